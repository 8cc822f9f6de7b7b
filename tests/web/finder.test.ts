// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { Finder } from '../../web/lib/diagram/finder.ts'
import { NONE } from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { disjointCircles } from './disjoint-circles.ts'
import { library, seededRandom } from './library.ts'
import { boxAround, leastDistance, pointIn, signedDistance } from './oracle.ts'

describe('find', () => {
  it('finds one of many, within one and far outside', () => {
    const circles = disjointCircles(20_000, seededRandom(3))
    const diagram = library.compute(circles)
    const random = seededRandom(4)
    for (const share of [0, 0.5, 1000]) {
      const box = boxAround(circles, share)
      for (let k = 0; k < 100; k++) {
        const point = pointIn(box, random(), random())
        const least = leastDistance(circles, point)
        const rounding = 1e-13 * Math.hypot(point.x, point.y)
        expect(signedDistance(circles, diagram.find(point.x, point.y), point) - least).toBeLessThanOrEqual(rounding)
      }
    }
  })

  // A higher power concentrates most of the neighbors in one direction.
  it.each([1, 3, 8])('finds the way around a circle with a thousand neighbors: %d', (power) => {
    const random = seededRandom(9)
    const circles = new Float64Array(3 * 1001)
    circles.set([5, 7, 100])
    for (let i = 1; i <= 1000; i++) {
      const turn = 2 * Math.PI * random() ** power
      circles.set([5 + 102 * Math.cos(turn), 7 + 102 * Math.sin(turn), 0.01], 3 * i)
    }
    const diagram = library.compute(circles)
    expect(diagram.neighbors(0).length).toBeGreaterThan(200)
    const box = boxAround(circles, 0.2)
    for (let k = 0; k < 2000; k++) {
      const point = pointIn(box, random(), random())
      // Starts at the large circle, or at the nearest known one.
      for (const found of [diagram.find(point.x, point.y), diagram.find(point.x, point.y, 0)]) {
        expect(signedDistance(circles, found, point) - leastDistance(circles, point)).toBeLessThanOrEqual(1e-12)
      }
    }
  })

  it('finds the nearest center where all weights are the same and far below zero', () => {
    const random = seededRandom(5)
    const weight = -1e15
    const circles = Float64Array.from({ length: 600 }, (_, k) => (k % 3 === 2 ? weight : 10 * random()))
    const centers = circles.map((value, k) => (k % 3 === 2 ? 0 : value))
    const diagram = library.compute(circles, { weights: true })
    for (let k = 0; k < 2000; k++) {
      const point = { x: 10 * random(), y: 10 * random() }
      const found = diagram.find(point.x, point.y)
      expect(signedDistance(centers, found, point) - leastDistance(centers, point)).toBeLessThanOrEqual(1e-13)
    }
  })

  it.each([
    ['one circle', [0, 0, 1]],
    ['two circles', [0, 0, 1, 9, 0, 1]],
    ['a column', [0, 0, 1, 0, 9, 1, 0, 20, 3, 0, 33, 0]],
    ['one that hides all others', [0, 0, 9, 1, 1, 1, 2, 2, 2]],
  ])('works for %s', (_, numbers) => {
    const circles = Float64Array.from(numbers)
    const diagram = library.compute(circles)
    for (let k = 0; k < 50; k++) {
      const point = { x: 7 * Math.cos(k), y: k - 9 }
      expect(signedDistance(circles, diagram.find(point.x, point.y), point)).toBe(leastDistance(circles, point))
    }
  })

  // Only the circles of few ranks around some places keep their sides, and a walk cannot continue without sides.
  it.each([0, 1])('takes few steps among many circles on a line along axis %s', (axis) => {
    const [count, period, few] = [20_000, 100, 4]
    const circles = Float64Array.from({ length: 3 * count }, (_, k) =>
      k % 3 === 2 ? 0.25 : k % 3 === axis ? Math.floor(k / 3) : 7030,
    )
    const { cells } = library.compute(circles)
    const finder = new Finder(cells)
    cells.diagram.firstSide.forEach((_, i, firstSide) => {
      if (Math.abs((i % period) - period / 2) > few) (firstSide as Int32Array)[i] = NONE
    })
    for (let i = period / 2; i < count; i += period) {
      const [along, across] = [i + 0.25, 7030.5]
      expect(axis === 0 ? finder.find(along, across) : finder.find(across, along)).toBe(i)
    }
  })

  it('finds what an edit puts between a circle and its many neighbors', () => {
    const around = Array.from({ length: 60 }, (_, k) => {
      const turn = (2 * Math.PI * k) / 60
      return { x: 10 * Math.cos(turn), y: 10 * Math.sin(turn), r: 0.1 }
    })
    const editor = library.edit([{ x: 0, y: 0, r: 1 }, ...around])
    const diagram = editor.snapshot()
    expect(diagram.find(4, 3, 0)).toBe(0)
    const turn = 0.05
    const between = { x: 8 * Math.cos(turn), y: 8 * Math.sin(turn), r: 0.1 }
    diagram.apply(editor.insert(between))
    expect(diagram.find(between.x, between.y, 0)).toBe(61)
    expect(diagram.neighbors(0).length).toBeGreaterThan(24)
    diagram.apply(editor.remove(61))
    expect(diagram.find(between.x, between.y, 0)).toBeLessThan(61)
    editor.dispose()
  })

  it.each([1, 3, 8])('finds the way around a circle whose many neighbors are edited between searches: %d', (power) => {
    const random = seededRandom(11)
    const rim = () => {
      const turn = 2 * Math.PI * random() ** power
      return { x: 5 + 102 * Math.cos(turn), y: 7 + 102 * Math.sin(turn), r: 0.01 }
    }
    const editor = library.edit([{ x: 5, y: 7, r: 100 }, ...Array.from({ length: 300 }, rim)])
    const diagram = editor.snapshot()
    const ids = Array.from({ length: 300 }, (_, k) => k + 1)
    for (let k = 0; k < 1200; k++) {
      const place = Math.floor(random() * ids.length)
      const id = ids[place] as number
      const kind = random()
      // At first there are more insertions, at last more removals, until few neighbors are left.
      if (kind < 0.2) diagram.apply(editor.replace(id, rim()))
      else if (kind < 0.6 === k < 500) {
        const change = editor.insert(rim())
        diagram.apply(change)
        ids.push(change.inserted[0] as number)
      } else if (ids.length > 3) {
        diagram.apply(editor.remove(id))
        ids.splice(place, 1)
      }
      const { x, y } = rim()
      for (const share of [0.5, 0.99, 1, 1.01]) {
        const point = { x: 5 + share * (x - 5), y: 7 + share * (y - 7) }
        const hub = diagram.indexOf(0)
        for (const found of [diagram.find(point.x, point.y), diagram.find(point.x, point.y, hub)]) {
          const excess = signedDistance(diagram.circles, found, point) - leastDistance(diagram.circles, point)
          expect(excess).toBeLessThanOrEqual(1e-12)
        }
      }
    }
    editor.dispose()
  })

  it('finds the way around a circle that lies outside of its cell with many sides', async () => {
    const { compute } = await loadMetrics({ library })
    const random = seededRandom(7)
    const points = Array.from({ length: 300 }, () => {
      const turn = 2 * Math.PI * random()
      return { x: 12 * Math.cos(turn), y: 12 * Math.sin(turn) }
    })
    points.unshift({ x: 0, y: 0 })
    // These circles have the cells of the points.
    const circles = Float64Array.from(points.flatMap(({ x, y }) => [x + 20, y, Math.sqrt(40 * x + 500)]))
    const diagram = compute(circles, { metric: 'power' })
    expect(diagram.contains(0, 20, 0)).toBe(false)
    const centers = Float64Array.from(points.flatMap(({ x, y }) => [x, y, 0]))
    for (let k = 0; k < 2000; k++) {
      const point = { x: 30 * random() - 15, y: 30 * random() - 15 }
      for (const hint of [NONE, 0]) {
        const found = diagram.find(point.x, point.y, hint)
        expect(signedDistance(centers, found, point) - leastDistance(centers, point)).toBeLessThanOrEqual(1e-12)
      }
    }
  })

  it('finds the only circle that an edit leaves visible', () => {
    const editor = library.edit([
      { x: 0, y: 0, r: 1 },
      { x: 90, y: 0, r: 1 },
    ])
    const diagram = editor.snapshot()
    expect(diagram.find(1, 0)).toBe(0)
    diagram.apply(editor.replace(1, { x: 90, y: 0, r: 99 }))
    expect(diagram.find(1, 0)).toBe(1)
    editor.dispose()
  })

  it('finds nothing where there is nothing, or no place', () => {
    expect(library.compute([]).find(0, 0)).toBe(NONE)
    const diagram = library.compute(Float64Array.of(0, 0, 1))
    for (const [x, y] of [
      [Number.NaN, 0],
      [0, Number.NEGATIVE_INFINITY],
    ] as const) {
      expect(diagram.find(x, y)).toBe(NONE)
    }
  })

  it('does not mind a hint that is no circle, or a hidden one', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 5, 1, 0, 1, 20, 0, 1))
    for (const hint of [-1, 99, 1, Number.NaN, 0.5]) expect(diagram.find(1, 0, hint)).toBe(0)
  })
})

describe('findAll', () => {
  it('is find of each', () => {
    const circles = disjointCircles(500, seededRandom(6))
    const diagram = library.compute(circles)
    const random = seededRandom(7)
    const points = Float64Array.from({ length: 2000 }, () => 400 * random() - 100)
    points[100] = Number.NaN
    const found = diagram.findAll(points)
    expect(found).toHaveLength(1000)
    expect(found).toEqual(
      Int32Array.from({ length: 1000 }, (_, k) => diagram.find(points[2 * k] as number, points[2 * k + 1] as number)),
    )
    expect(diagram.findAll(new Float64Array(0))).toHaveLength(0)
  })
})
