// SPDX-License-Identifier: GPL-3.0-or-later
import { type PostedError, receivedError } from '../lib/base/errors.ts'

/** A call of a function in a thread, by its name. */
export interface RemoteCall<Name = PropertyKey> {
  readonly request: number
  readonly name: Name
  readonly args: readonly unknown[]
}

/** The reply to a call: a value, or an error. */
export interface RemoteReply {
  readonly request: number
  readonly value?: unknown
  readonly error?: PostedError | undefined
}

/** The functions of a thread, as `Calls` declares them. */
type Functions<Calls> = { readonly [Name in keyof Calls]: (...args: never[]) => unknown }

/** The pending calls of functions in a thread. */
export class RemoteCalls<Calls extends Functions<Calls>> {
  readonly #waiting = new Map<number, { resolve(value: never): void; reject(error: Error): void; owner: unknown }>()
  #last = 0

  /**
   * Calls a function. `post` sends the call to the thread. `owner` identifies calls for `leave`.
   * @throws CircleVoronoiError that the thread replied with, and whatever `post` throws
   */
  call<Name extends keyof Calls>(
    name: Name,
    args: Parameters<Calls[Name]>,
    post: (call: RemoteCall<Name>) => void,
    owner?: unknown,
  ): Promise<ReturnType<Calls[Name]>> {
    return new Promise((resolve, reject) => {
      this.#last += 1
      post({ request: this.#last, name, args })
      this.#waiting.set(this.#last, { resolve, reject, owner })
    })
  }

  receive({ request, value, error }: RemoteReply): void {
    const waiting = this.#waiting.get(request)
    this.#waiting.delete(request)
    if (error === undefined) waiting?.resolve(value as never)
    else waiting?.reject(receivedError(error))
  }

  /** Settles an owner's calls that will get no reply: rejects them with an error, or resolves them to `undefined`. */
  leave(owner?: unknown, error?: PostedError): void {
    const requests = [...this.#waiting].filter(([, waiting]) => waiting.owner === owner)
    for (const [request] of requests) this.receive({ request, error })
  }
}
