// SPDX-License-Identifier: GPL-3.0-or-later

import { circleOf } from '../base/diagram-data.ts'
import { lengthOf } from '../base/scale.ts'
import type { DiagramData, Point } from '../base/types.ts'
import { polylineOf } from '../curves/bezier.ts'
import { polyline as arcPolyline, isCircleArc } from '../regions/circle-arc.ts'
import { convexHull } from '../regions/hull.ts'
import type { SharedPiece } from '../regions/outline.ts'
import type { Region } from '../regions/region.ts'
import { type MultiPolygon, multiPolygonOf } from './draw-clipped.ts'

/**
 * A closed counter-clockwise ring of points x, y that repeats its first point at the end.
 *
 * @category Cells
 */
export type Polygon = [x: number, y: number][]

/**
 * Joins the loops of an outline to one ring, which goes from the first point to each further loop and back. Neighboring
 * cells share their points bit for bit.
 */
export function ringOf(outline: readonly (readonly SharedPiece[])[], tolerance: number): Polygon | undefined {
  const [ring, ...others] = outline.map((loop) => {
    const points: Polygon = []
    let last: Point | undefined
    for (const piece of loop) {
      for (const point of pointsOf(piece, tolerance)) {
        if (point.x !== last?.x || point.y !== last.y) points.push([point.x, point.y])
        last = point
      }
    }
    return points
  })
  if (ring === undefined || ring[0] === undefined) return undefined
  const [x, y] = ring[0]
  for (const other of others) {
    for (const point of other) ring.push(point)
    ring.push([x, y])
  }
  return ring
}

function pointsOf(piece: SharedPiece, tolerance: number): Point[] {
  if (isCircleArc(piece)) return arcPolyline(piece, tolerance)
  const points = polylineOf(piece.forward, tolerance)
  return piece.forward === piece.curve ? points : points.reverse()
}

/** Returns the part of `hullRing` inside a region; `undefined` if it has no area. */
export function hullInRegion(diagram: DiagramData, region: Region, tolerance: number): MultiPolygon | undefined {
  const corners = hullRing(diagram, tolerance)?.slice(0, -1) ?? []
  const inside = region.module.clipConvex(corners.map(([x, y]) => ({ x, y })))
  return inside && multiPolygonOf(inside, 0)
}

/**
 * Returns a ring inside the hull of the circles, no farther from the hull than the tolerance. The smallest effective
 * tolerance is 1e-9 of a circle's radius.
 */
export function hullRing(diagram: DiagramData, tolerance: number): Polygon | undefined {
  const ring: Polygon = []
  for (const { circle, start, end, angle } of convexHull(diagram).arcs) {
    const { x, y } = circleOf(diagram.circles, circle)
    const [dx, dy] = [start.x - x, start.y - y]
    const r = lengthOf({ x: dx, y: dy })
    // A chord of angle 2 h is r (1 - cos h) from the middle of its arc.
    const half = 2 * Math.asin(Math.min(1, Math.sqrt(Math.max(tolerance / r, 1e-9) / 2)))
    const count = r > 0 ? Math.max(Math.ceil(angle / (2 * half)), angle > Math.PI ? 3 : 1) : 1
    ring.push([start.x, start.y])
    for (let k = 1; k < count; k++) {
      const [cosine, sine] = [Math.cos((k / count) * angle), Math.sin((k / count) * angle)]
      ring.push([x + cosine * dx - sine * dy, y + sine * dx + cosine * dy])
    }
    if (end.x !== start.x || end.y !== start.y) ring.push([end.x, end.y])
  }
  const [first] = ring
  if (first === undefined) return undefined
  ring.push([...first])
  return ring
}
