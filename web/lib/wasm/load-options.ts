// SPDX-License-Identifier: GPL-3.0-or-later
import { checkOptionNames, refuseOption, shown } from '../base/check.ts'
import { defaultWasm } from './default-wasm.ts'
import { type CompiledWasm, compileWasm, type WasmSource } from './wasm.ts'

/**
 * Options for loading.
 *
 * @category Loading
 */
export interface LoadOptions {
  /** The source of `circle-voronoi.wasm`. Default: the file next to this module; Node reads it from disk. */
  readonly wasm?: WasmSource | Promise<WasmSource> | undefined
}

/** @throws CircleVoronoiError `badOption` */
export function checkLoadOptions(options: LoadOptions, caller: string): void {
  checkOptionNames(options, caller, ['wasm'])
  const { wasm }: { wasm?: unknown } = options
  if (wasm !== undefined && typeof wasm !== 'string' && (typeof wasm !== 'object' || wasm === null)) {
    refuseOption(`The option wasm is an address, bytes, a Response or a module, not ${shown(wasm)}.`)
  }
}

/** `circle-voronoi.wasm`, compiled. */
export function compileCircleVoronoi({ wasm }: LoadOptions): Promise<CompiledWasm> {
  return compileWasm(wasm, defaultWasm)
}
