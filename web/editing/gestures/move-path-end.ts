// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { View } from '../../view/view.ts'
import type { Gesture } from './gesture.ts'

/** Drags an end of the path. */
export class MovePathEnd implements Gesture {
  readonly #view: View
  readonly #end: 'from' | 'to'
  readonly #before: Point | undefined

  constructor(view: View, end: 'from' | 'to') {
    this.#view = view
    this.#end = end
    this.#before = view.layers.path?.[end]
  }

  move(to: Point): void {
    this.#view.movePathEnd(this.#end, this.#view.toPlane(to))
  }

  cancel(): void {
    if (this.#before !== undefined) this.#view.movePathEnd(this.#end, this.#before)
  }
}
