// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError, type ErrorCode, reasonOf } from '../base/errors.ts'
import { nodeModule } from '../base/node.ts'

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
  /** `circle` is -1 if the error blames no circle. `weights` are the last weights of a fit that did not converge. */
  readonly error: {
    readonly code: string
    readonly circle: number
    readonly message: string
    readonly weights?: Float64Array
  }
}

/** The callbacks that tell Emscripten's modules where the WebAssembly is. */
export interface EmscriptenOptions {
  instantiateWasm(imports: object, receive: (instance: object) => void): object
  /**
   * Returns the address of a file. Without this callback, modules resolve the name against their own address, which
   * some modules lack.
   */
  locateFile(name: string): string
}

/**
 * Compiles a module. `beside` returns its default source, or throws in a module without an address.
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
 * Creates an instance of an Emscripten module with its own memory.
 *
 * @throws CircleVoronoiError `notLoaded`, if it is another module or memory is exhausted
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

/** Returns the result of a module, or throws its error. */
export function unwrap<Value extends object>(result: Value | WasmError): Value {
  if (!('error' in result)) return result
  const { code, circle, message, weights } = result.error
  throw new CircleVoronoiError(code as ErrorCode, message, { circle: circle < 0 ? undefined : circle, weights })
}

async function compileFrom(url: URL): Promise<CompiledWasm> {
  if (url.protocol === 'file:') {
    // Node's fetch does not read files.
    const files = nodeModule('node:fs/promises')
    if (files !== undefined) return WebAssembly.compile(await files.readFile(url))
  }
  return compileResponse(await fetch(url))
}

async function compileResponse(response: Response): Promise<CompiledWasm> {
  if (!response.ok) throw new Error(`the answer is ${response.status} ${response.statusText}`.trim())
  // Servers that do not know .wasm send a wrong type, which the streaming compiler refuses, as it does parameters.
  const isTyped = response.headers.get('Content-Type') === 'application/wasm'
  return isTyped ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer())
}

function notLoaded(place: string, cause: unknown): CircleVoronoiError {
  const message = `The WebAssembly cannot be loaded ${place}: ${reasonOf(cause)}.`
  return new CircleVoronoiError('notLoaded', message, { cause })
}
