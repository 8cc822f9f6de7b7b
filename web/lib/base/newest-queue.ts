// SPDX-License-Identifier: GPL-3.0-or-later

/** A pending piece of work, with the callbacks of its caller. */
export interface Queued<Work, Answer> {
  work: Work
  readonly askers: { resolve(answer: Answer): void; reject(reason: unknown): void }[]
}

/**
 * A queue of work. New work replaces pending work that has the same key, and its answer goes to both callers. This
 * keeps a drag at most one request behind.
 */
export class NewestQueue<Work, Answer> {
  #waiting: Queued<Work, Answer>[] = []
  /** Pending work that newer work of the same key replaces. */
  readonly #newest = new Map<unknown, Queued<Work, Answer>>()
  readonly #act: ((work: Work) => Promise<Answer>) | undefined
  #isBusy = false

  /** `act` runs the work, one after the other. Without it, the work waits until it is taken. */
  constructor(act?: (work: Work) => Promise<Answer>) {
    this.#act = act
  }

  /** Adds work. If `key` is given, later work with this key may replace it. */
  add(work: Work, key?: unknown): Promise<Answer> {
    return new Promise((resolve, reject) => {
      const before = this.#newest.get(key)
      if (before !== undefined) {
        before.work = work
        before.askers.push({ resolve, reject })
        return
      }
      const queued = { work, askers: [{ resolve, reject }] }
      this.#waiting.push(queued)
      if (key !== undefined) this.#newest.set(key, queued)
      if (this.#act !== undefined && !this.#isBusy) void this.#run(this.#act)
    })
  }

  /** Keeps pending work from being replaced: the work of one key, or all work. */
  settle(key?: unknown): void {
    if (key === undefined) this.#newest.clear()
    else this.#newest.delete(key)
  }

  /** Removes and returns all pending work. */
  takeAll(): Queued<Work, Answer>[] {
    const taken = this.#waiting
    this.#waiting = []
    this.#newest.clear()
    return taken
  }

  async #run(act: (work: Work) => Promise<Answer>): Promise<void> {
    this.#isBusy = true
    for (let next = this.#waiting.shift(); next !== undefined; next = this.#waiting.shift()) {
      for (const [key, queued] of this.#newest) if (queued === next) this.#newest.delete(key)
      const { work, askers } = next
      const settle = await act(work).then(
        (answer) => (asker: (typeof askers)[number]) => asker.resolve(answer),
        (reason) => (asker: (typeof askers)[number]) => asker.reject(reason),
      )
      for (const asker of askers) settle(asker)
    }
    this.#isBusy = false
  }
}
