// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point, Vector } from './types.ts'

export function cross(u: Vector, v: Vector): number {
  return u.x * v.y - u.y * v.x
}

export function dot(u: Vector, v: Vector): number {
  return u.x * v.x + u.y * v.y
}

export function length(v: Vector): number {
  return Math.sqrt(dot(v, v))
}

/** Returns the vector from one point to another. */
export function between(from: Point, to: Point): Vector {
  return { x: to.x - from.x, y: to.y - from.y }
}
