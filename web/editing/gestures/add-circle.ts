// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Point } from '../../lib/index.ts'
import { type Gesture, type GestureContext, snapDistance } from './gesture.ts'

/** Adds a circle: the press sets its center, the drag its radius. */
export class AddCircle implements Gesture {
  readonly #context: GestureContext
  readonly #gesture: number
  readonly #center: Point
  #added: Promise<readonly number[]> | undefined
  #last: Circle | undefined
  #isCanceled = false

  constructor(context: GestureContext, from: Point) {
    this.#context = context
    this.#gesture = context.editing.beginGesture()
    this.#center = context.view.toPlane(from)
  }

  move(to: Point, snaps: boolean): void {
    const { editing, actions } = this.#context
    const circle = this.#circleTo(to, snaps)
    this.#last = circle
    const isFirst = this.#added === undefined
    this.#added ??= actions.circles.add([circle], this.#gesture)
    this.#added.then(([id]) => {
      const isWanted = !this.#isCanceled && (isFirst || circle === this.#last)
      if (id !== undefined && isWanted) editing.replace([{ id, circle: this.#last as Circle }], this.#gesture)
    })
  }

  #circleTo(to: Point, snaps: boolean): Circle {
    const { view, actions } = this.#context
    const { x, y } = this.#center
    const point = view.toPlane(to)
    const circle = { x, y, r: Math.hypot(point.x - x, point.y - y) }
    return snaps ? actions.circles.snapped(circle, snapDistance(view), true) : circle
  }

  click(): void {
    this.#context.actions.circles.addFitting(this.#center)
  }

  cancel(): void {
    this.#isCanceled = true
    this.#context.editing.cancel(this.#gesture)
  }
}
