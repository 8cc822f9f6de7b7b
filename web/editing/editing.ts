// SPDX-License-Identifier: GPL-3.0-or-later
import { NewestQueue } from '../lib/base/newest-queue.ts'
import type { Circle, Edit, Float64s } from '../lib/index.ts'
import type { LinkAttributes } from '../lib/link.ts'
import type { CircleTable, KeptIds } from '../view/circle-table.ts'
import { type Areas, type Domain, NO_DOMAIN } from '../view/domain.ts'
import type { DomainChange, Shares } from '../view/protocol.ts'
import { ENGLISH_REFUSALS, Refusal, Superseded } from '../view/refusal.ts'
import type { Edited } from '../view/scene-client.ts'
import { type Attributes, attributesOf, type DataColumn, NO_ATTRIBUTES, numberIn, withValues } from './attributes.ts'
import { type CircleSet, EMPTY_HISTORY, type History, limited, MOST_BYTES, type Opening, record } from './history.ts'
import { namesBy } from './identity.ts'
import { PackedSteps } from './packed-steps.ts'

/** The backend that computes diagrams: a view. */
export interface DiagramBackend {
  /** The current circles. */
  readonly circles: CircleTable
  setCircles(circles: Float64Array, change?: DomainChange, kept?: KeptIds): Promise<Edited>
  apply(edits: readonly Edit[], change?: DomainChange): Promise<Edited>
}

/** The result of a request. */
export interface Outcome {
  readonly edited: Edited
  readonly history: History
  readonly domain: Domain
  /** The attributes of circles, by their ids. */
  readonly attributes: Attributes
  /** Whether the circles were replaced by others. */
  readonly isOpened: boolean
}

/** A history that continues when its circles are opened again under their ids. */
export interface Past {
  readonly history: History
  readonly lastGesture: number
}

interface Job {
  /** Maps circles to their values after an edit; `undefined` removes a circle. */
  readonly made: ReadonlyMap<number, Circle | undefined>
  /** Resolves to `undefined` if there was nothing to do. */
  run(): Promise<Edited | undefined>
}

/**
 * The circles and their history, as confirmed by the backend. A refused edit leaves no trace. Requests run one at a
 * time; a pending step of a drag is replaced by the next one, so that fast drags never queue up.
 */
export class Editing {
  readonly #backend: DiagramBackend
  readonly #onOutcome: (outcome: Outcome) => void
  readonly #onProblem: (error: Error) => void
  #scene: CircleSet | undefined
  #domain = NO_DOMAIN
  #attributes = NO_ATTRIBUTES
  #colors: string | undefined
  #history = EMPTY_HISTORY
  readonly #mostBytes: number
  readonly #queue = new NewestQueue<Job, Edited | undefined>()
  #lastKey: string | undefined
  #lastGesture = 0
  /** The last gesture that began before the current circles were opened. */
  #lastFormer = 0
  /** The number of openings, except by undo and redo. */
  #openings = 0

  /** `mostBytes` limits the memory of the history. */
  constructor(
    backend: DiagramBackend,
    onOutcome: (outcome: Outcome) => void,
    onProblem: (error: Error) => void,
    mostBytes = MOST_BYTES,
  ) {
    this.#backend = backend
    this.#onOutcome = onOutcome
    this.#onProblem = onProblem
    this.#mostBytes = mostBytes
  }

  get circles(): CircleTable {
    return this.#backend.circles
  }

  /** The history, for when the current circles are opened again under their ids. */
  get past(): Past {
    return { history: this.#history, lastGesture: this.#lastGesture }
  }

  /** Continues the history of the circles that were opened, and returns it. */
  takeUp({ history, lastGesture }: Past): History {
    this.#history = history
    this.#lastGesture = Math.max(this.#lastGesture, lastGesture)
    return history
  }

  /**
   * The number of edits and openings that are running or pending. A request counts until its listeners have returned.
   */
  get unfinished(): number {
    return this.#queue.works.length
  }

  /** The opened circles without later edits. */
  get scene(): CircleSet | undefined {
    return this.#scene
  }

  /** The clipping region, and the areas by id. */
  get domain(): Domain {
    return this.#domain
  }

  /** The prescribed areas, in the order of the circles. */
  get areas(): Areas | undefined {
    const { areas } = this.#domain
    if (areas === undefined || areas === 'equal') return areas
    const known = Array.from(this.circles.ids(), (id) => areas[id])
    const named = known.filter((share) => share !== undefined)
    const mean = named.reduce((sum, share) => sum + share, 0) / named.length
    return known.map((share) => share ?? mean)
  }

  /** The attributes of circles, by their ids. */
  get attributes(): Attributes {
    return this.#attributes
  }

  /** The attributes of the current circles, in their order; `undefined` if there are none. */
  get fileAttributes(): LinkAttributes | undefined {
    if (this.#attributes === NO_ATTRIBUTES) return undefined
    return attributesOf(this.#attributes, [...this.circles.ids()])
  }

  /** The name of a circle, or an empty text. */
  nameOf(id: number): string {
    return namesBy(this.#attributes.columns)(id)
  }

  /** The JSON text of a circle's value in a column, empty if the circle has no value. */
  valueOf(id: number, column: string): string {
    return this.#columnOf(column)?.values[id] ?? ''
  }

  /** A column in the order of the circles, with NaN where there is no number. */
  valuesOf(name: string): Float64s {
    const values = this.#columnOf(name)?.values
    return Float64Array.from(this.circles.ids(), (id) => numberIn(values?.[id]))
  }

  #columnOf(name: string): DataColumn | undefined {
    return this.#attributes.columns.find((column) => column.name === name)
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
      let attributes = this.#attributes
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
   * `undefined` if the circles were refused.
   */
  async open(scene: CircleSet, edits: readonly Edit[] = []): Promise<Edited | undefined> {
    let isOpened = false
    const opened = this.#ask(async () => {
      const before = this.#before()
      const edited = await this.#replaceScene(scene, edits.length === 0)
      this.#history = { done: [...this.#history.done, ...before], undone: [] }
      this.#openings += 1
      isOpened = true
      return edited
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

  async #apply(
    edits: readonly Edit[],
    gesture: number,
    change?: Partial<Domain>,
    attributes?: Attributes,
    colors?: string,
  ): Promise<Edited> {
    const before = this.#domain
    const domain = change === undefined ? before : { ...before, ...change, ...this.#byId(change.areas) }
    const edited = await this.#backend.apply(edits, this.#changeTo(domain, this.#sharesOf(domain, edits), colors))
    const former = { domain: change && before, attributes: attributes && this.#attributes }
    this.#history = record(this.#history, edited.back, gesture, former)
    this.#domain = domain
    this.#attributes = attributes ?? this.#attributes
    return edited
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
      const last = this.#history.done.at(-1)
      if (last?.kind !== 'edits' || last.gesture !== gesture) return undefined
      const edited = await this.#goBack('done', 'undone')
      this.#history = { done: this.#history.done, undone: [] }
      return edited
    })
  }

  #step(from: 'done' | 'undone', to: 'done' | 'undone'): Promise<Edited | undefined> {
    const openings = this.#openings
    // Undo does not revert an opening that was requested later, because the user has not seen it yet.
    return this.#ask(async () => (openings === this.#openings ? this.#goBack(from, to) : undefined))
  }

  async #goBack(from: 'done' | 'undone', to: 'done' | 'undone'): Promise<Edited | undefined> {
    const entry = this.#history[from].at(-1)
    if (entry === undefined) return undefined
    if (entry.kind === 'opening') return this.#openAgain(entry, from, to)
    const before = this.#domain
    const { domain = before } = entry
    const steps = entry.steps.unpacked()
    const change = this.#changeTo(domain, this.#sharesOf(domain, steps))
    const edited = await this.#backend.apply(steps, change)
    this.#domain = domain
    const attributes = this.#attributes
    this.#attributes = entry.attributes ?? attributes
    const back = {
      ...entry,
      steps: PackedSteps.of(edited.back),
      domain: entry.domain && before,
      attributes: entry.attributes && attributes,
    }
    this.#history = {
      ...this.#history,
      [from]: this.#history[from].slice(0, -1),
      [to]: [...this.#history[to], back],
    } as History
    return edited
  }

  async #openAgain(entry: Opening, from: 'done' | 'undone', to: 'done' | 'undone'): Promise<Edited> {
    const before = this.#before()
    const edited = await this.#replaceScene(entry.scene)
    this.#history = {
      ...EMPTY_HISTORY,
      [from]: this.#history[from].slice(0, -1),
      [to]: [...this.#history[to], ...before],
    }
    return edited
  }

  /** `areAll`: no edits follow, so the scene's colors apply to its circles. */
  async #replaceScene(scene: CircleSet, areAll = true): Promise<Edited> {
    const { circles, kept, domain = NO_DOMAIN } = scene
    const list = listIn(domain.areas)
    if (list !== undefined) checkCount(list, circles.length / 3)
    const shares = { known: list && new Map(list.map((share, k) => [kept?.ids[k] ?? k, share])), inserted: [] }
    const edited = await this.#backend.setCircles(
      circles,
      this.#changeTo(domain, shares, areAll ? scene.colors : undefined),
      kept,
    )
    this.#scene = scene
    this.#colors = edited.colors
    this.#domain = list === undefined ? domain : { ...domain, ...this.#byId(list) }
    this.#attributes = scene.attributes ?? NO_ATTRIBUTES
    this.#lastFormer = this.#lastGesture
    return edited
  }

  /** Converts areas from the order of the circles to ids. */
  #byId(areas: Areas | undefined): Pick<Domain, 'areas'> | undefined {
    const list = listIn(areas)
    if (list === undefined) return undefined
    checkCount(list, this.circles.count)
    const byId: number[] = []
    this.circles.ids().forEach((id, k) => {
      byId[id] = list[k] as number
    })
    return { areas: byId }
  }

  /** The change of domain for the backend. It contains the region only if the region differs. */
  #changeTo(domain: Domain, fit: Shares, colors?: string): DomainChange | undefined {
    const { region, lattice, areas } = domain
    if (domain === NO_DOMAIN && this.#domain === NO_DOMAIN) return colors === undefined ? undefined : { colors }
    return {
      region: region === this.#domain.region ? undefined : (region ?? null),
      lattice: lattice === this.#domain.lattice ? undefined : (lattice ?? null),
      areSites: areas !== undefined,
      fit: areas && fit,
      colors,
    }
  }

  /** The areas of the current circles and of the circles that edits insert. */
  #sharesOf({ areas }: Domain, edits: readonly Edit[]): Shares {
    const list = listIn(areas)
    if (list === undefined) return { known: undefined, inserted: [] }
    const shareOf = (id: number | undefined) => (id === undefined ? undefined : list[id]) ?? Number.NaN
    return {
      known: new Map(Array.from(this.circles.ids(), (id) => [id, shareOf(id)])),
      inserted: edits.flatMap((edit) => (edit.kind === 'insert' ? [shareOf(edit.id)] : [])),
    }
  }

  /** The entry that restores the current circles; empty before the first opening. */
  #before(): Opening[] {
    if (this.#scene === undefined) return []
    const kept = this.circles.keptIds
    // Animated changes are not recorded.
    if (!this.#isRecorded) return [{ kind: 'opening', scene: { ...this.#scene, kept } }]
    const circles = this.circles.circles()
    const attributes = this.#attributes === NO_ATTRIBUTES ? undefined : this.#attributes
    const domain = this.#domain === NO_DOMAIN ? undefined : { ...this.#domain, areas: this.areas }
    const isSameData = attributes === this.#scene.attributes
    const isEdited = this.#scene.isEdited || !isSameData || !isSame(circles, this.#scene.circles)
    const scene = { ...this.#scene, circles, kept, isEdited, attributes, domain, colors: this.#colors }
    return [{ kind: 'opening', scene }]
  }

  /** Whether the history has edits of the current circles. */
  get #isRecorded(): boolean {
    return [this.#history.done, this.#history.undone].some((side) => side.at(-1)?.kind === 'edits')
  }

  /** The colors of the circles by ascending id; `undefined` if opening the circles anew chooses the same. */
  get colors(): string | undefined {
    return this.#scene?.colors !== undefined || this.#isRecorded ? this.#colors : undefined
  }

  /** Predicts a circle's value after all pending requests, assuming that none is refused. */
  latest(id: number): Circle | undefined {
    const last = this.#queue.works.findLast(({ made }) => made.has(id))
    return last === undefined ? this.circles.get(id) : last.made.get(id)
  }

  /** A new request replaces a pending one with the same `key`. Requests without a key are never replaced. */
  #ask(run: () => Promise<Edited | undefined>, edits: readonly Edit[] = [], key?: string): Promise<Edited | undefined> {
    // A pending request may be replaced by the same gesture, but not by a later one.
    if (key !== this.#lastKey) this.#queue.settle()
    this.#lastKey = key
    const answer = this.#queue.add({ made: madeBy(edits), run }, key)
    this.#queue.drain((job) => this.#do(job))
    return answer
  }

  async #do(job: Job): Promise<Edited | undefined> {
    try {
      const before = this.circles
      const edited = await job.run()
      this.#colors = edited?.colors ?? this.#colors
      this.#history = limited(this.#history, this.#mostBytes)
      if (edited !== undefined) {
        const { domain, attributes } = this
        this.#onOutcome({ edited, history: this.#history, domain, attributes, isOpened: this.circles !== before })
      }
      return edited
    } catch (error) {
      if (error instanceof Superseded) return undefined
      if (!(error instanceof Error)) throw error
      this.#onProblem(error)
      return undefined
    }
  }
}

/** Edits of one gesture that move the same circles share a key; other edits have none. */
function keyOf(gesture: number, edits: readonly Edit[]): string | undefined {
  const ids = edits.map((edit) => (edit.kind === 'replace' ? edit.id : undefined))
  return ids.includes(undefined) ? undefined : [gesture, ...ids].join()
}

function madeBy(edits: readonly Edit[]): Map<number, Circle | undefined> {
  const made = new Map<number, Circle | undefined>()
  for (const edit of edits) {
    if (edit.kind !== 'insert') made.set(edit.id, edit.kind === 'replace' ? (edit.circle as Circle) : undefined)
  }
  return made
}

function listIn(areas: Areas | undefined): readonly number[] | undefined {
  return areas === 'equal' ? undefined : areas
}

/** @throws Refusal */
function checkCount({ length }: readonly number[], circles: number): void {
  if (length !== circles) throw new Refusal(ENGLISH_REFUSALS, (words) => words.areasForCircles(length, circles))
}

function isSame(circles: Float64Array, others: Float64Array): boolean {
  return circles.length === others.length && circles.every((value, k) => value === others[k])
}
