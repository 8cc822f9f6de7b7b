// SPDX-License-Identifier: GPL-3.0-or-later

import { receivedError } from '../lib/base/errors.ts'
import type { Edit, Point } from '../lib/index.ts'
import { CircleTable, type Hit, type KeptIds, NO_CHANGE } from './circle-table.ts'
import type { DiagramCounts } from './diagram-counts.ts'
import type { PaintedLayers } from './layers.ts'
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
import type { RemoteCalls } from './remote-calls.ts'
import type { Style } from './style.ts'

/** The result of opening circles or of an edit. */
export interface Edited {
  readonly counts: DiagramCounts
  /** The ids of inserted circles, in the order of the edits. */
  readonly inserted: Int32Array
  /** The edits that undo the change. */
  readonly back: readonly Edit[]
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

/** The thread of a scene. */
export interface SceneThread {
  readonly questions: RemoteCalls<Questions>
  isRunning(): boolean
  /** Starts a thread if none is running. Returns false if the thread has been disposed of. */
  begin(): boolean
  /** Replaces the thread, and rejects all pending requests with `Superseded`. */
  restart(): void
  post(message: ToPainter): void
  remove(scene: number): unknown
}

/** The reason why a thread stopped. */
export type Reason = (words: Refusals) => string

export const failureFor = (reason: Reason): Error => new Failure((words) => words.notComputed(reason(words)))

export const isDisposedOf: Reason = (words) => words.disposed

/** Questions that refer to circles by id or position. */
const ABOUT_KNOWN: ReadonlySet<keyof Questions> = new Set(['touch', 'try', 'tell', 'tabulate'])

/** The revision of the circles that a new thread starts with. */
const RESTORED = 0

export type Answer<Name extends keyof Questions> = ReturnType<Questions[Name]> | undefined

/** The circles of one view in the painting thread, and the state from which a new thread continues after a failure. */
export class SceneClient {
  readonly #scene: number
  readonly #events: PictureEvents
  readonly #thread: SceneThread
  readonly #waiting = new Map<number, Waiting>()
  #revision = 0
  #isClosed = false
  #circles = new CircleTable(new Float64Array())
  /** `fit` is left out, because the circles already have their fitted radii. */
  #domain: DomainChange = {}
  #look: ToPainter | undefined
  /** The last answered request for highlights, and the unanswered ones. */
  #mark: ToPainter | undefined
  #unansweredMarks: ToPainter[] = []
  #layers: ToPainter | undefined

  constructor(scene: number, events: PictureEvents, thread: SceneThread) {
    this.#scene = scene
    this.#events = events
    this.#thread = thread
    thread.post({ kind: 'add', scene })
  }

  /** The circles after all finished edits. An opening creates a new table. */
  get circles(): CircleTable {
    return this.#circles
  }

  get domain(): DomainChange {
    return this.#domain
  }

  /** The circle at a point of the plane (`CircleTable.hitAt`). */
  hitAt(point: Point, slack: number, reach?: number): Hit | undefined {
    return this.#circles.hitAt(point, slack, reach, this.#domain)
  }

  /**
   * Replaces the circles. Without `kept`, circle i gets id i.
   * @throws CircleVoronoiError as `compute`; the scene stays unchanged
   */
  open(circles: Float64Array, change: DomainChange = {}, kept?: KeptIds): Promise<Edited> {
    const revision = this.#nextRevision()
    return this.#edited({ kind: 'open', scene: this.#scene, revision, opening: revision, circles, kept, ...change })
  }

  /**
   * Edits the current circles.
   * @throws CircleVoronoiError as `DiagramEditor.apply`, `region` and `fitAreas`; Superseded if other circles are
   * opened before the edits run. The scene stays unchanged
   */
  edit(edits: readonly Edit[], change: DomainChange = {}): Promise<Edited> {
    const revision = this.#nextRevision()
    const { opening } = this.#circles
    return this.#edited({ kind: 'edit', scene: this.#scene, revision, opening, edits, ...change })
  }

  #nextRevision(): number {
    this.#revision += 1
    return this.#revision
  }

  #edited(message: Waiting['message']): Promise<Edited> {
    return new Promise((resolve, reject) => {
      this.#waiting.set(message.revision, { message, resolve, reject })
      if (this.#isClosed || !this.#thread.begin()) this.leave(failureFor(isDisposedOf))
      else this.#thread.post(message)
    })
  }

  /** Cancels an opening by replacing the thread that computes it. Returns false if no opening is running. */
  cancel(): boolean {
    const isOpening = [...this.#waiting.values()].some(
      ({ message }) => message.kind === 'open' || message.fit !== undefined,
    )
    if (isOpening) this.#thread.restart()
    return isOpening
  }

  /**
   * Asks the thread a question. Resolves to `undefined` if the thread failed or the question's circles have been
   * replaced.
   * @throws CircleVoronoiError that says why there is no answer
   */
  async ask<Name extends keyof Questions>(name: Name, ...args: Parameters<Questions[Name]>): Promise<Answer<Name>> {
    if (!this.#thread.isRunning() || this.#isClosed) return undefined
    const circles = this.#circles
    const answer = await this.#thread.questions.call(
      name,
      args,
      (call) => this.#thread.post({ kind: 'ask', scene: this.#scene, ...call }),
      this,
    )
    // Drops an answer about circles that have been replaced since the question.
    return ABOUT_KNOWN.has(name) && this.#circles !== circles ? undefined : answer
  }

  // An unserializable message is thrown by `post`. Storing it first would make every later attempt fail.

  look(request: PaintRequest, style: Style): void {
    this.#look = this.#posted({ kind: 'look', scene: this.#scene, ...request, style }) ?? this.#look
  }

  /** Sets the layers. The next `look` paints them. */
  setLayers(layers: PaintedLayers): void {
    this.#setLayers(layers, true)
  }

  /** Sets layers that change only results for all circles, so that nothing is repainted. */
  findAgain(layers: PaintedLayers): void {
    this.#setLayers(layers, false)
  }

  #setLayers(layers: PaintedLayers, isPainted: boolean): void {
    this.#layers = this.#posted({ kind: 'layers', scene: this.#scene, layers, isPainted }) ?? this.#layers
  }

  /** Highlights circles. */
  mark(selected: number | undefined, hovered: number | undefined): void {
    const message = this.#posted({ kind: 'mark', scene: this.#scene, selected, hovered })
    if (message !== undefined) this.#unansweredMarks.push(message)
  }

  #posted(message: ToPainter): ToPainter | undefined {
    if (this.#isClosed) return undefined
    this.#thread.post(message)
    return message
  }

  /** Closes the scene. Pending and later requests are rejected. */
  close(): void {
    this.#posted({ kind: 'close', scene: this.#scene })
    this.#isClosed = true
    this.#thread.remove(this.#scene)
    this.leave(failureFor(isDisposedOf))
  }

  /** Rejects all requests that will not be answered. */
  leave(failure: Error): void {
    this.#thread.questions.leave(this)
    for (const { reject } of this.#waiting.values()) reject(failure)
    this.#waiting.clear()
  }

  /** Sends the whole state to a new thread. */
  restore(): void {
    const scene = this.#scene
    const { opening, keptIds: kept } = this.#circles
    const circles = this.#circles.circles()
    const messages: readonly (ToPainter | undefined)[] = [
      { kind: 'add', scene },
      this.#layers,
      { kind: 'open', scene, revision: RESTORED, opening, circles, kept, ...this.#domain },
      this.#look,
      this.#mark,
    ]
    for (const message of messages) if (message !== undefined) this.#thread.post(message)
  }

  /** Handles a message of the thread. Returns whether it completes a request. */
  receive(message: Extract<FromPainter, { scene: number }>): boolean {
    if (message.kind === 'marked') this.#mark = this.#unansweredMarks.shift() ?? this.#mark
    if ('marks' in message) this.#events.marked(message.marks)
    if (message.kind === 'painted' || message.kind === 'edited') this.#events.painted(message)
    if (message.kind === 'edited' || message.kind === 'found') this.#events.found(message.found)
    if (!('revision' in message)) return message.kind === 'painted' && message.isWhole
    const waiting = this.#waiting.get(message.revision)
    if (waiting === undefined) return false
    this.#waiting.delete(message.revision)
    if (message.kind === 'superseded') waiting.reject(new Superseded())
    else if (message.kind === 'refused') waiting.reject(receivedError(message.error))
    else waiting.resolve(this.#follow(waiting.message, message))
    return true
  }

  #follow(asked: Waiting['message'], done: Extract<FromPainter, { kind: 'opened' | 'edited' }>): Edited {
    const { region = this.#domain.region, lattice = this.#domain.lattice, areSites = this.#domain.areSites } = asked
    const { counts, fitted, seconds, colors, change = NO_CHANGE } = done
    this.#domain = { region, lattice, areSites, colors: colors ?? this.#domain.colors }
    if (done.kind === 'opened' && asked.kind === 'open') {
      // The highlighted ids belonged to former circles.
      this.#mark = undefined
      this.#circles = new CircleTable(done.circles ?? asked.circles.slice(), asked.opening, asked.kept)
    }
    const back = this.#circles.follow(change)
    return { counts, fitted, seconds, colors, inserted: change.inserted, back }
  }

  /** Drops the settings that may have crashed a thread, during its work or at its start. Returns which ones. */
  forgetCause(during: InProgress | undefined, isBare: boolean): Lost {
    const isOfScene = during?.scene === this.#scene
    const isUnanswered = this.#unansweredMarks.length > 0
    this.#unansweredMarks = []
    // Each viewport and each edit computes the highlights, so they may have been the cause.
    const marks = isBare || isUnanswered || (isOfScene && ['look', 'edit'].includes(during.kind))
    const layers = isBare || (isOfScene && ['layers', 'paint', 'find'].includes(during.kind))
    if (marks) this.#mark = undefined
    if (layers) this.#layers = undefined
    return { marks, layers }
  }

  fail(failure: Failure, lost: Lost): void {
    this.#events.failed(failure, lost)
  }
}
