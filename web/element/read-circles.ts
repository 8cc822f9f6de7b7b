// SPDX-License-Identifier: GPL-3.0-or-later
// Small readers for what a page says of circles. Those of `circle-voronoi/files` read more, and are ten times as large.
import { isRecord } from '../lib/base/check.ts'
import { type Circles, coordinatesOf } from '../lib/base/coordinates.ts'
import type { Float64s } from '../lib/index.ts'
import { parseJson } from './attributes.ts'
import { type ElementRefusals, refuse } from './refusals.ts'

/** What a header may call the columns. */
const NAMES = [
  ['x', 'cx', 'lon', 'longitude'],
  ['y', 'cy', 'lat', 'latitude'],
  ['r', 'rad', 'radius'],
] as const
/** In the order in which they are tried: a comma may be a decimal mark, and spaces stand beside separators. */
const SEPARATORS = [';', '\t', ',', ' ']
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i

/**
 * Circles of a text: JSON (`[[x, y, r], ...]`, objects, or an object with `circles`), GeoJSON points with a property r, or
 * CSV. Numbers are those that `readCircles` of `circle-voronoi/files` reads, to the bit; what it may refuse to guess is
 * refused here.
 *
 * @throws CircleVoronoiError `badInput`
 */
export function readCircles(text: string): Float64s {
  return /^\s*[[{]/.test(text) ? circlesOfJson(text) : circlesOfRows(rowsOf(text))
}

/** Those of a table: a row for each, three numbers or what a header row names. */
export function circlesOfTable(table: HTMLTableElement): Float64s {
  return circlesOfRows(
    Array.from(table.rows, (row, k) => ({
      place: (words) => words.row(k + 1),
      fields: Array.from(row.cells, (cell) => (cell.textContent ?? '').trim()),
    })),
  )
}

function circlesOfJson(text: string): Float64s {
  const given = parseJson(text, (words) => words.circles)
  if (isRecord(given) && Array.isArray(given.features)) return coordinatesOf(given.features.map(circleOfFeature))
  const list = isRecord(given) ? given.circles : given
  // As the arrays of a diagram are written.
  const isFlat = Array.isArray(list) && typeof list[0] === 'number'
  return coordinatesOf(isFlat ? Float64Array.from(list as number[]) : (list as Circles))
}

function circleOfFeature(feature: unknown): number[] {
  const { geometry, properties } = (feature ?? {}) as Record<string, Record<string, unknown> | null>
  const [x, y] = geometry?.type === 'Point' && Array.isArray(geometry.coordinates) ? geometry.coordinates : []
  return [x, y, properties?.r] as number[]
}

interface Row {
  /** What it is called in errors. */
  place(words: ElementRefusals): string
  readonly fields: readonly string[]
}

function rowsOf(text: string): Row[] {
  const lines = text.replace(/^\uFEFF/, '').split(/\r\n?|\n/)
  const known = lines.map((line, k) => ({ line: line.trim(), place: (words: ElementRefusals) => words.line(k + 1) }))
  const said = known.filter(({ line }) => line !== '' && !line.startsWith('#'))
  const first = said[0]?.line ?? ''
  const separator = SEPARATORS.find((mark) => first.includes(mark)) ?? ','
  // Between columns that are aligned there are many.
  const between = separator === ' ' ? / +/ : separator
  return said.map(({ line, place }) => {
    const fields = line.split(between).map((field) => field.trim().replace(/^"([^"]*)"$/, '$1'))
    while (fields.length > 3 && fields.at(-1) === '') fields.pop()
    return { place, fields: separator === ',' ? fields : fields.map((field) => field.replace(',', '.')) }
  })
}

/** A header says which columns these are; without one there are three. */
function circlesOfRows(rows: readonly Row[]): Float64s {
  const header = rows[0]?.fields.map((name) => name.toLowerCase()) ?? []
  const named = NAMES.map((names) => header.findIndex((name) => (names as readonly string[]).includes(name)))
  const isNamed = named.every((column) => column >= 0)
  const columns = isNamed ? named : [0, 1, 2]
  const numbers: number[] = []
  for (const { place, fields } of isNamed ? rows.slice(1) : rows) {
    const texts = columns.map((column) => fields[column] ?? '')
    if (!texts.every((field) => NUMBER.test(field)) || (!isNamed && fields.length !== 3)) {
      refuse((words) => words.notThree(place(words), fields.join(' ')), 'badInput')
    }
    numbers.push(...texts.map(Number))
  }
  if (numbers.length === 0) refuse((words) => words.noCircles, 'badInput')
  return Float64Array.from(numbers)
}
