// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError, reasonOf } from '../base/errors.ts'
import { importComparison } from './import-comparison.ts'
import type { CircleVoronoi, ComputingLibrary } from './library.ts'
import { checkLoadOptions } from './load-options.ts'

/**
 * A library that can also load comparison diagrams. Workers of bundlers do without: some bundlers cannot split the code of
 * a worker.
 */
export function withComparison(library: ComputingLibrary): CircleVoronoi {
  return {
    ...library,
    async loadComparison(options = {}) {
      checkLoadOptions(options, 'loadComparison')
      const { comparisonOf } = await importComparison().catch((cause) => {
        const message = `The comparison diagrams cannot be loaded: ${reasonOf(cause)}.`
        throw new CircleVoronoiError('notLoaded', message, { cause })
      })
      return comparisonOf(library, options)
    },
  }
}
