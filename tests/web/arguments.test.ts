// SPDX-License-Identifier: GPL-3.0-or-later
// Each function names itself, the argument and the allowed options in the error about a wrong argument.
import { describe, expect, it, vi } from 'vitest'
import { loadComparison } from '../../web/lib/comparison.ts'
import { loadFiles } from '../../web/lib/files.ts'
import {
  bisector,
  circleAt,
  clearestPath,
  clipCurve,
  closestPair,
  convexHull,
  cubicBeziers,
  type Diagram,
  DiagramSnapshot,
  edgeAt,
  edgeCurve,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscCenteredInHull,
  largestEmptyDiscInside,
  loadCircleVoronoi,
  mergeVertices,
  outlineArea,
  outlineCentroid,
  outlinePerimeter,
  PeriodicDiagram,
  parameterAt,
  pointAt,
  polyline,
  rationalBezier,
  SvgPath,
  traceArc,
  vertexAt,
} from '../../web/lib/index.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { EditorClient } from '../../web/lib/threads/editor-client.ts'
import { createWorker } from '../../web/lib/worker.ts'
import { useThreads } from './fake-threads.ts'
import { library } from './library.ts'

vi.mock('../../web/lib/threads/thread.ts', () => import('./fake-threads.ts'))

type Act = (...args: unknown[]) => unknown
type Methods = Readonly<Record<string, Act>>

/** Removes the types of methods, as in a program without them. */
const untyped = (value: object) => value as unknown as Methods
const bound = (value: object, name: string): Act => (untyped(value)[name] as Act).bind(value)
/** The methods of a value by their names. */
const methods = (value: object, names: readonly string[]) => names.map((name) => [name, bound(value, name)] as const)

const CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const BOX = [-5, -5, 10, 10] as const
const diagram = library.compute(CIRCLES)
const { computeComparison } = await loadComparison({ library })
const power = computeComparison(CIRCLES, 'power')
const periodic = library.computePeriodic(CIRCLES, { a: [9, 0], b: [0, 9] })
const IMAGES = periodic.circleOf.length
const editor = library.edit(CIRCLES)
const trace = library.trace(CIRCLES)
const regions = await loadRegions()
const region = regions.region([
  [
    [0, 0],
    [9, 0],
    [0, 9],
  ],
])
const files = await loadFiles()
useThreads(() => ({ post() {}, keepAlive() {}, terminate() {} }))
const client = new EditorClient({} as never, false, () => {})
const worker = createWorker()
const curve = edgeCurve(diagram, 0)
const [arc] = clipCurve(curve, { bounds: BOX })

/** The message of the error that a call throws or rejects with. */
async function messageOf(act: () => unknown): Promise<string> {
  try {
    await act()
  } catch (error) {
    expect(error).toMatchObject({ name: 'CircleVoronoiError', code: expect.stringMatching(/^bad(Input|Option)$/) })
    return (error as Error).message
  }
  return 'There was no error.'
}

const CIRCLE = 'the index of a circle'
const EDGE = 'the index of an edge'
const ID = 'the id of a circle'

/** Calls with right arguments, and the names of those that are numbers. */
const NUMBERS: readonly (readonly [name: string, act: Act, args: readonly unknown[], names: readonly string[]])[] = [
  ...methods(diagram, ['cell', 'neighbors', 'cellPath', 'cellPolygon', 'cellOutline']).map(
    ([name, act]) => [name, act, [0], [CIRCLE]] as const,
  ),
  ...methods(diagram, ['cellArea', 'cellCentroid', 'cellPerimeter']).map(
    ([name, act]) => [name, act, [0], [CIRCLE]] as const,
  ),
  ['edgePath', bound(diagram, 'edgePath'), [0], [EDGE]],
  ['contains', bound(diagram, 'contains'), [0, 1, 1], [CIRCLE, 'x', 'y']],
  ['find', bound(diagram, 'find'), [1, 1, 0], ['x', 'y', 'hint']],
  ...methods(periodic, ['neighbors', 'cellPath', 'cellPolygon', 'cellArea', 'cellCentroid', 'cellPerimeter']).map(
    ([name, act]) => [name, act, [0], [CIRCLE]] as const,
  ),
  ['contains', bound(periodic, 'contains'), [0, 1, 1], [CIRCLE, 'x', 'y']],
  ['find', bound(periodic, 'find'), [1, 1], ['x', 'y']],
  ['imageFrom', bound(periodic, 'imageFrom'), [0, 1], [CIRCLE, CIRCLE]],
  ...[editor, client].flatMap(
    (edited) =>
      [
        ['insert', bound(edited, 'insert'), [[0, 0, 1], 0], ['', 'hint']],
        ['remove', bound(edited, 'remove'), [0], [ID]],
        ['replace', bound(edited, 'replace'), [0, [0, 0, 1]], [ID]],
        ['nearest', bound(edited, 'nearest'), [1, 1, 0], ['x', 'y', 'hint']],
        ['circle', bound(edited, 'circle'), [0], [ID]],
        ['isHidden', bound(edited, 'isHidden'), [0], [ID]],
        ['apply', (id: unknown) => bound(edited, 'apply')([{ kind: 'insert', circle: [0, 0, 1], id }]), [0], [ID]],
        ['apply', (id: unknown) => bound(edited, 'apply')([{ kind: 'remove', id }]), [0], [ID]],
        ['apply', (id: unknown) => bound(edited, 'apply')([{ kind: 'replace', id, circle: [0, 0, 1] }]), [0], [ID]],
      ] as const,
  ),
  ['indexOf', bound(editor.snapshot(), 'indexOf'), [0], [ID]],
  ['event', bound(trace, 'event'), [0], ['the index of an event']],
  ['at', bound(trace, 'at'), [0], ['the number of events']],
  ['circleAt', circleAt as Act, [CIRCLES, 0], ['', CIRCLE]],
  ['vertexAt', vertexAt as Act, [diagram, 0], ['', 'the index of a vertex']],
  ['edgeAt', edgeAt as Act, [diagram, 0], ['', EDGE]],
  ['edgeCurve', edgeCurve as Act, [diagram, 0], ['', EDGE]],
  ['bisector', bisector as Act, [CIRCLES, 0, 1], ['', CIRCLE, CIRCLE]],
  ['parameterAt', parameterAt as Act, [curve.bisector, 1, 1], ['', 'x', 'y']],
  ['cubicBeziers', cubicBeziers as Act, [arc, 1], ['', 'tolerance']],
  ['polyline', polyline as Act, [arc, 1], ['', 'tolerance']],
  ['traceArc', traceArc as Act, [new SvgPath(), arc, 1], ['', '', 'tolerance']],
  ['mergeVertices', mergeVertices as Act, [diagram, 1], ['', 'nearZero']],
  ['contains', bound(region, 'contains'), [1, 1], ['x', 'y']],
]

describe('a text in place of a number', () => {
  it.each(NUMBERS)('%s', async (name, act, args, names) => {
    for (const [k, argument] of names.entries()) {
      if (argument === '') continue
      expect(await messageOf(() => act(...args.with(k, '0')))).toBe(`${name} takes a number as ${argument}, not "0".`)
    }
  })
})

/** Functions of an index, the kind of thing that it counts, and how many of them there are. */
const INDICES: readonly (readonly [name: string, act: (index: number) => unknown, thing: string, count: number])[] = [
  ...methods(diagram, ['neighbors', 'contains', 'cellPath', 'cellPolygon', 'cellOutline', 'cellArea']).map(
    ([name, act]) => [name, act, 'circle', 3] as const,
  ),
  ...methods(diagram, ['cellCentroid', 'cellPerimeter']).map(([name, act]) => [name, act, 'circle', 3] as const),
  ['edgePath', bound(diagram, 'edgePath'), 'edge', 3],
  ...methods(periodic, ['neighbors', 'contains', 'cellPath', 'cellPolygon', 'cellArea', 'cellCentroid']).map(
    ([name, act]) => [name, act, 'circle', 3] as const,
  ),
  ['cellPerimeter', bound(periodic, 'cellPerimeter'), 'circle', 3],
  ['imageFrom', (i) => periodic.imageFrom(i, 0), 'circle', IMAGES],
  ['imageFrom', (i) => periodic.imageFrom(0, i), 'circle', IMAGES],
  ['circleAt', (i) => circleAt(CIRCLES, i), 'circle', 3],
  ['bisector', (i) => bisector(CIRCLES, i, 0), 'circle', 3],
  ['bisector', (i) => bisector(CIRCLES, 0, i), 'circle', 3],
  ['vertexAt', (v) => vertexAt(diagram, v), 'vertex', 1],
  ['edgeAt', (e) => edgeAt(diagram, e), 'edge', 3],
  ['edgeCurve', (e) => edgeCurve(diagram, e), 'edge', 3],
]

describe('an index out of range', () => {
  it.each(INDICES)('%s', async (name, act, thing, count) => {
    for (const index of [count, -1, 0.5]) {
      expect(await messageOf(() => act(index))).toBe(
        `${name}: there is no ${thing} ${index}; the diagram has ${count}.`,
      )
    }
  })
})

const BOUNDED = 'bounds, region'
const BOUNDS = `${BOUNDED} and maxDistance`
const DRAWING = 'context, bounds, region, maxDistance, tolerance and digits'
const COMPUTING = 'weights, method, candidates, samples, resample, progress'
const READING = 'name, weights, points, x, y, radius, id and skipInvalid'
const FITTING = 'region, lattice, shares, tolerance, maxSteps, relax, weights, onStep and signal'
const P = { x: 3, y: 0 }
const LATTICE = { a: [9, 0], b: [0, 9] } as const

type Limit = (options: object, of?: Diagram) => unknown

/** Methods that take the limits of cells. */
const LIMITED: readonly (readonly [name: string, act: Limit, options: string])[] = [
  ['neighbors', (options, of = diagram) => of.neighbors(0, options), BOUNDS],
  ['cellOutline', (options, of = diagram) => of.cellOutline(0, options), BOUNDS],
  ['cellArea', (options, of = diagram) => of.cellArea(0, options), BOUNDS],
  ['cellCentroid', (options, of = diagram) => of.cellCentroid(0, options), BOUNDS],
  ['cellPerimeter', (options, of = diagram) => of.cellPerimeter(0, options), BOUNDS],
  ['cellAreas', (options, of = diagram) => of.cellAreas(options), BOUNDS],
  ['cellCentroids', (options, of = diagram) => of.cellCentroids(options), BOUNDS],
  ['cellPerimeters', (options, of = diagram) => of.cellPerimeters(options), BOUNDS],
  ['edgePath', (options, of = diagram) => of.edgePath(0, options), DRAWING],
  ['cellPath', (options, of = diagram) => of.cellPath(0, options), DRAWING],
  ['render', (options, of = diagram) => of.render(options), DRAWING],
  ['renderBounds', (options, of = diagram) => of.renderBounds(options), DRAWING],
  ['cellPolygon', (options, of = diagram) => of.cellPolygon(0, options), `${BOUNDED}, maxDistance and tolerance`],
  ['cellPolygon', (options, of = diagram) => of.cellPolygons(options).next(), `${BOUNDED}, maxDistance and tolerance`],
]

/** Queries that take bounds or a region. */
const QUERIES = [
  ['clearestPath', (options: object) => clearestPath(diagram, P, P, options as never), 'bounds and region'],
  ['largestEmptyDiscCenteredIn', (o: object) => largestEmptyDiscCenteredIn(diagram, o as never), 'bounds and region'],
  ['largestEmptyDiscInside', (o: object) => largestEmptyDiscInside(diagram, o as never), 'bounds and region'],
] as const

/** Functions of options, and a list of the options. */
const OPTIONS: readonly (readonly [name: string, act: (options: object) => unknown, options: string])[] = [
  ...LIMITED,
  ...QUERIES,
  ['renderCircles', (options) => diagram.renderCircles(options), 'context and digits'],
  ['renderDual', (options) => diagram.renderDual(options), 'context and digits'],
  ['renderHull', (options) => diagram.renderHull(options), 'context, digits, region and tolerance'],
  ['hullPolygon', (options) => diagram.hullPolygon(options), 'region and tolerance'],
  ['cellPath', (options) => periodic.cellPath(0, options), DRAWING],
  ['cellPolygon', (options) => periodic.cellPolygon(0, options), `${BOUNDED}, maxDistance and tolerance`],
  ['compute', (options) => library.compute(CIRCLES, options), `${COMPUTING}, x, y and r`],
  ['computePeriodic', (o) => library.computePeriodic(CIRCLES, LATTICE, o), `${COMPUTING}, x, y and r`],
  ['trace', (options) => library.trace(CIRCLES, options), `${COMPUTING} and edits`],
  ['edit', (options) => library.edit(CIRCLES, options), 'weights, ids and nextId'],
  ['compute', (options) => worker.compute(CIRCLES, options), `${COMPUTING}, signal, x, y and r`],
  ['computePeriodic', (o) => worker.computePeriodic(CIRCLES, LATTICE, o), `${COMPUTING}, signal, x, y and r`],
  ['edit', (options) => worker.edit(CIRCLES, options), 'weights, ids and nextId'],
  ['fitAreas', (options) => regions.fitAreas([[1, 1]], [1], options as never), FITTING],
  ['fitAreas', (options) => worker.fitAreas([[1, 1]], [1], options as never), FITTING],
  ['writeCircles', (options) => files.writeCircles(CIRCLES, options), 'format and attributes'],
  [
    'writeDiagram',
    (options) => files.writeDiagram(diagram, options),
    'format, bounds, region, maxDistance, tolerance, digits and attributes',
  ],
  ['readCircles', (options) => files.readCircles('', options), READING],
  ['readCircleFile', (options) => files.readCircleFile('', options), READING],
  ['loadComparison', loadComparison, 'wasm and library'],
]

/** Functions of one option. */
const ONE_OPTION: readonly (readonly [name: string, act: (options: object) => unknown, option: string])[] = [
  ['clipCurve', (options) => clipCurve(curve, options as never), 'bounds'],
  ['region', (options) => regions.region([], options), 'dissolve'],
  ['readDiagram', (options) => files.readDiagram('', options), 'name'],
  ['readDiagramFile', (options) => files.readDiagramFile('', options), 'name'],
  ['loadCircleVoronoi', loadCircleVoronoi, 'wasm'],
  ['loadRegions', loadRegions, 'wasm'],
  ['loadFiles', loadFiles, 'wasm'],
  ['createWorker', createWorker, 'wasm'],
]

describe('an unknown option', () => {
  it.each(OPTIONS)('%s', async (name, act, options) => {
    expect(await messageOf(() => act({ foo: 1 }))).toBe(
      `There is no option foo of ${name}; its options are ${options}.`,
    )
  })

  it.each(ONE_OPTION)('%s', async (name, act, option) => {
    expect(await messageOf(() => act({ foo: 1 }))).toBe(`There is no option foo of ${name}; its only one is ${option}.`)
  })

  it.each([
    ['cell', (options: object) => bound(diagram, 'cell')(0, options)],
    ['contains', (options: object) => bound(diagram, 'contains')(0, 1, 1, options)],
    ['findAll', (options: object) => bound(diagram, 'findAll')([1, 1], options)],
    ['neighbors', (options: object) => bound(periodic, 'neighbors')(0, options)],
    ['find', (options: object) => bound(periodic, 'find')(1, 1, options)],
    ['contains', (options: object) => bound(periodic, 'contains')(0, 1, 1, options)],
    ['cellArea', (options: object) => bound(periodic, 'cellArea')(0, options)],
    ['cellCentroid', (options: object) => bound(periodic, 'cellCentroid')(0, options)],
    ['cellPerimeter', (options: object) => bound(periodic, 'cellPerimeter')(0, options)],
    ['contacts', (options: object) => bound(periodic, 'contacts')(options)],
    ['certify', (options: object) => bound(library, 'certify')(diagram, options)],
    ...[closestPair, convexHull, largestEmptyDiscCenteredInHull].map(
      (query) => [query.name, (options: object) => (query as Act)(diagram, options)] as const,
    ),
  ] as const)('%s, which has none', async (name, act) => {
    expect(await messageOf(() => act({ foo: undefined, bounds: BOX }))).toBe(
      `There is no option bounds of ${name}, which has none.`,
    )
    expect(await messageOf(() => act({ foo: undefined }))).toBe('There was no error.')
  })

  it('is ignored if it is undefined', async () => {
    for (const [, act] of [...LIMITED, ...QUERIES]) {
      expect(await messageOf(() => act({ bounds: BOX, foo: undefined }))).toBe('There was no error.')
    }
  })
})

it.each([...OPTIONS, ...ONE_OPTION])('options that are no object: %s', async (name, act) => {
  for (const options of [null, [], 'x', 5]) {
    expect(await messageOf(() => act(options as never))).toBe(`The options of ${name} are not an object.`)
  }
})

describe('limits of cells', () => {
  it.each([...LIMITED, ...QUERIES])('of %s are a region of this library, or bounds', async (name, act) => {
    expect(await messageOf(() => act({ region: [] }))).toBe(
      `The region of ${name} is made by loadRegions().region, not an array.`,
    )
    expect(await messageOf(() => act({ region, bounds: BOX }))).toBe(`${name} takes bounds or a region, not both.`)
    expect(await messageOf(() => act({ bounds: 5 }))).toBe(
      'Bounds are a ConvexPolygon, or a box of four numbers: { minX, minY, maxX, maxY } or an array.',
    )
  })

  it('are a box with an area, up to a limit', async () => {
    for (const box of [
      [0, 0, 9, 0],
      [0, 0, 0, 9],
      [9, 0, 0, 9],
      [0, 9, 9, 0],
      [0, 0, 9, Number.NaN],
      [0, 0, 9, 2 ** 101],
      [-(2 ** 101), 0, 9, 9],
    ] as const) {
      const [minX, minY, maxX, maxY] = box
      for (const bounds of [box, { minX, minY, maxX, maxY }]) {
        expect(await messageOf(() => diagram.render({ bounds }))).toBe(
          'The box is empty, or a coordinate is not finite, or beyond 1.2e30 (2^100).',
        )
      }
    }
    expect(diagram.renderBounds({ bounds: [0, 0, 2 ** 100, 2 ** 100], digits: 0 })).toMatch(/^M0,0L/)
  })

  it.each(['renderHull', 'hullPolygon'])('of %s are a region', async (name) => {
    expect(await messageOf(() => bound(diagram, name)({ region: 5 }))).toBe(
      `The region of ${name} is made by loadRegions().region, not 5.`,
    )
  })

  it.each(LIMITED)('of %s have a distance', async (_, act) => {
    for (const limits of [{}, { region }, { bounds: BOX }]) {
      expect(await messageOf(() => act({ ...limits, maxDistance: '1' }))).toBe(
        'The maximum distance is a number up to 1.2e30 (2^100), not "1".',
      )
    }
  })

  it.each(LIMITED)('of %s of a power diagram have no distance', async (name, act) => {
    for (const limits of [{}, { region }, { bounds: BOX }]) {
      expect(await messageOf(() => act({ ...limits, maxDistance: 1 }, power))).toBe(
        `${name} takes no maximum distance of a power diagram, which has no distances.`,
      )
    }
  })

  it.each(OPTIONS.filter(([, , options]) => options.startsWith('context')))(
    'and a context of %s are options',
    async (name, act) => {
      expect(await messageOf(() => act(new SvgPath()))).toBe(`What ${name} draws on is an option: { context }.`)
      expect(await messageOf(() => act({ context: {} }))).toBe('The context is nothing to draw on, but an object.')
      expect(await messageOf(() => act({ digits: -1 }))).toBe('The number of digits is a whole number from 0, not -1.')
    },
  )

  it.each(OPTIONS.filter(([, , options]) => options.includes('tolerance') && !options.includes('shares')))(
    'of %s are drawn within a tolerance',
    async (name, act) => {
      const format = name === 'writeDiagram' ? { format: 'svg' } : {}
      for (const limits of name === 'renderHull' ? [{ region }] : [{}, { region }]) {
        expect(await messageOf(() => act({ ...format, ...limits, tolerance: 0 }))).toBe(
          'The tolerance is a finite number above 0, not 0.',
        )
      }
    },
  )
})

describe('a value that is no diagram', () => {
  it.each(Object.entries({ closestPair, convexHull, edgeAt, edgeCurve, mergeVertices, vertexAt }))(
    'of %s',
    async (name, act) => {
      expect(await messageOf(() => (act as Act)({}))).toBe(`${name} takes a diagram, not an object.`)
    },
  )

  it.each(
    Object.entries({
      clearestPath,
      largestEmptyDiscCenteredIn,
      largestEmptyDiscCenteredInHull,
      largestEmptyDiscInside,
    }),
  )('of %s', async (name, act) => {
    const says = `${name} takes a Diagram, not an object; new Diagram(data) makes one of plain data.`
    expect(await messageOf(() => (act as Act)({ ...diagram }))).toBe(says)
  })

  it.each(
    Object.entries({
      clearestPath: [P, P],
      closestPair: [],
      largestEmptyDiscCenteredIn: [{ bounds: BOX }],
      largestEmptyDiscCenteredInHull: [],
      largestEmptyDiscInside: [{ bounds: BOX }],
    }),
  )('of circles for %s', async (name, args) => {
    const queries = {
      clearestPath,
      closestPair,
      largestEmptyDiscCenteredIn,
      largestEmptyDiscCenteredInHull,
      largestEmptyDiscInside,
    }
    expect(await messageOf(() => bound(queries, name)(power, ...args))).toBe(
      `${name} takes a diagram of the metric circles, not of power.`,
    )
  })

  it('of an editor for new DiagramSnapshot, nor of a box for new PeriodicDiagram', async () => {
    expect(await messageOf(() => new DiagramSnapshot(diagram as never))).toBe(
      'new DiagramSnapshot takes a snapshot of an editor, not an object.',
    )
    expect(await messageOf(() => new PeriodicDiagram(diagram as never))).toBe(
      'new PeriodicDiagram takes the data of a periodic diagram, not an object.',
    )
  })

  it.each(Object.entries({ outlineArea, outlineCentroid, outlinePerimeter }))(
    'nor an outline of %s',
    async (name, act) => {
      for (const [outline, said] of [
        [5, '5'],
        [[5], 'an array'],
        [undefined, 'undefined'],
      ]) {
        expect(await messageOf(() => (act as Act)(outline))).toBe(
          `${name} takes an outline, a list of closed loops, not ${said}.`,
        )
      }
    },
  )
})

describe('a part of an input', () => {
  it.each(Object.entries({ circleAt, bisector }))('of %s is an array of circles', async (name, act) => {
    expect(await messageOf(() => (act as Act)([0, 0, 1], 0, 0))).toBe(
      `${name} takes a Float64Array of x, y and r for each circle, not an array.`,
    )
    expect(await messageOf(() => (act as Act)(new Float64Array(4), 0, 0))).toBe(
      `${name} takes three numbers for each circle, but there are 4.`,
    )
  })

  it.each(Object.entries({ pointAt, parameterAt }))('of %s is a bisector', async (name, act) => {
    expect(await messageOf(() => (act as Act)(curve, 1, 1))).toBe(`${name} takes a bisector, not an object.`)
  })

  it.each(Object.entries({ clipCurve, rationalBezier, cubicBeziers, polyline }))(
    'of %s is a curve',
    async (name, act) => {
      expect(await messageOf(() => (act as Act)({}, 1))).toBe(`${name} takes a curve, not an object.`)
    },
  )

  it.each([
    ...Object.entries({ rationalBezier, cubicBeziers, polyline }),
    ['traceArc', (...args: unknown[]) => (traceArc as Act)(new SvgPath(), ...args)] as const,
  ])('of %s is a bounded curve', async (name, act) => {
    const says = `${name} takes a curve with two ends; clipCurve makes some of one that goes to infinity.`
    for (const end of ['start', 'end']) {
      expect(await messageOf(() => (act as Act)({ ...arc, [end]: undefined }, 1))).toBe(says)
    }
  })

  it.each(Object.entries({ cubicBeziers, polyline }))('of %s is a tolerance', async (name, act) => {
    expect(await messageOf(() => (act as Act)(arc, Number.NaN))).toBe(`${name} takes a number as tolerance, not NaN.`)
  })

  it('of clearestPath is a pair of points', async () => {
    for (const point of [undefined, { x: 1 }, { y: 1 }, { x: Infinity, y: 1 }]) {
      const says = `clearestPath takes points { x, y } of finite numbers, not ${point ? 'an object' : 'undefined'}.`
      expect(await messageOf(() => clearestPath(diagram, point as never, P))).toBe(says)
      expect(await messageOf(() => clearestPath(diagram, P, point as never))).toBe(says)
    }
  })

  it.each([
    ['encodeLink', (lattice: never) => encodeLink({ lattice })],
    ['computePeriodic', (lattice: never) => library.computePeriodic(CIRCLES, lattice)],
    ['computePeriodic', (lattice: never) => worker.computePeriodic(CIRCLES, lattice)],
    ['fitAreas', (lattice: never) => regions.fitAreas([[1, 1]], [1], { lattice })],
    ['fitAreas', (lattice: never) => worker.fitAreas([[1, 1]], [1], { lattice })],
  ] as const)('of %s is a lattice', async (name, act) => {
    const { a, b } = LATTICE
    for (const lattice of [5, { a }, { b }, { a, b: [0] }, { a: [1, 0, 0], b }, { a, b: [0, '9'] }, { a: 'ab', b }]) {
      expect(await messageOf(() => act(lattice as never))).toBe(
        `${name} takes a lattice as { a: [ax, ay], b: [bx, by] }, all numbers.`,
      )
    }
  })

  it.each(['readCircles', 'readCircleFile', 'readDiagram', 'readDiagramFile', 'holdsDiagram'])(
    'of %s is a text',
    async (name) => {
      expect(await messageOf(() => bound(files, name)(5))).toBe(`${name} takes a text or its bytes, not 5.`)
    },
  )

  it('of finalCells is a box and a radius', async () => {
    const box = { minX: 0, minY: 0, maxX: 1, maxY: 1 }
    for (const known of [
      undefined,
      { box },
      { maxRadius: 1 },
      { box, maxRadius: '1' },
      ...Object.keys(box).map((side) => ({ box: { ...box, [side]: '0' }, maxRadius: 1 })),
    ]) {
      expect(await messageOf(() => library.finalCells(diagram, known as never))).toBe(
        'finalCells takes what is known as { box: { minX, minY, maxX, maxY }, maxRadius }, all numbers.',
      )
    }
    const wide = { box: { minX: -40, minY: -20, maxX: 70, maxY: 90 }, maxRadius: 1 }
    expect([...library.finalCells(diagram, wide).vertices]).toEqual([1])
    for (const [side, value] of Object.entries({ minX: 0, minY: 0, maxX: 5, maxY: 6 })) {
      const { vertices } = library.finalCells(diagram, { ...wide, box: { ...wide.box, [side]: value } })
      expect([...vertices]).toEqual([0])
    }
    expect([...library.finalCells(diagram, { ...wide, maxRadius: 99 }).vertices]).toEqual([0])
  })

  it('of a core that judges is an array of the right kind and length', async () => {
    const kinds = {
      ...{ circles: 3, vertices: 3, vertexCircles: 3, edges: 4, hidden: 2 },
      ...{ hull: 1, nextSide: 2, vertexSides: 3, firstSide: 1 },
    }
    for (const [name, size] of Object.entries(kinds)) {
      const isOfDoubles = name === 'circles' || name === 'vertices'
      const [type, other] = isOfDoubles ? [Float64Array, Int32Array] : [Int32Array, Float64Array]
      const known = { box: { minX: 0, minY: 0, maxX: 1, maxY: 1 }, maxRadius: 1 }
      for (const array of [undefined, [], new other(size), ...(size === 1 ? [] : [new type(size + 1)])]) {
        const changed = { ...diagram, [name]: array } as never
        for (const act of [library.certify, (d: never) => library.finalCells(d, known), files.writeDiagram]) {
          expect(await messageOf(() => act(changed))).toBe(`${name} is no ${type.name} of ${size} numbers each.`)
        }
      }
    }
  })
})

describe('a value of an option', () => {
  const computes: readonly ((options: object) => unknown)[] = [
    (options) => library.compute(CIRCLES, options),
    (options) => library.computePeriodic(CIRCLES, LATTICE, options),
    (options) => worker.compute(CIRCLES, options),
    (options) => worker.computePeriodic(CIRCLES, LATTICE, options),
  ]
  const TRUTH = [1, 'true', null]
  it.each([
    ['weights', TRUTH, () => 'The option weights is true or false.'],
    ['resample', TRUTH, () => 'The option resample is true or false.'],
    ['method', [1, null], () => 'The options method and candidates are strings.'],
    ['candidates', [1, null], () => 'The options method and candidates are strings.'],
    [
      'samples',
      [-1, 0.5, 2 ** 31, null],
      (value: unknown) => `The option samples is a whole number from 0, not ${value}.`,
    ],
    ...['progress', 'x', 'y', 'r'].map((name) => [name, [1, null], () => `The option ${name} is a function.`] as const),
  ] as const)('%s of compute', async (name, values, says) => {
    for (const act of computes) {
      for (const value of values) expect(await messageOf(() => act({ [name]: value }))).toBe(says(value))
    }
  })

  it.each([
    ['method', 'auto, touching-disc or flip'],
    ['candidates', 'dynamic, uniform or all-pairs'],
  ])('%s of compute is one of a few', async (name, choice) => {
    for (const act of computes.slice(0, 2)) {
      expect(await messageOf(() => act({ [name]: 'x' }))).toBe(`Unknown ${name}: the choice is ${choice}.`)
    }
  })

  const fits: readonly ((options: object) => unknown)[] = [
    (options) => regions.fitAreas([[1, 1]], [1], { region, ...options }),
    (options) => worker.fitAreas([[1, 1]], [1], { region, ...options }),
  ]
  it.each([
    ['shares', 1, 'shares is true or false, not 1.'],
    ['tolerance', '1', 'tolerance is a number, not "1".'],
    ...['maxSteps', 'relax'].flatMap((name) =>
      [0.5, 2 ** 31, -(2 ** 31), '1'].map(
        (value) =>
          [name, value, `${name} is a whole number, not ${typeof value === 'string' ? '"1"' : value}.`] as const,
      ),
    ),
    ['onStep', 1, 'The option onStep is a function.'],
    ['signal', {}, 'The option signal is an AbortSignal.'],
    ['lattice', LATTICE, 'fitAreas takes a region or a lattice, not both.'],
    ['weights', 5, 'fitAreas takes a list of numbers as weights, not 5.'],
    ['weights', ['1'], 'fitAreas takes a list of numbers as weights, but item 0 is "1".'],
    ['weights', [1, 2], 'There are 2 weights for 1 site.'],
    ['weights', [], 'There are 0 weights for 1 site.'],
    [
      'region',
      {},
      'fitAreas needs a region, which `region` of `loadRegions` makes, as its option region, or periods as its option lattice.',
    ],
  ] as const)('%s of fitAreas: %j', async (name, value, says) => {
    for (const act of fits) expect(await messageOf(() => act({ [name]: value }))).toBe(says)
  })

  it('dissolve of region, weights, ids and nextId of edit, and signal of a worker', async () => {
    for (const value of TRUTH) {
      expect(await messageOf(() => regions.region([], { dissolve: value as never }))).toBe(
        'The option dissolve is true or false.',
      )
      for (const { edit } of [library, { edit: worker.edit.bind(worker) }]) {
        expect(await messageOf(() => edit(CIRCLES, { weights: value as never }))).toBe(
          'The option weights is true or false.',
        )
      }
    }
    for (const nextId of [-1, 0.5, 2 ** 31, '3']) {
      expect(await messageOf(() => library.edit(CIRCLES, { nextId: nextId as never }))).toBe(
        `nextId must be a whole number from 0 to 2147483647, not ${nextId === '3' ? '"3"' : nextId}.`,
      )
    }
    expect(await messageOf(() => library.edit(CIRCLES, { ids: 5 as never }))).toBe(
      'ids must be a list of whole numbers, not 5.',
    )
    for (const id of [-1, 0.5, 2 ** 31]) {
      expect(await messageOf(() => library.edit([[0, 0, 1]], { ids: [id] }))).toBe(
        `ids must be whole numbers from 0 to 2147483646 in increasing order; ${id} is not.`,
      )
    }
    for (const act of computes.slice(2)) {
      expect(await messageOf(() => act({ signal: {} }))).toBe('The option signal is an AbortSignal.')
    }
  })

  it.each([loadCircleVoronoi, loadRegions, loadComparison, loadFiles, createWorker])('wasm of %o', async (load) => {
    for (const [wasm, said] of [
      [5, '5'],
      [null, 'null'],
      [() => {}, 'a function'],
    ]) {
      expect(await messageOf(() => (load as Act)({ wasm }))).toBe(
        `The option wasm is an address, bytes, a Response or a module, not ${said}.`,
      )
    }
  })

  it('library of loadComparison', async () => {
    for (const [value, said] of [
      [5, '5'],
      [{}, 'an object'],
      [null, 'null'],
      [{ compute: 5 }, 'an object'],
    ]) {
      expect(await messageOf(() => loadComparison({ library: value as never }))).toBe(
        `The option library is what loadCircleVoronoi loads, not ${said}.`,
      )
    }
  })
})
