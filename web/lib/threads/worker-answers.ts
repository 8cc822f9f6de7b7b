// SPDX-License-Identifier: GPL-3.0-or-later

import { loadedOnce } from '../base/loaded-once.ts'
import { nodeModule } from '../base/node.ts'
import createMetricsModule from '../generated/circle-voronoi-metrics.js'
import createRegionsModule from '../generated/circle-voronoi-regions.js'
import createSphereModule from '../generated/circle-voronoi-sphere.js'
import type { DiagramEditor } from '../wasm/editor.ts'
import { type CircleVoronoi, circleVoronoiOf } from '../wasm/library.ts'
import { metricsOf } from '../wasm/metrics.ts'
import { regionsOf } from '../wasm/regions.ts'
import { spheresOf } from '../wasm/sphere.ts'
import type { CompiledWasm } from '../wasm/wasm.ts'
import { type Answers, answerRequests, type Port, transferring } from './answer-requests.ts'
import {
  type ComputeProgress,
  EDITOR_METHODS,
  type EditorMethod,
  type EditorRequests,
  type HowComputed,
  type WorkerRequests,
} from './worker-requests.ts'

/** Answers the requests of `createWorker` and of its editors, in the calling thread. */
export function answerWorker(): void {
  let library: Promise<CircleVoronoi>
  let editor: DiagramEditor
  const regionsIn = loadedOnce((wasm: CompiledWasm) => regionsOf(createRegionsModule, wasm))
  const metricsIn = loadedOnce((wasm: CompiledWasm) => metricsOf(createMetricsModule, wasm, library))
  const onSphere = loadedOnce((wasm: CompiledWasm) => spheresOf(createSphereModule, wasm))
  const modules = async ({ wasm }: HowComputed) => (wasm === undefined ? library : metricsIn(wasm))

  const callsOf = (method: EditorMethod) => async (args: readonly unknown[]) => {
    await library
    return (editor[method] as (...args: readonly unknown[]) => unknown)(...args)
  }
  const calls = Object.fromEntries(EDITOR_METHODS.map((method) => [method, callsOf(method)]))

  const answers: Answers<WorkerRequests & EditorRequests> = {
    start: ([module]) => {
      library = circleVoronoiOf(module)
      // Each request awaits the library and reports its failure, so the failure is not unhandled.
      library.catch(() => {})
    },
    compute: async ([circles, how], { tell }) => {
      const { compute } = await modules(how)
      return withMemory(compute(circles, optionsOf(how, tell)))
    },
    computePeriodic: async ([circles, lattice, how], { tell }) => {
      const { computePeriodic } = await modules(how)
      return withMemory(computePeriodic(circles, lattice, optionsOf(how, tell)))
    },
    computeSphere: async ([sphere, wasm]) => withMemory((await onSphere(wasm)).computed(sphere)),
    fitAreas: async ([{ sites, areas, lattice, ...options }, rings, wasm], { tell }) => {
      const { regionOf, fitAreas } = await regionsIn(wasm)
      if (rings !== undefined) {
        return withMemory(fitAreas(sites, areas, { ...options, region: regionOf(rings), onStep: tell }))
      }
      const [ax, ay, bx, by] = lattice as unknown as [number, number, number, number]
      return withMemory(fitAreas(sites, areas, { ...options, lattice: { a: [ax, ay], b: [bx, by] }, onStep: tell }))
    },
    treemap: async ([tree, rings, wasm], { tell }) => {
      const { regionOf, cellsOfTree } = await regionsIn(wasm)
      const progress = tell && ((done: number, count: number) => tell([done, count]))
      return withMemory(cellsOfTree(regionOf(rings), tree, progress))
    },
    edit: async ([circles, options]) => {
      editor = (await library).edit(circles, options)
    },
    snapshot: async () => {
      await library
      return withMemory(editor.snapshot())
    },
    ...(calls as unknown as Pick<Answers<EditorRequests>, EditorMethod>),
  }
  const nodePort = nodeModule('node:worker_threads')?.parentPort
  answerRequests(answers, (nodePort ?? globalThis) as unknown as Port)
}

function optionsOf({ options, metric }: HowComputed, tell: ((progress: ComputeProgress) => void) | undefined) {
  return {
    ...options,
    ...(metric !== undefined && { metric }),
    ...(tell && { progress: (...progress: ComputeProgress) => tell(progress) }),
  }
}

/** Transfers the memory of all arrays of a result and its diagram. The few numbers of a snapshot are copied. */
function withMemory<Result extends object>(result: Result): Result {
  return transferring(result, buffersIn(result))
}

function buffersIn(result: object): Transferable[] {
  return Object.entries(result).flatMap(([name, value]) => {
    if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer]
    return name === 'diagram' || name === 'periodic' ? buffersIn(value) : []
  })
}
