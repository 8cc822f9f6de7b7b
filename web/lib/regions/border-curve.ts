// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../base/diagram-data.ts'
import { type Surd, signOf, signOfSum, surd, wholeOf, wholeSquareOf } from '../base/exact.ts'
import { cross, dot, length } from '../base/point.ts'
import type { DiagramData, Vector } from '../base/types.ts'
import type { BorderEnd } from './border-end.ts'
import type { ClipLine, WholeVector } from './clip-line.ts'
import { ROUNDING_OF_SIGNS, signBeyond, TIE } from './sign-filter.ts'

/**
 * A curve that a piece of the border of a cell lies on, seen from the center of the cell's circle. It has a convex inner
 * side, so a line crosses it at most twice.
 *
 * Signs that involve the bounds are those of bounds moved by (e, f), where e is positive but smaller than any number
 * and f is positive but smaller than any power of e. So no corner lies on the curve, and no line touches it. Each sign
 * is found in doubles with an error bound, else in integers, and where the value is 0, its derivatives decide. The signs
 * are those of shifted_signs.h in C++.
 */
export interface BorderCurve {
  /** Whether the curve is a line. The methods below, except `sideOf` and `shareOf`, are not for lines. */
  readonly isStraight: boolean
  /** Whether the cell is on the inner side. */
  readonly isCellInside: boolean
  /** A direction such that its cross product with the points of a piece grows along the border. */
  readonly direction: WholeVector
  /** Returns 1 if the start of a line lies on the cell's side, else -1, times `TIE` if the shift decides. */
  sideOf(corner: ClipLine): number
  /**
   * Returns on which side of a line the curve lies between two crossings: 1 for left, -1 for right, 0 if it is not
   * crossed twice.
   */
  bulgeBeyond(line: ClipLine): number
  /** Returns whether the middle between the two crossings of a line is ahead of the start of another line on it. */
  isAheadOf(corner: ClipLine, line: ClipLine): boolean
  /** Returns 1 if the middle between the two crossings of a line is ahead of a point of the curve, -1 if behind. */
  turnAfter(end: BorderEnd, line: ClipLine): number
  /**
   * Returns the place where a line leaves the cell across the curve, or enters it, as a share of the way to its end.
   */
  shareOf(line: ClipLine, isExit: boolean): Surd
}

function wholeCross(u: WholeVector, v: WholeVector): bigint {
  return u.x * v.y - u.y * v.x
}

function wholeDot(u: WholeVector, v: WholeVector): bigint {
  return u.x * v.x + u.y * v.y
}

function sizeOf({ x, y }: Vector): number {
  return Math.abs(x) + Math.abs(y)
}

/** Returns twice the way from a point of the plane to the middle between the center and a point. */
function twiceToMiddle(point: WholeVector, from: WholeVector): WholeVector {
  return { x: point.x - 2n * from.x, y: point.y - 2n * from.y }
}

/** The weight of a circle in a diagram of straight edges, rounded. */
function weightOf({ circles, metric, weights }: DiagramData, circle: number): number {
  if (metric !== 'power') return 0
  const r = at(circles, 3 * circle + 2)
  return weights ? r : r ** 2
}

/** Returns the weight exactly, in units of the squared coordinate step. */
export function wholeWeightOf({ circles, metric, weights }: DiagramData, circle: number): bigint {
  if (metric !== 'power') return 0n
  const r = at(circles, 3 * circle + 2)
  return weights ? wholeSquareOf(r) : wholeOf(r) ** 2n
}

/** Exact numbers of a neighbor, seen from the circle. */
export interface WholeNeighbor extends WholeVector {
  /** The difference of the radii, for diagrams of circles. */
  readonly s: bigint
  /** The circle's weight minus that of the neighbor, for diagrams of straight edges. */
  readonly weight: bigint
}

/** Returns the exact numbers of a circle as seen from another. */
export function wholeNeighbor(diagram: DiagramData, circle: number, neighbor: number): WholeNeighbor {
  const { circles, metric } = diagram
  const number = (k: number, i: number) => wholeOf(at(circles, 3 * i + k))
  return {
    x: number(0, neighbor) - number(0, circle),
    y: number(1, neighbor) - number(1, circle),
    s: metric === 'circles' ? number(2, neighbor) - number(2, circle) : 0n,
    weight: wholeWeightOf(diagram, circle) - wholeWeightOf(diagram, neighbor),
  }
}

/** The bisector of a circle and a neighbor. */
export class BisectorBorder implements BorderCurve {
  readonly isStraight: boolean
  readonly isCellInside: boolean
  /** The way to the neighbor's center. */
  readonly x: number
  readonly y: number
  /** The neighbor's radius minus the circle's. */
  readonly s: number
  /** The circle's weight minus that of the neighbor, for the metric `power`, and the size of both. */
  readonly weight: number
  readonly weightSize: number
  readonly #diagram: DiagramData
  readonly #circle: number
  readonly #neighbor: number
  #whole: WholeNeighbor | undefined

  constructor(diagram: DiagramData, circle: number, neighbor: number) {
    const { circles, metric } = diagram
    this.#diagram = diagram
    this.#circle = circle
    this.#neighbor = neighbor
    this.x = at(circles, 3 * neighbor) - at(circles, 3 * circle)
    this.y = at(circles, 3 * neighbor + 1) - at(circles, 3 * circle + 1)
    this.s = metric === 'circles' ? at(circles, 3 * neighbor + 2) - at(circles, 3 * circle + 2) : 0
    this.weight = weightOf(diagram, circle) - weightOf(diagram, neighbor)
    this.weightSize = Math.abs(weightOf(diagram, circle)) + Math.abs(weightOf(diagram, neighbor))
    this.isStraight = this.s === 0
    this.isCellInside = this.s > 0
  }

  get whole(): WholeNeighbor {
    this.#whole ??= wholeNeighbor(this.#diagram, this.#circle, this.#neighbor)
    return this.#whole
  }

  get direction(): WholeVector {
    return this.whole
  }

  /** Returns the way from the start of a line to the neighbor's center. */
  #toNeighbor({ from }: ClipLine): Vector {
    const { circles } = this.#diagram
    return { x: at(circles, 3 * this.#neighbor) - from.x, y: at(circles, 3 * this.#neighbor + 1) - from.y }
  }

  sideOf(corner: ClipLine): number {
    if (this.#diagram.metric !== 'circles') return this.#straightSideOf(corner)
    const near = length(corner)
    const far = length(this.#toNeighbor(corner))
    const error = ROUNDING_OF_SIGNS * (near + far + Math.abs(this.s))
    return signBeyond(far - near - this.s, error) || -this.#exactLead(corner)
  }

  /** Returns the sign of the distance from the circle minus that from the neighbor. */
  #exactLead(corner: ClipLine): number {
    const { whole } = this
    const start = corner.wholeStart
    const u = { x: -start.x, y: -start.y }
    const v = { x: whole.x - start.x, y: whole.y - start.y }
    // The distances a and b from the centers, with a = b + s but for the sign.
    const s = -whole.s
    const aa = wholeDot(u, u)
    const bb = wholeDot(v, v)
    const isLarger = s >= 0n
    const square = isLarger ? bb : aa
    const sign = signOfSum(isLarger ? aa - bb - s * s : aa + s * s - bb, -2n * s, square)
    if (sign !== 0) return sign
    // The derivative along x, then the second one, then that along y.
    return (
      TIE * (signOfSum((isLarger ? v.x : u.x) * s, v.x - u.x, square) || (s === 0n ? signOf(v.y - u.y) : -signOf(s)))
    )
  }

  #straightSideOf(corner: ClipLine): number {
    const { x, y } = this
    const square = x * x + y * y
    const value = square - 2 * (corner.x * x + corner.y * y) + this.weight
    const size = square + 2 * sizeOf(corner) * sizeOf(this) + this.weightSize
    const sign = signBeyond(value, ROUNDING_OF_SIGNS * size)
    if (sign !== 0) return sign
    const { whole } = this
    const exact = wholeDot(whole, whole) - 2n * wholeDot(corner.wholeStart, whole) + whole.weight
    return signOf(exact) || -TIE * (signOf(whole.x) || signOf(whole.y))
  }

  // With D the way between the centers, s the difference of their radii and u the direction of the line, which has the
  // height k above the middle of the centers, the line meets the branch twice if and only if k^2 > (s^2 u . u - (u .
  // D)^2) / 4 > 0, and it meets the axis beyond the middle as seen from the larger circle.
  bulgeBeyond(line: ClipLine): number {
    const { x, y, s } = this
    const { dx, dy } = line
    const square = dx * dx + dy * dy
    const along = dx * x + dy * y
    const bound = s * s * square - along * along
    const whole = square * (s * s + x * x + y * y)
    const boundError = 8 * ROUNDING_OF_SIGNS * whole
    if (bound < -boundError) return 0
    const toNeighbor = this.#toNeighbor(line)
    const u = { x: dx, y: dy }
    const height = cross(u, toNeighbor) - cross(u, line)
    const size = sizeOf(u) * (sizeOf(toNeighbor) + sizeOf(line))
    const rest = height * height - bound
    const restError = boundError + 8 * ROUNDING_OF_SIGNS * size * size
    if (rest < -restError) return 0
    const side = signBeyond(height, 4 * ROUNDING_OF_SIGNS * size)
    const toSmaller = s < 0 ? cross(u, this) : -cross(u, this)
    const turn = signBeyond(toSmaller, 4 * ROUNDING_OF_SIGNS * sizeOf(u) * sizeOf(this))
    if (side !== 0 && side === turn) return 0
    if (bound > boundError && rest > restError && side !== 0 && turn !== 0) return side
    return this.#exactBulge(line)
  }

  #exactBulge(line: ClipLine): number {
    const { whole } = this
    const { s } = whole
    const u = line.wholeDirection
    const along = wholeDot(u, whole)
    const least = s * s * wholeDot(u, u) - along * along
    if (least <= 0n) return 0
    const height = wholeCross(u, twiceToMiddle(whole, line.wholeStart))
    const side = signOf(height)
    const turn = signOf(wholeCross(u, whole)) * -signOf(s)
    if (side === 0 || side === turn) return 0
    const rest = signOf(height * height - least)
    return rest > 0 || (rest === 0 && line.afterShift === side) ? side : 0
  }

  isAheadOf(corner: ClipLine, line: ClipLine): boolean {
    const { x, y, s } = this
    const u = { x: line.dx, y: line.dy }
    const m = { x: x - 2 * corner.x, y: y - 2 * corner.y }
    const value = s * s * dot(m, u) - dot(m, this) * dot(u, this)
    const size = (s * s + sizeOf(this) ** 2) * sizeOf(u) * (sizeOf(this) + 2 * sizeOf(corner))
    const sign = signBeyond(value, 4 * ROUNDING_OF_SIGNS * size)
    if (sign !== 0) return sign > 0
    const { whole } = this
    const { s: ws } = whole
    const wu = line.wholeDirection
    const wm = twiceToMiddle(whole, corner.wholeStart)
    const along = wholeDot(wu, whole)
    const normal = { x: ws * ws * wu.x - whole.x * along, y: ws * ws * wu.y - whole.y * along }
    // The shift moves the corner, but not the line through the middles of all parallel chords.
    return (signOf(wholeDot(wm, normal)) || -(signOf(normal.x) || signOf(normal.y))) > 0
  }

  turnAfter(end: BorderEnd, line: ClipLine): number {
    const { x, y, s } = this
    const u = { x: line.dx, y: line.dy }
    const m = { x: x - 2 * end.x, y: y - 2 * end.y }
    const value = s * s * dot(m, u) - dot(m, this) * dot(u, this)
    const size = 2 * end.error + 4 * ROUNDING_OF_SIGNS * (sizeOf(this) + 2 * sizeOf(end))
    const sign = signBeyond(value, 2 * (s * s + sizeOf(this) ** 2) * sizeOf(u) * size)
    if (sign !== 0) return sign
    const { whole } = this
    const wu = line.wholeDirection
    const along = wholeDot(wu, whole)
    const ss = whole.s * whole.s
    const a = -2n * (ss * wu.x - whole.x * along)
    const b = -2n * (ss * wu.y - whole.y * along)
    return end.signOf(a, b, along * (ss - wholeDot(whole, whole)))
  }

  // With x the way from the middle of the centers, the two branches are where 4 (x . D)^2 - 4 s^2 x . x = s^2 (D . D -
  // s^2), and the left side is the larger one on the inner side of each branch.
  shareOf(line: ClipLine, isExit: boolean): Surd {
    const { whole } = this
    const { s } = whole
    const u = line.wholeDirection
    const along = wholeDot(u, whole)
    const square = wholeDot(whole, whole)
    if (s === 0n) {
      return surd(square + whole.weight - 2n * wholeDot(line.wholeStart, whole), 0n, 0n, 2n * along)
    }
    const m = twiceToMiddle(whole, line.wholeStart)
    const ss = s * s
    const height = wholeDot(m, whole)
    // a t^2 + 2 b t + c is 0.
    const a = 4n * (along * along - ss * wholeDot(u, u))
    const b = 2n * (ss * wholeDot(m, u) - height * along)
    const c = height * height - ss * (wholeDot(m, m) + square - ss)
    if (a === 0n) return surd(-c, 0n, 0n, 2n * b)
    return surd(-b, isExit === s < 0n ? 1n : -1n, b * b - a * c, a)
  }
}

const AXES: readonly WholeVector[] = [
  { x: 1n, y: 0n },
  { x: 0n, y: 1n },
  { x: -1n, y: 0n },
  { x: 0n, y: -1n },
]

/** A quarter of the circle that a maximum distance makes around the center. */
export class RimBorder implements BorderCurve {
  readonly isStraight = false
  readonly isCellInside = true
  readonly direction: WholeVector
  readonly radius: number
  /** The squared radius exactly, in units of the squared coordinate step. */
  readonly wholeSquare: bigint

  constructor(radius: number, wholeSquare: bigint, quarter: number) {
    this.radius = radius
    this.wholeSquare = wholeSquare
    this.direction = AXES[quarter] as WholeVector
  }

  sideOf(corner: ClipLine): number {
    const square = this.radius * this.radius
    const distance = dot(corner, corner)
    const sign = signBeyond(square - distance, ROUNDING_OF_SIGNS * (square + distance))
    if (sign !== 0) return sign
    const start = corner.wholeStart
    // The derivative along x, then the second one.
    return signOf(this.wholeSquare - wholeDot(start, start)) || -TIE * (signOf(start.x) || 1)
  }

  bulgeBeyond(line: ClipLine): number {
    const u = { x: line.dx, y: line.dy }
    const height = -cross(u, line)
    const size = sizeOf(u) * sizeOf(line)
    const across = this.radius * this.radius * dot(u, u)
    const rest = across - height * height
    const error = 4 * ROUNDING_OF_SIGNS * (across + size * size)
    const side = signBeyond(height, ROUNDING_OF_SIGNS * size)
    if (rest < -error) return 0
    if (rest > error && side !== 0) return -side
    const wu = line.wholeDirection
    const h = -wholeCross(wu, line.wholeStart)
    const center = signOf(h) || line.afterShift
    const sign = signOf(this.wholeSquare * wholeDot(wu, wu) - h * h)
    return sign > 0 || (sign === 0 && line.afterShift !== center) ? -center : 0
  }

  isAheadOf(corner: ClipLine, line: ClipLine): boolean {
    const value = corner.x * line.dx + corner.y * line.dy
    const size = sizeOf(corner) * (Math.abs(line.dx) + Math.abs(line.dy))
    const sign = signBeyond(value, ROUNDING_OF_SIGNS * size)
    if (sign !== 0) return sign < 0
    const { x, y } = line.wholeDirection
    return (signOf(wholeDot(corner.wholeStart, line.wholeDirection)) || signOf(x) || signOf(y)) < 0
  }

  turnAfter(end: BorderEnd, line: ClipLine): number {
    const value = end.x * line.dx + end.y * line.dy
    const size = Math.abs(line.dx) + Math.abs(line.dy)
    const sign = signBeyond(value, size * (end.error + ROUNDING_OF_SIGNS * sizeOf(end)))
    if (sign !== 0) return -sign
    const { x, y } = line.wholeDirection
    return -end.signOf(x, y, 0n)
  }

  shareOf(line: ClipLine, isExit: boolean): Surd {
    const u = line.wholeDirection
    const start = line.wholeStart
    const a = wholeDot(u, u)
    const b = wholeDot(u, start)
    const c = wholeDot(start, start) - this.wholeSquare
    return surd(-b, isExit ? 1n : -1n, b * b - a * c, a)
  }
}

/** Returns how far the place at a share of a line is ahead along a border curve. */
export function placeAlong({ direction }: BorderCurve, line: ClipLine, { p, q, d, w }: Surd): Surd {
  const start = wholeCross(direction, line.wholeStart)
  const step = wholeCross(direction, line.wholeDirection)
  return { p: start * w + step * p, q: step * q, d, w }
}
