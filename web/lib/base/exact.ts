// SPDX-License-Identifier: GPL-3.0-or-later
// Exact arithmetic with numbers p + q sqrt(d), as integers. It decides where rounding errors of doubles do not.
import { refuseInput } from './check.ts'
import { COORDINATE_STEP } from './coordinate-limits.ts'

const ROOT_BITS = 64n

/**
 * Returns a number of the range of inputs (coordinate-limits.ts) as a multiple of the coordinate step.
 *
 * @throws CircleVoronoiError `badInput`, if the number is far beyond that range, because arrays were changed
 */
export function wholeOf(x: number): bigint {
  return toInteger(x / COORDINATE_STEP)
}

/** Returns a squared radius as a multiple of the square of the coordinate step. */
export function wholeSquareOf(x: number): bigint {
  return toInteger(x / COORDINATE_STEP / COORDINATE_STEP)
}

function toInteger(x: number): bigint {
  if (!Number.isFinite(x))
    refuseInput('The diagram has a coordinate beyond all limits. Its arrays must not be changed.')
  return BigInt(Math.round(x))
}

export function signOf(p: bigint): number {
  return p > 0n ? 1 : p < 0n ? -1 : 0
}

/** The number (p + q sqrt(d)) / w, with d >= 0 and w > 0. */
export interface Surd {
  readonly p: bigint
  readonly q: bigint
  readonly d: bigint
  readonly w: bigint
}

/** Makes a number of which w is not 0 and d may be negative where rounding was to make it 0. */
export function surd(p: bigint, q: bigint, d: bigint, w: bigint): Surd {
  const root = d > 0n ? d : 0n
  return w < 0n ? { p: -p, q: -q, d: root, w: -w } : { p, q, d: root, w }
}

/** Returns the sign of p + q sqrt(d). */
export function signOfSum(p: bigint, q: bigint, d: bigint): number {
  const first = signOf(p)
  const second = d > 0n ? signOf(q) : 0
  if (first * second >= 0) return first === 0 ? second : first
  return first * signOf(p * p - q * q * d)
}

/** Returns the sign of the difference of two numbers. */
export function compareSurds(one: Surd, other: Surd): number {
  // p + q sqrt(d) + r sqrt(e)
  const p = one.p * other.w - other.p * one.w
  const q = one.q * other.w
  const r = -other.q * one.w
  const { d } = one
  const { d: e } = other
  const first = signOfSum(p, q, d)
  const second = e > 0n ? signOf(r) : 0
  if (first * second >= 0) return first === 0 ? second : first
  return first * signOfSum(p * p + q * q * d - r * r * e, 2n * p * q, d)
}

/** Returns the number of bits of a positive integer, up to three more. */
function bitsOf(p: bigint): number {
  return 4 * p.toString(16).length
}

/** Returns the largest integer whose square is not above d >= 0. */
function rootOf(d: bigint): bigint {
  if (d < 1n) return 0n
  let root = 1n << BigInt((bitsOf(d) >> 1) + 1)
  for (;;) {
    const next = (root + d / root) >> 1n
    if (next >= root) return root
    root = next
  }
}

function sizeOf(p: bigint): bigint {
  return p < 0n ? -p : p
}

/** Returns a number rounded to a double. */
export function numberOf({ p, q, d, w }: Surd): number {
  const sign = signOfSum(p, q, d)
  if (sign === 0) return 0
  // The more the two terms cancel, the more bits the root needs.
  let numerator = p
  let shift = 0n
  if (q !== 0n && d > 0n) {
    for (shift = ROOT_BITS; ; shift *= 2n) {
      const root = rootOf((q * q * d) << (2n * shift))
      numerator = (p << shift) + (q < 0n ? -root : root)
      if (bitsOf(sizeOf(numerator)) > ROOT_BITS) break
    }
  }
  const divisor = w << shift
  const up = Number(ROOT_BITS) + bitsOf(divisor) - bitsOf(sizeOf(numerator))
  const quotient = up > 0 ? (numerator << BigInt(up)) / divisor : numerator / (divisor << BigInt(-up))
  return Number(quotient) * 2 ** -up
}

/** Returns a number, as a multiple of the coordinate step, rounded to a coordinate. */
export function coordinateOf(number: Surd): number {
  return numberOf(number) * COORDINATE_STEP
}
