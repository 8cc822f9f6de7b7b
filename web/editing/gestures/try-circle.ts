// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { Gesture, GestureContext } from './gesture.ts'

/** Previews the cell of a new circle under the pointer. The release adds the circle. */
export class TryCircle implements Gesture {
  readonly #context: GestureContext
  #last: Point
  #isOver = false
  #isFollowing = false

  constructor(context: GestureContext, from: Point) {
    this.#context = context
    this.#last = context.view.toPlane(from)
    this.#follow()
  }

  async #follow(): Promise<void> {
    if (this.#isFollowing) return
    this.#isFollowing = true
    const { view, actions } = this.#context
    for (let shown: Point | undefined; shown !== this.#last && !this.#isOver; ) {
      shown = this.#last
      await view.tryCircle(actions.circles.fitted(shown))
    }
    this.#isFollowing = false
  }

  move(to: Point): void {
    this.#last = this.#context.view.toPlane(to)
    this.#follow()
  }

  end(): void {
    this.cancel()
    this.#context.actions.circles.addFitting(this.#last)
  }

  cancel(): void {
    this.#isOver = true
    this.#context.view.tryCircle(undefined)
  }
}
