// SPDX-License-Identifier: GPL-3.0-or-later
// Every public function refuses wrong arguments by a code, and by the index of a circle where there is one. The calls are
// generated from one table: right arguments, and the kind of each, which has the wrong values.
import { afterAll, describe, expect, it, vi } from 'vitest'
import * as fileFunctions from '../../web/lib/files.ts'
import * as index from '../../web/lib/index.ts'
import { CircleVoronoiError, ConvexPolygon, type ErrorCode, type Lattice, SvgPath } from '../../web/lib/index.ts'
import * as links from '../../web/lib/link.ts'
import * as metricFunctions from '../../web/lib/metrics.ts'
import * as regionFunctions from '../../web/lib/regions.ts'
import * as sphereFunctions from '../../web/lib/sphere.ts'
import { EditorClient } from '../../web/lib/threads/editor-client.ts'
import * as workers from '../../web/lib/worker.ts'
import { library } from './library.ts'

vi.stubGlobal(
  'Worker',
  class {
    postMessage() {}
    terminate() {}
  },
)
afterAll(() => vi.unstubAllGlobals())

const CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const BOX = [-5, -5, 10, 10] as const
const NESTED = Float64Array.of(1, 2, 3, 1, 2, 4)
const LATTICE = { a: [9, 0], b: [0, 9] } as const
const SINK = new SvgPath()
const P = { x: 3, y: 0 }
const POLYGON = [P, { x: 9, y: 0 }, { x: 9, y: 9 }]
const diagram = library.compute(CIRCLES)
const metrics = await metricFunctions.loadMetrics({ library })
const power = metrics.compute(CIRCLES, { metric: 'power' })
const periodic = library.computePeriodic(CIRCLES, LATTICE)
const editor = library.edit(CIRCLES)
const snapshot = editor.snapshot()
const trace = library.trace(CIRCLES)
const regions = await regionFunctions.loadRegions()
const region = regions.region([POLYGON.map(({ x, y }) => [x, y])])
const files = await fileFunctions.loadFiles()
const spheres = await sphereFunctions.loadSphere()
const sphere = spheres.computeSphere(CIRCLES)
const worker = workers.createWorker()
const client = new EditorClient({} as WebAssembly.Module, false, () => {})
const curve = index.edgeCurve(diagram, 0)
const [arc] = index.clipCurve(curve, { bounds: BOX })

/** A wrong value, the code of its error, and the index of the circle that the error names. */
type Wrong = readonly [value: unknown, code: ErrorCode, circle?: number | undefined]

const bad = (code: ErrorCode, ...values: readonly unknown[]): Wrong[] => values.map((value) => [value, code])
const input = (...values: readonly unknown[]) => bad('badInput', ...values)
const option = (...values: readonly unknown[]) => bad('badOption', ...values)

type Resizable = ArrayBuffer & { resize(bytes: number): void }
const Resizable = ArrayBuffer as unknown as new (bytes: number, options: object) => Resizable
/** Copies of a list whose memory is gone: of a buffer that was transferred, or became too short or empty. */
function lost<List extends Float64Array | Float32Array | Int32Array | Uint8Array>(list: List): List[] {
  const transferred = list.slice()
  structuredClone(transferred.buffer, { transfer: [transferred.buffer] })
  const { byteLength, length } = list
  const shorter = [byteLength - 1, 0].map((bytes) => {
    const buffer = new Resizable(byteLength, { maxByteLength: byteLength })
    const copy = new (list.constructor as Float64ArrayConstructor)(buffer, 0, length)
    buffer.resize(bytes)
    return copy
  })
  return [transferred, ...shorter] as List[]
}

const NO_NUMBERS = ['0', null, {}, [1], true]
const indexOf = (count: number) => input(...NO_NUMBERS, undefined, count, -1, 0.5, Number.NaN, Infinity)
const id = [...input(...NO_NUMBERS, undefined), ...bad('unknownCircle', 0.5, -2, 2 ** 31, Number.NaN)]
/** Changes one number of three circles. */
const changed = (place: number, value: unknown) => Array.from(CIRCLES, (old, k) => (k === place ? value : old))
const rows = (numbers: readonly unknown[]) => [0, 3, 6].map((k) => numbers.slice(k, k + 3))
/** Circles of which one is wrong, in all forms that lists have. */
const wrongCircles = (code: ErrorCode, circle: number, place: number, value: unknown): Wrong[] =>
  [Float64Array.from(changed(place, value) as number[]), rows(changed(place, value))].map((list) => [
    list,
    code,
    circle,
  ])
const noCircles: readonly Wrong[] = [
  ...input(5, 'x', {}, new Float64Array(4), new Float32Array(5), ...lost(CIRCLES)),
  ...input(...lost(Float32Array.from(CIRCLES)), ...lost(Int32Array.from(CIRCLES))),
  ...lost(Float64Array.of(0, 0, 1)).map((row) => [[row], 'badInput', 0] as const),
  [[[0, 0, 1], [5, 5], []], 'badInput', 1],
  [[0, 0, 1], 'badInput', 0],
  [[null], 'badInput', 0],
  [new Array(3), 'badInput', 0],
  [rows(changed(7, '8')), 'badInput', 2],
  [rows(changed(5, undefined)), 'badInput', 1],
  ...wrongCircles('nonFinite', 1, 4, Number.NaN),
  ...wrongCircles('nonFinite', 0, 2, Infinity),
  ...wrongCircles('coordinateTooLarge', 2, 6, -1e29),
]
const noPlaces: readonly Wrong[] = [
  ...input(5, 'x', null, {}, new Float64Array(4), new Float32Array(5), ...lost(CIRCLES)),
  [[[0, 0, 1], [5, 5], []], 'badInput', 1],
  [[0, 0, 1], 'badInput', 0],
  [[null], 'badInput', 0],
  [[{ lon: 1, lat: 2, r: 3 }], 'badInput', 0],
  [rows(changed(7, '8')), 'badInput', 2],
]
const noCaps: readonly Wrong[] = [
  ...wrongCircles('nonFinite', 1, 3, Number.NaN),
  ...wrongCircles('nonFinite', 0, 2, Infinity),
  ...wrongCircles('coordinateTooLarge', 2, 7, 91),
  ...wrongCircles('coordinateTooLarge', 0, 2, 20016),
]
const negative = wrongCircles('negativeRadius', 1, 5, -1)
const oneCircle = (own: number | undefined): Wrong[] => [
  ...[5, 'x', null, undefined, [1, 2], { x: 1, y: 2 }, ['0', 0, 1]].map((circle) => [circle, 'badInput', own] as const),
  ...lost(Float64Array.of(0, 0, 1)).map((circle) => [circle, 'badInput', own] as const),
  [[0, Number.NaN, 1], 'nonFinite', own],
  [[0, 0, -1], 'negativeRadius', own],
  [[0, 1e29, 1], 'coordinateTooLarge', own],
]
/** Lists of numbers, written as texts. Numbers in quotation marks stay texts. */
const lists = (text: string) =>
  text.split(';').map((list) =>
    list
      .trim()
      .split(' ')
      .map((item) => (item.startsWith("'") ? item.slice(1, -1) : Number(item))),
  )
const boxes = lists(
  "0 0 9 0; 0 0 0 9; 9 0 0 9; 0 9 9 0; 0 0 9 NaN; 0 0 9 3e30; -3e30 0 9 9; 0 0 9; 0 0 9 9 9; '0' '0' '9' '9'",
)
const sides = boxes.filter(({ length }) => length === 4).map(([minX, minY, maxX, maxY]) => ({ minX, minY, maxX, maxY }))
const things = ['x', 5, null, undefined, {}, []]
const STAR = lists('1 0; -0.8 0.6; 0.3 -0.95; 0.3 0.95; -0.8 -0.6').map(([x, y]) => ({ x, y }))
const KNOWN = { box: { minX: 0, minY: 0, maxX: 1, maxY: 1 }, maxRadius: 1 }
const JSON_FILE = JSON.stringify(diagram)
const badLattices = [
  ...[lists('9 0; 0'), lists('9 0 0; 0 9'), lists("9 0; 0 '9'"), ['ab', [0, 9]]],
  ...lost(Float64Array.of(9, 0)).map((a) => [a, [0, 9]]),
].map(([a, b]) => ({ a, b }))
/** The names of the arrays of a diagram. */
const ARRAYS = [
  ...['circles', 'vertices', 'vertexCircles', 'edges', 'hull'],
  ...['nextSide', 'vertexSides', 'firstSide'],
] as const
/** Diagrams of which one array has lost its memory. */
const lostDiagrams = ARRAYS.flatMap((name) =>
  lost(diagram[name as 'circles']).map((list) => Object.assign(library.compute(CIRCLES), { [name]: list })),
)
const bytesOf = (text: string) => new TextEncoder().encode(text)
const wrongBoxes = Object.keys(KNOWN.box).map((side) => ({ box: { ...KNOWN.box, [side]: '0' }, maxRadius: 1 }))

const TREE = { children: [{ value: 1 }, { value: 2 }] }
const NO_TREES = input(
  5,
  null,
  'x',
  { children: 5 },
  { children: [5] },
  { children: [{}] },
  { children: [{ value: '1' }] },
)

/** The right value of each kind of arguments, and the wrong ones. */
const ARGUMENTS: Readonly<Record<string, readonly [right: unknown, wrong: readonly Wrong[]]>> = {
  circle: [0, indexOf(3)],
  otherCircle: [1, indexOf(3)],
  edge: [0, indexOf(3)],
  vertex: [0, indexOf(1)],
  image: [0, indexOf(periodic.circleOf.length)],
  event: [0, indexOf(trace.length)],
  events: [0, input(...NO_NUMBERS, undefined, -1, 0.5, trace.length + 1)],
  id: [0, id],
  knownId: [0, [...id, [99, 'unknownCircle', 99]]],
  // Numbers that are no index have no cell, and those that are no id have no circle.
  number: [1, input(...NO_NUMBERS, undefined)],
  hint: [0, input(...NO_NUMBERS)],
  length: [1, input(...NO_NUMBERS, Number.NaN)],
  above0: [1, input(...NO_NUMBERS, undefined, Number.NaN, 0, -1, Infinity)],
  longitude: [1, input(...NO_NUMBERS, undefined, Number.NaN, Infinity)],
  latitude: [1, input(...NO_NUMBERS, undefined, Number.NaN, Infinity, 91)],
  circles: [CIRCLES, [...noCircles, ...negative]],
  sent: [CIRCLES, input(...lost(CIRCLES))],
  weights: [CIRCLES, noCircles],
  powers: [CIRCLES, [...noCircles, ...wrongCircles('coordinateTooLarge', 1, 5, -1e58)]],
  places: [CIRCLES, [...noPlaces, ...noCaps, ...negative]],
  weightedPlaces: [CIRCLES, [...noPlaces, ...noCaps]],
  sentPlaces: [CIRCLES, noPlaces],
  newCircle: [[3, 3, 1], oneCircle(undefined)],
  circle0: [[0, 0, 2], oneCircle(0)],
  array: [CIRCLES, input(...things, new Float64Array(4), ...lost(CIRCLES))],
  data: [diagram, input(...things, ...lostDiagrams)],
  diagram: [diagram, input(...things, { ...diagram }, power, ...lostDiagrams)],
  snapshotData: [snapshot, input(...things, diagram)],
  periodicData: [periodic, input(...things, diagram)],
  curve: [curve, input(...things)],
  arc: [arc, input(...things, { ...arc, start: undefined }, { ...arc, end: undefined })],
  bisector: [curve.bisector, input(...things, curve)],
  outline: [[], input('x', 5, null, undefined, {}, [5])],
  sink: [SINK, []],
  point: [P, input(...things, [3, 0], { x: 1 }, { y: 1 }, { x: Infinity, y: 1 })],
  points: [
    [1, 2],
    input(
      ...things.slice(0, 5),
      [1],
      new Float64Array(3),
      lists('1 2; 3 4'),
      ['0', '1'],
      ...lost(Float64Array.of(1, 2)),
    ),
  ],
  corners: [POLYGON, option(undefined, 5, {}, [P], STAR)],
  lattice: [LATTICE, input(5, 'x', { a: [9, 0] }, { b: [0, 9] }, ...badLattices)],
  circleText: ['1,2,3', input(5, null, undefined, {}, [], ...lost(bytesOf('1,2,3')))],
  diagramText: [JSON_FILE, input(5, null, undefined, {}, [], ...lost(bytesOf(JSON_FILE)))],
  edits: [
    [],
    [
      ...input(5, undefined, {}, [null], [{ move: 3 }], [{ kind: 'move', id: 0 }], [{ kind: 'remove', id: '0' }]),
      ...input([{ kind: 'replace', circle: [0, 0, 1] }], [{ kind: 'insert', circle: [0, 0, 1], id: '0' }]),
      ...bad('unknownCircle', [{ kind: 'remove', id: 0.5 }], [{ kind: 'insert', circle: [0, 0, 1], id: -1 }]),
      [[{ kind: 'replace', id: 2, circle: [0, 0, -1] }], 'negativeRadius', 2],
      [[{ kind: 'insert', circle: [0, 0] }], 'badInput'],
    ],
  ],
  change: [undefined, input(undefined, 5, {})],
  sites: [
    lists('5 1'),
    [...input(5, {}, 'x', ...lost(CIRCLES)), [lists('1 1; 1'), 'badInput', 1], [lists("1 1; 1 '1'"), 'badInput', 1]],
  ],
  areas: [[27], input(5, '12', ['1'], [undefined], new Array(1), ...lost(Float64Array.of(27)))],
  sentTree: [TREE, NO_TREES],
  tree: [
    TREE,
    [
      ...NO_TREES,
      ...input({ children: [{ value: 0 }] }, { children: [{ value: -1 }] }, { children: [{ value: Number.NaN }] }),
    ],
  ],
  shape: [[POLYGON.map(({ x, y }) => [x, y])], option(7, null, undefined, 'x', {})],
  known: [KNOWN, input(5, undefined, {}, { box: KNOWN.box }, { maxRadius: 1 }, ...wrongBoxes)],
}

/** The wrong values of each option, or of each kind of options. */
const OPTIONS: Readonly<Record<string, readonly Wrong[]>> = {
  any: [],
  none: [],
  bounds: option(5, null, 'x', {}, ...boxes, ...sides),
  region: option(5, [], {}, 'x', null),
  maxDistance: option('1', Number.NaN, Infinity, 2 ** 101, null),
  ground: option('1', Number.NaN, Infinity, null),
  sphereRadius: option(0, -1, Number.NaN, Infinity, '1', null),
  tolerance: option(0, -1, Number.NaN, Infinity, '1', null),
  digits: option(-1, 0.5, Number.NaN, '3', null),
  context: option({}, 5, 'x'),
  text: option(1, null),
  truth: option(1, 'true', null),
  function: option(1, 'x', null),
  samples: option(-1, 0.5, 2 ** 31, null, '3', Number.NaN),
  choice: option('x', 1, null),
  // A worker leaves it to its thread to know the names.
  name: option(1, null),
  nextId: option(-1, 0.5, 2 ** 31, '3', null),
  ids: [...option(5, [-1], [0.5], [2 ** 31], ['0']), ...input(...lost(Int32Array.of(1, 2, 3)))],
  count: option(0.5, 2 ** 31, '1', Number.NaN, null),
  number: option('1', null),
  lattice: ARGUMENTS.lattice?.[1] ?? [],
  startWeights: [...input(5, ['1'], 'x', ...lost(Float64Array.of(0))), ...option([1, 2], [])],
  edits: input(5, {}, [null], [{ kind: 'move', id: 0 }]),
  signal: option({}, 5, 'now'),
  format: option('pdf', 5, null, ''),
  wasm: option(5, null, () => {}),
  library: option(5, {}, null, { compute: 5 }),
}

type Act = (...args: readonly unknown[]) => unknown
/** A function with the kinds of its arguments, and of its options by their names. */
interface Row {
  readonly owner: object
  readonly name: string
  readonly act: Act
  readonly args: readonly (readonly [right: unknown, wrong: readonly Wrong[]])[]
  /** `undefined` if a further argument is ignored. */
  readonly options: Readonly<Record<string, readonly Wrong[]>> | undefined
  /** Options that each call needs. */
  readonly needed: readonly object[]
  /** Whether a thread answers. */
  readonly isLater: boolean
}

/**
 * Describes a function of an object. Kinds of arguments are separated by spaces. An option is of the kind of its name, or
 * of another one after a colon. `none`: the function has no options, and says so.
 */
function row(owner: object, name: string, args = '', options?: string, needed?: object): Row {
  const found = (owner as Readonly<Record<string, Act>>)[name] as Act
  const words = (text: string) => text.split(' ').filter((word) => word !== '' && word !== 'none')
  const kinds = words(options ?? '').map((word) => word.split(':'))
  return {
    owner,
    name,
    act: found.bind(owner),
    args: words(args).map((kind) => ARGUMENTS[kind] as Row['args'][0]),
    options:
      options === undefined
        ? undefined
        : Object.fromEntries(kinds.map(([name = '', kind = name]) => [name, OPTIONS[kind] as readonly Wrong[]])),
    needed: needed === undefined ? [] : [needed],
    isLater: owner === client || owner === worker,
  }
}

const LIMITS = 'bounds region maxDistance'
const POLYGONS = `${LIMITS} tolerance`
const DRAWING = `${POLYGONS} context digits`
const FINDING = 'x:function y:function r:function'
const METHODS = 'method:choice candidates:choice'
const COMPUTING = 'weights:truth samples resample:truth progress:function'
const EDITING = 'weights:truth ids nextId'
const FITTING =
  'region lattice metric:choice shares:truth tolerance:number maxSteps:count relax:count weights:startWeights onStep:function signal'
const DIVIDING = 'region metric:choice relax:count tolerance:number previous:none key:function progress:function signal'
const READING = 'name:text weights:truth points:truth x:text y:text radius:text id:text skipInvalid:truth'
const COMPUTING_SPHERE = 'weights:truth radius:sphereRadius longitude:function latitude:function r:function'
const BY_METRIC = `${COMPUTING} ${METHODS} ${FINDING} metric:choice`
const IN_THREAD = `${COMPUTING} ${FINDING} method:name candidates:name signal`

/** Methods with limits of cells. */
const LIMITED: readonly (readonly [name: string, args: string, options: string])[] = [
  ...['neighbors', 'cellOutline', 'cellArea', 'cellCentroid', 'cellPerimeter'].map(
    (name) => [name, 'circle', LIMITS] as const,
  ),
  ...['cellAreas', 'cellCentroids', 'cellPerimeters'].map((name) => [name, '', LIMITS] as const),
  ['cellPath', 'circle', DRAWING],
  ['edgePath', 'edge', DRAWING],
  ['render', '', DRAWING],
  ['renderBounds', '', DRAWING],
  ['cellPolygon', 'circle', POLYGONS],
]

const ROWS: readonly Row[] = [
  row(diagram, 'exportBox', '', 'maxDistance'),
  ...LIMITED.map(([name, args, options]) => row(diagram, name, args, options)),
  ...LIMITED.map(([name, args, options]) => row(power, name, args, options)),
  row(diagram, 'cell', 'number', 'none'),
  row(diagram, 'renderCircles', '', 'context digits'),
  row(diagram, 'renderDual', '', 'context digits'),
  row(diagram, 'renderHull', '', 'context digits region tolerance', { region }),
  row(diagram, 'hullPolygon', '', 'region tolerance'),
  row({ cellPolygon: (options?: object) => diagram.cellPolygons(options).next() }, 'cellPolygon', '', POLYGONS),
  row(diagram, 'contains', 'circle number number', 'none'),
  row(diagram, 'find', 'number number hint'),
  row(diagram, 'findAll', 'points', 'none'),
  ...['neighbors', 'cellArea', 'cellCentroid', 'cellPerimeter'].map((name) => row(periodic, name, 'circle', 'none')),
  row(periodic, 'cellPath', 'circle', DRAWING),
  row(periodic, 'cellPolygon', 'circle', POLYGONS),
  row(periodic, 'contains', 'circle number number', 'none'),
  row(periodic, 'find', 'number number', 'none'),
  row(periodic, 'imageFrom', 'image image'),
  row(periodic, 'contacts', '', 'none'),
  ...[editor, client].flatMap((edited) => [
    row(edited, 'insert', 'newCircle hint'),
    row(edited, 'remove', edited === editor ? 'knownId' : 'id'),
    row(edited, 'replace', `${edited === editor ? 'knownId' : 'id'} circle0`),
    row(edited, 'apply', 'edits'),
    row(edited, 'nearest', 'number number hint'),
    row(edited, 'circle', 'id'),
    row(edited, 'isHidden', 'id'),
  ]),
  row(snapshot, 'indexOf', 'number'),
  row(snapshot, 'apply', 'change'),
  row(trace, 'event', 'event'),
  row(trace, 'at', 'events'),
  row(library, 'compute', 'circles', `${COMPUTING} ${METHODS} ${FINDING}`),
  row(library, 'compute', 'weights', `${COMPUTING} ${METHODS} ${FINDING}`, { weights: true }),
  row(library, 'computePeriodic', 'circles lattice', `${COMPUTING} ${METHODS} ${FINDING}`),
  row(library, 'trace', 'circles', `${COMPUTING} ${METHODS} edits`),
  row(library, 'edit', 'circles', EDITING),
  row(library, 'certify', 'data', 'none'),
  row(metrics, 'certify', 'data', 'none'),
  row(library, 'finalCells', 'data known'),
  row(worker, 'compute', 'sent', `${IN_THREAD} metric:choice`),
  row(worker, 'computePeriodic', 'sent lattice', `${IN_THREAD} metric:choice`),
  row(worker, 'edit', 'sent', EDITING),
  row(worker, 'fitAreas', 'sites areas', FITTING, { region }),
  row(regions, 'fitAreas', 'sites areas', FITTING, { region }),
  row(regions, 'treemap', 'tree', DIVIDING, { region }),
  row(worker, 'treemap', 'sentTree', DIVIDING, { region }),
  row(regions, 'region', 'shape', 'dissolve:truth'),
  row(region, 'contains', 'number number'),
  row(spheres, 'computeSphere', 'places', COMPUTING_SPHERE),
  row(spheres, 'computeSphere', 'weightedPlaces', COMPUTING_SPHERE, { weights: true }),
  row(worker, 'computeSphere', 'sentPlaces', `${COMPUTING_SPHERE.replace(':sphereRadius', ':number')} signal`),
  row(sphere, 'find', 'longitude latitude'),
  row(sphere, 'distanceFrom', 'circle longitude latitude'),
  row(sphere, 'neighbors', 'circle', 'none'),
  ...['cellArea', 'cellPerimeter'].map((name) => row(sphere, name, 'circle', 'maxDistance:ground')),
  ...['cellAreas', 'cellPerimeters'].map((name) => row(sphere, name, '', 'maxDistance:ground')),
  row(sphere, 'cellPolygon', 'circle', 'maxDistance:ground tolerance'),
  row(sphere, 'toGeoJSON', '', 'maxDistance:ground tolerance'),
  row(metrics, 'compute', 'circles', BY_METRIC),
  row(metrics, 'compute', 'circles', BY_METRIC, { metric: 'centers' }),
  row(metrics, 'compute', 'weights', BY_METRIC, { metric: 'centers', weights: true }),
  row(metrics, 'compute', 'circles', BY_METRIC, { metric: 'power' }),
  row(metrics, 'compute', 'powers', BY_METRIC, { metric: 'power', weights: true }),
  row(metrics, 'computePeriodic', 'circles lattice', BY_METRIC, { metric: 'centers' }),
  row(metrics, 'computePeriodic', 'circles lattice', BY_METRIC, { metric: 'power' }),
  row(files, 'readCircles', 'circleText', READING),
  row(files, 'readCircleFile', 'circleText', READING),
  row(files, 'readDiagram', 'diagramText', 'name:text'),
  row(files, 'readDiagramFile', 'diagramText', 'name:text'),
  row(files, 'holdsDiagram', 'diagramText'),
  row(files, 'writeCircles', 'weights', 'format attributes:any'),
  row(files, 'writeDiagram', 'data', `${POLYGONS} format digits attributes:any`, { format: 'svg' }),
  row(index, 'circleAt', 'array circle'),
  row(index, 'vertexAt', 'data vertex'),
  row(index, 'edgeAt', 'data edge'),
  row(index, 'edgeCurve', 'data edge'),
  row(index, 'mergeVertices', 'data length'),
  row(index, 'convexHull', 'data', 'none'),
  row(index, 'closestPair', 'data', 'none'),
  row(index, 'hiddenWarning', 'data'),
  row(index, 'largestEmptyDiscCenteredInHull', 'diagram', 'none'),
  row(index, 'largestEmptyDiscCenteredIn', 'diagram', 'bounds region', { bounds: BOX }),
  row(index, 'largestEmptyDiscInside', 'diagram', 'bounds region', { bounds: BOX }),
  row(index, 'clearestPath', 'diagram point point', 'bounds region'),
  row(index, 'bisector', 'array circle otherCircle'),
  row(index, 'pointAt', 'bisector above0'),
  row(index, 'parameterAt', 'bisector number number'),
  row(index, 'clipCurve', 'curve', 'bounds', { bounds: BOX }),
  row(index, 'rationalBezier', 'arc'),
  row(index, 'cubicBeziers', 'arc above0'),
  row(index, 'polyline', 'arc above0'),
  row(index, 'traceArc', 'sink arc above0'),
  ...['outlineArea', 'outlineCentroid', 'outlinePerimeter'].map((name) => row(index, name, 'outline')),
  row(ConvexPolygon, 'from', 'corners'),
  row({ 'new Diagram': (data: index.Diagram) => new index.Diagram(data) }, 'new Diagram', 'data'),
  row(
    { 'new DiagramSnapshot': (data: index.DiagramSnapshot) => new index.DiagramSnapshot(data) },
    'new DiagramSnapshot',
    'snapshotData',
  ),
  row(
    { 'new PeriodicDiagram': (data: index.PeriodicDiagram) => new index.PeriodicDiagram(data) },
    'new PeriodicDiagram',
    'periodicData',
  ),
  row(index, 'fromJSON', 'diagramText'),
  row(index, 'loadCircleVoronoi', '', 'wasm'),
  row(regionFunctions, 'loadRegions', '', 'wasm'),
  row(fileFunctions, 'loadFiles', '', 'wasm'),
  row(sphereFunctions, 'loadSphere', '', 'wasm'),
  row(metricFunctions, 'loadMetrics', '', 'wasm library'),
  row(workers, 'createWorker', '', 'wasm'),
  row({ encodeLink: (lattice: Lattice) => links.encodeLink({ lattice }) }, 'encodeLink', 'lattice'),
  row({ encodeLink: (circles: Float64Array) => links.encodeLink({ circles }) }, 'encodeLink', 'sent'),
  row({ encodeLink: (circles: Float64Array) => links.encodeLinkAtOnce({ circles }) }, 'encodeLink', 'sent'),
]

interface Call {
  readonly row: Row
  /** The wrong argument, or the name of the wrong option. */
  readonly what: string
  readonly value: unknown
  readonly args: readonly unknown[]
  readonly wrong: Wrong
}

/** All calls with one wrong argument or option. */
function* callsOf(row: Row): Generator<Call> {
  const { args, options, needed } = row
  const right = args.map(([value]) => value)
  for (const [k, [, values]] of args.entries()) {
    for (const wrong of values)
      yield { row, what: '', value: wrong[0], args: [...right.with(k, wrong[0]), ...needed], wrong }
  }
  const names = Object.keys(options ?? {})
  const wrongOptions: (readonly [what: string, options: unknown, wrong: Wrong])[] = [
    ...(options === undefined ? [] : [['foo', { foo: 1 }, [1, 'badOption']] as const]),
    ...(names.length === 0 ? [] : option(null, [], 'x', 5)).map((wrong) => ['options', wrong[0], wrong] as const),
    ...(names.includes('context') ? option(SINK) : []).map((wrong) => ['', SINK, wrong] as const),
    ...(names.includes('bounds') ? option(BOX) : []).map(
      (wrong) => ['region', { bounds: BOX, region }, wrong] as const,
    ),
    ...Object.entries(options ?? {}).flatMap(([name, values]) =>
      values.map((wrong) => [name, { [name]: wrong[0] }, wrong] as const),
    ),
  ]
  for (const [what, options, wrong] of wrongOptions) {
    const isObject = what !== 'options' && what !== ''
    yield {
      row,
      what,
      value: wrong[0],
      args: [...right, isObject ? { ...needed[0], ...(options as object) } : options],
      wrong,
    }
  }
}

async function errorOf(act: Act, args: readonly unknown[]): Promise<unknown> {
  try {
    await act(...args)
  } catch (error) {
    return error
  }
  return 'no error'
}

describe('a wrong argument or option', () => {
  it.each(ROWS.map((row) => [row.name, row] as const))('of %s has its code', async (_, row) => {
    const wrong: unknown[] = []
    for (const {
      what,
      args,
      wrong: [value, code, circle],
    } of callsOf(row)) {
      const error = await errorOf(row.act, args)
      const isRight = error instanceof CircleVoronoiError && error.code === code && error.circle === circle
      if (!isRight) wrong.push([what, value, code, circle, error])
    }
    expect(wrong).toEqual([])
  })
})

/** Calls with one wrong argument that no other function has. */
const SINGLE: readonly (readonly [title: string, code: ErrorCode, act: () => unknown])[] = [
  ['the bisector of a circle and itself', 'badInput', () => index.bisector(CIRCLES, 0, 0)],
  ['the bisector of concentric circles', 'badInput', () => index.bisector(NESTED, 0, 1)],
  ['a metric that there is not', 'badInput', () => index.bisector(CIRCLES, 0, 1, 'x' as index.Metric)],
  ['a path without circles', 'badInput', () => index.clearestPath(library.compute([]), P, P)],
  ['weights as a text', 'badInput', () => library.certify(Object.assign({ ...diagram }, { weights: 'no' }))],
  ['an editor of a power diagram', 'badInput', () => library.edit(power)],
  ['an editor of a power diagram in a worker', 'badInput', () => worker.edit(power)],
  ['the proof of a power diagram', 'badInput', () => library.certify(power)],
  ['the final cells of a power diagram', 'badInput', () => library.finalCells(power, KNOWN)],
  ['a method of a power diagram', 'badOption', () => metrics.compute(CIRCLES, { metric: 'power', method: 'flip' })],
  ['a trace of a power diagram', 'badOption', () => (library.trace as Act)(CIRCLES, { metric: 'power' })],
  [
    'a snapshot without ids',
    'badInput',
    () => new index.DiagramSnapshot(Object.assign({ ...snapshot }, { numbers: undefined })),
  ],
  ['a long text as circles', 'badInput', () => (library.compute as Act)('0'.repeat(41))],
  [
    'a radius as an object',
    'badInput',
    () => library.compute([1, 2], { x: () => 0, y: () => 0, r: () => Object('3') }),
  ],
  ['ids in decreasing order', 'badOption', () => library.edit(NESTED, { ids: [2, 1] })],
  [
    'dynamic candidates with too many samples',
    'badOption',
    () => library.compute(CIRCLES, { method: 'touching-disc', samples: 1001 }),
  ],
  [
    'uniform candidates without samples',
    'badOption',
    () => library.compute(CIRCLES, { method: 'touching-disc', candidates: 'uniform', samples: 0 }),
  ],
  ['a cap as large as a small sphere', 'coordinateTooLarge', () => spheres.computeSphere([[0, 0, 4]], { radius: 1 })],
  [
    'a region and a lattice',
    'badOption',
    () => regions.fitAreas([[5, 1]], [1], Object.assign({ region }, { lattice: LATTICE as never })),
  ],
  [
    'all pairs of too many circles',
    'tooManyCircles',
    () => library.compute(new Float64Array(30_003), { method: 'touching-disc', candidates: 'all-pairs' }),
  ],
]

it.each(SINGLE)('%s is refused with the code %s', async (_, code, act) => {
  expect(await errorOf(act, [])).toMatchObject({ name: 'CircleVoronoiError', code })
})

it('each array of a diagram is of its type and length where a core reads it', async () => {
  const sizes = {
    ...{ circles: 3, vertices: 3, vertexCircles: 3, edges: 4, hidden: 2 },
    ...{ hull: 1, nextSide: 2, vertexSides: 3, firstSide: 1 },
  }
  for (const [name, size] of Object.entries(sizes)) {
    const types = [Float64Array, Int32Array] as const
    const [type, other] = name === 'circles' || name === 'vertices' ? types : ([types[1], types[0]] as const)
    for (const array of [undefined, [], new other(size), ...(size === 1 ? [] : [new type(size + 1)])]) {
      const data = { ...diagram, [name]: array } as never
      const proof = () => metrics.certify(Object.assign({}, data, { metric: 'power' }))
      for (const act of [library.certify, proof, () => library.finalCells(data, KNOWN), files.writeDiagram]) {
        const message = expect.stringContaining(name)
        expect(await errorOf(() => (act as Act)(data), [])).toMatchObject({ code: 'badInput', message })
      }
    }
  }
})

it.each(ROWS.filter(({ owner }) => owner === diagram).map((row) => [row.name, row] as const))(
  '%s of a diagram of which an array has lost its memory is refused',
  async (name, { args, needed }) => {
    for (const lost of lostDiagrams) {
      const act = (lost as unknown as Readonly<Record<string, Act>>)[name] as Act
      const error = await errorOf(act.bind(lost), [...args.map(([right]) => right), ...needed])
      expect(error).toMatchObject({ code: 'badInput' })
    }
  },
)

it('properties and files of a diagram of which an array has lost its memory are refused', async () => {
  for (const lost of lostDiagrams) {
    for (const act of [
      () => lost.halfedges,
      () => lost.toJSON(),
      () => [...lost.cellPolygons({ bounds: BOX })],
      () => lost.cellAreas({ region }),
      () => library.edit(new index.Diagram(lost)),
    ]) {
      expect(await errorOf(act, [])).toMatchObject({ code: 'badInput' })
    }
  }
})

describe('the table', () => {
  /** Functions without arguments, or whose arguments cannot be wrong. */
  const OTHERS: readonly string[] = [
    ...['begin', 'cellPolygons', 'certificate', 'constructor', 'contactsCsv', 'dispose', 'farthestPlace', 'ids'],
    ...['renew', 'size', 'snapshot', 'toJSON', 'update'],
  ]

  it('has every public function', () => {
    const names = new Set(ROWS.map(({ name }) => name))
    const missing = new Set<string>()
    const modules = [index, metricFunctions, fileFunctions, regionFunctions, sphereFunctions, workers, links]
    const loaded = [library, editor, client, worker, metrics, files, regions, region, spheres]
    for (const owner of [...modules, ...loaded, diagram, periodic, sphere, snapshot, trace] as object[]) {
      for (let level = owner; level !== Object.prototype && level !== null; level = Object.getPrototypeOf(level)) {
        for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(level))) {
          if (typeof value === 'function' && !names.has(name) && !names.has(`new ${name}`)) missing.add(name)
        }
      }
    }
    expect([...missing].sort()).toEqual(OTHERS)
  })

  it('has right arguments where none is changed', async () => {
    const isLater = (row: Row) => /^(apply|insert|remove|replace)$/.test(row.name) || row.isLater
    for (const row of ROWS) {
      const args = row.args.map(([value]) => value)
      if (!isLater(row)) expect(await errorOf(row.act, [...args, ...row.needed]), row.name).toBe('no error')
    }
  })
})
