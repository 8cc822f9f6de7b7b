// SPDX-License-Identifier: GPL-3.0-or-later

import { checkThing } from '../base/check.ts'
import { between, dot } from '../base/point.ts'
import { largestOf, ROUNDING } from '../base/scale.ts'
import type { Point, Vector } from '../base/types.ts'
import { type Bisector, pointOf } from '../curves/bisector.ts'
import type { BoundedCurve, EdgeCurve } from '../curves/curve.ts'
import { boundsOf, type ConvexBoundsOptions } from './convex-polygon.ts'

/** The largest rounding error of a crossing, as a share of its side, divided by the rounding error of a length. */
const ROUNDING_OF_CROSSINGS = 2 ** 6
/** Stands for a side of a polygon: the end lies on the circle that cuts a cell at the maximum distance. */
export const CIRCLE_CUT = -2

/**
 * A part of a curve inside bounds. `cutFrom` and `cutTo` are the sides of the bounds on which the ends of the part lie,
 * or `CIRCLE_CUT`. `NONE` means that the part ends at the end of the curve.
 */
export interface Part {
  readonly curve: BoundedCurve
  readonly cutFrom: number
  readonly cutTo: number
}

export function isSame(p: Point, q: Point): boolean {
  return p.x === q.x && p.y === q.y
}

/**
 * Returns the pieces of an arc inside bounds, in order. Each piece is bounded; there are several if the arc leaves
 * the bounds and comes back. Rounding may add or drop a piece about as short as rounding; `Diagram` decides the parts of
 * its edges exactly.
 *
 * @throws CircleVoronoiError `badInput`, `badOption`
 *
 * @category Curves
 * @example
 * clipCurve(edgeCurve(diagram, 0), { bounds: [-5, -5, 10, 10] }).length // 1
 */
export function clipCurve(curve: EdgeCurve, options: ConvexBoundsOptions): BoundedCurve[] {
  checkThing(curve, 'bisector', 'clipCurve', 'a curve')
  const bounds = boundsOf(options, 'clipCurve')
  const { bisector, from, to } = curve
  const ends: { s: number; p: Point | undefined }[] = [{ s: from, p: curve.start }]
  const isBetween = (s: number) => s * (1 - ROUNDING) > from && s * (1 + ROUNDING) < to
  bounds.corners.forEach((corner, k) => {
    const next = bounds.cornerAfter(k)
    for (const s of new LineCrossing(bisector, corner, between(corner, next)).parameters) {
      if (isBetween(s)) ends.push({ s, p: nearestOn(corner, next, pointOf(bisector, s)) })
    }
  })
  ends.sort((one, other) => one.s - other.s).push({ s: to, p: curve.end })
  const pieces: BoundedCurve[] = []
  ends.slice(1).forEach(({ s, p: end }, k) => {
    const { s: last, p: start } = ends[k] as { s: number; p: Point | undefined }
    if (start === undefined || end === undefined) return
    if (!bounds.contains(pointOf(bisector, Math.sqrt(last) * Math.sqrt(s)))) return
    const before = pieces.at(-1)
    if (before?.to === last && before.end === start) pieces[pieces.length - 1] = { ...before, to: s, end }
    else pieces.push({ bisector, from: last, to: s, start, end })
  })
  return pieces
}

/** Returns the point of a segment that is nearest to a point, up to rounding. */
export function nearestOn(from: Point, to: Point, p: Point): Point {
  const along = between(from, to)
  const share = dot(between(from, p), along) / dot(along, along)
  return share <= 0 ? from : share >= 1 ? to : { x: from.x + share * along.x, y: from.y + share * along.y }
}

/**
 * The point where a branch crosses the line through `p` along a direction.
 *
 * Let n be the normal to the right of the line. Multiplying n . (point(s) - p) > 0 by 2 s gives
 *
 *     (A + B) s^2 - 2 (A + k) s + (A - B) > 0
 *
 * with A = -|a| n . along, B = b n . across, and k = n . (p - origin - apex along). Only the ratios of A, B, k matter.
 */
export class LineCrossing {
  /** The parameters in increasing order: none, one or two. */
  readonly parameters: readonly number[]
  readonly #crossings: readonly { readonly s: number; readonly goesRight: boolean }[]
  readonly #root: number
  readonly #height: number
  readonly #axes: number

  constructor(bisector: Bisector, p: Point, direction: Vector) {
    const normal = { x: direction.y, y: -direction.x }
    const a = -Math.abs(bisector.a) * dot(normal, bisector.along)
    const b = bisector.b * dot(normal, bisector.across)
    const toLine = between(bisector.origin, p)
    const k = dot(normal, toLine) - bisector.apex * dot(normal, bisector.along)
    const half = a + k
    const growth = a + b
    const decay = a - b
    const discriminant = k * (k + 2 * a) + b * b
    const root = Math.sqrt(discriminant)
    const sum = half < 0 ? half - root : half + root
    const crossings = [
      { s: sum / growth, goesRight: growth > 0 },
      { s: decay / sum, goesRight: decay < 0 },
    ].filter(({ s }) => discriminant > 0 && s > 0 && s < Number.POSITIVE_INFINITY)
    this.#crossings = crossings.sort((one, other) => one.s - other.s)
    this.parameters = this.#crossings.map(({ s }) => s)
    this.#root = root
    this.#axes = Math.abs(bisector.a) + bisector.b
    this.#height =
      this.#axes +
      Math.abs(bisector.apex) +
      (Math.abs(normal.x * toLine.x) + Math.abs(normal.y * toLine.y)) / largestOf(direction)
  }

  /** Returns whether rounding moves the crossing at a parameter by less than 2^-44 of the length of `direction`. */
  isCertainAt(s: number): boolean {
    // The height above the line has a rounding error of the height and of the point's coordinates on the branch, which
    // is `extent` at most. The parameter changes the height at the rate `root`, and the point at the rate `extent`.
    const extent = (this.#axes * (s + 1 / s)) / 2
    return (this.#height + extent) * extent < ROUNDING_OF_CROSSINGS * this.#root
  }

  /** Returns the parameter where the branch crosses from the left of the line to the right, or from right to left. */
  crossing(toRight: boolean): number | undefined {
    return this.#crossings.find(({ goesRight }) => goesRight === toRight)?.s
  }
}
