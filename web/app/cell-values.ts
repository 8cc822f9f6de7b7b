// SPDX-License-Identifier: GPL-3.0-or-later
import { type DataColumn, isNumeric, numberIn, textIn } from '../editing/attributes.ts'
import type { CircleTable } from '../view/circle-table.ts'
import type { CellValues } from '../view/layers.ts'

/** The values of a column by which cells are colored: numbers, or categories by descending frequency. */
export function cellValues(column: DataColumn, circles: CircleTable): CellValues {
  const { name } = column
  const values = new Float64Array(circles.size).fill(Number.NaN)
  const ids = circles.ids()
  if (isNumeric(column)) {
    for (const id of ids) values[id] = numberIn(column.values[id])
    return { name, values }
  }
  const counts = new Map<string, number>()
  for (const id of ids) {
    const text = textIn(column.values[id])
    if (text !== '') counts.set(text, (counts.get(text) ?? 0) + 1)
  }
  const categories = [...counts.keys()].sort(
    (one, other) => (counts.get(other) as number) - (counts.get(one) as number) || (one < other ? -1 : 1),
  )
  const places = new Map(categories.map((category, k) => [category, k]))
  for (const id of ids) values[id] = places.get(textIn(column.values[id])) ?? Number.NaN
  return { name, values, categories }
}
