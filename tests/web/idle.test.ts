// SPDX-License-Identifier: GPL-3.0-or-later
// The wait of figures for an idle browser.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { whenIdle } from '../../web/element/idle.ts'

let window: EventTarget
beforeEach(() => {
  window = new EventTarget()
  vi.stubGlobal('addEventListener', window.addEventListener.bind(window))
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

describe('the wait for an idle browser', () => {
  let idle: { run: () => void; timeout: number }[]
  const run = () => idle.shift()?.run()
  beforeEach(() => {
    idle = []
    vi.stubGlobal('requestIdleCallback', (run: () => void, { timeout }: { timeout: number }) =>
      idle.push({ run, timeout }),
    )
  })

  it('calls functions one at a time in their order, without those that were canceled', () => {
    const calls: string[] = []
    const cancels = ['a', 'b', 'c', 'd'].map((name) => whenIdle(() => calls.push(name)))
    expect(idle.map(({ timeout }) => timeout)).toEqual([3000])
    cancels[1]?.()
    run()
    expect([calls, idle.length]).toEqual([['a'], 1])
    run()
    cancels[3]?.()
    run()
    expect([calls, idle.length]).toEqual([['a', 'c'], 0])
    whenIdle(() => calls.push('e'))
    run()
    expect([calls, idle.length]).toEqual([['a', 'c', 'e'], 0])
  })

  it('begins once the page is loaded, and with a timer where browsers have no idle callback', () => {
    const calls: string[] = []
    const state = vi.spyOn(document, 'readyState', 'get').mockReturnValue('loading')
    whenIdle(() => calls.push('a'))
    expect(idle).toEqual([])
    window.dispatchEvent(new Event('load'))
    window.dispatchEvent(new Event('load'))
    expect(idle).toHaveLength(1)
    run()
    vi.unstubAllGlobals()
    state.mockRestore()
    vi.useFakeTimers({ toFake: ['setTimeout'] })
    whenIdle(() => calls.push('b'))
    vi.advanceTimersByTime(299)
    expect(calls).toEqual(['a'])
    vi.advanceTimersByTime(1)
    expect(calls).toEqual(['a', 'b'])
  })
})
