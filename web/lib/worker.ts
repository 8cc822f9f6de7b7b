// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Computes and edits diagrams and fits areas in a worker, with progress and cancellation.
 *
 * @module circle-voronoi/worker
 */

import { refuseOption } from './base/check.ts'
import { type Accessors, type Circles, coordinatesOf } from './base/coordinates.ts'
import { workerFailure } from './base/errors.ts'
import { loadedOnce } from './base/loaded-once.ts'
import type { DiagramData, Disposal } from './base/types.ts'
import { Diagram } from './diagram/diagram.ts'
import { withWarning } from './diagram/hidden-warning.ts'
import { type Lattice, latticeNumbers } from './diagram/lattice.ts'
import { PeriodicDiagram } from './diagram/periodic-diagram.ts'
import createSphereModule from './generated/circle-voronoi-sphere.js'
import type { Region } from './regions/region.ts'
import type { RingArrays } from './regions/region-shape.ts'
import { CancelableRequests } from './threads/cancelable-requests.ts'
import { Channel, type ProgressOf, type RequestOptions } from './threads/channel.ts'
import { EditorClient } from './threads/editor-client.ts'
import { startThread } from './threads/thread.ts'
import type { AsyncDiagramEditor } from './threads/worker-editor.ts'
import type { ComputeProgress, HowComputed, WorkerRequests } from './threads/worker-requests.ts'
import { defaultMetricsWasm, defaultRegionsWasm, defaultSphereWasm } from './wasm/default-wasm.ts'
import { type EditorOptions, editorStart } from './wasm/editor.ts'
import {
  type AreaFit,
  checkSignal,
  type FitOptions,
  fitInput,
  type PeriodicAreaFit,
  type PeriodicFitOptions,
  type SiteLike,
} from './wasm/fit.ts'
import { checkLoadOptions, compileCircleVoronoi, type LoadOptions } from './wasm/load-options.ts'
import { checkMetricOptions, type MetricOptions, newestMetricsWasm } from './wasm/metrics.ts'
import type { Options } from './wasm/options.ts'
import { newestWasm, wasmOf } from './wasm/regions.ts'
import {
  type CapAccessors,
  type Caps,
  newestSphereWasm,
  type SphereOptions,
  sphereInput,
  spheresOf,
} from './wasm/sphere.ts'
import type { SphereDiagram } from './wasm/sphere-diagram.ts'
import { type TreemapOptions, type TreeNode, type TreeWithCells, treeOf } from './wasm/treemap.ts'
import { type CompiledWasm, compileWasm } from './wasm/wasm.ts'

export type { AsyncDiagramEditor, AsyncEditorMethods } from './threads/worker-editor.ts'
export type {
  AreaFit,
  Disposal,
  FitOptions,
  LoadOptions,
  Options,
  PeriodicAreaFit,
  PeriodicFitOptions,
  SiteLike,
  TreemapOptions,
  TreeNode,
  TreeWithCells,
}

/**
 * Options of `compute` in a worker.
 *
 * @category Workers
 */
export interface AsyncOptions extends Options {
  /** A signal that cancels the computation at once; the promise is rejected with the reason of the signal. */
  readonly signal?: AbortSignal | undefined
}

/**
 * Options of `compute` in a worker, for any metric.
 *
 * @category Workers
 */
export interface AsyncMetricOptions extends AsyncOptions, MetricOptions {}

/**
 * Options of `computeSphere` in a worker.
 *
 * @category Workers
 */
export interface AsyncSphereOptions extends SphereOptions {
  /** A signal that cancels the computation at once; the promise is rejected with the reason of the signal. */
  readonly signal?: AbortSignal | undefined
}

/**
 * The methods of a worker.
 *
 * @category Workers
 */
export interface WorkerMethods {
  /** Computes a diagram of circles that functions find in data, which are called in this thread. */
  compute<Datum>(data: Iterable<Datum>, options: AsyncMetricOptions & Accessors<Datum>): Promise<Diagram>
  /**
   * Computes a diagram in the worker, with the arguments of `compute` of `Metrics`, without blocking this thread.
   * Arrays are transferred to the worker and back; only the input is copied. An error thrown by `progress` cancels the
   * computation and rejects the promise. For other metrics than `circles`, the worker takes the module that
   * `loadMetrics` of this thread loaded last, or else the file next to this module.
   *
   * @throws CircleVoronoiError with one of the codes of `ErrorCode`; the reason of `signal`; a `DOMException` named
   * AbortError if the worker is disposed of. Each as a rejection.
   */
  compute(circles: Circles, options?: AsyncMetricOptions): Promise<Diagram>
  /** Computes a periodic diagram of circles that functions find in data. */
  computePeriodic<Datum>(
    data: Iterable<Datum>,
    lattice: Lattice,
    options: AsyncMetricOptions & Accessors<Datum>,
  ): Promise<PeriodicDiagram>
  /**
   * Computes a periodic diagram in the worker, with the arguments of `computePeriodic` of `Metrics`.
   *
   * @throws CircleVoronoiError as `computePeriodic`, and what `compute` of the worker throws. Each as a rejection.
   */
  computePeriodic(circles: Circles, lattice: Lattice, options?: AsyncMetricOptions): Promise<PeriodicDiagram>
  /** Computes a diagram on a sphere of circles that functions find in data. */
  computeSphere<Datum>(data: Iterable<Datum>, options: AsyncSphereOptions & CapAccessors<Datum>): Promise<SphereDiagram>
  /**
   * Computes a diagram on a sphere in the worker, with the arguments of `computeSphere` of `Spheres`. Both threads take
   * the module that `loadSphere` of this thread loaded last, or else the file next to this module.
   *
   * @throws CircleVoronoiError as `computeSphere`, and what `compute` of the worker throws. Each as a rejection.
   */
  computeSphere(places: Caps, options?: AsyncSphereOptions): Promise<SphereDiagram>
  /**
   * Creates an editor in a thread of its own, with the arguments of `edit` of the library.
   *
   * @throws CircleVoronoiError as `edit`; a `DOMException` named AbortError if the worker is disposed of. Each as a
   *   rejection.
   *
   * @example
   * ```js
   * const editor = await worker.edit(circles)
   * const diagram = await editor.snapshot()
   * editor.onchange = (change) => diagram.apply(change)
   * canvas.onpointermove = ({ offsetX: x, offsetY: y }) => editor.replace(0, { x, y, r: 5 })
   * ```
   */
  edit(circles: Circles | DiagramData, options?: EditorOptions): Promise<AsyncDiagramEditor>
  /**
   * Fits areas in the worker, with the arguments and the result of `fitAreas` of `Regions`, without blocking this thread.
   * The region is one that `loadRegions` made in this thread. An error thrown by `onStep` cancels the fit and rejects the
   * promise.
   *
   * @throws CircleVoronoiError as `fitAreas`; the reason of `signal`; a `DOMException` named AbortError if the worker is
   * disposed of. Each as a rejection.
   *
   * @example
   * const { region } = await loadRegions()
   * const square = region([[[0, 0], [1, 0], [1, 1], [0, 1]]])
   * const worker = createWorker()
   * const fit = await worker.fitAreas([[0.3, 0.3], [0.7, 0.6]], [3, 1], { region: square, shares: true })
   * fit.areas // Float64Array(2) [ 0.75, 0.25 ]
   * worker.dispose()
   */
  fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: FitOptions,
  ): Promise<AreaFit>
  /**
   * Fits areas in a box whose opposite sides are glued together. The worker takes the module that `loadRegions` of this
   * thread loaded last, or else the file next to this module.
   *
   * @throws CircleVoronoiError as `fitAreas` with a region
   */
  fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: PeriodicFitOptions,
  ): Promise<PeriodicAreaFit>
  /**
   * Divides a region among the nodes of a tree in the worker, with the arguments and the result of `treemap` of `Regions`.
   * The region is one that `loadRegions` made in this thread. An error thrown by `progress` cancels the computation and
   * rejects the promise.
   *
   * @throws CircleVoronoiError as `treemap`; the reason of `signal`; a `DOMException` named AbortError if the worker is
   * disposed of. Each as a rejection.
   *
   * @example
   * const { region } = await loadRegions()
   * const square = region([[[0, 0], [2, 0], [2, 2], [0, 2]]])
   * const worker = createWorker()
   * const root = await worker.treemap({ children: [{ value: 3 }, { value: 1 }] }, { region: square })
   * root.children[0].area // 3
   * worker.dispose()
   */
  treemap<Node extends TreeNode>(root: Node, options: TreemapOptions): Promise<TreeWithCells<Node>>
  /** Ends the worker and its editors and cancels their work. */
  dispose(): void
}

/**
 * A worker that computes one diagram or fit after the other. `using` disposes of the worker.
 *
 * @category Workers
 */
export type CircleVoronoiWorker = WorkerMethods & Disposal

/**
 * Creates a worker in a page, in another worker or in Node. Its thread starts with the first computation. An idle
 * worker does not keep Node from exiting.
 *
 * @category Workers
 * @example
 * const worker = createWorker()
 * const later = await worker.compute([[0, 0, 1], [6, 0, 1], [0, 8, 1]])
 * later.find(5, 1) // 1
 * worker.dispose()
 */
export function createWorker(options: LoadOptions = {}): CircleVoronoiWorker {
  checkLoadOptions(options, 'createWorker')
  return new Client(options)
}

/** The options of a computation, some of which find circles in data. */
type ReadOptions<Datum> = AsyncMetricOptions & Partial<Accessors<Datum>>

/** Returns the arrays from which the worker makes the region again. */
function arraysOf({ points, ringOffsets, polygonOffsets }: Region): RingArrays {
  return { points, ringOffsets, polygonOffsets }
}

class Client implements CircleVoronoiWorker {
  readonly #module: () => Promise<CompiledWasm>
  readonly #metricsModule = loadedOnce(() => compileWasm(undefined, defaultMetricsWasm))
  readonly #regionsModule = loadedOnce(() => compileWasm(undefined, defaultRegionsWasm))
  readonly #sphereModule = loadedOnce(() => compileWasm(undefined, defaultSphereWasm))
  /** Answers the questions about diagrams that the worker has computed. */
  readonly #spheres = loadedOnce((wasm: CompiledWasm) => spheresOf(createSphereModule, wasm))
  #channel: Channel<WorkerRequests> | undefined
  /** Fulfilled when the last request has ended. */
  #last: Promise<unknown> = Promise.resolve()
  readonly #requests = new CancelableRequests()
  readonly #editors = new Set<EditorClient>()
  #isDisposed = false

  constructor(loadOptions: LoadOptions) {
    this.#module = loadedOnce(() => compileCircleVoronoi(loadOptions))
  }

  async compute<Datum>(circles: Circles | Iterable<Datum>, options: ReadOptions<Datum> = {}): Promise<Diagram> {
    checkMetricOptions(options, 'compute', ['signal'])
    const { coordinates, how, more } = await this.#computation(circles, options)
    return withWarning(new Diagram(await this.#ask('compute', [coordinates, how], more)))
  }

  async computePeriodic<Datum>(
    circles: Circles | Iterable<Datum>,
    lattice: Lattice,
    options: ReadOptions<Datum> = {},
  ): Promise<PeriodicDiagram> {
    const [ax, ay, bx, by] = latticeNumbers(lattice, 'computePeriodic') as unknown as [number, number, number, number]
    checkMetricOptions(options, 'computePeriodic', ['signal'])
    const { coordinates, how, more } = await this.#computation(circles, options)
    const periods = { a: [ax, ay], b: [bx, by] } as const
    return new PeriodicDiagram(await this.#ask('computePeriodic', [coordinates, periods, how], more))
  }

  /** Returns the arguments of a computation, whose options have been checked. */
  async #computation<Datum>(
    data: Circles | Iterable<Datum>,
    { signal, progress, metric = 'circles', x, y, r, ...options }: ReadOptions<Datum>,
  ) {
    checkSignal(signal)
    const coordinates = coordinatesOf(data, { x, y, r })
    const onProgress = progress && ((told: ComputeProgress) => progress(...told))
    const other = metric === 'circles' ? {} : { metric, wasm: newestMetricsWasm() ?? (await this.#metricsModule()) }
    const how: HowComputed = { options, ...other }
    return { coordinates, how, more: { signal, transfer: [coordinates.buffer], onProgress } }
  }

  async computeSphere<Datum>(
    places: Caps | Iterable<Datum>,
    options: AsyncSphereOptions & Partial<CapAccessors<Datum>> = {},
  ): Promise<SphereDiagram> {
    const sphere = sphereInput(places, options, ['signal'])
    const { signal } = options
    checkSignal(signal)
    const wasm = newestSphereWasm() ?? (await this.#sphereModule())
    const [computed, { diagramOf }] = await Promise.all([
      this.#ask('computeSphere', [sphere, wasm], { signal, transfer: [sphere.caps.buffer] }),
      this.#spheres(wasm),
    ])
    return diagramOf(computed)
  }

  fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: FitOptions,
  ): Promise<AreaFit>
  fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: PeriodicFitOptions,
  ): Promise<PeriodicAreaFit>
  async fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: FitOptions | PeriodicFitOptions,
  ): Promise<AreaFit | PeriodicAreaFit> {
    const fit = fitInput(sites, areas, options)
    const { region, onStep, signal } = options
    const wasm = region === undefined ? (newestWasm() ?? (await this.#regionsModule())) : wasmOf(region)
    if (wasm === undefined) refuseOption('The region of fitAreas was made by another copy of the library.')
    const transfer = [fit.sites.buffer, fit.areas.buffer]
    const more = { signal, transfer, onProgress: onStep }
    const found = await this.#ask('fitAreas', [fit, region && arraysOf(region), wasm], more)
    return 'periodic' in found
      ? { ...found, periodic: new PeriodicDiagram(found.periodic) }
      : { ...found, diagram: new Diagram(found.diagram) }
  }

  async treemap<Node extends TreeNode>(root: Node, options: TreemapOptions): Promise<TreeWithCells<Node>> {
    const { input, finish, named } = treeOf(root, options)
    const { region, progress, signal } = options
    const wasm = wasmOf(region)
    if (wasm === undefined) refuseOption('The region of treemap was made by another copy of the library.')
    const transfer = [input.parents.buffer, input.values.buffer, input.previous.buffer]
    const onProgress = progress && ((divided: readonly [number, number]) => progress(...divided))
    const more = { signal, transfer, onProgress }
    const cells = await this.#ask('treemap', [input, arraysOf(region), wasm], more).catch((error: unknown) => {
      throw named(error)
    })
    return finish(cells)
  }

  async edit(circles: Circles | DiagramData, options: EditorOptions = {}): Promise<AsyncDiagramEditor> {
    const start = editorStart(circles, options)
    if (this.#isDisposed) throw disposed()
    const module = await this.#module()
    if (this.#isDisposed) throw disposed()
    const editor = new EditorClient(module, start.weights, () => this.#editors.delete(editor))
    this.#editors.add(editor)
    await editor.begin(start)
    return editor
  }

  dispose(): void {
    this.#isDisposed = true
    for (const editor of this.#editors) editor.dispose()
    this.#requests.cancelAll(disposed())
    this.#channel?.end(disposed())
  }

  [Symbol.dispose](): void {
    this.dispose()
  }

  /** Asks the thread when all earlier requests have ended. */
  async #ask<Name extends keyof WorkerRequests>(
    name: Name,
    args: Parameters<WorkerRequests[Name]>,
    { signal, transfer, onProgress }: RequestOptions<ProgressOf<WorkerRequests[Name]>>,
  ): Promise<ReturnType<WorkerRequests[Name]>> {
    if (this.#isDisposed) throw disposed()
    return this.#requests.run(signal, (request) => {
      const answer = this.#last.then(async () => {
        request.signal.throwIfAborted()
        const module = await this.#module()
        request.signal.throwIfAborted()
        const channel = this.#open(module)
        // Only the end of the thread stops a computation.
        request.signal.addEventListener('abort', () => channel.end(request.signal.reason))
        const listen = (progress: Parameters<NonNullable<typeof onProgress>>[0]) => {
          try {
            onProgress?.(progress)
          } catch (error) {
            request.abort(error)
          }
        }
        return channel.request(name, args, { transfer, onProgress: onProgress && listen })
      })
      this.#last = answer.catch(() => {})
      const aborted = new Promise<never>((_, reject) => {
        request.signal.addEventListener('abort', () => reject(request.signal.reason))
      })
      return Promise.race([answer, aborted])
    })
  }

  #open(module: CompiledWasm): Channel<WorkerRequests> {
    if (this.#channel !== undefined && !this.#channel.isEnded) return this.#channel
    try {
      const channel = new Channel<WorkerRequests>(startThread, (cause) => channel.end(workerFailure(cause)), {})
      channel.request('start', [module]).catch(() => {})
      this.#channel = channel
      return channel
    } catch (cause) {
      throw workerFailure(cause)
    }
  }
}

function disposed(): DOMException {
  return new DOMException('The worker has been disposed of.', 'AbortError')
}
