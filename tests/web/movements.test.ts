// SPDX-License-Identifier: GPL-3.0-or-later
// The animations of the page's circles.
import { expect, it } from 'vitest'
import { type Movement, movementOf } from '../../web/app/motion/movements.ts'
import type { IdentifiedCircle } from '../../web/editing/arranging.ts'
import type { Circle } from '../../web/lib/index.ts'
import { seededRandom } from './library.ts'

const random = seededRandom(6)
const BOX = { minX: 0, minY: 0, maxX: 20, maxY: 12 }
const CIRCLES: readonly IdentifiedCircle[] = Array.from({ length: 12 }, (_, id) => ({
  id,
  circle: { x: 2 + 3 * (id % 6), y: 3 + 5 * Math.floor(id / 6), r: 0.3 + random() / 2 },
}))

it('bouncing circles stay in their box and keep their sizes', () => {
  const next = movementOf('bounce', CIRCLES, BOX, random)
  let last = next(1 / 60)
  for (let k = 0; k < 2000; k++) last = next(1 / 60)
  expect(last.map(({ id, circle }) => [id, circle.r])).toEqual(CIRCLES.map(({ id, circle }) => [id, circle.r]))
  // A time step may carry a circle slightly into the wall, which then reflects it.
  for (const { circle } of last) {
    expect(circle.x).toBeGreaterThan(BOX.minX + circle.r - 0.2)
    expect(circle.x).toBeLessThan(BOX.maxX - circle.r + 0.2)
    expect(circle.y).toBeGreaterThan(BOX.minY + circle.r - 0.2)
    expect(circle.y).toBeLessThan(BOX.maxY - circle.r + 0.2)
  }
  expect(last.some(({ circle }, k) => Math.abs(circle.x - (CIRCLES[k] as IdentifiedCircle).circle.x) > 1)).toBe(true)
})

it.each([
  [0, 18.95, 6, 1, 0],
  [0.25, 10, 10.95, 0, 1],
  [0.5, 1.05, 6, -1, 0],
  [0.75, 10, 1.05, 0, -1],
])('a circle that flies at %d of a turn comes back from the wall as its rim touches it', (angle, x, y, dx, dy) => {
  const next = movementOf('bounce', [{ id: 0, circle: { x, y, r: 1 } }], BOX, () => angle)
  // A circle crosses the larger side of the box in eight seconds.
  const [there, back] = [next(0.1), next(0.1)].map((moved) => (moved[0] as IdentifiedCircle).circle)
  expect([there?.x, there?.y]).toEqual([expect.closeTo(x + 0.25 * dx, 12), expect.closeTo(y + 0.25 * dy, 12)])
  expect([back?.x, back?.y]).toEqual([expect.closeTo(x, 12), expect.closeTo(y, 12)])
})

it('circles that overlap and part are left alone, as are points, which never touch', () => {
  const angles = [0.5, 0]
  const apart = [8, 9].map((x, id) => ({ id, circle: { x, y: 6, r: 1 } }))
  const next = movementOf('bounce', apart, BOX, () => angles.shift() as number)
  expect(next(0.1).map(({ circle }) => circle.x)).toEqual([expect.closeTo(7.75, 12), expect.closeTo(9.25, 12)])
  expect(next(0.1).map(({ circle }) => circle.x)).toEqual([expect.closeTo(7.5, 12), expect.closeTo(9.5, 12)])
  const points = headOn({ x: 8, y: 6, r: 0 }, { x: 8, y: 6, r: 0 })
  expect(
    points(0.1).map(({ circle }) => circle.x),
    'one on the other',
  ).toEqual([8.25, 7.75])
})

/** Two circles that fly toward each other, at angles 0 and half a turn. */
function headOn(one: Circle, other: Circle): Movement {
  const angles = [0, 0.5]
  const pair = [one, other].map((circle, id) => ({ id, circle }))
  return movementOf('bounce', pair, BOX, () => angles.shift() as number)
}

it('two equal circles that meet exchange their speeds', () => {
  const next = headOn({ x: 5, y: 6, r: 1 }, { x: 9, y: 6, r: 1 })
  const distances = Array.from({ length: 200 }, () => {
    const [one, other] = next(1 / 60) as [IdentifiedCircle, IdentifiedCircle]
    return other.circle.x - one.circle.x
  })
  expect(Math.min(...distances)).toBeGreaterThan(1.8)
  expect(distances.at(-1)).toBeGreaterThan(4)
})

it('the larger of two circles that meet is deflected less, as its mass is its area', () => {
  const next = headOn({ x: 8, y: 6, r: 1 }, { x: 13, y: 6, r: 3 })
  // The circles overlap after the first frame, and bounce in the second one.
  const [before, after] = [next(0.4), next(0.1)].map((moved) => moved.map(({ circle }) => circle.x))
  expect(before).toEqual([9, 12])
  expect(after?.[0]).toBeCloseTo(9 - 0.1 * 6.5, 12)
  expect(after?.[1]).toBeCloseTo(12 - 0.1 * 1.5, 12)
})

it.each(['grow', 'compare'] as const)(
  'circles grow from points to what they are, and breathe around that: %s',
  (name) => {
    const grow = movementOf(name, CIRCLES, BOX)
    expect(grow(0).every(({ circle }) => circle.r === 0)).toBe(true)
    const radii = CIRCLES.map(({ circle }) => circle.r)
    for (const [k, { circle }] of grow(5).entries()) expect(circle.r).toBeCloseTo(radii[k] as number, 12)
    const breathe = movementOf('breathe', CIRCLES, BOX, random)
    for (let k = 0; k < 50; k++) {
      breathe(0.1).forEach(({ circle }, k) => {
        expect(circle.r).toBeLessThanOrEqual((radii[k] as number) + 1e-12)
        expect(circle.r).toBeGreaterThan(0.6 * (radii[k] as number))
      })
    }
  },
)

it('a breath is over after four seconds', () => {
  const breathe = movementOf('breathe', CIRCLES, BOX, random)
  const radii = (seconds: number) => breathe(seconds).map(({ circle }) => circle.r)
  const begin = radii(0.1)
  expect(radii(2)).not.toEqual(begin.map((r) => expect.closeTo(r, 9)))
  expect(radii(2)).toEqual(begin.map((r) => expect.closeTo(r, 9)))
})
