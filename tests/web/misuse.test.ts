// SPDX-License-Identifier: GPL-3.0-or-later
// Misuse that JavaScript lets through causes one error sentence and no result.
import { describe, expect, it } from 'vitest'
import { loadComparison } from '../../web/lib/comparison.ts'
import {
  type Bounds,
  bisector,
  ConvexPolygon,
  clearestPath,
  clipCurve,
  Diagram,
  DiagramSnapshot,
  loadCircleVoronoi,
  mergeVertices,
  parameterAt,
  pointAt,
  polyline,
} from '../../web/lib/index.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { createWorker } from '../../web/lib/worker.ts'
import { errorOf } from './errors.ts'
import { library } from './library.ts'

const CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const diagram = library.compute(CIRCLES)
const { computeComparison } = await loadComparison({ library })
const power = computeComparison(CIRCLES, 'power')
/** Removes the types, as in a program without them. */
const d = diagram as unknown as Record<string, (...args: unknown[]) => unknown>
const l = library as unknown as Record<string, (...args: unknown[]) => unknown>
const editor = library.edit(CIRCLES)
const PENTAGRAM = [0, 2, 4, 1, 3].map((k) => ({
  x: Math.cos((2 * Math.PI * k) / 5),
  y: Math.sin((2 * Math.PI * k) / 5),
}))
const e = editor as unknown as Record<string, (...args: unknown[]) => unknown>
const untyped = (f: unknown) => f as (...args: unknown[]) => unknown
const box = { minX: 0, minY: 0, maxX: 9, maxY: 9 }
const texts = { minX: '0', minY: '0', maxX: '9', maxY: '9' }

/** The error code, the message, and the call. */
const MISUSE: readonly (readonly [code: string, says: string, act: () => unknown])[] = [
  ['badInput', 'find takes a number as x, not an object.', () => d.find?.({ x: 5, y: 1 })],
  ['badInput', 'find takes a number as x, not an array.', () => d.find?.([5, 1])],
  ['badInput', 'find takes a number as y, not undefined.', () => d.find?.(5)],
  [
    'badInput',
    'findAll takes two numbers for each point, but there are 3.',
    () => diagram.findAll(new Float64Array(3)),
  ],
  ['badInput', 'findAll takes a Float64Array of x and y for each point, not an object.', () => d.findAll?.({})],
  [
    'badInput',
    'findAll takes a number as a coordinate, not an array.',
    () =>
      d.findAll?.([
        [1, 2],
        [3, 4],
      ]),
  ],
  ['badInput', 'contains takes a number as x, not an object.', () => d.contains?.(0, { x: 1, y: 2 })],
  ['badInput', 'bisector takes two circles with different centers.', () => bisector(CIRCLES, 0, 0)],
  [
    'badInput',
    'bisector takes two circles with different centers.',
    () => bisector(Float64Array.of(1, 2, 3, 1, 2, 4), 0, 1),
  ],
  ['badInput', 'There is no metric "foo".', () => untyped(bisector)(CIRCLES, 0, 1, 'foo')],
  [
    'badInput',
    'bisector takes a Float64Array of x, y and r for each circle, not an array.',
    () => untyped(bisector)([0, 0, 1, 6, 0, 1], 0, 1),
  ],
  ...[0, -1, Number.POSITIVE_INFINITY, Number.NaN].map(
    (s) =>
      [
        'badInput',
        `pointAt takes a finite number above 0 as parameter, not ${s}.`,
        () => pointAt(bisector(CIRCLES, 0, 1), s),
      ] as const,
  ),
  [
    'badInput',
    'parameterAt takes a number as y, not undefined.',
    () => untyped(parameterAt)(bisector(CIRCLES, 0, 1), 3),
  ],
  ['badInput', 'mergeVertices takes a number as nearZero, not NaN.', () => mergeVertices(diagram, Number.NaN)],
  ['badInput', 'mergeVertices takes a number as nearZero, not "x".', () => untyped(mergeVertices)(diagram, 'x')],
  ['badInput', 'new Diagram takes a diagram, not undefined.', () => new Diagram(undefined as unknown as Diagram)],
  ['badInput', 'circles is no Float64Array of 3 numbers each.', () => l.finalCells?.(undefined, { box, maxRadius: 1 })],
  ['badInput', 'weights is not true or false, but "no".', () => l.certify?.({ ...diagram, weights: 'no' })],
  ['badInput', 'clipCurve takes a curve, not undefined.', () => untyped(clipCurve)(undefined, box)],
  ['badInput', 'polyline takes a curve, not undefined.', () => untyped(polyline)()],
  ['badInput', 'pointAt takes a bisector, not undefined.', () => untyped(pointAt)()],
  ['badInput', 'pointAt takes a bisector, not "x".', () => untyped(pointAt)('x', 1)],
  [
    'badInput',
    'clearestPath takes points { x, y } of finite numbers, not an array.',
    () => untyped(clearestPath)(diagram, [3, 0], [0, 4]),
  ],
  [
    'badInput',
    'clearestPath takes a diagram of one circle or more.',
    () => clearestPath(library.compute([]), { x: 3, y: 0 }, { x: 0, y: 4 }),
  ],
  [
    'badInput',
    'new DiagramSnapshot takes the numbers of an editor, not undefined.',
    () => new DiagramSnapshot({ ...diagram, numbers: undefined as never }),
  ],
  [
    'badInput',
    'The diagram is that of the editor after 0 changes; what is applied has to be the next one.',
    () => untyped(editor.snapshot().apply.bind(editor.snapshot()))(undefined),
  ],
  ['badInput', 'The new circle does not have three numbers x, y and r.', () => e.insert?.(1, 2, 3)],
  ['badInput', 'Circle 1 does not have three numbers x, y and r.', () => e.replace?.(1, { x: 1, y: 2 })],
  ['unknownCircle', 'There is no circle with id 0.5.', () => editor.remove(0.5)],
  ['badInput', 'nearest takes a number as x, not an object.', () => e.nearest?.({ x: 1, y: 2 })],
  ['badInput', 'apply takes a list of edits, not undefined.', () => e.apply?.()],
  [
    'badInput',
    'An edit has a kind, insert, remove or replace, not "move".',
    () => e.apply?.([{ kind: 'move', id: 0 }]),
  ],
  ['badInput', 'edit takes a diagram of the metric circles, not of power.', () => library.edit(power)],
  ['badInput', 'The circles are neither a typed array nor a list, but an object.', () => l.edit?.({})],
  [
    'badOption',
    'Bounds are a ConvexPolygon, or a box of four numbers: { minX, minY, maxX, maxY } or an array.',
    () => d.render?.({ bounds: texts }),
  ],
  [
    'badOption',
    'Bounds are a ConvexPolygon, or a box of four numbers: { minX, minY, maxX, maxY } or an array.',
    () => d.render?.({ bounds: [0, 0, 9] }),
  ],
  [
    'badOption',
    'Bounds are a ConvexPolygon, or a box of four numbers: { minX, minY, maxX, maxY } or an array.',
    () => {
      diagram.render({ bounds: [0, 0, 9, 9] })
      d.render?.({ bounds: [0, 0, 9, 9, 9] })
    },
  ],
  [
    'badOption',
    'The box is empty, or a coordinate is not finite, or beyond 1.2e30 (2^100).',
    () => diagram.render({ bounds: [0, 0, 0, 9] }),
  ],
  ['badOption', 'The polygon winds more than once, or has no area.', () => ConvexPolygon.from(PENTAGRAM)],
  [
    'badOption',
    'The tolerance is a finite number above 0, not Infinity.',
    () => diagram.render({ tolerance: Number.POSITIVE_INFINITY }),
  ],
  ['badOption', 'The corners of a polygon are an array of points, not undefined.', () => untyped(ConvexPolygon.from)()],
  [
    'badOption',
    'There is no option Method of compute; its options are weights, method, candidates, samples, resample, progress, x, y and r.',
    () => l.compute?.([], { Method: 'flip' }),
  ],
  ['badInput', 'The circles are neither a typed array nor a list, but 5.', () => l.compute?.(5)],
  ['badInput', 'The circles are neither a typed array nor a list, but "0,0,1".', () => l.compute?.('0,0,1')],
  [
    'badInput',
    `The circles are neither a typed array nor a list, but "${'0'.repeat(40)}…".`,
    () => l.compute?.('0'.repeat(41)),
  ],
  ['badInput', 'Three numbers per circle are needed, but there are 4.', () => library.compute(new Float32Array(4))],
  [
    'badInput',
    'Circle 1 does not have three numbers x, y and r.',
    () =>
      library.compute([
        [0, 0, 1],
        [5, 5],
      ]),
  ],
  ['badInput', 'Circle 0 does not have three numbers x, y and r.', () => l.compute?.([0, 0, 1])],
  ...[
    ['0', 0, 1],
    [0, '0', 1],
    [0, 0, '1'],
  ].map(
    (circle) => ['badInput', 'Circle 0 does not have three numbers x, y and r.', () => l.compute?.([circle])] as const,
  ),
]

describe('is refused with a sentence', () => {
  it.each(MISUSE)('%s: %s', (code, says, act) => {
    expect(errorOf(act)).toMatchObject({ code, message: says })
  })

  it('as a rejection of what loads', async () => {
    const refusal = expect.objectContaining({ name: 'CircleVoronoiError', code: 'badOption' })
    for (const options of [{ wasm: 5 }, { url: '' }, 'x']) {
      await expect(loadCircleVoronoi(options as object)).rejects.toThrow(refusal)
      await expect(loadComparison(options as object)).rejects.toThrow(refusal)
      await expect(loadRegions(options as object)).rejects.toThrow(refusal)
    }
    await expect(loadComparison({ library: 5 as never })).rejects.toThrow(refusal)
    using worker = createWorker()
    await expect(worker.compute(CIRCLES, { sample: 1 } as object)).rejects.toThrow(refusal)
    await expect(worker.compute(CIRCLES, { signal: 'now' } as object)).rejects.toThrow(refusal)
  })
})

describe('circles', () => {
  const lists: readonly (readonly [string, () => Parameters<typeof library.compute>[0]])[] = [
    ['a Float32Array', () => Float32Array.from(CIRCLES)],
    [
      'arrays',
      () => [
        [0, 0, 1],
        [6, 0, 1],
        [0, 8, 1],
      ],
    ],
    ['typed arrays', () => [CIRCLES.subarray(0, 3), CIRCLES.subarray(3, 6), CIRCLES.subarray(6)]],
    ['objects and arrays', () => [{ x: 0, y: 0, r: 1 }, [6, 0, 1], { x: 0, y: 8, r: 1 }]],
    [
      'a set',
      () =>
        new Set([
          [0, 0, 1],
          [6, 0, 1],
          [0, 8, 1],
        ]),
    ],
    [
      'a generator',
      function* () {
        yield* [
          [0, 0, 1],
          [6, 0, 1],
          [0, 8, 1],
        ]
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
    expect(() => library.compute(cities, { x: () => 1, y: () => 2, r: () => '3' as never })).toThrow(
      /^Circle 0 does not/,
    )
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
  expect(methods(power)).toEqual([])
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
