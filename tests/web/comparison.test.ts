// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it, vi } from 'vitest'
import { distanceFrom } from '../../web/lib/base/metric.ts'
import { loadComparison } from '../../web/lib/comparison.ts'
import {
  ConvexPolygon,
  convexHull,
  type Diagram,
  type Metric,
  outlineArea,
  type Point,
  vertexAt,
} from '../../web/lib/index.ts'
import { anyCircles, KINDS, unit } from './arbitrary-circles.ts'
import { library } from './library.ts'
import { boxAround, pointIn, scaleOf } from './oracle.ts'
import { tuple } from './tuples.ts'

const { computeComparison } = await loadComparison({ library })

function distanceTo(circles: Float64Array, i: number, { x, y }: Point, metric: Metric): number {
  const [cx, cy, r] = tuple(circles, 3 * i, 3)
  const squared = (x - cx) ** 2 + (y - cy) ** 2
  return metric === 'power' ? squared - r * r : Math.sqrt(squared) - (metric === 'circles' ? r : 0)
}

function leastDistance(circles: Float64Array, point: Point, metric: Metric): number {
  let least = Number.POSITIVE_INFINITY
  for (let i = 0; i < circles.length / 3; i++) least = Math.min(least, distanceTo(circles, i, point, metric))
  return least
}

function areas(diagram: Diagram, region: ConvexPolygon): number[] {
  return Array.from({ length: diagram.circles.length / 3 }, (_, i) =>
    outlineArea(diagram.cellOutline(i, { bounds: region })),
  )
}

describe.each(['circles', 'centers', 'power'] as const)('by %s', (metric) => {
  it('distances are those of the metric', () => {
    const diagram = computeComparison(Float64Array.of(0, 0, 2, 9, 1, 1), metric)
    const distance = { circles: 3, centers: 5, power: 21 }[metric]
    expect(distanceFrom(diagram, 0, 3, -4)).toBe(distance)
  })

  it('cells are of what is nearest, and fill a box', () => {
    fc.assert(
      fc.property(anyCircles, unit, unit, (circles, across, up) => {
        const diagram = computeComparison(circles, metric)
        const region = ConvexPolygon.of(boxAround(circles, 0.2))
        const point = pointIn(region.box, across, up)
        const least = leastDistance(circles, point, metric)
        const size = scaleOf(circles) + Math.hypot(point.x, point.y)
        const rounding = 1e-13 * (metric === 'power' ? size * size : size)
        const found = diagram.find(point.x, point.y)
        expect(distanceTo(circles, found, point, metric) - least).toBeLessThanOrEqual(rounding)
        for (let i = 0; i < circles.length / 3; i++) {
          const lead = distanceTo(circles, i, point, metric) - least
          if (diagram.contains(i, point.x, point.y)) expect(lead).toBeLessThanOrEqual(rounding)
          else if (diagram.cell(i) !== undefined) expect(lead).toBeGreaterThanOrEqual(-rounding)
        }
        const sum = areas(diagram, region).reduce((partial, part) => partial + part, 0)
        expect(Math.abs(sum / region.area() - 1)).toBeLessThan(1e-9)
      }),
      { numRuns: 200 },
    )
  })

  it('vertices are at the same distance from their three circles, and none is nearer', () => {
    fc.assert(
      fc.property(KINDS.disjoint, (circles) => {
        const diagram = computeComparison(circles, metric)
        for (let v = 0; v < diagram.vertices.length / 3; v++) {
          const { x, y, r: radius } = vertexAt(diagram, v)
          const least = leastDistance(circles, { x, y }, metric)
          const size = scaleOf(circles) + Math.hypot(x, y)
          const expected = metric === 'power' ? Math.sign(radius) * radius * radius : radius
          // Nearly parallel edges meet far away, at inaccurate points.
          if (size > 1e4) continue
          for (const i of diagram.vertexCircles.subarray(3 * v, 3 * v + 3)) {
            expect(Math.abs(distanceTo(circles, i, { x, y }, metric) - least)).toBeLessThan(1e-9 * size * size)
          }
          expect(Math.abs(expected - least)).toBeLessThan(1e-9 * size * size)
        }
      }),
    )
  })
})

it('is the same by all three for equal radii', () => {
  fc.assert(
    fc.property(KINDS.equalRadii, (circles) => {
      const region = ConvexPolygon.of(boxAround(circles, 0.1))
      const [expected, ...others] = (['circles', 'centers', 'power'] as const).map((metric) =>
        areas(computeComparison(circles, metric), region),
      ) as [number[], number[], number[]]
      for (const other of others) {
        other.forEach((part, i) => {
          expect(Math.abs(part - (expected[i] as number))).toBeLessThan(1e-9 * region.area())
        })
      }
    }),
  )
})

it('keeps the circles and the metric, and so do clones', () => {
  const circles = Float64Array.of(0, 0, 3, 10, 0, 1, 4, 7, 0)
  for (const metric of ['circles', 'centers', 'power'] as const) {
    const diagram = computeComparison(circles, metric)
    expect(structuredClone(diagram)).toMatchObject({ metric, circles })
    expect(convexHull(diagram).arcs).toHaveLength(3)
  }
  expect(convexHull(computeComparison(circles, 'power')).area).toBeCloseTo(35, 12)
})

it('has rounded circles, and is computed by the library that is given', async () => {
  const circles = Float64Array.of(2 ** -97, 1, 2 ** -95)
  const compute = vi.fn(library.compute)
  const { computeComparison } = await loadComparison({ library: { ...library, compute } })
  for (const metric of ['circles', 'centers', 'power'] as const) {
    expect(computeComparison(circles, metric).circles).toEqual(Float64Array.of(0, 1, 2 ** -95))
  }
  expect(compute).toHaveBeenCalledTimes(2)
})

it('has its radical axis where the powers are equal', () => {
  const diagram = computeComparison(
    [
      { x: 0, y: 0, r: 3 },
      { x: 10, y: 0, r: 1 },
    ],
    'power',
  )
  const box = { minX: 0, minY: 0, maxX: 10, maxY: 1 }
  expect(areas(diagram, ConvexPolygon.of(box)).map((part) => Math.round(part * 1e9) / 1e9)).toEqual([5.4, 4.6])
})

it('a circle that others cover may have no cell of the power diagram, and a center may lie outside its cell', () => {
  const between = computeComparison(Float64Array.of(0, 0, 3, 2, 0, 0.1, 4, 0, 3), 'power')
  expect(between.hidden[0]).toBe(1)
  expect(between.cell(1)).toBeUndefined()
  const outside = computeComparison(Float64Array.of(0, 0, 3, 2, 0, 0.5), 'power')
  expect(outside.contains(1, 2, 0)).toBe(false)
  expect(outside.cell(1)).toBeDefined()
})

it('says so when its module is another', async () => {
  const wasm = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0])
  await expect(loadComparison({ library, wasm })).rejects.toMatchObject({ code: 'notLoaded' })
})
