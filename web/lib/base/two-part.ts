// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with twice the digits: the sum of a number and the rest that it lacks. cpp/src/numbers/two_part.h explains
// them and has the same order of operations.

interface TwoPart {
  readonly value: number
  readonly rest: number
}

/** Returns a + b exactly. */
export function sum(a: number, b: number): TwoPart {
  const value = a + b
  const part = value - a
  return { value, rest: a - (value - part) + (b - part) }
}

/** Returns a^2 exactly, except for underflow. */
export function square(a: number): TwoPart {
  const value = a * a
  const shifted = 134217729 * a
  const high = shifted - (shifted - a)
  const low = a - high
  return { value, rest: high * high - value + 2 * high * low + low * low }
}

/** Returns the squared length of the common tangents of two circles: x^2 + y^2 - r^2, for the differences of both. */
export function tangentSquare(circles: Float64Array, p: number, o: number): number {
  const difference = (k: number) => sum(circles[3 * p + k] as number, -(circles[3 * o + k] as number))
  const x = difference(0)
  const y = difference(1)
  const s = difference(2)
  const xx = square(x.value)
  const yy = square(y.value)
  const ss = square(s.value)
  const plane = sum(xx.value, yy.value)
  const all = sum(plane.value, -ss.value)
  const products = x.value * x.rest + y.value * y.rest - s.value * s.rest
  const rest = 2 * products + (xx.rest + yy.rest - ss.rest) + (plane.rest + all.rest)
  return sum(all.value, rest).value
}
