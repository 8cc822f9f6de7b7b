// SPDX-License-Identifier: GPL-3.0-or-later

/** A pending piece of work, with the callbacks of its caller. */
export interface Queued<Work, Answer> {
  work: Work
  readonly askers: { resolve(answer: Answer): void; reject(reason: unknown): void }[]
}

/**
 * Work that waits for its turn. The newest request of a key replaces the one that waits under this key, and answers
 * both. So a drag is never behind by more than one request.
 */
export class NewestQueue<Work, Answer> {
  #waiting: Queued<Work, Answer>[] = []
  /** Pending work that newer work of the same key replaces. */
  readonly #newest = new Map<unknown, Queued<Work, Answer>>()
  #current: Work | undefined
  #isBusy = false

  /** `key`: of what may be replaced. */
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
    })
  }

  /** Keeps pending work from being replaced: of one key, or all. */
  settle(key?: unknown): void {
    if (key === undefined) this.#newest.clear()
    else this.#newest.delete(key)
  }

  /** The work that `drain` is running, and the pending work. */
  get works(): readonly Work[] {
    const waiting = this.#waiting.map(({ work }) => work)
    return this.#current === undefined ? waiting : [this.#current, ...waiting]
  }

  /** Takes out all that waits. */
  takeAll(): Queued<Work, Answer>[] {
    const taken = this.#waiting
    this.#waiting = []
    this.#newest.clear()
    return taken
  }

  /** Does what waits, one after the other, unless that is under way. */
  async drain(act: (work: Work) => Promise<Answer>): Promise<void> {
    if (this.#isBusy) return
    this.#isBusy = true
    for (let next = this.#waiting.shift(); next !== undefined; next = this.#waiting.shift()) {
      for (const [key, queued] of this.#newest) if (queued === next) this.#newest.delete(key)
      const { work, askers } = next
      this.#current = work
      const settle = await act(work).then(
        (answer) => (asker: (typeof askers)[number]) => asker.resolve(answer),
        (reason) => (asker: (typeof askers)[number]) => asker.reject(reason),
      )
      this.#current = undefined
      for (const asker of askers) settle(asker)
    }
    this.#isBusy = false
  }
}
