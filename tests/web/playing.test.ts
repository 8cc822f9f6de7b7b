// SPDX-License-Identifier: GPL-3.0-or-later
// The player of the method while it plays, asks, and loses or changes its circles, without a browser.
import type { TemplateResult } from 'lit/html.js'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { Diagram } from '../../web/lib/index.ts'
import { Trace, type TraceOptions } from '../../web/lib/wasm/trace.ts'
import { testedAt } from '../../web/player/discs.ts'
import { mountPlayer, type Player } from '../../web/player/player.ts'
import { sentenceOf } from '../../web/player/sentences.ts'
import { circlesAt, overlayOf, PLAYER_COLORS } from '../../web/player/step-overlay.ts'
import { concerns, kindOf, stepsOf } from '../../web/player/steps.ts'
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
/** A part of the player that can have the focus. */
interface Part {
  isConnected?: boolean
  matches?(selector: string): boolean
  focus?(): void
}
let root: {
  dir: string
  lang: string
  keys: ((event: unknown) => void)[]
  classes: string[]
  sheets: { adoptedStyleSheets: unknown[] }
  /** The parts by their selectors. */
  parts: Record<string, Part | object>
  resize(): void
}
let words: typeof WORDS | undefined
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
      constructor(resize: () => void) {
        root.resize = resize
      }
      observe() {}
      disconnect() {
        root.resize = () => {}
      }
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
  words = undefined
  const keys: ((event: unknown) => void)[] = []
  const fakeRoot = {
    keys,
    dir: '',
    lang: '',
    classes: [] as string[],
    sheets: { adoptedStyleSheets: [] },
    parts: {} as Record<string, Part | object>,
    resize: () => {},
    scrollHeight: 0,
    clientHeight: 0,
    scrollTop: 0,
    classList: {
      add: (name: string) => fakeRoot.classes.push(name),
      remove: (name: string) => fakeRoot.classes.splice(fakeRoot.classes.indexOf(name), 1),
    },
    getRootNode: () => fakeRoot.sheets,
    getBoundingClientRect: () => ({ bottom: 100 }),
    addEventListener: (_: string, listen: (event: unknown) => void, { signal }: { signal: AbortSignal }) => {
      keys.push(listen)
      signal.addEventListener('abort', () => keys.splice(keys.indexOf(listen), 1))
    },
    querySelector: (selector: string) => fakeRoot.parts[selector] ?? null,
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
    words: () => words,
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
  expect([typeof page, root.classes, root.keys]).toEqual(['symbol', [], []])
  player.play()
  seconds(100)
  expect([step, told.length]).toEqual(before)
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

/** The steps of the trace that is played. */
function trace() {
  const given = traced(library, library.edit(Float64Array.from(circles)).snapshot(), {})
  const events = new Trace(new Diagram(given.diagram), given.events)
  return { given, events, steps: stepsOf(events) }
}

it('each step has its sentence, its line of the program, its picture and its place, and the last one the diagram', async () => {
  await loaded()
  const { given, events, steps } = trace()
  const colors = Object.fromEntries(Object.keys(PLAYER_COLORS).map((name) => [name, color])) as never
  for (const [k, each] of steps.entries()) {
    step = k
    player.follow()
    const state = events.at(each.end)
    const known = circlesAt(events, given.circles, state, given.ids)
    const tested = testedAt(events, each, state, (id) => known.get(id))
    const isLast = k === steps.length - 1
    expect(view.above, each.line).toEqual(isLast ? [] : overlayOf(events, each, state, tested, known, colors))
    expect(view.hasDiagram).toBe(isLast)
    expect(text()).toContain(`>${sentenceOf(events, each, tested, WORDS)}<`)
    expect(text()).toContain(`aria-current=step>${WORDS.lines[each.line]}<`)
    expect(text()).toContain(`class="where">${k}<span class="of"> / ${steps.length - 1}<`)
    const parts = partsOf(page)
    expect([parts[parts.indexOf(WORDS.stepLabel) + 2]]).toEqual([WORDS.stepOf(k, steps.length - 1)])
  }
})

it('jumps to the next and the previous step of each kind, of the selected circle, and with a breakpoint', async () => {
  await loaded()
  const { events, steps } = trace()
  const isDisabled = (label: string) => {
    const parts = partsOf(page)
    return parts.slice(parts.indexOf(label)).find((part) => typeof part === 'boolean')
  }
  const go = (to: number) => {
    step = to
    player.follow()
  }
  go(4)
  press(WORDS.breakHere)
  go(0)
  listeners.get('marked')?.({ selected: { id: 3 } })
  for (const goal of [...Object.keys(WORDS.goals)]) {
    go(0)
    after(WORDS.goal)({ target: { value: goal } })
    const holds = (k: number) =>
      goal === 'breakpoint'
        ? k === 4
        : goal === 'selected'
          ? concerns(events, steps, k, 3)
          : kindOf(steps[k] as (typeof steps)[number]) === goal
    const wanted = steps.flatMap((_, k) => (k > 0 && holds(k) ? [k] : []))
    const seen: number[] = []
    while (isDisabled(WORDS.next) === false && seen.length < 500) {
      press(WORDS.next)
      seen.push(step as number)
    }
    expect(seen, goal).toEqual(wanted)
    while (isDisabled(WORDS.previous) === false && seen.length > 0) {
      expect(step).toBe(seen.pop())
      press(WORDS.previous)
    }
    expect(seen.length, goal).toBeLessThan(2)
  }
  // A jump ends playback.
  go(0)
  after(WORDS.goal)({ target: { value: 'stage' } })
  press(WORDS.play)
  press(WORDS.next)
  const place = step
  seconds(9)
  expect([step, text().includes(WORDS.play)]).toEqual([place, true])
  listeners.get('marked')?.({ selected: undefined })
  go(0)
  after(WORDS.goal)({ target: { value: 'selected' } })
  expect(isDisabled(WORDS.next)).toBe(true)
  go(4)
  press(WORDS.breakHere)
  go(0)
  after(WORDS.goal)({ target: { value: 'breakpoint' } })
  expect(isDisabled(WORDS.next)).toBe(true)
})

it('has the list of waiting discs, and the ring of the selected circle or of the first one of the step', async () => {
  await loaded()
  const { events, steps } = trace()
  const first = steps.findIndex(({ line }) => line === 'place')
  step = 0
  player.follow()
  expect(text()).toContain(WORDS.queue(0))
  expect(text()).toContain(WORDS.selectOne)
  step = first
  player.follow()
  const [id] = events.event(steps[first]?.event as number).circles as [number]
  expect(text()).toContain(WORDS.aroundCircle(id, false))
  expect(text()).not.toContain(WORDS.queue(0))
  // A ring with one neighbor: an edge out and one in at the same place, and the arc between them, in two parts.
  const [, x] = text().match(/<svg x=([\d.]+%) [\s\S]*d=M-3 50V24/) ?? []
  expect(text()).toContain(`<line class="unused" x1=${x} x2=97.00% `)
  expect(text()).toContain(`<line class="unused" x1=3.00% x2=${x} `)
  expect(text()).toMatch(new RegExp(`<svg x=${x} [\\s\\S]*d=M3 24V50[\\s\\S]*<circle class="foot" cx=${x}`))
  const listed = () => [text().match(/<li><span>\d+[–·]/g)?.length, text().match(/and (\d+) more/)?.[1]]
  expect(listed()).toEqual([6, undefined])
  step = steps.findIndex(({ line }) => line === 'pairs')
  player.follow()
  expect(listed()).toEqual([6, '1'])
  expect(text()).toContain(WORDS.queue(7))
  step = first
  player.follow()
  listeners.get('marked')?.({ selected: { id: 4 } })
  expect(text()).toContain(WORDS.aroundCircle(4, true))
  const before = page
  listeners.get('marked')?.({ selected: { id: 4 } })
  expect(page).toBe(before)
  listeners.get('marked')?.({ selected: undefined })
  expect(text()).toContain(WORDS.aroundCircle(id, false))
})

it('keys that a button or a list uses stay with it, and all others do not reach the page', async () => {
  await loaded()
  let isStopped = false
  const at = (name: string, selectors: string) => {
    isStopped = false
    const closest = (selector: string) => (selector.includes(selectors) ? {} : null)
    return [key(name, { target: { closest }, stopPropagation: () => (isStopped = true) }), isStopped, step]
  }
  expect(at(' ', 'button')).toEqual([false, true, 0])
  expect(at('End', 'select')).toEqual([false, true, 0])
  expect(at('x', 'nothing')).toEqual([false, false, 0])
  expect(at('ArrowRight', 'button')).toEqual([true, true, 1])
})

it('keeps the focus where its button is disabled or gone, and gives it to the next step after an answer', async () => {
  await loaded()
  const focused: string[] = []
  const part = (name: string): Part => ({ focus: () => focused.push(name) })
  root.parts = { input: part('slider'), '[data-forth]': part('forth') }
  for (const [isConnected, isDisabled, count] of [
    [true, false, 0],
    [false, false, 1],
    [true, true, 2],
  ] as const) {
    root.parts[':focus'] = { isConnected, matches: (selector: string) => isDisabled && selector === ':disabled' }
    player.redraw()
    expect(focused).toHaveLength(count)
  }
  expect(new Set(focused)).toEqual(new Set(['slider']))
  delete root.parts[':focus']
  press(WORDS.ask)
  press(WORDS.play)
  seconds(1000)
  after(WORDS.whatNext)()
  expect(focused.at(-1)).toBe('forth')
})

it('scrolls the current line between its head and its end, if the head stays there', async () => {
  const scrolled = root as unknown as { scrollHeight: number; clientHeight: number; scrollTop: number }
  let position = 'sticky'
  vi.stubGlobal('getComputedStyle', () => ({ position }))
  let line = { top: 50, bottom: 60 }
  let rects: object[] = [{}]
  root.parts = {
    '[aria-current]': { getClientRects: () => rects, getBoundingClientRect: () => line },
    '.head': { getBoundingClientRect: () => ({ bottom: 30 }) },
  }
  Object.assign(scrolled, { scrollHeight: 200, clientHeight: 100 })
  await loaded()
  const reveal = (at: typeof line) => {
    line = at
    scrolled.scrollTop = 40
    player.redraw()
    return scrolled.scrollTop
  }
  expect(reveal({ top: 50, bottom: 60 })).toBe(40)
  expect(reveal({ top: 20, bottom: 30 })).toBe(40 - 10 - 24)
  expect(reveal({ top: 105, bottom: 115 })).toBe(40 + 15 + 24)
  position = 'static'
  expect(reveal({ top: 20, bottom: 30 })).toBe(40)
  position = 'sticky'
  rects = []
  expect(reveal({ top: 20, bottom: 30 })).toBe(40)
  rects = [{}]
  scrolled.scrollHeight = 100
  expect(reveal({ top: 20, bottom: 30 })).toBe(40)
})

it('has its texts in the language of its page, its style sheet once, and its timeline as wide as it is', async () => {
  await loaded()
  expect([root.lang, root.classes, root.sheets.adoptedStyleSheets.length]).toEqual(['en', ['cv-player'], 1])
  words = { ...WORDS, lang: 'xx', play: 'PLAY' }
  player.redraw()
  expect([root.lang, text().includes('PLAY')]).toEqual(['xx', true])
  vi.stubGlobal('devicePixelRatio', 1)
  const canvas = { clientWidth: 50, clientHeight: 9, width: 0, getContext: () => null }
  root.parts.canvas = canvas
  root.resize()
  expect(canvas.width).toBe(50)
  words = { ...WORDS, told: () => 'Zu viele.' }
  listeners.get('changed')?.(undefined)
  await vi.advanceTimersByTimeAsync(200)
  asked.at(-1)?.refuse(new Error('Too many.'))
  await expect(player.ready).rejects.toThrow('Too many.')
  expect([text().includes('Zu viele.'), view.above]).toEqual([true, []])
  // There is no timeline without steps.
  canvas.width = 0
  root.resize()
  expect(canvas.width).toBe(0)
})

it('a step that does not exist becomes the nearest one, and a missing answer is a problem', async () => {
  await loaded()
  const last = player.steps - 1
  for (const [wanted, found] of [
    [1e9, last],
    [-5, 0],
    [1.6, 2],
    [Number.NaN, 0],
  ] as const) {
    step = wanted
    player.follow()
    expect(step).toBe(found)
  }
  listeners.get('changed')?.(undefined)
  await vi.advanceTimersByTimeAsync(149)
  const count = asked.length
  await vi.advanceTimersByTimeAsync(1)
  expect(asked.length).toBe(count + 1)
  expect(view.above).toEqual([])
  step = 3
  player.follow()
  expect(step).toBe(3)
})
