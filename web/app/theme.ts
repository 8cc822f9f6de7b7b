// SPDX-License-Identifier: GPL-3.0-or-later

/** The colours of the drawing. They are custom properties of style.css, so that light and dark are told apart there. */
export interface Theme {
  readonly edge: string
  readonly vertex: string
  readonly disc: string
  readonly rim: string
  readonly hidden: string
  readonly accent: string
  readonly selectedCell: string
  readonly neighborCell: string
  /** From the smallest circles' cells to the largest ones'. */
  readonly tints: readonly string[]
}

const TINTS = 6

export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement)
  const color = (name: string) => style.getPropertyValue(`--${name}`).trim()
  return {
    edge: color('edge'),
    vertex: color('vertex'),
    disc: color('disc'),
    rim: color('rim'),
    hidden: color('hidden'),
    accent: color('accent'),
    selectedCell: color('selected-cell'),
    neighborCell: color('neighbor-cell'),
    tints: Array.from({ length: TINTS }, (_, i) => color(`tint-${i}`)),
  }
}

/** Tells when the system changes between light and dark. */
export function onThemeChange(listener: () => void): void {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', listener)
}
