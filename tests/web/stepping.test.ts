// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it, vi } from 'vitest'
import type { EditorActions } from '../../web/editing/editor-actions.ts'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import { mountPlayer, type Player, type PlayerOptions } from '../../web/player/player.ts'
import { Stepping } from '../../web/player/stepping.ts'
import type { View } from '../../web/view/view.ts'

vi.mock('../../web/player/player.ts', () => ({ mountPlayer: vi.fn() }))

/** A loaded player at step 0. `say` reports a step as the player does, and `asked` has the steps that it was told to show. */
async function played() {
  const state: { now: State } = { now: { ...INITIAL_STATE, step: 0, edited: {} as State['edited'] } }
  let follow = () => {}
  const store = {
    get: () => state.now,
    update() {},
    subscribe(listener: (state: State) => void) {
      follow = () => listener(state.now)
      return () => {}
    },
  }
  const asked: number[] = []
  let say = (_step: number, _steps: number) => {}
  const dispose = vi.fn()
  vi.mocked(mountPlayer).mockImplementation((_, { onstep }: PlayerOptions) => {
    say = onstep
    const stepTo = (step: number) => {
      asked.push(step)
      onstep(step, 9)
    }
    return { ready: Promise.resolve(), stepTo, dispose } as unknown as Player
  })
  const showStep = (step: number | undefined) => {
    state.now = { ...state.now, step }
  }
  const stepping = new Stepping({
    container: {} as HTMLElement,
    view: {} as View,
    store,
    actions: { showStep } as unknown as EditorActions,
    options: () => ({}),
  })
  follow()
  await stepping.whenReady()
  return {
    stepOf: () => state.now.step,
    showStep,
    follow: () => follow(),
    say: (step: number) => say(step, 9),
    asked,
    dispose,
  }
}

it('the step that the player shows becomes the step of the state', async () => {
  const { stepOf, say, asked } = await played()
  say(4)
  expect(stepOf()).toBe(4)
  expect(asked).toEqual([])
})

it('a new step of the state is kept if the player reports another step before it hears of the new one', async () => {
  const { stepOf, showStep, follow, say, asked } = await played()
  showStep(3)
  say(0)
  expect(stepOf()).toBe(3)
  expect(asked).toEqual([3])
  follow()
  expect(asked).toEqual([3])
})

it('a closed player does not open again if it reports a step before it hears that it is closed', async () => {
  const { stepOf, showStep, follow, say, dispose } = await played()
  showStep(undefined)
  say(0)
  follow()
  expect(stepOf()).toBeUndefined()
  expect(dispose).toHaveBeenCalledOnce()
})
