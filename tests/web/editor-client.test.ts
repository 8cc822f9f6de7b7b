// SPDX-License-Identifier: GPL-3.0-or-later
// The client of an editor in a thread. The thread answers when the test says so; tests/wasm/worker.test.mjs uses real
// threads.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { type Change, CircleVoronoiError, Diagram, type DiagramEditor } from '../../web/lib/index.ts'
import { EditorClient } from '../../web/lib/threads/editor-client.ts'
import type { ThreadEvents } from '../../web/lib/threads/thread.ts'
import type { CallResult, EditorCall, EditorCalls, Start } from '../../web/lib/threads/worker-messages.ts'
import { useThreads } from './fake-threads.ts'
import { library } from './library.ts'

const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 4, 9, 3)
const MODULE = {} as Start['module']

/** A thread with an editor, like that of `answerRequests`. */
class FakeThread {
  readonly posted: (Start | EditorCalls)[] = []
  isKeptAlive: boolean | undefined
  isTerminated = false
  readonly #events: ThreadEvents
  #editor: DiagramEditor | undefined

  constructor(events: ThreadEvents) {
    this.#events = events
  }

  post(message: Start | EditorCalls): void {
    this.posted.push(message)
  }

  keepAlive(isNeeded: boolean): void {
    this.isKeptAlive = isNeeded
  }

  terminate(): void {
    this.isTerminated = true
  }

  /** The calls of the last message. */
  get calls(): readonly EditorCall[] {
    return (this.posted.at(-1) as EditorCalls).calls
  }

  answer(): void {
    this.#events.onReply({ results: this.calls.map((call) => this.#resultOf(call)) })
  }

  /** Sends a message that is not an answer. */
  mumble(): void {
    this.#events.onReply({ progress: ['touch', 0.5] })
  }

  breakDown(cause: unknown): void {
    this.#events.onFailure(cause)
  }

  #resultOf({ method, args }: EditorCall): CallResult {
    try {
      if (method === 'edit') {
        this.#editor = library.edit(...(args as Parameters<typeof library.edit>))
        return { value: undefined }
      }
      const methods = this.#editor as unknown as Record<string, (...args: readonly unknown[]) => unknown>
      return { value: methods[method]?.(...args) }
    } catch (error) {
      const { code, circle, message } = error as CircleVoronoiError
      return { error: { code, circle, message } }
    }
  }
}

vi.mock('../../web/lib/threads/thread.ts', () => import('./fake-threads.ts'))
const threads: FakeThread[] = []

let client: EditorClient
let thread: FakeThread
let changes: Change[]
const onEnd = vi.fn()

beforeEach(async () => {
  useThreads((events) => {
    const started = new FakeThread(events)
    threads.push(started)
    return started
  })
  client = new EditorClient(MODULE, false, onEnd)
  thread = threads.at(-1) as FakeThread
  changes = []
  client.onchange = (change) => changes.push(change)
  const begun = client.begin({ circles: THREE })
  expect(thread.posted[0]).toEqual({ module: MODULE })
  expect(thread.isKeptAlive).toBe(true)
  thread.answer()
  await begun
  expect(thread.isKeptAlive).toBe(false)
})
afterEach(() => {
  client.dispose()
  onEnd.mockClear()
})

/** Resolves with the answer to a request. */
async function answered<Value>(promise: Promise<Value>): Promise<Value> {
  thread.answer()
  return promise
}

const methodsOf = (calls: readonly EditorCall[]) => calls.map(({ method, args }) => [method, ...args])

describe('the client of an editor', () => {
  it('asks its thread, and gives the answers', async () => {
    expect(await answered(client.size())).toBe(3)
    expect(await answered(client.nearest(9, 1))).toBe(1)
    expect(methodsOf(thread.calls)).toEqual([['nearest', 9, 1, -1]])
    expect(await answered(client.nearest(9, 1, 2))).toBe(1)
    expect(methodsOf(thread.calls)).toEqual([['nearest', 9, 1, 2]])
    expect(await answered(client.circle(2))).toEqual({ x: 4, y: 9, r: 3 })
    expect(await answered(client.circle(7))).toBeUndefined()
    expect(await answered(client.isHidden(0))).toBe(false)
    expect([...(await answered(client.ids()))]).toEqual([0, 1, 2])
    expect((await answered(client.certificate())).certified).toBe(true)
    const diagram = await answered(client.snapshot())
    expect(diagram).toBeInstanceOf(Diagram)
    expect(diagram.find(4, 8)).toBe(2)
    expect(changes).toHaveLength(0)
  })

  it('tells each change before its promise is fulfilled', async () => {
    const insert = client.insert([5, 4, 0.5], 1)
    const seen = insert.then((change) => expect(changes).toEqual([change]))
    thread.answer()
    await seen
    expect(methodsOf(thread.calls)).toEqual([['insert', { x: 5, y: 4, r: 0.5 }, 1]])
    await answered(client.replace(3, { x: 5, y: 4, r: 0.6 }))
    await answered(client.remove(3))
    await answered(
      client.apply([
        { kind: 'insert', circle: [5, 4, 0.5] },
        { kind: 'remove', id: 4 },
      ]),
    )
    expect(changes).toHaveLength(4)
    expect(await answered(client.size())).toBe(3)
  })

  it('gives its thread one message at a time, with all that has come meanwhile, in order', async () => {
    const first = client.size()
    const later = [client.insert([5, 4, 0.5]), client.size(), client.circle(3)] as const
    expect(methodsOf(thread.calls)).toEqual([['size']])
    thread.answer()
    expect(await first).toBe(3)
    expect(thread.isKeptAlive).toBe(true)
    expect(methodsOf(thread.calls)).toEqual([['insert', { x: 5, y: 4, r: 0.5 }, -1], ['size'], ['circle', 3]])
    thread.answer()
    expect(await later[1]).toBe(4)
    expect(await later[2]).toEqual({ x: 5, y: 4, r: 0.5 })
    expect(thread.isKeptAlive).toBe(false)
  })

  it('does the last of the replacements that wait, and all get its change', async () => {
    const busy = client.size()
    const drags = [1, 2, 3].map((x) => client.replace(0, [x, 0, 1]))
    const other = client.replace(1, [11, 0, 2])
    thread.answer()
    await busy
    expect(methodsOf(thread.calls)).toEqual([
      ['replace', 0, { x: 3, y: 0, r: 1 }],
      ['replace', 1, { x: 11, y: 0, r: 2 }],
    ])
    thread.answer()
    const [first, ...others] = await Promise.all(drags)
    for (const change of others) expect(change).toBe(first)
    expect(await other).not.toBe(first)
    expect(changes).toHaveLength(2)
  })

  it('removes a circle in place of replacing it before, and what comes then is another circle', async () => {
    const busy = client.size()
    const drag = client.replace(0, [1, 0, 1])
    const removal = client.remove(0)
    const again = client.replace(0, [2, 0, 1])
    thread.answer()
    await busy
    expect(methodsOf(thread.calls)).toEqual([
      ['remove', 0],
      ['replace', 0, { x: 2, y: 0, r: 1 }],
    ])
    thread.answer()
    expect(await drag).toBe(await removal)
    await expect(again).rejects.toMatchObject({ code: 'unknownCircle', circle: 0 })
  })

  it('does not merge what something else is asked between', async () => {
    const busy = client.size()
    void client.replace(0, [1, 0, 1])
    const between = client.circle(0)
    const last = client.replace(0, [2, 0, 1])
    thread.answer()
    await busy
    expect(thread.calls.map(({ method }) => method)).toEqual(['replace', 'circle', 'replace'])
    thread.answer()
    expect(await between).toEqual({ x: 1, y: 0, r: 1 })
    await last
  })

  it('rejects what the editor refuses, and goes on', async () => {
    const hidden = client.remove(9)
    thread.answer()
    const error = await hidden.catch((error) => error)
    expect(error).toBeInstanceOf(CircleVoronoiError)
    expect(error).toMatchObject({ code: 'unknownCircle', circle: 9 })
    expect(changes).toHaveLength(0)
    expect(await answered(client.size())).toBe(3)
    expect(thread.isTerminated).toBe(false)
  })

  it('answers an edit where a listener throws, which is an uncaught error', async () => {
    client.onchange = () => {
      throw new Error('The listener fails.')
    }
    const later: (() => void)[] = []
    vi.stubGlobal('queueMicrotask', (act: () => void) => later.push(act))
    const change = await answered(client.remove(0))
    vi.unstubAllGlobals()
    expect([...change.removed]).toEqual([0])
    expect(later).toHaveLength(1)
    expect(later[0]).toThrow('The listener fails.')
    expect(await answered(client.size())).toBe(2)
  })

  it('takes an answer for no other reply', async () => {
    const size = client.size()
    thread.mumble()
    expect(await answered(size)).toBe(3)
  })

  it('ends once it is disposed of, and rejects what has not been answered and what is asked then', async () => {
    const asked = [client.size(), client.replace(0, [1, 0, 1]), client.replace(0, [2, 0, 1])]
    client.dispose()
    client[Symbol.dispose]()
    // Messages that the thread has posted before its end still arrive.
    thread.answer()
    expect(changes).toEqual([])
    for (const promise of [...asked, client.ids()]) {
      await expect(promise).rejects.toMatchObject({ name: 'AbortError', message: 'The editor has been disposed of.' })
    }
    expect(thread.isTerminated).toBe(true)
    expect(onEnd).toHaveBeenCalledTimes(1)
  })

  it('says why its thread broke down', async () => {
    const size = client.size()
    thread.breakDown(new Error('out of memory'))
    await expect(size).rejects.toMatchObject({ code: 'internal', message: expect.stringContaining('out of memory') })
    await expect(client.size()).rejects.toMatchObject({ code: 'internal', circle: undefined })
    expect(onEnd).toHaveBeenCalledTimes(1)
  })

  it('ends where it cannot begin', async () => {
    const other = new EditorClient(MODULE, false, onEnd)
    const itsThread = threads.at(-1) as FakeThread
    const begun = other.begin({ circles: Float64Array.of(0, 0, -1) })
    itsThread.answer()
    await expect(begun).rejects.toMatchObject({ code: 'negativeRadius', circle: 0 })
    await expect(other.size()).rejects.toMatchObject({ code: 'negativeRadius' })
    expect(itsThread.isTerminated).toBe(true)
    expect(onEnd).toHaveBeenCalledTimes(1)
  })

  it('begins with the ids and the next id that it is given', async () => {
    const other = new EditorClient(MODULE, false, onEnd)
    const itsThread = threads.at(-1) as FakeThread
    const start = { ids: Int32Array.of(2, 5, 7), nextId: 9 }
    const begun = other.begin({ circles: THREE, ...start })
    expect(methodsOf(itsThread.calls)).toEqual([['edit', THREE, { weights: false, ...start }]])
    itsThread.answer()
    await begun
    const inserted = other.insert([5, 4, 0.5])
    itsThread.answer()
    expect([...(await inserted).inserted]).toEqual([9])
    other.dispose()
  })

  it('takes weights where it is told so', async () => {
    const other = new EditorClient(MODULE, true, onEnd)
    const itsThread = threads.at(-1) as FakeThread
    const begun = other.begin({ circles: Float64Array.of(0, 0, -1) })
    itsThread.answer()
    await begun
    const edits = [
      other.insert([5, 0, -2]),
      other.replace(0, [0, 0, -3]),
      other.apply([{ kind: 'insert', circle: [0, 9, -4] }]),
    ]
    const snapshot = other.snapshot()
    // The first request is sent at once, later ones are sent together.
    itsThread.answer()
    itsThread.answer()
    await Promise.all(edits)
    expect((await snapshot).weights).toBe(true)
    expect((await snapshot).circles).toEqual(Float64Array.of(0, 0, -3, 5, 0, -2, 0, 9, -4))
    await expect(client.insert([5, 0, -2])).rejects.toMatchObject({ code: 'negativeRadius' })
  })
})
