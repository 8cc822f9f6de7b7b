// SPDX-License-Identifier: GPL-3.0-or-later

/** A generous bound on the rounding error of a sign's value, as a share of the sizes of its summands. */
export const ROUNDING_OF_SIGNS = 2 ** -48
/** The factor of signs that the shift of the bounds has decided, because the value is exactly 0. */
export const TIE = 2

/** Returns the sign of a value, or 0 if it may be an error. */
export function signBeyond(value: number, error: number): number {
  return value > error ? 1 : value < -error ? -1 : 0
}
