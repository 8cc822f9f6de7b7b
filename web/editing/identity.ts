// SPDX-License-Identifier: GPL-3.0-or-later
// The columns that say how a circle is called and colored.
import { COLOR_COLUMN, NAME_COLUMN } from '../view/identity-columns.ts'
import type { Name } from '../view/labels.ts'
import type { OwnColors } from '../view/layers.ts'
import { type Attributed, type Attributes, type DataColumn, textIn } from './attributes.ts'

/** The names of new columns for names and colors. */
export const NAME = 'name'
export const COLOR = 'color'

/** The column that holds the names of circles. */
export function nameColumn(columns: readonly DataColumn[]): DataColumn | undefined {
  return columns.find(({ name }) => NAME_COLUMN.test(name))
}

/** Whether a column holds the names or the colors. */
export function isIdentity(column: DataColumn, columns: readonly DataColumn[]): boolean {
  return column === nameColumn(columns) || column === colorColumn(columns)
}

/** Returns the name of a circle by its id: that of its column, or else its id in a file, or an empty text. */
export function namesBy(columns: readonly DataColumn[]): (id: number) => string {
  const [own, inFile] = [nameColumn(columns)?.values, columns.find(({ name }) => /^id$/i.test(name.trim()))?.values]
  return (id) => textIn(own?.[id]).trim() || textIn(inFile?.[id]).trim()
}

/** The name of a circle, or an empty text. */
export function nameIn({ columns }: Attributes, id: number): string {
  return namesBy(columns)(id)
}

/** The column that holds the colors of circles. */
export function colorColumn(columns: readonly DataColumn[]): DataColumn | undefined {
  return columns.find(({ name }) => COLOR_COLUMN.test(name))
}

/** The names of circles, by decreasing radius. */
export function namesOf({ circles, attributes }: Attributed): Name[] {
  if (attributes.columns.length === 0) return []
  const nameOf = namesBy(attributes.columns)
  const named = Array.from(circles.ids()).flatMap((id) => {
    const text = nameOf(id)
    return text === '' ? [] : [{ id, text, r: circles.get(id)?.r ?? 0 }]
  })
  return named.sort((one, other) => other.r - one.r || one.id - other.id)
}

/** The colors that circles have by a column; `undefined` if none has one. `isRight` tells which texts are colors. */
export function ownColorsOf({ circles, attributes }: Attributed, isRight = isColor): OwnColors | undefined {
  const column = colorColumn(attributes.columns)
  if (column === undefined) return undefined
  const places = new Map<string, number>()
  const values = new Float64Array(circles.size).fill(Number.NaN)
  for (const id of circles.ids()) {
    const color = textIn(column.values[id]).trim()
    if (!isRight(color)) continue
    const place = places.get(color) ?? places.size
    places.set(color, place)
    values[id] = place
  }
  return places.size === 0 ? undefined : { values, colors: [...places.keys()] }
}

/** Whether a text is a CSS color. Outside of browsers, only those in hexadecimal digits are known. */
export function isColor(text: string): boolean {
  if (/^#([\da-f]{3,4}|[\da-f]{6}|[\da-f]{8})$/i.test(text)) return true
  return (
    globalThis.CSS?.supports('color', text) === true &&
    !/^(inherit|initial|unset|revert|revert-layer|currentcolor)$/i.test(text) &&
    !/var\(/i.test(text)
  )
}
