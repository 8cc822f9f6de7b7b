// SPDX-License-Identifier: GPL-3.0-or-later

import { at, circleAt, NONE } from '../../lib/base/diagram-data.ts'
import { hypotenuse } from '../../lib/base/scale.ts'
import { traceArc } from '../../lib/curves/bezier.ts'
import { parameterAt, pointAt } from '../../lib/curves/bisector.ts'
import { type BoundedCurve, edgeCurve, isBoundedCurve, reversed } from '../../lib/curves/curve.ts'
import type { Diagram, HullArc, Point } from '../../lib/index.ts'
import { clearestPath } from '../../lib/queries/clearest-path.ts'
import { largestEmptyDiscCenteredInHull } from '../../lib/queries/largest-empty-disc.ts'
import { convexHull } from '../../lib/regions/hull.ts'
import type { GlobalResults } from '../protocol.ts'
import { idOf } from './cell-boxes.ts'
import { commandsOf } from './commands.ts'
import type { Picture } from './picture.ts'
import { touching } from './touching.ts'

/**
 * Computes the visible layers that depend on all circles, one in each step. Unbounded parts extend as far as the
 * picture.
 */
export function* found({ diagram, reach, layers, method }: Picture, tolerance: number): Generator<void, GlobalResults> {
  const isEmpty = diagram.circles.length === 0
  const hull = layers.hull ? hullOf(diagram) : undefined
  yield
  const largest = layers.largestDisc && !isEmpty ? largestEmptyDiscCenteredInHull(diagram) : undefined
  const largestDisc = largest && {
    ...touching(diagram, largest.disc, largest.circles),
    circles: largest.circles.map((i) => idOf(diagram, i)),
  }
  yield
  const { path: ends } = layers
  const path = ends === undefined || isEmpty ? undefined : pathOf(diagram, ends.from, ends.to, tolerance, reach)
  return { hull, largestDisc, path, method: method?.found }
}

/**
 * The hull's arcs as numbers: for each the circle's x, y and radius, the start angle, the turn, and the start of the
 * next arc.
 */
function hullOf(diagram: Diagram): Float64Array {
  const { arcs } = convexHull(diagram)
  return Float64Array.from(
    arcs.flatMap(({ circle, r, start, angle }, k) => {
      const [x, y] = [at(diagram.circles, 3 * circle), at(diagram.circles, 3 * circle + 1)]
      const next = (arcs[(k + 1) % arcs.length] as HullArc).start
      return [x, y, r, Math.atan2(start.y - y, start.x - x), angle, next.x, next.y]
    }),
  )
}

function pathOf(diagram: Diagram, from: Point, to: Point, tolerance: number, reach: number): GlobalResults['path'] {
  const { clearance, edges, entry, exit } = clearestPath(diagram, from, to)
  const outline = commandsOf((sink) => {
    const lineTo = ({ x, y }: Point) => sink.lineTo(x, y)
    const goTo = ({ x, y }: Point) => sink.moveTo(x, y)
    goTo(from)
    if (entry === undefined) lineTo(farFrom(diagram, from, reach))
    for (const { arc, comesBack } of arcsAlong(diagram, [...edges], entry, exit, reach)) {
      if (comesBack) goTo(arc.start)
      else lineTo(arc.start)
      traceArc(sink, arc, tolerance)
    }
    if (exit === undefined) goTo(farFrom(diagram, to, reach))
    lineTo(to)
  })
  return { clearance, outline }
}

/** A distant point in the direction away from the nearest circle's center. */
function farFrom(diagram: Diagram, { x, y }: Point, reach: number): Point {
  const nearest = circleAt(diagram.circles, diagram.find(x, y))
  const [dx, dy] = [x - nearest.x, y - nearest.y]
  const distance = hypotenuse(dx, dy)
  return distance === 0 ? { x: x + reach, y } : { x: x + (reach * dx) / distance, y: y + (reach * dy) / distance }
}

/** A part of the path. `comesBack` means that it returns from infinity, where the previous part ended. */
interface Stretch {
  readonly arc: BoundedCurve
  readonly comesBack: boolean
}

/** Traces consecutive edges, from a point on the first to a point on the last. Unbounded edges extend to `reach`. */
function arcsAlong(
  diagram: Diagram,
  edges: readonly number[],
  entry: Point | undefined,
  exit: Point | undefined,
  reach: number,
): Stretch[] {
  let node = firstNode(diagram, edges, entry)
  return edges.flatMap((edge, k) => {
    const [start, end] = endsOf(diagram, edge)
    const curve = edgeCurve(diagram, edge)
    const { bisector } = curve
    const parameterOf = (point: Point | undefined) =>
      point === undefined ? undefined : parameterAt(bisector, point.x, point.y)
    const entered = k === 0 ? parameterOf(entry) : undefined
    const left = k === edges.length - 1 ? parameterOf(exit) : undefined
    const isForward = entered !== undefined && left !== undefined ? entered <= left : start === node
    const comesBack = entered === undefined && node === NONE
    node = isForward ? end : start
    const farthest = Math.max((2 * reach) / bisector.b, 2)
    const low = (isForward ? entered : left) ?? (start === NONE ? 1 / farthest : undefined)
    const high = (isForward ? left : entered) ?? (end === NONE ? farthest : undefined)
    const part = {
      bisector,
      from: low ?? curve.from,
      to: high ?? curve.to,
      start: low === undefined ? curve.start : pointAt(bisector, low),
      end: high === undefined ? curve.end : pointAt(bisector, high),
    }
    return isBoundedCurve(part) ? [{ arc: isForward ? part : reversed(part), comesBack }] : []
  })
}

/** The vertex at which a path enters its first edge, or `NONE` for infinity. */
function firstNode(diagram: Diagram, edges: readonly number[], entry: Point | undefined): number {
  const [first, second] = edges
  if (first === undefined || entry === undefined) return NONE
  const [start, end] = endsOf(diagram, first)
  // The path leaves through the vertex shared with the next edge, or else to infinity.
  const leaves = second === undefined ? end === NONE : endsOf(diagram, second).includes(end)
  return leaves ? start : end
}

function endsOf({ edges }: Diagram, edge: number): readonly [start: number, end: number] {
  return [at(edges, 4 * edge + 2), at(edges, 4 * edge + 3)]
}
