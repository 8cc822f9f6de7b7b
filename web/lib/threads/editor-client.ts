// SPDX-License-Identifier: GPL-3.0-or-later

import { checkNumber } from '../base/check.ts'
import type { CircleLike } from '../base/coordinates.ts'
import { NONE } from '../base/diagram-data.ts'
import { callListener, receivedError, workerFailure } from '../base/errors.ts'
import { NewestQueue, type Queued } from '../base/newest-queue.ts'
import type { Certificate, Circle, Int32s, SnapshotData } from '../base/types.ts'
import type { Change } from '../diagram/change.ts'
import { DiagramSnapshot } from '../diagram/diagram-snapshot.ts'
import { checkedCircle, checkedEdits, checkId, type Edit, type EditorStart } from '../wasm/editor.ts'
import type { CompiledWasm } from '../wasm/wasm.ts'
import { startThread, type Thread } from './thread.ts'
import type { AsyncEditorMethods } from './worker-editor.ts'
import type { EditorCall, Reply } from './worker-messages.ts'

/** The client of an editor in another thread. */
export class EditorClient implements AsyncEditorMethods {
  onchange: ((change: Change) => void) | undefined
  readonly #thread: Thread
  /** The calls that have been posted to the thread. */
  #sent: Queued<EditorCall, unknown>[] = []
  readonly #queue = new NewestQueue<EditorCall, unknown>()
  readonly #weights: boolean
  readonly #onEnd: () => void
  /** The reason why the editor has ended; `undefined` while it is running. */
  #end: unknown

  /** `onEnd` is called when the editor ends. */
  constructor(module: CompiledWasm, weights: boolean, onEnd: () => void) {
    this.#weights = weights
    this.#onEnd = onEnd
    this.#thread = startThread({
      onReply: (reply) => this.#receive(reply),
      onFailure: (cause) => this.#stop(workerFailure(cause)),
    })
    this.#thread.post({ module })
  }

  /** Creates the editor. Must be the first call. */
  async begin({ circles, ids, nextId }: Omit<EditorStart, 'weights'>): Promise<void> {
    try {
      await this.#ask('edit', circles, { weights: this.#weights, ids, nextId })
    } catch (error) {
      this.#stop(error)
      throw error
    }
  }

  async insert(circle: CircleLike, hint: number = NONE): Promise<Change> {
    checkNumber(hint, 'insert', 'hint')
    return this.#ask('insert', checkedCircle(circle, this.#weights), hint)
  }

  async remove(id: number): Promise<Change> {
    checkId(id, 'remove')
    const change = this.#add<Change>(id, 'remove', id)
    // A later replacement must not take the place of the removal.
    this.#queue.settle(id)
    return change
  }

  async replace(id: number, circle: CircleLike): Promise<Change> {
    checkId(id, 'replace')
    return this.#add(id, 'replace', id, checkedCircle(circle, this.#weights, id))
  }

  async apply(edits: Iterable<Edit>): Promise<Change> {
    return this.#inOrder('apply', checkedEdits(edits, this.#weights))
  }

  async nearest(x: number, y: number, hint: number = NONE): Promise<number> {
    checkNumber(x, 'nearest', 'x')
    checkNumber(y, 'nearest', 'y')
    checkNumber(hint, 'nearest', 'hint')
    return this.#inOrder('nearest', x, y, hint)
  }

  async size(): Promise<number> {
    return this.#inOrder('size')
  }

  async circle(id: number): Promise<Circle | undefined> {
    checkId(id, 'circle')
    return this.#inOrder('circle', id)
  }

  async isHidden(id: number): Promise<boolean> {
    checkId(id, 'isHidden')
    return this.#inOrder('isHidden', id)
  }

  async ids(): Promise<Int32s> {
    return this.#inOrder('ids')
  }

  async snapshot(): Promise<DiagramSnapshot> {
    return new DiagramSnapshot(await this.#inOrder<SnapshotData>('snapshot'))
  }

  async certificate(): Promise<Certificate> {
    return this.#inOrder('certificate')
  }

  dispose(): void {
    this.#stop(new DOMException('The editor has been disposed of.', 'AbortError'))
  }

  [Symbol.dispose](): void {
    this.dispose()
  }

  /** Calls a method after all earlier calls. */
  #inOrder<Value>(method: string, ...args: unknown[]): Promise<Value> {
    this.#queue.settle()
    return this.#ask(method, ...args)
  }

  #ask<Value>(method: string, ...args: unknown[]): Promise<Value> {
    return this.#add(undefined, method, ...args)
  }

  /** Queues a call. If `id` is given, a later call for the same circle replaces this one. */
  #add<Value>(id: number | undefined, method: string, ...args: unknown[]): Promise<Value> {
    if (this.#end !== undefined) return Promise.reject(this.#end)
    const answer = this.#queue.add({ method, args }, id)
    this.#send()
    return answer as Promise<Value>
  }

  #send(): void {
    if (this.#sent.length > 0) return
    this.#sent = this.#queue.takeAll()
    if (this.#sent.length === 0) return
    this.#thread.keepAlive(true)
    this.#thread.post({ calls: this.#sent.map(({ work }) => work) })
  }

  #receive(reply: Reply): void {
    // After the end, all pending calls have been rejected.
    if (this.#end !== undefined || !('results' in reply)) return
    const answered = this.#sent
    this.#sent = []
    this.#send()
    if (this.#sent.length === 0) this.#thread.keepAlive(false)
    reply.results.forEach((result, k) => {
      const { work, askers } = answered[k] as Queued<EditorCall, unknown>
      if ('error' in result) {
        for (const { reject } of askers) reject(receivedError(result.error))
        return
      }
      if (EDITS.includes(work.method)) callListener(this.onchange, result.value as Change)
      for (const { resolve } of askers) resolve(result.value)
    })
  }

  #stop(reason: unknown): void {
    if (this.#end !== undefined) return
    this.#end = reason
    this.#onEnd()
    this.#thread.terminate()
    const unanswered = [...this.#sent, ...this.#queue.takeAll()]
    this.#sent = []
    for (const { askers } of unanswered) {
      for (const { reject } of askers) reject(reason)
    }
  }
}

/** The methods that make a change. */
const EDITS = ['insert', 'remove', 'replace', 'apply']
