// SPDX-License-Identifier: GPL-3.0-or-later

import { drawCell } from '../../../lib/drawing/draw.ts'
import type { FrameSink } from '../frame-sink.ts'
import { type Layer, type Painting, shareOf } from '../painting.ts'

/** Browsers fill long paths in more than linear time. */
const CELLS_PER_PATH = 64
/** The tints of circles' sizes are background: they are not missed where cells are small, in pixels. */
const TINTED_CELL = [6, 12] as const
/** Of colors that were asked for. */
const OPACITY = 0.7

/** The colors of cells. */
export const cells: Layer = {
  id: 'cells',
  isOn: (layers) => layers.cells !== 'none',
  draw(painting) {
    const { layers, style, width } = painting
    const isBackground = layers.cells === 'radius'
    const opacity = isBackground ? style.cellOpacity * shareOf(width, TINTED_CELL) : OPACITY
    if (opacity === 0) return
    fillCells(painting, layers.cells === 'different' ? style.map : style.tints, opacity)
  },
}

function fillCells(painting: Painting, colors: readonly string[], opacity: number): void {
  const { picture, limits, tolerance } = painting
  const paths = colors.map(() => ({ sink: painting.sink(), count: 0 }))
  const flush = (k: number) => {
    painting.fill((paths[k] as { sink: FrameSink }).sink.path, colors[k] as string, opacity)
    paths[k] = { sink: painting.sink(), count: 0 }
  }
  for (const i of painting.circles) {
    const k = picture.colorOf(i)
    const own = paths[k] as { sink: FrameSink; count: number }
    drawCell(own.sink, picture.diagram.cells, i, limits, tolerance)
    own.count += 1
    if (own.count === CELLS_PER_PATH) flush(k)
  }
  for (const k of paths.keys()) flush(k)
}
