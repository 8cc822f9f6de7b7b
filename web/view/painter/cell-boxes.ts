// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/base/diagram-data.ts'
import type { Diagram, SnapshotData } from '../../lib/index.ts'
import { addAround, addBox, addEdge, addFarPart, clearBox, emptyBoxes } from './boxes.ts'

/** Extends a box by a circle and its cell, up to `reach`. */
export function addCell(boxes: Float64Array, k: number, diagram: Diagram, i: number, reach: number): void {
  const { circles, cells } = diagram
  addAround(boxes, k, at(circles, 3 * i), at(circles, 3 * i + 1), at(circles, 3 * i + 2))
  for (const side of cells.sides(i)) addEdge(boxes, k, diagram, side >> 1, reach)
  addFarPart(boxes, k, diagram, i, reach)
}

/** The bounding boxes of circles with their cells, by id. Each edge is measured once for both of its cells. */
export function cellBoxes(diagram: Diagram, reach: number): Float64Array {
  const { circles, edges } = diagram
  const boxes = emptyBoxes(idCount(diagram))
  for (let i = 0; i < circles.length / 3; i++) {
    addAround(boxes, idOf(diagram, i), at(circles, 3 * i), at(circles, 3 * i + 1), at(circles, 3 * i + 2))
  }
  const own = emptyBoxes(1)
  for (let e = 0; e < edges.length / 4; e++) {
    clearBox(own, 0)
    addEdge(own, 0, diagram, e, reach)
    addBox(boxes, idOf(diagram, at(edges, 4 * e)), own, 0)
    addBox(boxes, idOf(diagram, at(edges, 4 * e + 1)), own, 0)
  }
  for (const i of new Set(diagram.hull)) addFarPart(boxes, idOf(diagram, i), diagram, i, reach)
  return boxes
}

/** Extends a box by the centers of a circle and its neighbors. */
export function addStar(boxes: Float64Array, k: number, diagram: Diagram, i: number): void {
  for (const j of [i, ...diagram.neighbors(i)]) addCenter(boxes, k, diagram, j)
}

/** The bounding boxes of the centers of each circle and its neighbors, by id. */
export function starBoxes(diagram: Diagram): Float64Array {
  const { circles, edges } = diagram
  const boxes = emptyBoxes(idCount(diagram))
  for (let i = 0; i < circles.length / 3; i++) addCenter(boxes, idOf(diagram, i), diagram, i)
  for (let e = 0; e < edges.length; e += 4) {
    addCenter(boxes, idOf(diagram, at(edges, e)), diagram, at(edges, e + 1))
    addCenter(boxes, idOf(diagram, at(edges, e + 1)), diagram, at(edges, e))
  }
  return boxes
}

function addCenter(boxes: Float64Array, k: number, { circles }: Diagram, i: number): void {
  addAround(boxes, k, at(circles, 3 * i), at(circles, 3 * i + 1), 0)
}

/** A diagram of an editor, whose circles have ids, or another one, whose indices serve as ids. */
export type Identified = Diagram & Partial<Pick<SnapshotData, 'numbers'>>

export function idOf({ numbers }: Identified, i: number): number {
  return numbers === undefined ? i : at(numbers.circles, i)
}

function idCount(diagram: Identified): number {
  const count = diagram.circles.length / 3
  const { numbers } = diagram
  return numbers === undefined ? count : numbers.circles.reduce((most, id) => Math.max(most, id + 1), 0)
}
