// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  middleOf,
  nextInDirection,
  scaled,
  snappedInPlace,
  snappedInSize,
  stepped,
} from '../../web/editing/arranging.ts'
import type { Circle, Point } from '../../web/lib/index.ts'
import { roundStep } from '../../web/view/round-step.ts'

const coordinate = fc.double({ min: -100, max: 100, noNaN: true })
const point = fc.record({ x: coordinate, y: coordinate })

describe('a step', () => {
  it.each([
    [1, 1],
    [1.3, 1],
    [1.5, 2],
    [3, 2],
    [3.3, 5],
    [7, 5],
    [8, 10],
    [0.017, 0.02],
    [4e-9, 5e-9],
    [123456, 1e5],
  ])('near %d is %d', (length, step) => expect(roundStep(length)).toBe(step))

  it('leaves numbers short', () => {
    expect(stepped(0.1, 0.2)).toBe(0.3)
    expect(stepped(-3.8, 0.05)).toBe(-3.75)
    expect(stepped(1, 1e-7)).toBe(1.0000001)
    expect(stepped(1e-20, 1e-20)).toBe(2e-20)
    expect(stepped(1 / 3, 0.1)).toBe(1 / 3 + 0.1)
    expect(stepped(0.30000000000000004, 0)).toBe(0.30000000000000004)
  })

  it('is never far from the sum', () => {
    fc.assert(
      fc.property(coordinate, fc.double({ min: 1e-9, max: 100, noNaN: true }), (value, length) => {
        const step = roundStep(length)
        expect(step / length).toBeGreaterThan(0.6)
        expect(step / length).toBeLessThan(1.6)
        expect(Math.abs(stepped(value, step) - (value + step))).toBeLessThan(1e-13)
      }),
    )
  })
})

it('circles are scaled about a point', () => {
  expect(scaled({ x: 3, y: 4, r: 5 }, { x: 1, y: 2 }, 2)).toEqual({ x: 5, y: 6, r: 10 })
  expect(
    middleOf([
      { x: 0, y: 0, r: 1 },
      { x: 9, y: 2, r: 4 },
    ]),
  ).toEqual({ x: 6, y: 2 })
})

describe('the next one in a direction', () => {
  const others = [
    { x: 5, y: 0 },
    { x: 3, y: 2.9 },
    { x: 1, y: 4 },
    { x: -1, y: -6 },
  ]
  it.each([
    [[1, 0], { x: 5, y: 0 }],
    [[0, 1], { x: 1, y: 4 }],
    [[0, -1], { x: -1, y: -6 }],
    // No point lies within 45 degrees.
    [[-1, 0], { x: -1, y: -6 }],
  ] as const)('%j is %j', (direction, next) => {
    expect(nextInDirection({ x: 0, y: 0 }, others, direction)).toEqual(next)
  })

  it('is none where none lies on that side', () => {
    expect(nextInDirection({ x: 9, y: 0 }, others, [1, 0])).toBeUndefined()
    expect(nextInDirection({ x: 5, y: 0 }, [{ x: 5, y: 0 }], [1, 0])).toBeUndefined()
  })

  it('is the one ahead that is nearest, and of those to the side, too', () => {
    const sideways = [
      { x: 1, y: 9 },
      { x: 1, y: 3 },
      { x: 5e-324, y: 2 },
    ]
    expect(nextInDirection({ x: 0, y: 0 }, sideways, [1, 0])).toEqual({ x: 1, y: 3 })
    expect(nextInDirection({ x: 0, y: 0 }, sideways.slice(2), [1, 0])).toEqual({ x: 5e-324, y: 2 })
    expect(nextInDirection({ x: 0, y: 0 }, [...sideways, { x: 1e200, y: 0 }], [1, 0])).toEqual({ x: 1e200, y: 0 })
  })

  it('lies on that side, and from there one comes back to something', () => {
    fc.assert(
      fc.property(point, fc.array(point, { minLength: 1 }), (from, others) => {
        const next = nextInDirection(from, others, [1, 0])
        expect(next === undefined).toBe(others.every(({ x }) => !(x - from.x > 0)))
        if (next === undefined) return
        const back = nextInDirection(next, [...others, from], [-1, 0])
        // Leads back to the previous point, or to one that is equally near.
        expect([from, ...others]).toContainEqual(back)
        const rank = ({ x, y }: Point) => Math.hypot(x - next.x, y - next.y) ** 2 / (next.x - x)
        const isAhead = ({ x, y }: Point) => Math.abs(y - next.y) <= next.x - x
        expect((back as Point).x).toBeLessThan(next.x)
        if (isAhead(from)) expect(rank(back as Point)).toBeLessThanOrEqual(rank(from) * (1 + 1e-12))
      }),
    )
  })
})

describe('snapping', () => {
  const within = 0.5
  const gap = (a: Circle, b: Circle) => Math.hypot(a.x - b.x, a.y - b.y) - a.r - b.r

  it('has a circle touch another one', () => {
    const other = { x: 0, y: 0, r: 2 }
    const snapped = snappedInPlace({ x: 2.4, y: 2.4, r: 1 }, { others: [other], grid: 1, within })
    expect(gap(snapped, other)).toBeCloseTo(0, 12)
    expect(snapped.x).toBeCloseTo(snapped.y, 12)
  })

  it('has a circle touch two', () => {
    const others = [
      { x: 0, y: 0, r: 2 },
      { x: 5, y: 0, r: 2 },
      { x: 50, y: 0, r: 2 },
    ]
    for (const y of [1.9, -1.9]) {
      const snapped = snappedInPlace({ x: 2.6, y, r: 1.1 }, { others, grid: 1, within })
      expect(gap(snapped, others[0] as Circle)).toBeCloseTo(0, 12)
      expect(gap(snapped, others[1] as Circle)).toBeCloseTo(0, 12)
      expect(Math.sign(snapped.y)).toBe(Math.sign(y))
    }
  })

  it('touches two others that are up to twice as far away as one', () => {
    const others = [
      { x: -2.9, y: 0, r: 1 },
      { x: 2.9, y: 0, r: 1 },
    ]
    const touching = Math.sqrt(3 ** 2 - 2.9 ** 2)
    for (const [distance, isBoth] of [
      [1.9, true],
      [2.1, false],
    ] as const) {
      const snapping = { others, grid: 1e-9, within: 0.1 }
      const { x, y } = snappedInPlace({ x: 0, y: touching - distance * 0.1, r: 2 }, snapping)
      expect([distance, Math.abs(x) < 1e-9 && Math.abs(y - touching) < 1e-9]).toEqual([distance, isBoth])
    }
  })

  it('is to the grid where no other is near, by x and by y, and nowhere from afar', () => {
    const snapping = { others: [{ x: 50, y: 0, r: 2 }], grid: 0.1, within: 0.02 }
    expect(snappedInPlace({ x: 0.31, y: 0.249, r: 1 }, snapping)).toEqual({ x: 0.3, y: 0.249, r: 1 })
    expect(snappedInSize({ x: 0, y: 0, r: 0.71 }, snapping)).toEqual({ x: 0, y: 0, r: 0.7 })
    expect(snappedInSize({ x: 0, y: 0, r: 0.75 }, snapping)).toEqual({ x: 0, y: 0, r: 0.75 })
  })

  it('has a circle grow until it touches the nearest, and never below zero', () => {
    const others = [
      { x: 5, y: 0, r: 2 },
      { x: 0, y: 5.3, r: 2 },
      { x: 1, y: 0, r: 2 },
    ]
    expect(snappedInSize({ x: 0, y: 0, r: 3.1 }, { others, grid: 1, within }).r).toBe(3)
    expect(snappedInSize({ x: 0, y: 0, r: 3.2 }, { others, grid: 1, within }).r).toBeCloseTo(3.3, 12)
    expect(snappedInSize({ x: 0, y: 0, r: 0.2 }, { others, grid: 1, within }).r).toBe(0)
    expect(snappedInSize({ x: 0, y: 0, r: 0.05 }, { others: [{ x: 1.9, y: 0, r: 2 }], grid: 1, within }).r).toBe(0)
  })

  it('leaves circles that cannot touch where they are', () => {
    const same = { x: 0, y: 0, r: 1 }
    expect(snappedInPlace({ x: 0, y: 0, r: 0 }, { others: [{ x: 0, y: 0, r: 0 }], grid: 1, within })).toEqual({
      x: 0,
      y: 0,
      r: 0,
    })
    expect(Number.isFinite(snappedInPlace({ x: 2, y: 0.1, r: 1 }, { others: [same, same], grid: 1, within }).x)).toBe(
      true,
    )
  })
})
