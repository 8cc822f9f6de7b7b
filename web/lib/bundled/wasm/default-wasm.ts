// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../wasm/default-wasm.ts in the library's bundle. The file contains the bytes of the core. The other
// modules, which few programs need, are fetched.
import compressed from '../../generated/circle-voronoi.wasm'
import { unpacked } from './unpacked.ts'

export function defaultWasm(): Response {
  return unpacked(compressed)
}

export function defaultMetricsWasm(): URL {
  return new URL('../lib/generated/circle-voronoi-metrics.wasm', import.meta.url)
}

export function defaultSphereWasm(): URL {
  return new URL('../lib/generated/circle-voronoi-sphere.wasm', import.meta.url)
}

export function defaultRegionsWasm(): URL {
  return new URL('../lib/generated/circle-voronoi-regions.wasm', import.meta.url)
}
