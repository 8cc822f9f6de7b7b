// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../lib/index.ts'
import { toPlane } from './camera.ts'
import type { Hit } from './circle-table.ts'
import { type Gesture, type GestureTarget, gesturesOf } from './gestures.ts'
import { pointOf } from './on-screen.ts'
import type { View } from './view.ts'

/** Distance that counts as on a rim or a dot, in pixels. */
const MOUSE_SLACK = 5
const TOUCH_SLACK = 12
/** Half the width of a finger's target, in pixels. */
const FINGER = 22
/** A finger on more small circles than these is likely to pan. It can drag a selected one. */
const MOST_IN_REACH = 4
/** Distance from an edge at which the pointer or a finger shows its disc, in pixels. */
const DISC_SLACK = 14
const TOUCH_DISC_SLACK = 24
/** A shorter movement counts as a click, in pixels. */
const CLICK_DISTANCE = 4
/** Duration of a long press, in milliseconds. A long press on empty space previews a circle. */
const HOLD = 400
/** Duration of the vibration that answers a long press, in milliseconds. */
const VIBRATION = 15
/** A value of `MouseEvent.button`. */
const MAIN = 0
const MIDDLE = 1

/** The pointer listeners of a view. */
export interface Listening {
  /** Whether a button or a finger is down. */
  readonly isPressed: boolean
  stop(): void
}

/** The interplay of a view with the scrolling page around it. */
export interface PointerOptions {
  /**
   * Lets the page scroll: by the wheel, unless the view was pressed before or Ctrl is held, and by one finger, unless it
   * is on something draggable. The element's `touch-action` must allow scrolling.
   */
  readonly letsPageScroll?: boolean
}

/** Listens to pointer, wheel and double click on a view's element. */
export function listenToPointer(
  element: HTMLElement,
  view: View,
  target: GestureTarget,
  { letsPageScroll = false }: PointerOptions = {},
): Listening {
  const pressed = new Map<number, Point>()
  let gesture: Gesture | undefined
  let hasMoved = false
  let start: Point = { x: 0, y: 0 }
  let holding: ReturnType<typeof setTimeout> | undefined
  /** Whether the view uses the wheel. */
  let isActive = !letsPageScroll
  /** The position of the pointer above the element without a press. */
  let hovering: Point | undefined
  /** Whether the first finger drags something; otherwise the page scrolls. */
  let isFingerHeld = false
  /** Whether touch events are suppressed. They arrive after the pointer events. */
  let isTouchKept = false
  /** The event that ended the last press. */
  let released: Event | undefined

  const gestures = gesturesOf(view, target)
  const planeAt = (point: Point) => toPlane(view.camera, view.size, point)
  const hitAt = (point: Point, pointerType: string): Hit | undefined => {
    const [slack, reach] = pointerType === 'touch' ? [TOUCH_SLACK, FINGER] : [MOUSE_SLACK, 0]
    return view.hitAt(planeAt(point), slack / view.camera.scale, reach / view.camera.scale)
  }

  const gestureAt = (point: Point, { pointerType, shiftKey }: PointerEvent): Gesture => {
    const hit = hitAt(point, pointerType)
    const circle = hit === undefined ? undefined : target.circle(hit.id)
    if (shiftKey) return gestures.band(point, () => hit !== undefined && target.toggle(hit.id))
    if (hit === undefined) return gestures.pan(point, () => target.select([]))
    const { id, part, inReach = 0 } = hit
    const isTouch = pointerType === 'touch'
    const isSelected = target.isSelected(id)
    const isCrowded = inReach > MOST_IN_REACH && !isSelected && !letsPageScroll
    // A tap adds to several selected circles, as there is no Shift key.
    const tap = () => (isTouch && part !== 'cell' && isSeveral() ? target.toggle(id) : target.select([id]))
    // A circle that is gone can still be selected.
    if (part === 'cell' || isCrowded || circle === undefined) return gestures.pan(point, tap)
    const grab = () => {
      if (!isSelected) target.select([id])
      const isOne = target.selectedCircles().length === 1
      // A finger covers a whole circle, so that it is selected before it is resized.
      const isResized = part === 'rim' && isOne && (!isTouch || isSelected)
      return isResized ? gestures.resizeCircle(point, id, circle) : gestures.moveCircles(point, id)
    }
    return isTouch ? gestures.onceMoved(grab, tap) : grab()
  }

  const isSeveral = () => target.selectedCircles().length > 1

  /** Whether a finger drags something instead of scrolling the page. */
  const isHeld = (point: Point): boolean => {
    if (!letsPageScroll || target.tool === 'add' || isOnHandle(point, TOUCH_SLACK)) return true
    const hit = hitAt(point, 'touch')
    return hit !== undefined && hit.part !== 'cell' && target.circle(hit.id) !== undefined
  }

  const isOnHandle = (point: Point, slack: number): boolean =>
    view.pathEndAt(point, slack) !== undefined || view.handleAt(point, slack) !== undefined

  const select = (point: Point) => {
    const hit = hitAt(point, 'touch')
    if (hit !== undefined && hit.part !== 'cell' && isSeveral()) target.toggle(hit.id)
    else target.select(hit === undefined ? [] : [hit.id])
  }

  const begin = (point: Point, event: PointerEvent): Gesture => {
    const isTouch = event.pointerType === 'touch'
    if (isTouch && !isFingerHeld) return { move() {}, click: () => select(point) }
    const pathEnd = view.pathEndAt(point, isTouch ? TOUCH_SLACK : 0)
    const scaling = view.handleAt(point, isTouch ? TOUCH_SLACK : 0)
    if (event.button === MIDDLE || target.tool === 'pan') return gestures.pan(point, () => {})
    if (target.tool === 'add') return gestures.addCircle(point)
    if (target.tool === 'draw') return gestures.drawCorner(point)
    if (pathEnd !== undefined) return gestures.movePathEnd(pathEnd)
    if (scaling !== undefined) return gestures.scaleCircles(point, scaling)
    return gestureAt(point, event)
  }

  /** Whether a long press is on empty space, without a circle or handle. */
  const isEmpty = (point: Point, { pointerType }: PointerEvent): boolean => {
    if (target.tool === 'add') return true
    if (target.tool !== 'select' || isOnHandle(point, pointerType === 'touch' ? TOUCH_SLACK : 0)) return false
    const hit = hitAt(point, pointerType)
    return (hit === undefined || hit.part === 'cell') && target.fitted(planeAt(point)) !== undefined
  }

  /** A long press by a finger adds a circle to the selection. Returns whether the finger is on a circle. */
  const holdSelects = (point: Point, event: PointerEvent): boolean => {
    if (event.pointerType !== 'touch' || target.tool !== 'select') return false
    const hit = hitAt(point, event.pointerType)
    if (hit === undefined || hit.part === 'cell') return false
    if (target.isSelected(hit.id)) return true
    target.toggle(hit.id)
    navigator.vibrate?.(VIBRATION)
    gesture = gestures.moveCircles(point, hit.id)
    hasMoved = true
    return true
  }

  const hold = (point: Point, event: PointerEvent, begun: Gesture) => {
    // The press may have ended or become another gesture.
    if (hasMoved || gesture !== begun || event.button !== MAIN || event.shiftKey) return
    if (holdSelects(point, event) || !isEmpty(point, event)) return
    begun.cancel?.()
    const showsDisc = event.pointerType === 'touch' && view.layers.disc && target.tool === 'select'
    gesture = showsDisc ? showDisc(point) : gestures.holdCircle(point)
    hasMoved = true
  }

  /** A resting finger shows a disc; when it moves, the disc follows. */
  const showDisc = (from: Point): Gesture => {
    const show = (point: Point) => view.touch(planeAt(point), TOUCH_DISC_SLACK / view.camera.scale)
    show(from)
    return { move: show }
  }

  const showCursor = (hit: Hit | undefined) => {
    element.dataset.cursor = target.tool === 'select' ? (hit?.part ?? 'cell') : target.tool
  }

  const end = (point: Point | undefined) => {
    clearTimeout(holding)
    gesture = undefined
    if (point !== undefined) showCursor(hitAt(point, 'mouse'))
  }

  const cancel = () => {
    gesture?.cancel?.()
    end(undefined)
  }

  const listeners = new AbortController()
  const on = <Name extends keyof HTMLElementEventMap>(
    name: Name,
    listener: (event: HTMLElementEventMap[Name]) => void,
    options: AddEventListenerOptions = {},
  ) => element.addEventListener(name, listener, { ...options, signal: listeners.signal })

  /** Stops the view's own gestures from reaching a page with gestures of its own, such as slides and carousels. */
  const keepHere = (event: MouseEvent) => {
    const isTouch = 'pointerType' in event && event.pointerType === 'touch'
    const isPressed = pressed.size > 0 || released === event
    const isScroll = isTouch && pressed.size < 2 && !isFingerHeld
    if (isPressed && !isScroll) event.stopPropagation()
  }

  on('pointerdown', (event) => {
    isActive = true
    if (![MAIN, MIDDLE].includes(event.button) || pressed.size === 2) return
    // The middle button would start autoscrolling.
    if (event.button === MIDDLE) event.preventDefault()
    element.setPointerCapture(event.pointerId)
    const point = pointOf(event)
    pressed.set(event.pointerId, point)
    if (pressed.size === 2) {
      cancel()
      gesture = gestures.pinch(pressed)
      hasMoved = true
      return
    }
    start = point
    isFingerHeld = event.pointerType === 'touch' && isHeld(point)
    // Browsers move no focus by a touch that does not scroll; the keys of a slide would stay with the slide.
    if (isFingerHeld && letsPageScroll) element.focus({ preventScroll: true })
    hasMoved = false
    // Fingers cannot hover, so a tap shows the disc that a hovering pointer would, until the next tap.
    if (event.pointerType === 'touch') view.touch(planeAt(point), TOUCH_DISC_SLACK / view.camera.scale)
    const begun = begin(point, event)
    gesture = begun
    // Moves arrive once a frame; wait one before assuming that the pointer rests.
    holding = setTimeout(() => requestAnimationFrame(() => hold(point, event, begun)), HOLD)
    if (['cell', 'pan'].includes(element.dataset.cursor ?? '')) element.dataset.cursor = 'panning'
  })

  const hover = (point: Point) => {
    view.touch(planeAt(point), DISC_SLACK / view.camera.scale)
    const hit = hitAt(point, 'mouse')
    target.hover(hit?.id)
    if (target.tool === 'select' && view.handleAt(point, 0) !== undefined) element.dataset.cursor = 'scale'
    else showCursor(hit)
  }
  /** Updates the hovered circle when the picture changes under a resting pointer. */
  const hoverAgain = () => {
    if (hovering !== undefined && pressed.size === 0 && target.tool !== 'draw') hover(hovering)
  }
  const unwatch = [view.on('camera', hoverAgain), view.on('changed', hoverAgain)]

  on('pointermove', (event) => {
    const point = pointOf(event)
    if (!pressed.has(event.pointerId)) {
      if (event.pointerType === 'touch') return
      if (target.tool === 'draw') {
        target.hover(undefined)
        showCursor(undefined)
        target.draw?.('move', planeAt(point), 0)
        return
      }
      hovering = point
      hover(point)
      return
    }
    pressed.set(event.pointerId, point)
    if (hovering !== undefined) hovering = point
    hasMoved ||= Math.hypot(point.x - start.x, point.y - start.y) >= CLICK_DISTANCE
    if (hasMoved) gesture?.move(point, event.altKey !== target.snaps)
  })

  on('pointerup', (event) => {
    if (!pressed.delete(event.pointerId)) return
    released = event
    if (hasMoved) gesture?.end?.()
    else gesture?.click?.()
    end(pointOf(event))
  })
  // Also called if another element or the system captures the pointer.
  const lose = ({ pointerId }: PointerEvent) => {
    if (pressed.delete(pointerId)) cancel()
  }
  on('pointercancel', lose)
  on('lostpointercapture', lose)
  // A long press would open the browser's menu.
  on('contextmenu', (event) => {
    if (pressed.size > 0) event.preventDefault()
  })
  on('pointerleave', ({ pointerType }) => {
    isActive = !letsPageScroll
    hovering = undefined
    target.hover(undefined)
    // Fingers leave the element whenever they are lifted.
    if (pointerType !== 'touch') view.touch(undefined, 0)
  })
  on('keydown', (event) => {
    if (event.key === 'Escape' && gesture !== undefined) {
      event.preventDefault()
      event.stopImmediatePropagation()
      cancel()
    }
  })

  on('dblclick', (event) => {
    const point = pointOf(event)
    if (target.tool === 'draw') {
      target.draw?.('close', planeAt(point), 0)
      return
    }
    const hit = hitAt(point, 'mouse')
    if (hit === undefined || hit.part === 'cell') target.addFitting(planeAt(point))
  })

  // Scrolling must be prevented at touchstart, which follows the pointer event.
  const keepTouch = (event: TouchEvent) => {
    isTouchKept = event.touches.length > 1 || (pressed.size > 0 && isFingerHeld)
    if (isTouchKept && event.cancelable) event.preventDefault()
    keepTouchHere(event)
  }
  const keepTouchHere = (event: TouchEvent) => {
    if (isTouchKept) event.stopPropagation()
  }
  if (letsPageScroll) {
    on('touchstart', keepTouch, { passive: false })
    for (const name of ['touchmove', 'touchend', 'touchcancel'] as const) on(name, keepTouchHere)
    for (const name of ['pointerdown', 'pointermove', 'pointerup', 'pointercancel', 'mousedown'] as const)
      on(name, keepHere)
  }

  on(
    'wheel',
    (event) => {
      if (!isActive && !event.ctrlKey) return
      event.preventDefault()
      if (letsPageScroll) event.stopPropagation()
      // A pinch on a touchpad arrives as a wheel with the control key and small steps.
      const speed = event.ctrlKey ? 0.01 : 0.0016
      const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY
      target.zoom(Math.exp(-pixels * speed), pointOf(event))
    },
    { passive: false },
  )
  return {
    get isPressed() {
      return pressed.size > 0
    },
    stop() {
      listeners.abort()
      for (const end of unwatch) end()
      hovering = undefined
      end(undefined)
    },
  }
}
