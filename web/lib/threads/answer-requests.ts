// SPDX-License-Identifier: GPL-3.0-or-later

import { CircleVoronoiError, type PostedError, postedError, reasonOf } from '../base/errors.ts'
import { loadedOnce } from '../base/loaded-once.ts'
import { Diagram } from '../diagram/diagram.ts'
import createMetricsModule from '../generated/circle-voronoi-metrics.js'
import createRegionsModule from '../generated/circle-voronoi-regions.js'
import createSphereModule from '../generated/circle-voronoi-sphere.js'
import type { DiagramEditor } from '../wasm/editor.ts'
import type { FitStep } from '../wasm/fit.ts'
import { type CircleVoronoi, circleVoronoiOf } from '../wasm/library.ts'
import { metricsOf } from '../wasm/metrics.ts'
import type { Progress } from '../wasm/options.ts'
import { type RegionsOfModule, regionsOf } from '../wasm/regions.ts'
import { spheresOf } from '../wasm/sphere.ts'
import type { CompiledWasm } from '../wasm/wasm.ts'
import type {
  CallResult,
  ComputeRequest,
  EditorCall,
  EditorCalls,
  FitRequest,
  Reply,
  Request,
  Start,
  TreemapRequest,
} from './worker-messages.ts'

/** The common interface of Node's parent port and the global scope of a browser's worker. */
interface Port {
  onmessage: ((event: { readonly data: Start | Request | EditorCalls }) => void) | null
  postMessage(reply: Reply, transfer?: ArrayBuffer[]): void
}

/** Answers the requests of the client in `worker.ts`, in the calling thread. */
export function answerRequests(): void {
  const nodePort = globalThis.process?.getBuiltinModule?.('node:worker_threads').parentPort
  const port = (nodePort ?? globalThis) as unknown as Port
  let library: Promise<CircleVoronoi> | undefined
  const answerCalls = editing()
  const regionsIn = loadedOnce((wasm: CompiledWasm) => regionsOf(createRegionsModule, wasm))
  const computed = computing()
  const onSphere = loadedOnce((wasm: CompiledWasm) => spheresOf(createSphereModule, wasm))

  port.onmessage = async ({ data }) => {
    if ('module' in data) {
      library = circleVoronoiOf(data.module)
      // Each request awaits the library and reports its failure, so the failure is not unhandled.
      library.catch(() => {})
      return
    }
    if ('calls' in data) {
      const results = await answerCalls(data.calls, library as Promise<CircleVoronoi>)
      const snapshots = results.flatMap((result) =>
        'value' in result && result.value instanceof Diagram ? [result.value] : [],
      )
      port.postMessage({ results }, snapshots.flatMap(buffersOf))
      return
    }
    const tell = (told: Reply) => port.postMessage(told)
    const answer = async (): Promise<Reply> => {
      if ('fit' in data) return fitted(data, await regionsIn(data.wasm), tell)
      if ('tree' in data) return divided(data, await regionsIn(data.wasm), tell)
      if ('sphere' in data) return { sphere: (await onSphere(data.wasm)).computed(data.sphere) }
      return computed(data, library as Promise<CircleVoronoi>, tell)
    }
    const reply = await answer().catch((error: unknown): Reply => ({ error: posted(error) }))
    port.postMessage(reply, buffersIn(reply))
  }
}

type Tell = (told: Reply) => void

/** Returns a function that answers computations. The first one with another metric loads the module. */
function computing(): (request: ComputeRequest, library: Promise<CircleVoronoi>, tell: Tell) => Promise<Reply> {
  const metricsIn = loadedOnce((wasm: CompiledWasm, library: Promise<CircleVoronoi>) =>
    metricsOf(createMetricsModule, wasm, library),
  )
  return async ({ circles, lattice, metric, wasm, options, tellsProgress }, library, tell) => {
    const progress: Progress = (...told) => tell({ progress: told })
    const all = tellsProgress ? { ...options, progress } : options
    const { compute, computePeriodic } = wasm === undefined ? await library : await metricsIn(wasm, library)
    const chosen = metric === undefined ? all : { ...all, metric }
    return lattice === undefined
      ? { diagram: compute(circles, chosen) }
      : { periodic: computePeriodic(circles, lattice, chosen) }
  }
}

function fitted(
  { fit, region: rings, tellsProgress }: FitRequest,
  { regionOf, fitAreas }: RegionsOfModule,
  tell: Tell,
): Reply {
  const { sites, areas, lattice, ...options } = fit
  const onStep = tellsProgress ? (step: FitStep) => tell({ step }) : undefined
  if (rings !== undefined) return { fit: fitAreas(sites, areas, { ...options, region: regionOf(rings), onStep }) }
  const [ax, ay, bx, by] = lattice as unknown as [number, number, number, number]
  const periods = { a: [ax, ay], b: [bx, by] } as const
  return { periodicFit: fitAreas(sites, areas, { ...options, lattice: periods, onStep }) }
}

function divided(
  { tree, region, tellsProgress }: TreemapRequest,
  { regionOf, cellsOfTree }: RegionsOfModule,
  tell: Tell,
): Reply {
  const progress = tellsProgress ? (...all: [number, number]) => tell({ divided: all }) : undefined
  return { cells: cellsOfTree(regionOf(region), tree, progress) }
}

/** Returns a function that answers the calls of an editor. The first call creates the editor. */
function editing(): (calls: readonly EditorCall[], library: Promise<CircleVoronoi>) => Promise<CallResult[]> {
  let editor: DiagramEditor | undefined
  return (calls, library) =>
    Promise.all(
      calls.map(async ({ method, args }) => {
        try {
          const { edit } = await library
          if (method === 'edit') {
            editor = edit(...(args as Parameters<CircleVoronoi['edit']>))
            return { value: undefined }
          }
          const methods = editor as unknown as Record<string, (...args: readonly unknown[]) => unknown>
          return { value: methods[method]?.(...args) }
        } catch (error) {
          return { error: posted(error) }
        }
      }),
    )
}

function posted(error: unknown): PostedError {
  if (error instanceof CircleVoronoiError) return postedError(error)
  return { code: 'internal', circle: undefined, message: `The computation failed: ${reasonOf(error)}.` }
}

function buffersIn(reply: Reply): ArrayBuffer[] {
  if ('diagram' in reply) return buffersOf(reply.diagram)
  if ('sphere' in reply) return buffersOf(reply.sphere)
  if ('cells' in reply) return buffersOf(reply.cells)
  if ('periodic' in reply) return [...buffersOf(reply.periodic), ...buffersOf(reply.periodic.diagram)]
  if ('periodicFit' in reply) {
    const { periodic, ...fit } = reply.periodicFit
    return [...buffersOf(fit), ...buffersOf(periodic), ...buffersOf(periodic.diagram)]
  }
  // The diagram of a fit has its own arrays.
  return 'fit' in reply ? [...buffersOf(reply.fit), ...buffersOf(reply.fit.diagram)] : []
}

/** Returns the memory of all arrays of a result, which is transferred instead of copied. */
function buffersOf(result: object): ArrayBuffer[] {
  return Object.values(result).flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : []))
}
