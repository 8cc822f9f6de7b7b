// SPDX-License-Identifier: GPL-3.0-or-later
import { circleOf, edgeOf, NONE } from '../base/diagram-data.ts'
import { distanceFrom } from '../base/metric.ts'
import { between, dot } from '../base/point.ts'
import { facing, largestOf, lengthOf, measuredIn, powerOfTwoIn } from '../base/scale.ts'
import type { Point } from '../base/types.ts'
import { pointOf } from '../curves/bisector.ts'
import { type BoundedCurve, curveOf, reversed, segment } from '../curves/curve.ts'
import type { Diagram } from '../diagram/diagram.ts'
import { boundedPart, HalfPlane, isSame, partsInside } from '../regions/clip.ts'
import type { ConvexPolygon } from '../regions/convex-polygon.ts'
import { curveLength } from '../regions/measure.ts'
import { exitOf } from './cell-exit.ts'
import type { ClearestPath } from './clearest-path.ts'
import { Heap } from './heap.ts'

/** Points this close to a side, as a share of the size of the bounds and of their coordinates, are linked to it. */
const NEAR_SIDE = 1e-12
const NEAR_SIDE_OF_COORDINATES = 2 ** -50
/** A ray that leaves its cell this close to a side, as a share of its length, ends on the side. */
const NEAR_EXIT = 1e-9

/** A place on a piece of the graph, and its node. */
interface Stop {
  readonly place: number
  readonly node: number
}

/** A part of an edge in the bounds, in the direction of the edge. */
interface EdgePart {
  readonly curve: BoundedCurve
  readonly edge: number
  readonly stops: Stop[]
}

/** A step from one node to another. */
interface Link {
  readonly nodes: readonly [number, number]
  readonly curve: BoundedCurve | undefined
  readonly edge: number
  readonly clearance: number
  readonly length: number
  readonly isRay: boolean
}

/**
 * Finds the clearest path from `p` to `q` inside bounds. If several paths are equally clear, it is the shortest along
 * edges and boundary.
 *
 * Moving straight away from the nearest center never loses clearance and leads to an edge or the boundary. So some
 * clearest path follows edges and boundary. The boundary is one closed line, and all edges inside are connected with it,
 * so there is a path. Bounds are convex, so the segment between any two of their points lies inside: where rounding
 * hides whether a vertex or an end lies on the boundary, both are linked.
 */
export function pathInBounds(diagram: Diagram, p: Point, q: Point, bounds: ConvexPolygon): ClearestPath {
  const graph = new Graph(diagram, bounds)
  const ends = [p, q].map((point) => graph.addEnd(point))
  const [from, to] = ends as [number, number]
  graph.link()
  const links = graph.route(isSame(p, q) ? to : from, to)
  const clearances = [p, q].map(({ x, y }) => distanceFrom(diagram, diagram.find(x, y), x, y))
  const first = links[0]
  const last = links.at(-1)
  return {
    clearance: Math.min(...clearances, ...links.map(({ clearance }) => clearance)),
    edges: Int32Array.from(
      links.flatMap(({ edge }, k) => (edge === NONE || edge === links[k - 1]?.edge ? [] : [edge])),
    ),
    entry: first?.isRay === true && first.curve !== undefined ? first.curve.end : p,
    exit: last?.isRay === true && last.curve !== undefined ? last.curve.start : q,
    curves: links.flatMap(({ curve }) => (curve === undefined ? [] : [curve])),
  }
}

class Graph {
  readonly #diagram: Diagram
  readonly #halves: readonly HalfPlane[]
  readonly #nearSide: number
  /** The points of the nodes. */
  readonly #points: Point[] = []
  readonly #links: Link[][] = []
  /** The nodes on each side. */
  readonly #onSide: Stop[][]
  readonly #parts = new Map<number, EdgePart[]>()

  constructor(diagram: Diagram, bounds: ConvexPolygon) {
    this.#diagram = diagram
    this.#halves = HalfPlane.of(bounds)
    const { minX, minY, maxX, maxY } = bounds.box
    const coordinates = Math.max(-minX, -minY, maxX, maxY)
    this.#nearSide = NEAR_SIDE * bounds.reachFrom(bounds.corner(0)) + NEAR_SIDE_OF_COORDINATES * coordinates
    this.#onSide = this.#halves.map(({ from }) => [{ place: 0, node: this.#addNode(from) }])
    const nodeOfVertex = new Map<number, number>()
    for (let edge = 0; edge < diagram.edges.length / 4; edge++) {
      const { start, end } = edgeOf(diagram, edge)
      const parts = partsInside(boundedPart(curveOf(diagram, edge), bounds), bounds)
      for (const { curve, cutFrom, cutTo } of parts) {
        const nodeOf = (point: Point, cut: number, vertex: number) => {
          if (cut !== NONE)
            return this.#addOnSide(
              this.#halves.findIndex(({ side }) => side === cut),
              point,
            )
          const node = nodeOfVertex.get(vertex) ?? this.#addNode(point)
          if (!nodeOfVertex.has(vertex)) this.#linkToSides(node)
          nodeOfVertex.set(vertex, node)
          return node
        }
        const stops = [
          { place: curve.from, node: nodeOf(curve.start, cutFrom, start) },
          { place: curve.to, node: nodeOf(curve.end, cutTo, end) },
        ]
        this.#parts.set(edge, [...(this.#parts.get(edge) ?? []), { curve, edge, stops }])
      }
    }
  }

  #addNode(point: Point): number {
    this.#links.push([])
    return this.#points.push(point) - 1
  }

  #pointOf(node: number): Point {
    return this.#points[node] as Point
  }

  #addOnSide(k: number, point: Point): number {
    const node = this.#addNode(point)
    this.#onSide[k]?.push({ place: (this.#halves[k] as HalfPlane).place(point), node })
    return node
  }

  /** Links a node to the sides on which it may lie. */
  #linkToSides(node: number): void {
    const point = this.#pointOf(node)
    this.#halves.forEach((half, k) => {
      if (half.height(point) > this.#nearSide * lengthOf(half.along)) return
      this.#addStraight(node, this.#addOnSide(k, half.onSide(half.nearest(point))))
    })
  }

  /** Adds an end of the path, with the ray from the nearest center through it. */
  addEnd(point: Point): number {
    const node = this.#addNode(point)
    this.#linkToSides(node)
    const circle = this.#diagram.find(point.x, point.y)
    const center = circleOf(this.#diagram.circles, circle)
    const toPoint = between(center, point)
    const size = largestOf(toPoint)
    const direction = size === 0 ? { x: 1, y: 0 } : measuredIn(powerOfTwoIn(size), toPoint)
    let side = NONE
    let ahead = Infinity
    this.#halves.forEach((half, k) => {
      const fall = -(half.along.x * direction.y - half.along.y * direction.x)
      const distance = Math.max(half.height(point), 0) / fall
      if (!(fall > 0 && distance < ahead)) return
      ahead = distance
      side = k
    })
    const exit = exitOf(this.#diagram, circle, point)
    const parts = exit && this.#parts.get(exit.edge)
    if (exit !== undefined && parts !== undefined) {
      const leaves = lengthOf(between(point, exit.point)) / lengthOf(direction)
      const isAhead = facing(direction, between(point, exit.point)) > 0
      if (!isAhead || leaves < ahead * (1 - NEAR_EXIT)) {
        this.#addRay(node, this.#addOnPart(parts, exit.parameter))
        return node
      }
    }
    const half = this.#halves[side] as HalfPlane
    const hit = { x: point.x + ahead * direction.x, y: point.y + ahead * direction.y }
    this.#addRay(node, this.#addOnSide(side, half.onSide(half.nearest(hit))))
    return node
  }

  /** Returns a node at a parameter of an edge, in the nearest part of the edge. */
  #addOnPart(parts: readonly EdgePart[], parameter: number): number {
    const missOf = ({ curve: { from, to } }: EdgePart) =>
      parameter < from ? from / parameter : parameter > to ? parameter / to : 1
    const part = parts.reduce((one, other) => (missOf(other) < missOf(one) ? other : one))
    const { bisector, from, to } = part.curve
    if (parameter <= from) return part.stops[0]?.node as number
    if (parameter >= to) return part.stops[1]?.node as number
    const node = this.#addNode(pointOf(bisector, parameter))
    part.stops.push({ place: parameter, node })
    return node
  }

  /** Links the nodes along edges and sides. */
  link(): void {
    for (const part of [...this.#parts.values()].flat()) {
      const [first, second, ...between] = part.stops
      const stops = [first as Stop, ...between.sort((one, other) => one.place - other.place), second as Stop]
      stops.slice(1).forEach((to, k) => {
        this.#addArc(part, stops[k] as Stop, to)
      })
    }
    const ring = this.#onSide.flatMap((stops) => stops.sort((one, other) => one.place - other.place))
    ring.forEach(({ node }, k) => {
      this.#addStraight((ring.at(k - 1) as Stop).node, node)
    })
  }

  #addArc({ curve, edge }: EdgePart, from: Stop, to: Stop): void {
    const [start, end] = [this.#pointOf(from.node), this.#pointOf(to.node)]
    const part = { bisector: curve.bisector, from: from.place, to: to.place, start, end }
    const { x, y } = pointOf(curve.bisector, Math.min(Math.max(1, part.from), part.to))
    const clearance = distanceFrom(this.#diagram, edgeOf(this.#diagram, edge).left, x, y)
    const isWithoutLength = isSame(start, end)
    this.#add({
      nodes: [from.node, to.node],
      curve: isWithoutLength ? undefined : part,
      edge,
      clearance,
      length: isWithoutLength ? 0 : curveLength(part),
      isRay: false,
    })
  }

  /** Adds a segment in one cell. */
  #addStraight(from: number, to: number, isRay = false): void {
    const [start, end] = [this.#pointOf(from), this.#pointOf(to)]
    const along = between(start, end)
    const size = lengthOf(along)
    // Rounding may hide in which cell an end lies.
    const circles = new Set(
      [0, 0.5, 1].map((share) => this.#diagram.find(start.x + share * along.x, start.y + share * along.y)),
    )
    const clearances = [...circles].map((circle) => {
      const share =
        size === 0 ? 0 : dot(measuredIn(size, along), between(start, circleOf(this.#diagram.circles, circle))) / size
      const within = Math.min(Math.max(share, 0), 1)
      return distanceFrom(this.#diagram, circle, start.x + within * along.x, start.y + within * along.y)
    })
    const curve = size === 0 ? undefined : segment(start, end)
    this.#add({ nodes: [from, to], curve, edge: NONE, clearance: Math.min(...clearances), length: size, isRay })
  }

  #addRay(from: number, to: number): void {
    this.#addStraight(from, to, true)
  }

  #add(link: Link): void {
    for (const node of link.nodes) this.#links[node]?.push(link)
  }

  /** Returns the shortest of the clearest routes between two nodes. */
  route(start: number, goal: number): Link[] {
    const clearest = this.#best(start, Infinity, (clearance, link) => Math.min(clearance, link.clearance))
    const clearance = clearest.keys[goal] as number
    const { by } = this.#best(start, 0, (length, link) =>
      link.clearance >= clearance ? length - link.length : -Infinity,
    )
    const links: Link[] = []
    for (let node = goal; node !== start; ) {
      const link = by[node] as Link
      const isForward = link.nodes[1] === node
      links.push(isForward || link.curve === undefined ? link : { ...link, curve: reversed(link.curve) })
      node = link.nodes[isForward ? 0 : 1]
    }
    return links.reverse()
  }

  /** Finds for each node the largest key of a path from the start, and the last link of this path (Dijkstra). */
  #best(start: number, key: number, keyAlong: (key: number, link: Link) => number) {
    const keys = new Float64Array(this.#links.length).fill(-Infinity)
    const by: (Link | undefined)[] = []
    keys[start] = key
    const pending = new Heap()
    pending.push(start, key)
    while (pending.size > 0) {
      const { item: node, key } = pending.pop()
      if (key < (keys[node] as number)) continue
      for (const link of this.#links[node] ?? []) {
        const next = link.nodes[0] === node ? link.nodes[1] : link.nodes[0]
        const nextKey = keyAlong(key, link)
        if (!(nextKey > (keys[next] as number))) continue
        keys[next] = nextKey
        by[next] = link
        pending.push(next, nextKey)
      }
    }
    return { keys, by }
  }
}
