// SPDX-License-Identifier: GPL-3.0-or-later

import type { LoadOptions } from '../lib/wasm/load-options.ts'
import { metricsAddress, regionsAddress } from '../lib/wasm/other-wasm.ts'
import type { WasmSource } from '../lib/wasm/wasm.ts'

/**
 * Options for loading a figure. By default each file is the one next to the module.
 *
 * @category Element
 */
export interface FigureLoadOptions extends LoadOptions {
  /** The source of `circle-voronoi-regions.wasm`, which `region` and `areas` need. */
  readonly regionsWasm?: WasmSource | Promise<WasmSource> | undefined
  /** The source of `circle-voronoi-metrics.wasm`, which the layer `power` needs. */
  readonly metricsWasm?: WasmSource | Promise<WasmSource> | undefined
}

/** The modules that few figures need, in a form that can be posted to a thread. */
export interface OtherModules {
  readonly regionsWasm?: Exclude<WasmSource, URL | Response> | undefined
  readonly metricsWasm?: Exclude<WasmSource, URL | Response> | undefined
}

/**
 * Prepares the modules that a thread loads on demand. A thread cannot resolve their addresses itself, because Turbopack
 * starts it from a blob.
 */
export async function otherModules(options: FigureLoadOptions): Promise<OtherModules> {
  const { regionsWasm, metricsWasm } = options
  const [regions, metrics] = await Promise.all([
    sendable(regionsWasm ?? regionsAddress()),
    sendable(metricsWasm ?? metricsAddress()),
  ])
  return {
    ...(regions !== undefined && { regionsWasm: regions }),
    ...(metrics !== undefined && { metricsWasm: metrics }),
  }
}

async function sendable(source: WasmSource | Promise<WasmSource> | undefined): Promise<OtherModules['regionsWasm']> {
  const given = await source
  // Resolves relative to the page, because a thread has another base address. The URLs of Turbopack are relative, too.
  if (typeof given === 'string' || given instanceof URL) return new URL(given, globalThis.document?.baseURI).href
  return given instanceof Response ? given.arrayBuffer() : given
}
