// SPDX-License-Identifier: GPL-3.0-or-later
// The page of one figure: its texts, its messages, and states that come one after the other.
// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { FrameMessage } from '../../web/element/frame-types.ts'
import { Frame } from '../../web/embed/frame.ts'
import { encodeLink, type LinkInput } from '../../web/lib/link.ts'
import { make, send } from './page-document.ts'
import { eventually } from './turns.ts'

const PARTS = ['texts', 'title', 'question', 'met', 'again', 'open', 'problem']
const CIRCLES = [
  [0, 0, 2],
  [10, 0, 2],
]
const QUESTION: LinkInput = { circles: CIRCLES, title: 'Neighbors', check: { cell: 1, edges: 3 } }

/** The element, which records the states that it was given. */
class Figure extends HTMLElement {
  readonly states: LinkInput[] = []
  /** The check while the last state was set. */
  checkMeanwhile: unknown
  state: { circles: unknown } = { circles: [] }
  /** The error of the next state. */
  refusal: Error | undefined
  /** The error that the next check causes. */
  wrongCheck: Error | undefined
  wait = async () => {}
  updateComplete = Promise.resolve()
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
let resize: () => void
let told: FrameMessage[]
let frame: Frame
let loads: Map<string, (circles: Float64Array) => void>

beforeEach(() => {
  figure = new Figure()
  main = make('main', {}, figure, ...PARTS.map((id) => make('p', { id })))
  document.body.replaceChildren(main)
  told = []
  loads = new Map()
  vi.stubGlobal(
    'ResizeObserver',
    class {
      constructor(resized: () => void) {
        resize = resized
      }
      observe() {}
    },
  )
  frame = new Frame(main, {
    load: (name) =>
      new Promise((resolve) => loads.set(name, (circles) => resolve({ circles, domain: { region: REGION } }))),
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

it('tells a height that changes while a report is pending once, with the report', async () => {
  await frame.open(await encodeLink(QUESTION))
  told.length = 0
  let complete = () => {}
  figure.updateComplete = new Promise((resolve) => {
    complete = resolve
  })
  const reported = frame.request({})
  Object.assign(main, { getBoundingClientRect: () => ({ height: 300 }) })
  resize()
  complete()
  await reported
  resize()
  expect(told.map(({ height }) => height)).toEqual([300])
})

it('has no check of other circles while it shows new ones, and tells an error of the new check', async () => {
  await frame.open(await encodeLink(QUESTION))
  const checks = () => [figure.checkMeanwhile, figure.check]
  expect(checks()).toEqual([undefined, QUESTION.check])
  await frame.request({ state: { layers: { hull: true } } })
  expect(checks()).toEqual([QUESTION.check, QUESTION.check])
  await frame.request({ state: { check: { cell: 0, edges: 3 } } })
  expect(checks()).toEqual([undefined, { cell: 0, edges: 3 }])
  expect(document.title).toBe('Neighbors')
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
