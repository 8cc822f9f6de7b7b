// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic with lengths whose products may overflow. Circles and regions keep the range of numbers
// (coordinate-limits.ts), but vertices lie up to 2^876 away, and a query may take any point.
import { cross, dot, length } from './point.ts'
import type { Vector } from './types.ts'

/** The relative rounding error of curve parameters and of points on curves. */
export const ROUNDING = 2 ** -40

const view = new DataView(new ArrayBuffer(8))

/** Whether a sum of two products has not overflowed. */
function isSafe(product: number): boolean {
  return Math.abs(product) < 2 ** 1000
}

/** Returns the largest power of two that is not above `size` > 0. */
export function powerOfTwoIn(size: number): number {
  view.setFloat64(0, size)
  view.setUint32(0, view.getUint32(0) & 0x7ff00000)
  view.setUint32(4, 0)
  return view.getFloat64(0)
}

/**
 * Returns a unit for lengths of about `size`, in which products of up to four lengths are safe. The unit is 1 for most
 * sizes, otherwise a power of two near `size`, so division by it is exact.
 */
export function unitFor(size: number): number {
  return size >= 2 ** 200 && size < Number.POSITIVE_INFINITY ? powerOfTwoIn(size) : 1
}

export function largestOf({ x, y }: Vector): number {
  return Math.max(Math.abs(x), Math.abs(y))
}

export function measuredIn(unit: number, v: Vector): Vector {
  return unit === 1 ? v : { x: v.x / unit, y: v.y / unit }
}

/** Returns the length of a vector of any size. */
export function lengthOf({ x, y }: Vector): number {
  return hypotenuse(x, y)
}

/** Returns the length of the vector (x, y). */
export function hypotenuse(x: number, y: number): number {
  const square = x * x + y * y
  if (isSafe(square)) return Math.sqrt(square)
  const v = { x, y }
  const unit = unitFor(largestOf(v))
  return unit * length(measuredIn(unit, v))
}

/** Returns the cross product times a positive factor. It is positive if the turn from u to v is to the left. */
export function turn(u: Vector, v: Vector): number {
  const product = cross(u, v)
  if (isSafe(product)) return product
  return cross(measuredIn(unitFor(largestOf(u)), u), measuredIn(unitFor(largestOf(v)), v))
}

/** Returns the dot product times a positive factor. */
export function facing(u: Vector, v: Vector): number {
  return dot(measuredIn(unitFor(largestOf(u)), u), measuredIn(unitFor(largestOf(v)), v))
}
