// SPDX-License-Identifier: GPL-3.0-or-later
// The visible parts of circles that are too large for canvas arcs.
import { expect, it } from 'vitest'
import { addArc, addDisc } from '../../web/view/painter/disc-path.ts'
import { RecordingSink } from './recording-sink.ts'

const FRAME = { x: 0, y: 0, scale: 1, width: 400, height: 300 }
const RADIUS = 1e6
/** Directions from the center of a circle to the middle of the frame. */
const ANGLES = [0, 0.7, 1.6, 2.5, 3.1, 4, 5.5]

function centerBefore(angle: number) {
  return [200 - RADIUS * Math.cos(angle), 150 - RADIUS * Math.sin(angle)] as const
}

/** The points of a path inside the frame, and their largest distance from a circle. */
function seenOf({ points }: RecordingSink, cx: number, cy: number) {
  const inside = points.filter(({ x, y }) => x >= 0 && x <= FRAME.width && y >= 0 && y <= FRAME.height)
  const miss = Math.max(0, ...inside.map(({ x, y }) => Math.abs(Math.hypot(x - cx, y - cy) - RADIUS)))
  return { inside, miss }
}

it.each(ANGLES)('the rim of a large circle crosses the frame where it is, and is not elsewhere: at %d', (angle) => {
  const [cx, cy] = centerBefore(angle)
  const sink = new RecordingSink(256)
  addDisc(sink, FRAME, cx, cy, RADIUS)
  const { inside, miss } = seenOf(sink, cx, cy)
  expect(miss).toBeLessThan(1e-3)
  for (const along of [-120, 0, 120]) {
    const [x, y] = [200 - along * Math.sin(angle), 150 + along * Math.cos(angle)]
    expect(Math.min(...inside.map((point) => Math.hypot(point.x - x, point.y - y)))).toBeLessThan(4)
  }
})

it.each(ANGLES)('an arc of a large circle is seen between its ends only: at %d', (angle) => {
  const [cx, cy] = centerBefore(angle)
  const shares = [
    [angle, 1],
    [angle - 1, 1],
    [angle + 3, 2 * Math.PI - 3],
    [angle + 1, 1],
    [angle + 80 / RADIUS, 1],
  ].map(([from = 0, turn = 0]) => {
    const sink = new RecordingSink(256)
    addArc(sink, FRAME, cx, cy, RADIUS, from, turn)
    const { inside, miss } = seenOf(sink, cx, cy)
    expect(miss).toBeLessThan(1e-3)
    const sides = inside.map(({ x, y }) => (y - 150) * Math.cos(angle) - (x - 200) * Math.sin(angle))
    return [sides.some((side) => side < -50), sides.some((side) => side > 50)]
  })
  // The first arc begins in the middle of the frame, the next two end there, one is elsewhere, and one begins beside it.
  expect(shares).toEqual([
    [false, true],
    [true, false],
    [true, false],
    [false, false],
    [false, true],
  ])
})

it('a frame inside a large circle is filled, and one outside is left empty', () => {
  const pathTo = (distance: number) => {
    const sink = new RecordingSink(4)
    addDisc(sink, FRAME, 200, 150 + distance, RADIUS)
    return sink.points
  }
  expect(pathTo(2 * RADIUS)).toEqual([])
  const corners = pathTo(0)
  for (const axis of ['x', 'y'] as const) {
    const values = corners.map((point) => point[axis])
    expect(Math.min(...values)).toBeLessThan(0)
    expect(Math.max(...values)).toBeGreaterThan(400)
  }
})
