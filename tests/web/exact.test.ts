// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers p + q sqrt(d), compared with square roots of 400 bits.
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  compareSurds,
  coordinateOf,
  numberOf,
  type Surd,
  signOfSum,
  surd,
  wholeOf,
  wholeSquareOf,
} from '../../web/lib/base/exact.ts'

const BITS = 400n

/** The square root in units of 2^-400, rounded down, by bisection. */
function rootOf(d: bigint): bigint {
  let root = 0n
  for (let bit = 1n << (BITS + 64n); bit > 0n; bit >>= 1n) {
    if ((root + bit) * (root + bit) <= d << (2n * BITS)) root += bit
  }
  return root
}

/** A number in units of 2^-400, nearly. */
function approximate({ p, q, d, w }: Surd): bigint {
  return ((p << BITS) + q * rootOf(d)) / w
}

const integer = fc.bigInt(-(2n ** 60n), 2n ** 60n)
const positive = fc.bigInt(1n, 2n ** 60n)
const anySurd = fc.tuple(integer, integer, fc.bigInt(0n, 2n ** 60n), positive).map(([p, q, d, w]) => ({ p, q, d, w }))
/** Numbers of which p almost cancels q sqrt(d), or cancels it. */
const nearZero = fc
  .tuple(fc.bigInt(1n, 2n ** 30n), fc.bigInt(0n, 2n ** 60n), fc.bigInt(-1n, 1n), positive)
  .map(([q, d, off, w]): Surd => ({ p: -((q * rootOf(d)) >> BITS) + off, q, d, w }))

function signOf(value: bigint): number {
  return value > 0n ? 1 : value < 0n ? -1 : 0
}

describe('a number p + q sqrt(d)', () => {
  it('has the sign of its value', () => {
    fc.assert(
      fc.property(fc.oneof(anySurd, nearZero), (number) => {
        const value = approximate({ ...number, w: 1n })
        const isZero = number.p ** 2n === number.q ** 2n * number.d && signOf(number.p) * signOf(number.q) <= 0
        expect(signOfSum(number.p, number.q, number.d) + 0).toBe(isZero ? 0 : signOf(value))
      }),
    )
  })

  it('is less than another, equal or greater', () => {
    fc.assert(
      fc.property(fc.oneof(anySurd, nearZero), fc.oneof(anySurd, nearZero), (one, other) => {
        const difference = approximate(one) - approximate(other)
        fc.pre(difference < -4n || difference > 4n)
        expect(compareSurds(one, other)).toBe(signOf(difference))
        expect(compareSurds(other, one)).toBe(-signOf(difference))
      }),
    )
  })

  it('equals itself in other terms', () => {
    fc.assert(
      fc.property(anySurd, positive, (number, k) => {
        const { p, q, d, w } = number
        expect(compareSurds(number, { p: p * k, q, d: d * k * k, w: w * k }) + 0).toBe(0)
        expect(compareSurds(number, surd(-p, -q, d, -w)) + 0).toBe(0)
      }),
    )
  })

  it('is rounded to a double', () => {
    fc.assert(
      fc.property(fc.oneof(anySurd, nearZero), (number) => {
        const rounded = numberOf(number)
        const value = approximate(number)
        fc.pre(Math.abs(rounded) > 2 ** -300)
        const error = BigInt(Math.round(rounded * 2 ** 360)) * 2n ** (BITS - 360n) - value
        expect(Number(error > 0n ? error : -error)).toBeLessThanOrEqual(Math.abs(Number(value)) * 2 ** -52)
      }),
    )
    expect(numberOf({ p: -6n, q: 2n, d: 9n, w: 7n })).toBe(0)
  })

  it('has no root of a number below 0', () => {
    expect(surd(1n, 5n, -3n, 2n)).toEqual({ p: 1n, q: 5n, d: 0n, w: 2n })
    expect(signOfSum(-2n, 5n, 0n)).toBe(-1)
  })
})

it('a coordinate is a whole number of steps', () => {
  for (const x of [0, 1, -0.75, 2 ** 100, -(2 ** -96), 1.1, 1e-20]) {
    const whole = wholeOf(x)
    expect(coordinateOf({ p: whole, q: 0n, d: 0n, w: 1n })).toBe(Math.round(x * 2 ** 96) / 2 ** 96)
    expect(wholeSquareOf(x * x)).toBe(BigInt(Math.round(x * x * 2 ** 192)))
  }
  for (const x of [Number.NaN, Number.POSITIVE_INFINITY, 1e300]) {
    expect(() => wholeOf(x)).toThrow(expect.objectContaining({ code: 'badInput' }))
  }
})
