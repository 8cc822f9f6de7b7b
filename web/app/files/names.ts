// SPDX-License-Identifier: GPL-3.0-or-later
// What a file says of its circles beside centers and radii: the library reads their numbers alone.
import { type Attributes, columnsOf, NO_ATTRIBUTES } from '../../editing/attributes.ts'
import { isRecord } from '../../lib/base/check.ts'
import type { LinkAttributes } from '../../lib/link.ts'
import { guessedColumns, otherColumns, rowsOf } from './columns.ts'

/** The attributes of so many circles in a text of CSV, JSON or GeoJSON; `undefined`: it has none. */
export function attributesIn(text: string, count: number): Attributes | undefined {
  const attributes = /^\s*[[{]/.test(text) ? attributesOfJson(text, count) : attributesOfTable(text)
  if (attributes === undefined || attributes.columns.some(({ values }) => values.length !== count)) return undefined
  const { columns, ids, heights, collection } = attributes
  return columns.length + ids.length + heights.length + collection.length > 0 ? attributes : undefined
}

function attributesOfTable(text: string): Attributes | undefined {
  const rows = rowsOf(text)
  if (rows === undefined) return undefined
  const { x = 0, y = 1, r = 2 } = guessedColumns(rows)
  return { ...NO_ATTRIBUTES, columns: otherColumns(rows, [x, y, r as number]) }
}

function attributesOfJson(text: string, count: number): Attributes | undefined {
  const data = parsed(text)
  const items = itemsOf(data)
  if (items?.length !== count) return undefined
  const given = items.map(propertiesOf)
  const heading = [...new Set(given.flatMap(Object.keys))]
  const { x, y, r } = guessedColumns({ heading })
  const used = new Set<unknown>([x, y, r].map((k) => heading[k as number]))
  // The place of the circle, as the writers say it.
  if (given.every(({ circle }, k) => circle === k)) used.add('circle')
  const properties = given.map((item) =>
    JSON.stringify(Object.fromEntries(Object.entries(item).filter(([name]) => !used.has(name)))),
  )
  return columnsOf({ properties, ...geoJsonOf(data, items) }, count)
}

/** What GeoJSON says beside properties: ids, heights, and the other members of the collection. */
function geoJsonOf(data: unknown, items: readonly unknown[]): Omit<LinkAttributes, 'properties'> {
  const { ids, heights, collection } = NO_ATTRIBUTES
  if (!isRecord(data) || !Array.isArray(data.features)) return { ids, heights, collection }
  const listOf = (read: (feature: Record<string, unknown>) => unknown) => {
    const list = items.map((item) => (isRecord(item) ? (JSON.stringify(read(item)) ?? '') : ''))
    return list.every((text) => text === '') ? [] : list
  }
  const { type: _, features: __, bbox: ___, ...others } = data
  return {
    ids: listOf(({ id }) => (typeof id === 'string' || typeof id === 'number' ? id : undefined)),
    heights: listOf(({ geometry }) => {
      const { coordinates } = isRecord(geometry) ? geometry : {}
      return Array.isArray(coordinates) && Number.isFinite(coordinates[2]) ? coordinates[2] : undefined
    }),
    collection: Object.keys(others).length === 0 ? '' : JSON.stringify(others),
  }
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text)
  } catch {
    return undefined
  }
}

function itemsOf(data: unknown): readonly unknown[] | undefined {
  const { features, circles } = isRecord(data) ? data : {}
  return [data, features, circles].find(Array.isArray)
}

/** Of a feature, or of a circle as an object. */
function propertiesOf(item: unknown): Readonly<Record<string, unknown>> {
  const { properties = item } = isRecord(item) ? item : {}
  return isRecord(properties) && !Array.isArray(properties) ? properties : {}
}
