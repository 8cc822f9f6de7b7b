// SPDX-License-Identifier: GPL-3.0-or-later
import { at, circleOf, NONE } from '../base/diagram-data.ts'
import { CircleVoronoiError } from '../base/errors.ts'
import { compareSurds, signOf, signOfSum, wholeOf } from '../base/exact.ts'
import { cross, length } from '../base/point.ts'
import { lengthOf } from '../base/scale.ts'
import type { Point, Vector } from '../base/types.ts'
import { parameterAtDistance, pointOf } from '../curves/bisector.ts'
import { curveOf, type EdgeCurve } from '../curves/curve.ts'
import {
  BisectorBorder,
  type BorderCurve,
  RimBorder,
  type WholeNeighbor,
  wholeNeighbor,
  wholeWeightOf,
} from './border-curve.ts'
import { BorderEnd, type ExactPoint } from './border-end.ts'
import { type Limits, reachFrom } from './cell-limits.ts'
import type { Cells } from './cells.ts'
import { isSame } from './clip.ts'
import { ClipLine } from './clip-line.ts'
import { CutPoint } from './cut-point.ts'
import { errorOfVertex } from './measure.ts'
import { ROUNDING_OF_SIGNS, signBeyond } from './sign-filter.ts'

/** A piece of the border of a cell, or of its part within the maximum distance, counter-clockwise. */
export interface BorderPiece {
  readonly line: BorderCurve
  /** The start; `undefined` at infinity. */
  readonly from: BorderEnd | undefined
  /** The end; `undefined` at infinity. */
  readonly to: BorderEnd | undefined
  /** The side of the cell that the piece is a part of, or `NONE` for an arc of the circle. */
  readonly side: number
  /** The curve of the part in the direction of its edge; `undefined` for an arc of the circle. */
  readonly forward: EdgeCurve | undefined
}

/** A part of a side of a cell. */
export interface SidePiece extends BorderPiece {
  readonly line: BisectorBorder
  readonly forward: EdgeCurve
  /** Whether the circle of the maximum distance cuts off the start or the end. */
  readonly isCutFrom: boolean
  readonly isCutTo: boolean
}

/** The diagram's arrays were changed. @throws CircleVoronoiError `notCertified` */
export function refuseOutline(circle: number): never {
  throw new CircleVoronoiError('notCertified', `The outline of cell ${circle} does not close.`, { circle })
}

const AXES: readonly Vector[] = [
  { x: 1, y: 0 },
  { x: 0, y: 1 },
  { x: -1, y: 0 },
  { x: 0, y: -1 },
]

const ORIGIN: Point = { x: 0, y: 0 }
/** The error bound of the number of a vertex of a power diagram, as a share of it. */
const ROUNDING_OF_POWERS = 2 ** -35

/** The line of a bisector as seen from the center: u . x with the way u to the neighbor, and the chord of the circle. */
interface Chord {
  readonly along: number
  readonly alongError: number
  /** The squared length of the chord times u . u; negative if the line does not meet the circle. */
  readonly rest: number
  readonly restError: number
}

/**
 * The border of a cell within the maximum distance. Exact signs decide which ends of its sides are within: a vertex at
 * that distance is. The bounds play no part here.
 */
export class CellBorder {
  readonly center: Point
  readonly #cells: Cells
  readonly #circle: number
  readonly #maxDistance: number | undefined
  readonly #radius: number
  /** 0 for the metric `power`, where only the square is known exactly. */
  readonly #wholeRadius: bigint
  readonly #wholeSquare: bigint
  readonly #ends = new Map<number, BorderEnd>()

  constructor(cells: Cells, circle: number, { maxDistance }: Limits) {
    const { diagram } = cells
    const { x, y, r } = circleOf(diagram.circles, circle)
    this.center = { x, y }
    this.#cells = cells
    this.#circle = circle
    this.#maxDistance = maxDistance
    this.#radius = reachFrom(diagram, circle, maxDistance ?? 0)
    const most = wholeOf(maxDistance ?? 0)
    const isPower = diagram.metric === 'power'
    this.#wholeRadius = isPower ? 0n : most + (diagram.metric === 'circles' ? wholeOf(r) : 0n)
    this.#wholeSquare = isPower
      ? wholeWeightOf(diagram, circle) + (most < 0n ? -most : most) * most
      : this.#wholeRadius ** 2n
  }

  /**
   * Returns the pieces, in order. Where one does not start at the end of the one before it, infinity is between. Returns
   * `undefined` if nothing of the cell is within the maximum distance.
   */
  pieces(): BorderPiece[] | undefined {
    const parts: SidePiece[] = []
    for (const side of this.#cells.sides(this.#circle)) {
      const part = this.partOf(side)
      if (part !== undefined) parts.push(part)
    }
    if (this.#maxDistance === undefined) return parts
    const pieces: BorderPiece[] = []
    if (parts.length === 0) {
      if (!this.#hasCenter()) return undefined
      const axis = this.#axisEnd(0)
      this.#addRim(pieces, axis, axis, 0, AXES.length - 1)
    }
    parts.forEach((part, k) => {
      pieces.push(part)
      const next = parts[(k + 1) % parts.length] as SidePiece
      if (part.isCutTo || next.isCutFrom) this.#addGap(pieces, part.to as BorderEnd, next.from as BorderEnd)
    })
    return pieces
  }

  /** Returns the part of a side of the cell within the maximum distance; `undefined` if there is none. */
  partOf(side: number): SidePiece | undefined {
    const { diagram } = this.#cells
    const line = new BisectorBorder(diagram, this.#circle, this.#cells.neighborOf(side))
    const origin = this.#cells.originOf(side)
    const target = this.#cells.targetOf(side)
    const start = origin === NONE ? undefined : this.#vertexEnd(origin)
    const end = target === NONE ? undefined : this.#vertexEnd(target)
    const forward = curveOf(diagram, side >> 1)
    const whole = { line, from: start, to: end, side, forward, isCutFrom: false, isCutTo: false }
    if (this.#maxDistance === undefined) return whole
    const hasStart = start !== undefined && this.#isWithin(origin, start)
    const hasEnd = end !== undefined && this.#isWithin(target, end)
    if (hasStart && hasEnd) return whole
    // The distance grows from the apex to both sides.
    const isApexWithin = () => this.#isApexWithin(line, this.#cells.neighborOf(side))
    if (!hasStart && !hasEnd && !(this.#hasApexBetween(line, start, end) && isApexWithin())) return undefined
    const cut = this.#cutCurve(forward, side, !hasStart, !hasEnd)
    const isBackward = side % 2 === 1
    return {
      ...whole,
      forward: cut,
      isCutFrom: !hasStart,
      isCutTo: !hasEnd,
      from: hasStart ? start : this.#cutEnd(line, (isBackward ? cut.end : cut.start) as Point, -1),
      to: hasEnd ? end : this.#cutEnd(line, (isBackward ? cut.start : cut.end) as Point, 1),
    }
  }

  /** Returns the curve of an edge between the points where the circle cuts off its ends. */
  #cutCurve(whole: EdgeCurve, side: number, isCutFrom: boolean, isCutTo: boolean): EdgeCurve {
    const { diagram } = this.#cells
    const { bisector } = whole
    const reachOf = (i: number) => reachFrom(diagram, i, this.#maxDistance as number)
    const reach = reachOf(this.#cells.circleOf(isSame(bisector.origin, bisector.left) ? side & ~1 : side | 1))
    const most = parameterAtDistance(bisector, Math.max(reach, Math.abs(bisector.apex)))
    const clamped = (s: number) => Math.min(Math.max(s, whole.from), whole.to)
    const cutAt = (s: number) => CutPoint.after(bisector.origin, pointOf({ ...bisector, origin: ORIGIN }, s))
    let { from, to, start, end } = whole
    const isForward = side % 2 === 0
    if (isForward ? isCutFrom : isCutTo) {
      from = clamped(1 / most)
      start = cutAt(from)
    }
    if (isForward ? isCutTo : isCutFrom) {
      to = clamped(most)
      end = cutAt(to)
    }
    if (from > to) from = to = Math.sqrt(from) * Math.sqrt(to)
    return { bisector, from, to, start, end }
  }

  #vertexEnd(vertex: number): BorderEnd {
    const known = this.#ends.get(vertex)
    if (known !== undefined) return known
    const { diagram } = this.#cells
    const point = { x: at(diagram.vertices, 3 * vertex), y: at(diagram.vertices, 3 * vertex + 1) }
    const seen = { x: point.x - this.center.x, y: point.y - this.center.y }
    const end = new BorderEnd(point, seen, errorOfVertex(diagram, vertex), () => this.#exactVertex(vertex))
    this.#ends.set(vertex, end)
    return end
  }

  #isWithin(vertex: number, end: BorderEnd): boolean {
    const { diagram } = this.#cells
    const r = at(diagram.vertices, 3 * vertex + 2)
    const most = this.#maxDistance as number
    const rounding = diagram.metric === 'power' ? ROUNDING_OF_POWERS : ROUNDING_OF_SIGNS
    const sign = signBeyond(most - r, end.error + rounding * (Math.abs(r) + Math.abs(most)))
    if (sign !== 0) return sign > 0
    const { x, y, w, w1, rho } = end.exact
    const radius = this.#wholeRadius
    if (radius < 0n) return false
    if (rho === undefined) return x * x + y * y <= this.#wholeSquare * w * w
    return signOfSum(radius * w - rho, radius * w1, end.exact.d) >= 0
  }

  /** Returns the vertex of the circle and two others, seen from the circle (shifted_signs.cpp). */
  #exactVertex(vertex: number): ExactPoint {
    const { diagram } = this.#cells
    const corners = diagram.vertexCircles.subarray(3 * vertex, 3 * vertex + 3)
    const own = corners.indexOf(this.#circle)
    if (own === -1) refuseOutline(this.#circle)
    const seen = (k: number) => wholeNeighbor(diagram, this.#circle, at(corners, (own + k) % 3))
    return diagram.metric === 'circles' ? curvedVertex(seen(1), seen(2)) : straightVertex(seen(1), seen(2))
  }

  /**
   * Returns how the line of a bisector lies to the circle. With u the way to the neighbor, s the difference of the radii,
   * w that of the weights and R the radius of the circle, 2 u . x = u . u - s^2 - 2 R s + w.
   */
  #chordOf({ x, y, s, weight, weightSize }: BisectorBorder): Chord {
    const radius = this.#radius
    const square = x * x + y * y
    const along = square - s * s - 2 * radius * s + weight
    const alongError = ROUNDING_OF_SIGNS * (square + s * s + 2 * Math.abs(radius * s) + weightSize)
    const rest = 4 * radius * radius * square - along * along
    const size = Math.abs(along) + alongError / ROUNDING_OF_SIGNS
    const restError = 8 * ROUNDING_OF_SIGNS * (4 * radius * radius * square + size * size)
    return { along, alongError, rest, restError }
  }

  #wholeChordOf({ whole: u }: BisectorBorder): { square: bigint; along: bigint; rest: bigint } {
    const square = u.x * u.x + u.y * u.y
    const along = square - u.s * u.s - 2n * this.#wholeRadius * u.s + u.weight
    return { square, along, rest: 4n * this.#wholeSquare * square - along * along }
  }

  /**
   * Returns an end where the circle cuts the bisector to a neighbor, counter-clockwise from the direction to the
   * neighbor (turn 1) or clockwise from it (-1).
   */
  #cutEnd(line: BisectorBorder, point: Point, turn: number): BorderEnd {
    const { x, y } = line
    const square = x * x + y * y
    const { along, alongError, rest, restError } = this.#chordOf(line)
    const root = Math.sqrt(Math.max(rest, 0))
    const rootError = rest > restError ? restError / root : 2 * Math.sqrt(restError)
    const seen = {
      x: (along * x - turn * root * y) / (2 * square),
      y: (along * y + turn * root * x) / (2 * square),
    }
    const error = (alongError + rootError) / Math.sqrt(square) + 4 * ROUNDING_OF_SIGNS * length(seen)
    return new BorderEnd(point, seen, error, () => {
      const { x, y } = line.whole
      const { square, along, rest } = this.#wholeChordOf(line)
      const sign = BigInt(turn)
      return { x: along * x, x1: -sign * y, y: along * y, y1: sign * x, w: 2n * square, w1: 0n, d: rest }
    })
  }

  #hasApexBetween(line: BisectorBorder, start: BorderEnd | undefined, end: BorderEnd | undefined): boolean {
    const turnTo = (p: BorderEnd) => {
      const error = (Math.abs(line.x) + Math.abs(line.y)) * (p.error + ROUNDING_OF_SIGNS * lengthOf(p))
      return signBeyond(cross(line, p), error) || p.signOf(-line.whole.y, line.whole.x, 0n)
    }
    return (start === undefined || turnTo(start) < 0) && (end === undefined || turnTo(end) > 0)
  }

  /** Whether the apex of the bisector to a neighbor is within: whether both discs are not empty and overlap. */
  #isApexWithin(line: BisectorBorder, neighbor: number): boolean {
    if (!(this.#radius > 0 && reachFrom(this.#cells.diagram, neighbor, this.#maxDistance as number) > 0)) return false
    const { rest, restError } = this.#chordOf(line)
    return (signBeyond(rest, restError) || signOf(this.#wholeChordOf(line).rest)) > 0
  }

  /** Whether the cell contains the center of its circle. Only cells of the metric `power` may not. */
  #hasCenter(): boolean {
    const { diagram } = this.#cells
    const { center } = this
    const place = new ClipLine(0, center, center, center)
    return [...this.#cells.neighbors(this.#circle)].every(
      (neighbor) => new BisectorBorder(diagram, this.#circle, neighbor).sideOf(place) > 0,
    )
  }

  #axisEnd(k: number): BorderEnd {
    const { x, y } = AXES[k % AXES.length] as Vector
    const seen = { x: this.#radius * x, y: this.#radius * y }
    return new BorderEnd(CutPoint.after(this.center, seen), seen, ROUNDING_OF_SIGNS * this.#radius, () => ({
      x: 0n,
      x1: BigInt(x),
      y: 0n,
      y1: BigInt(y),
      w: 1n,
      w1: 0n,
      d: this.#wholeSquare,
    }))
  }

  /** Adds the arc of the circle from one cut to the next one, counter-clockwise. */
  #addGap(pieces: BorderPiece[], from: BorderEnd, to: BorderEnd): void {
    const quarter = quarterOf(from)
    const last = quarterOf(to)
    const count = (last - quarter + AXES.length) % AXES.length
    this.#addRim(pieces, from, to, quarter, count === 0 && isBefore(to, from, quarter) ? AXES.length : count)
  }

  /** Adds an arc in parts of at most a quarter turn: it passes `axes` axes and starts in the given quarter. */
  #addRim(pieces: BorderPiece[], from: BorderEnd, to: BorderEnd, quarter: number, axes: number): void {
    let last = from
    for (let k = 0; k <= axes; k++) {
      const isLast = k === axes
      const next = isLast ? to : this.#axisEnd(quarter + k + 1)
      const line = new RimBorder(this.#radius, this.#wholeSquare, (quarter + k) % AXES.length)
      pieces.push({ line, from: last, to: next, side: NONE, forward: undefined })
      last = next
    }
  }
}

/** Returns the quarter of the circle that an end lies in. A quarter includes its first axis only. */
function quarterOf(end: BorderEnd): number {
  const x = signBeyond(end.x, end.error) || end.signOf(1n, 0n, 0n)
  const y = signBeyond(end.y, end.error) || end.signOf(0n, 1n, 0n)
  if (y >= 0) return x > 0 ? 0 : y > 0 ? 1 : 2
  return x < 0 ? 2 : 3
}

/** Returns whether an end lies before another in the same quarter of the circle. */
function isBefore(end: BorderEnd, other: BorderEnd, quarter: number): boolean {
  const axis = AXES[quarter] as Vector
  const sign = signBeyond(cross(axis, other) - cross(axis, end), end.error + other.error)
  if (sign !== 0) return sign > 0
  const place = (p: BorderEnd) => p.valueOf(BigInt(-axis.y), BigInt(axis.x))
  return compareSurds(place(end), place(other)) < 0
}

/**
 * Returns the vertex of a circle o and two circles u and v, seen from o. The unit vector e to the vertex satisfies e . D +
 * D_s = 0, where D = g_v u - g_u v in (x, y, s) space, and g = x^2 + y^2 - s^2.
 */
function curvedVertex(u: WholeNeighbor, v: WholeNeighbor): ExactPoint {
  const cone = (x: bigint, y: bigint, s: bigint) => x * x + y * y - s * s
  const gu = cone(u.x, u.y, u.s)
  const gv = cone(v.x, v.y, v.s)
  const x = gv * u.x - gu * v.x
  const y = gv * u.y - gu * v.y
  const s = gv * u.s - gu * v.s
  const nx = u.y * v.s - u.s * v.y
  const ny = u.s * v.x - u.x * v.s
  const ns = u.x * v.y - u.y * v.x
  return {
    x: -s * x,
    x1: -y,
    y: -s * y,
    y1: x,
    w: 2n * (nx * y - ny * x),
    w1: 2n * ns,
    d: gu * gv * cone(u.x - v.x, u.y - v.y, u.s - v.s),
    rho: x * x + y * y,
  }
}

/** Returns the vertex of the centers of three circles, or of their weights, seen from the first one. */
function straightVertex(u: WholeNeighbor, v: WholeNeighbor): ExactPoint {
  const ku = u.x * u.x + u.y * u.y + u.weight
  const kv = v.x * v.x + v.y * v.y + v.weight
  const w = 2n * (u.x * v.y - u.y * v.x)
  const sign = w < 0n ? -1n : 1n
  const x = sign * (ku * v.y - kv * u.y)
  const y = sign * (kv * u.x - ku * v.x)
  return { x, x1: 0n, y, y1: 0n, w: sign * w, w1: 0n, d: 0n }
}
