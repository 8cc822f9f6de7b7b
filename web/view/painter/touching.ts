// SPDX-License-Identifier: GPL-3.0-or-later

import { at, circleOf, NONE } from '../../lib/base/diagram-data.ts'
import { hypotenuse } from '../../lib/base/scale.ts'
import { parameterOf, pointOf } from '../../lib/curves/bisector.ts'
import { curveOf } from '../../lib/curves/curve.ts'
import type { Diagram, Point, Vertex } from '../../lib/index.ts'
import type { Touching } from '../protocol.ts'

/**
 * The disc at the vertex nearest to (x, y), or else at the nearest point of an edge, among the cells of some circles.
 */
export function touchingNear(
  diagram: Diagram,
  circles: readonly number[],
  x: number,
  y: number,
  slack: number,
): Touching | undefined {
  const { cells, vertices, edges, vertexCircles } = diagram
  let nearest = slack
  let vertex = NONE
  let edge = NONE
  let place: Point = { x, y }
  const sides = circles.flatMap((i) => [...cells.sides(i)])
  for (const side of sides) {
    const v = cells.originOf(side)
    if (v === NONE) continue
    const distance = hypotenuse(at(vertices, 3 * v) - x, at(vertices, 3 * v + 1) - y)
    if (distance < nearest) [nearest, vertex] = [distance, v]
  }
  if (vertex !== NONE) {
    const disc = { x: at(vertices, 3 * vertex), y: at(vertices, 3 * vertex + 1), r: at(vertices, 3 * vertex + 2) }
    return touching(diagram, disc, [...vertexCircles.subarray(3 * vertex, 3 * vertex + 3)])
  }
  for (const side of sides) {
    const { bisector, from, to } = curveOf(diagram, side >> 1)
    const point = pointOf(bisector, Math.min(Math.max(parameterOf(bisector, x, y), from), to))
    const distance = hypotenuse(point.x - x, point.y - y)
    if (distance < nearest) [nearest, edge, place] = [distance, side >> 1, point]
  }
  if (edge === NONE) return undefined
  const left = circleOf(diagram.circles, at(edges, 4 * edge))
  const r = hypotenuse(place.x - left.x, place.y - left.y) - left.r
  return touching(diagram, { ...place, r }, [at(edges, 4 * edge), at(edges, 4 * edge + 1)])
}

/**
 * The largest empty disc around a point, which touches the nearest circle; `undefined` if that circle contains the
 * point.
 */
export function touchingAround(diagram: Diagram, nearest: number, x: number, y: number): Touching | undefined {
  const circle = circleOf(diagram.circles, nearest)
  const r = hypotenuse(x - circle.x, y - circle.y) - circle.r
  return r > 0 ? touching(diagram, { x, y, r }, [nearest]) : undefined
}

/** A disc with the points at which it touches circles. */
export function touching(diagram: Diagram, disc: Vertex, circles: readonly number[]): Touching {
  const points = circles.map((i) => {
    const { x, y, r } = circleOf(diagram.circles, i)
    const [dx, dy] = [disc.x - x, disc.y - y]
    const distance = hypotenuse(dx, dy)
    return distance === 0 ? { x: x + r, y } : { x: x + (r * dx) / distance, y: y + (r * dy) / distance }
  })
  return { disc, points }
}
