// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { mountLiveRegion } from '../../web/editing/live-region.ts'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import { createStore } from '../../web/editing/store.ts'
import { ENGLISH_EDITING } from '../../web/editing/words.ts'
import type { Described } from '../../web/view/protocol.ts'

let frame = () => {}
beforeEach(() => {
  vi.useFakeTimers()
  vi.stubGlobal('requestAnimationFrame', (tell: () => void) => {
    frame = tell
  })
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/** The description of a circle with these neighbors. */
function described(id: number, ...neighbors: number[]): Described {
  const circle = { x: 0, y: 0, r: 1 }
  const none = new Float64Array()
  const [isBounded, hiddenBy, color] = [true, undefined, '#123456']
  return {
    id,
    circle,
    color,
    hiddenBy,
    isBounded,
    neighbors: Int32Array.from(neighbors),
    outline: none,
    neighborhood: none,
  }
}

/** Collects the announcements, and returns a function that changes the state. */
function speaker() {
  const store = createStore(INITIAL_STATE)
  const texts: string[] = []
  const element = { replaceChildren: (text: string) => texts.push(text) }
  mountLiveRegion(store, element as unknown as HTMLElement, {
    words: ENGLISH_EDITING,
    called: (id) => ENGLISH_EDITING.called(id, id === 7 ? 'Hamburg' : ''),
  })
  const change = (part: Partial<State>) => {
    store.update((state) => ({ ...state, ...part }))
    frame()
  }
  return { texts, change }
}

it.each([0, 100, 10_000])(
  'an action is announced with the description of the circle that it selected, which comes after %i ms',
  (ms) => {
    const { texts, change } = speaker()
    change({ said: { text: 'Circle 3 added' }, selected: 3, described: undefined })
    vi.advanceTimersByTime(ms)
    change({ described: described(3, 0, 1) })
    vi.advanceTimersByTime(1000)
    expect(texts).toEqual(['Circle 3 added. Bounded cell, 2 neighbors'])
    // The action is announced once.
    change({ selected: 1, described: undefined })
    vi.advanceTimersByTime(1000)
    change({ described: described(1, 3) })
    vi.advanceTimersByTime(1000)
    expect(texts.slice(1)).toEqual(['Circle 1. Bounded cell, 1 neighbor'])
  },
)

it('an action is announced with the description of another circle that was selected in the meantime', () => {
  const { texts, change } = speaker()
  change({ said: { text: 'Circle 3 added' }, selected: 3, described: undefined })
  change({ selected: 1 })
  change({ described: described(1, 3) })
  vi.advanceTimersByTime(1000)
  expect(texts).toEqual(['Circle 3 added. Circle 1. Bounded cell, 1 neighbor'])
})

it('an action that selects nothing is announced without waiting for a description', () => {
  const { texts, change } = speaker()
  change({ selected: 3, described: described(3, 0, 1) })
  vi.advanceTimersByTime(1000)
  change({ said: { text: 'Snapping is on' } })
  vi.advanceTimersByTime(1000)
  change({ said: { text: 'Circle 3 deleted' }, selected: undefined })
  vi.advanceTimersByTime(1000)
  expect(texts).toEqual(['Circle 3. Bounded cell, 2 neighbors', 'Snapping is on', 'Circle 3 deleted'])
})

it('an action waits for the description of its circle, also after another announcement that was pending', () => {
  const { texts, change } = speaker()
  change({ said: { text: 'Snapping is on' } })
  vi.advanceTimersByTime(100)
  change({ said: { text: 'Circle 3 added' }, selected: 3, described: undefined })
  vi.advanceTimersByTime(1000)
  expect(texts).toEqual([])
  change({ described: described(3, 0, 1) })
  vi.advanceTimersByTime(1000)
  expect(texts).toEqual(['Circle 3 added. Bounded cell, 2 neighbors'])
})

it('steps that follow each other are announced once they have ended, and a drag of the described circle is not', () => {
  const { texts, change } = speaker()
  change({ selected: 3, described: described(3, 0, 1) })
  vi.advanceTimersByTime(1000)
  texts.length = 0
  for (const x of [1, 2, 3]) {
    change({ said: { text: `x ${x}` } })
    vi.advanceTimersByTime(249)
  }
  expect(texts).toEqual([])
  vi.advanceTimersByTime(1)
  expect(texts).toEqual(['x 3'])
  change({ described: described(3, 0) })
  vi.advanceTimersByTime(1000)
  expect(texts).toEqual(['x 3'])
})
