// SPDX-License-Identifier: GPL-3.0-or-later
import type { Reply } from './compute-worker.ts'

/**
 * Computes diagrams in a worker, one at a time. Circles that arrive meanwhile wait, and newer ones take their place: a
 * drag never queues up work.
 */
export class Computer {
  readonly #worker = new Worker(new URL('./compute-worker.ts', import.meta.url), { type: 'module' })
  readonly #onReply: (reply: Reply) => void
  #isBusy = false
  #waiting: Float64Array | undefined

  constructor(onReply: (reply: Reply) => void) {
    this.#onReply = onReply
    this.#worker.addEventListener('message', ({ data }: MessageEvent<Reply>) => {
      this.#isBusy = false
      this.#onReply(data)
      if (this.#waiting !== undefined) this.request(this.#waiting)
    })
    this.#worker.addEventListener('error', () => this.#onReply({ problem: 'The computation could not be loaded.' }))
  }

  request(circles: Float64Array): void {
    if (this.#isBusy) {
      this.#waiting = circles
      return
    }
    this.#waiting = undefined
    this.#isBusy = true
    this.#worker.postMessage(circles)
  }
}
