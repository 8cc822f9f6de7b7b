// SPDX-License-Identifier: GPL-3.0-or-later
// The captions on the picture: the first hint, the status, progress, toasts, the legend, the scale and names.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { PageActions } from '../../web/app/page-actions.ts'
import { drawLegend, mountLegend } from '../../web/app/panels/legend.ts'
import { mountNames } from '../../web/app/panels/names.ts'
import { mountProgress } from '../../web/app/panels/progress.ts'
import { mountSay } from '../../web/app/panels/say.ts'
import { mountScale } from '../../web/app/panels/scale.ts'
import { mountStatus } from '../../web/app/panels/status.ts'
import { toast } from '../../web/app/panels/toast.ts'
import type { Editing } from '../../web/editing/editing.ts'
import { EMPTY_HISTORY, type History } from '../../web/editing/history.ts'
import type { Stage } from '../../web/editing/opening-actions.ts'
import type { Remedy, State } from '../../web/editing/state.ts'
import type { Legend } from '../../web/view/protocol.ts'
import type { Style } from '../../web/view/style.ts'
import type { View } from '../../web/view/view.ts'
import {
  all,
  choose,
  controls,
  element,
  measure,
  noting,
  openPage,
  press,
  send,
  stateOf,
  textOf,
} from './page-document.ts'
import { settled } from './turns.ts'

vi.mock('../../web/view/style.ts', () => ({ readStyle: () => ({ ramp: ['a', 'b'], map: ['red', 'blue'] }) }))

let page: ReturnType<typeof openPage>
beforeEach(() => {
  page = openPage()
  vi.useFakeTimers()
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.useRealTimers()
})

const editedOf = (circles: number, more: object = {}) =>
  ({ counts: { circles, vertices: 1, edges: 2, hidden: 0 }, seconds: 0, ...more }) as unknown as State['edited']
const EDITS = { done: [{ kind: 'edits' }], undone: [] } as unknown as History

describe('the caption', () => {
  function said(isTouch = false) {
    page.media.matches = isTouch
    const opened: unknown[] = []
    const { store, change } = stateOf()
    mountSay(store, (file) => opened.push(file))
    const place = element('say')
    const text = () => (place.hidden ? undefined : textOf(place))
    return { change, text, place, opened }
  }
  const MOUSE = 'Drag a rim to resize. Double-click to add a circle.'
  const FINGER = 'Tap one to resize it. Double-tap to add a circle.'
  const START = { edited: editedOf(8), dataSet: 'start' }

  it.each([
    [false, MOUSE],
    [true, FINGER],
  ])(
    'of the first circles stays until they are touched, and then says for a while what else can be done: fingers %s',
    (isTouch, hint) => {
      const { change, text, place } = said(isTouch)
      expect(text()).toBeUndefined()
      change(START)
      expect(text()).toBe(`Every point is colored by its nearest circle. Drag one.${hint} Or open a photo.`)
      expect(place.classList.contains('first')).toBe(true)
      vi.runAllTimers()
      expect(text()).toBeDefined()
      change({ selection: [1] })
      expect([text(), place.classList.contains('first')]).toEqual([hint, false])
      vi.advanceTimersByTime(11_999)
      expect(text()).toBe(hint)
      vi.advanceTimersByTime(1)
      expect(text()).toBeUndefined()
    },
  )

  it.each([
    ['a step of the method', { step: 0 }],
    ['a problem', { problem: 'wrong' }],
  ] as const)('is gone at once where there is %s', (_, more) => {
    const { change, text } = said()
    change(START)
    change(more)
    expect(text()).toBeUndefined()
  })

  it.each([
    ['an edit', { history: EDITS }],
    ['a selection', { selection: [1] }],
  ] as const)('of other circles is gone after %s', (_, more) => {
    const { change, text } = said()
    change({ edited: editedOf(8), dataSet: 'spruces' })
    change(more)
    expect(text()).toBeUndefined()
    change({ history: EMPTY_HISTORY, selection: [] })
    expect(text(), 'is said again where everything is undone').toBeDefined()
  })

  it('of other circles has their source, and lasts a while', () => {
    const { change, text, place } = said()
    change({ edited: editedOf(8), dataSet: 'spruces' })
    expect(text()).toMatch(/^Trunks of Norway spruces.*spatstat\.data$/)
    expect([place.classList.contains('first'), controls(place).size]).toEqual([false, 0])
    change({ edited: editedOf(9), dataSet: 'introduction' })
    expect(text()).toMatch(/hidden inside another\.$/)
    vi.advanceTimersByTime(11_999)
    expect(text()).toBeDefined()
    vi.advanceTimersByTime(1)
    expect(text()).toBeUndefined()
    change({ edited: editedOf(9), dataSet: '' })
    expect(text()).toBeUndefined()
  })

  it('of the first circles opens a photo', () => {
    const { change, place, opened } = said()
    change(START)
    const photo = place.querySelector('input') as HTMLInputElement
    const file = new File([], 'a.png')
    choose(photo)
    choose(photo, file)
    expect(opened).toEqual([file])
  })

  it.each([
    [false, 'Double-click'],
    [true, 'Double-tap'],
  ])('without circles says how to begin, and stays: fingers %s', (isTouch, how) => {
    const { change, text } = said(isTouch)
    change({ edited: editedOf(0), dataSet: 'start' })
    vi.runAllTimers()
    expect(text()).toBe(`No circles.${how} to add one, or choose a data set above.`)
  })

  it('changes with the kind of pointer while it is shown', () => {
    const { change, text } = said()
    change(START)
    page.media.matches = true
    page.media.dispatchEvent(new Event('change'))
    expect(text()).toContain(FINGER)
    change({ problem: 'wrong' })
    page.media.dispatchEvent(new Event('change'))
    expect(text()).toBeUndefined()
  })

  it('of the next circles lasts its own time', () => {
    const { change, text } = said()
    change({ edited: editedOf(8), dataSet: 'spruces' })
    vi.advanceTimersByTime(11_000)
    change({ dataSet: 'waka' })
    vi.advanceTimersByTime(11_000)
    expect(text()).toMatch(/Gabon/)
    change(START)
    vi.runAllTimers()
    expect(text()).toContain(MOUSE)
    const opening = { kind: 'opening' }
    change({ dataSet: 'waka', history: { done: [opening, { kind: 'edits' }], undone: [] } as unknown as History })
    expect(text()).toBe(MOUSE)
  })
})

describe('the status', () => {
  function shown() {
    const { store, change } = stateOf()
    mountStatus(store)
    const status = element('status')
    const ranks = () => all(status, 'span').flatMap(({ classList }) => [...classList])
    return { change, status, problem: element('problem'), ranks }
  }
  it('has the counts, each in one or in many, and what is rare where there is any', () => {
    const { change, status, ranks } = shown()
    expect(textOf(status)).toBe('Loading …')
    change({ edited: editedOf(1) })
    expect(textOf(status)).toBe('1 circle · 1 vertex · 2 edges · ✓ proven')
    expect(ranks()).toEqual(['second', 'minor', 'good'])
    const counts = { circles: 2000, vertices: 3, edges: 1, hidden: 4 }
    change({ edited: editedOf(0, { counts, seconds: 0.05, fitted: { error: 1.4e-7 } }) })
    expect(textOf(status)).toBe(
      '2,000 circles · 3 vertices · 1 edge · 4 hidden · areas within 1e-7 · ✓ proven · computed in 50 ms',
    )
    expect(ranks()).toEqual(['second', 'minor', 'rare', 'second', 'good', 'minor'])
    change({ edited: editedOf(0, { counts: { ...counts, hidden: 1 } }) })
    expect(textOf(status)).toContain(' · 1 hidden · ')
    for (const [seconds, text] of [
      [0.0499, '✓ proven'],
      [0.9994, 'computed in 999 ms'],
      [1, 'computed in 1.0 s'],
      [12.34, 'computed in 12.3 s'],
    ] as const) {
      change({ edited: editedOf(1, { seconds }) })
      expect(textOf(status)?.split(' · ').at(-1)).toBe(text)
    }
  })

  it('is announced again with each diagram, and only then', () => {
    const { change, status } = shown()
    const edited = editedOf(3)
    change({ edited })
    const first = status.firstElementChild
    change({ selection: [1] })
    expect(status.firstElementChild).toBe(first)
    change({ edited: editedOf(3) })
    expect(status.firstElementChild).not.toBe(first)
  })

  it('has the problem with its remedy, and not with that of another one', () => {
    const { change, problem } = shown()
    const done: string[] = []
    const remedy: Remedy = { problem: 'wrong', label: 'Skip', act: () => done.push('skip') }
    expect([problem.hidden, textOf(problem)]).toEqual([true, ''])
    change({ problem: 'wrong' })
    expect([problem.hidden, textOf(problem)]).toEqual([false, 'wrong'])
    change({ remedy })
    expect(textOf(problem)).toBe('wrong Skip')
    press(problem, 'Skip')
    expect(done).toEqual(['skip'])
    const [first] = all(problem)
    change({ selection: [1] })
    expect(all(problem)[0]).toBe(first)
    change({ problem: 'other' })
    expect(textOf(problem)).toBe('other')
    change({ problem: '', remedy: { ...remedy, problem: '' } })
    expect([problem.hidden, textOf(problem)]).toEqual([true, ''])
  })
})

describe('progress', () => {
  function progress() {
    const done: unknown[][] = []
    let observe = () => {}
    vi.stubGlobal(
      'MutationObserver',
      class {
        constructor(act: () => void) {
          observe = act
        }
        observe(target: unknown, { attributeFilter }: { attributeFilter: unknown }) {
          expect([target, attributeFilter]).toEqual([element('figure'), ['aria-busy']])
        }
      },
    )
    const actions = noting(done, { onstage: (_: Stage, __: number) => {} })
    const set = actions as { onstage: (stage: Stage, circles: number) => void }
    mountProgress(actions as unknown as PageActions)
    const place = element('progress')
    place.hidden = true
    const text = () => (place.hidden ? undefined : textOf(place))
    const painting = (isBusy: boolean) => {
      element('figure').setAttribute('aria-busy', String(isBusy))
      observe()
    }
    return { stage: (stage: Stage, circles = 0) => set.onstage(stage, circles), text, place, done, painting }
  }

  it('appears after a while, and says each stage, which can be canceled', () => {
    const { stage, text, place, done } = progress()
    stage('loading')
    vi.advanceTimersByTime(299)
    expect(text()).toBeUndefined()
    vi.advanceTimersByTime(1)
    expect(text()).toBe('Loading …Cancel')
    for (const [name, said] of [
      ['computing', 'Computing the diagram of 1,234 circles …'],
      ['clipping', 'Clipping the cells of 1,234 circles …'],
      ['fitting', 'Fitting the areas of 1,234 circles …'],
      ['repeating', 'Computing the cells of 1,234 circles …'],
    ] as const) {
      stage(name, 1234)
      expect([text(), place.querySelector('progress')?.getAttribute('aria-label')]).toEqual([`${said}Cancel`, said])
    }
    stage('computing', 1)
    expect(text()).toBe('Computing the diagram of 1 circle …Cancel')
    press(place, 'Cancel')
    expect([done, textOf(element('toast'))]).toEqual([[['cancelOpening']], 'Canceled. Nothing has changed.'])
    stage('refused')
    expect(text()).toBeUndefined()
  })

  it('of something short does not appear, and each time waits anew', () => {
    const { stage, text } = progress()
    stage('loading')
    vi.advanceTimersByTime(200)
    stage('computing', 3)
    expect(text()).toBeUndefined()
    stage('opened', 3)
    stage('loading')
    vi.advanceTimersByTime(299)
    expect(text(), 'the wait of the former opening is over').toBeUndefined()
    stage('opened', 3)
    vi.runAllTimers()
    expect(text()).toBeUndefined()
    stage('loading')
    vi.advanceTimersByTime(200)
    stage('computing', 3)
    vi.advanceTimersByTime(100)
    expect(text()).toBe('Computing the diagram of 3 circles …Cancel')
  })

  it('goes on while opened circles are painted, without Cancel', () => {
    const { stage, text, painting } = progress()
    stage('computing', 3)
    vi.runAllTimers()
    painting(true)
    stage('opened', 3)
    expect(text()).toBe('Painting 3 circles …')
    painting(true)
    expect(text()).toBeDefined()
    painting(false)
    expect(text()).toBeUndefined()
    stage('computing', 3)
    vi.runAllTimers()
    painting(false)
    expect(text(), 'not only painting').toBeDefined()
    painting(true)
    stage('refused', 3)
    expect(text()).toBeUndefined()
  })
})

describe('a toast', () => {
  it.each([
    [undefined, 6000],
    [{ label: 'Undo', act() {} }, 12_000],
  ] as const)('with the offer %j is gone after a while', (offer, lasting) => {
    toast('Done.', offer)
    const place = element('toast')
    vi.advanceTimersByTime(lasting - 1)
    expect(place.hidden).toBe(false)
    vi.advanceTimersByTime(1)
    expect(place.hidden).toBe(true)
  })

  it('lasts its own time after another one, and is gone once its offer is taken', () => {
    const done: string[] = []
    const place = element('toast')
    toast('First.')
    vi.advanceTimersByTime(5000)
    toast('Second.', { label: 'Undo', act: () => done.push('undo') })
    expect(textOf(place)).toBe('Second.Undo')
    vi.advanceTimersByTime(5000)
    expect(place.hidden).toBe(false)
    press(place, 'Undo')
    expect([done, place.hidden]).toEqual([['undo'], true])
  })
})

describe('the legend', () => {
  const legendOf = (more: Partial<Legend>): Legend =>
    ({ measure: 'area', knots: [], isClipped: false, ...more }) as Legend
  const STYLE = { ramp: ['a', 'b', 'c'], map: ['red', 'blue'] } as unknown as Style
  function drawn(legend: Legend, unit?: string) {
    const place = document.createElement('div')
    drawLegend(place, legend, STYLE, unit)
    return place
  }
  const drawOn = (context: object) =>
    vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(context as CanvasRenderingContext2D)
  beforeEach(() => void drawOn({ fillRect() {} }))
  afterEach(() => void vi.restoreAllMocks())

  it.each([
    ['radius', 'Radius of the circle'],
    ['area', 'Area of the cell'],
    ['filled', 'Share of the cell that the circle fills'],
    ['degree', 'Number of neighbors'],
    ['gap', 'Distance to the nearest circle'],
    ['index', 'Number of the circle'],
  ] as const)('of %s has its name, its unit and its numbers', (measure, name) => {
    const knots = [0, 99_999, 123_456, 1e6, 0.0004, 0.001, 1.256, -1e-4]
    const texts = (place: HTMLElement) => all(place, 'span').slice(2).map(textOf)
    const place = drawn(legendOf({ measure, knots }), 'mm')
    expect(textOf(place.querySelector('span'))).toBe(`${name} (mm)`)
    expect(texts(place)).toEqual(['0', '99999', '120000', '1e+6', '4e-4', '0.001', '1.3', '-1e-4'])
    expect(texts(drawn(legendOf({ measure, knots: [1, 2, 3], isClipped: true })))).toEqual(['≤ 1', '2', '≥ 3'])
  })

  it('draws its colors', () => {
    const filled: unknown[] = []
    const context = { fillStyle: '', fillRect: (...box: number[]) => filled.push([context.fillStyle, ...box]) }
    drawOn(context)
    const canvas = drawn(legendOf({ knots: [1, 2] })).querySelector('canvas')
    expect(canvas).toMatchObject({ width: 3 })
    expect(filled).toEqual(['a', 'b', 'c'].map((color, k) => [color, k, 0, 1, 1]))
  })

  it('says the one number of equal circles', () => {
    expect(textOf(drawn(legendOf({ knots: [2, 2, 2] })))).toBe('Area of the cell: 2 for all')
    expect(textOf(drawn(legendOf({ knots: [2, 2], isClipped: true }), 'mm'))).toBe(
      'Area of the cell (mm): 2 for nearly all',
    )
  })

  it('of a column has its categories in their colors, and others without one', () => {
    const place = drawn(legendOf({ measure: 'column', name: 'n', categories: ['u', 'v', 'w'], hasOthers: true }))
    expect(textOf(place.querySelector('span'))).toBe('n')
    expect(all(place, 'li').map(textOf)).toEqual(['u', 'v', 'others'])
    expect(all(place, '.swatch').map(({ style }) => style.background)).toEqual(['red', 'blue', 'transparent'])
    expect(textOf(drawn(legendOf({ measure: 'column', name: 'n', categories: ['u'] })))).toBe('n u')
  })

  it('is asked for where the colors or the circles are other ones, and not after an edit', async () => {
    const asked: ((legend: Legend | undefined) => void)[] = []
    const events = new Map<string, () => void>()
    const view = {
      hasDiagram: true,
      ask: () => new Promise((resolve) => asked.push(resolve)),
      on: (name: string, act: () => void) => events.set(name, act),
    }
    const { store, change } = stateOf()
    mountLegend(store, view as unknown as View)
    const place = element('legend')
    change({ edited: editedOf(1) })
    change({ edited: editedOf(2), history: EDITS })
    change({ edited: editedOf(3), history: { ...EDITS, undone: EDITS.done } })
    change({ edited: editedOf(4) })
    expect(asked).toHaveLength(3)
    asked[2]?.(legendOf({ knots: [1, 1] }))
    await settled()
    expect([place.hidden, textOf(place)]).toEqual([false, 'Area of the cell: 1 for all'])
    const { layers } = store.get()
    const opening = { kind: 'opening' }
    const changes: Partial<State>[] = [
      { layers: { ...layers, cells: 'area' } },
      { layers: { ...layers, cells: 'area', column: { name: 'n', values: new Float64Array() } } },
      { dataSet: 'spruces' },
      { history: { done: [opening], undone: [] } as unknown as History },
    ]
    for (const [k, more] of changes.entries()) {
      change(more)
      expect(asked, Object.keys(more).join()).toHaveLength(4 + k)
    }
    // A late answer about former colors is dropped.
    asked[4]?.(legendOf({ knots: [7, 7] }))
    await settled()
    expect(textOf(place)).toBe('Area of the cell: 1 for all')
    asked[6]?.(legendOf({ knots: [8, 8] }))
    await settled()
    expect(textOf(place)).toBe('Area of the cell: 8 for all')
    view.hasDiagram = false
    events.get('diagram')?.()
    expect(place.hidden).toBe(true)
    view.hasDiagram = true
    page.media.dispatchEvent(new Event('change'))
    expect(place.hidden).toBe(false)
    change({ dataSet: 'waka' })
    asked[7]?.(undefined)
    await settled()
    expect(place.hidden).toBe(true)
  })
})

describe('the scale and the pointer', () => {
  function scaled(scale = 1) {
    const frames: (() => void)[] = []
    vi.stubGlobal('requestAnimationFrame', (act: () => void) => frames.push(act))
    const events = new Map<string, () => void>()
    const view = {
      camera: { x: 0, y: 0, scale },
      size: { width: 200, height: 100 },
      on: (name: string, act: () => void) => events.set(name, act),
    }
    mountScale(view as unknown as View)
    const place = element('scale')
    const figure = element('figure')
    const draw = () => {
      for (const frame of frames.splice(0)) frame()
    }
    const part = (name: string) => textOf(place.querySelector(`.${name}`))
    return { place, view, events, frames, draw, figure, part }
  }

  it('have a bar of a round length, which follows the camera', () => {
    const { place, view, events, frames, draw, part } = scaled()
    expect(part('length')).toBe('100')
    expect(place.querySelector('svg')?.getAttribute('width')).toBe('102')
    expect(place.querySelector('path')?.getAttribute('d')).toBe('M1 0v6h100v-6')
    view.camera = { x: 0, y: 0, scale: 2.5 }
    events.get('camera')?.()
    events.get('camera')?.()
    expect(frames).toHaveLength(1)
    draw()
    expect([part('length'), place.querySelector('svg')?.getAttribute('width')]).toEqual(['20', '52'])
    events.get('camera')?.()
    expect(frames).toHaveLength(1)
  })

  it.each([
    [1, '-50, 25'],
    [20, '-2.50, 1.25'],
    [0.1, '-500, 250'],
    [1e-20, '-5.000000e+21, 2.500000e+21'],
  ])('say where the pointer is, as exactly as pixels are: scale %d', (scale, text) => {
    const { draw, figure, part } = scaled(scale)
    expect(part('pointer')).toBe('')
    send(figure, 'pointermove', { pointerType: 'mouse', offsetX: 50, offsetY: 25 })
    draw()
    expect(part('pointer')).toBe(text)
    send(figure, 'pointermove', { pointerType: 'touch', offsetX: 50, offsetY: 25 })
    draw()
    expect(part('pointer')).toBe('')
    send(figure, 'pointermove', { pointerType: 'pen', offsetX: 50, offsetY: 25 })
    send(figure, 'pointerleave')
    draw()
    expect(part('pointer')).toBe('')
  })
})

it('the name of the circle under the pointer is beside the pointer, inside the figure', () => {
  const { store, change } = stateOf()
  mountNames(store, { nameOf: (id: number) => ['', 'Bonn', 'Kiel'][id] } as unknown as Editing)
  const [tag, figure] = [element('name-tag'), element('figure')]
  measure(figure, { clientWidth: 200, clientHeight: 100 })
  measure(tag, { offsetWidth: 50, offsetHeight: 20 })
  const move = (offsetX: number, offsetY: number) => send(figure, 'pointermove', { offsetX, offsetY })
  move(10, 20)
  expect([tag.hidden, tag.style.translate]).toEqual([true, ''])
  change({ hovered: 1 })
  expect([tag.hidden, textOf(tag), tag.style.translate]).toEqual([false, 'Bonn', '24px 34px'])
  move(190, 95)
  expect(tag.style.translate).toBe('136px 66px')
  measure(figure, { clientWidth: 20, clientHeight: 10 })
  change({ hovered: 2 })
  expect([textOf(tag), tag.style.translate]).toEqual(['Kiel', '0px 0px'])
  for (const hovered of [0, undefined]) {
    change({ hovered })
    expect([tag.hidden, textOf(tag)]).toEqual([true, ''])
  }
})
