// SPDX-License-Identifier: GPL-3.0-or-later
// Services that all figures of a page share: the wait for an idle browser, observers of positions, and drawings for
// print.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { whenIdle } from '../../web/element/idle.ts'
import { watchVisibility } from '../../web/element/visibility.ts'
import { parsedSvg } from '../../web/view/parsed-svg.ts'
import { make } from './page-document.ts'

let window: EventTarget
let print: EventTarget & { matches: boolean }
beforeEach(() => {
  window = new EventTarget()
  print = Object.assign(new EventTarget(), { matches: false })
  vi.stubGlobal('addEventListener', window.addEventListener.bind(window))
  vi.stubGlobal('matchMedia', () => print)
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

it('an element is told that it comes near or goes far, by two observers for all, until it stops', () => {
  const observers: { tell: (entries: unknown[]) => void; margin: string; seen: Set<unknown> }[] = []
  vi.stubGlobal(
    'IntersectionObserver',
    class {
      readonly seen = new Set<unknown>()
      observe = (element: unknown) => this.seen.add(element)
      unobserve = (element: unknown) => this.seen.delete(element)
      constructor(tell: (entries: unknown[]) => void, { rootMargin }: { rootMargin: string }) {
        observers.push({ tell, margin: rootMargin, seen: this.seen })
      }
    },
  )
  const [one, other] = [make('a'), make('b')]
  const told: unknown[] = []
  const stop = watchVisibility(one, (sight) => told.push(['one', sight]))
  watchVisibility(other, (sight) => told.push(['other', sight]))
  expect(observers.map(({ margin }) => margin)).toEqual(['25% 0px', '150% 0px'])
  for (const { seen } of observers) expect(seen.size).toBe(2)
  const both = (isIntersecting: boolean) => {
    for (const { tell } of observers) tell([one, other].map((target) => ({ target, isIntersecting })))
  }
  both(true)
  both(false)
  expect(told.splice(0)).toEqual([
    ['one', 'near'],
    ['other', 'near'],
    ['one', 'far'],
    ['other', 'far'],
  ])
  stop()
  for (const { seen } of observers) expect([...seen]).toEqual([other])
  both(true)
  expect(told).toEqual([['other', 'near']])
})

it('elements of an SVG are made from its text', () => {
  const text =
    '<svg xmlns="http://www.w3.org/2000/svg" width="2"><g a:b="1" c-d="2 3"><path d="M0 0"/><text> A </text></g> <path/></svg>'
  const written = (node: Node): unknown =>
    node instanceof Element
      ? [
          node.localName,
          Object.fromEntries([...node.attributes].map(({ name, value }) => [name, value])),
          ...[...node.childNodes].map(written),
        ]
      : node.textContent
  expect(written(parsedSvg(text) as SVGElement)).toEqual([
    'svg',
    { width: '2' },
    ['g', { 'a:b': '1', 'c-d': '2 3' }, ['path', { d: 'M0 0' }], ['text', {}, ' A ']],
    ['path', {}],
  ])
  expect(parsedSvg('')).toBeUndefined()
})
