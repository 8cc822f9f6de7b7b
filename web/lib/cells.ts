// SPDX-License-Identifier: GPL-3.0-or-later
import { type EdgeCurve, edgeCurve, reversed } from './curve.ts'
import { at, circleAt, type DiagramData, NONE, vertexAt } from './diagram-data.ts'
import { between, dot } from './point.ts'
import { largestOf, lengthOf, measuredIn, unitFor } from './scale.ts'

/**
 * The cells of a diagram: which sides each has, in order. Made once per diagram, in linear time.
 *
 * An edge seen from one of its two cells is a *side* of that cell. Side 2 e of edge e belongs to the left circle and runs
 * from start to end; side 2 e + 1 belongs to the right circle and runs back. So every side has its own cell on its left,
 * and the sides of a cell run counter-clockwise around it.
 *
 * The diagram must be certified, or a comparison diagram.
 */
export class Cells {
  readonly diagram: DiagramData
  /** The sides of cell i are those from `#first[i]` to `#first[i + 1]` in `#sides`. */
  readonly #first: Int32Array
  readonly #sides: Int32Array
  readonly #reach: Float64Array

  /** Sorts the sides of all cells, in linear time. */
  constructor(diagram: DiagramData) {
    const circleCount = diagram.circles.length / 3
    const sideCount = diagram.edges.length / 2
    this.diagram = diagram
    this.#first = new Int32Array(circleCount + 1)
    this.#sides = new Int32Array(sideCount)
    this.#reach = new Float64Array(circleCount)

    const some = new Int32Array(circleCount)
    for (let side = sideCount - 1; side >= 0; side--) {
      const circle = this.circleOf(side)
      some[circle] = side
      this.#first[circle + 1] = at(this.#first, circle + 1) + 1
      this.#reach[circle] = Math.max(at(this.#reach, circle), this.#reachOf(side))
    }
    for (let i = 0; i < circleCount; i++) this.#first[i + 1] = at(this.#first, i + 1) + at(this.#first, i)

    // The sides of a cell form one cycle, infinity included.
    const next = this.#nextSides()
    let place = 0
    for (let i = 0; i < circleCount; i++) {
      for (let side = at(some, i); place < at(this.#first, i + 1); side = at(next, side)) this.#sides[place++] = side
      // A circle without sides has the whole plane, unless it is hidden.
      if (at(this.#first, i) === place) this.#reach[i] = Number.POSITIVE_INFINITY
    }
    for (let h = 0; h < diagram.hidden.length; h += 2) this.#reach[at(diagram.hidden, h)] = Number.NaN
  }

  /** Hidden circles have no cell. */
  exists(circle: number): boolean {
    return this.reach(circle) >= 0
  }

  /** The largest distance from the circle's centre to a point of its cell; infinite for an unbounded one, NaN for none. */
  reach(circle: number): number {
    return at(this.#reach, circle)
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
    // Past the circles there are no sides either.
    return this.#sides.subarray(this.#first[circle] ?? 0, this.#first[circle + 1] ?? 0)
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
    const difference = metric === 'centres' ? 0 : d.r - c.r
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

  /** The largest distance from the centre of the side's circle to a point of the side: that of one of its ends. */
  #reachOf(side: number): number {
    const centre = circleAt(this.diagram.circles, this.circleOf(side))
    const distanceTo = (vertex: number) =>
      vertex === NONE
        ? Number.POSITIVE_INFINITY
        : Math.min(lengthOf(between(centre, vertexAt(this.diagram, vertex))), Number.MAX_VALUE)
    return Math.max(distanceTo(this.originOf(side)), distanceTo(this.targetOf(side)))
  }

  /** For each side the one that follows it counter-clockwise around its cell. */
  #nextSides(): Int32Array {
    const { circles, vertexCircles, edges, hull } = this.diagram
    // Each of the three cells at a vertex has one side that begins there.
    const departures = new Int32Array(vertexCircles.length)
    const slot = (vertex: number, circle: number) =>
      3 * vertex + (at(vertexCircles, 3 * vertex) === circle ? 0 : at(vertexCircles, 3 * vertex + 1) === circle ? 1 : 2)
    // A side that ends at infinity belongs to the hull's step from its neighbour to its circle, one that begins there to
    // the step from its circle to its neighbour; each step occurs once.
    const step = (from: number, to: number) => (from * circles.length) / 3 + to
    const fromInfinity = new Map<number, number>()
    const sides = new Int32Array(edges.length / 2)
    sides.forEach((_, side) => {
      const origin = this.originOf(side)
      if (origin === NONE) fromInfinity.set(step(this.circleOf(side), this.neighborOf(side)), side)
      else departures[slot(origin, this.circleOf(side))] = side
    })
    const following = new Map<number, number>()
    hull.forEach((circle, i) => {
      const [before, after] = [hull.at(i - 1) as number, hull[(i + 1) % hull.length] as number]
      following.set(step(before, circle), step(circle, after))
    })
    return sides.map((_, side) => {
      const target = this.targetOf(side)
      if (target !== NONE) return at(departures, slot(target, this.circleOf(side)))
      const next = following.get(step(this.neighborOf(side), this.circleOf(side))) as number
      return fromInfinity.get(next) as number
    })
  }
}
