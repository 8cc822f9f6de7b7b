// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow root of an element.
// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { loadWords, wordsOf } from '../../web/element/language.ts'
import { Shell } from '../../web/element/shell.ts'

let root: ShadowRoot
let shell: Shell
const of = (name: string) => root.querySelector(`.${name}`) as HTMLElement
beforeEach(() => {
  vi.useFakeTimers()
  root = document.createElement('div').attachShadow({ mode: 'open' })
  shell = new Shell(root)
})
afterEach(() => void vi.useRealTimers())

it('a hint is visible for a while after it was last given', () => {
  const hint = of('hint')
  expect(hint.hidden).toBe(true)
  shell.hint('Press Ctrl.')
  vi.advanceTimersByTime(1400)
  shell.hint('Press Ctrl.')
  vi.advanceTimersByTime(1400)
  expect([hint.hidden, hint.textContent]).toEqual([false, 'Press Ctrl.'])
  vi.advanceTimersByTime(200)
  expect(hint.hidden).toBe(true)
})

it('its texts are in their own language, from left to right', async () => {
  await loadWords('de')
  for (const lang of ['en', 'de']) {
    shell.describe(wordsOf(lang), '', '', false)
    const spoken = [...root.querySelectorAll<HTMLElement>('[dir=ltr]')]
    expect(spoken.map(({ lang }) => lang)).toEqual(Array(5).fill(lang))
  }
})

it('takes the focus and pixels only while it has them, and shows no poster once it has failed', () => {
  const { figure, frame } = shell
  const now = () => [frame.dataset.running, figure.inert, figure.tabIndex]
  expect(now()).toEqual(['false', true, -1])
  shell.isRunning = true
  expect(now()).toEqual(['true', false, 0])
  shell.isRunning = false
  expect(now()).toEqual(['false', true, -1])
  for (const isShown of [false, true]) {
    shell.isShown = isShown
    expect(frame.dataset.shown).toBe(String(isShown))
  }
  const slots = () => [...root.querySelectorAll('slot')].map(({ name }) => name)
  expect(slots()).toEqual(['poster', '', 'caption'])
  shell.fail()
  expect(slots()).toEqual(['', 'caption'])
})
