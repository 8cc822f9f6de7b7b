// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import { type Gesture, type GestureContext, snapDistance } from './gesture.ts'

/** Places a corner of a region on release. */
export class DrawRegion implements Gesture {
  readonly #context: GestureContext
  #last: Point

  constructor(context: GestureContext, from: Point) {
    this.#context = context
    this.#last = from
    this.move(from)
  }

  move(to: Point): void {
    const { view, actions } = this.#context
    this.#last = to
    actions.tools.pen?.move(view.toPlane(to))
  }

  click(): void {
    this.end()
  }

  end(): void {
    const { view, actions } = this.#context
    actions.tools.pen?.place(view.toPlane(this.#last), snapDistance(view))
  }
}
