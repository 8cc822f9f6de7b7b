// SPDX-License-Identifier: GPL-3.0-or-later
// The facts about a cell, as text for the panel and for screen readers.
import { short } from './colors.js'
import { nameOf } from './table.js'

/** More columns are in the saved file only. */
const MOST_COLUMNS = 8

/**
 * Returns what there is to say about a circle and its cell.
 * @returns {{ name: string, facts: [label: string, text: string][], neighbors: number[], sentence: string }}
 */
export function detailsOf({ table, diagram }, circle) {
  const name = nameOf(table, circle)
  const neighbors = [...new Set(diagram.neighbors(circle))]
  const radius = diagram.caps[3 * circle + 2]
  const area = areaText(diagram.cellArea(circle))
  const columns = Object.entries(table.rows[circle] ?? {})
    .filter(([column, value]) => column !== table.naming && value !== null && value !== '')
    .slice(0, MOST_COLUMNS)
    .map(([column, value]) => [column, typeof value === 'number' ? value.toLocaleString('en') : textOf(value)])
  const hider = hiderOf(diagram, circle)
  const facts = [
    ...(hider === undefined ? [['Area of the cell', area]] : [['Hidden by', nameOf(table, hider)]]),
    ...(radius > 0 ? [['Radius', lengthText(radius)]] : []),
    ['Place', placeText(diagram.caps[3 * circle], diagram.caps[3 * circle + 1])],
    ...columns,
  ]
  const count = neighbors.length === 1 ? '1 neighbor' : `${neighbors.length} neighbors`
  return { name, facts, neighbors, sentence: `${name}: ${area}, ${count}.` }
}

/** Returns the circle that hides another. */
function hiderOf({ hidden }, circle) {
  const k = hidden.findIndex((value, k) => k % 2 === 0 && value === circle)
  return k < 0 ? undefined : hidden[k + 1]
}

function areaText(area) {
  return area >= 1 || area === 0 ? `${short(area)} km²` : `${short(1e6 * area)} m²`
}

function lengthText(kilometers) {
  return kilometers >= 1 ? `${short(kilometers)} km` : `${short(1000 * kilometers)} m`
}

function placeText(longitude, latitude) {
  const east = ((((longitude + 180) % 360) + 360) % 360) - 180
  const part = (value, [positive, negative]) => `${Math.abs(value).toFixed(2)}° ${value < 0 ? negative : positive}`
  return `${part(latitude, 'NS')}, ${part(east, 'EW')}`
}

function textOf(value) {
  return typeof value === 'string' ? value : JSON.stringify(value)
}
