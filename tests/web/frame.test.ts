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
  /** The check while the last state was set. */
  checkMeanwhile: unknown
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
    if (check === undefined || this.wrongCheck === undefined) return
    send(this, 'error', { detail: { error: this.wrongCheck } })
  }
  async setState(state: LinkInput) {
    const { refusal } = this
    this.refusal = undefined
    await this.wait()
    this.checkMeanwhile = this.#check
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
  const checks = () => [figure.checkMeanwhile, figure.check]
  expect(checks()).toEqual([undefined, QUESTION.check])
  await frame.request({ state: { layers: { hull: true } } })
  expect(checks()).toEqual([QUESTION.check, QUESTION.check])
  await frame.request({ state: { check: { cell: 0, edges: 3 } } })
  expect(checks()).toEqual([undefined, { cell: 0, edges: 3 }])
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
