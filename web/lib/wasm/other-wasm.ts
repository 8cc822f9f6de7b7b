// SPDX-License-Identifier: GPL-3.0-or-later
// The addresses of the files that threads load.
import { defaultMetricsWasm, defaultRegionsWasm } from './default-wasm.ts'

/**
 * The address of `circle-voronoi-metrics.wasm`; `undefined` if this module has no address, or the thread contains
 * the bytes.
 */
export function metricsAddress(): URL | undefined {
  return addressOf(defaultMetricsWasm)
}

/** The address of `circle-voronoi-regions.wasm`. */
export function regionsAddress(): URL | undefined {
  return addressOf(defaultRegionsWasm)
}

function addressOf(beside: () => unknown): URL | undefined {
  try {
    return beside() as URL
  } catch {
    return undefined
  }
}
