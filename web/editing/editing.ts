// SPDX-License-Identifier: GPL-3.0-or-later
import { NewestQueue } from '../lib/base/newest-queue.ts'
import type { Circle, Edit } from '../lib/index.ts'
import type { CircleTable, Step } from '../view/circle-table.ts'
import type { Edited } from '../view/painter.ts'
import { EMPTY_HISTORY, type History, idsOnceOpened, type Opening, record, renamed, type Scene } from './history.ts'

/** Who computes: a view. */
export interface Computer {
  /** The circles as they are. */
  readonly circles: CircleTable
  setCircles(circles: Float64Array): Promise<Edited>
  apply(edits: readonly Edit[]): Promise<Edited>
}

/** What became of what was asked. */
export interface Outcome {
  readonly edited: Edited
  readonly history: History
  /** Whether the circles are other ones than before, with ids of their own. */
  readonly isOpened: boolean
}

interface Job {
  /** What it makes of circles that are there; `undefined`: it removes them. */
  readonly made: ReadonlyMap<number, Circle | undefined>
  /** `undefined`: there was nothing to do. */
  run(): Promise<Edited | undefined>
}

/**
 * The circles and their history, as the computer has confirmed them: what it refuses has never been. One thing at a time is
 * asked of it; what of a drag has not begun gives way to what comes after, so that a fast one never queues up.
 */
export class Editing {
  readonly #computer: Computer
  readonly #onOutcome: (outcome: Outcome) => void
  readonly #onProblem: (error: Error) => void
  #scene: Scene | undefined
  /** Where they are not the same: the ids by the numbers of circles, and the numbers by the ids. */
  readonly #ids = new Map<number, number>()
  readonly #numbers = new Map<number, number>()
  #lastAbsent = 0
  #history = EMPTY_HISTORY
  readonly #queue = new NewestQueue<Job, Edited | undefined>()
  #lastKey: string | undefined
  #lastGesture = 0

  constructor(computer: Computer, onOutcome: (outcome: Outcome) => void, onProblem: (error: Error) => void) {
    this.#computer = computer
    this.#onOutcome = onOutcome
    this.#onProblem = onProblem
  }

  get circles(): CircleTable {
    return this.#computer.circles
  }

  /** What was opened: the circles as they were then. */
  get scene(): Scene | undefined {
    return this.#scene
  }

  /** The id of a circle by its number: the id that it had first. One that comes back by undo has another id. */
  idOf(number: number): number {
    return this.#ids.get(number) ?? number
  }

  /** The number of a circle, which stays the same when it comes back by undo. */
  numberOf(id: number): number {
    return this.#numbers.get(id) ?? id
  }

  /** What a circle is called, if it is called anything. */
  nameOf(id: number): string {
    return this.#scene?.names?.[this.numberOf(id)] ?? ''
  }

  #rename(formerId: number, id: number): void {
    const number = this.numberOf(formerId)
    this.#ids.set(number, id)
    this.#numbers.set(id, number)
  }

  /** A number for the edits of one gesture: they become one entry of the history. */
  beginGesture(): number {
    this.#lastGesture += 1
    return this.#lastGesture
  }

  /** Other circles, and edits of them, before anything else is asked. Undo goes back to those that were there. `undefined`: refused. */
  async open(scene: Scene, edits: readonly Edit[] = []): Promise<Edited | undefined> {
    let isOpened = false
    const opened = this.#ask(-1, [], async () => {
      const before = this.#before()
      const edited = await this.#become(scene)
      this.#history = { done: [...this.#history.done, ...before], undone: [] }
      isOpened = true
      return edited
    })
    if (edits.length > 0) {
      const gesture = this.beginGesture()
      await this.#ask(gesture, [], async () => (isOpened ? this.#apply(edits, gesture) : undefined))
    }
    return opened
  }

  /** All or none of the edits. `undefined`: refused. */
  edit(edits: readonly Edit[], gesture = this.beginGesture()): Promise<Edited | undefined> {
    return this.#ask(gesture, edits, () => this.#apply(edits, gesture))
  }

  async #apply(edits: readonly Edit[], gesture: number): Promise<Edited> {
    const edited = await this.#computer.apply(edits)
    this.#history = record(this.#history, edited.back, gesture)
    return edited
  }

  undo(): Promise<Edited | undefined> {
    return this.#step('done', 'undone')
  }

  redo(): Promise<Edited | undefined> {
    return this.#step('undone', 'done')
  }

  /** Takes back what a gesture has done, for good. */
  async cancel(gesture: number): Promise<void> {
    await this.#ask(-1, [], async () => {
      const last = this.#history.done.at(-1)
      if (last?.kind !== 'edits' || last.gesture !== gesture) return undefined
      const edited = await this.#goBack('done', 'undone')
      this.#history = { done: this.#history.done, undone: [] }
      return edited
    })
  }

  #step(from: 'done' | 'undone', to: 'done' | 'undone'): Promise<Edited | undefined> {
    return this.#ask(-1, [], () => this.#goBack(from, to))
  }

  async #goBack(from: 'done' | 'undone', to: 'done' | 'undone'): Promise<Edited | undefined> {
    const entry = this.#history[from].at(-1)
    if (entry === undefined) return undefined
    if (entry.kind === 'opening') return this.#openAgain(entry, from, to)
    const edited = await this.#computer.apply(entry.steps.map(plain))
    const former = entry.steps.flatMap((step) => (step.kind === 'insert' ? [step.formerId] : []))
    const ids = new Map(former.flatMap((id, k) => (id === undefined ? [] : [[id, edited.inserted[k] as number]])))
    for (const [formerId, id] of ids) this.#rename(formerId, id)
    const back = { ...entry, steps: edited.back }
    const history = {
      ...this.#history,
      [from]: this.#history[from].slice(0, -1),
      [to]: [...this.#history[to], back],
    } as History
    this.#history = ids.size === 0 ? history : renamed(history, (id) => ids.get(id) ?? id)
    return edited
  }

  async #openAgain({ scene, ids }: Opening, from: 'done' | 'undone', to: 'done' | 'undone'): Promise<Edited> {
    const before = this.#before()
    const edited = await this.#become(scene)
    const left = this.#history[from].slice(0, -1)
    const others = this.#history[to]
    const idOf = idsOnceOpened(ids, () => --this.#lastAbsent)
    // What is on the other side is about the circles that go.
    const kept = renamed({ ...EMPTY_HISTORY, [from]: left }, idOf)[from]
    this.#history = { ...EMPTY_HISTORY, [from]: kept, [to]: [...others, ...before] }
    return edited
  }

  async #become(scene: Scene): Promise<Edited> {
    const edited = await this.#computer.setCircles(scene.circles)
    this.#scene = scene
    this.#ids.clear()
    this.#numbers.clear()
    return edited
  }

  /** What goes back to the circles as they are; nothing before the first ones. */
  #before(): Opening[] {
    if (this.#scene === undefined) return []
    const { dataSet, isEdited } = this.#scene
    const circles = this.circles.circles()
    const ids = this.circles.ids()
    const names = this.#scene.names && Array.from(ids, (id) => this.nameOf(id))
    const scene = { circles, dataSet, isEdited: isEdited || !isSame(circles, this.#scene.circles), names }
    return [{ kind: 'opening', scene, ids }]
  }

  /** A circle as it will be once all that was asked is done, if nothing is refused. */
  latest(id: number): Circle | undefined {
    const last = this.#queue.works.findLast(({ made }) => made.has(id))
    return last === undefined ? this.circles.get(id) : last.made.get(id)
  }

  #ask(gesture: number, edits: readonly Edit[], run: () => Promise<Edited | undefined>): Promise<Edited | undefined> {
    const key = keyOf(gesture, edits)
    // What has not begun gives way to what the same gesture does next, and not to what comes later.
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
      if (edited !== undefined) {
        this.#onOutcome({ edited, history: this.#history, isOpened: this.circles !== before })
      }
      return edited
    } catch (error) {
      if (!(error instanceof Error)) throw error
      this.#onProblem(error)
      return undefined
    }
  }
}

/** Edits that put the same circles somewhere else in one gesture have one key; others have none. */
function keyOf(gesture: number, edits: readonly Edit[]): string | undefined {
  const ids = edits.map((edit) => (edit.kind === 'replace' ? edit.id : undefined))
  return ids.length === 0 || ids.includes(undefined) ? undefined : [gesture, ...ids].join()
}

function madeBy(edits: readonly Edit[]): Map<number, Circle | undefined> {
  const made = new Map<number, Circle | undefined>()
  for (const edit of edits) {
    if (edit.kind !== 'insert') made.set(edit.id, edit.kind === 'replace' ? (edit.circle as Circle) : undefined)
  }
  return made
}

function plain(step: Step): Edit {
  return step.kind === 'insert' ? { kind: 'insert', circle: step.circle } : step
}

function isSame(circles: Float64Array, others: Float64Array): boolean {
  return circles.length === others.length && circles.every((value, k) => value === others[k])
}
