// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Point } from '../lib/index.ts'
import { panned, toPlane } from './camera.ts'
import type { Hit } from './protocol.ts'
import type { View } from './view.ts'

/** How near to a rim or a dot counts as on it, in pixels. */
const MOUSE_SLACK = 5
const TOUCH_SLACK = 12
/** How near to an edge the pointer shows its disc. */
const DISC_SLACK = 14
/** A pointer that moves less than this was a click. */
const CLICK_DISTANCE = 4

/** What the gestures of a view do to its circles. */
export interface Hands {
  /** Whether what is pressed next becomes a circle. */
  readonly isAdding: boolean
  /** A circle as it is now. */
  circle(id: number): Circle | undefined
  /** A number for what belongs to one gesture: one step of undo. */
  beginGesture(): number
  select(id: number | undefined): void
  hover(id: number | undefined): void
  set(id: number, circle: Circle, gesture: number): void
  /** Adds a circle and returns its id; `undefined` if it was refused. */
  add(circle: Circle, gesture: number): Promise<number | undefined>
  /** Adds a circle that leaves some room to the nearest other one. */
  addFitting(center: Point): Promise<void>
  /** Takes back what a gesture did. */
  cancel(gesture: number): void
  /** `factor`: how much larger everything is to be; `anchor`: the pixel that stays where it is. */
  zoom(factor: number, anchor: Point): void
}

/** What a pressed pointer does until it is released. Points are in pixels. */
interface Gesture {
  move(to: Point): void
  /** Released without having moved. */
  click?(): void
  cancel?(): void
}

/** What listens to a pointer. */
export interface Listening {
  /** Ends once all that the pointer has done is done; `undefined` if it is, as what it pressed is known. */
  readonly pending: Promise<unknown> | undefined
  stop(): void
}

/** Pointer, wheel and double click on the element of a view. */
export function listenToPointer(element: HTMLElement, view: View, hands: Hands): Listening {
  const pressed = new Map<number, Point>()
  let gesture: Gesture | undefined
  let hasMoved = false
  let start: Point = { x: 0, y: 0 }
  /** What was pressed and is not known yet. */
  let pending: Promise<unknown> | undefined

  const planeAt = (point: Point) => toPlane(view.camera, view.size, point)
  const hitAt = (point: Point, pointerType: string): Promise<Hit | undefined> => {
    const { x, y } = planeAt(point)
    return view.hit(x, y, (pointerType === 'touch' ? TOUCH_SLACK : MOUSE_SLACK) / view.camera.scale)
  }

  const pan = (from: Point, click: () => void): Gesture => {
    let last = from
    return {
      move(to) {
        view.setCamera(panned(view.camera, to.x - last.x, to.y - last.y))
        last = to
      },
      click,
    }
  }

  /** The circle keeps its place under the pointer. */
  const moveCircle = (from: Point, id: number, { x, y, r }: Circle): Gesture => {
    const gesture = hands.beginGesture()
    const grip = planeAt(from)
    return {
      move(to) {
        const point = planeAt(to)
        hands.set(id, { x: x + point.x - grip.x, y: y + point.y - grip.y, r }, gesture)
      },
      cancel: () => hands.cancel(gesture),
    }
  }

  /** The rim keeps its distance to the pointer. */
  const resizeCircle = (from: Point, id: number, { x, y, r }: Circle): Gesture => {
    const gesture = hands.beginGesture()
    const distanceTo = (point: Point) => {
      const { x: px, y: py } = planeAt(point)
      return Math.hypot(px - x, py - y)
    }
    const offset = r - distanceTo(from)
    return {
      move: (to) => hands.set(id, { x, y, r: Math.max(distanceTo(to) + offset, 0) }, gesture),
      cancel: () => hands.cancel(gesture),
    }
  }

  /** Press where the centre is to be, drag to the rim. */
  const addCircle = (from: Point): Gesture => {
    const gesture = hands.beginGesture()
    const { x, y } = planeAt(from)
    let added: Promise<number | undefined> | undefined
    let last = from
    const circleTo = (to: Point): Circle => {
      const point = planeAt(to)
      return { x, y, r: Math.hypot(point.x - x, point.y - y) }
    }
    return {
      move(to) {
        last = to
        if (added === undefined) {
          added = hands.add(circleTo(to), gesture)
          added.then((id) => id !== undefined && hands.set(id, circleTo(last), gesture))
        } else {
          added.then((id) => id !== undefined && to === last && hands.set(id, circleTo(to), gesture))
        }
      },
      click: () => hands.addFitting({ x, y }),
      cancel: () => hands.cancel(gesture),
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
        view.setCamera(panned(view.camera, next.middle.x - last.middle.x, next.middle.y - last.middle.y))
        hands.zoom(next.width / last.width, next.middle)
        last = next
      },
    }
  }

  const wait = (known: Promise<unknown>) => {
    const all = Promise.all([pending, known]).finally(() => {
      if (pending === all) pending = undefined
    })
    pending = all
  }

  /** What is under the pointer is known a moment later: until then what it does is kept. */
  const whenKnown = (begun: Promise<Gesture>): Gesture => {
    let known: Gesture | undefined
    let last: Point | undefined
    let isCancelled = false
    const then = begun.then((gesture) => {
      known = gesture
      if (last !== undefined && !isCancelled) gesture.move(last)
      return gesture
    })
    wait(then)
    return {
      move(to) {
        if (known === undefined) last = to
        else known.move(to)
      },
      click: () => wait(then.then((gesture) => gesture.click?.())),
      cancel() {
        isCancelled = true
        known?.cancel?.()
      },
    }
  }

  const movePathEnd = (end: 'from' | 'to'): Gesture => {
    const before = view.layers.path?.[end]
    return {
      move: (to) => view.movePathEnd(end, planeAt(to)),
      cancel: () => before !== undefined && view.movePathEnd(end, before),
    }
  }

  const gestureAt = async (point: Point, pointerType: string): Promise<Gesture> => {
    const hit = await hitAt(point, pointerType)
    const circle = hit === undefined ? undefined : hands.circle(hit.id)
    if (hit === undefined || circle === undefined) return pan(point, () => hands.select(undefined))
    if (hit.part === 'cell') return pan(point, () => hands.select(hit.id))
    hands.select(hit.id)
    return hit.part === 'rim' ? resizeCircle(point, hit.id, circle) : moveCircle(point, hit.id, circle)
  }

  const showCursor = (hit: Hit | undefined) => {
    element.dataset.cursor = hands.isAdding ? 'add' : (hit?.part ?? 'cell')
  }

  const end = (point: Point | undefined) => {
    gesture = undefined
    if (point !== undefined) hitAt(point, 'mouse').then(showCursor)
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

  on('pointerdown', (event) => {
    if (event.button !== 0 || pressed.size === 2) return
    element.setPointerCapture(event.pointerId)
    const point = pointOf(event)
    pressed.set(event.pointerId, point)
    if (pressed.size === 2) {
      cancel()
      gesture = pinch()
      hasMoved = true
      return
    }
    start = point
    hasMoved = false
    const pathEnd = view.pathEndAt(point, event.pointerType === 'touch' ? TOUCH_SLACK : 0)
    if (hands.isAdding) gesture = addCircle(point)
    else if (pathEnd !== undefined) gesture = movePathEnd(pathEnd)
    else gesture = whenKnown(gestureAt(point, event.pointerType))
    if (element.dataset.cursor === 'cell') element.dataset.cursor = 'pan'
  })

  on('pointermove', (event) => {
    const point = pointOf(event)
    if (!pressed.has(event.pointerId)) {
      if (event.pointerType === 'touch') return
      view.touch(planeAt(point), DISC_SLACK / view.camera.scale)
      hitAt(point, event.pointerType).then((hit) => {
        if (pressed.size > 0) return
        hands.hover(hit?.id)
        showCursor(hit)
      })
      return
    }
    pressed.set(event.pointerId, point)
    hasMoved ||= Math.hypot(point.x - start.x, point.y - start.y) >= CLICK_DISTANCE
    if (hasMoved) gesture?.move(point)
  })

  on('pointerup', (event) => {
    if (!pressed.delete(event.pointerId)) return
    if (!hasMoved) gesture?.click?.()
    end(pointOf(event))
  })
  // Also where another element or the system takes the pointer away.
  const lose = ({ pointerId }: PointerEvent) => {
    if (pressed.delete(pointerId)) cancel()
  }
  on('pointercancel', lose)
  on('lostpointercapture', lose)
  on('pointerleave', () => {
    hands.hover(undefined)
    view.touch(undefined, 0)
  })
  on('keydown', (event) => {
    if (event.key === 'Escape' && gesture !== undefined) {
      event.preventDefault()
      event.stopImmediatePropagation()
      cancel()
    }
  })

  const addAt = async (point: Point) => {
    const hit = await hitAt(point, 'mouse')
    if (hit === undefined || hit.part === 'cell') await hands.addFitting(planeAt(point))
  }
  on('dblclick', (event) => wait(addAt(pointOf(event))))

  on(
    'wheel',
    (event) => {
      event.preventDefault()
      // A pinch on a touchpad arrives as a wheel with the control key and small steps.
      const speed = event.ctrlKey ? 0.01 : 0.0016
      const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY
      hands.zoom(Math.exp(-pixels * speed), pointOf(event))
    },
    { passive: false },
  )
  return {
    get pending() {
      return pending
    },
    stop: () => listeners.abort(),
  }
}

function pointOf(event: MouseEvent): Point {
  return { x: event.offsetX, y: event.offsetY }
}
