// SPDX-License-Identifier: GPL-3.0-or-later

import { at } from '../base/diagram-data.ts'
import type { DiagramData } from '../base/types.ts'
import { curveOf } from '../curves/curve.ts'
import { boundedPart, type Part, partNear, partsInside } from './clip.ts'
import type { ConvexPolygon } from './convex-polygon.ts'

/** The limits of cells and edges: bounds and, optionally, a maximum distance from the nearest circle. */
export interface Limits {
  readonly bounds: ConvexPolygon
  readonly maxDistance: number | undefined
}

/** Returns the radius of the disc around a circle's center that the maximum distance keeps. It may be negative. */
export function reachFrom({ circles, metric }: DiagramData, circle: number, maxDistance: number): number {
  return (metric === 'circles' ? at(circles, 3 * circle + 2) : 0) + maxDistance
}

/** Whether the limits keep a whole cell, because they keep all points up to `reach` from its circle's center. */
export function isKeptWhole(diagram: DiagramData, circle: number, reach: number, limits: Limits): boolean {
  const { bounds, maxDistance } = limits
  if (maxDistance !== undefined && !(reach < reachFrom(diagram, circle, maxDistance))) return false
  const x = at(diagram.circles, 3 * circle)
  const y = at(diagram.circles, 3 * circle + 1)
  const { minX, minY, maxX, maxY } = bounds.box
  if (!(minX <= x - reach && x + reach <= maxX && minY <= y - reach && y + reach <= maxY)) return false
  if (bounds.isBox) return true
  return [-reach, reach].every((dx) => [-reach, reach].every((dy) => bounds.contains({ x: x + dx, y: y + dy })))
}

/**
 * Returns the part of an edge within the maximum distance. Without a maximum distance, it is the edge with its ends at
 * infinity moved to points far outside the bounds.
 */
export function partAtDistance(diagram: DiagramData, edge: number, { bounds, maxDistance }: Limits): Part | undefined {
  const curve = curveOf(diagram, edge)
  if (maxDistance === undefined) return boundedPart(curve, bounds)
  const reachOf = (end: number) => reachFrom(diagram, at(diagram.edges, 4 * edge + end), maxDistance)
  return partNear(curve, Math.min(reachOf(0), reachOf(1)))
}

/** Returns the parts of an edge inside the limits, in the direction of the edge. */
export function keptParts(diagram: DiagramData, edge: number, limits: Limits): Part[] {
  const part = partAtDistance(diagram, edge, limits)
  return part === undefined ? [] : partsInside(part, limits.bounds)
}
