// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the modules that few figures need, when they need them.
import type { Comparison } from '../../lib/wasm/comparison.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import type { OtherModules } from '../load.ts'

export async function comparisonFor(library: CircleVoronoi, { comparisonWasm }: OtherModules): Promise<Comparison> {
  const { comparisonOf } = await import('../../lib/wasm/comparison.ts')
  return comparisonOf(library, comparisonWasm)
}

export async function regionsFrom({ regionsWasm }: OtherModules): Promise<Regions> {
  const { loadRegions } = await import('../../lib/regions.ts')
  return loadRegions({ wasm: regionsWasm })
}
