// SPDX-License-Identifier: GPL-3.0-or-later
// Reads circles from text with the same results as `readCircles` of `circle-voronoi/files` (table-text.ts gives the
// reason).
import { isRecord } from '../lib/base/check.ts'
import { COORDINATE_LIMIT } from '../lib/base/coordinate-limits.ts'
import type { Float64s } from '../lib/index.ts'
import { hexPoints, type TextPoints } from './hex-points.ts'
import { COLOR_COLUMN, NAME_COLUMN } from './identity-columns.ts'
import {
  filled,
  NumberReader,
  namedSeparator,
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
  // JSON lines may have the record separators of RFC 8142.
  const content = text.replace(/^\uFEFF/, '').replaceAll('\x1E', '\n')
  if (!/^\s*[[{]/.test(content)) return circlesOfTable(content)
  try {
    return circlesOfJson(JSON.parse(content))
  } catch (error) {
    if (error instanceof TextProblem) throw error
    const lines = linesOfJson(content)
    if (lines === undefined) throw new TextProblem((error as Error).message)
    return circlesOfFeatures(lines)
  }
}

/** The values of a text with a Feature or a geometry on each line; `undefined` if it is no such text. */
function linesOfJson(text: string): unknown[] | undefined {
  try {
    const values = text.split(/[\r\n]+/).flatMap((line) => (line.trim() === '' ? [] : [JSON.parse(line) as unknown]))
    return isFeature(values[0]) ? values : undefined
  } catch {
    return undefined
  }
}

/** Reads circles from parsed JSON. @throws TextProblem */
export function circlesOfJson(given: unknown): TextCircles {
  if (Array.isArray(given)) return { circles: numbersOf(given, circleOfItem), columns: identitiesIn(given) }
  if (isFeature(given)) return circlesOfFeatures([given])
  if (!isRecord(given) || given.type !== 'FeatureCollection' || !Array.isArray(given.features)) {
    throw new TextProblem('expected an array of circles, or a GeoJSON FeatureCollection or Feature')
  }
  return circlesOfFeatures(given.features)
}

/** Returns whether a value is a Feature or a geometry of GeoJSON. */
function isFeature(given: unknown): boolean {
  return isRecord(given) && given.features === undefined && (given.type === 'Feature' || 'coordinates' in given)
}

/** Reads Features. Each point of a MultiPoint is a circle. */
function circlesOfFeatures(features: readonly unknown[]): TextCircles {
  const points = features.flatMap((feature, circle) => {
    const given = isRecord(feature) ? feature.properties : undefined
    const properties = isRecord(given) ? given : {}
    const radius = namedValue(properties, RADIUS)
    return pointsOfFeature(feature).map(([x, y]) => {
      const numbers = [x, y, radius]
      if (!isCircle(numbers)) throw new TextProblem('not a circle', { circle })
      return { numbers: numbers as number[], properties }
    })
  })
  return {
    circles: Float64Array.from(points.flatMap(({ numbers }) => numbers)),
    columns: identitiesIn(points.map(({ properties }) => properties)),
  }
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

/** The positions of a Feature; one that is no circle if it has none. */
function pointsOfFeature(feature: unknown): readonly (readonly unknown[])[] {
  const geometry = isRecord(feature) && feature.type === 'Feature' ? feature.geometry : undefined
  if (!isRecord(geometry) || !Array.isArray(geometry.coordinates)) return [[]]
  const { type, coordinates } = geometry
  if (type === 'Point') return [coordinates]
  return type === 'MultiPoint' && coordinates.length > 0 && coordinates.every(Array.isArray) ? coordinates : [[]]
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
  const named = namedSeparator(text)
  for (const separator of SEPARATORS) {
    if (named !== undefined && separator !== named) continue
    let first: TextRow | undefined
    try {
      ;[first] = recordsOf(text, separator)
    } catch (error) {
      // Another separator may give quotation marks another meaning, so that reading can still succeed.
      failed ??= error
      continue
    }
    if (first === undefined) throw new TextProblem('no circles')
    if (isHeaderOrCircle(first, separator)) return circlesOfRows([...recordsOf(text, separator)], separator)
    line ??= first.line
    if (!/POINT|\b0[01][\da-f]{40}/i.test(text)) continue
    const rows = [...recordsOf(text, separator)]
    if (pointColumnsOf(rows) !== undefined) return circlesOfRows(rows, separator)
  }
  throw line === undefined
    ? (failed ?? new TextProblem('no separator', { line: 1 }))
    : new TextProblem('not three numbers', { line })
}

/** Returns whether the first row of a table names the columns or is a circle. @throws TextProblem if two columns mean one */
export function isHeaderOrCircle(first: TextRow, separator: Separator): boolean {
  return columnsOf(first) !== undefined || isThreeNumbers(first.fields, separator)
}

/** Reads circles from rows. The first row may be a header. @throws TextProblem */
export function circlesOfRows(rows: readonly TextRow[], separator: Separator): TextCircles {
  const header = rows[0] === undefined ? undefined : columnsOf(rows[0])
  const points = header === undefined ? pointColumnsOf(rows) : undefined
  const hasHeader = header !== undefined || points !== undefined
  const columns = header ?? (points === undefined ? [0, 1, 2] : [points.radius])
  const width = hasHeader ? (rows[0] as TextRow).fields.length : 3
  const reader = new NumberReader(separator)
  const srids = new Set<string>()
  const circles = rows.slice(hasHeader ? 1 : 0).flatMap((row) => {
    const { line, fields: given } = row
    const fields = given.length > width ? filled(given) : given
    const isRow = hasHeader ? fields.length <= width : fields.length === width
    const numbers = columns.map((column) => reader.read(fields[column] ?? { text: '', isQuoted: false }))
    const wkt = points === undefined ? undefined : wktPoints(fields[points.place]?.text ?? '')
    if (wkt?.srid !== undefined) srids.add(wkt.srid)
    const all = points === undefined ? [numbers] : (wkt?.points ?? []).map((point) => [...point, ...numbers])
    if (!isRow || all.length === 0 || !all.every(isCircle) || srids.size > 1) {
      throw new TextProblem('not three numbers', { line })
    }
    return all.map((circle) => ({ circle: circle as number[], row }))
  })
  const names = hasHeader ? (rows[0] as TextRow).fields.map(({ text }, k) => [text, k] as const) : []
  const identities = names.filter(([name]) => isIdentity(name))
  const recordOf = ({ fields }: TextRow) => Object.fromEntries(identities.map(([name, k]) => [name, fields[k]?.text]))
  const named = identities.length === 0 ? [] : identitiesIn(circles.map(({ row }) => recordOf(row)))
  return { circles: Float64Array.from(circles.flatMap(({ circle }) => circle)), columns: named }
}

/** The columns of points as well-known text and of radii, below a header; `undefined` if there are none. */
function pointColumnsOf([header, ...rows]: readonly TextRow[]): { place: number; radius: number } | undefined {
  const names = header?.fields.map(({ text }) => text.toLowerCase()) ?? []
  const [radius, other] = names.flatMap((name, k) =>
    (USUAL_NAMES[RADIUS] as readonly string[]).includes(name) ? [k] : [],
  )
  if (radius === undefined || other !== undefined) return undefined
  const placesOf = ({ fields }: TextRow) =>
    [...names.keys()].filter((k) => wktPoints(fields[k]?.text ?? '') !== undefined)
  const first = rows.find((row) => placesOf(row).length > 0)
  const [place, second] = first === undefined ? [] : placesOf(first)
  if (second !== undefined) throw new TextProblem('two columns of points', { line: first?.line })
  return place === undefined ? undefined : { place, radius }
}

const WKT = /^\s*(?:SRID\s*=\s*(\d+)\s*;)?\s*(MULTI)?POINT\s*(?:ZM|Z|M)?\s*\((.*)\)\s*;?\s*$/i

/** The positions of a POINT or a MULTIPOINT, also in hexadecimal digits; `undefined` if a text is neither. */
function wktPoints(text: string): TextPoints | undefined {
  const binary = hexPoints(text)
  if (binary !== undefined) return binary
  const [, srid, multi, inside] = WKT.exec(text) ?? []
  if (inside === undefined) return undefined
  const positions =
    multi === undefined
      ? [inside]
      : inside
          .split(',')
          .flatMap((part) => (/^\s*EMPTY\s*$/i.test(part) ? [] : [part.replace(/^\s*\((.*)\)\s*$/, '$1')]))
  const points = positions.map((position) =>
    position
      .trim()
      .split(/\s+/)
      .map((text) => new NumberReader(',').read({ text, isQuoted: false })),
  )
  const arePoints = points.length > 0 && points.every((point) => point.length > 1 && !point.includes(undefined))
  return arePoints ? { srid, points: points.map((point) => point.slice(0, 2) as number[]) } : undefined
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
