// SPDX-License-Identifier: GPL-3.0-or-later
// Circles a power of two times as large have the same diagram and geometry, bit for bit, times that power: from the
// smallest to the largest inputs that `compute` takes.
import { describe, expect, it } from 'vitest'
import { rounded } from '../../web/lib/base/coordinate-limits.ts'
import { powerOfTwoIn, unitFor } from '../../web/lib/base/scale.ts'
import {
  type Box,
  clearestPath,
  clipCurve,
  closestPair,
  convexHull,
  cubicBeziers,
  type Diagram,
  edgeCurve,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscCenteredInHull,
  largestEmptyDiscInside,
  type Metric,
  mergeVertices,
  outlineArea,
  outlineCentroid,
  outlinePerimeter,
  type Point,
  pointAt,
  polyline,
} from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { exportBox } from '../../web/lib/regions/export-box.ts'
import { curveLength } from '../../web/lib/regions/measure.ts'
import { library, seededRandom } from './library.ts'

const metrics = await loadMetrics({ library })

type Sides = [number, number, number, number]

/** Results with their dimension: 0 for a number, 1 for a length, 2 for an area. */
class Measures {
  readonly numbers: [dimension: number, value: number][] = []

  add(dimension: number, ...values: number[]): void {
    for (const value of values) this.numbers.push([dimension, value])
  }

  addPoint({ x, y }: Point): void {
    this.add(1, x, y)
  }
}

function addCurves(all: Measures, diagram: Diagram, box: Box, tolerance: number): void {
  for (let e = 0; e < diagram.edges.length / 4; e++) {
    const curve = edgeCurve(diagram, e)
    all.add(0, curve.from, curve.to)
    all.addPoint(pointAt(curve.bisector, 3))
    for (const piece of clipCurve(curve, { bounds: box })) {
      all.addPoint(piece.start)
      all.add(1, curveLength(piece))
      polyline(piece, tolerance).forEach((p) => {
        all.addPoint(p)
      })
      cubicBeziers(piece, tolerance).forEach(({ control1 }) => {
        all.addPoint(control1)
      })
    }
  }
}

function addCells(all: Measures, diagram: Diagram, box: Box): void {
  for (let i = 0; i < diagram.circles.length / 3; i++) {
    const parts = diagram.cellOutline(i, { bounds: box })
    parts.flat().forEach(({ curve }) => {
      all.addPoint(curve.start)
    })
    all.add(2, outlineArea(parts))
    all.add(1, outlinePerimeter(parts))
    all.addPoint(outlineCentroid(parts))
    all.add(0, diagram.cellPath(i, { bounds: box }).length > 0 ? 1 : 0)
    for (const share of [0.1, 0.4, 0.45, 0.8]) {
      const x = box.minX + share * (box.maxX - box.minX)
      const y = box.minY + share * share * (box.maxY - box.minY)
      all.add(0, Number(diagram.contains(i, x, y)), diagram.find(x, y, i))
    }
  }
}

function addQueries(all: Measures, diagram: Diagram, box: Box): void {
  const { arcs, length, area } = convexHull(diagram)
  all.add(1, length)
  all.add(2, area)
  for (const { start, angle } of arcs) {
    all.addPoint(start)
    all.add(0, angle)
  }
  all.add(1, closestPair(diagram)?.gap ?? 0)
  const discs = [
    largestEmptyDiscCenteredIn(diagram, { bounds: box }),
    largestEmptyDiscCenteredInHull(diagram),
    largestEmptyDiscInside(diagram, { bounds: box }),
  ]
  for (const found of discs) {
    if (found === undefined) throw new Error('There is no disc.')
    all.addPoint(found.disc)
    all.add(1, found.disc.r)
    all.add(0, ...found.circles)
  }
  const path = clearestPath(diagram, { x: box.minX, y: box.minY }, { x: box.maxX, y: box.maxY / 2 })
  all.add(1, path.clearance)
  all.add(0, ...path.edges, ...mergeVertices(diagram).edges)
  all.add(1, exportBox(diagram.circles).maxX)
}

function measure(circles: Float64Array, metric: Metric, scale: number) {
  const diagram = metrics.compute(
    circles.map((value) => value * scale),
    { metric },
  )
  const box = { minX: -0.25 * scale, minY: -0.5 * scale, maxX: scale, maxY: 0.75 * scale }
  const all = new Measures()
  addCurves(all, diagram, box, 2 ** -13 * scale)
  addCells(all, diagram, box)
  if (metric === 'circles') addQueries(all, diagram, box)
  return all.numbers
}

/** Numbers with few bits, which the smallest scale still represents exactly. */
function coarseCircles(radius: number): Float64Array {
  const random = seededRandom(11)
  return new Float64Array(60).map((_, k) => Math.round(4096 * (k % 3 === 2 ? radius : 1) * random()) / 4096)
}

// The largest number is about 1, so that it is at the limits of inputs.
describe.each([-55, -30, 30, 60, 96])('2^%d times as large', (exponent) => {
  const times = (value: number, dimension: number) =>
    Array.from({ length: dimension }).reduce<number>((product) => product * 2 ** exponent, value)

  it.each(['circles', 'centers', 'power'] as const)('all is as large, by the metric %s', (metric) => {
    for (const radius of [0.1, 0.4]) {
      const circles = coarseCircles(radius)
      const expected = measure(circles, metric, 1)
      const found = measure(circles, metric, 2 ** exponent)
      expect(found.length).toBe(expected.length)
      const wrong = found.findIndex(([dimension, value], k) => {
        return value !== times(expected[k]?.[1] as number, dimension)
      })
      expect(wrong).toBe(-1)
    }
  })
})

it('the unit of a size is 1 unless products of sizes could overflow, and for no size', () => {
  expect([1, 2 ** 199, 2 ** -1074, 0, Number.POSITIVE_INFINITY, Number.NaN].map(unitFor)).toEqual([1, 1, 1, 1, 1, 1])
  expect([1.5 * 2 ** 200, 1.5 * 2 ** 876].map(unitFor)).toEqual([2 ** 200, 2 ** 876])
})

describe('the cells of circles with anything between their sizes', () => {
  it.each([1, 1e-10, 1e-17, 1e-22, 1e-28])('fill every box: %d', (small) => {
    for (const large of [1, 1e-15, 1e10, 1e28]) {
      if (small >= large && small !== 1) continue
      for (const circles of [
        [0, 0, 0, small, 0, 0, 0, large, 0],
        [0, 0, 0.25 * small, small, 0, 0.5 * small, 0, large, 0.1 * large],
        [0, 0, 0, small, small, 0.5 * small, 0.5 * large, large, 0, -large, 0.25 * large, 0.5 * large],
      ]) {
        const diagram = library.compute(Float64Array.from(circles))
        for (const size of [small, large, Math.sqrt(small) * Math.sqrt(large)]) {
          const [minX, minY, maxX, maxY] = [-1.5, -1.25, 1.75, 2].map((share) => rounded(share * size)) as Sides
          if (!(minX < maxX && minY < maxY)) continue
          let sum = 0
          for (let i = 0; i < circles.length / 3; i++)
            sum +=
              outlineArea(diagram.cellOutline(i, { bounds: [minX, minY, maxX, maxY] })) / (maxX - minX) / (maxY - minY)
          expect(Math.abs(sum - 1)).toBeLessThan(1e-9)
        }
      }
    }
  })
})

it('the unit of a length is the largest power of two that is not above it', () => {
  for (const [size, power] of [
    [1, 1],
    [2 - 2 ** -52, 1],
    [3, 2],
    [0.75, 0.5],
    [1e300, 2 ** 996],
  ] as const) {
    expect(powerOfTwoIn(size)).toBe(power)
  }
})
