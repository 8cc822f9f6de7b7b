// SPDX-License-Identifier: GPL-3.0-or-later
import type { Edit, Options, Point } from '../lib/index.ts'
import { BasePicture } from './base-picture.ts'
import { type Camera, type Size, toScreen } from './camera.ts'
import { DEFAULT_LAYERS, type Layers } from './layers.ts'
import { drawOverlay, HANDLE_RADIUS } from './overlay.ts'
import type { Edited, Painter, PainterScene } from './painter.ts'
import type { Computed, Distribution, Found, Hit, Marks, Touching } from './protocol.ts'
import { readStyle, type Style } from './style.ts'

/** A zoom rests so long, in milliseconds, before the picture is painted sharp. */
const REST = 80

/** Circles and their diagram in an element of a page, moved and zoomed by a camera. */
export class View {
  readonly #container: HTMLElement
  readonly #base: HTMLCanvasElement
  readonly #overlay: HTMLCanvasElement
  readonly #picture = new BasePicture()
  readonly #scene: PainterScene
  readonly #observer: ResizeObserver
  #style: Style
  #camera: Camera = { x: 0, y: 0, scale: 1 }
  #size: Size = { width: 0, height: 0 }
  #frame = 0
  #rest: ReturnType<typeof setTimeout> | undefined
  #marks: Marks = { selected: undefined, hovered: undefined }
  #layers = DEFAULT_LAYERS
  #found: Found | undefined
  #touching: Touching | undefined
  /** Where the pointer was when a disc was last asked for; what comes for another place is late. */
  #touchedAt: Point | undefined
  #baseChanged = false
  #overlayChanged = false

  /** Called when what is known of the circles that stand out has changed. */
  onmarked: ((marks: Marks) => void) | undefined
  /** Called when what the layers show that depends on all circles is known, or is no longer. */
  onfound: ((found: Found | undefined) => void) | undefined
  /** Called when other layers are shown, or an end of the path was dragged. */
  onlayers: ((layers: Layers) => void) | undefined

  /** Called when what is looked at has changed. */
  oncamera: (() => void) | undefined

  constructor(container: HTMLElement, painter: Painter) {
    this.#container = container
    this.#base = container.appendChild(document.createElement('canvas'))
    this.#overlay = container.appendChild(document.createElement('canvas'))
    this.#style = readStyle(container)
    this.#scene = painter.add({
      painted: (painted) => {
        this.#picture.put(painted)
        this.#baseChanged = true
        this.#schedule()
      },
      marked: (marks) => {
        this.#marks = marks
        this.#overlayChanges()
        this.onmarked?.(marks)
      },
      found: (found) => {
        this.#found = found
        // It was that of the circles before.
        this.#touching = undefined
        this.#overlayChanges()
        this.onfound?.(found)
      },
    })
    this.#observer = new ResizeObserver(() => this.#resize())
    this.#observer.observe(container)
    this.#resize()
  }

  /**
   * Other circles; circle i gets id i.
   *
   * @throws CircleVoronoiError as `compute`; then all stays as it was
   */
  open(circles: Float64Array): Promise<Edited> {
    this.#picture.clear()
    this.#touching = undefined
    this.#found = undefined
    const opened = this.#scene.open(circles)
    this.#see()
    return opened
  }

  edit(edits: readonly Edit[]): Promise<Edited> {
    return this.#scene.edit(edits)
  }

  get camera(): Camera {
    return this.#camera
  }

  get size(): Size {
    return this.#size
  }

  set camera(camera: Camera) {
    this.#camera = camera
    this.oncamera?.()
    this.#baseChanged = true
    this.#overlayChanged = true
    this.#schedule()
    if (this.#picture.isSharp(camera, devicePixelRatio)) {
      this.#see()
    } else {
      clearTimeout(this.#rest)
      this.#rest = setTimeout(() => this.#see(), REST)
    }
  }

  hit(x: number, y: number, slack: number): Promise<Hit | undefined> {
    return this.#scene.hit(x, y, slack)
  }

  /** How cells are distributed. */
  measure(): Promise<Distribution | undefined> {
    return this.#scene.measure()
  }

  /** Computes the diagram once more from nothing, to see how. */
  compute(options: Options): Promise<Computed | undefined> {
    return this.#scene.compute(options)
  }

  get layers(): Layers {
    return this.#layers
  }

  set layers(layers: Layers) {
    this.#layers = layers
    this.#scene.setLayers(layers)
    const wish = this.#picture.again(this.#camera, this.#size)
    if (wish !== undefined) this.#scene.look(wish, this.#style)
    this.#overlayChanges()
    this.onlayers?.(layers)
  }

  /** Shows the disc of the vertex or the point of an edge next to a point of the plane, if that layer is on. */
  async touch(point: Point | undefined, slack: number): Promise<void> {
    this.#touchedAt = point
    const touching =
      point === undefined || !this.#layers.disc ? undefined : await this.#scene.touch(point.x, point.y, slack)
    if (this.#touchedAt !== point || touching === this.#touching) return
    this.#touching = touching
    this.#overlayChanges()
  }

  /** The end of the path at a pixel. */
  pathEndAt(point: Point, slack: number): 'from' | 'to' | undefined {
    const { path } = this.#layers
    if (path === undefined) return undefined
    return (['to', 'from'] as const).find((end) => {
      const { x, y } = toScreen(this.#camera, this.#size, path[end])
      return Math.hypot(x - point.x, y - point.y) < HANDLE_RADIUS + slack
    })
  }

  /** Moves an end of the path to a point of the plane. */
  movePathEnd(end: 'from' | 'to', point: Point): void {
    const { path } = this.#layers
    if (path === undefined) return
    this.#layers = { ...this.#layers, path: { ...path, [end]: point } }
    this.#scene.findAgain(this.#layers)
    this.#overlayChanges()
    this.onlayers?.(this.#layers)
  }

  /** Which circles stand out. */
  mark(selected: number | undefined, hovered: number | undefined): void {
    this.#scene.mark(selected, hovered)
  }

  /** Reads the style of the container again, after it has changed. */
  restyle(): void {
    this.#style = readStyle(this.#container)
    this.#picture.clear()
    this.#see()
    this.#overlayChanged = true
    this.#schedule()
  }

  dispose(): void {
    this.#observer.disconnect()
    cancelAnimationFrame(this.#frame)
    clearTimeout(this.#rest)
    this.#scene.close()
    this.#base.remove()
    this.#overlay.remove()
  }

  #resize(): void {
    this.#size = { width: this.#container.clientWidth, height: this.#container.clientHeight }
    for (const canvas of [this.#base, this.#overlay]) {
      canvas.width = Math.round(this.#size.width * devicePixelRatio)
      canvas.height = Math.round(this.#size.height * devicePixelRatio)
    }
    this.#baseChanged = true
    this.#overlayChanged = true
    this.#see()
    this.#schedule()
  }

  #see(): void {
    if (this.#size.width === 0 || this.#size.height === 0) return
    const wish = this.#picture.see(this.#camera, this.#size, devicePixelRatio)
    if (wish !== undefined) this.#scene.look(wish, this.#style)
  }

  #schedule(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#draw())
  }

  #draw(): void {
    this.#frame = 0
    if (this.#baseChanged) {
      const context = this.#base.getContext('2d') as CanvasRenderingContext2D
      this.#picture.draw(context, this.#camera, this.#size, devicePixelRatio)
      this.#baseChanged = false
    }
    this.#container.ariaBusy = String(!this.#picture.isWhole || !this.#picture.isSharp(this.#camera, devicePixelRatio))
    if (this.#overlayChanged) this.#drawOverlay()
    this.#overlayChanged = false
  }

  #drawOverlay(): void {
    const context = this.#overlay.getContext('2d') as CanvasRenderingContext2D
    const { width, height } = this.#overlay
    const frame = { x: this.#camera.x, y: this.#camera.y, scale: this.#camera.scale * devicePixelRatio, width, height }
    drawOverlay(context, frame, devicePixelRatio, this.#style, {
      marks: this.#marks,
      found: this.#found,
      touching: this.#touching,
      layers: this.#layers,
    })
  }

  #overlayChanges(): void {
    this.#overlayChanged = true
    this.#schedule()
  }
}
