// SPDX-License-Identifier: GPL-3.0-or-later
// What goes between a worker's client and its thread: `Start` once, then one `Request` at a time, each followed by any
// number of `progress` and one other reply.
import type { DiagramData, Float64s } from './diagram-data.ts'
import type { ErrorCode } from './errors.ts'
import type { Options, Stage } from './options.ts'
import type { CompiledWasm } from './wasm.ts'

export interface Start {
  readonly module: CompiledWasm
}

export interface Request {
  readonly circles: Float64s
  readonly options: Omit<Options, 'progress'>
  readonly tellsProgress: boolean
}

export type Reply =
  | { readonly progress: readonly [stage: Stage, done: number] }
  | { readonly diagram: DiagramData }
  | { readonly error: { readonly code: ErrorCode; readonly circle: number; readonly message: string } }
