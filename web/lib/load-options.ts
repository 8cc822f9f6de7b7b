// SPDX-License-Identifier: GPL-3.0-or-later
import { type CompiledWasm, compileWasm, type WasmSource } from './wasm.ts'

/** How the WebAssembly is found. */
export interface LoadOptions {
  /** `circle-voronoi.wasm`. Default: the file beside this module; Node reads it from the disk. */
  readonly wasm?: WasmSource | Promise<WasmSource>
}

/** `circle-voronoi.wasm`, compiled. */
export function compileCircleVoronoi({ wasm }: LoadOptions): Promise<CompiledWasm> {
  return compileWasm(wasm ?? new URL('./generated/circle-voronoi.wasm', import.meta.url))
}
