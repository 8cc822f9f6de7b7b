// SPDX-License-Identifier: GPL-3.0-or-later

import { checkThing } from '../base/check.ts'
import { NONE } from '../base/diagram-data.ts'
import { between, dot } from '../base/point.ts'
import { largestOf, measuredIn, powerOfTwoIn, turn, unitFor } from '../base/scale.ts'
import type { Point, Vector } from '../base/types.ts'
import { controlPoint } from '../curves/bezier.ts'
import { type Bisector, parameterAtRise, pointOf } from '../curves/bisector.ts'
import { type BoundedCurve, type EdgeCurve, isBoundedCurve, seenFrom } from '../curves/curve.ts'
import { type ConvexPolygon, type RegionOptions, regionOf } from './convex-polygon.ts'
import { CIRCLE_OF_RING } from './ring.ts'

/**
 * A part of a curve inside a region, and the sides of the region, or `CIRCLE_OF_RING`, that cut it off, on which its ends
 * lie then; `NONE` where it ends with the curve.
 */
export interface Part {
  readonly curve: BoundedCurve
  readonly cutFrom: number
  readonly cutTo: number
}

/** A range of the parameter, and the sides that cut it off. */
interface Span {
  readonly from: number
  readonly to: number
  readonly cutFrom: number
  readonly cutTo: number
}

/**
 * Returns the pieces of an arc inside a region, in order. Each piece is bounded; there are several if the arc leaves
 * the region and comes back.
 *
 * @throws CircleVoronoiError `badArgument`, `badOption`
 *
 * @category Curves
 * @example
 * clipCurve(edgeCurve(diagram, 0), { bounds: [-5, -5, 10, 10] }).length // 1
 */
export function clipCurve(curve: EdgeCurve, options: RegionOptions): BoundedCurve[] {
  checkThing(curve, 'bisector', 'clipCurve', 'a curve')
  return partsInside(curve, regionOf(options, 'clipCurve')).map((part) => part.curve)
}

/** The parts of a curve inside a region, in order: bounded. */
export function partsInside(whole: EdgeCurve, region: ConvexPolygon): Part[] {
  const curve = seenFrom(whole, region.reachFrom(whole.bisector.origin))
  const parts: Part[] = []
  for (const { from, to, cutFrom, cutTo } of spansInside(curve, region)) {
    const { bisector } = curve
    const start = cutFrom === NONE ? curve.start : onSide(region, cutFrom, pointOf(bisector, from))
    const end = cutTo === NONE ? curve.end : onSide(region, cutTo, pointOf(bisector, to))
    const part = { bisector, from, to, start, end }
    if (isBoundedCurve(part)) parts.push({ curve: part, cutFrom, cutTo })
  }
  return parts
}

/**
 * The part of a curve whose points are up to a distance from the origin of its bisector, the center of the smaller circle:
 * bounded, if there is one. The distance apex + c (cosh t - 1) grows from the apex to both sides: it is from 1 / s to s.
 */
export function partNear(whole: EdgeCurve, reach: number): Part | undefined {
  const curve = seenFrom(whole, reach)
  const { bisector } = curve
  const rise = (reach / bisector.unit - bisector.apex) / (bisector.apex + Math.abs(bisector.a))
  if (!(rise > 0)) return undefined
  const most = parameterAtRise(rise)
  const isCutFrom = curve.from < 1 / most
  const isCutTo = curve.to > most
  const from = isCutFrom ? 1 / most : curve.from
  const to = isCutTo ? most : curve.to
  if (from > to) return undefined
  const start = isCutFrom ? pointOf(bisector, from) : (curve.start as Point)
  const end = isCutTo ? pointOf(bisector, to) : (curve.end as Point)
  return {
    curve: { bisector, from, to, start, end },
    cutFrom: isCutFrom ? CIRCLE_OF_RING : NONE,
    cutTo: isCutTo ? CIRCLE_OF_RING : NONE,
  }
}

function spansInside(curve: EdgeCurve, region: ConvexPolygon): Span[] {
  let spans: Span[] = [{ from: curve.from, to: curve.to, cutFrom: NONE, cutTo: NONE }]
  if (isBoundedCurve(curve)) {
    const place = placeOf(curve, region)
    if (place !== 'cut') return place === 'inside' ? spans : []
  }
  for (let side = 0; side < region.corners.length && spans.length > 0; side++) {
    const from = region.corner(side)
    const crossing = new LineCrossing(curve.bisector, from, between(from, region.cornerAfter(side)))
    const kept: Span[] = []
    for (let rest of spans) {
      for (const s of crossing.parameters) {
        if (s <= rest.from || s >= rest.to) continue
        const { from, to, cutFrom, cutTo } = rest
        if (!crossing.isRight(from, s)) kept.push({ from, to: s, cutFrom, cutTo: side })
        rest = { from: s, to, cutFrom: side, cutTo }
      }
      if (!crossing.isRight(rest.from, rest.to)) kept.push(rest)
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
    const direction = between(corner, region.cornerAfter(side))
    const first = turn(direction, between(corner, start))
    const second = turn(direction, between(corner, control))
    const third = turn(direction, between(corner, end))
    if (first < 0 && second < 0 && third < 0) return 'outside'
    isInside &&= first >= 0 && second >= 0 && third >= 0
  }
  return isInside ? 'inside' : 'cut'
}

function onSide(region: ConvexPolygon, side: number, p: Point): Point {
  const from = region.corner(side)
  const to = region.cornerAfter(side)
  const direction = between(from, to)
  const unit = unitFor(largestOf(direction))
  const along = measuredIn(unit, direction)
  const share = dot(measuredIn(unit, between(from, p)), along) / dot(along, along)
  if (share <= 0) return from
  if (share >= 1) return to
  return { x: from.x + share * direction.x, y: from.y + share * direction.y }
}

/**
 * Where a branch crosses the line through `p` along a direction.
 *
 * With n the normal to the right of the line, n . (point(s) - p) > 0 becomes, multiplied by 2 s,
 * (A + B) s^2 - 2 (A + k) s + (A - B) > 0, where A = -|a| n . along, B = b n . across, k = n . (p - origin - apex along).
 * Only the ratios of A, B and k count.
 */
export class LineCrossing {
  /** The parameters, increasing: none, one or two. */
  readonly parameters: readonly number[]
  readonly #growth: number
  readonly #half: number
  readonly #decay: number

  constructor(bisector: Bisector, p: Point, direction: Vector) {
    // Short, since k is large where the circles are near one another.
    const largest = largestOf(direction)
    const along = measuredIn(largest > 0 ? powerOfTwoIn(largest) : 1, direction)
    const normal = { x: along.y, y: -along.x }
    let a = -Math.abs(bisector.a) * dot(normal, bisector.along)
    let b = bisector.b * dot(normal, bisector.across)
    const toPoint = measuredIn(bisector.unit, between(bisector.origin, p))
    let k = dot(normal, toPoint) - bisector.apex * dot(normal, bisector.along)
    const unit = unitFor(Math.max(Math.abs(a), Math.abs(b), Math.abs(k)))
    a /= unit
    b /= unit
    k /= unit
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
    // The branch may touch the line in one of any two points, but not in both.
    const first = this.#height(parameterBetween(from, middle))
    const second = this.#height(parameterBetween(middle, to))
    return (Math.abs(first) > Math.abs(second) ? first : second) > 0
  }

  #height(s: number): number {
    return this.#growth * s - 2 * this.#half + this.#decay / s
  }
}

function parameterBetween(from: number, to: number): number {
  if (from === 0) return to === Number.POSITIVE_INFINITY ? 1 : to / 2
  return to === Number.POSITIVE_INFINITY ? 2 * from : Math.sqrt(from) * Math.sqrt(to)
}
