// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  type Box,
  clearestPath,
  type Diagram,
  edgeAt,
  edgeCurve,
  NONE,
  type Point,
  pointAt,
} from '../../web/lib/index.ts'
import { KINDS, unit } from './arbitrary-circles.ts'
import { library } from './library.ts'
import { boxAround, leastDistance, pointIn, scaleOf, signedDistance } from './oracle.ts'

const COUNT = 60

/** The best clearance of a path from pixel to pixel, by flooding from the clearest pixels down. */
function clearanceByPixels(circles: Float64Array, box: Box, p: Point, q: Point): number {
  const center = (k: number) => pointIn(box, ((k % COUNT) + 0.5) / COUNT, (Math.floor(k / COUNT) + 0.5) / COUNT)
  const pixelOf = ({ x, y }: Point) =>
    Math.floor((COUNT * (y - box.minY)) / (box.maxY - box.minY)) * COUNT +
    Math.floor((COUNT * (x - box.minX)) / (box.maxX - box.minX))
  const clearances = Array.from({ length: COUNT * COUNT }, (_, k) => leastDistance(circles, center(k)))
  const [from, to] = [pixelOf(p), pixelOf(q)]
  const parent = clearances.map((_, k) => k)
  const root = (k: number): number => {
    let r = k
    while (parent[r] !== r) {
      parent[r] = parent[parent[r] as number] as number
      r = parent[r] as number
    }
    return r
  }
  const isOpen = clearances.map(() => false)
  const order = clearances
    .map((_, k) => k)
    .sort((one, other) => (clearances[other] as number) - (clearances[one] as number))
  for (const k of order) {
    isOpen[k] = true
    const [column, row] = [k % COUNT, Math.floor(k / COUNT)]
    for (const [dx, dy] of [
      [-1, -1],
      [0, -1],
      [1, -1],
      [-1, 0],
      [1, 0],
      [-1, 1],
      [0, 1],
      [1, 1],
    ] as const) {
      if (column + dx < 0 || column + dx >= COUNT || row + dy < 0 || row + dy >= COUNT) continue
      const next = k + dx + COUNT * dy
      if (isOpen[next]) parent[root(next)] = root(k)
    }
    if (isOpen[from] && isOpen[to] && root(from) === root(to)) return clearances[k] as number
  }
  throw new Error('The pixels are not connected.')
}

/** The least clearance over many points of the edges that a path follows. */
function clearanceAlong({ circles, ...rest }: Diagram, path: ReturnType<typeof clearestPath>): number {
  const diagram = { circles, ...rest }
  let least = Number.POSITIVE_INFINITY
  // The path follows whole edges, except for the first and the last.
  for (const e of path.edges.slice(1, -1)) {
    const { bisector, from, to } = edgeCurve(diagram, e)
    const [low, high] = [Math.max(from, 1e-3), Math.min(to, 1e3)]
    for (let k = 0; k <= 32; k++) {
      least = Math.min(least, leastDistance(circles, pointAt(bisector, low * (high / low) ** (k / 32))))
    }
  }
  return least
}

describe.each(Object.entries(KINDS).filter(([name]) => name !== 'oneHuge'))(
  'among circles that are %s',
  (_, arbitrary) => {
    it('is as clear as that of pixels, both ways', () => {
      fc.assert(
        fc.property(arbitrary, unit, unit, unit, unit, (circles, a, b, c, d) => {
          const diagram = library.compute(circles)
          const inner = boxAround(circles, 0)
          // Leaves room to go around everything.
          const extent = Math.max(inner.maxX - inner.minX, inner.maxY - inner.minY)
          const box = {
            minX: inner.minX - extent,
            minY: inner.minY - extent,
            maxX: inner.maxX + extent,
            maxY: inner.maxY + extent,
          }
          const [p, q] = [pointIn(inner, a, b), pointIn(inner, c, d)]
          const size = Math.max(box.maxX - box.minX, box.maxY - box.minY)
          const path = clearestPath(diagram, p, q)
          expect(Math.abs(path.clearance - clearanceByPixels(circles, box, p, q))).toBeLessThan((2 * size) / COUNT)
          expect(clearestPath(diagram, q, p).clearance).toBeCloseTo(path.clearance, 7)
          expect(path.clearance).toBeLessThanOrEqual(leastDistance(circles, p) + 1e-9)
        }),
        { numRuns: 12 },
      )
    })
  },
)

it('follows edges that meet, and keeps clear all the way', () => {
  fc.assert(
    fc.property(fc.oneof(...Object.values(KINDS)), unit, unit, unit, unit, (circles, a, b, c, d) => {
      const diagram = library.compute(circles)
      const box = boxAround(circles, 0.1)
      const [p, q] = [pointIn(box, a, b), pointIn(box, c, d)]
      const path = clearestPath(diagram, p, q)
      const rounding = 1e-8 * scaleOf(circles)
      const ends = (e: number) => [edgeAt(diagram, e).start, edgeAt(diagram, e).end]
      path.edges.forEach((e, k) => {
        const before = path.edges[k - 1]
        if (before !== undefined) expect(ends(before).some((end) => ends(e).includes(end))).toBe(true)
      })
      expect(clearanceAlong(diagram, path)).toBeGreaterThanOrEqual(path.clearance - rounding)
      for (const [point, end] of [
        [path.entry, p],
        [path.exit, q],
      ] as const) {
        if (point === undefined) continue
        expect(leastDistance(circles, point)).toBeGreaterThanOrEqual(path.clearance - rounding)
        // The direction away from the nearest circle's center.
        const nearest = diagram.find(end.x, end.y)
        expect(signedDistance(circles, nearest, point)).toBeGreaterThanOrEqual(
          signedDistance(circles, nearest, end) - rounding,
        )
      }
      // A path without an entry comes from infinity.
      const [first, last] = [path.edges[0], path.edges.at(-1)]
      if (first === undefined || last === undefined) expect([path.entry, path.exit]).toEqual([undefined, undefined])
      else if (path.entry === undefined) expect(ends(first)).toContain(NONE)
      else if (path.exit === undefined) expect(ends(last)).toContain(NONE)
    }),
    { numRuns: 300 },
  )
})

it('along one edge is as clear in both directions', () => {
  const circles = [
    [0, 3, 2],
    [0, -3, 2],
  ]
  // No wider way leads around, because everything is within a wall.
  for (let k = -16; k <= 16; k++) circles.push([k / 2, 5.5, 0.2], [k / 2, -5.5, 0.2])
  for (let k = -10; k <= 10; k++) circles.push([-8, k / 2, 0.2], [8, k / 2, 0.2])
  const diagram = library.compute(circles)
  const [left, right] = [
    { x: -3, y: 0 },
    { x: 2, y: 0 },
  ]
  expect(clearestPath(diagram, left, right).clearance).toBeCloseTo(1, 12)
  expect(clearestPath(diagram, right, left).clearance).toBeCloseTo(1, 12)
  // Neither path makes a detour to an end of the edge.
  expect(clearestPath(diagram, { x: 1, y: 0 }, right).edges).toHaveLength(1)
  expect(clearestPath(diagram, right, { x: 1, y: 0 }).edges).toHaveLength(1)
})

it('goes through the wider gap', () => {
  // A ring of six circles with gaps of 1, except for two gaps of 1.5.
  const h = (5 * Math.sqrt(3)) / 2
  const circles = [
    [5, 0, 2],
    [2.5, h, 2],
    [-2.5, h, 2],
    [-5, 0, 1.5],
    [-2.5, -h, 2],
    [2.5, -h, 2],
  ].flat()
  const diagram = library.compute(Float64Array.from(circles))
  expect(clearestPath(diagram, { x: 0.1, y: 0 }, { x: 20, y: 0 }).clearance).toBeCloseTo(0.75, 12)
  // The outside is unbounded, so only the end points limit the clearance.
  const around = clearestPath(diagram, { x: 0, y: 20 }, { x: 0, y: -20 })
  expect(around.clearance).toBeCloseTo(Math.hypot(2.5, 20 - h) - 2, 12)
})

it('leads around a single circle by way of infinity', () => {
  const path = clearestPath(library.compute(Float64Array.of(0, 0, 1)), { x: 3, y: 0 }, { x: -4, y: 0 })
  expect(path).toEqual({ clearance: 2, edges: new Int32Array(0), entry: undefined, exit: undefined })
})

it('starts at a center as beside it, and goes straight to the right there', () => {
  const diagram = library.compute(Float64Array.of(0, 0, 1, 8, 0, 1, 0, 8, 1, -8, 0, 1, 0, -8, 1))
  const to = { x: 30, y: 1 }
  const [path, beside] = [clearestPath(diagram, { x: 0, y: 0 }, to), clearestPath(diagram, { x: 1e-9, y: 0 }, to)]
  expect([path.entry, path.edges, path.clearance]).toEqual([{ x: 4, y: 0 }, beside.edges, -1])
  // Squares of these lengths would be 0 or infinite.
  for (const p of [
    { x: -1e-300, y: 0 },
    { x: 0, y: 1e-160 },
  ]) {
    expect(clearestPath(diagram, p, to)).toEqual(path)
    expect(clearestPath(diagram, p, { x: 1e300, y: 1e299 })).toMatchObject({ entry: { x: 4, y: 0 }, clearance: -1 })
  }
  expect(clearestPath(diagram, { x: -1e300, y: 0 }, to).entry).toBeUndefined()
  expect(clearestPath(diagram, { x: 0, y: 4.5 }, { x: 1e200, y: 1e200 }).clearance).toBeCloseTo(2.5, 12)
})

it('ends among circles too small for squares', () => {
  const circles = Float64Array.of(0, 0, 0.1, 1, 0, 0.2, 0, 1, 0.3, 0.9, 0.9, 0.05).map((value) => 1e-16 * value)
  const diagram = library.compute(circles)
  const path = clearestPath(diagram, { x: 0, y: 0 }, { x: 1e-16, y: 1e-16 })
  expect(path.edges.length).toBeLessThanOrEqual(diagram.edges.length / 4)
})
