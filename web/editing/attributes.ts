// SPDX-License-Identifier: GPL-3.0-or-later
// What a file says about circles beside their centers and radii, by columns. All values are texts of JSON, so that no number
// loses a digit and no text becomes a number.
import type { LinkAttributes } from '../lib/link.ts'

/** A column: the text of a JSON value for each circle by its number; empty, where there is none. */
export interface DataColumn {
  readonly name: string
  readonly values: readonly string[]
}

/** The columns of circles, and what GeoJSON says of features and collections (`LinkAttributes`). */
export interface Attributes extends Omit<LinkAttributes, 'properties'> {
  readonly columns: readonly DataColumn[]
}

export const NO_ATTRIBUTES: Attributes = { columns: [], ids: [], heights: [], collection: '' }

/** Whether a column has numbers alone; texts and other values are shown as they are. */
export function isNumeric({ values }: DataColumn): boolean {
  let isAny = false
  for (const value of values) {
    if (value === '' || value === 'null') continue
    if (!/^-?\d/.test(value)) return false
    isAny = true
  }
  return isAny
}

/** The number of a JSON text; NaN, if it is none. */
export function numberIn(value: string | undefined): number {
  return value !== undefined && /^-?\d/.test(value) ? Number(value) : Number.NaN
}

/** A value as people write it: a text without quotation marks, nothing for `null`. */
export function textIn(value: string | undefined): string {
  if (value === undefined || value === '' || value === 'null') return ''
  return value.startsWith('"') ? (JSON.parse(value) as string) : value
}

/** Names that columns of names have in other programs, the surest first. */
const NAMES = /^(name|label|title|ort|stadt|city|place|bezeichnung|beschriftung)$/i

/** The column that says what circles are called. */
export function nameColumn(columns: readonly DataColumn[]): DataColumn | undefined {
  return columns.find(({ name }) => NAMES.test(name.trim())) ?? columns.find(({ name }) => /^id$/i.test(name.trim()))
}

/**
 * The value that a text becomes that somebody writes into a column; `undefined`: the column has numbers, and it is none. Nothing
 * becomes `null`.
 */
export function valueFrom(text: string, column: DataColumn): string | undefined {
  const trimmed = text.trim()
  if (trimmed === '') return 'null'
  if (isNumeric(column)) {
    const number = trimmed.replace(/^\u2212/, '-').replace(/^(-?)\+?(\d*),(\d+)$/, '$1$2.$3')
    if (isNumeral(number)) return number
    const value = Number(number)
    return Number.isFinite(value) && !/^[-+]?0[xob]/i.test(number) ? JSON.stringify(value) : undefined
  }
  // A value of another kind is replaced by one of this kind.
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

/** The attributes as columns. `count`: how many circles there are. */
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

/** The attributes of some circles by their numbers, as files and links have them. */
export function attributesOf(
  { columns, ids, heights, collection }: Attributes,
  numbers: readonly number[],
): LinkAttributes {
  const names = columns.map(({ name }) => JSON.stringify(name))
  const propertiesOf = (number: number) => {
    const members = columns.flatMap(({ values }, k) => {
      const value = values[number] ?? ''
      return value === '' ? [] : [`${names[k]}:${value}`]
    })
    return `{${members.join()}}`
  }
  const listOf = (list: readonly string[]) => (list.length === 0 ? [] : numbers.map((number) => list[number] ?? ''))
  return { properties: numbers.map(propertiesOf), ids: listOf(ids), heights: listOf(heights), collection }
}

/** The members of the text of a JSON object, with the texts of their values. */
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

/** The attributes with another value of a circle in a column. */
export function withValue(attributes: Attributes, column: string, number: number, value: string): Attributes {
  const columns = attributes.columns.map((known) => {
    if (known.name !== column) return known
    const values = Array.from({ length: Math.max(known.values.length, number + 1) }, (_, k) => known.values[k] ?? '')
    values[number] = value
    return { ...known, values }
  })
  return { ...attributes, columns }
}

/** About how much memory they take, in bytes. */
export function bytesOfAttributes({ columns, ids, heights }: Attributes): number {
  const bytesIn = (list: readonly string[]) => list.reduce((sum, text) => sum + 2 * text.length + 16, 0)
  return [...columns.map(({ values }) => values), ids, heights].reduce((sum, list) => sum + bytesIn(list), 0)
}
