// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of circles in outlines. They are counter-clockwise and at most a quarter turn, so the ends and the radius
// determine the center, which is to the left of the chord.

/** The area of a region and the integrals of x and y over it. Lengths are relative to a point and in some unit. */
export interface Moments {
  readonly area: number
  readonly x: number
  readonly y: number
}

import { between, length } from '../base/point.ts'
import { lengthOf } from '../base/scale.ts'
import type { PathSink, Point, Vector } from '../base/types.ts'
import { carlson } from '../curves/carlson.ts'
import type { OutlinePiece } from './outline-piece.ts'

/** The smallest tolerance of a polyline, as a share of the radius. */
const FINEST_POLYLINE = 1e-9
/** The number of halvings after which an arc of half a turn reaches the smallest tolerance. */
const MOST_HALVINGS = 16

/** Whether a piece of an outline is an arc of a circle, whose `curve` is the chord. */
export function isCircleArc({ r }: OutlinePiece): boolean {
  return r > 0
}

export function arcLength({ curve: { start, end }, r }: OutlinePiece): number {
  const { sine, first } = halfAngleOf(start, end, r)
  return 2 * r * sine * first
}

/**
 * Returns the moments of the region between an arc and its chord. From the circle's center, the centroid is 2 / 3 sin^3
 * h / (h - sin h cos h) radii away, and the chord cos h radii.
 */
export function momentsOverChord(start: Vector, end: Vector, r: number): Moments {
  const chord = between(start, end)
  const size = length(chord)
  if (size === 0) return { area: 0, x: 0, y: 0 }
  const { sine, cosine, second } = halfAngleOf(start, end, r)
  const area = sine * (size / 2) * (size / 2) * (2 / 3) * second
  const beyond = r * (1 / second - cosine)
  return {
    area,
    x: area * (start.x + chord.x / 2 + (beyond * chord.y) / size),
    y: area * (start.y + chord.y / 2 - (beyond * chord.x) / size),
  }
}

/** Returns a polyline within a tolerance of an arc. Its points, at least two, divide the arc evenly. */
export function polyline({ curve, r }: OutlinePiece, tolerance: number): Point[] {
  const least = Math.max(tolerance, FINEST_POLYLINE * r)
  let points: Point[] = [curve.start, curve.end]
  // All parts have the same sagitta. Halving the parts divides the sagitta by about four.
  const isCoarse = () => {
    const { sine, cosine } = halfAngleOf(points[0] as Point, points[1] as Point, r)
    return r * sine * (sine / (1 + cosine)) > least
  }
  for (let round = 0; round < MOST_HALVINGS && isCoarse(); round++) {
    const middle = middleOf(points[0] as Point, points[1] as Point, r)
    // No number lies between adjacent floating-point numbers.
    if (points.slice(0, 2).some(({ x, y }) => x === middle.x && y === middle.y)) break
    points = points.flatMap((point, k) => (k === 0 ? [point] : [middleOf(points[k - 1] as Point, point, r), point]))
  }
  return points
}

/** Draws an arc. The path must already be at its start. */
export function traceCircleArc(sink: PathSink, { curve: { start, end }, r }: OutlinePiece): void {
  const chord = between(start, end)
  const size = lengthOf(chord)
  const { sine, cosine } = halfAngleOf(start, end, r)
  const toCenter = (r * cosine) / size
  const x = start.x + chord.x / 2 - toCenter * chord.y
  const y = start.y + chord.y / 2 + toCenter * chord.x
  const from = Math.atan2(start.y - y, start.x - x)
  sink.arc(x, y, r, from, from + 2 * Math.asin(sine))
}

/**
 * Returns sin h and cos h for half the angle h of an arc, and R_F and R_D of (cos^2 h, 1, 1). The identities are h =
 * sin h R_F and h - sin h cos h = 2 / 3 sin^3 h R_D (DLMF 19.25).
 */
function halfAngleOf(start: Point, end: Point, r: number) {
  const sine = Math.min(lengthOf(between(start, end)) / r / 2, 1)
  const cosine = Math.sqrt((1 - sine) * (1 + sine))
  const [first, second] = carlson(cosine, 1, 1)
  return { sine, cosine, first, second }
}

/**
 * Returns the point in the middle of an arc. It is 1 - cos h = sin h tan (h / 2) radii beyond the middle of the chord.
 */
function middleOf(start: Point, end: Point, r: number): Point {
  const chord = between(start, end)
  const { sine, cosine } = halfAngleOf(start, end, r)
  const rise = sine / (1 + cosine) / 2
  return { x: start.x + chord.x / 2 + rise * chord.y, y: start.y + chord.y / 2 - rise * chord.x }
}
