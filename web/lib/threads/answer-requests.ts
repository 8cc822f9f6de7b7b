// SPDX-License-Identifier: GPL-3.0-or-later

import { postedError } from '../base/errors.ts'
import type { FromThread, Functions, ProgressOf, ToThread } from './channel.ts'

/** The circumstances of a request. */
export interface RequestContext<Progress> {
  /** Aborted when the request is canceled. */
  readonly signal: AbortSignal
  /** Reports progress; `undefined` if nobody listens. */
  readonly tell: ((progress: Progress) => void) | undefined
}

/** The functions that answer requests. */
export type Answers<Requests extends Functions<Requests>> = {
  readonly [Name in keyof Requests]: (
    args: Parameters<Requests[Name]>,
    context: RequestContext<ProgressOf<Requests[Name]>>,
  ) => ReturnType<Requests[Name]> | Promise<ReturnType<Requests[Name]>>
}

/** The common interface of Node's parent port and the global scope of a browser's worker. */
export interface Port {
  onmessage: ((event: { readonly data: ToThread }) => void) | null
  postMessage(message: FromThread, transfer: readonly Transferable[]): void
}

const transfers = new WeakMap<object, readonly Transferable[]>()

/** Marks the parts of an answer that are transferred instead of copied. Returns the answer. */
export function transferring<Answer extends object>(answer: Answer, transfer: readonly Transferable[]): Answer {
  transfers.set(answer, transfer)
  return answer
}

/**
 * Answers the requests of a `Channel` in the calling thread. An error that an answer throws is the answer to its
 * request alone. Returns a function that sends events.
 */
export function answerRequests<Requests extends Functions<Requests>, Events extends object = object>(
  answers: Answers<Requests>,
  port = globalThis as unknown as Port,
): <Name extends keyof Events>(event: Name, data: Events[Name], transfer?: readonly Transferable[]) => void {
  const running = new Map<number, AbortController>()

  port.onmessage = async ({ data: message }) => {
    if ('cancel' in message) {
      running.get(message.cancel)?.abort()
      return
    }
    const { id, name, args, tellsProgress } = message
    const controller = new AbortController()
    running.set(id, controller)
    const tell = tellsProgress ? (progress: unknown) => port.postMessage({ id, progress }, []) : undefined
    try {
      const answer = answers[name as keyof Requests] as (args: unknown, context: unknown) => unknown
      const value = await answer(args, { signal: controller.signal, tell })
      port.postMessage({ id, value }, transfers.get(Object(value)) ?? [])
    } catch (error) {
      port.postMessage({ id, error: postedError(error) }, [])
    } finally {
      running.delete(id)
    }
  }
  return (event, data, transfer = []) => port.postMessage({ event, data }, transfer)
}
