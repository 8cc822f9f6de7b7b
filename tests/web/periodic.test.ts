// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { type Lattice, PeriodicDiagram } from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { problemOf } from './errors.ts'
import { library, seededRandom } from './library.ts'

const { computePeriodic } = await loadMetrics({ library })

const METRICS = ['circles', 'centers', 'power'] as const
const BOX: Lattice = { a: [4, 0], b: [1, 3] }

function circles(count: number, seed: number, largest = 0.2): [number, number, number][] {
  const random = seededRandom(seed)
  return Array.from({ length: count }, () => {
    const [u, v] = [random(), random()]
    return [4 * u + v, 3 * v, largest * random()]
  })
}

/** The nearest image of a circle to a point, by exhaustive search. */
function nearestByTrying(given: readonly (readonly [number, number, number])[], x: number, y: number) {
  let best = { distance: Infinity, circle: -1, shift: [0, 0] as [number, number] }
  const l0 = Math.round(y / 3)
  const k0 = Math.round((x - l0) / 4)
  given.forEach(([cx, cy, r], circle) => {
    for (let k = k0 - 3; k <= k0 + 3; k++) {
      for (let l = l0 - 3; l <= l0 + 3; l++) {
        const distance = Math.hypot(cx + 4 * k + l - x, cy + 3 * l - y) - r
        if (distance < best.distance) best = { distance, circle, shift: [k, l] }
      }
    }
  })
  return { circle: best.circle, shift: best.shift }
}

describe('a periodic diagram', () => {
  it.each(METRICS)('has cells that fill the box, and neighbors from both sides, by %s', (metric) => {
    for (const count of [1, 2, 3, 10, 200]) {
      const periodic = computePeriodic(circles(count, count), BOX, { metric })
      expect(periodic.diagram.metric).toBe(metric)
      expect(periodic.circleCount).toBe(count)
      let area = 0
      const seen = new Map<string, number>()
      for (let i = 0; i < count; i++) {
        area += periodic.cellArea(i)
        for (const { circle, shift } of periodic.neighbors(i)) {
          const key = [i, circle, ...shift].join()
          seen.set(key, (seen.get(key) ?? 0) + 1)
        }
      }
      expect(Math.abs(area / 12 - 1)).toBeLessThan(1e-12)
      for (const [key, times] of seen) {
        const [i, j, k, l] = key.split(',').map(Number) as [number, number, number, number]
        expect(seen.get([j, i, -k + 0, -l + 0].join())).toBe(times)
      }
      const visible = Array.from({ length: count }, (_, i) => Number(periodic.cellArea(i) > 0))
      const isVisible = visible.reduce((sum, is) => sum + is, 0)
      expect([...seen.values()].reduce((sum, times) => sum + times, 0)).toBe(6 * isVisible)
    }
  })

  it('lets the circles stay that lie in the box', () => {
    const given = circles(50, 1)
    const { diagram, shiftOf } = library.computePeriodic(given, BOX)
    given.forEach(([x, y, r], i) => {
      expect(Math.abs(diagram.circles[3 * i] as number) - x).toBeCloseTo(0, 13)
      expect(diagram.circles[3 * i + 1]).toBeCloseTo(y, 13)
      expect(diagram.circles[3 * i + 2]).toBe(r)
      expect([...shiftOf.subarray(2 * i, 2 * i + 2)]).toEqual([0, 0])
    })
  })

  it('finds the nearest image of any point', () => {
    // Includes circles that were moved.
    const near = circles(40, 2)
    const far = near.map(([x, y, r], i) => [x + 4 * (i % 5) - (i % 3), y - 3 * (i % 3), r] as const)
    const random = seededRandom(3)
    for (const given of [near, far]) {
      const periodic = library.computePeriodic(given, BOX)
      for (let n = 0; n < 100; n++) {
        const [x, y] = [60 * random() - 30, 60 * random() - 30]
        const found = periodic.find(x, y)
        if (given === near) expect(found).toEqual(nearestByTrying(near, x, y))
        const { circle, shift } = found as { circle: number; shift: readonly [number, number] }
        const [cx, cy, r] = given[circle] as readonly [number, number, number]
        const own = Math.hypot(cx + 4 * shift[0] + shift[1] - x, cy + 3 * shift[1] - y) - r
        const [bx, by, br] = near[circle] as [number, number, number]
        const { shift: expected } = nearestByTrying(near, x, y)
        expect(own).toBeCloseTo(Math.hypot(bx + 4 * expected[0] + expected[1] - x, by + 3 * expected[1] - y) - br, 9)
      }
      expect(periodic.find(Number.NaN, 0)).toBeUndefined()
      expect(() => periodic.find(1e300, 0)).toThrow(expect.objectContaining({ code: 'badInput' }))
      // The image of a far point is the image of a near one, moved by as many periods.
      for (const [k, l] of [
        [1000, 0],
        [0, 1000],
        [-300, 700],
      ] as const) {
        const { circle, shift } = periodic.find(1.5, 0.5) as { circle: number; shift: readonly [number, number] }
        const moved = { circle, shift: [shift[0] + k, shift[1] + l] }
        expect(periodic.find(1.5 + 4 * k + l, 0.5 + 3 * l)).toEqual(moved)
      }
    }
    expect(library.computePeriodic([], BOX).find(0, 0)).toBeUndefined()
  })

  it('draws and measures whole cells', () => {
    const periodic = library.computePeriodic(circles(3, 5), BOX)
    for (let i = 0; i < 3; i++) {
      const polygon = periodic.cellPolygon(i) as [number, number][]
      let area = 0
      polygon.forEach(([x, y], k) => {
        const [nextX, nextY] = polygon[(k + 1) % polygon.length] as [number, number]
        area += (x * nextY - nextX * y) / 2
      })
      expect(area).toBeCloseTo(periodic.cellArea(i), 3)
      expect(periodic.cellPath(i)).toMatch(/^M.*Z$/)
      expect(periodic.cellPerimeter(i)).toBeGreaterThan(Math.sqrt(area))
      const { x, y } = periodic.cellCentroid(i) as { x: number; y: number }
      expect(periodic.contains(i, x, y)).toBe(true)
    }
  })

  it('has the contacts of a packing, also as CSV', () => {
    const periodic = library.computePeriodic(Float64Array.of(0, 0, 0.4, 1, 0, 0.4), { a: [2, 0], b: [0, 1] })
    const { contacts, lengths, gaps, areas, packingFractions } = periodic.contacts()
    expect([...areas].map((area) => area.toFixed(12))).toEqual(['1.000000000000', '1.000000000000'])
    for (const fraction of packingFractions) expect(fraction).toBeCloseTo(Math.PI * 0.16, 12)
    const long = [...lengths.keys()].filter((k) => (lengths[k] as number) > 0.5)
    expect(long.map((k) => (gaps[k] as number).toFixed(9))).toEqual(Array(8).fill('0.200000000'))
    const found = long.map((k) => [...contacts.subarray(4 * k, 4 * k + 4)].join()).sort()
    expect(found.join(' ')).toBe('0,0,0,-1 0,0,0,1 0,1,-1,0 0,1,0,0 1,0,0,0 1,0,1,0 1,1,0,-1 1,1,0,1')
    const [header, ...lines] = periodic.contactsCsv().trimEnd().split('\n') as [string, ...string[]]
    expect(header).toBe('circle,neighbor,shift_a,shift_b,length,gap,area,packing_fraction')
    expect(lines).toHaveLength(lengths.length)
    expect(lines[0]?.split(',').map(Number)).toEqual([
      ...contacts.subarray(0, 4),
      lengths[0],
      gaps[0],
      areas[0],
      packingFractions[0],
    ])
  })

  it('knows what overlapping circles cover', () => {
    // The disc covers its whole cell, which is as large as the box.
    const { packingFractions } = library.computePeriodic([[0.5, 0.5, 2]], { a: [1, 0], b: [0, 1] }).contacts()
    expect([...packingFractions]).toEqual([1])
  })

  it('has one contact for two borders with the same image, and none of a hidden circle', () => {
    const given = [
      [15, 20, 4],
      [25, 20, 4],
      [20, 20, 0.5],
      [15, 20, 1],
    ]
    const periodic = library.computePeriodic(given as [number, number, number][], { a: [40, 0], b: [0, 40] })
    expect(periodic.neighbors(0).filter(({ circle, shift }) => `${circle} ${shift}` === '1 0,0')).toHaveLength(2)
    const { contacts, lengths, gaps, areas, packingFractions } = periodic.contacts()
    const keys = Array.from(lengths, (_, k) => contacts.subarray(4 * k, 4 * k + 4).join())
    expect(new Set(keys).size).toBe(keys.length)
    expect(gaps[keys.indexOf('0,1,0,0')]).toBe(2)
    for (let i = 0; i < 4; i++) {
      const sum = lengths.filter((_, k) => contacts[4 * k] === i).reduce((partial, length) => partial + length, 0)
      expect(sum).toBeCloseTo(periodic.cellPerimeter(i), 9)
      const r = i === 3 ? 0 : (given[i]?.[2] as number)
      expect(packingFractions[i]).toBeCloseTo(i === 3 ? 0 : (Math.PI * r * r) / (areas[i] as number), 12)
    }
    expect(areas[3]).toBe(0)
    // Two discs of radius 4 at distance 6 cover a lens twice.
    const overlapping = library
      .computePeriodic(Float64Array.of(0, 0, 4, 6, 0, 4), { a: [40, 0], b: [0, 40] })
      .contacts()
    const half = 16 * Math.PI - (16 * Math.acos(0.75) - 3 * Math.sqrt(7))
    for (const fraction of overlapping.packingFractions) expect(fraction).toBeCloseTo(half / 800, 9)
  })

  it('survives a structured clone', () => {
    const periodic = library.computePeriodic(circles(5, 6), BOX)
    const { diagram, circleCount, lattice, circleOf, shiftOf } = periodic
    const clone = new PeriodicDiagram(
      structuredClone({ diagram: { ...diagram }, circleCount, lattice, circleOf, shiftOf }),
    )
    expect(clone.neighbors(0)).toEqual(periodic.neighbors(0))
    expect(clone.find(3, 4)).toEqual(periodic.find(3, 4))
  })

  it('has periods that are finite and not parallel', () => {
    const wrong = (lattice: Lattice) => problemOf(() => library.computePeriodic([[0, 0, 1]], lattice))
    expect(wrong({ a: [1, 0], b: [-2, 0] })).toMatch(/^badOption: The periods must not be zero or parallel/)
    expect(wrong({ a: [1, 0], b: [0, Infinity] })).toMatch(/^badOption: The periods must be finite/)
  })
})
