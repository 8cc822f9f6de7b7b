// SPDX-License-Identifier: GPL-3.0-or-later

import { between, length } from '../base/point.ts'
import type { Circle, Point, Vector } from '../base/types.ts'

/**
 * Returns the unit normal n, pointing to the right, of a common tangent of two circles. The tangent is directed from i
 * to j and has both circles on its left: n . c_i + r_i = n . c_j + r_j. Neither circle contains the other.
 */
export function tangentNormal(i: Circle, j: Circle): Vector {
  const v = between(i, j)
  const d = length(v)
  const difference = i.r - j.r
  const along = difference / d
  const across = Math.sqrt(Math.max((d - difference) * (d + difference), 0)) / d
  return { x: (v.x * along + v.y * across) / d, y: (v.y * along - v.x * across) / d }
}

/** Returns the point of a circle in the direction of a unit vector. */
export function pointOn({ x, y, r }: Circle, direction: Vector): Point {
  return { x: x + r * direction.x, y: y + r * direction.y }
}
