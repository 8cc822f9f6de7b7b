// SPDX-License-Identifier: GPL-3.0-or-later
import { checkAbove0, checkCircles, checkIndex, checkNumber, checkThing, refuseInput, shown } from '../base/check.ts'
import { at } from '../base/diagram-data.ts'
import { hypotenuse } from '../base/scale.ts'
import { tangentSquare } from '../base/two-part.ts'
import type { Point, Vector } from '../base/types.ts'
import { METRICS, type Metric } from '../base/types.ts'

/**
 * The bisector of two circles, the points at the same distance from both: one branch of a hyperbola whose foci are the
 * centers and whose axis has length 2 |a| = |r_left - r_right|, bent around the smaller circle. Seen from the center of
 * the smaller circle, the origin,
 *
 *     point(s) = origin + (apex - |a| (s - 1)^2 / (2 s)) along + b (s - 1 / s) / 2 across,      0 < s < infinity,
 *
 * so s = 1 is the apex, on the line of centers, and growing s has the left circle on its left. With s = e^t this is the
 * usual (|a| cosh t, b sinh t), without cancellation near the smaller circle and without functions that differ between
 * platforms. For equal radii, and for the other metrics, a is 0 and the branch is a straight line.
 *
 * Multiplying s by a number is an affine map of the branch onto itself. So the shape of an arc depends only on the
 * ratio of the parameters at its ends.
 *
 * @category Curves
 */
export interface Bisector {
  /** The center of the left circle, one of the two foci. */
  readonly left: Point
  /** The center of the right circle, one of the two foci. */
  readonly right: Point
  /** Half the difference of the radii, (r_left - r_right) / 2; 0 for a straight bisector. */
  readonly a: number
  /** The other half-axis of the hyperbola, above 0: a^2 + b^2 = c^2, where c is half the distance of the centers. */
  readonly b: number
  /** The center of the smaller circle, or of the left circle if the radii are equal. */
  readonly origin: Point
  /** Unit vector from the origin to the other focus. */
  readonly along: Vector
  /** Unit vector at right angles to `along`, with the left circle on its left. */
  readonly across: Vector
  /**
   * The distance c - |a| from the origin to the apex. For the metric `power` it is where the radical axis crosses the
   * line of centers, and may be negative.
   */
  readonly apex: number
}

/**
 * The smallest parameter of a finite point: 0 and infinity are reserved for ends at infinity. No edge reaches it. Vertices
 * lie within 2^876 of circles whose centers are 2^-96 apart, so parameters lie between 2^-974 and 2^974.
 */
const SMALLEST_PARAMETER = 1e-300
const LARGEST_PARAMETER = 1e300
/**
 * The smallest b, as a share of the distance. It keeps b above 0 where one circle touches the other from inside, and
 * the branch is a folded ray.
 */
const SMALLEST_B = 2 ** -50
/**
 * The largest distance of a circle from touching another one from inside, as a share, where it is computed with twice the
 * digits.
 */
const NEARLY_INSIDE = 2 ** -16

/**
 * Returns the bisector of two circles that both have cells. `circles` has x, y, r of each circle.
 *
 * @throws CircleVoronoiError `badInput`, if there are no such circles, they have the same center, or the metric is
 *   unknown
 *
 * @category Curves
 * @example
 * bisector(Float64Array.of(-2, 0, 1, 2, 0, 0), 0, 1).apex // 1.5
 */
export function bisector(circles: Float64Array, left: number, right: number, metric: Metric = 'circles'): Bisector {
  checkCircles(circles, 'bisector')
  checkIndex(left, circles.length / 3, 'bisector', 'circle')
  checkIndex(right, circles.length / 3, 'bisector', 'circle')
  if (!METRICS.includes(metric)) refuseInput(`There is no metric ${shown(metric)}.`)
  const isSame = (k: number) => circles[3 * left + k] === circles[3 * right + k]
  if (isSame(0) && isSame(1)) refuseInput('bisector takes two circles with different centers.')
  return bisectorOf(circles, left, right, metric)
}

/** Does what `bisector` does, for arguments that have been checked. */
export function bisectorOf(circles: Float64Array, left: number, right: number, metric: Metric): Bisector {
  return measureBisector(blankBisector(), circles, left, right, metric, false)
}

/** An object whose numbers can be replaced in place. */
export type Mutable<T> = { -readonly [Key in keyof T]: T[Key] extends Point ? { x: number; y: number } : T[Key] }

/**
 * Creates a bisector for `measureBisector` to fill. Its numbers are not integers, which engines would store in another
 * way.
 */
export function blankBisector(): Mutable<Bisector> {
  const point = () => ({ x: 0.5, y: 0.5 })
  const left = point()
  return { left, right: point(), a: 0.5, b: 0.5, origin: left, along: point(), across: point(), apex: 0.5 }
}

/** Sets `target` to the bisector of two circles and returns it. */
export function measureBisector(
  target: Mutable<Bisector>,
  circles: Float64Array,
  left: number,
  right: number,
  metric: Metric,
  weights: boolean,
): Bisector {
  const leftRadius = at(circles, 3 * left + 2)
  const rightRadius = at(circles, 3 * right + 2)
  target.left.x = at(circles, 3 * left)
  target.left.y = at(circles, 3 * left + 1)
  target.right.x = at(circles, 3 * right)
  target.right.y = at(circles, 3 * right + 1)
  const originIsLeft = metric !== 'circles' || leftRadius <= rightRadius
  const origin = originIsLeft ? target.left : target.right
  const other = originIsLeft ? target.right : target.left
  const x = other.x - origin.x
  const y = other.y - origin.y
  const d = Math.sqrt(x * x + y * y)
  const difference = metric === 'circles' ? leftRadius - rightRadius : 0
  const size = Math.abs(difference)
  // Below 2^290: the radii are below 2^97, and the centers 2^-96 apart.
  const sum = weights ? 1 : leftRadius + rightRadius
  const shift = metric === 'power' ? (leftRadius - rightRadius) * (sum / (2 * d)) : 0
  // The difference of d and size has few digits where one circle is nearly inside the other. The difference of their
  // squares has all digits.
  const isNearlyInside = metric === 'circles' && d - size < NEARLY_INSIDE * d
  const square = isNearlyInside ? tangentSquare(circles, left, right) : (d - size) * (d + size)
  target.a = difference / 2
  target.b = Math.max(Math.sqrt(Math.max(square, 0)), d * SMALLEST_B) / 2
  target.origin = origin
  target.along.x = x / d
  target.along.y = y / d
  target.across.x = originIsLeft ? -target.along.y : target.along.y
  target.across.y = originIsLeft ? target.along.x : -target.along.x
  target.apex = (isNearlyInside ? Math.max(square, 0) / (d + size) : d - size) / 2 + shift
  return target
}

/**
 * Returns the point of the bisector at the parameter 0 < s < infinity.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Curves
 * @example
 * pointAt(bisector(Float64Array.of(-2, 0, 1, 2, 0, 0), 0, 1), 1) // { x: 0.5, y: 0 }
 */
export function pointAt(bisector: Bisector, s: number): Point {
  checkThing(bisector, 'apex', 'pointAt', 'a bisector')
  checkAbove0(s, 'pointAt', 'parameter')
  return pointOf(bisector, s)
}

/** Does what `pointAt` does, for arguments that have been checked. */
export function pointOf(bisector: Bisector, s: number): Point {
  const { apex, a, b } = bisector
  return inPlane(bisector, apex - Math.abs(a) * (((s - 1) / s) * ((s - 1) / 2)), (b * (s - 1 / s)) / 2)
}

/** Returns the point at u along and v across from the origin. */
export function inPlane({ origin, along, across }: Bisector, u: number, v: number): Point {
  return { x: origin.x + (u * along.x + v * across.x), y: origin.y + (u * along.y + v * across.y) }
}

/**
 * Returns the parameter of a point (x, y) that lies on the bisector up to rounding.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Curves
 * @example
 * parameterAt(bisector(Float64Array.of(-2, 0, 1, 2, 0, 0), 0, 1), 0.5, 0) // 1
 */
export function parameterAt(bisector: Bisector, x: number, y: number): number {
  checkThing(bisector, 'apex', 'parameterAt', 'a bisector')
  checkNumber(x, 'parameterAt', 'x')
  checkNumber(y, 'parameterAt', 'y')
  return parameterOf(bisector, x, y)
}

/** Does what `parameterAt` does, for arguments that have been checked. */
export function parameterOf(bisector: Bisector, x: number, y: number): number {
  const { origin, across, apex, a, b } = bisector
  const dx = x - origin.x
  const dy = y - origin.y
  const sine = (dx * across.x + dy * across.y) / b
  if (a === 0) return exponentialOf(sine)
  // The point's height b sinh t and its distance apex + c (cosh t - 1) both determine t. Rounding matters less in the
  // value that changes faster. For a narrow branch this is the distance, because the height may be off by any factor,
  // like b. Each of the two values tells whether to use the distance.
  const c = apex + Math.abs(a)
  const rise = Math.max((hypotenuse(dx, dy) - apex) / c, 0)
  const size = Math.max(Math.abs(sine), Math.sqrt(rise) * Math.sqrt(rise + 2))
  const isSteep = c * size > b * hypotenuse(size, 1)
  if (!isSteep) return exponentialOf(sine)
  return sine < 0 ? 1 / parameterAtRise(rise) : parameterAtRise(rise)
}

/** Returns the parameter s >= 1 at which the distance is apex + c rise, where rise = cosh t - 1. */
function parameterAtRise(rise: number): number {
  return exponentialOf(Math.sqrt(rise) * Math.sqrt(rise + 2))
}

/**
 * Returns the parameter s >= 1 at which a branch has a distance from its origin, at least that of the apex. The distance
 * is apex + c (cosh t - 1) for a hyperbola, and the hypotenuse of apex and b sinh t for a line.
 */
export function parameterAtDistance(bisector: Bisector, distance: number): number {
  const apex = Math.abs(bisector.apex)
  if (bisector.a !== 0) return parameterAtRise((distance - apex) / (apex + Math.abs(bisector.a)))
  return exponentialOf(Math.sqrt(distance - apex) * (Math.sqrt(distance + apex) / bisector.b))
}

/** e^t for t = arsinh(sine). */
export function exponentialOf(sine: number): number {
  const size = Math.abs(sine)
  const s = size < 1e100 ? size + Math.sqrt(size * size + 1) : 2 * size
  return Math.min(Math.max(sine < 0 ? 1 / s : s, SMALLEST_PARAMETER), LARGEST_PARAMETER)
}
