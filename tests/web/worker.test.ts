// SPDX-License-Identifier: GPL-3.0-or-later
// The client of a worker, with a thread that the test controls message by message. tests/wasm/worker.test.mjs uses real
// threads.
import { readFileSync } from 'node:fs'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { CircleVoronoiError, Diagram } from '../../web/lib/index.ts'
import type { RegionModule } from '../../web/lib/regions/region.ts'
import { loadRegions, Region } from '../../web/lib/regions.ts'
import type { ThreadEvents } from '../../web/lib/threads/thread.ts'
import type { ComputeRequest, FitRequest, Reply, Request, Start } from '../../web/lib/threads/worker-messages.ts'
import { type CircleVoronoiWorker, createWorker } from '../../web/lib/worker.ts'
import { useThreads } from './fake-threads.ts'
import { library } from './library.ts'
import { box } from './shapes.ts'

const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 4, 9, 3)
const WASM = readFileSync(new URL('../../web/lib/generated/circle-voronoi.wasm', import.meta.url))

class FakeThread {
  readonly posted: (Start | Request)[] = []
  readonly transferred: ArrayBuffer[] = []
  isKeptAlive: boolean | undefined
  isTerminated = false
  readonly #events: ThreadEvents

  constructor(events: ThreadEvents) {
    this.#events = events
  }

  post(message: Start | Request, transfer: ArrayBuffer[] = []): void {
    this.posted.push(message)
    this.transferred.push(...transfer)
  }

  keepAlive(isNeeded: boolean): void {
    this.isKeptAlive = isNeeded
  }

  terminate(): void {
    this.isTerminated = true
  }

  get requests(): Request[] {
    return this.posted.filter((message): message is Request => !('module' in message))
  }

  say(reply: Reply): void {
    this.#events.onReply(reply)
  }

  /** Answers the last request like a real thread. */
  answer(): void {
    const { circles, options } = this.requests.at(-1) as ComputeRequest
    this.say({ diagram: library.compute(circles, options) })
  }

  breakDown(cause: unknown): void {
    this.#events.onFailure(cause)
  }
}

vi.mock('../../web/lib/threads/thread.ts', () => import('./fake-threads.ts'))
const threads: FakeThread[] = []
let failure: Error | undefined

let worker: CircleVoronoiWorker
beforeEach(() => {
  useThreads((events) => {
    if (failure !== undefined) throw failure
    const thread = new FakeThread(events)
    threads.push(thread)
    return thread
  })
  worker = createWorker({ wasm: WASM })
})
afterEach(() => {
  worker.dispose()
  threads.length = 0
  failure = undefined
  vi.unstubAllGlobals()
})

/** Resolves once the client has sent this many requests to the thread. */
async function asked(count: number, thread = 0): Promise<FakeThread> {
  await vi.waitFor(() => expect(threads[thread]?.requests).toHaveLength(count), { timeout: 40_000 })
  return threads[thread] as FakeThread
}

/** The reason of a rejection, if the promise settles as soon as others. */
async function reasonOf(promise: Promise<unknown>): Promise<unknown> {
  return promise.then(
    () => expect.unreachable('It was fulfilled.'),
    (reason) => reason,
  )
}

it('makes no editor once it was disposed of, before or while its module comes', async () => {
  const before = worker.edit(THREE)
  worker.dispose()
  const promises = [before, worker.edit(THREE), worker.compute(THREE)]
  for (const reason of await Promise.all(promises.map(reasonOf))) {
    expect(reason).toMatchObject({ name: 'AbortError', message: 'The worker has been disposed of.' })
  }
  expect(threads).toHaveLength(0)
})

describe('a worker', () => {
  it('starts one thread with the first computation, and keeps Node alive while there is something to do', async () => {
    expect(threads).toHaveLength(0)
    const first = worker.compute(THREE, { method: 'flip', progress: () => {} })
    const thread = await asked(1)
    expect(thread.posted[0]).toEqual({ module: expect.any(WebAssembly.Module) })
    expect(thread.requests[0]).toEqual({ circles: THREE, options: { method: 'flip' }, tellsProgress: true })
    expect(thread.transferred).toEqual([(thread.requests[0] as ComputeRequest).circles.buffer])
    expect(thread.isKeptAlive).toBe(true)
    thread.answer()
    const diagram = await first
    expect(diagram).toBeInstanceOf(Diagram)
    expect(diagram.find(9, 0)).toBe(1)
    expect(thread.isKeptAlive).toBe(false)
    const second = worker.compute([])
    expect((await asked(2)).requests[1]).toMatchObject({ tellsProgress: false })
    expect(thread.isKeptAlive).toBe(true)
    thread.answer()
    expect((await second).circles).toHaveLength(0)
    expect(threads).toHaveLength(1)
    expect(thread.posted).toHaveLength(3)
  })

  it('computes one after the other, with a module that it compiles once', async () => {
    const compile = vi.spyOn(WebAssembly, 'compile')
    const promises = [THREE, [], [[1, 2, 3]]].map((circles) => worker.compute(circles))
    const thread = await asked(1)
    thread.answer()
    await asked(2)
    expect(thread.isKeptAlive).toBe(true)
    thread.answer()
    ;(await asked(3)).answer()
    const sizes = (await Promise.all(promises)).map(({ circles }) => circles.length)
    expect(sizes).toEqual([9, 0, 3])
    expect(compile).toHaveBeenCalledOnce()
    compile.mockRestore()
  })

  it('tells progress, to who asked for it alone', async () => {
    const told: unknown[] = []
    const first = worker.compute(THREE, { progress: (...args) => told.push(args) })
    const second = worker.compute(THREE)
    const thread = await asked(1)
    thread.say({ progress: ['touch', 0.5] })
    thread.answer()
    await first
    await asked(2)
    thread.say({ progress: ['flip', 0] })
    thread.answer()
    await second
    expect(told).toEqual([['touch', 0.5]])
  })

  it('rejects with the error of the thread, and goes on', async () => {
    const first = worker.compute(THREE)
    const thread = await asked(1)
    thread.say({ error: { code: 'nonFinite', circle: 2, message: 'No.' } })
    const error = await reasonOf(first)
    expect(error).toBeInstanceOf(CircleVoronoiError)
    expect(error).toMatchObject({ code: 'nonFinite', circle: 2, message: 'No.' })
    const second = worker.compute(THREE)
    ;(await asked(2)).answer()
    await second
    expect(thread.isTerminated).toBe(false)
  })

  it('says what makes the thread break down, and has another the next time', async () => {
    const first = worker.compute(THREE)
    const second = worker.compute([])
    ;(await asked(1)).breakDown(new Error('out of memory.'))
    expect(await reasonOf(first)).toMatchObject({ code: 'internal', message: 'The worker failed: out of memory.' })
    expect(threads[0]?.isTerminated).toBe(true)
    const other = await asked(1, 1)
    expect(other.posted).toHaveLength(2)
    other.answer()
    expect((await second).circles).toHaveLength(0)
    // Late messages of the first thread are ignored.
    threads[0]?.answer()
    threads[0]?.breakDown('again')
    expect(other.isTerminated).toBe(false)
  })

  it('bears a thread that breaks down while it is idle, or talks without being asked', async () => {
    const progress = vi.fn()
    const first = worker.compute(THREE, { progress })
    const thread = await asked(1)
    thread.answer()
    await first
    thread.answer()
    thread.say({ progress: ['touch', 1] })
    expect(progress).not.toHaveBeenCalled()
    thread.breakDown('idle')
    expect(thread.isTerminated).toBe(true)
    const second = worker.compute(THREE)
    ;(await asked(1, 1)).answer()
    await second
  })

  it('that cannot start says so, and tries again', async () => {
    failure = new Error('there are none here')
    expect(await reasonOf(worker.compute(THREE))).toMatchObject({
      code: 'internal',
      message: 'The worker failed: there are none here.',
      cause: failure,
    })
    failure = undefined
    const again = worker.compute(THREE)
    ;(await asked(1)).answer()
    await again
  })

  it('tries again to load what it could not', async () => {
    let isOnline = false
    vi.stubGlobal('fetch', async () => {
      if (!isOnline) throw new Error('offline')
      return new Response(WASM, { headers: { 'Content-Type': 'application/wasm' } })
    })
    const other = createWorker({ wasm: 'https://example.org/circle-voronoi.wasm' })
    const failed = [other.compute(THREE), other.compute(THREE)]
    for (const promise of failed) {
      expect(await reasonOf(promise)).toMatchObject({ code: 'notLoaded', message: expect.stringContaining('offline') })
    }
    expect(threads).toHaveLength(0)
    isOnline = true
    const again = other.compute(THREE)
    ;(await asked(1)).answer()
    expect((await again).vertices).toHaveLength(3)
    other.dispose()
  })
})

describe('a fit in a worker', async () => {
  const bytes = readFileSync(new URL('../../web/lib/generated/circle-voronoi-regions.wasm', import.meta.url))
  const { region, fitAreas } = await loadRegions({ wasm: bytes })
  const square = region([box(0, 0, 4, 4)])
  const SITES = [
    [1, 1],
    [3, 2],
  ] as const

  it('gets all that a fit needs, tells its steps, and gives what the library gives', async () => {
    const here = fitAreas(SITES, [4, 12], { region: square })
    const told: unknown[] = []
    const promise = worker.fitAreas(SITES, [4, 12], { region: square, onStep: (step) => told.push(step) })
    const thread = await asked(1)
    const { fit, ...request } = thread.requests[0] as FitRequest
    expect(fit).toEqual({
      sites: Float64Array.of(1, 1, 0, 3, 2, 0),
      areas: Float64Array.of(4, 12),
      shares: false,
      tolerance: 1e-9,
      maxSteps: 500,
      relax: 0,
    })
    const { points, ringOffsets, polygonOffsets } = square
    expect(request).toEqual({
      region: { points, ringOffsets, polygonOffsets },
      wasm: expect.any(WebAssembly.Module),
      tellsProgress: true,
    })
    expect(thread.transferred).toEqual([fit.sites.buffer, fit.areas.buffer])
    const step = { steps: 1, error: 0.5, weights: Float64Array.of(0, 1) }
    thread.say({ step })
    thread.say({ fit: structuredClone(here) })
    const there = await promise
    expect(told).toEqual([step])
    expect(there.diagram).toBeInstanceOf(Diagram)
    expect(there).toEqual(here)
    const next = worker.compute(THREE)
    ;(await asked(2)).answer()
    expect((await next).circles).toHaveLength(9)
    expect(threads).toHaveLength(1)
  })

  it('is canceled by its signal, and by what onStep throws', async () => {
    const controller = new AbortController()
    const { signal } = controller
    const first = worker.fitAreas(SITES, [4, 12], { region: square, signal, onStep: () => controller.abort('enough') })
    const second = worker.fitAreas(SITES, [4, 12], {
      region: square,
      onStep() {
        throw new RangeError('mine')
      },
    })
    const step = { steps: 0, error: 1, weights: new Float64Array(2) }
    ;(await asked(1)).say({ step })
    expect(await reasonOf(first)).toBe('enough')
    ;(await asked(1, 1)).say({ step })
    expect(await reasonOf(second)).toEqual(new RangeError('mine'))
    expect(threads.map(({ isTerminated }) => isTerminated)).toEqual([true, true])
    expect(await reasonOf(worker.fitAreas(SITES, [4, 12], { region: square, signal }))).toBe('enough')
  })

  it('that does not converge has the weights that it reached', async () => {
    const fit = worker.fitAreas(SITES, [4, 12], { region: square })
    const error = { code: 'notConverged', circle: undefined, message: 'No.', weights: Float64Array.of(0, 1) } as const
    const thread = await asked(1)
    expect(thread.requests[0]).toMatchObject({ tellsProgress: false })
    thread.say({ error })
    expect(await reasonOf(fit)).toMatchObject({ code: 'notConverged', message: 'No.', weights: error.weights })
  })

  it('is refused before it goes there', async () => {
    const problem = (options: object) => reasonOf(worker.fitAreas(SITES, [4, 12], options as { region: Region }))
    expect(await problem({})).toMatchObject({ code: 'badOption', message: expect.stringContaining('needs a region') })
    expect(await problem({ region: square, signal: 1 })).toMatchObject({ code: 'badOption' })
    expect(await problem({ region: square, onStep: 1 })).toMatchObject({ code: 'badOption' })
    expect(await problem({ region: square, progress: () => {} })).toMatchObject({
      message: expect.stringContaining('There is no option progress of fitAreas'),
    })
    const foreign = new Region(square, {} as RegionModule)
    expect(await problem({ region: foreign })).toMatchObject({ message: expect.stringContaining('another copy') })
    expect(threads).toHaveLength(0)
  })
})

describe('canceling', () => {
  it('what waits does not end what runs, from whose progress it is done', async () => {
    const controller = new AbortController()
    const running = worker.compute(THREE, { progress: () => controller.abort('not needed') })
    const waiting = worker.compute([], { signal: controller.signal })
    const last = worker.compute([[1, 2, 3]])
    const thread = await asked(1)
    thread.say({ progress: ['touch', 0.5] })
    expect(await reasonOf(waiting)).toBe('not needed')
    expect(thread.isTerminated).toBe(false)
    expect(thread.requests).toHaveLength(1)
    thread.answer()
    expect((await running).circles).toHaveLength(9)
    ;(await asked(2)).answer()
    expect((await last).circles).toHaveLength(3)
    expect(threads).toHaveLength(1)
  })

  it('what runs ends its thread, and what waits has another', async () => {
    const controller = new AbortController()
    const running = worker.compute(THREE, { signal: controller.signal })
    const waiting = worker.compute([])
    const thread = await asked(1)
    controller.abort('enough')
    expect(await reasonOf(running)).toBe('enough')
    expect(thread.isTerminated).toBe(true)
    ;(await asked(1, 1)).answer()
    await waiting
  })

  it('by what progress throws does the same', async () => {
    const mine = new RangeError('mine')
    const running = worker.compute(THREE, {
      progress() {
        throw mine
      },
    })
    const thread = await asked(1)
    thread.say({ progress: ['triangulate', 0] })
    expect(await reasonOf(running)).toBe(mine)
    expect(thread.isTerminated).toBe(true)
  })

  it('before the thread has it spares the thread', async () => {
    const controller = new AbortController()
    const promise = worker.compute(THREE, { signal: controller.signal })
    controller.abort('at once')
    expect(await reasonOf(promise)).toBe('at once')
    expect(await reasonOf(worker.compute(THREE, { signal: controller.signal }))).toBe('at once')
    const other = worker.compute([])
    ;(await asked(1)).answer()
    await other
    expect(threads).toHaveLength(1)
  })

  it('what is done has no effect', async () => {
    const controller = new AbortController()
    const { signal } = controller
    const [add, remove] = [vi.spyOn(signal, 'addEventListener'), vi.spyOn(signal, 'removeEventListener')]
    const done = worker.compute(THREE, { signal })
    ;(await asked(1)).answer()
    await done
    expect(add).toHaveBeenCalledOnce()
    expect(remove.mock.calls).toEqual(add.mock.calls)
    const running = worker.compute([])
    const thread = await asked(2)
    controller.abort()
    expect(thread.isTerminated).toBe(false)
    thread.answer()
    await running
  })

  it('takes a signal, and nothing else for one', async () => {
    const signal = {} as AbortSignal
    expect(await reasonOf(worker.compute(THREE, { signal }))).toMatchObject({ code: 'badOption' })
  })
})

describe('disposing of a worker', () => {
  it('cancels what runs and what waits, begins nothing, and ends the thread', async () => {
    const promises = [THREE, [], []].map((circles) => worker.compute(circles))
    const thread = await asked(1)
    worker.dispose()
    for (const promise of [...promises, worker.compute(THREE)]) {
      expect(await reasonOf(promise)).toMatchObject({
        name: 'AbortError',
        message: 'The worker has been disposed of.',
      })
    }
    expect(thread.isTerminated).toBe(true)
    expect(threads).toHaveLength(1)
    expect(thread.requests).toHaveLength(1)
  })

  it('is what `using` does', async () => {
    const promise = worker.compute(THREE)
    const thread = await asked(1)
    ;(worker as unknown as Record<symbol, () => void>)[Symbol.dispose]?.()
    expect(await reasonOf(promise)).toBeInstanceOf(DOMException)
    expect(thread.isTerminated).toBe(true)
  })

  it('ends its editors', async () => {
    const editing = worker.edit(THREE)
    await vi.waitFor(() => expect(threads[0]?.posted).toHaveLength(2), { timeout: 40_000 })
    const [thread] = threads as [FakeThread]
    thread.say({ results: [{ value: undefined }] })
    const size = (await editing).size()
    worker.dispose()
    expect(thread.isTerminated).toBe(true)
    expect(await reasonOf(size)).toMatchObject({ message: 'The editor has been disposed of.' })
  })

  it('ends an idle thread, too', async () => {
    const promise = worker.compute(THREE)
    const thread = await asked(1)
    thread.answer()
    await promise
    worker.dispose()
    expect(thread.isTerminated).toBe(true)
  })
})
