// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { CameraActions } from '../camera-actions.ts'
import type { Gesture } from './gesture.ts'

/** Moves the plane with the pointer. */
export class Pan implements Gesture {
  readonly #camera: CameraActions
  readonly click: () => void
  #last: Point

  constructor(camera: CameraActions, from: Point, click: () => void = () => {}) {
    this.#camera = camera
    this.#last = from
    this.click = click
  }

  move(to: Point): void {
    this.#camera.pan(to.x - this.#last.x, to.y - this.#last.y)
    this.#last = to
  }
}
