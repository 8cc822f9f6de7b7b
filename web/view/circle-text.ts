// SPDX-License-Identifier: GPL-3.0-or-later
// Reads circles from text with the same results as `readCircles` of `circle-voronoi/files` (table-text.ts gives the
// reason).
import { isRecord } from '../lib/base/check.ts'
import { COORDINATE_LIMIT } from '../lib/base/coordinate-limits.ts'
import type { Float64s } from '../lib/index.ts'
import { COLOR_COLUMN, NAME_COLUMN } from './identity-columns.ts'
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
export const USUAL_NAMES = [
  ['x', 'cx', 'lon', 'long', 'lng', 'longitude', 'easting'],
  ['y', 'cy', 'lat', 'latitude', 'northing'],
  ['r', 'rad', 'radius'],
] as const
const RADIUS = 2

/** A row of a table from any source. */
export interface TextRow {
  readonly fields: readonly TableField[]
  /** The number of the line or row, from 1. */
  readonly line: number
}

/** Texts about circles, as JSON: one for each circle, empty where there is none. */
export interface TextColumn {
  readonly name: string
  readonly values: readonly string[]
}

/** Circles of a text, with the columns of their names and colors. */
export interface TextCircles {
  readonly circles: Float64s
  readonly columns: readonly TextColumn[]
}

/** @throws TextProblem */
export function circlesOfText(text: string): Float64s {
  return namedCirclesOfText(text).circles
}

/** @throws TextProblem */
export function namedCirclesOfText(text: string): TextCircles {
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

/** Reads circles from parsed JSON. @throws TextProblem */
export function circlesOfJson(given: unknown): TextCircles {
  if (Array.isArray(given)) return { circles: numbersOf(given, circleOfItem), columns: identitiesIn(given) }
  if (!isRecord(given) || given.type !== 'FeatureCollection' || !Array.isArray(given.features)) {
    throw new TextProblem('expected an array of circles or a GeoJSON FeatureCollection')
  }
  const circles = numbersOf(given.features, circleOfFeature)
  return { circles, columns: identitiesIn(given.features.map(({ properties }) => properties)) }
}

/** The names and colors among the members of objects. */
export function identitiesIn(items: readonly unknown[]): TextColumn[] {
  const columns = new Map<string, string[]>()
  for (const [k, item] of items.entries()) {
    for (const [name, value] of isRecord(item) ? Object.entries(item) : []) {
      if (typeof value !== 'string' || value.trim() === '' || !isIdentity(name)) continue
      const values = columns.get(name) ?? Array<string>(items.length).fill('')
      columns.set(name, values)
      values[k] = JSON.stringify(value)
    }
  }
  return [...columns].map(([name, values]) => ({ name, values }))
}

function isIdentity(name: string): boolean {
  return NAME_COLUMN.test(name) || COLOR_COLUMN.test(name)
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
  return isRecord(item) ? USUAL_NAMES.map((_, k) => namedValue(item, k)) : undefined
}

function circleOfFeature(feature: unknown): readonly unknown[] | undefined {
  if (!isRecord(feature) || feature.type !== 'Feature' || !isRecord(feature.geometry)) return undefined
  const { type, coordinates } = feature.geometry
  const isOnePoint = type === 'MultiPoint' && Array.isArray(coordinates) && coordinates.length === 1
  const point: unknown = isOnePoint ? coordinates[0] : type === 'Point' ? coordinates : undefined
  if (!Array.isArray(point)) return undefined
  return [point[0], point[1], isRecord(feature.properties) ? namedValue(feature.properties, RADIUS) : undefined]
}

/** The member of an object for x, y or r: the first name of the list with a numeric value. */
function namedValue(object: Readonly<Record<string, unknown>>, k: number): unknown {
  const keys = Object.keys(object)
  const named = (USUAL_NAMES[k] as readonly string[]).map((name) => keys.filter((key) => key.toLowerCase() === name))
  // Two keys mean the same.
  if (named.some(({ length }) => length > 1)) return undefined
  return object[named.flat().find((key) => typeof object[key] === 'number') ?? '']
}

function isCircle(circle: readonly unknown[]): boolean {
  const isEachRight = circle.every((value) => Number.isFinite(value) && Math.abs(value as number) <= COORDINATE_LIMIT)
  return isEachRight && (circle[RADIUS] as number) >= 0
}

function circlesOfTable(text: string): TextCircles {
  let failed: unknown
  let line: number | undefined
  for (const separator of SEPARATORS) {
    let first: TextRow | undefined
    try {
      ;[first] = recordsOf(text, separator)
    } catch (error) {
      // Another separator may give quotation marks another meaning, so that reading can still succeed.
      failed ??= error
      continue
    }
    if (first === undefined) throw new TextProblem('no circles')
    if (isHeaderOrCircle(first, separator)) {
      return circlesOfRows([...recordsOf(text, separator)], separator)
    }
    line ??= first.line
  }
  throw line === undefined ? failed : new TextProblem('not three numbers', { line })
}

/** Returns whether the first row of a table names the columns or is a circle. @throws TextProblem if two columns mean one */
export function isHeaderOrCircle(first: TextRow, separator: Separator): boolean {
  return columnsOf(first) !== undefined || isThreeNumbers(first.fields, separator)
}

/** Reads circles from rows. The first row may be a header. @throws TextProblem */
export function circlesOfRows(rows: readonly TextRow[], separator: Separator): TextCircles {
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
  const names = header === undefined ? [] : (rows[0] as TextRow).fields.map(({ text }, k) => [text, k] as const)
  const identities = names.filter(([name]) => isIdentity(name))
  const recordOf = ({ fields }: TextRow) => Object.fromEntries(identities.map(([name, k]) => [name, fields[k]?.text]))
  const named = identities.length === 0 ? [] : identitiesIn(rows.slice(1).map(recordOf))
  return { circles: Float64Array.from(circles.flat()), columns: named }
}

/**
 * The columns that a header names; `undefined` if a coordinate is missing. @throws TextProblem if two columns name the
 * same one
 */
function columnsOf({ fields, line }: TextRow): readonly number[] | undefined {
  const names = fields.map(({ text }) => text.toLowerCase())
  const found = USUAL_NAMES.map((known) =>
    names.flatMap((name, k) => ((known as readonly string[]).includes(name) ? [k] : [])),
  )
  if (found.some((places) => places.length === 0)) return undefined
  if (found.some((places) => places.length > 1)) throw new TextProblem('two columns mean one', { line })
  return found.map(([place]) => place as number)
}

function isThreeNumbers(fields: readonly TableField[], separator: Separator): boolean {
  const given = filled(fields)
  // Tests each field alone, because the row's error reports fields with different decimal marks.
  return given.length === 3 && given.every((field) => new NumberReader(separator).read(field) !== undefined)
}
