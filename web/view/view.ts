// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Circle, Edit, Point } from '../lib/index.ts'
import { BasePicture, MOST_ENLARGED } from './base-picture.ts'
import { boundingBox, type Camera, type Size, toScreen } from './camera.ts'
import type { CircleTable } from './circle-table.ts'
import { type AboveLayer, checkLayers, DEFAULT_LAYERS, type Layers, withoutDiagram } from './layers.ts'
import { scaleOnScreen } from './on-screen.ts'
import {
  type Above,
  drawOverlay,
  HANDLE_RADIUS,
  handleOf,
  isNothingAbove,
  NOTHING_STANDS_OUT,
  type StandingOut,
} from './overlay.ts'
import { CanvasDrawing, type Drawing } from './painter/drawing.ts'
import type { Frame } from './painter/frame.ts'
import type { Answer, Edited, Lost, Painter, PainterScene } from './painter.ts'
import { pictureFrame } from './picture-frame.ts'
import type { DomainChange, Found, Marks, Questions, Touching, Trial } from './protocol.ts'
import { Failure, Superseded } from './refusal.ts'
import { isDark, readStyle, type Style } from './style.ts'
import { svgPicture } from './svg-picture.ts'

/** A zoom rests so long, in milliseconds, before the picture is painted sharp. */
const REST = 80

/** Transforms that enlarge by less leave the picture as it is; of larger ones it gets so many times as many pixels. */
const LEAST_ENLARGED = 1.05
const MOST_SHARPENED = 4

const notDrawn = () => new Failure((words) => words.notDrawn)

/** What listeners are told. */
export interface ViewEvents {
  /** What is known of the circles that stand out, whenever that has changed. */
  readonly marked: Marks
  /** What the layers show that depends on all circles, once it is known; `undefined`: it is no longer. */
  readonly found: Found | undefined
  /** Others are shown, or an end of the path was dragged. */
  readonly layers: Layers
  /** Whether anything of the diagram is drawn. */
  readonly diagram: boolean
  readonly camera: Camera
  /** Colors may be others. */
  readonly style: undefined
  /** What the circle would take that is tried; `undefined`: none is. */
  readonly tried: Trial | undefined
  /** Circles were set, or edited. */
  readonly changed: Edited
  /** They could not be, and why: a `CircleVoronoiError`, or another one if the computer failed. */
  readonly refused: Error
  /** Drawing has failed and goes on. `marks`: which circles stand out is not known any more. */
  readonly failed: { readonly error: Error; readonly marks: boolean }
}

/** Circles that are selected: x, y, r each, and the box around them. */
export interface Chosen {
  readonly circles: Float64Array
  readonly box: Box
}

/** A part of the plane, and the size that it is drawn in. */
export interface Shot {
  readonly camera: Camera
  readonly size: Size
}

/** The corners of what is selected with a rubber band, in pixels. */
export interface Band {
  readonly from: Point
  readonly to: Point
}

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
  /** The scale of what is looked at, and of what the outlines of marked cells are for. */
  #lookedAt = 1
  #outlinedAt = 1
  #found: Found | undefined
  #touching: Touching | undefined
  /** Where the pointer was when a disc was last asked for; what comes for another place is late. */
  #touchedAt: Point | undefined
  #trial: Trial | undefined
  #lastTrial = 0
  #chosen: Chosen | undefined
  #band: Band | undefined
  #sketch: Float64Array | undefined
  #above: readonly AboveLayer[] = []
  #baseChanged = false
  #overlayChanged = false
  /** Whether there is nothing on the overlay: then it need not be cleared. */
  #isOverlayEmpty = true
  #isShown = true
  #scale = 1
  #hasDiagram = true

  readonly #listeners: { readonly [Name in keyof ViewEvents]: Set<(event: ViewEvents[Name]) => void> } = {
    marked: new Set(),
    found: new Set(),
    layers: new Set(),
    diagram: new Set(),
    camera: new Set(),
    style: new Set(),
    tried: new Set(),
    changed: new Set(),
    refused: new Set(),
    failed: new Set(),
  }
  readonly #ondispose: () => void
  readonly #watching = new AbortController()

  /** `ondispose`: called when the view is disposed of. */
  constructor(container: HTMLElement, painter: Painter, ondispose = () => {}) {
    this.#ondispose = ondispose
    container.classList.add('circle-voronoi')
    this.#container = container
    this.#base = container.appendChild(document.createElement('canvas'))
    this.#overlay = container.appendChild(document.createElement('canvas'))
    this.#style = this.#readStyle()
    this.#scene = painter.add({
      painted: (painted) => {
        this.#picture.put(painted)
        // It was that of the circles before.
        if (painted.kind === 'edited') this.#touching = undefined
        this.#baseChanged = true
        this.#schedule()
      },
      marked: (marks) => {
        this.#marks = marks
        this.#outlinedAt = this.#lookedAt
        this.#overlayChanges()
        this.#tell('marked', marks)
      },
      outlined: (marks) => {
        this.#marks = marks
        this.#outlinedAt = this.#lookedAt
        this.#overlayChanges()
      },
      found: (found) => this.#findingChanges(found),
      failed: (error, lost) => this.#drawingFailed(error, lost),
    })
    this.#observer = new ResizeObserver(() => this.#sizeChanges())
    this.#observer.observe(container)
    this.#watchSurroundings()
    this.#resize()
  }

  /**
   * Other circles; circle i gets id i.
   *
   * @throws CircleVoronoiError as `compute`, `region` and `fitAreas`; then all stays as it was
   */
  setCircles(circles: Float64Array, change?: DomainChange): Promise<Edited> {
    this.#picture.clear()
    const opened = this.#scene.open(circles, change).then((edited) => {
      this.#touching = undefined
      this.#findingChanges(undefined)
      return edited
    })
    this.#see()
    // What is there stays until there is more, but it is no longer all.
    this.#schedule()
    return this.#told(opened)
  }

  /** Ends the computation of circles that were set and are not there yet. False: there are none. */
  cancel(): boolean {
    return this.#scene.cancel()
  }

  /**
   * All or none of the edits, for the circles that are there now.
   *
   * @throws CircleVoronoiError as `DiagramEditor.apply`, `region` and `fitAreas`; Superseded, if other circles come first. Then
   *   all stays as it was
   */
  apply(edits: readonly Edit[], change?: DomainChange): Promise<Edited> {
    return this.#told(this.#scene.edit(edits, change))
  }

  /** The circles as they are after all edits that are done; another table for other circles. */
  get circles(): CircleTable {
    return this.#scene.circles
  }

  /** Has a function called with each event of a kind, and returns what ends that. */
  on<Name extends keyof ViewEvents>(name: Name, listener: (event: ViewEvents[Name]) => void): () => void {
    this.#listeners[name].add(listener)
    return () => this.#listeners[name].delete(listener)
  }

  get camera(): Camera {
    return this.#camera
  }

  get size(): Size {
    return this.#size
  }

  setCamera(camera: Camera): void {
    this.#camera = camera
    this.#tell('camera', camera)
    this.#baseChanged = true
    this.#overlayChanged = true
    this.#schedule()
    if (this.#picture.isSharp(camera, this.#pixelRatio)) {
      this.#see()
    } else {
      clearTimeout(this.#rest)
      this.#rest = setTimeout(() => this.#see(), REST)
    }
  }

  /**
   * Asks the thread something about the circles. `undefined`: there is no answer, as the thread has failed, or as other circles
   * have come that it was not about.
   *
   * @throws CircleVoronoiError that says why it cannot be answered
   */
  ask<Name extends keyof Questions>(name: Name, ...args: Parameters<Questions[Name]>): Promise<Answer<Name>> {
    return this.#scene.ask(name, ...args)
  }

  /** What is drawn, unless only circles are (`hasDiagram`). */
  get layers(): Layers {
    return this.#layers
  }

  /** Whether anything of the diagram is drawn, or circles alone. */
  get hasDiagram(): boolean {
    return this.#hasDiagram
  }

  set hasDiagram(hasDiagram: boolean) {
    if (hasDiagram === this.#hasDiagram) return
    this.#hasDiagram = hasDiagram
    this.#drawLayers(this.#layers)
    this.#tell('diagram', hasDiagram)
  }

  get #drawnLayers(): Layers {
    return this.#drawn(this.#layers)
  }

  #drawn(layers: Layers): Layers {
    return this.#hasDiagram ? layers : withoutDiagram(layers)
  }

  /**
   * Draws something else, or something more; layers that are not named stay.
   *
   * @throws CircleVoronoiError `badArgument`, if there is nothing that could be drawn of one, and what the browser throws of
   *   something that it cannot send to a thread; then all stays as it was
   */
  setLayers(change: Partial<Layers>): void {
    const layers = { ...this.#layers, ...change }
    checkLayers(layers)
    this.#drawLayers(layers)
    this.#layers = layers
    this.#tell('layers', layers)
  }

  #drawLayers(layers: Layers): void {
    this.#scene.setLayers(this.#drawn(layers))
    const wish = this.#isShown ? this.#picture.again(this.#camera, this.#size) : undefined
    if (wish !== undefined) this.#scene.look(wish, this.#style)
    this.#overlayChanges()
  }

  /** Shows the disc of the vertex or the point of an edge next to a point of the plane, if that layer is on. */
  async touch(point: Point | undefined, slack: number): Promise<void> {
    this.#touchedAt = point
    const touching =
      point === undefined || !this.#drawnLayers.disc
        ? undefined
        : await this.#scene.ask('touch', point.x, point.y, slack)
    if (this.#touchedAt !== point || touching === this.#touching) return
    this.#touching = touching
    this.#overlayChanges()
  }

  /** Shows what a circle would take that is not there, or no longer. */
  async tryCircle(circle: Circle | undefined): Promise<void> {
    this.#lastTrial += 1
    const turn = this.#lastTrial
    const trial = circle === undefined ? undefined : await this.#scene.ask('try', circle)
    if (turn !== this.#lastTrial || trial === this.#trial) return
    this.#trial = trial
    this.#overlayChanges()
    this.#tell('tried', trial)
  }

  /** The end of the path at a pixel. */
  pathEndAt(point: Point, slack: number): 'from' | 'to' | undefined {
    const { path } = this.#drawnLayers
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
    this.#tell('layers', this.#layers)
  }

  /** What is seen, or another part, as the text of an SVG: without what is selected. */
  async toSVG({ camera, size }: Shot = this): Promise<string> {
    const frame = { ...camera, ...size }
    const drawn = await this.#scene.ask('svg', frame, this.#style)
    if (drawn === undefined) throw notDrawn()
    return svgPicture(frame, drawn, this.#style, this.#drawnLayers, this.#above)
  }

  /**
   * The same as a PNG of `scale` pixels for each CSS pixel.
   *
   * @throws CircleVoronoiError `badArgument`, if no browser could draw it
   */
  async toPNG(scale = devicePixelRatio, { camera, size }: Shot = this): Promise<Blob> {
    const frame = pictureFrame(camera, size, scale)
    const image = await this.#scene.ask('image', frame, scale, this.#style)
    if (image === undefined) throw notDrawn()
    const canvas = new OffscreenCanvas(frame.width, frame.height)
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
    context.drawImage(image, 0, 0)
    image.close()
    this.#drawAbove(new CanvasDrawing(context), frame, scale)
    return canvas.convertToBlob({ type: 'image/png' })
  }

  /** What is seen as a film that goes on, without what stands out. */
  stream(): MediaStream {
    return this.#base.captureStream()
  }

  /** Has one circle stand out, or none. */
  select(id: number | undefined): void {
    this.mark(id, undefined)
  }

  /** Which circles stand out. */
  mark(selected: number | undefined, hovered: number | undefined): void {
    this.#scene.mark(selected, hovered)
  }

  /** Which circles are selected, as they are: they can be scaled by a handle, and of several each stands out. */
  choose(circles: readonly Circle[]): void {
    const flat = Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r]))
    const [first, ...others] = circles
    // The handle of a point is beside it: its box is not the one that is fitted.
    const box = first !== undefined && others.length === 0 ? boxOfCircle(first) : boundingBox(flat)
    this.#chosen = first && { circles: flat, box }
    this.#overlayChanges()
  }

  set band(band: Band | undefined) {
    this.#band = band
    this.#overlayChanges()
  }

  /** The corners of a polygon that is being drawn, x and y of each; the last one still moves. */
  set sketch(sketch: Float64Array | undefined) {
    this.#sketch = sketch
    this.#overlayChanges()
  }

  /** What else is drawn above the picture, from the lowest up: shown with the next frame, as nothing is painted anew. */
  set above(layers: readonly AboveLayer[]) {
    this.#above = layers
    this.#overlayChanges()
  }

  /** What is scaled about, if the handle of the selected circles is at a pixel. */
  handleAt(point: Point, slack: number): Point | undefined {
    if (this.#chosen === undefined) return undefined
    const { box } = this.#chosen
    const { x, y } = handleOf(box, (corner) => toScreen(this.#camera, this.#size, corner))
    if (Math.hypot(x - point.x, y - point.y) > HANDLE_RADIUS + slack) return undefined
    return { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2 }
  }

  /** Whether it has pixels: one that nobody sees needs none. */
  get isShown(): boolean {
    return this.#isShown
  }

  set isShown(isShown: boolean) {
    if (isShown === this.#isShown) return
    this.#isShown = isShown
    if (!isShown) this.#picture.clear()
    this.#resize()
  }

  /** Reads the style of the container again, after it has changed. */
  restyle(): void {
    this.#style = this.#readStyle()
    this.#picture.clear()
    this.#see()
    this.#overlayChanges()
    this.#tell('style', undefined)
  }

  #readStyle(): Style {
    const style = readStyle(this.#container)
    // For paper, which is light.
    this.#container.toggleAttribute('data-dark', isDark(style))
    return style
  }

  /** Ends all that was asked; nothing is told of that, nor anything else. */
  dispose(): void {
    for (const listeners of Object.values(this.#listeners)) listeners.clear()
    this.#observer.disconnect()
    cancelAnimationFrame(this.#frame)
    clearTimeout(this.#rest)
    this.#watching.abort()
    this.#scene.close()
    this.#ondispose()
    this.#base.remove()
    this.#overlay.remove()
  }

  /** Paper has a size and a resolution of its own, and does not wait for a picture: it shows the screen's, scaled (theme.css). */
  #sizeChanges(): void {
    if (!matchMedia('print').matches) this.#resize()
  }

  /** Pixels of the screen for each CSS pixel of the container. */
  get #pixelRatio(): number {
    return devicePixelRatio * this.#scale
  }

  /** How much a transform or a zoom around the container enlarges it. Pictures that are made smaller stay as they are. */
  #scaleOnScreen(): number {
    const scale = scaleOnScreen(this.#container)
    return scale > LEAST_ENLARGED ? Math.min(scale, MOST_SHARPENED) : 1
  }

  /** Nothing tells of a transform: it is looked at whenever something is drawn, and where the window is another. */
  #checkScale(): void {
    if (matchMedia('print').matches) return
    const ratio = this.#scaleOnScreen() / this.#scale
    if (Math.max(ratio, 1 / ratio) > LEAST_ENLARGED) this.#resize()
  }

  #resize(): void {
    this.#size = { width: this.#container.clientWidth, height: this.#container.clientHeight }
    this.#scale = this.#scaleOnScreen()
    const pixels = this.#isShown ? this.#pixelRatio : 0
    for (const canvas of [this.#base, this.#overlay]) {
      canvas.width = Math.round(this.#size.width * pixels)
      canvas.height = Math.round(this.#size.height * pixels)
    }
    this.#baseChanged = true
    this.#overlayChanged = true
    this.#see()
    this.#schedule()
  }

  #see(): void {
    if (!this.#isShown || this.#size.width === 0 || this.#size.height === 0) return
    const wish = this.#picture.see(this.#camera, this.#size, this.#pixelRatio)
    if (wish === undefined) return
    this.#lookedAt = this.#camera.scale
    this.#scene.look(wish, this.#style)
  }

  #schedule(): void {
    const isDisposed = this.#watching.signal.aborted
    if (this.#frame === 0 && !isDisposed) this.#frame = requestAnimationFrame(() => this.#draw())
  }

  #draw(): void {
    this.#frame = 0
    if (!this.#isShown) return
    this.#checkScale()
    if (this.#baseChanged) {
      const context = this.#base.getContext('2d') as CanvasRenderingContext2D
      this.#picture.draw(context, this.#camera, this.#size, this.#pixelRatio)
      this.#baseChanged = false
    }
    this.#container.ariaBusy = String(!this.#picture.isWhole || !this.#picture.isSharp(this.#camera, this.#pixelRatio))
    if (this.#overlayChanged) this.#drawOverlay()
    this.#overlayChanged = false
  }

  /** What stands out on the screen. On paper, nothing does. */
  get #standingOut(): StandingOut {
    if (matchMedia('print').matches) return NOTHING_STANDS_OUT
    return {
      marks: this.#marks,
      touching: this.#touching,
      trial: this.#trial,
      chosen: this.#chosen,
      band: this.#band,
      sketch: this.#sketch,
    }
  }

  #drawOverlay(): void {
    const above = this.#aboveOf(this.#standingOut)
    const isEmpty = isNothingAbove(above)
    if (isEmpty && this.#isOverlayEmpty) return
    this.#isOverlayEmpty = isEmpty
    const context = this.#overlay.getContext('2d') as CanvasRenderingContext2D
    const { width, height } = this.#overlay
    const ratio = this.#pixelRatio
    const frame = { x: this.#camera.x, y: this.#camera.y, scale: this.#camera.scale * ratio, width, height }
    context.clearRect(0, 0, width, height)
    drawOverlay(new CanvasDrawing(context), frame, ratio, this.#style, above)
  }

  #drawAbove(drawing: Drawing, frame: Frame, pixelRatio: number): void {
    drawOverlay(drawing, frame, pixelRatio, this.#style, this.#aboveOf(NOTHING_STANDS_OUT))
  }

  #aboveOf(standingOut: StandingOut): Above {
    // Outlines of cells are cut to what was looked at. Seen far larger, they are too coarse.
    const enlarged = this.#camera.scale / this.#outlinedAt
    const hasOutlines = enlarged < MOST_ENLARGED && this.#hasDiagram
    const marks = hasOutlines ? standingOut.marks : withoutCells(standingOut.marks)
    return { found: this.#found, layers: this.#drawnLayers, above: this.#above, ...standingOut, marks }
  }

  /** Another thread draws from now on, without what may have been the cause. */
  #drawingFailed(error: Error, { marks, layers }: Lost): void {
    if (marks) this.#marks = { selected: undefined, hovered: undefined }
    if (layers) this.setLayers(DEFAULT_LAYERS)
    this.#overlayChanges()
    this.#tell('failed', { error, marks })
  }

  #findingChanges(found: Found | undefined): void {
    this.#found = found
    this.#overlayChanges()
    this.#tell('found', found)
  }

  #overlayChanges(): void {
    this.#overlayChanged = true
    this.#schedule()
  }

  #tell<Name extends keyof ViewEvents>(name: Name, event: ViewEvents[Name]): void {
    for (const listener of this.#listeners[name]) listener(event)
  }

  /** Tells what comes of edits as events, too. */
  #told(edited: Promise<Edited>): Promise<Edited> {
    edited.then(
      (outcome) => this.#tell('changed', outcome),
      (error: Error) => {
        if (!(error instanceof Superseded)) this.#tell('refused', error)
      },
    )
    return edited
  }

  /** The scheme, the system's colors, style sheets and the pixels of the screen may be others later. */
  #watchSurroundings(): void {
    const { signal } = this.#watching
    // WebKit runs the modules of a page before its style sheets are there.
    const restyleBy = ({ target }: Event) => {
      if (target instanceof HTMLLinkElement && target.relList.contains('stylesheet')) this.restyle()
    }
    document.addEventListener('load', restyleBy, { capture: true, signal })
    for (const query of ['(prefers-color-scheme: dark)', '(forced-colors: active)']) {
      matchMedia(query).addEventListener('change', () => this.restyle(), { signal })
    }
    // Paper gets what is drawn by then.
    matchMedia('print').addEventListener('change', () => this.#drawOverlay(), { signal })
    // Others that hear of the same may set a transform.
    const check = () => requestAnimationFrame(() => this.#checkScale())
    for (const name of ['resize', 'transitionend']) addEventListener(name, check, { signal })
    const watchPixels = () => {
      const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`)
      const change = () => {
        this.#sizeChanges()
        watchPixels()
      }
      query.addEventListener('change', change, { signal, once: true })
    }
    watchPixels()
  }
}

function boxOfCircle({ x, y, r }: Circle): Box {
  return { minX: x - r, minY: y - r, maxX: x + r, maxY: y + r }
}

function withoutCells({ selected, hovered }: Marks): Marks {
  const circleOf = (described: Marks['selected']) =>
    described && { ...described, outline: new Float64Array(), neighborhood: new Float64Array() }
  return { selected: circleOf(selected), hovered: circleOf(hovered) }
}
