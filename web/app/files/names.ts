// SPDX-License-Identifier: GPL-3.0-or-later
// What a file says of its circles beside centers and radii: the library reads their numbers alone.
import { isRecord } from '../../lib/base/check.ts'
import type { NamedCircles } from '../csv.ts'
import { guessedColumns, isNumeric, namesIn, otherColumns, rowsOf } from './columns.ts'

const KEYS = ['name', 'label', 'title'] as const

/** What there is beside circles. */
type Attributes = Pick<NamedCircles, 'names' | 'columns'>

/** The names and the other numbers of so many circles in a text of CSV, JSON or GeoJSON; of each, nothing where it has none. */
export function attributesIn(text: string, count: number): Attributes {
  const { names, columns = [] } = /^\s*[[{]/.test(text) ? attributesOfJson(text) : attributesOfTable(text)
  const isNamed = names?.length === count && names.some((name) => name !== '')
  const whole = columns.filter(({ values }) => values.length === count)
  return { names: isNamed ? names : undefined, columns: whole.length > 0 ? whole : undefined }
}

function attributesOfTable(text: string): Attributes {
  const rows = rowsOf(text)
  if (rows === undefined) return {}
  const { x = 0, y = 1, r = 2, name } = guessedColumns(rows)
  return { names: namesIn(rows, name), columns: otherColumns(rows, [x, y, r as number, name]) }
}

function attributesOfJson(text: string): Attributes {
  const items = itemsOf(text)
  if (items === undefined) return {}
  const given = items.map(propertiesOf)
  const names = given.map((item) => KEYS.map((key) => item[key]).find((value) => typeof value === 'string') ?? '')
  const heading = [...new Set(given.flatMap(Object.keys))]
  const { x, y, r } = guessedColumns({ heading })
  const columns = heading.flatMap((name, k) => {
    const values = given.map((item) => (typeof item[name] === 'number' ? item[name] : Number.NaN))
    return [x, y, r].includes(k) || !isNumeric(values) ? [] : [{ name, values: Float64Array.from(values) }]
  })
  return { names: names as string[], columns }
}

function itemsOf(text: string): readonly unknown[] | undefined {
  try {
    const data: unknown = JSON.parse(text)
    const { features, circles } = isRecord(data) ? data : {}
    return [data, features, circles].find(Array.isArray)
  } catch {
    return undefined
  }
}

/** Of a feature, or of a circle as an object. */
function propertiesOf(item: unknown): Readonly<Record<string, unknown>> {
  const { properties = item } = isRecord(item) ? item : {}
  return isRecord(properties) && !Array.isArray(properties) ? properties : {}
}
