// SPDX-License-Identifier: GPL-3.0-or-later

/** Calls a function again and again, so many times a second, until it returns false or is stopped. */
export class Playback {
  readonly #step: () => boolean
  #speed = 1
  #timer: ReturnType<typeof setTimeout> | undefined

  constructor(step: () => boolean) {
    this.#step = step
  }

  /** Calls in a second. */
  get speed(): number {
    return this.#speed
  }

  set speed(speed: number) {
    this.#speed = speed
    if (this.#timer !== undefined) this.start()
  }

  /** Begins to wait for the next call, also where it is waited for already. */
  start(): void {
    this.stop()
    this.#timer = setTimeout(() => {
      this.#timer = undefined
      if (this.#step()) this.start()
    }, 1000 / this.#speed)
  }

  stop(): void {
    clearTimeout(this.#timer)
    this.#timer = undefined
  }
}
