// SPDX-License-Identifier: GPL-3.0-or-later

import { at } from '../base/diagram-data.ts'
import type { DiagramData } from '../base/types.ts'
import { curveOf } from '../curves/curve.ts'
import { boundedPart, type Part, partNear, partsInside } from './clip.ts'
import type { ConvexPolygon } from './convex-polygon.ts'

/** The limits of cells and edges: the inside of bounds and, if there is one, a distance from the nearest circle. */
export interface Limits {
  readonly bounds: ConvexPolygon
  readonly maxDistance: number | undefined
}

/** The radius, perhaps not above 0, of the disc around the center of a circle that the distance keeps. */
export function reachFrom({ circles, metric }: DiagramData, circle: number, maxDistance: number): number {
  return (metric === 'circles' ? at(circles, 3 * circle + 2) : 0) + maxDistance
}

/** Whether all of a cell is kept, for all points up to `reach` from its circle's center are. */
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
 * The part of an edge within the distance, or without one the edge with ends far outside the bounds in place of those at
 * infinity.
 */
export function partAtDistance(diagram: DiagramData, edge: number, { bounds, maxDistance }: Limits): Part | undefined {
  const curve = curveOf(diagram, edge)
  if (maxDistance === undefined) return boundedPart(curve, bounds)
  const reachOf = (end: number) => reachFrom(diagram, at(diagram.edges, 4 * edge + end), maxDistance)
  return partNear(curve, Math.min(reachOf(0), reachOf(1)))
}

/** The parts of an edge that are kept, in its direction. */
export function keptParts(diagram: DiagramData, edge: number, limits: Limits): Part[] {
  const part = partAtDistance(diagram, edge, limits)
  return part === undefined ? [] : partsInside(part, limits.bounds)
}
