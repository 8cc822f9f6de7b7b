// SPDX-License-Identifier: GPL-3.0-or-later
// What the circles of a file are called. The library reads their numbers alone.
import { guessedColumns, rowsOf } from './columns.ts'

const KEYS = ['name', 'label', 'title'] as const

/** The names of so many circles in a text of CSV, JSON or GeoJSON; `undefined`: it has none. */
export function namesIn(text: string, count: number): readonly string[] | undefined {
  const names = /^\s*[[{]/.test(text) ? namesOfJson(text) : namesOfTable(text)
  return names?.length === count && names.some((name) => name !== '') ? names : undefined
}

function namesOfTable(text: string): readonly string[] | undefined {
  const rows = rowsOf(text)
  const column = rows === undefined ? undefined : guessedColumns(rows).name
  return column === undefined ? undefined : rows?.rows.map((row) => row[column] ?? '')
}

function namesOfJson(text: string): readonly string[] | undefined {
  try {
    const data: unknown = JSON.parse(text)
    const { features, circles } = (data ?? {}) as { readonly features?: unknown; readonly circles?: unknown }
    const items = [data, features, circles].find(Array.isArray) as readonly unknown[] | undefined
    return items?.map((item) => nameOf(item))
  } catch {
    return undefined
  }
}

function nameOf(item: unknown): string {
  if (typeof item !== 'object' || item === null) return ''
  const { properties = item } = item as { readonly properties?: object }
  const given = properties as Readonly<Record<string, unknown>>
  const name = KEYS.map((key) => given[key]).find((value) => typeof value === 'string')
  return (name as string | undefined) ?? ''
}
