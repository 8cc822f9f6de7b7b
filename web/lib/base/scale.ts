// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths from the smallest to the largest number, whose products neither overflow nor vanish.
import { cross, dot, length } from './point.ts'
import type { Vector } from './types.ts'

/** Parameters of curves and places on them may be off by this share, by rounding. */
export const ROUNDING = 2 ** -40

const view = new DataView(new ArrayBuffer(8))

/** Whether a sum of two products has neither overflown nor lost what counts. */
function isSafe(product: number): boolean {
  const size = Math.abs(product)
  return 2 ** -900 < size && size < 2 ** 1000
}

/** The largest power of two up to `size` > 0. */
export function powerOfTwoIn(size: number): number {
  if (size < 2 ** -1022) return powerOfTwoIn(size * 2 ** 100) * 2 ** -100
  view.setFloat64(0, size)
  view.setUint32(0, view.getUint32(0) & 0x7ff00000)
  view.setUint32(4, 0)
  return view.getFloat64(0)
}

/**
 * A unit to measure lengths of about `size` in, so that products of up to four are safe: 1 for most, else a power of two
 * next to `size`. To divide by it is exact.
 */
export function unitFor(size: number): number {
  const isSafe = 2 ** -200 < size && size < 2 ** 200
  return isSafe || !(size > 0 && size < Number.POSITIVE_INFINITY) ? 1 : powerOfTwoIn(size)
}

export function largestOf({ x, y }: Vector): number {
  return Math.max(Math.abs(x), Math.abs(y))
}

export function measuredIn(unit: number, v: Vector): Vector {
  return unit === 1 ? v : { x: v.x / unit, y: v.y / unit }
}

/** The length of a vector of any size. */
export function lengthOf({ x, y }: Vector): number {
  return hypotenuse(x, y)
}

/** The hypotenuse of a vector by its coordinates. */
export function hypotenuse(x: number, y: number): number {
  const square = x * x + y * y
  if (isSafe(square)) return Math.sqrt(square)
  const v = { x, y }
  const unit = unitFor(largestOf(v))
  return unit * length(measuredIn(unit, v))
}

/** The cross product but for a factor above 0: positive if the way from u to v is a left turn. */
export function turn(u: Vector, v: Vector): number {
  const product = cross(u, v)
  if (isSafe(product)) return product
  return cross(measuredIn(unitFor(largestOf(u)), u), measuredIn(unitFor(largestOf(v)), v))
}

/** The dot product but for a factor above 0. */
export function facing(u: Vector, v: Vector): number {
  return dot(measuredIn(unitFor(largestOf(u)), u), measuredIn(unitFor(largestOf(v)), v))
}
