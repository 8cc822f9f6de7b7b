// SPDX-License-Identifier: GPL-3.0-or-later
// Queries about the circles of a diagram of the metric `circles`, each in linear time except for sorting. The triangles
// of the dual are `vertexCircles`. Two triangles may share two circles or all three (a quasi-triangulation).
import { checkData, checkMetric, checkNoOptions } from '../base/check.ts'
import { at, circleOf } from '../base/diagram-data.ts'
import { between } from '../base/point.ts'
import { lengthOf } from '../base/scale.ts'
import type { DiagramData } from '../base/types.ts'

/**
 * Two circles and the gap between them.
 *
 * @category Questions
 */
export interface ClosestPair {
  /** The circle with the smaller index. */
  readonly first: number
  readonly second: number
  /** The gap |c - c'| - r - r', negative if the circles overlap. */
  readonly gap: number
}

/**
 * Finds the two visible circles with the smallest gap. Returns `undefined` if fewer than two circles are visible.
 *
 * @throws CircleVoronoiError `badInput`, if the diagram is of another metric than `circles`
 *
 * @category Questions
 * @example
 * closestPair(diagram) // { first: 0, second: 1, gap: 4 }
 */
export function closestPair(diagram: DiagramData): ClosestPair | undefined
export function closestPair(diagram: DiagramData, ...others: readonly unknown[]): ClosestPair | undefined {
  checkNoOptions(others, 'closestPair')
  checkData(diagram, 'closestPair')
  checkMetric(diagram, 'closestPair', 'circles')
  const { circles, edges } = diagram
  // The two circles of the closest pair share an edge: a circle nearer than gap / 2 to the middle of their gap would
  // have a smaller gap to each.
  let closest: ClosestPair | undefined
  for (let e = 0; e < edges.length; e += 4) {
    const first = Math.min(at(edges, e), at(edges, e + 1))
    const second = Math.max(at(edges, e), at(edges, e + 1))
    const c = circleOf(circles, first)
    const d = circleOf(circles, second)
    const gap = lengthOf(between(c, d)) - c.r - d.r
    if (closest === undefined || gap < closest.gap || (gap === closest.gap && isBefore(first, second, closest))) {
      closest = { first, second, gap }
    }
  }
  return closest
}

/** Breaks ties between equal gaps by the smallest indices, so the result does not depend on the order of the edges. */
function isBefore(first: number, second: number, other: ClosestPair): boolean {
  return first < other.first || (first === other.first && second < other.second)
}
