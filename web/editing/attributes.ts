// SPDX-License-Identifier: GPL-3.0-or-later
// The attributes that files give to circles beside centers and radii, by columns. All values are JSON texts, so that no
// number loses a digit and no text becomes a number.
import type { Float64s } from '../lib/index.ts'
import type { LinkAttributes, LinkState } from '../lib/link.ts'
import type { CircleTable } from '../view/circle-table.ts'

/** A column: the JSON text of a value for each circle by its id, empty where a circle has no value. */
export interface DataColumn {
  readonly name: string
  readonly values: readonly string[]
}

/** The columns of circles, and the data of GeoJSON features and collections (`LinkAttributes`). */
export interface Attributes extends Omit<LinkAttributes, 'properties'> {
  readonly columns: readonly DataColumn[]
}

export const NO_ATTRIBUTES: Attributes = { columns: [], ids: [], heights: [], collection: '' }

/** Whether all values of a column are numbers. */
export function isNumeric({ values }: DataColumn): boolean {
  let isAny = false
  for (const value of values) {
    if (value === '' || value === 'null') continue
    if (!/^-?\d/.test(value)) return false
    isAny = true
  }
  return isAny
}

/** The number in a JSON text; NaN for other values. */
export function numberIn(value: string | undefined): number {
  return value !== undefined && /^-?\d/.test(value) ? Number(value) : Number.NaN
}

/** Formats a value for people: a text without quotation marks, nothing for `null`. */
export function textIn(value: string | undefined): string {
  if (value === undefined || value === '' || value === 'null') return ''
  return value.startsWith('"') ? (JSON.parse(value) as string) : value
}

/**
 * Converts text that a user enters into a value of a column. Empty text becomes `null`; `undefined` if a numeric column
 * gets no number.
 */
export function valueFrom(text: string, column: DataColumn): string | undefined {
  const trimmed = text.trim()
  if (trimmed === '') return 'null'
  if (column.values.length === 0) return JSON.stringify(text)
  if (isNumeric(column)) {
    const number = trimmed.replace(/^\u2212/, '-').replace(/^(-?)\+?(\d*),(\d+)$/, '$1$2.$3')
    if (isNumeral(number)) return number
    const value = Number(number)
    return Number.isFinite(value) && !/^[-+]?0[xob]/i.test(number) ? JSON.stringify(value) : undefined
  }
  // A text replaces values of another kind only if no value of the column is a text.
  const isOther = column.values.every((value) => value === '' || /^[ntf{[]/.test(value))
  if (isOther && isJson(trimmed)) return trimmed
  return JSON.stringify(text)
}

function isNumeral(text: string): boolean {
  return /^-?(0|[1-9]\d*)(\.\d+)?([eE][-+]?\d+)?$/.test(text)
}

function isJson(text: string): boolean {
  try {
    JSON.parse(text)
    return true
  } catch {
    return false
  }
}

/** Converts attributes to columns. `count` is the number of circles. */
export function columnsOf({ properties, ids, heights, collection }: LinkAttributes, count: number): Attributes {
  const columns = new Map<string, string[]>()
  properties.forEach((text, k) => {
    for (const [name, value] of membersOf(text)) {
      const values = columns.get(name) ?? Array<string>(count).fill('')
      columns.set(name, values)
      values[k] = value
    }
  })
  return { columns: [...columns].map(([name, values]) => ({ name, values })), ids, heights, collection }
}

/** The attributes of a link's circles; `undefined` if it has none. */
export function attributesOfLink(
  { attributes, names }: Pick<LinkState, 'attributes' | 'names'>,
  count: number,
): Attributes | undefined {
  if (attributes !== undefined) return columnsOf(attributes, count)
  return names && namedAs(names)
}

/** Attributes that consist of names, empty for circles without one. */
export function namedAs(names: readonly string[]): Attributes {
  const values = names.map((name) => (name === '' ? '' : JSON.stringify(name)))
  return { ...NO_ATTRIBUTES, columns: [{ name: 'name', values }] }
}

/** The attributes of some circles, in the form of files and links. */
export function attributesOf(
  { columns, ids, heights, collection }: Attributes,
  circles: readonly number[],
): LinkAttributes {
  const names = columns.map(({ name }) => JSON.stringify(name))
  const propertiesOf = (id: number) => {
    const members = columns.flatMap(({ values }, k) => {
      const value = values[id] ?? ''
      return value === '' ? [] : [`${names[k]}:${value}`]
    })
    return `{${members.join()}}`
  }
  const listOf = (list: readonly string[]) => (list.length === 0 ? [] : circles.map((id) => list[id] ?? ''))
  return { properties: circles.map(propertiesOf), ids: listOf(ids), heights: listOf(heights), collection }
}

/** Circles with attributes (`Editing`). */
export interface Attributed {
  readonly circles: CircleTable
  readonly attributes: Attributes
}

/** The attributes of all circles, in their order; `undefined` if there are none. */
export function fileAttributes({ attributes, circles }: Attributed): LinkAttributes | undefined {
  return attributes === NO_ATTRIBUTES ? undefined : attributesOf(attributes, [...circles.ids()])
}

/** The JSON text of a circle's value in a column, empty if the circle has no value. */
export function valueIn(attributes: Attributes, column: string, id: number): string {
  return columnIn(attributes, column)?.values[id] ?? ''
}

/** A column in the order of the circles, with NaN where there is no number. */
export function numbersIn(attributes: Attributes, column: string, circles: CircleTable): Float64s {
  const values = columnIn(attributes, column)?.values
  return Float64Array.from(circles.ids(), (id) => numberIn(values?.[id]))
}

/** The column of a name. */
export function columnIn({ columns }: Attributes, name: string): DataColumn | undefined {
  return columns.find((column) => column.name === name)
}

/** The members of a JSON object, with the JSON texts of their values. */
export function membersOf(text: string): [name: string, value: string][] {
  const members: [string, string][] = []
  let depth = 0
  let isQuoted = false
  let from = -1
  let name: string | undefined
  const end = (k: number) => {
    if (name !== undefined) members.push([name, text.slice(from, k).trim()])
    name = undefined
    from = k + 1
  }
  for (let k = 0; k < text.length; k++) {
    const letter = text[k] as string
    if (isQuoted) {
      if (letter === '\\') k += 1
      else if (letter === '"') isQuoted = false
    } else if (letter === '"') isQuoted = true
    else if (letter === '{' || letter === '[') {
      depth += 1
      if (depth === 1) from = k + 1
    } else if (letter === '}' || letter === ']') {
      if (depth === 1) end(k)
      depth -= 1
    } else if (depth === 1 && letter === ':' && name === undefined) {
      name = JSON.parse(text.slice(from, k)) as string
      from = k + 1
    } else if (depth === 1 && letter === ',') end(k)
  }
  return members
}

/** Sets values of circles, by their ids, in a column. A column of a new name is added. */
export function withValues(attributes: Attributes, name: string, given: ReadonlyMap<number, string>): Attributes {
  const { columns } = attributes
  const known = columnIn(attributes, name)
  const count = [...given.keys()].reduce((most, id) => Math.max(most, id + 1), known?.values.length ?? 0)
  const values = Array.from({ length: count }, (_, id) => given.get(id) ?? known?.values[id] ?? '')
  const column = { name, values }
  return {
    ...attributes,
    columns: known ? columns.map((other) => (other === known ? column : other)) : [...columns, column],
  }
}

/** The memory of attributes, which each edit asks for. */
const knownBytes = new WeakMap<Attributes, number>()

/** Estimates the memory of attributes, in bytes. */
export function bytesOfAttributes(attributes: Attributes): number {
  const known = knownBytes.get(attributes)
  if (known !== undefined) return known
  const { columns, ids, heights } = attributes
  const bytesIn = (list: readonly string[]) => list.reduce((sum, text) => sum + 2 * text.length + 16, 0)
  const bytes = [...columns.map(({ values }) => values), ids, heights].reduce((sum, list) => sum + bytesIn(list), 0)
  knownBytes.set(attributes, bytes)
  return bytes
}
