// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { NO_ATTRIBUTES, namedAs } from '../../web/editing/attributes.ts'
import { type DiagramBackend, Editing, type Outcome } from '../../web/editing/editing.ts'
import { EMPTY_HISTORY } from '../../web/editing/history.ts'
import { problemOf } from '../../web/editing/problem.ts'
import { INITIAL_STATE, stateAfter } from '../../web/editing/state.ts'
import type { Circle, Edit } from '../../web/lib/index.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { NO_DOMAIN } from '../../web/view/domain.ts'
import { Superseded } from '../../web/view/refusal.ts'
import { LibraryBackend } from './library-backend.ts'

const TWO = Float64Array.of(0, 0, 1, 5, 5, 2)

it('what is selected stays after an edit if it is there, and not after other circles were opened', () => {
  const circles = new CircleTable(TWO.slice())
  const state = { ...INITIAL_STATE, selection: [1, 7], selected: undefined, problem: 'wrong', hovered: 1 }
  const outcome = {
    edited: undefined,
    history: EMPTY_HISTORY,
    domain: NO_DOMAIN,
    isOpened: false,
  } as unknown as Outcome
  const edited = stateAfter(state, outcome, circles)
  expect([edited.selection, edited.selected, edited.circle]).toEqual([[1], 1, { x: 5, y: 5, r: 2 }])
  expect([edited.problem, edited.hovered]).toEqual(['', 1])
  const opened = stateAfter({ ...state, described: {} as never }, { ...outcome, isOpened: true }, circles)
  expect([opened.selection, opened.problem, opened.hovered, opened.described]).toEqual([[], '', undefined, undefined])
})

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
  const apply = computer.apply.bind(computer)
  computer.apply = (edits) => {
    asked.push(edits)
    return apply(edits)
  }
  const editing = new Editing(
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
  it('makes one step of undo of the edits of one gesture', async () => {
    const { editing, circles } = await started()
    for (const x of [1, 2, 3]) await editing.edit(moved(0, x), 7)
    expect(circles()).toEqual([3, 0, 1, 5, 5, 2])
    await editing.undo()
    expect(circles()).toEqual([...TWO])
    await editing.redo()
    expect(circles()).toEqual([3, 0, 1, 5, 5, 2])
  })

  it('keeps the steps of two gestures apart', async () => {
    const { editing, circles } = await started()
    await editing.edit(moved(0, 1))
    await editing.edit(moved(0, 2))
    await editing.undo()
    expect(circles()).toEqual([1, 0, 1, 5, 5, 2])
  })

  it('undoes twice and does both again', async () => {
    const { editing, circles } = await started()
    await editing.edit(moved(0, 1))
    await editing.edit([{ kind: 'remove', id: 1 }])
    const both = circles()
    await editing.undo()
    await editing.undo()
    expect(circles()).toEqual([...TWO])
    await editing.redo()
    await editing.redo()
    expect(circles()).toEqual(both)
  })

  it('makes one step of adding a circle and dragging its rim', async () => {
    const { editing, circles } = await started()
    const edited = await editing.edit([{ kind: 'insert', circle: { x: 9, y: 9, r: 0 } }], 3)
    const id = edited?.inserted[0] as number
    await editing.edit([{ kind: 'replace', id, circle: { x: 9, y: 9, r: 3 } }], 3)
    expect(circles()).toEqual([...TWO, 9, 9, 3])
    await editing.undo()
    expect(circles()).toEqual([...TWO])
  })

  it('follows a batch in which a circle comes and goes', async () => {
    const { editing, circles, editor } = await started()
    const insert = (x: number): Edit => ({ kind: 'insert', circle: { x, y: 9, r: 1 } })
    const edited = await editing.edit([insert(20), insert(30), { kind: 'remove', id: 2 }, ...moved(3, 40)])
    expect([...(edited?.inserted ?? [])]).toEqual([3])
    expect(circles()).toEqual([...TWO, 40, 0, 1])
    expect([...editing.circles.ids()]).toEqual([...editor().ids()])
    await editing.undo()
    expect(circles()).toEqual([...TWO])
    await editing.redo()
    expect(circles()).toEqual([...TWO, 40, 0, 1])
    expect([...editing.circles.ids()]).toEqual([...editor().ids()])
  })

  it('finds a circle that came back', async () => {
    const { editing, circles } = await started()
    await editing.edit(moved(0, 4))
    await editing.edit([{ kind: 'remove', id: 0 }])
    await editing.undo()
    await editing.undo()
    expect(circles()).toEqual([...TWO])
    await editing.redo()
    await editing.redo()
    expect(circles()).toEqual([5, 5, 2])
  })

  it('forgets what was undone at the next edit', async () => {
    const { editing, circles } = await started()
    await editing.edit(moved(0, 1))
    await editing.undo()
    await editing.edit(moved(1, 2))
    await editing.redo()
    expect(circles()).toEqual([0, 0, 1, 2, 0, 1])
  })

  it('does nothing where there is nothing to undo or to do again', async () => {
    const { editing, asked, outcomes, circles } = await started()
    await editing.undo()
    await editing.redo()
    expect(asked).toEqual([])
    expect(circles()).toEqual([...TWO])
    expect(outcomes).toHaveLength(1)
  })

  it('leaves out what of a drag has not begun when more comes', async () => {
    const { editing, asked, circles } = await started()
    const all = Array.from({ length: 50 }, (_, x) => editing.edit(moved(0, x), 5))
    expect(editing.latest(0)?.x).toBe(49)
    await Promise.all(all)
    expect(asked).toEqual([moved(0, 0), moved(0, 49)])
    expect(circles()[0]).toBe(49)
  })

  it('leaves out no edit of a drag that the next one does not repeat', async () => {
    const { editing, asked } = await started()
    const add: Edit[] = [{ kind: 'insert', circle: { x: 9, y: 9, r: 1 } }]
    const drag = [moved(0, 1), moved(0, 2), moved(1, 2), [...moved(1, 3), ...moved(0, 3)], add, add, []]
    await Promise.all(drag.map((edits) => editing.edit(edits, 5)))
    expect(asked).toEqual(drag)
    const remove: Edit[] = [{ kind: 'remove', id: 1 }]
    await Promise.all([moved(0, 4), remove, moved(0, 5)].map((edits) => editing.edit(edits, 6)))
    expect(asked.slice(drag.length)).toEqual([moved(0, 4), remove, moved(0, 5)])
  })

  it('keeps what of two drags waits at once', async () => {
    const { editing, asked } = await started()
    await Promise.all([editing.edit(moved(0, 1), 5), editing.edit(moved(0, 2), 5), editing.edit(moved(0, 3), 6)])
    expect(asked).toEqual([moved(0, 1), moved(0, 2), moved(0, 3)])
  })

  it('keeps the order of a drag and of what comes between its steps', async () => {
    const { editing, asked } = await started()
    const steps = [moved(0, 1), moved(0, 2), moved(1, 3), moved(0, 4)]
    await Promise.all(steps.map((edits, k) => editing.edit(edits, k === 2 ? 6 : 5)))
    expect(asked).toEqual(steps)
  })

  it('says nothing of an edit that another one has superseded', async () => {
    const computer = new LibraryBackend(async () => {})
    const problems: unknown[] = []
    const editing = new Editing(
      computer,
      () => {},
      (error) => problems.push(error.message),
    )
    await editing.open(sceneOf(TWO))
    let error: Error = new Superseded()
    computer.apply = () => Promise.reject(error)
    expect(await editing.edit(moved(0, 1))).toBeUndefined()
    expect(problems).toEqual([])
    error = new Error('It failed.')
    expect(await editing.edit(moved(0, 1))).toBeUndefined()
    expect(problems).toEqual(['It failed.'])
  })

  it('refuses areas that are not as many as circles', async () => {
    const { editing, problems, circles } = await started()
    const before = circles()
    const domain = { region: undefined, areas: [1, 2, 3] }
    expect(await editing.open({ ...sceneOf(TWO), domain })).toBeUndefined()
    expect(await editing.edit([], editing.beginGesture(), domain)).toBeUndefined()
    expect([circles(), editing.areas, problems.length, problems[0]]).toEqual([
      before,
      undefined,
      2,
      expect.stringMatching(/3.* 2/),
    ])
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

  it('knows whether the circles that one goes back to are those of their data set', async () => {
    const { editing } = await started()
    await editing.open(sceneOf(Float64Array.of(7, 7, 7), 'seven'))
    await editing.undo()
    expect(editing.scene).toEqual({ circles: TWO, dataSet: 'two', isEdited: false })
    await editing.edit([{ kind: 'insert', circle: { x: 9, y: 9, r: 1 } }])
    await editing.open(sceneOf(Float64Array.of(7, 7, 7), 'seven'))
    await editing.undo()
    expect(editing.scene?.isEdited).toBe(true)
  })

  it('edits what it opens before anything else that is asked', async () => {
    const { editing, circles } = await started()
    const first = editing.open(sceneOf(Float64Array.of(7, 7, 7, 8, 8, 1), 'seven'), [{ kind: 'remove', id: 0 }])
    const second = editing.open(sceneOf(Float64Array.of(1, 1, 1, 2, 2, 2, 3, 3, 3), 'six'))
    expect([await first, await second]).not.toContain(undefined)
    expect(circles()).toEqual([1, 1, 1, 2, 2, 2, 3, 3, 3])
    await editing.undo()
    expect(circles()).toEqual([8, 8, 1])
    await editing.undo()
    expect(circles()).toEqual([7, 7, 7, 8, 8, 1])
  })

  it('forgets the oldest steps where its history takes too many bytes, and goes back through the others', async () => {
    const histories: number[] = []
    const ignore = () => {}
    const record = ({ history }: Outcome) => histories.push(history.done.length)
    const editing = new Editing(new LibraryBackend(async () => {}), record, ignore, 5 * 300)
    await editing.open(sceneOf(TWO))
    for (let x = 1; x <= 20; x++) await editing.edit([...moved(0, x), ...moved(1, -x)])
    expect(Math.max(...histories)).toBe(5)
    for (let k = 0; k < 9; k++) await editing.undo()
    expect([...editing.circles.circles()]).toEqual([15, 0, 1, -15, 0, 1])
    for (let k = 0; k < 9; k++) await editing.redo()
    expect([...editing.circles.circles()]).toEqual([20, 0, 1, -20, 0, 1])
  })

  it('has nothing to redo once other circles are opened', async () => {
    const { editing, circles, problems } = await started()
    await editing.edit(moved(0, 1))
    await editing.undo()
    await editing.open(sceneOf(Float64Array.of(7, 7, 7), 'seven'))
    expect(await editing.redo()).toBeUndefined()
    expect([circles(), problems]).toEqual([[7, 7, 7], []])
  })

  it('reports with each outcome whether other circles were opened', async () => {
    const { editing, openings } = await started()
    await editing.edit(moved(0, 1))
    await editing.open(sceneOf(Float64Array.of(7, 7, 7), 'seven'))
    for (const step of ['undo', 'undo', 'redo', 'redo'] as const) await editing[step]()
    expect(openings).toEqual([true, false, true, true, false, false, true])
  })

  it('keeps names and columns with their circles; an added circle has none', async () => {
    const { editing } = await started()
    expect([[...editing.valuesOf('height')], editing.nameOf(0)]).toEqual([[Number.NaN, Number.NaN], ''])
    const { columns } = namedAs(['one', 'two'])
    const attributes = { ...NO_ATTRIBUTES, columns: [{ name: 'height', values: ['3', '4'] }, ...columns] }
    await editing.open({ ...sceneOf(TWO), attributes })
    await editing.edit([{ kind: 'remove', id: 0 }])
    await editing.undo()
    await editing.edit([{ kind: 'insert', circle: { x: 9, y: 9, r: 1 } }])
    expect(Array.from(editing.circles.ids(), (id) => editing.nameOf(id))).toEqual(['one', 'two', ''])
    expect([...editing.valuesOf('height')]).toEqual([3, 4, Number.NaN])
    expect([...editing.valuesOf('width')]).toEqual(Array(3).fill(Number.NaN))
  })

  it('has no names and no columns before circles are opened', () => {
    const computer = new LibraryBackend(async () => {})
    const ignore = () => {}
    const editing = new Editing(computer, ignore, ignore)
    expect([editing.valuesOf('height'), editing.nameOf(0)]).toEqual([new Float64Array(), ''])
  })

  it('edits nothing where what it opens is refused', async () => {
    const { editing, circles, asked } = await started()
    expect(await editing.open(sceneOf(Float64Array.of(0, 0, -1)), [{ kind: 'remove', id: 0 }])).toBeUndefined()
    expect([circles(), asked]).toEqual([[...TWO], []])
  })

  it('passes on the colors of circles once all of them are there', async () => {
    const given: unknown[] = []
    const computer = new LibraryBackend(async () => {})
    const backend: DiagramBackend = {
      get circles() {
        return computer.circles
      },
      setCircles(circles, change, kept) {
        given.push(['setCircles', change?.colors])
        return computer.setCircles(circles, change, kept)
      },
      apply(edits, change) {
        given.push(['apply', change?.colors])
        return computer.apply(edits)
      },
    }
    const editing = new Editing(
      backend,
      () => {},
      () => expect.unreachable(),
    )
    const colored = { ...sceneOf(TWO), colors: '01' }
    await editing.open(colored)
    expect(given.splice(0)).toEqual([['setCircles', '01']])
    expect([editing.colors, editing.fileAttributes]).toEqual(['01', undefined])
    await editing.open(colored, moved(0, 3))
    expect(given).toEqual([
      ['setCircles', undefined],
      ['apply', '01'],
    ])
  })

  it('has the colors of the last edit that tells any, and none of former circles', async () => {
    const computer = new LibraryBackend(async () => {})
    const { apply } = computer
    let colors: string | undefined = '12'
    computer.apply = async function (edits) {
      return { ...(await apply.call(this, edits)), colors }
    }
    const editing = new Editing(
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

  it('ends a gesture and an undo that were begun before other circles were opened', async () => {
    const { editing, circles } = await started()
    const gesture = editing.beginGesture()
    await editing.edit(moved(0, 1), gesture)
    const opened = editing.open(sceneOf(Float64Array.of(7, 7, 7, 9, 9, 1)))
    const undone = editing.undo()
    await opened
    await undone
    expect(circles(), 'the opening has not been seen').toEqual([7, 7, 7, 9, 9, 1])
    expect(await editing.edit(moved(0, 3), gesture)).toBeUndefined()
    expect(await editing.setValues('name', new Map([[0, '"A"']]), gesture)).toBeUndefined()
    expect([circles(), editing.nameOf(0)]).toEqual([[7, 7, 7, 9, 9, 1], ''])
    await editing.edit(moved(0, 3))
    expect(circles()[0]).toBe(3)
  })

  it('calls a circle that came back by the id that it had, also after other circles were opened', async () => {
    const { editing } = await started()
    const insertion = { kind: 'insert', circle: { x: 9, y: 9, r: 1 } } as const
    for (let k = 0; k < 2; k++) {
      await editing.edit([{ kind: 'remove', id: 1 }])
      await editing.undo()
    }
    expect(editing.circles.get(1)).toEqual({ x: 5, y: 5, r: 2 })
    await editing.edit([insertion, { kind: 'remove', id: 0 }])
    await editing.open(sceneOf(TWO))
    expect([...editing.circles.ids()]).toEqual([0, 1])
    await editing.undo()
    expect([...editing.circles.ids()]).toEqual([1, 2])
    await editing.undo()
    expect([...editing.circles.circles()]).toEqual([...TWO])
    await editing.edit([insertion])
    expect([...editing.circles.ids()]).toEqual([0, 1, 3])
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

  it('has what is refused never have been, and keeps what comes after', async () => {
    const { editing, problems, circles } = await started()
    const refused = editing.edit([{ kind: 'replace', id: 0, circle: { x: 0, y: 0, r: -1 } }])
    const good = editing.edit(moved(1, 3))
    expect(await refused).toBeUndefined()
    expect(await good).toBeDefined()
    expect(problems).toEqual([expect.stringMatching(/Circle 0 .*radius/)])
    expect(circles()).toEqual([0, 0, 1, 3, 0, 1])
    await editing.undo()
    expect(circles()).toEqual([...TWO])
  })

  it('goes back to what was before a gesture that is canceled, and there is nothing to do again', async () => {
    const { editing, circles, problems } = await started()
    await editing.edit(moved(1, 8))
    editing.edit(moved(0, 1), 9)
    editing.edit(moved(0, 2), 9)
    await editing.cancel(9)
    expect(circles()).toEqual([0, 0, 1, 8, 0, 1])
    expect(await editing.redo()).toBeUndefined()
    expect([circles(), problems]).toEqual([[0, 0, 1, 8, 0, 1], []])
  })

  it('knows of circles that it goes back to whether they were edited', async () => {
    for (const isOpenedEdited of [false, true]) {
      for (const isEdited of [false, true]) {
        const { editing } = await started()
        await editing.open({ ...sceneOf(TWO), isEdited: isOpenedEdited })
        if (isEdited) await editing.edit(moved(0, 1))
        await editing.open(sceneOf(Float64Array.of(7, 7, 7), 'seven'))
        await editing.undo()
        expect(editing.scene).toMatchObject({ dataSet: 'two', isEdited: isOpenedEdited || isEdited })
      }
    }
  })

  it('goes back to other circles, and what was done to them, and forth again', async () => {
    const { editing, circles } = await started()
    await editing.edit(moved(1, 3))
    await editing.edit([{ kind: 'remove', id: 0 }])
    await editing.open(sceneOf(Float64Array.of(7, 7, 7, 8, 8, 1), 'seven'))
    await editing.edit(moved(0, 9))
    expect([circles(), editing.scene?.dataSet]).toEqual([[9, 0, 1, 8, 8, 1], 'seven'])
    await editing.undo()
    await editing.undo()
    expect([circles(), editing.scene?.dataSet]).toEqual([[3, 0, 1], 'two'])
    expect(editing.scene?.isEdited).toBe(true)
    await editing.undo()
    await editing.undo()
    expect(circles()).toEqual([...TWO])
    for (let k = 0; k < 3; k++) await editing.redo()
    expect([circles(), editing.scene]).toEqual([
      [7, 7, 7, 8, 8, 1],
      { circles: Float64Array.of(7, 7, 7, 8, 8, 1), dataSet: 'seven', isEdited: false },
    ])
    await editing.redo()
    expect(circles()).toEqual([9, 0, 1, 8, 8, 1])
    await editing.redo()
    expect(circles()).toEqual([9, 0, 1, 8, 8, 1])
  })

  it('keeps everything as it is where other circles are refused', async () => {
    const { editing, circles, problems } = await started()
    await editing.edit(moved(1, 3))
    expect(await editing.open(sceneOf(Float64Array.of(0, 0, -1)))).toBeUndefined()
    expect(problems).toEqual([expect.stringMatching(/Circle 0 .*radius/)])
    expect([circles(), editing.scene?.dataSet]).toEqual([[0, 0, 1, 3, 0, 1], 'two'])
    await editing.undo()
    expect(circles()).toEqual([...TWO])
  })

  it('cancels nothing of what came before a gesture that has done nothing', async () => {
    const { editing, circles, problems } = await started()
    await editing.cancel(editing.beginGesture())
    await editing.edit(moved(1, 8))
    await editing.cancel(editing.beginGesture())
    expect([circles(), problems]).toEqual([[0, 0, 1, 8, 0, 1], []])
  })

  it('has the circles of the editor after any edits, undone and done again', async () => {
    const number = fc.double({ min: -10, max: 10, noNaN: true })
    const circle = fc.record({ x: number, y: number, r: fc.double({ min: 0, max: 3, noNaN: true }) })
    const step = fc.oneof(
      circle.map((circle) => ({ circle })),
      fc.record({ k: fc.nat(20), circle }),
      fc.nat(20).map((k) => ({ k })),
      fc.constantFrom('undo' as const, 'redo' as const, 'open' as const),
    )
    await fc.assert(
      fc.asyncProperty(fc.array(step, { maxLength: 30 }), async (steps) => {
        const { editing, editor, circles } = await started()
        for (const step of steps) {
          const ids = editor().ids()
          const id = typeof step === 'object' && 'k' in step ? ids[step.k % Math.max(ids.length, 1)] : undefined
          if (step === 'undo') await editing.undo()
          else if (step === 'redo') await editing.redo()
          else if (step === 'open') await editing.open(sceneOf(Float64Array.of(1, 1, 1, 2, 2, 2, 3, 3, 3)))
          else if (id !== undefined && 'circle' in step)
            await editing.edit([{ kind: 'replace', id, circle: step.circle }])
          else if (id !== undefined) await editing.edit([{ kind: 'remove', id }])
          else if ('circle' in step) await editing.edit([{ kind: 'insert', circle: step.circle as Circle }])
          // An editor has no -0.
          expect(circles().map((value) => value + 0)).toEqual([...editor().snapshot().circles])
        }
        const end = circles()
        for (const _ of steps) await editing.undo()
        expect(circles()).toEqual([...TWO])
        for (const _ of steps) await editing.redo()
        if (!steps.includes('undo')) expect(circles()).toEqual(end)
      }),
      { numRuns: 60 },
    )
  })
})
