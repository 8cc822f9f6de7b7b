// SPDX-License-Identifier: GPL-3.0-or-later

import { reasonOf, receivedError } from '../lib/base/errors.ts'
import type { Edit } from '../lib/index.ts'
import { startModuleWorker } from '../lib/threads/module-worker.ts'
import { compileCircleVoronoi } from '../lib/wasm/load-options.ts'
import { CircleTable, NO_CHANGE, type Step } from './circle-table.ts'
import type { DiagramCounts } from './diagram-counts.ts'
import type { Layers } from './layers.ts'
import { type FigureLoadOptions, otherModules } from './load.ts'
import { newWorker, THREAD_NAME, threadFile } from './painter-file.ts'
import type {
  DomainChange,
  Fitted,
  Found,
  FromPainter,
  InProgress,
  Marks,
  Questions,
  ToPainter,
  Wish,
} from './protocol.ts'
import { Failure, type Refusals, Superseded } from './refusal.ts'
import { type RemoteCall, RemoteCalls } from './remote-calls.ts'
import type { Style } from './style.ts'

/** What came of circles that were opened, or of edits. */
export interface Edited {
  readonly counts: DiagramCounts
  /** The ids of the circles that came, in the order of the edits. */
  readonly inserted: Int32Array
  /** The edits that undo it. */
  readonly back: readonly Step[]
  /** How near areas are to those that were asked for; `undefined`: none were. */
  readonly fitted?: Fitted | undefined
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
  /** The thread has failed, and another one goes on without what may have been the cause. */
  failed(failure: Failure, lost: Lost): void
}

/** What a new thread is not told again. */
export interface Lost {
  /** Which circles stand out. */
  readonly marks: boolean
  readonly layers: boolean
}

export type Painted = Extract<FromPainter, { kind: 'painted' | 'edited' }>

/** What was asked to change circles, until it is answered. */
interface Waiting {
  readonly message: Extract<ToPainter, { kind: 'open' | 'edit' }>
  resolve(edited: Edited): void
  reject(error: unknown): void
}

interface Scene {
  readonly events: PictureEvents
  readonly waiting: Map<number, Waiting>
  /** What another thread has to know to go on where this one fails. */
  circles: CircleTable
  /** Without `fit`: circles have the radii that were fitted. */
  domain: DomainChange
  look: ToPainter | undefined
  /** The last one that was answered, and those that are not yet. */
  mark: ToPainter | undefined
  unansweredMarks: ToPainter[]
  layers: ToPainter | undefined
}

/**
 * The thread that has the diagrams of all views of a page, and paints them. What fails because of it, and not because of what
 * was asked, is an `Error` that is no `CircleVoronoiError`: nothing has changed then, and another thread takes its place. If
 * this one never worked, that is when something is opened or edited again.
 *
 * A new thread is told the circles, the layers and what is looked at, but not what the failed one was doing: that would end it,
 * too. If it fails nevertheless before it has done anything, the next one is told the circles and what is looked at alone, and
 * there is none after that.
 */
export class Painter {
  readonly #options: FigureLoadOptions
  readonly #scenes = new Map<number, Scene>()
  readonly #questions = new RemoteCalls<Questions>()
  #worker: Worker | undefined
  /** Whether the thread has done something that was asked. */
  #hasWorked = false
  #beginning: Beginning = 'new'
  #isDisposed = false
  #lastScene = 0

  constructor(options: FigureLoadOptions = {}) {
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
      domain: {},
      look: undefined,
      mark: undefined,
      unansweredMarks: [],
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
          this.#stop((words) => words.canceled)
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
        // An answer about other circles than the asker knows would be wrong.
        return ABOUT_KNOWN.has(name) && scene.circles !== circles ? undefined : answer
      },
    })
  }

  /** Ends the thread, and with it all views. */
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
    for (const [scene, { circles, domain, look, mark, layers }] of this.#scenes) {
      const known = { scene, revision: RESTORED, opening: circles.opening }
      const restoring = circles.restoring()
      worker.postMessage({ kind: 'add', scene } satisfies ToPainter)
      if (layers !== undefined) worker.postMessage(layers)
      worker.postMessage({ kind: 'open', circles: restoring.circles, ...domain, ...known } satisfies ToPainter)
      worker.postMessage({ kind: 'edit', edits: restoring.edits, ...known } satisfies ToPainter)
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
    scene.domain = { region, lattice, areSites }
    if (message.kind === 'opened' && waiting.message.kind === 'open') {
      // What stood out was one of the circles before.
      scene.mark = undefined
      scene.circles = new CircleTable(message.circles ?? waiting.message.circles.slice(), waiting.message.opening)
    }
    const { change = NO_CHANGE } = message
    const back = scene.circles.follow(change)
    const { counts, fitted, seconds } = message
    waiting.resolve({ counts, fitted, seconds, inserted: change.inserted, back })
  }

  #fail(reason: Reason, during?: InProgress): void {
    const next = this.#hasWorked ? 'restored' : this.#beginning === 'restored' ? 'bare' : undefined
    const isFirst = !this.#hasWorked && this.#beginning === 'new'
    this.#stop(reason)
    // Who has asked for something hears of it.
    if (isFirst) return
    const lost = [...this.#scenes].map(
      ([number, scene]) => [scene, forgetCause(number, scene, during, next !== 'restored')] as const,
    )
    if (next !== undefined) this.#start(next)
    const failure = new Failure((words) => words[next ? 'drawingFailed' : 'drawingEnded'](reason(words)))
    for (const [{ events }, what] of lost) events.failed(failure, what)
  }

  #stop(reason: Reason): void {
    this.#worker?.terminate()
    this.#worker = undefined
    for (const scene of this.#scenes.values()) this.#leave(scene, reason)
  }

  /** There will be no answers for a scene. */
  #leave(scene: Scene, reason: Reason): void {
    this.#questions.leave(scene)
    const failure = new Failure((words) => words.notComputed(reason(words)))
    for (const { reject } of scene.waiting.values()) reject(failure)
    scene.waiting.clear()
  }
}

/** What may have ended a thread that was doing something, or did not even begin, is forgotten. Returns what that is. */
function forgetCause(number: number, scene: Scene, during: InProgress | undefined, isBare: boolean): Lost {
  const isOfScene = during?.scene === number
  const isUnanswered = scene.unansweredMarks.length > 0
  scene.unansweredMarks = []
  // What stands out is described with each look and each edit, too.
  const marks = isBare || isUnanswered || (isOfScene && ['look', 'edit'].includes(during.kind))
  const layers = isBare || (isOfScene && ['layers', 'paint', 'find'].includes(during.kind))
  if (marks) scene.mark = undefined
  if (layers) scene.layers = undefined
  return { marks, layers }
}

/** What a thread was told as it began: nothing, all that another one knew, or the circles and what is looked at alone. */
type Beginning = 'new' | 'restored' | 'bare'

/** Why the thread does nothing more. */
type Reason = (words: Refusals) => string

const isDisposedOf: Reason = (words) => words.disposed

/** The questions about circles that the asker knows by their ids or places. */
const ABOUT_KNOWN: ReadonlySet<keyof Questions> = new Set(['hit', 'touch', 'try', 'tell', 'tabulate'])

/** The revision of what a new thread is told of old circles. */
const RESTORED = 0

/** How a scene talks to the thread. */
interface Line {
  circles(): CircleTable
  post(message: ToPainter): void
  /** Posts it, too. */
  edited(message: Waiting['message']): Promise<Edited>
  cancel(): boolean
  ask<Name extends keyof Questions>(name: Name, args: Parameters<Questions[Name]>): Promise<Answer<Name>>
}

export type Answer<Name extends keyof Questions> = ReturnType<Questions[Name]> | undefined

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
  open(circles: Float64Array, change: DomainChange = {}): Promise<Edited> {
    const revision = this.#nextRevision()
    return this.#line.edited({ kind: 'open', scene: this.#scene, revision, opening: revision, circles, ...change })
  }

  /**
   * Edits the circles that are there now.
   *
   * @throws CircleVoronoiError as `DiagramEditor.apply`, `region` and `fitAreas`; Superseded, if other circles are there once
   *   it is the turn of the edits. Then all stays as it was
   */
  edit(edits: readonly Edit[], change: DomainChange = {}): Promise<Edited> {
    const revision = this.#nextRevision()
    const { opening } = this.circles
    return this.#line.edited({ kind: 'edit', scene: this.#scene, revision, opening, edits, ...change })
  }

  #nextRevision(): number {
    this.#revision += 1
    return this.#revision
  }

  /** Ends the thread that computes circles which are being opened; another one goes on. False: none are. */
  cancel(): boolean {
    return this.#line.cancel()
  }

  look(wish: Wish, style: Style): void {
    this.#line.post({ kind: 'look', scene: this.#scene, ...wish, style })
  }

  /** The circles as they are after all edits that are done; another table for other circles. */
  get circles(): CircleTable {
    return this.#line.circles()
  }

  /**
   * `undefined`: there is no answer, as the thread has failed, or as other circles have come that it was not about.
   *
   * @throws CircleVoronoiError that says why it cannot be answered
   */
  ask<Name extends keyof Questions>(name: Name, ...args: Parameters<Questions[Name]>): Promise<Answer<Name>> {
    return this.#line.ask(name, args)
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
