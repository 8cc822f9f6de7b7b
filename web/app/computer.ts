// SPDX-License-Identifier: GPL-3.0-or-later
import type { Diagram } from '../lib/index.ts'
import { createWorker } from '../lib/worker.ts'

/** What comes back for the circles of one request. */
export type Reply = { readonly diagram: Diagram } | { readonly problem: string }

/**
 * Computes diagrams in a worker, one at a time. Circles that arrive meanwhile wait, and newer ones take their place: a
 * drag never queues up work.
 */
export class Computer {
  readonly #worker = createWorker()
  readonly #onReply: (reply: Reply) => void
  #isBusy = false
  #waiting: Float64Array | undefined

  constructor(onReply: (reply: Reply) => void) {
    this.#onReply = onReply
  }

  async request(circles: Float64Array): Promise<void> {
    this.#waiting = circles
    if (this.#isBusy) return
    this.#isBusy = true
    while (this.#waiting !== undefined) {
      const next = this.#waiting
      this.#waiting = undefined
      this.#onReply(await this.#replyTo(next))
    }
    this.#isBusy = false
  }

  async #replyTo(circles: Float64Array): Promise<Reply> {
    try {
      return { diagram: await this.#worker.computeAsync(circles) }
    } catch (error) {
      return { problem: error instanceof Error ? error.message : String(error) }
    }
  }
}
