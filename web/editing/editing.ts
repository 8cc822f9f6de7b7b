// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Edit, Float64s } from '../lib/index.ts'
import type { CircleTable, KeptIds } from '../view/circle-table.ts'
import { type Areas, type Domain, NO_DOMAIN } from '../view/domain.ts'
import type { Computations, DomainChange, Fit } from '../view/protocol.ts'
import { ENGLISH_REFUSALS, Refusal, Superseded } from '../view/refusal.ts'
import type { Edited } from '../view/scene-client.ts'
import type { Store } from '../view/store.ts'
import type { IdentifiedCircle } from './arranging.ts'
import { type Attributes, NO_ATTRIBUTES, withValues } from './attributes.ts'
import { areasById, areasFor, areasInOrder, domainChange } from './domain-change.ts'
import { fittingAfter } from './fitting.ts'
import { type CircleSet, EMPTY_HISTORY, type History, limited, MOST_BYTES, type Opening, record } from './history.ts'
import { PackedSteps } from './packed-steps.ts'
import { type State, stateAfter } from './state.ts'

/** More circles would take too long to fit. */
const MOST_FITTED = 10_000

/** The backend that computes diagrams: the scene of a view. */
export interface DiagramBackend {
  /** The current circles. */
  readonly circles: CircleTable
  open(circles: Float64Array, change?: DomainChange, kept?: KeptIds): Promise<Edited>
  edit(edits: readonly Edit[], change?: DomainChange): Promise<Edited>
  /** Fits circles to areas. Resolves to `undefined` if the signal canceled it, or after a failure, which is told. */
  ask(name: 'fit', args: Parameters<Computations['fit']>, signal: AbortSignal): Promise<Fit | undefined>
}

/** The result of a request. The rest is in the state. */
export interface Outcome {
  readonly edited: Edited
  /** Whether the circles were replaced by others. */
  readonly isOpened: boolean
  /** Whether circles may have other names, colors or values of columns than before. */
  readonly hasNewAttributes: boolean
}

/** A history that continues when its circles are opened again under their ids. */
export interface Past {
  readonly history: History
  readonly lastGesture: number
}

/** The result of a request that the backend has confirmed, and the parts of the state that it changes. */
interface Confirmed {
  readonly edited: Edited
  readonly change: Pick<State, 'history'> & Partial<Pick<State, 'scene' | 'colors' | 'domain' | 'attributes'>>
}

/** Circles with their radii for a domain. Without circles or areas, nothing was fitted. */
type MaybeFit = Pick<Fit, 'circles'> & Partial<Fit>

/** A request, running or pending. */
interface Job {
  readonly key: string | undefined
  /** The circles that its edits change, as they are afterwards; `undefined` stands for a removed circle. */
  circlesAfter: ReadonlyMap<number, Circle | undefined>
  /** Resolves to `undefined` if there was nothing to do. */
  run(): Promise<Confirmed | undefined>
}

/**
 * Changes the circles and the parts of the state that belong to them, once the backend has confirmed a request. A
 * refused edit leaves no trace. Requests run one at a time; a pending step of a drag is replaced by the next one, so
 * that fast drags never queue up.
 */
export class Editing {
  readonly #store: Store<State>
  readonly #backend: DiagramBackend
  readonly #onOutcome: (outcome: Outcome) => void
  readonly #onProblem: (error: Error) => void
  readonly #mostBytes: number
  /** The running job, and the pending ones. */
  #jobs: Job[] = []
  /** The answer to the newest job. */
  #newest: Promise<Edited | undefined> = Promise.resolve(undefined)
  #lastGesture = 0
  /** The last gesture that began before the current circles were opened. */
  #lastFormer = 0
  /** The number of openings, except by undo and redo. */
  #openings = 0
  /** Cancels the fit that is running. */
  #fitting: AbortController | undefined

  /** `mostBytes` limits the memory of the history. */
  constructor(
    store: Store<State>,
    backend: DiagramBackend,
    onOutcome: (outcome: Outcome) => void,
    onProblem: (error: Error) => void,
    mostBytes = MOST_BYTES,
  ) {
    this.#store = store
    this.#backend = backend
    this.#onOutcome = onOutcome
    this.#onProblem = onProblem
    this.#mostBytes = mostBytes
  }

  get #state(): State {
    return this.#store.get()
  }

  get circles(): CircleTable {
    return this.#backend.circles
  }

  /** The history, for when the current circles are opened again under their ids. */
  get past(): Past {
    return { history: this.#state.history, lastGesture: this.#lastGesture }
  }

  /** Continues the history of the circles that were opened. */
  takeUp({ history, lastGesture }: Past): void {
    this.#store.update((state) => ({ ...state, history }))
    this.#lastGesture = Math.max(this.#lastGesture, lastGesture)
  }

  /**
   * The number of edits and openings that are running or pending. A request counts until its listeners have returned.
   */
  get unfinished(): number {
    return this.#jobs.length
  }

  /** The opened circles without later edits. */
  get scene(): CircleSet | undefined {
    return this.#state.scene
  }

  /** The clipping region, and the areas by id. */
  get domain(): Domain {
    return this.#state.domain
  }

  /** The prescribed areas, in the order of the circles. */
  get areas(): Areas | undefined {
    return areasInOrder(this.domain, this.circles)
  }

  /** The attributes of circles, by their ids. */
  get attributes(): Attributes {
    return this.#state.attributes
  }

  /**
   * Sets values of circles in a column, as JSON texts by id. A column of a new name is added. Resolves to `undefined` if
   * the edit was refused or had no effect.
   */
  setValues(column: string, values: ReadonlyMap<number, string>, gesture?: number): Promise<Edited | undefined> {
    return this.setColumns(new Map([[column, values]]), gesture)
  }

  /** Sets values in several columns at once, like `setValues`. */
  setColumns(
    columns: ReadonlyMap<string, ReadonlyMap<number, string>>,
    gesture = this.beginGesture(),
  ): Promise<Edited | undefined> {
    return this.#ask(async () => {
      if (gesture <= this.#lastFormer || columns.size === 0) return undefined
      let { attributes } = this.#state
      for (const [column, values] of columns) attributes = withValues(attributes, column, values)
      return this.#apply([], gesture, undefined, attributes)
    })
  }

  /**
   * Returns a number that groups the edits of one gesture into one history entry. Once other circles are opened,
   * further edits of the gesture have no effect.
   */
  beginGesture(): number {
    this.#lastGesture += 1
    return this.#lastGesture
  }

  /**
   * Replaces the circles, then applies edits, before any pending request. Undo restores the former circles. Resolves to
   * `undefined` if the circles were refused. Cancels a fit of the former circles.
   */
  async open(scene: CircleSet, edits: readonly Edit[] = []): Promise<Edited | undefined> {
    this.cancelFit()
    let isOpened = false
    const opened = this.#ask(async () => {
      const done = [...this.#state.history.done, ...this.#before()]
      const opened = await this.#replaceScene(scene, { done, undone: [] }, edits.length === 0)
      if (opened === undefined) return undefined
      this.#openings += 1
      isOpened = true
      return opened
    })
    if (edits.length > 0) {
      const gesture = this.beginGesture()
      await this.#ask(async () =>
        isOpened ? this.#apply(edits, gesture, undefined, undefined, scene.colors) : undefined,
      )
    }
    return opened
  }

  /**
   * Applies all edits or none, and a change of the domain, whose areas are in the order of the circles. Resolves to
   * `undefined` if the edits were refused, or if other circles have been opened since the gesture began.
   */
  edit(edits: readonly Edit[], gesture = this.beginGesture(), domain?: Partial<Domain>): Promise<Edited | undefined> {
    const key = domain === undefined ? keyOf(gesture, edits) : `domain,${gesture}`
    const apply = async () => (gesture <= this.#lastFormer ? undefined : this.#apply(edits, gesture, domain))
    return this.#ask(apply, edits, key)
  }

  /** Replaces those circles that are there. A drag may continue after the keyboard removed one of its circles. */
  replace(changes: readonly IdentifiedCircle[], gesture: number): void {
    const there = changes.filter(({ id }) => this.latest(id) !== undefined)
    const edits = there.map(({ id, circle }) => ({ kind: 'replace', id, circle }) as const)
    if (edits.length > 0) this.edit(edits, gesture)
  }

  async #apply(
    edits: readonly Edit[],
    gesture: number,
    change?: Partial<Domain>,
    attributes?: Attributes,
    colors?: string,
  ): Promise<Confirmed | undefined> {
    const before = this.#state
    const domain =
      change === undefined ? before.domain : { ...before.domain, ...change, ...areasById(change.areas, this.circles) }
    const edited = await this.#applyIn(domain, edits, colors)
    if (edited === undefined) return undefined
    const former = { domain: change && before.domain, attributes: attributes && before.attributes }
    const history = record(before.history, edited.back, gesture, former)
    return { edited, change: { history, domain, attributes: attributes ?? before.attributes } }
  }

  /** Applies edits, after which cells have the areas of the domain. Resolves to `undefined` if a fit was canceled. */
  async #applyIn(domain: Domain, edits: readonly Edit[], colors?: string): Promise<Edited | undefined> {
    const change = domainChange(this.domain, domain, colors)
    if (domain.areas === undefined) return this.#backend.edit(edits, change)
    const { circles, shares, withRadii } = fittingAfter(edits, this.circles, domain.areas)
    const fit = await this.#fit(domain, circles, shares)
    return fit && fittedIn(await this.#backend.edit(withRadii(fit.circles), change), fit)
  }

  /**
   * Fits circles to shares of a domain's region. Resolves to `undefined` if the fit was canceled or failed.
   * @throws CircleVoronoiError as `region` and `fitAreas`; Refusal if there is no region or too many circles
   */
  async #fit({ region }: Domain, circles: Float64s, shares: readonly number[]): Promise<MaybeFit | undefined> {
    if (region === undefined) throw new Refusal(ENGLISH_REFUSALS, (words) => words.areasWithoutRegion)
    if (shares.length === 0) return { circles }
    if (shares.length > MOST_FITTED) throw new Refusal(ENGLISH_REFUSALS, (words) => words.tooManyForAreas(MOST_FITTED))
    this.#fitting = new AbortController()
    try {
      return await this.#backend.ask('fit', [circles, shares, region], this.#fitting.signal)
    } finally {
      this.#fitting = undefined
    }
  }

  /** Cancels the fit that is running. Its edit or opening has no effect. Returns false if none is running. */
  cancelFit(): boolean {
    const isFitting = this.#fitting !== undefined
    this.#fitting?.abort()
    return isFitting
  }

  undo(): Promise<Edited | undefined> {
    return this.#step('done', 'undone')
  }

  redo(): Promise<Edited | undefined> {
    return this.#step('undone', 'done')
  }

  /** Reverts the edits of a gesture and forgets them. */
  async cancel(gesture: number): Promise<void> {
    await this.#ask(async () => {
      const last = this.#state.history.done.at(-1)
      if (last?.kind !== 'edits' || last.gesture !== gesture) return undefined
      const back = await this.#goBack('done', 'undone')
      return back && { ...back, change: { ...back.change, history: { ...back.change.history, undone: [] } } }
    })
  }

  #step(from: 'done' | 'undone', to: 'done' | 'undone'): Promise<Edited | undefined> {
    const openings = this.#openings
    // Undo does not revert an opening that was requested later, because the user has not seen it yet.
    return this.#ask(async () => (openings === this.#openings ? this.#goBack(from, to) : undefined))
  }

  /** Applies the newest entry of a side of the history. Its reverse becomes an entry of the other side. */
  async #goBack(from: 'done' | 'undone', to: 'done' | 'undone'): Promise<Confirmed | undefined> {
    const before = this.#state
    const entry = before.history[from].at(-1)
    if (entry === undefined) return undefined
    const historyWith = (others: History[typeof to]): History => ({
      ...EMPTY_HISTORY,
      [from]: before.history[from].slice(0, -1),
      [to]: [...before.history[to], ...others],
    })
    if (entry.kind === 'opening') return this.#replaceScene(entry.scene, historyWith(this.#before()))
    const { domain = before.domain, attributes = before.attributes } = entry
    const steps = entry.steps.unpacked()
    const edited = await this.#applyIn(domain, steps)
    if (edited === undefined) return undefined
    const back = {
      ...entry,
      steps: PackedSteps.of(edited.back),
      domain: entry.domain && before.domain,
      attributes: entry.attributes && before.attributes,
    }
    return { edited, change: { domain, attributes, history: historyWith([back]) } }
  }

  /** `areAll`: no edits follow, so the scene's colors apply to its circles. */
  async #replaceScene(scene: CircleSet, history: History, areAll = true): Promise<Confirmed | undefined> {
    const { circles, kept, domain = NO_DOMAIN, attributes = NO_ATTRIBUTES } = scene
    const count = circles.length / 3
    const shares = areasFor(count, domain.areas)
    const change = domainChange(this.domain, domain, areAll ? scene.colors : undefined)
    const isFitted = domain.areas !== undefined && count > 0
    const fit = isFitted ? await this.#fit(domain, circles, shares ?? Array<number>(count).fill(1)) : { circles }
    if (fit === undefined) return undefined
    const edited = fittedIn(await this.#backend.open(fit.circles, change, kept), fit)
    this.#lastFormer = this.#lastGesture
    const areas = areasById(domain.areas, this.circles)
    const byId = areas === undefined ? domain : { ...domain, ...areas }
    return { edited, change: { scene, colors: edited.colors, domain: byId, attributes, history } }
  }

  /** The entry that restores the current circles; empty before the first opening. */
  #before(): Opening[] {
    const { scene, attributes: current, domain: limits, colors } = this.#state
    if (scene === undefined) return []
    const kept = this.circles.keptIds
    // Animated changes are not recorded.
    if (!this.#isRecorded) return [{ kind: 'opening', scene: { ...scene, kept } }]
    const circles = this.circles.circles()
    const attributes = current === NO_ATTRIBUTES ? undefined : current
    const domain = limits === NO_DOMAIN ? undefined : { ...limits, areas: this.areas }
    const isSameData = attributes === scene.attributes
    const isEdited = scene.isEdited || !isSameData || !isSame(circles, scene.circles)
    return [{ kind: 'opening', scene: { ...scene, circles, kept, isEdited, attributes, domain, colors } }]
  }

  /** Whether the history has edits of the current circles. */
  get #isRecorded(): boolean {
    const { done, undone } = this.#state.history
    return [done, undone].some((side) => side.at(-1)?.kind === 'edits')
  }

  /** The colors of the circles by ascending id; `undefined` if opening the circles anew chooses the same. */
  get colors(): string | undefined {
    const { scene, colors } = this.#state
    return scene?.colors !== undefined || this.#isRecorded ? colors : undefined
  }

  /** Predicts a circle's value after all pending requests, assuming that none is refused. */
  latest(id: number): Circle | undefined {
    const last = this.#jobs.findLast(({ circlesAfter }) => circlesAfter.has(id))
    return last === undefined ? this.circles.get(id) : last.circlesAfter.get(id)
  }

  /** Queues a request. If the newest pending one has the same `key`, the new one replaces it. */
  #ask(run: Job['run'], edits: readonly Edit[] = [], key?: string): Promise<Edited | undefined> {
    const circlesAfter = circlesAfterAll(edits)
    const pending = this.#jobs.length > 1 ? this.#jobs.at(-1) : undefined
    if (key !== undefined && pending?.key === key) Object.assign(pending, { run, circlesAfter })
    else {
      const job = { key, circlesAfter, run }
      const act = () => this.#do(job)
      this.#jobs.push(job)
      this.#newest = this.#newest.then(act, act)
    }
    return this.#newest
  }

  async #do(job: Job): Promise<Edited | undefined> {
    try {
      const { circles: formerCircles } = this
      const { attributes: formerAttributes } = this.#state
      const confirmed = await job.run()
      if (confirmed === undefined) return undefined
      const { edited, change } = confirmed
      const isOpened = this.circles !== formerCircles
      this.#store.update((state) => {
        const colors = edited.colors ?? state.colors
        const next = stateAfter({ ...state, colors, ...change, edited }, this.circles, isOpened)
        return { ...next, history: limited(next.history, this.#mostBytes) }
      })
      const isOther = isOpened || this.attributes !== formerAttributes
      this.#onOutcome({ edited, isOpened, hasNewAttributes: isOther || edited.inserted.length > 0 })
      return edited
    } catch (error) {
      if (!(error instanceof Superseded)) this.#onProblem(error as Error)
      return undefined
    } finally {
      this.#jobs.shift()
    }
  }
}

/** Adds the accuracy and the time of a fit to the result of its edit. */
function fittedIn(edited: Edited, { fitted, seconds = 0 }: MaybeFit): Edited {
  return { ...edited, fitted, seconds: seconds + edited.seconds }
}

/** Edits of one gesture that move the same circles share a key; other edits have none. */
function keyOf(gesture: number, edits: readonly Edit[]): string | undefined {
  const ids = edits.map((edit) => (edit.kind === 'replace' ? edit.id : undefined))
  return ids.includes(undefined) ? undefined : [gesture, ...ids].join()
}

/** The existing circles that edits change, as they are afterwards; `undefined` stands for a removed circle. */
function circlesAfterAll(edits: readonly Edit[]): Map<number, Circle | undefined> {
  const after = new Map<number, Circle | undefined>()
  for (const edit of edits) {
    if (edit.kind !== 'insert') after.set(edit.id, edit.kind === 'replace' ? (edit.circle as Circle) : undefined)
  }
  return after
}

function isSame(circles: Float64Array, others: Float64Array): boolean {
  return circles.length === others.length && circles.every((value, k) => value === others[k])
}
