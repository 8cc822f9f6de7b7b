// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/diagram-data.ts'
import type { Point } from '../../lib/index.ts'
import type { Actions } from '../actions.ts'
import { type Size, toPlane } from '../camera.ts'
import { type Hit, hitTest } from '../hit-test.ts'
import { NOBODY, type State } from '../state.ts'
import type { Store } from '../store.ts'

/** How near to a rim or a dot counts as on it, in pixels. */
const MOUSE_SLACK = 5
const TOUCH_SLACK = 12
/** A pointer that moves less than this was a click. */
const CLICK_DISTANCE = 4

/** What a pressed pointer does until it is released. Points are in pixels. */
interface Gesture {
  move(to: Point): void
  /** Released without having moved. */
  click?(): void
}

/** Pointer, wheel and double click on the canvas. */
export function listenToPointer(
  canvas: HTMLCanvasElement,
  store: Store<State>,
  actions: Actions,
  size: () => Size,
): void {
  const pressed = new Map<number, Point>()
  let gesture: Gesture | undefined
  let hasMoved = false
  let start: Point = { x: 0, y: 0 }

  const planeAt = (point: Point) => toPlane(store.get().camera, size(), point)
  const hitAt = (point: Point, pointerType: string): Hit | undefined => {
    const slack = pointerType === 'touch' ? TOUCH_SLACK : MOUSE_SLACK
    return hitTest(store.get().circles, planeAt(point), slack / store.get().camera.scale)
  }

  const pan = (from: Point, click: () => void): Gesture => {
    let last = from
    return {
      move(to) {
        actions.pan(to.x - last.x, to.y - last.y)
        last = to
      },
      click,
    }
  }

  /** The circle keeps its place under the pointer. */
  const moveCircle = (from: Point, circle: number): Gesture => {
    const id = actions.beginGesture()
    const { circles } = store.get()
    const grip = planeAt(from)
    const offsetX = at(circles, 3 * circle) - grip.x
    const offsetY = at(circles, 3 * circle + 1) - grip.y
    const r = at(circles, 3 * circle + 2)
    return {
      move(to) {
        const point = planeAt(to)
        actions.setCircle(circle, point.x + offsetX, point.y + offsetY, r, id)
      },
    }
  }

  /** The rim keeps its distance to the pointer. */
  const resizeCircle = (from: Point, circle: number): Gesture => {
    const id = actions.beginGesture()
    const { circles } = store.get()
    const x = at(circles, 3 * circle)
    const y = at(circles, 3 * circle + 1)
    const distanceTo = (point: Point) => {
      const { x: px, y: py } = planeAt(point)
      return Math.hypot(px - x, py - y)
    }
    const offset = at(circles, 3 * circle + 2) - distanceTo(from)
    return { move: (to) => actions.setCircle(circle, x, y, Math.max(distanceTo(to) + offset, 0), id) }
  }

  /** Press where the centre is to be, drag to the rim. */
  const addCircle = (from: Point): Gesture => {
    const id = actions.beginGesture()
    const center = planeAt(from)
    let index = NOBODY
    return {
      move(to) {
        const point = planeAt(to)
        const r = Math.hypot(point.x - center.x, point.y - center.y)
        if (index === NOBODY) {
          index = store.get().circles.length / 3
          actions.add(center, r, id)
        } else {
          actions.setCircle(index, center.x, center.y, r, id)
        }
      },
      click: () => actions.addFitting(center),
    }
  }

  const pinch = (): Gesture => {
    const spread = () => {
      const [one, other] = [...pressed.values()] as [Point, Point]
      return {
        middle: { x: (one.x + other.x) / 2, y: (one.y + other.y) / 2 },
        width: Math.max(Math.hypot(one.x - other.x, one.y - other.y), 1),
      }
    }
    let last = spread()
    return {
      move() {
        const next = spread()
        actions.pan(next.middle.x - last.middle.x, next.middle.y - last.middle.y)
        actions.zoom(next.width / last.width, next.middle)
        last = next
      },
    }
  }

  const gestureAt = (point: Point, pointerType: string): Gesture => {
    if (store.get().isAdding) return addCircle(point)
    const hit = hitAt(point, pointerType)
    if (hit === undefined || hit.part === 'cell') return pan(point, () => actions.select(hit?.circle ?? NOBODY))
    actions.select(hit.circle)
    return hit.part === 'rim' ? resizeCircle(point, hit.circle) : moveCircle(point, hit.circle)
  }

  const showCursor = (point: Point, pointerType: string) => {
    canvas.dataset.cursor = store.get().isAdding ? 'add' : (hitAt(point, pointerType)?.part ?? 'cell')
  }

  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || pressed.size === 2) return
    canvas.setPointerCapture(event.pointerId)
    const point = pointOf(event)
    pressed.set(event.pointerId, point)
    if (pressed.size === 2) {
      gesture = pinch()
      hasMoved = true
      return
    }
    start = point
    hasMoved = false
    gesture = gestureAt(point, event.pointerType)
    if (canvas.dataset.cursor === 'cell') canvas.dataset.cursor = 'pan'
  })

  canvas.addEventListener('pointermove', (event) => {
    const point = pointOf(event)
    if (!pressed.has(event.pointerId)) {
      if (event.pointerType === 'touch') return
      actions.hover(hitAt(point, event.pointerType)?.circle ?? NOBODY)
      showCursor(point, event.pointerType)
      return
    }
    pressed.set(event.pointerId, point)
    hasMoved ||= Math.hypot(point.x - start.x, point.y - start.y) >= CLICK_DISTANCE
    if (hasMoved) gesture?.move(point)
  })

  const release = (event: PointerEvent) => {
    if (!pressed.delete(event.pointerId)) return
    if (!hasMoved && event.type === 'pointerup') gesture?.click?.()
    gesture = undefined
    showCursor(pointOf(event), event.pointerType)
  }
  canvas.addEventListener('pointerup', release)
  canvas.addEventListener('pointercancel', release)
  canvas.addEventListener('pointerleave', () => actions.hover(NOBODY))

  canvas.addEventListener('dblclick', (event) => {
    const point = pointOf(event)
    const hit = hitAt(point, 'mouse')
    if (hit === undefined || hit.part === 'cell') actions.addFitting(planeAt(point))
  })

  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault()
      // A pinch on a touchpad arrives as a wheel with the control key and small steps.
      const speed = event.ctrlKey ? 0.01 : 0.0016
      const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY
      actions.zoom(Math.exp(-pixels * speed), pointOf(event))
    },
    { passive: false },
  )
}

function pointOf(event: MouseEvent): Point {
  return { x: event.offsetX, y: event.offsetY }
}
