// SPDX-License-Identifier: GPL-3.0-or-later
// The overlay of a view, with a painter that answers on command. The pixels are not checked.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { Point } from '../../web/lib/index.ts'
import { DEFAULT_LAYERS, type Layers } from '../../web/view/layers.ts'
import type { Painter } from '../../web/view/painter.ts'
import type { Described, Highlights, Touching } from '../../web/view/protocol.ts'
import { Superseded } from '../../web/view/refusal.ts'
import { View } from '../../web/view/view.ts'

interface Drawn {
  readonly touching: unknown
  readonly marks: Highlights
  readonly found: unknown
  readonly chosen: { readonly circles: Float64Array; readonly box: unknown } | undefined
  readonly band: unknown
  readonly sketch: unknown
  readonly above: readonly unknown[]
  readonly layers: Layers
  readonly covered: unknown
  readonly names: { readonly list: readonly unknown[]; circleOf(id: number): unknown }
}
const { drawn, picture } = vi.hoisted(() => ({ drawn: [] as Drawn[], picture: [] as string[] }))
vi.mock('../../web/view/overlay.ts', () => ({
  HANDLE_RADIUS: 7,
  NOTHING_STANDS_OUT: { marks: { selected: undefined, hovered: undefined } },
  handleOf: (box: { maxX: number; minY: number }, toPixel: (point: Point) => Point) =>
    toPixel({ x: box.maxX, y: box.minY }),
  drawOverlay: (...[, , , , above]: Drawn[]) => drawn.push(above as Drawn),
  isNothingAbove: ({ touching, marks, ...others }: Drawn) =>
    touching === undefined &&
    marks.selected === undefined &&
    [others.found, others.chosen, others.band, others.sketch].every((part) => part === undefined) &&
    others.above.length === 0 &&
    others.names.list.length === 0,
}))
/** The number of times that the style sheet was read. */
let readings = 0
/** The color schemes other than its own in which the style sheet was read. */
let schemes: string[] = []
vi.mock('../../web/view/style.ts', () => ({
  readStyle: ({ style }: { style?: { colorScheme: string } }) => {
    readings += 1
    if (style?.colorScheme === 'light') schemes.push('light')
    return {}
  },
  isDark: () => false,
}))
vi.mock('../../web/view/base-picture.ts', () => ({
  MOST_ENLARGED: 256,
  BasePicture: class {
    isWhole = true
    isSharp = () => isSharp
    see = (...how: unknown[]) => {
      picture.push('see')
      looked = how
      return {}
    }
    again = () => {
      picture.push('again')
      return {}
    }
    put = () => picture.push('put')
    clear = () => picture.push('clear')
    draw = () => picture.push('draw')
  },
}))

/** The camera, the size and the pixel ratio of the last request for pixels. */
let looked: unknown[]
/** Whether pixels of the camera's scale are there. */
let isSharp = true
let frames: (() => void)[] = []
let sizeChanges = () => {}
let media: Map<string, EventTarget & { matches: boolean }>
let window: EventTarget
/** The listeners to style sheets and other files of the document. */
let loads: ((event: Event) => void)[]
beforeEach(() => {
  drawn.length = 0
  picture.length = 0
  looked = []
  schemes = []
  frames = []
  isSharp = true
  const canvas = () => ({ getContext: () => ({ clearRect() {} }), remove: () => removed.push('canvas') })
  removed = []
  unsendable = undefined
  loads = []
  vi.stubGlobal('document', {
    createElement: canvas,
    addEventListener: (name: string, listen: (event: Event) => void) => name === 'load' && loads.push(listen),
  })
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
      disconnect() {
        removed.push('observer')
      }
    },
  )
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
  vi.stubGlobal('cancelAnimationFrame', (frame: number) => frames.splice(frame - 1, 1))
})
afterEach(() => {
  // A view may wait for its camera to rest.
  for (const view of views.splice(0)) view.dispose()
  vi.unstubAllGlobals()
})

const views: View[] = []

/** The parts that a view removes when it is disposed of. */
let removed: string[]
/** The reason why edits are refused. */
let refusal: Error
/** The error of layers that cannot be sent. */
let unsendable: Error | undefined

function opened() {
  const answers: ((touching: Touching | undefined) => void)[] = []
  let events: Parameters<Painter['add']>[0] | undefined
  const looks: string[] = []
  const sent: unknown[] = []
  const asked: unknown[][] = []
  const opening: ((edited: object) => void)[] = []
  const scene = {
    circles: { get: (id: number) => ({ x: id, y: 0, r: 1 }) },
    setLayers: (layers: unknown) => {
      if (unsendable !== undefined) throw unsendable
      sent.push(layers)
    },
    findAgain: (layers: unknown) => sent.push(['found', layers]),
    mark: (...ids: unknown[]) => sent.push(['mark', ...ids]),
    cancel: () => true,
    hitAt: (...where: unknown[]) => where,
    open: (...how: unknown[]) => {
      asked.push(['open', ...how])
      return new Promise<object>((resolve) => opening.push(resolve))
    },
    look: () => looks.push('look'),
    close: () => looks.push('close'),
    ask: (...question: unknown[]) => {
      asked.push(question)
      return new Promise<Touching | undefined>((resolve) => answers.push(resolve))
    },
    edit: () => Promise.reject(refusal),
  }
  const painter = {
    add(given: typeof events) {
      events = given
      return scene
    },
  } as unknown as Painter
  const classList = { add() {} }
  const attributes: [string, boolean][] = []
  const container = {
    classList,
    style: { colorScheme: 'dark' },
    ariaBusy: '',
    toggleAttribute: (name: string, isOn: boolean) => attributes.push([name, isOn]),
    appendChild: (child: unknown) => child,
    currentCSSZoom: 1,
    clientWidth: 80,
    clientHeight: 60,
    offsetWidth: 80,
    offsetHeight: 60,
    getBoundingClientRect: () => ({ width: 80, height: 60 }),
  }
  let disposals = 0
  const view = new View(container as unknown as HTMLElement, painter, () => {
    disposals += 1
  })
  views.push(view)
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
  return {
    ...{ view, answers, shown, edited, marked, resize, looks: () => looks.splice(0) },
    ...{ sent, asked, opening, container, attributes, disposals: () => disposals, events: () => events as Events },
  }
}
type Events = Parameters<Painter['add']>[0]

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

it('drops pixels, discs and results of former circles once others are opened, and tells so', async () => {
  const { view, answers, asked, opening, events, shown, looks } = opened()
  const told: unknown[] = []
  view.on('found', (found) => told.push(found))
  view.on('changed', (changed) => told.push(changed))
  const touched = view.touch(HERE, 1)
  answers[0]?.(DISC)
  await touched
  events().found('results' as never)
  shown()
  expect([drawn.at(-1)?.touching, drawn.at(-1)?.found]).toEqual([DISC, 'results'])
  picture.length = 0
  looks()
  const [circles, change, kept] = [new Float64Array(3), { colors: '1' }, { ids: Int32Array.of(7) }]
  const done = view.setCircles(circles, change, kept as never)
  expect(asked.at(-1)).toEqual(['open', circles, change, kept])
  expect([picture, looks(), frames.length]).toEqual([['clear', 'see'], ['look'], 1])
  expect(view.cancel()).toBe(true)
  opening[0]?.({ counts: 1 })
  expect(await done).toEqual({ counts: 1 })
  expect(told).toEqual(['results', undefined, { counts: 1 }])
  shown()
  expect([drawn.at(-1)?.touching, drawn.at(-1)?.found]).toEqual([undefined, undefined])
})

it('tells listeners until they unsubscribe, and nobody after its end', () => {
  const { view, events } = opened()
  const told: string[] = []
  const stop = view.on('camera', () => told.push('first'))
  view.on('camera', () => told.push('second'))
  const camera = { x: 0, y: 0, scale: 1 }
  view.setCamera(camera)
  stop()
  view.setCamera(camera)
  expect(told).toEqual(['first', 'second', 'second'])
  const highlights = { selected: undefined, hovered: undefined }
  view.on('marked', () => told.push('marked'))
  view.on('failed', () => told.push('failed'))
  events().outlined(highlights)
  events().marked(highlights)
  expect(told.slice(3)).toEqual(['marked'])
  view.dispose()
  view.setCamera(camera)
  events().marked(highlights)
  events().failed(new Error('It broke.') as never, { marks: true, layers: false })
  expect(told).toHaveLength(4)
})

it('passes questions, highlights and places on to its scene', async () => {
  const { view, asked, sent } = opened()
  view.ask('room', 1, 2)
  expect(asked.at(-1)).toEqual(['room', 1, 2])
  sent.length = 0
  view.mark(1, 2)
  view.select(3)
  expect(sent).toEqual([
    ['mark', 1, 2],
    ['mark', 3, undefined],
  ])
  expect(view.hitAt(HERE, 1, 2)).toEqual([HERE, 1, 2])
})

it('shows only circles without a diagram, with their own colors, and tells it once', () => {
  const { view, sent, looks } = opened()
  const told: unknown[] = []
  view.on('diagram', (isShown) => told.push(isShown))
  const own = { values: Float64Array.of(0), colors: ['red'] }
  view.setLayers({ hull: true })
  sent.length = 0
  looks()
  view.hasDiagram = true
  expect([sent, told, looks()]).toEqual([[], [], []])
  view.hasDiagram = false
  view.hasDiagram = false
  expect(sent).toEqual([expect.objectContaining({ hull: false, edges: false, circles: true })])
  expect([told, view.hasDiagram, view.layers.hull, looks()]).toEqual([[false], false, true, ['look']])
  view.setIdentities([], own)
  view.setIdentities([], own)
  expect(sent.slice(1)).toEqual([expect.objectContaining({ hull: false, ownColors: own })])
  view.hasDiagram = true
  expect(sent.at(-1)).toMatchObject({ hull: true, ownColors: own })
})

it('layers that are refused or cannot be sent change nothing, and others are told', () => {
  const { view, sent, shown } = opened()
  const told: unknown[] = []
  view.on('layers', ({ hull }) => told.push(hull))
  expect(() => view.setLayers({ hull: 1 as never })).toThrow('The layer hull')
  unsendable = new Error('It cannot be cloned.')
  expect(() => view.setLayers({ hull: true })).toThrow('cannot be cloned')
  expect([view.layers.hull, told]).toEqual([false, []])
  unsendable = undefined
  view.setLayers({ hull: true })
  expect([view.layers.hull, view.layers.disc, told]).toEqual([true, true, [true]])
  expect(frames).toHaveLength(1)
  shown()
  view.movePathEnd('to', HERE)
  sent.length = 0
  expect([told, frames.length]).toEqual([[true], 0])
  view.setLayers({ path: { from: { x: 0, y: 0 }, to: { x: 9, y: 9 } } })
  sent.length = 0
  shown()
  view.movePathEnd('to', HERE)
  expect(view.layers.path).toEqual({ from: { x: 0, y: 0 }, to: HERE })
  expect(sent).toEqual([['found', view.layers]])
  expect([told, frames.length]).toEqual([[true, true, true], 1])
})

it('has a handle at the corner of what is chosen, which scales about its middle', () => {
  const { view, shown } = opened()
  expect(view.handleAt({ x: 0, y: 0 }, 1e9)).toBeUndefined()
  view.choose([
    { x: 0, y: 0, r: 1 },
    { x: 10, y: 4, r: 2 },
  ])
  shown()
  expect([...(drawn.at(-1)?.chosen?.circles ?? [])]).toEqual([0, 0, 1, 10, 4, 2])
  expect(drawn.at(-1)?.chosen?.box).toEqual({ minX: -1, minY: -1, maxX: 12, maxY: 6 })
  const corner = view.toScreen({ x: 12, y: -1 })
  expect(view.handleAt({ x: corner.x + 7, y: corner.y }, 0)).toEqual({ x: 5.5, y: 2.5 })
  expect(view.handleAt({ x: corner.x + 7.1, y: corner.y }, 0)).toBeUndefined()
  expect(view.handleAt({ x: corner.x, y: corner.y + 9 }, 2)).toBeDefined()
  // The handle of one circle is at its rim.
  view.choose([{ x: 0, y: 0, r: 2 }])
  shown()
  const side = expect.closeTo(Math.SQRT2, 9)
  expect(drawn.at(-1)?.chosen?.box).toMatchObject({ maxX: side, minY: expect.closeTo(-Math.SQRT2, 9) })
  view.choose([])
  shown()
  expect([drawn.at(-1)?.chosen, view.handleAt(corner, 1e9)]).toEqual([undefined, undefined])
})

it('draws bands, sketches, names and layers of clients with the next frame', () => {
  const { view, shown } = opened()
  const [band, sketch] = [{ from: HERE, to: HERE }, new Float64Array(2)]
  const above = [{ id: 'a', color: 'red' }]
  view.covered = () => ({ top: 1, right: 2, bottom: 3, left: 4 })
  for (const [name, value, act] of [
    ['band', band, () => (view.band = band)],
    ['sketch', sketch, () => (view.sketch = sketch)],
    ['above', above, () => (view.above = above)],
  ] as const) {
    act()
    expect(frames).toHaveLength(1)
    shown()
    expect(drawn.at(-1)?.[name]).toBe(value)
  }
  const names = [{ id: 7, text: 'A' }] as never
  view.setIdentities(names, undefined)
  shown()
  expect(drawn.at(-1)?.names.list).toBe(names)
  expect(drawn.at(-1)?.names.circleOf(7)).toEqual({ x: 7, y: 0, r: 1 })
  expect(drawn.at(-1)?.covered).toEqual({ top: 1, right: 2, bottom: 3, left: 4 })
})

it('writes its picture without highlights, and says where it could not be drawn', async () => {
  const { view, answers, asked, container } = opened()
  for (const write of [() => view.toSVG(), () => view.toPNG(2), () => view.toPrint()]) {
    const written = write()
    answers.at(-1)?.(undefined)
    await expect(written).rejects.toThrow(/could not be drawn/)
  }
  const [svg, png, print] = asked.slice(-3) as [unknown[], unknown[], unknown[]]
  expect(svg.slice(0, 2)).toEqual(['svg', { x: 0, y: 0, scale: 1, width: 80, height: 60 }])
  expect(png.slice(0, 3)).toEqual(['image', { x: 0, y: 0, scale: 2, width: 160, height: 120 }, 2])
  expect(print[2]).toEqual({ paper: '#ffffff' })
  expect([schemes, container.style.colorScheme]).toEqual([['light'], 'dark'])
  const camera = { x: 1, y: 2, scale: 3 }
  view.toSVG({ camera, size: { width: 7, height: 8 } })
  expect(asked.at(-1)?.[1]).toEqual({ ...camera, width: 7, height: 8 })
  await expect(view.toPNG(0)).rejects.toThrow('The scale of a picture')
})

it('a PNG has what is above the picture, without highlights, in its own pixels', async () => {
  const { view, answers, marked, shown } = opened()
  marked({ selected: { id: 0 } as unknown as Described, hovered: undefined })
  view.above = [{ id: 'a', color: 'red' }]
  shown()
  const drawnImages: unknown[] = []
  vi.stubGlobal(
    'OffscreenCanvas',
    class {
      readonly size: readonly number[]
      constructor(...size: number[]) {
        this.size = size
      }
      getContext() {
        return { drawImage: (...args: unknown[]) => drawnImages.push(args) }
      }
      convertToBlob(options: unknown) {
        return { size: this.size, options }
      }
    },
  )
  let isClosed = false
  const image = { close: () => (isClosed = true) }
  vi.stubGlobal('devicePixelRatio', 2)
  const made = view.toPNG()
  answers.at(-1)?.(image as never)
  expect(await made).toEqual({ size: [160, 120], options: { type: 'image/png' } })
  expect([drawnImages, isClosed]).toEqual([[[image, 0, 0]], true])
  expect(drawn.at(-1)).toMatchObject({ above: [{ id: 'a' }], marks: { selected: undefined } })
})

it('is streamed with its highlights, frame by frame, until the stream has ended', () => {
  const { view, shown } = opened()
  shown()
  const layers: unknown[] = []
  const tracks = [{ readyState: 'live' }, { readyState: 'ended' }]
  const stream = { getTracks: () => tracks }
  const create = document.createElement
  Object.assign(document, {
    createElement: () => ({
      getContext: () => ({ drawImage: (...args: unknown[]) => layers.push(args.slice(1)) }),
      captureStream: () => stream,
    }),
  })
  expect(view.stream()).toBe(stream)
  Object.assign(document, { createElement: create })
  expect(layers).toEqual([
    [0, 0, 80, 60],
    [0, 0, 80, 60],
  ])
  shown()
  expect([layers.length, frames.length]).toEqual([4, 1])
  for (const track of tracks) track.readyState = 'ended'
  shown()
  expect([layers.length, frames.length]).toEqual([4, 0])
})

it('has no pixels and asks for none while it is not shown', () => {
  const { view, looks, shown, resize } = opened()
  looks()
  view.isShown = true
  expect(looks()).toEqual([])
  picture.length = 0
  view.isShown = false
  expect(picture).toEqual(['clear'])
  view.setCamera({ x: 0, y: 0, scale: 3 })
  view.setLayers({ hull: true })
  resize(90)
  shown()
  expect([looks(), picture]).toEqual([[], ['clear']])
  view.isShown = true
  expect([looks(), view.isShown]).toEqual([['look'], true])
  shown()
  expect(picture).toContain('draw')
  picture.length = 0
  resize(0)
  expect(looks()).toEqual([])
})

it('asks for pixels as fine as it is enlarged on the screen, up to four times', () => {
  const { container, shown, view } = opened()
  const enlarged = (scale: number) => {
    Object.assign(container, { getBoundingClientRect: () => ({ width: 80 * scale, height: 60 * scale }) })
    view.setCamera(view.camera)
    shown()
    return looked[2]
  }
  expect([1, 1.04, 2, 2.08, 3, 9, 0.5].map(enlarged)).toEqual([1, 1, 2, 2, 3, 4, 1])
  enlarged(2)
  looked = []
  const print = media.get('print') as { matches: boolean }
  print.matches = true
  enlarged(3)
  // The camera itself asks for pixels of the former scale.
  expect(looked[2]).toBe(2)
})

it('is busy until all pixels are there, and sharp', () => {
  const { view, shown, container, edited } = opened()
  shown()
  expect(container.ariaBusy).toBe('false')
  isSharp = false
  view.setCamera({ x: 0, y: 0, scale: 3 })
  shown()
  expect(container.ariaBusy).toBe('true')
  isSharp = true
  picture.length = 0
  edited()
  shown()
  expect([picture, container.ariaBusy]).toEqual([['put', 'draw'], 'false'])
  shown()
  expect(picture).toEqual(['put', 'draw'])
})

it('prints no highlights, in the size of the screen', () => {
  const { marked, shown, resize, view, looks } = opened()
  marked({ selected: { id: 0 } as unknown as Described, hovered: undefined })
  shown()
  expect(drawn.at(-1)?.marks.selected).toBeDefined()
  const print = media.get('print') as EventTarget & { matches: boolean }
  print.matches = true
  looks()
  print.dispatchEvent(new Event('change'))
  expect(drawn.at(-1)?.marks.selected).toBeUndefined()
  resize(500)
  expect([view.size.width, looks()]).toEqual([80, []])
  print.matches = false
  print.dispatchEvent(new Event('change'))
  expect(drawn.at(-1)?.marks.selected).toBeDefined()
  resize(500)
  expect(view.size.width).toBe(500)
})

it('reads its style again after style sheets have loaded, and marks whether it is dark', () => {
  const { attributes, looks, view } = opened()
  const told: unknown[] = []
  view.on('style', (style) => told.push(style))
  class Link extends EventTarget {
    relList = { contains: (name: string) => name === this.kind }
    kind = 'stylesheet'
  }
  vi.stubGlobal('HTMLLinkElement', Link)
  readings = 0
  looks()
  picture.length = 0
  attributes.length = 0
  const load = (target: EventTarget) => {
    const event = new Event('load')
    Object.defineProperty(event, 'target', { value: target })
    for (const listen of loads) listen(event)
  }
  load(new Link())
  expect([readings, picture, looks(), told.length, attributes]).toEqual([
    1,
    ['clear', 'see'],
    ['look'],
    1,
    [['data-dark', false]],
  ])
  load(Object.assign(new Link(), { kind: 'icon' }))
  load(new EventTarget())
  expect(readings).toBe(1)
})

it('goes on after a failure without what may have caused it, and tells it', () => {
  const { view, marked, events, shown, sent } = opened()
  const told: unknown[] = []
  view.on('failed', (failed) => told.push(failed))
  const selected = { id: 0 } as unknown as Described
  for (const [marks, layers] of [
    [false, false],
    [true, false],
    [false, true],
  ] as const) {
    view.setLayers({ hull: true })
    marked({ selected, hovered: undefined })
    shown()
    sent.length = 0
    const error = new Error('It broke.')
    events().failed(error as never, { marks, layers })
    expect(told.pop()).toEqual({ error, marks })
    expect(view.layers.hull).toBe(!layers)
    if (layers) expect(view.layers).toEqual(DEFAULT_LAYERS)
    shown()
    expect(drawn.at(-1)?.marks.selected).toBe(marks ? undefined : selected)
  }
})

it('ends once, with all that it has added', () => {
  const { view, looks, disposals } = opened()
  looks()
  view.dispose()
  expect([removed.sort(), looks(), disposals()]).toEqual([['canvas', 'canvas', 'observer'], ['close'], 1])
})
