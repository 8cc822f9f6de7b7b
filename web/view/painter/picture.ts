// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/diagram-data.ts'
import type { Box, Change, Diagram, DiagramEditor } from '../../lib/index.ts'
import { boundingBox } from '../camera.ts'
import { TINTS } from '../style.ts'
import { BoxIndex } from './box-index.ts'
import { addAround, addBox, addEdge, addFarPart, clearBox, EMPTY_BOX, emptyBoxes, union } from './boxes.ts'

/** How far, in extents of all circles, edges are taken to go that go to infinity. */
const HORIZON = 1000
/** So many radii say which are the small ones. */
const MOST_RADII = 20_000

/** What is drawn: the diagram of an editor, what of it lies where, and what is drawn in which way. */
export class Picture {
  readonly editor: DiagramEditor
  /** Follows the editor. */
  readonly diagram: Diagram
  /** Boxes around circles and their cells, by the circles' ids. */
  readonly index: BoxIndex
  /** About how far apart the circles are. */
  readonly cellWidth: number
  readonly #reach: number
  readonly #tintBounds: readonly number[]

  /** Takes the editor over. */
  constructor(editor: DiagramEditor) {
    this.editor = editor
    this.diagram = editor.snapshot()
    const { circles } = this.diagram
    const box = boundingBox(circles)
    const extent = Math.max(box.maxX - box.minX, box.maxY - box.minY)
    this.#reach = HORIZON * extent
    this.#tintBounds = tintBounds(circles)
    const count = circles.length / 3
    const area = (box.maxX - box.minX) * (box.maxY - box.minY)
    // Circles in a row have hardly any area between them.
    this.cellWidth = count === 0 ? 1 : Math.max(Math.sqrt(area / count), extent / count)
    this.index = new BoxIndex(cellBoxes(this.diagram, this.#reach))
  }

  /** Which of the tints circles of this radius have: each tint about as many as others, equal radii one. */
  readonly tintOf = (r: number): number => {
    let tint = 0
    while (tint < TINTS - 1 && (this.#tintBounds[tint] as number) <= r) tint += 1
    return tint
  }

  /**
   * Makes the change of an edit its own, and returns boxes around all that looks different now: where a circle comes, nothing
   * changes outside its cell; where one goes, nothing outside the cell it had; where one moves, nothing outside both.
   */
  apply(change: Change): Box[] {
    const { removed, replaced, inserted, cells, hidden, shown } = change
    const before = this.#around([...removed, ...replaced, ...hidden, ...shown])
    this.diagram.apply(change)
    for (const id of removed) this.index.delete(id)
    for (const id of new Set([...replaced, ...inserted, ...cells, ...hidden])) this.#place(id)
    return [before, this.#around([...replaced, ...inserted, ...hidden, ...shown])].filter(
      ({ minX, maxX }) => minX <= maxX,
    )
  }

  #around(ids: readonly number[]): Box {
    return ids.reduce((box, id) => union(box, this.index.get(id)), EMPTY_BOX)
  }

  /** A box around a circle and its cell. */
  #place(id: number): void {
    const { circles, cells } = this.diagram
    const i = this.diagram.indexOf(id)
    this.index.set(id, (boxes, k) => {
      addAround(boxes, k, at(circles, 3 * i), at(circles, 3 * i + 1), at(circles, 3 * i + 2))
      for (const side of cells.sides(i)) addEdge(boxes, k, this.diagram, side >> 1, this.#reach)
      addFarPart(boxes, k, this.diagram, i, this.#reach)
    })
  }
}

/** Boxes around all circles and their cells, by the circles' ids: that of each edge is made once, for both of its cells. */
function cellBoxes(diagram: Diagram, reach: number): Float64Array {
  const { circles, edges, numbers } = diagram
  const idOf = (i: number) => numbers?.circles[i] ?? i
  const count = circles.length / 3
  // Of a snapshot the last circle has the largest id.
  const boxes = emptyBoxes(count === 0 ? 0 : idOf(count - 1) + 1)
  for (let i = 0; i < count; i++) {
    addAround(boxes, idOf(i), at(circles, 3 * i), at(circles, 3 * i + 1), at(circles, 3 * i + 2))
  }
  const own = emptyBoxes(1)
  for (let e = 0; e < edges.length / 4; e++) {
    clearBox(own, 0)
    addEdge(own, 0, diagram, e, reach)
    addBox(boxes, idOf(at(edges, 4 * e)), own, 0)
    addBox(boxes, idOf(at(edges, 4 * e + 1)), own, 0)
  }
  for (const i of new Set(diagram.hull)) addFarPart(boxes, idOf(i), diagram, i, reach)
  return boxes
}

/** From some of the radii, if there are many. */
function tintBounds(circles: Float64Array): number[] {
  const count = circles.length / 3
  const step = Math.ceil(count / MOST_RADII)
  const radii = new Float64Array(Math.floor(count / Math.max(step, 1)))
    .map((_, k) => at(circles, 3 * step * k + 2))
    .sort()
  return Array.from({ length: TINTS - 1 }, (_, k) => radii[Math.floor(((k + 1) * radii.length) / TINTS)] ?? 0)
}
