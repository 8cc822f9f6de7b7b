// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a table of places with the reader of `circle-voronoi/files`.
import { EARTH_RADIUS } from 'circle-voronoi/sphere'
import { columnsIn, headingOf, nameColumn, unitOf } from './columns.js'

const KILOMETERS = { km: 1, m: 1e-3 }

/**
 * @typedef {object} Table
 * @property {string} name of the file
 * @property {string} text
 * @property {Float64Array} places longitude, latitude and radius in kilometers of each circle
 * @property {readonly string[]} properties the other columns of each circle, as JSON
 * @property {readonly object[]} rows the same, parsed
 * @property {string | undefined} naming the column with names
 * @property {string} radius the column of radii; empty: all places are points
 * @property {'km' | 'm'} unit of the column of radii
 * @property {readonly string[]} numeric all columns that may be radii
 */

/**
 * Reads a table. `radius` and `unit` are choices of the user; without them, the names of the columns decide.
 * @param {import('circle-voronoi/files').Files} files
 * @returns {Table}
 * @throws Error with one sentence
 */
export function readTable(files, { name, text, radius: chosen, unit: chosenUnit }) {
  const heading = headingOf(text)
  const found = columnsIn(heading)
  const isGeoJson = /^\uFEFF?\s*\{/.test(text)
  const isNamed = found.longitude !== undefined && found.latitude !== undefined
  const isHeading = heading.length > 0 && heading.every((field) => Number.isNaN(Number.parseFloat(field)))
  if (isHeading && !isNamed && !isGeoJson) {
    throw new Error(`${name}: there are no columns for longitude and latitude, only ${heading.join(', ')}.`)
  }
  const radius = chosen ?? found.radius ?? ''
  const { circles, attributes } = files.readCircleFile(text, {
    name,
    ...(isNamed && !isGeoJson && { x: found.longitude, y: found.latitude }),
    ...(radius !== '' ? { radius } : (isNamed || isGeoJson) && { points: true }),
  })
  if (circles.length === 0) throw new Error(`${name}: there are no circles.`)
  const radii = circles.filter((_, k) => k % 3 === 2)
  const unit = chosenUnit ?? unitOf(radius) ?? likelyUnit(radii)
  const rows = attributes.properties.map((text) => JSON.parse(text))
  return {
    name,
    text,
    places: circles.map((value, k) => (k % 3 === 2 ? value * KILOMETERS[unit] : value)),
    properties: attributes.properties,
    rows,
    naming: nameColumn(rows),
    radius,
    unit,
    numeric: heading.filter((name) => name === radius || isRadius(name, rows)),
  }
}

/** Radii that are longer than half of the way around the Earth in kilometers are meters. */
function likelyUnit(radii) {
  return radii.some((r) => r > Math.PI * EARTH_RADIUS) ? 'm' : 'km'
}

function isRadius(name, rows) {
  return rows.length > 0 && rows.every((row) => typeof row[name] === 'number' && row[name] >= 0)
}

/** Returns the name of a circle. */
export function nameOf({ rows, naming }, circle) {
  const name = naming === undefined ? undefined : rows[circle]?.[naming]
  return name === undefined || name === null || name === '' ? `Circle ${circle}` : String(name)
}
