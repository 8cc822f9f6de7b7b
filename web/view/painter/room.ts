// SPDX-License-Identifier: GPL-3.0-or-later

import { at, circleOf, NONE } from '../../lib/base/diagram-data.ts'
import type { Circle, Diagram } from '../../lib/index.ts'

/** The largest number of cells that are searched around a point. */
const MOST_SEARCHED = 20_000

/**
 * A circle in the free room nearest to a point. It has half the size of the room, so that others keep most of their
 * cells. A point outside of all circles has room itself; else the search goes from cell to cell, and room is around the
 * vertices.
 */
export function roomNear(diagram: Diagram, x: number, y: number): Circle | undefined {
  const [nearest, room] = nearestTo(diagram.circles, x, y)
  if (nearest === NONE) return undefined
  if (room > 0) return { x, y, r: room / 2 }
  const { cells, vertices } = diagram
  const seen = new Set([nearest])
  let ring = [nearest]
  let found: Circle | undefined
  let least = Number.POSITIVE_INFINITY
  // A vertex in the ring after the first one with room may still be nearer.
  for (let rest = 2; ring.length > 0 && rest > 0 && seen.size < MOST_SEARCHED; ) {
    for (const i of ring) {
      for (const side of cells.sides(i)) {
        const v = cells.originOf(side)
        if (v === NONE || !(at(vertices, 3 * v + 2) > 0)) continue
        const [vertexX, vertexY, clearance] = [at(vertices, 3 * v), at(vertices, 3 * v + 1), at(vertices, 3 * v + 2)]
        const distance = Math.hypot(vertexX - x, vertexY - y)
        if (distance < least) [found, least] = [{ x: vertexX, y: vertexY, r: clearance / 2 }, distance]
      }
    }
    if (found !== undefined) rest -= 1
    const next = ring.flatMap((i) => [...diagram.neighbors(i)]).filter((j) => !seen.has(j))
    for (const j of next) seen.add(j)
    ring = [...new Set(next)]
  }
  return found ?? outside(diagram, seen)
}

/** The circle nearest to a point and its distance, negative inside the circle. A circle with a cell is one of these. */
function nearestTo(circles: Float64Array, x: number, y: number): [i: number, distance: number] {
  let [nearest, least] = [NONE, Number.POSITIVE_INFINITY]
  for (let i = 0; i < circles.length / 3; i++) {
    const distance = Math.hypot(at(circles, 3 * i) - x, at(circles, 3 * i + 1) - y) - at(circles, 3 * i + 2)
    if (distance < least) [nearest, least] = [i, distance]
  }
  return [nearest, least]
}

/** A circle beside all of some circles, between which there is no room. */
function outside({ circles }: Diagram, among: ReadonlySet<number>): Circle {
  const right = [...among]
    .map((i) => circleOf(circles, i))
    .reduce((one, two) => (two.x + two.r > one.x + one.r ? two : one))
  const r = right.r > 0 ? right.r / 4 : 1
  return { x: right.x + right.r + 2 * r, y: right.y, r }
}
