// SPDX-License-Identifier: GPL-3.0-or-later
import { toPrint } from '../view/export.ts'
import { PrintDrawing } from '../view/print-drawing.ts'
import type { View } from '../view/view.ts'

/** More circles are printed as pixels. */
const MOST_DRAWN = 5000

/** Prints a drawing, sharp and on white, in place of the pixels of the screen. */
export function printDrawing(view: View, place: HTMLElement): void {
  const isDrawn = () => view.size.width > 0 && view.circles.count <= MOST_DRAWN
  const printed = new PrintDrawing(place, async () => (isDrawn() ? toPrint(view) : ''))
  for (const name of ['camera', 'layers', 'diagram', 'found', 'changed'] as const) view.on(name, () => printed.change())
  // The first circles may be there already.
  printed.change()
}
