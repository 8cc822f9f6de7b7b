// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a convex polygon into a cell, so that the module for regions can clip it.
import { between, cross } from '../base/point.ts'
import { largestOf, lengthOf } from '../base/scale.ts'
import type { Float64s, Point } from '../base/types.ts'

/** A cell thinner than this fraction of its length counts as having no area. */
const LEAST_WIDTH = 1e-9

/**
 * Returns points, as circles of radius 0, such that the cell of the first point is a convex polygon. They are a point
 * inside and its mirror images in the sides. `corners` run counter-clockwise. Returns `undefined` for a polygon without
 * an area.
 */
export function circlesOfConvexCell(corners: readonly Point[]): Float64s | undefined {
  const count = corners.length
  const origin = corners[0]
  if (origin === undefined) return undefined
  const inside = { x: origin.x, y: origin.y }
  let size = 0
  for (const corner of corners) {
    const offset = between(origin, corner)
    inside.x += offset.x / count
    inside.y += offset.y / count
    size = Math.max(size, largestOf(offset))
  }
  const circles = [inside.x, inside.y, 0]
  for (let k = 0; k < count; k++) {
    const corner = corners[k] as Point
    const along = between(corner, corners[(k + 1) % count] as Point)
    const length = lengthOf(along)
    if (length === 0) continue
    const unit = { x: along.x / length, y: along.y / length }
    const height = cross(unit, between(corner, inside))
    if (!(height > LEAST_WIDTH * size)) return undefined
    circles.push(inside.x + 2 * height * unit.y, inside.y - 2 * height * unit.x, 0)
  }
  return circles.length > 9 ? Float64Array.from(circles) : undefined
}
