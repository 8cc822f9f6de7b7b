// SPDX-License-Identifier: GPL-3.0-or-later

import { NONE } from '../../../lib/base/diagram-data.ts'
import { drawCell } from '../../../lib/drawing/draw.ts'
import type { FrameSink } from '../frame-sink.ts'
import { type Layer, type PaintContext, shareOf } from '../paint-context.ts'

/** Width of the line that covers the seams between cells, in pixels. */
const SEAM = 0.75
/** Long paths take more than linear time in browsers. */
const CELLS_PER_PATH = 64
/**
 * Range of cell widths in pixels over which tints fade in. Narrower cells need none, because their discs have the same
 * colors.
 */
const TINTED_CELL = [6, 12] as const

/** Cells in a faint tint or the full color of their circles, or in the color of their own measure. */
export const cells: Layer = {
  id: 'cells',
  isClipped: true,
  isOn: (layers) => layers.cells !== 'none' || layers.column !== undefined,
  draw(painting) {
    const { style, width, picture, layers } = painting
    const isTinted = picture.areDiscsColored && !layers.fullColor
    const opacity = isTinted ? style.cellOpacity * shareOf(width, TINTED_CELL) : 1
    if (opacity > 0) fillCells(painting, opacity)
  },
}

function fillCells(painting: PaintContext, opacity: number): void {
  const { picture, limits, tolerance, palette, layers, pixelRatio } = painting
  const paths = new Map<number, { readonly sink: FrameSink; count: number }>()
  const flush = (k: number) => {
    const own = paths.get(k)
    paths.delete(k)
    if (own === undefined) return
    const { path } = own.sink
    painting.fill(path, palette[k] as string, opacity)
    // Otherwise the paper would shine through between two cells without an edge.
    if (layers.fullColor && !layers.edges) painting.stroke(path, palette[k] as string, SEAM * pixelRatio)
  }
  for (const i of painting.circles) {
    const k = picture.colorOf(i)
    if (k === NONE) continue
    const own = paths.get(k) ?? { sink: painting.sink(), count: 0 }
    paths.set(k, own)
    drawCell(own.sink, picture.diagram.cells, i, limits, tolerance)
    own.count += 1
    if (own.count === CELLS_PER_PATH) flush(k)
  }
  for (const k of [...paths.keys()]) flush(k)
}
