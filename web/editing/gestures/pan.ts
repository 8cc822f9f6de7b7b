// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import { panned } from '../../view/camera.ts'
import type { View } from '../../view/view.ts'
import type { Gesture } from './gesture.ts'

/** Moves the plane with the pointer. */
export class Pan implements Gesture {
  readonly #view: View
  readonly click: () => void
  #last: Point

  constructor(view: View, from: Point, click: () => void = () => {}) {
    this.#view = view
    this.#last = from
    this.click = click
  }

  move(to: Point): void {
    this.#view.setCamera(panned(this.#view.camera, to.x - this.#last.x, to.y - this.#last.y))
    this.#last = to
  }
}
