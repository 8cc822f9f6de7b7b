// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../wasm/default-wasm.ts in the thread of the element's one-file build. The page gives the thread the core.
import metrics from '../../generated/circle-voronoi-metrics.wasm'
import regions from '../../generated/circle-voronoi-regions.wasm'
import { unpacked } from './unpacked.ts'

export function defaultWasm(): never {
  throw new Error('The page gives the core.')
}

export function defaultMetricsWasm(): Response {
  return unpacked(metrics)
}

export function defaultRegionsWasm(): Response {
  return unpacked(regions)
}
