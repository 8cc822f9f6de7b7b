// SPDX-License-Identifier: GPL-3.0-or-later
// Like page.js, with the options that esbuild needs.
import wasm from 'circle-voronoi/circle-voronoi.wasm'
import metrics from 'circle-voronoi/circle-voronoi-metrics.wasm'
import regions from 'circle-voronoi/circle-voronoi-regions.wasm'
import { use } from './main.js'
import { show } from './show.js'

show(use({ wasm }, { wasm: metrics }, { wasm: regions }))
