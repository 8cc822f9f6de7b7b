// SPDX-License-Identifier: GPL-3.0-or-later
import type { Channel } from '../lib/threads/channel.ts'
import type { ComputingRequests } from './protocol.ts'

/**
 * Threads for computations that take long and cannot be divided into steps. Each computation has a thread of its own,
 * so that canceling it ends no other one. One idle thread is kept.
 */
export class ComputingThreads {
  readonly #start: () => Channel<ComputingRequests>
  #idle: Channel<ComputingRequests> | undefined

  constructor(start: () => Channel<ComputingRequests>) {
    this.#start = start
  }

  /** Runs a computation. `signal` ends it at once. */
  async request<Name extends 'compute' | 'trace'>(
    name: Name,
    args: Parameters<ComputingRequests[Name]>,
    signal: AbortSignal,
  ): Promise<ReturnType<ComputingRequests[Name]>> {
    const idle = this.#idle
    this.#idle = undefined
    const channel = idle === undefined || idle.isEnded ? this.#start() : idle
    const cancel = () => channel.end(signal.reason)
    signal.addEventListener('abort', cancel)
    try {
      return await channel.request(name, args)
    } finally {
      signal.removeEventListener('abort', cancel)
      if (this.#idle === undefined) this.#idle = channel
      else channel.end(undefined)
    }
  }

  dispose(reason: unknown): void {
    this.#idle?.end(reason)
  }
}
