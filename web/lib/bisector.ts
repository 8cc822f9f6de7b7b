// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from './diagram.ts'
import type { PathSink } from './path-sink.ts'

/**
 * The bisector of two circles, the points at the same signed distance from both: one branch of a hyperbola whose foci
 * are the centres. With m the middle of the centres, u the unit vector from the left centre to the right one and v = u
 * turned by 90 degrees counter-clockwise,
 *
 *     point(t) = m + a cosh(t) u + b sinh(t) v,      a = (r_left - r_right) / 2,  a^2 + b^2 = c^2,
 *
 * where c is half the distance of the centres. Growing t has the left circle on its left. For equal radii a is 0 and the
 * branch is a straight line. The distance to the left centre is c cosh(t) + a, so it grows with |t|.
 *
 * A shift of t is an affine map of the branch onto itself, so an arc is as curved as its range of t is wide, wherever it
 * lies: every formula below depends on the half-width h of the range alone.
 */
export interface Bisector {
  readonly mx: number
  readonly my: number
  readonly ux: number
  readonly uy: number
  readonly a: number
  readonly b: number
  readonly c: number
}

export interface Point {
  readonly x: number
  readonly y: number
}

/** A range of the parameter t, `from` less than `to`; the ends may be infinite. */
export interface Range {
  readonly from: number
  readonly to: number
}

/** Keeps b above zero where two circles touch from inside up to rounding: the branch is then a folded ray. */
const SMALLEST_B = 2 ** -50

/** `circles`: x, y, r each. Precondition: neither circle contains the other. */
export function bisector(circles: Float64Array, left: number, right: number): Bisector {
  const xl = at(circles, 3 * left)
  const yl = at(circles, 3 * left + 1)
  const dx = at(circles, 3 * right) - xl
  const dy = at(circles, 3 * right + 1) - yl
  const dr = at(circles, 3 * left + 2) - at(circles, 3 * right + 2)
  const d = Math.sqrt(dx * dx + dy * dy)
  return {
    mx: xl + dx / 2,
    my: yl + dy / 2,
    ux: dx / d,
    uy: dy / d,
    a: dr / 2,
    // Not c^2 - a^2, which cancels for a circle almost inside the other.
    b: Math.max(Math.sqrt(Math.max((d - dr) * (d + dr), 0)), d * SMALLEST_B) / 2,
    c: d / 2,
  }
}

export function pointAt({ mx, my, ux, uy, a, b }: Bisector, t: number): Point {
  const along = a * Math.cosh(t)
  const across = b * Math.sinh(t)
  return { x: mx + along * ux - across * uy, y: my + along * uy + across * ux }
}

/** The parameter of a point of the bisector. */
export function parameterAt({ mx, my, ux, uy, b }: Bisector, x: number, y: number): number {
  return Math.asinh(((y - my) * ux - (x - mx) * uy) / b)
}

/**
 * The part of `range` whose points are at a distance from the left centre between `near` and `far`: no range, one, or
 * one on either side of the apex t = 0. It is bounded if `far` is finite.
 */
export function rangesWithin({ a, c }: Bisector, range: Range, near: number, far: number): Range[] {
  const farthest = (far - a) / c
  if (!(farthest >= 1)) return []
  const outer = Math.acosh(farthest)
  const nearest = (near - a) / c
  if (nearest <= 1) return intersections(range, [{ from: -outer, to: outer }])
  const inner = Math.acosh(nearest)
  return intersections(range, [
    { from: -outer, to: -inner },
    { from: inner, to: outer },
  ])
}

function intersections(range: Range, others: readonly Range[]): Range[] {
  return others
    .map(({ from, to }) => ({ from: Math.max(from, range.from), to: Math.min(to, range.to) }))
    .filter(({ from, to }) => from < to)
}

/** An arc as a rational quadratic Bezier curve: exact, with weights 1, `weight`, 1. */
export interface RationalBezier {
  readonly start: Point
  readonly control: Point
  readonly end: Point
  readonly weight: number
}

/** The arc from parameter `from` to parameter `to`, both finite. */
export function rationalBezier(curve: Bisector, from: number, to: number): RationalBezier {
  const weight = Math.cosh((to - from) / 2)
  const apex = pointAt(curve, (from + to) / 2)
  return {
    start: pointAt(curve, from),
    // The tangents at both ends meet on the ray from the middle of the hyperbola through the arc's apex.
    control: { x: curve.mx + (apex.x - curve.mx) / weight, y: curve.my + (apex.y - curve.my) / weight },
    end: pointAt(curve, to),
    weight,
  }
}

/**
 * Draws the arc from parameter `from` (where the path already is) to parameter `to`, in either direction, as cubic Bezier
 * curves no farther than `tolerance` from it. The last one ends at `end`, which is the arc's end up to rounding: arcs that
 * meet in a vertex then meet exactly.
 */
export function traceArc(
  sink: PathSink,
  curve: Bisector,
  from: number,
  to: number,
  end: Point,
  tolerance: number,
): void {
  const { mx, my, ux, uy, a, b } = curve
  const size = Math.abs(a)
  // The chord is at most |a| (cosh h - 1) off.
  if (size * (Math.cosh((to - from) / 2) - 1) <= tolerance) {
    sink.lineTo(end.x, end.y)
    return
  }
  const pieces = Math.max(1, Math.ceil(Math.abs(to - from) / (2 * halfWidthWithin(tolerance / size))))
  const step = (to - from) / pieces
  // The cubic with the arc's tangents at its ends that also meets it in the middle.
  const handle = (4 / 3) * Math.tanh(step / 4)
  let along = a * Math.cosh(from)
  let across = b * Math.sinh(from)
  for (let piece = 1; piece <= pieces; piece++) {
    const t = piece === pieces ? to : from + piece * step
    const nextAlong = a * Math.cosh(t)
    const nextAcross = b * Math.sinh(t)
    // The derivative of (a cosh t, b sinh t) is (across a / b, along b / a); a is not 0 here.
    const along1 = along + handle * across * (a / b)
    const across1 = across + handle * along * (b / a)
    const along2 = nextAlong - handle * nextAcross * (a / b)
    const across2 = nextAcross - handle * nextAlong * (b / a)
    sink.bezierCurveTo(
      mx + along1 * ux - across1 * uy,
      my + along1 * uy + across1 * ux,
      mx + along2 * ux - across2 * uy,
      my + along2 * uy + across2 * ux,
      piece === pieces ? end.x : mx + nextAlong * ux - nextAcross * uy,
      piece === pieces ? end.y : my + nextAlong * uy + nextAcross * ux,
    )
    along = nextAlong
    across = nextAcross
  }
}

/**
 * The half-width h up to which one cubic stays within `ratio` times |a| of its arc. The cubic's distance is at most
 * 4/27 s^3 / (1 + s) |a| with s = sinh^2(h / 2).
 */
function halfWidthWithin(ratio: number): number {
  return 2 * Math.asinh(Math.sqrt(Math.cbrt((27 / 4) * ratio)))
}
