// SPDX-License-Identifier: GPL-3.0-or-later
import { controlPoint } from './bezier.ts'
import { type Bisector, pointAt } from './bisector.ts'
import { type Bounds, ConvexPolygon } from './convex-polygon.ts'
import { type BoundedCurve, type EdgeCurve, isBounded } from './curve.ts'
import { NONE } from './diagram-data.ts'
import { between, dot, type Point, type Vector } from './point.ts'

/**
 * A range of the parameter of a curve inside a region, and the sides of the region that cut it off there; `NONE` where it
 * ends with the curve.
 */
export interface Span {
  readonly from: number
  readonly to: number
  readonly cutFrom: number
  readonly cutTo: number
}

/** The pieces of an arc inside a region, in order: bounded, and several if the arc leaves the region and comes back. */
export function clip(curve: EdgeCurve, bounds: Bounds): BoundedCurve[] {
  const region = ConvexPolygon.of(bounds)
  return clipSpans(curve, region)
    .map((span) => part(curve, span, region))
    .filter(isBounded)
}

/** The parts of a curve inside a region, in order. A part that is not cut reaches the end of the curve. */
export function clipSpans(curve: EdgeCurve, region: ConvexPolygon): Span[] {
  let spans: Span[] = [{ from: curve.from, to: curve.to, cutFrom: NONE, cutTo: NONE }]
  if (isBounded(curve)) {
    const place = placeOf(curve, region)
    if (place !== 'cut') return place === 'inside' ? spans : []
  }
  for (let side = 0; side < region.corners.length && spans.length > 0; side++) {
    const from = region.corner(side)
    const crossing = new LineCrossing(curve.bisector, from, between(from, region.cornerAfter(side)))
    const kept: Span[] = []
    const keep = (span: Span) => {
      if (!crossing.isRight(span.from, span.to)) kept.push(span)
    }
    for (let rest of spans) {
      for (const s of crossing.parameters) {
        if (s <= rest.from || s >= rest.to) continue
        keep({ ...rest, to: s, cutTo: side })
        rest = { ...rest, from: s, cutFrom: side }
      }
      keep(rest)
    }
    spans = kept
  }
  return spans
}

/** Spares the work for most arcs: an arc lies in the triangle of its Bezier points. */
function placeOf(
  { bisector, from, to, start, end }: BoundedCurve,
  region: ConvexPolygon,
): 'inside' | 'outside' | 'cut' {
  const control = controlPoint(bisector, from, to)
  let isInside = true
  for (let side = 0; side < region.corners.length; side++) {
    const corner = region.corner(side)
    const { x: dx, y: dy } = between(corner, region.cornerAfter(side))
    const first = dx * (start.y - corner.y) - dy * (start.x - corner.x)
    const second = dx * (control.y - corner.y) - dy * (control.x - corner.x)
    const third = dx * (end.y - corner.y) - dy * (end.x - corner.x)
    if (first < 0 && second < 0 && third < 0) return 'outside'
    isInside &&= first >= 0 && second >= 0 && third >= 0
  }
  return isInside ? 'inside' : 'cut'
}

/** That part of the curve; where it is cut, its ends lie on the side of the region. */
export function part(curve: EdgeCurve, { from, to, cutFrom, cutTo }: Span, region: ConvexPolygon): EdgeCurve {
  if (cutFrom === NONE && cutTo === NONE) return curve
  const { bisector } = curve
  return {
    bisector,
    from,
    to,
    start: cutFrom === NONE ? curve.start : onSide(region, cutFrom, pointAt(bisector, from)),
    end: cutTo === NONE ? curve.end : onSide(region, cutTo, pointAt(bisector, to)),
  }
}

function onSide(region: ConvexPolygon, side: number, p: Point): Point {
  const from = region.corner(side)
  const to = region.cornerAfter(side)
  const direction = between(from, to)
  const share = dot(between(from, p), direction) / dot(direction, direction)
  if (share <= 0) return from
  if (share >= 1) return to
  return { x: from.x + share * direction.x, y: from.y + share * direction.y }
}

/**
 * Where a branch crosses the line through `p` along a direction.
 *
 * With n the normal to the right of the line, n . (point(s) - p) > 0 becomes, multiplied by 2 s,
 * (A + B) s^2 - 2 (A + k) s + (A - B) > 0, where A = -|a| n . along, B = b n . across, k = n . (p - origin - apex along).
 */
export class LineCrossing {
  /** The parameters, increasing: none, one or two. */
  readonly parameters: readonly number[]
  readonly #growth: number
  readonly #half: number
  readonly #decay: number

  constructor(bisector: Bisector, p: Point, direction: Vector) {
    const normal = { x: direction.y, y: -direction.x }
    const a = -Math.abs(bisector.a) * dot(normal, bisector.along)
    const b = bisector.b * dot(normal, bisector.across)
    const k = dot(normal, between(bisector.origin, p)) - bisector.apex * dot(normal, bisector.along)
    this.#growth = a + b
    this.#half = a + k
    this.#decay = a - b
    const discriminant = k * (k + 2 * a) + b * b
    const root = Math.sqrt(discriminant)
    const sum = this.#half < 0 ? this.#half - root : this.#half + root
    this.parameters =
      discriminant > 0
        ? [sum / this.#growth, this.#decay / sum]
            .filter((s) => s > 0 && s < Number.POSITIVE_INFINITY)
            .sort((one, other) => one - other)
        : []
  }

  /**
   * Whether the branch is to the right of the line between two parameters; ends at infinity are 0 and infinity.
   * Precondition: it does not cross the line between them.
   */
  isRight(from: number, to: number): boolean {
    const middle = parameterBetween(from, to)
    const height = (s: number) => this.#growth * s - 2 * this.#half + this.#decay / s
    // The branch may touch the line in one of any two points, but not in both.
    const first = height(parameterBetween(from, middle))
    const second = height(parameterBetween(middle, to))
    return (Math.abs(first) > Math.abs(second) ? first : second) > 0
  }
}

function parameterBetween(from: number, to: number): number {
  if (from === 0) return to === Number.POSITIVE_INFINITY ? 1 : to / 2
  return to === Number.POSITIVE_INFINITY ? 2 * from : Math.sqrt(from) * Math.sqrt(to)
}
