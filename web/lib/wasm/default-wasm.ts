// SPDX-License-Identifier: GPL-3.0-or-later
import type { WasmSource } from './wasm.ts'

/** `circle-voronoi.wasm` beside this module. Throws where modules have no address. */
export function defaultWasm(): WasmSource {
  return new URL('../generated/circle-voronoi.wasm', import.meta.url)
}
