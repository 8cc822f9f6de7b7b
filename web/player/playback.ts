// SPDX-License-Identifier: GPL-3.0-or-later

/** Calls a function repeatedly at a given rate until it returns false or playback is stopped. */
export class Playback {
  readonly #step: () => boolean
  #speed = 1
  #timer: ReturnType<typeof setTimeout> | undefined

  constructor(step: () => boolean) {
    this.#step = step
  }

  /** Calls per second. */
  get speed(): number {
    return this.#speed
  }

  set speed(speed: number) {
    this.#speed = speed
    if (this.#timer !== undefined) this.start()
  }

  /** Waits for the next call; restarts the wait if one is running. */
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
