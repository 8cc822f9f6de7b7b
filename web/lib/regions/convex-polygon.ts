// SPDX-License-Identifier: GPL-3.0-or-later
import { checkOptionNames, refuseOption, shown } from '../base/check.ts'
import { REGION_LIMIT, REGION_LIMIT_TEXT, rounded } from '../base/coordinate-limits.ts'
import { between, cross } from '../base/point.ts'
import { facing, turn } from '../base/scale.ts'
import type { Box, Point, Vector } from '../base/types.ts'

/**
 * A region to clip to: a box, also as `[minX, minY, maxX, maxY]`, or a convex polygon.
 *
 * @category Cells
 */
export type Bounds = Box | readonly [minX: number, minY: number, maxX: number, maxY: number] | ConvexPolygon

/**
 * The options of functions that only clip to bounds.
 *
 * @category Cells
 */
export interface ConvexBoundsOptions {
  readonly bounds: Bounds
}

/** @throws CircleVoronoiError `badOption`, if `bounds` is missing or there are other options */
export function boundsOf(options: ConvexBoundsOptions, caller: string): ConvexPolygon {
  checkOptionNames(options, caller, ['bounds'])
  return ConvexPolygon.of(options.bounds)
}

/**
 * A convex polygon, as a closed region for clipping.
 *
 * @category Cells
 * @example
 * const triangle = ConvexPolygon.from([{ x: 0, y: 0 }, { x: 9, y: 0 }, { x: 0, y: 9 }])
 * triangle.area() // 40.5
 * diagram.cellArea(0, { bounds: triangle }) // 12
 */
export class ConvexPolygon {
  /** The corners, counter-clockwise, rounded to multiples of 2^-96 like all numbers. */
  readonly corners: readonly Point[]
  /** The bounding box. */
  readonly box: Box
  /** Whether the polygon was made from a box. */
  readonly isBox: boolean

  private constructor(corners: readonly Point[], isBox = false) {
    this.isBox = isBox
    const least = (numbers: readonly number[]) => numbers.reduce((one, other) => Math.min(one, other))
    this.corners = corners
    this.box = {
      minX: least(corners.map(({ x }) => x)),
      minY: least(corners.map(({ y }) => y)),
      maxX: -least(corners.map(({ x }) => -x)),
      maxY: -least(corners.map(({ y }) => -y)),
    }
  }

  /**
   * Creates a polygon from its corners in counter-clockwise order. Corners may lie on the line through their neighbors.
   *
   * @throws CircleVoronoiError `badOption`, if there are fewer than three corners, a coordinate is not finite or exceeds
   * `REGION_LIMIT`, two corners in a row are equal, or they do not turn left exactly once.
   */
  static from(corners: readonly Point[]): ConvexPolygon {
    if (!Array.isArray(corners)) refuseOption(`The corners of a polygon are an array of points, not ${shown(corners)}.`)
    if (corners.length < 3) refuseOption('A convex polygon needs three corners or more.')
    if (!corners.every((corner) => isInRange(corner?.x) && isInRange(corner?.y))) {
      refuseOption(`A corner of the polygon is not finite, or beyond ${REGION_LIMIT_TEXT}.`)
    }
    const polygon = new ConvexPolygon(corners.map(({ x, y }) => ({ x: rounded(x), y: rounded(y) })))
    const sides = polygon.corners.map((corner, k) => between(corner, polygon.cornerAfter(k)))
    let halfTurns = 0
    sides.forEach((out, k) => {
      const before = sides.at(k - 1) as Vector
      if (out.x === 0 && out.y === 0) refuseOption('Two corners of the polygon in a row are equal.')
      const side = turn(before, out)
      if (side < 0 || (side === 0 && facing(before, out) < 0)) {
        refuseOption('The polygon is not convex, or its corners are not counter-clockwise.')
      }
      if (isUpper(before) !== isUpper(out)) halfTurns += 1
    })
    if (halfTurns !== 2) refuseOption('The polygon winds more than once, or has no area.')
    return polygon
  }

  /**
   * Creates the polygon of some bounds.
   *
   * @throws CircleVoronoiError `badOption`, if `bounds` is not a polygon or a box of four numbers, the box is empty, or
   *   a coordinate is not finite or exceeds `REGION_LIMIT`.
   */
  static of(bounds: Bounds): ConvexPolygon {
    if (bounds instanceof ConvexPolygon) return bounds
    const [minX, minY, maxX, maxY] = sidesOf(bounds).map(rounded) as [number, number, number, number]
    if (!(minX < maxX && minY < maxY && [minX, minY, maxX, maxY].every(isInRange))) {
      refuseOption(`The box is empty, or a coordinate is not finite, or beyond ${REGION_LIMIT_TEXT}.`)
    }
    const corners = [
      { x: minX, y: minY },
      { x: maxX, y: minY },
      { x: maxX, y: maxY },
      { x: minX, y: maxY },
    ]
    return new ConvexPolygon(corners, true)
  }

  /** Returns corner `k`, where side `k` begins. */
  corner(k: number): Point {
    return this.corners[k] as Point
  }

  /** Returns the corner where side `k` ends. */
  cornerAfter(k: number): Point {
    return this.corners[k + 1 === this.corners.length ? 0 : k + 1] as Point
  }

  /** Returns whether a point lies inside or on the boundary. */
  contains(p: Point): boolean {
    return this.corners.every((corner, k) => turn(between(corner, this.cornerAfter(k)), between(corner, p)) >= 0)
  }

  /** @internal Returns the largest coordinate difference between `p` and a point of the polygon. */
  reachFrom({ x, y }: Point): number {
    const { minX, minY, maxX, maxY } = this.box
    return Math.max(Math.abs(minX - x), Math.abs(maxX - x), Math.abs(minY - y), Math.abs(maxY - y))
  }

  /** Returns the area. */
  area(): number {
    const first = this.corner(0)
    const twice = (k: number) => cross(between(first, this.corner(k)), between(first, this.cornerAfter(k)))
    return this.corners.reduce((sum, _, k) => sum + twice(k), 0) / 2
  }

  /** Returns the mean of the corners, which lies inside. */
  middle(): Point {
    const { length } = this.corners
    return {
      x: this.corners.reduce((sum, { x }) => sum + x / length, 0),
      y: this.corners.reduce((sum, { y }) => sum + y / length, 0),
    }
  }
}

/** Whether a direction lies in the upper half-plane. It changes twice in each full turn, because no turn is half a turn. */
function isUpper({ y }: Vector): boolean {
  return y > 0
}

function isInRange(coordinate: number): boolean {
  return Math.abs(coordinate) <= REGION_LIMIT
}

/** The numbers of a box, in the order of its array. */
function sidesOf(bounds: Exclude<Bounds, ConvexPolygon>): readonly [number, number, number, number] {
  const { minX, minY, maxX, maxY }: Partial<Box> = Object(bounds)
  const sides: readonly unknown[] = Array.isArray(bounds) ? bounds : [minX, minY, maxX, maxY]
  if (sides.length !== 4 || !sides.every((side) => typeof side === 'number')) {
    refuseOption('Bounds are a ConvexPolygon, or a box of four numbers: { minX, minY, maxX, maxY } or an array.')
  }
  return sides as readonly [number, number, number, number]
}
