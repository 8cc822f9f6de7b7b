// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces web/view/painter/other-modules.ts in the element. The scripts of the modules are imported statically: Vite
// up to 7 cannot split the code of a worker, and a script that is opened from a disk can import nothing. They are
// imported first and together: similar scripts next to one another compress to a third of their size.
import '../lib/generated/circle-voronoi.js'
import '../lib/generated/circle-voronoi-metrics.js'
import '../lib/generated/circle-voronoi-regions.js'
import { loadMetrics } from '../lib/metrics.ts'
import { loadRegions } from '../lib/regions.ts'
import type { CircleVoronoi } from '../lib/wasm/library.ts'
import type { Metrics } from '../lib/wasm/metrics.ts'
import type { Regions } from '../lib/wasm/regions.ts'
import type { OtherModules } from '../view/load.ts'

export function metricsFor(library: CircleVoronoi, { metricsWasm }: OtherModules): Promise<Metrics> {
  return loadMetrics({ library, wasm: metricsWasm })
}

export function regionsFrom({ regionsWasm }: OtherModules): Promise<Regions> {
  return loadRegions({ wasm: regionsWasm })
}
