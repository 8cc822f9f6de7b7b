// SPDX-License-Identifier: GPL-3.0-or-later

/** Time slice in milliseconds, before the thread handles messages. */
const SLICE = 8

/** Computes an answer in steps. */
export type Steps<Value> = () => Generator<void, Value>

/** Long work. `begin` starts it again, for example after an opening. */
interface Work {
  readonly owner: unknown
  readonly begin: Steps<unknown>
  steps: Generator<void, unknown>
  readonly resolve: (value: never) => void
  readonly reject: (error: unknown) => void
}

/** Divides the time of a thread: messages come first, then tiles, then work in steps. */
export class Scheduler {
  readonly #paint: (end: number) => boolean
  readonly #pause = new MessageChannel()
  #isScheduled = false
  #works: Work[] = []

  /** `paint` paints tiles until a time of `performance.now()`, and returns whether tiles are left. */
  constructor(paint: (end: number) => boolean) {
    this.#paint = paint
    this.#pause.port1.onmessage = () => this.#runSlice()
  }

  /** Asks for a slice. Messages that have arrived are handled before. */
  schedule(): void {
    if (this.#isScheduled) return
    this.#isScheduled = true
    this.#pause.port2.postMessage(undefined)
  }

  /** Runs work of an owner in steps. If the signal is aborted, the work stops and its promise is rejected. */
  run<Value>(owner: unknown, begin: Steps<Value>, signal: AbortSignal): Promise<Value> {
    return new Promise((resolve, reject) => {
      signal.throwIfAborted()
      const work: Work = { owner, begin, steps: begin(), resolve, reject }
      this.#works.push(work)
      signal.addEventListener('abort', () => this.#end(work, () => reject(signal.reason)), { once: true })
      this.schedule()
    })
  }

  /** Starts the work of an owner again. */
  restart(owner: unknown): void {
    for (const work of this.#works) if (work.owner === owner) work.steps = work.begin()
  }

  #runSlice(): void {
    this.#isScheduled = false
    const end = performance.now() + SLICE
    const isPaintingLeft = this.#paint(end)
    this.#work(end)
    if (isPaintingLeft || this.#works.length > 0) this.schedule()
  }

  /** Uses the rest of a slice, or else takes one step, so that endless painting does not stop all work. */
  #work(end: number): void {
    const [work] = this.#works
    if (work === undefined) return
    try {
      let step = work.steps.next()
      while (step.done !== true && performance.now() < end) step = work.steps.next()
      if (step.done === true) this.#end(work, () => work.resolve(step.value as never))
    } catch (error) {
      this.#end(work, () => work.reject(error))
    }
  }

  #end(work: Work, settle: () => void): void {
    this.#works = this.#works.filter((other) => other !== work)
    settle()
  }
}

/** Takes all steps at once. */
export function finished<Value>(steps: Generator<void, Value>): Value {
  let step = steps.next()
  while (step.done !== true) step = steps.next()
  return step.value
}
