// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Circle, Point } from '../lib/index.ts'
import { panned, toPlane } from './camera.ts'
import type { View } from './view.ts'

/** Distance at which snapping acts, in pixels. */
const SNAP_DISTANCE = 8

/** A circle with its id. */
export interface IdentifiedCircle {
  readonly id: number
  readonly circle: Circle
}

/** The phases of drawing a polygon: a corner moves, is placed, or closes the polygon. */
export type SketchPhase = 'move' | 'place' | 'close'

/** The effects of gestures on the circles of a view. */
export interface GestureTarget {
  /** The effect of a press. `add` adds a circle. */
  readonly tool: 'select' | 'pan' | 'add' | 'draw'
  /** Draws with the tool `draw` at a point. Points `within` a distance in units count as the same. */
  draw?(how: SketchPhase, point: Point, within: number): void
  /** Whether dragged circles snap without a modifier key. */
  readonly snaps: boolean
  /** A circle's current values; `undefined` if the circle is gone or must not be changed. */
  circle(id: number): Circle | undefined
  /** The selected circles. */
  selectedCircles(): readonly IdentifiedCircle[]
  isSelected(id: number): boolean
  select(ids: readonly number[]): void
  /** Adds a circle to the selection, or removes it. */
  toggle(id: number): void
  /** Adds the circles in a box to the selection. */
  selectWithin(box: Box): void
  hover(id: number | undefined): void
  /** Returns a number that groups edits into one undo step. */
  beginGesture(): number
  set(circles: readonly IdentifiedCircle[], gesture: number): void
  /**
   * Snaps a circle to other circles or a grid within a distance in units. `sizes` changes the radius instead of the
   * center.
   */
  snapped(circle: Circle, within: number, sizes: boolean): Circle
  /** Adds circles and returns their ids; none if they were refused. */
  add(circles: readonly Circle[], gesture: number): Promise<readonly number[]>
  /** A circle at a point that leaves some room to its nearest neighbor; `undefined` if none fits. */
  fitted(center: Point): Circle | undefined
  /** Adds the circle that `fitted` returns. */
  addFitting(center: Point): Promise<void>
  /** Reverts the edits of a gesture. */
  cancel(gesture: number): void
  /** Zooms by `factor` about the pixel `anchor`. */
  zoom(factor: number, anchor: Point): void
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

/** Creates gestures that begin at a given pixel. */
export function gesturesOf(view: View, target: GestureTarget) {
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

  /** Drags the selected circles. Circle `id` is the one under the pointer, which snaps. */
  const moveCircles = (from: Point, id: number): Gesture => {
    const gesture = target.beginGesture()
    const held = target.selectedCircles()
    const grip = planeAt(from)
    return {
      move(to, snaps) {
        const point = planeAt(to)
        const movedBy = (circle: Circle, dx: number, dy: number) => ({ ...circle, x: circle.x + dx, y: circle.y + dy })
        let [dx, dy] = [point.x - grip.x, point.y - grip.y]
        const grabbed = held.find((other) => other.id === id)
        const place = grabbed && snaps ? target.snapped(movedBy(grabbed.circle, dx, dy), within(), false) : undefined
        if (grabbed && place) [dx, dy] = [place.x - grabbed.circle.x, place.y - grabbed.circle.y]
        const moved = held.map((other) => ({
          id: other.id,
          circle: other === grabbed && place ? place : movedBy(other.circle, dx, dy),
        }))
        target.set(moved, gesture)
      },
      // A click without a drag selects only this circle.
      click: () => target.select([id]),
      cancel: () => target.cancel(gesture),
    }
  }

  /** Begins another gesture at the first move. */
  const onceMoved = (begin: () => Gesture, click: () => void): Gesture => {
    let begun: Gesture | undefined
    return {
      move(to, snaps) {
        begun ??= begin()
        begun.move(to, snaps)
      },
      click,
      end: () => begun?.end?.(),
      cancel: () => begun?.cancel?.(),
    }
  }

  /** Drags the rim, at a constant distance from the pointer. */
  const resizeCircle = (from: Point, id: number, { x, y, r }: Circle): Gesture => {
    const gesture = target.beginGesture()
    const distanceTo = (point: Point) => {
      const { x: px, y: py } = planeAt(point)
      return Math.hypot(px - x, py - y)
    }
    const offset = r - distanceTo(from)
    return {
      move(to, snaps) {
        const circle = { x, y, r: Math.max(distanceTo(to) + offset, 0) }
        target.set([{ id, circle: snaps ? target.snapped(circle, within(), true) : circle }], gesture)
      },
      click: () => target.select([id]),
      cancel: () => target.cancel(gesture),
    }
  }

  /** Scales the selected circles by the pointer's distance from their center. */
  const scaleCircles = (from: Point, middle: Point): Gesture => {
    const held = target.selectedCircles()
    const [only, ...others] = held
    // A single point has no size to scale, so its radius is dragged instead.
    if (only !== undefined && others.length === 0) return resizeCircle(from, only.id, only.circle)
    const gesture = target.beginGesture()
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
        target.set(
          held.map(({ id, circle }) => ({ id, circle: scaled(circle) })),
          gesture,
        )
      },
      cancel: () => target.cancel(gesture),
    }
  }

  /** The press sets the center, the drag sets the radius. */
  const addCircle = (from: Point): Gesture => {
    const gesture = target.beginGesture()
    const { x, y } = planeAt(from)
    let added: Promise<readonly number[]> | undefined
    let last: Circle = { x, y, r: 0 }
    let isCanceled = false
    const circleTo = (to: Point, snaps: boolean): Circle => {
      const point = planeAt(to)
      const circle = { x, y, r: Math.hypot(point.x - x, point.y - y) }
      return snaps ? target.snapped(circle, within(), true) : circle
    }
    return {
      move(to, snaps) {
        const circle = circleTo(to, snaps)
        last = circle
        const isFirst = added === undefined
        added ??= target.add([circle], gesture)
        added.then(([id]) => {
          const isWanted = !isCanceled && (isFirst || circle === last)
          if (id !== undefined && isWanted) target.set([{ id, circle: last }], gesture)
        })
      },
      click: () => target.addFitting({ x, y }),
      cancel() {
        isCanceled = true
        target.cancel(gesture)
      },
    }
  }

  /** The release places the corner. */
  const drawCorner = (from: Point): Gesture => {
    let last = from
    const draw = (how: SketchPhase) => target.draw?.(how, planeAt(last), within())
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

  /** A long press on empty space previews the cell of a new circle. The release adds the circle. */
  const holdCircle = (from: Point): Gesture => {
    let last = planeAt(from)
    let isOver = false
    let isFollowing = false
    const follow = async () => {
      if (isFollowing) return
      isFollowing = true
      for (let shown: Point | undefined; shown !== last && !isOver; ) {
        shown = last
        await view.tryCircle(target.fitted(shown))
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
        target.addFitting(last)
      },
      cancel: stop,
    }
  }

  /** Selects the circles between two corners. */
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
        target.selectWithin({
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

  /** Two fingers keep the points of the plane between them. */
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
        target.zoom(next.width / last.width, next.middle)
        last = next
      },
    }
  }

  return {
    pan,
    onceMoved,
    moveCircles,
    resizeCircle,
    scaleCircles,
    addCircle,
    drawCorner,
    holdCircle,
    band,
    movePathEnd,
    pinch,
  }
}
