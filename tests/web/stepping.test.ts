// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { EditorActions } from '../../web/editing/editor-actions.ts'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import { createStore } from '../../web/editing/store.ts'
import { mountPlayer, type Player, type PlayerOptions } from '../../web/player/player.ts'
import { Stepping } from '../../web/player/stepping.ts'
import type { View } from '../../web/view/view.ts'

vi.mock('../../web/player/player.ts', () => ({ mountPlayer: vi.fn() }))

let frame = () => {}
beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', (tell: () => void) => {
    frame = tell
  })
})
afterEach(() => vi.unstubAllGlobals())

/**
 * A loaded player at step 0. `report` reports a step like the player, `asked` records the steps requested from the
 * player, and `told` those that listeners received.
 */
async function played() {
  const store = createStore<State>({ ...INITIAL_STATE, step: 0, edited: {} as State['edited'] })
  const [asked, told]: [number[], number[]] = [[], []]
  let report = (_: number) => {}
  const [dispose, play] = [vi.fn(), vi.fn()]
  vi.mocked(mountPlayer).mockImplementation((_, { onstep }: PlayerOptions) => {
    let shown = 0
    report = (step) => {
      shown = step
      onstep(step, 9)
    }
    const stepTo = (step: number) => {
      asked.push(step)
      if (step !== shown) report(step)
    }
    return { ready: Promise.resolve(), stepTo, dispose, play } as unknown as Player
  })
  const showStep = (step: number | undefined) => store.update((state) => ({ ...state, step }))
  const stepping = new Stepping({
    container: {} as HTMLElement,
    view: {} as View,
    store,
    actions: { showStep } as unknown as EditorActions,
    options: () => ({}),
    onstep: (step) => told.push(step),
  })
  await stepping.whenReady()
  const fakes = { dispose, play, stepping }
  return { stepOf: () => store.get().step, showStep, report: (step: number) => report(step), asked, told, ...fakes }
}

it('the step that the player shows becomes the step of the state', async () => {
  const { stepOf, report, asked, told } = await played()
  report(4)
  expect([stepOf(), asked, told]).toEqual([4, [], [4]])
})

it('a new step of the state is kept if the player reports another step before it hears of the new one', async () => {
  const { stepOf, showStep, report, asked, told } = await played()
  showStep(3)
  report(0)
  expect([stepOf(), asked, told]).toEqual([3, [3], [3]])
  frame()
  expect([stepOf(), asked, told]).toEqual([3, [3], [3]])
})

it('listeners hear of a step that the player reaches before it hears that the state names it', async () => {
  const { stepOf, showStep, report, told } = await played()
  showStep(1)
  report(1)
  frame()
  expect([stepOf(), told]).toEqual([1, [1]])
})

it('a closed player does not open again if it reports a step before it hears that it is closed', async () => {
  const { stepOf, showStep, report, dispose } = await played()
  showStep(undefined)
  report(0)
  frame()
  expect(stepOf()).toBeUndefined()
  expect(dispose).toHaveBeenCalledOnce()
})

it('a player that is closed while it plays does not play when it is opened again', async () => {
  const { stepping, showStep, play } = await played()
  stepping.play()
  expect(play).toHaveBeenCalledOnce()
  showStep(undefined)
  frame()
  showStep(0)
  frame()
  await stepping.whenReady()
  expect(play).toHaveBeenCalledOnce()
  stepping.play()
  expect(play).toHaveBeenCalledTimes(2)
})
