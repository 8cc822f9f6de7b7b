// SPDX-License-Identifier: GPL-3.0-or-later
// The threads of the page, run in the thread of a test. Each start evaluates the program anew.
import { buildSync } from 'esbuild'
import { Bitmap, Canvas, Path } from './page-canvas.ts'

type Program = (...globals: unknown[]) => void
const programs = new Map<string, Program>()

/** Builds the program of a thread. Its globals are parameters, so that each start has its own. */
function programOf(url: URL): Program {
  // Vite's addresses begin at the folder of the project. Built files have other names.
  const file = `.${url.pathname}`.replace(/\.js$/, '.ts')
  const known = programs.get(file)
  if (known !== undefined) return known
  const [bundle] = buildSync({
    entryPoints: [file],
    bundle: true,
    write: false,
    logLevel: 'error',
    // The folder of the tests has no list of modules without side effects.
    ignoreAnnotations: true,
    format: 'iife',
    target: 'esnext',
    define: { globalThis: 'thread', 'import.meta.url': 'address' },
  }).outputFiles
  const names = ['thread', 'address', 'document', 'location', 'OffscreenCanvas', 'Path2D']
  const program = new Function(...names, bundle?.text ?? '') as Program
  programs.set(file, program)
  return program
}

type Listener = (event: { readonly data: unknown }) => void

/** A `Worker` in the thread of the test. Messages are copied and arrive in later turns, as in a browser. */
export class ThreadHere {
  static readonly running = new Set<ThreadHere>()
  static #underWay = 0
  onmessage: Listener | undefined
  onerror: ((event: { readonly message: string }) => void) | undefined
  readonly name: string
  readonly #thread: { onmessage?: Listener }
  #isEnded = false

  constructor(url: URL) {
    this.name = url.pathname.split('/').at(-1) as string
    // Own properties, because the window of the page has a setter of this name.
    this.#thread = Object.create(globalThis, {
      // Threads of a browser know no process.
      process: { value: undefined },
      onmessage: { writable: true, value: undefined },
      postMessage: { value: (data: unknown) => this.#deliver(data, this) },
    })
    programOf(url)(this.#thread, url.href, undefined, undefined, Canvas, Path)
    ThreadHere.running.add(this)
  }

  postMessage(data: unknown): void {
    this.#deliver(data, this.#thread)
  }

  terminate(): void {
    this.#isEnded = true
    ThreadHere.running.delete(this)
  }

  /** Whether a message is under way. */
  static get isBusy(): boolean {
    return ThreadHere.#underWay > 0
  }

  static endAll(): void {
    for (const thread of ThreadHere.running) thread.terminate()
  }

  #deliver(data: unknown, to: { onmessage?: Listener | undefined }): void {
    const copy = copyOf(data)
    ThreadHere.#underWay += 1
    setImmediate(() => {
      ThreadHere.#underWay -= 1
      if (!this.#isEnded) to.onmessage?.({ data: copy })
    })
  }
}

/** Copies a message as `postMessage` does. Bitmaps and compiled modules are handed over. */
function copyOf(value: unknown): unknown {
  if (typeof value === 'function' || typeof value === 'symbol') throw new DOMException('no copy', 'DataCloneError')
  if (typeof value !== 'object' || value === null || value instanceof Bitmap) return value
  if (value instanceof WebAssembly.Module) return value
  if (Array.isArray(value)) return value.map(copyOf)
  if (value instanceof Map) return new Map([...value].map(([key, one]) => [copyOf(key), copyOf(one)]))
  if (Object.getPrototypeOf(value) !== Object.prototype) return structuredClone(value)
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, copyOf(one)]))
}
