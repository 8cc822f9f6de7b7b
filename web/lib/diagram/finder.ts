// SPDX-License-Identifier: GPL-3.0-or-later

import { refuseArrays, refuseInfinite } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import { facing, turn } from '../base/scale.ts'
import type { Vector } from '../base/types.ts'
import type { Cells } from '../regions/cells.ts'

/**
 * The largest number of sides for which asking every neighbor is faster. The nearest neighbor then makes the longest
 * step.
 */
const FEW_SIDES = 24
/** The error of a difference of distances, as a share of its numbers: more than twice the loss of its operations. */
const ROUNDING = 2 ** -49
/** Squares of smaller numbers lose digits. */
const SMALL = 1e-140
/** Circles for each bucket of the grid, on average. */
const PER_BUCKET = 2
/** Growth of the number of circles, as a factor and a constant, after which the grid is rebuilt. */
const MOST_GROWTH = 4
const FEW_CIRCLES = 16

/**
 * Finds the nearest circle by a walk through the cells.
 *
 * From cell i the walk goes on to a neighbor that is nearer to p, until there is none. That cannot end too early: the
 * cells are star-shaped around their centers, so if p is outside cell i, the segment from c_i to p leaves it across a
 * side, and from there on it is nearer to the neighbor across that side (the points nearer to i than to j are
 * star-shaped around c_i too). In a cell with many sides, the side is found by bisection. For the metric `power` cells
 * are intersections of half-planes, one for each neighbor, and one of them excludes p.
 *
 * A grid of starting circles makes the walk short: for circles spread evenly a step or two.
 */
export class Finder {
  readonly #cells: Cells
  /** The corner of the grid, the side of its square buckets, and their number. */
  readonly #minX: number = 0
  readonly #minY: number = 0
  readonly #side: number = 1
  readonly #columns: number = 0
  readonly #rows: number = 0
  /** A visible circle for each bucket, row by row. */
  readonly #starts: Int32Array
  /** The sides of cells with more than `FEW_SIDES`; of those that have changed, and may have fewer, not yet. */
  readonly #manySides: Map<number, Int32Array | undefined>
  /** The number of circles that the grid was made for. */
  readonly #circleCount: number
  /** A circle that was found last, where a start is gone. */
  #last: number = 0

  /** In linear time. */
  constructor(cells: Cells) {
    this.#cells = cells
    const { circles } = cells.diagram
    let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity]
    this.#circleCount = circles.length / 3
    let visible = 0
    for (let i = 0; i < circles.length / 3; i++) {
      if (!cells.exists(i)) continue
      visible += 1
      minX = Math.min(minX, at(circles, 3 * i))
      minY = Math.min(minY, at(circles, 3 * i + 1))
      maxX = Math.max(maxX, at(circles, 3 * i))
      maxY = Math.max(maxY, at(circles, 3 * i + 1))
    }
    if (visible > 0) {
      this.#minX = minX
      this.#minY = minY
      const [width, height] = [maxX - minX, maxY - minY]
      if (!Number.isFinite(width + height)) refuseInfinite(circles)
      const wanted = Math.max(1, visible / PER_BUCKET)
      const extent = Math.max(width, height) // a product of the smallest numbers would be 0
      const share = Math.max(Math.sqrt(((width / extent) * (height / extent)) / wanted), 1 / wanted)
      this.#side = extent * share || 1 // any size does for one place
      this.#columns = Math.floor(width / this.#side) + 1
      this.#rows = Math.floor(height / this.#side) + 1
    }
    this.#starts = this.#filledGrid()
    this.#manySides = manySidesOf(cells)
  }

  /**
   * The circle of smallest distance to (x, y), one of them up to rounding where several are. The walk starts near the
   * point, or from `hint`, if that is nearer. `NONE` if there are no circles, or a coordinate is not finite.
   */
  find(x: number, y: number, hint: number = NONE): number {
    if (this.#columns === 0 || !Number.isFinite(x) || !Number.isFinite(y)) return NONE
    let circle = at(this.#starts, this.#bucketOf(x, y))
    if (!this.#cells.exists(circle)) circle = this.#someCircle()
    if (circle === NONE) return NONE
    if (this.#cells.exists(hint) && this.#lead(hint, circle, x, y) > 0) circle = hint
    // Each step comes nearer, so that none is made twice, but rounding may lead around in a circle: then one is met
    // again
    // that was marked at step 1, 2, 4, 8 and so on.
    let marked = circle
    for (let step = 0, markAt = 1; ; step++) {
      const next = this.#nearerNeighbor(circle, x, y)
      if (next === NONE || next === marked) {
        this.#last = circle
        return circle
      }
      circle = next
      if (step !== markAt) continue
      marked = circle
      markAt *= 2
    }
  }

  /**
   * For each of many points, x and y each, the same; points near in the list that are near in the plane help. Half as
   * many
   * indices as numbers.
   */
  findAll(points: Float64Array): Int32Array {
    let circle = NONE
    return new Int32Array(points.length >> 1).map((_, k) => {
      circle = this.find(at(points, 2 * k), at(points, 2 * k + 1), circle)
      return circle
    })
  }

  /**
   * Told that some circles of the diagram, and their cells, are others now. Returns whether this is still good for the
   * diagram:
   * not, if it has grown too much.
   */
  follow(changed: Iterable<number>): boolean {
    const cells = this.#cells
    const { circles } = cells.diagram
    if (this.#columns === 0 || circles.length / 3 > MOST_GROWTH * this.#circleCount + FEW_CIRCLES) return false
    for (const circle of changed) {
      this.#manySides.set(circle, undefined)
      if (cells.exists(circle))
        this.#starts[this.#bucketOf(at(circles, 3 * circle), at(circles, 3 * circle + 1))] = circle
    }
    return true
  }

  /** A circle with a cell, where a start has none any more; `NONE` if there is none. */
  #someCircle(): number {
    const { circles } = this.#cells.diagram
    const count = circles.length / 3
    for (let k = 0; k < count; k++) {
      const circle = (this.#last + k) % count
      if (this.#cells.exists(circle)) return circle
    }
    return NONE
  }

  /** The sides of a cell, if they are many. */
  #manySidesOf(circle: number): Int32Array | undefined {
    if (this.#manySides.size === 0) return undefined
    const known = this.#manySides.get(circle)
    if (known !== undefined || !this.#manySides.has(circle)) return known
    const sides = this.#cells.sides(circle)
    if (sides.length > FEW_SIDES) {
      this.#manySides.set(circle, sides)
      return sides
    }
    this.#manySides.delete(circle)
    return undefined
  }

  #bucketOf(x: number, y: number): number {
    const column = Math.min(Math.max(Math.floor((x - this.#minX) / this.#side), 0), this.#columns - 1)
    const row = Math.min(Math.max(Math.floor((y - this.#minY) / this.#side), 0), this.#rows - 1)
    return row * this.#columns + column
  }

  #filledGrid(): Int32Array {
    const { circles } = this.#cells.diagram
    const columns = this.#columns
    const starts = new Int32Array(columns * this.#rows).fill(NONE)
    for (let i = 0; i < circles.length / 3; i++) {
      if (this.#cells.exists(i)) starts[this.#bucketOf(at(circles, 3 * i), at(circles, 3 * i + 1))] = i
    }
    // Empty buckets take the start of a filled one near them. The list grows while it is gone through.
    const filled: number[] = []
    for (let bucket = 0; bucket < starts.length; bucket++) {
      if (at(starts, bucket) !== NONE) filled.push(bucket)
    }
    for (const bucket of filled) {
      const column = bucket % columns
      const near = []
      if (column > 0) near.push(bucket - 1)
      if (column + 1 < columns) near.push(bucket + 1)
      near.push(bucket - columns, bucket + columns)
      for (const next of near) {
        if (starts[next] !== NONE) continue
        starts[next] = at(starts, bucket)
        filled.push(next)
      }
    }
    return starts
  }

  /** A neighbor nearer to the point than the circle itself, or `NONE`. */
  #nearerNeighbor(circle: number, x: number, y: number): number {
    const cells = this.#cells
    const { circles, metric, edges, nextSide, firstSide } = cells.diagram
    let side = at(firstSide, circle)
    if (side === NONE) return NONE
    let stop = side
    const many = metric === 'power' ? undefined : this.#manySidesOf(circle)
    if (many !== undefined) {
      // Rounding may be off by a side of next to no length.
      const after = this.#sidesUpTo(many, circle, x, y)
      side = at(many, (after + many.length - 2) % many.length)
      stop = at(many, (after + 2) % many.length)
    }
    let most = 0
    let nearest = NONE
    const r = at(circles, 3 * circle + 2)
    const toCenter = plainDistance(circles, circle, x, y)
    let left = nextSide.length
    do {
      if (left-- === 0) refuseArrays('circle', circle)
      // neighborOf(side), to which calls are too much here.
      const neighbor = at(edges, 4 * (side >> 1) + 1 - (side & 1))
      side = at(nextSide, side)
      const toOther = plainDistance(circles, neighbor, x, y)
      const otherR = at(circles, 3 * neighbor + 2)
      let lead = metric === 'centers' ? toCenter - toOther : toCenter - r - (toOther - otherR)
      if (metric === 'power' || !isClear(lead, toCenter, r, toOther, otherR)) lead = cells.lead(neighbor, circle, x, y)
      if (lead > most) {
        most = lead
        nearest = neighbor
      }
    } while (side !== stop)
    return nearest
  }

  /** The lead of one circle over another at a point, by plain distances unless rounding may decide. */
  #lead(circle: number, other: number, x: number, y: number): number {
    const { circles, metric } = this.#cells.diagram
    if (metric === 'circles') {
      const [r, otherR] = [at(circles, 3 * circle + 2), at(circles, 3 * other + 2)]
      const toCenter = plainDistance(circles, circle, x, y)
      const toOther = plainDistance(circles, other, x, y)
      const lead = toOther - otherR - (toCenter - r)
      if (isClear(lead, toCenter, r, toOther, otherR)) return lead
    }
    return this.#cells.lead(circle, other, x, y)
  }

  /** The number of sides of a cell before the direction of a point, counted from the start of the first side. */
  #sidesUpTo(sides: Int32Array, circle: number, x: number, y: number): number {
    const { circles } = this.#cells.diagram
    const toPoint = { x: x - at(circles, 3 * circle), y: y - at(circles, 3 * circle + 1) }
    const reference = this.#beginningOf(at(sides, 0))
    let low = 0
    let high = sides.length
    while (low < high) {
      const middle = (low + high) >> 1
      if (noLater(reference, this.#beginningOf(at(sides, middle)), toPoint)) low = middle + 1
      else high = middle
    }
    return low
  }

  /** The direction from the cell's center in which a side begins. */
  #beginningOf(side: number): Vector {
    const { circles, vertices } = this.#cells.diagram
    const circle = this.#cells.circleOf(side)
    const origin = this.#cells.originOf(side)
    if (origin !== NONE) {
      return {
        x: at(vertices, 3 * origin) - at(circles, 3 * circle),
        y: at(vertices, 3 * origin + 1) - at(circles, 3 * circle + 1),
      }
    }
    // The limit of point(s) as s goes to 0.
    const { a, b, along, across } = this.#cells.curveOf(side).bisector
    const size = Math.abs(a)
    return { x: -size * along.x - b * across.x, y: -size * along.y - b * across.y }
  }
}

function manySidesOf(cells: Cells): Map<number, Int32Array | undefined> {
  const { circles, edges } = cells.diagram
  const count = new Int32Array(circles.length / 3)
  for (let side = 0; side < edges.length / 2; side++) {
    const circle = cells.circleOf(side)
    count[circle] = at(count, circle) + 1
  }
  const sides = new Map<number, Int32Array | undefined>()
  count.forEach((its, circle) => {
    if (its > FEW_SIDES) sides.set(circle, cells.sides(circle))
  })
  return sides
}

/** The distance from the center of a circle, without care for numbers whose squares are beyond the range of numbers. */
function plainDistance(circles: Float64Array, circle: number, x: number, y: number): number {
  const dx = x - at(circles, 3 * circle)
  const dy = y - at(circles, 3 * circle + 1)
  return Math.sqrt(dx * dx + dy * dy)
}

/**
 * Whether a lead that was found by plain distances is right in its sign. Comparisons that rounding may decide, here or
 * beyond the range of squares, need care.
 */
function isClear(lead: number, toCenter: number, r: number, toOther: number, otherR: number): boolean {
  return Math.abs(lead) > ROUNDING * (toCenter + toOther + Math.abs(r) + Math.abs(otherR)) + SMALL
}

/** Whether turning counter-clockwise from `reference` one meets v no later than w. */
function noLater(reference: Vector, v: Vector, w: Vector): boolean {
  const isSecondHalf = (u: Vector) => {
    const side = turn(reference, u)
    return side < 0 || (side === 0 && facing(reference, u) < 0)
  }
  if (isSecondHalf(v) !== isSecondHalf(w)) return isSecondHalf(w)
  return turn(v, w) >= 0
}
