// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { DecimalText } from '../../web/lib/drawing/decimal.ts'

const textOf = (value: number, count: number) => {
  const text = new DecimalText(count)
  text.addNumber(value)
  return `${text}`
}

const digits = fc.integer({ min: 0, max: 20 })
const numbers = fc.oneof(
  fc.double({ noNaN: true, noDefaultInfinity: true }),
  fc.double({ min: -1000, max: 1000, noNaN: true }),
  fc.integer({ min: -1000, max: 1000 }).map((i) => i / 64),
  fc.tuple(fc.integer({ min: -(2 ** 30), max: 2 ** 30 }), digits).map(([i, k]) => i / 10 ** k),
)

describe('the text of a number with few digits', () => {
  it('may be as long as it will, and of commands alone', () => {
    const text = new DecimalText(2)
    for (let k = 0; k < 40_000; k++) text.add('Z')
    expect(`${text}`).toBe('Z'.repeat(40_000))
    for (let k = 0; k < 9_000; k++) text.addNumber(12.25)
    expect(`${text}`).toBe('Z'.repeat(40_000) + '12.25'.repeat(9_000))
  })

  it('is empty until something is added, and again once it is taken', () => {
    const text = new DecimalText(2)
    expect(text.isEmpty).toBe(true)
    text.add('M')
    expect(text.isEmpty).toBe(false)
    expect(text.take()).toBe('M')
    expect(text.isEmpty).toBe(true)
  })

  it('is the shortest of the number rounded', () => {
    fc.assert(
      fc.property(numbers, digits, (value, count) => {
        const scaled = value * 10 ** count
        const expected = Math.abs(scaled) < 2 ** 53 ? Math.round(scaled) / 10 ** count : value
        const text = textOf(value, count)
        expect(Number(text)).toBe(expected === 0 ? Number(text) * 0 : expected)
        expect(text.length).toBeLessThanOrEqual(`${expected}`.length + (`${expected}`.includes('e') ? 25 : 0))
      }),
      { numRuns: 2000 },
    )
  })

  it.each([
    [0, 3, '0'],
    [-0.0001, 3, '0'],
    [-0.5, 1, '-0.5'],
    [1.0004, 4, '1.0004'],
    [12.3456789, 6, '12.345679'],
    [0.00001, 5, '0.00001'],
    [3.1, 7, '3.1'],
    [1e21, 2, '1e+21'],
    [0.1, Number.POSITIVE_INFINITY, '0.1'],
    [5e10 + 0.25, 2, '50000000000.25'],
  ])('%d to %d digits is %s', (value, count, text) => {
    expect(textOf(value, count)).toBe(text)
  })

  it('stays in its own text, when several long ones are written in turns', () => {
    const texts = [1, 2, 3].map((count) => new DecimalText(count))
    const expected = ['', '', '']
    for (let k = 0; k < 10_000; k++) {
      texts[k % 3]?.add(' ')
      texts[k % 3]?.addNumber(k + 0.5)
      expected[k % 3] += ` ${k}.5`
    }
    expect(texts.map(String)).toEqual(expected)
    expect(texts.map(String)).toEqual(expected)
    texts[0]?.add('!')
    expect(String(texts[0])).toBe(`${expected[0]}!`)
  })
})
