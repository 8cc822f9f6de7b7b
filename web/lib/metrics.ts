// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Diagrams by any metric: power (Laguerre) diagrams, and the ordinary Voronoi diagrams of the centers.
 *
 * @module circle-voronoi/metrics
 */
import { checkOptionNames, isRecord, refuseOption, shown } from './base/check.ts'
import createModule from './generated/circle-voronoi-metrics.js'
import { defaultMetricsWasm } from './wasm/default-wasm.ts'
import type { CircleVoronoi } from './wasm/library.ts'
import { checkLoadOptions, type LoadOptions } from './wasm/load-options.ts'
import { loadCircleVoronoi } from './wasm/loader.ts'
import { type Metrics, metricsOf } from './wasm/metrics.ts'
import { compileWasm } from './wasm/wasm.ts'

export type { MetricOptions, Metrics } from './wasm/metrics.ts'

/**
 * Options of `loadMetrics`.
 *
 * @category Metrics
 */
export interface MetricsLoadOptions {
  /** The source of `circle-voronoi-metrics.wasm`. Default: the file next to this module. */
  readonly wasm?: LoadOptions['wasm']
  /** A library that is loaded already. Default: another one is loaded. */
  readonly library?: CircleVoronoi | undefined
}

/**
 * Loads the WebAssembly of other metrics.
 *
 * @throws CircleVoronoiError `notLoaded`, `badOption`. Each as a rejection.
 *
 * @category Metrics
 * @example
 * const { compute } = await loadMetrics()
 * compute([[0, 0, 3], [10, 0, 1]], { metric: 'power' }).find(5.2, 0) // 0
 * compute([[0, 0, -4], [10, 0, 20]], { metric: 'power', weights: true }).find(3.9, 0) // 1
 */
export async function loadMetrics(options: MetricsLoadOptions = {}): Promise<Metrics> {
  checkOptionNames(options, 'loadMetrics', ['wasm', 'library'])
  const { library, wasm } = options
  checkLoadOptions({ wasm }, 'loadMetrics')
  if (library !== undefined && !(isRecord(library) && typeof library.compute === 'function')) {
    refuseOption(`The option library is what loadCircleVoronoi loads, not ${shown(library)}.`)
  }
  const core = library ?? loadCircleVoronoi()
  return metricsOf(createModule, compileWasm(wasm, defaultMetricsWasm), core)
}
