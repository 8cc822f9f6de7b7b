// SPDX-License-Identifier: GPL-3.0-or-later

import { refuseInput } from '../base/check.ts'
import { cross, dot } from '../base/point.ts'
import type { Float64s, Point } from '../base/types.ts'

/**
 * The two periods of a plane that repeats itself: the sides of a box whose opposite sides are glued together, each as x
 * and y. The box can be any parallelogram.
 *
 * @category Periodic diagrams
 */
export interface Lattice {
  readonly a: readonly [x: number, y: number]
  readonly b: readonly [x: number, y: number]
}

/**
 * The multiples of both periods in a translation.
 *
 * @category Periodic diagrams
 */
export type Shift = readonly [a: number, b: number]

/**
 * Returns the numbers of a lattice. Types are checked here, because embind would convert any value; the core judges the
 * values.
 *
 * @throws CircleVoronoiError `badInput`
 */
export function latticeNumbers(lattice: Lattice, caller: string): Float64s {
  const { a, b }: Partial<Record<keyof Lattice, unknown>> = Object(lattice)
  const isPeriod = (period: unknown): period is Lattice['a'] =>
    (Array.isArray(period) || period instanceof Float64Array) &&
    period.length === 2 &&
    period.every((value: unknown) => typeof value === 'number')
  if (!isPeriod(a) || !isPeriod(b))
    refuseInput(`${caller} takes a lattice as { a: [ax, ay], b: [bx, by] }, all numbers.`)
  return Float64Array.of(...a, ...b)
}

/** The shortest periods of a lattice. */
export interface Periods {
  /** A shortest vector of the lattice, and a shortest one that is not parallel to it. */
  readonly vectors: readonly [Point, Point]
  /** Returns a lattice vector that is nearest or almost nearest to (x, y), and its shift. */
  nearest(x: number, y: number): { readonly steps: Point; readonly shift: Shift }
}

/** Reduces a lattice (Lagrange, Gauss) like `reduce` in cpp/src/diagram/reduced_lattice.h. */
export function shortestPeriods({ a, b }: Lattice): Periods {
  // All lengths are divided by the largest coordinate, so that no square vanishes.
  const unit = Math.max(...[...a, ...b].map(Math.abs))
  const period = ([x, y]: readonly [number, number], shift: Shift) => ({ x, y, u: { x: x / unit, y: y / unit }, shift })
  let shorter = period(a, [1, 0])
  let longer = period(b, [0, 1])
  for (;;) {
    if (dot(longer.u, longer.u) < dot(shorter.u, shorter.u)) [shorter, longer] = [longer, shorter]
    const square = dot(shorter.u, shorter.u)
    const ratio = dot(shorter.u, longer.u) / square
    const times = Math.floor(Math.abs(ratio) + 0.5) * Math.sign(ratio)
    const [k, l] = longer.shift
    const next = period(
      [longer.x - times * shorter.x, longer.y - times * shorter.y],
      [k - times * shorter.shift[0], l - times * shorter.shift[1]],
    )
    if (!(dot(next.u, next.u) < dot(longer.u, longer.u))) break
    longer = next
  }
  const area = cross(shorter.u, longer.u)
  return {
    vectors: [
      { x: shorter.x, y: shorter.y },
      { x: longer.x, y: longer.y },
    ],
    nearest(x, y) {
      const p = { x: x / unit, y: y / unit }
      const i = Math.floor(cross(p, longer.u) / area + 0.5)
      const j = Math.floor(cross(shorter.u, p) / area + 0.5)
      const sum = (of: (one: typeof shorter) => number) => i * of(shorter) + j * of(longer)
      return {
        steps: { x: sum((one) => one.x), y: sum((one) => one.y) },
        shift: [sum((one) => one.shift[0]), sum((one) => one.shift[1])],
      }
    },
  }
}
