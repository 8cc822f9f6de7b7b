// SPDX-License-Identifier: GPL-3.0-or-later
// node examples/treemap/write-svg.mjs treemap.svg, after `npm run build:lib`: writes the treemap of the page as a file.
import { writeFileSync } from 'node:fs'
import { loadRegions } from '../../dist/lib/regions.js'
import { disc, LAND } from './land.js'
import { svgOf } from './svg.js'
import { treemap } from './treemap.js'

const SIZE = 800
const regions = await loadRegions()
const whole = regions.region([disc({ x: SIZE / 2, y: SIZE / 2, r: SIZE / 2 - 4 })])
writeFileSync(process.argv[2], svgOf(treemap(regions, LAND, whole), SIZE))
