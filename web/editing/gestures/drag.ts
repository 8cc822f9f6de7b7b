// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Point } from '../../lib/index.ts'
import type { IdentifiedCircle } from '../arranging.ts'
import { type Gesture, type GestureContext, snapDistance } from './gesture.ts'

/** Drags the selected circles. The circle under the pointer snaps. */
export class Drag implements Gesture {
  readonly #context: GestureContext
  readonly #gesture: number
  readonly #id: number
  readonly #held: readonly IdentifiedCircle[]
  /** The circle under the pointer. */
  readonly #grabbed: IdentifiedCircle | undefined
  readonly #from: Point

  constructor(context: GestureContext, from: Point, id: number) {
    this.#context = context
    this.#gesture = context.editing.beginGesture()
    this.#id = id
    this.#held = context.actions.circles.selectedCircles()
    this.#grabbed = this.#held.find((other) => other.id === id)
    this.#from = context.view.toPlane(from)
  }

  move(to: Point, snaps: boolean): void {
    const { view, editing, actions } = this.#context
    const point = view.toPlane(to)
    let [dx, dy] = [point.x - this.#from.x, point.y - this.#from.y]
    const movedBy = (circle: Circle) => ({ ...circle, x: circle.x + dx, y: circle.y + dy })
    const grabbed = this.#grabbed
    const snapped =
      grabbed && snaps ? actions.circles.snapped(movedBy(grabbed.circle), snapDistance(view), false) : undefined
    if (grabbed && snapped) [dx, dy] = [snapped.x - grabbed.circle.x, snapped.y - grabbed.circle.y]
    const moved = this.#held.map((held) => ({
      id: held.id,
      circle: held === grabbed && snapped ? snapped : movedBy(held.circle),
    }))
    editing.replace(moved, this.#gesture)
  }

  /** A click without a drag selects only this circle. */
  click(): void {
    this.#context.actions.selection.select([this.#id])
  }

  cancel(): void {
    this.#context.editing.cancel(this.#gesture)
  }
}
