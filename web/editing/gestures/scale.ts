// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import { type IdentifiedCircle, scaled } from '../arranging.ts'
import type { Gesture, GestureContext } from './gesture.ts'

/** Scales the selected circles by the pointer's distance from a center. */
export class Scale implements Gesture {
  readonly #context: GestureContext
  readonly #gesture: number
  readonly #held: readonly IdentifiedCircle[]
  readonly #center: Point
  readonly #distance: number

  constructor(context: GestureContext, from: Point, center: Point) {
    this.#context = context
    this.#gesture = context.editing.beginGesture()
    this.#held = context.actions.circles.selectedCircles()
    this.#center = center
    this.#distance = this.#distanceTo(from)
  }

  #distanceTo(point: Point): number {
    const { x, y } = this.#context.view.toPlane(point)
    return Math.hypot(x - this.#center.x, y - this.#center.y)
  }

  move(to: Point): void {
    const factor = this.#distanceTo(to) / this.#distance
    const moved = this.#held.map(({ id, circle }) => ({ id, circle: scaled(circle, this.#center, factor) }))
    this.#context.editing.replace(moved, this.#gesture)
  }

  cancel(): void {
    this.#context.editing.cancel(this.#gesture)
  }
}
