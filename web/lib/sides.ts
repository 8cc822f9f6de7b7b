// SPDX-License-Identifier: GPL-3.0-or-later
import { type Bisector, bisector, type Point, parameterAt, type Range } from './bisector.ts'
import { at, type Diagram, NONE } from './diagram.ts'

/**
 * An edge seen from one of its two cells is a *side* of that cell. Side 2e of edge e belongs to the left circle and runs
 * from start to end; side 2e + 1 belongs to the right circle and runs back. So every side has its own cell on its left,
 * and the sides of a cell run counter-clockwise around it.
 */
export function circleOf({ edges }: Diagram, side: number): number {
  return at(edges, 4 * (side >> 1) + (side & 1))
}

/** The circle on the other side of the edge. */
export function neighborOf(diagram: Diagram, side: number): number {
  return circleOf(diagram, side ^ 1)
}

/** The vertex where the side begins, or `NONE`. */
export function originOf({ edges }: Diagram, side: number): number {
  return at(edges, 4 * (side >> 1) + 2 + (side & 1))
}

/** The vertex where the side ends, or `NONE`. */
export function targetOf(diagram: Diagram, side: number): number {
  return originOf(diagram, side ^ 1)
}

/** The side's bisector, with the side's own circle on the left, so that its parameter grows along the side. */
export function bisectorOf(diagram: Diagram, side: number): Bisector {
  return bisector(diagram.circles, circleOf(diagram, side), neighborOf(diagram, side))
}

/** The parameters of the side's ends on its bisector; an unbounded end is infinite. */
export function rangeOf(diagram: Diagram, side: number, curve: Bisector): Range {
  const origin = originOf(diagram, side)
  const target = targetOf(diagram, side)
  return {
    from: origin === NONE ? Number.NEGATIVE_INFINITY : parameterOfVertex(diagram, curve, origin),
    to: target === NONE ? Number.POSITIVE_INFINITY : parameterOfVertex(diagram, curve, target),
  }
}

function parameterOfVertex({ vertices }: Diagram, curve: Bisector, v: number): number {
  return parameterAt(curve, at(vertices, 3 * v), at(vertices, 3 * v + 1))
}

export function vertexPoint({ vertices }: Diagram, v: number): Point {
  return { x: at(vertices, 3 * v), y: at(vertices, 3 * v + 1) }
}

/** The largest distance from the centre of the side's circle to a point of the side. */
export function reachOf(diagram: Diagram, side: number): number {
  const origin = originOf(diagram, side)
  const target = targetOf(diagram, side)
  if (origin === NONE || target === NONE) return Number.POSITIVE_INFINITY
  // The distance grows from the apex of the branch either way, so it is largest at a vertex.
  const { circles, vertices } = diagram
  return (
    at(circles, 3 * circleOf(diagram, side) + 2) + Math.max(at(vertices, 3 * origin + 2), at(vertices, 3 * target + 2))
  )
}
