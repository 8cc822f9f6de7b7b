// SPDX-License-Identifier: GPL-3.0-or-later
import { comparisonOf, loadComparisonModule } from './comparison.ts'
import type { CircleVoronoi, ComputingLibrary } from './library.ts'
import { checkLoadOptions } from './load-options.ts'
import { loadRegionsModule, regionsOf } from './regions.ts'

/**
 * A library that can also load its other modules. The workers of bundlers do without: some bundlers cannot split the code of
 * a worker.
 */
export function withModules(library: ComputingLibrary): CircleVoronoi {
  return {
    ...library,
    async loadComparison(options = {}) {
      checkLoadOptions(options, 'loadComparison')
      return comparisonOf(library, await loadComparisonModule(options))
    },
    async loadRegions(options = {}) {
      checkLoadOptions(options, 'loadRegions')
      return regionsOf(await loadRegionsModule(options))
    },
  }
}
