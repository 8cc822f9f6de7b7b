// SPDX-License-Identifier: GPL-3.0-or-later

import { checkThing } from '../base/check.ts'
import { NONE } from '../base/diagram-data.ts'
import { between, cross, dot } from '../base/point.ts'
import { largestOf, measuredIn, powerOfTwoIn, turn } from '../base/scale.ts'
import type { Point, Vector } from '../base/types.ts'
import { type Bisector, parameterAtDistance, pointOf } from '../curves/bisector.ts'
import { type BoundedCurve, type EdgeCurve, isBoundedCurve } from '../curves/curve.ts'
import { boundsOf, type ConvexBoundsOptions, type ConvexPolygon } from './convex-polygon.ts'

/** Stands for a side of a polygon: the end lies on the circle that cuts a cell at the maximum distance. */
export const CIRCLE_CUT = -2
/** Stands for a side of a polygon: the end is at infinity, represented by a point far outside. */
const FAR_CUT = -3
/**
 * The distance of ends at infinity, as a multiple of the distance of the bounds from the centers. The directions there
 * differ from the directions at infinity by a few degrees.
 */
const FAR = 64

/**
 * A part of a curve inside bounds. `cutFrom` and `cutTo` are the sides of the bounds on which the ends of the part lie,
 * or `CIRCLE_CUT`. `NONE` means that the part ends at the end of the curve.
 */
export interface Part {
  readonly curve: BoundedCurve
  readonly cutFrom: number
  readonly cutTo: number
}

/** Returns whether cutting has left only a point. */
export function isPoint({ curve: { start, end }, cutFrom, cutTo }: Part): boolean {
  return isSame(start, end) && (cutFrom !== NONE || cutTo !== NONE)
}

export function isSame(p: Point, q: Point): boolean {
  return p.x === q.x && p.y === q.y
}

/** The half-plane left of a side of a polygon. Sides on one line make one half-plane. */
export class HalfPlane {
  /** The first side of the polygon on the line. */
  readonly side: number
  readonly from: Point
  readonly to: Point
  readonly along: Vector

  constructor(side: number, from: Point, to: Point) {
    const direction = between(from, to)
    this.side = side
    this.from = from
    this.to = to
    this.along = measuredIn(powerOfTwoIn(largestOf(direction)), direction)
  }

  /** Returns the half-planes of the sides of a polygon. */
  static of({ corners }: ConvexPolygon): HalfPlane[] {
    const isTurn = (corner: Point, k: number) =>
      turn(between(corners.at(k - 1) as Point, corner), between(corner, corners[(k + 1) % corners.length] as Point)) !==
      0
    const sides = corners.flatMap((corner, k) => (isTurn(corner, k) ? [k] : []))
    const cornerAt = (i: number) => corners[sides[i % sides.length] as number] as Point
    return sides.map((side, i) => new HalfPlane(side, cornerAt(i), cornerAt(i + 1)))
  }

  /**
   * Returns how far a point is to the left of the line, in a unit of the line. It is negative outside, and exact for
   * points on a line parallel to an axis.
   */
  height(p: Point): number {
    return cross(this.along, between(this.from, p))
  }

  /** Returns how far ahead along the line a point is, in the same unit. */
  place(p: Point): number {
    return dot(this.along, between(this.from, p))
  }

  /** Returns the point of the line nearest to `p`. */
  nearest(p: Point): Point {
    const { from, along } = this
    const share = this.place(p) / dot(along, along)
    return { x: from.x + share * along.x, y: from.y + share * along.y }
  }

  /** Returns a point of the line, moved onto the side. */
  onSide(p: Point): Point {
    const ahead = this.place(p)
    return ahead <= 0 ? this.from : ahead >= this.place(this.to) ? this.to : p
  }
}

/**
 * Returns the pieces of an arc inside bounds, in order. Each piece is bounded; there are several if the arc leaves
 * the bounds and comes back.
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
  return partsInside(boundedPart(curve, bounds), bounds).map((part) => part.curve)
}

/** Returns a curve whose ends at infinity are moved to points far outside the bounds, where clipping removes them. */
export function boundedPart(whole: EdgeCurve, bounds: ConvexPolygon): Part {
  const reach = Math.max(bounds.reachFrom(whole.bisector.left), bounds.reachFrom(whole.bisector.right))
  if (isBoundedCurve(whole)) return { curve: whole, cutFrom: NONE, cutTo: NONE }
  const { bisector } = whole
  const most = parameterAtDistance(bisector, FAR * Math.max(reach, Math.abs(bisector.apex)))
  let { from, to, start, end } = whole
  if (start === undefined) {
    from = Math.min(1 / most, to)
    start = from === to ? (end as Point) : pointOf(bisector, from)
  }
  if (end === undefined) {
    to = Math.max(most, from)
    end = from === to ? start : pointOf(bisector, to)
  }
  return {
    curve: { bisector, from, to, start, end },
    cutFrom: whole.start === undefined ? FAR_CUT : NONE,
    cutTo: whole.end === undefined ? FAR_CUT : NONE,
  }
}

/**
 * Cuts a bounded part of a curve. Returns the parts in the half-plane, in order.
 *
 * The shared end points of pieces decide which ends are inside. A root only determines the place of a crossing, and is
 * moved back if it lies beyond an end. So rounding moves an end as little as it moves the line, and the pieces of a
 * loop stay linked.
 */
export function cutPart(part: Part, half: HalfPlane): readonly Part[] {
  const { bisector, from, to, start, end } = part.curve
  const first = half.height(start)
  const last = half.height(end)
  const hasStart = first >= 0
  const hasEnd = last >= 0
  const whole = hasStart ? [part] : []
  // A straight line crosses once.
  if (bisector.a === 0 && hasStart === hasEnd) return whole
  const line = new LineCrossing(bisector, half.from, half.along)
  const endAt = ({ curve, ...rest }: Part, s: number): Part => {
    const p = s === from && hasStart ? start : half.nearest(pointOf(bisector, s))
    return { ...rest, curve: { bisector, from: curve.from, to: s, start: curve.start, end: p }, cutTo: half.side }
  }
  const startAt = ({ curve, ...rest }: Part, s: number): Part => {
    const p = s === to && hasEnd ? end : half.nearest(pointOf(bisector, s))
    return { ...rest, curve: { bisector, from: s, to: curve.to, start: p, end: curve.end }, cutFrom: half.side }
  }
  if (hasStart !== hasEnd) {
    const s = line.crossing(hasStart)
    const crossing = s !== undefined ? Math.min(Math.max(s, from), to) : Math.abs(first) < Math.abs(last) ? from : to
    return [hasStart ? endAt(part, crossing) : startAt(part, crossing)]
  }
  const turning = line.turningPoint(hasStart)
  if (turning === undefined || !(from < turning && turning < to)) return whole
  const early = Math.max(line.parameters[0] as number, from)
  const late = Math.min(line.parameters[1] as number, to)
  return hasStart ? [endAt(part, early), startAt(part, late)] : [endAt(startAt(part, early), late)]
}

/** Moves the cut ends of a part onto the sides that cut them, because rounding may have left them beyond a corner. */
export function movedOntoSides(part: Part, halves: readonly HalfPlane[]): Part {
  const { curve, cutFrom, cutTo } = part
  if (cutFrom === NONE && cutTo === NONE) return part
  const moved = (cut: number, p: Point) => halves.find(({ side }) => side === cut)?.onSide(p) ?? p
  const { bisector, from, to } = curve
  return { ...part, curve: { bisector, from, to, start: moved(cutFrom, curve.start), end: moved(cutTo, curve.end) } }
}

/** Returns the parts of a curve's part inside the bounds, in order. */
export function partsInside(part: Part, bounds: ConvexPolygon): Part[] {
  const halves = HalfPlane.of(bounds)
  let parts = [part]
  for (const half of halves) {
    parts = parts.flatMap((rest) => cutPart(rest, half)).filter((rest) => !isPoint(rest))
  }
  return parts.map((rest) => movedOntoSides(rest, halves)).filter((rest) => !isPoint(rest))
}

/**
 * Returns the bounded part of a curve whose points are at most `reach` from the center of the smaller circle;
 * `undefined` if no point is. The distance grows from the apex to both sides, so the part is from 1 / s to s.
 */
export function partNear(curve: EdgeCurve, reach: number): Part | undefined {
  const { bisector } = curve
  if (!(reach > bisector.apex)) return undefined
  const most = parameterAtDistance(bisector, reach)
  const isCutFrom = curve.from < 1 / most
  const isCutTo = curve.to > most
  const from = isCutFrom ? 1 / most : curve.from
  const to = isCutTo ? most : curve.to
  if (from > to) return undefined
  const start = isCutFrom ? pointOf(bisector, from) : (curve.start as Point)
  const end = isCutTo ? pointOf(bisector, to) : (curve.end as Point)
  return {
    curve: { bisector, from, to, start, end },
    cutFrom: isCutFrom ? CIRCLE_CUT : NONE,
    cutTo: isCutTo ? CIRCLE_CUT : NONE,
  }
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
  readonly #growth: number
  readonly #decay: number

  constructor(bisector: Bisector, p: Point, direction: Vector) {
    const normal = { x: direction.y, y: -direction.x }
    const a = -Math.abs(bisector.a) * dot(normal, bisector.along)
    const b = bisector.b * dot(normal, bisector.across)
    const k = dot(normal, between(bisector.origin, p)) - bisector.apex * dot(normal, bisector.along)
    const half = a + k
    this.#growth = a + b
    this.#decay = a - b
    const discriminant = k * (k + 2 * a) + b * b
    const root = Math.sqrt(discriminant)
    const sum = half < 0 ? half - root : half + root
    const crossings = [
      { s: sum / this.#growth, goesRight: this.#growth > 0 },
      { s: this.#decay / sum, goesRight: this.#decay < 0 },
    ].filter(({ s }) => discriminant > 0 && s > 0 && s < Number.POSITIVE_INFINITY)
    this.#crossings = crossings.sort((one, other) => one.s - other.s)
    this.parameters = this.#crossings.map(({ s }) => s)
  }

  /** Returns the parameter where the branch crosses from the left of the line to the right, or from right to left. */
  crossing(toRight: boolean): number | undefined {
    return this.#crossings.find(({ goesRight }) => goesRight === toRight)?.s
  }

  /**
   * Returns the parameter between two crossings where the branch is farthest to the right of the line, or to the left.
   * Returns `undefined` without two crossings, or if the branch is on the other side between them.
   */
  turningPoint(right: boolean): number | undefined {
    if (this.parameters.length < 2 || this.#growth < 0 !== right) return undefined
    return Math.sqrt(this.#decay / this.#growth)
  }
}
