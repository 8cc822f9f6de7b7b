// SPDX-License-Identifier: GPL-3.0-or-later
// An edit applies to the circles that it was made for. After another opening it has no effect.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { Radii } from '../../web/app/motion/radii.ts'
import { aTurn, editingSession, sceneOf } from './editing-session.ts'

const FORMER = Float64Array.from({ length: 27 }, (_, k) => (k % 3 === 2 ? 1 : 5 * k))
const OPENED = Float64Array.from({ length: 27 }, (_, k) => (k % 3 === 2 ? 2 : 7 * k))

beforeEach(() => vi.stubGlobal('requestAnimationFrame', () => 0))
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
    fake.scene.ask = () =>
      new Promise((resolve) => {
        answer = () => resolve(undefined)
      })
    const added = actions.circles.addInRoom()
    await editing.open(sceneOf(OPENED))
    answer()
    await added
    expect(circles()).toEqual([...OPENED])
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
