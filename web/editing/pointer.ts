// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../lib/index.ts'
import type { Hit } from '../view/circle-table.ts'
import { pointOf } from '../view/on-screen.ts'
import type { Gesture, GestureContext } from './gestures/gesture.ts'
import { Pinch } from './gestures/pinch.ts'
import {
  gestureOn,
  gestureOnHold,
  gestureOnScroll,
  hitAt,
  MAIN,
  MIDDLE,
  type Press,
  scrollsPage,
} from './gestures/press.ts'
import { showDiscAt } from './gestures/show-disc.ts'

/** A shorter movement counts as a click, in pixels. */
const CLICK_DISTANCE = 4
/** Duration of a long press, in milliseconds. A long press on empty space previews a circle. */
const HOLD = 400

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
  context: GestureContext,
  { letsPageScroll = false }: PointerOptions = {},
): Listening {
  const { view, actions } = context
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

  const hold = (press: Press, begun: Gesture) => {
    // The press may have ended or become another gesture.
    if (hasMoved || gesture !== begun || press.button !== MAIN || press.shiftKey) return
    const next = gestureOnHold(context, press)
    if (next === undefined) return
    begun.cancel?.()
    gesture = next
    hasMoved = true
  }

  const showCursor = (hit: Hit | undefined) => {
    element.dataset.cursor = actions.tools.tool === 'select' ? (hit?.part ?? 'cell') : actions.tools.tool
  }

  const end = (point: Point | undefined) => {
    clearTimeout(holding)
    gesture = undefined
    if (point !== undefined) showCursor(hitAt(view, point, false))
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
      gesture = new Pinch(actions.camera, pressed)
      hasMoved = true
      return
    }
    start = point
    const isFinger = event.pointerType === 'touch'
    const press = { point, isFinger, button: event.button, shiftKey: event.shiftKey, letsPageScroll }
    const isScroll = scrollsPage(context, press)
    isFingerHeld = isFinger && !isScroll
    // Browsers move no focus by a touch that does not scroll; the keys of a slide would stay with the slide.
    if (isFingerHeld && letsPageScroll) element.focus({ preventScroll: true })
    hasMoved = false
    // Fingers cannot hover, so a tap shows the disc that a hovering pointer would, until the next tap.
    if (isFinger) showDiscAt(view, point, true)
    const begun = isScroll ? gestureOnScroll(context, press) : gestureOn(context, press)
    gesture = begun
    // Moves arrive once a frame; wait one before assuming that the pointer rests.
    holding = setTimeout(() => requestAnimationFrame(() => hold(press, begun)), HOLD)
    if (['cell', 'pan'].includes(element.dataset.cursor ?? '')) element.dataset.cursor = 'panning'
  })

  const hover = (point: Point) => {
    showDiscAt(view, point, false)
    const hit = hitAt(view, point, false)
    actions.selection.hover(hit?.id)
    if (actions.tools.tool === 'select' && view.handleAt(point, 0) !== undefined) element.dataset.cursor = 'scale'
    else showCursor(hit)
  }
  /** Updates the hovered circle when the picture changes under a resting pointer. */
  const hoverAgain = () => {
    if (hovering !== undefined && pressed.size === 0 && actions.tools.tool !== 'draw') hover(hovering)
  }
  const unwatch = [view.on('camera', hoverAgain), view.on('changed', hoverAgain)]

  on('pointermove', (event) => {
    const point = pointOf(event)
    if (!pressed.has(event.pointerId)) {
      if (event.pointerType === 'touch') return
      if (actions.tools.tool === 'draw') {
        actions.selection.hover(undefined)
        showCursor(undefined)
        actions.tools.pen?.move(view.toPlane(point))
        return
      }
      hovering = point
      hover(point)
      return
    }
    pressed.set(event.pointerId, point)
    if (hovering !== undefined) hovering = point
    hasMoved ||= Math.hypot(point.x - start.x, point.y - start.y) >= CLICK_DISTANCE
    if (hasMoved) gesture?.move(point, event.altKey !== actions.tools.snaps)
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
    actions.selection.hover(undefined)
    // Fingers leave the element whenever they are lifted.
    if (pointerType !== 'touch') view.showDisc(undefined, 0)
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
    if (actions.tools.tool === 'draw') {
      actions.tools.pen?.close()
      return
    }
    const hit = hitAt(view, point, false)
    if (hit === undefined || hit.part === 'cell') actions.circles.addFitting(view.toPlane(point))
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
      actions.camera.zoom(Math.exp(-pixels * speed), pointOf(event))
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
