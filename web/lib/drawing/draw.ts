// SPDX-License-Identifier: GPL-3.0-or-later

import { at, circleOf, NONE } from '../base/diagram-data.ts'
import { hypotenuse, lengthOf } from '../base/scale.ts'
import type { Box, DiagramData, PathSink, Point } from '../base/types.ts'
import { addArc, controlPoint } from '../curves/bezier.ts'
import { type BoundedCurve, borrowCurve, returnCurve } from '../curves/curve.ts'
import { isKeptWhole, type Limits } from '../regions/cell-limits.ts'
import type { Cells } from '../regions/cells.ts'
import type { ConvexPolygon } from '../regions/convex-polygon.ts'
import { convexHull } from '../regions/hull.ts'
import { keptParts, outlineOf } from '../regions/outline.ts'
import { drawOutline } from './draw-clipped.ts'

/** Draws the kept parts of edge `e`, no farther than `tolerance` from the true curve. */
export function drawEdge(sink: PathSink, diagram: DiagramData, e: number, limits: Limits, tolerance: number): void {
  if (hasEndsInside(diagram, e, limits, tolerance)) {
    const { vertices, edges } = diagram
    const [start, end] = [at(edges, 4 * e + 2), at(edges, 4 * e + 3)]
    // An edge drawn as its chord cannot leave the bounds between its ends.
    if (isNearChord(diagram, e, tolerance)) {
      sink.moveTo(at(vertices, 3 * start), at(vertices, 3 * start + 1))
      sink.lineTo(at(vertices, 3 * end), at(vertices, 3 * end + 1))
      return
    }
    const curve = borrowCurve(diagram, 2 * e) as BoundedCurve
    try {
      // An arc lies in the triangle of its Bézier points.
      if (isWithin(limits.bounds.box, controlPoint(curve.bisector, curve.from, curve.to), 0)) {
        sink.moveTo(curve.start.x, curve.start.y)
        addArc(sink, curve, tolerance)
        return
      }
    } finally {
      returnCurve()
    }
  }
  if (isBeyondEdge(diagram, e, limits.bounds)) return
  for (const { curve } of keptParts(diagram, e, limits)) {
    sink.moveTo(curve.start.x, curve.start.y)
    addArc(sink, curve, tolerance)
  }
}

/** Draws the outline of the kept part of a cell, counter-clockwise: a closed path for each piece. */
export function drawCell(sink: PathSink, cells: Cells, circle: number, limits: Limits, tolerance: number): void {
  const reach = cells.reach(circle)
  if (!(distanceTo(limits.bounds, cells.diagram, circle) <= reach)) return
  if (isKeptWhole(cells.diagram, circle, reach, limits)) {
    drawWholeCell(sink, cells, circle, tolerance)
    return
  }
  drawOutline(sink, outlineOf(cells, circle, limits), tolerance)
}

/** Draws a cell that lies inside the bounds without clipping, as for most cells of a view. */
function drawWholeCell(sink: PathSink, cells: Cells, circle: number, tolerance: number): void {
  const { vertices, firstSide, nextSide } = cells.diagram
  const first = at(firstSide, circle)
  const start = cells.originOf(first)
  sink.moveTo(at(vertices, 3 * start), at(vertices, 3 * start + 1))
  let side = first
  do {
    if (isNearChord(cells.diagram, side >> 1, tolerance)) {
      const end = cells.targetOf(side)
      sink.lineTo(at(vertices, 3 * end), at(vertices, 3 * end + 1))
    } else {
      const curve = borrowCurve(cells.diagram, side) as BoundedCurve
      try {
        addArc(sink, curve, tolerance)
      } finally {
        returnCurve()
      }
    }
    side = at(nextSide, side)
  } while (side !== first)
  sink.closePath()
}

/**
 * Whether a bounded edge can be drawn as its chord, by a bound that does not need its curve. With d the distance of the
 * centers, |a| half the difference of the radii and L the chord, the error is at most |a| (w - 1) (`traceArc`), and w -
 * 1 is at most L^2 / (8 b^2), where 4 b^2 = d^2 - (2 a)^2.
 */
function isNearChord({ circles, edges, vertices, metric }: DiagramData, e: number, tolerance: number): boolean {
  const left = 3 * at(edges, 4 * e)
  const right = 3 * at(edges, 4 * e + 1)
  const difference = metric === 'circles' ? at(circles, left + 2) - at(circles, right + 2) : 0
  if (difference === 0) return true
  const dx = at(circles, left) - at(circles, right)
  const dy = at(circles, left + 1) - at(circles, right + 1)
  const square = dx * dx + dy * dy
  const rest = square - difference * difference
  const most = 3.9 * tolerance * rest
  // The bound fails if the difference cancels or squares overflow or underflow.
  if (!(rest > 1e-6 * square && most > 1e-280 && most < 1e280)) return false
  const start = 3 * at(edges, 4 * e + 2)
  const end = 3 * at(edges, 4 * e + 3)
  const x = at(vertices, start) - at(vertices, end)
  const y = at(vertices, start + 1) - at(vertices, end + 1)
  return Math.abs(difference) * (x * x + y * y) <= most
}

/** Whether the bounds are a box and both ends of an edge lie inside it, by more than the error of drawing. */
function hasEndsInside(
  { edges, vertices }: DiagramData,
  e: number,
  { bounds, maxDistance }: Limits,
  tolerance: number,
): boolean {
  const start = at(edges, 4 * e + 2)
  const end = at(edges, 4 * e + 3)
  if (maxDistance !== undefined || !bounds.isBox || start === NONE || end === NONE) return false
  return (
    isVertexWithin(bounds.box, vertices, start, 4 * tolerance) &&
    isVertexWithin(bounds.box, vertices, end, 4 * tolerance)
  )
}

function isVertexWithin(box: Box, vertices: Float64Array, v: number, margin: number): boolean {
  return isWithin(box, { x: at(vertices, 3 * v), y: at(vertices, 3 * v + 1) }, margin)
}

function isWithin({ minX, minY, maxX, maxY }: Box, { x, y }: Point, margin: number): boolean {
  return minX + margin < x && x < maxX - margin && minY + margin < y && y < maxY - margin
}

/** Draws the convex hull: arcs of circles and the tangent segments between them. */
export function drawHull(sink: PathSink, diagram: DiagramData): void {
  const { arcs } = convexHull(diagram)
  arcs.forEach(({ circle, start, angle }, k) => {
    const { x, y } = circleOf(diagram.circles, circle)
    const radius = lengthOf({ x: start.x - x, y: start.y - y })
    const from = Math.atan2(start.y - y, start.x - x)
    if (k === 0) sink.moveTo(start.x, start.y)
    else sink.lineTo(start.x, start.y)
    if (radius > 0) sink.arc(x, y, radius, from, from + angle)
  })
  if (arcs.length > 0) sink.closePath()
}

/** Draws the outline of bounds. */
export function drawBounds(sink: PathSink, { corners }: ConvexPolygon): void {
  corners.forEach(({ x, y }, k) => {
    if (k === 0) sink.moveTo(x, y)
    else sink.lineTo(x, y)
  })
  sink.closePath()
}

/** Draws a segment from center to center for each edge. */
export function drawDual(sink: PathSink, { circles, edges }: DiagramData): void {
  for (let e = 0; e < edges.length; e += 4) {
    const [left, right] = [at(edges, e), at(edges, e + 1)]
    sink.moveTo(at(circles, 3 * left), at(circles, 3 * left + 1))
    sink.lineTo(at(circles, 3 * right), at(circles, 3 * right + 1))
  }
}

/** Draws a circle, or a point if the radius is negative. */
export function drawCircle(sink: PathSink, { circles }: DiagramData, i: number): void {
  const { x, y, r } = circleOf(circles, i)
  const radius = Math.max(r, 0)
  sink.moveTo(x + radius, y)
  sink.arc(x, y, radius, 0, 2 * Math.PI)
  sink.closePath()
}

/**
 * Whether an edge is certainly outside the bounds, which saves time for small bounds. The distance from the left center
 * grows from the apex to both sides, so it is largest at a vertex.
 */
function isBeyondEdge(diagram: DiagramData, e: number, bounds: ConvexPolygon): boolean {
  const { circles, edges, vertices } = diagram
  const left = at(edges, 4 * e)
  const start = at(edges, 4 * e + 2)
  const end = at(edges, 4 * e + 3)
  if (start === NONE || end === NONE) return false
  const x = at(circles, 3 * left)
  const y = at(circles, 3 * left + 1)
  const toStart = hypotenuse(at(vertices, 3 * start) - x, at(vertices, 3 * start + 1) - y)
  const toEnd = hypotenuse(at(vertices, 3 * end) - x, at(vertices, 3 * end + 1) - y)
  return Math.max(toStart, toEnd) < distanceTo(bounds, diagram, left)
}

/** Returns a lower bound for the distance from a circle's center to the bounds. */
function distanceTo({ box }: ConvexPolygon, { circles }: DiagramData, circle: number): number {
  const x = at(circles, 3 * circle)
  const y = at(circles, 3 * circle + 1)
  return hypotenuse(Math.max(box.minX - x, 0, x - box.maxX), Math.max(box.minY - y, 0, y - box.maxY))
}
