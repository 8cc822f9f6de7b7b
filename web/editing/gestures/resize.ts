// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { IdentifiedCircle } from '../arranging.ts'
import { type Gesture, type GestureContext, snapDistance } from './gesture.ts'

/** Drags the rim of a circle, at a constant distance from the pointer. */
export class Resize implements Gesture {
  readonly #context: GestureContext
  readonly #gesture: number
  readonly #held: IdentifiedCircle
  /** The radius at the press, minus the distance of the pointer from the center. */
  readonly #offset: number

  constructor(context: GestureContext, from: Point, held: IdentifiedCircle) {
    this.#context = context
    this.#gesture = context.editing.beginGesture()
    this.#held = held
    this.#offset = held.circle.r - this.#distanceTo(from)
  }

  #distanceTo(point: Point): number {
    const { x, y } = this.#context.view.toPlane(point)
    return Math.hypot(x - this.#held.circle.x, y - this.#held.circle.y)
  }

  move(to: Point, snaps: boolean): void {
    const { view, editing, actions } = this.#context
    const { id, circle } = this.#held
    const resized = { ...circle, r: Math.max(this.#distanceTo(to) + this.#offset, 0) }
    const next = snaps ? actions.circles.snapped(resized, snapDistance(view), true) : resized
    editing.replace([{ id, circle: next }], this.#gesture)
  }

  click(): void {
    this.#context.actions.selection.select([this.#held.id])
  }

  cancel(): void {
    this.#context.editing.cancel(this.#gesture)
  }
}
