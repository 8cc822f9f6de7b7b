// SPDX-License-Identifier: GPL-3.0-or-later
// The range of numbers, as in circle_voronoi/limits.h, whose names the constants have.
import type { Float64s } from './types.ts'

/** The largest coordinate, radius or weight of a circle, in absolute value. */
export const COORDINATE_LIMIT = 2 ** 96
/** The limit in error messages. */
export const COORDINATE_LIMIT_TEXT = '7.9e28 (2^96)'
/** Numbers are rounded to multiples of this. */
export const COORDINATE_STEP = 2 ** -96
/** The largest weight of a power diagram, in absolute value, which is the square of a length. */
export const POWER_LIMIT = COORDINATE_LIMIT ** 2
/** The limit in error messages. */
export const POWER_LIMIT_TEXT = '6.3e57 (2^192)'
/** Weights of power diagrams are rounded to multiples of this. */
export const POWER_STEP = COORDINATE_STEP ** 2
/** The largest number of an input is 0, or not below this. */
export const SMALLEST_INPUT = 2 ** -56
/** The smallest input in error messages. */
export const SMALLEST_INPUT_TEXT = '1.4e-17 (2^-56)'

/**
 * The largest coordinate of a box or a convex polygon and the largest `maxDistance`, in absolute value. It is sixteen
 * times the limit of circles, so that there is a box around any circles.
 *
 * @category Cells
 * @example
 * REGION_LIMIT // 1.2676506002282294e+30
 */
export const REGION_LIMIT = 2 ** 100
/** The limit in error messages. */
export const REGION_LIMIT_TEXT = '1.2e30 (2^100)'

/** Returns a number rounded to a multiple of `COORDINATE_STEP`, ties to even. The sign stays, also that of zero. */
export function rounded(x: number): number {
  return roundedTo(COORDINATE_STEP, x)
}

function roundedTo(step: number, x: number): number {
  const whole = 2 ** 52 // numbers from here on are integers
  const size = Math.abs(x)
  if (!(size < whole * step)) return x
  const result = (size / step + whole - whole) * step
  return x < 0 || Object.is(x, -0) ? -result : result
}

/** Rounds the numbers of circles in place. `rStep` is the step of radii or weights. */
export function roundAll(numbers: Float64s, rStep: number = COORDINATE_STEP): Float64s {
  for (let k = 0; k < numbers.length; k += 1) {
    numbers[k] = roundedTo(k % 3 === 2 ? rStep : COORDINATE_STEP, numbers[k] as number)
  }
  return numbers
}

/** Returns the error message for an input whose largest number is too small and not 0, or nothing if it is in the range. */
export function tooSmallMessage(largest: number, what: string): string | undefined {
  if (largest === 0 || largest >= SMALLEST_INPUT) return undefined
  let [exponent, size] = [0, largest]
  for (; size < 0.5; exponent -= 1) size *= 2
  const power = Math.trunc((-exponent * 30103 + 99999) / 100000)
  return `${what} are too small: all numbers are below ${SMALLEST_INPUT_TEXT}. Multiply them by 1e${power}.`
}
