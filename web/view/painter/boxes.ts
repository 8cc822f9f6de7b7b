// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes in a flat list, four numbers each: minX, minY, maxX, maxY. A million cells would need too many objects.

import { at, NONE } from '../../lib/base/diagram-data.ts'
import { inPlane } from '../../lib/curves/bisector.ts'
import { curveOf } from '../../lib/curves/curve.ts'
import type { Box, Diagram, Point } from '../../lib/index.ts'

export const EMPTY_BOX: Box = {
  minX: Number.POSITIVE_INFINITY,
  minY: Number.POSITIVE_INFINITY,
  maxX: Number.NEGATIVE_INFINITY,
  maxY: Number.NEGATIVE_INFINITY,
}

/** Squares of smaller numbers may underflow. */
const SMALLEST_SQUARE = 1e-280

/** A list of empty boxes. */
export function emptyBoxes(count: number): Float64Array {
  const boxes = new Float64Array(4 * count)
  for (let k = 0; k < count; k++) clearBox(boxes, k)
  return boxes
}

export function clearBox(boxes: Float64Array, k: number): void {
  boxes[4 * k] = Number.POSITIVE_INFINITY
  boxes[4 * k + 1] = Number.POSITIVE_INFINITY
  boxes[4 * k + 2] = Number.NEGATIVE_INFINITY
  boxes[4 * k + 3] = Number.NEGATIVE_INFINITY
}

/** Box k as an object. */
export function boxAt(boxes: Float64Array, k: number): Box {
  return { minX: at(boxes, 4 * k), minY: at(boxes, 4 * k + 1), maxX: at(boxes, 4 * k + 2), maxY: at(boxes, 4 * k + 3) }
}

export function union(a: Box, b: Box): Box {
  return {
    minX: Math.min(a.minX, b.minX),
    minY: Math.min(a.minY, b.minY),
    maxX: Math.max(a.maxX, b.maxX),
    maxY: Math.max(a.maxY, b.maxY),
  }
}

/** Extends box k by a rectangle given by its middle and half of its sides. */
export function addAround(boxes: Float64Array, k: number, x: number, y: number, width: number, height = width): void {
  boxes[4 * k] = Math.min(at(boxes, 4 * k), x - width)
  boxes[4 * k + 1] = Math.min(at(boxes, 4 * k + 1), y - height)
  boxes[4 * k + 2] = Math.max(at(boxes, 4 * k + 2), x + width)
  boxes[4 * k + 3] = Math.max(at(boxes, 4 * k + 3), y + height)
}

/** Extends box k by box j of another list. */
export function addBox(boxes: Float64Array, k: number, others: Float64Array, j: number): void {
  boxes[4 * k] = Math.min(at(boxes, 4 * k), at(others, 4 * j))
  boxes[4 * k + 1] = Math.min(at(boxes, 4 * k + 1), at(others, 4 * j + 1))
  boxes[4 * k + 2] = Math.max(at(boxes, 4 * k + 2), at(others, 4 * j + 2))
  boxes[4 * k + 3] = Math.max(at(boxes, 4 * k + 3), at(others, 4 * j + 3))
}

/**
 * Extends box k by an edge, up to `reach` if the edge is unbounded.
 * Along the line through the two centers an arc moves away from its apex; across the line it moves in one direction. It
 * lies in the rectangle of that orientation that its ends span, together with its apex if the apex is between them.
 */
export function addEdge(boxes: Float64Array, k: number, diagram: Diagram, edge: number, reach: number): void {
  const { circles, vertices, edges } = diagram
  const left = 3 * at(edges, 4 * edge)
  const right = 3 * at(edges, 4 * edge + 1)
  const start = at(edges, 4 * edge + 2)
  const end = at(edges, 4 * edge + 3)
  const x = at(circles, left)
  const y = at(circles, left + 1)
  const dx = at(circles, right) - x
  const dy = at(circles, right + 1) - y
  const square = dx * dx + dy * dy
  if (start === NONE || end === NONE || !(square > SMALLEST_SQUARE)) {
    addCurve(boxes, k, diagram, edge, reach)
    return
  }
  const distance = Math.sqrt(square)
  const alongX = dx / distance
  const alongY = dy / distance
  const startX = at(vertices, 3 * start) - x
  const startY = at(vertices, 3 * start + 1) - y
  const endX = at(vertices, 3 * end) - x
  const endY = at(vertices, 3 * end + 1) - y
  const startU = startX * alongX + startY * alongY
  const startV = startY * alongX - startX * alongY
  const endU = endX * alongX + endY * alongY
  const endV = endY * alongX - endX * alongY
  let minU = Math.min(startU, endU)
  let maxU = Math.max(startU, endU)
  if (startV > 0 !== endV > 0) {
    const apex = (distance + at(circles, left + 2) - at(circles, right + 2)) / 2
    minU = Math.min(minU, apex)
    maxU = Math.max(maxU, apex)
  }
  const u = (minU + maxU) / 2
  const v = (startV + endV) / 2
  const halfU = (maxU - minU) / 2
  const halfV = Math.abs(startV - endV) / 2
  addAround(
    boxes,
    k,
    x + u * alongX - v * alongY,
    y + u * alongY + v * alongX,
    halfU * Math.abs(alongX) + halfV * Math.abs(alongY),
    halfU * Math.abs(alongY) + halfV * Math.abs(alongX),
  )
}

/** Extends box k by an edge, using the parameters of its curve. */
function addCurve(boxes: Float64Array, k: number, diagram: Diagram, edge: number, reach: number): void {
  const { bisector, from, to } = curveOf(diagram, edge)
  const { a, b, apex } = bisector
  const farthest = Math.max((2 * reach) / b, 2)
  const ends = [Math.max(from, 1 / farthest), Math.min(to, farthest)]
  const u = ends.map((s) => apex - Math.abs(a) * (((s - 1) / s) * ((s - 1) / 2)))
  const v = ends.map((s) => (b * (s - 1 / s)) / 2)
  if (from <= 1 && to >= 1) u.push(apex)
  for (const along of [Math.min(...u), Math.max(...u)]) {
    for (const across of v) {
      const { x, y } = inPlane(bisector, along, across)
      addAround(boxes, k, x, y, 0)
    }
  }
}

/** Extends box k by the part of a hull circle's cell that lies between its unbounded edges, up to `reach`. */
export function addFarPart(boxes: Float64Array, k: number, diagram: Diagram, circle: number, reach: number): void {
  const { circles, cells } = diagram
  const x = at(circles, 3 * circle)
  const y = at(circles, 3 * circle + 1)
  const sides = cells.sides(circle)
  // A visible circle whose cell has no sides owns the whole plane.
  if (sides.length === 0 && cells.exists(circle)) addAround(boxes, k, x, y, reach)
  sides.forEach((side, place) => {
    if (cells.targetOf(side) !== NONE) return
    const from = farDirection(diagram, side)
    const to = farDirection(diagram, at(sides, (place + 1) % sides.length) ^ 1)
    const turn = turnBetween(from, to)
    for (const axis of AXES) {
      if (turnBetween(from, axis) <= turn) addAround(boxes, k, x + reach * axis.x, y + reach * axis.y, 0)
    }
  })
}

const AXES = [
  { x: 1, y: 0 },
  { x: 0, y: 1 },
  { x: -1, y: 0 },
  { x: 0, y: -1 },
] as const

/** The direction of a side that ends at infinity. */
function farDirection(diagram: Diagram, side: number): Point {
  const { a, b, along, across } = curveOf(diagram, side >> 1).bisector
  const v = side & 1 ? -b : b
  return { x: v * across.x - Math.abs(a) * along.x, y: v * across.y - Math.abs(a) * along.y }
}

/** The counter-clockwise angle from one direction to another, from 0 to 2 pi. */
function turnBetween(from: Point, to: Point): number {
  const angle = Math.atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y)
  return angle < 0 ? angle + 2 * Math.PI : angle
}
