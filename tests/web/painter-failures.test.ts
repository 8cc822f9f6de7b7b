// SPDX-License-Identifier: GPL-3.0-or-later
// Two scenes of one painting thread that gets wrong requests and breaks down at random: every request ends, and afterwards
// each scene has the diagram of its circles.
// @vitest-environment happy-dom
import fc from 'fast-check'
import { afterAll, beforeEach, describe, expect, it, vi } from 'vitest'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import type { ToThread } from '../../web/lib/threads/channel.ts'
import { DEFAULT_LAYERS, type PaintedLayers } from '../../web/view/layers.ts'
import { Painter } from '../../web/view/painter.ts'
import type { Facts, PainterRequests } from '../../web/view/protocol.ts'
import { ENGLISH_REFUSALS, Failure, Superseded } from '../../web/view/refusal.ts'
import type { PictureEvents, SceneClient } from '../../web/view/scene-client.ts'
import { styleOf } from '../../web/view/style.ts'
import { action as actionOf, editOf } from './arbitrary-circles.ts'
import { Canvas, Path } from './page-canvas.ts'
import { ThreadHere } from './page-threads.ts'
import { fetchHere } from './whole-page.ts'

const REGION = [0, 1, 2].map((k) => [k === 0 ? -5 : 15, k < 2 ? -5 : 15] as const)
const DOMAINS = [
  { region: null, lattice: null },
  { region: null, lattice: { a: [40, 0], b: [3, 45] } },
  { region: [REGION], lattice: null },
] as const

vi.stubGlobal('fetch', fetchHere)
vi.stubGlobal('Worker', ThreadHere)
vi.stubGlobal('OffscreenCanvas', Canvas)
vi.stubGlobal('Path2D', Path)
afterAll(() => vi.unstubAllGlobals())
beforeEach(() => ThreadHere.endAll())

const circle = fc.record({
  x: fc.integer({ min: 0, max: 20 }),
  y: fc.integer({ min: 0, max: 20 }),
  r: fc.constantFrom(0, 1, 2, 5, -1),
})
const id = fc.nat(9)
const edit = editOf(circle)
const TWO = Float64Array.of(0, 0, 1, 9, 0, 1)
/** Wrong requests that make the thread throw a `TypeError`. */
const NOTHING = undefined as never
const BIG = 1n as never
const WRONG = {
  open: (one: SceneClient) => one.open(TWO, null as never),
  // The thread has the other circles before the error.
  reopen: (one: SceneClient) => one.open(Float64Array.of(7, 7, 1), { colors: null as never }),
  // The editor makes the edit before the error.
  edit: (one: SceneClient) => one.edit([{ kind: 'insert', circle: [3, 9, 1] }], { colors: null as never }),
  room: (one: SceneClient) => one.ask('room', [BIG, BIG]),
  touch: (one: SceneClient) => one.ask('touch', [BIG, BIG, 0]),
  try: (one: SceneClient) => one.ask('try', [NOTHING]),
  fit: (one: SceneClient) => one.ask('fit', [TWO, NOTHING, [REGION]]),
  tabulate: (one: SceneClient) => one.ask('tabulate', [NOTHING, undefined]),
  tell: (one: SceneClient) => one.ask('tell', [NOTHING]),
}
const wrongRequests = Object.keys(WRONG) as (keyof typeof WRONG)[]
/** Layers with which some answers are impossible: views refuse all but the first two. */
const LAYERS = {
  plain: DEFAULT_LAYERS,
  hull: { ...DEFAULT_LAYERS, hull: true },
  column: { ...DEFAULT_LAYERS, cells: 'area', column: { name: 'a', values: null as never } },
  path: { ...DEFAULT_LAYERS, path: { from: null as never, to: null as never } },
  distance: { ...DEFAULT_LAYERS, cells: 'area', maxDistance: BIG },
} satisfies Record<string, PaintedLayers>
const BOX = { left: 0, top: 0, width: 256, height: 256 }
const request = { paintId: 1, grid: { id: 1, x: 0, y: 0, scale: 1, pixelRatio: 1 }, seen: BOX, wanted: BOX }
const STYLE = styleOf(new Proxy({}, { get: () => 'red' }))
const FRAME = { x: 0, y: 0, scale: 1, width: 100, height: 100 }
const QUESTIONS = {
  tell: (one: SceneClient) => one.ask('tell', [[0, 1]]),
  legend: (one: SceneClient) => one.ask('legend', []),
  measure: (one: SceneClient) => one.ask('measure', []),
  tabulate: (one: SceneClient) => one.ask('tabulate', [['area'], undefined]),
  svg: (one: SceneClient) => one.ask('svg', [FRAME, STYLE, []]),
  fit: (one: SceneClient) => one.ask('fit', [TWO, [1, 2], [REGION]]),
  canceled: (one: SceneClient) => one.ask('fit', [TWO, [1, 2], [REGION]], AbortSignal.timeout(1)),
}
const scene = fc.nat(1)
const action = fc.oneof(
  actionOf('open', { scene, circles: fc.array(circle, { maxLength: 8 }), domain: fc.nat(2) }),
  actionOf('edit', { scene, edits: fc.array(edit, { minLength: 1, maxLength: 3 }) }),
  actionOf('edit', { scene, edits: fc.array(edit, { minLength: 1, maxLength: 1 }) }),
  actionOf('layers', { scene, layers: fc.constantFrom(...(Object.keys(LAYERS) as (keyof typeof LAYERS)[])) }),
  actionOf('look', { scene }),
  actionOf('mark', { scene, id }),
  actionOf('ask', { scene, question: fc.constantFrom(...(Object.keys(QUESTIONS) as (keyof typeof QUESTIONS)[])) }),
  actionOf('cancel', { scene }),
  actionOf('break', { scene }),
  actionOf('fail', { scene, request: fc.constantFrom(...wrongRequests) }),
  actionOf('wait', { scene }),
)
type Action = typeof action extends fc.Arbitrary<infer Value> ? Value : never

/** Crashes the painting thread. */
function crash(): void {
  const [thread] = ThreadHere.running
  thread?.onerror?.({ message: 'it broke' })
}

/** Waits until no message is under way. */
async function quiet(): Promise<void> {
  for (let turns = 0; turns < 5; turns++) {
    await new Promise((resolve) => setTimeout(resolve))
    if (ThreadHere.isBusy) turns = 0
  }
}

function doIt(one: SceneClient, action: Action): Promise<unknown> | undefined {
  switch (action.kind) {
    case 'open': {
      const circles = Float64Array.from(action.circles.flatMap(({ x, y, r }) => [x, y, r]))
      return one.open(circles, DOMAINS[action.domain])
    }
    case 'edit':
      return one.edit(action.edits)
    case 'layers':
      one.setLayers(LAYERS[action.layers])
      return
    case 'look':
      one.look(request, STYLE)
      return
    case 'mark':
      one.mark(action.id, undefined)
      return
    case 'ask':
      return QUESTIONS[action.question](one)
    case 'cancel':
      one.cancel()
      return
    case 'break':
      crash()
      return
    case 'fail':
      return WRONG[action.request](one)
    case 'wait':
      return quiet()
  }
}

const listener = (failures: unknown[]): PictureEvents => ({
  opening() {},
  changed() {},
  painted() {},
  marked() {},
  found() {},
  reopened() {},
  failed: (failure) => failures.push(failure),
})

/** Returns what is known of circles in an order that does not depend on earlier edits, nor sums on the order of parts. */
function factsOf(facts: Facts | undefined) {
  const cells = Array.from(facts?.cells ?? [], ([id, cell]) => {
    const [area, perimeter] = [cell.area, cell.perimeter].map((sum) => sum.toPrecision(9))
    return [id, { ...cell, area, perimeter, neighbors: [...cell.neighbors].sort((a, b) => a - b) }]
  })
  return { ...facts, cells }
}

async function play(script: readonly Action[]): Promise<void> {
  const painter = new Painter()
  const failures: unknown[] = []
  const scenes = [painter.add(listener(failures)), painter.add(listener(failures))]
  const domains = [0, 0]
  const asked: Promise<unknown>[] = []
  try {
    for (const action of script) {
      const answer = doIt(scenes[action.scene] as SceneClient, action)
      if (answer === undefined) continue
      const done = answer.then(() => {
        if (action.kind === 'open') domains[action.scene] = action.domain
      })
      done.catch(() => {})
      asked.push(done)
      if (action.kind === 'wait') await done
    }
    for (const one of scenes) one.setLayers(DEFAULT_LAYERS)
    // An edit or an opening begins another thread where there is none any more.
    for (const one of scenes) await one.edit([]).catch(() => one.edit([]))
    for (const result of await Promise.allSettled(asked)) {
      if (result.status === 'fulfilled') continue
      const isKnown = [CircleVoronoiError, Superseded, Failure].some((kind) => result.reason instanceof kind)
      expect(isKnown, String(result.reason)).toBe(true)
    }
    const isTold = (failure: unknown) => failure instanceof Failure || failure instanceof CircleVoronoiError
    expect(failures.every(isTold)).toBe(true)
    // One thread waits for further fits.
    expect(ThreadHere.running.size).toBeLessThanOrEqual(2)
    for (const [k, one] of scenes.entries()) {
      const { circles } = one
      const fresh = painter.add(listener(failures))
      await fresh.open(circles.circles(), DOMAINS[domains[k] as number], circles.keptIds)
      const ids = [...circles.ids()]
      expect(factsOf(await one.ask('tell', [ids]))).toEqual(factsOf(await fresh.ask('tell', [ids])))
      const inserted = await Promise.all(
        [one, fresh].map((each) => each.edit([{ kind: 'insert', circle: [1, 30, 1] }])),
      )
      expect(inserted[0]?.inserted).toEqual(inserted[1]?.inserted)
      fresh.close()
    }
  } finally {
    painter.dispose()
    await quiet()
  }
  expect(ThreadHere.running.size).toBe(0)
}

it('whatever breaks down, every request ends, and each scene has the diagram of its circles', async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(action, { minLength: 1, maxLength: 12 }), (script) => play(script)),
    { numRuns: 40 },
  )
}, 300_000)

/** The request at which each thread crashes. */
let crashesAt: keyof PainterRequests | undefined
let started = 0
class CrashingThread extends ThreadHere {
  constructor(url: URL) {
    super(url)
    started += 1
  }
  override postMessage(data: ToThread) {
    if ('name' in data && data.name === crashesAt) setImmediate(() => this.onerror?.({ message: 'it broke' }))
    else super.postMessage(data)
  }
}
const layers = LAYERS.hull

describe('an error in a request', () => {
  const requests = {
    ...WRONG,
    look: (one: SceneClient) => one.look(NOTHING, NOTHING),
    layers: (one: SceneClient) => one.setLayers(NOTHING),
    trace: (one: SceneClient) => one.ask('trace', [null as never]),
  }
  it.each(Object.entries(requests))('to %s is the answer to it alone', async (name, act) => {
    vi.stubGlobal('Worker', CrashingThread)
    crashesAt = undefined
    started = 0
    const failures: unknown[] = []
    const painter = new Painter()
    const [one, other] = [painter.add(listener(failures)), painter.add(listener([]))]
    await Promise.all([one.open(TWO), other.open(TWO)])
    const answer = await Promise.resolve(act(one)).catch((error) => error)
    await quiet()
    const isChange = ['open', 'reopen', 'edit'].includes(name)
    const unexpected = expect.objectContaining({ code: 'internal' })
    expect([answer, failures[0]]).toEqual(isChange ? [unexpected, undefined] : [undefined, unexpected])
    // Views refuse wrong layers, with which nothing could be drawn.
    for (const scene of name === 'layers' ? [other] : [one, other]) {
      const { inserted } = await scene.edit([{ kind: 'insert', circle: [4, 7, 1] }])
      expect([...inserted]).toEqual([2])
      expect((await scene.ask('tell', [[2]]))?.cells.get(2)).toMatchObject({ x: 4, y: 7, r: 1 })
    }
    expect(started).toBe(['fit', 'trace'].includes(name) ? 2 : 1)
    painter.dispose()
    vi.stubGlobal('Worker', ThreadHere)
  })
})

describe('an error that layers cause', () => {
  const requests: readonly (readonly [keyof typeof LAYERS, string, (one: SceneClient) => unknown])[] = [
    ['column', 'legend', QUESTIONS.legend],
    ['distance', 'measure', QUESTIONS.measure],
    ['distance', 'tabulate', QUESTIONS.tabulate],
    ['distance', 'mark', (one) => one.mark(0, undefined)],
    ['column', 'look', (one) => one.look(request, STYLE)],
    ['path', 'open', (one) => one.open(TWO)],
  ]
  it.each(requests)('(%s) in %s is told, and other layers are drawn by the same thread', async (name, _, act) => {
    const failures: unknown[] = []
    const whole = vi.fn()
    const painter = new Painter()
    const one = painter.add({ ...listener(failures), painted: ({ kind }) => kind === 'painted' && whole() })
    await one.open(TWO)
    await quiet()
    const [thread] = ThreadHere.running
    one.setLayers(LAYERS[name])
    await quiet()
    failures.length = 0
    const errors: unknown[] = []
    await Promise.resolve(act(one)).catch((error) => errors.push(error))
    // Searches begin after a pause.
    await vi.waitFor(() => expect(failures.length + errors.length).toBe(1), { timeout: 40_000 })
    expect([...failures, ...errors]).toEqual([expect.any(CircleVoronoiError)])
    failures.length = 0
    one.setLayers(LAYERS.hull)
    one.look({ ...request, paintId: 2 }, STYLE)
    expect(await QUESTIONS.measure(one)).toMatchObject({ certificate: { certified: true } })
    await vi.waitFor(() => expect(whole).toHaveBeenCalled(), { timeout: 40_000 })
    expect([failures, [...ThreadHere.running]]).toEqual([[], [thread]])
    painter.dispose()
  })
})

it('a region that cannot be loaded offline refuses its edit, and is loaded by the next one', async () => {
  const painter = new Painter()
  const [one, other] = [painter.add(listener([])), painter.add(listener([]))]
  await Promise.all([one.open(TWO), other.open(TWO)])
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')))
  await expect(one.edit([], { region: [REGION] })).rejects.toMatchObject({ code: 'notLoaded' })
  expect((await other.ask('tell', [[0]]))?.circles).toBe(2)
  vi.stubGlobal('fetch', fetchHere)
  expect((await one.edit([], { region: [REGION] })).counts.circles).toBe(2)
  expect(ThreadHere.running.size).toBe(1)
  painter.dispose()
})

describe('a thread that crashes', () => {
  async function begin() {
    vi.stubGlobal('Worker', CrashingThread)
    crashesAt = undefined
    started = 0
    const told: Error[] = []
    const marked: (number | undefined)[] = []
    const painter = new Painter()
    const show = () => {
      scene.setLayers(layers)
      scene.look(request, STYLE)
      scene.mark(1, undefined)
    }
    const scene = painter.add({
      ...listener([]),
      reopened: () => show(),
      changed: (_, picture) => picture && marked.push(picture.marks.selected?.id),
      marked: ({ selected }) => marked.push(selected?.id),
      failed: (failure) => told.push(failure),
    })
    await scene.open(TWO)
    show()
    await quiet()
    return { painter, scene, told, marked }
  }

  it('is replaced by one with the circles, the viewport, the layers and the highlights', async () => {
    const { painter, scene, told, marked } = await begin()
    // Near circles make the edges of a new picture thinner, but not of this one.
    const near = Array.from({ length: 9 }, (_, k) => ({ kind: 'insert', circle: [3 + k / 9, 4, 0] }) as const)
    await scene.edit(near)
    const widths = async () => (await scene.ask('svg', [FRAME, STYLE, []]))?.elements.match(/stroke-width="[^"]*"/g)
    const before = await widths()
    crashesAt = 'tell'
    expect(await scene.ask('tell', [[0]])).toBeUndefined()
    expect(await widths()).toEqual(before)
    expect([...(await scene.edit([{ kind: 'insert', circle: [3, 9, 1] }])).inserted]).toEqual([11])
    expect([started, told.length, marked]).toEqual([2, 1, [1, 1, 1, 1]])
    const drawn = await scene.ask('svg', [FRAME, STYLE, []])
    expect(drawn).toMatchObject({ elements: expect.stringContaining('<'), found: { hull: expect.anything() } })
    painter.dispose()
    vi.stubGlobal('Worker', ThreadHere)
  })

  it.each(['open', 'layers', 'look', 'mark'] as const)(
    'twice at %s is replaced once, and again at the next edit',
    async (name) => {
      const { painter, scene, told } = await begin()
      crashesAt = name
      if (name === 'open') scene.open(TWO).catch(() => {})
      if (name === 'layers') scene.setLayers(layers)
      if (name === 'look') scene.look(request, STYLE)
      if (name === 'mark') scene.mark(0, undefined)
      await quiet()
      expect([started, told.length, ThreadHere.running.size]).toEqual([2, 2, 0])
      expect(told.every((failure) => failure instanceof Failure)).toBe(true)
      crashesAt = undefined
      expect([...(await scene.edit([{ kind: 'insert', circle: [3, 9, 1] }])).inserted]).toEqual([2])
      expect(started).toBe(3)
      painter.dispose()
      vi.stubGlobal('Worker', ThreadHere)
    },
  )

  it.each([
    ['cannot start', () => {}],
    ['crashes at its start', CrashingThread],
  ])('where it %s the opening alone says so, and the next one tries again', async (_, Thread) => {
    crashesAt = 'start'
    vi.stubGlobal('Worker', Thread)
    const failures: unknown[] = []
    const scene = new Painter().add(listener(failures))
    await expect(scene.open(TWO)).rejects.toThrow(Failure)
    expect(failures).toEqual([])
    vi.stubGlobal('Worker', ThreadHere)
    expect((await scene.open(TWO)).counts.circles).toBe(2)
  })
})

it('a long computation is canceled, and another one goes on', async () => {
  const painter = new Painter()
  const scene = painter.add(listener([]))
  const many = Float64Array.from({ length: 1500 }, (_, k) => (k % 3 === 2 ? 0.1 : ((k * 7919) % 997) / 9))
  await scene.open(many)
  const canceled = new AbortController()
  const first = scene.ask('compute', [{ method: 'touching-disc', candidates: 'all-pairs' }], canceled.signal)
  const second = scene.ask('compute', [{}])
  canceled.abort()
  expect(await first).toBeUndefined()
  expect(await second).toMatchObject({ certificate: { certified: true } })
  await scene.edit([{ kind: 'remove', id: 0 }])
  painter.dispose()
  await quiet()
  expect(ThreadHere.running.size).toBe(0)
})

it('an edit that is canceled is not made, and the next one is', async () => {
  const scene = new Painter().add(listener([]))
  await scene.open(TWO)
  expect(scene.cancel()).toBe(false)
  const edited = scene.edit([{ kind: 'remove', id: 0 }], { region: [REGION] })
  expect(scene.cancel()).toBe(true)
  await expect(edited).rejects.toThrow(Superseded)
  expect([...scene.circles.circles()]).toEqual([...TWO])
  expect(await scene.ask('tell', [[0]])).toMatchObject({ circles: 2 })
  expect([...(await scene.edit([{ kind: 'insert', circle: [4, 7, 1] }])).inserted]).toEqual([2])
  expect(scene.cancel()).toBe(false)
})

it('an edit of circles whose replacement failed is for none, and the next one is made', async () => {
  const painter = new Painter()
  const scene = painter.add(listener([]))
  await scene.open(TWO)
  const replaced = WRONG.reopen(scene)
  const edited = scene.edit([{ kind: 'insert', circle: [4, 7, 1] }])
  await expect(replaced).rejects.toMatchObject({ code: 'internal' })
  await expect(edited).rejects.toThrow(Superseded)
  expect([...(await scene.edit([{ kind: 'insert', circle: [4, 7, 1] }])).inserted]).toEqual([2])
  expect((await scene.ask('tell', [[0]]))?.cells.get(0)).toMatchObject({ x: 0, y: 0, r: 1 })
  painter.dispose()
})

it('the highlights of a scene that is closed are not told any more', async () => {
  const painter = new Painter()
  const marked = vi.fn()
  const scene = painter.add({ ...listener([]), marked })
  await scene.open(TWO)
  scene.mark(0, undefined)
  scene.close()
  await quiet()
  expect(marked).not.toHaveBeenCalled()
  painter.dispose()
})

describe('a computation', () => {
  const computations = {
    compute: (one: SceneClient) => one.ask('compute', [{}]),
    trace: (one: SceneClient) => one.ask('trace', [{}]),
    fit: QUESTIONS.fit,
  }
  it.each(['compute', 'trace', 'fit'] as const)('%s whose thread crashes or cannot start says so', async (name) => {
    const ask = computations[name]
    vi.stubGlobal('Worker', CrashingThread)
    crashesAt = name as never
    const failures: unknown[] = []
    const painter = new Painter()
    const scene = painter.add(listener(failures))
    await scene.open(TWO)
    expect(await ask(scene)).toBeUndefined()
    expect(failures).toEqual([expect.any(Failure)])
    vi.stubGlobal('Worker', () => {})
    expect(await ask(scene)).toBeUndefined()
    expect(failures).toEqual([expect.any(Failure), expect.any(Failure)])
    vi.stubGlobal('Worker', ThreadHere)
    expect(await ask(scene)).toBeDefined()
    expect(ThreadHere.running.size).toBe(name === 'fit' ? 2 : 1)
    // The view that ends its own computation needs no reason.
    const closed = ask(scene)
    painter.dispose()
    expect(await closed).toBeUndefined()
    expect([failures.length, ThreadHere.running.size]).toEqual([2, 0])
  })

  it('whose options cannot be sent leaves no thread', async () => {
    const painter = new Painter()
    const scene = painter.add(listener([]))
    await scene.open(TWO)
    await scene.ask('compute', [{ progress: () => true }]).catch(() => {})
    expect(ThreadHere.running.size).toBe(1)
    painter.dispose()
  })

  it('is no sign that the painting thread works', async () => {
    const failures: Error[] = []
    const painter = new Painter()
    const scene = painter.add({ ...listener([]), failed: (failure) => failures.push(failure) })
    await scene.open(TWO)
    crash()
    expect(await scene.ask('compute', [{}])).toBeDefined()
    crash()
    expect([failures.length, ThreadHere.running.size]).toEqual([2, 0])
    painter.dispose()
  })

  it('has the images of circles that repeat, and a trace has the circles', async () => {
    const { library } = await import('./library.ts')
    const painter = new Painter()
    const scene = painter.add(listener([]))
    const lattice = { a: [12, 0], b: [0, 9] } as const
    const circles = Float64Array.of(1, 1, 1, 6, 4, 2, 10, 2, 1.5)
    const { diagram } = library.computePeriodic(circles, lattice)
    await scene.open(circles, { lattice })
    const { counts } = library.compute(diagram.circles).stats
    expect(await scene.ask('compute', [{}])).toMatchObject({ stats: { counts }, certificate: { certified: true } })
    expect(await scene.ask('trace', [{}])).toMatchObject({ circles, ids: Int32Array.of(0, 1, 2) })
    await scene.edit([], { lattice: null })
    const plane = library.compute(circles).stats
    expect(await scene.ask('compute', [{}])).toMatchObject({ stats: { counts: plane.counts } })
    painter.dispose()
  })
})

it('where no thread follows one that crashes, the views are told', async () => {
  const failures: Error[] = []
  const painter = new Painter()
  const scene = painter.add({ ...listener([]), failed: (failure) => failures.push(failure) })
  await scene.open(TWO)
  vi.stubGlobal('Worker', () => {})
  expect(crash).not.toThrow()
  expect(failures).toEqual([expect.any(Failure)])
  vi.stubGlobal('Worker', ThreadHere)
  expect([...(await scene.edit([{ kind: 'insert', circle: [3, 9, 1] }])).inserted]).toEqual([2])
  painter.dispose()
})

it('a thread whose file cannot be loaded is told in the language of the view', async () => {
  const failures: Error[] = []
  const painter = new Painter()
  const scene = painter.add({ ...listener([]), failed: (failure) => failures.push(failure) })
  await scene.open(TWO)
  for (const thread of ThreadHere.running) thread.onerror?.({ message: undefined as never })
  expect((failures[0] as Failure).say({ ...ENGLISH_REFUSALS, noThread: 'DATEI' })).toContain('DATEI')
  painter.dispose()
})

it('threads that end before they have begun leave one copy of their text', async () => {
  /** A thread of a page that may not load the file as a worker. */
  class ThreadOfText extends ThreadHere {
    constructor(url: URL | string) {
      if (typeof url !== 'string') throw new DOMException('another origin', 'SecurityError')
      super(new URL('/web/view/painter/start-thread.ts', location.href))
    }
    addEventListener() {}
  }
  const texts = new Set<string>()
  vi.spyOn(URL, 'createObjectURL').mockImplementation(() => {
    texts.add(`blob:${texts.size}`)
    return `blob:${texts.size - 1}`
  })
  vi.spyOn(URL, 'revokeObjectURL').mockImplementation((url) => texts.delete(url))
  vi.stubGlobal('Worker', ThreadOfText)
  const painter = new Painter()
  const scene = painter.add(listener([]))
  await scene.open(TWO)
  for (let k = 0; k < 3; k++) {
    const canceled = new AbortController()
    const computed = scene.ask('compute', [{}], canceled.signal)
    canceled.abort()
    expect(await computed).toBeUndefined()
  }
  expect([texts.size, ThreadHere.running.size]).toEqual([1, 1])
  vi.restoreAllMocks()
  vi.stubGlobal('Worker', ThreadHere)
  painter.dispose()
})
