// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { Playback } from '../../web/player/playback.ts'

let steps = 0
let goesOn = true
let playback: Playback
beforeEach(() => {
  vi.useFakeTimers()
  steps = 0
  goesOn = true
  playback = new Playback(() => {
    steps += 1
    return goesOn
  })
})
afterEach(() => vi.useRealTimers())
const after = (milliseconds: number) => {
  vi.advanceTimersByTime(milliseconds)
  return steps
}

it('plays so many steps in a second, until it is stopped or there is none', () => {
  playback.start()
  expect([after(999), after(1), after(2000)]).toEqual([0, 1, 3])
  playback.stop()
  expect(after(5000)).toBe(3)
  playback.start()
  goesOn = false
  expect(after(5000)).toBe(4)
})

it('has one timer, whatever is asked while it plays: another speed, or to play once more', () => {
  playback.start()
  after(500)
  playback.speed = 10
  playback.start()
  expect([after(100), after(900)]).toEqual([1, 10])
  playback.stop()
  expect(after(5000)).toBe(10)
})

it('does not begin to play where its speed is another one', () => {
  playback.speed = 10
  expect([after(5000), playback.speed]).toEqual([0, 10])
  playback.start()
  goesOn = false
  after(1000)
  playback.speed = 1
  expect(after(5000)).toBe(1)
})
