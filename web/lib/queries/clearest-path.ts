// SPDX-License-Identifier: GPL-3.0-or-later

import { checkDiagram, checkMetric, checkOptionNames, checkPoint, refuseInput } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import { distanceFrom } from '../base/metric.ts'
import type { Point } from '../base/types.ts'
import { pointOf } from '../curves/bisector.ts'
import { type BoundedCurve, curveOf, type EdgeCurve, reversed, segment } from '../curves/curve.ts'
import type { Diagram } from '../diagram/diagram.ts'
import { type Bounds, type ConvexBoundsOptions, ConvexPolygon } from '../regions/convex-polygon.ts'
import { Region, regionOption } from '../regions/region.ts'
import { type Exit, exitOf } from './cell-exit.ts'
import { Heap } from './heap.ts'
import { pathInBounds } from './path-in-bounds.ts'

/**
 * A path whose smallest distance from any circle is as large as possible.
 *
 * @category Questions
 */
export interface ClearestPath {
  /** The smallest distance from a circle along the path; negative if every path enters circles. */
  readonly clearance: number
  /**
   * The edges to follow, in order: the first from `entry`, the last up to `exit`. If the path goes around everything,
   * an edge that leads to infinity is followed by one that comes back.
   */
  readonly edges: Int32Array
  /**
   * The point where the path from p meets the first edge or the boundary, after going straight away from the center of
   * the nearest circle; `undefined` if the path leads straight to infinity.
   */
  readonly entry: Point | undefined
  /**
   * The point where the path leaves the last edge or the boundary for q; `undefined` if the path comes straight from
   * infinity.
   */
  readonly exit: Point | undefined
  /**
   * With bounds or a region, the curves of the whole path from p to q. Each ends where the next one starts. Parts of
   * edges are arcs, and the others are straight. There are none if p and q are the same.
   */
  readonly curves?: readonly BoundedCurve[]
}

/**
 * Finds the path of greatest clearance from p to q, in O(n log n). The diagram must have the metric `circles` and at
 * least one circle.
 *
 * With `bounds` or a `region`, the path stays inside. The clearance counts circles only: the boundary is a limit and no
 * obstacle, so the path may run along it. To keep away from the boundary, pass a smaller region. The result is the
 * shortest of the clearest paths along edges and boundary. It is `undefined` only if p and q lie in different parts of
 * the region. Polygons that touch in a point are one part.
 *
 * @throws CircleVoronoiError `badInput`, also if p or q lies outside the bounds or the region; `badOption`
 *
 * @category Questions
 * @example
 * clearestPath(diagram, { x: 3, y: 0 }, { x: 0, y: 4 }).clearance // 2
 */
export function clearestPath(
  diagram: Diagram,
  p: Point,
  q: Point,
  options: ConvexBoundsOptions | { readonly region: Region },
): ClearestPath | undefined
export function clearestPath(diagram: Diagram, p: Point, q: Point): ClearestPath
export function clearestPath(
  diagram: Diagram,
  p: Point,
  q: Point,
  options: Partial<ConvexBoundsOptions> & { readonly region?: Region } = {},
): ClearestPath | undefined {
  checkDiagram(diagram, 'clearestPath')
  checkOptionNames(options, 'clearestPath', ['bounds', 'region'])
  const region = regionOption(options, 'clearestPath')
  checkMetric(diagram, 'clearestPath', 'circles')
  checkPoint(p, 'clearestPath')
  checkPoint(q, 'clearestPath')
  if (diagram.circles.length === 0) refuseInput('clearestPath takes a diagram of one circle or more.')
  if (region !== undefined || options.bounds !== undefined) {
    const given = region ?? ConvexPolygon.of(options.bounds as Bounds)
    for (const point of [p, q]) {
      const isInside = given instanceof Region ? given.contains(point.x, point.y) : given.contains(point)
      if (!isInside)
        refuseInput(`clearestPath: (${point.x}, ${point.y}) lies outside the ${region ? 'region' : 'bounds'}.`)
    }
    return given instanceof Region ? pathInRegion(diagram, p, q, given) : pathInBounds(diagram, p, q, given)
  }
  // Moving straight away from the nearest center until an edge never loses clearance. So every path, also through
  // infinity, can be moved onto the edges. The clearest path is therefore the widest path along edges (Dijkstra).
  const fromCircle = diagram.find(p.x, p.y)
  const toCircle = diagram.find(q.x, q.y)
  const from = exitOf(diagram, fromCircle, p)
  const to = exitOf(diagram, toCircle, q)
  const route = routeTo(diagram, reached(diagram, from), from, to)
  return {
    clearance: Math.min(
      route.clearance,
      distanceFrom(diagram, fromCircle, p.x, p.y),
      distanceFrom(diagram, toCircle, q.x, q.y),
    ),
    edges: Int32Array.from(route.edges),
    entry: from?.point,
    exit: to?.point,
  }
}

function pathInRegion(diagram: Diagram, p: Point, q: Point, region: Region): ClearestPath | undefined {
  const path = region.module.clip(diagram, undefined).clearestPath(p, q)
  if (path === undefined) return undefined
  const { clearance, edges, ends, curveEdges, isForward, numbers } = path
  const pointAt = (numbers: Float64Array, k: number) => ({ x: at(numbers, k), y: at(numbers, k + 1) })
  const curves = Array.from(curveEdges, (edge, k): BoundedCurve => {
    const start = pointAt(numbers, 6 * k + 2)
    const end = pointAt(numbers, 6 * k + 4)
    if (edge === NONE) return segment(start, end)
    const curve = curveOf(diagram, edge)
    const { bisector } = isForward[k] === 1 ? curve : reversed(curve)
    return { bisector, from: at(numbers, 6 * k), to: at(numbers, 6 * k + 1), start, end }
  })
  return { clearance, edges, entry: pointAt(ends, 0), exit: pointAt(ends, 2), curves }
}

/** The clearance of the best path to each node (a vertex or infinity), and its last step. */
interface Reach {
  readonly clearance: Float64Array
  /** The last edge of the path; `NONE` if the path starts at the node. */
  readonly edge: Int32Array
  /** The previous node of the path; `NONE` if the path starts on the edge. */
  readonly before: Int32Array
}

/** Returns the node of a vertex. Infinity is the node after the last vertex. */
function nodeOf({ vertices }: Diagram, vertex: number): number {
  return vertex === NONE ? vertices.length / 3 : vertex
}

function startOf(diagram: Diagram, edge: number): number {
  return nodeOf(diagram, at(diagram.edges, 4 * edge + 2))
}

function endOf(diagram: Diagram, edge: number): number {
  return nodeOf(diagram, at(diagram.edges, 4 * edge + 3))
}

/**
 * Returns the least distance from the circles along a part of an edge. It is at the apex if the part contains it,
 * otherwise at an end.
 */
function clearanceOf(diagram: Diagram, { bisector }: EdgeCurve, edge: number, from: number, to: number): number {
  const { x, y } = pointOf(bisector, Math.min(Math.max(1, from), to))
  return distanceFrom(diagram, at(diagram.edges, 4 * edge), x, y)
}

/** Finds the best paths from a point on an edge, or from infinity, to all nodes. */
function reached(diagram: Diagram, from: Exit | undefined): Reach {
  const { vertexSides } = diagram
  const nodeCount = nodeOf(diagram, NONE) + 1
  const reach: Reach = {
    clearance: new Float64Array(nodeCount).fill(Number.NEGATIVE_INFINITY),
    edge: new Int32Array(nodeCount).fill(NONE),
    before: new Int32Array(nodeCount).fill(NONE),
  }
  const pending = new Heap()
  const offer = (node: number, clearance: number, edge: number, before: number) => {
    if (!(clearance > at(reach.clearance, node))) return
    reach.clearance[node] = clearance
    reach.edge[node] = edge
    reach.before[node] = before
    pending.push(node, clearance)
  }

  if (from === undefined) {
    offer(nodeOf(diagram, NONE), Number.POSITIVE_INFINITY, NONE, NONE)
  } else {
    const { edge, parameter } = from
    const curve = curveOf(diagram, edge)
    offer(startOf(diagram, edge), clearanceOf(diagram, curve, edge, curve.from, parameter), edge, NONE)
    offer(endOf(diagram, edge), clearanceOf(diagram, curve, edge, parameter, curve.to), edge, NONE)
  }
  const toInfinity: number[] = []
  for (let edge = 0; edge < diagram.edges.length / 4; edge++) {
    if (startOf(diagram, edge) === nodeCount - 1 || endOf(diagram, edge) === nodeCount - 1) toInfinity.push(2 * edge)
  }
  while (pending.size > 0) {
    const { item: node, key } = pending.pop()
    if (key < at(reach.clearance, node)) continue
    for (const side of node === nodeCount - 1 ? toInfinity : vertexSides.subarray(3 * node, 3 * node + 3)) {
      const edge = side >> 1
      const curve = curveOf(diagram, edge)
      const along = Math.min(key, clearanceOf(diagram, curve, edge, curve.from, curve.to))
      offer(startOf(diagram, edge), along, edge, node)
      offer(endOf(diagram, edge), along, edge, node)
    }
  }
  return reach
}

interface Route {
  readonly clearance: number
  readonly edges: readonly number[]
}

function routeTo(diagram: Diagram, reach: Reach, from: Exit | undefined, to: Exit | undefined): Route {
  if (to === undefined) return routeToNode(reach, nodeOf(diagram, NONE), Number.POSITIVE_INFINITY, NONE)
  const { edge, parameter } = to
  const curve = curveOf(diagram, edge)
  const clearance = (low: number, high: number) => clearanceOf(diagram, curve, edge, low, high)
  const start = startOf(diagram, edge)
  const end = endOf(diagram, edge)
  const byStart = clearance(curve.from, parameter)
  const byEnd = clearance(parameter, curve.to)
  const throughStart = Math.min(byStart, at(reach.clearance, start))
  const throughEnd = Math.min(byEnd, at(reach.clearance, end))
  if (from?.edge === edge) {
    const direct = clearance(Math.min(from.parameter, parameter), Math.max(from.parameter, parameter))
    if (direct >= throughStart && direct >= throughEnd) return { clearance: direct, edges: [edge] }
  }
  return throughStart >= throughEnd ? routeToNode(reach, start, byStart, edge) : routeToNode(reach, end, byEnd, edge)
}

/** Returns the path to a node and on along a last edge. */
function routeToNode({ clearance, edge, before }: Reach, node: number, lastClearance: number, last: number): Route {
  const edges = last === NONE ? [] : [last]
  for (let place = node; place !== NONE; place = at(before, place)) {
    if (edge[place] !== NONE) edges.push(at(edge, place))
  }
  return { clearance: Math.min(lastClearance, at(clearance, node)), edges: edges.reverse() }
}
