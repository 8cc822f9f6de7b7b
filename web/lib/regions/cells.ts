// SPDX-License-Identifier: GPL-3.0-or-later

import { at, circleAt, NONE } from '../base/diagram-data.ts'
import { between, dot } from '../base/point.ts'
import { hypotenuse, largestOf, lengthOf, measuredIn, unitFor } from '../base/scale.ts'
import type { DiagramData } from '../base/types.ts'
import { type EdgeCurve, edgeCurve, reversed } from '../curves/curve.ts'

/**
 * The cells of a diagram, which must be certified, or a comparison diagram: what its arrays say of sides.
 *
 * @category Cells
 * @example
 * const { cells } = diagram
 * cells.isBounded(0) // false
 * cells.contains(0, 1, 1) // true
 * cells.sides(0).map((side) => cells.neighborOf(side)) // Int32Array(2) [ 2, 1 ]
 */
export class Cells {
  readonly diagram: DiagramData

  /** Of a diagram, which is not copied. */
  constructor(diagram: DiagramData) {
    this.diagram = diagram
  }

  /** Hidden circles have no cell. */
  exists(circle: number): boolean {
    const { firstSide, hull } = this.diagram
    return (firstSide[circle] ?? NONE) !== NONE || (hull.length === 1 && hull[0] === circle)
  }

  /** The largest distance from the circle's centre to a point of its cell; infinite for an unbounded one, NaN for none. */
  reach(circle: number): number {
    if (!this.exists(circle)) return Number.NaN
    const { firstSide, nextSide } = this.diagram
    const first = at(firstSide, circle)
    // A circle without sides has the whole plane.
    if (first === NONE) return Number.POSITIVE_INFINITY
    let reach = 0
    let side = first
    do {
      reach = Math.max(reach, this.#reachOf(side))
      side = at(nextSide, side)
    } while (side !== first)
    return reach
  }

  /** Whether there is a cell, and it does not go to infinity. */
  isBounded(circle: number): boolean {
    return this.reach(circle) < Number.POSITIVE_INFINITY
  }

  /**
   * The sides of a cell, counter-clockwise; none if there is no cell, or it is the whole plane. Where the cell goes to
   * infinity, the next side after one that ends there begins there.
   */
  sides(circle: number): Int32Array {
    const { firstSide, nextSide } = this.diagram
    // Past the circles there are no sides either.
    const first = firstSide[circle] ?? NONE
    if (first === NONE) return new Int32Array()
    const sides = [first]
    for (let side = at(nextSide, first); side !== first; side = at(nextSide, side)) sides.push(side)
    return Int32Array.from(sides)
  }

  /** The circle whose cell the side belongs to. */
  circleOf(side: number): number {
    return at(this.diagram.edges, 4 * (side >> 1) + (side & 1))
  }

  /** The circle on the other side of the edge. */
  neighborOf(side: number): number {
    return this.circleOf(side ^ 1)
  }

  /** The vertex where a side begins, or `NONE`. */
  originOf(side: number): number {
    return at(this.diagram.edges, 4 * (side >> 1) + 2 + (side & 1))
  }

  /** The vertex where a side ends, or `NONE`. */
  targetOf(side: number): number {
    return this.originOf(side ^ 1)
  }

  /** The curve of a side, with its cell on the left. */
  curveOf(side: number): EdgeCurve {
    const curve = edgeCurve(this.diagram, side >> 1)
    return side & 1 ? reversed(curve) : curve
  }

  /** The circles across the sides of a cell, in their order: a circle recurs if the two share several edges. */
  neighbors(circle: number): Int32Array {
    return this.sides(circle).map((side) => this.neighborOf(side))
  }

  /**
   * Whether no circle is nearer to (x, y), up to rounding. It suffices to ask the neighbours: a ray from the centre that
   * leaves the cell across a side stays nearer to the neighbour there, and for the metric `power` a cell is the
   * intersection of half-planes, one for each neighbour. False for a hidden circle.
   */
  contains(circle: number, x: number, y: number): boolean {
    return (
      this.exists(circle) && this.sides(circle).every((side) => this.lead(circle, this.neighborOf(side), x, y) >= 0)
    )
  }

  /**
   * How much nearer (x, y) is to one circle than to another, negative if the other is nearer: the difference of their
   * distances, but without cancellation where the point is far away. Of the metric `power` it is divided by a length.
   */
  lead(circle: number, other: number, x: number, y: number): number {
    // |p - d|^2 - |p - c|^2 = (c - d) . ((p - c) + (p - d))
    const { circles, metric } = this.diagram
    const c = circleAt(circles, circle)
    const d = circleAt(circles, other)
    const fromCircle = between(c, { x, y })
    const fromOther = between(d, { x, y })
    const difference = metric === 'centers' ? 0 : d.r - c.r
    let size = lengthOf(fromCircle) + lengthOf(fromOther)
    if (metric === 'power') size += c.r + d.r
    if (size === 0) return -difference
    const sum = { x: fromCircle.x + fromOther.x, y: fromCircle.y + fromOther.y }
    const unit = unitFor(largestOf(between(d, c)))
    const sumUnit = unitFor(Math.max(largestOf(sum), size))
    const product = dot(measuredIn(unit, between(d, c)), measuredIn(sumUnit, sum))
    if (metric !== 'power') return (product / (size / sumUnit)) * unit - difference
    return ((product - (difference / unit) * ((c.r + d.r) / sumUnit)) / (size / sumUnit)) * unit
  }

  /** The distance from the centre of the side's circle to where it begins, which the side before has, too. */
  #reachOf(side: number): number {
    const origin = this.originOf(side)
    if (origin === NONE) return Number.POSITIVE_INFINITY
    const { circles, vertices } = this.diagram
    const circle = this.circleOf(side)
    const dx = at(vertices, 3 * origin) - at(circles, 3 * circle)
    const dy = at(vertices, 3 * origin + 1) - at(circles, 3 * circle + 1)
    return Math.min(hypotenuse(dx, dy), Number.MAX_VALUE)
  }
}
