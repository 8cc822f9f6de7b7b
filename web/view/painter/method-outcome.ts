// SPDX-License-Identifier: GPL-3.0-or-later
import { at, edgeOf, NONE, vertexOf } from '../../lib/base/diagram-data.ts'
import type { Diagram } from '../../lib/index.ts'
import { mergeVertices } from '../../lib/queries/merged.ts'
import type { Counted } from '../protocol.ts'
import { leastFirst } from './ring.ts'

/** The result of a method compared with the diagram. */
export interface MethodOutcome {
  readonly vertices: Counted
  readonly edges: Counted
  /** The indices of the missed edges. */
  readonly missed: readonly number[]
}

/** Tolerance for equal vertices, relative to their radius and to the diagram's extent. */
const SAME_PLACE = 1e-9

/**
 * Compares another diagram of the same circles, right or wrong, with a certified one. Vertices at the same place count
 * as one, because a disc that more than three circles touch can be split in several ways.
 */
export function methodOutcome(right: Diagram, other: Diagram): MethodOutcome {
  const { mergedVertex, edges, vertices } = mergeVertices(right)
  const placeOf = placesIn(right, other, mergedVertex)
  const count = vertices.length / 3
  const found = new Set(placeOf.filter((place) => place < count))
  const wrong = new Set(placeOf.filter((place) => place >= count))

  const left = new Map<string, number>()
  let wrongEdges = 0
  for (let e = 0; e < other.edges.length / 4; e++) {
    const { left: i, right: j, start, end } = edgeOf(other, e)
    const [from, to] = [start, end].map((v) => (v === NONE ? NONE : (placeOf[v] as number))) as [number, number]
    if (from === to && from !== NONE) continue
    const key = keyOf(i, j, from, to)
    left.set(key, (left.get(key) ?? 0) + 1)
    wrongEdges += 1
  }
  const missed: number[] = []
  let foundEdges = 0
  let remaining = 0
  for (let e = 0; e < right.edges.length / 4; e++) {
    const { left: i, right: j, start, end } = edgeOf(right, e)
    const [from, to] = [start, end].map((v) => (v === NONE ? NONE : at(mergedVertex, v))) as [number, number]
    if (from === to && from !== NONE) continue
    remaining += 1
    const key = keyOf(i, j, from, to)
    const there = left.get(key) ?? 0
    left.set(key, there - 1)
    if (there > 0) foundEdges += 1
    else missed.push(e)
  }
  return {
    vertices: { all: count, found: found.size, wrong: wrong.size },
    edges: { all: Math.max(remaining, edges.length / 4), found: foundEdges, wrong: wrongEdges - foundEdges },
    missed,
  }
}

/** Maps each vertex of the other diagram to the merged vertex at its place, or to a new number. */
function placesIn(right: Diagram, other: Diagram, mergedVertex: Int32Array): number[] {
  const known = new Map<string, number>()
  const rest = new Set<number>()
  for (let v = 0; v < mergedVertex.length; v++) {
    known.set(circlesOf(right, v), v)
    rest.add(v)
  }
  const places = Array.from({ length: other.vertices.length / 3 }, (_, v) => {
    const same = known.get(circlesOf(other, v))
    if (same !== undefined) rest.delete(same)
    return same === undefined ? NONE : at(mergedVertex, same)
  })
  // Unmatched vertices may be at the place of a vertex of other circles.
  const extent = extentOf(right.circles)
  const own = mergedVertex.length
  return places.map((place, v) => {
    if (place !== NONE) return place
    const { x, y, r } = vertexOf(other, v)
    const near = SAME_PLACE * (extent + Math.abs(r))
    for (const candidate of rest) {
      const { x: px, y: py } = vertexOf(right, candidate)
      if (Math.abs(px - x) < near && Math.abs(py - y) < near) return at(mergedVertex, candidate)
    }
    return own + v
  })
}

/** A triple of circles in a given cyclic order has at most one disc that touches them from outside. */
function circlesOf({ vertexCircles }: Diagram, v: number): string {
  return leastFirst([0, 1, 2].map((k) => at(vertexCircles, 3 * v + k))).join()
}

/** An edge's key, the same from both sides. */
function keyOf(left: number, right: number, start: number, end: number): string {
  return left < right ? `${left},${right},${start},${end}` : `${right},${left},${end},${start}`
}

function extentOf(circles: Float64Array): number {
  let most = 0
  for (let k = 0; k < circles.length; k += 3) {
    most = Math.max(most, Math.abs(at(circles, k) - at(circles, 0)), Math.abs(at(circles, k + 1) - at(circles, 1)))
  }
  return most
}
