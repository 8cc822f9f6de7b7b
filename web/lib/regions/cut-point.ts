// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point, Vector } from '../base/types.ts'

/** A point that has been computed more exactly than its coordinates say, so that areas far from the origin are right. */
export class CutPoint implements Point {
  readonly x: number
  readonly y: number
  readonly #rest: Vector

  /** `rest` is what rounding has taken from the coordinates. */
  constructor(x: number, y: number, rest: Vector) {
    this.x = x
    this.y = y
    this.#rest = rest
  }

  /** Returns the point at the end of a vector. */
  static after(from: Point, step: Vector): CutPoint {
    const x = from.x + step.x
    const y = from.y + step.y
    return new CutPoint(x, y, { x: restOf(from.x, step.x, x), y: restOf(from.y, step.y, y) })
  }

  /** Returns the vector from the coordinates of a point to another point. */
  static seenFrom(from: Point, point: Point): Vector {
    const x = point.x - from.x
    const y = point.y - from.y
    return point instanceof CutPoint ? { x: x + point.#rest.x, y: y + point.#rest.y } : { x, y }
  }
}

/** Returns the rounding error of a sum (Knuth's two-sum). */
function restOf(a: number, b: number, sum: number): number {
  const second = sum - a
  return a - (sum - second) + (b - second)
}
