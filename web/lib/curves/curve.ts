// SPDX-License-Identifier: GPL-3.0-or-later

import { checkData, checkIndex } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import { between, dot } from '../base/point.ts'
import { lengthOf, ROUNDING } from '../base/scale.ts'
import type { DiagramData, Point } from '../base/types.ts'
import { type Bisector, blankBisector, exponentialOf, type Mutable, measureBisector, parameterOf } from './bisector.ts'

/**
 * An arc of a bisector, from parameter `from` to parameter `to` >= `from`. An end at infinity has the parameter 0 or
 * infinity and no point. The other ends of an edge equal its vertices bit for bit, so arcs that share a vertex meet
 * exactly. An edge of length zero has equal parameters.
 *
 * @category Curves
 */
export interface EdgeCurve {
  readonly bisector: Bisector
  readonly from: number
  readonly to: number
  /** The start point; `undefined` at infinity. */
  readonly start: Point | undefined
  /** The end point; `undefined` at infinity. */
  readonly end: Point | undefined
}

/**
 * A bounded arc.
 *
 * @category Curves
 */
export interface BoundedCurve extends EdgeCurve {
  readonly start: Point
  readonly end: Point
}

/**
 * Returns whether an arc is bounded.
 *
 * @category Curves
 * @example
 * isBoundedCurve(edgeCurve(diagram, 0)) // false
 * clipCurve(edgeCurve(diagram, 0), { bounds: [-5, -5, 10, 10] }).every(isBoundedCurve) // true
 */
export function isBoundedCurve(curve: EdgeCurve): curve is BoundedCurve {
  return curve.start !== undefined && curve.end !== undefined
}

/**
 * Returns the curve of edge `edge` of a diagram.
 *
 * @throws CircleVoronoiError `badInput`, if there is no such edge
 *
 * @category Curves
 * @example
 * const curve = edgeCurve(diagram, 0)
 * curve.bisector.a // 0
 * curve.from < curve.to // true
 */
export function edgeCurve(diagram: DiagramData, edge: number): EdgeCurve {
  checkData(diagram, 'edgeCurve')
  checkIndex(edge, diagram.edges.length / 4, 'edgeCurve', 'edge')
  return curveOf(diagram, edge)
}

/** Does what `edgeCurve` does, for arguments that have been checked. `room` holds the bisector and the ends of the result. */
export function curveOf(
  { circles, metric, weights, vertices, edges }: DiagramData,
  edge: number,
  room = roomForCurve(),
): EdgeCurve {
  const start = placed(room.start, vertices, at(edges, 4 * edge + 2))
  const end = placed(room.end, vertices, at(edges, 4 * edge + 3))
  const left = at(edges, 4 * edge)
  const right = at(edges, 4 * edge + 1)
  const whole = measureBisector(room.bisector, circles, left, right, metric, weights)
  return arcBetween(whole, start, end)
}

function roomForCurve() {
  return { bisector: blankBisector(), start: { x: 0.5, y: 0.5 }, end: { x: 0.5, y: 0.5 } }
}

/** Moves a point to a vertex and returns it; `undefined` at infinity. */
function placed(point: Mutable<Point>, vertices: Float64Array, vertex: number): Point | undefined {
  if (vertex === NONE) return undefined
  point.x = at(vertices, 3 * vertex)
  point.y = at(vertices, 3 * vertex + 1)
  return point
}

const room = roomForCurve()
let borrowers = 0

/**
 * Borrows the curve of a side, with its cell on the left, until `returnCurve`. Only `left` and `right` of its bisector
 * are the objects of the edge. The objects of the curve are reused, because drawing needs each curve once. A context
 * that draws another cell from its own callbacks gets new objects.
 */
export function borrowCurve(diagram: DiagramData, side: number): EdgeCurve {
  const curve = curveOf(diagram, side >> 1, borrowers === 0 ? room : roomForCurve())
  borrowers += 1
  if (side % 2 === 0) return curve
  const bisector = curve.bisector as Mutable<Bisector>
  bisector.a = -bisector.a
  bisector.across.x = -bisector.across.x
  bisector.across.y = -bisector.across.y
  return { bisector, from: 1 / curve.to, to: 1 / curve.from, start: curve.end, end: curve.start }
}

/** Returns the curve that was borrowed last. */
export function returnCurve(): void {
  borrowers -= 1
}

/** Parameters with a larger quotient belong to different points. */
const FAR_APART = 2 ** 10

/** Returns whether rounding hides on which side of the axis a point lies, for example far out on a narrow branch. */
function isSideHidden({ origin, across }: Bisector, p: Point): boolean {
  const toPoint = between(origin, p)
  return Math.abs(dot(toPoint, across)) <= ROUNDING * lengthOf(toPoint)
}

/** Returns the arc of a bisector between two ends. An end that is `undefined` is at infinity. */
function arcBetween(curve: Bisector, start: Point | undefined, end: Point | undefined): EdgeCurve {
  let from = start === undefined ? 0 : parameterOf(curve, start.x, start.y)
  let to = end === undefined ? Number.POSITIVE_INFINITY : parameterOf(curve, end.x, end.y)
  // If two distant ends are in the wrong order, one of them is on the other side of the axis.
  if (from > FAR_APART * to) {
    if (to < 1 && isSideHidden(curve, end as Point)) to = 1 / to
    else if (from > 1 && isSideHidden(curve, start as Point)) from = 1 / from
  }
  // The order of the ends is certified: where the parameters contradict it, the edge has length zero up to rounding.
  if (from > to) from = to = Math.sqrt(from) * Math.sqrt(to)
  return { bisector: curve, from, to, start, end }
}

/** Returns the arc in the opposite direction, with left and right exchanged. */
export function reversed(curve: BoundedCurve): BoundedCurve
export function reversed(curve: EdgeCurve): EdgeCurve
export function reversed({ bisector, from, to, start, end }: EdgeCurve): EdgeCurve {
  const { left, right, a, b, origin, along, across, apex } = bisector
  return {
    // A spread would take longer.
    bisector: {
      left: right,
      right: left,
      a: -a,
      b,
      origin,
      along,
      across: { x: -across.x, y: -across.y },
      apex,
    },
    // 1 / infinity is 0, and 1 / 0 is infinity.
    from: 1 / to,
    to: 1 / from,
    start: end,
    end: start,
  }
}

/** Returns the straight segment between two different points. */
export function segment(start: Point, end: Point): BoundedCurve {
  const chord = between(start, end)
  // Vertices may lie far apart (scale.ts).
  const size = lengthOf(chord)
  const across = { x: chord.x / size, y: chord.y / size }
  const along = { x: across.y, y: -across.x }
  const half = size / 2
  const middle = { x: start.x + chord.x / 2, y: start.y + chord.y / 2 }
  const left = { x: middle.x - half * along.x, y: middle.y - half * along.y }
  const right = { x: middle.x + half * along.x, y: middle.y + half * along.y }
  return {
    bisector: { left, right, a: 0, b: size / 2, origin: left, along, across, apex: size / 2 },
    from: exponentialOf(-1),
    to: exponentialOf(1),
    start,
    end,
  }
}
