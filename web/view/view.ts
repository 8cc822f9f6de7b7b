// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Point } from '../lib/index.ts'
import { type Camera, NO_PADDING, type Padding, type Size, toPlane, toScreen } from './camera.ts'
import type { CircleTable, Hit } from './circle-table.ts'
import { type DrawnSelection, drawnSelection } from './drawn-selection.ts'
import { Events } from './events.ts'
import type { Name, Names } from './labels.ts'
import {
  checkLayers,
  isPathOnly,
  type Layers,
  type OverlayLayer,
  type OwnColors,
  type PaintedLayers,
  withoutDiagram,
} from './layers.ts'
import {
  drawOverlay,
  HANDLE_RADIUS,
  handleOf,
  isOverlayEmpty,
  NOT_HIGHLIGHTED,
  type OverlayContent,
  type OverlayHighlights,
  type SelectionRectangle,
} from './overlay.ts'
import { CanvasDrawing } from './painter/drawing.ts'
import type { Painter } from './painter.ts'
import type { GlobalResults, Highlights, Painted, Touching, Trial } from './protocol.ts'
import type { Edited, SceneClient } from './scene-client.ts'
import { Screen } from './screen.ts'
import type { Store } from './store.ts'
import type { Style } from './style.ts'
import { MOST_ENLARGED, TileBuffer } from './tile-buffer.ts'
import { NO_HIGHLIGHTS, selectedIn, type ViewState } from './view-state.ts'

/** Pause after zooming before the picture is painted sharp, in milliseconds. */
const SHARPENING_DELAY = 80

/** The parts of the state that the overlay shows. */
const DRAWN_ABOVE = ['camera', 'layers', 'selection', 'highlights', 'found'] as const

const NOTHING_MARKED = { selection: [], hovered: undefined }

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
  /** Drawing failed, or something else that no request asked for. */
  readonly failed: Error
}

/** Shows circles and their diagram in an element of a page, seen by a camera. */
export class View {
  readonly #screen: Screen
  readonly #tiles = new TileBuffer()
  /** The circles in the painting thread. */
  readonly scene: SceneClient
  readonly #store: Store<ViewState>
  #frame = 0
  #sharpening: ReturnType<typeof setTimeout> | undefined
  /** The scale of the last paint request, and the scale of the highlighted outlines. */
  #requestedScale = 1
  #outlinedAt = 1
  /** The state whose highlights were requested last. */
  #marked: Pick<ViewState, 'selection' | 'hovered'> = NOTHING_MARKED
  #disc: Touching | undefined
  /** The position of the last request for a disc. Answers for older positions are ignored. */
  #discAt: Point | undefined
  #trial: Trial | undefined
  #lastTrial = 0
  /** The selected circles as they are drawn; `undefined` if they have changed since. */
  #selection: { readonly drawn: DrawnSelection | undefined } | undefined
  #rectangle: SelectionRectangle | undefined
  #sketch: Float64Array | undefined
  #overlays: readonly OverlayLayer[] = []
  #baseChanged = false
  #overlayChanged = false
  /** Whether the overlay is empty and needs no clearing. */
  #isOverlayEmpty = true
  #hasDiagram = true
  #names: readonly Name[] = []
  #ownColors: OwnColors | undefined

  /** The borders of the picture that something covers. */
  covered: () => Padding = () => NO_PADDING

  readonly #events = new Events<ViewEvents>()
  readonly #ondispose: () => void
  readonly #unsubscribe: readonly (() => void)[]
  #isDisposed = false

  /** `ondispose` is called when the view is disposed of. */
  constructor(container: HTMLElement, painter: Painter, store: Store<ViewState>, ondispose = () => {}) {
    this.#store = store
    this.#ondispose = ondispose
    this.#screen = new Screen(container, {
      resized: () => this.#drawAll(),
      restyled: () => {
        this.#tiles.clear()
        this.#requestTiles()
        this.#overlayChanges()
        this.#events.tell('style', undefined)
      },
      printed: () => this.#drawOverlay(),
    })
    this.scene = painter.add({
      opening: () => {
        // The old pixels stay until new ones arrive, but the picture is incomplete.
        this.#tiles.clear()
        this.#requestTiles()
        this.#schedule()
      },
      changed: (outcome, picture) => {
        // They belonged to the former circles.
        this.#disc = undefined
        this.#selection = undefined
        if (picture === undefined) {
          this.#marked = NOTHING_MARKED
          this.#update({ highlights: NO_HIGHLIGHTS, found: undefined })
        } else {
          this.#put(picture)
          this.#outlinedAt = this.#requestedScale
          this.#update({ highlights: picture.marks, found: picture.found })
        }
        this.#overlayChanges()
        this.#events.tell('changed', outcome)
      },
      painted: (painted) => this.#put(painted),
      marked: (highlights) => {
        this.#outlinedAt = this.#requestedScale
        this.#update({ highlights })
      },
      found: (found) => this.#update({ found }),
      reopened: () => {
        this.#drawLayers()
        this.#mark()
      },
      failed: (error) => this.#events.tell('failed', error),
    })
    const mark = (state: ViewState) => {
      const isSame = selectedIn(state) === selectedIn(this.#marked) && state.hovered === this.#marked.hovered
      this.#marked = state
      if (!isSame) this.#mark()
    }
    this.#unsubscribe = [store.watch((state, before) => this.#follow(state, before)), store.subscribe(mark)]
    this.#drawAll()
  }

  /** Asks for the descriptions of the selected and the hovered circle. */
  #mark(): void {
    const state = this.#store.get()
    this.scene.mark(selectedIn(state), state.hovered)
  }

  /** Changes the state. `#follow` draws it. */
  #update(change: Partial<ViewState>): void {
    this.#store.update((state) => ({ ...state, ...change }))
  }

  /** Draws a new state, or asks the thread for what it lacks. */
  #follow(state: ViewState, before: ViewState): void {
    if (state.selection !== before.selection) this.#selection = undefined
    if (state.layers !== before.layers) {
      if (isPathOnly(state.layers, before.layers)) this.scene.findAgain(this.drawnLayers)
      else this.#drawLayers()
      this.#events.tell('layers', state.layers)
    }
    if (state.camera !== before.camera) this.#cameraChanges()
    if (state.highlights !== before.highlights) this.#events.tell('marked', state.highlights)
    if (state.found !== before.found) this.#events.tell('found', state.found)
    if (DRAWN_ABOVE.some((name) => state[name] !== before[name])) this.#overlayChanges()
  }

  /** The circles after all finished edits. An opening creates a new table. */
  get circles(): CircleTable {
    return this.scene.circles
  }

  /** Subscribes to an event, and returns a function that unsubscribes. */
  on<Name extends keyof ViewEvents>(name: Name, listener: (event: ViewEvents[Name]) => void): () => void {
    return this.#events.on(name, listener)
  }

  get camera(): Camera {
    return this.#store.get().camera
  }

  get size(): Size {
    return this.#screen.size
  }

  setCamera(camera: Camera): void {
    this.#update({ camera })
  }

  #cameraChanges(): void {
    const { camera } = this
    this.#events.tell('camera', camera)
    this.#baseChanged = true
    if (this.#tiles.isSharp(camera, this.#screen.pixelRatio)) {
      this.#requestTiles()
    } else {
      clearTimeout(this.#sharpening)
      this.#sharpening = setTimeout(() => this.#requestTiles(), SHARPENING_DELAY)
    }
  }

  /** The disc of a circle as it is drawn: a point if radii are weights. */
  discOf(id: number): Circle | undefined {
    const circle = this.circles.get(id)
    return circle && (this.scene.domain.areSites === true ? { ...circle, r: 0 } : circle)
  }

  /** The circle at a point of the plane (`CircleTable.hitAt`). */
  hitAt(point: Point, slack: number, reach?: number): Hit | undefined {
    return this.scene.hitAt(point, slack, reach)
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
    this.#events.tell('diagram', hasDiagram)
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

  /** The layers as the thread draws them. */
  get drawnLayers(): PaintedLayers {
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
    this.scene.setLayers(this.drawnLayers)
    const request = this.isShown ? this.#tiles.requestAll(this.camera, this.size) : undefined
    if (request !== undefined) this.scene.look(request, this.style)
    this.#overlayChanges()
  }

  /** Shows the disc at the nearest vertex or point of an edge, if that layer is visible. */
  async showDisc(point: Point | undefined, slack: number): Promise<void> {
    this.#discAt = point
    const disc =
      point === undefined || !this.drawnLayers.disc
        ? undefined
        : await this.scene.ask('touch', [point.x, point.y, slack])
    if (this.#discAt !== point || disc === this.#disc) return
    this.#disc = disc
    this.#overlayChanges()
  }

  /** Previews a new circle; `undefined` ends the preview. */
  async tryCircle(circle: Circle | undefined): Promise<void> {
    this.#lastTrial += 1
    const turn = this.#lastTrial
    const trial = circle === undefined ? undefined : await this.scene.ask('try', [circle])
    if (turn !== this.#lastTrial || trial === this.#trial) return
    this.#trial = trial
    this.#overlayChanges()
    this.#events.tell('tried', trial)
  }

  /** The end of the path at a pixel. */
  pathEndAt(point: Point, slack: number): 'from' | 'to' | undefined {
    const { path } = this.drawnLayers
    if (path === undefined) return undefined
    return (['to', 'from'] as const).find((end) => {
      const { x, y } = this.toScreen(path[end])
      return Math.hypot(x - point.x, y - point.y) < HANDLE_RADIUS + slack
    })
  }

  /** Moves an end of the path to a point of the plane. */
  movePathEnd(end: 'from' | 'to', point: Point): void {
    const { path } = this.layers
    if (path !== undefined) this.#update({ layers: { ...this.layers, path: { ...path, [end]: point } } })
  }

  /** The pixel of a point of the plane. */
  toScreen(point: Point): Point {
    return toScreen(this.camera, this.size, point)
  }

  /** The point of the plane at a pixel. */
  toPlane(point: Point): Point {
    return toPlane(this.camera, this.size, point)
  }

  /** The selected circle, if exactly one is selected. */
  get selected(): Circle | undefined {
    const id = selectedIn(this.#store.get())
    return id === undefined ? undefined : this.circles.get(id)
  }

  /** The selected circles as they are drawn. */
  get #selectionNow(): DrawnSelection | undefined {
    this.#selection ??= { drawn: drawnSelection(this.#store.get().selection.flatMap((id) => this.discOf(id) ?? [])) }
    return this.#selection.drawn
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
  get overlays(): readonly OverlayLayer[] {
    return this.#overlays
  }

  set overlays(layers: readonly OverlayLayer[]) {
    this.#overlays = layers
    this.#overlayChanges()
  }

  /** The center of scaling, if the selection's handle is at a pixel. */
  handleAt(point: Point, slack: number): Point | undefined {
    const selection = this.#selectionNow
    if (selection === undefined) return undefined
    const { box } = selection
    const { x, y } = handleOf(box, (corner) => this.toScreen(corner))
    if (Math.hypot(x - point.x, y - point.y) > HANDLE_RADIUS + slack) return undefined
    return { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2 }
  }

  /** Whether the view has pixels. */
  get isShown(): boolean {
    return this.#screen.isShown
  }

  set isShown(isShown: boolean) {
    if (isShown === this.isShown) return
    if (!isShown) this.#tiles.clear()
    this.#screen.isShown = isShown
  }

  /** Reads the container's style again after a change. */
  restyle(): void {
    this.#screen.restyle()
  }

  get style(): Style {
    return this.#screen.style
  }

  /** The style on white paper. */
  get printStyle(): Style {
    return this.#screen.printStyle
  }

  /** The canvases of the picture and of the overlay. */
  get canvases(): readonly [HTMLCanvasElement, HTMLCanvasElement] {
    return [this.#screen.base, this.#screen.overlay]
  }

  /** Ends all requests silently. */
  dispose(): void {
    this.#isDisposed = true
    this.#events.end()
    for (const end of this.#unsubscribe) end()
    cancelAnimationFrame(this.#frame)
    clearTimeout(this.#sharpening)
    this.scene.close()
    this.#ondispose()
    this.#screen.dispose()
  }

  #drawAll(): void {
    this.#baseChanged = true
    this.#overlayChanged = true
    this.#requestTiles()
    this.#schedule()
  }

  #requestTiles(): void {
    if (!this.#screen.isPainted) return
    const request = this.#tiles.request(this.camera, this.size, this.#screen.pixelRatio)
    if (request === undefined) return
    this.#requestedScale = this.camera.scale
    this.scene.look(request, this.style)
  }

  /** Shows pixels with the next frame. */
  #put(painted: Painted): void {
    const { painted: before } = this.#tiles
    this.#tiles.put(painted)
    // Names wait for their cells.
    if (this.#tiles.painted !== before) this.#overlayChanged = true
    this.#baseChanged = true
    this.#schedule()
  }

  #schedule(): void {
    if (this.#frame === 0 && !this.#isDisposed) this.#frame = requestAnimationFrame(() => this.#draw())
  }

  #draw(): void {
    this.#frame = 0
    if (!this.isShown) return
    this.#screen.checkScale()
    if (this.#baseChanged) {
      const context = this.#screen.base.getContext('2d') as CanvasRenderingContext2D
      this.#tiles.draw(context, this.camera, this.size, this.#screen.pixelRatio)
      this.#baseChanged = false
    }
    this.#screen.isBusy = !this.#tiles.isWhole || !this.#tiles.isSharp(this.camera, this.#screen.pixelRatio)
    if (this.#overlayChanged) this.#drawOverlay()
    this.#overlayChanged = false
  }

  /** The highlights on screen. Paper shows none. */
  get #highlights(): OverlayHighlights {
    if (matchMedia('print').matches) return NOT_HIGHLIGHTED
    const { highlights } = this.#store.get()
    // Outlines of cells were clipped to the old viewport, and are too coarse after zooming in.
    const enlarged = this.camera.scale / this.#outlinedAt
    const hasOutlines = enlarged < MOST_ENLARGED && this.#hasDiagram
    return {
      highlights: hasOutlines ? highlights : withoutCells(highlights),
      touching: this.#disc,
      trial: this.#trial,
      selection: this.#selectionNow,
      rectangle: this.#rectangle,
      sketch: this.#sketch,
    }
  }

  /** The names of circles, and what places them. */
  get names(): Names {
    return { list: this.#names, circles: this.circles, domain: this.scene.domain }
  }

  /** The overlay without highlights. */
  get overlayContent(): OverlayContent {
    const { drawnLayers: layers, names, overlays } = this
    return { ...NOT_HIGHLIGHTED, found: this.#store.get().found, layers, names, overlays, covered: NO_PADDING }
  }

  #drawOverlay(): void {
    const { painted } = this.#tiles
    const names = painted === undefined ? { ...this.names, list: [] } : { ...this.names, within: painted }
    const content = { ...this.overlayContent, ...this.#highlights, names, covered: this.covered() }
    const isEmpty = isOverlayEmpty(content)
    if (isEmpty && this.#isOverlayEmpty) return
    this.#isOverlayEmpty = isEmpty
    const context = this.#screen.overlay.getContext('2d') as CanvasRenderingContext2D
    const { width, height } = this.#screen.overlay
    const ratio = this.#screen.pixelRatio
    const frame = { x: this.camera.x, y: this.camera.y, scale: this.camera.scale * ratio, width, height }
    context.clearRect(0, 0, width, height)
    drawOverlay(new CanvasDrawing(context), frame, ratio, this.style, content)
  }

  #overlayChanges(): void {
    this.#overlayChanged = true
    this.#schedule()
  }
}

function withoutCells({ selected, hovered }: Highlights): Highlights {
  const circleOf = (described: Highlights['selected']) =>
    described && { ...described, outline: new Float64Array(), neighborhood: new Float64Array() }
  return { selected: circleOf(selected), hovered: circleOf(hovered) }
}
