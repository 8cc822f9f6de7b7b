// SPDX-License-Identifier: GPL-3.0-or-later
// The messages between a worker's client and its thread. The client sends `Start` once, then one `Request` at a time.
// The thread answers with any number of `progress`, `step` or `divided` replies and one final reply. A thread that edits gets one
// `EditorCalls` at a time and answers with `results`.

import type { PostedError } from '../base/errors.ts'
import type { DiagramData, Float64s, Metric } from '../base/types.ts'
import type { Lattice } from '../diagram/lattice.ts'
import type { PeriodicData } from '../diagram/periodic-diagram.ts'
import type { RingArrays } from '../regions/region-shape.ts'
import type { AreaFit, FitInput, FitStep, PeriodicAreaFit } from '../wasm/fit.ts'
import type { Options, Stage } from '../wasm/options.ts'
import type { SphereInput } from '../wasm/sphere.ts'
import type { SphereData } from '../wasm/sphere-diagram.ts'
import type { TreemapArrays, TreemapInput } from '../wasm/treemap.ts'
import type { CompiledWasm } from '../wasm/wasm.ts'

export interface Start {
  readonly module: CompiledWasm
}

/** The computation to run, and whether to report its progress or its steps. */
export type Request = ComputeRequest | FitRequest | TreemapRequest | SphereRequest

export interface ComputeRequest {
  readonly circles: Float64s
  /** The periods of the circles, if they repeat. */
  readonly lattice?: Lattice
  /** A metric other than `circles`, and the module that computes its diagrams. */
  readonly metric?: Metric
  readonly wasm?: CompiledWasm
  readonly options: Omit<Options, 'progress'>
  readonly tellsProgress: boolean
}

export interface FitRequest {
  readonly fit: FitInput
  /** The region, if the fit has one instead of a lattice. */
  readonly region: RingArrays | undefined
  /** The module that made the region. */
  readonly wasm: CompiledWasm
  readonly tellsProgress: boolean
}

export interface TreemapRequest {
  readonly tree: TreemapInput
  readonly region: RingArrays
  /** The module that made the region. */
  readonly wasm: CompiledWasm
  readonly tellsProgress: boolean
}

export interface SphereRequest {
  readonly sphere: SphereInput
  readonly wasm: CompiledWasm
}

/** A call of an editor: `edit` creates the editor, the other names are its methods. */
export interface EditorCall {
  readonly method: string
  readonly args: readonly unknown[]
}

export interface EditorCalls {
  readonly calls: readonly EditorCall[]
}

/** The result of a call. */
export type CallResult = { readonly value: unknown } | { readonly error: PostedError }

export type Reply =
  | { readonly progress: readonly [stage: Stage, done: number] }
  | { readonly step: FitStep }
  | { readonly divided: readonly [done: number, count: number] }
  | { readonly diagram: DiagramData }
  | { readonly periodic: PeriodicData }
  | { readonly fit: Omit<AreaFit, 'diagram'> & { readonly diagram: DiagramData } }
  | { readonly periodicFit: Omit<PeriodicAreaFit, 'periodic'> & { readonly periodic: PeriodicData } }
  | { readonly cells: TreemapArrays }
  | { readonly sphere: SphereData }
  | { readonly results: readonly CallResult[] }
  | { readonly error: PostedError }
