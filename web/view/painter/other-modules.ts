// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the modules that few figures need, when they need them.
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import type { Metrics } from '../../lib/wasm/metrics.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import type { OtherModules } from '../load.ts'

export async function metricsFor(library: CircleVoronoi, { metricsWasm }: OtherModules): Promise<Metrics> {
  const { loadMetrics } = await import('../../lib/metrics.ts')
  return loadMetrics({ library, wasm: metricsWasm })
}

export async function regionsFrom({ regionsWasm }: OtherModules): Promise<Regions> {
  const { loadRegions } = await import('../../lib/regions.ts')
  return loadRegions({ wasm: regionsWasm })
}
