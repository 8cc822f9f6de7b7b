// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the tutorial and the record of read chapters.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { letCorrupt } from '../../web/tutorial/corrupt.ts'
import { CORRUPTIONS } from '../../web/tutorial/corruptions.ts'
import { sayCounts } from '../../web/tutorial/counts.ts'
import { KINDS } from '../../web/tutorial/drawn/kinds.ts'
import { bringToLife } from '../../web/tutorial/drawn.ts'
import { showExtras } from '../../web/tutorial/extras.ts'
import { numberCircles } from '../../web/tutorial/numbers.ts'
import { followPrinted } from '../../web/tutorial/printed.ts'
import { MOST_CIRCLES } from '../../web/tutorial/printed-rules.ts'
import { markRead } from '../../web/tutorial/progress.ts'
import { slideFigures } from '../../web/tutorial/sliders.ts'
import { followTrials } from '../../web/tutorial/trials.ts'
import { DEFAULT_LAYERS, type Layers } from '../../web/view/layers.ts'
import { all, make, openPage, send } from './page-document.ts'
import { box } from './shapes.ts'
import { aTurn, eventually } from './turns.ts'
import { fetchHere } from './whole-page.ts'

let frames: ((now: number) => void)[]
let resized: (() => void)[]
beforeEach(() => {
  openPage('')
  frames = []
  resized = []
  vi.stubGlobal('devicePixelRatio', 1)
  vi.stubGlobal('fetch', fetchHere)
  vi.stubGlobal('requestAnimationFrame', (frame: (now: number) => void) => frames.push(frame))
  vi.stubGlobal('cancelAnimationFrame', (frame: number) => {
    frames[frame - 1] = () => {}
  })
  vi.stubGlobal(
    'ResizeObserver',
    class {
      constructor(change: () => void) {
        resized.push(change)
      }
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
  isInView = false
  getState = () => ({ view: this.view })
  override scrollIntoView() {
    this.isInView = true
  }
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

it('an exercise says that it is done while it is, and shows its answer', () => {
  const [figure, output] = [element(), make('output')]
  output.dataset.done = 'Well done.'
  const button = make('button', { className: 'show' })
  button.dataset.circles = '[[1, 1, 1]]'
  const section = make('section', { className: 'try' }, figure, make('figcaption', {}, output), button)
  document.body.append(section)
  followTrials(document)
  for (const isMet of [true, false]) {
    send(figure, 'checkchange', { detail: { isMet } })
    expect([section.classList.contains('done'), output.value]).toEqual([isMet, isMet ? 'Well done.' : ''])
  }
  button.click()
  expect([figure.circles, figure.isInView]).toEqual([[[1, 1, 1]], true])
})

it('a slider changes the radii or the samples of its figure, and says its value', async () => {
  const figure = element()
  const outputs = ['scale', 'dynamic', 'uniform'].map((changes) => {
    const slider = sliderOf(1, 50)
    slider.dataset.changes = changes
    slider.dataset.figure = 'one'
    const output = make('output')
    document.body.append(make('p', {}, slider, output))
    return { slider, output }
  })
  document.body.append(make('figure', { id: 'one' }, figure))
  figure.layers = { ...DEFAULT_LAYERS, hull: true }
  slideFigures(document)
  const values = outputs.map(({ slider, output }, k) => {
    slider.valueAsNumber = [1.504, 3, 40][k] as number
    send(slider, 'input')
    return output.value
  })
  expect(values).toEqual(['1.5', '3', '40'])
  expect([...figure.circles].filter((_, k) => k % 3 === 2)).toEqual(
    SIX.filter((_, k) => k % 3 === 2).map((r) => r * 1.504),
  )
  expect(figure.layers).toMatchObject({ hull: true, candidates: 'uniform', sampleCount: 40 })
  send(outputs[1]?.slider as Element, 'input')
  expect(figure.layers).toMatchObject({ hull: true, candidates: 'dynamic', sampleCount: 3 })
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
  for (const none of [() => Object.assign(figure, { clientWidth: 0 }), () => (figure.view = { span: 0 })]) {
    none()
    resized[0]?.()
    frame()
    expect(places()[1]).toEqual(['1', '250', '100'])
    figure.clientWidth = 300
  }
})

describe('a diagram that is corrupted', () => {
  async function corrupted() {
    const figure = element()
    const caption = make('figcaption')
    const around = make('figure', { id: 'c' }, figure, caption)
    around.dataset.corrupt = ''
    document.body.replaceChildren(around)
    letCorrupt(document)
    await aTurn()
    await eventually(() => expect(verdict()).toMatch(/./))
    const box = around.querySelector('.corrupt') as HTMLElement
    const choice = box.querySelector('select') as HTMLSelectElement
    return { figure, box, choice }
  }
  const verdict = () => document.querySelector('output')?.value

  it('is refused by the judge with its flaw marked, and right again by the button and with other circles', async () => {
    const { figure, box, choice } = await corrupted()
    const about = () => box.querySelector('p')?.textContent
    const drawn = () => [
      figure.layers.edges,
      figure.layers.vertices,
      figure.layers.cells,
      figure.layers.data.map(({ id }) => id),
    ]
    const right = [verdict(), about()]
    const isRight = () => {
      expect([verdict(), about(), choice.value]).toEqual([...right, ''])
      expect(drawn()).toEqual([true, true, 'auto', []])
    }
    isRight()
    figure.layers = { ...figure.layers, hull: true }
    expect(box.querySelector('label')).toHaveProperty('htmlFor', 'c-change')
    expect(choice.id).toBe('c-change')
    for (const back of [() => box.querySelector('button')?.click(), () => send(figure, 'circleschange')]) {
      choice.value = '0'
      send(choice, 'change')
      await aTurn()
      expect(verdict()).not.toBe(right[0])
      expect(about()).toBe(CORRUPTIONS[0]?.about)
      expect(drawn()).toEqual([false, false, 'none', ['claimed', 'marked']])
      expect(figure.layers.hull).toBe(true)
      back()
      await aTurn()
      isRight()
    }
    // No circle is hidden.
    choice.value = `${CORRUPTIONS.length - 1}`
    send(choice, 'change')
    await aTurn()
    expect(right).not.toContain(about())
    expect(verdict()).toBe(right[0])
  })

  it('has a table whose vertices are marked while they are looked at, and can be changed', async () => {
    const { figure, box } = await corrupted()
    const right = verdict()
    const table = box.querySelector('table') as HTMLElement
    const rows = all(table, 'tr')
    expect(rows.length).toBeGreaterThan(3)
    const marked = () => figure.layers.data.map(({ id }) => id)
    for (const [come, leave] of [
      ['focusin', 'focusout'],
      ['pointerenter', 'pointerleave'],
    ] as const) {
      send(rows[1] as Element, come)
      expect(marked()).toEqual(['marked'])
      send(table, leave)
      expect(marked()).toEqual([])
    }
    const selects = all(rows[1] as Element, 'select')
    expect(new Set(selects.map((select) => select.getAttribute('aria-label'))).size).toBe(3)
    const [select] = selects as [HTMLSelectElement]
    const now = select.value
    expect(new Set(selects.map(({ value }) => value)).size, 'circles of the vertex').toBe(3)
    select.value = `${(Number(now) + 1) % 6}`
    send(select, 'change')
    await aTurn()
    expect(verdict()).not.toBe(right)
    expect(marked()).toEqual(['claimed', 'marked'])
    select.value = now
    send(select, 'change')
    await aTurn()
    expect(verdict()).toBe(right)
  })
})

describe('a figure that the tutorial draws', () => {
  async function drawn(spec: object = {}) {
    const [told, slider] = [make('output', { className: 'told' }), sliderOf(0)]
    const [play, back, forth] = ['play', 'back', 'forth'].map((className) => make('button', { className })) as [
      HTMLButtonElement,
      HTMLButtonElement,
      HTMLButtonElement,
    ]
    const link = Object.assign(make('a', { className: 'open' }), { href: 'https://example.org/#v1.first' })
    const image = Object.assign(make('img'), { alt: 'Discs' })
    const picture = make('div', { className: 'picture' }, image)
    const figure = make('figure', {}, picture, slider, play, back, forth, link, told)
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
    let width = 480
    vi.spyOn(Element.prototype, 'getBoundingClientRect').mockImplementation(
      () => ({ left: 10, top: 20, width }) as DOMRect,
    )
    await bringToLife(document)
    await eventually(() => expect(picture.querySelector('svg')).not.toBeNull())
    const svg = picture.querySelector('svg') as SVGElement
    const [content, handles] = [...svg.children] as [SVGElement, SVGElement]
    const resize = (to: number) => {
      width = to
      resized.at(-1)?.()
    }
    return {
      told,
      slider,
      play,
      back,
      forth,
      link,
      svg,
      content,
      handles: [...handles.children] as SVGElement[],
      resize,
    }
  }
  const place = (handle: Element | undefined) => ['cx', 'cy', 'r'].map((name) => Number(handle?.getAttribute(name)))

  it('shows the state at its slider, goes back and forth by whole steps, and stays within its range', async () => {
    const { slider, told, back, forth, content } = await drawn()
    const last = Number(slider.max)
    expect(last).toBeGreaterThan(3)
    const seen = new Set<string>()
    const slideTo = (value: number) => {
      slider.valueAsNumber = value
      send(slider, 'input')
    }
    for (const [act, value] of [
      [() => back.click(), 0],
      [() => forth.click(), 1],
      [() => forth.click(), 2],
      [() => back.click(), 1],
      [() => slideTo(1.5), 1.5],
      [() => forth.click(), 2],
      [() => slideTo(1.5), 1.5],
      [() => back.click(), 1],
      [() => slideTo(last), last],
      [() => forth.click(), last],
    ] as const) {
      act()
      expect(slider.valueAsNumber).toBe(value)
      expect(slider.getAttribute('aria-valuetext')).toBe(told.value)
      seen.add(content.innerHTML)
    }
    expect(seen.size).toBe(5)
  })

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

  it('has handles that are dragged and moved by keys within the picture, and its link follows', async () => {
    const { svg, handles, content, link, play, resize } = await drawn({ kind: 'nearest', point: [3, 3] })
    expect([svg.getAttribute('aria-label'), svg.getAttribute('role')]).toEqual(['Discs', 'group'])
    expect(new Set(handles.map((handle) => handle.getAttribute('aria-label'))).size).toBe(5)
    const [, , width = 0, height = 0] = svg.getAttribute('viewBox')?.split(' ').map(Number) ?? []
    const scale = width / 24
    const [x, y, r] = place(handles[0])
    expect([x, r]).toEqual([width / 2 - 6 * scale, 3 * scale])
    expect(place(handles[4])[2]).toBe((22 * width) / 480)
    const before = content.innerHTML
    // A CSS pixel is width / 480 units of the picture.
    send(handles[0] as Element, 'pointerdown', { pointerId: 1, clientX: 100, clientY: 100 })
    send(handles[0] as Element, 'pointermove', { pointerId: 1, clientX: 100 + 48, clientY: 100 - 24 })
    expect(frames).toHaveLength(1)
    send(handles[0] as Element, 'pointermove', { pointerId: 1, clientX: 100 + 48, clientY: 100 - 24 })
    expect(frames).toHaveLength(1)
    frame()
    const moved = place(handles[0])
    expect(moved[0]).toBeCloseTo((x as number) + width / 10, 6)
    expect(moved[1]).toBeCloseTo((y as number) - width / 20, 6)
    expect(content.innerHTML).not.toBe(before)
    send(handles[0] as Element, 'lostpointercapture')
    send(handles[0] as Element, 'pointermove', { pointerId: 1, clientX: 300, clientY: 100 })
    frame()
    expect(place(handles[0])).toEqual(moved)
    for (const [key, dx, dy] of [
      ['ArrowRight', 1, 0],
      ['ArrowUp', 0, -1],
      ['ArrowLeft', -1, 0],
      ['ArrowDown', 0, 1],
    ] as const) {
      const [fromX, fromY] = place(handles[4]) as [number, number]
      expect(send(handles[4] as Element, 'keydown', { key }).defaultPrevented).toBe(true)
      frame()
      const [toX, toY] = place(handles[4]) as [number, number]
      expect([toX - fromX, toY - fromY].map((step) => Math.round((1e6 * step * 80) / width) / 1e6)).toEqual([dx, dy])
    }
    expect(send(handles[4] as Element, 'keydown', { key: 'a' }).defaultPrevented).toBe(false)
    expect(send(handles[4] as Element, 'touchstart').defaultPrevented).toBe(true)
    send(handles[1] as Element, 'pointerdown', { pointerId: 1, clientX: 0, clientY: 0 })
    send(handles[1] as Element, 'pointermove', { pointerId: 1, clientX: 1e5, clientY: -1e5 })
    frame()
    expect(place(handles[1]).slice(0, 2)).toEqual([width, 0])
    send(handles[1] as Element, 'pointermove', { pointerId: 1, clientX: -1e5, clientY: 1e5 })
    frame()
    expect(place(handles[1]).slice(0, 2)).toEqual([0, height])
    await eventually(() => expect(link.href).toMatch(/^https:\/\/example\.org\/#v1\.(?!first)/))
    resize(240)
    expect(svg.style.getPropertyValue('--unit')).toBe(`${width / 240}`)
    expect(place(handles[4])[2]).toBe((22 * width) / 240)
    resize(0)
    expect(svg.style.getPropertyValue('--unit')).toBe('1')
    play.click()
    send(handles[4] as Element, 'keydown', { key: 'ArrowRight' })
    expect(play.textContent).not.toBe('Pause')
  })

  it('is drawn with regions where its kind needs them', async () => {
    const [name] = Object.entries(KINDS).find(([, kind]) => kind.hasRegions) as [string, unknown]
    const square = [[box(-6, -4, 18, 12)]]
    const { content } = await drawn({ kind: name, region: { type: 'MultiPolygon', coordinates: square } })
    expect(content.innerHTML).not.toBe('')
  })
})

describe('what the printed rules find', () => {
  async function followed() {
    const figure = element()
    const image = Object.assign(make('img'), { alt: 'The rules as printed' })
    const [picture, output] = [make('div', { className: 'picture' }, image), make('output')]
    const around = make('figure', { className: 'printed' }, figure, picture, output)
    around.dataset.rules = 'literal'
    document.body.replaceChildren(around)
    followPrinted(document)
    await aTurn()
    /** Draws, and waits for what is said. */
    const said = async (pattern: RegExp) => {
      frame()
      await eventually(() => expect(output.value).toMatch(pattern))
      return output.value
    }
    return { figure, picture, said }
  }

  it('is drawn beside the figure and said, for its circles and wherever it looks', async () => {
    const { figure, picture, said } = await followed()
    resized[0]?.()
    await said(/^As printed/)
    await eventually(() => expect(picture.querySelector('svg')).not.toBeNull())
    const svg = picture.querySelector('svg') as SVGElement
    expect([svg.getAttribute('aria-label'), svg.innerHTML.includes('class="discs"'), picture.children.length]).toEqual([
      'The rules as printed',
      true,
      1,
    ])
    for (const name of ['pointermove', 'pointerup', 'wheel', 'keydown', 'keyup', 'dblclick']) {
      const before = svg.getAttribute('viewBox')
      figure.view = { x: Math.random(), y: 0, span: 20 }
      send(figure, name)
      frame()
      await eventually(() => expect(svg.getAttribute('viewBox'), name).not.toBe(before))
    }
    const before = svg.innerHTML
    figure.circles = Float64Array.from(SIX.slice(0, 9))
    send(figure, 'circleschange')
    frame()
    await eventually(() => expect(svg.innerHTML).not.toBe(before))
  })

  it('is nothing of too many circles, and is loaded again where that has failed', async () => {
    vi.stubGlobal('fetch', async () => new Response(null, { status: 404 }))
    const { figure, said } = await followed()
    resized[0]?.()
    // The rules may have been loaded by the test before.
    await said(/\w/)
    vi.stubGlobal('fetch', fetchHere)
    send(figure, 'circleschange')
    await said(/^As printed/)
    figure.circles = Float64Array.from({ length: 3 * MOST_CIRCLES + 3 }, (_, k) => (k % 3 === 2 ? 0.1 : k))
    send(figure, 'circleschange')
    await said(new RegExp(`${MOST_CIRCLES} circles at most`))
  })
})

it('a figure has its rims and its steps above, also after its circles have changed', async () => {
  const [rims, steps] = [element(), element()]
  for (const [name, figure] of [
    ['rims', rims],
    ['steps', steps],
  ] as const) {
    const around = make('figure', {}, figure)
    around.dataset[name] = name === 'steps' ? '0 3' : ''
    document.body.append(around)
  }
  rims.layers = { ...DEFAULT_LAYERS, hull: true }
  await showExtras(document)
  await aTurn()
  expect(rims.layers).toMatchObject({ hull: true, data: [{ id: 'rims', discs: expect.any(Float64Array) }] })
  expect(rims.layers.data).toHaveLength(1)
  const [way] = steps.layers.data
  expect([way?.id, [...(way?.points?.slice(0, 2) ?? [])], [...(way?.points?.slice(-2) ?? [])]]).toEqual([
    'steps',
    [0, 0],
    [13, 8],
  ])
  rims.circles = Float64Array.of(0, 0, 3, 9, 0, 1)
  send(rims, 'circleschange')
  expect(rims.layers.data[0]?.discs).toEqual(Float64Array.of(0, 0, 2, 9, 0, 0))
})
