// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Edit, Point } from '../lib/index.ts'
import { BasePicture, MOST_ENLARGED } from './base-picture.ts'
import { type Camera, NO_PADDING, type Padding, type Size, toPlane, toScreen } from './camera.ts'
import { type Chosen, chosenOf } from './chosen.ts'
import type { CircleTable, Hit, KeptIds } from './circle-table.ts'
import type { Name, Names } from './labels.ts'
import {
  checkLayers,
  DEFAULT_LAYERS,
  isPathOnly,
  type Layers,
  type OverlayLayer,
  type OwnColors,
  type PaintedLayers,
  withoutDiagram,
} from './layers.ts'
import { scaleOnScreen } from './on-screen.ts'
import {
  drawOverlay,
  HANDLE_RADIUS,
  handleOf,
  isNothingAbove,
  NOTHING_STANDS_OUT,
  type OverlayContent,
  type OverlayHighlights,
  type SelectionRectangle,
} from './overlay.ts'
import { CanvasDrawing, type Drawing } from './painter/drawing.ts'
import type { Frame } from './painter/frame.ts'
import type { Painter } from './painter.ts'
import { pictureFrame } from './picture-frame.ts'
import type { DomainChange, GlobalResults, Highlights, Questions, Touching, Trial } from './protocol.ts'
import { Failure, Superseded } from './refusal.ts'
import type { Answer, Edited, Lost, SceneClient } from './scene-client.ts'
import type { Store } from './store.ts'
import { isDark, readStyle, type Style } from './style.ts'
import { svgPicture, titlesOf } from './svg-picture.ts'
import { NO_HIGHLIGHTS, selectedIn, type ViewState } from './view-state.ts'

/** Pause after zooming before the picture is painted sharp, in milliseconds. */
const REST = 80

/** Transforms below this scale leave the resolution as it is; larger ones increase it. */
const LEAST_ENLARGED = 1.05
const MOST_SHARPENED = 4

/** The parts of the state that the overlay shows. */
const DRAWN_ABOVE = ['camera', 'layers', 'selection', 'highlights', 'found'] as const

const notDrawn = () => new Failure((words) => words.notDrawn)

/** The events of a view. */
export interface ViewEvents {
  /** The descriptions of the highlighted circles have arrived. */
  readonly marked: Highlights
  /** The global results are known, or no longer valid (`undefined`). */
  readonly found: GlobalResults | undefined
  readonly layers: Layers
  /** Whether anything of the diagram is drawn. */
  readonly diagram: boolean
  readonly camera: Camera
  /** The style may have changed. */
  readonly style: undefined
  /** The effect of a previewed circle; `undefined` without a preview. */
  readonly tried: Trial | undefined
  /** Circles were set or edited. */
  readonly changed: Edited
  /** A change was refused, with a `CircleVoronoiError`, or another error if the thread failed. */
  readonly refused: Error
  /** Drawing failed, and a new thread continues. */
  readonly failed: Error
}

/** A part of the plane, and the size in which to export it. */
export interface ExportView {
  readonly camera: Camera
  readonly size: Size
}

/** Shows circles and their diagram in an element of a page, seen by a camera. */
export class View {
  readonly #container: HTMLElement
  readonly #base: HTMLCanvasElement
  readonly #overlay: HTMLCanvasElement
  readonly #picture = new BasePicture()
  readonly #scene: SceneClient
  readonly #store: Store<ViewState>
  readonly #observer: ResizeObserver
  #style: Style
  #size: Size = { width: 0, height: 0 }
  #frame = 0
  #rest: ReturnType<typeof setTimeout> | undefined
  /** The scale of the last paint request, and the scale of the highlighted outlines. */
  #lookedAt = 1
  #outlinedAt = 1
  #touching: Touching | undefined
  /** The position of the last request for a disc. Answers for older positions are ignored. */
  #touchedAt: Point | undefined
  #trial: Trial | undefined
  #lastTrial = 0
  /** The selected circles as they are drawn; `undefined` if they have changed since. */
  #chosen: { readonly drawn: Chosen | undefined } | undefined
  #rectangle: SelectionRectangle | undefined
  #sketch: Float64Array | undefined
  #above: readonly OverlayLayer[] = []
  #baseChanged = false
  #overlayChanged = false
  /** Whether the overlay is empty and needs no clearing. */
  #isOverlayEmpty = true
  #isShown = true
  #scale = 1
  #hasDiagram = true
  #names: readonly Name[] = []
  #ownColors: OwnColors | undefined

  /** The borders of the picture that something covers. */
  covered: () => Padding = () => NO_PADDING

  readonly #listeners = new Map<keyof ViewEvents, Set<(event: never) => void>>()
  readonly #ondispose: () => void
  readonly #watching = new AbortController()

  /** `ondispose` is called when the view is disposed of. */
  constructor(container: HTMLElement, painter: Painter, store: Store<ViewState>, ondispose = () => {}) {
    this.#store = store
    this.#ondispose = ondispose
    container.classList.add('circle-voronoi')
    this.#container = container
    this.#base = container.appendChild(document.createElement('canvas'))
    this.#overlay = container.appendChild(document.createElement('canvas'))
    this.#style = this.#readStyle()
    this.#scene = painter.add({
      painted: (painted) => {
        const { painted: before } = this.#picture
        this.#picture.put(painted)
        // Names wait for their cells.
        if (this.#picture.painted !== before) this.#overlayChanged = true
        // The disc belonged to the former circles.
        if (painted.kind === 'edited') this.#touching = undefined
        this.#baseChanged = true
        this.#schedule()
      },
      marked: (highlights) => {
        this.#outlinedAt = this.#lookedAt
        this.#update({ highlights })
        this.#tell('marked', highlights)
      },
      found: (found) => this.#findingChanges(found),
      failed: (error, lost) => this.#drawingFailed(error, lost),
    })
    this.#observer = new ResizeObserver(() => this.#sizeChanges())
    this.#observer.observe(container)
    this.#watchSurroundings()
    this.#resize()
    const { signal } = this.#watching
    signal.addEventListener(
      'abort',
      store.watch((state, before) => this.#follow(state, before)),
    )
    let [selected, hovered]: (number | undefined)[] = []
    const mark = (state: ViewState) => {
      if (selectedIn(state) === selected && state.hovered === hovered) return
      selected = selectedIn(state)
      hovered = state.hovered
      this.#scene.mark(selected, hovered)
    }
    signal.addEventListener('abort', store.subscribe(mark))
  }

  /** Changes the state. `#follow` draws it. */
  #update(change: Partial<ViewState>): void {
    this.#store.update((state) => ({ ...state, ...change }))
  }

  /** Draws a new state, or asks the thread for what it lacks. */
  #follow(state: ViewState, before: ViewState): void {
    if (state.selection !== before.selection) this.#chosen = undefined
    if (state.layers !== before.layers) {
      if (isPathOnly(state.layers, before.layers)) this.#scene.findAgain(this.#drawnLayers)
      else this.#drawLayers()
      this.#tell('layers', state.layers)
    }
    if (state.camera !== before.camera) this.#cameraChanges()
    if (DRAWN_ABOVE.some((name) => state[name] !== before[name])) this.#overlayChanges()
  }

  /**
   * Replaces the circles. Without `kept`, circle i gets id i.
   * @throws CircleVoronoiError as `compute`, `region` and `fitAreas`; the view stays unchanged
   */
  setCircles(circles: Float64Array, change?: DomainChange, kept?: KeptIds): Promise<Edited> {
    this.#picture.clear()
    const opened = this.#scene.open(circles, change, kept).then((edited) => {
      this.#touching = undefined
      this.#findingChanges(undefined)
      return edited
    })
    this.#see()
    // The old pixels stay until new ones arrive, but the picture is incomplete.
    this.#schedule()
    return this.#told(opened)
  }

  /** Cancels the computation of new circles. Returns false if none is running. */
  cancel(): boolean {
    return this.#scene.cancel()
  }

  /**
   * Applies all edits or none to the current circles.
   * @throws CircleVoronoiError as `DiagramEditor.apply`, `region` and `fitAreas`; Superseded if other circles are
   * opened first. The view stays unchanged
   */
  apply(edits: readonly Edit[], change?: DomainChange): Promise<Edited> {
    return this.#told(this.#scene.edit(edits, change))
  }

  /** The circles after all finished edits. An opening creates a new table. */
  get circles(): CircleTable {
    return this.#scene.circles
  }

  /** Subscribes to an event, and returns a function that unsubscribes. */
  on<Name extends keyof ViewEvents>(name: Name, listener: (event: ViewEvents[Name]) => void): () => void {
    const listeners = this.#listeners.get(name) ?? new Set()
    this.#listeners.set(name, listeners.add(listener))
    return () => listeners.delete(listener)
  }

  get camera(): Camera {
    return this.#store.get().camera
  }

  get size(): Size {
    return this.#size
  }

  setCamera(camera: Camera): void {
    this.#update({ camera })
  }

  #cameraChanges(): void {
    const { camera } = this
    this.#tell('camera', camera)
    this.#baseChanged = true
    if (this.#picture.isSharp(camera, this.#pixelRatio)) {
      this.#see()
    } else {
      clearTimeout(this.#rest)
      this.#rest = setTimeout(() => this.#see(), REST)
    }
  }

  /**
   * Asks the thread a question. Resolves to `undefined` if the thread failed or the question's circles have been
   * replaced.
   * @throws CircleVoronoiError that says why there is no answer
   */
  ask<Name extends keyof Questions>(name: Name, ...args: Parameters<Questions[Name]>): Promise<Answer<Name>> {
    return this.#scene.ask(name, ...args)
  }

  /** The disc of a circle as it is drawn: a point if radii are weights. */
  discOf(id: number): Circle | undefined {
    const circle = this.circles.get(id)
    return circle && (this.#scene.domain.areSites === true ? { ...circle, r: 0 } : circle)
  }

  /** The circle at a point of the plane (`CircleTable.hitAt`). */
  hitAt(point: Point, slack: number, reach?: number): Hit | undefined {
    return this.#scene.hitAt(point, slack, reach)
  }

  /** The layers. They are not drawn if only circles are shown (`hasDiagram`). */
  get layers(): Layers {
    return this.#store.get().layers
  }

  /** Whether anything of the diagram is drawn besides circles. */
  get hasDiagram(): boolean {
    return this.#hasDiagram
  }

  set hasDiagram(hasDiagram: boolean) {
    if (hasDiagram === this.#hasDiagram) return
    this.#hasDiagram = hasDiagram
    this.#drawLayers()
    this.#tell('diagram', hasDiagram)
  }

  /** The names of circles, the most important first, and their own colors. */
  setIdentities(names: readonly Name[], ownColors: OwnColors | undefined): void {
    this.#names = names
    if (ownColors !== this.#ownColors) {
      this.#ownColors = ownColors
      this.#drawLayers()
    }
    this.#overlayChanges()
  }

  get #drawnLayers(): PaintedLayers {
    const shown = this.#hasDiagram ? this.layers : withoutDiagram(this.layers)
    return this.#ownColors === undefined ? shown : { ...shown, ownColors: this.#ownColors }
  }

  /**
   * Changes some layers; the others stay.
   * @throws CircleVoronoiError `badInput` if a layer is invalid. The layers stay unchanged
   */
  setLayers(change: Partial<Layers>): void {
    const layers = { ...this.layers, ...change }
    checkLayers(layers)
    this.#update({ layers })
  }

  #drawLayers(): void {
    this.#scene.setLayers(this.#drawnLayers)
    const request = this.#isShown ? this.#picture.again(this.camera, this.#size) : undefined
    if (request !== undefined) this.#scene.look(request, this.#style)
    this.#overlayChanges()
  }

  /** Shows the disc at the nearest vertex or point of an edge, if that layer is visible. */
  async showDisc(point: Point | undefined, slack: number): Promise<void> {
    this.#touchedAt = point
    const touching =
      point === undefined || !this.#drawnLayers.disc
        ? undefined
        : await this.#scene.ask('touch', point.x, point.y, slack)
    if (this.#touchedAt !== point || touching === this.#touching) return
    this.#touching = touching
    this.#overlayChanges()
  }

  /** Previews a new circle; `undefined` ends the preview. */
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
      const { x, y } = toScreen(this.camera, this.#size, path[end])
      return Math.hypot(x - point.x, y - point.y) < HANDLE_RADIUS + slack
    })
  }

  /** Moves an end of the path to a point of the plane. */
  movePathEnd(end: 'from' | 'to', point: Point): void {
    const { path } = this.layers
    if (path !== undefined) this.#update({ layers: { ...this.layers, path: { ...path, [end]: point } } })
  }

  /** Returns the visible part, or another one, as SVG text in the colors for white paper. */
  toPrint(shot: ExportView = this): Promise<string> {
    const { style } = this.#container
    const before = style.colorScheme
    style.colorScheme = 'light'
    const light = { ...readStyle(this.#container), paper: '#ffffff' }
    style.colorScheme = before
    return this.toSVG(shot, light)
  }

  /** Returns the visible part, or another one, as SVG text without selection. */
  async toSVG({ camera, size }: ExportView = this, style = this.#style): Promise<string> {
    const frame = { ...camera, ...size }
    const drawn = await this.#scene.ask('svg', frame, style, titlesOf(this.#named, this.#above))
    if (drawn === undefined) throw notDrawn()
    return svgPicture(frame, drawn, style, this.#drawnLayers, this.#named, this.#above)
  }

  /**
   * Returns the visible part, or another one, as a PNG of `scale` pixels per CSS pixel.
   * @throws CircleVoronoiError `badInput` if the picture is too large for browsers
   */
  async toPNG(scale = devicePixelRatio, { camera, size }: ExportView = this): Promise<Blob> {
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

  /** Returns a video stream of the canvas. Stopping its track ends it. */
  stream(): MediaStream {
    const { width, height } = this.#base
    const canvas = Object.assign(document.createElement('canvas'), { width, height })
    const context = canvas.getContext('2d') as CanvasRenderingContext2D
    const stream = canvas.captureStream()
    const draw = () => {
      if (stream.getTracks().every(({ readyState }) => readyState === 'ended')) return
      for (const layer of [this.#base, this.#overlay]) context.drawImage(layer, 0, 0, width, height)
      requestAnimationFrame(draw)
    }
    draw()
    return stream
  }

  /** The pixel of a point of the plane. */
  toScreen(point: Point): Point {
    return toScreen(this.camera, this.#size, point)
  }

  /** The point of the plane at a pixel. */
  toPlane(point: Point): Point {
    return toPlane(this.camera, this.#size, point)
  }

  /** The selected circle, if exactly one is selected. */
  get selected(): Circle | undefined {
    const id = selectedIn(this.#store.get())
    return id === undefined ? undefined : this.circles.get(id)
  }

  select(ids: readonly number[]): void {
    this.#update({ selection: ids })
  }

  /** The selected circles as they are drawn. */
  get #drawnSelection(): Chosen | undefined {
    this.#chosen ??= { drawn: chosenOf(this.#store.get().selection.flatMap((id) => this.discOf(id) ?? [])) }
    return this.#chosen.drawn
  }

  /** The rectangle in which circles are about to be selected. */
  set rectangle(rectangle: SelectionRectangle | undefined) {
    this.#rectangle = rectangle
    this.#overlayChanges()
  }

  /** The corners of the polygon being drawn, x and y each. The last corner follows the pointer. */
  set sketch(sketch: Float64Array | undefined) {
    this.#sketch = sketch
    this.#overlayChanges()
  }

  /** Additional layers above the picture, bottom first. They appear at the next frame without repainting. */
  set above(layers: readonly OverlayLayer[]) {
    this.#above = layers
    this.#overlayChanges()
  }

  /** The center of scaling, if the selection's handle is at a pixel. */
  handleAt(point: Point, slack: number): Point | undefined {
    const chosen = this.#drawnSelection
    if (chosen === undefined) return undefined
    const { box } = chosen
    const { x, y } = handleOf(box, (corner) => toScreen(this.camera, this.#size, corner))
    if (Math.hypot(x - point.x, y - point.y) > HANDLE_RADIUS + slack) return undefined
    return { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2 }
  }

  /** Whether the view has a visible size. */
  get isShown(): boolean {
    return this.#isShown
  }

  set isShown(isShown: boolean) {
    if (isShown === this.#isShown) return
    this.#isShown = isShown
    if (!isShown) this.#picture.clear()
    this.#resize()
  }

  /** Reads the container's style again after a change. */
  restyle(): void {
    this.#style = this.#readStyle()
    this.#picture.clear()
    this.#see()
    this.#overlayChanges()
    this.#tell('style', undefined)
  }

  #readStyle(): Style {
    const style = readStyle(this.#container)
    // Print styles use this attribute, because paper is light.
    this.#container.toggleAttribute('data-dark', isDark(style))
    return style
  }

  /** Ends all requests silently. */
  dispose(): void {
    for (const listeners of this.#listeners.values()) listeners.clear()
    this.#observer.disconnect()
    cancelAnimationFrame(this.#frame)
    clearTimeout(this.#rest)
    this.#watching.abort()
    this.#scene.close()
    this.#ondispose()
    this.#base.remove()
    this.#overlay.remove()
  }

  /**
   * Prints the screen's picture scaled (theme.css), because printing does not wait for a picture in the paper's size
   * and resolution.
   */
  #sizeChanges(): void {
    if (!matchMedia('print').matches) this.#resize()
  }

  /** Device pixels per CSS pixel of the container. */
  get #pixelRatio(): number {
    return devicePixelRatio * this.#scale
  }

  /** The scale of transforms and zoom around the container. Reductions keep the resolution. */
  #scaleOnScreen(): number {
    const scale = scaleOnScreen(this.#container)
    return scale > LEAST_ENLARGED ? Math.min(scale, MOST_SHARPENED) : 1
  }

  /** Transforms cause no event, so the scale is checked at each drawing and when the window changes. */
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
    const request = this.#picture.see(this.camera, this.#size, this.#pixelRatio)
    if (request === undefined) return
    this.#lookedAt = this.camera.scale
    this.#scene.look(request, this.#style)
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
      this.#picture.draw(context, this.camera, this.#size, this.#pixelRatio)
      this.#baseChanged = false
    }
    this.#container.ariaBusy = String(!this.#picture.isWhole || !this.#picture.isSharp(this.camera, this.#pixelRatio))
    if (this.#overlayChanged) this.#drawOverlay()
    this.#overlayChanged = false
  }

  /** The highlights on screen. Paper shows none. */
  get #standingOut(): OverlayHighlights {
    if (matchMedia('print').matches) return NOTHING_STANDS_OUT
    return {
      marks: this.#store.get().highlights,
      touching: this.#touching,
      trial: this.#trial,
      chosen: this.#drawnSelection,
      rectangle: this.#rectangle,
      sketch: this.#sketch,
    }
  }

  #drawOverlay(): void {
    const { painted } = this.#picture
    const names = painted === undefined ? { ...this.#named, list: [] } : { ...this.#named, within: painted }
    const above = { ...this.#aboveOf(this.#standingOut, this.covered()), names }
    const isEmpty = isNothingAbove(above)
    if (isEmpty && this.#isOverlayEmpty) return
    this.#isOverlayEmpty = isEmpty
    const context = this.#overlay.getContext('2d') as CanvasRenderingContext2D
    const { width, height } = this.#overlay
    const ratio = this.#pixelRatio
    const frame = { x: this.camera.x, y: this.camera.y, scale: this.camera.scale * ratio, width, height }
    context.clearRect(0, 0, width, height)
    drawOverlay(new CanvasDrawing(context), frame, ratio, this.#style, above)
  }

  #drawAbove(drawing: Drawing, frame: Frame, pixelRatio: number): void {
    drawOverlay(drawing, frame, pixelRatio, this.#style, this.#aboveOf(NOTHING_STANDS_OUT, NO_PADDING))
  }

  #aboveOf(standingOut: OverlayHighlights, covered: Padding): OverlayContent {
    // Outlines of cells were clipped to the old viewport, and are too coarse after zooming in.
    const enlarged = this.camera.scale / this.#outlinedAt
    const hasOutlines = enlarged < MOST_ENLARGED && this.#hasDiagram
    const marks = hasOutlines ? standingOut.marks : withoutCells(standingOut.marks)
    const [layers, names] = [this.#drawnLayers, this.#named]
    return { found: this.#store.get().found, layers, names, covered, above: this.#above, ...standingOut, marks }
  }

  get #named(): Names {
    return { list: this.#names, circles: this.circles, domain: this.#scene.domain }
  }

  /** Continues with a new thread, without the possible cause of the failure. */
  #drawingFailed(error: Error, { marks, layers }: Lost): void {
    // The failed request may have been one for highlights.
    if (marks) this.#update({ highlights: NO_HIGHLIGHTS, selection: [], hovered: undefined })
    if (layers) this.setLayers(DEFAULT_LAYERS)
    this.#tell('failed', error)
  }

  #findingChanges(found: GlobalResults | undefined): void {
    if (found !== this.#store.get().found) this.#update({ found })
    this.#tell('found', found)
  }

  #overlayChanges(): void {
    this.#overlayChanged = true
    this.#schedule()
  }

  #tell<Name extends keyof ViewEvents>(name: Name, event: ViewEvents[Name]): void {
    for (const listener of this.#listeners.get(name) ?? []) listener(event as never)
  }

  /** Reports the result of an edit as an event, too. */
  #told(edited: Promise<Edited>): Promise<Edited> {
    edited.then(
      (outcome) => {
        this.#chosen = undefined
        this.#overlayChanges()
        this.#tell('changed', outcome)
      },
      (error: Error) => {
        if (!(error instanceof Superseded)) this.#tell('refused', error)
      },
    )
    return edited
  }

  /** Follows changes of the color scheme, system colors, style sheets and the screen's resolution. */
  #watchSurroundings(): void {
    const { signal } = this.#watching
    // WebKit may run modules before style sheets are loaded.
    const restyleBy = ({ target }: Event) => {
      if (target instanceof HTMLLinkElement && target.relList.contains('stylesheet')) this.restyle()
    }
    document.addEventListener('load', restyleBy, { capture: true, signal })
    for (const query of ['(prefers-color-scheme: dark)', '(forced-colors: active)']) {
      matchMedia(query).addEventListener('change', () => this.restyle(), { signal })
    }
    // Printing shows the pixels painted so far.
    matchMedia('print').addEventListener('change', () => this.#drawOverlay(), { signal })
    // Other listeners of the same event may set a transform first.
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

function withoutCells({ selected, hovered }: Highlights): Highlights {
  const circleOf = (described: Highlights['selected']) =>
    described && { ...described, outline: new Float64Array(), neighborhood: new Float64Array() }
  return { selected: circleOf(selected), hovered: circleOf(hovered) }
}
