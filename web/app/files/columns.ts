// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the columns of centers and radii in tables of other programs.
import { type DataColumn, NO_ATTRIBUTES } from '../../editing/attributes.ts'
import type { NamedCircles } from '../csv.ts'

/** A table of text fields. */
export interface Rows {
  /** The names of the columns; numbers if the table has no header. */
  readonly heading: readonly string[]
  readonly hasHeading: boolean
  readonly rows: readonly (readonly string[])[]
  readonly hasDecimalCommas: boolean
}

/** The columns of centers and radii; all circles may share one radius. */
export interface Columns {
  readonly x: number
  readonly y: number
  readonly r: number | { readonly all: number }
  readonly name: number | undefined
}

const NAMES: Readonly<Record<'x' | 'y' | 'r' | 'd' | 'name', RegExp>> = {
  x: /^(x|cx|x ?(coord|koord|pos|wert|value|center|centre).*|(center|centre|pos|position) ?x|lon|long|lng|longitude|länge|längengrad|east|easting|rechtswert)$/,
  y: /^(y|cy|y ?(coord|koord|pos|wert|value|center|centre).*|(center|centre|pos|position) ?y|lat|latitude|breite|breitengrad|north|northing|hochwert)$/,
  r: /^(r|rad|radi(us|en|i)?|radius .*|weight|gewicht)$/,
  d: /^(d|diam|diameter|durchmesser|dbh|bhd)$/,
  name: /^(name|label|title|id|ort|stadt|city|place|bezeichnung|beschriftung)$/,
}
/** Separators by decreasing reliability. */
const SEPARATORS = ['\t', ';', '|', ','] as const
/** Number of lines that determine the separator. */
const LOOKED_AT = 50

/** Parses text as a table, if most of its rows have at least two columns of numbers. */
export function rowsOf(text: string): Rows | undefined {
  const lines = text
    .replace(/^\uFEFF/, '')
    .split(/\r?\n/)
    .filter((line) => line.trim() !== '')
  const separator = separatorOf(lines.slice(0, LOOKED_AT))
  if (separator === undefined) return undefined
  const table = lines.map((line) => fieldsOf(line, separator))
  const hasDecimalCommas = separator !== ',' && table.some((row) => row.some((field) => /^-?\d+,\d+$/.test(field)))
  const [first = []] = table
  const hasHeading = !first.some((field) => isNumber(numberOf(field, hasDecimalCommas)))
  const rows = hasHeading ? table.slice(1) : table
  const heading = hasHeading ? first : first.map((_, k) => `Column ${k + 1}`)
  const found = { heading, hasHeading, rows, hasDecimalCommas }
  return heading.filter((_, k) => isNumeric(valuesIn(found, k))).length < 2 ? undefined : found
}

/** The columns besides centers and radii. A column has a single type: numbers if all of its fields are numbers. */
export function otherColumns(rows: Rows, used: readonly (number | undefined)[]): DataColumn[] {
  return rows.heading.flatMap((name, k) => (used.includes(k) ? [] : [{ name, values: jsonIn(rows, k) }]))
}

function jsonIn({ rows, hasDecimalCommas }: Rows, column: number): string[] {
  const fields = rows.map((row) => row[column] ?? '')
  const numerals = fields.map((field) => (hasDecimalCommas ? field.replace(',', '.') : field))
  const isOfNumbers = numerals.every((field) => field === '' || /^-?(0|[1-9]\d*)(\.\d+)?(e[-+]?\d+)?$/i.test(field))
  if (isOfNumbers) return numerals.map((field) => field || 'null')
  return fields.map((field) => (field === '' ? 'null' : JSON.stringify(field)))
}

function valuesIn({ rows, hasDecimalCommas }: Rows, column: number): number[] {
  return rows.map((row) => numberOf(row[column] ?? '', hasDecimalCommas))
}

/** Whether most of the values are numbers. */
export function isNumeric(values: readonly number[]): boolean {
  return values.filter(isNumber).length > values.length / 2
}

function isNumber(value: number): boolean {
  return !Number.isNaN(value)
}

/** Guesses the columns from their names, where possible. */
export function guessedColumns({
  heading,
}: Pick<Rows, 'heading'>): Partial<Columns> & { readonly isDiameter?: boolean } {
  const normal = heading.map((name) =>
    name
      .toLowerCase()
      .replace(/[_\-.()[\]]+/g, ' ')
      .trim(),
  )
  const find = (kind: keyof typeof NAMES) => {
    const place = normal.findIndex((name) => NAMES[kind].test(name))
    return place < 0 ? undefined : place
  }
  const [x, y, r, d, name] = [find('x'), find('y'), find('r'), find('d'), find('name')]
  const radius = r ?? d
  return {
    ...(x !== undefined && { x }),
    ...(y !== undefined && { y }),
    ...(radius !== undefined && { r: radius }),
    name,
    isDiameter: r === undefined && d !== undefined,
  }
}

/** @throws Error that names the first invalid row */
export function circlesFrom(rows: Rows, columns: Columns, isDiameter: boolean, file: string): NamedCircles {
  const circles = new Float64Array(3 * rows.rows.length)
  const { x, y, r } = columns
  for (const [k, row] of rows.rows.entries()) {
    const value = (column: number) => numberOf(row[column] ?? '', rows.hasDecimalCommas)
    const radius = typeof r === 'number' ? value(r) / (isDiameter ? 2 : 1) : r.all
    const circle = [value(x), value(y), radius]
    const wrong = circle.findIndex((number) => !Number.isFinite(number))
    if (wrong >= 0) {
      const column = [x, y, typeof r === 'number' ? r : 0][wrong] as number
      throw new Error(
        `${file}, row ${k + 1}: “${row[column] ?? ''}” in column ${rows.heading[column]} is not a number.`,
      )
    }
    if (radius < 0) throw new Error(`${file}, row ${k + 1}: the radius must not be negative (got ${radius}).`)
    circles.set(circle, 3 * k)
  }
  const columnsBeside = otherColumns(rows, [x, y, typeof r === 'number' ? r : undefined])
  return { circles, ...(columnsBeside.length > 0 && { attributes: { ...NO_ATTRIBUTES, columns: columnsBeside } }) }
}

function separatorOf(lines: readonly string[]): string | undefined {
  const isEven = (separator: string) => {
    const counts = lines.map((line) => fieldsOf(line, separator).length)
    return (counts[0] as number) > 1 && counts.every((count) => count === counts[0])
  }
  return lines.length === 0 ? undefined : SEPARATORS.find(isEven)
}

/** Splits a line. Separators in quotation marks belong to a field. */
function fieldsOf(line: string, separator: string): string[] {
  const fields: string[] = []
  let field = ''
  let isQuoted = false
  for (const letter of line) {
    if (letter === '"') isQuoted = !isQuoted
    else if (letter === separator && !isQuoted) {
      fields.push(field.trim())
      field = ''
    } else field += letter
  }
  return [...fields, field.trim()]
}

function numberOf(field: string, hasDecimalCommas: boolean): number {
  if (field === '') return Number.NaN
  return Number(hasDecimalCommas ? field.replace(',', '.') : field)
}
