// SPDX-License-Identifier: GPL-3.0-or-later
import type { Float64s } from '../lib/index.ts'

/**
 * Reads lines `x,y,r` as x, y, r each. A header line and blank lines are allowed.
 *
 * @throws Error that names the first line which is not three numbers.
 */
export function parseCircles(text: string): Float64s {
  const numbers: number[] = []
  for (const [index, line] of text.split(/\r?\n/).entries()) {
    const fields = line.split(',').map((field) => field.trim())
    const values = fields.map(Number)
    const isCircle = fields.length === 3 && fields.every((field) => field !== '') && !values.some(Number.isNaN)
    if (isCircle) {
      numbers.push(...values)
    } else if (line.trim() !== '' && !(index === 0 && values.every(Number.isNaN))) {
      throw new Error(`Line ${index + 1} is not three numbers x,y,r: ${line}`)
    }
  }
  return Float64Array.from(numbers)
}
