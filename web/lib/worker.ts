// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Computes and edits diagrams and fits areas in a worker, with progress and cancellation.
 *
 * @module circle-voronoi/worker
 */

import { refuseOption } from './base/check.ts'
import { type Accessors, type Circles, coordinatesOf } from './base/coordinates.ts'
import { receivedError, workerFailure } from './base/errors.ts'
import { loadedOnce } from './base/loaded-once.ts'
import type { DiagramData, Disposal } from './base/types.ts'
import { Diagram } from './diagram/diagram.ts'
import { withWarning } from './diagram/hidden-warning.ts'
import { type Lattice, latticeNumbers } from './diagram/lattice.ts'
import { PeriodicDiagram } from './diagram/periodic-diagram.ts'
import createSphereModule from './generated/circle-voronoi-sphere.js'
import type { Region } from './regions/region.ts'
import type { RingArrays } from './regions/region-shape.ts'
import { EditorClient } from './threads/editor-client.ts'
import { startThread, type Thread } from './threads/thread.ts'
import type { AsyncDiagramEditor } from './threads/worker-editor.ts'
import type { ComputeRequest, Reply, Request } from './threads/worker-messages.ts'
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

/** A pending or running computation. */
interface Job {
  readonly request: Request
  /** The memory of the request, which is transferred instead of copied. */
  readonly transfer: ArrayBuffer[]
  readonly observer: Observer
  /** Fulfills the promise with the last reply. */
  readonly resolve: (reply: Reply) => void
  readonly reject: (reason: unknown) => void
  readonly onAbort: () => void
}

/** The listeners of a caller, and its signal. */
interface Observer {
  readonly tell: (reply: Reply) => void
  readonly signal: AbortSignal | undefined
}

/** The options of a computation, some of which find circles in data. */
type ReadOptions<Datum> = AsyncMetricOptions & Partial<Accessors<Datum>>

/** Returns the request of a computation, whose options have been checked, and who listens to it. */
function computationOf<Datum>(
  data: Circles | Iterable<Datum>,
  { signal, progress, metric: _, x, y, r, ...options }: ReadOptions<Datum>,
): { readonly request: ComputeRequest; readonly observer: Observer } {
  checkSignal(signal)
  const circles = coordinatesOf(data, { x, y, r })
  const tell = (reply: Reply) => 'progress' in reply && progress?.(...reply.progress)
  return { request: { circles, options, tellsProgress: progress !== undefined }, observer: { tell, signal } }
}

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
  #thread: Thread | undefined
  /** The first job belongs to the thread; the others wait. */
  #jobs: Job[] = []
  /** The job that the thread has been given. */
  #running: Job | undefined
  readonly #editors = new Set<EditorClient>()
  #isDisposed = false

  constructor(loadOptions: LoadOptions) {
    this.#module = loadedOnce(() => compileCircleVoronoi(loadOptions))
  }

  async compute<Datum>(circles: Circles | Iterable<Datum>, options: ReadOptions<Datum> = {}): Promise<Diagram> {
    checkMetricOptions(options, 'compute', ['signal'])
    const { request, observer } = computationOf(circles, options)
    const other = await this.#otherMetric(options)
    const reply = await this.#ask({ ...request, ...other }, [request.circles.buffer], observer)
    return withWarning(new Diagram((reply as Extract<Reply, { diagram: unknown }>).diagram))
  }

  async computePeriodic<Datum>(
    circles: Circles | Iterable<Datum>,
    lattice: Lattice,
    options: ReadOptions<Datum> = {},
  ): Promise<PeriodicDiagram> {
    const [ax, ay, bx, by] = latticeNumbers(lattice, 'computePeriodic') as unknown as [number, number, number, number]
    checkMetricOptions(options, 'computePeriodic', ['signal'])
    const { request, observer } = computationOf(circles, options)
    const periods = { a: [ax, ay], b: [bx, by] } as const
    const other = await this.#otherMetric(options)
    const reply = await this.#ask({ ...request, lattice: periods, ...other }, [request.circles.buffer], observer)
    return new PeriodicDiagram((reply as Extract<Reply, { periodic: unknown }>).periodic)
  }

  /** Returns a metric other than `circles`, and the module for it. */
  async #otherMetric({ metric = 'circles' }: MetricOptions): Promise<Pick<ComputeRequest, 'metric' | 'wasm'>> {
    return metric === 'circles' ? {} : { wasm: newestMetricsWasm() ?? (await this.#metricsModule()), metric }
  }

  async computeSphere<Datum>(
    places: Caps | Iterable<Datum>,
    options: AsyncSphereOptions & Partial<CapAccessors<Datum>> = {},
  ): Promise<SphereDiagram> {
    const sphere = sphereInput(places, options, ['signal'])
    const { signal } = options
    checkSignal(signal)
    const wasm = newestSphereWasm() ?? (await this.#sphereModule())
    const [reply, { diagramOf }] = await Promise.all([
      this.#ask({ sphere, wasm }, [sphere.caps.buffer], { tell: () => {}, signal }),
      this.#spheres(wasm),
    ])
    return diagramOf((reply as Extract<Reply, { sphere: unknown }>).sphere)
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
    const request = { fit, region: region && arraysOf(region), wasm, tellsProgress: onStep !== undefined }
    const tell = (reply: Reply) => 'step' in reply && onStep?.(reply.step)
    const reply = await this.#ask(request, [fit.sites.buffer, fit.areas.buffer], { tell, signal })
    if ('periodicFit' in reply) {
      const { periodic, ...rest } = reply.periodicFit
      return { ...rest, periodic: new PeriodicDiagram(periodic) }
    }
    const { diagram, ...rest } = (reply as Extract<Reply, { fit: unknown }>).fit
    return { ...rest, diagram: new Diagram(diagram) }
  }

  async treemap<Node extends TreeNode>(root: Node, options: TreemapOptions): Promise<TreeWithCells<Node>> {
    const { input, finish, named } = treeOf(root, options)
    const { region, progress, signal } = options
    const wasm = wasmOf(region)
    if (wasm === undefined) refuseOption('The region of treemap was made by another copy of the library.')
    const request = { tree: input, region: arraysOf(region), wasm, tellsProgress: progress !== undefined }
    const tell = (reply: Reply) => 'divided' in reply && progress?.(...reply.divided)
    const memory = [input.parents.buffer, input.values.buffer, input.previous.buffer]
    const reply = await this.#ask(request, memory, { tell, signal }).catch((error: unknown) => {
      throw named(error)
    })
    return finish((reply as Extract<Reply, { cells: unknown }>).cells)
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
    // The last job is canceled first, so that no other job begins.
    for (const job of this.#jobs.toReversed()) this.#cancel(job, disposed())
    this.#stopThread()
  }

  [Symbol.dispose](): void {
    this.dispose()
  }

  /** Puts a request into the queue, and returns the reply that ends it. */
  async #ask(request: Request, transfer: ArrayBuffer[], observer: Observer): Promise<Reply> {
    const { signal } = observer
    if (this.#isDisposed) throw disposed()
    signal?.throwIfAborted()
    return new Promise((resolve, reject) => {
      const onAbort = () => this.#cancel(job, signal?.reason)
      const job: Job = { request, transfer, observer, resolve, reject, onAbort }
      signal?.addEventListener('abort', onAbort)
      this.#jobs.push(job)
      if (this.#jobs.length === 1) this.#begin(job)
    })
  }

  #begin(job: Job): void {
    this.#module()
      .then((module) => {
        // The job may have been canceled in the meantime.
        if (this.#jobs[0] === job) this.#run(job, module)
      })
      .catch((error) => this.#settle(job, () => job.reject(error)))
  }

  #run(job: Job, module: CompiledWasm): void {
    try {
      this.#thread ??= this.#startThread(module)
    } catch (cause) {
      throw workerFailure(cause)
    }
    this.#thread.keepAlive(true)
    this.#thread.post(job.request, job.transfer)
    this.#running = job
  }

  #startThread(module: CompiledWasm): Thread {
    // Messages of a thread that has been ended are ignored.
    const ifCurrent = (action: () => void) => this.#thread === thread && action()
    const thread = startThread({
      onReply: (reply) => ifCurrent(() => this.#receive(reply)),
      onFailure: (cause) => ifCurrent(() => this.#fail(cause)),
    })
    thread.post({ module })
    return thread
  }

  #receive(reply: Reply): void {
    const job = this.#running
    if (job === undefined || 'results' in reply) return
    if ('progress' in reply || 'step' in reply || 'divided' in reply) {
      try {
        job.observer.tell(reply)
      } catch (error) {
        this.#cancel(job, error)
      }
      return
    }
    this.#running = undefined
    this.#settle(job, () => {
      if ('error' in reply) return job.reject(receivedError(reply.error))
      job.resolve(reply)
    })
  }

  #fail(cause: unknown): void {
    const job = this.#running
    this.#stopThread()
    if (job === undefined) return
    this.#settle(job, () => job.reject(workerFailure(cause)))
  }

  #cancel(job: Job, reason: unknown): void {
    // Only the end of the thread stops a computation.
    if (this.#running === job) this.#stopThread()
    this.#settle(job, () => job.reject(reason))
  }

  /** Takes a job from the queue, settles its promise, and goes on with the next. */
  #settle(job: Job, settlePromise: () => void): void {
    const wasFirst = this.#jobs[0] === job
    this.#jobs = this.#jobs.filter((other) => other !== job)
    job.observer.signal?.removeEventListener('abort', job.onAbort)
    settlePromise()
    const [next] = this.#jobs
    if (next === undefined) this.#thread?.keepAlive(false)
    else if (wasFirst) this.#begin(next)
  }

  #stopThread(): void {
    this.#thread?.terminate()
    this.#thread = undefined
    this.#running = undefined
  }
}

function disposed(): DOMException {
  return new DOMException('The worker has been disposed of.', 'AbortError')
}
