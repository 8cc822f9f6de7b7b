// SPDX-License-Identifier: GPL-3.0-or-later
import type { Float64s, Int32s } from '../base/types.ts'

/**
 * How an edit was made; the result is certified in each case. `local`: by flips around the circles concerned. `patch`:
 * the flips failed, and a diagram of the surrounding circles was computed and spliced in. `whole`: the whole diagram
 * was computed.
 *
 * @category Editing
 */
export type EditWay = 'local' | 'patch' | 'whole'

/**
 * The effect of an edit, or of a batch of edits, on a diagram.
 *
 * Circles are named by their ids. Each vertex and each edge has a number, which may be reused after the vertex or edge
 * is removed. An edge that gets another end counts as a new edge, and a vertex whose circle moves counts as a new
 * vertex. To update a copy of the diagram, take away the removed parts and then add the added ones, as `Diagram.apply`
 * does. The circles and vertices of the copy then equal `DiagramEditor.snapshot` bit for bit, at any scale.
 *
 * @category Editing
 */
export interface Change {
  /** The number of changes that the editor has made, including this one. */
  readonly revision: number
  readonly way: EditWay
  /** Ids of the inserted circles, in the order of the edits. */
  readonly inserted: Int32s
  readonly removed: Int32s
  readonly replaced: Int32s
  /** Three numbers for each inserted circle, then for each replaced circle: x, y, r. */
  readonly circles: Float64s
  /** Circles that lost their cell, or were inserted without a cell. */
  readonly hidden: Int32s
  /**
   * Two ids for each circle in `hidden`, and for each hidden circle that got another hider: the circle, and a visible
   * circle that contains it.
   */
  readonly hiders: Int32s
  /** Circles that were hidden and now have a cell. */
  readonly shown: Int32s
  /** Circles whose cells changed, including new circles. */
  readonly cells: Int32s
  readonly removedVertices: Int32s
  readonly addedVertices: Int32s
  /** Three numbers for each added vertex: x, y, r. */
  readonly vertices: Float64s
  /** Three ids for each added vertex: its circles, counter-clockwise, the smallest id first. */
  readonly vertexCircles: Int32s
  readonly removedEdges: Int32s
  readonly addedEdges: Int32s
  /**
   * Four numbers for each added edge: left circle, right circle, start vertex, end vertex; an unbounded end is `NONE`.
   */
  readonly edges: Int32s
  /**
   * Two numbers for each unbounded side whose next side has changed: the side, and the next side around its cell. Side
   * 2 e belongs to the left circle of edge e, side 2 e + 1 to the right circle.
   */
  readonly hullSides: Int32s
}

const WAYS: readonly EditWay[] = ['local', 'patch', 'whole']
/** The number of integers before the lists. */
const HEAD = 18

/** Reads a change from the bytes of cpp/wasm/editor_bindings.cpp and copies its lists. */
export function changeOf(bytes: Uint8Array, revision: number): Change {
  const buffer = bytes.slice().buffer
  const head = new Int32Array(buffer, 0, HEAD)
  let list = 1
  let place = 4 * HEAD
  const doubles = (size: number): Float64s => {
    const array = new Float64Array(buffer, place, size * (head[list++] as number))
    place += array.byteLength
    return array
  }
  const integers = (size: number): Int32s => {
    const array = new Int32Array(buffer, place, size * (head[list++] as number))
    place += array.byteLength
    return array
  }
  const circles = doubles(3)
  const vertices = doubles(3)
  return {
    revision,
    way: WAYS[head[0] as number] as EditWay,
    circles,
    vertices,
    inserted: integers(1),
    removed: integers(1),
    replaced: integers(1),
    hidden: integers(1),
    hiders: integers(2),
    shown: integers(1),
    cells: integers(1),
    removedVertices: integers(1),
    addedVertices: integers(1),
    vertexCircles: integers(3),
    removedEdges: integers(1),
    addedEdges: integers(1),
    edges: integers(4),
    hullSides: integers(2),
  }
}
