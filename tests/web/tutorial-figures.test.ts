// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the tutorial and the record of read chapters.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { sayCounts } from '../../web/tutorial/counts.ts'
import { bringToLife } from '../../web/tutorial/drawn.ts'
import { numberCircles } from '../../web/tutorial/numbers.ts'
import { markRead } from '../../web/tutorial/progress.ts'
import { DEFAULT_LAYERS, type Layers } from '../../web/view/layers.ts'
import { make, openPage, send } from './page-document.ts'
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

describe('read chapters', () => {
  const KEY = 'circle-voronoi tutorial'
  let see: (isIntersecting: boolean) => void
  beforeEach(() => {
    localStorage.clear()
    see = () => {}
    vi.stubGlobal(
      'IntersectionObserver',
      class {
        constructor(tell: (entries: unknown[], observer: unknown) => void) {
          see = (isIntersecting) => tell([{ isIntersecting }], this)
        }
        observe() {}
        disconnect() {
          see = () => {}
        }
      },
    )
  })
  /** The read ones of three chapters, of which the second is this one. */
  const read = () => {
    const links = ['1.html', '2.html', '3.html'].map((file) => make('a', { href: file }))
    links[1]?.setAttribute('aria-current', 'page')
    const pages = make('nav', { className: 'pages' }, make('ol', {}, ...links))
    document.body.replaceChildren(pages, make('nav', { className: 'turn' }))
    markRead(document)
    return links.flatMap((link, k) =>
      link.classList.contains('read') && link.textContent === ' (read)' ? [k + 1] : [],
    )
  }

  it('are those whose end was seen, and are marked with a word', () => {
    localStorage.setItem(KEY, '["1.html", 7]')
    expect(read()).toEqual([1])
    see(false)
    expect(localStorage.getItem(KEY)).toBe('["1.html", 7]')
    see(true)
    expect([localStorage.getItem(KEY), read()]).toEqual(['["1.html","2.html"]', [1, 2]])
  })

  it.each(['{}', '7', '{', 'null'])('are none where something else was kept: %s', (text) => {
    localStorage.setItem(KEY, text)
    expect(read()).toEqual([])
  })

  it('are none where nothing can be kept', () => {
    const forbidden = () => {
      throw new Error('forbidden')
    }
    vi.stubGlobal('localStorage', { getItem: forbidden, setItem: forbidden })
    expect(read()).toEqual([])
    expect(() => see(true)).not.toThrow()
  })
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
