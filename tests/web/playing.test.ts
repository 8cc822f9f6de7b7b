// SPDX-License-Identifier: GPL-3.0-or-later
// The player of the method in a figure with its thread: playing, asking, jumping, and circles that change.
// @vitest-environment happy-dom

import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import type { ProblemWords } from '../../web/editing/problem.ts'
import { showStep } from '../../web/editing/state.ts'
import { Diagram, Trace } from '../../web/lib/index.ts'
import { testedAt } from '../../web/player/discs.ts'
import { sentenceOf } from '../../web/player/sentences.ts'
import { type Colors, circlesAt, overlayOf, PLAYER_COLORS } from '../../web/player/step-overlay.ts'
import { concerns, kindOf, type Step, stepsOf } from '../../web/player/steps.ts'
import { type PlayerWords, ENGLISH_PLAYER as WORDS } from '../../web/player/words.ts'
import { NO_DOMAIN } from '../../web/view/domain.ts'
import { traced } from '../../web/view/painter/traced.ts'
import { all, control, controls, send, textOf } from './page-document.ts'
import { ThreadHere } from './page-threads.ts'
import { newFigure } from './whole-figure.ts'
import { quiet, soon, surround } from './whole-page.ts'

const SIX = Float64Array.of(0, 0, 2, 10, 1, 1, 5, 8, 1.5, 2, 6, 0.8, 9, 6, 2.2, 14, 2, 1)
const MANY = Float64Array.from({ length: 3003 }, (_, k) => [k, 0, 0.1][k % 3] as number)
let library: typeof import('./library.ts')['library']
let figure: ReturnType<typeof newFigure>
let words: PlayerWords | undefined
/** Notes what the player draws on the picture. */
let drawn: { readonly mock: { readonly lastCall?: readonly unknown[] | undefined } }
const above = () => drawn.mock.lastCall?.[0]
const problems: string[] = []
const told: (readonly [number, number])[] = []
const root = () => figure.player
const text = () => textOf(root()) ?? ''
const step = () => figure.step
const last = () => figure.stepping.steps - 1
const button = (name: string) => control(root(), name)
const isEnabled = (name: string) => !button(name).disabled
const sentence = () => textOf(root().querySelector('.sentence'))
const scene = (circles = SIX) => ({ circles: circles.slice(), dataSet: '', isEdited: false, domain: NO_DOMAIN })

async function press(name: string) {
  button(name).click()
  await quiet()
}
async function choose(name: string, value: string) {
  Object.assign(button(name), { value })
  send(button(name), 'change')
  await quiet()
}
async function go(to: number | undefined) {
  showStep(figure.store, to)
  await quiet()
}
/** Waits for the trace of a player that is opened. */
const loaded = () =>
  soon(async () => {
    await quiet()
    expect(controls(root()).size).toBeGreaterThan(0)
  })
/** Lets seconds pass. */
async function seconds(count: number) {
  for (let k = 0; k < count; k++) {
    await vi.advanceTimersByTimeAsync(1000)
    await quiet()
  }
}
async function key(name: string, more: object = {}, target: Element = root()) {
  const { defaultPrevented } = send(target, 'keydown', { key: name, ...more })
  await quiet()
  return [defaultPrevented, step()]
}
/** The steps that the player plays. */
function played() {
  const given = traced(library, SIX, Int32Array.from(SIX.subarray(0, SIX.length / 3).keys()), {})
  const events = new Trace(new Diagram(given.diagram), given.events)
  return { given, events, steps: stepsOf(events) }
}

beforeAll(async () => {
  surround()
  ;({ library } = await import('./library.ts'))
})
beforeEach(async () => {
  surround()
  document.body.innerHTML = ''
  words = undefined
  for (const list of [problems, told]) list.length = 0
  figure = newFigure({
    onstep: (...now) => told.push(now),
    onproblem: ({ message }) => problems.push(message),
    words: () => words && { refusals: {} as ProblemWords, player: words },
  })
  drawn = vi.spyOn(figure.view, 'overlays', 'set')
  await figure.open(scene())
  await go(0)
  await loaded()
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
})
afterEach(() => {
  vi.useRealTimers()
  figure.dispose()
})

describe('the player', () => {
  it('has the sentence, the line, the picture and the place of each step, and the diagram at the last', async () => {
    const { given, events, steps } = played()
    expect(last()).toBe(steps.length - 1)
    const colors = Object.fromEntries(Object.keys(PLAYER_COLORS).map((name) => [name, expect.any(String)]))
    for (const [k, each] of steps.entries()) {
      await go(k)
      const state = events.at(each.end)
      const known = circlesAt(events, given.circles, state, given.ids)
      const tested = testedAt(events, each, state, (id) => known.get(id))
      const isLast = k === last()
      const expected = isLast ? [] : overlayOf(events, each, state, tested, known, colors as Colors)
      expect(above(), each.line).toEqual(expected)
      expect(figure.view.hasDiagram).toBe(isLast)
      expect(sentence()).toBe(sentenceOf(events, each, tested, WORDS))
      expect(all(root(), '[aria-current=step]').map(textOf)).toEqual([WORDS.lines[each.line]])
      expect(textOf(root().querySelector('.where'))).toBe(`${k} / ${last()}`)
      expect(button(WORDS.stepLabel).getAttribute('aria-valuetext')).toBe(WORDS.stepOf(k, last()))
      expect([isEnabled(WORDS.back), isEnabled(WORDS.forth)]).toEqual([k > 0, !isLast])
      expect(told.at(-1)).toEqual([k, steps.length])
    }
  })

  it('plays a step each second and stops at the last, from where it plays from the start', async () => {
    await press(WORDS.play)
    await seconds(3)
    expect([step(), told.slice(-3)]).toEqual([3, [1, 2, 3].map((k) => [k, last() + 1])])
    await choose(WORDS.speed, '10')
    await seconds(1)
    expect(step()).toBe(13)
    await seconds(20)
    expect([step(), isEnabled(WORDS.play)]).toEqual([last(), true])
    await go(5)
    await seconds(1)
    expect(step()).toBe(5)
    await go(last())
    await press(WORDS.play)
    expect(step()).toBe(0)
    await seconds(1)
    expect(step()).toBe(10)
    await press(WORDS.pause)
    await choose(WORDS.speed, '30')
    await seconds(1)
    expect(step()).toBe(10)
  })

  it('asks before each step whose outcome is open, and counts right answers by the trace', async () => {
    await press(WORDS.ask)
    await choose(WORDS.speed, '30')
    let [right, count] = [0, 0]
    while (step() !== last()) {
      await press(WORDS.play)
      await seconds(3)
      const question = root().querySelector('[role=group]')
      if (question === null) continue
      const before = step() as number
      expect(question.getAttribute('aria-label')).toBe(WORDS.whatNext)
      const answer = question.querySelector('button') as HTMLElement
      answer.focus()
      answer.click()
      await quiet()
      count += 1
      if (text().includes(WORDS.right)) right += 1
      expect([step(), text().includes(WORDS.score(right, count))]).toEqual([before + 1, true])
      expect(document.activeElement).toBe(button(WORDS.forth))
      // The answer is explained beside the next step only.
      await press(WORDS.forth)
      expect(text()).not.toContain(WORDS.score(right, count))
    }
    expect([count > 2, right > 0, right < count]).toEqual([true, true, true])
  })

  it('jumps to the next and the previous step of each kind, of the selected circle, and with a breakpoint', async () => {
    const { events, steps } = played()
    await go(4)
    await press(WORDS.breakHere)
    figure.actions.selection.select([3])
    await quiet()
    const holds: Record<string, (step: Step, k: number) => boolean> = {
      breakpoint: (_, k) => k === 4,
      selected: (_, k) => concerns(events, steps, k, 3),
    }
    for (const goal of Object.keys(WORDS.goals)) {
      await go(0)
      await choose(WORDS.goal, goal)
      const isGoal = holds[goal] ?? ((step: Step) => kindOf(step) === goal)
      const wanted = steps.flatMap((step, k) => (k > 0 && isGoal(step, k) ? [k] : []))
      const seen: number[] = []
      while (isEnabled(WORDS.next)) {
        await press(WORDS.next)
        seen.push(step() as number)
      }
      expect(seen, goal).toEqual(wanted)
      while (isEnabled(WORDS.previous) && seen.length > 0) {
        expect(step()).toBe(seen.pop())
        await press(WORDS.previous)
      }
      expect(seen.length, goal).toBeLessThan(2)
    }
    await choose(WORDS.goal, 'selected')
    figure.actions.selection.select([])
    await quiet()
    expect(isEnabled(WORDS.next)).toBe(false)
    await choose(WORDS.goal, 'stage')
    await go(0)
    await press(WORDS.play)
    await press(WORDS.next)
    const place = step()
    await seconds(3)
    expect([place === 0, step()], 'a jump ends playback').toEqual([false, place])
  })

  it('has its texts in the language of the page', async () => {
    words = { ...WORDS, lang: 'xx', play: 'PLAY', localized: () => 'Zu viele.' }
    figure.stepping.redraw()
    expect([root().lang, controls(root()).has('PLAY')]).toEqual(['xx', true])
    await figure.open(scene(MANY))
    await soon(() => expect(sentence()).toBe('Zu viele.'))
  })
})

describe('keys in the player', () => {
  it('go forward, back, to both ends and from stage to stage, and end playback', async () => {
    const end = last()
    const places = []
    for (const name of ['ArrowRight', 'ArrowRight', 'ArrowLeft', 'End', 'Home']) places.push(await key(name))
    expect(places).toEqual([1, 2, 1, end, 0].map((place) => [true, place]))
    const [, second] = await key('PageDown')
    await key('PageDown')
    expect(await key('PageUp')).toEqual([true, second])
    for (const [name, more] of [
      ['x', {}],
      ['ArrowRight', { altKey: true }],
      ['End', { ctrlKey: true }],
      ['End', { metaKey: true }],
    ] as const) {
      expect(await key(name, more)).toEqual([false, second])
    }
    await key(' ')
    await seconds(1)
    expect(step()).toBe(Number(second) + 1)
    await key('ArrowLeft')
    await seconds(2)
    expect(step()).toBe(second)
    await key(' ')
    await key(' ')
    await seconds(2)
    expect(step()).toBe(second)
  })

  it('that a button or a list uses stay with it, and all others do not reach the page', async () => {
    const reached: string[] = []
    document.body.addEventListener('keydown', (event) => reached.push(event.key))
    expect(await key(' ', {}, button(WORDS.play))).toEqual([false, 0])
    expect(await key('End', {}, button(WORDS.speed))).toEqual([false, 0])
    expect(await key('ArrowRight', {}, button(WORDS.play))).toEqual([true, 1])
    expect(reached).toEqual([])
    await key('x')
    expect(reached).toEqual(['x'])
  })
})

it('a player that begins anew ends the thread of its former trace', async () => {
  await quiet()
  const [painting] = ThreadHere.running
  // No message arrives meanwhile.
  const briefly = async () => {
    for (let turn = 0; turn < 50; turn++) await Promise.resolve()
  }
  for (const circles of [SIX, SIX.slice(3)]) {
    await figure.open(scene(circles))
    vi.advanceTimersByTime(150)
    await briefly()
    expect(ThreadHere.running.size).toBe(2)
  }
  figure.stepping.restart()
  expect([...ThreadHere.running]).toEqual([painting])
})

describe('a player that is closed', () => {
  it('shows the diagram, goes no farther, and does not play as it is opened again', async () => {
    await press(WORDS.play)
    await seconds(1)
    await go(undefined)
    expect([figure.view.hasDiagram, above(), root().innerHTML.replace(/<!--.*?-->/g, '')]).toEqual([true, [], ''])
    await seconds(3)
    figure.stepping.restart()
    expect(step()).toBeUndefined()
    await go(0)
    await loaded()
    await seconds(3)
    expect(step()).toBe(0)
    figure.stepping.play()
    await seconds(1)
    expect(step()).toBe(1)
    figure.stepping.restart()
    await quiet()
    expect(step()).toBe(0)
  })

  it.each(['closed', 'disposed of'])('or that was %s while it loaded is no problem', async (how) => {
    await go(undefined)
    showStep(figure.store, 2)
    if (how === 'closed') showStep(figure.store, undefined)
    else figure.dispose()
    await quiet()
    expect([problems, controls(root()).size]).toEqual([[], 0])
  })
})
