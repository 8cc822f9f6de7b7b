// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to a thread and their answers. `Channel` is the side that asks, and `answerRequests` the side of the thread.
// Both share one type, which gives the function of each request by its name.
import { type PostedError, receivedError } from '../base/errors.ts'

/** The functions of a thread by name. */
export type Functions<Requests> = { readonly [Name in keyof Requests]: (...args: never[]) => unknown }

/** A function that reports its progress. */
export type WithProgress<Request, Progress> = Request & { readonly progress?: Progress }

export type ProgressOf<Request> = Request extends { readonly progress?: infer Progress } ? Progress : never

/** A message to a thread: a request, or the end of one. */
export type ToThread =
  | {
      readonly id: number
      readonly name: PropertyKey
      readonly args: readonly unknown[]
      readonly tellsProgress: boolean
    }
  | { readonly cancel: number }

/** A message of a thread: the answer to a request, its progress, or an event. */
export type FromThread =
  | { readonly id: number; readonly value: unknown }
  | { readonly id: number; readonly error: PostedError }
  | { readonly id: number; readonly progress: unknown }
  | { readonly event: PropertyKey; readonly data: unknown }

/** A running thread. */
export interface Thread {
  /** Sends a message and transfers the objects in `transfer`. */
  post(message: ToThread, transfer: readonly Transferable[]): void
  /** Sets whether the thread keeps Node from exiting. It has no effect in browsers. */
  keepAlive(isNeeded: boolean): void
  /** Ends the thread at once, even during a computation. */
  terminate(): void
}

/** The events of a thread. */
export interface ThreadEvents {
  onMessage(message: FromThread): void
  /** Called if the thread has crashed, or with `undefined` if its file could not be loaded. */
  onFailure(cause: unknown): void
}

/** The options of a request. */
export interface RequestOptions<Progress> {
  /** Cancels the request: the promise is rejected with the signal's reason, and the thread stops at its next step. */
  readonly signal?: AbortSignal | undefined
  /** The objects that are transferred instead of copied. */
  readonly transfer?: readonly Transferable[] | undefined
  readonly onProgress?: ((progress: Progress) => void) | undefined
}

interface Pending {
  readonly resolve: (value: never) => void
  readonly reject: (reason: unknown) => void
  readonly onProgress: ((progress: never) => void) | undefined
  /** Stops listening to the signal. */
  readonly forget: () => void
}

/** Asks one thread. After the end of the thread, all requests are rejected with the reason of the end. */
export class Channel<Requests extends Functions<Requests>, Events extends object = object> {
  readonly #thread: Thread
  readonly #pending = new Map<number, Pending>()
  #last = 0
  #end: { readonly reason: unknown } | undefined

  /** @throws what `start` throws */
  constructor(
    start: (events: ThreadEvents) => Thread,
    onFailure: (cause: unknown) => void,
    onEvent: { readonly [Name in keyof Events]: (data: Events[Name]) => void },
  ) {
    this.#thread = start({
      // The messages of a thread that has been ended may still arrive.
      onMessage: (message) => {
        if (this.#end !== undefined) return
        if ('event' in message) onEvent[message.event as keyof Events](message.data as Events[keyof Events])
        else this.#receive(message)
      },
      onFailure: (cause) => {
        if (this.#end === undefined) onFailure(cause)
      },
    })
  }

  /**
   * Sends a request, and returns its answer. The answer is rejected with the error of the thread's function: a
   * `CircleVoronoiError`, whose code is `internal` if the function threw another error.
   * @throws DOMException at once, and not as a rejection, if the arguments cannot be sent
   */
  request<Name extends keyof Requests>(
    name: Name,
    args: Parameters<Requests[Name]>,
    { signal, transfer = [], onProgress }: RequestOptions<ProgressOf<Requests[Name]>> = {},
  ): Promise<ReturnType<Requests[Name]>> {
    if (this.#end !== undefined) return Promise.reject(this.#end.reason)
    if (signal?.aborted) return Promise.reject(signal.reason)
    this.#last += 1
    const id = this.#last
    this.#thread.post({ id, name, args, tellsProgress: onProgress !== undefined }, transfer)
    if (this.#pending.size === 0) this.#thread.keepAlive(true)
    const cancel = () => {
      this.#thread.post({ cancel: id }, [])
      this.#take(id)?.reject(signal?.reason)
    }
    signal?.addEventListener('abort', cancel)
    const forget = () => signal?.removeEventListener('abort', cancel)
    return new Promise((resolve, reject) => this.#pending.set(id, { resolve, reject, onProgress, forget }))
  }

  /** Ends the thread and rejects all pending requests. */
  end(reason: unknown): void {
    if (this.#end !== undefined) return
    this.#end = { reason }
    this.#thread.terminate()
    for (const id of [...this.#pending.keys()]) this.#take(id)?.reject(reason)
  }

  get isEnded(): boolean {
    return this.#end !== undefined
  }

  #receive(message: Exclude<FromThread, { event: PropertyKey }>): void {
    if ('progress' in message) this.#pending.get(message.id)?.onProgress?.(message.progress as never)
    else if ('error' in message) this.#take(message.id)?.reject(receivedError(message.error))
    else this.#take(message.id)?.resolve(message.value as never)
  }

  #take(id: number): Pending | undefined {
    const pending = this.#pending.get(id)
    pending?.forget()
    if (this.#pending.delete(id) && this.#pending.size === 0) this.#thread.keepAlive(false)
    return pending
  }
}
