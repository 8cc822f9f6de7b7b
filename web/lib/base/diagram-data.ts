// SPDX-License-Identifier: GPL-3.0-or-later
import { checkCircles, checkData, checkIndex } from './check.ts'
import type { Circle, DiagramData, Edge, Vertex } from './types.ts'

/**
 * Stands for "none", for example at the unbounded end of an edge.
 *
 * @category Diagrams
 * @example
 * diagram.hull.includes(NONE) // false
 * edgeAt(diagram, 0).start === NONE || edgeAt(diagram, 0).end === NONE // true
 */
export const NONE = -1

/**
 * Returns circle `i` of a flat array of x, y, r.
 *
 * @throws CircleVoronoiError `badInput`, if there is none
 *
 * @category Diagrams
 * @example
 * circleAt(diagram.circles, 1) // { x: 6, y: 0, r: 1 }
 */
export function circleAt(circles: Float64Array, i: number): Circle {
  checkCircles(circles, 'circleAt')
  checkIndex(i, circles.length / 3, 'circleAt', 'circle')
  return circleOf(circles, i)
}

/** Does what `circleAt` does, for arguments that have been checked. */
export function circleOf(circles: Float64Array, i: number): Circle {
  return { x: at(circles, 3 * i), y: at(circles, 3 * i + 1), r: at(circles, 3 * i + 2) }
}

/**
 * Returns vertex `v` of a diagram.
 *
 * @throws CircleVoronoiError `badInput`, if there is none
 *
 * @category Diagrams
 * @example
 * vertexAt(diagram, 0) // { x: 3, y: 4, r: 4 }
 */
export function vertexAt(diagram: DiagramData, v: number): Vertex {
  checkData(diagram, 'vertexAt')
  checkIndex(v, diagram.vertices.length / 3, 'vertexAt', 'vertex')
  return vertexOf(diagram, v)
}

/** Does what `vertexAt` does, for arguments that have been checked. */
export function vertexOf({ vertices }: DiagramData, v: number): Vertex {
  return { x: at(vertices, 3 * v), y: at(vertices, 3 * v + 1), r: at(vertices, 3 * v + 2) }
}

/**
 * Returns edge `e` of a diagram.
 *
 * @throws CircleVoronoiError `badInput`, if there is none
 *
 * @category Diagrams
 * @example
 * const { left, right } = edgeAt(diagram, 0)
 * diagram.neighbors(left).includes(right) // true
 */
export function edgeAt(diagram: DiagramData, e: number): Edge {
  checkData(diagram, 'edgeAt')
  checkIndex(e, diagram.edges.length / 4, 'edgeAt', 'edge')
  return edgeOf(diagram, e)
}

/** Does what `edgeAt` does, for arguments that have been checked. */
export function edgeOf({ edges }: DiagramData, e: number): Edge {
  return {
    left: at(edges, 4 * e),
    right: at(edges, 4 * e + 1),
    start: at(edges, 4 * e + 2),
    end: at(edges, 4 * e + 3),
  }
}

/** The number at an index of a typed array. Precondition: 0 <= index < array.length. */
export function at(array: Float64Array | Int32Array | Uint8Array, index: number): number {
  return array[index] as number
}
