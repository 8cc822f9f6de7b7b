// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { mountLiveRegion } from '../../web/editing/live-region.ts'
import { initialState } from '../../web/editing/state.ts'
import { ENGLISH_EDITING } from '../../web/editing/words.ts'
import type { Described } from '../../web/view/protocol.ts'
import { createStore } from '../../web/view/store.ts'

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

/** The description of a circle with so many neighbors. */
function described(id: number, neighbors: number): Described {
  const none = new Float64Array()
  const [circle, isBounded, hiddenBy, color] = [{ x: 0, y: 0, r: 1 }, true, undefined, '#123456']
  return {
    id,
    circle,
    color,
    hiddenBy,
    isBounded,
    neighbors: new Int32Array(neighbors),
    outline: none,
    neighborhood: none,
  }
}

/**
 * Does some steps: `say A`, `select 3`, `describe 3 2` (with two neighbors), `wait 100` milliseconds. An action selects
 * and says at once: `say A 3`, or `say A none` without a selection. Returns the numbers and capital letters of each announcement.
 */
function announced(script: string): string[] {
  const store = createStore(initialState())
  const texts: string[] = []
  const element = { replaceChildren: (text: string) => texts.push(text) }
  mountLiveRegion(store, element as unknown as HTMLElement, { words: ENGLISH_EDITING, called: (id) => `${id}` })
  for (const step of script.split('; ')) {
    const [what, one = '', two] = step.split(' ')
    if (what === 'wait') vi.advanceTimersByTime(Number(one))
    else {
      store.update((state) => ({
        ...state,
        ...(what === 'say' && { said: { text: one } }),
        ...((what === 'select' || two !== undefined) && {
          selection: two === 'none' ? [] : [Number(what === 'say' ? two : one)],
        }),
        ...(what === 'describe'
          ? { highlights: { selected: described(Number(one), Number(two)), hovered: undefined } }
          : {}),
      }))
      frame()
    }
  }
  vi.advanceTimersByTime(1000)
  return texts.map((text) => text.match(/\d+|\b[A-Z]\b/g)?.join(' ') ?? '')
}

it.each([
  ['an action with the circle that it selects, which is described soon', 'say A 3; describe 3 2', ['A 2']],
  ['an action with the circle that it selects, which is described late', 'say A 3; wait 9000; describe 3 2', ['A 2']],
  ['an action once', 'say A 3; describe 3 2; wait 900; select 1; describe 1 4', ['A 2', '1 4']],
  ['an action with another circle that is selected meanwhile', 'say A 3; select 1; describe 1 4', ['A 1 4']],
  ['an action that selects nothing at once', 'describe 3 2; wait 900; say A; wait 900; say B', ['3 2', 'A', 'B']],
  ['an action that ends the selection at once', 'describe 3 2; wait 900; say A none', ['3 2', 'A']],
  ['the last of two actions with its circle', 'say A; wait 100; say B 3; wait 900; describe 3 2', ['B 2']],
  ['actions that follow each other once they have ended', 'say A; wait 249; say B; wait 249; say C', ['C']],
  [
    'a drag of the described circle at its end',
    'describe 3 2; wait 900; describe 3 4; wait 99; describe 3 5',
    ['3 2', '3 5'],
  ],
  ['a drag that begins at once as it ends', 'select 3; describe 3 2; wait 99; describe 3 5', ['3 5']],
  ['no drag that changes nothing', 'describe 3 2; wait 900; describe 3 4; wait 99; describe 3 2', ['3 2']],
])('screen readers hear %s', (_, script, expected) => {
  expect(announced(script)).toEqual(expected)
})
