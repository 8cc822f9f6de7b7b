// SPDX-License-Identifier: GPL-3.0-or-later
import { at, edgeOf, NONE, vertexOf } from '../../lib/base/diagram-data.ts'
import type { Diagram } from '../../lib/index.ts'
import { mergeVertices } from '../../lib/queries/merged.ts'
import type { Counted } from '../protocol.ts'
import { leastFirst } from './ring.ts'

/** What a method finds of a diagram. */
export interface MethodOutcome {
  readonly vertices: Counted
  readonly edges: Counted
  /** The edges of the diagram that it misses, by index. */
  readonly missed: readonly number[]
}

/** How near to a vertex another one is the same, as a part of its radius and of the diagram's extent. */
const SAME_PLACE = 1e-9

/**
 * What another diagram of the same circles, right or wrong, has of a certified one. Vertices at one place count as one, as more
 * than three circles may touch its disc in any order.
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

/** Of each vertex of the other diagram the merged vertex at its place, or a number of its own beyond them. */
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
  // Those left over may be the same disc, touched by others of its circles.
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

/** Three circles in this order round touch one disc from outside at most. */
function circlesOf({ vertexCircles }: Diagram, v: number): string {
  return leastFirst([0, 1, 2].map((k) => at(vertexCircles, 3 * v + k))).join()
}

/** The same from either side. */
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
