// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of Node that the library uses. The types of Node are not used, because browsers run the same code.

interface NodeModules {
  'node:fs/promises': { readFile(file: URL): Promise<Uint8Array<ArrayBuffer>> }
  'node:worker_threads': {
    readonly parentPort: object | null
    readonly workerData: unknown
    readonly Worker: new (file: URL | string, options: NodeWorkerOptions) => NodeWorker
  }
}

interface NodeWorkerOptions {
  readonly eval: boolean
  readonly execArgv: readonly string[]
  readonly workerData: string
}

/** A worker thread of Node. */
interface NodeWorker {
  on(event: 'message' | 'error', listener: (value: never) => void): void
  postMessage(message: unknown, transfer: readonly Transferable[]): void
  ref(): void
  unref(): void
  terminate(): Promise<number>
}

/** Returns a module of Node, or undefined elsewhere. For an import, bundlers would look for the module in a page. */
export function nodeModule<Name extends keyof NodeModules>(name: Name): NodeModules[Name] | undefined {
  const { process }: { process?: { getBuiltinModule?(name: string): unknown } } = globalThis as object
  return process?.getBuiltinModule?.(name) as NodeModules[Name] | undefined
}
