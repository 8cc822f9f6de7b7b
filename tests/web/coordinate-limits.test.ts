// SPDX-License-Identifier: GPL-3.0-or-later
// The limits of numbers are those of C++.
import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import * as limits from '../../web/lib/base/coordinate-limits.ts'
import { fromJSON } from '../../web/lib/index.ts'
import { problemOf } from './errors.ts'
import { library } from './library.ts'

const header = readFileSync(new URL('../../cpp/include/circle_voronoi/limits.h', import.meta.url), 'utf8')

/** A constant of the header: a power of two, or a text. */
function constant(name: string): number | string | undefined {
  const [, value] = new RegExp(`\\b${name} = (.*);`).exec(header) ?? []
  const [, exponent] = /^0x1p(-?\d+)$/.exec(value ?? '') ?? []
  return exponent === undefined ? value?.replace(/^"(.*)"$/, '$1') : 2 ** Number(exponent)
}

it.each([
  ['kCoordinateLimit', limits.COORDINATE_LIMIT],
  ['kCoordinateLimitText', limits.COORDINATE_LIMIT_TEXT],
  ['kCoordinateStep', limits.COORDINATE_STEP],
  ['kSmallestInput', limits.SMALLEST_INPUT],
  ['kSmallestInputText', limits.SMALLEST_INPUT_TEXT],
  ['kRegionLimit', limits.REGION_LIMIT],
  ['kRegionLimitText', limits.REGION_LIMIT_TEXT],
])('%s is the same', (name, ours) => {
  expect(ours).toBe(constant(name))
})

describe('the circles of a diagram', () => {
  const STEP = limits.COORDINATE_STEP

  it.each([
    [0.1, 0.1],
    [2 ** 96, 2 ** 96],
    [2 ** -44 * (2 - 2 ** -52), 2 ** -44 * (2 - 2 ** -52)],
    [0.5 * STEP, 0],
    [1.5 * STEP, 2 * STEP],
    [2.5 * STEP, 2 * STEP],
    [2.75 * STEP, 3 * STEP],
    [2 ** -45 * (2 - 2 ** -52), 2 ** -44],
    [5e-324, 0],
    [0, 0],
  ])('have %d as %d, like those of the core', (given, expected) => {
    expect(limits.rounded(given)).toBe(expected)
    expect(limits.rounded(-given)).toBe(-expected)
    const diagram = library.compute([
      [given, -given, 0],
      [1, 0, 0],
    ])
    expect([...diagram.circles]).toEqual([expected, -expected, 0, 1, 0, 0])
    const editor = library.edit([[1, 0, 0]])
    editor.insert([given, -given, 0])
    expect([...editor.snapshot().circles].map((value) => value + 0)).toEqual([1, 0, 0, expected, 0 - expected, 0])
    editor.dispose()
  })

  it('are at the limit, and not a step beyond it', () => {
    const largest = library.compute([[2 ** 96, -(2 ** 96), 2 ** 96]])
    expect(fromJSON(JSON.stringify(largest)).circles).toEqual(largest.circles)
    const beyond = 2 ** 96 * (1 + 2 ** -52)
    expect(problemOf(() => library.compute([[0, beyond, 0]]))).toBe(
      'coordinateTooLarge: Circle 0 has a coordinate or a radius beyond 7.9e28 (2^96).',
    )
  })

  it('are refused if all numbers are so small that rounding could be felt', () => {
    expect(library.compute([[0, 2 ** -56, 0]]).circles.length).toBe(3)
    expect(library.compute([[0, 0, 0]]).circles.length).toBe(3)
    for (const size of [2 ** -56 * (1 - 2 ** -53), 1e-20, 1e-300, 5e-324]) {
      const message = limits.tooSmallMessage(size, 'The circles')
      expect(message).toBeDefined()
      expect(problemOf(() => library.compute([[0, size, 0]]))).toBe(`coordinateTooSmall: ${message}`)
      const [, power] = /by 1e(\d+)\.$/.exec(message ?? '') ?? []
      const halves = [Math.floor(Number(power) / 2), Math.ceil(Number(power) / 2)] as const
      const product = size * 10 ** halves[0] * 10 ** halves[1]
      expect(product >= 0.4 && product < 20).toBe(true)
    }
  })
})
