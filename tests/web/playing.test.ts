// SPDX-License-Identifier: GPL-3.0-or-later
// The player of the method while it plays, asks, and loses or changes its circles, without a browser.
import type { TemplateResult } from 'lit/html.js'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { TraceOptions } from '../../web/lib/wasm/trace.ts'
import { mountPlayer, type Player } from '../../web/player/player.ts'
import { ENGLISH_PLAYER as WORDS } from '../../web/player/words.ts'
import { traced } from '../../web/view/painter/traced.ts'
import type { View } from '../../web/view/view.ts'
import { library } from './library.ts'

/** The newest template of the player. */
let page: unknown
vi.mock('lit/html.js', async (original) => ({
  ...(await original<object>()),
  render: (template: unknown) => {
    page = template
  },
}))
/** The color of all lines in the style sheet. */
let color = 'black'
vi.mock('../../web/view/style.ts', () => ({
  computedColors: (_: unknown, colors: object) => Object.fromEntries(Object.keys(colors).map((name) => [name, color])),
}))

type Press = (event?: unknown) => void

/** All strings and values of a template and its nested templates, in their order. */
function partsOf(template: unknown): unknown[] {
  if (Array.isArray(template)) return template.flatMap(partsOf)
  const { strings, values } = (template ?? {}) as Partial<TemplateResult>
  if (strings === undefined) return typeof template === 'symbol' ? [] : [template]
  return strings.flatMap((text, k) => [text, ...(k < (values?.length ?? 0) ? partsOf(values?.[k]) : [])])
}
const text = () =>
  partsOf(page)
    .filter((part) => typeof part !== 'function')
    .join('')
/** The listener that follows a label. */
function after(label: string): Press {
  const parts = partsOf(page)
  const found = parts.slice(parts.indexOf(label)).find((part) => typeof part === 'function')
  if (!parts.includes(label)) throw new Error(`There is no ${label}.`)
  return found as Press
}
const press = (label: string) => after(label)()

const FIVE = [0, 0, 2, 10, 1, 1, 5, 8, 1.5, 2, 6, 0.8, 9, 6, 2.2]
let circles: number[]
let listeners: Map<string, (data: unknown) => void>
let asked: { options: TraceOptions; answer: () => void; refuse: (error: Error) => void }[]
let step: number | undefined
let stage: string | undefined
let told: [number, number][]
let view: { hasDiagram: boolean; above: readonly unknown[] }
let root: { dir: string; keys: ((event: unknown) => void)[] }
let player: Player

beforeEach(() => {
  vi.useFakeTimers()
  vi.stubGlobal(
    'CSSStyleSheet',
    class {
      replaceSync() {}
    },
  )
  vi.stubGlobal(
    'ResizeObserver',
    class {
      observe() {}
      disconnect() {}
    },
  )
  circles = FIVE
  listeners = new Map()
  asked = []
  told = []
  step = 0
  stage = undefined
  page = undefined
  const fakeView = {
    hasDiagram: true,
    above: [] as readonly unknown[],
    on(name: string, listen: (data: unknown) => void) {
      listeners.set(name, listen)
      return () => listeners.delete(name)
    },
    ask: (_: string, options: TraceOptions) =>
      new Promise((resolve, reject) => {
        const { snapshot } = { snapshot: library.edit(Float64Array.from(circles)).snapshot() }
        asked.push({ options, answer: () => resolve(traced(library, snapshot, options)), refuse: reject })
      }),
  }
  const keys: ((event: unknown) => void)[] = []
  const fakeRoot = {
    keys,
    dir: '',
    lang: '',
    classList: { add() {}, remove() {} },
    getRootNode: () => ({ adoptedStyleSheets: [] }),
    addEventListener: (_: string, listen: (event: unknown) => void) => keys.push(listen),
    querySelector: () => null,
  }
  view = fakeView
  root = fakeRoot
  player = mountPlayer(fakeRoot as unknown as HTMLElement, {
    view: fakeView as unknown as View,
    options: {},
    place: () => ({ step, stage }),
    go: (next, line) => {
      step = next
      stage = line
    },
    onstep: (...now) => told.push(now),
  })
})
afterEach(() => {
  player.dispose()
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/** Lets the newest request for a trace be answered. */
async function loaded(): Promise<void> {
  await vi.advanceTimersByTimeAsync(200)
  asked.at(-1)?.answer()
  await player.ready
}
const seconds = (count: number) => vi.advanceTimersByTime(1000 * count)

it('plays a step each second, says each, and stops at the last, from where it plays from the start', async () => {
  await loaded()
  expect([step, view.hasDiagram, root.dir]).toEqual([0, false, 'ltr'])
  press(WORDS.play)
  seconds(3)
  expect(step).toBe(3)
  expect(told.slice(-3)).toEqual([1, 2, 3].map((k) => [k, player.steps]))
  seconds(1000)
  expect([step, view.hasDiagram]).toEqual([player.steps - 1, true])
  expect(text()).toContain(WORDS.play)
  press(WORDS.play)
  expect([step, view.hasDiagram]).toEqual([0, false])
  seconds(2)
  expect(step).toBe(2)
})

it('begins to play once the trace is there, if it was told before', async () => {
  player.play()
  seconds(5)
  expect(step).toBe(0)
  await loaded()
  seconds(2)
  expect(step).toBe(2)
})

it('another speed counts from the next step on', async () => {
  await loaded()
  press(WORDS.play)
  after(WORDS.speed)({ target: { value: '10' } })
  vi.advanceTimersByTime(500)
  expect(step).toBe(5)
})

it('stops at a breakpoint, goes on from there, and has none after an edit', async () => {
  await loaded()
  player.pause()
  step = 2
  player.follow()
  press(WORDS.breakHere)
  step = 0
  player.follow()
  press(WORDS.play)
  seconds(10)
  expect(step).toBe(2)
  press(WORDS.play)
  seconds(2)
  expect(step).toBe(4)
  circles = [...FIVE, 20, 20, 1]
  listeners.get('changed')?.(undefined)
  await loaded()
  step = 0
  player.follow()
  press(WORDS.play)
  seconds(10)
  expect(step).toBeGreaterThan(2)
})

it('asks before a step whose outcome is open, keeps the score, and explains the answer beside the next step only', async () => {
  await loaded()
  press(WORDS.ask)
  press(WORDS.play)
  seconds(1000)
  const first = step as number
  expect(text()).toContain(WORDS.whatNext)
  expect(first).toBeLessThan(player.steps - 1)
  // The answers follow the question. One answer is right.
  const parts = partsOf(page)
  const choices = parts.slice(parts.indexOf(WORDS.whatNext)).filter((part) => typeof part === 'function') as Press[]
  choices[0]?.()
  expect(step).toBe(first + 1)
  const wasRight = text().includes(WORDS.right)
  expect(text()).toContain(WORDS.score(wasRight ? 1 : 0, 1))
  press(WORDS.play)
  seconds(1)
  expect(text()).not.toContain(WORDS.score(wasRight ? 1 : 0, 1))
  // Going back and forth does not bring the answer again.
  step = first + 1
  player.follow()
  expect(text()).not.toContain(WORDS.score(wasRight ? 1 : 0, 1))
  listeners.get('changed')?.(undefined)
  await loaded()
  step = first
  player.follow()
  after(WORDS.whatNext)()
  expect(text()).toMatch(new RegExp(`${WORDS.score(0, 1)}|${WORDS.score(1, 1)}`))
})

it('each answer counts as right or wrong by the trace', async () => {
  await loaded()
  press(WORDS.ask)
  let [right, count] = [0, 0]
  for (step = 0; step < player.steps - 1; step++) {
    player.follow()
    if (!text().includes(WORDS.whatNext)) continue
    after(WORDS.whatNext)()
    count += 1
    if (text().includes(WORDS.right)) right += 1
    expect(text()).toContain(WORDS.score(right, count))
  }
  expect(count).toBeGreaterThan(2)
  expect(right).toBeGreaterThan(0)
  expect(right).toBeLessThan(count)
})

it('of circles that are refused says why, shows their diagram, and is well again with others', async () => {
  asked[0]?.refuse(new Error('There are too many.'))
  await expect(player.ready).rejects.toThrow('There are too many.')
  expect(text()).toContain('There are too many.')
  expect([view.hasDiagram, player.steps]).toEqual([true, 0])
  player.play()
  listeners.get('changed')?.(undefined)
  await vi.advanceTimersByTimeAsync(10)
  expect(text()).toContain('There are too many.')
  await loaded()
  expect(text()).not.toContain('There are too many.')
  expect(step).toBe(0)
})

it('an answer about circles that have changed since is not shown', async () => {
  circles = [...FIVE, 20, 20, 1]
  listeners.get('changed')?.(undefined)
  asked[0]?.answer()
  await vi.advanceTimersByTimeAsync(10)
  expect(player.steps).toBe(0)
  await loaded()
  const steps = player.steps
  circles = FIVE
  listeners.get('changed')?.(undefined)
  await loaded()
  expect(player.steps).toBeLessThan(steps)
})

it('a player that is disposed of between two steps goes no farther', async () => {
  await loaded()
  press(WORDS.play)
  seconds(1)
  player.dispose()
  seconds(100)
  expect([step, view.hasDiagram]).toEqual([1, true])
})

it('a player that is disposed of while it plays or loads is silent, and the diagram is there again', async () => {
  await loaded()
  press(WORDS.play)
  seconds(1)
  listeners.get('changed')?.(undefined)
  player.play()
  player.dispose()
  const before = [step, told.length]
  await loaded().catch(() => {})
  seconds(100)
  expect([step, told.length]).toEqual(before)
  expect([view.hasDiagram, view.above, listeners.size]).toEqual([true, [], 0])
})

/** Presses a key, and returns whether the player used it. */
function key(name: string, more: object = {}): boolean {
  let isUsed = false
  const target = { closest: () => null }
  const event = { key: name, target, preventDefault: () => (isUsed = true), stopPropagation() {}, ...more }
  for (const listen of root.keys) listen(event)
  return isUsed
}

it('keys go forward, back, to both ends and from stage to stage, and end playback', async () => {
  await loaded()
  const last = player.steps - 1
  const seen = ['ArrowRight', 'ArrowRight', 'ArrowLeft', 'End', 'Home', 'PageDown'].map((name) => [key(name), step])
  expect(seen.slice(0, 5)).toEqual([1, 2, 1, last, 0].map((place) => [true, place]))
  const second = step as number
  expect(second).toBeGreaterThan(0)
  key('PageDown')
  key('PageUp')
  expect(step).toBe(second)
  expect([
    key('x'),
    key('ArrowRight', { altKey: true }),
    key('End', { ctrlKey: true }),
    key('End', { metaKey: true }),
  ]).toEqual([false, false, false, false])
  expect(step).toBe(second)
  key(' ')
  seconds(1)
  expect(step).toBe(second + 1)
  key('ArrowLeft')
  seconds(5)
  expect(step).toBe(second)
  key(' ')
  key(' ')
  seconds(5)
  expect(step).toBe(second)
})

it('the forward button ends at the last step, and the back button at the first', async () => {
  await loaded()
  const isDisabled = (label: string) => {
    const parts = partsOf(page)
    return parts.slice(parts.indexOf(label)).find((part) => typeof part === 'boolean')
  }
  const seen = [0, 1, player.steps - 2, player.steps - 1].map((place) => {
    step = place
    player.follow()
    return [isDisabled(WORDS.back), isDisabled(WORDS.forth)]
  })
  expect(seen).toEqual([
    [true, false],
    [false, false],
    [false, false],
    [false, true],
  ])
})

it('changed circles are played from the same stage, or from the start within one, and the new step is told', async () => {
  await loaded()
  key('PageDown')
  key('PageDown')
  const before = step as number
  const line = partsOf(page)
    .join('')
    .match(/aria-current=step>([^<]*)/)?.[1]
  const change = async (more: number[]) => {
    circles = [...circles, ...more]
    listeners.get('changed')?.(undefined)
    told = []
    await loaded()
  }
  await change([20, 20, 1])
  expect(told).toEqual([[step, player.steps]])
  expect(partsOf(page).join('')).toContain(`aria-current=step>${line}`)
  expect(step).toBeGreaterThanOrEqual(before)
  key('End')
  for (let k = 0; k < 8; k++) key('ArrowLeft')
  expect(text()).toMatch(/disc/)
  await change([-20, 20, 1])
  expect(step).toBe(0)
  // A player that is about to close has no step, and tells none.
  step = undefined
  await change([-20, -20, 1])
  expect([told, step]).toEqual([[], undefined])
})

it('the picture has the colors of the style sheet, also after they have changed', async () => {
  await loaded()
  step = 3
  player.follow()
  const colors = () => [...new Set((view.above as { color: string }[]).map(({ color }) => color))]
  expect(colors()).toEqual(['black'])
  color = 'white'
  listeners.get('style')?.(undefined)
  expect(colors()).toEqual(['white'])
})
