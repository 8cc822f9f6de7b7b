// SPDX-License-Identifier: GPL-3.0-or-later

import { checkOutline } from '../base/check.ts'
import { at } from '../base/diagram-data.ts'
import { CircleVoronoiError } from '../base/errors.ts'
import { between, cross } from '../base/point.ts'
import { largestOf, lengthOf, measuredIn, unitFor } from '../base/scale.ts'
import type { DiagramData, Point, Vector } from '../base/types.ts'
import { type Bisector, pointOf } from '../curves/bisector.ts'
import { carlson } from '../curves/carlson.ts'
import type { BoundedCurve } from '../curves/curve.ts'
import {
  arcLength as circleArcLength,
  momentsOverChord as circleMoments,
  isCircleArc,
  type Moments,
} from './circle-arc.ts'
import type { ConvexPolygon } from './convex-polygon.ts'
import { CutPoint } from './cut-point.ts'
import type { Outline, OutlinePiece } from './outline-piece.ts'

/** A smaller area, as a share of the square around it, is only rounding. */
const ROUNDING_OF_AREA = 2 ** -44
/** The error bound of a vertex, as a share of the distances from its circles. */
const ROUNDING_OF_VERTICES = 2 ** -34
/** The error bound of a point on the border of the bounds, as a share of coordinates and of distances from circles. */
const ROUNDING_OF_BOUNDARY = 2 ** -44
/** The rounding error of coordinates, as a share of the largest coordinate. */
const ROUNDING_OF_COORDINATES = 2 ** -48

/**
 * Returns the area of an outline, exact up to rounding: polygons plus closed forms for the parts between arcs and their
 * chords, which need only square roots.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Cells
 * @example
 * outlineArea(diagram.cellOutline(0, { bounds: [-5, -5, 10, 10] })) // 72
 */
export function outlineArea(outline: Outline): number {
  checkOutline(outline, 'outlineArea')
  return areaOf(outline)
}

/** Does what `outlineArea` does, for arguments that have been checked. */
export function areaOf(outline: Outline): number {
  const unit = unitFor(extentOf(outline))
  // Not -0.
  return momentsOf(outline, unit).area * unit * unit + 0
}

/**
 * Returns the centroid of an outline, exact up to rounding. For an outline without area it is the centroid of its end
 * points; for an empty outline, (0, 0).
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Cells
 * @example
 * outlineCentroid(diagram.cellOutline(0, { bounds: [-5, -5, 10, 10] })) // { x: -1, y: -0.5 }
 */
export function outlineCentroid(outline: Outline): Point {
  checkOutline(outline, 'outlineCentroid')
  return centroidOf(outline)
}

/** Does what `outlineCentroid` does, for arguments that have been checked. */
export function centroidOf(outline: Outline): Point {
  const reference = referenceOf(outline)
  const extent = extentOf(outline)
  const unit = unitFor(extent)
  const { area, x, y } = momentsOf(outline, unit)
  if (extent > 0 && area > ROUNDING_OF_AREA * (extent / unit) * (extent / unit)) {
    return { x: reference.x + unit * (x / area), y: reference.y + unit * (y / area) }
  }
  const starts = outline.flat().map(({ curve }) => between(reference, curve.start))
  if (starts.length === 0) return reference
  return {
    x: reference.x + starts.reduce((sum, start) => sum + start.x, 0) / starts.length,
    y: reference.y + starts.reduce((sum, start) => sum + start.y, 0) / starts.length,
  }
}

/**
 * Returns the total length of an outline, exact up to rounding (see `curveLength`).
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Cells
 * @example
 * outlinePerimeter(diagram.cellOutline(0, { bounds: [-5, -5, 10, 10] })) // 34
 */
export function outlinePerimeter(outline: Outline): number {
  checkOutline(outline, 'outlinePerimeter')
  return perimeterOf(outline)
}

/** Does what `outlinePerimeter` does, for arguments that have been checked. */
export function perimeterOf(outline: Outline): number {
  return outline.flat().reduce((sum, piece) => sum + lengthOfPiece(piece), 0)
}

/** Returns a bound on the error of the coordinates of a vertex. */
export function errorOfVertex({ circles, vertexCircles, vertices }: DiagramData, vertex: number): number {
  const x = at(vertices, 3 * vertex)
  const y = at(vertices, 3 * vertex + 1)
  let size = 0
  for (let k = 3 * vertex; k < 3 * vertex + 3; k++) {
    const circle = 3 * at(vertexCircles, k)
    size += Math.abs(at(circles, circle) - x) + Math.abs(at(circles, circle + 1) - y)
  }
  return ROUNDING_OF_VERTICES * size + ROUNDING_OF_COORDINATES * (Math.abs(x) + Math.abs(y))
}

/** Judges the areas of cells inside bounds. */
export class AreaJudge {
  readonly #whole: number
  readonly #bounds: ConvexPolygon
  readonly #perimeter: number
  /** The largest coordinate of the bounds or distance between a circle and the bounds. */
  #reach: number
  #sum = 0

  constructor(bounds: ConvexPolygon) {
    const { corners } = bounds
    this.#whole = bounds.area()
    this.#bounds = bounds
    this.#perimeter = corners.reduce(
      (sum, corner, k) => sum + lengthOf(between(corner, corners[(k + 1) % corners.length] as Point)),
      0,
    )
    this.#reach = Math.max(...corners.map(largestOf))
  }

  /**
   * Adds the area of a cell, whose circle has the center `center`. The area must be between 0 and the area of the
   * bounds.
   *
   * @throws CircleVoronoiError `notCertified`
   */
  add(area: number, center: Point, circle: number): void {
    if (area !== 0) this.#reach = Math.max(this.#reach, this.#bounds.reachFrom(center))
    this.#sum += area
    const rounding = ROUNDING_OF_VERTICES * this.#perimeter * this.#reach
    if (area >= -rounding && area <= this.#whole + rounding) return
    const message = `The area of cell ${circle}, ${area}, is not between 0 and that of the bounds, ${this.#whole}. Certify the diagram.`
    throw new CircleVoronoiError('notCertified', message, { circle })
  }

  /**
   * Checks that the areas of all cells sum to the area of the bounds. Errors of vertices do not matter here, because
   * both cells of an edge have the same end points.
   *
   * @throws CircleVoronoiError `notCertified`
   */
  checkSum(): void {
    if (Math.abs(this.#sum - this.#whole) <= ROUNDING_OF_BOUNDARY * this.#perimeter * this.#reach) return
    const message = `The areas of the cells sum to ${this.#sum}, not to that of the bounds, ${this.#whole}. Certify the diagram.`
    throw new CircleVoronoiError('notCertified', message)
  }
}

export function lengthOfPiece(piece: OutlinePiece): number {
  return isCircleArc(piece) ? circleArcLength(piece) : curveLength(piece.curve)
}

/**
 * Returns the length of a bounded arc, up to rounding of its ends. It is an elliptic integral, computed by Carlson's
 * duplication with a few dozen square roots.
 */
export function curveLength({ bisector, from, to, start, end }: BoundedCurve): number {
  const { a, b } = bisector
  const chord = lengthOf(between(start, end))
  if (a === 0 || !(to > from)) return chord
  let length = 0
  if (to <= 1) length = lengthBeyondApex(bisector, 1 / to, 1 / from)
  else if (from >= 1) length = lengthBeyondApex(bisector, from, to)
  else length = lengthBeyondApex(bisector, 1, 1 / from) + lengthBeyondApex(bisector, 1, to)
  // The chord from point(from) to point(to), which equal the ends up to rounding.
  const middle = Math.sqrt(from) * Math.sqrt(to)
  const span = (to - from) / middle
  const straight = span * lengthOf({ x: (a * (middle - 1 / middle)) / 2, y: (b * (middle + 1 / middle)) / 2 })
  return chord + Math.max(length - straight, 0)
}

/** Returns the start of the first piece, the reference point of moments. */
function referenceOf(outline: Outline): Point {
  return outline[0]?.[0]?.curve.start ?? { x: 0, y: 0 }
}

function middleOf({ bisector, from, to }: BoundedCurve): Point {
  return pointOf(bisector, Math.sqrt(from) * Math.sqrt(to))
}

/**
 * Returns approximately the largest distance between two points of an outline. The middle of a curved piece may be much
 * farther away than its ends.
 */
function extentOf(outline: Outline): number {
  const reference = referenceOf(outline)
  let most = 0
  const take = ({ x, y }: Point) => {
    most = Math.max(most, Math.abs(x - reference.x), Math.abs(y - reference.y))
  }
  for (const loop of outline) {
    for (const { curve } of loop) {
      take(curve.start)
      if (curve.bisector.a !== 0) take(middleOf(curve))
    }
  }
  return most
}

const NO_MOMENTS: Moments = { area: 0, x: 0, y: 0 }

function momentsOf(outline: Outline, unit: number): Moments {
  const reference = referenceOf(outline)
  const seen = (p: Point) => measuredIn(unit, CutPoint.seenFrom(reference, p))
  let [area, x, y] = [0, 0, 0]
  const add = (u: Vector, v: Vector, beyond: Moments) => {
    const triangle = cross(u, v) / 2
    area += triangle + beyond.area
    x += (triangle * (u.x + v.x)) / 3 + beyond.x
    y += (triangle * (u.y + v.y)) / 3 + beyond.y
  }
  for (const loop of outline) {
    const end = loop.at(-1)?.curve.end
    let last = end && seen(end)
    for (const piece of loop) {
      const { curve } = piece
      const u = seen(curve.start)
      const v = seen(curve.end)
      // Points whose coordinates are equal may be apart by less than rounding.
      if (last !== undefined && (last.x !== u.x || last.y !== u.y)) add(last, u, NO_MOMENTS)
      add(u, v, isCircleArc(piece) ? circleMoments(u, v, piece.r / unit) : momentsOverChord(curve, reference, unit))
      last = v
    }
  }
  return { area, x, y }
}

/**
 * Returns the moments of the region between a bounded arc and its chord, positive if the arc bends to the right of its
 * chord.
 *
 * In the frame of the middle of the hyperbola and of conjugate half-diameters along the arc's middle parameter, the
 * region is sqrt(1 + y^2) <= x <= cosh h with |y| <= sinh h, h half the width of the arc in t. Its area is (sinh(2 h) -
 * 2 h) / 2, and the integral of x over it 2 / 3 sinh^3 h. Both are divided by e^(2 h), which may overflow.
 */
function momentsOverChord({ bisector, from, to }: BoundedCurve, reference: Point, unit: number): Moments {
  const { a: signed, b, origin, along, across, apex } = bisector
  const share = signed !== 0 && to > from ? sinhExcessShare(to / from) / 2 : 0
  if (share === 0) return { area: 0, x: 0, y: 0 }
  const root = Math.sqrt(to) / Math.sqrt(from)
  const sine = (to - from) / to / 2
  const shift = (2 / 3) * ((sine / share) * sine) * sine * root

  const scale = 1 / unit
  const a = Math.abs(signed) * scale
  const middle = Math.sqrt(from) * Math.sqrt(to)
  const u = apex * scale + a - (a * shift * (middle + 1 / middle)) / 2
  const v = (b * scale * shift * (middle - 1 / middle)) / 2
  const toOrigin = measuredIn(unit, between(reference, origin))
  const x = toOrigin.x + (u * along.x + v * across.x)
  const y = toOrigin.y + (u * along.y + v * across.y)
  // The branch bends away from its smaller circle.
  const area = -Math.sign(signed) * a * root * (b * scale * root) * share
  return { area, x: area * x, y: area * y }
}

/**
 * Returns f(d) = sinh(d) - d for d = ln(ratio) >= 0, with square roots only. The recursion f(2 d) = 2 f(d) + 2 sinh(d)
 * (cosh(d) - 1) leads to small d without cancellation.
 */
function sinhExcess(ratio: number): number {
  if (ratio < 1.25) {
    const z = (ratio - 1) / (ratio + 1)
    let d = 0
    for (let k = 15; k > 0; k -= 2) d = d * z * z + 2 / k
    d *= z
    let sum = 0
    for (let k = 13; k > 1; k -= 2) sum = ((1 + sum) * d * d) / (k * (k - 1))
    return d * sum
  }
  const root = Math.sqrt(ratio)
  const sine = (root - 1 / root) / 2
  const cosineExcess = ((root - 1) * (root - 1)) / (2 * root)
  return 2 * sinhExcess(root) + 2 * sine * cosineExcess
}

/** Returns `sinhExcess` divided by the ratio, which may overflow. */
function sinhExcessShare(ratio: number): number {
  return ratio < 1e300 ? sinhExcess(ratio) / ratio : 0.5
}

/**
 * Returns the length from parameter `from` >= 1 to `to`. A branch is symmetric about its apex.
 *
 * With Y = sinh t and m = 1 + (a / b)^2, the length is b times the integral of sqrt((1 + m Y^2) / (1 + Y^2)) over Y.
 * With y = Y^2, this is half the integral of (1 + m y) / sqrt(y (1 + y) (1 + m y)), which is between any limits
 *
 *     R_F(U12^2, U13^2, U14^2) + m (R_D(U12^2, U13^2, U14^2) / 3 + Y_from Y_to / U14)
 *
 * with the U of DLMF 19.29.5, a sum of positive terms. To avoid overflow, all sines and cosines are divided by e^t, and
 * the U by e^t of `from`.
 */
function lengthBeyondApex({ a, b }: Bisector, from: number, to: number): number {
  if (!(to > from)) return 0
  const m = 1 + (a / b) * (a / b)
  const endAt = (s: number) => {
    const sine = (((s - 1) / s) * (1 + 1 / s)) / 2
    return { sine, cosine: (1 + 1 / s / s) / 2, speed: Math.sqrt(1 / s / s + m * sine * sine) }
  }
  const p = endAt(from)
  const q = endAt(to)
  const share = from / to
  // (Y_to^2 - Y_from^2) / to^2
  const step = (((to - from) / to) * (1 + share) * ((from - 1) / from + (to - 1) / to / from) * (1 + 1 / from / to)) / 4
  const u12 = (q.sine * q.cosine * p.speed + share * p.sine * p.cosine * q.speed) / step
  const u13 = (q.sine * q.speed * p.cosine + share * p.sine * p.speed * q.cosine) / step
  const u14 = (share * q.sine * p.cosine * p.speed + p.sine * q.cosine * q.speed) / step
  const [first, second] = carlson(u12, u13, u14)
  return b * (first / from + m * (second / 3 / from / from / from + ((p.sine * q.sine) / u14) * to))
}
