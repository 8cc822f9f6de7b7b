// SPDX-License-Identifier: GPL-3.0-or-later
// Guesses which columns of a table are centers and radii, where the readers do not know their names.
import { isRecord } from '../../lib/base/check.ts'
import { isHeaderOrCircle } from '../../view/circle-text.ts'
import { filled, NumberReader, recordsOf, SEPARATORS, type Separator, type TableRecord } from '../../view/table-text.ts'

/** A table as text. */
export interface Table {
  /** The names of the columns. A column without a name has a number. */
  readonly heading: readonly string[]
  readonly hasHeading: boolean
  readonly rows: readonly (readonly string[])[]
  /** Whether each column has a number in any row. */
  readonly hasNumbers: readonly boolean[]
}

/** The indices of columns. All circles may have the same radius. */
export interface Columns {
  readonly x: number
  readonly y: number
  readonly r: number | { readonly all: number }
}

/** The names of three columns. */
export interface ColumnNames {
  readonly x: string
  readonly y: string
  /** `undefined` if no column has the radii. */
  readonly radius: string | undefined
}

const LONGITUDE = /^((decimal|geo) ?)?(lon|long|lng|longitude|länge|längengrad)( (deg|degrees|dd|wgs ?84))?$/
const LATITUDE = /^((decimal|geo) ?)?(lat|latitude|breite|breitengrad)( (deg|degrees|dd|wgs ?84))?$/
const NAMES: Readonly<Record<'x' | 'y' | 'r' | 'd', RegExp>> = {
  x: /^(x|cx|x ?(coord|koord|pos|wert|value|center|centre).*|(center|centre|pos|position) ?x|east|easting|rechtswert)$/,
  y: /^(y|cy|y ?(coord|koord|pos|wert|value|center|centre).*|(center|centre|pos|position) ?y|north|northing|hochwert)$/,
  r: /^(r|rad|radi(us|en|i)?|radius .*|r (km|m)|weight|gewicht)$/,
  d: /^(d|diam|diameter|durchmesser|dbh|bhd)$/,
}

/** Returns whether the name of a column is one of longitudes. */
export function isLongitude(name: string): boolean {
  return LONGITUDE.test(normalName(name))
}

/** Returns whether the name of a column is one of latitudes. */
export function isLatitude(name: string): boolean {
  return LATITUDE.test(normalName(name))
}

/** Returns a name in lower case, with blanks in place of signs. */
export function normalName(name: string): string {
  return name
    .toLowerCase()
    .replace(/[_\-.()[\]°]+/g, ' ')
    .trim()
}

/**
 * Returns the columns of a text that the readers know by their names. Returns `undefined` for columns without names, and
 * for GeoJSON, which has none.
 */
export function knownColumns(text: string): ColumnNames | undefined {
  const names = /^\uFEFF?\s*\[/.test(text) ? membersIn(text) : headingIn(text)
  const { x, y, r } = guessedColumns({ heading: names })
  if (x === undefined || y === undefined) return undefined
  return { x: names[x] as string, y: names[y] as string, radius: typeof r === 'number' ? names[r] : undefined }
}

function headingIn(text: string): readonly string[] {
  for (const candidate of SEPARATORS) {
    const first = attempt(() => recordsOf(text, candidate).next().value as TableRecord | undefined)
    if (first !== undefined && attempt(() => isHeaderOrCircle(first, candidate)) === true) {
      return first.fields.map(({ text }) => text)
    }
  }
  return []
}

/** The names of the first object in a list. */
function membersIn(json: string): readonly string[] {
  const [first] = attempt<readonly unknown[]>(() => JSON.parse(json)) ?? []
  return isRecord(first) ? Object.keys(first) : []
}

/**
 * Reads a table whose columns the readers do not know. Returns `undefined` if they know the columns, so that something else is
 * wrong with the text, and if fewer than two columns have numbers in most rows.
 */
export function unknownTable(text: string): Table | undefined {
  if (/^\uFEFF?\s*[[{<]/.test(text)) return undefined
  let separator: Separator | undefined
  let width = 0
  for (const candidate of SEPARATORS) {
    const first = attempt(() => recordsOf(text, candidate).next().value as TableRecord | undefined)
    if (first === undefined) continue
    if (attempt(() => isHeaderOrCircle(first, candidate)) === true) return undefined
    const count = filled(first.fields).length
    if (count > width || (count === width && candidate === ',')) {
      separator = candidate
      width = count
    }
  }
  const records = separator && attempt(() => [...recordsOf(text, separator as Separator)])
  return separator && records && tableOf(records, separator)
}

function tableOf(records: readonly TableRecord[], separator: Separator): Table | undefined {
  const isNumber = (field: TableRecord['fields'][number] | undefined) =>
    field !== undefined && new NumberReader(separator).read(field) !== undefined
  const [first = { fields: [] }] = records
  const hasHeading = !first.fields.some(isNumber)
  const rows = hasHeading ? records.slice(1) : records
  const counts = first.fields.map((_, k) => rows.filter(({ fields }) => isNumber(fields[k])).length)
  if (counts.filter((count) => count > rows.length / 2).length < 2) return undefined
  const textsOf = ({ fields }: Pick<TableRecord, 'fields'>) => fields.map(({ text }) => text)
  return {
    heading: hasHeading ? textsOf(first) : first.fields.map((_, k) => `column ${k + 1}`),
    hasHeading,
    rows: rows.map(textsOf),
    hasNumbers: counts.map((count) => count > 0),
  }
}

/** Returns `undefined` if quotation marks are not closed. */
function attempt<Value>(read: () => Value): Value | undefined {
  try {
    return read()
  } catch {
    return undefined
  }
}

/** The columns that names suggest. */
export interface Guess extends Partial<Columns> {
  readonly isDiameter: boolean
  /** Whether exactly one column has such a name for each of x, y and the radius. */
  readonly isSure: boolean
}

export function guessedColumns({ heading }: Pick<Table, 'heading'>): Guess {
  const normal = heading.map(normalName)
  const isKind = {
    x: (name: string) => NAMES.x.test(name) || LONGITUDE.test(name),
    y: (name: string) => NAMES.y.test(name) || LATITUDE.test(name),
    r: (name: string) => NAMES.r.test(name),
    d: (name: string) => NAMES.d.test(name),
  }
  const find = (kind: keyof typeof NAMES) => normal.flatMap((name, k) => (isKind[kind](name) ? [k] : []))
  const [x, y, r, d] = [find('x'), find('y'), find('r'), find('d')]
  const radius = r.length > 0 ? r : d
  return {
    ...(x[0] !== undefined && { x: x[0] }),
    ...(y[0] !== undefined && { y: y[0] }),
    ...(radius[0] !== undefined && { r: radius[0] }),
    isDiameter: radius === d && d.length > 0,
    isSure: [x, y, radius].every(({ length }) => length === 1),
  }
}

/** Returns the option for a column: its name, or `#1`, `#2`, ... if it has none or shares it with another column. */
export function nameOfColumn({ heading, hasHeading }: Table, column: number): string {
  const name = heading[column] as string
  const isOnlyOne = heading.filter((other) => other.toLowerCase() === name.toLowerCase()).length === 1
  return hasHeading && isOnlyOne && name !== '' ? name : `#${column + 1}`
}
