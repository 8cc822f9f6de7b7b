// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from './diagram-data.ts'
import type { Metric } from './metric.ts'
import type { Point, Vector } from './point.ts'

/**
 * The bisector of two circles, the points at the same distance from both: one branch of a hyperbola whose foci are the
 * centres and whose axis has length 2 |a| = |r_left - r_right|, bent around the smaller circle. Seen from the centre of
 * the smaller circle, the origin,
 *
 *     point(s) = origin + (apex - |a| (s - 1)^2 / (2 s)) along + b (s - 1 / s) / 2 across,      0 < s < infinity,
 *
 * so s = 1 is the apex, on the line of centres, and growing s has the left circle on its left. With s = e^t this is the
 * usual (|a| cosh t, b sinh t), without cancellation near the smaller circle and without functions that differ between
 * platforms. For equal radii a is 0 and the branch is a straight line, as it is for the other metrics.
 *
 * Lengths are squared: below about 1e-150 they count as zero, and arcs of such circles end but are not right.
 *
 * Multiplying s by a number is an affine map of the branch onto itself: an arc is as curved as the ratio of the parameters
 * of its ends says, wherever it lies.
 */
export interface Bisector {
  /** The foci: the centre of the left circle, */
  readonly left: Point
  /** and of the right one. */
  readonly right: Point
  /** (r_left - r_right) / 2 */
  readonly a: number
  /** a^2 + b^2 = c^2, where c is half the distance of the centres; above 0 */
  readonly b: number
  /** The focus of the smaller circle, the left one if radii are equal. */
  readonly origin: Point
  /** Unit vector from the origin to the other focus. */
  readonly along: Vector
  /** Unit vector at right angles to it, with the left circle on its left. */
  readonly across: Vector
  /**
   * The distance c - |a| from the origin to the apex. For the metric `power` it is where the radical axis crosses the line
   * of centres, and may be negative.
   */
  readonly apex: number
}

/** Finite parameters keep away from what stands for infinity. */
const SMALLEST_PARAMETER = 1e-300
const LARGEST_PARAMETER = 1e300
/** Keeps b above zero where two circles touch from inside up to rounding: the branch is then a folded ray. */
const SMALLEST_B = 2 ** -50

/** The bisector of two circles with cells; `circles`: x, y, r each. */
export function bisector(circles: Float64Array, left: number, right: number, metric: Metric = 'circles'): Bisector {
  const leftCentre = { x: at(circles, 3 * left), y: at(circles, 3 * left + 1) }
  const rightCentre = { x: at(circles, 3 * right), y: at(circles, 3 * right + 1) }
  const leftRadius = at(circles, 3 * left + 2)
  const rightRadius = at(circles, 3 * right + 2)
  const difference = metric === 'circles' ? leftRadius - rightRadius : 0
  const size = Math.abs(difference)
  const originIsLeft = difference <= 0
  const origin = originIsLeft ? leftCentre : rightCentre
  const other = originIsLeft ? rightCentre : leftCentre
  const dx = other.x - origin.x
  const dy = other.y - origin.y
  const d = Math.sqrt(dx * dx + dy * dy)
  const along = { x: dx / d, y: dy / d }
  return {
    left: leftCentre,
    right: rightCentre,
    a: difference / 2,
    // Not c^2 - a^2, which cancels for a circle almost inside the other.
    b: Math.max(Math.sqrt(Math.max((d - size) * (d + size), 0)), d * SMALLEST_B) / 2,
    origin,
    along,
    across: originIsLeft ? { x: -along.y, y: along.x } : { x: along.y, y: -along.x },
    apex:
      metric === 'power' ? d / 2 + (leftRadius - rightRadius) * ((leftRadius + rightRadius) / (2 * d)) : (d - size) / 2,
  }
}

/** The point of the bisector with parameter 0 < s < infinity. */
export function pointAt({ origin, along, across, apex, a, b }: Bisector, s: number): Point {
  const u = apex - Math.abs(a) * (((s - 1) / s) * ((s - 1) / 2))
  const v = (b * (s - 1 / s)) / 2
  return { x: origin.x + (u * along.x + v * across.x), y: origin.y + (u * along.y + v * across.y) }
}

/** The parameter of the point of the bisector next to (x, y), a point on it but for rounding. */
export function parameterAt({ origin, across, apex, a, b }: Bisector, x: number, y: number): number {
  const dx = x - origin.x
  const dy = y - origin.y
  const sine = (dx * across.x + dy * across.y) / b
  const c = apex + Math.abs(a)
  // The point's height b sinh t and its distance apex + c (cosh t - 1) both tell t; rounding shows less in the one that
  // changes faster. Of a narrow branch that is the distance.
  const isSteep = a !== 0 && c * Math.abs(sine) > b * Math.sqrt(sine * sine + 1)
  const rise = (Math.sqrt(dx * dx + dy * dy) - apex) / c
  if (!isSteep || !(rise > 0)) return exponentialOf(sine)
  const size = Math.sqrt(rise) * Math.sqrt(rise + 2)
  return exponentialOf(sine < 0 ? -size : size)
}

/** e^t for t = arsinh(sine). */
export function exponentialOf(sine: number): number {
  const size = Math.abs(sine)
  const s = size < 1e100 ? size + Math.sqrt(size * size + 1) : 2 * size
  return Math.min(Math.max(sine < 0 ? 1 / s : s, SMALLEST_PARAMETER), LARGEST_PARAMETER)
}
