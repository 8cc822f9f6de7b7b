// SPDX-License-Identifier: GPL-3.0-or-later
import type { Bisector } from './bisector.ts'
import type { BoundedCurve } from './curve.ts'
import type { Outline } from './outline.ts'
import { between, cross, length, type Point } from './point.ts'

/** Exact up to rounding: polygons, and closed forms for what lies between an arc and its chord, by square roots alone. */
export function area(outline: Outline): number {
  return momentsOf(outline).area
}

/** The centre of mass, likewise. Of an outline without area it is that of its end points; (0, 0) if it is empty. */
export function centroid(outline: Outline): Point {
  const reference = referenceOf(outline)
  const { area, x, y } = momentsOf(outline)
  if (area > 0) return { x: reference.x + x / area, y: reference.y + y / area }
  const starts = outline.flat().map(({ curve }) => between(reference, curve.start))
  if (starts.length === 0) return reference
  return {
    x: reference.x + starts.reduce((sum, start) => sum + start.x, 0) / starts.length,
    y: reference.y + starts.reduce((sum, start) => sum + start.y, 0) / starts.length,
  }
}

/** The length of all pieces, to about 1e-12 of it. */
export function perimeter(outline: Outline): number {
  return outline.flat().reduce((sum, { curve }) => sum + arcLength(curve), 0)
}

/** The length of a bounded arc, by quadrature, to about 1e-12 of it. */
export function arcLength({ bisector, from, to, start, end }: BoundedCurve): number {
  if (bisector.a === 0) return length(between(start, end))
  if (to <= 1) return lengthBeyondApex(bisector, 1 / to, 1 / from)
  if (from >= 1) return lengthBeyondApex(bisector, from, to)
  return lengthBeyondApex(bisector, 1, 1 / from) + lengthBeyondApex(bisector, 1, to)
}

/** A region's area and the integrals of x and y over it, relative to a point. */
interface Moments {
  readonly area: number
  readonly x: number
  readonly y: number
}

/** The start of the first piece. */
function referenceOf(outline: Outline): Point {
  return outline[0]?.[0]?.curve.start ?? { x: 0, y: 0 }
}

/** Moments relative to the start of the first piece. */
function momentsOf(outline: Outline): Moments {
  const reference = referenceOf(outline)
  let [area, x, y] = [0, 0, 0]
  for (const { curve } of outline.flat()) {
    const u = between(reference, curve.start)
    const v = between(reference, curve.end)
    const triangle = cross(u, v) / 2
    const beyond = momentsOverChord(curve, reference)
    area += triangle + beyond.area
    x += (triangle * (u.x + v.x)) / 3 + beyond.x
    y += (triangle * (u.y + v.y)) / 3 + beyond.y
  }
  return { area, x, y }
}

/**
 * The region between a bounded arc and its chord, counted positive where the arc bends to the right of its chord.
 *
 * In the frame of the middle of the hyperbola and of conjugate half-diameters along the arc's middle parameter, the region
 * is sqrt(1 + y^2) <= x <= cosh h with |y| <= sinh h, h half the width of the arc in t. Its area is (sinh(2 h) - 2 h) / 2,
 * and the integral of x over it 2 / 3 sinh^3 h.
 */
function momentsOverChord({ bisector, from, to }: BoundedCurve, reference: Point): Moments {
  const { a: signed, b, origin, along, across, apex } = bisector
  const unitArea = signed !== 0 && to > from ? sinhExcess(Math.min(to / from, 1e300)) / 2 : 0
  if (unitArea === 0) return { area: 0, x: 0, y: 0 }
  const a = Math.abs(signed)
  const root = Math.sqrt(to) / Math.sqrt(from)
  const sine = (root - 1 / root) / 2
  const shift = (2 / 3) * ((sine / unitArea) * sine) * sine

  const middle = Math.sqrt(from) * Math.sqrt(to)
  const u = apex + a - (a * shift * (middle + 1 / middle)) / 2
  const v = (b * shift * (middle - 1 / middle)) / 2
  const x = origin.x - reference.x + (u * along.x + v * across.x)
  const y = origin.y - reference.y + (u * along.y + v * across.y)
  // The branch bends away from its smaller circle.
  const area = -signed * b * unitArea
  return { area, x: area * x, y: area * y }
}

/**
 * sinh(d) - d for d = ln(ratio) >= 0, with square roots alone: f(2 d) = 2 f(d) + 2 sinh(d) (cosh(d) - 1) has no
 * cancellation, and leads back to small d.
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

/** From parameter 1 <= from to `to`: a branch is alike on both sides of its apex. */
function lengthBeyondApex(bisector: Bisector, from: number, to: number): number {
  const depth = 60
  return to > from ? adaptive(bisector, from, to, gauss(bisector, from, to), depth) : 0
}

function adaptive(bisector: Bisector, from: number, to: number, whole: number, depth: number): number {
  const middle = (from + to) / 2
  const first = gauss(bisector, from, middle)
  const second = gauss(bisector, middle, to)
  if (depth === 0 || Math.abs(first + second - whole) <= 1e-13 * whole) return first + second
  return adaptive(bisector, from, middle, first, depth - 1) + adaptive(bisector, middle, to, second, depth - 1)
}

/** Abscissas and weights of the Gauss-Legendre rule of order 8 (Abramowitz and Stegun, table 25.4). */
const RULE = [
  [0.1834346424956498, 0.362683783378362],
  [0.525532409916329, 0.31370664587788727],
  [0.7966664774136267, 0.22238103445337448],
  [0.9602898564975363, 0.10122853629037626],
] as const

function gauss(bisector: Bisector, from: number, to: number): number {
  const middle = (from + to) / 2
  const half = (to - from) / 2
  return (
    half *
    RULE.reduce(
      (sum, [x, weight]) => sum + weight * (speed(bisector, middle - half * x) + speed(bisector, middle + half * x)),
      0,
    )
  )
}

/** The speed of the parameter: |d point / d s|. */
function speed({ a, b }: Bisector, s: number): number {
  const x = a * (1 - 1 / s) * (1 + 1 / s)
  const y = b * (1 + 1 / (s * s))
  return Math.sqrt(x * x + y * y) / 2
}
