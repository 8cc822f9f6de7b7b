// SPDX-License-Identifier: GPL-3.0-or-later

import { at, NONE } from '../../../lib/base/diagram-data.ts'
import { hypotenuse } from '../../../lib/base/scale.ts'
import type { Diagram, PathSink } from '../../../lib/index.ts'
import { addDisc } from '../disc-path.ts'
import { type Layer, shareOf } from '../paint-context.ts'

/** Range of cell widths in pixels over which vertices fade in. */
const CELL_WITH_VERTICES = [50, 80] as const
const RADIUS = 2
/** Radius of a merged vertex. */
const MERGED_RADIUS = 3.5

/**
 * The vertices. Merged vertices show their number of circles, and vertices of more than three circles are highlighted.
 */
export const vertices: Layer = {
  id: 'vertices',
  isClipped: true,
  isOn: (layers) => layers.vertices,
  draw(painting) {
    const { picture, frame, circles, pixelRatio, layers, style, width } = painting
    const { diagram } = picture
    const { nearZero, maxDistance = Number.POSITIVE_INFINITY } = layers
    const opacity = shareOf(width, CELL_WITH_VERTICES)
    // Merged vertices are drawn at any size of cells.
    if (opacity === 0 && nearZero === undefined) return
    const plain = painting.drawing.path()
    const merged = painting.drawing.path()
    const sink = painting.sink()
    const add = (path: PathSink, v: number, radius: number) =>
      addDisc(
        path,
        frame,
        sink.x(at(diagram.vertices, 3 * v)),
        sink.y(at(diagram.vertices, 3 * v + 1)),
        radius * pixelRatio,
      )
    for (const i of circles) {
      for (const side of diagram.cells.sides(i)) {
        const v = diagram.cells.originOf(side)
        // Draws each vertex once, with the first of its circles.
        if (v === NONE || at(diagram.vertexCircles, 3 * v) !== i) continue
        if (at(diagram.vertices, 3 * v + 2) > maxDistance) continue
        const others = nearZero === undefined ? 0 : mergedWith(diagram, v, nearZero)
        if (others > 0) add(merged, v, MERGED_RADIUS)
        else if (others === 0) add(plain, v, RADIUS)
      }
    }
    painting.fill(plain, style.edge, opacity)
    painting.fill(merged, style.merged)
  },
}

/**
 * The number of other vertices merged into a vertex, by edges up to a length; -1 if the vertex is merged into another
 * one.
 */
export function mergedWith(diagram: Diagram, v: number, nearZero: number): number {
  const { vertices, vertexSides, cells } = diagram
  const members = [v]
  for (let k = 0; k < members.length; k++) {
    const member = members[k] as number
    for (let slot = 3 * member; slot < 3 * member + 3; slot++) {
      const next = cells.targetOf(at(vertexSides, slot))
      if (next === NONE || members.includes(next)) continue
      const dx = at(vertices, 3 * next) - at(vertices, 3 * member)
      const dy = at(vertices, 3 * next + 1) - at(vertices, 3 * member + 1)
      if (!(hypotenuse(dx, dy) <= nearZero)) continue
      if (next < v) return -1
      members.push(next)
    }
  }
  return members.length - 1
}
