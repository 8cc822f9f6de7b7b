// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { EditorActions } from '../../web/editing/editor-actions.ts'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import { createStore } from '../../web/editing/store.ts'
import { mountPlayer, type Player, type PlayerOptions } from '../../web/player/player.ts'
import { Stepping } from '../../web/player/stepping.ts'
import type { View } from '../../web/view/view.ts'
import { aTurn } from './editing-session.ts'

vi.mock('../../web/player/player.ts', () => ({ mountPlayer: vi.fn() }))

let frame = () => {}
beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', (tell: () => void) => {
    frame = tell
  })
})
afterEach(() => vi.unstubAllGlobals())

/** A loaded player of nine steps. `go` changes the step like the player, and `told` records the steps that listeners received. */
async function played() {
  const store = createStore<State>({ ...INITIAL_STATE, step: 0, edited: {} as State['edited'] })
  const told: number[] = []
  let options: PlayerOptions | undefined
  const [dispose, play, pause, redraw, onproblem] = [vi.fn(), vi.fn(), vi.fn(), vi.fn(), vi.fn()]
  const player = { ready: Promise.resolve() as Promise<void>, steps: 9, dispose, play, pause, redraw }
  /** The methods for which options were asked. */
  const given: { method: string | undefined }[] = []
  vi.mocked(mountPlayer).mockImplementation((_, given: PlayerOptions) => {
    options = given
    const follow = () => given.onstep(Math.min(given.place().step as number, 8), 9)
    return Object.assign(player, { follow }) as unknown as Player
  })
  const showStep = (step: number | undefined, method?: string, stage?: string) =>
    store.update((state) => ({ ...state, step, method, stage }))
  const stepping = new Stepping({
    container: {} as HTMLElement,
    view: {} as View,
    store,
    actions: { showStep } as unknown as EditorActions,
    options: (method) => {
      given.push({ method })
      return {}
    },
    onstep: (step) => told.push(step),
    onproblem,
  })
  await stepping.whenReady()
  told.length = 0
  const { place, go } = options as unknown as PlayerOptions
  return {
    stepOf: () => store.get().step,
    showStep,
    place,
    go,
    told,
    dispose,
    play,
    pause,
    redraw,
    player,
    given,
    onproblem,
    stepping,
  }
}

it('the step that the player goes to is the step of the state, and the player asks for no other', async () => {
  const { stepOf, go, place, showStep } = await played()
  go(4)
  expect([stepOf(), place().step]).toEqual([4, 4])
  showStep(3)
  expect(place().step).toBe(3)
  go(place().step as number)
  expect(stepOf()).toBe(3)
})

it('the player shows a new step of the state with the next frame', async () => {
  const { showStep, told } = await played()
  showStep(3)
  expect(told).toEqual([])
  frame()
  expect(told).toEqual([3])
})

it('the stage of changed circles is forgotten once another step is wanted', async () => {
  const { go, place, showStep } = await played()
  go(4, 'discs' as never)
  expect(place()).toMatchObject({ step: 4, stage: 'discs' })
  showStep(4)
  expect(place().stage).toBeUndefined()
})

it('plays from the start where no step is shown, from the step otherwise, and pauses', async () => {
  const { stepping, showStep, stepOf, play, pause } = await played()
  showStep(4)
  frame()
  stepping.play()
  expect([stepOf(), play.mock.calls.length]).toEqual([4, 1])
  showStep(undefined)
  frame()
  stepping.play()
  expect(stepOf()).toBe(0)
  frame()
  await stepping.whenReady()
  expect(play).toHaveBeenCalledTimes(2)
  stepping.pause()
  expect(pause).toHaveBeenCalledOnce()
  // The player does not play once it is mounted again, either.
  showStep(undefined)
  frame()
  stepping.play()
  stepping.pause()
  frame()
  await stepping.whenReady()
  expect(play).toHaveBeenCalledTimes(2)
})

it('begins again with other options, at the start, and is redrawn with other texts', async () => {
  const { stepping, stepOf, showStep, dispose, redraw, given } = await played()
  showStep(4, 'auto')
  frame()
  await stepping.whenReady()
  expect(given.map(({ method }) => method)).toEqual([undefined, 'auto'])
  stepping.restart()
  expect([stepOf(), dispose.mock.calls.length]).toEqual([0, 2])
  await stepping.whenReady()
  expect(given).toHaveLength(3)
  expect(stepping.steps).toBe(9)
  stepping.redraw()
  expect(redraw).toHaveBeenCalledOnce()
  stepping.dispose()
  expect(stepping.steps).toBe(0)
})

it('is ready once the newest trace is, whatever became of those before', async () => {
  const { stepping, player } = await played()
  let isReady = false
  let fail = (_: Error) => {}
  let finish = () => {}
  player.ready = new Promise<void>((_, reject) => {
    fail = reject
  })
  const ready = stepping.whenReady().then(() => {
    isReady = true
  })
  await aTurn()
  player.ready = new Promise<void>((resolve) => {
    finish = resolve
  })
  fail(new Error('old'))
  await aTurn()
  expect(isReady).toBe(false)
  finish()
  await ready
})

it('a player that is closed stays closed', async () => {
  const { stepOf, showStep, dispose, stepping, told } = await played()
  showStep(undefined)
  stepping.restart()
  frame()
  expect(stepOf()).toBeUndefined()
  expect(dispose).toHaveBeenCalledOnce()
  expect(told).toEqual([])
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

it('a player that was disposed of is not opened again by the state', async () => {
  const { stepping, showStep, dispose } = await played()
  const mounted = vi.mocked(mountPlayer).mock.calls.length
  stepping.dispose()
  showStep(4)
  frame()
  await stepping.whenReady()
  expect(dispose).toHaveBeenCalledOnce()
  expect(mountPlayer).toHaveBeenCalledTimes(mounted)
})

it.each(['closed', 'disposed of'])(
  'a player that loads after it was %s is neither mounted nor a problem',
  async (how) => {
    const { stepping, showStep, onproblem } = await played()
    showStep(undefined)
    frame()
    await stepping.whenReady()
    vi.mocked(mountPlayer).mockClear()
    vi.mocked(mountPlayer).mockImplementation(() => {
      throw new Error('too late')
    })
    showStep(2)
    frame()
    if (how === 'closed') showStep(undefined)
    else stepping.dispose()
    frame()
    await stepping.whenReady()
    expect(mountPlayer).not.toHaveBeenCalled()
    expect(onproblem).not.toHaveBeenCalled()
  },
)

it('a problem of a player that was closed meanwhile is not told', async () => {
  const { stepping, showStep, onproblem } = await played()
  showStep(undefined)
  frame()
  let fail = (_: Error) => {}
  const ready = new Promise<void>((_, reject) => {
    fail = reject
  })
  vi.mocked(mountPlayer).mockClear()
  vi.mocked(mountPlayer).mockImplementation(() => ({ ready, dispose: () => {} }) as unknown as Player)
  showStep(2)
  frame()
  await vi.waitFor(() => expect(mountPlayer).toHaveBeenCalledOnce())
  showStep(undefined)
  frame()
  fail(new Error('late'))
  await stepping.whenReady()
  expect(onproblem).not.toHaveBeenCalled()
})
