// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError, reasonOf } from '../base/errors.ts'
import { importComparison, importRegions } from './import-modules.ts'
import type { CircleVoronoi, ComputingLibrary } from './library.ts'
import { checkLoadOptions } from './load-options.ts'

/**
 * A library that can also load its other modules. Workers of bundlers do without: some bundlers cannot split the code of a
 * worker.
 */
export function withModules(library: ComputingLibrary): CircleVoronoi {
  return {
    ...library,
    async loadComparison(options = {}) {
      checkLoadOptions(options, 'loadComparison')
      const { comparisonOf } = await importComparison().catch(notLoaded('The comparison diagrams'))
      return comparisonOf(library, options)
    },
    async loadRegions(options = {}) {
      checkLoadOptions(options, 'loadRegions')
      const { regionsOf } = await importRegions().catch(notLoaded('The regions'))
      return regionsOf(options)
    },
  }
}

function notLoaded(what: string): (cause: unknown) => never {
  return (cause) => {
    throw new CircleVoronoiError('notLoaded', `${what} cannot be loaded: ${reasonOf(cause)}.`, { cause })
  }
}
