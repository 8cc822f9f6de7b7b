// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from './errors.ts'
import { between, cross, type Point, type Vector } from './point.ts'
import { facing, largestOf, turn } from './scale.ts'

/** An axis-parallel rectangle, minX < maxX and minY < maxY. */
export interface Box {
  readonly minX: number
  readonly minY: number
  readonly maxX: number
  readonly maxY: number
}

/** The largest coordinate of a region, in absolute value: a hundred times that of a circle, and areas are numbers. */
export const REGION_LIMIT = 1e152

/** What curves and cells are clipped to. */
export type Bounds = Box | ConvexPolygon

/** The closed region that curves and cells are clipped to. */
export class ConvexPolygon {
  /** Counter-clockwise. */
  readonly corners: readonly Point[]
  /** The smallest box around it. */
  readonly box: Box

  private constructor(corners: readonly Point[]) {
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
   * From corners in counter-clockwise order; corners on the line through their neighbours are allowed.
   *
   * @throws CircleVoronoiError `badOption`, if there are fewer than three corners, a coordinate is not finite or exceeds
   * `REGION_LIMIT`, two corners in a row are equal, or they do not turn left exactly once.
   */
  static from(corners: readonly Point[]): ConvexPolygon {
    if (corners.length < 3) refuse('A convex polygon needs three corners or more.')
    if (!corners.every(({ x, y }) => isInRange(x) && isInRange(y))) {
      refuse('A corner of the polygon is not finite, or beyond 1e152.')
    }
    const polygon = new ConvexPolygon(corners.map(({ x, y }) => ({ x, y })))
    const sides = polygon.corners.map((corner, k) => between(corner, polygon.cornerAfter(k)))
    let halfTurns = 0
    sides.forEach((out, k) => {
      const before = sides.at(k - 1) as Vector
      if (out.x === 0 && out.y === 0) refuse('Two corners of the polygon in a row are equal.')
      const side = turn(before, out)
      if (side < 0 || (side === 0 && facing(before, out) < 0)) {
        refuse('The polygon is not convex, or its corners are not counter-clockwise.')
      }
      if (isUpper(before) !== isUpper(out)) halfTurns += 1
    })
    if (halfTurns !== 2) refuse('The polygon winds more than once, or has no area.')
    return polygon
  }

  /**
   * The polygon of some bounds.
   *
   * @throws CircleVoronoiError `badOption`, if they are a box that is empty, or a coordinate is not finite or exceeds
   * `REGION_LIMIT`.
   */
  static of(bounds: Bounds): ConvexPolygon {
    if (bounds instanceof ConvexPolygon) return bounds
    const { minX, minY, maxX, maxY } = bounds
    if (!(minX < maxX && minY < maxY && [minX, minY, maxX, maxY].every(isInRange))) {
      refuse('The box is empty, or a coordinate is not finite, or beyond 1e152.')
    }
    return new ConvexPolygon([
      { x: minX, y: minY },
      { x: maxX, y: minY },
      { x: maxX, y: maxY },
      { x: minX, y: maxY },
    ])
  }

  /** Corner `k`, where side `k` begins. */
  corner(k: number): Point {
    return this.corners[k] as Point
  }

  /** The corner at which side `k` ends. */
  cornerAfter(k: number): Point {
    return this.corners[k + 1 === this.corners.length ? 0 : k + 1] as Point
  }

  /** Whether a point is inside or on the boundary. */
  contains(p: Point): boolean {
    return this.corners.every((corner, k) => turn(between(corner, this.cornerAfter(k)), between(corner, p)) >= 0)
  }

  /** How far what is inside may be from a point, along one axis. */
  reachFrom(p: Point): number {
    let reach = 0
    for (const corner of this.corners) reach = Math.max(reach, largestOf(between(p, corner)))
    return reach
  }

  /** The area. */
  area(): number {
    const first = this.corner(0)
    const twice = (k: number) => cross(between(first, this.corner(k)), between(first, this.cornerAfter(k)))
    return this.corners.reduce((sum, _, k) => sum + twice(k), 0) / 2
  }

  /** The mean of the corners, which lies inside. */
  middle(): Point {
    const { length } = this.corners
    return {
      x: this.corners.reduce((sum, { x }) => sum + x / length, 0),
      y: this.corners.reduce((sum, { y }) => sum + y / length, 0),
    }
  }
}

/** Whether a direction lies in the half-open upper half-plane; it changes twice in each full turn. */
function isUpper({ x, y }: Vector): boolean {
  return y > 0 || (y === 0 && x > 0)
}

function isInRange(coordinate: number): boolean {
  return Math.abs(coordinate) <= REGION_LIMIT
}

function refuse(message: string): never {
  throw new CircleVoronoiError('badOption', -1, message)
}
