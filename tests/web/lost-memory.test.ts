// SPDX-License-Identifier: GPL-3.0-or-later
// An array whose buffer was transferred, or became too short, reads as empty. No function may take it for no circles.
import { describe, expect, it } from 'vitest'
import { loadComparison } from '../../web/lib/comparison.ts'
import { loadFiles } from '../../web/lib/files.ts'
import {
  bisector,
  circleAt,
  clearestPath,
  closestPair,
  convexHull,
  Diagram,
  edgeAt,
  edgeCurve,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscCenteredInHull,
  largestEmptyDiscInside,
  mergeVertices,
  vertexAt,
} from '../../web/lib/index.ts'
import { encodeLink, encodeLinkAtOnce } from '../../web/lib/link.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { createWorker } from '../../web/lib/worker.ts'
import { library } from './library.ts'

type Numbers = Float64Array | Float32Array | Int32Array | Uint8Array
type Lose = <List extends Numbers>(list: List) => List

const CIRCLES = [0, 0, 1, 6, 0, 1, 0, 8, 1]
const BOUNDS = [-5, -5, 10, 10] as const
const files = await loadFiles()
const regions = await loadRegions()
const { computeComparison } = await loadComparison({ library })
const worker = createWorker()
const region = regions.region([
  [
    [0, 0],
    [9, 0],
    [0, 9],
  ],
])

/** Copies a list into a buffer that then becomes shorter. */
function shrink<List extends Numbers>(list: List, bytes: number): List {
  const size = list.byteLength
  const buffer = new (ArrayBuffer as unknown as new (size: number, options: object) => ArrayBuffer)(size, {
    maxByteLength: size,
  })
  const copy = new (list.constructor as Float64ArrayConstructor)(buffer, 0, list.length) as List
  copy.set(list)
  ;(buffer as unknown as { resize(bytes: number): void }).resize(bytes)
  return copy
}

const LOSSES: readonly (readonly [way: string, lose: Lose])[] = [
  [
    'whose buffer was transferred',
    (list) => {
      structuredClone(list.buffer, { transfer: [list.buffer as ArrayBuffer] })
      return list
    },
  ],
  ['whose buffer became too short', (list) => shrink(list, list.byteLength - 1)],
  ['whose buffer became empty', (list) => shrink(list, 0)],
]

const floats = (...numbers: readonly number[]) => Float64Array.from(numbers)
const LATTICE = { a: [9, 0], b: [0, 9] } as const

/** Functions that take a list of numbers, and a list that is right. */
const TAKERS: readonly (readonly [name: string, act: (list: never) => unknown, list: () => Numbers])[] = [
  ...(
    [
      ['compute', (list) => library.compute(list)],
      ['compute of a worker', (list) => worker.compute(list)],
      ['computePeriodic', (list) => library.computePeriodic(list, LATTICE)],
      ['computePeriodic of a worker', (list) => worker.computePeriodic(list, LATTICE)],
      ['trace', (list) => library.trace(list)],
      ['edit', (list) => library.edit(list)],
      ['edit of a worker', (list) => worker.edit(list)],
      ['computeComparison', (list) => computeComparison(list, 'power')],
      ['circleAt', (list) => circleAt(list, 0)],
      ['bisector', (list) => bisector(list, 0, 1)],
      ['writeCircles', (list) => files.writeCircles(list)],
      ['encodeLink', (list) => encodeLink({ circles: list })],
      ['encodeLinkAtOnce', (list) => encodeLinkAtOnce({ circles: list })],
      ['fitAreas, sites', (list) => regions.fitAreas(list, [1, 1, 1], { region, shares: true })],
    ] as readonly (readonly [string, (list: never) => unknown])[]
  ).map(([name, act]) => [name, act, () => floats(...CIRCLES)] as const),
  ['compute of single precision', (list) => library.compute(list), () => Float32Array.from(CIRCLES)],
  ['compute of a list of rows', (list) => library.compute([list]), () => floats(0, 0, 1)],
  ['compute of whole numbers', (list) => library.compute(list), () => Int32Array.from(CIRCLES)],
  ['insert', (list) => library.edit(floats(...CIRCLES)).insert(list), () => floats(20, 0, 1)],
  ['replace', (list) => library.edit(floats(...CIRCLES)).replace(0, list), () => floats(0, 1, 1)],
  ['edit, ids', (ids) => library.edit(floats(...CIRCLES), { ids }), () => Int32Array.of(1, 2, 3)],
  ['lattice', (a) => library.computePeriodic(CIRCLES_LIST, { a, b: [0, 9] }), () => floats(9, 0)],
  ['findAll', (list) => library.compute(floats(...CIRCLES)).findAll(list), () => floats(1, 1)],
  ['fitAreas, areas', (list) => regions.fitAreas(SITES, list, { region, shares: true }), () => floats(1, 2)],
  [
    'fitAreas, weights',
    (weights) => regions.fitAreas(SITES, [1, 2], { region, shares: true, weights }),
    () => floats(0, 0),
  ],
  ['readCircles', (bytes) => files.readCircles(bytes), () => new TextEncoder().encode('x,y,r\n1,2,3\n')],
  ['readCircleFile', (bytes) => files.readCircleFile(bytes), () => new TextEncoder().encode('x,y,r\n1,2,3\n')],
  ['readDiagram', (bytes) => files.readDiagram(bytes), diagramBytes],
  ['readDiagramFile', (bytes) => files.readDiagramFile(bytes), diagramBytes],
  ['holdsDiagram', (bytes) => files.holdsDiagram(bytes), diagramBytes],
]
const CIRCLES_LIST = [[0, 0, 1] as const]
const SITES = [
  [1, 1],
  [2, 3],
] as const

function diagramBytes(): Uint8Array {
  return new TextEncoder().encode(files.writeDiagram(library.compute(floats(...CIRCLES))))
}

const ARRAYS = [
  'circles',
  'vertices',
  'vertexCircles',
  'edges',
  'hull',
  'nextSide',
  'vertexSides',
  'firstSide',
] as const

/** Functions that take a diagram, or are methods of one. */
const OF_DIAGRAMS: readonly (readonly [name: string, act: (diagram: Diagram) => unknown])[] = [
  ['new Diagram', (diagram) => new Diagram(diagram)],
  ['certify', (diagram) => library.certify(diagram)],
  ['edit', (diagram) => library.edit(new Diagram(diagram))],
  ['finalCells', (diagram) => library.finalCells(diagram, { box: BOUNDS, maxRadius: 1 } as never)],
  ['writeDiagram', (diagram) => files.writeDiagram(diagram)],
  ['vertexAt', (diagram) => vertexAt(diagram, 0)],
  ['edgeAt', (diagram) => edgeAt(diagram, 0)],
  ['edgeCurve', (diagram) => edgeCurve(diagram, 0)],
  ['closestPair', closestPair],
  ['convexHull', convexHull],
  ['mergeVertices', (diagram) => mergeVertices(diagram, 1)],
  ['clearestPath', (diagram) => clearestPath(diagram, { x: 1, y: 5 }, { x: 5, y: 1 })],
  ['largestEmptyDiscCenteredIn', (diagram) => largestEmptyDiscCenteredIn(diagram, { bounds: BOUNDS })],
  ['largestEmptyDiscCenteredInHull', largestEmptyDiscCenteredInHull],
  ['largestEmptyDiscInside', (diagram) => largestEmptyDiscInside(diagram, { bounds: BOUNDS })],
  ['find', (diagram) => diagram.find(1, 1)],
  ['findAll', (diagram) => diagram.findAll([1, 1])],
  ['cell', (diagram) => diagram.cell(0)],
  ['neighbors', (diagram) => diagram.neighbors(0)],
  ['contains', (diagram) => diagram.contains(0, 1, 1)],
  ['cellArea', (diagram) => diagram.cellArea(0, { bounds: BOUNDS })],
  ['cellAreas', (diagram) => diagram.cellAreas({ bounds: BOUNDS })],
  ['cellAreas in a region', (diagram) => diagram.cellAreas({ region })],
  ['cellCentroids', (diagram) => diagram.cellCentroids({ bounds: BOUNDS })],
  ['cellPolygons', (diagram) => [...diagram.cellPolygons({ bounds: BOUNDS })]],
  ['cellPath', (diagram) => diagram.cellPath(0, { bounds: BOUNDS })],
  ['render', (diagram) => diagram.render({ bounds: BOUNDS })],
  ['renderCircles', (diagram) => diagram.renderCircles()],
  ['renderDual', (diagram) => diagram.renderDual()],
  ['renderHull', (diagram) => diagram.renderHull()],
  ['hullPolygon', (diagram) => diagram.hullPolygon()],
  ['halfedges', (diagram) => diagram.halfedges],
  ['toJSON', (diagram) => diagram.toJSON()],
]

async function codeOf(act: () => unknown): Promise<string> {
  try {
    await act()
  } catch (error) {
    return (error as { code?: string }).code ?? String(error)
  }
  return 'no error'
}

describe.each(LOSSES)('an array %s is bad input', (_, lose) => {
  it.each(TAKERS)('for %s', async (_name, act, list) => {
    expect(await codeOf(() => act(lose(list()) as never))).toBe('badInput')
  })

  it.each(OF_DIAGRAMS)('in the diagram of %s', async (_name, act) => {
    for (const name of ARRAYS) {
      const diagram = library.compute(floats(...CIRCLES))
      Object.assign(diagram, { [name]: lose(diagram[name].slice()) })
      expect(await codeOf(() => act(diagram)), name).toBe('badInput')
    }
  })
})

describe('arrays that keep their memory', () => {
  const shared = (numbers: readonly number[]) => {
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
    const expected = library.compute(floats(...CIRCLES)).vertices
    expect(library.compute(shared(CIRCLES)).vertices).toEqual(expected)
    expect(library.compute(floats(7, ...CIRCLES, 7).subarray(1, 10)).vertices).toEqual(expected)
    expect(library.compute(floats(...CIRCLES)).findAll(shared([1, 1, 6, 1]))).toEqual(Int32Array.of(0, 1))
  })
})
