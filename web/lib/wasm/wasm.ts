// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError, type ErrorCode, reasonOf } from '../base/errors.ts'

/**
 * `WebAssembly.Module`, if the DOM types are available (the types of Node lack it).
 *
 * @category Loading
 */
export type CompiledWasm = typeof globalThis extends { WebAssembly: { Module: { prototype: infer Module } } }
  ? Module
  : never

/**
 * The source of a WebAssembly module: its URL (pages resolve relative URLs against themselves; Node accepts `file:` and
 * `https:`), the `Response` of a `fetch`, the bytes, or the compiled module.
 *
 * @category Loading
 */
export type WasmSource = string | URL | Response | ArrayBuffer | ArrayBufferView | CompiledWasm

/** The error that a function of the core returns in place of its result. */
export interface WasmError {
  /** `circle`: -1 if there is none. `weights`: those of a fit that did not converge. */
  readonly error: {
    readonly code: string
    readonly circle: number
    readonly message: string
    readonly weights?: Float64Array
  }
}

/** The callbacks by which Emscripten's modules find the WebAssembly. */
export interface EmscriptenOptions {
  instantiateWasm(imports: object, receive: (instance: object) => void): object
  /**
   * Returns the address of a file. Without it they resolve its name against their own address, which some modules do
   * not have.
   */
  locateFile(name: string): string
}

/**
 * The compiled module. `beside`: where it is by default; it may throw, in a module without an address.
 *
 * @throws CircleVoronoiError `notLoaded`
 */
export async function compileWasm(
  source: WasmSource | Promise<WasmSource> | undefined,
  beside: () => WasmSource,
): Promise<CompiledWasm> {
  let place = source === undefined ? 'beside this module, which has no address (give it as { wasm })' : 'what was given'
  try {
    const given = await (source ?? beside())
    if (given instanceof WebAssembly.Module) return given
    if (typeof given === 'string' || given instanceof URL) {
      const url = new URL(given, globalThis.document?.baseURI ?? globalThis.location?.href)
      place = url.href
      return await compileFrom(url)
    }
    if ('arrayBuffer' in given) return await compileResponse(given)
    return await WebAssembly.compile(given as BufferSource)
  } catch (cause) {
    throw notLoaded(`from ${place}`, cause)
  }
}

/**
 * An instance of a module of Emscripten, with a memory of its own.
 *
 * @throws CircleVoronoiError `notLoaded`: it is another module, or there is no memory for it.
 */
export function instantiate<Exports>(
  create: (options: EmscriptenOptions) => Promise<Exports>,
  module: CompiledWasm,
): Promise<Exports> {
  return new Promise((resolve, reject) => {
    const fail = (cause: unknown) => reject(notLoaded('from this module', cause))
    const instantiateWasm: EmscriptenOptions['instantiateWasm'] = (imports, receive) => {
      WebAssembly.instantiate(module, imports as WebAssembly.Imports)
        .then(receive)
        .catch(fail)
      return {}
    }
    try {
      create({ instantiateWasm, locateFile: (name) => name }).then(resolve, fail)
    } catch (cause) {
      fail(cause)
    }
  })
}

/** A result of a module, or its error thrown. */
export function unwrap<Value extends object>(result: Value | WasmError): Value {
  if (!('error' in result)) return result
  const { code, circle, message, weights } = result.error
  throw new CircleVoronoiError(code as ErrorCode, message, { circle: circle < 0 ? undefined : circle, weights })
}

async function compileFrom(url: URL): Promise<CompiledWasm> {
  if (url.protocol === 'file:') {
    // Node's fetch does not read files. Not an import, so that no bundler looks for node:fs in a page.
    const files = globalThis.process?.getBuiltinModule?.('node:fs/promises')
    if (files !== undefined) return WebAssembly.compile(await files.readFile(url))
  }
  return compileResponse(await fetch(url))
}

async function compileResponse(response: Response): Promise<CompiledWasm> {
  if (!response.ok) throw new Error(`the answer is ${response.status} ${response.statusText}`.trim())
  // Servers that do not know .wasm send another type, which the streaming compiler refuses.
  const isTyped = response.headers.get('Content-Type')?.startsWith('application/wasm') ?? false
  return isTyped ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer())
}

function notLoaded(place: string, cause: unknown): CircleVoronoiError {
  const message = `The WebAssembly cannot be loaded ${place}: ${reasonOf(cause)}.`
  return new CircleVoronoiError('notLoaded', message, { cause })
}
