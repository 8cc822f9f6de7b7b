// SPDX-License-Identifier: GPL-3.0-or-later
// Queries about the circles of a diagram of the metric `circles`, each in linear time except for sorting. The dual's
// triangles are `vertexCircles`; two of them may share two circles or all three, so it is a quasi-triangulation.
import { checkData, checkMetric, checkNoOptions } from '../base/check.ts'
import { at, circleOf } from '../base/diagram-data.ts'
import { between } from '../base/point.ts'
import { lengthOf } from '../base/scale.ts'
import type { DiagramData } from '../base/types.ts'

/**
 * Returns the pairs of circles whose cells share an edge, as two indices each. The smaller index comes first; pairs are
 * sorted, and each appears once.
 *
 * @throws CircleVoronoiError `badArgument`
 *
 * @category Questions
 * @example
 * neighborPairs(diagram) // Int32Array(6) [ 0, 1, 0, 2, 1, 2 ]
 */
export function neighborPairs(diagram: DiagramData): Int32Array
export function neighborPairs(diagram: DiagramData, ...others: readonly unknown[]): Int32Array {
  checkNoOptions(others, 'neighborPairs')
  checkData(diagram, 'neighborPairs')
  const { circles, edges } = diagram
  const count = circles.length / 3
  // As numbers i n + j, which doubles hold exactly.
  const keys = new Float64Array(edges.length / 4).map((_, e) => {
    const left = at(edges, 4 * e)
    const right = at(edges, 4 * e + 1)
    return Math.min(left, right) * count + Math.max(left, right)
  })
  const pairs = keys.sort().filter((key, k) => key !== keys[k - 1])
  return new Int32Array(2 * pairs.length).map((_, k) => {
    const key = at(pairs, k >> 1)
    return k & 1 ? key % count : Math.floor(key / count)
  })
}

/**
 * Two circles and the gap between them.
 *
 * @category Questions
 */
export interface ClosestPair {
  /** The circle with the smaller index. */
  readonly first: number
  readonly second: number
  /** |c - c'| - r - r': negative if the two overlap. */
  readonly gap: number
}

/**
 * Finds the two visible circles with the smallest gap. Returns `undefined` if fewer than two circles are visible.
 *
 * @throws CircleVoronoiError `badArgument`, if the diagram is of another metric than `circles`
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
  // The two share an edge: a circle k nearer than gap / 2 to the middle of their gap would have a smaller gap to each.
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

/** If gaps are equal, the pair with the smallest indices counts, whatever the order of the edges. */
function isBefore(first: number, second: number, other: ClosestPair): boolean {
  return first < other.first || (first === other.first && second < other.second)
}
