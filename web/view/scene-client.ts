// SPDX-License-Identifier: GPL-3.0-or-later

import { CircleVoronoiError, reasonOf } from '../lib/base/errors.ts'
import type { Edit, Point } from '../lib/index.ts'
import type { Channel } from '../lib/threads/channel.ts'
import { type CircleChange, CircleTable, type Hit, type KeptIds, NO_CHANGE } from './circle-table.ts'
import type { DiagramCounts } from './diagram-counts.ts'
import { checkPlayed, type PaintedLayers } from './layers.ts'
import type {
  Computations,
  ComputingRequests,
  DomainChange,
  EditedPicture,
  Fitted,
  GlobalResults,
  Highlights,
  Opened,
  PaintedTiles,
  PainterRequests,
  PaintRequest,
  Questions,
} from './protocol.ts'
import { ENGLISH_REFUSALS, Failure, Refusal, type Refusals, Superseded } from './refusal.ts'
import type { Style } from './style.ts'

/** The result of opening circles or of an edit. */
export interface Edited {
  readonly counts: DiagramCounts
  /** The ids of inserted circles, in the order of the edits. */
  readonly inserted: Int32Array
  /** The edits that undo the change. */
  readonly back: readonly Edit[]
  /** The accuracy of fitted areas (`Editing`); `undefined` if no areas were prescribed. */
  readonly fitted?: Fitted | undefined
  /** The colors that tell circles from their neighbors, by ascending id, if they have changed (`Coloring`). */
  readonly colors?: string | undefined
  /** The computing time. */
  readonly seconds: number
}

/** The events of a view's picture. */
export interface PictureEvents {
  /** An opening has been requested. */
  opening(): void
  /** Circles were opened or edited. An edit has what it changed in the picture. */
  changed(edited: Edited, picture: EditedPicture | undefined): void
  painted(painted: PaintedTiles): void
  marked(marks: Highlights): void
  found(found: GlobalResults): void
  /** The circles have been sent again. The layers, the viewport and the highlights are to follow. */
  reopened(): void
  /** Something failed that no request asked for. */
  failed(failure: Error): void
}

/** The threads of a scene. */
export interface SceneThreads {
  /** The channel to the painting thread; `undefined` if there is none. */
  channel(): Channel<PainterRequests> | undefined
  /** Starts a painting thread if there is none. @throws Failure */
  begin(): Channel<PainterRequests>
  /** Replaces the painting thread, and rejects all pending requests with `Superseded`. */
  restart(): void
  /** Runs a computation in a thread of its own, because it cannot be divided into steps. `signal` ends it at once. */
  compute<Name extends keyof Computations>(
    name: Name,
    args: Parameters<ComputingRequests[Name]>,
    signal: AbortSignal,
  ): Promise<ReturnType<ComputingRequests[Name]>>
  /** Notes that the painting thread has completed something. */
  worked(): void
  remove(scene: number): unknown
}

/** The reason why a thread stopped. */
export type Reason = (words: Refusals) => string

export const failureFor = (reason: Reason): Error => new Failure((words) => words.notComputed(reason(words)))

export const isDisposedOf: Reason = (words) => words.disposed

/** The questions and computations about the circles of a view. */
export type Asked = Questions & Computations

/** Questions that refer to circles by id or position. */
const ABOUT_KNOWN: ReadonlySet<keyof Asked> = new Set(['touch', 'try', 'tell', 'tabulate'])

export type Answer<Name extends keyof Asked> = ReturnType<Asked[Name]> | undefined

type Args<Name extends keyof PainterRequests> = Parameters<PainterRequests[Name]>

/** The circles of one view in the painting thread. Another thread gets them after a crash. */
export class SceneClient {
  readonly #scene: number
  readonly events: PictureEvents
  readonly #threads: SceneThreads
  /** Aborted when the scene is closed. */
  readonly #closing = new AbortController()
  #lastOpening = 0
  /** The number of openings and edits that are running. */
  #changes = 0
  #circles = new CircleTable(new Float64Array())
  #domain: DomainChange = {}

  constructor(scene: number, events: PictureEvents, threads: SceneThreads) {
    this.#scene = scene
    this.events = events
    this.#threads = threads
    this.#send('add', [scene])
  }

  get #isClosed(): boolean {
    return this.#closing.signal.aborted
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
   * @throws CircleVoronoiError as `compute` and `region`; the scene stays unchanged
   */
  async open(circles: Float64Array, change: DomainChange = {}, kept?: KeptIds): Promise<Edited> {
    this.#lastOpening += 1
    const opening = this.#lastOpening
    const answer = this.#change('open', [this.#scene, opening, circles, kept, change])
    this.events.opening()
    const opened = await answer
    this.#circles = new CircleTable(opened.circles ?? circles.slice(), opening, kept)
    return this.#confirm(opened, NO_CHANGE, change, undefined)
  }

  /**
   * Applies all edits or none to the current circles.
   * @throws CircleVoronoiError as `DiagramEditor.apply` and `region`; Superseded if other circles are opened before the
   * edits run. The scene stays unchanged
   */
  async edit(edits: readonly Edit[], change: DomainChange = {}): Promise<Edited> {
    const args: Args<'edit'> = [this.#scene, this.#circles.opening, edits, change]
    const edited = await this.#change('edit', args)
    if (edited === undefined) throw new Superseded()
    return this.#confirm(edited, edited.change, change, edited)
  }

  /** Sends a change of the circles. */
  async #change<Name extends 'open' | 'edit'>(
    name: Name,
    args: Args<Name>,
  ): Promise<ReturnType<PainterRequests[Name]>> {
    if (this.#isClosed) throw failureFor(isDisposedOf)
    const channel = this.#threads.begin()
    this.#changes += 1
    try {
      return await channel.request(name, args, { signal: this.#closing.signal })
    } catch (error) {
      if (error instanceof CircleVoronoiError) this.#threads.worked()
      // The thread may have other circles than the confirmed ones.
      if (isUnexpected(error)) this.#reopen()
      throw asFailure(error)
    } finally {
      this.#changes -= 1
    }
  }

  /** Follows a change of the circles, and tells it. */
  #confirm(
    { counts, seconds, colors, lasting }: Omit<Opened, 'circles'>,
    changed: CircleChange,
    { region = this.#domain.region, lattice = this.#domain.lattice, areSites = this.#domain.areSites }: DomainChange,
    picture: EditedPicture | undefined,
  ): Edited {
    this.#domain = { region, lattice, areSites, colors: colors ?? this.#domain.colors, lasting }
    const back = this.#circles.follow(changed)
    this.#threads.worked()
    const edited = { counts, seconds, colors, inserted: changed.inserted, back }
    this.events.changed(edited, picture)
    return edited
  }

  /** Cancels an opening or an edit by replacing the thread that computes it. Returns false if none is running. */
  cancel(): boolean {
    const isChanging = this.#changes > 0
    if (isChanging) this.#threads.restart()
    return isChanging
  }

  /**
   * Asks a question. Resolves to `undefined` if it was canceled or its circles have been replaced, or if the thread
   * failed, which is an event.
   * @throws CircleVoronoiError that says why there is no answer
   */
  async ask<Name extends keyof Asked>(
    name: Name,
    args: Parameters<Asked[Name]>,
    signal?: AbortSignal,
  ): Promise<Answer<Name>> {
    if (this.#isClosed) return undefined
    const circles = this.#circles
    try {
      const signals = [this.#closing.signal, ...(signal ? [signal] : [])]
      const answer = await this.#answerTo(name, args, AbortSignal.any(signals))
      // Drops an answer about circles that have been replaced since the question.
      return ABOUT_KNOWN.has(name) && this.#circles !== circles ? undefined : (answer as Answer<Name>)
    } catch (error) {
      // The end of the painting thread is told once, to all scenes.
      const isTold = this.#isClosed || (error instanceof Failure && !isComputation(name))
      if (!isTold && (isUnexpected(error) || error instanceof Failure)) this.events.failed(asFailure(error))
      else if (error instanceof CircleVoronoiError) throw error
      return undefined
    }
  }

  async #answerTo(name: keyof Asked, args: readonly unknown[], signal: AbortSignal): Promise<unknown> {
    if (isComputation(name)) {
      if (name === 'fit') return this.#threads.compute(name, args as Parameters<Asked[typeof name]>, signal)
      // Starting a thread only for the refusal would copy all circles.
      if (name === 'trace') checkPlayed(this.#circles.count)
      const [options] = args as Parameters<Asked[typeof name]>
      const circles = this.#circles.circles()
      return name === 'compute'
        ? this.#threads.compute(name, [circles, this.#domain.lattice ?? undefined, options], signal)
        : this.#threads.compute(name, [circles, this.#circles.ids(), options], signal)
    }
    const channel = this.#threads.channel()
    if (channel === undefined) return undefined
    const answer = await channel.request(name, [this.#scene, ...args] as never, { signal })
    this.#threads.worked()
    return answer
  }

  look(request: PaintRequest, style: Style): void {
    this.#send('look', [this.#scene, request, style])
  }

  /** Sets the layers. The next `look` paints them. */
  setLayers(layers: PaintedLayers): void {
    this.#send('layers', [this.#scene, layers, true])
  }

  /** Sets layers that change only results for all circles, so that nothing is repainted. */
  findAgain(layers: PaintedLayers): void {
    this.#send('layers', [this.#scene, layers, false])
  }

  /** Highlights circles. */
  mark(selected: number | undefined, hovered: number | undefined): void {
    this.#send('mark', [this.#scene, selected, hovered], (marks) => this.events.marked(marks))
  }

  /**
   * Sends a request whose error is an event, unless the scene is closed.
   * @throws DOMException if the arguments cannot be sent
   */
  #send<Name extends keyof PainterRequests>(
    name: Name,
    args: Args<Name>,
    use: (answer: ReturnType<PainterRequests[Name]>) => void = () => {},
  ): void {
    if (this.#isClosed) return
    const answer = this.#threads.channel()?.request(name, args)
    const useOpen = (value: ReturnType<PainterRequests[Name]>) => this.#isClosed || use(value)
    answer?.then(useOpen).catch((error) => {
      // Other errors have ended the thread, which is told once.
      if (error instanceof CircleVoronoiError && !this.#isClosed) this.events.failed(asFailure(error))
    })
  }

  /** Closes the scene. Pending and later requests are rejected. */
  close(): void {
    this.#send('close', [this.#scene])
    this.#closing.abort(failureFor(isDisposedOf))
    this.#threads.remove(this.#scene)
  }

  /** Adds the scene to a new thread. */
  restore(): void {
    this.#send('add', [this.#scene])
    this.#reopen()
  }

  #reopen(): void {
    const { opening, keptIds } = this.#circles
    this.#send('open', [this.#scene, opening, this.#circles.circles(), keptIds, this.#domain])
    this.events.reopened()
  }
}

function isComputation(name: keyof Asked): name is keyof Computations {
  return name === 'compute' || name === 'trace' || name === 'fit'
}

/** Whether an error is a fault of the program and not of its input. */
function isUnexpected(error: unknown): boolean {
  return error instanceof CircleVoronoiError && error.code === 'internal'
}

/** Explains an unexpected error. Other errors explain themselves. */
export function asFailure(error: unknown): Error {
  if (!isUnexpected(error)) return error as Error
  return new Refusal(ENGLISH_REFUSALS, (words) => words.notComputed(reasonOf(error)), 'internal')
}
