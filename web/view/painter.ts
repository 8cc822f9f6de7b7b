// SPDX-License-Identifier: GPL-3.0-or-later

import { reasonOf, receivedError } from '../lib/base/errors.ts'
import { startModuleWorker } from '../lib/threads/module-worker.ts'
import { compileCircleVoronoi } from '../lib/wasm/load-options.ts'
import { CircleTable, NO_CHANGE, type UndoEdit } from './circle-table.ts'
import type { DiagramCounts } from './diagram-counts.ts'
import type { PaintedLayers } from './layers.ts'
import { type FigureLoadOptions, otherModules } from './load.ts'
import { newWorker, THREAD_NAME, threadFile } from './painter-file.ts'
import type {
  DomainChange,
  Fitted,
  FromPainter,
  GlobalResults,
  Highlights,
  InProgress,
  PaintRequest,
  Questions,
  ToPainter,
} from './protocol.ts'
import { Failure, type Refusals, Superseded } from './refusal.ts'
import { type RemoteCall, RemoteCalls } from './remote-calls.ts'
import type { Style } from './style.ts'

/** The result of opening circles or of an edit. */
export interface Edited {
  readonly counts: DiagramCounts
  /** The ids of inserted circles, in the order of the edits. */
  readonly inserted: Int32Array
  /** The edits that undo the change. */
  readonly back: readonly UndoEdit[]
  /** The accuracy of fitted areas; `undefined` if no areas were prescribed. */
  readonly fitted?: Fitted | undefined
  /** The colors that tell circles from their neighbors, by ascending id, if they have changed (`Coloring`). */
  readonly colors?: string | undefined
  /** The computing time. */
  readonly seconds: number
}

/** The events of a view's picture. */
export interface PictureEvents {
  painted(painted: Painted): void
  marked(marks: Highlights): void
  /** The highlighted cells have new outlines for the current viewport; everything else is unchanged. */
  outlined(marks: Highlights): void
  /** `undefined`: the results belong to former circles, and new ones will follow. */
  found(found: GlobalResults | undefined): void
  /** The thread has failed and a new one continues. The possible cause of the failure is dropped. */
  failed(failure: Failure, lost: Lost): void
}

/** The settings that a new thread does not receive. */
export interface Lost {
  /** Whether circles were highlighted. */
  readonly marks: boolean
  readonly layers: boolean
}

export type Painted = Extract<FromPainter, { kind: 'painted' | 'edited' }>

/** An unanswered request to change circles. */
interface Waiting {
  readonly message: Extract<ToPainter, { kind: 'open' | 'edit' }>
  resolve(edited: Edited): void
  reject(error: unknown): void
}

interface SceneRecord {
  readonly events: PictureEvents
  readonly waiting: Map<number, Waiting>
  /** The state from which a new thread continues after a failure. */
  circles: CircleTable
  /** `fit` is left out, because the circles already have their fitted radii. */
  domain: DomainChange
  look: ToPainter | undefined
  /** The last answered request for highlights, and the unanswered ones. */
  mark: ToPainter | undefined
  unansweredMarks: ToPainter[]
  layers: ToPainter | undefined
}

/**
 * The thread that computes and paints the diagrams of all views of a page. A failure of the thread itself, as opposed
 * to a refused request, is an `Error` that is not a `CircleVoronoiError`. Nothing has changed then, and a new thread
 * takes over: at once, or at the next opening or edit if the failed thread never worked.
 * A new thread receives the circles, the layers and the viewport, but not the work during which the former one failed,
 * because the work may fail again. If the new thread fails before it has done anything, its successor receives only the
 * circles and the viewport. If that one fails too, there is no other.
 */
export class Painter {
  readonly #options: FigureLoadOptions
  readonly #scenes = new Map<number, SceneRecord>()
  readonly #questions = new RemoteCalls<Questions>()
  #worker: Worker | undefined
  /** Whether the thread has completed any request. */
  #hasWorked = false
  #beginning: Beginning = 'new'
  #isDisposed = false
  #lastScene = 0

  constructor(options: FigureLoadOptions = {}) {
    this.#options = options
    this.#start()
  }

  /** Adds a scene for another view. */
  add(events: PictureEvents): SceneClient {
    this.#lastScene += 1
    const number = this.#lastScene
    const scene: SceneRecord = {
      events,
      waiting: new Map(),
      circles: new CircleTable(new Float64Array()),
      domain: {},
      look: undefined,
      mark: undefined,
      unansweredMarks: [],
      layers: undefined,
    }
    this.#scenes.set(number, scene)
    this.#worker?.postMessage({ kind: 'add', scene: number } satisfies ToPainter)
    const isClosed = () => !this.#scenes.has(number)
    return new SceneClient(number, {
      circles: () => scene.circles,
      post: (message) => {
        if (isClosed()) return
        // An unserializable message throws here. Storing it first would make every later attempt fail.
        this.#worker?.postMessage(message)
        if (message.kind === 'look') scene.look = message
        if (message.kind === 'mark') scene.unansweredMarks.push(message)
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
      cancel: () => {
        const isOpening = [...scene.waiting.values()].some(
          ({ message }) => message.kind === 'open' || message.fit !== undefined,
        )
        if (isOpening) {
          // A result that the user canceled needs no reason.
          this.#stop(
            () => '',
            () => new Superseded(),
          )
          this.#start()
        }
        return isOpening
      },
      ask: async (name, args) => {
        const worker = this.#worker
        if (worker === undefined || isClosed()) return undefined
        const post = (call: RemoteCall<keyof Questions>) =>
          worker.postMessage({ kind: 'ask', scene: number, ...call } satisfies ToPainter)
        const { circles } = scene
        const answer = await this.#questions.call(name, args, post, scene)
        // Drops an answer about circles that have been replaced since the question.
        return ABOUT_KNOWN.has(name) && scene.circles !== circles ? undefined : answer
      },
    })
  }

  /** Terminates the thread, and with it all views. */
  dispose(): void {
    this.#isDisposed = true
    this.#stop(isDisposedOf)
  }

  #start(beginning: Beginning = 'new'): void {
    let worker: Worker
    try {
      worker = startModuleWorker(newWorker, threadFile, THREAD_NAME)
    } catch (error) {
      this.#stop(() => reasonOf(error))
      return
    }
    this.#worker = worker
    this.#hasWorked = false
    this.#beginning = beginning
    const fail = (reason: Reason, during?: InProgress) => {
      if (this.#worker === worker) this.#fail(reason, during)
    }
    worker.onmessage = ({ data }: MessageEvent<FromPainter>) => {
      if (data.kind === 'failed') fail(() => data.message, data.during)
      else if (this.#worker === worker) this.#receive(data)
    }
    worker.onerror = ({ message }) => fail((words) => message ?? words.noThread)
    Promise.all([compileCircleVoronoi(this.#options), otherModules(this.#options)]).then(
      ([module, others]) => worker.postMessage({ kind: 'start', module, others } satisfies ToPainter),
      (error: Error) => fail(() => reasonOf(error)),
    )
    for (const [scene, { circles, domain: kept, look, mark, layers }] of this.#scenes) {
      const { colors, ...domain } = kept
      const known = { scene, revision: RESTORED, opening: circles.opening }
      const restoring = circles.restoring()
      worker.postMessage({ kind: 'add', scene } satisfies ToPainter)
      if (layers !== undefined) worker.postMessage(layers)
      worker.postMessage({ kind: 'open', circles: restoring.circles, ...domain, ...known } satisfies ToPainter)
      worker.postMessage({ kind: 'edit', edits: restoring.edits, colors, ...known } satisfies ToPainter)
      if (look !== undefined) worker.postMessage(look)
      if (mark !== undefined) worker.postMessage(mark)
    }
  }

  #receive(message: Exclude<FromPainter, { kind: 'failed' }>): void {
    if ('request' in message) {
      this.#hasWorked = true
      this.#questions.receive(message)
      return
    }
    const scene = this.#scenes.get(message.scene)
    if (scene === undefined) return
    if (message.kind === 'marked') scene.mark = scene.unansweredMarks.shift() ?? scene.mark
    if (message.kind === 'painted' && message.isWhole) this.#hasWorked = true
    if (message.kind === 'marked' || message.kind === 'edited') scene.events.marked(message.marks)
    if (message.kind === 'outlined') scene.events.outlined(message.marks)
    if (message.kind === 'painted' || message.kind === 'edited') scene.events.painted(message)
    if (message.kind === 'edited' || message.kind === 'found') scene.events.found(message.found)
    if (!('revision' in message)) return
    const waiting = scene.waiting.get(message.revision)
    if (waiting === undefined) return
    this.#hasWorked = true
    scene.waiting.delete(message.revision)
    if (message.kind === 'superseded') {
      waiting.reject(new Superseded())
      return
    }
    if (message.kind === 'refused') {
      waiting.reject(receivedError(message.error))
      return
    }
    const { message: asked } = waiting
    const { region = scene.domain.region, lattice = scene.domain.lattice, areSites = scene.domain.areSites } = asked
    const { counts, fitted, seconds, colors } = message
    scene.domain = { region, lattice, areSites, colors: colors ?? scene.domain.colors }
    if (message.kind === 'opened' && waiting.message.kind === 'open') {
      // The highlighted ids belonged to former circles.
      scene.mark = undefined
      scene.circles = new CircleTable(message.circles ?? waiting.message.circles.slice(), waiting.message.opening)
    }
    const { change = NO_CHANGE } = message
    const back = scene.circles.follow(change)
    waiting.resolve({ counts, fitted, seconds, colors, inserted: change.inserted, back })
  }

  #fail(reason: Reason, during?: InProgress): void {
    const next = this.#hasWorked ? 'restored' : this.#beginning === 'restored' ? 'bare' : undefined
    const isFirst = !this.#hasWorked && this.#beginning === 'new'
    this.#stop(reason)
    // The callers of the rejected requests report the failure.
    if (isFirst) return
    const lost = [...this.#scenes].map(
      ([number, scene]) => [scene, forgetCause(number, scene, during, next !== 'restored')] as const,
    )
    if (next !== undefined) this.#start(next)
    const failure = new Failure((words) => words[next ? 'drawingFailed' : 'drawingEnded'](reason(words)))
    for (const [{ events }, what] of lost) events.failed(failure, what)
  }

  #stop(reason: Reason, failureOf = failureFor): void {
    this.#worker?.terminate()
    this.#worker = undefined
    for (const scene of this.#scenes.values()) this.#leave(scene, reason, failureOf)
  }

  /** Rejects all requests of a scene that will not be answered. */
  #leave(scene: SceneRecord, reason: Reason, failureOf = failureFor): void {
    this.#questions.leave(scene)
    const failure = failureOf(reason)
    for (const { reject } of scene.waiting.values()) reject(failure)
    scene.waiting.clear()
  }
}

/** Drops the settings that may have crashed a thread, during its work or at its start. Returns which ones. */
function forgetCause(number: number, scene: SceneRecord, during: InProgress | undefined, isBare: boolean): Lost {
  const isOfScene = during?.scene === number
  const isUnanswered = scene.unansweredMarks.length > 0
  scene.unansweredMarks = []
  // Highlights are computed with each viewport and each edit, so any of these may have failed because of them.
  const marks = isBare || isUnanswered || (isOfScene && ['look', 'edit'].includes(during.kind))
  const layers = isBare || (isOfScene && ['layers', 'paint', 'find'].includes(during.kind))
  if (marks) scene.mark = undefined
  if (layers) scene.layers = undefined
  return { marks, layers }
}

/** The state that a thread starts with: none, everything that its predecessor had, or only circles and viewport. */
type Beginning = 'new' | 'restored' | 'bare'

/** The reason why a thread stopped. */
type Reason = (words: Refusals) => string

const failureFor = (reason: Reason): Error => new Failure((words) => words.notComputed(reason(words)))

const isDisposedOf: Reason = (words) => words.disposed

/** Questions that refer to circles by id or position. */
const ABOUT_KNOWN: ReadonlySet<keyof Questions> = new Set(['hit', 'touch', 'try', 'tell', 'tabulate'])

/** The revision of the circles that a new thread starts with. */
const RESTORED = 0

/** A scene's connection to the thread. */
interface SceneConnection {
  circles(): CircleTable
  post(message: ToPainter): void
  /** Posts an edit and resolves with its result. */
  edited(message: Waiting['message']): Promise<Edited>
  cancel(): boolean
  ask<Name extends keyof Questions>(name: Name, args: Parameters<Questions[Name]>): Promise<Answer<Name>>
}

export type Answer<Name extends keyof Questions> = ReturnType<Questions[Name]> | undefined

/** The client side of one view's circles in the painting thread. */
export class SceneClient {
  readonly #scene: number
  readonly #connection: SceneConnection
  #revision = 0

  constructor(scene: number, connection: SceneConnection) {
    this.#scene = scene
    this.#connection = connection
  }

  /**
   * Replaces the circles; circle i gets id i.
   * @throws CircleVoronoiError as `compute`; the scene stays unchanged
   */
  open(circles: Float64Array, change: DomainChange = {}): Promise<Edited> {
    const revision = this.#nextRevision()
    return this.#connection.edited({
      kind: 'open',
      scene: this.#scene,
      revision,
      opening: revision,
      circles,
      ...change,
    })
  }

  /**
   * Edits the current circles.
   * @throws CircleVoronoiError as `DiagramEditor.apply`, `region` and `fitAreas`; Superseded if other circles are
   * opened before the edits run. The scene stays unchanged
   */
  edit(edits: readonly UndoEdit[], change: DomainChange = {}): Promise<Edited> {
    const revision = this.#nextRevision()
    const { opening } = this.circles
    return this.#connection.edited({ kind: 'edit', scene: this.#scene, revision, opening, edits, ...change })
  }

  #nextRevision(): number {
    this.#revision += 1
    return this.#revision
  }

  /** Cancels an opening by replacing the thread that computes it. Returns false if no opening is running. */
  cancel(): boolean {
    return this.#connection.cancel()
  }

  look(request: PaintRequest, style: Style): void {
    this.#connection.post({ kind: 'look', scene: this.#scene, ...request, style })
  }

  /** The circles after all finished edits. An opening creates a new table. */
  get circles(): CircleTable {
    return this.#connection.circles()
  }

  /**
   * Asks the thread a question. Resolves to `undefined` if the thread failed or the question's circles have been
   * replaced.
   * @throws CircleVoronoiError that says why there is no answer
   */
  ask<Name extends keyof Questions>(name: Name, ...args: Parameters<Questions[Name]>): Promise<Answer<Name>> {
    return this.#connection.ask(name, args)
  }

  /** Sets the layers. The next `look` paints them. */
  setLayers(layers: PaintedLayers): void {
    this.#connection.post({ kind: 'layers', scene: this.#scene, layers, isPainted: true })
  }

  /** Sets layers that change only results for all circles, so that nothing is repainted. */
  findAgain(layers: PaintedLayers): void {
    this.#connection.post({ kind: 'layers', scene: this.#scene, layers, isPainted: false })
  }

  /** Highlights circles. */
  mark(selected: number | undefined, hovered: number | undefined): void {
    this.#connection.post({ kind: 'mark', scene: this.#scene, selected, hovered })
  }

  /** Closes the scene. Pending and later requests are rejected. */
  close(): void {
    this.#connection.post({ kind: 'close', scene: this.#scene })
  }
}
