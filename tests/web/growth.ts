// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the costs that README.md lists: steps (steps.ts) of the same work on circles of four times the number.
import './steps.ts'
import { expect } from 'vitest'
import { seededRandom } from './library.ts'
import { stepsOf } from './steps.ts'

/** The circles of a family, x, y and r of each, for a size. */
type Family = (size: number) => Float64Array

type Numbers = readonly [x: number, y: number, r: number]

function circlesOf(circles: readonly Numbers[]): Float64Array {
  return Float64Array.from(circles.flat())
}

function around(radius: number, size: number, r = 0): Numbers[] {
  return Array.from({ length: size }, (_, k) => {
    const angle = (2 * Math.PI * k) / size
    return [radius * Math.cos(angle), radius * Math.sin(angle), r]
  })
}

function scattered(size: number, width: number, height: number, radius: number): Float64Array {
  const random = seededRandom(size)
  return circlesOf(Array.from({ length: size }, () => [width * random(), height * random(), radius * random()]))
}

const HUB: Numbers = [0, 0, 10]

/** Families in which the work of one circle, row or cell grows in different ways. */
export const FAMILIES = {
  /** Random circles. */
  uniform: (size) => scattered(size, 1, 1, 0.2 / Math.sqrt(size)),
  /** A large circle with points around it: one cell has all others as neighbors, and the hull has all points. */
  hub: (size) => circlesOf([HUB, ...around(12, size)]),
  /** A hub that comes last, within a few large circles far away. */
  wheel: (size) => circlesOf([...around(100, 5, 10), ...around(12, size), HUB]),
  /** Points on one line, whose cells are strips. */
  strips: (size) => circlesOf(Array.from({ length: size }, (_, k) => [k / size, -k / size, 0])),
  /** Random circles in a long row. */
  comb: (size) => scattered(size, size, 1, 0.1),
} satisfies Readonly<Record<string, Family>>

export type FamilyName = keyof typeof FAMILIES

/** 4 n log(4 n) is 4.97 times n log n at this size. */
const SIZE = 300
const FACTOR = 4
const GROWTH_OF_N_LOG_N = 5

/** Prepares an input without being counted, and returns the work to count. */
export type Prepare = (circles: Float64Array) => () => unknown

/** Expects that work on four times as many circles takes at most the steps of n log n. */
export async function expectGrowth(prepare: Prepare, families: readonly FamilyName[]): Promise<void> {
  const growths: [family: FamilyName, growth: number][] = []
  for (const family of families) {
    const stepsAt = (size: number) => stepsOf(prepare(FAMILIES[family](size)))
    const few = await stepsAt(SIZE)
    const many = await stepsAt(FACTOR * SIZE)
    // A few steps more are no growth of next to nothing.
    growths.push([family, many / Math.max(few, SIZE)])
  }
  expect(growths.filter(([, growth]) => growth > GROWTH_OF_N_LOG_N)).toEqual([])
}
