// SPDX-License-Identifier: GPL-3.0-or-later
import { drawCell } from '../../lib/drawing/draw.ts'
import type { Name } from '../labels.ts'
import type { PaintContext } from './paint-context.ts'
import type { SvgDrawing } from './svg-drawing.ts'

/** Adds an invisible cell above each named circle of a frame, whose tooltip is the name. */
export function addTitles(drawing: SvgDrawing, painting: PaintContext, names: readonly Name[]): void {
  const { diagram } = painting.picture
  const texts = new Map(names.map(({ id, text }) => [diagram.indexOf(id), text]))
  for (const i of painting.circles) {
    const text = texts.get(i)
    if (text === undefined) continue
    const sink = painting.sink()
    drawCell(sink, diagram.cells, i, painting.limits, painting.tolerance)
    drawing.title(sink.path, text)
  }
}
