// SPDX-License-Identifier: GPL-3.0-or-later

/** The colours of the drawing: CSS colours. */
export interface Style {
  readonly paper: string
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

export const DISC_OPACITY = 0.85
/** Smaller circles are drawn as dots of this radius, in pixels. */
export const DOT_RADIUS = 1.5
/** How many tints circles and cells have by size. */
export const TINTS = 6

/** The style that the custom properties of an element say. */
export function readStyle(element: Element): Style {
  const style = getComputedStyle(element)
  const value = (name: string) => style.getPropertyValue(`--${name}`).trim()
  return {
    paper: value('paper'),
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
