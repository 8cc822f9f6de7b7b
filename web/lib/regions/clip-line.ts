// SPDX-License-Identifier: GPL-3.0-or-later
import { wholeOf } from '../base/exact.ts'
import type { Point } from '../base/types.ts'
import type { ConvexPolygon } from './convex-polygon.ts'

/** Integers x and y in coordinate steps. */
export interface WholeVector {
  readonly x: bigint
  readonly y: bigint
}

/** The line of a side of the bounds, seen from the center of a circle. The inside is on its left. */
export class ClipLine {
  /** The side of the bounds. */
  readonly side: number
  readonly from: Point
  readonly to: Point
  /** The start of the side, seen from the center. */
  readonly x: number
  readonly y: number
  /** The direction of the side. */
  readonly dx: number
  readonly dy: number
  /**
   * The side of the line, 1 for left and -1 for right, on which a point of the line lies after the shift of the bounds
   * (CellSigns).
   */
  readonly afterShift: number
  readonly #center: Point
  #wholeStart: WholeVector | undefined
  #wholeDirection: WholeVector | undefined

  constructor(side: number, from: Point, to: Point, center: Point) {
    this.side = side
    this.from = from
    this.to = to
    this.x = from.x - center.x
    this.y = from.y - center.y
    this.dx = to.x - from.x
    this.dy = to.y - from.y
    this.afterShift = to.y !== from.y ? Math.sign(to.y - from.y) : Math.sign(from.x - to.x)
    this.#center = center
  }

  /** Returns the lines of all sides, in order. */
  static of(bounds: ConvexPolygon, center: Point): ClipLine[] {
    return bounds.corners.map((corner, k) => new ClipLine(k, corner, bounds.cornerAfter(k), center))
  }

  get wholeStart(): WholeVector {
    this.#wholeStart ??= wholeBetween(this.#center, this.from)
    return this.#wholeStart
  }

  get wholeDirection(): WholeVector {
    this.#wholeDirection ??= wholeBetween(this.from, this.to)
    return this.#wholeDirection
  }
}

export function wholeBetween(from: Point, to: Point): WholeVector {
  return { x: wholeOf(to.x) - wholeOf(from.x), y: wholeOf(to.y) - wholeOf(from.y) }
}
