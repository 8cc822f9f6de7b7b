// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../wasm/default-wasm.ts in the library's bundle: the bytes of what computes are in the file, and few programs need
// the other modules, which are fetched.
import compressed from '../../generated/circle-voronoi.wasm'
import { unpacked } from './unpacked.ts'

export function defaultWasm(): Response {
  return unpacked(compressed)
}

export function defaultComparisonWasm(): URL {
  return new URL('../lib/generated/circle-voronoi-comparison.wasm', import.meta.url)
}

export function defaultRegionsWasm(): URL {
  return new URL('../lib/generated/circle-voronoi-regions.wasm', import.meta.url)
}
