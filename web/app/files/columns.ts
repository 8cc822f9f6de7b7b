// SPDX-License-Identifier: GPL-3.0-or-later
// Guesses which columns of a table are centers and radii, where the readers do not know their names.
import { isRecord } from '../../lib/base/check.ts'
import { at } from '../../lib/base/diagram-data.ts'
import type { Float64s } from '../../lib/index.ts'
import { boundingBox } from '../../view/camera.ts'
import { isHeaderOrCircle, USUAL_NAMES } from '../../view/circle-text.ts'
import { filled, NumberReader, recordsOf, SEPARATORS, type Separator, type TableRecord } from '../../view/table-text.ts'

/** A table as text. */
export interface Table {
  /** The names of the columns. A column without a name has a number. */
  readonly heading: readonly string[]
  readonly hasHeading: boolean
  readonly rows: readonly (readonly string[])[]
  readonly separator: Separator
  /** Whether each column has a number in any row. */
  readonly hasNumbers: readonly boolean[]
  /** Whether each column may be coordinates or radii: numbers that are no ids. */
  readonly areMeasures: readonly boolean[]
}

/** The ways to get radii from a column: as it is, half of a diameter, or the square root of a number or an area. */
export type RadiusKind = 'radius' | 'diameter' | 'root'

/** The way to get radii from a column. `factor` multiplies the radii. */
export interface RadiusScale {
  readonly kind: RadiusKind
  readonly factor: number
}

export const UNCHANGED: RadiusScale = { kind: 'radius', factor: 1 }

/** The columns of the circles by their indices. `r` is a column, or one radius for all circles. */
export interface Columns extends RadiusScale {
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
/** Names of columns in lower case, without their units. */
const NAMES: Readonly<Record<'x' | 'y' | RadiusKind | 'id', RegExp>> = {
  x: /^(x|cx|x ?(coord|koord|pos|wert|value|center|centre).*|(center|centre|pos|position) ?x|east|easting|rechtswert)$/,
  y: /^(y|cy|y ?(coord|koord|pos|wert|value|center|centre).*|(center|centre|pos|position) ?y|north|northing|hochwert)$/,
  radius: /^(r|rad|radi(us|en|i)?|radius .*|weight|gewicht)$/,
  diameter: /^(d|dia|diam|diameter|durchmesser|dbh|bhd)$/,
  root: /^(pop|population|people|inhabitants|einwohner|bevölkerung|area|fläche|basal area)$/,
  id: /^(.+ )?(id|fid|oid|gid|uuid|code|key|index|nr|no|nummer|number|plz|zip|zipcode|postcode|year|jahr)$/,
}
/** Projected coordinates are in meters if their names say nothing else. */
const PROJECTED = /^(east|easting|rechtswert|north|northing|hochwert)$/
/** Units of lengths in headings, in millimeters. */
const UNITS: readonly (readonly [name: RegExp, millimeters: number])[] = [
  [/^(mm|millimet(er|re)s?)$/, 1],
  [/^(cm|centimet(er|re)s?|zentimeter)$/, 10],
  [/^(dm|decimet(er|re)s?|dezimeter)$/, 100],
  [/^(m|met(er|re)s?|metern)$/, 1000],
  [/^(km|kilomet(er|re)s?|kilometern)$/, 1e6],
  [/^(in|inch|inches)$/, 25.4],
  [/^(ft|foot|feet)$/, 304.8],
  [/^(mi|miles?)$/, 1_609_344],
]
/** Length of a degree of latitude in kilometers. */
export const DEGREE = 111.2
export const METER = 1000
export const KILOMETER = 1e6

/** Number of rows that tell which character separates columns. */
const COMPARED = 20
/** A column with more rows than this that counts them is one of ids. */
const COUNTED = 2

/** Returns whether the name of a column is one of longitudes. */
export function isLongitude(name: string): boolean {
  return LONGITUDE.test(normalName(name))
}

/** Returns whether the name of a column is one of latitudes. */
export function isLatitude(name: string): boolean {
  return LATITUDE.test(normalName(name))
}

/** Returns a name in lower case, with blanks in place of signs. */
function normalName(name: string): string {
  return name
    .toLowerCase()
    .replace(/[\s_\-.()[\]°]+/g, ' ')
    .trim()
}

/** Splits the name of a column, such as `Dia (cm)`, into a normal name and its unit in millimeters. */
function nameAndUnit(name: string): { readonly name: string; readonly unit: number | undefined } {
  const normal = normalName(name)
  const [, rest = '', last = ''] = /^(.+) (\S+)$/.exec(normal) ?? []
  const unit = UNITS.find(([names]) => names.test(last))?.[1]
  return unit === undefined ? { name: normal, unit } : { name: rest.replace(/ in$/, ''), unit }
}

/** Returns the unit of lengths that the name of a column ends with, in millimeters. */
export function unitOf(name: string): number | undefined {
  return nameAndUnit(name).unit
}

/**
 * Returns the columns of a text that the readers know by their names. Returns `undefined` for columns without names, and
 * for GeoJSON, which has none.
 */
export function knownColumns(text: string): ColumnNames | undefined {
  const names = /^\uFEFF?\s*\[/.test(text) ? membersIn(text) : headingIn(text)
  const [x, y, radius] = USUAL_NAMES.map((usual) => {
    const ranks = names.map((name) => (usual as readonly string[]).indexOf(name.toLowerCase()))
    const first = Math.min(...ranks.filter((rank) => rank >= 0))
    return names[ranks.indexOf(first)]
  })
  return x === undefined || y === undefined ? undefined : { x, y, radius }
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
  let best = [false, false, 0, false]
  for (const candidate of SEPARATORS) {
    const records = attempt(() => firstOf(recordsOf(text, candidate), COMPARED))
    const [first] = records ?? []
    if (records === undefined || first === undefined) continue
    if (attempt(() => isHeaderOrCircle(first, candidate)) === true) return undefined
    const width = filled(first.fields).length
    // Names have spaces, too.
    const isSplit = width > 1 && candidate !== ' '
    const isEven = records.every(({ fields }) => fields.length === first.fields.length)
    const rank = [isSplit, isEven, width, candidate === ',']
    const differs = rank.findIndex((value, k) => value !== best[k])
    if (differs < 0 || Number(rank[differs]) < Number(best[differs])) continue
    separator = candidate
    best = rank
  }
  const records = separator && attempt(() => [...recordsOf(text, separator as Separator)])
  return separator && records && tableOf(records, separator)
}

function firstOf(records: Iterable<TableRecord>, count: number): TableRecord[] {
  const first: TableRecord[] = []
  for (const record of records) {
    first.push(record)
    if (first.length === count) break
  }
  return first
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
  const heading = hasHeading ? textsOf(first) : first.fields.map((_, k) => `column ${k + 1}`)
  const texts = rows.map(textsOf)
  return {
    heading,
    hasHeading,
    rows: texts,
    separator,
    hasNumbers: counts.map((count) => count > 0),
    areMeasures: counts.map((count, k) => count > rows.length / 2 && !areIds(heading[k] as string, texts, k)),
  }
}

/**
 * Whether a column is called like ids, has zeros in front of numbers, or counts the rows. A column that is called like a
 * coordinate or a radius has no ids.
 */
function areIds(name: string, rows: readonly (readonly string[])[], column: number): boolean {
  if (NAMES.id.test(normalName(name))) return true
  const { name: plain } = nameAndUnit(name)
  if ([NAMES.x, NAMES.y, ...KINDS.map((kind) => NAMES[kind])].some((pattern) => pattern.test(plain))) return false
  if (rows.some((row) => /^0\d/.test(row[column] ?? ''))) return true
  const first = Number(rows[0]?.[column])
  const isCounted = rows.every((row, k) => row[column] === String(first + k))
  return rows.length > COUNTED && (first === 0 || first === 1) && isCounted
}

/** Returns `undefined` if quotation marks are not closed. */
function attempt<Value>(read: () => Value): Value | undefined {
  try {
    return read()
  } catch {
    return undefined
  }
}

/** The radius of all circles where no column has the radii. */
export const SAME = { all: 1 } as const

/**
 * Guesses the columns of a table by their names. Without names, the first numbers are the coordinates, and the next ones
 * the radii. Each column has at most one role.
 */
export function guessedColumns(table: Table): Columns {
  const { heading, areMeasures } = table
  const names = heading.map((name) => nameAndUnit(name).name)
  const free = new Set([...heading.keys()].filter((k) => areMeasures[k]))
  const take = (isWanted: (name: string) => boolean): number | undefined => {
    const column = [...free].find((k) => isWanted(names[k] as string))
    if (column !== undefined) free.delete(column)
    return column
  }
  const x = take((name) => NAMES.x.test(name) || LONGITUDE.test(name))
  const y = take((name) => NAMES.y.test(name) || LATITUDE.test(name))
  const named = KINDS.reduce<number | undefined>((r, kind) => r ?? take((name) => NAMES[kind].test(name)), undefined)
  const any = () => true
  const centers = { x: x ?? take(any) ?? 0, y: y ?? take(any) ?? 1 }
  // Centers that are known by their names have no radii of an unknown name.
  const areCentersNamed = x !== undefined && y !== undefined
  const r = named ?? (areCentersNamed ? undefined : take(any)) ?? SAME
  return { ...centers, r, ...scaleOf(table, { ...centers, r }) }
}

const KINDS = ['radius', 'diameter', 'root'] as const

/**
 * Guesses how radii follow from a column: by its name, unless the kind is given, and by the units of the columns. Square
 * roots get a factor with which the largest circle has a twentieth of the extent of all centers as its radius.
 */
export function scaleOf(table: Table, { x, y, r }: Pick<Columns, 'x' | 'y' | 'r'>, given?: RadiusKind): RadiusScale {
  if (typeof r !== 'number') return UNCHANGED
  const [nameOfX, nameOfY, radius] = [x, y, r].map((k) => nameAndUnit(table.heading[k] as string)) as [
    Named,
    Named,
    Named,
  ]
  const kind = given ?? KINDS.find((kind) => NAMES[kind].test(radius.name)) ?? 'radius'
  const areDegrees = LONGITUDE.test(nameOfX.name) && LATITUDE.test(nameOfY.name)
  if (kind === 'root') return { kind, factor: rootFactor(table, { x, y, r }, areDegrees ? DEGREE : 1) }
  if (radius.unit === undefined) return { kind, factor: 1 }
  // Radii of places in degrees are in meters or kilometers.
  if (areDegrees) return { kind, factor: radius.unit === KILOMETER ? 1 : radius.unit / METER }
  const [unit, other] = [nameOfX, nameOfY].map(({ name, unit }) => unit ?? (PROJECTED.test(name) ? METER : undefined))
  return { kind, factor: unit === undefined || unit !== other ? 1 : radius.unit / unit }
}
type Named = ReturnType<typeof nameAndUnit>

/** The factor is rounded to one digit. `length` is that of a unit of the coordinates. */
function rootFactor(table: Table, columns: Pick<Columns, 'x' | 'y' | 'r'>, length: number): number {
  const circles = circlesOfTable(table, { ...columns, kind: 'root', factor: 1 })
  let largest = 0
  for (let k = 2; k < circles.length; k += 3) largest = Math.max(largest, at(circles, k))
  const { minX, minY, maxX, maxY } = boundingBox(circles.map((value, k) => (k % 3 === 2 ? 0 : value)))
  const factor = (Math.hypot(maxX - minX, maxY - minY) * length) / 20 / largest
  return Number.isFinite(factor) && factor > 0 ? Number(factor.toPrecision(1)) : 1
}

/** Returns the radius for a number of a column. */
export function scaled(value: number, { kind, factor }: RadiusScale): number {
  return factor * (kind === 'radius' ? value : kind === 'diameter' ? value / 2 : Math.sqrt(value))
}

/** The circles of a table. Rows that are no circles are left out; the reader reports them. */
export function circlesOfTable({ rows, separator }: Table, columns: Columns): Float64s {
  const reader = new NumberReader(separator)
  const numberIn = (text = '') => reader.read({ text, isQuoted: true }) ?? Number.NaN
  const { x, y, r } = columns
  return Float64Array.from(
    rows.flatMap((row) => {
      const radius = typeof r === 'number' ? scaled(numberIn(row[r]), columns) : r.all
      const circle = [numberIn(row[x]), numberIn(row[y]), radius]
      return circle.every(Number.isFinite) && radius >= 0 ? circle : []
    }),
  )
}

/** Returns the option for a column: its name, or `#1`, `#2`, ... if it has none or shares it with another column. */
export function nameOfColumn({ heading, hasHeading }: Table, column: number): string {
  const name = heading[column] as string
  const isOnlyOne = heading.filter((other) => other.toLowerCase() === name.toLowerCase()).length === 1
  return hasHeading && isOnlyOne && name !== '' ? name : `#${column + 1}`
}
