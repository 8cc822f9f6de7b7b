// SPDX-License-Identifier: GPL-3.0-or-later
import type { Attributes } from '../editing/attributes.ts'
import type { Float64s } from '../lib/index.ts'

/** Circles with optional names and further attributes of a file. */
export interface NamedCircles {
  readonly circles: Float64s
  readonly names?: readonly string[] | undefined
  readonly attributes?: Attributes | undefined
}

/**
 * Reads lines `x,y,r` as x, y, r each. A header line and blank lines are allowed.
 *
 * @throws Error that names the first line which is not three numbers.
 */
export function parseCircles(text: string): Float64s {
  return parseNamed(text).circles
}

/**
 * Reads the same format, with names from a column `name` in the header.
 * @throws Error as `parseCircles`
 */
export function parseNamed(text: string): NamedCircles {
  const numbers: number[] = []
  const names: string[] = []
  let hasNames = false
  for (const [index, line] of text.split(/\r?\n/).entries()) {
    const fields = line.split(',').map((field) => field.trim())
    const values = fields.slice(0, 3)
    const isCircle =
      fields.length === (hasNames ? 4 : 3) && values.every((field) => field !== '' && !Number.isNaN(Number(field)))
    if (isCircle) {
      numbers.push(...values.map(Number))
      names.push(fields[3] ?? '')
    } else if (index === 0 && fields.every((field) => Number.isNaN(Number(field)))) {
      hasNames = fields[3] === 'name'
    } else if (line.trim() !== '') {
      throw new Error(`Line ${index + 1} is not three numbers x,y,r: ${line}`)
    }
  }
  return { circles: Float64Array.from(numbers), names: hasNames ? names : undefined }
}
