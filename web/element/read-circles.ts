// SPDX-License-Identifier: GPL-3.0-or-later
// Reads circles from a page's text, tables and data. Errors are in the reader's language.
import { isRecord } from '../lib/base/check.ts'
import { type Circles, coordinatesOf } from '../lib/base/coordinates.ts'
import {
  circlesOfJson,
  circlesOfRows,
  identitiesIn,
  namedCirclesOfText,
  type TextCircles,
} from '../view/circle-text.ts'
import { TextProblem } from '../view/table-text.ts'
import { parseJson } from './attributes.ts'
import { type ElementRefusals, refuse } from './refusals.ts'

/**
 * Reads circles from a text: JSON (`[[x, y, r], ...]`, objects, or an object with `circles`), GeoJSON points, or CSV.
 * The numbers and columns equal the result of `readCircles` of `circle-voronoi/files`, bit for bit.
 *
 * @throws CircleVoronoiError `badInput`
 */
export function readCircles(text: string): TextCircles {
  if (/^\s*[[{]/.test(text)) return circlesOfGiven(parseJson(text, (words) => words.circles))
  const lines = text.split(/\r\n?|\n/)
  const circles = saying(
    () => namedCirclesOfText(text),
    (words, line) => words.notThree(words.line(line), lines[line - 1] ?? ''),
  )
  return circles.circles.length > 0 ? circles : refuse((words) => words.noCircles)
}

/** Reads a table with a row for each circle: three numbers, or columns named by a header row. */
export function circlesOfTable(table: HTMLTableElement): TextCircles {
  const rows = Array.from(table.rows, (row, k) => ({
    line: k + 1,
    fields: Array.from(row.cells, (cell) => cell.textContent ?? ''),
  }))
  return circlesOfCells(rows, (words, line) => words.row(line))
}

/** Reads a Markdown table, with or without the line below its header. */
export function circlesOfMarkdown(text: string): TextCircles {
  const lines = text.split(/\r\n?|\n/).map((line, k) => ({
    line: k + 1,
    fields: line
      .trim()
      .replace(/^\||\|$/g, '')
      .split('|'),
  }))
  const rows = lines.filter(({ fields }) => !fields.every((field) => /^\s*:?-*:?\s*$/.test(field)))
  return circlesOfCells(rows, (words, line) => words.line(line))
}

/** `place` formats the position of a row for errors. */
function circlesOfCells(
  rows: readonly { readonly line: number; readonly fields: readonly string[] }[],
  place: (words: ElementRefusals, line: number) => string,
): TextCircles {
  const cells = rows.map(({ line, fields }) => ({
    line,
    fields: fields.map((text) => ({ text: text.trim(), isQuoted: false })),
  }))
  const fieldsOf = (line: number) => rows.find((row) => row.line === line)?.fields.map((text) => text.trim()) ?? []
  const circles = saying(
    // The cells are already separated, so commas are decimal marks.
    () => circlesOfRows(cells, ';'),
    (words, line) => words.notThree(place(words, line), fieldsOf(line).join(' ')),
  )
  return circles.circles.length > 0 ? circles : refuse((words) => words.noCircles)
}

function circlesOfGiven(given: unknown): TextCircles {
  if (Array.isArray(given) || (isRecord(given) && given.type === 'FeatureCollection')) {
    return saying(
      () => circlesOfJson(given),
      (words) => words.noCircles,
    )
  }
  // Accepts the arrays of a diagram, and states.
  const list = isRecord(given) ? given.circles : given
  const isFlat = Array.isArray(list) && typeof list[0] === 'number'
  return circlesOfValue(isFlat ? Float64Array.from(list as number[]) : (list as Circles))
}

/** Circles in any form that `compute` takes; objects may have names and colors. */
export function circlesOfValue(value: Circles): TextCircles {
  return { circles: coordinatesOf(value), columns: Array.isArray(value) ? identitiesIn(value) : [] }
}

/** Runs `read`, and turns an error in the text into a refusal. `say` formats errors of a line. */
function saying(read: () => TextCircles, say: (words: ElementRefusals, line: number) => string): TextCircles {
  try {
    return read()
  } catch (error) {
    if (!(error instanceof TextProblem)) throw error
    const { line, circle } = error
    return refuse((words) => {
      if (circle !== undefined) return words.notCircle(circle)
      return line === undefined ? words.noCircles : say(words, line)
    })
  }
}
