// SPDX-License-Identifier: GPL-3.0-or-later
// The addresses of the files that threads load.
import { defaultComparisonWasm, defaultRegionsWasm } from './default-wasm.ts'

/**
 * The address of `circle-voronoi-comparison.wasm`; `undefined` if this module has no address, or the thread contains
 * the bytes.
 */
export function comparisonAddress(): URL | undefined {
  return addressOf(defaultComparisonWasm)
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
