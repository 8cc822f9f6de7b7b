// SPDX-License-Identifier: GPL-3.0-or-later
// Files of circles with what else is known of each: the writers of the library have a line for each circle.
import { membersOf, textIn } from '../../editing/attributes.ts'
import type { LinkAttributes } from '../../lib/link.ts'
import type { SavedFormat } from './files-protocol.ts'

/** Members that the writers use themselves. */
const OWN: Readonly<Record<SavedFormat, readonly string[]>> = {
  csv: ['x', 'y', 'r'],
  json: ['x', 'y', 'r'],
  geojson: ['circle', 'r'],
  cells: ['circle', 'r', 'area', 'neighbors'],
}
const CIRCLE: Readonly<Record<SavedFormat, RegExp>> = {
  csv: /^/,
  json: /^ {2}\{"x": /,
  geojson: /^\{"type":"Feature",/,
  cells: /^\{"type":"Feature",/,
}

/** A text that the library has written of some circles, with their attributes in the same order. */
export function withAttributes(text: string, format: SavedFormat, attributes: LinkAttributes): string {
  const members = attributes.properties.map((properties) => membersOf(properties))
  const isTaken = new Set(OWN[format])
  const nameIn = (name: string) => (isTaken.has(name) ? `input_${name}` : name)
  if (format === 'csv') return table(text, members, nameIn)
  let circle = 0
  const lines = text.split('\n').map((line) => {
    if (!CIRCLE[format].test(line)) return line
    const own = (members[circle] ?? []).map(([name, value]) => `${JSON.stringify(nameIn(name))}:${value}`).join()
    const id = attributes.ids[circle] ?? ''
    const height = attributes.heights[circle] ?? ''
    circle += 1
    if (format === 'json') {
      const parts = [id && `"id": ${id}`, height && `"z": ${height}`, own && `"properties": {${own}}`].filter(Boolean)
      return parts.length === 0 ? line : line.replace('}', () => `, ${parts.join(', ')}}`)
    }
    return line
      .replace('"type":"Feature",', (type) => (id === '' ? type : `${type}"id":${id},`))
      .replace('},"geometry"', (end) => (own === '' ? end : `,${own}${end}`))
      .replace(/("type":"Point","coordinates":\[[^\]]*)\]/, (whole, point) =>
        height === '' ? whole : `${point},${height}]`,
      )
  })
  return lines.join('\n').replace('"FeatureCollection",', (type) => {
    const collection = membersOf(attributes.collection).filter(([name]) => !['type', 'features', 'bbox'].includes(name))
    return [type, ...collection.map(([name, value]) => `${JSON.stringify(name)}:${value},`)].join('')
  })
}

function table(
  text: string,
  members: readonly (readonly (readonly [name: string, value: string])[])[],
  nameIn: (name: string) => string,
): string {
  const names = [...new Set(members.flatMap((own) => own.map(([name]) => name)))]
  const [heading = '', ...lines] = text.split('\n')
  const rows = lines.map((line, k) => {
    const own = members[k]
    if (line === '' || own === undefined) return line
    const values = new Map(own)
    return [line, ...names.map((name) => field(values.get(name)))].join()
  })
  return [[heading, ...names.map((name) => quoted(nameIn(name)))].join(), ...rows].join('\n')
}

/** A text that would be a number is in quotation marks, so that it stays a text. */
function field(value: string | undefined): string {
  const text = textIn(value)
  return value?.startsWith('"') && /^\s*[-+]?[\d.]/.test(text) ? `"${text.replaceAll('"', '""')}"` : quoted(text)
}

function quoted(text: string): string {
  return /[",\r\n;\t]|^\s|\s$|^#/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}
