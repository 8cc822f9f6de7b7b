// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { CameraActions } from '../camera-actions.ts'
import type { Gesture } from './gesture.ts'

/** Two fingers keep the points of the plane between them. */
export class Pinch implements Gesture {
  readonly #camera: CameraActions
  readonly #fingers: ReadonlyMap<number, Point>
  #last: Spread

  /** `fingers` has the current positions of both fingers. */
  constructor(camera: CameraActions, fingers: ReadonlyMap<number, Point>) {
    this.#camera = camera
    this.#fingers = fingers
    this.#last = spreadOf(fingers)
  }

  move(): void {
    const next = spreadOf(this.#fingers)
    const { middle, width } = this.#last
    this.#camera.pan(next.middle.x - middle.x, next.middle.y - middle.y)
    this.#camera.zoom(next.width / width, next.middle)
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
