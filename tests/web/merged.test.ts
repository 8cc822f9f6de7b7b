// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { type MergedDiagram, mergeVertices, NONE } from '../../web/lib/index.ts'
import { anyCircles } from './arbitrary-circles.ts'
import { library, seededRandom } from './library.ts'
import { signedDistance } from './oracle.ts'
import { tuple } from './tuples.ts'

function circlesAround({ firstCircle, circles }: MergedDiagram, v: number): number[] {
  return [...circles.subarray(firstCircle[v], firstCircle[v + 1])]
}

/** Circles around the origin, each at the same distance. */
const wheel = (count: number, r = 3) =>
  Array.from({ length: count }, (_, k) => {
    const turn = (2 * Math.PI * k) / count
    return { x: 100 * Math.cos(turn), y: 100 * Math.sin(turn), r }
  })

describe('mergeVertices', () => {
  it('makes one vertex of a square', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 0.5, 2, 0, 0.5, 2, 2, 0.5, 0, 2, 0.5))
    expect(diagram.vertices).toHaveLength(6)
    const merged = mergeVertices(diagram)
    expect(merged.vertices).toHaveLength(3)
    expect([...merged.vertices].map((value) => Math.round(value * 1e9) / 1e9)).toEqual([1, 1, 0.914213562])
    expect(circlesAround(merged, 0)).toEqual([0, 1, 2, 3])
    const edges = [0, 4, 8, 12].map((e) => [...merged.edges.subarray(e, e + 4)])
    const pairs = edges.map(([left = NONE, right = NONE]) => [left, right].sort().join()).sort()
    expect(pairs).toEqual(['0,1', '0,3', '1,2', '2,3'])
    for (const [, , ...ends] of edges) expect(ends.sort()).toEqual([NONE, 0])
    expect(merged.edges).toHaveLength(16)
    expect(merged.mergedVertex).toEqual(Int32Array.of(0, 0))
  })

  // Radii of almost the distance bring the vertex so near to the circles that only their size shows its rounding error.
  it.each([3, 99.9999999])('makes one vertex of many circles of radius %d around a point, in their turn', (r) => {
    const count = 40
    const order = Array.from({ length: count }, (_, k) => (7 * k) % count)
    const circles = wheel(count, r)
    const merged = mergeVertices(library.compute(order.map((k) => circles[k] as (typeof circles)[number])))
    expect(merged.vertices).toHaveLength(3)
    expect(circlesAround(merged, 0).map((i) => order[i])).toEqual(order.map((_, k) => k))
    expect(merged.edges).toHaveLength(4 * count)
  })

  it('makes one vertex of those alone that are the same to the bit, where nothing is near zero', () => {
    const diagram = library.compute(wheel(40))
    const places = Array.from({ length: diagram.vertices.length / 3 }, (_, v) =>
      diagram.vertices.slice(3 * v, 3 * v + 2),
    )
    const different = new Set(places.map(([x, y]) => `${x} ${y}`)).size
    expect(different).toBeGreaterThan(1)
    expect(mergeVertices(diagram, 0).vertices.length / 3).toBeGreaterThanOrEqual(different)
  })

  it('makes one vertex of them however they are numbered', () => {
    const random = seededRandom(2)
    for (let trial = 0; trial < 60; trial++) {
      const circles = wheel(64)
        .map((circle) => ({ ...circle, key: random() }))
        .sort((one, other) => one.key - other.key)
      expect(mergeVertices(library.compute(circles)).vertices).toHaveLength(3)
    }
  })

  it('does not depend on the order of the input', () => {
    const random = seededRandom(1)
    const grid = Array.from({ length: 36 }, (_, k) => ({ x: 3 * (k % 6), y: 3 * Math.floor(k / 6), r: 1 }))
    const cyclesOf = (circles: typeof grid, names: readonly number[]) => {
      const merged = mergeVertices(library.compute(circles))
      return Array.from({ length: merged.vertices.length / 3 }, (_, v) => {
        const cycle = circlesAround(merged, v).map((i) => names[i] as number)
        const start = cycle.indexOf(Math.min(...cycle))
        return [...cycle.slice(start), ...cycle.slice(0, start)].join()
      }).sort()
    }
    const names = grid.map((_, i) => i)
    const shuffled = names
      .map((i) => ({ i, key: random() }))
      .sort((one, other) => one.key - other.key)
      .map(({ i }) => i)
    const expected = cyclesOf(grid, names)
    expect(expected).toHaveLength(25)
    expect(
      cyclesOf(
        shuffled.map((i) => grid[i] as (typeof grid)[number]),
        shuffled,
      ),
    ).toEqual(expected)
  })

  it('keeps a vertex on all its circles, and Euler content', () => {
    fc.assert(
      fc.property(anyCircles, fc.constantFrom(undefined, 0, 1e-3, 1), (circles, nearZero) => {
        const diagram = library.compute(circles)
        const merged = mergeVertices(diagram, nearZero)
        const count = merged.vertices.length / 3
        const degrees = new Int32Array(count)
        for (let e = 0; e < merged.edges.length; e += 4) {
          for (const v of merged.edges.subarray(e + 2, e + 4)) {
            if (v !== NONE) degrees[v] = (degrees[v] as number) + 1
          }
        }
        // Every merged edge removes one vertex, unless it closes a loop.
        const lost = (diagram.edges.length - merged.edges.length) / 4
        expect(lost).toBeGreaterThanOrEqual(diagram.vertices.length / 3 - count)
        if (nearZero === undefined) expect(lost).toBe(diagram.vertices.length / 3 - count)
        const scale = circles.reduce((sum, value) => Math.max(sum, Math.abs(value)), 1)
        for (let v = 0; v < count; v++) {
          const [x, y, radius] = tuple(merged.vertices, 3 * v, 3)
          const around = circlesAround(merged, v)
          if ((nearZero ?? 0) === 0) expect(around).toHaveLength(degrees[v] as number)
          if ((nearZero ?? 0) > 0) continue
          for (const i of around) {
            const size = Math.max(scale, Math.abs(x), Math.abs(y), Math.abs(radius))
            expect(Math.abs(signedDistance(circles, i, { x, y }) - radius)).toBeLessThan(1e-9 * size)
          }
        }
        if (nearZero === 0) expect(merged.vertices.length).toBeLessThanOrEqual(diagram.vertices.length)
      }),
    )
  })
})
