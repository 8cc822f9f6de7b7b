// SPDX-License-Identifier: GPL-3.0-or-later
// Circles as text, read as `readCircles` of `circle-voronoi/files` reads them (table-text.ts says why).
import { isRecord } from '../lib/base/check.ts'
import { COORDINATE_LIMIT } from '../lib/base/coordinate-limits.ts'
import type { Float64s } from '../lib/index.ts'
import {
  filled,
  NumberReader,
  recordsOf,
  SEPARATORS,
  type Separator,
  type TableField,
  TextProblem,
} from './table-text.ts'

/** The names of columns, members and properties (`cpp/src/io/column_names.cpp`). */
const NAMES = [
  ['x', 'cx', 'lon', 'long', 'lng', 'longitude', 'easting'],
  ['y', 'cy', 'lat', 'latitude', 'northing'],
  ['r', 'rad', 'radius'],
] as const
const RADIUS = 2

/** Rows of a table, wherever it comes from. */
export interface TextRow {
  readonly fields: readonly TableField[]
  /** The line, or the number of the row, from 1. */
  readonly line: number
}

/** @throws TextProblem */
export function circlesOfText(text: string): Float64s {
  const content = text.replace(/^\uFEFF/, '')
  if (!/^\s*[[{]/.test(content)) return circlesOfTable(content)
  let given: unknown
  try {
    given = JSON.parse(content)
  } catch (error) {
    throw new TextProblem((error as Error).message)
  }
  return circlesOfJson(given)
}

/** The circles of JSON that was parsed. @throws TextProblem */
export function circlesOfJson(given: unknown): Float64s {
  if (Array.isArray(given)) return numbersOf(given, circleOfItem)
  if (!isRecord(given) || given.type !== 'FeatureCollection' || !Array.isArray(given.features)) {
    throw new TextProblem('expected an array of circles or a GeoJSON FeatureCollection')
  }
  return numbersOf(given.features, circleOfFeature)
}

function numbersOf(items: readonly unknown[], circleOf: (item: unknown) => readonly unknown[] | undefined): Float64s {
  const circles = new Float64Array(3 * items.length)
  for (const [k, item] of items.entries()) {
    const circle = circleOf(item)
    if (circle?.length !== 3 || !isCircle(circle)) throw new TextProblem('not a circle', { circle: k })
    circles.set(circle as number[], 3 * k)
  }
  return circles
}

function circleOfItem(item: unknown): readonly unknown[] | undefined {
  if (Array.isArray(item)) return item
  return isRecord(item) ? NAMES.map((_, k) => namedValue(item, k)) : undefined
}

function circleOfFeature(feature: unknown): readonly unknown[] | undefined {
  if (!isRecord(feature) || feature.type !== 'Feature' || !isRecord(feature.geometry)) return undefined
  const { type, coordinates } = feature.geometry
  const isOnePoint = type === 'MultiPoint' && Array.isArray(coordinates) && coordinates.length === 1
  const point: unknown = isOnePoint ? coordinates[0] : type === 'Point' ? coordinates : undefined
  if (!Array.isArray(point)) return undefined
  return [point[0], point[1], isRecord(feature.properties) ? namedValue(feature.properties, RADIUS) : undefined]
}

/** The member of an object that means x, y or r: the first one in the list of names that has a number. */
function namedValue(object: Readonly<Record<string, unknown>>, k: number): unknown {
  const keys = Object.keys(object)
  const named = (NAMES[k] as readonly string[]).flatMap((name) => keys.filter((key) => key.toLowerCase() === name))
  return object[named.find((key) => typeof object[key] === 'number') ?? '']
}

function isCircle(circle: readonly unknown[]): boolean {
  const isEachRight = circle.every((value) => Number.isFinite(value) && Math.abs(value as number) <= COORDINATE_LIMIT)
  return isEachRight && (circle[RADIUS] as number) >= 0
}

function circlesOfTable(text: string): Float64s {
  let failed: unknown
  let line: number | undefined
  for (const separator of SEPARATORS) {
    let first: TextRow | undefined
    try {
      ;[first] = recordsOf(text, separator)
    } catch (error) {
      // Quotation marks mean something else with another separator.
      failed ??= error
      continue
    }
    if (first === undefined) throw new TextProblem('no circles')
    if (columnsOf(first) !== undefined || isThreeNumbers(first.fields, separator)) {
      return circlesOfRows([...recordsOf(text, separator)], separator)
    }
    line ??= first.line
  }
  throw line === undefined ? failed : new TextProblem('not three numbers', { line })
}

/** The circles of rows, the first of which may name the columns. @throws TextProblem */
export function circlesOfRows(rows: readonly TextRow[], separator: Separator): Float64s {
  const header = rows[0] === undefined ? undefined : columnsOf(rows[0])
  const columns = header ?? [0, 1, 2]
  const width = header === undefined ? 3 : (rows[0] as TextRow).fields.length
  const reader = new NumberReader(separator)
  const circles = rows.slice(header === undefined ? 0 : 1).map(({ line, fields: given }) => {
    const fields = given.length > width ? filled(given) : given
    const isRow = header === undefined ? fields.length === width : fields.length <= width
    const circle = columns.map((column) => reader.read(fields[column] ?? { text: '', isQuoted: false }))
    if (!isRow || !isCircle(circle)) throw new TextProblem('not three numbers', { line })
    return circle as number[]
  })
  return Float64Array.from(circles.flat())
}

/** The columns that a header names; `undefined` if it does not name all three. @throws TextProblem if two mean one */
function columnsOf({ fields, line }: TextRow): readonly number[] | undefined {
  const names = fields.map(({ text }) => text.toLowerCase())
  const found = NAMES.map((known) =>
    names.flatMap((name, k) => ((known as readonly string[]).includes(name) ? [k] : [])),
  )
  if (found.some((places) => places.length === 0)) return undefined
  if (found.some((places) => places.length > 1)) throw new TextProblem('two columns mean one', { line })
  return found.map(([place]) => place as number)
}

function isThreeNumbers(fields: readonly TableField[], separator: Separator): boolean {
  const given = filled(fields)
  // Each of them alone: whether their decimal marks are one is said of the row.
  return given.length === 3 && given.every((field) => new NumberReader(separator).read(field) !== undefined)
}
