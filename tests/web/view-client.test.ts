// SPDX-License-Identifier: GPL-3.0-or-later
// The overlay of a view, with a painter that answers on command. The pixels are not checked.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { Point } from '../../web/lib/index.ts'
import type { Painter } from '../../web/view/painter.ts'
import type { Described, Highlights, Touching } from '../../web/view/protocol.ts'
import { Superseded } from '../../web/view/refusal.ts'
import { View } from '../../web/view/view.ts'

const drawn = vi.hoisted(() => [] as { touching: unknown; marks: Highlights }[])
vi.mock('../../web/view/overlay.ts', () => ({
  HANDLE_RADIUS: 7,
  drawOverlay: (...[, , , , above]: (typeof drawn)[number][]) => drawn.push(above as (typeof drawn)[number]),
  isNothingAbove: ({ touching, marks }: { touching: unknown; marks: Highlights }) =>
    touching === undefined && marks.selected === undefined,
}))
/** The number of times that the style sheet was read. */
let readings = 0
vi.mock('../../web/view/style.ts', () => ({
  readStyle: () => {
    readings += 1
    return {}
  },
  isDark: () => false,
}))
vi.mock('../../web/view/base-picture.ts', () => ({
  MOST_ENLARGED: 256,
  BasePicture: class {
    isWhole = true
    isSharp = () => isSharp
    see = () => ({})
    again() {}
    put() {}
    clear() {}
    draw() {}
  },
}))

/** Whether pixels of the camera's scale are there. */
let isSharp = true
let frames: (() => void)[] = []
let sizeChanges = () => {}
let media: Map<string, EventTarget & { matches: boolean }>
let window: EventTarget
beforeEach(() => {
  drawn.length = 0
  frames = []
  isSharp = true
  const canvas = () => ({ getContext: () => ({ clearRect() {} }), remove() {} })
  vi.stubGlobal('document', Object.assign(new EventTarget(), { createElement: canvas, fonts: new EventTarget() }))
  media = new Map()
  vi.stubGlobal('matchMedia', (query: string) => {
    const list = media.get(query) ?? Object.assign(new EventTarget(), { matches: false })
    media.set(query, list)
    return list
  })
  window = new EventTarget()
  vi.stubGlobal('addEventListener', window.addEventListener.bind(window))
  vi.stubGlobal('devicePixelRatio', 1)
  vi.stubGlobal(
    'ResizeObserver',
    class {
      constructor(changed: () => void) {
        sizeChanges = changed
      }
      observe() {}
      disconnect() {}
    },
  )
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
  vi.stubGlobal('cancelAnimationFrame', (frame: number) => frames.splice(frame - 1, 1))
})
afterEach(() => vi.unstubAllGlobals())

/** The reason why edits are refused. */
let refusal: Error

function opened() {
  const answers: ((touching: Touching | undefined) => void)[] = []
  let events: Parameters<Painter['add']>[0] | undefined
  const looks: string[] = []
  const scene = {
    setLayers() {},
    look: () => looks.push('look'),
    close: () => looks.push('close'),
    ask: () => new Promise<Touching | undefined>((resolve) => answers.push(resolve)),
    edit: () => Promise.reject(refusal),
  }
  const painter = {
    add(given: typeof events) {
      events = given
      return scene
    },
  } as unknown as Painter
  const classList = { add() {} }
  const container = {
    classList,
    toggleAttribute() {},
    appendChild: (child: unknown) => child,
    currentCSSZoom: 1,
    clientWidth: 80,
    clientHeight: 60,
    offsetWidth: 80,
    offsetHeight: 60,
    getBoundingClientRect: () => ({ width: 80, height: 60 }),
  }
  const view = new View(container as unknown as HTMLElement, painter)
  view.setLayers({ ...view.layers, disc: true })
  /** The highlights after all pending frames; `undefined` also if nothing was redrawn. */
  const shown = () => {
    drawn.length = 0
    for (const frame of frames.splice(0)) frame()
    return drawn.at(-1)?.touching
  }
  shown()
  const edited = () => events?.painted({ kind: 'edited' } as never)
  const marked = (marks: Highlights) => events?.marked(marks)
  const resize = (clientWidth: number) => {
    Object.assign(container, { clientWidth, offsetWidth: clientWidth })
    sizeChanges()
  }
  return { view, answers, shown, edited, marked, resize, looks: () => looks.splice(0) }
}

const HERE: Point = { x: 1, y: 2 }
const DISC = { x: 1, y: 2, r: 3 } as unknown as Touching
const OTHER = { x: 4, y: 4, r: 1 } as unknown as Touching

it('shows the disc of the place where the pointer is, whatever answers come late', async () => {
  const { view, answers, shown } = opened()
  const first = view.touch(HERE, 1)
  const second = view.touch({ x: 5, y: 5 }, 1)
  answers[1]?.(OTHER)
  await second
  expect(shown()).toBe(OTHER)
  answers[0]?.(DISC)
  await first
  expect(frames).toHaveLength(0)
  const last = view.touch(undefined, 1)
  await last
  expect(drawn).toHaveLength(1)
  expect(frames).toHaveLength(1)
  expect(shown()).toBeUndefined()
})

it('draws nothing above the picture while it moves, if nothing is there', async () => {
  const { view, answers, shown } = opened()
  view.setCamera({ x: 3, y: 4, scale: 5 })
  shown()
  expect(drawn).toHaveLength(0)
  const touched = view.touch(HERE, 1)
  answers[0]?.(DISC)
  await touched
  shown()
  view.setCamera({ x: 3, y: 4, scale: 6 })
  expect(shown()).toBe(DISC)
  // Draws once more to clear the overlay.
  await view.touch(undefined, 1)
  shown()
  expect(drawn).toHaveLength(1)
  view.setCamera({ x: 3, y: 4, scale: 7 })
  shown()
  expect(drawn).toHaveLength(0)
})

it('draws nothing anew where the disc is the one that is shown', async () => {
  const { view, answers, shown } = opened()
  for (const k of [0, 1]) {
    const touched = view.touch({ ...HERE }, 1)
    answers[k]?.(DISC)
    await touched
    expect(shown()).toBe(k === 0 ? DISC : undefined)
    expect(drawn).toHaveLength(k === 0 ? 1 : 0)
  }
})

it('shows no disc of circles that were edited, until it is asked for again', async () => {
  const { view, answers, shown, edited } = opened()
  const before = view.touch({ ...HERE }, 1)
  answers[0]?.(DISC)
  await before
  expect(shown()).toBe(DISC)
  edited()
  const after = view.touch({ ...HERE }, 1)
  answers[1]?.(DISC)
  await after
  expect(shown()).toBe(DISC)
  expect(drawn).toHaveLength(1)
})

it('draws the disc again after a change of size, which clears the overlay', async () => {
  const { view, answers, shown, resize } = opened()
  const touched = view.touch(HERE, 1)
  answers[0]?.(DISC)
  await touched
  expect(shown()).toBe(DISC)
  resize(100)
  expect(shown()).toBe(DISC)
})

it('draws no outline of a cell that was cut for a far smaller scale', () => {
  const { view, shown, marked } = opened()
  const outline = Float64Array.of(1, 2, 3)
  const selected = { id: 0, outline, neighborhood: outline } as unknown as Described
  marked({ selected, hovered: undefined })
  shown()
  expect(drawn.at(-1)?.marks.selected?.outline).toBe(outline)
  view.setCamera({ ...view.camera, scale: 100 })
  shown()
  expect(drawn.at(-1)?.marks.selected?.outline).toBe(outline)
  view.setCamera({ ...view.camera, scale: 1e6 })
  shown()
  expect(drawn.at(-1)?.marks.selected?.outline).toHaveLength(0)
})

it('asks for pixels of another scale once the camera rests, and for none once it is disposed of', () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  try {
    const { view, looks } = opened()
    looks()
    view.setCamera({ x: 3, y: 4, scale: 5 })
    expect(looks()).toEqual(['look'])
    isSharp = false
    for (const scale of [6, 7]) {
      view.setCamera({ x: 3, y: 4, scale })
      vi.advanceTimersByTime(79)
      expect(looks()).toEqual([])
    }
    vi.advanceTimersByTime(1)
    expect(looks()).toEqual(['look'])
    view.setCamera({ x: 3, y: 4, scale: 8 })
    view.dispose()
    vi.advanceTimersByTime(1000)
    expect(looks()).toEqual(['close'])
    expect(frames).toHaveLength(0)
  } finally {
    vi.useRealTimers()
  }
})

it('shows the newest circle that is tried, whatever answers come late, and tells each once', async () => {
  const { view, answers } = opened()
  const tried: unknown[] = []
  view.on('tried', (trial) => tried.push(trial))
  const circle = { x: 1, y: 2, r: 3 }
  const [first, second] = [view.tryCircle(circle), view.tryCircle(circle)]
  answers[1]?.(OTHER)
  await second
  answers[0]?.(DISC)
  await first
  expect(tried).toEqual([OTHER])
  const third = view.tryCircle(circle)
  await view.tryCircle(undefined)
  answers[2]?.(DISC)
  await third
  expect(tried).toEqual([OTHER, undefined])
})

it('finds the end of the path at a pixel, the last one if both are there', () => {
  const { view } = opened()
  view.setCamera({ x: 0, y: 0, scale: 10 })
  const path = (x: number) => view.setLayers({ path: { from: { x: 0, y: 0 }, to: { x, y: 0 } } })
  path(3)
  const ends = [40, 70, 55].map((x) => view.pathEndAt({ x, y: 30 }, 0))
  expect(ends).toEqual(['from', 'to', undefined])
  expect(view.pathEndAt({ x: 55, y: 30 }, 20)).toBe('to')
  path(0)
  expect(view.pathEndAt({ x: 40, y: 30 }, 0)).toBe('to')
})

it('tells of edits that are refused, and not of those whose circles were replaced', async () => {
  const { view } = opened()
  const refused: unknown[] = []
  view.on('refused', (error) => refused.push(error))
  for (const error of [new Error('No circle.'), new Superseded()]) {
    refusal = error
    await expect(view.apply([])).rejects.toBe(error)
  }
  expect(refused).toEqual([new Error('No circle.')])
})

it('follows the style and the resolution of the screen until it is disposed of', async () => {
  const { view, answers, shown } = opened()
  const touched = view.touch(HERE, 1)
  answers[0]?.(DISC)
  await touched
  shown()
  readings = 0
  const change = () => {
    for (const list of [...media.values()]) list.dispatchEvent(new Event('change'))
    for (const name of ['resize', 'transitionend']) window.dispatchEvent(new Event(name))
  }
  expect([...media.keys()].sort()).toEqual([
    '(forced-colors: active)',
    '(prefers-color-scheme: dark)',
    '(resolution: 1dppx)',
    'print',
  ])
  drawn.length = 0
  change()
  expect([readings, drawn.length > 0, frames.length > 0]).toEqual([2, true, true])
  // After a change the view watches the new resolution.
  vi.stubGlobal('devicePixelRatio', 2)
  change()
  expect(media.has('(resolution: 2dppx)')).toBe(true)
  shown()
  view.dispose()
  readings = 0
  drawn.length = 0
  change()
  expect([readings, drawn.length, frames.length]).toEqual([0, 0, 0])
})
