// SPDX-License-Identifier: GPL-3.0-or-later
// The WebAssembly files beside this module. Each function throws if modules have no address.
import type { WasmSource } from './wasm.ts'

/** The address of `circle-voronoi.wasm`. */
export function defaultWasm(): WasmSource {
  return new URL('../generated/circle-voronoi.wasm', import.meta.url)
}

/** The address of `circle-voronoi-metrics.wasm`. */
export function defaultMetricsWasm(): WasmSource {
  return new URL('../generated/circle-voronoi-metrics.wasm', import.meta.url)
}

/** The address of `circle-voronoi-sphere.wasm`. */
export function defaultSphereWasm(): WasmSource {
  return new URL('../generated/circle-voronoi-sphere.wasm', import.meta.url)
}

/** The address of `circle-voronoi-regions.wasm`. */
export function defaultRegionsWasm(): WasmSource {
  return new URL('../generated/circle-voronoi-regions.wasm', import.meta.url)
}
