// SPDX-License-Identifier: GPL-3.0-or-later
// A worker and its editors, with threads that run here, asked at random, canceled and broken down: each promise has the
// result of the library, or the reason why there is none.
// @vitest-environment happy-dom
import fc from 'fast-check'
import { afterAll, describe, expect, it, vi } from 'vitest'
import {
  type Circles,
  CircleVoronoiError,
  type DiagramEditor,
  loadCircleVoronoi,
  type Options,
} from '../../web/lib/index.ts'
import { loadMetrics, type MetricOptions } from '../../web/lib/metrics.ts'
import type { RegionModule } from '../../web/lib/regions/region.ts'
import { loadRegions, Region } from '../../web/lib/regions.ts'
import { type AsyncDiagramEditor, type CircleVoronoiWorker, createWorker } from '../../web/lib/worker.ts'
import { action as actionOf, editOf } from './arbitrary-circles.ts'
import { contentOf } from './edit-script.ts'
import { ThreadHere } from './page-threads.ts'
import { fetchHere } from './whole-page.ts'

vi.stubGlobal('fetch', fetchHere)
vi.stubGlobal('Worker', ThreadHere)
afterAll(() => vi.unstubAllGlobals())
const library = await loadCircleVoronoi()
const metrics = await loadMetrics({ library })
const regions = await loadRegions()
const region = regions.region([[0, 1, 2].map((k) => [k === 0 ? 0 : 20, k < 2 ? 0 : 20] as const)])
const THREE = [
  [0, 0, 1],
  [10, 0, 2],
  [4, 9, 3],
] as const
const queued = queueMicrotask
const LATTICE = { a: [30, 0], b: [4, 30] } as const

const circle = fc.record({
  x: fc.integer({ min: 0, max: 20 }),
  y: fc.integer({ min: 0, max: 20 }),
  r: fc.constantFrom(0, 0, 1, 2, -1),
})
const circles = fc.array(circle, { maxLength: 8 })
const signal = fc.option(fc.nat(2), { nil: undefined })
const options: fc.Arbitrary<Options> = fc.record(
  { method: fc.constantFrom('auto', 'flip', 'touching-disc', 'magic' as 'auto'), weights: fc.boolean() },
  { requiredKeys: [] },
)
const metric = fc.constantFrom(undefined, 'circles', 'centers', 'power', 'magic' as 'power')
const progress = fc.constantFrom(undefined, undefined, 'told' as const, 'throws' as const)
const action = fc.oneof(
  actionOf('compute', { circles, options, metric, signal, progress }),
  actionOf('periodic', { circles, options, signal, progress }),
  actionOf('fit', { circles, signal, progress }),
  actionOf('fitInBox', { circles, signal, progress }),
  actionOf('abort', { which: fc.nat(2) }),
  actionOf('break'),
  actionOf('wait', { turns: fc.nat(40) }),
)
type Action = typeof action extends fc.Arbitrary<infer Value> ? Value : never
type Request = Extract<Action, { circles: unknown }>

/** An error of a listener. */
const MINE = new RangeError('mine')

/** The result of a request as plain data, or the code and the circle of its error. */
async function outcomeOf(act: () => unknown): Promise<unknown> {
  try {
    const value = await act()
    expect(value).not.toBeInstanceOf(Error)
    return JSON.parse(JSON.stringify(value, (key, part) => (key === 'stats' || key === 'seconds' ? undefined : part)))
  } catch (error) {
    return error instanceof CircleVoronoiError
      ? { code: error.code, circle: error.circle, weights: error.weights }
      : error
  }
}

type Library = Pick<CircleVoronoiWorker, 'compute' | 'computePeriodic' | 'fitAreas'>

function ask(from: Library, request: Request, more: object): unknown {
  const { kind, circles } = request
  if (kind === 'compute') {
    const options: MetricOptions = { ...request.options, metric: request.metric }
    return from.compute(circles, { ...options, ...more })
  }
  if (kind === 'periodic') return from.computePeriodic(circles, LATTICE, { ...request.options, ...more })
  const sites = circles.map(({ x, y }) => [x, y] as const)
  const areas = sites.map((_, k) => k + 1)
  const fitting = { shares: true, tolerance: 1e-6, maxSteps: 50, ...more }
  if (kind === 'fit') return from.fitAreas(sites, areas, { region, ...fitting })
  return from.fitAreas(sites, areas, { lattice: LATTICE, ...fitting })
}

const here = { ...library, ...metrics, fitAreas: regions.fitAreas } as unknown as Library
const turn = () => new Promise((resolve) => setImmediate(resolve))

async function play(script: readonly Action[]): Promise<void> {
  ThreadHere.endAll()
  const worker = createWorker()
  const signals = [0, 1, 2].map(() => new AbortController())
  const asked: { readonly request: Request; readonly answer: Promise<unknown>; readonly told: unknown[] }[] = []
  let broken = 0
  for (const action of script) {
    if (action.kind === 'abort') signals[action.which]?.abort(`signal ${action.which}`)
    else if (action.kind === 'wait') for (let k = 0; k < action.turns; k++) await turn()
    else if (action.kind === 'break') {
      broken += ThreadHere.running.size
      for (const thread of [...ThreadHere.running]) thread.onerror?.({ message: 'it broke.' })
    } else if ('circles' in action) {
      const told: unknown[] = []
      const listen = (...how: unknown[]) => {
        told.push(how)
        if (action.progress === 'throws') throw MINE
      }
      const listener = action.kind === 'fit' || action.kind === 'fitInBox' ? 'onStep' : 'progress'
      const more = {
        ...(action.progress && { [listener]: listen }),
        ...(action.signal !== undefined && { signal: signals[action.signal]?.signal }),
      }
      asked.push({ request: action, answer: outcomeOf(() => ask(worker, action, more)), told })
    }
  }
  for (const { request, answer, told } of asked) {
    const there = await answer
    const expected = await outcomeOf(() => ask(here, request, {}))
    const isAborted = request.signal !== undefined && there === `signal ${request.signal}`
    const isBroken = broken > 0 && (there as { code?: string }).code === 'internal'
    const isStopped = request.progress === 'throws' && there === MINE && told.length === 1
    if (!isAborted && !isBroken && !isStopped) expect(there).toEqual(expected)
    if (request.progress === undefined) expect(told).toEqual([])
  }
  const last = worker.compute([[1, 2, 3]])
  await expect(last).resolves.toMatchObject({ circles: Float64Array.of(1, 2, 3) })
  expect(ThreadHere.running.size).toBe(1)
  const pending = outcomeOf(() => worker.compute([]))
  worker.dispose()
  expect(await pending).toMatchObject({ name: 'AbortError' })
  expect(await outcomeOf(() => worker.compute([]))).toMatchObject({ name: 'AbortError' })
  expect(ThreadHere.running.size).toBe(0)
}

it('each request of a worker has the result of the library, or the reason why there is none', async () => {
  await fc.assert(fc.asyncProperty(fc.array(action, { minLength: 1, maxLength: 10 }), play), { numRuns: 60 })
}, 300_000)

const id = fc.nat(9)
const edit = editOf(circle)
const call = fc.oneof(
  { weight: 4, arbitrary: fc.tuple(fc.constant('edit' as const), edit) },
  fc.tuple(fc.constant('apply' as const), fc.array(edit, { maxLength: 3 })),
  fc.tuple(fc.constantFrom('circle' as const, 'isHidden' as const), id),
  fc.tuple(fc.constantFrom('size' as const, 'ids' as const, 'certificate' as const)),
  fc.tuple(fc.constant('wait' as const), fc.nat(20)),
)
type Call = typeof call extends fc.Arbitrary<infer Value> ? Value : never

function callOn(editor: DiagramEditor | AsyncDiagramEditor, [method, what]: Call): unknown {
  if (method === 'edit') {
    const { kind } = what
    if (kind === 'insert') return editor.insert(what.circle)
    return kind === 'remove' ? editor.remove(what.id) : editor.replace(what.id, what.circle)
  }
  if (method === 'apply') return editor.apply(what)
  if (method === 'circle' || method === 'isHidden') return editor[method](what)
  return method === 'wait' ? undefined : editor[method]()
}

/** The ids of a change, whose other parts depend on which edits were made as one; or any other answer. */
const partOf = (answer: unknown) => {
  const { inserted, removed } = Object(answer)
  return inserted === undefined ? answer : { inserted, removed }
}

async function playEditor(
  script: readonly Call[],
  start: Circles,
  end: 'dispose' | 'break' | undefined,
): Promise<void> {
  ThreadHere.endAll()
  const worker = createWorker()
  const [editor, local] = [await worker.edit(start), library.edit(start)]
  const diagram = await editor.snapshot()
  let changes = 0
  editor.onchange = (change) => {
    changes += 1
    diagram.apply(change)
  }
  const answers: (readonly [Call, Promise<unknown>, unknown])[] = []
  for (const call of script) {
    if (call[0] === 'wait') for (let k = 0; k < call[1]; k++) await turn()
    else answers.push([call, outcomeOf(() => callOn(editor, call)), await outcomeOf(() => callOn(local, call))])
  }
  if (end === 'dispose') editor.dispose()
  if (end === 'break') for (const thread of [...ThreadHere.running]) thread.onerror?.({ message: 'it broke' })
  const reason = end === 'dispose' ? { name: 'AbortError' } : { code: 'internal' }
  for (const [[method, what], answer, expected] of answers) {
    const there = await answer
    // Replacements of one circle that wait together are made as one.
    const isReplacement = method === 'edit' && what.kind === 'replace' && !('code' in (expected as object))
    const { name, code } = Object(there)
    const isEnded = end === 'dispose' ? name === 'AbortError' : end === 'break' && code === 'internal'
    if (!isEnded && !isReplacement) expect(partOf(there)).toEqual(partOf(expected))
  }
  if (end === undefined) {
    const snapshot = await editor.snapshot()
    for (const other of [diagram, local.snapshot()]) expect(contentOf(other)).toEqual(contentOf(snapshot))
    expect(changes).toBeLessThanOrEqual(script.length)
  } else {
    expect(await outcomeOf(() => editor.size())).toMatchObject(reason)
  }
  local.dispose()
  worker.dispose()
  expect(await outcomeOf(() => editor.size())).toMatchObject(end === 'break' ? reason : { name: 'AbortError' })
  expect(ThreadHere.running.size).toBe(0)
}

it('an editor of a worker makes the edits of the library, and tells each change once', async () => {
  const start = circles.map((list) => list.map(({ x, y, r }) => ({ x, y, r: Math.abs(r) })))
  const end = fc.constantFrom(undefined, undefined, 'dispose' as const, 'break' as const)
  await fc.assert(fc.asyncProperty(fc.array(call, { minLength: 1, maxLength: 14 }), start, end, playEditor), {
    numRuns: 60,
  })
}, 300_000)

describe('an editor', () => {
  it('makes the last of the replacements that wait, and all get its change', async () => {
    using worker = createWorker()
    const editor = await worker.edit(THREE)
    const changes: unknown[] = []
    editor.onchange = (change) => changes.push(change)
    const busy = editor.size()
    const drags = [1, 2, 3].map((x) => editor.replace(0, [x, 0, 1]))
    const other = editor.replace(1, [11, 0, 2])
    await busy
    const [first, ...others] = await Promise.all(drags)
    for (const change of others) expect(change).toBe(first)
    expect(await other).not.toBe(first)
    expect([changes.length, await editor.circle(0)]).toEqual([2, { x: 3, y: 0, r: 1 }])
    // A removal ends what may be replaced.
    const [drag, removal, again] = [
      editor.replace(0, [1, 0, 1]),
      editor.remove(0),
      outcomeOf(() => editor.replace(0, [2, 0, 1])),
    ]
    await Promise.all([drag, removal])
    expect(await again).toMatchObject({ code: 'unknownCircle', circle: 0 })
  })

  it('ends where it cannot begin, and takes ids and weights', async () => {
    using worker = createWorker()
    expect(await outcomeOf(() => worker.edit([[0, 0, -1]]))).toMatchObject({ code: 'negativeRadius', circle: 0 })
    expect(ThreadHere.running.size).toBe(0)
    const editor = await worker.edit(THREE, { ids: [2, 5, 7], nextId: 9, weights: true })
    expect([...(await editor.insert([5, 4, -1])).inserted]).toEqual([9])
    expect((await editor.snapshot()).weights).toBe(true)
  })

  it('answers an edit where a listener throws, which is an uncaught error', async () => {
    using worker = createWorker()
    const editor = await worker.edit(THREE)
    editor.onchange = () => {
      throw MINE
    }
    const later: (() => void)[] = []
    vi.stubGlobal('queueMicrotask', (act: () => void) => later.push(act))
    const change = await editor.remove(0)
    Object.assign(globalThis, { queueMicrotask: queued })
    expect([...change.removed]).toEqual([0])
    expect(later.map((act) => outcomeOf(act))).toHaveLength(1)
    expect(later[0]).toThrow(MINE)
  })
})

describe('a worker', () => {
  it('that cannot start, or whose module is not there, says so and tries again', async () => {
    using worker = createWorker()
    Object.assign(globalThis, { Worker: () => {} })
    expect(await outcomeOf(() => worker.compute(THREE))).toMatchObject({ code: 'internal' })
    Object.assign(globalThis, { Worker: ThreadHere })
    expect(await outcomeOf(() => worker.compute(THREE))).toMatchObject({ circles: expect.anything() })
    const fetched = vi.fn(async () => new Response(null, { status: 404 }))
    Object.assign(globalThis, { fetch: fetched })
    using other = createWorker({ wasm: 'https://example.org/circle-voronoi.wasm' })
    for (const name of ['compute', 'edit'] as const) {
      expect(await outcomeOf(() => other[name](THREE))).toMatchObject({ code: 'notLoaded' })
    }
    Object.assign(globalThis, { fetch: fetchHere })
    expect(await outcomeOf(() => other.compute(THREE))).toMatchObject({ circles: expect.anything() })
  })

  it('refuses a region of another copy of the library', async () => {
    using worker = createWorker()
    const foreign = new Region(region, {} as RegionModule)
    const refused = outcomeOf(() => worker.fitAreas([[5, 1]], [1], { region: foreign }))
    expect(await refused).toMatchObject({ code: 'badOption' })
  })
})
