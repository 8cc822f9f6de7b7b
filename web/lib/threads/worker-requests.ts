// SPDX-License-Identifier: GPL-3.0-or-later
// The requests of `createWorker` and of its editors to their threads.

import type { DiagramData, Float64s, Metric, SnapshotData } from '../base/types.ts'
import type { Lattice } from '../diagram/lattice.ts'
import type { PeriodicData } from '../diagram/periodic-diagram.ts'
import type { RingArrays } from '../regions/region-shape.ts'
import type { DiagramEditor, EditorOptions } from '../wasm/editor.ts'
import type { AreaFit, FitInput, FitStep, PeriodicAreaFit } from '../wasm/fit.ts'
import type { Options, Stage } from '../wasm/options.ts'
import type { SphereInput } from '../wasm/sphere.ts'
import type { SphereData } from '../wasm/sphere-diagram.ts'
import type { TreemapArrays, TreemapInput } from '../wasm/treemap.ts'
import type { CompiledWasm } from '../wasm/wasm.ts'
import type { WithProgress } from './channel.ts'

/** The requests of a worker. `start` is the first one; its thread has one other request at a time. */
export interface WorkerRequests {
  start(module: CompiledWasm): void
  readonly compute: WithProgress<(circles: Float64s, how: HowComputed) => DiagramData, ComputeProgress>
  readonly computePeriodic: WithProgress<
    (circles: Float64s, lattice: Lattice, how: HowComputed) => PeriodicData,
    ComputeProgress
  >
  /** `wasm` is the module for spheres. */
  computeSphere(sphere: SphereInput, wasm: CompiledWasm): SphereData
  /** `wasm` is the module that made the region. A fit without a region has a lattice. */
  readonly fitAreas: WithProgress<
    (fit: FitInput, region: RingArrays | undefined, wasm: CompiledWasm) => PostedFit,
    FitStep
  >
  /** `wasm` is the module that made the region. */
  readonly treemap: WithProgress<
    (tree: TreemapInput, region: RingArrays, wasm: CompiledWasm) => TreemapArrays,
    readonly [done: number, count: number]
  >
}

export type ComputeProgress = readonly [stage: Stage, done: number]

export interface HowComputed {
  readonly options: Omit<Options, 'progress'>
  /** A metric other than `circles`, and the module that computes its diagrams. */
  readonly metric?: Metric
  readonly wasm?: CompiledWasm
}

export type PostedFit =
  | (Omit<AreaFit, 'diagram'> & { readonly diagram: DiagramData })
  | (Omit<PeriodicAreaFit, 'periodic'> & { readonly periodic: PeriodicData })

/** The requests of an editor. `start` and `edit`, which creates the editor, are the first ones. */
export interface EditorRequests extends Pick<WorkerRequests, 'start'>, Pick<DiagramEditor, EditorMethod> {
  edit(circles: Float64s | DiagramData, options: EditorOptions): void
  snapshot(): SnapshotData
}

export const EDITOR_METHODS = [
  'insert',
  'remove',
  'replace',
  'apply',
  'nearest',
  'size',
  'circle',
  'isHidden',
  'ids',
  'certificate',
] as const satisfies readonly (keyof DiagramEditor)[]

export type EditorMethod = (typeof EDITOR_METHODS)[number]
