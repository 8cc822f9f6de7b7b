// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { nextFrame as onNextFrame } from '../../web/view/next-frame.ts'
import { createStore } from '../../web/view/store.ts'

let frames: (() => void)[] = []
const nextFrame = () => {
  const due = frames
  frames = []
  for (const frame of due) frame()
}

beforeEach(() => {
  frames = []
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
})
afterEach(() => vi.unstubAllGlobals())

it('tells a value at once, and once a frame in which it was replaced, until that is ended', () => {
  const store = createStore(1)
  const told: number[] = []
  const toldToo: number[] = []
  store.subscribe((value) => told.push(value))
  expect(told).toEqual([1])
  store.update((value) => value + 1)
  store.update((value) => value + 1)
  expect(store.get()).toBe(3)
  expect(told).toEqual([1])
  expect(frames).toHaveLength(1)
  const end = store.subscribe((value) => toldToo.push(value))
  nextFrame()
  expect(told).toEqual([1, 3])
  expect(toldToo).toEqual([3, 3])
  end()
  store.update((value) => 2 * value)
  nextFrame()
  expect([told, toldToo]).toEqual([
    [1, 3, 6],
    [3, 3],
  ])
  store.update((value) => value)
  expect(frames).toEqual([])
})

it('the next frame comes once, also in a hidden tab, which draws none, and leaves no timer', () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  try {
    for (const [hidden, wait] of [
      [false, 1000],
      [true, 0],
    ] as const) {
      vi.stubGlobal('document', { hidden })
      let count = 0
      const act = () => {
        count += 1
      }
      onNextFrame(act)
      nextFrame()
      expect([count, vi.getTimerCount()]).toEqual([1, 0])
      onNextFrame(act)
      if (wait > 0) {
        vi.advanceTimersByTime(wait - 1)
        expect(count).toBe(1)
      }
      vi.advanceTimersByTime(wait > 0 ? 1 : 0)
      expect(count).toBe(2)
      nextFrame()
      expect(count).toBe(2)
    }
  } finally {
    vi.useRealTimers()
  }
})

it('tells a watcher of each new value at once, with the former one, until that is ended', () => {
  const store = createStore(1)
  const told: number[][] = []
  const end = store.watch((...values) => told.push(values))
  store.update((value) => value + 1)
  store.update((value) => value)
  store.update((value) => value + 1)
  end()
  store.update((value) => value + 1)
  expect(told).toEqual([
    [2, 1],
    [3, 2],
  ])
  expect(frames).toEqual([])
})
