// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../wasm/default-wasm.ts in the element's one-file builds. The file contains all modules, so it works
// alone and from a disk, where nothing can be fetched.

import core from '../../generated/circle-voronoi.wasm'
import metrics from '../../generated/circle-voronoi-metrics.wasm'
import regions from '../../generated/circle-voronoi-regions.wasm'
import { unpacked } from './unpacked.ts'

export function defaultWasm(): Response {
  return unpacked(core)
}

export function defaultMetricsWasm(): Response {
  return unpacked(metrics)
}

export function defaultRegionsWasm(): Response {
  return unpacked(regions)
}
