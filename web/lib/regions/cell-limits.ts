// SPDX-License-Identifier: GPL-3.0-or-later

import { at } from '../base/diagram-data.ts'
import { square, sum } from '../base/two-part.ts'
import type { DiagramData } from '../base/types.ts'
import type { ConvexPolygon } from './convex-polygon.ts'

/** The limits of cells and edges: bounds and, optionally, a maximum distance from the nearest circle. */
export interface Limits {
  readonly bounds: ConvexPolygon
  readonly maxDistance: number | undefined
}

/** Generous bounds on the errors of vertices, as a share of their distance, and on rounding of coordinates. */
const ERROR_OF_VERTICES = 2 ** -30
const ROUNDING = 2 ** -45

/**
 * Returns the radius of the disc around a circle's center that the maximum distance keeps. It may be negative. For the
 * metric `power` it is the root of the weight plus the signed square of the distance, or 0 if that is negative.
 */
export function reachFrom({ circles, metric, weights }: DiagramData, circle: number, maxDistance: number): number {
  const r = at(circles, 3 * circle + 2)
  if (metric !== 'power') return (metric === 'circles' ? r : 0) + maxDistance
  const weight = weights ? { value: r, rest: 0 } : square(r)
  const own = square(maxDistance)
  const sign = maxDistance < 0 ? -1 : 1
  const { value, rest } = sum(weight.value, sign * own.value)
  return Math.sqrt(Math.max(value + (rest + (weight.rest + sign * own.rest)), 0))
}

/** Returns an upper bound of the distance to points of a cell, and of all errors. */
function farthest({ circles }: DiagramData, circle: number, reach: number, { bounds }: Limits): number {
  const x = at(circles, 3 * circle)
  const y = at(circles, 3 * circle + 1)
  return reach + ERROR_OF_VERTICES * reach + ROUNDING * (Math.abs(x) + Math.abs(y) + bounds.reachFrom({ x, y }))
}

/**
 * Whether the limits certainly keep a whole cell, because they keep all points up to `reach` from its circle's center.
 */
export function isKeptWhole(diagram: DiagramData, circle: number, reach: number, limits: Limits): boolean {
  const { bounds, maxDistance } = limits
  const most = farthest(diagram, circle, reach, limits)
  if (maxDistance !== undefined && !(most < reachFrom(diagram, circle, maxDistance))) return false
  const x = at(diagram.circles, 3 * circle)
  const y = at(diagram.circles, 3 * circle + 1)
  const { minX, minY, maxX, maxY } = bounds.box
  if (!(minX < x - most && x + most < maxX && minY < y - most && y + most < maxY)) return false
  if (bounds.isBox) return true
  return [-most, most].every((dx) => [-most, most].every((dy) => bounds.contains({ x: x + dx, y: y + dy })))
}

/** Whether a cell is certainly outside the bounds, because all its points are up to `reach` from its circle's center. */
export function isOutside(diagram: DiagramData, circle: number, reach: number, limits: Limits): boolean {
  const x = at(diagram.circles, 3 * circle)
  const y = at(diagram.circles, 3 * circle + 1)
  const { minX, minY, maxX, maxY } = limits.bounds.box
  const most = farthest(diagram, circle, reach, limits)
  return x + most < minX || x - most > maxX || y + most < minY || y - most > maxY
}
