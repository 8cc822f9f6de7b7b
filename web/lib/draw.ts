// SPDX-License-Identifier: GPL-3.0-or-later
import { type Point, pointAt, rangesWithin, traceArc } from './bisector.ts'
import type { Cells } from './cells.ts'
import { at, circleAt, type Diagram } from './diagram.ts'
import type { PathSink } from './path-sink.ts'
import { bisectorOf, circleOf, originOf, rangeOf, reachOf, targetOf, vertexPoint } from './sides.ts'

/** A window on the plane: what lies outside it need not be drawn. */
export interface Box {
  readonly minX: number
  readonly minY: number
  readonly maxX: number
  readonly maxY: number
}

/** Draws the part of edge `e` that lies in the box, and little more, no farther than `tolerance` from the true curve. */
export function traceEdge(sink: PathSink, diagram: Diagram, e: number, box: Box, tolerance: number): void {
  const side = 2 * e
  const { near, far } = distancesTo(box, diagram.circles, circleOf(diagram, side))
  if (reachOf(diagram, side) < near) return
  const curve = bisectorOf(diagram, side)
  const range = rangeOf(diagram, side, curve)
  // The margin outweighs rounding where the curve runs across the box at a steady distance from the centre.
  const margin = (far - near) / 2
  for (const { from, to } of rangesWithin(curve, range, near - margin, far + margin)) {
    const start = from === range.from ? vertexPoint(diagram, originOf(diagram, side)) : pointAt(curve, from)
    const end = to === range.to ? vertexPoint(diagram, targetOf(diagram, side)) : pointAt(curve, to)
    sink.moveTo(start.x, start.y)
    traceArc(sink, curve, from, to, end, tolerance)
  }
}

/**
 * Draws the outline of a cell, cut by a circle around the cell's own circle that contains the box: a cell is star-shaped
 * seen from there, so the cut is an arc wherever the cell goes on. A hidden circle and a cell outside the box draw nothing.
 */
export function traceCell(sink: PathSink, cells: Cells, circle: number, box: Box, tolerance: number): void {
  const { diagram } = cells
  const { near, far: cut } = distancesTo(box, diagram.circles, circle)
  if (!cells.exists(circle) || cells.reach(circle) < near) return

  const { x, y } = circleAt(diagram.circles, circle)
  const angleOf = (point: Point) => Math.atan2(point.y - y, point.x - x)
  let first: Point | undefined
  let last: Point | undefined
  let lastIsCut = false
  let swept = 0

  const arcAlongCut = (from: Point, to: Point) => {
    const angle = angleOf(from)
    const sweep = turn(angle, angleOf(to))
    // A gap of no width may come out as a full turn; what is drawn already tells the two apart.
    if (swept + sweep < FULL_TURN + ANGLE_ROUNDING) sink.arc(x, y, cut, angle, angle + sweep)
    swept += sweep
  }

  for (const side of cells.sides(circle)) {
    const curve = bisectorOf(diagram, side)
    const range = rangeOf(diagram, side, curve)
    const visible = rangesWithin(curve, range, 0, cut)[0]
    if (visible === undefined) continue
    const { from, to } = visible
    const start = from === range.from ? vertexPoint(diagram, originOf(diagram, side)) : pointAt(curve, from)
    const end = to === range.to ? vertexPoint(diagram, targetOf(diagram, side)) : pointAt(curve, to)
    if (first === undefined || last === undefined) {
      first = start
      sink.moveTo(start.x, start.y)
    } else if (lastIsCut) {
      arcAlongCut(last, start)
    }
    traceArc(sink, curve, from, to, end, tolerance)
    swept += turn(angleOf(start), angleOf(end))
    last = end
    lastIsCut = to < range.to
  }

  if (first === undefined || last === undefined) {
    sink.moveTo(x + cut, y)
    sink.arc(x, y, cut, 0, FULL_TURN)
  } else if (lastIsCut) {
    arcAlongCut(last, first)
  }
  sink.closePath()
}

const FULL_TURN = 2 * Math.PI
const ANGLE_ROUNDING = 1e-6

/** The counter-clockwise angle from one direction to another, from 0 to a full turn. */
function turn(from: number, to: number): number {
  const difference = to - from
  return difference < 0 ? difference + FULL_TURN : difference
}

/** The least and the greatest distance from a circle's centre to the points of the box. */
function distancesTo(box: Box, circles: Float64Array, circle: number): { near: number; far: number } {
  const x = at(circles, 3 * circle)
  const y = at(circles, 3 * circle + 1)
  const nearX = Math.max(box.minX - x, 0, x - box.maxX)
  const nearY = Math.max(box.minY - y, 0, y - box.maxY)
  const farX = Math.max(box.maxX - x, x - box.minX)
  const farY = Math.max(box.maxY - y, y - box.minY)
  return { near: Math.sqrt(nearX * nearX + nearY * nearY), far: Math.sqrt(farX * farX + farY * farY) }
}
