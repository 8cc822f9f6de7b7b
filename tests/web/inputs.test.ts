// SPDX-License-Identifier: GPL-3.0-or-later
// The forms in which a program may give circles, bounds and points, and diagrams that change in place.
import { describe, expect, it } from 'vitest'
import { type Bounds, ConvexPolygon, Diagram } from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { library } from './library.ts'

const CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const ROWS = [0, 3, 6].map((k) => [...CIRCLES.subarray(k, k + 3)])
const diagram = library.compute(CIRCLES)
const { compute } = await loadMetrics({ library })
const power = compute(CIRCLES, { metric: 'power' })
const editor = library.edit(CIRCLES)

describe('circles', () => {
  const lists: readonly (readonly [string, () => Parameters<typeof library.compute>[0]])[] = [
    ['a Float32Array', () => Float32Array.from(CIRCLES)],
    ['arrays', () => ROWS],
    ['typed arrays', () => [CIRCLES.subarray(0, 3), CIRCLES.subarray(3, 6), CIRCLES.subarray(6)]],
    ['objects and arrays', () => [{ x: 0, y: 0, r: 1 }, [6, 0, 1], { x: 0, y: 8, r: 1 }]],
    ['a set', () => new Set(ROWS)],
    [
      'a generator',
      function* () {
        yield* ROWS
      },
    ],
  ]
  it.each(lists)('may be %s', (_, circles) => {
    expect(library.compute(circles())).toMatchObject({ circles: CIRCLES, vertices: diagram.vertices })
    expect(library.compute(circles()).edges).toEqual(diagram.edges)
  })

  it('are those of data as it is while three functions go through it', () => {
    const data = [1, 2, 3, 4, 5, 6]
    const found = library.compute(data, {
      x(x, i) {
        if (i === 1) data.length = 3
        return 9 * x
      },
      y: () => 0,
      r: () => 1,
    })
    expect([...found.circles]).toEqual([9, 0, 1, 18, 0, 1, 27, 0, 1])
  })

  it('may be found in data by three functions', () => {
    const cities = [
      { name: 'a', at: [0, 0], size: 1 },
      { name: 'b', at: [6, 0], size: 1 },
      { name: 'c', at: [0, 8], size: 1 },
    ] as const
    const seen: unknown[] = []
    const found = library.compute(cities, {
      x(city, i, all) {
        seen.push([city.name, i, all])
        return city.at[0]
      },
      y(city, i, all) {
        seen.push([city.name, i, all])
        return city.at[1]
      },
      r(city, i, all) {
        seen.push([city.name, i, all])
        return city.size
      },
      method: 'flip',
    })
    expect(found).toMatchObject({ circles: CIRCLES, vertices: diagram.vertices, stats: { method: 'flip' } })
    expect(seen).toEqual(cities.flatMap(({ name }, i) => Array(3).fill([name, i, cities])))
  })

  it('may be found by as many functions as data need', () => {
    const points = [
      { x: 0, y: 0 },
      { x: 6, y: 0 },
      { x: 0, y: 8 },
    ]
    expect(library.compute(points, { r: () => 1 }).vertices).toEqual(diagram.vertices)
    const doubled = library.compute(
      CIRCLES.map((value) => 2 * value),
      { x: (_, i) => i, y: () => 0, r: () => 0 },
    )
    expect(doubled.circles.filter((_, k) => k % 3 === 0)).toEqual(Float64Array.from({ length: 9 }, (_, i) => i))
    const box = { a: [20, 0], b: [0, 20] } as const
    const { diagram: one, ...images } = library.computePeriodic(points, box, { r: () => 1 })
    const { diagram: same, ...its } = library.computePeriodic(CIRCLES, box)
    expect([one.vertices, images]).toEqual([same.vertices, its])
  })
})

it('bounds are those of each call, whatever they were before', () => {
  const one = library.compute([[0, 0, 1]])
  const areaIn = (bounds: Bounds) => one.cellArea(0, { bounds })
  expect(areaIn([-9, -9, 9, 9])).toBe(324)
  for (const k of [0, 1, 2, 3]) {
    const sides = [-9, -9, 9, 9].with(k, 0) as [number, number, number, number]
    expect(areaIn(sides)).toBe(162)
    expect(areaIn([-9, -9, 9, 9])).toBe(324)
    expect(one.cellArea(0, { bounds: sides, maxDistance: 99 })).toBe(162)
    expect(areaIn([-9, -9, 9, 9])).toBe(324)
  }
  const corners = [
    { x: -9, y: -9 },
    { x: 9, y: -9 },
    { x: -9, y: 9 },
  ]
  expect(areaIn(ConvexPolygon.from(corners))).toBe(162)
  expect(areaIn([-9, -9, 9, 9])).toBe(324)
  expect(areaIn({ minX: -9, minY: -9, maxX: 9, maxY: 0 })).toBe(162)
})

it('points may be any list of numbers', () => {
  for (const points of [Float64Array.of(5, 1, 1, 7), Float32Array.of(5, 1, 1, 7), [5, 1, 1, 7]]) {
    expect(diagram.findAll(points)).toEqual(Int32Array.of(1, 2))
  }
})

it('a diagram has the methods of its kind', () => {
  const methods = (value: Diagram) => ['update', 'apply', 'indexOf'].filter((name) => name in value)
  expect(methods(diagram)).toEqual(['update'])
  expect(methods(editor.snapshot())).toEqual(['apply', 'indexOf'])
  expect(methods(power)).toEqual(['update'])
  expect(methods(new Diagram(structuredClone(diagram)))).toEqual([])
  expect(diagram).toBeInstanceOf(Diagram)
  expect(editor.snapshot()).toBeInstanceOf(Diagram)
})

describe('update', () => {
  it('computes the diagram of circles that were moved in place', () => {
    const moving = library.compute(CIRCLES)
    expect(moving.find(3.5, 0)).toBe(1)
    expect(moving.halfedges).toHaveLength(3)
    expect(moving.cell(1)?.neighbors).toHaveLength(2)
    moving.circles.set([20, 3], 3)
    expect(moving.update()).toBe(moving)
    const fresh = library.compute(moving.circles)
    expect(moving.vertices).toEqual(fresh.vertices)
    expect(moving.halfedges).toEqual(fresh.halfedges)
    expect(Array.from(CIRCLES, (_, i) => moving.cell(i))).toEqual(Array.from(CIRCLES, (_, i) => fresh.cell(i)))
    expect(moving.find(3.5, 0)).toBe(0)
    expect(moving.render()).toBe(fresh.render())
  })

  it('leaves the diagram as it was if the circles are refused', () => {
    const moving = library.compute(CIRCLES)
    moving.circles[5] = -1
    expect(() => moving.update()).toThrow(expect.objectContaining({ code: 'negativeRadius', circle: 1 }))
    expect(moving.vertices).toEqual(diagram.vertices)
    expect(moving.certificate.certified).toBe(true)
  })
})

describe('arrays that keep their memory', () => {
  const shared = (numbers: ArrayLike<number>) => {
    const list = new Float64Array(new SharedArrayBuffer(8 * numbers.length))
    list.set(numbers)
    return list as unknown as Float64Array<ArrayBuffer>
  }

  it('are empty lists of no circles', () => {
    for (const none of [new Float64Array(), new Float64Array(new ArrayBuffer(8), 8), shared([])]) {
      expect(library.compute(none).circles).toHaveLength(0)
    }
  })

  it('may be shared between threads, or begin inside a buffer', () => {
    expect(library.compute(shared(CIRCLES)).vertices).toEqual(diagram.vertices)
    expect(library.compute(Float64Array.of(7, ...CIRCLES, 7).subarray(1, 10)).vertices).toEqual(diagram.vertices)
    expect(diagram.findAll(shared([1, 1, 6, 1]))).toEqual(Int32Array.of(0, 1))
  })
})
