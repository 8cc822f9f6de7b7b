// SPDX-License-Identifier: GPL-3.0-or-later
// Reference results for the library, by scanning all circles or many points.
import type { Box } from '../../web/lib/base/types.ts'
import { type Bisector, type BoundedCurve, type ConvexPolygon, type Point, pointAt } from '../../web/lib/index.ts'
import { tuple } from './tuples.ts'

/** The signed distance from circle `i` of a flat array. */
export function signedDistance(circles: Float64Array, i: number, { x, y }: Point): number {
  const dx = x - (circles[3 * i] as number)
  const dy = y - (circles[3 * i + 1] as number)
  return Math.sqrt(dx * dx + dy * dy) - (circles[3 * i + 2] as number)
}

/** The distance from the nearest circle. */
export function leastDistance(circles: Float64Array, point: Point): number {
  let least = Number.POSITIVE_INFINITY
  for (let i = 0; i < circles.length / 3; i++) least = Math.min(least, signedDistance(circles, i, point))
  return least
}

/** The largest coordinate of the circles, the scale of rounding errors. */
export function scaleOf(circles: Float64Array): number {
  return circles.reduce((largest, value) => Math.max(largest, Math.abs(value)), 0)
}

/** A box around the circles, larger by `share` of their extent on each side. A row of points gets some height. */
export function boxAround(circles: Float64Array, share: number): Box {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity]
  for (let i = 0; i < circles.length; i += 3) {
    const [x, y, r] = tuple(circles, i, 3)
    minX = Math.min(minX, x - r)
    minY = Math.min(minY, y - r)
    maxX = Math.max(maxX, x + r)
    maxY = Math.max(maxY, y + r)
  }
  const size = Math.max(maxX - minX, maxY - minY)
  const margin = size > 0 ? share * size : 1
  const marginOf = (extent: number) => (extent + 2 * margin > 0 ? margin : size / 10)
  const [x, y] = [marginOf(maxX - minX), marginOf(maxY - minY)]
  return { minX: minX - x, minY: minY - y, maxX: maxX + x, maxY: maxY + y }
}

/** The point at fractions of a box's width and height. */
export function pointIn({ minX, minY, maxX, maxY }: Box, across: number, up: number): Point {
  return { x: minX + across * (maxX - minX), y: minY + up * (maxY - minY) }
}

/** The signed distance of a point from the border of a convex polygon, positive inside. */
export function depthIn(polygon: ConvexPolygon, { x, y }: Point): number {
  const depths = polygon.corners.map((p, k) => {
    const q = polygon.cornerAfter(k)
    return ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x)) / Math.hypot(q.x - p.x, q.y - p.y)
  })
  return Math.min(...depths)
}

/**
 * The distance of a point from an arc. At the tip of a needle there are two minima close together, so each side is
 * searched separately.
 */
export function distanceFromArc({ bisector, from, to }: BoundedCurve, point: Point): number {
  const apex = Math.min(Math.max(1, from), to)
  return Math.min(distanceFromSide(bisector, from, apex, point), distanceFromSide(bisector, apex, to, point))
}

/** The distance from an arc on one side of the apex, by bisection around each local minimum of many points. */
function distanceFromSide(bisector: Bisector, from: number, to: number, { x, y }: Point): number {
  const count = 128
  const { a, b, along, across } = bisector
  const step = (to / from) ** (1 / count)
  const distanceAt = (s: number) => {
    const point = pointAt(bisector, s)
    return Math.sqrt((point.x - x) * (point.x - x) + (point.y - y) * (point.y - y))
  }
  /** Whether the distance decreases along the arc at a parameter. */
  const isAhead = (s: number) => {
    const point = pointAt(bisector, s)
    const [u, v] = [-Math.abs(a) * (1 - 1 / (s * s)), b * (1 + 1 / (s * s))]
    return (x - point.x) * (u * along.x + v * across.x) + (y - point.y) * (u * along.y + v * across.y) > 0
  }
  const parameters = [from]
  for (let k = 1; k < count; k++) parameters.push((parameters[k - 1] as number) * step)
  parameters.push(to)
  const distances = parameters.map(distanceAt)
  let best = Math.min(...distances)
  distances.forEach((distance, k) => {
    if ((distances[k - 1] ?? distance) < distance || (distances[k + 1] ?? distance) < distance) return
    let [low, high] = [parameters[k - 1] ?? from, parameters[k + 1] ?? to]
    for (let halving = 0; halving < 50; halving++) {
      const middle = Math.sqrt(low * high)
      if (isAhead(middle)) low = middle
      else high = middle
    }
    best = Math.min(best, distanceAt(low))
  })
  return best
}
