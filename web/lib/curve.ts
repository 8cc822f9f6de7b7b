// SPDX-License-Identifier: GPL-3.0-or-later
import { type Bisector, bisector, exponentialOf, parameterAt } from './bisector.ts'
import { at, type DiagramData, NONE } from './diagram-data.ts'
import { between, length, type Point } from './point.ts'

/**
 * An arc of a bisector, from parameter `from` to parameter `to` >= `from`. An end at infinity has the parameter 0 or
 * infinity and no point; the other ends of an edge are its vertices bit for bit: arcs that meet in a vertex meet exactly.
 * An edge of length zero has equal parameters.
 */
export interface EdgeCurve {
  readonly bisector: Bisector
  readonly from: number
  readonly to: number
  /** `undefined`: at infinity. */
  readonly start: Point | undefined
  /** `undefined`: at infinity. */
  readonly end: Point | undefined
}

/** An arc with two ends. */
export interface BoundedCurve extends EdgeCurve {
  readonly start: Point
  readonly end: Point
}

/** Whether an arc has two ends. */
export function isBounded(curve: EdgeCurve): curve is BoundedCurve {
  return curve.start !== undefined && curve.end !== undefined
}

/** The curve of edge `edge` of a diagram. */
export function edgeCurve({ circles, metric, vertices, edges }: DiagramData, edge: number): EdgeCurve {
  const start = at(edges, 4 * edge + 2)
  const end = at(edges, 4 * edge + 3)
  const curve = bisector(circles, at(edges, 4 * edge), at(edges, 4 * edge + 1), metric)
  const startPoint = start === NONE ? undefined : { x: at(vertices, 3 * start), y: at(vertices, 3 * start + 1) }
  const endPoint = end === NONE ? undefined : { x: at(vertices, 3 * end), y: at(vertices, 3 * end + 1) }
  let from = startPoint === undefined ? 0 : parameterAt(curve, startPoint.x, startPoint.y)
  let to = endPoint === undefined ? Number.POSITIVE_INFINITY : parameterAt(curve, endPoint.x, endPoint.y)
  // The order of the ends is certified: where the parameters contradict it, the edge has length zero up to rounding.
  if (from > to) from = to = Math.sqrt(from) * Math.sqrt(to)
  return { bisector: curve, from, to, start: startPoint, end: endPoint }
}

/** The same arc run through the other way: left and right change places. */
export function reversed(curve: BoundedCurve): BoundedCurve
export function reversed(curve: EdgeCurve): EdgeCurve
export function reversed({ bisector, from, to, start, end }: EdgeCurve): EdgeCurve {
  const { left, right, a, b, origin, along, across, apex } = bisector
  return {
    bisector: { left: right, right: left, a: -a, b, origin, along, across: { x: -across.x, y: -across.y }, apex },
    // 1 / infinity is 0, and the other way round.
    from: 1 / to,
    to: 1 / from,
    start: end,
    end: start,
  }
}

/** The straight segment from `start` to `end`, which differ. */
export function segment(start: Point, end: Point): BoundedCurve {
  const chord = between(start, end)
  const size = length(chord)
  const across = { x: chord.x / size, y: chord.y / size }
  const along = { x: across.y, y: -across.x }
  const half = size / 2
  const middle = { x: start.x + chord.x / 2, y: start.y + chord.y / 2 }
  const left = { x: middle.x - half * along.x, y: middle.y - half * along.y }
  const right = { x: middle.x + half * along.x, y: middle.y + half * along.y }
  return {
    bisector: { left, right, a: 0, b: half, origin: left, along, across, apex: half },
    from: exponentialOf(-1),
    to: exponentialOf(1),
    start,
    end,
  }
}
