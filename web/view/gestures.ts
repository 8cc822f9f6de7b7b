// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Circle, Point } from '../lib/index.ts'
import { panned, toPlane } from './camera.ts'
import type { View } from './view.ts'

/** What snaps moves at most so far, in pixels. */
const SNAP_DISTANCE = 8

/** A circle and its number. */
export interface Held {
  readonly id: number
  readonly circle: Circle
}

/** A corner is about to be somewhere, or is there, or it was the last one. */
export type Drawn = 'move' | 'place' | 'close'

/** What the gestures of a view do to its circles. */
export interface Hands {
  /** What a press does: `add`: it becomes a circle. */
  readonly tool: 'select' | 'pan' | 'add' | 'draw'
  /** What the tool `draw` does at a point; what lies `within` so many units is the same point. */
  draw?(how: Drawn, point: Point, within: number): void
  /** Whether dragged circles snap without a key. */
  readonly snaps: boolean
  /** A circle as it is now; `undefined`: there is none, or it is not to be changed. */
  circle(id: number): Circle | undefined
  /** Those that are selected. */
  held(): readonly Held[]
  isSelected(id: number): boolean
  select(ids: readonly number[]): void
  /** Selects a circle beside the others, or no longer. */
  toggle(id: number): void
  /** Selects the circles in a box beside the others. */
  selectWithin(box: Box): void
  hover(id: number | undefined): void
  /** A number for what belongs to one gesture: one step of undo. */
  beginGesture(): number
  set(circles: readonly Held[], gesture: number): void
  /** A circle moved at most so far, in units, to where it touches others or to a grid; `sizes`: made larger or smaller. */
  snapped(circle: Circle, within: number, sizes: boolean): Circle
  /** Adds circles and returns their ids; none if they were refused. */
  add(circles: readonly Circle[], gesture: number): Promise<readonly number[]>
  /** A circle that leaves some room to the nearest other one; `undefined`: none can be added. */
  fitted(center: Point): Promise<Circle | undefined>
  /** Adds that circle. */
  addFitting(center: Point): Promise<void>
  /** Takes back what a gesture did. */
  cancel(gesture: number): void
  /** `factor`: how much larger everything is to be; `anchor`: the pixel that stays where it is. */
  zoom(factor: number, anchor: Point): void
}

/** What a pressed pointer does until it is released. Points are in pixels. */
export interface Gesture {
  move(to: Point, snaps: boolean): void
  /** Released without having moved. */
  click?(): void
  /** Released after it has moved. */
  end?(): unknown
  cancel?(): void
}

/** The gestures, each begun at a pixel. */
export function gesturesOf(view: View, hands: Hands) {
  const planeAt = (point: Point) => toPlane(view.camera, view.size, point)
  const within = () => SNAP_DISTANCE / view.camera.scale

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

  /** The selected circles keep their places under the pointer; `id`: the one that is grabbed, and snaps. */
  const moveCircles = (from: Point, id: number): Gesture => {
    const gesture = hands.beginGesture()
    const held = hands.held()
    const grip = planeAt(from)
    return {
      move(to, snaps) {
        const point = planeAt(to)
        const movedBy = (circle: Circle, dx: number, dy: number) => ({ ...circle, x: circle.x + dx, y: circle.y + dy })
        let [dx, dy] = [point.x - grip.x, point.y - grip.y]
        const grabbed = held.find((other) => other.id === id)
        const place = grabbed && snaps ? hands.snapped(movedBy(grabbed.circle, dx, dy), within(), false) : undefined
        if (grabbed && place) [dx, dy] = [place.x - grabbed.circle.x, place.y - grabbed.circle.y]
        const moved = held.map((other) => ({
          id: other.id,
          circle: other === grabbed && place ? place : movedBy(other.circle, dx, dy),
        }))
        hands.set(moved, gesture)
      },
      // Of several, one.
      click: () => hands.select([id]),
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
      move(to, snaps) {
        const circle = { x, y, r: Math.max(distanceTo(to) + offset, 0) }
        hands.set([{ id, circle: snaps ? hands.snapped(circle, within(), true) : circle }], gesture)
      },
      click: () => hands.select([id]),
      cancel: () => hands.cancel(gesture),
    }
  }

  /** The selected circles grow with the distance of the pointer from their middle. */
  const scaleCircles = (from: Point, middle: Point): Gesture => {
    const held = hands.held()
    const [only, ...others] = held
    // One that is a point has no size to be scaled.
    if (only !== undefined && others.length === 0) return resizeCircle(from, only.id, only.circle)
    const gesture = hands.beginGesture()
    const distanceTo = (point: Point) => {
      const { x, y } = planeAt(point)
      return Math.hypot(x - middle.x, y - middle.y)
    }
    const distance = distanceTo(from)
    return {
      move(to) {
        const factor = distanceTo(to) / distance
        const scaled = ({ x, y, r }: Circle) => ({
          x: middle.x + (x - middle.x) * factor,
          y: middle.y + (y - middle.y) * factor,
          r: r * factor,
        })
        hands.set(
          held.map(({ id, circle }) => ({ id, circle: scaled(circle) })),
          gesture,
        )
      },
      cancel: () => hands.cancel(gesture),
    }
  }

  /** Press where the center is to be, drag to the rim. */
  const addCircle = (from: Point): Gesture => {
    const gesture = hands.beginGesture()
    const { x, y } = planeAt(from)
    let added: Promise<readonly number[]> | undefined
    let last: Circle = { x, y, r: 0 }
    let isCanceled = false
    const circleTo = (to: Point, snaps: boolean): Circle => {
      const point = planeAt(to)
      const circle = { x, y, r: Math.hypot(point.x - x, point.y - y) }
      return snaps ? hands.snapped(circle, within(), true) : circle
    }
    return {
      move(to, snaps) {
        const circle = circleTo(to, snaps)
        last = circle
        const isFirst = added === undefined
        added ??= hands.add([circle], gesture)
        added.then(([id]) => {
          const isWanted = !isCanceled && (isFirst || circle === last)
          if (id !== undefined && isWanted) hands.set([{ id, circle: last }], gesture)
        })
      },
      click: () => hands.addFitting({ x, y }),
      cancel() {
        isCanceled = true
        hands.cancel(gesture)
      },
    }
  }

  /** The corner is where it is released. */
  const drawCorner = (from: Point): Gesture => {
    let last = from
    const draw = (how: Drawn) => hands.draw?.(how, planeAt(last), within())
    draw('move')
    return {
      move(to) {
        last = to
        draw('move')
      },
      click: () => draw('place'),
      end: () => draw('place'),
    }
  }

  /** Held where nothing is: what a circle would take that is there is shown, and once it is released, it is. */
  const holdCircle = (from: Point): Gesture => {
    let last = planeAt(from)
    let isOver = false
    let isFollowing = false
    const follow = async () => {
      if (isFollowing) return
      isFollowing = true
      for (let shown: Point | undefined; shown !== last && !isOver; ) {
        shown = last
        const circle = await hands.fitted(shown)
        if (!isOver) await view.tryCircle(circle)
      }
      isFollowing = false
    }
    const stop = () => {
      isOver = true
      view.tryCircle(undefined)
    }
    follow()
    return {
      move(to) {
        last = planeAt(to)
        follow()
      },
      end() {
        stop()
        return hands.addFitting(last)
      },
      cancel: stop,
    }
  }

  /** What lies between two corners is selected. */
  const band = (from: Point, click: () => void): Gesture => {
    let last = from
    const clear = () => {
      view.band = undefined
    }
    return {
      move(to) {
        last = to
        view.band = { from, to }
      },
      click,
      end() {
        clear()
        const [one, other] = [planeAt(from), planeAt(last)]
        hands.selectWithin({
          minX: Math.min(one.x, other.x),
          minY: Math.min(one.y, other.y),
          maxX: Math.max(one.x, other.x),
          maxY: Math.max(one.y, other.y),
        })
      },
      cancel: clear,
    }
  }

  const movePathEnd = (end: 'from' | 'to'): Gesture => {
    const before = view.layers.path?.[end]
    return {
      move: (to) => view.movePathEnd(end, planeAt(to)),
      cancel: () => before !== undefined && view.movePathEnd(end, before),
    }
  }

  /** Two fingers: what lies between them stays there. */
  const pinch = (pressed: ReadonlyMap<number, Point>): Gesture => {
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

  return { pan, moveCircles, resizeCircle, scaleCircles, addCircle, drawCorner, holdCircle, band, movePathEnd, pinch }
}
