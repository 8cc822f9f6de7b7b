// SPDX-License-Identifier: GPL-3.0-or-later
import { checkData, checkLength, refuseArrays } from '../base/check.ts'
import { at, edgeOf, NONE } from '../base/diagram-data.ts'
import { hypotenuse } from '../base/scale.ts'
import type { DiagramData } from '../base/types.ts'

/**
 * A diagram with vertices of any degree, in which vertices joined by edges of length near zero are merged (paper,
 * section 8).
 *
 * @category Questions
 */
export interface MergedDiagram {
  /** Three numbers for each merged vertex: x, y and signed radius of its member with the smallest index. */
  readonly vertices: Float64Array
  /**
   * For each merged vertex, the index in `circles` where its circles begin. The last item is the length of `circles`.
   */
  readonly firstCircle: Int32Array
  /**
   * The circles of merged vertex v have the indices from `firstCircle[v]` to `firstCircle[v + 1] - 1`,
   * counter-clockwise from the smallest circle. A circle appears several times if its cell meets the vertex more than
   * once.
   */
  readonly circles: Int32Array
  /**
   * Four numbers for each edge that remains, in the order of the diagram: left circle, right circle, and the merged
   * vertices where it starts and ends.
   */
  readonly edges: Int32Array
  /** For each vertex of the diagram, its merged vertex. */
  readonly mergedVertex: Int32Array
}

/**
 * Merges vertices of a certified diagram that are joined by edges not longer than `nearZero`, in the units of the
 * input. By default the limit is a small multiple of the rounding error of the vertices of each edge. The circles
 * around each merged vertex do not depend on the order of the input, except for their indices, as long as no edge is
 * about as long as `nearZero`.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Questions
 * @example
 * const square = library.compute([[0, 0, 1], [4, 0, 1], [4, 4, 1], [0, 4, 1]])
 * square.vertices.length / 3 // 2
 * mergeVertices(square).circles // Int32Array(4) [ 0, 1, 2, 3 ]
 */
export function mergeVertices(diagram: DiagramData, nearZero?: number): MergedDiagram {
  checkData(diagram, 'mergeVertices')
  if (nearZero !== undefined) checkLength(nearZero, 'mergeVertices', 'nearZero')
  const { vertices, vertexSides, edges, nextSide } = diagram
  const count = vertices.length / 3
  const edgeCount = edges.length / 4
  const sets = new Sets(count)
  const isShort = new Uint8Array(edgeCount)
  for (let e = 0; e < edgeCount; e++) {
    const { start, end } = edgeOf(diagram, e)
    if (start === NONE || end === NONE) continue
    const limit = nearZero ?? roundingError(diagram, start) + roundingError(diagram, end)
    const gap = (k: number) => at(vertices, 3 * end + k) - at(vertices, 3 * start + k)
    if (hypotenuse(gap(0), gap(1)) > limit) continue
    isShort[e] = 1
    sets.unite(start, end)
  }

  const mergedVertex = new Int32Array(count)
  const members: number[] = []
  for (let v = 0; v < count; v++) {
    const root = sets.find(v)
    mergedVertex[v] = root === v ? members.push(v) - 1 : at(mergedVertex, root)
  }

  // The walk goes clockwise around a merged vertex. Beyond each long side that leaves the vertex lies a cell, whose
  // next long side also leaves the vertex.
  const isMet = new Uint8Array(2 * edgeCount)
  const around: number[][] = members.map(() => [])
  const isShortSide = (side: number) => isShort[side >> 1] === 1
  vertexSides.forEach((start, slot) => {
    const vertex = Math.floor(slot / 3)
    const list = around[at(mergedVertex, vertex)] ?? refuseArrays('vertex', vertex)
    for (let side = start; !isShortSide(side) && isMet[side] === 0; ) {
      isMet[side] = 1
      list.push(at(edges, 4 * (side >> 1) + (side & 1)))
      side = at(nextSide, side ^ 1)
      let left = nextSide.length
      while (isShortSide(side)) {
        if (left-- === 0) refuseArrays('vertex', vertex)
        side = at(nextSide, side)
      }
    }
  })

  const firstCircle = new Int32Array(members.length + 1)
  around.forEach((list, v) => {
    if (list.length === 0) refuseArrays('vertex', members[v] as number)
    firstCircle[v + 1] = at(firstCircle, v) + list.length
  })
  const circles = new Int32Array(at(firstCircle, members.length))
  around.forEach((list, v) => {
    circles.set(fromSmallest(list.reverse()), at(firstCircle, v))
  })
  const mergedEnd = (vertex: number) => (vertex === NONE ? NONE : at(mergedVertex, vertex))
  return {
    vertices: new Float64Array(3 * members.length).map((_, k) =>
      at(vertices, 3 * (members[Math.floor(k / 3)] as number) + (k % 3)),
    ),
    firstCircle,
    circles,
    edges: edges.filter((_, k) => isShort[k >> 2] === 0).map((value, k) => (k % 4 < 2 ? value : mergedEnd(value))),
    mergedVertex,
  }
}

function fromSmallest(cycle: readonly number[]): number[] {
  const start = cycle.indexOf(cycle.reduce((least, i) => Math.min(least, i)))
  return cycle.slice(start).concat(cycle.slice(0, start))
}

/**
 * Returns 2^-40 of the numbers that determine a vertex. This is several thousand times the unit roundoff, because
 * three-touch discs may be badly conditioned, and far below a visible length.
 */
function roundingError({ circles, vertices, vertexCircles }: DiagramData, vertex: number): number {
  const sizeOf = (numbers: Float64Array, i: number) =>
    Math.abs(at(numbers, 3 * i)) + Math.abs(at(numbers, 3 * i + 1)) + Math.abs(at(numbers, 3 * i + 2))
  let size = sizeOf(vertices, vertex)
  for (let slot = 3 * vertex; slot < 3 * vertex + 3; slot++) {
    size = Math.max(size, sizeOf(circles, at(vertexCircles, slot)))
  }
  return 2 ** -40 * size
}

/** Union-find over indices. The smallest index represents its set. */
class Sets {
  readonly #parent: Int32Array

  constructor(count: number) {
    this.#parent = new Int32Array(count).map((_, i) => i)
  }

  find(i: number): number {
    let root = i
    while (at(this.#parent, root) !== root) {
      const grandparent = at(this.#parent, at(this.#parent, root))
      this.#parent[root] = grandparent
      root = grandparent
    }
    return root
  }

  unite(i: number, j: number): void {
    const [one, other] = [this.find(i), this.find(j)]
    this.#parent[Math.max(one, other)] = Math.min(one, other)
  }
}
