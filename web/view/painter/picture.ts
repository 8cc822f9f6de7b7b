// SPDX-License-Identifier: GPL-3.0-or-later
import { at, NONE } from '../../lib/base/diagram-data.ts'
import type { Box, Change, Diagram, DiagramEditor, Point } from '../../lib/index.ts'
import { boundingBox } from '../camera.ts'
import {
  type CellColors,
  type DataLayer,
  DEFAULT_LAYERS,
  isMeasure,
  type Layers,
  type MethodLayer,
  MOST_MAPPED,
} from '../layers.ts'
import type { Legend } from '../protocol.ts'
import { BoxIndex } from './box-index.ts'
import { addAround, boxAt, EMPTY_BOX, emptyBoxes, union } from './boxes.ts'
import { addCell, addStar, cellBoxes, idOf, starBoxes } from './cell-boxes.ts'
import type { Centers } from './centers.ts'
import type { Clip } from './clip.ts'
import { Coloring } from './coloring.ts'
import { Measures } from './measures.ts'
import type { MethodResult } from './method-layers.ts'
import { RepeatedDiagram, type Torus } from './torus.ts'

/** How far, in extents of all circles, edges are taken to go that go to infinity. */
const HORIZON = 1000

const NO_MOVES: readonly Point[] = [{ x: 0, y: 0 }]

/** A diagram that does not follow, and where its cells are. */
export interface Ghost {
  readonly diagram: Diagram
  readonly index: BoxIndex
}

/** What looks different after an edit. */
export interface Difference {
  readonly boxes: readonly Box[]
  /** Whether something does outside of these boxes. */
  readonly isEverywhere: boolean
}

/** A layer of a client, and where its parts are. */
export interface IndexedData {
  readonly layer: Pick<DataLayer, 'points' | 'segments' | 'discs'>
  /** A CSS color, or the name of a style's. */
  readonly color: string
  readonly points: BoxIndex | undefined
  readonly segments: BoxIndex | undefined
  readonly discs: BoxIndex | undefined
}

/** What is drawn: the diagram of an editor, what of it lies where, and what is drawn in which way. */
export class Picture {
  readonly editor: DiagramEditor
  /** Follows the editor; has images, too, if the circles repeat. */
  diagram: Diagram
  /** Boxes around circles and their cells, by the circles' ids. */
  index: BoxIndex
  /** The box, if the circles repeat. */
  readonly torus: Torus | undefined
  /** Follows the editor, and has no images. */
  readonly #snapshot: Diagram
  /** The box around all circles and cells without images. */
  #extent: Box = EMPTY_BOX
  /** About how far apart the circles are. */
  readonly cellWidth: number
  /** How far edges go that go to infinity. */
  readonly reach: number
  /** The diagram of the centers, if a layer shows something of it. */
  centers: Centers | undefined
  /** The power diagram of the circles as they are, likewise. */
  power: Ghost | undefined
  data: readonly IndexedData[] = []
  /** What the touching disc method makes of the circles as they are, likewise. */
  method: (MethodResult & { readonly layers: readonly (IndexedData & { readonly color: MethodLayer })[] }) | undefined
  /** What `auto` is: that of the circles as they were opened, so that no edit changes all colors. */
  readonly #automatic: CellColors
  #layers = DEFAULT_LAYERS
  #clip: Clip | undefined
  /** Whether circles are shown as points. */
  areSites = false
  #measures: Measures | undefined
  #areas: Measures | undefined
  #gaps: Measures | undefined
  #coloring: Coloring | undefined
  /** Boxes around circles' centers and those of their neighbors, by ids, once they are asked for. */
  #stars: BoxIndex | undefined
  #hiddenBy: Map<number, number[]> | undefined

  /** Takes the editor over. */
  constructor(editor: DiagramEditor, clip?: Clip, torus?: Torus) {
    this.#clip = clip
    this.editor = editor
    this.torus = torus
    this.#snapshot = editor.snapshot()
    this.diagram = torus?.diagramOf(this.#snapshot) ?? this.#snapshot
    const { circles } = this.#snapshot
    const box = boundingBox(circles)
    const extent = Math.max(box.maxX - box.minX, box.maxY - box.minY)
    this.reach = HORIZON * extent
    const count = circles.length / 3
    this.#automatic = count <= MOST_MAPPED ? 'different' : 'radius'
    const area = torus?.area ?? (box.maxX - box.minX) * (box.maxY - box.minY)
    // Circles in a row have hardly any area between them.
    this.cellWidth = count === 0 ? 1 : Math.max(Math.sqrt(area / count), extent / count)
    this.index = this.#indexed()
  }

  /** The number of circles without images. */
  get count(): number {
    return this.#snapshot.circles.length / 3
  }

  /** How far copies of the circles are moved that a box shows. */
  copiesIn(seen: Box): readonly Point[] {
    return this.torus?.copiesIn(this.#extent, seen) ?? NO_MOVES
  }

  /** The point that stands for a point of the plane. */
  home(x: number, y: number): Point {
    return this.diagram instanceof RepeatedDiagram ? this.diagram.home(x, y) : { x, y }
  }

  /** Whether a side of a cell is drawn, as one of the two sides of an edge. */
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

  get layers(): Layers {
    return this.#layers
  }

  set layers(layers: Layers) {
    const cells = layers.cells === 'auto' ? this.#automatic : layers.cells
    const { column } = layers
    if (column !== undefined) {
      if (column !== this.#layers.column) this.#measures = new Measures('column', this.diagram, undefined, column)
    } else if (!isMeasure(cells)) this.#measures = undefined
    else if (cells === 'area') this.#measures = this.areas()
    else if (cells === 'gap') this.#measures = this.gaps()
    else if (this.#measures?.measure !== cells) this.#measures = new Measures(cells, this.diagram)
    if (cells !== 'different' || column !== undefined) this.#coloring = undefined
    else this.#coloring ??= new Coloring(this.#snapshot)
    if (!layers.dual) this.#stars = undefined
    if (layers.data !== this.#layers.data) this.data = layers.data.map((layer) => indexed(layer, layer.color))
    this.#layers = layers
  }

  /** What cells are cut to; `undefined`: nothing. */
  get clip(): Clip | undefined {
    return this.#clip
  }

  set clip(clip: Clip | undefined) {
    if (clip === this.#clip) return
    this.#clip = clip
    // Areas are others.
    this.#areas = undefined
    if (this.#measures?.measure === 'area') this.#measures = this.areas()
  }

  /** Has the power diagram of its circles. */
  setPower(diagram: Diagram): void {
    this.power = { diagram, index: new BoxIndex(cellBoxes(diagram, this.reach)) }
  }

  setMethod(result: MethodResult): void {
    this.method = { ...result, layers: result.data.map((layer) => indexed(layer, layer.name)) }
  }

  /** What colors say, `auto` being one of the others; `column`: values that a client gives. */
  get colors(): CellColors | 'column' {
    if (this.#layers.column !== undefined) return 'column'
    return this.#layers.cells === 'auto' ? this.#automatic : this.#layers.cells
  }

  /** Which color circle `i` and its cell have, of those that the layer of cells shows; `NONE`: a cell has none. */
  colorOf(i: number): number {
    return this.#coloring?.colorOf(idOf(this.diagram, i)) ?? this.#measures?.shadeOf(i) ?? 0
  }

  /** Whether discs have colors, and cells the same, but weaker. Otherwise the cells alone have them. */
  get areDiscsColored(): boolean {
    const { colors } = this
    const { column } = this.#layers
    return column === undefined ? ['radius', 'different', 'none'].includes(colors) : column.categories !== undefined
  }

  /** What the shades mean; `undefined`: colors say nothing. */
  get legend(): Legend | undefined {
    return this.#measures?.legend
  }

  /** The areas of cells, each found when it is asked for. */
  areas(): Measures {
    this.#areas ??= new Measures('area', this.diagram, this.#clip)
    return this.#areas
  }

  /** The area of the cell of a circle by its index. */
  areaOf(i: number): number {
    return this.#clip?.areaOf(this.diagram, i) ?? this.areas().valueOf(i)
  }

  /** The distances to the nearest other circle, likewise. */
  gaps(): Measures {
    this.#gaps ??= new Measures('gap', this.diagram)
    return this.#gaps
  }

  /** The indices, in increasing order, of the circles that with their cells may meet a box. */
  circlesIn(box: Box): number[] {
    return this.#indicesOf(this.index.search(box))
  }

  /** The same of circles from whose centers segments to their neighbors' centers may meet a box. */
  starsIn(box: Box): number[] {
    const { diagram } = this
    this.#stars ??= new BoxIndex(diagram instanceof RepeatedDiagram ? diagram.starBoxes() : starBoxes(diagram))
    return this.#indicesOf(this.#stars.search(box))
  }

  /** The circles that a circle hides, by indices. */
  hiddenBy(i: number): readonly number[] {
    this.#hiddenBy ??= hiddenByHider(this.diagram)
    return this.#hiddenBy.get(i) ?? []
  }

  /**
   * Makes the change of an edit its own, and returns boxes around all that looks different now. Where a circle comes, nothing
   * changes outside its cell; where one goes, nothing outside the cell it had; where one moves, nothing outside both. Only
   * where something is shown that depends on a whole cell, it is those of the neighbors, too.
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
    for (const id of changed) this.#place(id)
    this.#measures?.forget(changed)
    this.#areas?.forget(changed)
    this.#gaps?.forget(changed)
    const recolored = this.#coloring === undefined ? [] : this.#coloring.follow(this.diagram, changed)
    const boxes = [before, this.#lookOf([...replaced, ...inserted, ...hidden, ...shown, ...(recolored ?? [])], cells)]
    boxes.push(...(this.centers?.apply(change).boxes ?? []))
    return {
      boxes: boxes.filter(({ minX, maxX }) => minX <= maxX),
      isEverywhere: recolored === undefined || isMethodShown || this.#layers.power,
    }
  }

  /** All is made anew, but for the colors of cells. */
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
    const { inserted, replaced, shown, cells, hidden } = change
    this.#coloring?.follow(this.#snapshot, new Set([...inserted, ...replaced, ...shown, ...cells, ...hidden]))
    return { boxes: [], isEverywhere: true }
  }

  #indicesOf(ids: readonly number[]): number[] {
    return ids.map((id) => this.diagram.indexOf(id)).sort((i, j) => i - j)
  }

  #lookOf(ids: readonly number[], cells: Iterable<number>): Box {
    const { dual, nearZero, hidden } = this.#layers
    const { colors } = this
    const isWide = colors === 'area' || colors === 'degree' || colors === 'gap'
    const all = isWide || dual || hidden || nearZero !== undefined ? [...ids, ...cells] : ids
    return all.reduce((box, id) => union(union(box, this.index.get(id)), this.#stars?.get(id) ?? EMPTY_BOX), EMPTY_BOX)
  }

  /** A box around a circle and its cell. */
  #place(id: number): void {
    const i = this.diagram.indexOf(id)
    if (i === NONE) return
    this.index.set(id, (boxes, k) => addCell(boxes, k, this.diagram, i, this.reach))
    this.#stars?.set(id, (boxes, k) => addStar(boxes, k, this.diagram, i))
  }
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
      addPoint(boxes, k, discs as Float64Array, 3 * k, at(discs as Float64Array, 3 * k + 2))
    }),
  }
}
