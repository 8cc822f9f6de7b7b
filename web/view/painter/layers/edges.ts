// SPDX-License-Identifier: GPL-3.0-or-later

import { drawEdge } from '../../../lib/drawing/draw.ts'
import type { Diagram, PathSink } from '../../../lib/index.ts'
import { type Layer, type Painting, shareOf } from '../painting.ts'

/** Browsers stroke long paths in more than linear time. */
const EDGES_PER_PATH = 1000
/** Edges fade in where cells are so wide, in pixels. */
const CELL_WITH_EDGES = [1.5, 4] as const
const GHOST_LINE = 1.1
const MISSED_LINE = 3

/** The true arcs. */
export const edges: Layer = {
  id: 'edges',
  isClipped: true,
  isOn: (layers) => layers.edges,
  draw(painting) {
    const { picture, style, lineWidth, circles, width } = painting
    const opacity = shareOf(width, CELL_WITH_EDGES)
    if (opacity === 0) return
    strokeEdges(painting, picture.diagram, circles, (path) => painting.stroke(path, style.edge, lineWidth, [], opacity))
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
    const seen = picture.circlesIn(painting.limits.region.box)
    strokeEdges(painting, picture.diagram, seen, (path) => strokeGhost(painting, path, painting.style.ordinary))
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
    const seen = power.index.search(painting.limits.region.box).sort((i, j) => i - j)
    strokeEdges(painting, power.diagram, seen, (path) => strokeGhost(painting, path, painting.style.power))
  },
}

/** Those that the touching disc method misses. */
export const missedEdges: Layer = {
  id: 'missedEdges',
  isClipped: true,
  isOn: (layers) => layers.missedEdges,
  draw(painting) {
    const { picture, style, circles, lineWidth } = painting
    const missed = picture.method?.missed
    if (missed === undefined || missed.size === 0) return
    const isMissed = (edge: number) => missed.has(edge)
    const width = Math.max(MISSED_LINE * painting.pixelRatio, lineWidth)
    strokeEdges(painting, picture.diagram, circles, (path) => painting.stroke(path, style.missedEdges, width), isMissed)
  },
}

function strokeGhost(painting: Painting, path: PathSink, color: string): void {
  painting.stroke(path, color, Math.min(painting.lineWidth, GHOST_LINE * painting.pixelRatio), [5, 4])
}

function strokeEdges(
  painting: Painting,
  diagram: Diagram,
  circles: readonly number[],
  stroke: (path: PathSink) => void,
  isDrawn: (edge: number) => boolean = () => true,
): void {
  const { limits, tolerance, picture } = painting
  const ownLimits = diagram === picture.diagram ? limits : { ...limits, maxDistance: undefined }
  let sink = painting.sink()
  let count = 0
  for (const i of circles) {
    for (const side of diagram.cells.sides(i)) {
      // Each edge once: with its left circle.
      if (side & 1 || !isDrawn(side >> 1)) continue
      drawEdge(sink, diagram, side >> 1, ownLimits, tolerance)
      count += 1
      if (count % EDGES_PER_PATH !== 0) continue
      stroke(sink.path)
      sink = painting.sink()
    }
  }
  stroke(sink.path)
}
