// SPDX-License-Identifier: GPL-3.0-or-later
// Both ends of a thread: its start in Node and in a browser, and its answers.
import { readFileSync } from 'node:fs'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { answerRequests } from '../../web/lib/threads/answer-requests.ts'
import { startThread } from '../../web/lib/threads/thread.ts'
import type { ComputeRequest, EditorCalls, Reply, Request, Start } from '../../web/lib/threads/worker-messages.ts'
import { circleVoronoiOf } from '../../web/lib/wasm/library.ts'
import { compileCircleVoronoi } from '../../web/lib/wasm/load-options.ts'

const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 4, 9, 3)
/** A busy machine may take long to start a thread. */
const SOON = { timeout: 40_000 }
const PAGE = 'https://example.org/worker-thread.js'
const world = vi.hoisted(() => ({ file: '', text: '', newWorker: (): unknown => undefined }))

vi.mock('../../web/lib/threads/thread-file.ts', () => ({
  THREAD_NAME: 'the name',
  threadFile: () => world.text || new URL(world.file),
  newWorker: () => world.newWorker(),
}))

afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

function raise(error: Error): never {
  throw error
}

/** Creates a module that Node runs as a thread. */
function moduleOf(script: string): string {
  return `data:text/javascript,${encodeURIComponent(`
    import { parentPort, workerData } from 'node:worker_threads'
    ${script}`)}`
}

const request = (circles = THREE): ComputeRequest => ({
  circles: circles.slice() as ComputeRequest['circles'],
  options: {},
  tellsProgress: false,
})

describe('a thread in Node', () => {
  it('gets messages with the memory of their arrays, knows its name, and answers', async () => {
    world.file = moduleOf(`
      parentPort.on('message', ({ circles }) => parentPort.postMessage({ progress: [workerData, circles.length] }))`)
    const told: Reply[] = []
    const thread = startThread({
      onReply: (reply) => told.push(reply),
      onFailure: (cause) => expect.unreachable(String(cause)),
    })
    const message = request()
    thread.keepAlive(true)
    thread.post(message, [message.circles.buffer])
    expect(message.circles).toHaveLength(0)
    await vi.waitFor(() => expect(told).toEqual([{ progress: ['the name', 9] }]), SOON)
    thread.post(request())
    await vi.waitFor(() => expect(told).toHaveLength(2), SOON)
    thread.keepAlive(false)
    thread.terminate()
  })

  it('takes over no options of its process, some of which would break it', () => {
    const given: unknown[] = []
    class Worker extends EventTarget {
      readonly ref = () => given.push('ref')
      readonly unref = () => given.push('unref')
      readonly terminate = () => given.push('terminate')
      constructor(file: URL | string, options: unknown) {
        super()
        given.push(String(file), options)
      }
      on() {}
    }
    const builtin = vi.spyOn(process, 'getBuiltinModule').mockReturnValue({ Worker } as never)
    world.file = PAGE
    const thread = startThread({ onReply() {}, onFailure() {} })
    thread.keepAlive(true)
    thread.keepAlive(false)
    thread.terminate()
    world.text = 'the text'
    startThread({ onReply() {}, onFailure() {} })
    world.text = ''
    builtin.mockRestore()
    const options = { eval: false, execArgv: [], workerData: 'the name' }
    expect(given).toEqual([PAGE, options, 'ref', 'unref', 'terminate', 'the text', { ...options, eval: true }])
  })

  it('tells of its failure, and answers nothing', async () => {
    world.file = moduleOf(`throw new Error('broken')`)
    let failure: unknown
    const broken = startThread({
      onReply: () => expect.unreachable(),
      onFailure: (cause) => {
        failure = cause
      },
    })
    await vi.waitFor(() => expect(failure).toMatchObject({ message: 'broken' }), SOON)
    broken.terminate()
  })

  it('needs threads', () => {
    vi.stubGlobal('process', undefined)
    expect(() => startThread({ onReply() {}, onFailure() {} })).toThrow('there are none here')
    vi.stubGlobal('process', {})
    expect(() => startThread({ onReply() {}, onFailure() {} })).toThrow('there are none here')
  })
})

describe('a thread in a browser', () => {
  class FakeWorker extends EventTarget {
    static readonly made: FakeWorker[] = []
    onmessage: ((event: { data: unknown }) => void) | undefined
    onerror: ((event: { message?: string }) => void) | undefined
    readonly posted: unknown[] = []
    isTerminated = false
    readonly args: readonly unknown[]

    constructor(...args: readonly unknown[]) {
      super()
      this.args = args
      FakeWorker.made.push(this)
    }

    postMessage(...args: unknown[]): void {
      this.posted.push(args)
    }

    terminate(): void {
      this.isTerminated = true
    }
  }

  it('is a worker', () => {
    vi.stubGlobal('Worker', FakeWorker)
    const worker = new FakeWorker()
    world.newWorker = () => worker
    const told: unknown[] = []
    const thread = startThread({ onReply: (reply) => told.push(reply), onFailure: (cause) => told.push(cause) })
    const message = request()
    thread.post(message, [message.circles.buffer])
    thread.post(message)
    expect(worker.posted).toEqual([
      [message, [message.circles.buffer]],
      [message, []],
    ])
    worker.onmessage?.({ data: { progress: ['triangulate', 0] } })
    worker.onerror?.({ message: 'broken' })
    worker.onerror?.({})
    expect(told).toEqual([{ progress: ['triangulate', 0] }, 'broken', 'its file cannot be loaded'])
    thread.keepAlive(true)
    expect(worker.isTerminated).toBe(false)
    thread.terminate()
    expect(worker.isTerminated).toBe(true)
  })

  it('from another origin starts from a script that imports it', async () => {
    vi.stubGlobal('Worker', FakeWorker)
    world.file = PAGE
    world.newWorker = () => {
      throw new DOMException('another origin', 'SecurityError')
    }
    let script: Blob | undefined
    const create = vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => {
      script = blob as Blob
      return 'blob:here'
    })
    const revoke = vi.spyOn(URL, 'revokeObjectURL').mockImplementation(() => {})
    startThread({ onReply() {}, onFailure() {} })
    expect(create).toHaveBeenCalledOnce()
    expect(await script?.text()).toBe(`import "${PAGE}"`)
    expect(script?.type).toBe('text/javascript')
    const worker = FakeWorker.made.at(-1) as FakeWorker
    expect(worker.args).toEqual(['blob:here', { type: 'module', name: 'the name' }])
    expect(revoke).not.toHaveBeenCalled()
    worker.dispatchEvent(new Event('message'))
    worker.dispatchEvent(new Event('message'))
    expect(revoke.mock.calls).toEqual([['blob:here']])
  })

  it('in a page with Trusted Types has an address of the policy circle-voronoi, and Worker stays as it is', async () => {
    vi.stubGlobal('Worker', FakeWorker)
    const { startModuleWorker } = await import('../../web/lib/threads/module-worker.ts')
    const policies: string[] = []
    const create = vi.fn((name: string, rules: { createScriptURL(url: string): string }) => {
      policies.push(name)
      return { createScriptURL: (url: string) => `trusted ${rules.createScriptURL(url)}` }
    })
    const started = (make: () => unknown) =>
      startModuleWorker(make as () => Worker, () => '', 'x') as unknown as FakeWorker
    // A page that has no Trusted Types may get them later.
    expect(started(() => new Worker('a')).args).toEqual(['a'])
    vi.stubGlobal('trustedTypes', { createPolicy: create })
    for (let k = 0; k < 2; k++) {
      const { args } = started(() => new Worker(new URL(PAGE), { type: 'module' }))
      expect(args).toEqual([`trusted ${PAGE}`, { type: 'module' }])
      expect(globalThis.Worker).toBe(FakeWorker)
    }
    expect(() => started(() => raise(new Error('no')))).toThrow('no')
    expect(globalThis.Worker).toBe(FakeWorker)
    expect(policies).toEqual(['circle-voronoi'])
  })

  it('in a page that forbids the policy starts as without Trusted Types', async () => {
    vi.stubGlobal('Worker', FakeWorker)
    vi.resetModules()
    const { startModuleWorker } = await import('../../web/lib/threads/module-worker.ts')
    const create = vi.fn(() => raise(new TypeError('forbidden')))
    vi.stubGlobal('trustedTypes', { createPolicy: create })
    for (let k = 0; k < 2; k++) {
      const worker = startModuleWorker(
        () => new Worker('a'),
        () => '',
        'x',
      ) as unknown as FakeWorker
      expect(worker.args).toEqual(['a'])
    }
    expect(create).toHaveBeenCalledOnce()
  })

  it('that has the text of its file runs the text', async () => {
    vi.stubGlobal('Worker', FakeWorker)
    const { startModuleWorker } = await import('../../web/lib/threads/module-worker.ts')
    const refused = () => raise(new DOMException('another origin', 'SecurityError'))
    let script: Blob | undefined
    vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => {
      script = blob as Blob
      return 'blob:here'
    })
    const start = (file: () => URL | string) => startModuleWorker(refused, file, 'x') as unknown as FakeWorker
    expect(start(() => 'the text').args).toEqual(['blob:here', { type: 'classic', name: 'x' }])
    expect(await script?.text()).toBe('the text')
    // In a frame without an origin, only a text is a blob.
    vi.stubGlobal('origin', 'null')
    const [url, options] = start(() => new URL(PAGE)).args
    expect(url).toBe(`data:text/javascript,${encodeURIComponent(`import "${PAGE}"`)}`)
    expect(options).toEqual({ type: 'module', name: 'x' })
    expect(start(() => 'the text').args[0]).toBe('blob:here')
  })

  it('fails as the browser does for any other reason', () => {
    vi.stubGlobal('Worker', FakeWorker)
    for (const failure of [new TypeError('no'), new DOMException('no', 'SyntaxError')]) {
      world.newWorker = () => {
        throw failure
      }
      expect(() => startThread({ onReply() {}, onFailure() {} })).toThrow(failure)
    }
  })
})

describe('what a thread answers', () => {
  const module = compileCircleVoronoi({})

  /** A stub of a thread's port that records messages. */
  function answering() {
    const said: [reply: Reply, transfer: ArrayBuffer[] | undefined][] = []
    const port = {
      onmessage: (_: { data: Start | Request | EditorCalls }): unknown => undefined,
      postMessage: (reply: Reply, transfer?: ArrayBuffer[]) => said.push([reply, transfer]),
    }
    const original = process.getBuiltinModule
    vi.spyOn(process, 'getBuiltinModule').mockImplementation(((name: string) =>
      name === 'node:worker_threads' ? { parentPort: port } : original(name)) as typeof original)
    answerRequests()
    return { said, port, ask: (data: Start | Request | EditorCalls) => port.onmessage({ data }) }
  }

  const SITES = Float64Array.of(2, 2, 0, 7, 3, 0)
  const fitting = { areas: Float64Array.of(1, 3), shares: true, tolerance: 1e-9, maxSteps: 99, relax: 0 }
  const region = {
    points: Float64Array.of(0, 0, 10, 0, 10, 10, 0, 10),
    ringOffsets: Int32Array.of(0, 4),
    polygonOffsets: undefined,
  }
  const regions = readFileSync(new URL('../../web/lib/generated/circle-voronoi-regions.wasm', import.meta.url))
  const fitOf = async (more: object, where: object) => ({
    fit: { sites: SITES.slice(), ...fitting, ...more },
    region: undefined,
    wasm: await WebAssembly.compile(regions),
    tellsProgress: false,
    ...where,
  })

  /** The memory of all arrays in a value. The few numbers of a snapshot are copied. */
  const memoryOf = (value: unknown): unknown[] => {
    if (ArrayBuffer.isView(value)) return [value.buffer]
    const { numbers: _, ...parts } = Object(value)
    return typeof value === 'object' ? Object.values(parts).flatMap(memoryOf) : []
  }

  it.each([
    ['a diagram', async () => request()],
    ['a periodic diagram', async () => ({ ...request(), lattice: { a: [20, 0], b: [0, 20] } })],
    ['a fit', () => fitOf({}, { region })],
    ['a fit in a box', () => fitOf({ lattice: Float64Array.of(9, 0, 0, 4) }, {})],
    [
      'snapshots of an editor',
      async () => ({
        calls: [
          { method: 'edit', args: [THREE] },
          { method: 'snapshot', args: [] },
        ],
      }),
    ],
  ] as const)('is %s, with the memory of all its arrays', async (_, made) => {
    const { said, ask } = answering()
    await ask({ module: await module })
    await ask((await made()) as Request)
    expect(said).toHaveLength(1)
    const [[reply, transfer]] = said as [[Reply, ArrayBuffer[]]]
    expect('error' in reply).toBe(false)
    expect(new Set(transfer)).toEqual(new Set(memoryOf(reply)))
    expect(transfer).toHaveLength(new Set(transfer).size)
  })

  it('tells progress and steps if it is to', async () => {
    const { said, ask } = answering()
    await ask({ module: await module })
    await ask({ ...request(), tellsProgress: true, options: { method: 'touching-disc' } })
    const stages = said.splice(0).flatMap(([reply]) => ('progress' in reply ? [reply.progress[0]] : []))
    expect([...new Set(stages)]).toEqual(['order', 'triangulate', 'sample', 'pair', 'touch', 'certify', 'assemble'])
    await ask(await fitOf({}, { region, tellsProgress: true }))
    const steps = said.flatMap(([reply]) => ('step' in reply ? [reply.step.steps] : []))
    expect(steps).toEqual(Array.from({ length: said.length - 1 }, (_, step) => step))
  })

  it('is a fit, though the module did not load the first time', async () => {
    const { said, ask } = answering()
    const wrong = new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0))
    for (const more of [{ wasm: wrong }, {}]) await ask(await fitOf({}, { region, ...more }))
    const kinds = said.map(([told]) => ('error' in told ? told.error.code : Object.keys(told)[0]))
    expect(kinds).toEqual(['notLoaded', 'fit'])
  })

  it('is the reason for which the module does not load, each time', async () => {
    const { said, ask } = answering()
    const broken = new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0))
    await ask({ module: broken })
    // The failure before the first request is not unhandled.
    await expect(circleVoronoiOf(broken)).rejects.toThrow('cannot be loaded')
    await new Promise((resolve) => setImmediate(resolve))
    await ask(request())
    await ask(request())
    expect(said).toHaveLength(2)
    for (const [reply] of said) expect(reply).toMatchObject({ error: { code: 'notLoaded', circle: undefined } })
  })

  it('is what else went wrong, in one sentence', async () => {
    const { said, ask, port } = answering()
    await ask({ module: await module })
    port.postMessage = (reply, transfer) => {
      if ('progress' in reply) throw new TypeError('No clone.')
      return said.push([reply, transfer])
    }
    await ask({ ...request(), tellsProgress: true })
    const message = 'The computation failed: No clone.'
    expect(said).toEqual([[{ error: { code: 'internal', circle: undefined, message } }, []]])
  })
})
