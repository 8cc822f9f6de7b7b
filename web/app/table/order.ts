// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleTable } from '../../view/circle-table.ts'
import type { Column as Measured, Tabulated } from '../../view/protocol.ts'

/** The built-in columns of the table. */
export const COLUMNS = ['id', 'x', 'y', 'r', 'area', 'degree', 'gap'] as const
/** `data:` and a name denote a column of the file. */
export type Column = (typeof COLUMNS)[number] | `data:${string}`
const DATA = 'data:'

/** The sort column and direction. */
export interface Sorting {
  readonly column: Column
  readonly isDescending: boolean
}

export const BY_ID: Sorting = { column: 'id', isDescending: false }

export function isMeasured(column: Column): column is Measured {
  return column === 'area' || column === 'degree' || column === 'gap'
}

export function isFixed(column: Column): column is (typeof COLUMNS)[number] {
  return !column.startsWith(DATA)
}

/** The column for a name, and the name of a column. */
export function dataColumn(name: string): Column {
  return `${DATA}${name}`
}

export function dataName(column: Column): string {
  return column.slice(DATA.length)
}

/** Ranks texts in natural order (2 before 10). Missing texts get NaN. */
export function ranksOf(texts: readonly string[]): number[] {
  const { compare } = new Intl.Collator(undefined, { numeric: true })
  const ranks = new Map([...new Set(texts)].sort(compare).map((text, rank) => [text, rank]))
  return texts.map((text) => (text === '' ? Number.NaN : (ranks.get(text) as number)))
}

/**
 * The ids in the order of rows. `measured` holds the column's values if the painting thread computes them, `given`
 * the values of a file's column by ascending id.
 */
export function ordered(
  circles: CircleTable,
  { column, isDescending }: Sorting,
  measured?: Tabulated,
  given: readonly number[] = [],
): Int32Array {
  const ids = circles.ids()
  if (column === 'id') return isDescending ? ids.reverse() : ids
  const keys = new Float64Array((ids.at(-1) ?? -1) + 1).fill(Number.NaN)
  if (isMeasured(column)) {
    const values = measured?.columns[0]
    measured?.ids.forEach((id, k) => {
      keys[id] = values?.[k] as number
    })
  } else if (isFixed(column)) {
    for (const id of ids) keys[id] = circles.get(id)?.[column] as number
  } else {
    ids.forEach((id, k) => {
      keys[id] = given[k] ?? Number.NaN
    })
  }
  const sign = isDescending ? -1 : 1
  // Circles without a number come last. Ties are broken by id.
  return ids.sort((one, other) => {
    const [a, b] = [keys[one] as number, keys[other] as number]
    if (a < b) return -sign
    if (a > b) return sign
    return a === b ? one - other : Number(Number.isNaN(a)) - Number(Number.isNaN(b)) || one - other
  })
}

/** The row of each id; -1 for missing ids. */
export function placesOf(order: Int32Array): Int32Array {
  let last = -1
  for (const id of order) last = Math.max(last, id)
  const places = new Int32Array(last + 1).fill(-1)
  order.forEach((id, row) => {
    places[id] = row
  })
  return places
}
