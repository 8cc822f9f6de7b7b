// SPDX-License-Identifier: GPL-3.0-or-later

import { refuseArrays, refuseInfinite } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import { between } from '../base/point.ts'
import { facing, turn } from '../base/scale.ts'
import type { Point, Vector } from '../base/types.ts'
import type { Cells } from '../regions/cells.ts'
import { BucketGrid } from './bucket-grid.ts'

/**
 * The largest number of sides for which testing every neighbor is faster than bisection. The nearest neighbor then
 * gives the longest step.
 */
const FEW_SIDES = 24
/** The relative error bound of a difference of distances: more than twice the rounding of its operations. */
const ROUNDING = 2 ** -49
/** Squares of smaller numbers lose digits. */
const SMALL = 1e-140
/** Sides that are tested around the one in the direction of a point. */
const SIDES_TESTED = 4
/** Sides of a cell before the direction of a point where a walk to the point may start. */
const SIDES_BEFORE = 3
/** Growth of the number of circles, as a factor and a constant, after which the grid is rebuilt. */
const MOST_GROWTH = 4
const FEW_CIRCLES = 16

/**
 * Finds the nearest circle by a walk through the cells.
 *
 * From cell i the walk goes on to a neighbor that is nearer to p, until there is none. That cannot end too early: the
 * cells are star-shaped around their centers, so if p is outside cell i, the segment from c_i to p leaves it across a
 * side, and from there on it is nearer to the neighbor across that side (the points nearer to i than to j are
 * star-shaped around c_i too). In a cell with many sides, the side is found by bisection. For the metric `power`, cells
 * are intersections of half-planes, one for each neighbor, and some half-plane excludes p. Its border is crossed on the
 * way from any point of the cell to p.
 *
 * A grid of starting circles shortens the walk to a step or two if the circles are spread evenly.
 */
export class Finder {
  readonly #cells: Cells
  /** The circles to start from; `undefined` if no circle has a cell. */
  readonly #starts: BucketGrid | undefined
  /** The sides of cells that have or had more than `FEW_SIDES`; `undefined` until they are read. */
  readonly #manySides = new Map<number, ManySides | undefined>()
  /** The number of circles that the grid was made for. */
  readonly #circleCount: number
  /** The circle found last, as a start if the circle of a bucket is gone. */
  #last: number = 0

  /** Builds the grid in linear time. */
  constructor(cells: Cells) {
    this.#cells = cells
    const { circles } = cells.diagram
    this.#circleCount = circles.length / 3
    const visible: number[] = []
    for (let i = 0; i < circles.length / 3; i++) {
      if (!cells.exists(i)) continue
      visible.push(i)
      if (!Number.isFinite(at(circles, 3 * i) + at(circles, 3 * i + 1))) refuseInfinite(circles)
    }
    if (visible.length > 0) this.#starts = new BucketGrid(circles, Int32Array.from(visible))
    const count = new Int32Array(circles.length / 3)
    for (let side = 0; side < cells.diagram.edges.length / 2; side++) {
      const circle = cells.circleOf(side)
      count[circle] = at(count, circle) + 1
    }
    count.forEach((its, circle) => {
      if (its > FEW_SIDES) this.#manySides.set(circle, undefined)
    })
  }

  /**
   * Returns the circle nearest to (x, y), or `NONE` if there are no circles or a coordinate is not finite. Ties up to
   * rounding may go to any of the nearest circles. The walk starts near the point, or at `hint` if that is nearer.
   */
  find(x: number, y: number, hint: number = NONE): number {
    if (this.#starts === undefined || !Number.isFinite(x) || !Number.isFinite(y)) return NONE
    let circle = this.#starts.near(x, y)
    if (!this.#cells.exists(circle)) circle = this.#someCircle()
    if (circle === NONE) return NONE
    if (this.#cells.exists(hint) && this.#cells.distanceDifference(hint, circle, x, y) > 0) circle = hint
    // Each step comes nearer, so the walk ends. But rounding may lead around a loop, which then meets the circle marked
    // at step 4, 8, 16 and so on.
    let marked = circle
    for (let step = 0, markAt = 4; ; step++) {
      const next = this.#nearerNeighbor(circle, x, y)
      if (next === NONE || next === marked) {
        this.#last = circle
        return circle
      }
      circle = next
      if (step !== markAt) continue
      circle = this.#across(circle, x, y)
      marked = circle
      markAt *= 2
    }
  }

  /** Returns the circle, or a nearer one across a neighbor with many sides: a short cut on a walk around that neighbor. */
  #across(circle: number, x: number, y: number): number {
    const many = this.#manySides
    if (many.has(circle)) return circle
    for (const neighbor of this.#cells.neighbors(circle)) {
      const next = many.has(neighbor) ? this.#nearerNeighbor(circle, x, y, neighbor) : NONE
      if (next !== NONE) return next
    }
    return circle
  }

  /**
   * Returns the nearest circle of each point; `points` has x and y of each. It is fastest if consecutive points are
   * near each other.
   */
  findAll(points: Float64Array): Int32Array {
    let circle = NONE
    return new Int32Array(points.length >> 1).map((_, k) => {
      circle = this.find(at(points, 2 * k), at(points, 2 * k + 1), circle)
      return circle
    })
  }

  /**
   * Updates the finder after some circles and their cells have changed. Returns false if the diagram has grown too much
   * and needs a new finder.
   */
  follow(changed: Iterable<number>): boolean {
    const cells = this.#cells
    const { circles } = cells.diagram
    if (this.#starts === undefined || circles.length / 3 > MOST_GROWTH * this.#circleCount + FEW_CIRCLES) return false
    for (const circle of changed) {
      const x = circles[3 * circle] as number
      const y = circles[3 * circle + 1] as number
      const origin = this.#manySides.get(circle)?.origin
      // A cell is seen from its center; where the center has stayed, many sides have, too.
      if (origin?.x !== x || origin?.y !== y) this.#manySides.set(circle, undefined)
      if (cells.exists(circle)) this.#starts.put(x, y, circle)
    }
    return true
  }

  /** Returns a circle with a cell, in place of a start that lost its cell; `NONE` if no circle has a cell. */
  #someCircle(): number {
    const { circles } = this.#cells.diagram
    const count = circles.length / 3
    for (let k = 0; k < count; k++) {
      const circle = (this.#last + k) % count
      if (this.#cells.exists(circle)) return circle
    }
    return NONE
  }

  /** Returns the mean of the vertices of a cell, which is inside the cells of the metric `power`, unlike the center. */
  #middleOf(sides: Int32Array): Point {
    const { vertices } = this.#cells.diagram
    const origins = sides.map((side) => this.#cells.originOf(side)).filter((origin) => origin !== NONE)
    const mean = (k: number) => origins.reduce((sum, v) => sum + at(vertices, 3 * v + k) / origins.length, 0)
    return { x: mean(0), y: mean(1) }
  }

  /** Reads the sides of a cell, and returns them if they are many. */
  #read(circle: number): ManySides | undefined {
    const sides = this.#cells.sides(circle)
    if (sides.length <= FEW_SIDES) {
      this.#manySides.delete(circle)
      return undefined
    }
    const { circles, metric } = this.#cells.diagram
    const origin =
      metric === 'power' ? this.#middleOf(sides) : { x: at(circles, 3 * circle), y: at(circles, 3 * circle + 1) }
    const directions = Array.from(sides, (side) => this.#beginningOf(side, origin))
    const many = { origin, sides, directions, walked: 0 }
    this.#manySides.set(circle, many)
    return many
  }

  /** Returns the side before the one in the direction of a point; `undefined` if the cell has few sides. */
  #sideBefore(circle: number, x: number, y: number): number | undefined {
    if (!this.#manySides.has(circle)) return undefined
    const walkToward = (many: ManySides | undefined) => many && this.#walkToward(many, circle, { x, y })
    return walkToward(this.#manySides.get(circle)) ?? walkToward(this.#read(circle))
  }

  /**
   * Bisection finds an earlier side that is where it was when the sides were read. The walk from there passes the sides
   * that are new. The result is `undefined` if all walks together took more steps than it takes to read the sides.
   */
  #walkToward(many: ManySides, circle: number, point: Point): number | undefined {
    const { nextSide } = this.#cells.diagram
    const { origin, sides, directions } = many
    const toPoint = between(origin, point)
    const count = sides.length
    let place = (sidesUpTo(directions, toPoint) + count - SIDES_BEFORE) % count
    for (; many.walked <= count; many.walked++, place = (place + count - 1) % count) {
      if (!this.#isUnmoved(many, place, circle)) continue
      const first = at(sides, place)
      const reference = directions[place] as Vector
      let before = NONE
      let side = first
      let next = at(nextSide, side)
      for (let k = 0; next !== first && noLater(reference, this.#beginningOf(next, origin), toPoint); k++) {
        if (k >= SIDES_BEFORE && ++many.walked > count) return undefined
        before = side
        side = next
        next = at(nextSide, side)
      }
      if (before !== NONE) return before
    }
    return undefined
  }

  /** Whether a side is still a side of the cell that begins in the same direction. */
  #isUnmoved({ origin, sides, directions }: ManySides, place: number, circle: number): boolean {
    const side = at(sides, place)
    if (side >= this.#cells.diagram.nextSide.length || this.#cells.circleOf(side) !== circle) return false
    const { x, y } = this.#beginningOf(side, origin)
    const then = directions[place] as Vector
    return x === then.x && y === then.y
  }

  /** Returns a neighbor, of the circle or of another one, that is nearer to the point than the circle, or `NONE`. */
  #nearerNeighbor(circle: number, x: number, y: number, other: number = circle): number {
    const cells = this.#cells
    const { circles, metric, edges, nextSide, firstSide } = cells.diagram
    let side = at(firstSide, other)
    if (side === NONE) return NONE
    let stop = side
    const before = this.#sideBefore(other, x, y)
    if (before !== undefined) {
      // Rounding may choose the wrong side if a side has almost no length.
      side = before
      stop = at(nextSide, before)
      for (let k = 1; k < SIDES_TESTED && stop !== before; k++) stop = at(nextSide, stop)
    }
    let most = 0
    let nearest = NONE
    const r = at(circles, 3 * circle + 2)
    const toCenter = plainDistance(circles, circle, x, y)
    let left = nextSide.length
    do {
      if (left-- === 0) refuseArrays('circle', other)
      // The code of neighborOf(side) inline, because calls would be too slow here.
      const neighbor = at(edges, 4 * (side >> 1) + 1 - (side & 1))
      side = at(nextSide, side)
      const toOther = plainDistance(circles, neighbor, x, y)
      const otherR = at(circles, 3 * neighbor + 2)
      let difference = metric === 'centers' ? toCenter - toOther : toCenter - r - (toOther - otherR)
      if (metric === 'power' || !isClear(difference, toCenter, r, toOther, otherR))
        difference = cells.distanceDifference(neighbor, circle, x, y)
      if (difference > most) {
        most = difference
        nearest = neighbor
      }
    } while (side !== stop)
    return nearest
  }

  /** Returns the direction from a point of the cell to the start of a side. */
  #beginningOf(side: number, from: Point): Vector {
    const { vertices } = this.#cells.diagram
    const origin = this.#cells.originOf(side)
    if (origin !== NONE) return { x: at(vertices, 3 * origin) - from.x, y: at(vertices, 3 * origin + 1) - from.y }
    // The limit of point(s) as s goes to 0.
    const { a, b, along, across } = this.#cells.curveOf(side).bisector
    const size = Math.abs(a)
    return { x: -size * along.x - b * across.x, y: -size * along.y - b * across.y }
  }
}

/** The sides of a cell in order, as they were when they were read. */
interface ManySides {
  /** The center, or another point from which the whole cell is seen. */
  readonly origin: Point
  readonly sides: Int32Array
  /** The directions from the origin to the starts of the sides. */
  readonly directions: readonly Vector[]
  /** Steps of walks to points, past sides that have changed. */
  walked: number
}

/** Returns the number of directions up to the one to a point, counter-clockwise from the first. */
function sidesUpTo(directions: readonly Vector[], toPoint: Vector): number {
  const reference = directions[0] as Vector
  let low = 0
  let high = directions.length
  while (low < high) {
    const middle = (low + high) >> 1
    if (noLater(reference, directions[middle] as Vector, toPoint)) low = middle + 1
    else high = middle
  }
  return low
}

/** Returns the distance to the center of a circle. The squares may overflow or underflow. */
function plainDistance(circles: Float64Array, circle: number, x: number, y: number): number {
  const dx = x - at(circles, 3 * circle)
  const dy = y - at(circles, 3 * circle + 1)
  return Math.sqrt(dx * dx + dy * dy)
}

/**
 * Whether a difference of plain distances certainly has the right sign: it exceeds the rounding error, and no square
 * overflows or underflows.
 */
function isClear(difference: number, toCenter: number, r: number, toOther: number, otherR: number): boolean {
  return Math.abs(difference) > ROUNDING * (toCenter + toOther + Math.abs(r) + Math.abs(otherR)) + SMALL
}

/** Whether a counter-clockwise turn from `reference` meets v no later than w. */
function noLater(reference: Vector, v: Vector, w: Vector): boolean {
  const isSecondHalf = (u: Vector) => {
    const side = turn(reference, u)
    return side < 0 || (side === 0 && facing(reference, u) < 0)
  }
  if (isSecondHalf(v) !== isSecondHalf(w)) return isSecondHalf(w)
  return turn(v, w) >= 0
}
