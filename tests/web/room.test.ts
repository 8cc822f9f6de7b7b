// SPDX-License-Identifier: GPL-3.0-or-later
// Room for a circle that is added by a key.
import { describe, expect, it } from 'vitest'
import { circleOf } from '../../web/lib/base/diagram-data.ts'
import { roomNear } from '../../web/view/painter/room.ts'
import { dataSet, library, seededRandom } from './library.ts'
import { leastDistance } from './oracle.ts'

const random = seededRandom(46)

/** The distance of a circle from the nearest other one, below zero if they overlap. */
const clearance = (circles: Float64Array, circle: { x: number; y: number; r: number }) =>
  leastDistance(circles, circle) - circle.r

describe('room for a circle', () => {
  it.each(['bronzefilter', 'start', 'spruces'])('is free, and stays so for the next one, in %s', (name) => {
    let circles = dataSet(name)
    const { x, y } = circleOf(circles, 0)
    for (let k = 0; k < 12; k++) {
      const circle = roomNear(library.compute(circles), x, y) as { x: number; y: number; r: number }
      expect(circle.r).toBeGreaterThan(0)
      expect(clearance(circles, circle)).toBeGreaterThan(0)
      circles = Float64Array.of(...circles, circle.x, circle.y, circle.r)
      expect(library.compute(circles).cells.exists(circles.length / 3 - 1)).toBe(true)
    }
  })

  it('is at the point itself if that is free, and else near', () => {
    const circles = Float64Array.from({ length: 3 * 2000 }, (_, k) => (k % 3 === 2 ? 0.3 * random() : 20 * random()))
    const diagram = library.compute(circles)
    for (let k = 0; k < 200; k++) {
      const [x, y] = [2 + 16 * random(), 2 + 16 * random()]
      const circle = roomNear(diagram, x, y) as { x: number; y: number; r: number }
      expect(clearance(circles, circle)).toBeGreaterThan(0)
      if (clearance(circles, { x, y, r: 0 }) > 0) expect([circle.x, circle.y]).toEqual([x, y])
      else expect(Math.hypot(circle.x - x, circle.y - y)).toBeLessThan(2)
    }
  })

  it('is beside circles without room between them, and nowhere without circles', () => {
    for (const circles of [
      [0, 0, 5],
      [0, 0, 5, 1, 0, 5],
      [0, 0, 5, 1, 0, 1],
      [0, 0, 5, 3, 0, 5, 1, 2, 5, 1, 2, 5],
    ]) {
      const given = Float64Array.from(circles)
      const circle = roomNear(library.compute(given), 0.5, 0) as { x: number; y: number; r: number }
      expect(clearance(given, circle)).toBeGreaterThan(0)
    }
    expect(roomNear(library.compute([]), 0, 0)).toBeUndefined()
  })
})
