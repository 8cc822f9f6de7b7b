// SPDX-License-Identifier: GPL-3.0-or-later
import type { Float64s, Int32s } from '../base/types.ts'

/**
 * How an edit was done; each is certified. `local`: by flips around the circles concerned. `patch`: where these led astray, by
 * a diagram of the circles around, spliced in. `whole`: by computing everything.
 *
 * @category Editing
 */
export type EditWay = 'local' | 'patch' | 'whole'

/**
 * What an edit, or a batch, did to a diagram.
 *
 * Circles go by their ids. Each vertex and each edge has a number, which stays its own until it goes, and may then be that of
 * another: an edge with another end is another edge, and so is a vertex whose circle has moved. Who takes away what goes, then
 * puts what comes into its place, has the diagram as it is now; `Diagram.apply` does so. Its circles and vertices equal those of
 * `DiagramEditor.snapshot` to the bit, at any scale.
 *
 * @category Editing
 */
export interface Change {
  /** How many changes the editor has made, with this one. */
  readonly revision: number
  readonly way: EditWay
  /** In the order of the edits. */
  readonly inserted: Int32s
  readonly removed: Int32s
  readonly replaced: Int32s
  /** Three for each circle inserted, then for each replaced: x, y, r. */
  readonly circles: Float64s
  /** Circles that no longer have a cell, or came without one. */
  readonly hidden: Int32s
  /**
   * Two for each of those, and for each circle that another hides than before: the circle, and a visible one that contains it;
   * of several the one that it is kept with.
   */
  readonly hiders: Int32s
  /** Circles that were hidden and have a cell again. */
  readonly shown: Int32s
  /** Circles whose cells have another outline, new ones included. */
  readonly cells: Int32s
  readonly removedVertices: Int32s
  readonly addedVertices: Int32s
  /** Three for each vertex added: x, y, r. */
  readonly vertices: Float64s
  /** Three for each vertex added: its circles, counter-clockwise, the least first. */
  readonly vertexCircles: Int32s
  readonly removedEdges: Int32s
  readonly addedEdges: Int32s
  /** Four for each edge added: left, right, start, end; an unbounded end is `NONE`. */
  readonly edges: Int32s
  /**
   * Two for each side to infinity that another follows than before: the side, and the next one around its cell. Side 2 e is
   * that of the left circle of the edge with number e, 2 e + 1 that of the right one.
   */
  readonly hullSides: Int32s
}

const WAYS: readonly EditWay[] = ['local', 'patch', 'whole']
/** Numbers before the lists. */
const HEAD = 18

/** The change in the bytes of cpp/wasm/editor_bindings.cpp, which are copied. */
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
