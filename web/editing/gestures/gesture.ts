// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../lib/index.ts'
import type { View } from '../../view/view.ts'
import type { Editing } from '../editing.ts'
import type { FigureActions } from '../figure-actions.ts'

/** Distance at which snapping acts, in pixels. */
const SNAP_DISTANCE = 8

/** The figure that gestures act on. */
export interface GestureContext {
  readonly view: View
  readonly editing: Editing
  readonly actions: FigureActions
}

/** The effects of a pressed pointer until its release. Points are in pixels. */
export interface Gesture {
  move(to: Point, snaps: boolean): void
  /** Called on release if the pointer did not move. */
  click?(): void
  /** Called on release after a move. */
  end?(): void
  cancel?(): void
}

/** The distance at which snapping acts, in units. */
export function snapDistance({ camera }: View): number {
  return SNAP_DISTANCE / camera.scale
}
