// SPDX-License-Identifier: GPL-3.0-or-later

import { at, circleOf } from '../base/diagram-data.ts'
import { lengthOf, turn } from '../base/scale.ts'
import type { DiagramData, Point } from '../base/types.ts'
import { polylineOf } from '../curves/bezier.ts'
import { type BoundedCurve, borrowCurve, returnCurve } from '../curves/curve.ts'
import { isKeptWhole, type Limits } from '../regions/cell-limits.ts'
import type { Cells } from '../regions/cells.ts'
import { polyline as arcPolyline, isCircleArc } from '../regions/circle-arc.ts'
import { convexHull } from '../regions/hull.ts'
import { outlineOf } from '../regions/outline.ts'
import type { Region } from '../regions/region.ts'
import { type MultiPolygon, multiPolygonOf } from './draw-clipped.ts'

/**
 * A closed counter-clockwise ring of points x, y that repeats its first point at the end.
 *
 * @category Cells
 */
export type Polygon = [x: number, y: number][]

/**
 * Returns the part of a cell inside the limits as one ring, which goes from the first point to each further loop and
 * back; `undefined` if the part is empty. Neighboring cells share their points bit for bit. A loop that is so thin
 * that its points at the tolerance enclose no area, or so small that its points are rounding, is left out.
 */
export function cellRing(cells: Cells, circle: number, limits: Limits, tolerance: number): Polygon | undefined {
  if (isKeptWhole(cells.diagram, circle, cells.reach(circle), limits)) {
    const whole = wholeRing(cells, circle, tolerance)
    return hasArea(whole) ? whole : undefined
  }
  const rings = outlineOf(cells, circle, limits).map((loop) => {
    const points: Polygon = []
    for (const piece of loop) {
      if (isCircleArc(piece)) addPoints(points, arcPolyline(piece, tolerance))
      else addCurve(points, piece.forward, piece.forward !== piece.curve, tolerance)
    }
    return points
  })
  const [ring, ...others] = rings.filter((points) => hasArea(points) && isBeyondRounding(points))
  if (ring?.[0] === undefined) return undefined
  const [x, y] = ring[0]
  for (const other of others) {
    for (const point of other) ring.push(point)
    ring.push([x, y])
  }
  return ring
}

function hasArea(ring: Polygon): boolean {
  const [x, y] = ring[0] ?? [0, 0]
  let twice = 0
  for (let k = 2; k < ring.length; k++) {
    const [p, q] = [ring[k - 1], ring[k]] as [Polygon[number], Polygon[number]]
    twice += turn({ x: p[0] - x, y: p[1] - y }, { x: q[0] - x, y: q[1] - y })
  }
  return twice > 0
}

/** Returns whether a ring is larger than a few units in the last place of its points. */
function isBeyondRounding(ring: Polygon): boolean {
  const [x, y] = ring[0] as Polygon[number]
  const least = 2 ** -48 * Math.max(Math.abs(x), Math.abs(y))
  return ring.some(([px, py]) => Math.abs(px - x) > least || Math.abs(py - y) > least)
}

/** Returns the ring of a whole bounded cell. */
function wholeRing(cells: Cells, circle: number, tolerance: number): Polygon {
  const { circles, firstSide, metric, nextSide, vertices } = cells.diagram
  const ring: Polygon = []
  const addOrigin = (side: number) => {
    const vertex = cells.originOf(side)
    addPoint(ring, at(vertices, 3 * vertex), at(vertices, 3 * vertex + 1))
  }
  const first = at(firstSide, circle)
  let side = first
  do {
    // A straight side has no other points.
    addOrigin(side)
    const isCurved = metric === 'circles' && at(circles, 3 * circle + 2) !== at(circles, 3 * cells.neighborOf(side) + 2)
    if (isCurved) {
      addCurve(ring, borrowCurve(cells.diagram, side & ~1) as BoundedCurve, side % 2 === 1, tolerance)
      returnCurve()
    }
    side = at(nextSide, side)
  } while (side !== first)
  addOrigin(first)
  return ring
}

/** Adds a curve, whose points are computed in its own direction, to a ring. */
function addCurve(ring: Polygon, forward: BoundedCurve, isBackward: boolean, tolerance: number): void {
  const points = polylineOf(forward, tolerance)
  addPoints(ring, isBackward ? points.reverse() : points)
}

function addPoints(ring: Polygon, points: readonly Point[]): void {
  for (const { x, y } of points) addPoint(ring, x, y)
}

/** Adds a point to a ring unless it is the last one. */
function addPoint(ring: Polygon, x: number, y: number): void {
  const last = ring.at(-1)
  if (last === undefined || last[0] !== x || last[1] !== y) ring.push([x, y])
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
