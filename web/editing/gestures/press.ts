// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of a gesture on a press.
import type { Point } from '../../lib/index.ts'
import type { Hit } from '../../view/circle-table.ts'
import type { View } from '../../view/view.ts'
import { AddCircle } from './add-circle.ts'
import { Drag } from './drag.ts'
import { DrawRegion } from './draw-region.ts'
import type { Gesture, GestureContext } from './gesture.ts'
import { MovePathEnd } from './move-path-end.ts'
import { OnceMoved } from './once-moved.ts'
import { Pan } from './pan.ts'
import { Resize } from './resize.ts'
import { Scale } from './scale.ts'
import { SelectWithin } from './select-within.ts'
import { ShowDisc } from './show-disc.ts'
import { TryCircle } from './try-circle.ts'

/** Distance that counts as on a rim or a dot, in pixels. */
const MOUSE_SLACK = 5
const FINGER_SLACK = 12
/** Half the width of a finger's target, in pixels. */
const FINGER = 22
/** A finger on more small circles than these is likely to pan. It can drag a selected one. */
const MOST_IN_REACH = 4
/** Duration of the vibration that answers a long press, in milliseconds. */
const VIBRATION = 15

/** A value of `MouseEvent.button`. */
export const MAIN = 0
export const MIDDLE = 1

/** A pressed button or finger. */
export interface Press {
  /** The pixel. */
  readonly point: Point
  readonly isFinger: boolean
  readonly button: number
  readonly shiftKey: boolean
  /** Whether the page around the view may scroll by one finger (`PointerOptions`). */
  readonly letsPageScroll: boolean
}

/** The circle at a pixel. */
export function hitAt(view: View, point: Point, isFinger: boolean): Hit | undefined {
  const [slack, reach] = isFinger ? [FINGER_SLACK, FINGER] : [MOUSE_SLACK, 0]
  return view.hitAt(view.toPlane(point), slack / view.camera.scale, reach / view.camera.scale)
}

/** Whether a finger scrolls the page, because it is not on something draggable. */
export function scrollsPage({ view, actions }: GestureContext, { point, isFinger, letsPageScroll }: Press): boolean {
  if (!isFinger || !letsPageScroll || actions.tools.tool === 'add' || isOnHandle(view, point, FINGER_SLACK))
    return false
  const hit = hitAt(view, point, true)
  return hit === undefined || hit.part === 'cell' || actions.circles.circle(hit.id) === undefined
}

/** The gesture of a finger that scrolls the page: a tap selects. */
export function gestureOnScroll(context: GestureContext, { point }: Press): Gesture {
  return { move() {}, click: () => tap(context, hitAt(context.view, point, true)) }
}

/** The gesture that a press begins, unless it scrolls the page. */
export function gestureOn(context: GestureContext, press: Press): Gesture {
  const { view, actions } = context
  const { point, isFinger, button, shiftKey, letsPageScroll } = press
  const slack = isFinger ? FINGER_SLACK : 0
  if (button === MIDDLE || actions.tools.tool === 'pan') return new Pan(actions.camera, point)
  if (actions.tools.tool === 'add') return new AddCircle(context, point)
  if (actions.tools.tool === 'draw') return new DrawRegion(context, point)
  const pathEnd = view.pathEndAt(point, slack)
  if (pathEnd !== undefined) return new MovePathEnd(view, pathEnd)
  const center = view.handleAt(point, slack)
  if (center !== undefined) return onHandle(context, point, center)

  const hit = hitAt(view, point, isFinger)
  if (shiftKey) return new SelectWithin(context, point, () => hit !== undefined && actions.selection.toggle(hit.id))
  if (hit === undefined) return new Pan(actions.camera, point, () => actions.selection.select([]))
  const { id, part, inReach = 0 } = hit
  const circle = actions.circles.circle(id)
  const isSelected = actions.selection.isSelected(id)
  const isCrowded = inReach > MOST_IN_REACH && !isSelected && !letsPageScroll
  const click = () => (isFinger ? tap(context, hit) : actions.selection.select([id]))
  // A circle that is gone can still be selected.
  if (part === 'cell' || isCrowded || circle === undefined) return new Pan(actions.camera, point, click)
  const grab = () => {
    if (!isSelected) actions.selection.select([id])
    // A finger covers a whole circle, so that it is selected before it is resized.
    const isResized = part === 'rim' && !isSeveral(context) && (!isFinger || isSelected)
    return isResized ? new Resize(context, point, { id, circle }) : new Drag(context, point, id)
  }
  return isFinger ? new OnceMoved(grab, click) : grab()
}

/** The gesture that begins when a press becomes a long press; `undefined` if the present gesture goes on. */
export function gestureOnHold(context: GestureContext, { point, isFinger }: Press): Gesture | undefined {
  const { view, actions } = context
  const { tool } = actions.tools
  const hit = hitAt(view, point, isFinger)
  const isOnCircle = hit !== undefined && hit.part !== 'cell'
  if (isFinger && tool === 'select' && isOnCircle) {
    if (actions.selection.isSelected(hit.id)) return undefined
    actions.selection.toggle(hit.id)
    navigator.vibrate?.(VIBRATION)
    return new Drag(context, point, hit.id)
  }
  const isEmpty =
    tool === 'select' &&
    !isOnHandle(view, point, isFinger ? FINGER_SLACK : 0) &&
    !isOnCircle &&
    actions.circles.fitted(view.toPlane(point)) !== undefined
  if (tool !== 'add' && !isEmpty) return undefined
  const showsDisc = isFinger && view.layers.disc && tool === 'select'
  return showsDisc ? new ShowDisc(view, point) : new TryCircle(context, point)
}

/** The gesture of the selection's handle. */
function onHandle(context: GestureContext, point: Point, center: Point): Gesture {
  const [only, ...others] = context.actions.circles.selectedCircles()
  // A single point has no size to scale, so its radius is dragged instead.
  if (only !== undefined && others.length === 0) return new Resize(context, point, only)
  return new Scale(context, point, center)
}

function isOnHandle(view: View, point: Point, slack: number): boolean {
  return view.pathEndAt(point, slack) !== undefined || view.handleAt(point, slack) !== undefined
}

/** Selects the circle that a finger taps. A tap adds to several selected circles, as there is no Shift key. */
function tap(context: GestureContext, hit: Hit | undefined): void {
  const { actions } = context
  if (hit !== undefined && hit.part !== 'cell' && isSeveral(context)) actions.selection.toggle(hit.id)
  else actions.selection.select(hit === undefined ? [] : [hit.id])
}

function isSeveral({ actions }: GestureContext): boolean {
  return actions.circles.selectedCircles().length > 1
}
