// SPDX-License-Identifier: GPL-3.0-or-later
import { type Surd, signOfSum, surd } from '../base/exact.ts'
import type { Point } from '../base/types.ts'
import type { ClipLine } from './clip-line.ts'
import { ROUNDING_OF_SIGNS, signBeyond, TIE } from './sign-filter.ts'

/**
 * The point (x + x1 sqrt(d)) / (w + w1 sqrt(d)), likewise y, seen from the center of a circle, in coordinate steps. The
 * divisor is positive. The distance from the center is `rho` / (w + w1 sqrt(d)), where it is needed.
 */
export interface ExactPoint {
  readonly x: bigint
  readonly x1: bigint
  readonly y: bigint
  readonly y1: bigint
  readonly w: bigint
  readonly w1: bigint
  readonly d: bigint
  readonly rho?: bigint
}

/** A point where two pieces of the border of a cell meet. */
export class BorderEnd {
  /** The point in coordinates. */
  readonly point: Point
  /** The point, seen from the center of the circle, and a bound on the error of each number. */
  readonly x: number
  readonly y: number
  readonly error: number
  readonly #exactly: () => ExactPoint
  #exact: ExactPoint | undefined
  readonly #sides: number[] = []

  constructor(point: Point, seen: Point, error: number, exactly: () => ExactPoint) {
    this.point = point
    this.x = seen.x
    this.y = seen.y
    this.error = error
    this.#exactly = exactly
  }

  get exact(): ExactPoint {
    this.#exact ??= this.#exactly()
    return this.#exact
  }

  /** Returns the side of a line on which the point lies: 1 for left, -1 for right, times `TIE` if the shift decides. */
  sideOf(line: ClipLine): number {
    let side = this.#sides[line.side]
    if (side === undefined) {
      side = this.#sideOf(line)
      this.#sides[line.side] = side
    }
    return side
  }

  #sideOf(line: ClipLine): number {
    const { dx, dy } = line
    const x = this.x - line.x
    const y = this.y - line.y
    const size = Math.abs(this.x) + Math.abs(this.y) + Math.abs(line.x) + Math.abs(line.y)
    const error = (Math.abs(dx) + Math.abs(dy)) * (this.error + ROUNDING_OF_SIGNS * size)
    const sign = signBeyond(dx * y - dy * x, error)
    if (sign !== 0) return sign
    const { x: u, y: v } = line.wholeDirection
    const start = line.wholeStart
    return this.signOf(-v, u, v * start.x - u * start.y) || line.afterShift * TIE
  }

  /** Returns whether the start of a line lies above the point. */
  isBelow(corner: ClipLine): boolean {
    const error = this.error + ROUNDING_OF_SIGNS * (Math.abs(this.y) + Math.abs(corner.y))
    // The shift moves corners up.
    return (signBeyond(corner.y - this.y, error) || -this.signOf(0n, 1n, -corner.wholeStart.y)) >= 0
  }

  /** Returns the sign of a x + b y + c. */
  signOf(a: bigint, b: bigint, c: bigint): number {
    const { x, x1, y, y1, w, w1, d } = this.exact
    return signOfSum(a * x + b * y + c * w, a * x1 + b * y1 + c * w1, d)
  }

  /** Returns the number a x + b y of a point whose divisor is an integer. */
  valueOf(a: bigint, b: bigint): Surd {
    const { x, x1, y, y1, w, d } = this.exact
    return surd(a * x + b * y, a * x1 + b * y1, d, w)
  }
}
