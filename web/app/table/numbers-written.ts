// SPDX-License-Identifier: GPL-3.0-or-later
// Parses numbers as people and spreadsheets write them, and turns pasted numbers into edits.
import type { Circle, Edit } from '../../lib/index.ts'

const WRITTEN = ['x', 'y', 'r'] as const
export type Written = (typeof WRITTEN)[number]

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i
const WITH_COMMA = /^[+-]?\d+,\d+$/

/** `hasDecimalCommas`: whether every comma is a decimal mark. */
export function numberOf(text: string, hasDecimalCommas = true): number | undefined {
  const trimmed = text.trim().replace(/^\u2212/, '-')
  if (hasDecimalCommas && WITH_COMMA.test(trimmed)) return Number(trimmed.replace(',', '.'))
  return NUMBER.test(trimmed) ? Number(trimmed) : undefined
}

/** An error in one sentence. */
export interface Wrong {
  readonly problem: string
}

export function notANumber(text: string): string {
  return `“${text.trim().slice(0, 40)}” is not a number. Nothing has changed.`
}

/** Parses rows of numbers from a spreadsheet or text. A first row of words is a header. */
export function rowsOf(text: string): readonly (readonly number[])[] | Wrong {
  const lines = text.split(/\r?\n/)
  while (lines.at(-1)?.trim() === '') lines.pop()
  const separator = text.includes('\t') ? '\t' : text.includes(';') ? ';' : /\d,\d*,|\d, /.test(text) ? ',' : /\s+/
  const fieldsOf = (line: string) =>
    typeof separator === 'string' ? line.split(separator) : line.trim().split(separator)
  const isComma = separator === ','
  const first = lines[0] === undefined ? [] : fieldsOf(lines[0])
  const isHeading = lines.length > 1 && first.every((field) => numberOf(field, !isComma) === undefined)
  const rows: number[][] = []
  for (const line of isHeading ? lines.slice(1) : lines) {
    const row: number[] = []
    for (const field of fieldsOf(line)) {
      const value = numberOf(field, !isComma)
      if (value === undefined) return { problem: notANumber(field) }
      row.push(value)
    }
    rows.push(row)
  }
  return rows.length === 0 ? { problem: 'There is nothing to paste.' } : rows
}

/**
 * The edits that paste rows of numbers, starting at a column: into the circles of `ids`, one per row, then into new
 * circles.
 */
export function editsOf(
  rows: readonly (readonly number[])[],
  column: Written,
  ids: readonly number[],
  circleOf: (id: number) => Circle | undefined,
): readonly Edit[] | Wrong {
  const columns = WRITTEN.slice(WRITTEN.indexOf(column))
  const edits: Edit[] = []
  for (const [k, row] of rows.entries()) {
    if (row.length > columns.length) {
      return { problem: `There are ${row.length} columns to paste and only ${columns.join(', ')} to take them.` }
    }
    const given = Object.fromEntries(row.map((value, place) => [columns[place] as Written, value]))
    const id = ids[k]
    const circle = id === undefined ? undefined : circleOf(id)
    if (id !== undefined && circle !== undefined) edits.push({ kind: 'replace', id, circle: { ...circle, ...given } })
    else if (row.length === WRITTEN.length) edits.push({ kind: 'insert', circle: given as unknown as Circle })
    else return { problem: 'Rows beyond the last one are new circles: they need x, y and r.' }
  }
  return edits
}
