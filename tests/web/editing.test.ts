// SPDX-License-Identifier: GPL-3.0-or-later

import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { valueIn } from '../../web/editing/attributes.ts'
import { Editing } from '../../web/editing/editing.ts'
import { problemOf } from '../../web/editing/problem.ts'
import { initialState } from '../../web/editing/state.ts'
import type { Circle, Edit } from '../../web/lib/index.ts'
import { Superseded } from '../../web/view/refusal.ts'
import { createStore } from '../../web/view/store.ts'
import { editOf } from './arbitrary-circles.ts'
import { LibraryBackend } from './library-backend.ts'

const TWO = Float64Array.of(0, 0, 1, 5, 5, 2)

/** Editing with an editor of the library as its backend. Each answer arrives a turn later. */
async function started(circles = TWO) {
  const asked: (readonly Edit[])[] = []
  const problems: string[] = []
  const outcomes: number[] = []
  const openings: boolean[] = []
  let failure: string | undefined
  const computer = new LibraryBackend(async () => {
    await new Promise((resolve) => setTimeout(resolve))
    const message = failure
    failure = undefined
    if (message !== undefined) throw new Error(message)
  })
  const edit = computer.edit.bind(computer)
  computer.edit = (edits) => {
    asked.push(edits)
    return edit(edits)
  }
  const editing = new Editing(
    createStore(initialState()),
    computer,
    ({ isOpened }) => {
      outcomes.push(asked.length)
      openings.push(isOpened)
    },
    (error) => problems.push(problemOf(error, editing.scene !== undefined)),
  )
  await editing.open(sceneOf(circles))
  const fail = (message: string) => {
    failure = message
  }
  return {
    editing,
    asked,
    problems,
    outcomes,
    openings,
    fail,
    circles: () => [...editing.circles.circles()],
    editor: () => computer.editor,
  }
}

function sceneOf(circles: Float64Array<ArrayBuffer>, dataSet = 'two') {
  return { circles, dataSet, isEdited: false }
}

function moved(id: number, x: number): Edit[] {
  return [{ kind: 'replace', id, circle: { x, y: 0, r: 1 } }]
}

describe('Editing', () => {
  it('leaves out what of a drag has not begun when more comes', async () => {
    const { editing, asked, circles } = await started()
    const all = Array.from({ length: 50 }, (_, x) => editing.edit(moved(0, x), 5))
    expect(editing.latest(0)?.x).toBe(49)
    await Promise.all(all)
    expect(asked).toEqual([moved(0, 0), moved(0, 49)])
    expect(circles()[0]).toBe(49)
  })

  const add: Edit[] = [{ kind: 'insert', circle: { x: 9, y: 9, r: 1 } }]
  const remove: Edit[] = [{ kind: 'remove', id: 1 }]
  it.each([
    [
      'a drag whose steps do not repeat each other',
      [moved(0, 1), moved(0, 2), moved(1, 2), moved(0, 3), add, add, []],
      [],
    ],
    ['a drag of several circles', [moved(1, 2), [...moved(1, 3), ...moved(0, 3)], moved(0, 4)], []],
    ['a drag in which a circle is removed', [moved(0, 4), remove, moved(0, 5)], []],
    ['two drags at once', [moved(0, 1), moved(0, 2), moved(0, 3)], [2]],
    ['a drag and what comes between its steps', [moved(0, 1), moved(0, 2), moved(1, 3), moved(0, 4)], [2]],
  ] as const)('leaves out nothing of %s', async (_, steps, others) => {
    const { editing, asked } = await started()
    await Promise.all(steps.map((edits, k) => editing.edit(edits, others.some((other) => other === k) ? 6 : 5)))
    expect(asked).toEqual(steps)
  })

  it('says nothing of an edit that another one has superseded', async () => {
    const computer = new LibraryBackend(async () => {})
    const problems: unknown[] = []
    const editing = new Editing(
      createStore(initialState()),
      computer,
      () => {},
      (error) => problems.push(error.message),
    )
    await editing.open(sceneOf(TWO))
    let error: Error = new Superseded()
    computer.edit = () => Promise.reject(error)
    expect(await editing.edit(moved(0, 1))).toBeUndefined()
    expect(problems).toEqual([])
    error = new Error('It failed.')
    expect(await editing.edit(moved(0, 1))).toBeUndefined()
    expect(problems).toEqual(['It failed.'])
  })

  it('says that nothing has changed where what computes has failed', async () => {
    const { editing, problems, outcomes, circles, fail } = await started()
    const before = outcomes.length
    fail('The thread ended.')
    expect(await editing.edit(moved(0, 4))).toBeUndefined()
    expect(problems).toEqual(['The thread ended. Nothing has changed. Try again.'])
    expect([outcomes.length, circles()]).toEqual([before, [...TWO]])
    expect(await editing.edit(moved(0, 4))).toBeDefined()
  })

  it('forgets the oldest steps where its history takes too many bytes, and goes back through the others', async () => {
    const histories: number[] = []
    const ignore = () => {}
    const store = createStore(initialState())
    const record = () => histories.push(store.get().history.done.length)
    const editing = new Editing(store, new LibraryBackend(async () => {}), record, ignore, 5 * 300)
    await editing.open(sceneOf(TWO))
    for (let x = 1; x <= 20; x++) await editing.edit([...moved(0, x), ...moved(1, -x)])
    expect(Math.max(...histories)).toBe(5)
    for (let k = 0; k < 9; k++) await editing.undo()
    expect([...editing.circles.circles()]).toEqual([15, 0, 1, -15, 0, 1])
    for (let k = 0; k < 9; k++) await editing.redo()
    expect([...editing.circles.circles()]).toEqual([20, 0, 1, -20, 0, 1])
  })

  it('reports with each outcome whether other circles were opened', async () => {
    const { editing, openings } = await started()
    await editing.edit(moved(0, 1))
    await editing.open(sceneOf(Float64Array.of(7, 7, 7), 'seven'))
    for (const step of ['undo', 'undo', 'redo', 'redo'] as const) await editing[step]()
    expect(openings).toEqual([true, false, true, true, false, false, true])
  })

  it('has the colors of the last edit that tells any, and none of former circles', async () => {
    const computer = new LibraryBackend(async () => {})
    const { edit } = computer
    let colors: string | undefined = '12'
    computer.edit = async function (edits) {
      return { ...(await edit.call(this, edits)), colors }
    }
    const editing = new Editing(
      createStore(initialState()),
      computer,
      () => {},
      () => expect.unreachable(),
    )
    await editing.open({ ...sceneOf(TWO), colors: '01' })
    await editing.edit(moved(0, 1))
    expect(editing.colors).toBe('12')
    colors = undefined
    await editing.edit(moved(0, 2))
    expect(editing.colors).toBe('12')
    await editing.open(sceneOf(TWO))
    await editing.edit(moved(0, 1))
    expect(editing.colors).toBeUndefined()
    for (let k = 0; k < 2; k++) await editing.undo()
    expect(editing.colors, 'those of the circles that are there again').toBe('12')
  })

  it('goes on with its history where its circles are opened again under their ids', async () => {
    const { editing } = await started()
    await editing.edit([{ kind: 'insert', circle: { x: 9, y: 9, r: 1 } }])
    await editing.edit([{ kind: 'remove', id: 0 }])
    const other = (await started()).editing
    const { circles } = editing
    await other.open({ ...sceneOf(circles.circles().slice()), kept: circles.keptIds })
    other.takeUp(editing.past)
    expect([...other.circles.ids()]).toEqual([1, 2])
    await other.undo()
    expect([...other.circles.circles()]).toEqual([...TWO, 9, 9, 1])
    await other.undo()
    await other.redo()
    await other.redo()
    expect([...other.circles.ids()]).toEqual([1, 2])
    // New gestures differ from those that have begun and from those of the history.
    for (let k = 0; k < 5; k++) other.beginGesture()
    const begun = other.beginGesture()
    other.takeUp(editing.past)
    expect(other.beginGesture()).toBeGreaterThan(begun)
  })

  it('knows that a circle is to go', async () => {
    const { editing } = await started()
    const removed = editing.edit([{ kind: 'remove', id: 0 }])
    expect(editing.latest(0)).toBeUndefined()
    expect(editing.latest(1)).toEqual({ x: 5, y: 5, r: 2 })
    await removed
    expect(editing.latest(0)).toBeUndefined()
  })
})

/** The circles and their names by id that a user sees, in the scene that was opened. */
interface Seen {
  readonly scene: { readonly name: string; next: number; isEdited: boolean; readonly first: string }
  readonly circles: ReadonlyMap<number, Circle>
  readonly names: ReadonlyMap<number, string>
}

const NO_NAMES: ReadonlyMap<number, string> = new Map()

/** A history as it should be: steps with what was before and after them, each of one gesture. */
class Model {
  seen: Seen
  done: { before: Seen; after: Seen; gesture: number }[] = []
  undone: typeof this.done = []
  constructor(circles: readonly Circle[]) {
    this.seen = this.#opened('two', circles)
  }

  #opened(name: string, circles: readonly Circle[]): Seen {
    const scene = { name, next: circles.length, isEdited: false, first: JSON.stringify(circles) }
    return { scene, circles: new Map(circles.entries()), names: NO_NAMES }
  }

  /** Notes whether the circles that are left for those of another scene were edited. */
  #leave({ scene: next }: Seen): void {
    const { scene, circles, names } = this.seen
    const now = [...circles].sort(([a], [b]) => a - b).map(([, circle]) => circle)
    const isEdited = names !== NO_NAMES || JSON.stringify(now) !== scene.first
    if (next !== scene && isEdited) scene.isEdited = true
  }

  #step(after: Seen, gesture: number): void {
    this.#leave(after)
    const last = this.done.at(-1)
    this.undone = []
    if (last?.gesture === gesture && last.after === this.seen) last.after = after
    else this.done.push({ before: this.seen, after, gesture })
    this.seen = after
  }

  /** Returns whether the circles were not refused. */
  open(name: string, circles: readonly Circle[]): boolean {
    const isRight = circles.every(({ r }) => r >= 0)
    if (isRight) this.#step(this.#opened(name, circles), Number.NaN)
    return isRight
  }

  /** Makes all edits or none. */
  edit(edits: readonly Edit[], gesture: number): void {
    const circles = new Map(this.seen.circles)
    let { next } = this.seen.scene
    for (const edit of edits) {
      const isKnown = edit.kind === 'insert' || circles.has(edit.id)
      if (!isKnown || (edit.kind !== 'remove' && (edit.circle as Circle).r < 0)) return
      if (edit.kind === 'insert') circles.set(next++, edit.circle as Circle)
      else if (edit.kind === 'remove') circles.delete(edit.id)
      else circles.set(edit.id, edit.circle as Circle)
    }
    this.seen.scene.next = next
    this.#step({ ...this.seen, circles }, gesture)
  }

  name(id: number, name: string, gesture: number): void {
    this.#step({ ...this.seen, names: new Map(this.seen.names).set(id, name) }, gesture)
  }

  go(from: typeof this.done, to: typeof this.done, side: 'before' | 'after'): void {
    const step = from.pop()
    if (step === undefined) return
    to.push(step)
    this.#leave(step[side])
    this.seen = step[side]
  }

  cancel(gesture: number): void {
    const last = this.done.at(-1)
    if (last?.gesture !== gesture) return
    this.done.pop()
    this.seen = last.before
  }
}

describe('a history', () => {
  const circle = fc.record({
    x: fc.integer({ min: 0, max: 20 }),
    y: fc.nat(20),
    r: fc.constantFrom(0, 1, 2, 0, 1, 2, 3, 4, -1),
  })
  const edit = editOf(circle, fc.nat(4))
  const step = fc.oneof(
    {
      weight: 4,
      arbitrary: fc.record({ edits: fc.array(edit, { minLength: 1, maxLength: 3 }), isSame: fc.boolean() }),
    },
    { weight: 4, arbitrary: fc.constantFrom('undo' as const, 'undo' as const, 'redo' as const, 'cancel' as const) },
    fc.constant('wait' as const),
    { weight: 2, arbitrary: fc.record({ named: fc.nat(2) }) },
    {
      weight: 2,
      arbitrary: fc.record({ open: fc.array(circle, { maxLength: 3 }), edits: fc.array(edit, { maxLength: 1 }) }),
    },
  )

  it('has the circles and names that were there before and after each step, whatever is done, refused, waited for or canceled', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(step, { minLength: 6, maxLength: 25 }), async (steps) => {
        const { editing, problems } = await started()
        const two = [
          { x: 0, y: 0, r: 1 },
          { x: 5, y: 5, r: 2 },
        ]
        const model = new Model(two)
        const asked: Promise<unknown>[] = []
        let gesture = editing.beginGesture()
        const expectSeen = () => {
          const ids = [...editing.circles.ids()]
          expect(ids).toEqual([...model.seen.circles.keys()].sort((a, b) => a - b))
          expect(ids.map((id) => editing.circles.get(id))).toEqual(ids.map((id) => model.seen.circles.get(id)))
          expect(ids.map((id) => valueIn(editing.attributes, 'name', id))).toEqual(
            ids.map((id) => model.seen.names.get(id) ?? ''),
          )
        }
        const check = async () => {
          await Promise.all(asked.splice(0))
          expectSeen()
          const { name, isEdited } = model.seen.scene
          expect(editing.scene).toMatchObject({ dataSet: name, isEdited })
          expect(editing.past.history.done).toHaveLength(model.done.length)
        }
        for (const [k, step] of steps.entries()) {
          if (step === 'wait') await check()
          else if (step === 'undo' || step === 'redo') {
            const [from, to] = step === 'undo' ? [model.done, model.undone] : [model.undone, model.done]
            // Requests are about the former circles until others are there.
            const isOpening = Number.isNaN(from.at(-1)?.gesture)
            if (isOpening) await check()
            asked.push(editing[step]())
            model.go(from, to, step === 'undo' ? 'before' : 'after')
            if (!isOpening) continue
            await check()
            gesture = editing.beginGesture()
          } else if (step === 'cancel') {
            asked.push(editing.cancel(gesture))
            model.cancel(gesture)
          } else if ('open' in step) {
            await check()
            const flat = Float64Array.from(step.open.flatMap(({ x, y, r }) => [x, y, r]))
            await editing.open(sceneOf(flat, `${k}`), step.edits)
            if (model.open(`${k}`, step.open) && step.edits.length > 0) model.edit(step.edits, -k)
            gesture = editing.beginGesture()
          } else if ('named' in step) {
            if (!model.seen.circles.has(step.named)) continue
            asked.push(editing.setValues('name', new Map([[step.named, `"${k}"`]]), gesture))
            model.name(step.named, `"${k}"`, gesture)
          } else {
            if (!step.isSame) gesture = editing.beginGesture()
            asked.push(editing.edit(step.edits, gesture))
            model.edit(step.edits, gesture)
          }
        }
        await check()
        const count = model.done.length
        for (let k = 0; k <= count; k++) await editing.undo()
        expect([...editing.circles.circles()]).toEqual([...TWO])
        for (let k = 0; k < count; k++) await editing.redo()
        expectSeen()
        expect(problems.every((problem) => problem.length > 0)).toBe(true)
      }),
      { numRuns: 60 },
    )
  }, 120_000)
})
