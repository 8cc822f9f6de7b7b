// SPDX-License-Identifier: GPL-3.0-or-later
import { loadComparison } from './comparison.ts'
import type { CircleVoronoi, ComputingLibrary } from './library.ts'
import { checkLoadOptions } from './load-options.ts'
import { loadRegions } from './load-regions.ts'

/**
 * A library that can also load its other modules. The workers of bundlers do without: some bundlers cannot split the code of
 * a worker.
 */
export function withModules(library: ComputingLibrary): CircleVoronoi {
  return {
    ...library,
    async loadComparison(options = {}) {
      checkLoadOptions(options, 'loadComparison')
      return loadComparison(library, options)
    },
    async loadRegions(options = {}) {
      checkLoadOptions(options, 'loadRegions')
      return loadRegions(options)
    },
  }
}
