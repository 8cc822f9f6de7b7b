// SPDX-License-Identifier: GPL-3.0-or-later
// Geometry of moving, scaling and snapping circles, and of choosing the next one in a direction.
import type { Circle, Point } from '../lib/index.ts'

/** A circle with its id. */
export interface IdentifiedCircle {
  readonly id: number
  readonly circle: Circle
}

/** Adds without digits that neither summand has: 0.1 + 0.2 is 0.3. */
export function stepped(value: number, step: number): number {
  if (step === 0) return value
  const digits = Math.max(digitsOf(value), digitsOf(step))
  return digits > 15 ? value + step : Number((value + step).toFixed(digits))
}

/** The number of digits after the decimal point in the shortest text of a number. */
function digitsOf(value: number): number {
  const [mantissa, exponent = '0'] = String(value).split('e') as [string, string?]
  return Math.max((mantissa.split('.')[1] ?? '').length - Number(exponent), 0)
}

/** Scales a circle's center and radius by a factor about a point. */
export function scaled({ x, y, r }: Circle, about: Point, factor: number): Circle {
  return { x: about.x + (x - about.x) * factor, y: about.y + (y - about.y) * factor, r: r * factor }
}

/** The center of the bounding box of circles. */
export function middleOf(circles: readonly Circle[]): Point {
  const middle = (low: (circle: Circle) => number, high: (circle: Circle) => number) =>
    (circles.reduce((least, circle) => Math.min(least, low(circle)), Number.POSITIVE_INFINITY) +
      circles.reduce((most, circle) => Math.max(most, high(circle)), Number.NEGATIVE_INFINITY)) /
    2
  return {
    x: middle(
      ({ x, r }) => x - r,
      ({ x, r }) => x + r,
    ),
    y: middle(
      ({ y, r }) => y - r,
      ({ y, r }) => y + r,
    ),
  }
}

/** The next point in a direction of length 1: within 45 degrees of the direction if possible, else on its side. */
export function nextInDirection<Other extends Point>(
  from: Point,
  others: readonly Other[],
  [dx, dy]: readonly [number, number],
): Other | undefined {
  let next: Other | undefined
  let nextIsAhead = false
  let least = Number.POSITIVE_INFINITY
  for (const other of others) {
    const along = (other.x - from.x) * dx + (other.y - from.y) * dy
    const across = Math.abs((other.x - from.x) * dy - (other.y - from.y) * dx)
    if (!(along > 0)) continue
    const isAhead = across <= along
    const length = Math.hypot(along, across)
    // Grows with the angle to the direction, without bound toward a right angle.
    const rank = length * (length / along)
    const isBetter = isAhead === nextIsAhead ? rank < least : isAhead
    if (next !== undefined && !isBetter) continue
    next = other
    nextIsAhead = isAhead
    least = rank
  }
  return next
}

/** The candidates for snapping and the distance at which it acts. */
export interface Snapping {
  readonly others: readonly Circle[]
  /** The spacing of a grid through the origin. */
  readonly grid: number
  readonly within: number
}

/** Moves a circle to touch one or two other circles, if any are near enough; else to the grid. */
export function snappedInPlace(circle: Circle, { others, grid, within }: Snapping): Circle {
  const { r } = circle
  const gapTo = (other: Circle) => Math.abs(Math.hypot(circle.x - other.x, circle.y - other.y) - r - other.r)
  const [nearest, second] = others.filter((other) => gapTo(other) <= within).sort((a, b) => gapTo(a) - gapTo(b))
  if (nearest === undefined) return { x: onGrid(circle.x, grid, within), y: onGrid(circle.y, grid, within), r }
  const both = second === undefined ? undefined : touchingBoth(circle, nearest, second)
  if (both !== undefined && Math.hypot(both.x - circle.x, both.y - circle.y) <= 2 * within) return { ...both, r }
  const distance = Math.hypot(circle.x - nearest.x, circle.y - nearest.y)
  if (distance === 0) return circle
  const factor = (r + nearest.r) / distance
  return { x: nearest.x + (circle.x - nearest.x) * factor, y: nearest.y + (circle.y - nearest.y) * factor, r }
}

/** Changes a radius so that the circle touches another one, if any is near enough; else to a multiple of the grid. */
export function snappedInSize({ x, y, r }: Circle, { others, grid, within }: Snapping): Circle {
  const fitting = others
    .map((other) => Math.hypot(x - other.x, y - other.y) - other.r)
    .filter((radius) => radius >= 0 && Math.abs(radius - r) <= within)
    .sort((a, b) => Math.abs(a - r) - Math.abs(b - r))
  return { x, y, r: fitting[0] ?? Math.max(onGrid(r, grid, within), 0) }
}

/** The nearest position at which a circle touches two others from outside. NaN if there is none. */
function touchingBoth({ x, y, r }: Circle, one: Circle, other: Circle): Point {
  const [a, b] = [r + one.r, r + other.r]
  const [dx, dy] = [other.x - one.x, other.y - one.y]
  const d = Math.hypot(dx, dy)
  const along = (a * a - b * b + d * d) / (2 * d)
  const height = Math.sqrt(a * a - along * along)
  const side = dx * (y - one.y) - dy * (x - one.x) >= 0 ? 1 : -1
  return {
    x: one.x + (dx * along - side * dy * height) / d,
    y: one.y + (dy * along + side * dx * height) / d,
  }
}

function onGrid(value: number, grid: number, within: number): number {
  const line = Number((Math.round(value / grid) * grid).toPrecision(15))
  return Math.abs(line - value) <= within ? line : value
}
