// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the tutorial and the record of solved chapters.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { sayCounts } from '../../web/tutorial/counts.ts'
import { bringToLife } from '../../web/tutorial/drawn.ts'
import { numberCircles } from '../../web/tutorial/numbers.ts'
import { markSolved } from '../../web/tutorial/progress.ts'
import { stepRules } from '../../web/tutorial/rules.ts'
import { followTrials } from '../../web/tutorial/trials.ts'
import { DEFAULT_LAYERS, type Layers } from '../../web/view/layers.ts'
import { control, make, openPage, send } from './page-document.ts'
import { aTurn, eventually } from './turns.ts'
import { fetchHere } from './whole-page.ts'

let frames: ((now: number) => void)[]
beforeEach(() => {
  openPage('')
  frames = []
  vi.stubGlobal('devicePixelRatio', 1)
  vi.stubGlobal('fetch', fetchHere)
  vi.stubGlobal('requestAnimationFrame', (frame: (now: number) => void) => frames.push(frame))
  vi.stubGlobal('cancelAnimationFrame', (frame: number) => {
    frames[frame - 1] = () => {}
  })
  vi.stubGlobal(
    'ResizeObserver',
    class {
      observe() {}
    },
  )
  vi.stubGlobal('matchMedia', () => ({ matches: false }))
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

/** Draws the next frame. */
function frame(now = 0): void {
  const next = frames
  frames = []
  for (const draw of next) draw(now)
}

const SIX = [0, 0, 4, 10, 0, 3, 4, 9, 3, 13, 8, 2, -4, 7, 1, 6, 4, 1]

/** The element in a figure. */
class Figure extends HTMLElement {
  ready: Promise<void> = Promise.resolve()
  updateComplete: Promise<void> = Promise.resolve()
  circles = Float64Array.from(SIX)
  layers: Layers = DEFAULT_LAYERS
  override clientWidth = 300
  override clientHeight = 200
  view: unknown
  getState = () => ({ view: this.view })
}
customElements.define('circle-voronoi', Figure)
const element = () => new Figure()

const sliderOf = (value: number, max = 10, min = 0) => make('input', { type: 'range', min, max, step: 'any', value })

describe('solved chapters', () => {
  const KEY = 'circle-voronoi tutorial'
  beforeEach(() => localStorage.clear())
  /** Opens the second of three chapters, which has a question and an exercise. Returns the marked chapters. */
  const open = () => {
    const links = ['1.html', '2.html', '3.html'].map((file) => make('a', { href: file }))
    links[1]?.setAttribute('aria-current', 'page')
    const tasks = [make('form', { className: 'question' }), make('div', { className: 'try' })]
    document.body.replaceChildren(make('nav', { className: 'pages' }, make('ol', {}, ...links)), ...tasks)
    markSolved(document)
    const marked = () =>
      links.flatMap((link, k) => (link.classList.contains('solved') && link.textContent === ' (solved)' ? [k + 1] : []))
    return { tasks, marked }
  }
  const solve = (task: Element | undefined) => task?.dispatchEvent(new Event('solved', { bubbles: true }))

  it('are those with all tasks solved, and are marked with a word', () => {
    localStorage.setItem(KEY, '{"1.html": {"solved": [0, 1], "tasks": 2}, "3.html": {"solved": [1], "tasks": 2}}')
    const first = open()
    expect(first.marked()).toEqual([1])
    solve(first.tasks[1])
    solve(first.tasks[1])
    expect(first.marked()).toEqual([1])
    // The other task is solved on another day.
    const second = open()
    expect(second.marked()).toEqual([1])
    solve(second.tasks[0])
    expect(second.marked()).toEqual([1, 2])
    expect(open().marked()).toEqual([1, 2])
  })

  it.each(['["1.html", "2.html"]', '7', '{', 'null', '{"1.html": 3, "2.html": {"solved": 2, "tasks": 2}}'])(
    'are none where something else was kept: %s',
    (text) => {
      localStorage.setItem(KEY, text)
      expect(open().marked()).toEqual([])
    },
  )

  it('are only the open one where nothing can be kept', () => {
    const forbidden = () => {
      throw new Error('forbidden')
    }
    vi.stubGlobal('localStorage', { getItem: forbidden, setItem: forbidden })
    const { tasks, marked } = open()
    for (const task of tasks) solve(task)
    expect(marked()).toEqual([2])
  })

  it('count an exercise that the reader solves, not one whose answer is shown', () => {
    const figure = element()
    const show = make('button', { className: 'show' })
    show.dataset.circles = '[[0, 0, 1]]'
    const reset = make('button', { className: 'reset' })
    figure.setAttribute('circles', '[[0, 0, 2]]')
    figure.scrollIntoView = () => {}
    const caption = make('figcaption', {}, make('output'))
    const section = make('div', { className: 'try' }, figure, make('p', { className: 'now' }), show, reset, caption)
    document.body.replaceChildren(section)
    followTrials(document)
    let solved = 0
    section.addEventListener('solved', () => {
      solved += 1
    })
    const meet = () => send(figure, 'checkchange', { detail: { isMet: true } })
    send(figure, 'goalschange', { detail: { text: 'Edges now 7, goal 3' } })
    expect(section.querySelector('.now')?.textContent).toBe('Edges now 7, goal 3')
    show.click()
    meet()
    expect(solved).toBe(0)
    reset.click()
    meet()
    expect(solved).toBe(1)
  })
})

it('rules are shown one at a time, and move the figure above to where they apply', () => {
  const slider = sliderOf(0)
  const figure = make('figure', { id: 'grown' }, slider)
  const items = [3, undefined, 7].map((at) => {
    const item = make('li')
    if (at !== undefined) item.dataset.at = `${at}`
    return item
  })
  const group = make('div', { className: 'rules' }, make('ol', {}, ...items))
  Object.assign(group.dataset, { figure: 'grown', show: 'Show an event' })
  document.body.replaceChildren(figure, group)
  const moved: number[] = []
  slider.addEventListener('input', () => moved.push(slider.valueAsNumber))
  stepRules(document)
  const button = (name: string) => control(group, name)
  const shown = () => items.map((item) => item.classList.contains('current'))
  expect([shown(), moved]).toEqual([[true, false, false], []])
  button('Show an event').click()
  expect(moved).toEqual([3])
  button('Next rule').click()
  expect([shown(), moved, button('Show an event').disabled]).toEqual([[false, true, false], [3], true])
  button('Next rule').click()
  expect([moved, button('Next rule').disabled]).toEqual([[3, 7], true])
  button('Previous rule').click()
  expect(group.querySelector('output')?.value).toBe('Rule 2 of 3')
  button('All rules').click()
  expect([group.className, button('Next rule').disabled]).toEqual(['rules', true])
  button('All rules').click()
  expect(group.className).toBe('rules stepped')
})

it('counts of samples follow the circles and the slider', async () => {
  const [figure, output] = [element(), make('output', { className: 'counts' })]
  const around = make('figure', {}, figure, output)
  document.body.append(around)
  await sayCounts(document)
  const first = output.value
  expect(first).toMatch(/^\d+ samples on the largest circle/)
  figure.layers = { ...figure.layers, sampleCount: 5 }
  send(around, 'input')
  const more = output.value
  expect(Number.parseInt(more, 10)).toBeGreaterThan(Number.parseInt(first, 10))
  figure.circles = figure.circles.slice(0, 9)
  send(figure, 'circleschange')
  expect(output.value).not.toBe(more)
})

it('numbers of circles are at their centers, wherever the figure looks', async () => {
  const figure = element()
  document.body.append(figure)
  numberCircles(figure as never)
  const svg = document.querySelector('svg') as SVGElement
  expect(svg.getAttribute('aria-hidden')).toBe('true')
  await aTurn()
  frame()
  const places = () =>
    [...svg.querySelectorAll('text')].map((text) => [text.textContent, text.getAttribute('x'), text.getAttribute('y')])
  const whole = places()
  expect(whole.map(([name]) => name)).toEqual(['0', '1', '2', '3', '4', '5'])
  expect(svg.getAttribute('viewBox')).toBe('0 0 300 200')
  figure.view = { x: 0, y: 0, span: 20 }
  for (const name of ['pointermove', 'pointerup', 'wheel', 'keydown', 'keyup', 'dblclick', 'circleschange']) {
    send(figure, name)
    send(figure, name)
    expect(frames, name).toHaveLength(1)
    frame()
    expect(places()[1]).toEqual(['1', '250', '100'])
  }
})

describe('a figure that the tutorial draws', () => {
  async function drawn(spec: object = {}) {
    const slider = sliderOf(0)
    const [told, play] = [make('output', { className: 'told' }), make('button', { className: 'play' })]
    const others = ['back', 'forth'].map((className) => make('button', { className }))
    const link = Object.assign(make('a', { className: 'open' }), { href: 'https://example.org/#v1.first' })
    const image = Object.assign(make('img'), { alt: 'Discs' })
    const picture = make('div', { className: 'picture' }, image)
    const figure = make('figure', {}, picture, slider, play, ...others, link, told)
    figure.dataset.drawn = JSON.stringify({
      kind: 'growing',
      circles: [
        [0, 0, 3],
        [10, 0, 2],
        [4, 9, 2],
        [12, 9, 1],
      ],
      view: [6, 4, 24],
      at: 0,
      ...spec,
    })
    document.body.replaceChildren(figure)
    vi.spyOn(Element.prototype, 'getBoundingClientRect').mockReturnValue({ left: 10, top: 20, width: 480 } as DOMRect)
    await bringToLife(document)
    await eventually(() => expect(picture.querySelector('svg')).not.toBeNull())
    const svg = picture.querySelector('svg') as SVGElement
    const handles = [...(svg.children[1]?.children ?? [])]
    return { slider, play, link, svg, handles }
  }

  it('plays an event in 1.4 s, of which it rests half, to the end, from where it begins again; it pauses', async () => {
    const { slider, play } = await drawn()
    const last = Number(slider.max)
    const at = (now: number) => {
      frame(now)
      return slider.valueAsNumber
    }
    play.click()
    const pause = play.textContent
    const isPlaying = () => play.textContent === pause
    expect([0, 700, 1050, 1400, 2800].map(at)).toEqual([0, 0, 0.5, 1, 2])
    play.click()
    expect([isPlaying(), at(9000)]).toEqual([false, 2])
    play.click()
    expect([20_000, 20_000 + 1400, 20_000 + 1400 * last].map(at)).toEqual([2, 3, last])
    expect(isPlaying()).toBe(false)
    play.click()
    expect([isPlaying(), at(0)]).toEqual([true, 0])
  })

  it('jumps from event to event for readers who want less motion', async () => {
    vi.stubGlobal('matchMedia', (query: string) => ({ matches: query === '(prefers-reduced-motion: reduce)' }))
    const { slider, play } = await drawn()
    play.click()
    const seen = [0, 1300, 1400, 2700].map((now) => {
      frame(now)
      return slider.valueAsNumber
    })
    expect(seen).toEqual([0, 0, 1, 1])
  })

  it('has handles that stay within the picture, and a link that follows them', async () => {
    const { svg, handles, link } = await drawn({ kind: 'nearest', point: [3, 3] })
    const [, , width, height] = svg.getAttribute('viewBox')?.split(' ').map(Number) ?? []
    expect(new Set(handles.map((handle) => handle.getAttribute('aria-label'))).size).toBe(5)
    const [, second] = handles as [Element, Element]
    send(second, 'pointerdown', { pointerId: 1, clientX: 0, clientY: 0 })
    for (const [clientX, clientY, x, y] of [
      [1e5, -1e5, width, 0],
      [-1e5, 1e5, 0, height],
    ] as const) {
      send(second, 'pointermove', { pointerId: 1, clientX, clientY })
      frame()
      expect(['cx', 'cy'].map((name) => Number(second.getAttribute(name)))).toEqual([x, y])
    }
    await eventually(() => expect(link.href).toMatch(/^https:\/\/example\.org\/#v1\.(?!first)/))
  })
})
