// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../wasm/default-wasm.ts in the element's one-file builds. The file contains all modules, so it works
// alone and from a disk, where nothing can be fetched.

import core from '../../generated/circle-voronoi.wasm'
import comparison from '../../generated/circle-voronoi-comparison.wasm'
import regions from '../../generated/circle-voronoi-regions.wasm'
import { unpacked } from './unpacked.ts'

export function defaultWasm(): Response {
  return unpacked(core)
}

export function defaultComparisonWasm(): Response {
  return unpacked(comparison)
}

export function defaultRegionsWasm(): Response {
  return unpacked(regions)
}
