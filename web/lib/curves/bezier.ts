// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of bisectors as Bézier curves and polylines.
//
// Each error depends only on the middle of an arc's parameter range and on its half-width h, because multiplying the
// parameter is an affine map. Let w = cosh h, the weight of the arc as a rational Bézier curve, be
//
//     w = (sqrt(to / from) + sqrt(from / to)) / 2.

import { checkAbove0, checkBoundedCurve } from '../base/check.ts'
import { hypotenuse } from '../base/scale.ts'
import type { PathSink, Point } from '../base/types.ts'
import { type Bisector, inPlane, pointOf } from './bisector.ts'
import type { BoundedCurve } from './curve.ts'

/**
 * A conic section as a rational quadratic Bézier curve; its three points have the weights 1, `weight`, 1.
 *
 * @category Curves
 */
export interface RationalBezier {
  readonly start: Point
  readonly control: Point
  readonly end: Point
  readonly weight: number
}

/**
 * A cubic Bézier curve.
 *
 * @category Curves
 */
export interface CubicBezier {
  readonly start: Point
  readonly control1: Point
  readonly control2: Point
  readonly end: Point
}

/**
 * Converts a bounded arc to a rational Bézier curve, exactly.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Curves
 * @example
 * const [arc] = clipCurve(edgeCurve(library.compute([[0, 0, 1], [6, 0, 3]]), 0), { bounds: [-9, -9, 9, 9] })
 * rationalBezier(arc).weight > 1 // true
 */
export function rationalBezier(curve: BoundedCurve): RationalBezier {
  checkBoundedCurve(curve, 'rationalBezier')
  const { bisector, from, to, start, end } = curve
  return { start, control: controlPoint(bisector, from, to), end, weight: 1 + excessOf(from, to) }
}

/** The point of a rational Bézier curve at the parameter 0 <= u <= 1. */
export function bezierPointAt(bezier: RationalBezier, u: number): Point {
  const { start, control, end, weight } = bezier
  const first = (1 - u) * (1 - u)
  const second = 2 * u * (1 - u) * weight
  const third = u * u
  const sum = first + second + third
  return {
    x: (first * start.x + second * control.x + third * end.x) / sum,
    y: (first * start.y + second * control.y + third * end.y) / sum,
  }
}

/**
 * Converts a bounded arc to as few cubic Bézier curves as possible, no farther than `tolerance` from the arc. Each
 * curve has the tangents of the arc at both ends and meets it in the middle, or is straight. The tolerance is above 0;
 * the smallest effective one is 1e-12 of the extent of the arc.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Curves
 * @example
 * const [arc] = clipCurve(edgeCurve(library.compute([[0, 0, 1], [6, 0, 3]]), 0), { bounds: [-9, -9, 9, 9] })
 * cubicBeziers(arc, 0.1).length // 1
 */
export function cubicBeziers(curve: BoundedCurve, tolerance: number): CubicBezier[] {
  checkBoundedCurve(curve, 'cubicBeziers')
  checkAbove0(tolerance, 'cubicBeziers', 'tolerance')
  const pieces: CubicBezier[] = []
  let start = curve.start
  const add = (control1: Point, control2: Point, end: Point) => {
    pieces.push({ start, control1, control2, end })
    start = end
  }
  const sink: Pick<PathSink, 'lineTo' | 'bezierCurveTo'> = {
    lineTo(x, y) {
      const end = { x, y }
      add(mix(start, end, 1 / 3), mix(end, start, 1 / 3), end)
    },
    bezierCurveTo(x1, y1, x2, y2, x, y) {
      add({ x: x1, y: y1 }, { x: x2, y: y2 }, { x, y })
    },
  }
  addArc(sink, curve, tolerance)
  return pieces
}

/**
 * Draws a bounded arc as the curves of `cubicBeziers`. The path must already be at the start of the arc.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Curves
 * @example
 * const [arc] = clipCurve(edgeCurve(diagram, 0), { bounds: [-5, -5, 10, 10] })
 * const path = new SvgPath(1)
 * path.moveTo(arc.start.x, arc.start.y)
 * traceArc(path, arc, 0.1)
 * `${path}`.startsWith('M') // true
 */
export function traceArc(
  sink: Pick<PathSink, 'lineTo' | 'bezierCurveTo'>,
  curve: BoundedCurve,
  tolerance: number,
): void {
  checkBoundedCurve(curve, 'traceArc')
  checkAbove0(tolerance, 'traceArc', 'tolerance')
  addArc(sink, curve, tolerance)
}

/** Does what `traceArc` does, for arguments that have been checked. */
export function addArc(sink: Pick<PathSink, 'lineTo' | 'bezierCurveTo'>, curve: BoundedCurve, tolerance: number): void {
  const { bisector, to: last } = curve
  let { from, start } = curve
  if (isNearlyStraight(bisector.a, from, last, tolerance)) {
    sink.lineTo(curve.end.x, curve.end.y)
    return
  }
  let excess = excessOf(from, last)
  let error = chordError(bisector.a, bisector.b, from, last, excess)
  const limit = effectiveTolerance(1e-12, curve, error, tolerance)
  for (let isLast = false; !isLast; ) {
    // If one cubic is enough for the rest of the arc, no search for the longest line is needed.
    const byOneCubic = error > limit && cubicError(bisector.a, bisector.b, from, last, excess) <= limit
    const byCubic = byOneCubic || !(error > limit) ? last : farthestByCubic(bisector, from, last, limit)
    // Errors grow along the arc, so no search is needed if a line up to `byCubic` exceeds the limit.
    const isShorter = byOneCubic || (byCubic > from && chordError(bisector.a, bisector.b, from, byCubic) > 2 * limit)
    const byLine = isShorter ? from : farthestByChord(bisector, from, last, limit)
    const to = Math.max(byLine, byCubic)
    isLast = !(to < last)
    const end = isLast ? curve.end : pointOf(bisector, to)
    if (!(byCubic > byLine)) {
      sink.lineTo(end.x, end.y)
    } else {
      const control = controlPoint(bisector, from, to)
      const weight = 1 + (isLast ? excess : excessOf(from, to))
      const share = (4 * weight) / (3 * (1 + weight))
      sink.bezierCurveTo(
        start.x + share * (control.x - start.x),
        start.y + share * (control.y - start.y),
        end.x + share * (control.x - end.x),
        end.y + share * (control.y - end.y),
        end.x,
        end.y,
      )
    }
    from = to
    start = end
    if (isLast) return
    excess = excessOf(from, last)
    error = chordError(bisector.a, bisector.b, from, last, excess)
  }
}

/**
 * Converts a bounded arc to a polyline no farther than `tolerance` from the arc. It has as few points as possible, at
 * least two. The tolerance is above 0; the smallest effective one is 1e-9 of the extent of the arc.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Curves
 * @example
 * const [arc] = clipCurve(edgeCurve(library.compute([[0, 0, 1], [6, 0, 3]]), 0), { bounds: [-9, -9, 9, 9] })
 * polyline(arc, 0.1).length > polyline(arc, 1).length // true
 */
export function polyline(curve: BoundedCurve, tolerance: number): Point[] {
  checkBoundedCurve(curve, 'polyline')
  checkAbove0(tolerance, 'polyline', 'tolerance')
  return polylineOf(curve, tolerance)
}

/** Does what `polyline` does, for arguments that have been checked. */
export function polylineOf(curve: BoundedCurve, tolerance: number): Point[] {
  const { bisector, from: first, to, start, end } = curve
  if (isNearlyStraight(bisector.a, first, to, tolerance)) return [start, end]
  const limit = effectiveTolerance(1e-9, curve, chordError(bisector.a, bisector.b, first, to), tolerance)
  const points = [start]
  let from = farthestByChord(bisector, first, to, limit)
  while (from < to) {
    points.push(pointOf(bisector, from))
    from = farthestByChord(bisector, from, to, limit)
  }
  points.push(end)
  return points
}

/** Returns the intersection of the tangents at two parameters: the polar form of the branch. */
export function controlPoint(bisector: Bisector, from: number, to: number): Point {
  const { apex, a, b } = bisector
  const u = apex - Math.abs(a) * (((from - 1) / (from + to)) * (to - 1))
  return inPlane(bisector, u, b * ((from / (from + to)) * to - 1 / (from + to)))
}

/** w - 1 */
function excessOf(from: number, to: number): number {
  const difference = Math.sqrt(to) - Math.sqrt(from)
  return ((difference / Math.sqrt(from)) * (difference / Math.sqrt(to))) / 2
}

/**
 * Returns the largest distance of an arc from its chord, or an upper bound. On one side of the apex the arc turns by
 * less than a right angle, so the distance is largest at the middle parameter, where the tangent is parallel to the
 * chord: w - 1 times the distance of that tangent from the middle of the hyperbola. An arc around the apex may be a
 * needle, nearer to the line of its chord than to the chord itself. Its bound is the distance parallel to the axis, at
 * most w - 1 times |a|.
 */
function chordError(a: number, b: number, from: number, to: number, excess = excessOf(from, to)): number {
  if (a === 0) return 0
  const along = excess * Math.abs(a)
  if (from < 1 && 1 < to) return along
  const middle = Math.sqrt(from) * Math.sqrt(to)
  const x = (a * (middle - 1 / middle)) / 2
  const y = (b * (middle + 1 / middle)) / 2
  return along * (b / hypotenuse(x, y))
}

/**
 * Whether an arc is within a tolerance of its chord by a bound without square roots, which most arcs of a drawing
 * satisfy. The error is at most |a| (w - 1), and w - 1 = (w^2 - 1) / (w + 1) is at most (to - from)^2 / (8 from to).
 */
function isNearlyStraight(a: number, from: number, to: number, tolerance: number): boolean {
  const difference = to - from
  return a === 0 || Math.abs(a) * (difference / from) * (difference / to) <= 8 * tolerance
}

/**
 * A bound for the largest distance of an arc from the cubic with its tangents at both ends and its middle point.
 *
 * In the affine frame where the arc is (cosh t, sinh t), |t| <= h, the cubic (X, Y)(u) has
 *
 *     X^2 - Y^2 = 1 - 4 (w - 1)^3 / (w + 1) q^2 (1 - 4 q),      q = u (1 - u),
 *
 * so 0 <= 1 - X^2 + Y^2 <= f = (w - 1)^3 / (27 (w + 1)). That holds in the frame of the hyperbola's axes as well, where
 * the way to the branch along one axis is at most |a| f / (2 k cosh t), along the other b f / (k sinh t), with
 * k^2 = 1 - f and t the parameter of the arc nearest to the apex.
 */
function cubicError(a: number, b: number, from: number, to: number, excess = excessOf(from, to)): number {
  const f = (excess * excess * excess) / (27 * (excess + 2))
  if (!(f < 0.5)) return Number.POSITIVE_INFINITY
  const k = Math.sqrt(1 - f)
  const nearest = Math.min(Math.max(1, from), to)
  const sine = Math.abs(nearest - 1 / nearest) / 2
  const cosine = (nearest + 1 / nearest) / 2
  const error = (Math.abs(a) * f) / (2 * k * cosine)
  return k * k * sine * sine > f ? Math.min(error, (b * f) / (k * sine)) : error
}

/**
 * Returns the largest parameter up to `to` at which an arc is still within the tolerance of its chord, except for a few
 * percent of the way.
 */
function farthestByChord({ a, b }: Bisector, from: number, to: number, tolerance: number): number {
  if (!(chordError(a, b, from, to) > tolerance)) return to
  const nearlyAll = 15 / 16
  const mostSteps = 50
  // The error is w - 1 times a factor that is |a| around the apex, at most |a| elsewhere, and changes slowly.
  let excess = tolerance / Math.abs(a)
  let good = from
  let bad = to
  if (from < 1 && 1 < to) {
    const end = from * quotientOf(excess)
    if (end >= 1) return end
    if (!(chordError(a, b, from, 1) > tolerance)) return 1
    bad = 1
  }
  for (let i = 0; i < mostSteps; i++) {
    const proposed = from * quotientOf(excess)
    const next = good < proposed && proposed < bad ? proposed : Math.sqrt(good) * Math.sqrt(bad)
    const error = chordError(a, b, from, next)
    if (error > tolerance) {
      bad = next
    } else {
      good = next
      if (error >= nearlyAll * tolerance) break
    }
    excess = excessOf(from, next) * (tolerance / error)
  }
  return good > from ? good : bad
}

/** Returns the quotient of the parameters at the ends of an arc with a given w - 1. */
function quotientOf(excess: number): number {
  const root = 1 + excess + Math.sqrt(excess * (excess + 2))
  return root * root
}

/**
 * Returns the largest parameter up to `to` at which an arc is still within the tolerance of its cubic, except for a few
 * percent of the way. The error grows with the parameter.
 */
function farthestByCubic({ a, b }: Bisector, from: number, to: number, tolerance: number): number {
  if (!(cubicError(a, b, from, to) > tolerance)) return to
  const halvings = 50
  const nearEnough = 1 / 32
  let good = from
  let bad = to
  for (let i = 0; i < halvings && bad - good > nearEnough * (good - from); i++) {
    const middle = Math.sqrt(good) * Math.sqrt(bad)
    if (cubicError(a, b, from, middle) <= tolerance) good = middle
    else bad = middle
  }
  return good > from ? good : bad
}

/** Returns a tolerance that is not below a share of the arc's extent. `error` is the error of the chord. */
function effectiveTolerance(share: number, { start, end }: BoundedCurve, error: number, tolerance: number): number {
  const least = share * (hypotenuse(end.x - start.x, end.y - start.y) + error)
  return tolerance > least ? tolerance : least
}

function mix(p: Point, q: Point, share: number): Point {
  return { x: p.x + share * (q.x - p.x), y: p.y + share * (q.y - p.y) }
}
