// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Circle, Point } from '../lib/index.ts'
import type { LinkView } from '../lib/link.ts'
import { boundingBox, type Camera, fitted, type Padding, panned, toPlane, toScreen, zoomed } from '../view/camera.ts'
import { boxOf } from '../view/domain.ts'
import type { FigureParts } from './figure-actions.ts'
import { cameraShowing, LARGEST_ZOOM, SMALLEST_ZOOM } from './scene-link.ts'

/** Zoom factor of a button or key. */
const ZOOM_STEP = 1.5
/** Zooming to a selection shows this many times its size. */
const SHOWN_AROUND = 3
/** Radius of a circle added to empty space, in pixels. */
export const USUAL_RADIUS = 24

/** Moves of the camera. */
export class CameraActions {
  readonly #figure: FigureParts
  readonly #padding: () => Padding
  /** The parts of the picture that panels cover. */
  covered: () => Padding

  /** `padding` is kept free when everything is shown. */
  constructor(figure: FigureParts, padding: () => Padding) {
    this.#figure = figure
    this.#padding = padding
    this.covered = padding
  }

  /** The part of the plane that no panel covers. */
  get uncovered(): Box {
    const { camera, size } = this.#figure.view
    const { top, right, bottom, left } = this.covered()
    const low = toPlane(camera, size, { x: left, y: size.height - bottom })
    const high = toPlane(camera, size, { x: size.width - right, y: top })
    return { minX: low.x, minY: low.y, maxX: high.x, maxY: high.y }
  }

  /** Whether the viewport shows all circles as large as possible. */
  get isWhole(): boolean {
    return isSameCamera(this.#figure.view.camera, this.fittedTo(this.#box))
  }

  pan(dx: number, dy: number): void {
    this.#figure.view.setCamera(panned(this.#figure.view.camera, dx, dy))
  }

  zoom(factor: number, anchor: Point): void {
    const { camera, size } = this.#figure.view
    const { circles } = this.#figure.editing
    const [least, most] = this.#zoomLimits(this.#box, circles.core())
    const scale = Math.min(Math.max(camera.scale * factor, least), most)
    this.#figure.view.setCamera(zoomed(camera, size, anchor, scale / camera.scale))
  }

  /** Zooms in (1) or out (-1) by one step. */
  zoomAtMiddle(steps: 1 | -1): void {
    const { width, height } = this.#figure.view.size
    this.zoom(ZOOM_STEP ** steps, { x: width / 2, y: height / 2 })
  }

  /** Applies a link's viewport if it shows any of the circles. Otherwise shows all circles. */
  showView(view: LinkView | undefined): void {
    this.#figure.view.setCamera(this.cameraFor(view, this.#box))
  }

  /** Zooms to the selected circles, with a margin. */
  zoomToSelection(): void {
    const circles = this.#figure.store.get().selection.flatMap((id) => this.#figure.editing.circles.get(id) ?? [])
    if (circles.length === 0) return
    const box = boundingBox(Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r])))
    const { camera } = this.#figure.view
    const [{ x: firstX, y: firstY }] = circles as [Circle]
    const isOnePoint = circles.every(({ x, y, r }) => r === 0 && x === firstX && y === firstY)
    // A point is shown at the size of a new circle.
    const radius = isOnePoint ? USUAL_RADIUS / camera.scale : Math.max(box.maxX - box.minX, box.maxY - box.minY) / 2
    const half = SHOWN_AROUND * radius
    const [x, y] = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2]
    this.#figure.view.setCamera(this.fittedTo({ minX: x - half, minY: y - half, maxX: x + half, maxY: y + half }))
  }

  /** Shows everything. If everything is already visible, leaves out distant outliers. */
  fit(): void {
    const { circles, domain } = this.#figure.editing
    const [whole, core] = [this.fittedTo(this.#box), this.fittedTo(circles.core())]
    // A region is always shown in full.
    this.#figure.view.setCamera(
      domain.region === undefined && isSameCamera(this.#figure.view.camera, whole) ? core : whole,
    )
  }

  /** The bounding box of the circles and the region. */
  get #box(): Box {
    return boxOf(this.#figure.editing.circles.box(), this.#figure.editing.domain)
  }

  #zoomLimits(box: Box, core: Box): [least: number, most: number] {
    const whole = this.fittedTo(box).scale
    return [whole * SMALLEST_ZOOM, Math.max(whole, this.fittedTo(core).scale) * LARGEST_ZOOM]
  }

  /** The camera of a link's viewport if it shows any of the circles, else of all circles. */
  cameraFor(view: LinkView | undefined, box: Box): Camera {
    return cameraShowing(view, box, this.#figure.view.size, this.#padding())
  }

  fittedTo(box: Box): Camera {
    return fitted(box, this.#figure.view.size, this.#padding())
  }

  /** Brings the center of a circle into view. */
  revealCircle(id: number): void {
    const circle = this.#figure.editing.circles.get(id)
    if (circle !== undefined && !this.shows(circle)) {
      this.#figure.view.setCamera({ ...this.#figure.view.camera, x: circle.x, y: circle.y })
    }
  }

  /** Brings all given circles into view. */
  reveal(circles: readonly Circle[]): void {
    if (!circles.every((circle) => this.shows(circle))) this.showView(undefined)
  }

  /** Whether a point is visible and not covered by a panel. */
  shows(point: Point, { top, right, bottom, left } = this.covered()): boolean {
    const { camera, size } = this.#figure.view
    const { x, y } = toScreen(camera, size, point)
    return x >= left && x <= size.width - right && y >= top && y <= size.height - bottom
  }
}

export function isSameCamera(camera: Camera, other: Camera): boolean {
  return camera.x === other.x && camera.y === other.y && camera.scale === other.scale
}
