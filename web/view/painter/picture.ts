// SPDX-License-Identifier: GPL-3.0-or-later
import { at, NONE } from '../../lib/base/diagram-data.ts'
import type { Box, Change, Diagram, DiagramEditor, DiagramSnapshot, Point } from '../../lib/index.ts'
import { boundingBox } from '../camera.ts'
import {
  type CellColors,
  type DataLayer,
  DEFAULT_LAYERS,
  isMeasure,
  type MethodLayer,
  MOST_MAPPED,
  type OwnColors,
  type PaintedLayers,
} from '../layers.ts'
import type { Lasting, Legend } from '../protocol.ts'
import { MAP_COLORS, SHADES, type Style } from '../style.ts'
import { BoxIndex } from './box-index.ts'
import { addAround, boxAt, EMPTY_BOX, emptyBoxes, union } from './boxes.ts'
import { addCell, addStar, cellBoxes, idOf, starBoxes } from './cell-boxes.ts'
import type { Clip } from './clip.ts'
import { Coloring } from './coloring.ts'
import { type CellLimits, cellArea, Measures } from './measures.ts'
import type { MethodResult } from './method-layers.ts'
import { RepeatedDiagram, type Torus } from './torus.ts'

/** Length at which unbounded edges are cut, relative to the extent of all circles. */
const HORIZON = 1000
/** Once circles are farther apart than that many former extents, edges are cut elsewhere. */
const GROWTH = 10

const NO_MOVES: readonly Point[] = [{ x: 0, y: 0 }]

/** A static diagram that edits do not update, with the index of its cells. */
export interface StaticDiagram {
  readonly diagram: Diagram
  readonly index: BoxIndex
}

/** The visible difference after an edit. */
export interface Difference {
  readonly boxes: readonly Box[]
  /** Whether the picture may differ outside of the boxes. */
  readonly isEverywhere: boolean
}

/** The picture of another editor, which the changes of a picture's circles edit as well. */
export interface FollowingPicture {
  readonly picture: Picture
  apply(change: Change): Difference
  dispose(): void
}

/** A client's layer with the index of its parts. */
export interface IndexedData {
  readonly layer: Pick<DataLayer, 'points' | 'segments' | 'discs'>
  /** A CSS color, or the name of a style's color. */
  readonly color: string
  readonly points: BoxIndex | undefined
  readonly segments: BoxIndex | undefined
  readonly discs: BoxIndex | undefined
}

/** The contents of a picture: an editor's diagram with spatial indices, and its colors. */
export class Picture {
  readonly editor: DiagramEditor
  /** The editor's current diagram, extended by images if the circles repeat. */
  diagram: DiagramSnapshot
  /** The bounding boxes of circles and their cells, by circle id. */
  index: BoxIndex
  /** The box in which the circles repeat, if they do. */
  readonly torus: Torus | undefined
  /** The editor's current diagram without images. */
  readonly #snapshot: DiagramSnapshot
  /** The bounding box of all circles and cells without images. */
  #extent: Box = EMPTY_BOX
  /** The parts that no edit changes. */
  lasting: Lasting
  /** The box around all circles when `reach` was last chosen. */
  #around: Box
  /** The diagram of the centers, if a visible layer needs it. */
  centers: FollowingPicture | undefined
  /** The power diagram of the current circles, if a visible layer needs it. */
  power: StaticDiagram | undefined
  data: readonly IndexedData[] = []
  /** The touching disc method's results for the current circles, if a visible layer needs them. */
  method: (MethodResult & { readonly layers: readonly (IndexedData & { readonly color: MethodLayer })[] }) | undefined
  #layers: PaintedLayers = DEFAULT_LAYERS
  #clip: Clip | undefined
  /** Whether circles are drawn as points. */
  areSites = false
  #measures: Measures | undefined
  #areas: Measures | undefined
  #gaps: Measures | undefined
  /** The colors of circles once they have been shown. */
  #coloring: Coloring | undefined
  /** The bounding boxes of circles' centers with those of their neighbors, by id, computed on demand. */
  #stars: BoxIndex | undefined
  #hiddenBy: Map<number, number[]> | undefined

  /** Takes ownership of the editor. `former`: a picture of the same circles, whose colors they keep. */
  constructor(editor: DiagramEditor, clip?: Clip, torus?: Torus, former?: Picture) {
    if (former !== undefined) this.#coloring = former.#coloring
    this.#clip = clip
    this.editor = editor
    this.torus = torus
    this.#snapshot = editor.snapshot()
    this.diagram = torus?.diagramOf(this.#snapshot) ?? this.#snapshot
    this.#around = boundingBox(this.#snapshot.circles)
    this.lasting = {
      automatic: this.count <= MOST_MAPPED ? 'different' : 'radius',
      cellWidth: cellWidthOf(this.#snapshot, this.#around, torus),
    }
    this.index = this.#indexed()
  }

  /** Length at which unbounded edges are cut. */
  get reach(): number {
    return HORIZON * extentOf(this.#around)
  }

  /** The number of circles without images. */
  get count(): number {
    return this.#snapshot.circles.length / 3
  }

  /** The offsets of the copies that are visible in a box. */
  copiesIn(seen: Box): readonly Point[] {
    return this.torus?.copiesIn(this.#extent, seen) ?? NO_MOVES
  }

  /** The canonical point among the repeated images of a point. */
  home(x: number, y: number): Point {
    return this.diagram instanceof RepeatedDiagram ? this.diagram.home(x, y) : { x, y }
  }

  /** Whether the edge of a side is drawn with this side. Each edge is drawn with one of its two sides. */
  draws(side: number): boolean {
    return this.diagram instanceof RepeatedDiagram ? this.diagram.draws(side) : (side & 1) === 0
  }

  #indexed(): BoxIndex {
    if (!(this.diagram instanceof RepeatedDiagram)) return new BoxIndex(cellBoxes(this.diagram, this.reach))
    const boxes = this.diagram.cellBoxes(this.reach)
    this.#extent = EMPTY_BOX
    for (let k = 0; k < boxes.length / 4; k++) this.#extent = union(this.#extent, boxAt(boxes, k))
    return new BoxIndex(boxes)
  }

  get layers(): PaintedLayers {
    return this.#layers
  }

  set layers(layers: PaintedLayers) {
    const before = this.#layers
    this.#layers = layers
    if (layers.maxDistance !== before.maxDistance) this.#limitsChange()
    const cells = layers.cells === 'auto' ? this.lasting.automatic : layers.cells
    const { column } = layers
    if (column !== undefined) {
      if (column !== before.column || this.#measures === undefined) {
        this.#measures = new Measures('column', this.diagram, {}, column)
      }
    } else if (!isMeasure(cells)) this.#measures = undefined
    else if (cells === 'area') this.#measures = this.areas()
    else if (cells === 'gap') this.#measures = this.gaps()
    else if (this.#measures?.measure !== cells) this.#measures = new Measures(cells, this.diagram, this.limits)
    if (cells === 'different') this.#hasColors()
    if (!layers.dual) this.#stars = undefined
    if (layers.data !== before.data) this.data = layers.data.map((layer) => indexed(layer, layer.color))
  }

  #hasColors(): Coloring {
    this.#coloring ??= new Coloring(this.#snapshot)
    return this.#coloring
  }

  /** Gives the circles the colors that they had elsewhere (`Coloring.take`). */
  recolor(digits: string): void {
    this.#hasColors().take(this.#snapshot, digits)
  }

  /** The colors of all circles if they have changed since the last call. */
  newColors(): string | undefined {
    return this.#coloring?.news(this.#snapshot)
  }

  /** The clipping region, if any. */
  get clip(): Clip | undefined {
    return this.#clip
  }

  set clip(clip: Clip | undefined) {
    if (clip === this.#clip) return
    this.#clip = clip
    this.#limitsChange()
  }

  /** The limits of the cells. */
  get limits(): CellLimits {
    return { clip: this.#clip, maxDistance: this.#layers.maxDistance }
  }

  /** The limits change the areas. */
  #limitsChange(): void {
    this.#areas = undefined
    if (this.#measures?.measure === 'area') this.#measures = this.areas()
    if (this.#measures?.measure === 'filled') this.#measures = new Measures('filled', this.diagram, this.limits)
  }

  /** Sets the power diagram of the circles. */
  setPower(diagram: Diagram): void {
    this.power = { diagram, index: new BoxIndex(cellBoxes(diagram, this.reach)) }
  }

  setMethod(result: MethodResult): void {
    this.method = { ...result, layers: result.data.map((layer) => indexed(layer, layer.name)) }
  }

  /** The quantity that colors show, with `auto` resolved. `column` stands for a client's values. */
  get colors(): CellColors | 'column' {
    if (this.#layers.column !== undefined) return 'column'
    return this.#layers.cells === 'auto' ? this.lasting.automatic : this.#layers.cells
  }

  /** Whether colors show a ramp, in place of the colors that tell neighbors from each other. */
  get hasRamp(): boolean {
    const { colors } = this
    return colors === 'column' ? this.#layers.column?.categories === undefined : isMeasure(colors)
  }

  /** The colors of circles and cells, by their numbers. */
  palette({ ramp, map }: Style): readonly string[] {
    return [...(this.hasRamp ? ramp : map), ...(this.#ownColors?.colors ?? [])]
  }

  /** The colors of single circles, unless somebody chose a quantity for colors to show. */
  get #ownColors(): OwnColors | undefined {
    const { cells, column, ownColors } = this.#layers
    return column === undefined && !isMeasure(cells) ? ownColors : undefined
  }

  /** The number of the color of circle `i` and its cell in the palette; `NONE` if the cell has no color. */
  colorOf(i: number): number {
    const own = this.#ownColors?.values[idOf(this.diagram, i)] ?? Number.NaN
    if (!Number.isNaN(own)) return own + (this.hasRamp ? SHADES : MAP_COLORS)
    if (this.#measures !== undefined) return this.#measures.shadeOf(i)
    return this.colors === 'different' ? (this.#coloring?.colorOf(idOf(this.diagram, i)) ?? 0) : 0
  }

  /** Whether discs are colored and cells show a fainter tint. Otherwise only cells are colored. */
  get areDiscsColored(): boolean {
    const { colors } = this
    const { column } = this.#layers
    return column === undefined ? ['radius', 'different', 'none'].includes(colors) : column.categories !== undefined
  }

  /** The meaning of the shades; `undefined` if colors show no quantity. */
  get legend(): Legend | undefined {
    return this.#measures?.legend
  }

  /** The areas of cells, computed on demand. */
  areas(): Measures {
    this.#areas ??= new Measures('area', this.diagram, this.limits)
    return this.#areas
  }

  /** The area of the cell of a circle with an index. */
  areaOf(i: number): number {
    return cellArea(this.diagram, i, this.limits)
  }

  /** The distances to the nearest other circles, computed on demand. */
  gaps(): Measures {
    this.#gaps ??= new Measures('gap', this.diagram)
    return this.#gaps
  }

  /** The indices, in increasing order, of circles that may meet a box, themselves or with their cells. */
  circlesIn(box: Box): number[] {
    return this.#indicesOf(this.index.search(box))
  }

  /** The indices, in increasing order, of circles whose segments to their neighbors' centers may meet a box. */
  starsIn(box: Box): number[] {
    const { diagram } = this
    this.#stars ??= new BoxIndex(diagram instanceof RepeatedDiagram ? diagram.starBoxes() : starBoxes(diagram))
    return this.#indicesOf(this.#stars.search(box))
  }

  /** The indices of the circles that a circle hides. */
  hiddenBy(i: number): readonly number[] {
    this.#hiddenBy ??= hiddenByHider(this.diagram)
    return this.#hiddenBy.get(i) ?? []
  }

  /**
   * Applies an edit, and returns boxes around the visible difference. An inserted circle changes nothing outside its
   * cell, a removed one nothing outside its former cell, and a moved one nothing outside both. If a layer depends on
   * whole cells, the neighbors' cells are added.
   */
  apply(change: Change): Difference {
    if (this.torus !== undefined) return this.#repeat(this.torus, change)
    const { removed, replaced, inserted, cells, hidden, shown } = change
    const before = this.#lookOf([...removed, ...replaced, ...hidden, ...shown], cells)
    this.diagram.apply(change)
    this.#hiddenBy = undefined
    this.power = undefined
    const isMethodShown = this.method !== undefined
    this.method = undefined
    const changed = new Set([...inserted, ...replaced, ...shown, ...cells, ...hidden])
    for (const id of removed) {
      this.index.delete(id)
      this.#stars?.delete(id)
    }
    const grows = this.#grows(change)
    if (grows) this.index = this.#indexed()
    for (const id of changed) this.#place(id)
    this.#measures?.forget(changed)
    this.#areas?.forget(changed)
    this.#gaps?.forget(changed)
    this.#coloring?.follow(this.#snapshot, change)
    const boxes = [before, this.#lookOf([...replaced, ...inserted, ...hidden, ...shown], cells)]
    boxes.push(...(this.centers?.apply(change).boxes ?? []))
    return {
      boxes: boxes.filter(({ minX, maxX }) => minX <= maxX),
      isEverywhere: grows || isMethodShown || this.#layers.power,
    }
  }

  /** Whether an edit brings circles so far out that edges must be drawn farther. */
  #grows({ circles }: Change): boolean {
    const box = emptyBoxes(1)
    for (let k = 0; k < circles.length; k += 3) {
      addAround(box, 0, at(circles, k), at(circles, k + 1), at(circles, k + 2))
    }
    if (extentOf(union(this.#around, boxAt(box, 0))) <= GROWTH * extentOf(this.#around)) return false
    this.#around = boundingBox(this.#snapshot.circles)
    return true
  }

  /** Rebuilds everything except the colors of cells. */
  #repeat(torus: Torus, change: Change): Difference {
    this.#snapshot.apply(change)
    this.diagram = torus.diagramOf(this.#snapshot)
    this.index = this.#indexed()
    this.#stars = undefined
    this.#hiddenBy = undefined
    this.#areas = undefined
    this.#gaps = undefined
    this.#measures = undefined
    this.layers = this.#layers
    this.#coloring?.follow(this.#snapshot, change)
    return { boxes: [], isEverywhere: true }
  }

  #indicesOf(ids: readonly number[]): number[] {
    return ids.map((id) => this.diagram.indexOf(id)).sort((i, j) => i - j)
  }

  #lookOf(ids: readonly number[], cells: Iterable<number>): Box {
    const { dual, nearZero, hidden } = this.#layers
    const { colors } = this
    const isWide = colors === 'area' || colors === 'filled' || colors === 'degree' || colors === 'gap'
    const all = isWide || dual || hidden || nearZero !== undefined ? [...ids, ...cells] : ids
    return all.reduce((box, id) => union(union(box, this.index.get(id)), this.#stars?.get(id) ?? EMPTY_BOX), EMPTY_BOX)
  }

  /** Indexes the box of a circle and its cell. */
  #place(id: number): void {
    const i = this.diagram.indexOf(id)
    if (i === NONE) return
    this.index.set(id, (boxes, k) => addCell(boxes, k, this.diagram, i, this.reach))
    this.#stars?.set(id, (boxes, k) => addStar(boxes, k, this.diagram, i))
  }
}

/** Number of circles from which the distance of neighbors is estimated. */
const GAP_SAMPLE = 1000
/** The share of circles whose nearest neighbors are at most that far away. */
const GAP_SHARE = 0.9

function extentOf({ minX, minY, maxX, maxY }: Box): number {
  return Math.max(maxX - minX, maxY - minY)
}

/** The approximate distance between neighboring circles, which are in a box and may repeat. */
function cellWidthOf(diagram: Diagram, box: Box, torus: Torus | undefined): number {
  const count = diagram.circles.length / 3
  const area = torus?.area ?? (box.maxX - box.minX) * (box.maxY - box.minY)
  // Circles in a row have hardly any area between them.
  const usual = count === 0 ? 1 : Math.max(Math.sqrt(area / count), extentOf(box) / count)
  return Math.min(usual, 2 * wideGap(diagram)) || usual
}

/** A distance of centers beyond which few circles have their nearest neighbor; infinite for single circles. */
function wideGap(diagram: Diagram): number {
  const { circles } = diagram
  const count = circles.length / 3
  const step = Math.max(Math.floor(count / GAP_SAMPLE), 1)
  const gaps: number[] = []
  for (let i = 0; i < count; i += step) {
    let least = Number.POSITIVE_INFINITY
    for (const j of diagram.neighbors(i)) {
      const [dx, dy] = [at(circles, 3 * i) - at(circles, 3 * j), at(circles, 3 * i + 1) - at(circles, 3 * j + 1)]
      least = Math.min(least, Math.hypot(dx, dy))
    }
    if (least < Number.POSITIVE_INFINITY) gaps.push(least)
  }
  gaps.sort((one, other) => one - other)
  return gaps[Math.floor(GAP_SHARE * gaps.length)] ?? Number.POSITIVE_INFINITY
}

function hiddenByHider({ hidden }: Diagram): Map<number, number[]> {
  const lists = new Map<number, number[]>()
  for (let k = 0; k < hidden.length; k += 2) {
    const list = lists.get(at(hidden, k + 1))
    if (list === undefined) lists.set(at(hidden, k + 1), [at(hidden, k)])
    else list.push(at(hidden, k))
  }
  return lists
}

function indexed<Color extends string>(
  layer: IndexedData['layer'],
  color: Color,
): IndexedData & { readonly color: Color } {
  const index = (list: Float64Array | undefined, size: number, add: (boxes: Float64Array, k: number) => void) => {
    if (list === undefined) return undefined
    const boxes = emptyBoxes(Math.floor(list.length / size))
    for (let k = 0; k < boxes.length / 4; k++) add(boxes, k)
    return new BoxIndex(boxes)
  }
  const { points, segments, discs } = layer
  const addPoint = (boxes: Float64Array, k: number, list: Float64Array, place: number, r = 0) =>
    addAround(boxes, k, at(list, place), at(list, place + 1), r)
  return {
    layer,
    color,
    points: index(points, 2, (boxes, k) => addPoint(boxes, k, points as Float64Array, 2 * k)),
    segments: index(segments, 4, (boxes, k) => {
      addPoint(boxes, k, segments as Float64Array, 4 * k)
      addPoint(boxes, k, segments as Float64Array, 4 * k + 2)
    }),
    discs: index(discs, 3, (boxes, k) => {
      addPoint(boxes, k, discs as Float64Array, 3 * k, Math.abs(at(discs as Float64Array, 3 * k + 2)))
    }),
  }
}
