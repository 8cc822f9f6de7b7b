// SPDX-License-Identifier: GPL-3.0-or-later
// Parses numbers that are typed or pasted into the table of circles, and turns them into edits.
import type { Circle, Edit } from '../../lib/index.ts'
import { NumberReader, recordsOf, type Separator, TextProblem } from '../../view/table-text.ts'

const WRITTEN = ['x', 'y', 'r'] as const
export type Written = (typeof WRITTEN)[number]

/** Parses a number as the reader of tables does between tabs. Spreadsheets may write a true minus sign. */
export function numberOf(text: string, separator: Separator = '\t', isQuoted = false): number | undefined {
  return new NumberReader(separator).read({ text: text.trim().replace(/^\u2212/, '-'), isQuoted })
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
  const lines = text.replace(/(\r?\n[^\S\n]*)+$/, '')
  const separator = separatorOf(lines)
  const rows: number[][] = []
  try {
    const records = [...recordsOf(lines, separator)]
    const numbers = records.map(({ fields }) => fields.map((field) => numberOf(field.text, separator, field.isQuoted)))
    const isHeading = records.length > 1 && numbers[0]?.every((number) => number === undefined) === true
    for (const [k, { fields, line }] of records.entries()) {
      // The reader skipped a line, so the rows below it would move up.
      if (line !== k + 1) return { problem: notANumber('') }
      if (k === 0 && isHeading) continue
      const wrong = numbers[k]?.indexOf(undefined) ?? -1
      if (wrong >= 0) return { problem: notANumber(fields[wrong]?.text ?? '') }
      rows.push(numbers[k] as number[])
    }
  } catch (error) {
    if (!(error instanceof TextProblem)) throw error
    return { problem: notANumber(text) }
  }
  return rows.length === 0 ? { problem: 'There is nothing to paste.' } : rows
}

/** Finds the separator. In contrast to a file, a pasted text may be one column, also with decimal commas. */
function separatorOf(text: string): Separator {
  const separator = (['\t', ';', '|'] as const).find((candidate) => text.includes(candidate))
  if (separator !== undefined) return separator
  const lastLine = text.slice(text.lastIndexOf('\n') + 1)
  return numberOf(lastLine) !== undefined ? ';' : text.includes(',') ? ',' : ' '
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
