// SPDX-License-Identifier: GPL-3.0-or-later
// What goes between a worker's client and its thread: `Start` once, then one `Request` at a time, each followed by any
// number of `progress` and one other reply; or, to a thread that edits, one `EditorCalls` at a time, followed by `results`.

import type { PostedError } from '../base/errors.ts'
import type { DiagramData, Float64s } from '../base/types.ts'
import type { Options, Stage } from '../wasm/options.ts'
import type { CompiledWasm } from '../wasm/wasm.ts'

export interface Start {
  readonly module: CompiledWasm
}

export interface Request {
  readonly circles: Float64s
  readonly options: Omit<Options, 'progress'>
  readonly tellsProgress: boolean
}

/** What is asked of an editor: `edit` makes it, the others are its methods. */
export interface EditorCall {
  readonly method: string
  readonly args: readonly unknown[]
}

export interface EditorCalls {
  readonly calls: readonly EditorCall[]
}

/** What came of a call. */
export type CallResult = { readonly value: unknown } | { readonly error: PostedError }

export type Reply =
  | { readonly progress: readonly [stage: Stage, done: number] }
  | { readonly diagram: DiagramData }
  | { readonly results: readonly CallResult[] }
  | { readonly error: PostedError }
