// SPDX-License-Identifier: GPL-3.0-or-later
// An edit applies to the circles that it was made for. After another opening it has no effect.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { driftAtStart } from '../../web/app/motion/drift.ts'
import { Motion } from '../../web/app/motion/motion.ts'
import { Radii } from '../../web/app/motion/radii.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import type { Outcome } from '../../web/editing/editing.ts'
import { INITIAL_STATE, stateAfter } from '../../web/editing/state.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { PaintedScene } from '../../web/view/painter/painted-scene.ts'
import { Superseded } from '../../web/view/refusal.ts'
import type { View } from '../../web/view/view.ts'
import { aTurn, editingSession, sceneOf } from './editing-session.ts'
import { library } from './library.ts'

const FORMER = Float64Array.from({ length: 27 }, (_, k) => (k % 3 === 2 ? 1 : 5 * k))
const OPENED = Float64Array.from({ length: 27 }, (_, k) => (k % 3 === 2 ? 2 : 7 * k))

/** The frames of a test. */
let frames: ((now: number) => void)[] = []
const draw = (now: number) => {
  const now_ = frames
  frames = []
  for (const frame of now_) frame(now)
}
const settle = () => new Promise((resolve) => setTimeout(resolve, 5))

beforeEach(() => {
  frames = []
  vi.stubGlobal('requestAnimationFrame', (frame: (now: number) => void) => frames.push(frame))
  vi.stubGlobal('cancelAnimationFrame', () => {
    frames = []
  })
  vi.stubGlobal('matchMedia', () => ({ matches: false }))
  vi.stubGlobal('document', new EventTarget())
})
afterEach(() => vi.unstubAllGlobals())

/** Editing with a backend whose answers arrive a turn later. */
async function started() {
  const session = editingSession({ before: aTurn })
  await session.editing.open(sceneOf(FORMER, 'former'))
  return session
}

describe('circles that are opened are not changed by', () => {
  it('a gesture that began with other circles', async () => {
    const { editing, problems, circles } = await started()
    const gesture = editing.beginGesture()
    const move = (x: number) => editing.edit([{ kind: 'replace', id: 7, circle: { x, y: 0, r: 1 } }], gesture)
    await move(1)
    const opened = editing.open(sceneOf(OPENED))
    const [waiting, , late] = [move(2), await opened, move(3)]
    expect([await waiting, await late]).toEqual([undefined, undefined])
    expect([circles(), problems]).toEqual([[...OPENED], []])
    // Gestures that begin now refer to the new circles.
    expect(await editing.edit([{ kind: 'remove', id: 7 }])).toBeDefined()
    await editing.undo()
    await editing.undo()
    await editing.undo()
    expect(circles()).toEqual([...FORMER])
  })

  it('an edit without a gesture that waits behind them', async () => {
    const { editing, circles } = await started()
    const opened = editing.open(sceneOf(OPENED))
    const edited = editing.edit([{ kind: 'remove', id: 3 }])
    expect([(await opened) !== undefined, await edited, circles()]).toEqual([true, undefined, [...OPENED]])
  })

  it('an undo that was asked before they were there; two of them go on', async () => {
    const { editing, circles } = await started()
    await editing.edit([{ kind: 'remove', id: 3 }])
    const opened = editing.open(sceneOf(OPENED))
    const undone = editing.undo()
    expect([(await opened) !== undefined, await undone, circles()]).toEqual([true, undefined, [...OPENED]])
    await Promise.all([editing.undo(), editing.undo()])
    expect(circles().length).toBe(FORMER.length)
  })

  it('a circle that is added once it is known where there is room', async () => {
    const { editing, actions, fake, circles } = await started()
    let answer = () => {}
    fake.ask = () =>
      new Promise((resolve) => {
        answer = () => resolve(undefined)
      })
    const added = actions.addInRoom()
    await editing.open(sceneOf(OPENED))
    answer()
    await added
    expect(circles()).toEqual([...OPENED])
  })

  it('circles that move, which then stop', async () => {
    const { editing, problems, actions, view, circles } = await started()
    const page = Object.assign(actions, { complain: (text: string) => problems.push(text) }) as unknown as PageActions
    const motion = new Motion(view, editing, page)
    motion.start('grow')
    draw(0)
    await settle()
    // An edit is requested and waits behind an opening.
    const opened = editing.open(sceneOf(OPENED))
    draw(40)
    draw(80)
    await opened
    await settle()
    draw(120)
    await settle()
    expect([circles(), motion.isMoving, problems]).toEqual([[...OPENED], false, []])
  })

  it('an answer about a movement that another one has followed: that one goes on', async () => {
    const { editing, actions, view } = await started()
    const motion = new Motion(view, editing, actions as unknown as PageActions)
    motion.start('grow')
    draw(0)
    // The edit is refused a turn later.
    const { edit } = editing
    editing.edit = async () => undefined
    await settle()
    draw(40)
    editing.edit = edit
    motion.start('breathe')
    await settle()
    expect(motion.isMoving).toBe(true)
  })

  it('a movement whose edit is refused: it stops', async () => {
    const { editing, computer, problems, actions, view } = await started()
    const motion = new Motion(view, editing, actions as unknown as PageActions)
    computer.apply = async () => {
      throw new Error('It is refused.')
    }
    motion.start('grow')
    draw(0)
    await settle()
    expect([motion.isMoving, problems]).toEqual([false, ['It is refused.']])
  })

  it('the slider of radii', async () => {
    const { editing, store, circles } = await started()
    const radii = new Radii(store, editing)
    await radii.scale(0.5)
    const opened = editing.open(sceneOf(OPENED))
    const scaled = radii.scale(0.25)
    await opened
    await scaled
    expect(circles()).toEqual([...OPENED])
  })
})

describe('the circle that moves at the start', () => {
  it('ends where it cannot be moved, and where other circles are there', async () => {
    const { view, editing } = await started()
    let ends = 0
    let asked = 0
    const refused = {
      ...view,
      circles: editing.circles,
      apply: async () => {
        asked += 1
        throw new Superseded()
      },
    }
    driftAtStart(refused as unknown as View, {} as HTMLElement, () => {
      ends += 1
    })
    for (let now = 0; now < 100; now += 20) {
      draw(now)
      await settle()
    }
    expect([ends, asked, frames.length]).toEqual([1, 1, 0])
  })

  it('leaves nothing in the circles that undo goes back to', async () => {
    const { computer, editing, circles } = await started()
    await computer.apply([{ kind: 'replace', id: 7, circle: { x: 1, y: 2, r: 3 } }])
    await editing.open(sceneOf(OPENED))
    await editing.undo()
    expect([circles(), editing.scene?.isEdited]).toEqual([[...FORMER], false])
  })
})

it('who opens other circles neither selects nor points at any of them', () => {
  const state = { ...INITIAL_STATE, selection: [7], selected: 7, hovered: 8, described: { id: 7 } as never }
  const outcome = { edited: undefined, history: INITIAL_STATE.history, domain: INITIAL_STATE.domain }
  const circles = new CircleTable(OPENED.slice())
  const opened = stateAfter(state, { ...outcome, isOpened: true } as unknown as Outcome, circles)
  expect([opened.selection, opened.hovered, opened.described]).toEqual([[], undefined, undefined])
  const edited = stateAfter(state, { ...outcome, isOpened: false } as unknown as Outcome, circles)
  expect([edited.selection, edited.hovered, edited.described?.id]).toEqual([[7], 8, 7])
  const painted = new PaintedScene(library)
  painted.open(FORMER)
  painted.mark(7, 8)
  painted.open(OPENED)
  expect(painted.marks()).toEqual({ selected: undefined, hovered: undefined })
})
