// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/diagram-data.ts'
import type { Box, Change, Diagram, DiagramEditor } from '../../lib/index.ts'
import { BoxIndex } from './box-index.ts'
import { cellBox, circleBox, EMPTY_BOX, union } from './boxes.ts'

const TINTS = 6
/** How far, in extents of all circles, edges are taken to go that go to infinity. */
const HORIZON = 1000

/** What is drawn: the diagram of an editor, what of it lies where, and what is drawn in which way. */
export class Picture {
  readonly editor: DiagramEditor
  /** Follows the editor. */
  readonly diagram: Diagram
  /** Boxes around circles and their cells, by the circles' ids. */
  readonly index = new BoxIndex()
  /** About how far apart the circles are. */
  readonly cellWidth: number
  readonly #reach: number
  readonly #tintBounds: readonly number[]

  /** Takes the editor over. */
  constructor(editor: DiagramEditor) {
    this.editor = editor
    this.diagram = editor.snapshot()
    const { circles } = this.diagram
    const box = boxOf(circles)
    const extent = Math.max(box.maxX - box.minX, box.maxY - box.minY)
    this.#reach = HORIZON * extent
    this.#tintBounds = tintBounds(circles)
    const count = circles.length / 3
    const area = (box.maxX - box.minX) * (box.maxY - box.minY)
    // Circles in a row have hardly any area between them.
    this.cellWidth = count === 0 ? 1 : Math.max(Math.sqrt(area / count), extent / count)
    for (const id of editor.ids()) this.#place(id)
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
    return ids.reduce((box, id) => union(box, this.index.get(id) ?? EMPTY_BOX), EMPTY_BOX)
  }

  #place(id: number): void {
    this.index.set(id, cellBox(this.diagram, this.diagram.indexOf(id), this.#reach))
  }
}

function boxOf(circles: Float64Array): Box {
  let box = EMPTY_BOX
  for (let i = 0; i < circles.length; i += 3) {
    box = union(box, circleBox(at(circles, i), at(circles, i + 1), at(circles, i + 2)))
  }
  return box
}

function tintBounds(circles: Float64Array): number[] {
  const count = circles.length / 3
  const radii = new Float64Array(count).map((_, i) => at(circles, 3 * i + 2)).sort()
  return Array.from({ length: TINTS - 1 }, (_, k) => radii[Math.floor(((k + 1) * count) / TINTS)] ?? 0)
}
