// SPDX-License-Identifier: GPL-3.0-or-later

import { at } from '../../../lib/base/diagram-data.ts'
import type { Diagram, PathSink } from '../../../lib/index.ts'
import type { FrameSink } from '../frame-sink.ts'
import type { Layer, PaintContext } from '../paint-context.ts'
import type { Picture } from '../picture.ts'
import { addSegment } from '../segment-path.ts'

const SEGMENTS_PER_PATH = 1000

/** A segment between the centers of each two circles that share an edge. */
export const dual: Layer = {
  id: 'dual',
  isOn: (layers) => layers.dual,
  draw: (painting) => strokeDual(painting, painting.picture, painting.style.dual),
}

/** The Delaunay graph of the centers. */
export const delaunay: Layer = {
  id: 'delaunay',
  isOn: (layers) => layers.delaunay,
  draw(painting) {
    const { centers } = painting.picture
    if (centers !== undefined) strokeDual(painting, centers.picture, painting.style.delaunay)
  },
}

function strokeDual(painting: PaintContext, picture: Picture, color: string): void {
  const { limits, lineWidth } = painting
  const { diagram } = picture
  const sink = painting.sink()
  let path = painting.drawing.path()
  let count = 0
  const stroke = () => painting.stroke(path, color, lineWidth)
  const seen = new Set(picture.starsIn(limits.bounds.box))
  for (const i of seen) {
    for (const side of diagram.cells.sides(i)) {
      // Adds each edge once, also if its left circle is not in view.
      if (side & 1 && seen.has(diagram.cells.neighborOf(side))) continue
      addDualEdge(path, painting, sink, diagram, i, diagram.cells.neighborOf(side))
      count += 1
      if (count % SEGMENTS_PER_PATH !== 0) continue
      stroke()
      path = painting.drawing.path()
    }
  }
  stroke()
}

function addDualEdge(
  path: PathSink,
  { frame }: PaintContext,
  sink: FrameSink,
  { circles }: Diagram,
  i: number,
  j: number,
): void {
  addSegment(
    path,
    frame,
    sink.x(at(circles, 3 * i)),
    sink.y(at(circles, 3 * i + 1)),
    sink.x(at(circles, 3 * j)),
    sink.y(at(circles, 3 * j + 1)),
  )
}
