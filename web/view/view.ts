// SPDX-License-Identifier: GPL-3.0-or-later
import type { Edit } from '../lib/index.ts'
import { BasePicture } from './base-picture.ts'
import type { Camera, Size } from './camera.ts'
import { replay } from './painter/commands.ts'
import { addDisc } from './painter/disc-path.ts'
import { FrameSink } from './painter/frame-sink.ts'
import type { Edited, Painter, PainterScene } from './painter.ts'
import type { Hit, Marks } from './protocol.ts'
import { DISC_OPACITY, DOT_RADIUS, readStyle, type Style } from './style.ts'

/** A zoom rests so long, in milliseconds, before the picture is painted sharp. */
const REST = 80
const HOVER_OPACITY = 0.55

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
  #baseChanged = false
  #overlayChanged = false

  /** Called when what is known of the circles that stand out has changed. */
  onmarked: ((marks: Marks) => void) | undefined

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
        this.#overlayChanged = true
        this.#schedule()
        this.onmarked?.(marks)
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
    context.clearRect(0, 0, width, height)
    const frame = { x: this.#camera.x, y: this.#camera.y, scale: this.#camera.scale * devicePixelRatio, width, height }
    const { selected, hovered } = this.#marks
    const pathOf = (outline: Float64Array) => {
      const sink = new FrameSink(frame)
      replay(outline, sink)
      return sink.path
    }
    const fill = (outline: Float64Array, color: string) => {
      context.fillStyle = color
      context.fill(pathOf(outline))
    }
    if (selected !== undefined) {
      fill(selected.neighborhood, this.#style.neighborCell)
      fill(selected.outline, this.#style.selectedCell)
    }
    if (hovered !== undefined && hovered.id !== selected?.id) {
      context.globalAlpha = HOVER_OPACITY
      if (selected === undefined) fill(hovered.neighborhood, this.#style.neighborCell)
      fill(hovered.outline, this.#style.selectedCell)
      context.globalAlpha = 1
    }
    if (selected === undefined) return
    const { x, y, r } = selected.circle
    const rim = new FrameSink(frame)
    const radius = Math.max(r * frame.scale, DOT_RADIUS * devicePixelRatio)
    addDisc(rim.path, frame, rim.x(x), rim.y(y), radius)
    context.fillStyle = this.#style.selectedDisc
    context.globalAlpha = DISC_OPACITY
    context.fill(rim.path)
    context.globalAlpha = 1
    context.strokeStyle = this.#style.accent
    context.lineWidth = 2 * devicePixelRatio
    context.stroke(pathOf(selected.outline))
    context.setLineDash(selected.hiddenBy === undefined ? [] : [4 * devicePixelRatio, 4 * devicePixelRatio])
    context.stroke(rim.path)
    context.setLineDash([])
  }
}
