// SPDX-License-Identifier: GPL-3.0-or-later

import { checkNumber } from '../base/check.ts'
import type { CircleLike } from '../base/coordinates.ts'
import { NONE } from '../base/diagram-data.ts'
import { callListener, workerFailure } from '../base/errors.ts'
import { NewestQueue } from '../base/newest-queue.ts'
import type { Certificate, Circle, Int32s } from '../base/types.ts'
import type { Change } from '../diagram/change.ts'
import { DiagramSnapshot } from '../diagram/diagram-snapshot.ts'
import { checkedCircle, checkedEdits, checkId, type Edit, type EditorStart } from '../wasm/editor.ts'
import type { CompiledWasm } from '../wasm/wasm.ts'
import { Channel } from './channel.ts'
import { startThread } from './thread.ts'
import type { AsyncEditorMethods } from './worker-editor.ts'
import type { EditorRequests } from './worker-requests.ts'

type Name = keyof EditorRequests
/** A method and its arguments. */
type Call = { readonly [Method in Name]: readonly [name: Method, args: Parameters<EditorRequests[Method]>] }[Name]

/** The client of an editor in another thread. */
export class EditorClient implements AsyncEditorMethods {
  onchange: ((change: Change) => void) | undefined
  readonly #channel: Channel<EditorRequests>
  /** The number of calls that the thread has not answered. The others wait in the queue. */
  #sent = 0
  readonly #queue = new NewestQueue<Call, unknown>()
  readonly #weights: boolean
  readonly #onEnd: () => void

  /** `onEnd` is called when the editor ends. */
  constructor(module: CompiledWasm, weights: boolean, onEnd: () => void) {
    this.#weights = weights
    this.#onEnd = onEnd
    this.#channel = new Channel(startThread, (cause) => this.#stop(workerFailure(cause)), {})
    this.#channel.request('start', [module]).catch(() => {})
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
    const change = this.#add(id, 'remove', id)
    // A later replacement must not take the place of the removal.
    this.#queue.settle(id)
    return change
  }

  async replace(id: number, circle: CircleLike): Promise<Change> {
    checkId(id, 'replace')
    return this.#add(id, 'replace', id, checkedCircle(circle, this.#weights, id))
  }

  async apply(edits: Iterable<Edit>): Promise<Change> {
    return this.#inOrder('apply', checkedEdits(edits, this.#weights) as readonly Edit[])
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
    return new DiagramSnapshot(await this.#inOrder('snapshot'))
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
  #inOrder<Method extends Name>(name: Method, ...args: Parameters<EditorRequests[Method]>): Promise<Answer<Method>> {
    this.#queue.settle()
    return this.#ask(name, ...args)
  }

  #ask<Method extends Name>(name: Method, ...args: Parameters<EditorRequests[Method]>): Promise<Answer<Method>> {
    return this.#add(undefined, name, ...args)
  }

  /** Queues a call. If `id` is given, a later call for the same circle replaces this one. */
  #add<Method extends Name>(
    id: number | undefined,
    name: Method,
    ...args: Parameters<EditorRequests[Method]>
  ): Promise<Answer<Method>> {
    const answer = this.#queue.add([name, args] as unknown as Call, id)
    this.#send()
    return answer as Promise<Answer<Method>>
  }

  /** Sends all calls that wait, once the thread has answered the former ones. */
  #send(): void {
    if (this.#sent > 0) return
    const calls = this.#queue.takeAll()
    this.#sent = calls.length
    for (const { work, askers } of calls) {
      const [name, args] = work
      this.#channel
        .request<Name>(name, args)
        .finally(() => {
          this.#sent -= 1
          this.#send()
        })
        .then(
          (value) => {
            if (EDITS.includes(name)) callListener(this.onchange, value as Change)
            for (const { resolve } of askers) resolve(value)
          },
          (error) => {
            for (const { reject } of askers) reject(error)
          },
        )
    }
  }

  #stop(reason: unknown): void {
    if (this.#channel.isEnded) return
    this.#onEnd()
    this.#channel.end(reason)
  }
}

type Answer<Method extends Name> = ReturnType<EditorRequests[Method]>

/** The methods that make a change. */
const EDITS: readonly Name[] = ['insert', 'remove', 'replace', 'apply']
