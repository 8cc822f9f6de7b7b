// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { View } from '../../view/view.ts'
import type { Gesture } from './gesture.ts'

/** Distance from an edge at which the pointer or a finger shows its disc, in pixels. */
const MOUSE_DISTANCE = 14
const FINGER_DISTANCE = 24

/** Shows the disc at the edge near a resting finger. When the finger moves, the disc follows. */
export class ShowDisc implements Gesture {
  readonly #view: View

  constructor(view: View, from: Point) {
    this.#view = view
    this.move(from)
  }

  move(to: Point): void {
    showDiscAt(this.#view, to, true)
  }
}

/** Shows the disc at the edge near a pixel. */
export function showDiscAt(view: View, point: Point, isFinger: boolean): void {
  view.showDisc(view.toPlane(point), (isFinger ? FINGER_DISTANCE : MOUSE_DISTANCE) / view.camera.scale)
}
