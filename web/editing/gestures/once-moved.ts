// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { Gesture } from './gesture.ts'

/** Begins another gesture at the first move. */
export class OnceMoved implements Gesture {
  readonly #begin: () => Gesture
  readonly click: () => void
  #begun: Gesture | undefined

  constructor(begin: () => Gesture, click: () => void) {
    this.#begin = begin
    this.click = click
  }

  move(to: Point, snaps: boolean): void {
    this.#begun ??= this.#begin()
    this.#begun.move(to, snaps)
  }

  end(): void {
    this.#begun?.end?.()
  }

  cancel(): void {
    this.#begun?.cancel?.()
  }
}
