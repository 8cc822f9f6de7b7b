// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of the painting thread without a browser. Its canvases have no pixels.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { FromThread, ToThread } from '../../web/lib/threads/channel.ts'
import { compileCircleVoronoi } from '../../web/lib/wasm/load-options.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { answerViews } from '../../web/view/painter/painter-thread.ts'
import type {
  ComputingRequests,
  DrawnSvg,
  EditedPicture,
  Highlights,
  PainterEvents,
  PainterRequests,
  PaintRequest,
} from '../../web/view/protocol.ts'
import type { Style } from '../../web/view/style.ts'
import { NAMED_STYLE } from './named-style.ts'
import { Path } from './page-canvas.ts'
import { tickingClock } from './turns.ts'

const CIRCLES = Float64Array.of(0, 0, 1, 10, 0, 2, 4, 9, 3)
const LARGEST = 16_384
/** A busy machine may take long to start the thread. */
const SOON = { timeout: 40_000 }

/** Accepts any drawing. */
const context: unknown = new Proxy({}, { get: () => () => {}, set: () => true })

class FakeCanvas {
  readonly width: number
  constructor(width: number) {
    if (!(width > 0 && width <= LARGEST)) throw new RangeError('no such canvas')
    this.width = width
  }
  getContext() {
    return context
  }
  transferToImageBitmap() {
    return { width: this.width }
  }
}

type Requests = PainterRequests & ComputingRequests
const said: FromThread[] = []
/** The events of the thread about one scene. */
const eventsOf = <Name extends keyof PainterEvents>(name: Name, scene: number) =>
  said.flatMap((message) => {
    if (!('event' in message) || message.event !== name) return []
    const data = message.data as PainterEvents[Name]
    return data.scene === scene ? [data] : []
  })
let lastRequest = 0
/** Sends a request, and returns its number. */
function send<Name extends keyof Requests>(name: Name, ...args: Parameters<Requests[Name]>): number {
  lastRequest += 1
  const request: ToThread = { id: lastRequest, name, args, tellsProgress: false }
  ;(globalThis as unknown as Worker).onmessage?.({ data: request } as MessageEvent)
  return lastRequest
}
const answerOf = (id: number) =>
  said.find((message) => 'id' in message && message.id === id) as { value?: unknown; error?: unknown } | undefined
/** Sends a request, and waits for its value or its error. */
async function ask<Name extends keyof Requests>(name: Name, ...args: Parameters<Requests[Name]>) {
  const id = send(name, ...args)
  await vi.waitFor(() => expect(answerOf(id)).toBeDefined(), SOON)
  const { value, error } = answerOf(id) as { value?: unknown; error?: unknown }
  return error === undefined ? { value } : { error }
}
const answer = async <Name extends keyof Requests>(name: Name, ...args: Parameters<Requests[Name]>) =>
  (await ask(name, ...args)).value
/** Waits until everything sent has been answered. */
const heard = (scene: number) => ask('touch', scene, 0, 0, 1)

/** A paint request for a square of tiles. */
function requestOf(paintId: number, id: number, scale: number, tiles: number): PaintRequest {
  const size = 256 * tiles
  const box = { left: -size / 2, top: -size / 2, width: size, height: size }
  return { paintId, grid: { id, x: 0, y: 0, scale, pixelRatio: 1 }, seen: box, wanted: box }
}

vi.stubGlobal('postMessage', (message: FromThread) => said.push(message))
answerViews()
send('start', await compileCircleVoronoi({}), {})

beforeEach(() => {
  vi.stubGlobal('postMessage', (message: FromThread) => said.push(message))
  vi.stubGlobal('OffscreenCanvas', FakeCanvas)
  vi.stubGlobal('Path2D', Path)
  said.length = 0
})
afterEach(() => vi.unstubAllGlobals())

/** Adds a scene and opens circles in it. */
async function openScene(scene: number): Promise<void> {
  send('add', scene)
  send('open', scene, 1, CIRCLES, undefined, {})
  await heard(scene)
}

it('what is found is told once, also where the rest after circles were opened is over later', async () => {
  await openScene(7)
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  try {
    const found = () => eventsOf('found', 7)
    send('open', 7, 2, CIRCLES, undefined, {})
    send('layers', 7, { ...DEFAULT_LAYERS, hull: true }, true)
    // The module for the method is loaded first.
    await vi.waitFor(() => expect(found()).toHaveLength(1), SOON)
    await vi.advanceTimersByTimeAsync(10_000)
    expect(found()).toHaveLength(1)
    // Opens other circles, whose results follow after a pause.
    send('open', 7, 3, CIRCLES.slice(3), undefined, {})
    await vi.advanceTimersByTimeAsync(0)
    expect(found()).toHaveLength(1)
    await vi.advanceTimersByTimeAsync(10_000)
    expect(found()).toHaveLength(2)
    send('close', 7)
  } finally {
    vi.useRealTimers()
  }
})

it('a search that an edit has overtaken tells nothing', async () => {
  await openScene(8)
  const endClock = tickingClock(20)
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  try {
    const found = () => eventsOf('found', 8)
    send('layers', 8, { ...DEFAULT_LAYERS, hull: true }, true)
    await vi.waitFor(() => expect(found()).toHaveLength(1), SOON)
    await ask('open', 8, 2, CIRCLES, undefined, {})
    // The search begins, and its first step waits for the next slice.
    vi.advanceTimersByTime(1000)
    const edited = send('edit', 8, 2, [{ kind: 'remove', id: 2 }], {})
    await vi.waitFor(() => expect(answerOf(edited)?.value).toMatchObject({ found: expect.anything() }), SOON)
    await vi.advanceTimersByTimeAsync(1000)
    await heard(8)
    for (let turn = 0; turn < 20; turn++) await new Promise((resolve) => setImmediate(resolve))
    expect(found()).toHaveLength(1)
    send('close', 8)
  } finally {
    vi.useRealTimers()
    endClock()
  }
})

describe('what stands out', () => {
  it('has other outlines where another box, or another scale, is looked at', async () => {
    await openScene(1)
    send('look', 1, requestOf(1, 1, 10, 1), NAMED_STYLE)
    const first = (await answer('mark', 1, 0, undefined)) as Highlights
    const outlined = () => eventsOf('outlined', 1)
    // Requests the same pixels again, for other layers.
    send('look', 1, requestOf(2, 1, 10, 1), NAMED_STYLE)
    await heard(1)
    expect(outlined()).toEqual([])
    send('look', 1, requestOf(3, 1, 10, 3), NAMED_STYLE)
    send('look', 1, requestOf(4, 2, 2, 1), NAMED_STYLE)
    await heard(1)
    const told = [first, ...outlined().map(({ marks }) => marks)]
    const reach = told.map((marks) => Math.max(...(marks.selected?.outline ?? [])))
    expect(reach).toHaveLength(3)
    expect(reach[1]).toBeGreaterThan(reach[0] as number)
    expect(reach[2]).toBeGreaterThan(reach[1] as number)
    send('mark', 1, undefined, undefined)
    send('look', 1, requestOf(5, 3, 1, 1), NAMED_STYLE)
    await heard(1)
    expect(outlined()).toHaveLength(2)
    send('close', 1)
  })

  it('is as fine as the scale that is looked at: the clearest path, too', async () => {
    await openScene(2)
    send('look', 2, requestOf(1, 1, 1, 1), NAMED_STYLE)
    const path = { from: { x: -5, y: 8 }, to: { x: 12, y: 8 } }
    send('layers', 2, { ...DEFAULT_LAYERS, path }, true)
    const pieces = () => eventsOf('found', 2).map(({ found }) => found.path?.outline.length ?? 0)
    await vi.waitFor(() => expect(pieces()).toHaveLength(1), SOON)
    send('look', 2, requestOf(2, 2, 1e5, 1), NAMED_STYLE)
    await vi.waitFor(() => expect(pieces()).toHaveLength(2), SOON)
    expect(pieces()[1]).toBeGreaterThan(pieces()[0] as number)
    send('close', 2)
  })
})

it('edits for other circles than those of the scene change nothing, and those that come after them are done', async () => {
  await openScene(6)
  const edit = (opening: number) => ask('edit', 6, opening, [{ kind: 'remove', id: 2 }], {})
  send('open', 6, 2, CIRCLES, undefined, {})
  expect(await edit(1)).toEqual({ value: undefined })
  expect(await edit(2)).toMatchObject({ value: { counts: { circles: 2 } } })
  send('close', 6)
})

it('an SVG has the power diagram and what depends on all circles, however soon it is asked for', async () => {
  await openScene(5)
  send('layers', 5, { ...DEFAULT_LAYERS, hull: true, power: true }, true)
  const frame = { x: 0, y: 0, scale: 1, width: 100, height: 100 }
  const { elements, found } = (await answer('svg', 5, frame, NAMED_STYLE, [])) as DrawnSvg
  expect(elements).toContain('stroke="power"')
  expect(found.hull?.length).toBeGreaterThan(0)
  send('close', 5)
})

describe('questions', () => {
  it('are answered about the circles of their scene, also where an edit has changed them', async () => {
    await openScene(11)
    send('edit', 11, 1, [{ kind: 'remove', id: 1 }], {})
    expect(await answer('measure', 11)).toMatchObject({
      degrees: Int32Array.of(0, 2),
      certificate: { certified: true },
    })
    expect(await answer('tell', 11, [0, 1])).toMatchObject({ circles: 2, edges: 1, vertices: 0 })
    expect(await answer('legend', 11)).toBeUndefined()
    send('layers', 11, { ...DEFAULT_LAYERS, cells: 'radius' }, true)
    expect(await answer('legend', 11)).toMatchObject({ measure: 'radius' })
    expect(await answer('try', 11, { x: 20, y: 0, r: 1 })).toMatchObject({ circle: { x: 20, y: 0, r: 1 } })
    expect(await answer('try', 11, { x: 20, y: 0, r: -1 })).toBeUndefined()
    send('close', 11)
  })

  it('about a method are answered with the ids of their circles, also about edits', async () => {
    const circles = Float64Array.of(0, 0, 1, 4, 9, 3)
    const ids = Int32Array.of(0, 2)
    expect(await answer('trace', circles, ids, {})).toMatchObject({ circles, ids })
    const inserted = [
      { kind: 'insert', circle: [9, 9, 1] },
      { kind: 'remove', id: 2 },
    ] as const
    expect(await answer('trace', circles, ids, { edits: inserted })).toMatchObject({ ids })
    expect(await ask('trace', circles, ids, { edits: [{ kind: 'remove', id: 1 }] })).toMatchObject({
      error: { code: 'unknownCircle', circle: 1 },
    })
    const computed = (await answer('compute', circles, undefined, { method: 'flip' })) as object
    expect(Object.keys(computed).sort()).toEqual(['certificate', 'stats'])
    expect(await answer('compute', circles, undefined, { method: 'magic' as 'flip' })).toEqual({
      problem: expect.any(String),
    })
  })

  it('about all cells are answered about the circles that were opened since, and not at all once they are canceled', async () => {
    const many = Float64Array.from({ length: 900 }, (_, k) => (k % 3 === 2 ? 0.1 : ((k * 7919) % 997) / 9))
    await openScene(12)
    send('open', 12, 2, many, undefined, {})
    const endClock = tickingClock(5)
    const first = send('tabulate', 12, ['area'], undefined)
    send('open', 12, 3, CIRCLES, undefined, {})
    await vi.waitFor(() => expect(answerOf(first)?.value).toMatchObject({ ids: Int32Array.of(0, 1, 2) }), SOON)
    send('open', 12, 4, many, undefined, {})
    const second = send('tabulate', 12, ['area'], undefined)
    const cancel: ToThread = { cancel: second }
    await vi.waitFor(async () => {
      ;(globalThis as unknown as Worker).onmessage?.({ data: cancel } as MessageEvent)
      expect(answerOf(second)).toMatchObject({ error: { message: expect.stringContaining('abort') } })
    }, SOON)
    endClock()
    send('close', 12)
  })
})

describe('one scene', () => {
  it('that cannot be drawn as it was asked for is answered with nothing, and all go on', async () => {
    await openScene(3)
    const frame = { x: 0, y: 0, scale: 1, width: 100, height: 100 }
    expect(await ask('image', 3, { ...frame, width: 2 * LARGEST }, 1, NAMED_STYLE)).toEqual({ value: undefined })
    expect(await ask('svg', 3, { ...frame, width: Number.NaN }, NAMED_STYLE, [])).toEqual({ value: undefined })
    expect(await answer('image', 3, frame, 1, NAMED_STYLE)).toEqual({ width: 100 })
    expect(await answer('svg', 3, frame, NAMED_STYLE, [])).toEqual({
      elements: expect.stringContaining('<'),
      found: expect.anything(),
    })
    send('close', 3)
  })
})

describe('an error in painting', () => {
  const broken = new Proxy({} as Style, {
    get: () => {
      throw new RangeError('It broke.')
    },
  })

  it('is told to its scene, and the next request is painted', async () => {
    await openScene(8)
    send('look', 8, requestOf(1, 1, 10, 4), broken)
    await vi.waitFor(() => expect(eventsOf('failed', 8)).toHaveLength(1), SOON)
    expect(eventsOf('failed', 8)).toMatchObject([{ error: { message: expect.stringContaining('It broke') } }])
    send('look', 8, requestOf(2, 1, 10, 4), NAMED_STYLE)
    await vi.waitFor(() => expect(eventsOf('painted', 8).at(-1)).toMatchObject({ paintId: 2, isWhole: true }), SOON)
    expect(eventsOf('painted', 8).flatMap(({ patches }) => patches)).toHaveLength(16)
    expect(eventsOf('failed', 8)).toHaveLength(1)
    send('close', 8)
  })

  it('refuses no edit', async () => {
    await openScene(8)
    send('look', 8, requestOf(1, 1, 10, 1), broken)
    const edited = await ask('edit', 8, 1, [{ kind: 'remove', id: 1 }], {})
    expect(edited).toMatchObject({ value: { counts: { circles: 2 }, patches: [] } })
    expect(await answer('tell', 8, [0, 1])).toMatchObject({ circles: 2 })
    send('close', 8)
  })
})

it('an edit paints what is visible as a whole, also right after another scale', async () => {
  await openScene(8)
  const wanted = { left: -1024, top: -1024, width: 2048, height: 2048 }
  send('look', 8, { ...requestOf(1, 1, 40, 6), wanted }, NAMED_STYLE)
  const edits = [{ kind: 'replace', id: 0, circle: { x: 0, y: 0, r: 1 } }] as const
  const edited = (await answer('edit', 8, 1, edits, {})) as EditedPicture
  const before = said.slice(
    0,
    said.findIndex((message) => 'value' in message && message.value === edited),
  )
  const painted = before.flatMap((message) => ('event' in message ? (message.data as PainterEvents['painted']) : []))
  const tiles = [...painted, edited].flatMap(({ patches }) => patches ?? [])
  const isPainted = (x: number, y: number) =>
    tiles.some(({ box: { left, top, width, height } }) => x >= left && x < left + width && y >= top && y < top + height)
  for (let x = -768; x < 768; x += 64) for (let y = -768; y < 768; y += 64) expect(isPainted(x, y)).toBe(true)
  send('close', 8)
})

it('all scenes are painted in the end, however short the slices of time are', async () => {
  const scenes = [9, 10]
  for (const scene of scenes) await openScene(scene)
  // Between two readings of the clock, the time slice ends.
  const endClock = tickingClock(5)
  for (const scene of scenes) send('look', scene, requestOf(1, 1, 40, 4), NAMED_STYLE)
  await vi.waitFor(() => {
    for (const scene of scenes) expect(eventsOf('painted', scene).at(-1)?.isWhole).toBe(true)
  }, SOON)
  for (const scene of scenes) {
    expect(eventsOf('painted', scene).flatMap(({ patches }) => patches)).toHaveLength(16)
  }
  endClock()
  for (const scene of scenes) send('close', scene)
})

it('long work lets tiles and requests go first', async () => {
  const many = Float64Array.from({ length: 3000 }, (_, k) => (k % 3 === 2 ? 0.1 : ((k * 7919) % 997) / 9))
  await openScene(14)
  send('open', 14, 2, many, undefined, {})
  await heard(14)
  const endClock = tickingClock(5)
  const long = send('measure', 14)
  send('look', 14, requestOf(1, 1, 40, 2), NAMED_STYLE)
  const short = send('tell', 14, [0])
  await vi.waitFor(() => expect(answerOf(long)).toBeDefined(), SOON)
  const painted = said.findLastIndex((message) => 'event' in message && message.event === 'painted')
  const [last, first] = [long, short].map((id) => said.indexOf(answerOf(id) as FromThread)) as [number, number]
  expect(first).toBeLessThan(last)
  expect(painted).toBeLessThan(last)
  endClock()
  send('close', 14)
})
