// SPDX-License-Identifier: GPL-3.0-or-later
import { inPlane } from '../../lib/bisector.ts'
import { edgeCurve } from '../../lib/curve.ts'
import { at } from '../../lib/diagram-data.ts'
import type { Box, Diagram } from '../../lib/index.ts'

export const EMPTY_BOX: Box = {
  minX: Number.POSITIVE_INFINITY,
  minY: Number.POSITIVE_INFINITY,
  maxX: Number.NEGATIVE_INFINITY,
  maxY: Number.NEGATIVE_INFINITY,
}

export function union(a: Box, b: Box): Box {
  return {
    minX: Math.min(a.minX, b.minX),
    minY: Math.min(a.minY, b.minY),
    maxX: Math.max(a.maxX, b.maxX),
    maxY: Math.max(a.maxY, b.maxY),
  }
}

export function meets(a: Box, b: Box): boolean {
  return a.minX <= b.maxX && b.minX <= a.maxX && a.minY <= b.maxY && b.minY <= a.maxY
}

export function circleBox(x: number, y: number, r: number): Box {
  return { minX: x - r, minY: y - r, maxX: x + r, maxY: y + r }
}

/**
 * A box around an edge, of one that goes to infinity as far as `reach`.
 *
 * Along the line through the two centres an arc goes away from its apex, across it always on: it lies in the rectangle in
 * that direction that its ends and, if it is between them, its apex span.
 */
export function edgeBox(diagram: Diagram, edge: number, reach: number): Box {
  const { bisector, from, to } = edgeCurve(diagram, edge)
  const { a, b, apex, unit } = bisector
  const farthest = Math.max((2 * reach) / (b * unit), 2)
  const ends = [Math.max(from, 1 / farthest), Math.min(to, farthest)]
  const u = ends.map((s) => apex - Math.abs(a) * (((s - 1) / s) * ((s - 1) / 2)))
  const v = ends.map((s) => (b * (s - 1 / s)) / 2)
  if (from <= 1 && to >= 1) u.push(apex)
  let box = EMPTY_BOX
  for (const along of [Math.min(...u), Math.max(...u)]) {
    for (const across of v) {
      const { x, y } = inPlane(bisector, along, across)
      box = union(box, circleBox(x, y, 0))
    }
  }
  return box
}

/** A box around a circle and its cell. */
export function cellBox(diagram: Diagram, i: number, reach: number): Box {
  const { circles, cells } = diagram
  let box = circleBox(at(circles, 3 * i), at(circles, 3 * i + 1), at(circles, 3 * i + 2))
  for (const side of cells.sides(i)) box = union(box, edgeBox(diagram, side >> 1, reach))
  return box
}
