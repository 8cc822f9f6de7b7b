// SPDX-License-Identifier: GPL-3.0-or-later
// The page of one figure: its texts, its messages, and states that come one after the other.
// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { FrameMessage } from '../../web/element/frame-types.ts'
import { Frame } from '../../web/embed/frame.ts'
import { encodeLink, type LinkInput } from '../../web/lib/link.ts'
import { make, send } from './page-document.ts'
import { aTurn, eventually } from './turns.ts'

const PARTS = ['texts', 'title', 'question', 'met', 'again', 'open', 'problem']
const CIRCLES = [
  [0, 0, 2],
  [10, 0, 2],
]
const QUESTION: LinkInput = {
  circles: CIRCLES,
  title: 'Neighbors',
  question: 'Which?',
  check: { cell: 1, edges: 3 },
  alt: 'Two circles',
  lang: 'de',
  readonly: true,
}

/** The element, which records the states that it was given. */
class Figure extends HTMLElement {
  readonly states: LinkInput[] = []
  readonly order: string[] = []
  controls: string | undefined
  readonly = false
  alt = ''
  override lang = ''
  view: unknown = 'unset'
  state: { circles: unknown; view?: unknown } = { circles: [] }
  /** The error of the next state. */
  refusal: Error | undefined
  /** The error that the next check causes. */
  wrongCheck: Error | undefined
  wait = async () => {}
  updateComplete: Promise<unknown> = Promise.resolve()
  #check: unknown
  get check(): unknown {
    return this.#check
  }
  set check(check: unknown) {
    this.#check = check
    this.order.push(check === undefined ? 'no check' : 'check')
    if (check === undefined || this.wrongCheck === undefined) return
    send(this, 'error', { detail: { error: this.wrongCheck } })
  }
  async setState(state: LinkInput) {
    const { refusal } = this
    this.refusal = undefined
    await this.wait()
    this.order.push('state')
    if (refusal !== undefined) throw refusal
    this.states.push(state)
    if (state.circles !== undefined) this.state = { circles: [...(state.circles as Iterable<number>)] }
    send(this, 'circleschange')
  }
  getState = () => this.state
}

customElements.define('circle-voronoi', Figure)

let figure: Figure
let main: HTMLElement
let told: FrameMessage[]
let frame: Frame
let loads: Map<string, (circles: Float64Array) => void>
let resized: () => void
let height: number
let observed: unknown[]
const part = (id: string) => main.querySelector(`#${id}`) as HTMLElement

beforeEach(() => {
  figure = new Figure()
  main = make('main', {}, figure, ...PARTS.map((id) => make('p', { id })))
  document.body.replaceChildren(main)
  height = 100
  observed = []
  Object.assign(main, { getBoundingClientRect: () => ({ height: main.classList.contains('natural') ? height : 1 }) })
  told = []
  loads = new Map()
  vi.stubGlobal(
    'ResizeObserver',
    class {
      constructor(change: () => void) {
        resized = change
      }
      observe = (node: unknown) => observed.push(node)
    },
  )
  frame = new Frame(main, {
    load: (name) =>
      name === ''
        ? Promise.resolve({ circles: new Float64Array() })
        : new Promise((resolve) => loads.set(name, (circles) => resolve({ circles, domain: { region: REGION } }))),
    tell: (message) => told.push(message),
  })
})
afterEach(() => vi.unstubAllGlobals())

const REGION = [
  [
    [0, 0],
    [9, 0],
    [9, 9],
  ],
] as const

const texts = () => ({
  title: part('title').textContent,
  question: part('question').textContent,
  open: part('open').textContent,
  again: part('again').textContent,
  met: part('met').textContent,
  page: document.title,
  lang: document.documentElement.lang,
})
const hidden = () => PARTS.filter((id) => part(id).hidden)
const unseen = () => PARTS.filter((id) => part(id).classList.contains('visually-hidden'))

it('has the texts of a question, and the usual ones without', async () => {
  await frame.open(await encodeLink(QUESTION))
  expect(texts()).toEqual({
    title: 'Neighbors',
    question: 'Which?',
    open: 'Öffnen',
    again: 'Neu beginnen',
    met: 'Noch nicht gelöst',
    page: 'Neighbors',
    lang: 'de',
  })
  expect([hidden(), unseen()]).toEqual([['again', 'open', 'problem'], []])
  expect([figure.readonly, figure.alt, figure.lang]).toEqual([true, 'Two circles', 'de'])
  await frame.open(await encodeLink({ circles: CIRCLES }))
  expect(texts()).toMatchObject({ title: 'Voronoi diagram of circles', question: '', open: 'Open', lang: 'en' })
  expect(document.title).toBe('Voronoi diagram of circles')
  expect([hidden(), unseen()]).toEqual([
    ['question', 'met', 'again', 'problem'],
    ['texts', 'title'],
  ])
  expect([figure.readonly, figure.alt, figure.lang]).toEqual([false, '', undefined])
  for (const [state, seen] of [
    [{ title: 'A' }, []],
    [{ question: 'A' }, ['title']],
    [{ check: { circles: 1 } }, ['title']],
  ] as const) {
    await frame.open(await encodeLink({ circles: CIRCLES, ...state }))
    expect(unseen()).toEqual(seen)
  }
})

it('has its texts before its circles, and none of either where a link has none', async () => {
  let go = () => {}
  figure.wait = () => new Promise<void>((resolve) => (go = resolve))
  const opening = frame.open(await encodeLink(QUESTION))
  await eventually(() => expect(document.title).toBe('Neighbors'))
  expect(figure.states).toEqual([])
  figure.wait = async () => {}
  await eventually(() => {
    go()
    expect(figure.states).toHaveLength(1)
  })
  await opening
  await frame.open(await encodeLink({ layers: { hull: true } }))
  expect(figure.states.at(-1)).toMatchObject({ circles: new Float64Array(), region: undefined })
})

it('shows a player where a state has a step, and buttons where it has circles and none', async () => {
  const seen: unknown[] = []
  for (const state of [{ circles: CIRCLES }, { step: 2 }, { layers: {} }, { circles: CIRCLES, step: 0 }]) {
    if ('circles' in state) await frame.open(await encodeLink(state as LinkInput))
    else await frame.request({ state: state as LinkInput })
    seen.push(figure.controls)
  }
  expect(seen).toEqual(['', 'player', 'player', 'player'])
})

it('has no check of other circles while it shows new ones, and tells an error of the new check', async () => {
  await frame.open(await encodeLink(QUESTION))
  expect(figure.order).toEqual(['no check', 'state', 'check'])
  figure.order.length = 0
  await frame.request({ state: { layers: { hull: true } } })
  expect(figure.order).toEqual(['state', 'check'])
  figure.order.length = 0
  await frame.request({ state: { check: { cell: 0, edges: 3 } } })
  expect(figure.order).toEqual(['no check', 'state', 'check'])
  expect(figure.check).toEqual({ cell: 0, edges: 3 })
  expect(texts().title).toBe('Neighbors')
  figure.wrongCheck = new Error('There is no circle 9.')
  await frame.request({ state: { check: { cell: 9, edges: 3 } } })
  expect(told.at(-1)?.error).toBe('There is no circle 9.')
  figure.wrongCheck = undefined
  await frame.request({ state: { check: { cell: 1, edges: 3 } } })
  expect(told.at(-1)?.error).toBeUndefined()
  send(figure, 'error', { detail: { error: new Error('later') } })
  await frame.request({})
  expect(told.at(-1)?.error).toBeUndefined()
})

it('says whether the check is met, once for each change, and reports it with the circles', async () => {
  await frame.open(await encodeLink({ ...QUESTION, lang: '' }))
  let assigned = 0
  const met = part('met')
  let text = met.textContent
  Object.defineProperty(met, 'textContent', {
    get: () => text,
    set: (next: string) => {
      assigned += 1
      text = next
    },
  })
  for (const [isMet, said, count] of [
    [false, 'Not solved yet', 0],
    [true, 'Solved', 1],
    [true, 'Solved', 1],
    [false, 'Not solved yet', 2],
  ] as const) {
    send(figure, 'checkchange', { detail: { isMet } })
    expect([text, met.dataset.met, assigned]).toEqual([said, String(isMet), count])
    await aTurn()
    expect(told.at(-1)?.met).toBe(isMet)
    expect(JSON.parse(told.at(-1)?.answer as string)).toEqual({ circles: figure.state.circles, check: isMet })
  }
  await frame.open(await encodeLink({ circles: CIRCLES }))
  expect(told.at(-1)).toMatchObject({ type: 'circle-voronoi', height: 100, met: undefined, error: undefined })
  expect(JSON.parse(told.at(-1)?.answer as string)).toEqual({ circles: CIRCLES.flat() })
})

it('starts over once the circles of a question have changed', async () => {
  await frame.open(await encodeLink({ ...QUESTION, region: REGION }))
  expect(part('again').hidden).toBe(true)
  send(figure, 'circleschange')
  await aTurn()
  expect(part('again').hidden).toBe(false)
  await frame.request({ state: { layers: { hull: true } } })
  expect(part('again').hidden).toBe(false)
  part('again').click()
  await aTurn()
  await aTurn()
  expect(figure.states.at(-1)).toHaveProperty('region', REGION)
  expect([...(figure.states.at(-1) as { circles: Float64Array }).circles]).toEqual(CIRCLES.flat())
  expect([document.activeElement === figure, part('again').hidden]).toEqual([true, true])
  await frame.open(await encodeLink(QUESTION))
  await frame.startOver()
  expect(figure.states.at(-1)).toHaveProperty('region', null)
  await frame.open(await encodeLink({ circles: CIRCLES }))
  send(figure, 'circleschange')
  await aTurn()
  expect(part('again').hidden).toBe(true)
})

it('shows the newest state, however late others are, and no error of older ones', async () => {
  const first = frame.open(await encodeLink({ dataSet: 'first' }))
  const second = frame.open(await encodeLink({ dataSet: 'second', title: 'Second' }))
  await eventually(() => expect(loads.size).toBe(2))
  expect(told).toEqual([])
  loads.get('second')?.(Float64Array.of(2, 2, 2))
  await second
  loads.get('first')?.(Float64Array.of(1, 1, 1))
  await first
  expect(figure.states.map(({ circles }) => [...(circles as Float64Array)])).toEqual([[2, 2, 2]])
  expect(figure.states[0]).toMatchObject({ region: REGION })
  expect(document.title).toBe('Second')
  // The states are told once both are done.
  expect(told.map(({ state }) => state?.circles)).toEqual([[2, 2, 2]])
  let go = () => {}
  figure.wait = () => new Promise<void>((resolve) => (go = resolve))
  figure.refusal = new Error('late')
  const third = frame.request({ state: { layers: {} } })
  await eventually(() => expect(figure.refusal).toBeUndefined())
  figure.wait = async () => {}
  const fourth = frame.open(await encodeLink({ circles: CIRCLES }))
  go()
  await Promise.all([third, fourth])
  expect(told.at(-1)?.error).toBeUndefined()
  expect(told.at(-1)?.state?.circles).toEqual(CIRCLES.flat())
})

it('shows what is wrong with a link, until another one is right, and tells it', async () => {
  await frame.open('v1.AAAA')
  expect([part('problem').hidden, part('problem').textContent]).toEqual([false, told.at(-1)?.error])
  expect(told.at(-1)).toMatchObject({ state: undefined, met: undefined, answer: '', error: expect.any(String) })
  await frame.open(await encodeLink({ circles: CIRCLES }))
  expect([part('problem').hidden, part('problem').textContent]).toEqual([true, ''])
  await frame.request({ state: `https://example.org/#${await encodeLink({ circles: [[1, 1, 1]] })}` })
  expect(figure.state.circles).toEqual([1, 1, 1])
})

it('tells changes together once they are computed, and the current state where it is asked', async () => {
  await frame.open(await encodeLink({ circles: CIRCLES }))
  told.length = 0
  let complete = () => {}
  figure.updateComplete = new Promise<void>((resolve) => (complete = resolve))
  send(figure, 'circleschange')
  send(figure, 'stepchange')
  send(figure, 'checkchange', { detail: { isMet: true } })
  await aTurn()
  expect(told).toEqual([])
  complete()
  await aTurn()
  expect(told).toHaveLength(1)
  await frame.request({})
  expect(told).toHaveLength(2)
  send(figure, 'stepchange')
  await aTurn()
  expect(told).toHaveLength(3)
  frame.restore(Float64Array.of(1, 1, 1))
  expect(Reflect.get(figure, 'circles')).toEqual(Float64Array.of(1, 1, 1))
})

it('tells its height where that changes, and keeps all circles visible where they are', async () => {
  expect(observed).toEqual([main, part('texts')])
  resized()
  expect(figure.view).toBe('unset')
  await frame.open(await encodeLink({ circles: CIRCLES }))
  told.length = 0
  resized()
  await aTurn()
  expect([told, figure.view]).toEqual([[], undefined])
  height = 199.5
  resized()
  expect(told.map(({ height }) => height)).toEqual([200])
  expect(main.classList.contains('natural')).toBe(false)
  await aTurn()
  figure.state = { circles: [], view: { x: 1, y: 2, span: 3 } }
  await frame.request({})
  figure.view = 'kept'
  resized()
  await aTurn()
  expect(figure.view).toBe('kept')
})
