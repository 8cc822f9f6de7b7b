// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a table by their names The reader itself knows `lon`, `lat`, `r` and some others.

const LONGITUDE = /^(geo|decimal)?(x|lon|lng|long|longitude|länge|längengrad)(deg|degrees|wgs)?$/
const LATITUDE = /^(geo|decimal)?(y|lat|latitude|breite|breitengrad)(deg|degrees|wgs)?$/
const RADIUS = /^(r|rad|radius|radii|reach|range|reichweite)?$/
const NAME = /^(name|label|title|city|station|place|id|ort|stadt|bezeichnung)$/i
/** Units at the end of a name without blanks and signs. */
const UNITS = { km: /(in)?(km|kilomet(er|re)s?n?)$/, m: /(in)?(m|met(er|re)s?n?)$/ }

/**
 * Returns the names of a table's columns, or of the members of JSON objects.
 * @param {string} text
 */
export function headingOf(text) {
  const content = text.replace(/^\uFEFF/, '').trimStart()
  if (/^[[{]/.test(content)) return membersOf(content)
  const line = content.split(/\r\n?|\n/).find((line) => line.trim() !== '' && !line.startsWith('#')) ?? ''
  const separator = [';', '\t', '|', ','].find((sign) => line.includes(sign)) ?? /\s+/
  return line.split(separator).map((name) => name.trim().replace(/^"(.*)"$/, '$1'))
}

function membersOf(json) {
  try {
    const value = JSON.parse(json)
    const [first] = value.features?.map(({ properties }) => properties) ?? value
    return Object.keys(first).filter((name) => Number.isNaN(Number(name)))
  } catch {
    // The reader says what is wrong.
    return []
  }
}

/**
 * Returns the columns of the places and of their radii, and the unit of the radii if their column names it; `undefined`
 * for unknown ones.
 * @param {readonly string[]} heading
 */
export function columnsIn(heading) {
  const find = (pattern) => heading.find((name) => pattern.test(plain(name)))
  const radius = heading.find((name) => {
    const rest = withoutUnit(name)
    return RADIUS.test(rest) && (rest !== '' || unitOf(name) === 'km')
  })
  return { longitude: find(LONGITUDE), latitude: find(LATITUDE), radius, unit: radius && unitOf(radius) }
}

/**
 * Returns the unit in the name of a column: `km`, `m` or `undefined`.
 * @param {string} name
 */
export function unitOf(name) {
  return Object.keys(UNITS).find((unit) => UNITS[unit].test(plain(name)))
}

/** Returns the column with the names of places: one of the usual names, or the first column with texts. */
export function nameColumn(rows) {
  const names = Object.keys(rows[0] ?? {})
  return names.find((name) => NAME.test(name)) ?? names.find((name) => typeof rows[0][name] === 'string')
}

function withoutUnit(name) {
  const unit = unitOf(name)
  return unit === undefined ? plain(name) : plain(name).replace(UNITS[unit], '')
}

/** Leaves the letters of a name. */
function plain(name) {
  return name.toLowerCase().replace(/[^\p{L}]/gu, '')
}
