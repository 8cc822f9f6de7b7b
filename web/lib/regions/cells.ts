// SPDX-License-Identifier: GPL-3.0-or-later

import { refuseArrays } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import { hypotenuse, unitFor } from '../base/scale.ts'
import type { DiagramData } from '../base/types.ts'
import { curveOf, type EdgeCurve, reversed } from '../curves/curve.ts'

/**
 * The cells of a diagram and their sides. The diagram must be certified, or a comparison diagram.
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

  /** Wraps a diagram without copying it. */
  constructor(diagram: DiagramData) {
    this.diagram = diagram
  }

  /** Returns whether a circle has a cell; hidden circles have none. */
  exists(circle: number): boolean {
    const { firstSide, hull } = this.diagram
    return (firstSide[circle] ?? NONE) !== NONE || (hull.length === 1 && hull[0] === circle)
  }

  /**
   * Returns the largest distance from the center of a circle to a point of its cell: infinity for an unbounded cell,
   * NaN if there is no cell.
   *
   * @throws CircleVoronoiError `badInput`, if the arrays of the diagram were changed so that the cell's sides lead
   *   elsewhere
   */
  reach(circle: number): number {
    if (!this.exists(circle)) return Number.NaN
    const { firstSide, nextSide } = this.diagram
    const first = at(firstSide, circle)
    // A circle without sides has the whole plane.
    if (first === NONE) return Number.POSITIVE_INFINITY
    let reach = 0
    let side = first
    let left = nextSide.length
    do {
      this.#checkSide(side, circle, left--)
      reach = Math.max(reach, this.#reachOf(side))
      side = at(nextSide, side)
    } while (side !== first)
    return reach
  }

  /** Returns whether a circle has a bounded cell. */
  isBounded(circle: number): boolean {
    return this.reach(circle) < Number.POSITIVE_INFINITY
  }

  /**
   * Returns the sides of a cell, counter-clockwise; none if there is no cell or it is the whole plane. In an unbounded
   * cell, the side that ends at infinity is followed by the side that begins there.
   *
   * @throws CircleVoronoiError `badInput`, if the arrays of the diagram were changed so that the cell's sides lead
   *   elsewhere
   */
  sides(circle: number): Int32Array {
    const { firstSide, nextSide } = this.diagram
    // An index past the last circle has no sides either.
    const first = firstSide[circle] ?? NONE
    if (first === NONE) return new Int32Array()
    const sides: number[] = []
    let side = first
    do {
      this.#checkSide(side, circle, nextSide.length - sides.length)
      sides.push(side)
      side = at(nextSide, side)
    } while (side !== first)
    return new Int32Array(sides)
  }

  /** Returns the circle whose cell a side belongs to. */
  circleOf(side: number): number {
    return at(this.diagram.edges, 4 * (side >> 1) + (side & 1))
  }

  /** Returns the circle on the other side of the edge. */
  neighborOf(side: number): number {
    return this.circleOf(side ^ 1)
  }

  /** Returns the vertex where a side begins, or `NONE` if it comes from infinity. */
  originOf(side: number): number {
    return at(this.diagram.edges, 4 * (side >> 1) + 2 + (side & 1))
  }

  /** Returns the vertex where a side ends, or `NONE` if it goes to infinity. */
  targetOf(side: number): number {
    return this.originOf(side ^ 1)
  }

  /** Returns the curve of a side, with its cell on the left. */
  curveOf(side: number): EdgeCurve {
    const curve = curveOf(this.diagram, side >> 1)
    return side & 1 ? reversed(curve) : curve
  }

  /**
   * Returns the circle across each side of a cell, in order. A circle appears several times if the two cells share
   * several edges.
   */
  neighbors(circle: number): Int32Array {
    return this.sides(circle).map((side) => this.neighborOf(side))
  }

  /**
   * Returns whether (x, y) lies in the cell of a circle, up to rounding: whether no other circle is nearer. Returns
   * false for a hidden circle.
   */
  contains(circle: number, x: number, y: number): boolean {
    if (!this.exists(circle)) return false
    // It suffices to test the neighbors: a ray from the center that leaves the cell across a side stays nearer to the
    // neighbor there, and for the metric `power` a cell is the intersection of half-planes, one for each neighbor. If a
    // neighbor is as near as the circle up to rounding, one of its own neighbors may be much nearer.
    const asked = new Set([circle])
    for (const k of asked) {
      for (const other of this.neighbors(k)) {
        if (asked.has(other)) continue
        const difference = this.distanceDifference(circle, other, x, y)
        const rounding = this.#roundingOfDifference(circle, other)
        // The comparison is false for NaN, too.
        if (!(difference >= (k === circle ? 0 : -rounding))) return false
        if (difference <= rounding) asked.add(other)
      }
    }
    return true
  }

  /**
   * Returns how much nearer (x, y) is to one circle than to another: the difference of their distances, negative if the
   * other circle is nearer, computed without cancellation for points far away. For the metric `power` the difference is
   * divided by a length.
   */
  distanceDifference(circle: number, other: number, x: number, y: number): number {
    // |p - d|^2 - |p - c|^2 = (c - d) . ((p - c) + (p - d))
    const { circles, metric, weights } = this.diagram
    const cx = at(circles, 3 * circle)
    const cy = at(circles, 3 * circle + 1)
    const dx = at(circles, 3 * other)
    const dy = at(circles, 3 * other + 1)
    const cr = at(circles, 3 * circle + 2)
    const dr = at(circles, 3 * other + 2)
    const difference = metric === 'centers' ? 0 : dr - cr
    const radii = metric === 'power' ? this.#radiusOf(circle) + this.#radiusOf(other) : 0
    const size = hypotenuse(x - cx, y - cy) + hypotenuse(x - dx, y - dy) + radii
    if (size === 0) return -difference
    const sumX = x - cx + (x - dx)
    const sumY = y - cy + (y - dy)
    // The point may lie anywhere.
    const unit = unitFor(Math.max(Math.abs(sumX), Math.abs(sumY), size))
    const product = (cx - dx) * (sumX / unit) + (cy - dy) * (sumY / unit)
    if (metric !== 'power') return product / (size / unit) - difference
    return (product - difference * ((weights ? 1 : radii) / unit)) / (size / unit)
  }

  /**
   * Returns a bound on the rounding error of `distanceDifference`: a part of the distance between the two centers minus
   * the difference of the radii.
   */
  #roundingOfDifference(circle: number, other: number): number {
    const { circles } = this.diagram
    const dx = at(circles, 3 * circle) - at(circles, 3 * other)
    const dy = at(circles, 3 * circle + 1) - at(circles, 3 * other + 1)
    return 2 ** -49 * (hypotenuse(dx, dy) + Math.abs(this.signedRadiusOf(circle) - this.signedRadiusOf(other)))
  }

  /** Returns the radius of a circle, or the root of the weight that it has in a power diagram, with the weight's sign. */
  signedRadiusOf(circle: number): number {
    const { circles, metric, weights } = this.diagram
    const r = at(circles, 3 * circle + 2)
    return metric === 'power' && weights ? Math.sign(r) * Math.sqrt(Math.abs(r)) : r
  }

  #radiusOf(circle: number): number {
    return Math.abs(this.signedRadiusOf(circle))
  }

  /** Checks the next side of a walk around a cell that may visit `left` more sides. */
  #checkSide(side: number, circle: number, left: number): void {
    const { circles, vertices } = this.diagram
    const other = this.neighborOf(side)
    const origin = this.originOf(side)
    const isOfCell = this.circleOf(side) === circle && other >= 0 && other < circles.length / 3
    if (!(left > 0 && isOfCell && origin >= NONE && origin < vertices.length / 3)) refuseArrays('circle', circle)
  }

  /**
   * Returns the distance from the circle's center to the start of a side, which is also the end of the previous side.
   */
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
