// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError, reasonOf } from '../lib/base/errors.ts'
import type { Circle, Edit, Options } from '../lib/index.ts'
import { startModuleWorker } from '../lib/threads/module-worker.ts'
import { compileCircleVoronoi, type LoadOptions } from '../lib/wasm/load-options.ts'
import type { TraceOptions } from '../lib/wasm/trace.ts'
import { CircleTable, NO_CHANGE, type Step } from './circle-table.ts'
import type { Layers } from './layers.ts'
import type { Frame } from './painter/frame.ts'
import { newPainterWorker, PAINTER_NAME, painterFile } from './painter-file.ts'
import type {
  Column,
  Computed,
  Counts,
  Distribution,
  Facts,
  Found,
  FromPainter,
  Hit,
  Marks,
  Tabulated,
  ToPainter,
  Touching,
  Traced,
  Trial,
  Wish,
} from './protocol.ts'
import { Failure, type Refusals } from './refusal.ts'
import type { Style } from './style.ts'

/** What came of circles that were opened, or of edits. */
export interface Edited {
  readonly counts: Counts
  /** The ids of the circles that came, in the order of the edits. */
  readonly inserted: Int32Array
  /** The edits that undo it. */
  readonly back: readonly Step[]
  /** How long it took. */
  readonly seconds: number
}

/** What a view is told of its picture. */
export interface PictureEvents {
  painted(painted: Painted): void
  marked(marks: Marks): void
  /** Nothing else is known of them, but their outlines are those of what is looked at now. */
  outlined(marks: Marks): void
  /** `undefined`: what was found is that of other circles, and something else will be. */
  found(found: Found | undefined): void
}

export type Painted = Extract<FromPainter, { kind: 'painted' | 'edited' }>

/** What was asked to change circles, until it is answered. */
interface Waiting {
  readonly message: Extract<ToPainter, { kind: 'open' | 'edit' }>
  resolve(edited: Edited): void
  reject(error: unknown): void
}

/** What was asked without a change of circles. */
interface Asked {
  readonly scene: Scene
  resolve(answer: undefined): void
}

interface Scene {
  readonly events: PictureEvents
  readonly waiting: Map<number, Waiting>
  /** What another thread has to know to go on where this one fails. */
  circles: CircleTable
  look: ToPainter | undefined
  mark: ToPainter | undefined
  layers: ToPainter | undefined
}

/**
 * The thread that has the diagrams of all views of a page, and paints them. What fails because of it, and not because of what
 * was asked, is an `Error` that is no `CircleVoronoiError`: nothing has changed then, and another thread takes its place. If
 * this one never worked, that is when something is opened or edited again.
 */
export class Painter {
  readonly #options: LoadOptions
  readonly #scenes = new Map<number, Scene>()
  readonly #asked = new Map<number, Asked>()
  #worker: Worker | undefined
  /** Whether the thread has done something that was asked. */
  #hasWorked = false
  #isDisposed = false
  #lastScene = 0
  #lastRequest = 0

  constructor(options: LoadOptions = {}) {
    this.#options = options
    this.#start()
  }

  /** A scene for another view. */
  add(events: PictureEvents): PainterScene {
    this.#lastScene += 1
    const number = this.#lastScene
    const scene: Scene = {
      events,
      waiting: new Map(),
      circles: new CircleTable(new Float64Array()),
      look: undefined,
      mark: undefined,
      layers: undefined,
    }
    this.#scenes.set(number, scene)
    this.#worker?.postMessage({ kind: 'add', scene: number } satisfies ToPainter)
    const isClosed = () => !this.#scenes.has(number)
    return new PainterScene(number, {
      circles: () => scene.circles,
      post: (message) => {
        if (isClosed()) return
        // What cannot be sent is not known later, either.
        this.#worker?.postMessage(message)
        if (message.kind === 'look') scene.look = message
        if (message.kind === 'mark') scene.mark = message
        if (message.kind === 'layers') scene.layers = message
        if (message.kind === 'close') {
          this.#scenes.delete(number)
          this.#leave(scene, isDisposedOf)
        }
      },
      edited: (message) =>
        new Promise((resolve, reject) => {
          scene.waiting.set(message.revision, { message, resolve, reject })
          if (isClosed() || this.#isDisposed) {
            this.#leave(scene, isDisposedOf)
            return
          }
          if (this.#worker === undefined) this.#start()
          this.#worker?.postMessage(message)
        }),
      ask: (message) =>
        new Promise((resolve) => {
          if (this.#worker === undefined || isClosed()) {
            resolve(undefined)
            return
          }
          this.#lastRequest += 1
          this.#asked.set(this.#lastRequest, { scene, resolve: resolve as (answer: undefined) => void })
          this.#worker.postMessage({ ...message, request: this.#lastRequest })
        }),
    })
  }

  /** Ends the thread, and with it all views. */
  dispose(): void {
    this.#isDisposed = true
    this.#stop(isDisposedOf)
  }

  #start(): void {
    let worker: Worker
    try {
      worker = startModuleWorker(newPainterWorker, painterFile, PAINTER_NAME)
    } catch (error) {
      this.#stop(() => reasonOf(error))
      return
    }
    this.#worker = worker
    this.#hasWorked = false
    const fail = (reason: Reason) => {
      if (this.#worker === worker) this.#fail(reason)
    }
    worker.onmessage = ({ data }: MessageEvent<FromPainter>) => {
      if (data.kind === 'failed') fail(() => data.message)
      else if (this.#worker === worker) this.#receive(data)
    }
    worker.onerror = ({ message }) => fail((words) => message ?? words.noThread)
    compileCircleVoronoi(this.#options).then(
      (module) => worker.postMessage({ kind: 'start', module } satisfies ToPainter),
      (error: Error) => fail(() => reasonOf(error)),
    )
    for (const [scene, { circles, look, mark, layers }] of this.#scenes) {
      const known = { scene, revision: RESTORED }
      const restoring = circles.restoring()
      worker.postMessage({ kind: 'add', scene } satisfies ToPainter)
      if (layers !== undefined) worker.postMessage(layers)
      worker.postMessage({ kind: 'open', circles: restoring.circles, ...known } satisfies ToPainter)
      worker.postMessage({ kind: 'edit', edits: restoring.edits, ...known } satisfies ToPainter)
      if (look !== undefined) worker.postMessage(look)
      if (mark !== undefined) worker.postMessage(mark)
    }
  }

  #receive(message: Exclude<FromPainter, { kind: 'failed' }>): void {
    if ('request' in message) {
      this.#hasWorked = true
      this.#asked.get(message.request)?.resolve(message as never)
      this.#asked.delete(message.request)
      return
    }
    const scene = this.#scenes.get(message.scene)
    if (scene === undefined) return
    if (message.kind === 'marked' || message.kind === 'edited') scene.events.marked(message.marks)
    if (message.kind === 'outlined') scene.events.outlined(message.marks)
    if (message.kind === 'painted' || message.kind === 'edited') scene.events.painted(message)
    if (message.kind === 'edited' || message.kind === 'found') scene.events.found(message.found)
    if (!('revision' in message)) return
    const waiting = scene.waiting.get(message.revision)
    if (waiting === undefined) return
    this.#hasWorked = true
    scene.waiting.delete(message.revision)
    if (message.kind === 'refused') {
      waiting.reject(new CircleVoronoiError(message.code, message.circle, message.message))
      return
    }
    if (waiting.message.kind === 'open') scene.circles = new CircleTable(waiting.message.circles.slice())
    const { change = NO_CHANGE } = message
    const back = scene.circles.follow(change)
    waiting.resolve({ counts: message.counts, seconds: message.seconds, inserted: change.inserted, back })
  }

  #fail(reason: Reason): void {
    const isReplaced = this.#hasWorked
    this.#stop(reason)
    if (isReplaced) this.#start()
  }

  #stop(reason: Reason): void {
    this.#worker?.terminate()
    this.#worker = undefined
    for (const scene of this.#scenes.values()) this.#leave(scene, reason)
  }

  /** There will be no answers for a scene. */
  #leave(scene: Scene, reason: Reason): void {
    for (const [request, asked] of this.#asked) {
      if (asked.scene !== scene) continue
      this.#asked.delete(request)
      asked.resolve(undefined)
    }
    const failure = new Failure((words) => words.notComputed(reason(words)))
    for (const { reject } of scene.waiting.values()) reject(failure)
    scene.waiting.clear()
  }
}

/** Why the thread does nothing more. */
type Reason = (words: Refusals) => string

const isDisposedOf: Reason = (words) => words.disposed

/** The revision of what a new thread is told of old circles. */
const RESTORED = 0

/** How a scene talks to the thread. */
interface Line {
  circles(): CircleTable
  post(message: ToPainter): void
  /** Posts it, too. */
  edited(message: Waiting['message']): Promise<Edited>
  /** `undefined`: there will be no answer. */
  ask<Answer>(message: object): Promise<Answer | undefined>
}

/** The circles of one view, in the painter's thread. */
export class PainterScene {
  readonly #scene: number
  readonly #line: Line
  #revision = 0

  constructor(scene: number, line: Line) {
    this.#scene = scene
    this.#line = line
  }

  /**
   * Other circles; circle i gets id i.
   *
   * @throws CircleVoronoiError as `compute`; then all stays as it was
   */
  open(circles: Float64Array): Promise<Edited> {
    this.#revision += 1
    return this.#line.edited({ kind: 'open', scene: this.#scene, revision: this.#revision, circles })
  }

  /** @throws CircleVoronoiError as `DiagramEditor.apply`; then all stays as it was */
  edit(edits: readonly Edit[]): Promise<Edited> {
    this.#revision += 1
    return this.#line.edited({ kind: 'edit', scene: this.#scene, revision: this.#revision, edits })
  }

  look(wish: Wish, style: Style): void {
    this.#line.post({ kind: 'look', scene: this.#scene, ...wish, style })
  }

  /** The circle at a point of the plane; `slack`: how near counts as on it. */
  async hit(x: number, y: number, slack: number): Promise<Hit | undefined> {
    const answer = await this.#line.ask<{ hit: Hit | undefined }>({ kind: 'hit', scene: this.#scene, x, y, slack })
    return answer?.hit
  }

  /** The disc around the vertex or the point of an edge next to a point of the plane. */
  async touch(x: number, y: number, slack: number): Promise<Touching | undefined> {
    const message = { kind: 'touch', scene: this.#scene, x, y, slack }
    return (await this.#line.ask<{ touching: Touching | undefined }>(message))?.touching
  }

  /** What a circle would take; `undefined`: it is none. */
  async try(circle: Circle): Promise<Trial | undefined> {
    return (await this.#line.ask<{ trial: Trial | undefined }>({ kind: 'try', scene: this.#scene, circle }))?.trial
  }

  /** The circles as they are after all edits that are done; another table for other circles. */
  get circles(): CircleTable {
    return this.#line.circles()
  }

  /** What a frame shows, without what stands out: the elements of an SVG. `undefined`: it could not be drawn. */
  async svg(frame: Frame, pixelRatio: number, style: Style): Promise<string | undefined> {
    const message = { kind: 'draw', scene: this.#scene, as: 'svg', frame, pixelRatio, style }
    return (await this.#line.ask<{ drawing: string | undefined }>(message))?.drawing
  }

  /** The same in pixels. */
  async image(frame: Frame, pixelRatio: number, style: Style): Promise<ImageBitmap | undefined> {
    const message = { kind: 'draw', scene: this.#scene, as: 'image', frame, pixelRatio, style }
    return (await this.#line.ask<{ drawing: ImageBitmap | undefined }>(message))?.drawing
  }

  /** How cells are distributed: a moment later, where there are many. `undefined`: the thread has failed. */
  async measure(): Promise<Distribution | undefined> {
    const answer = await this.#line.ask<{ distribution: Distribution }>({ kind: 'measure', scene: this.#scene })
    return answer?.distribution
  }

  /** What the cells of circles measure: of these ids at once, of all a moment later. */
  async tabulate(columns: readonly Column[], ids?: Int32Array): Promise<Tabulated | undefined> {
    const message = { kind: 'tabulate', scene: this.#scene, columns, ids }
    return (await this.#line.ask<{ table: Tabulated }>(message))?.table
  }

  /** What is so of the diagram and of the cells of circles. */
  async tell(ids: readonly number[]): Promise<Facts | undefined> {
    const answer = await this.#line.ask<{ facts: Facts }>({ kind: 'tell', scene: this.#scene, ids })
    return answer?.facts
  }

  /** Computes the diagram from nothing, likewise. */
  async compute(options: Options): Promise<Computed | undefined> {
    const message = { kind: 'compute', scene: this.#scene, options }
    return (await this.#line.ask<{ computed: Computed }>(message))?.computed
  }

  /**
   * What a method does with the circles, event by event.
   *
   * @throws CircleVoronoiError as `trace` of the library, and of too many circles
   */
  async trace(options: TraceOptions): Promise<Traced | undefined> {
    const answer = await this.#line.ask<Extract<FromPainter, { kind: 'traced' | 'notTraced' }>>({
      kind: 'trace',
      scene: this.#scene,
      options,
    })
    if (answer?.kind === 'notTraced') throw new CircleVoronoiError(answer.code, answer.circle, answer.message)
    return answer?.traced
  }

  /** What is drawn; the next `look` has it painted. */
  setLayers(layers: Layers): void {
    this.#line.post({ kind: 'layers', scene: this.#scene, layers, isPainted: true })
  }

  /** Likewise, where only what depends on all circles is another. */
  findAgain(layers: Layers): void {
    this.#line.post({ kind: 'layers', scene: this.#scene, layers, isPainted: false })
  }

  /** Which circles stand out. */
  mark(selected: number | undefined, hovered: number | undefined): void {
    this.#line.post({ kind: 'mark', scene: this.#scene, selected, hovered })
  }

  /** Ends what is asked of it, and all that is asked later. */
  close(): void {
    this.#line.post({ kind: 'close', scene: this.#scene })
  }
}
