// SPDX-License-Identifier: GPL-3.0-or-later

/** The colours of the drawing. They are custom properties of style.css, so that light and dark are told apart there. */
export interface Theme {
  readonly edge: string
  readonly rim: string
  readonly hidden: string
  readonly accent: string
  readonly selectedDisc: string
  readonly selectedCell: string
  readonly neighborCell: string
  /** From the smallest circles to the largest. */
  readonly tints: readonly string[]
  /** A cell has the tint of its circle, so much weaker. */
  readonly cellOpacity: number
}

const TINTS = 6

export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement)
  const value = (name: string) => style.getPropertyValue(`--${name}`).trim()
  return {
    edge: value('edge'),
    rim: value('rim'),
    hidden: value('hidden'),
    accent: value('accent'),
    selectedDisc: value('selected-disc'),
    selectedCell: value('selected-cell'),
    neighborCell: value('neighbor-cell'),
    tints: Array.from({ length: TINTS }, (_, i) => value(`tint-${i}`)),
    cellOpacity: Number(value('cell-opacity')),
  }
}

/** Tells when the system changes between light and dark. */
export function onThemeChange(listener: () => void): void {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', listener)
}
