// SPDX-License-Identifier: GPL-3.0-or-later
// node examples/treemap/write-svg.mjs treemap.svg, after `npm run build:lib`: writes the first treemap of the page as a file.
import { writeFileSync } from 'node:fs'
import { loadRegions } from '../../dist/lib/regions.js'
import { disc, peopleIn, YEARS } from './people.js'
import { svgOf } from './svg.js'

const SIZE = 800
const { region, treemap } = await loadRegions()
const whole = region([disc({ x: SIZE / 2, y: SIZE / 2, r: SIZE / 2 - 4 })])
writeFileSync(process.argv[2], svgOf(treemap(peopleIn(YEARS[0]), { region: whole }), SIZE))
