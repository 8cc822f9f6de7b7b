// SPDX-License-Identifier: GPL-3.0-or-later

import { at, circleAt } from '../../lib/base/diagram-data.ts'
import type { Box, Diagram, Edit, Float64s } from '../../lib/index.ts'
import type { Metrics } from '../../lib/metrics.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import type { CircleChange, KeptIds } from '../circle-table.ts'
import type { DiagramCounts } from '../diagram-counts.ts'
import type { Name } from '../labels.ts'
import {
  DEFAULT_LAYERS,
  isAnythingFound,
  isMethodShown,
  isTraced,
  type PaintedLayers,
  repeatingLayers,
} from '../layers.ts'
import type { Described, DomainChange, DrawnSvg, GlobalResults, Highlights, Lasting, Patch } from '../protocol.ts'
import type { Style } from '../style.ts'
import { idOf } from './cell-boxes.ts'
import { Centers } from './centers.ts'
import { Clip } from './clip.ts'
import { commandsOf } from './commands.ts'
import type { Drawing } from './drawing.ts'
import { found } from './found.ts'
import { boundsOf, type Frame, toleranceOf } from './frame.ts'
import { frameOf } from './grid.ts'
import { cellArea, cellPerimeter } from './measures.ts'
import { methodResult } from './method-layers.ts'
import { paint } from './paint.ts'
import { PaintContext } from './paint-context.ts'
import { type Difference, Picture } from './picture.ts'
import { leastFirst } from './ring.ts'
import { finished } from './scheduler.ts'
import { SvgDrawing } from './svg-drawing.ts'
import { Tiles, type ViewportRequest } from './tiles.ts'
import { addTitles } from './titles.ts'
import { RepeatedDiagram, Torus } from './torus.ts'

/** Queries faster than this (seconds) run with each edit; slower ones wait for a pause. */
const QUICK = 0.005
/** Limit in seconds for a power diagram to be recomputed with each edit. */
const QUICK_POWER = 0.01
/** With more neighbors than this, only the circle's own cell is highlighted. */
const MOST_NEIGHBORS = 500

/** The circles if they have changed, because they repeat, and their colors. */
interface OpenResult {
  readonly circles: Float64s | undefined
  readonly colors: string | undefined
  readonly lasting: Lasting
  /** The computing time. */
  readonly seconds: number
}

function secondsSince(start: number): number {
  return (performance.now() - start) / 1000
}

/** The diagram of one view and the tiles already sent to it. */
export class PaintedScene {
  readonly library: CircleVoronoi
  /** The diagram and how it is drawn. */
  picture: Picture
  /** The requested layers. */
  #layers: PaintedLayers = DEFAULT_LAYERS
  /** Duration of the last computation of global results. */
  #findingSeconds = 0
  /** Whether the global results are up to date. */
  #isFound = false
  /** The module of metrics once loaded, and the duration of the last power diagram. */
  #metrics: Metrics | undefined
  #powerSeconds = 0
  readonly tiles = new Tiles((...frame) => this.draw(...frame))
  #hint = -1
  #selected: number | undefined
  #hovered: number | undefined

  /** A scene starts without circles. */
  constructor(library: CircleVoronoi) {
    this.library = library
    this.picture = new Picture(library.edit([]))
  }

  /**
   * Replaces the circles. Without `kept`, circle i gets id i. `regions` is required for a region.
   * @throws CircleVoronoiError as `edit` of the library and `region`; the scene stays unchanged
   */
  open(circles: Float64Array, change: DomainChange = {}, regions?: Regions, kept?: KeptIds): OpenResult {
    const clip = this.#clipOf(change, regions)
    const torus = this.#torusOf(change)
    const start = performance.now()
    const opened = torus?.wrappedCircles(circles) ?? circles
    const editor = this.library.edit(opened, kept)
    const seconds = secondsSince(start)
    const picture = new Picture(editor, clip, torus)
    const { areSites } = this.picture
    const layers = this.#layers
    picture.areSites = change.areSites ?? areSites
    this.dispose()
    this.picture = picture
    this.#findingSeconds = 0
    this.#hint = -1
    // The selected ids belonged to the former circles.
    this.#selected = undefined
    this.#hovered = undefined
    if (change.colors !== undefined) picture.recolor(change.colors)
    if (change.lasting !== undefined) picture.lasting = change.lasting
    this.setLayers(layers)
    return {
      colors: picture.newColors(),
      lasting: picture.lasting,
      circles: opened === circles ? undefined : opened.slice(),
      seconds,
    }
  }

  /** The clipping region after a change. */
  #clipOf({ region }: DomainChange, regions: Regions | undefined): Clip | undefined {
    if (region === undefined) return this.picture.clip
    return region === null ? undefined : new Clip(this.library, (regions as Regions).region(region))
  }

  /** The box of repeating circles after a change. */
  #torusOf({ lattice }: DomainChange): Torus | undefined {
    if (lattice === undefined) return this.picture.torus
    return lattice === null ? undefined : new Torus(this.library, lattice)
  }

  dispose(): void {
    this.picture.centers?.dispose()
    this.picture.editor.dispose()
  }

  /** Sets the visible layers. */
  setLayers(asked: PaintedLayers, isPainted = true): void {
    const picture = this.picture
    this.#layers = asked
    const layers = picture.torus === undefined ? asked : repeatingLayers(asked)
    const { candidates, sampleCount } = picture.layers
    this.#isFound = false
    picture.layers = layers
    if (!layers.delaunay && !layers.ordinary) {
      picture.centers?.dispose()
      picture.centers = undefined
    } else {
      picture.centers ??= new Centers(this.library, picture.diagram)
    }
    if (!layers.power) picture.power = undefined
    const isSame = candidates === layers.candidates && sampleCount === layers.sampleCount
    if (!isMethodShown(layers) || !isSame) picture.method = undefined
    if (isPainted) this.tiles.restart()
  }

  /** Whether the power diagram is visible but not computed. */
  get isPowerMissing(): boolean {
    return this.picture.layers.power && this.picture.power === undefined
  }

  /** Computes the power diagram of the current circles. */
  addPower(metrics: Metrics): void {
    this.#metrics = metrics
    this.#isFound = false
    this.#computePower(metrics)
    this.tiles.restart()
  }

  #computePower({ compute }: Metrics): void {
    const start = performance.now()
    this.picture.setPower(compute(this.picture.diagram.circles, { metric: 'power' }))
    this.#powerSeconds = secondsSince(start)
  }

  /** Updates the power diagram after an edit if that is fast. Returns whether it was. */
  #followPower(): boolean {
    if (!this.isPowerMissing || this.#metrics === undefined || this.#powerSeconds > QUICK_POWER) return false
    this.#computePower(this.#metrics)
    return true
  }

  /** Whether a layer of the method is visible but not computed. */
  get isMethodMissing(): boolean {
    const { diagram, method } = this.picture
    return method === undefined && isTraced(this.picture.layers, diagram.circles.length / 3)
  }

  /** Runs the touching disc method on the current circles. */
  addMethod(): void {
    this.#isFound = false
    this.picture.setMethod(methodResult(this.library, this.picture.diagram, this.picture.layers))
    this.tiles.restart()
  }

  /** Whether visible layers need global results that are missing. */
  get isAnythingToFind(): boolean {
    return !this.#isFound && isAnythingFound(this.picture.layers)
  }

  /** Whether the results include a path, whose outline depends on the scale. */
  get isPathFound(): boolean {
    return this.picture.layers.path !== undefined
  }

  /** Whether global results are fast enough to be computed with each edit. */
  get isFoundQuickly(): boolean {
    return this.#findingSeconds < QUICK
  }

  /** Computes the global results. */
  find(): GlobalResults {
    return finished(this.findInSteps())
  }

  /** Computes the global results in steps. The circles must stay the same meanwhile. */
  *findInSteps(): Generator<void, GlobalResults> {
    const scale = this.tiles.viewport?.grid.scale
    const tolerance = scale === undefined ? this.picture.lasting.cellWidth / 1000 : toleranceOf({ scale })
    const steps = found(this.picture, tolerance)
    for (let seconds = 0; ; ) {
      const start = performance.now()
      const step = steps.next()
      seconds += secondsSince(start)
      if (step.done === true) {
        this.#isFound = true
        this.#findingSeconds = seconds
        return step.value
      }
      yield
    }
  }

  /** Draws a frame. */
  draw(drawing: Drawing, frame: Frame, pixelRatio: number, style: Style): void {
    paint(new PaintContext(drawing, frame, pixelRatio, this.picture, style))
  }

  /** Draws a frame as SVG, with global results at the frame's precision. `names` are tooltips. */
  svg(frame: Frame, style: Style, names: readonly Name[]): DrawnSvg {
    const drawing = new SvgDrawing()
    const painting = new PaintContext(drawing, frame, 1, this.picture, style)
    paint(painting)
    addTitles(drawing, painting, names)
    return { elements: String(drawing), found: finished(found(this.picture, toleranceOf(frame))) }
  }

  counts(): DiagramCounts {
    const { count, torus, diagram } = this.picture
    const { circles, hidden, vertices, edges } = diagram
    if (torus !== undefined) {
      const cells = Array.from({ length: count }, (_, i) => Number(diagram.cells.exists(i)))
      const visible = cells.reduce((sum, exists) => sum + exists, 0)
      // Each vertex has three edges, and V - E + F = 0.
      return { circles: count, hidden: count - visible, vertices: 2 * visible, edges: 3 * visible }
    }
    return {
      circles: circles.length / 3,
      hidden: hidden.length / 2,
      vertices: vertices.length / 3,
      edges: edges.length / 4,
    }
  }

  /**
   * Edits the circles, and repaints the affected tiles. `regions` is as in `open`.
   * @throws CircleVoronoiError as `DiagramEditor.apply` and `region`; the scene stays unchanged
   */
  edit(
    edits: readonly Edit[],
    domain: DomainChange = {},
    regions?: Regions,
  ): {
    patches: Patch[]
    boxes: readonly Box[]
    change: CircleChange
    found: GlobalResults | undefined
    colors: string | undefined
    lasting: Lasting
    seconds: number
  } {
    const clip = this.#clipOf(domain, regions)
    const torus = this.#torusOf(domain)
    const start = performance.now()
    const change = this.picture.editor.apply(this.#wrapped(edits, torus))
    const seconds = secondsSince(start)
    const { areSites = this.picture.areSites, colors } = domain
    const isRepeatedOtherwise = torus !== this.picture.torus
    const isOtherwiseDrawn = areSites !== this.picture.areSites || colors !== undefined
    const isElsewhere = clip !== this.picture.clip || isOtherwiseDrawn || isRepeatedOtherwise
    this.picture.clip = clip
    const { boxes, isEverywhere } = isRepeatedOtherwise ? this.#repeatIn(torus) : this.picture.apply(change)
    this.picture.areSites = areSites
    if (colors !== undefined) this.picture.recolor(colors)
    // Repaints all visible tiles together, so that no part of an animation lags behind.
    const isAtOnce = (this.#followPower() || this.picture.torus !== undefined) && !isElsewhere
    const patches = isElsewhere ? [] : this.#repaint(isAtOnce ? undefined : boxes)
    if ((isEverywhere && !isAtOnce) || isElsewhere) this.tiles.restart()
    this.#isFound = false
    const { inserted, removed, replaced, circles } = change
    return {
      patches,
      boxes,
      change: { inserted, removed, replaced, circles },
      colors: this.picture.newColors(),
      lasting: this.picture.lasting,
      found: this.isFoundQuickly ? this.find() : undefined,
      seconds,
    }
  }

  /** Repaints boxes and missing tiles that are visible. `undefined` repaints all tiles. */
  #repaint(boxes: readonly Box[] | undefined): Patch[] {
    const { tiles } = this
    try {
      return [...tiles.release(), ...tiles.repaint(boxes), ...tiles.paintSeen()]
    } catch {
      // The edit is made. Painting fails again in a slice, which reports the error.
      tiles.restart()
      return []
    }
  }

  /** Edits that move all circles into the box. */
  #wrapped(edits: readonly Edit[], torus: Torus | undefined): readonly Edit[] {
    if (torus === undefined) return edits
    const own = edits.map((edit) => torus.wrappedEdit(edit))
    if (torus === this.picture.torus) return own
    const snapshot = this.picture.editor.snapshot()
    const edited = new Set(edits.flatMap((edit) => (edit.kind === 'insert' ? [] : [edit.id])))
    const wrapped = torus.wrappedCircles(snapshot.circles)
    const moved: Edit[] = []
    for (let i = 0; wrapped !== snapshot.circles && i < snapshot.circles.length / 3; i++) {
      const [id, circle] = [idOf(snapshot, i), circleAt(wrapped, i)]
      const { x, y } = circleAt(snapshot.circles, i)
      if (!edited.has(id) && (x !== circle.x || y !== circle.y)) moved.push({ kind: 'replace', id, circle })
    }
    return [...moved, ...own]
  }

  /** Changes the box in which the circles repeat. */
  #repeatIn(torus: Torus | undefined): Difference {
    const { editor, clip, centers } = this.picture
    centers?.dispose()
    this.picture = new Picture(editor, clip, torus, this.picture)
    this.setLayers(this.#layers, false)
    return { boxes: [], isEverywhere: true }
  }

  /** Sets the viewport. Returns whether it covers another box or has another scale. */
  look(request: ViewportRequest): { isElsewhere: boolean; isOtherScale: boolean } {
    const turned = this.tiles.turnTo(request)
    if (turned.isOtherScale) this.#isFound = false
    return turned
  }

  /** The id of the circle whose cell contains a point; -1 if there is none. */
  readonly nearest = (x: number, y: number): number => {
    const { diagram } = this.picture
    if (diagram instanceof RepeatedDiagram) {
      const image = diagram.periodic.find(x, y)
      return image === undefined ? -1 : idOf(diagram, image.circle)
    }
    this.#hint = this.picture.editor.nearest(x, y, this.#hint)
    return this.#hint
  }

  /** Sets the highlighted circles. */
  mark(selected: number | undefined, hovered: number | undefined): Highlights {
    this.#selected = selected
    this.#hovered = hovered
    return this.marks()
  }

  get isAnythingMarked(): boolean {
    return this.#selected !== undefined || this.#hovered !== undefined
  }

  /** The descriptions and outlines of the highlighted circles. */
  marks(): Highlights {
    return { selected: this.#describe(this.#selected, true), hovered: this.#describe(this.#hovered, false) }
  }

  #describe(id: number | undefined, isMeasured: boolean): Described | undefined {
    const { diagram, limits } = this.picture
    const { circles, cells, hidden, numbers } = diagram
    const i = id === undefined ? -1 : diagram.indexOf(id)
    if (id === undefined || i < 0) return undefined
    const idOf = (k: number) => numbers?.circles[k] ?? k
    let hiddenBy: number | undefined
    for (let h = 0; h < hidden.length; h += 2) if (at(hidden, h) === i) hiddenBy = idOf(at(hidden, h + 1))
    const neighbors = [...new Set(diagram.neighbors(i))]
    // Cells of images may lack neighbors.
    const whole = neighbors.filter((k) => k < this.picture.count)
    return {
      id,
      circle: { ...circleAt(circles, i), ...(this.picture.areSites && { r: 0 }) },
      color: this.tiles.viewport && this.picture.palette(this.tiles.viewport.style)[this.picture.colorOf(i)],
      hiddenBy,
      isBounded: cells.isBounded(i),
      size: isMeasured
        ? { area: cellArea(diagram, i, limits), perimeter: cellPerimeter(diagram, i, limits) }
        : undefined,
      neighbors: Int32Array.from(leastFirst([...new Set(neighbors.map(idOf))])),
      outline: this.outlineOf([i]),
      neighborhood: this.outlineOf(whole.length > MOST_NEIGHBORS ? [] : whole),
    }
  }

  /** The outlines of cells at the precision of the viewport (`replay`). */
  readonly outlineOf = (circles: readonly number[], diagram: Diagram = this.picture.diagram): Float64Array => {
    if (this.tiles.viewport === undefined) return new Float64Array()
    const { grid, wanted } = this.tiles.viewport
    const tolerance = toleranceOf(grid)
    const { clip, maxDistance } = this.picture.limits
    if (clip !== undefined)
      return commandsOf((context) => clip.drawCells(diagram, circles, { context, tolerance, maxDistance }))
    const options = { bounds: boundsOf(frameOf(grid, wanted)), tolerance, maxDistance }
    return commandsOf((context) => {
      for (const i of circles) diagram.cellPath(i, { context, ...options })
    })
  }
}
