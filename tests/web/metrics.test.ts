// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it, vi } from 'vitest'
import { distanceFrom } from '../../web/lib/base/metric.ts'
import { ConvexPolygon, convexHull, type Diagram, outlineArea, type Point, vertexAt } from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { anyCircles, KINDS, unit } from './arbitrary-circles.ts'
import { errorOf } from './errors.ts'
import { library } from './library.ts'
import { boxAround, pointIn, scaleOf } from './oracle.ts'
import { tuple } from './tuples.ts'

const { compute, certify } = await loadMetrics({ library })

type Measured = Pick<Diagram, 'circles' | 'metric' | 'weights'>

function distanceTo({ circles, metric, weights }: Measured, i: number, { x, y }: Point): number {
  const [cx, cy, r] = tuple(circles, 3 * i, 3)
  const squared = (x - cx) ** 2 + (y - cy) ** 2
  if (metric === 'power') return squared - (weights ? r : r * r)
  return Math.sqrt(squared) - (metric === 'circles' ? r : 0)
}

function leastDistance(diagram: Measured, point: Point): number {
  let least = Number.POSITIVE_INFINITY
  for (let i = 0; i < diagram.circles.length / 3; i++) least = Math.min(least, distanceTo(diagram, i, point))
  return least
}

/** Circles, and whether their third numbers are weights, of which every other one is then below zero. */
const input = (circles: fc.Arbitrary<Float64Array>) =>
  fc.tuple(circles, fc.boolean()).map(([given, weights]) => ({
    circles: weights ? given.map((value, k) => (k % 6 === 5 ? -value : value)) : given,
    weights,
  }))

/** The arrays of a diagram, by which two have the same bits. */
function arraysOf({ circles, vertices, vertexCircles, edges, hidden, hull, nextSide }: Diagram) {
  return { circles, vertices, vertexCircles, edges, hidden, hull, nextSide }
}

function areas(diagram: Diagram, region: ConvexPolygon): number[] {
  return Array.from({ length: diagram.circles.length / 3 }, (_, i) =>
    outlineArea(diagram.cellOutline(i, { bounds: region })),
  )
}

describe.each(['circles', 'centers', 'power'] as const)('by %s', (metric) => {
  it('distances are those of the metric', () => {
    const diagram = compute(Float64Array.of(0, 0, 2, 9, 1, 1), { metric })
    const distance = { circles: 3, centers: 5, power: 21 }[metric]
    expect(distanceFrom(diagram, 0, 3, -4)).toBe(distance)
  })

  it('cells are of what is nearest, and fill a box', () => {
    fc.assert(
      fc.property(input(anyCircles), unit, unit, ({ circles, weights }, across, up) => {
        const diagram = compute(circles, { metric, weights })
        expect(diagram).toMatchObject({ metric, weights, certificate: { certified: true } })
        const region = ConvexPolygon.of(boxAround(circles, 0.2))
        const point = pointIn(region.box, across, up)
        const least = leastDistance(diagram, point)
        const size = scaleOf(circles) + Math.hypot(point.x, point.y)
        const rounding = 1e-13 * (metric === 'power' ? size * size : size)
        const found = diagram.find(point.x, point.y)
        expect(distanceTo(diagram, found, point) - least).toBeLessThanOrEqual(rounding)
        for (let i = 0; i < circles.length / 3; i++) {
          const lead = distanceTo(diagram, i, point) - least
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
      fc.property(input(KINDS.disjoint), ({ circles, weights }) => {
        const diagram = compute(circles, { metric, weights })
        for (let v = 0; v < diagram.vertices.length / 3; v++) {
          const { x, y, r: radius } = vertexAt(diagram, v)
          const least = leastDistance(diagram, { x, y })
          const size = scaleOf(circles) + Math.hypot(x, y)
          const expected = metric === 'power' ? Math.sign(radius) * radius * radius : radius
          // Nearly parallel edges meet far away, at inaccurate points.
          if (size > 1e4) continue
          for (const i of diagram.vertexCircles.subarray(3 * v, 3 * v + 3)) {
            expect(Math.abs(distanceTo(diagram, i, { x, y }) - least)).toBeLessThan(1e-9 * size * size)
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
        areas(compute(circles, { metric }), region),
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
    const diagram = compute(circles, { metric })
    expect(structuredClone(diagram)).toMatchObject({ metric, circles })
    expect(convexHull(diagram).arcs).toHaveLength(3)
  }
  expect(convexHull(compute(circles, { metric: 'power' })).area).toBeCloseTo(35, 12)
})

it('has rounded circles, and is computed by the library that is given', async () => {
  const circles = Float64Array.of(2 ** -97, 1, 2 ** -95)
  const given = { ...library, compute: vi.fn(library.compute) }
  const metrics = await loadMetrics({ library: given })
  for (const metric of ['circles', 'centers', 'power'] as const) {
    expect(metrics.compute(circles, { metric }).circles).toEqual(Float64Array.of(0, 1, 2 ** -95))
  }
  expect(given.compute).toHaveBeenCalledTimes(2)
  const weights = compute([[0, 1, 2 ** -190 + 2 ** -193]], { metric: 'power', weights: true })
  expect(weights.circles).toEqual(Float64Array.of(0, 1, 2 ** -190))
})

it('is the diagram of the library by the metric circles, with each of its options', () => {
  fc.assert(
    fc.property(input(anyCircles), fc.constantFrom('auto', 'flip', undefined), ({ circles, weights }, method) => {
      const expected = arraysOf(library.compute(circles, { weights, method }))
      expect(arraysOf(compute(circles, { metric: 'circles', weights, method }))).toEqual(expected)
      expect(arraysOf(compute(circles, { weights, method }))).toEqual(expected)
    }),
    { numRuns: 30 },
  )
})

it('takes data and functions, and is computed again after its circles were changed in place', () => {
  const data = [
    { at: 0, weight: -4 },
    { at: 10, weight: 20 },
  ]
  const options = { x: ({ at }: { at: number }) => at, y: () => 0, r: ({ weight }: { weight: number }) => weight }
  for (const metric of ['centers', 'power'] as const) {
    const diagram = compute(data, { ...options, metric, weights: true })
    const { circles } = diagram
    circles.set([10, 0, 20, 0, 0, -4])
    expect(diagram.update().find(3.9, 0)).toBe(metric === 'power' ? 0 : 1)
    expect(diagram.circles).toBe(circles)
    expect(arraysOf(diagram)).toEqual(arraysOf(compute(circles, { metric, weights: true })))
    circles[0] = Number.NaN
    expect(errorOf(() => diagram.update())).toMatchObject({ code: 'nonFinite', circle: 0 })
    expect(diagram.edges).toHaveLength(4)
  }
})

it('tells its progress, and ends where a callback throws', () => {
  const circles = Float64Array.of(0, 0, 3, 10, 0, 1, 4, 7, 0)
  for (const metric of ['centers', 'power'] as const) {
    const stages: string[] = []
    compute(circles, { metric, progress: (stage) => stages.push(stage) })
    expect(stages).toEqual(expect.arrayContaining(['order', 'triangulate', 'certify', 'assemble']))
    const mine = new RangeError('mine')
    const progress = () => {
      throw mine
    }
    expect(() => compute(circles, { metric, progress })).toThrow(mine)
  }
})

describe('diagrams from elsewhere', () => {
  it('have the certificate of those computed', () => {
    fc.assert(
      fc.property(input(anyCircles), fc.constantFrom('circles', 'centers', 'power'), ({ circles, weights }, metric) => {
        const { certificate, ...diagram } = compute(circles, { metric, weights })
        expect(certify(diagram)).toEqual(certificate)
      }),
      { numRuns: 60 },
    )
  })

  it('have the flaw of each wrong array', () => {
    // The last circle has no cell of the power diagram.
    const circles = Float64Array.of(0, 0, 3, 10, 0, 1, 4, 7, 0, 5, -8, 2, 4, 2, 1.5, 2, 1, 0.5)
    const right = { ...compute(circles, { metric: 'power' }) }
    expect([...right.hidden].slice(0, 1)).toEqual([5])
    expect(certify(right).message).toBe(right.certificate.message)
    const changed = <List extends Float64Array | Int32Array>(list: List, k: number, value: number) => {
      const copy = list.slice() as List
      copy[k] = value
      return copy
    }
    const vertices = changed(right.vertices, 0, (right.vertices[0] as number) + 1e-6)
    const radii = changed(right.vertices, 2, (right.vertices[2] as number) + 1e-6)
    const larger = changed(right.circles, 17, 5)
    const other = compute(changed(right.circles, 14, 0.1), { metric: 'power' })
    expect(certify({ ...right, vertices })).toMatchObject({ flaw: 'vertexMisplaced', vertex: 0 })
    expect(certify({ ...right, vertices: radii })).toMatchObject({ flaw: 'vertexMisplaced', vertex: 0 })
    expect(certify({ ...right, circles: larger })).toMatchObject({ flaw: 'hiddenWithoutHider', circle: 5 })
    expect(certify({ ...right, hidden: changed(right.hidden, 1, 5) })).toMatchObject({ certified: false })
    expect(certify({ ...other, circles: right.circles })).toMatchObject({ certified: false })
    expect(certify({ ...right, weights: true })).toMatchObject({ certified: false })
    expect(certify({ ...right, metric: 'circles' })).toMatchObject({ certified: false })
    const endless = changed(right.circles, 2, Number.NaN)
    expect(errorOf(() => certify({ ...right, circles: endless }))).toMatchObject({ code: 'nonFinite', circle: 0 })
  })
})

it('has its radical axis where the powers are equal', () => {
  const diagram = compute(
    [
      { x: 0, y: 0, r: 3 },
      { x: 10, y: 0, r: 1 },
    ],
    { metric: 'power' },
  )
  const box = { minX: 0, minY: 0, maxX: 10, maxY: 1 }
  expect(areas(diagram, ConvexPolygon.of(box)).map((part) => Math.round(part * 1e9) / 1e9)).toEqual([5.4, 4.6])
})

it('a circle that others cover may have no cell of the power diagram, and a center may lie outside its cell', () => {
  const between = compute(Float64Array.of(0, 0, 3, 2, 0, 0.1, 4, 0, 3), { metric: 'power' })
  expect(between.hidden[0]).toBe(1)
  expect(between.cell(1)).toBeUndefined()
  const outside = compute(Float64Array.of(0, 0, 3, 2, 0, 0.5), { metric: 'power' })
  expect(outside.contains(1, 2, 0)).toBe(false)
  expect(outside.cell(1)).toBeDefined()
})

it('says so when its module is another', async () => {
  const wasm = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0])
  await expect(loadMetrics({ library, wasm })).rejects.toMatchObject({ code: 'notLoaded' })
})
