// SPDX-License-Identifier: GPL-3.0-or-later
import { at, type Diagram, NONE } from './diagram.ts'
import { bisectorOf, circleOf, neighborOf, originOf, reachOf, targetOf } from './sides.ts'

/** The cells of a diagram: which sides (see sides.ts) each has, in order. Made once per diagram, in linear time. */
export class Cells {
  readonly diagram: Diagram
  /** The sides of cell i are those from `#first[i]` to `#first[i + 1]` in `#sides`. */
  readonly #first: Int32Array
  readonly #sides: Int32Array
  /** For each cell the largest distance of its points from the centre of its circle. */
  readonly #reach: Float64Array

  constructor(diagram: Diagram) {
    const circleCount = diagram.circles.length / 3
    const sideCount = diagram.edges.length / 2
    this.diagram = diagram
    this.#first = new Int32Array(circleCount + 1)
    this.#sides = new Int32Array(sideCount)
    this.#reach = new Float64Array(circleCount).fill(Number.NEGATIVE_INFINITY)

    for (let side = 0; side < sideCount; side++) {
      const circle = circleOf(diagram, side)
      this.#first[circle + 1] = at(this.#first, circle + 1) + 1
      this.#reach[circle] = Math.max(at(this.#reach, circle), reachOf(diagram, side))
    }
    for (let i = 0; i < circleCount; i++) this.#first[i + 1] = at(this.#first, i + 1) + at(this.#first, i)

    const place = this.#first.slice()
    for (const side of sidesInOrder(diagram)) {
      const circle = circleOf(diagram, side)
      this.#sides[at(place, circle)] = side
      place[circle] = at(place, circle) + 1
    }

    // A circle without sides has no cell, or the whole plane if it is the only one that is not hidden.
    const hiddenCount = diagram.hidden.length / 2
    if (sideCount === 0 && hiddenCount === circleCount - 1) this.#reach.fill(Number.POSITIVE_INFINITY)
    for (let h = 0; h < hiddenCount; h++) this.#reach[at(diagram.hidden, 2 * h)] = Number.NEGATIVE_INFINITY
  }

  /** Hidden circles have no cell. */
  exists(circle: number): boolean {
    return at(this.#reach, circle) !== Number.NEGATIVE_INFINITY
  }

  /** The largest distance from the circle's centre to a point of its cell; infinite for an unbounded one. */
  reach(circle: number): number {
    return at(this.#reach, circle)
  }

  isBounded(circle: number): boolean {
    return this.exists(circle) && Number.isFinite(this.reach(circle))
  }

  /** The sides of a cell, counter-clockwise. Those of an unbounded cell begin with one that comes from infinity. */
  sides(circle: number): Int32Array {
    return this.#sides.subarray(at(this.#first, circle), at(this.#first, circle + 1))
  }

  /** The circles whose cells share an edge with that of `circle`, each once, in the order of the edges. */
  neighbors(circle: number): number[] {
    return [...new Set(Array.from(this.sides(circle), (side) => neighborOf(this.diagram, side)))]
  }
}

/** All sides, those of one cell in counter-clockwise order. */
function* sidesInOrder(diagram: Diagram): Generator<number> {
  const sideCount = diagram.edges.length / 2
  const next = nextSides(diagram)
  const seen = new Uint8Array(sideCount)
  function* chain(head: number): Generator<number> {
    for (let side = head; side !== NONE && seen[side] === 0; side = at(next, side)) {
      seen[side] = 1
      yield side
    }
  }

  // An unbounded cell is bounded by chains from infinity to infinity; a bounded one by a single loop.
  const heads: { side: number; angle: number }[] = []
  for (let side = 0; side < sideCount; side++) {
    if (originOf(diagram, side) === NONE) heads.push({ side, angle: angleAtInfinity(diagram, side) })
  }
  heads.sort((one, other) => one.angle - other.angle)
  for (const { side } of heads) yield* chain(side)
  for (let side = 0; side < sideCount; side++) yield* chain(side)
}

/** For each side the next one of its cell, or `NONE` where the side goes to infinity. */
function nextSides(diagram: Diagram): Int32Array {
  const { vertexCircles, edges } = diagram
  const sideCount = edges.length / 2
  // Each of the three cells at a vertex has one side that begins there.
  const departures = new Int32Array(vertexCircles.length).fill(NONE)
  const slot = (vertex: number, circle: number) =>
    3 * vertex + (at(vertexCircles, 3 * vertex) === circle ? 0 : at(vertexCircles, 3 * vertex + 1) === circle ? 1 : 2)
  for (let side = 0; side < sideCount; side++) {
    const origin = originOf(diagram, side)
    if (origin !== NONE) departures[slot(origin, circleOf(diagram, side))] = side
  }
  return new Int32Array(sideCount).map((_, side) => {
    const target = targetOf(diagram, side)
    return target === NONE ? NONE : at(departures, slot(target, circleOf(diagram, side)))
  })
}

/** The direction from which a side comes that begins at infinity. */
function angleAtInfinity(diagram: Diagram, side: number): number {
  const { ux, uy, a, b } = bisectorOf(diagram, side)
  // The limit of a cosh(t) u + b sinh(t) v is along a u - b v.
  return Math.atan2(a * uy - b * ux, a * ux + b * uy)
}
