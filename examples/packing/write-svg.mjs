// SPDX-License-Identifier: GPL-3.0-or-later
// node examples/packing/write-svg.mjs packing.svg, after `npm run build:lib`: packs discs and draws cells and contacts.
import { writeFileSync } from 'node:fs'
import { loadCircleVoronoi } from '../../dist/lib/index.js'
import { pack, touching } from './packing.js'
import { svgOf } from './svg.js'

const LATTICE = { a: [1, 0], b: [0.2, 0.8] }
const COUNT = 60
const RATIO = 1.4

let state = 7
const random = () => {
  state = (state * 1664525 + 1013904223) % 2 ** 32
  return state / 2 ** 32
}

const periodic = pack(await loadCircleVoronoi(), LATTICE, COUNT, RATIO, random)
const { areas, packingFractions } = periodic.contacts()
const covered = areas.reduce((sum, area, i) => sum + area * packingFractions[i], 0)
const whole = areas.reduce((sum, area) => sum + area, 0)
console.log(`${COUNT} discs cover ${((100 * covered) / whole).toFixed(1)} % of the box.`)
console.log(`Each touches ${((2 * touching(periodic).length) / COUNT).toFixed(1)} others on average.`)
writeFileSync(process.argv[2], svgOf(periodic, 800))
