// SPDX-License-Identifier: GPL-3.0-or-later

import { at, circleOf } from '../../../lib/base/diagram-data.ts'
import { hypotenuse } from '../../../lib/base/scale.ts'
import { drawEdge } from '../../../lib/drawing/draw.ts'
import type { Diagram, PathSink } from '../../../lib/index.ts'
import { keptParts } from '../../../lib/regions/outline.ts'
import type { FrameSink } from '../frame-sink.ts'
import { type Layer, type PaintContext, shareOf } from '../paint-context.ts'

/** Long paths take more than linear time in browsers. */
const EDGES_PER_PATH = 1000
/** Range of cell widths in pixels over which edges fade in. */
const CELL_WITH_EDGES = [1.5, 4] as const
const GHOST_LINE = 1.1
const MISSED_LINE = 3

/** The edges of the diagram, as exact arcs. */
export const edges: Layer = {
  id: 'edges',
  isClipped: true,
  isOn: (layers) => layers.edges,
  draw(painting) {
    const { style, lineWidth, width } = painting
    const opacity = shareOf(width, CELL_WITH_EDGES)
    if (opacity === 0) return
    strokeArcs(painting, (path) => painting.stroke(path, style.edge, lineWidth, [], opacity))
  },
}

/** The Voronoi diagram of the centers. */
export const ordinary: Layer = {
  id: 'ordinary',
  isClipped: true,
  isOn: (layers) => layers.ordinary,
  draw(painting) {
    const { centers } = painting.picture
    if (centers === undefined) return
    const { picture } = centers
    strokeDashed(painting, picture.diagram, picture.circlesIn(painting.limits.bounds.box), painting.style.ordinary)
  },
}

/** The power diagram. */
export const power: Layer = {
  id: 'power',
  isClipped: true,
  isOn: (layers) => layers.power,
  draw(painting) {
    const { power } = painting.picture
    if (power === undefined) return
    strokeDashed(painting, power.diagram, power.index.search(painting.limits.bounds.box), painting.style.power)
  },
}

/** The edges that the touching disc method misses. */
export const missedEdges: Layer = {
  id: 'missedEdges',
  isClipped: true,
  isOn: (layers) => layers.missedEdges,
  draw(painting) {
    const { picture, style, lineWidth } = painting
    const missed = picture.method?.missed
    if (missed === undefined || missed.size === 0) return
    const width = Math.max(MISSED_LINE * painting.pixelRatio, lineWidth)
    strokeArcs(
      painting,
      (path) => painting.stroke(path, style.missedEdges, width),
      (edge) => missed.has(edge),
    )
  },
}

function strokeArcs(
  painting: PaintContext,
  stroke: (path: PathSink) => void,
  isDrawn: (edge: number) => boolean = () => true,
): void {
  const { limits, tolerance, circles } = painting
  const { diagram } = painting.picture
  const add = (sink: FrameSink, e: number) => isDrawn(e) && drawEdge(sink, diagram, e, limits, tolerance)
  strokeEdges(painting, diagram, circles, add, stroke, (side) => painting.picture.draws(side))
}

/** Length of a dash and of a gap, in CSS pixels. */
const DASH = 5
const GAP = 4
/** Distance along a line, in pixels, beyond which rounding would shift dashes. */
const FAR = 1e9

/**
 * Strokes the dashed edges of a diagram of segments and rays. The phase of the dashes depends on the two circles only,
 * so that it is the same in all tiles and stays when a vertex of the edge moves.
 */
function strokeDashed(painting: PaintContext, diagram: Diagram, circles: readonly number[], color: string): void {
  const { lineWidth, pixelRatio, limits } = painting
  const [dash, period] = [DASH * pixelRatio, (DASH + GAP) * pixelRatio]
  const add = (sink: FrameSink, e: number) => {
    const { x, y, dx, dy } = lineOf(diagram, e)
    const [beginX, beginY] = [sink.x(x), sink.y(y)]
    for (const { curve } of keptParts(diagram, e, { bounds: limits.bounds, maxDistance: undefined })) {
      // Pixel coordinates are y-down.
      const along = [curve.start, curve.end].map((end) => (sink.x(end.x) - beginX) * dx - (sink.y(end.y) - beginY) * dy)
      const [from, to] = [Math.min(...along), Math.max(...along)]
      if (!(Math.abs(from) < FAR && Math.abs(to) < FAR)) continue
      for (let k = Math.floor(from / period); k * period < to; k++) {
        const [start, end] = [Math.max(k * period, from), Math.min(k * period + dash, to)]
        if (start >= end) continue
        sink.path.moveTo(beginX + start * dx, beginY - start * dy)
        sink.path.lineTo(beginX + end * dx, beginY - end * dy)
      }
    }
  }
  const thickness = Math.min(lineWidth, GHOST_LINE * pixelRatio)
  strokeEdges(painting, diagram, circles, add, (path) => painting.stroke(path, color, thickness))
}

/** The line of an edge: a point between the centers, and a direction that does not depend on their order. */
function lineOf({ circles, edges }: Diagram, e: number): { x: number; y: number; dx: number; dy: number } {
  const [one, other] = [circleOf(circles, at(edges, 4 * e)), circleOf(circles, at(edges, 4 * e + 1))]
  const isAscending = one.x < other.x || (one.x === other.x && one.y < other.y)
  const [p, q] = isAscending ? [one, other] : [other, one]
  const [x, y] = [q.x - p.x, q.y - p.y]
  const distance = hypotenuse(x, y)
  const share = 0.5 + (p.r / distance - q.r / distance) * ((p.r / distance + q.r / distance) / 2)
  return { x: p.x + share * x, y: p.y + share * y, dx: -y / distance, dy: x / distance }
}

function isLeft(side: number): boolean {
  return (side & 1) === 0
}

/** Adds the edges around circles, each once, and strokes them. By default an edge is added with its left circle. */
function strokeEdges(
  painting: PaintContext,
  { cells }: Diagram,
  circles: readonly number[],
  add: (sink: FrameSink, e: number) => void,
  stroke: (path: PathSink) => void,
  draws: (side: number) => boolean = isLeft,
): void {
  let sink = painting.sink()
  let count = 0
  for (const i of circles) {
    for (const side of cells.sides(i)) {
      if (!draws(side)) continue
      add(sink, side >> 1)
      count += 1
      if (count % EDGES_PER_PATH !== 0) continue
      stroke(sink.path)
      sink = painting.sink()
    }
  }
  stroke(sink.path)
}
