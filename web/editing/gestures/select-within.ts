// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { Gesture, GestureContext } from './gesture.ts'

/** Selects the circles in a rectangle between the press and the release. */
export class SelectWithin implements Gesture {
  readonly #context: GestureContext
  readonly #from: Point
  readonly click: () => void
  #last: Point

  constructor(context: GestureContext, from: Point, click: () => void) {
    this.#context = context
    this.#from = from
    this.#last = from
    this.click = click
  }

  move(to: Point): void {
    this.#last = to
    this.#context.view.rectangle = { from: this.#from, to }
  }

  end(): void {
    const { view, actions } = this.#context
    this.cancel()
    const [one, other] = [view.toPlane(this.#from), view.toPlane(this.#last)]
    actions.selection.selectWithin({
      minX: Math.min(one.x, other.x),
      minY: Math.min(one.y, other.y),
      maxX: Math.max(one.x, other.x),
      maxY: Math.max(one.y, other.y),
    })
  }

  cancel(): void {
    this.#context.view.rectangle = undefined
  }
}
