// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import { panned } from '../../view/camera.ts'
import type { Gesture, GestureContext } from './gesture.ts'

/** Two fingers keep the points of the plane between them. */
export class Pinch implements Gesture {
  readonly #context: GestureContext
  readonly #fingers: ReadonlyMap<number, Point>
  #last: Spread

  /** `fingers` has the current positions of both fingers. */
  constructor(context: GestureContext, fingers: ReadonlyMap<number, Point>) {
    this.#context = context
    this.#fingers = fingers
    this.#last = spreadOf(fingers)
  }

  move(): void {
    const { view, actions } = this.#context
    const next = spreadOf(this.#fingers)
    const { middle, width } = this.#last
    view.setCamera(panned(view.camera, next.middle.x - middle.x, next.middle.y - middle.y))
    actions.camera.zoom(next.width / width, next.middle)
    this.#last = next
  }
}

/** The middle between two fingers, and their distance. */
interface Spread {
  readonly middle: Point
  readonly width: number
}

function spreadOf(fingers: ReadonlyMap<number, Point>): Spread {
  const [one, other] = [...fingers.values()] as [Point, Point]
  return {
    middle: { x: (one.x + other.x) / 2, y: (one.y + other.y) / 2 },
    width: Math.max(Math.hypot(one.x - other.x, one.y - other.y), 1),
  }
}
