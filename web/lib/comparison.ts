// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Two related diagrams of the same circles: the ordinary Voronoi diagram of the centers, and the power diagram.
 *
 * @module circle-voronoi/comparison
 */
import { checkOptionNames, isRecord, refuseOption, shown } from './base/check.ts'
import { type Comparison, comparisonOf } from './wasm/comparison.ts'
import type { CircleVoronoi } from './wasm/library.ts'
import { checkLoadOptions, type LoadOptions } from './wasm/load-options.ts'
import { loadCircleVoronoi } from './wasm/loader.ts'

export type { Comparison } from './wasm/comparison.ts'

/**
 * Options of `loadComparison`.
 *
 * @category Comparison
 */
export interface ComparisonLoadOptions {
  /** The source of `circle-voronoi-comparison.wasm`. Default: the file next to this module. */
  readonly wasm?: LoadOptions['wasm']
  /** A library that is loaded already. Default: another one is loaded. */
  readonly library?: CircleVoronoi | undefined
}

/**
 * Loads the WebAssembly of comparison diagrams.
 *
 * @throws CircleVoronoiError `notLoaded`, `badOption`. Each as a rejection.
 *
 * @category Comparison
 * @example
 * const { computeComparison } = await loadComparison()
 * computeComparison([[0, 0, 3], [10, 0, 1]], 'power').find(5.2, 0) // 0
 */
export async function loadComparison(options: ComparisonLoadOptions = {}): Promise<Comparison> {
  checkOptionNames(options, 'loadComparison', ['wasm', 'library'])
  const { library, wasm } = options
  checkLoadOptions({ wasm }, 'loadComparison')
  if (library !== undefined && !(isRecord(library) && typeof library.compute === 'function')) {
    refuseOption(`The option library is what loadCircleVoronoi loads, not ${shown(library)}.`)
  }
  return comparisonOf(library ?? loadCircleVoronoi(), wasm)
}
