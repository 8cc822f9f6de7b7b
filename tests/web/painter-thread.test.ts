// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of the painting thread without a browser. Its canvases have no pixels.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { compileCircleVoronoi } from '../../web/lib/wasm/load-options.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { answerViews } from '../../web/view/painter/painter-thread.ts'
import type { DrawnSvg, FromPainter, PaintRequest, ToPainter } from '../../web/view/protocol.ts'
import { SHADES, type Style } from '../../web/view/style.ts'
import { Path } from './page-canvas.ts'

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

const said: FromPainter[] = []
const send = (message: ToPainter) => (globalThis as unknown as Worker).onmessage?.({ data: message } as MessageEvent)
const saidOf = <Kind extends FromPainter['kind']>(kind: Kind) =>
  said.filter((message) => message.kind === kind) as Extract<FromPainter, { kind: Kind }>[]
let lastRequest = 0
const nextRequest = () => ++lastRequest
/** Waits until everything sent has been answered. */
const heard = async (scene: number) => {
  const request = nextRequest()
  send({ kind: 'ask', scene, request, name: 'touch', args: [0, 0, 1] })
  await vi.waitFor(() => expect(saidOf('answer').some((hit) => hit.request === request)).toBe(true), SOON)
}

/** A paint request for a square of tiles. */
function requestOf(paintId: number, id: number, scale: number, tiles: number): PaintRequest {
  const size = 256 * tiles
  const box = { left: -size / 2, top: -size / 2, width: size, height: size }
  return { paintId, grid: { id, x: 0, y: 0, scale, pixelRatio: 1 }, seen: box, wanted: box }
}

vi.stubGlobal('postMessage', (message: FromPainter) => said.push(message))
answerViews()
send({ kind: 'start', module: await compileCircleVoronoi({}), others: {} })

beforeEach(() => {
  vi.stubGlobal('postMessage', (message: FromPainter) => said.push(message))
  vi.stubGlobal('OffscreenCanvas', FakeCanvas)
  vi.stubGlobal('Path2D', Path)
  said.length = 0
})
afterEach(() => {
  expect(saidOf('failed')).toEqual([])
  vi.unstubAllGlobals()
})

const colors = Array.from({ length: SHADES }, () => 'white')
const style = new Proxy({}, { get: (_, name) => (name === 'ramp' || name === 'map' ? colors : 'black') }) as Style

/** Adds a scene and opens circles in it. */
async function openScene(scene: number): Promise<void> {
  send({ kind: 'add', scene })
  send({ kind: 'open', scene, revision: 1, opening: 1, circles: CIRCLES })
  await heard(scene)
}

it('what is found is told once, also where the rest after circles were opened is over later', async () => {
  await openScene(7)
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  try {
    const found = () => saidOf('found').filter(({ scene }) => scene === 7)
    send({ kind: 'open', scene: 7, revision: 2, opening: 2, circles: CIRCLES })
    send({ kind: 'layers', scene: 7, layers: { ...DEFAULT_LAYERS, hull: true }, isPainted: true })
    // The module for the method is loaded first.
    await vi.waitFor(() => expect(found()).toHaveLength(1), SOON)
    await vi.advanceTimersByTimeAsync(10_000)
    expect(found()).toHaveLength(1)
    // Opens other circles, whose results follow after a pause.
    send({ kind: 'open', scene: 7, revision: 3, opening: 3, circles: CIRCLES.slice(3) })
    await vi.advanceTimersByTimeAsync(0)
    expect(found()).toHaveLength(1)
    await vi.advanceTimersByTimeAsync(10_000)
    expect(found()).toHaveLength(2)
    send({ kind: 'close', scene: 7 })
  } finally {
    vi.useRealTimers()
  }
})

describe('what stands out', () => {
  it('has other outlines where another box, or another scale, is looked at', async () => {
    await openScene(1)
    send({ kind: 'look', scene: 1, style, ...requestOf(1, 1, 10, 1) })
    send({ kind: 'mark', scene: 1, selected: 0, hovered: undefined })
    await heard(1)
    const [first] = saidOf('marked')
    // Requests the same pixels again, for other layers.
    send({ kind: 'look', scene: 1, style, ...requestOf(2, 1, 10, 1) })
    await heard(1)
    expect(saidOf('outlined')).toEqual([])
    send({ kind: 'look', scene: 1, style, ...requestOf(3, 1, 10, 3) })
    send({ kind: 'look', scene: 1, style, ...requestOf(4, 2, 2, 1) })
    await heard(1)
    const told = [first, ...saidOf('outlined')]
    const reach = told.map((message) => Math.max(...(message?.marks.selected?.outline ?? [])))
    expect(reach).toHaveLength(3)
    expect(reach[1]).toBeGreaterThan(reach[0] as number)
    expect(reach[2]).toBeGreaterThan(reach[1] as number)
    send({ kind: 'mark', scene: 1, selected: undefined, hovered: undefined })
    send({ kind: 'look', scene: 1, style, ...requestOf(5, 3, 1, 1) })
    await heard(1)
    expect([saidOf('marked').length, saidOf('outlined').length]).toEqual([2, 2])
    send({ kind: 'close', scene: 1 })
  })

  it('is as fine as the scale that is looked at: the clearest path, too', async () => {
    await openScene(2)
    send({ kind: 'look', scene: 2, style, ...requestOf(1, 1, 1, 1) })
    const path = { from: { x: -5, y: 8 }, to: { x: 12, y: 8 } }
    send({ kind: 'layers', scene: 2, layers: { ...DEFAULT_LAYERS, path }, isPainted: true })
    const pieces = () => saidOf('found').map(({ found }) => found.path?.outline.length ?? 0)
    await vi.waitFor(() => expect(pieces()).toHaveLength(1), SOON)
    send({ kind: 'look', scene: 2, style, ...requestOf(2, 2, 1e5, 1) })
    await vi.waitFor(() => expect(pieces()).toHaveLength(2), SOON)
    expect(pieces()[1]).toBeGreaterThan(pieces()[0] as number)
    send({ kind: 'close', scene: 2 })
  })
})

it('edits for other circles than those of the scene change nothing, and those that come after them are done', async () => {
  await openScene(6)
  const edit = (revision: number, opening: number) =>
    send({ kind: 'edit', scene: 6, revision, opening, edits: [{ kind: 'remove', id: 2 }] })
  send({ kind: 'open', scene: 6, revision: 2, opening: 2, circles: CIRCLES })
  edit(3, 1)
  edit(4, 2)
  await heard(6)
  expect(saidOf('superseded')).toEqual([{ kind: 'superseded', scene: 6, revision: 3 }])
  expect(saidOf('edited').map(({ revision, counts }) => [revision, counts.circles])).toEqual([[4, 2]])
  send({ kind: 'close', scene: 6 })
})

it('says what it was doing when it failed, and for which scene', async () => {
  await openScene(8)
  const broken = new Proxy({} as Style, {
    get: () => {
      throw new RangeError('It broke.')
    },
  })
  send({ kind: 'look', scene: 8, style: broken, ...requestOf(1, 1, 10, 1) })
  await vi.waitFor(() => expect(saidOf('failed')).toHaveLength(1), SOON)
  const message = expect.stringContaining('It broke')
  expect(saidOf('failed')).toEqual([{ kind: 'failed', message, during: { scene: 8, kind: 'paint' } }])
  said.length = 0
  send({ kind: 'close', scene: 8 })
})

it('an SVG has the power diagram and what depends on all circles, however soon it is asked for', async () => {
  await openScene(5)
  send({ kind: 'layers', scene: 5, layers: { ...DEFAULT_LAYERS, hull: true, power: true }, isPainted: true })
  const before = saidOf('answer').length
  const frame = { x: 0, y: 0, scale: 1, width: 100, height: 100 }
  const told = new Proxy(style, { get: (style, name) => (name === 'power' ? 'power' : Reflect.get(style, name)) })
  send({ kind: 'ask', scene: 5, request: nextRequest(), name: 'svg', args: [frame, told, []] })
  await heard(5)
  const { elements, found } = saidOf('answer').map(({ value }) => value)[before] as DrawnSvg
  expect(elements).toContain('stroke="power"')
  expect(found.hull?.length).toBeGreaterThan(0)
  send({ kind: 'close', scene: 5 })
})

describe('questions', () => {
  /** The answer of the thread to a question. */
  const ask = async (scene: number, name: Extract<ToPainter, { kind: 'ask' }>['name'], ...args: unknown[]) => {
    const request = nextRequest()
    send({ kind: 'ask', scene, request, name, args } as unknown as ToPainter)
    const answered = () => saidOf('answer').find((answer) => answer.request === request)
    await vi.waitFor(() => expect(answered()).toBeDefined(), SOON)
    const { kind: _, request: __, ...answer } = answered() as Extract<FromPainter, { kind: 'answer' }>
    return answer as { value?: unknown; error?: unknown }
  }
  const answerTo = async (...question: Parameters<typeof ask>) => (await ask(...question)).value

  it('are answered about the circles of their scene, also where an edit has changed them', async () => {
    await openScene(11)
    send({ kind: 'edit', scene: 11, revision: 2, opening: 1, edits: [{ kind: 'remove', id: 1 }] })
    const trace = (await answerTo(11, 'trace', {})) as { circles: Float64Array; ids: Int32Array }
    expect([[...trace.ids], [...trace.circles]]).toEqual([
      [0, 2],
      [0, 0, 1, 4, 9, 3],
    ])
    const edits = [
      { kind: 'insert', circle: [9, 9, 1] },
      { kind: 'remove', id: 2 },
    ]
    expect(await ask(11, 'trace', { edits })).toMatchObject({ value: { ids: Int32Array.of(0, 2) } })
    expect(await ask(11, 'trace', { edits: [{ kind: 'remove', id: 1 }] })).toMatchObject({
      error: { code: 'unknownCircle', circle: 1 },
    })
    const computed = (await answerTo(11, 'compute', { method: 'flip' })) as object
    expect(Object.keys(computed).sort()).toEqual(['certificate', 'stats'])
    expect(await answerTo(11, 'compute', { method: 'magic' })).toEqual({
      problem: expect.any(String),
    })
    expect(await answerTo(11, 'measure')).toMatchObject({
      degrees: Int32Array.of(0, 2),
      certificate: { certified: true },
    })
    expect(await answerTo(11, 'tell', [0, 1])).toMatchObject({ circles: 2, edges: 1, vertices: 0 })
    expect(await answerTo(11, 'legend')).toBeUndefined()
    send({ kind: 'layers', scene: 11, layers: { ...DEFAULT_LAYERS, cells: 'radius' }, isPainted: true })
    expect(await answerTo(11, 'legend')).toMatchObject({ measure: 'radius' })
    expect(await answerTo(11, 'try', { x: 20, y: 0, r: 1 })).toMatchObject({ circle: { x: 20, y: 0, r: 1 } })
    expect(await answerTo(11, 'try', { x: 20, y: 0, r: -1 })).toBeUndefined()
    send({ kind: 'close', scene: 11 })
  })

  it('about all cells are answered about the circles that were opened since, and not at all once their scene is closed', async () => {
    const many = Float64Array.from({ length: 900 }, (_, k) => (k % 3 === 2 ? 0.1 : ((k * 7919) % 997) / 9))
    await openScene(12)
    send({ kind: 'open', scene: 12, revision: 2, opening: 2, circles: many })
    const [first, second] = [nextRequest(), nextRequest()]
    const measure = (request: number) =>
      send({ kind: 'ask', scene: 12, request, name: 'tabulate', args: [['area'], undefined] })
    let now = performance.now()
    const clock = vi.spyOn(performance, 'now').mockImplementation(() => {
      now += 5
      return now
    })
    measure(first)
    send({ kind: 'open', scene: 12, revision: 3, opening: 3, circles: CIRCLES })
    const answer = (request: number) => saidOf('answer').find((hit) => hit.request === request)?.value
    await vi.waitFor(() => expect(answer(first)).toMatchObject({ ids: Int32Array.of(0, 1, 2) }), SOON)
    send({ kind: 'open', scene: 12, revision: 4, opening: 4, circles: many })
    measure(second)
    send({ kind: 'close', scene: 12 })
    await openScene(13)
    await ask(13, 'tabulate', ['area'], undefined)
    expect(answer(second)).toBeUndefined()
    clock.mockRestore()
    send({ kind: 'close', scene: 13 })
  })
})

describe('one scene', () => {
  it('that cannot be drawn as it was asked for is answered with nothing, and all go on', async () => {
    await openScene(3)
    const draw = (width: number, name: 'image' | 'svg') => {
      const frame = { x: 0, y: 0, scale: 1, width, height: 100 }
      const args = name === 'svg' ? [frame, style, []] : [frame, 1, style]
      send({ kind: 'ask', scene: 3, request: nextRequest(), name, args })
    }
    draw(2 * LARGEST, 'image')
    draw(Number.NaN, 'svg')
    draw(100, 'image')
    draw(100, 'svg')
    const before = saidOf('answer').length
    await heard(3)
    expect(
      saidOf('answer')
        .slice(before, -1)
        .map(({ value }) => value),
    ).toEqual([
      undefined,
      undefined,
      { width: 100 },
      { elements: expect.stringContaining('<'), found: expect.anything() },
    ])
    send({ kind: 'close', scene: 3 })
  })
})

it('an edit paints what is visible as a whole, also right after another scale', async () => {
  await openScene(8)
  const request = requestOf(1, 1, 40, 6)
  const wanted = { left: -1024, top: -1024, width: 2048, height: 2048 }
  send({ kind: 'look', scene: 8, style, ...request, wanted })
  send({
    kind: 'edit',
    scene: 8,
    revision: 2,
    opening: 1,
    edits: [{ kind: 'replace', id: 0, circle: { x: 0, y: 0, r: 1 } }],
  })
  await heard(8)
  const [edited] = saidOf('edited')
  const before = said.slice(0, said.indexOf(edited as FromPainter))
  const tiles = [...before, edited as FromPainter].flatMap((message) => ('patches' in message ? message.patches : []))
  const isPainted = (x: number, y: number) =>
    tiles.some(({ box: { left, top, width, height } }) => x >= left && x < left + width && y >= top && y < top + height)
  for (let x = -768; x < 768; x += 64) for (let y = -768; y < 768; y += 64) expect(isPainted(x, y)).toBe(true)
  send({ kind: 'close', scene: 8 })
})

it('all scenes are painted in the end, however short the slices of time are', async () => {
  const scenes = [9, 10]
  for (const scene of scenes) await openScene(scene)
  let now = performance.now()
  // Between two readings of the clock, the time slice ends.
  const clock = vi.spyOn(performance, 'now').mockImplementation(() => {
    now += 5
    return now
  })
  for (const scene of scenes) send({ kind: 'look', scene, style, ...requestOf(1, 1, 40, 4) })
  const wholes = () => saidOf('painted').filter(({ isWhole }) => isWhole)
  await vi.waitFor(() => expect(wholes().map(({ scene }) => scene)).toEqual(scenes), SOON)
  for (const painted of scenes) {
    const tiles = saidOf('painted').flatMap(({ scene, patches }) => (scene === painted ? patches : []))
    expect(tiles).toHaveLength(16)
  }
  clock.mockRestore()
  for (const scene of scenes) send({ kind: 'close', scene })
})
