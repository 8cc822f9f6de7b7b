// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../../lib/base/diagram-data.ts'
import { isMethodShown } from '../../layers.ts'
import { addDisc } from '../disc-path.ts'
import type { Layer, PaintContext } from '../paint-context.ts'
import type { IndexedData } from '../picture.ts'
import { addSegment } from '../segment-path.ts'

const LINE = 1.25
const DOT = 2.5

/** The layers of clients. */
export const data: Layer = {
  id: 'data',
  isOn: (layers) => layers.data.length > 0,
  draw(painting) {
    for (const own of painting.picture.data) drawData(painting, own, own.color)
  },
}

/** The intermediate results of the touching disc method. */
export const method: Layer = {
  id: 'method',
  isOn: isMethodShown,
  draw(painting) {
    for (const own of painting.picture.method?.layers ?? []) {
      if (painting.layers[own.color]) drawData(painting, own, painting.style[own.color])
    }
  },
}

function drawData(painting: PaintContext, { layer, points, segments, discs }: IndexedData, color: string): void {
  const { frame, pixelRatio, limits } = painting
  const sink = painting.sink()
  const lines = painting.drawing.path()
  const dots = painting.drawing.path()
  const { box } = limits.bounds
  const x = (list: Float64Array | undefined, k: number) => sink.x(at(list as Float64Array, k))
  const y = (list: Float64Array | undefined, k: number) => sink.y(at(list as Float64Array, k))
  for (const k of segments?.search(box) ?? []) {
    const own = layer.segments
    addSegment(lines, frame, x(own, 4 * k), y(own, 4 * k + 1), x(own, 4 * k + 2), y(own, 4 * k + 3))
  }
  for (const k of discs?.search(box) ?? []) {
    const radius = at(layer.discs as Float64Array, 3 * k + 2) * frame.scale
    addDisc(lines, frame, x(layer.discs, 3 * k), y(layer.discs, 3 * k + 1), Math.abs(radius))
  }
  for (const k of points?.search(box) ?? []) {
    addDisc(dots, frame, x(layer.points, 2 * k), y(layer.points, 2 * k + 1), DOT * pixelRatio)
  }
  painting.stroke(lines, color, LINE * pixelRatio)
  painting.fill(dots, color)
}
