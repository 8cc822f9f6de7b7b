// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON format of the command line (circle_voronoi/io.h) as JavaScript values.
import { shown } from '../base/check.ts'
import {
  COORDINATE_LIMIT,
  COORDINATE_LIMIT_TEXT,
  COORDINATE_STEP,
  POWER_LIMIT,
  POWER_LIMIT_TEXT,
  POWER_STEP,
  roundAll,
  tooSmallMessage,
} from '../base/coordinate-limits.ts'
import { at, NONE } from '../base/diagram-data.ts'
import { CircleVoronoiError, type ErrorCode } from '../base/errors.ts'
import type { Certificate, Circle, Counts, DiagramData, Float64s, HiddenCircle, Seconds, Stats } from '../base/types.ts'
import { CANDIDATES, METHODS, METRICS, type Metric, WAYS } from '../base/types.ts'
import { linkSides } from './link-sides.ts'

const FORMAT = 'circle-voronoi'
const VERSION = 1

/**
 * A diagram as the command line writes and reads it. `metric` is missing if it is `circles`, and `weights` if radii are
 * not weights.
 *
 * @category Diagrams
 */
export interface DiagramFile {
  readonly format: 'circle-voronoi'
  readonly version: 1
  readonly metric?: Metric
  readonly weights?: true
  readonly circles: readonly Circle[]
  readonly hidden: readonly HiddenCircle[]
  readonly vertices: readonly {
    readonly x: number
    readonly y: number
    readonly r: number
    readonly circles: readonly number[]
  }[]
  readonly edges: readonly { readonly circles: readonly number[]; readonly vertices: readonly number[] }[]
  readonly hull: readonly number[]
  readonly stats: Stats & { readonly certificate: Certificate }
}

/** Returns a diagram as the value that `JSON.stringify` writes to a file. */
export function fileOf(diagram: DiagramData): DiagramFile {
  const { metric, weights, circles, vertices, vertexCircles, edges, hidden, hull, certificate, stats } = diagram
  const list = <Item>(array: Float64Array | Int32Array, size: number, item: (first: number) => Item): Item[] =>
    Array.from({ length: array.length / size }, (_, i) => item(i * size))
  return {
    format: FORMAT,
    version: VERSION,
    ...(metric !== 'circles' && { metric }),
    ...(weights && { weights }),
    circles: list(circles, 3, (k) => ({ x: at(circles, k), y: at(circles, k + 1), r: at(circles, k + 2) })),
    hidden: list(hidden, 2, (k) => ({ circle: at(hidden, k), by: at(hidden, k + 1) })),
    vertices: list(vertices, 3, (k) => ({
      x: at(vertices, k),
      y: at(vertices, k + 1),
      r: at(vertices, k + 2),
      circles: [...vertexCircles.subarray(k, k + 3)],
    })),
    edges: list(edges, 4, (k) => ({
      circles: [...edges.subarray(k, k + 2)],
      vertices: [...edges.subarray(k + 2, k + 4)],
    })),
    hull: [...hull],
    stats: { ...stats, certificate },
  }
}

/**
 * Reads a diagram from the text of a file or from its parsed value. The result has no certificate, whatever the file
 * says, but all indices are in range.
 */
export function dataFrom(json: unknown): DiagramData {
  const file = typeof json === 'string' ? parsed(json) : json
  const {
    format,
    version,
    metric = 'circles',
    weights = false,
    circles,
    hidden,
    vertices,
    edges,
    hull,
    stats,
  } = itemOf(file, 'the file')
  if (format !== FORMAT) refuse(`The format of the file is ${shown(format)}, not "${FORMAT}".`)
  if (version !== VERSION)
    refuse(`The version of the file is ${shown(version)}, not ${VERSION}, the only one that can be read.`)
  if (!METRICS.includes(metric as Metric)) refuse(`There is no metric ${shown(metric)}.`)
  if (typeof weights !== 'boolean') refuse(`weights is not true or false, but ${shown(weights)}.`)
  const circleCount = listOf(circles, 'circles').length
  const vertexCount = listOf(vertices, 'vertices').length
  const parts = {
    metric: metric as Metric,
    weights,
    circles: circlesOf(listOf(circles, 'circles'), weights, weights && metric === 'power'),
    vertices: Float64Array.from(
      listOf(vertices, 'vertices').flatMap((item, v) => {
        const { x, y, r } = itemOf(item, `vertices[${v}]`)
        return [numberOf(x, 'x', 'vertices', v), numberOf(y, 'y', 'vertices', v), numberOf(r, 'r', 'vertices', v)]
      }),
    ),
    vertexCircles: Int32Array.from(
      listOf(vertices, 'vertices').flatMap((item, v) =>
        indicesOf(itemOf(item, `vertices[${v}]`).circles, 3, 0, circleCount, `circles of vertices[${v}]`),
      ),
    ),
    edges: Int32Array.from(
      listOf(edges, 'edges').flatMap((item, e) => {
        const edge = itemOf(item, `edges[${e}]`)
        return [
          ...indicesOf(edge.circles, 2, 0, circleCount, `circles of edges[${e}]`),
          ...indicesOf(edge.vertices, 2, NONE, vertexCount, `vertices of edges[${e}]`),
        ]
      }),
    ),
    hidden: Int32Array.from(
      listOf(hidden, 'hidden').flatMap((item, i) => {
        const { circle, by } = itemOf(item, `hidden[${i}]`)
        // A hidden circle of a power diagram need not have a hiding circle.
        return [
          ...indicesOf([circle], 1, 0, circleCount, `circle of hidden[${i}]`),
          ...indicesOf([by], 1, metric === 'power' ? NONE : 0, circleCount, `by of hidden[${i}]`),
        ]
      }),
    ),
    hull: Int32Array.from(indicesOf(hull, undefined, 0, circleCount, 'hull')),
  }
  return {
    ...parts,
    ...linkSides(parts),
    certificate: {
      certified: false,
      flaw: 'notJudged',
      circle: NONE,
      vertex: NONE,
      edge: NONE,
      message: 'The diagram has not been judged.',
    },
    stats: statsOf(stats),
  }
}

type Item = Readonly<Record<string, unknown>>

function parsed(text: string): unknown {
  try {
    return JSON.parse(text)
  } catch (cause) {
    throw new CircleVoronoiError('badInput', `The text is no JSON: ${(cause as Error).message}.`, { cause })
  }
}

function itemOf(value: unknown, name: string): Item {
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    refuse(`${name} is no object, but ${shown(value)}.`)
  return value as Item
}

function listOf(value: unknown, name: string): readonly unknown[] {
  if (!Array.isArray(value))
    refuse(value === undefined ? `There is no list of ${name}.` : `${name} is no list, but ${shown(value)}.`)
  return value
}

function numberOf(value: unknown, name: string, list: string, i: number): number {
  if (typeof value !== 'number' || !Number.isFinite(value))
    refuse(`${name} of ${list}[${i}] is no finite number, but ${shown(value)}.`)
  return value
}

/** `hasPowers`: the weights are those of a power diagram, which are squares of lengths. */
function circlesOf(items: readonly unknown[], weights: boolean, hasPowers: boolean): Float64s {
  const numbers = Float64Array.from(items.flatMap((item, i) => circleOf(item, i, weights, hasPowers)))
  const lengthOf = (value: number, k: number) =>
    hasPowers && k % 3 === 2 ? Math.sqrt(Math.abs(value)) : Math.abs(value)
  const problem = tooSmallMessage(
    numbers.reduce((largest, value, k) => Math.max(largest, lengthOf(value, k)), 0),
    'The circles',
  )
  if (problem !== undefined) refuse(problem, 'coordinateTooSmall')
  return roundAll(numbers, hasPowers ? POWER_STEP : COORDINATE_STEP)
}

function circleOf(item: unknown, i: number, weights: boolean, hasPowers: boolean): number[] {
  const circle = itemOf(item, `circles[${i}]`)
  const numbers = ['x', 'y', 'r'].map((name) => numberOf(circle[name], name, 'circles', i))
  if (numbers.some((value, k) => !(hasPowers && k === 2) && Math.abs(value) > COORDINATE_LIMIT)) {
    refuse(`Circle ${i} has a coordinate or a radius beyond ${COORDINATE_LIMIT_TEXT}.`, 'coordinateTooLarge', i)
  }
  if (hasPowers && Math.abs(numbers[2] as number) > POWER_LIMIT) {
    refuse(`Circle ${i} has a weight beyond ${POWER_LIMIT_TEXT}.`, 'coordinateTooLarge', i)
  }
  if ((numbers[2] as number) < 0 && !weights) refuse(`Circle ${i} has a negative radius.`, 'negativeRadius', i)
  return numbers
}

/** Reads `size` whole numbers from `first` up to but not including `count`. */
function indicesOf(value: unknown, size: number | undefined, first: number, count: number, name: string): number[] {
  const list = listOf(value, name)
  if (size !== undefined && list.length !== size) refuse(`${name} are ${list.length} numbers, not ${size}.`)
  for (const index of list) {
    if (!Number.isInteger(index) || (index as number) < first || (index as number) >= count) {
      refuse(`${name}: ${shown(index)} is no index from ${first} to ${count - 1}.`)
    }
  }
  return list as number[]
}

/** Reads the existing fields. Missing and invalid fields are empty, as on the command line. */
export function statsOf(value: unknown): Stats {
  const part = (item: unknown, name: string): unknown => Object(item)[name]
  const nameOf = <Name extends string>(list: string, known: readonly Name[]): Name | '' =>
    known.find((name) => name === part(value, list)) ?? ''
  const numbers = <Numbers extends object>(list: string, none: Numbers, fits: (item: unknown) => boolean): Numbers => {
    const given = Object.entries(Object(part(value, list))).filter(([name, item]) => name in none && fits(item))
    return { ...none, ...Object.fromEntries(given) }
  }
  const isCount = (item: unknown) => Number.isSafeInteger(item) && (item as number) >= 0
  return {
    method: nameOf('method', METHODS),
    way: nameOf('way', WAYS),
    candidates: nameOf('candidates', CANDIDATES),
    counts: numbers('counts', NO_COUNTS, isCount),
    seconds: numbers('seconds', NO_SECONDS, Number.isFinite),
  }
}

const NO_COUNTS: Counts = {
  circles: 0,
  hidden: 0,
  samples: 0,
  antipodalDiscs: 0,
  threeTouchDiscs: 0,
  events: 0,
  leftoverCycles: 0,
  resamplings: 0,
  flips: 0,
  repairs: 0,
  filtered: 0,
  refined: 0,
  inCircle: 0,
  exact: 0,
}
const NO_SECONDS: Seconds = {
  order: 0,
  triangulate: 0,
  sample: 0,
  pair: 0,
  touch: 0,
  flip: 0,
  repair: 0,
  certify: 0,
  assemble: 0,
  total: 0,
}

function refuse(message: string, code: ErrorCode = 'badInput', circle?: number): never {
  throw new CircleVoronoiError(code, message, { circle })
}
