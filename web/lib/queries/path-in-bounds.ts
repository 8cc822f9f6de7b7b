// SPDX-License-Identifier: GPL-3.0-or-later
import { circleOf, NONE } from '../base/diagram-data.ts'
import { distanceFrom } from '../base/metric.ts'
import { between, cross, dot } from '../base/point.ts'
import { facing, largestOf, lengthOf, measuredIn, powerOfTwoIn } from '../base/scale.ts'
import type { Point } from '../base/types.ts'
import { pointOf } from '../curves/bisector.ts'
import { type BoundedCurve, reversed, segment } from '../curves/curve.ts'
import type { Diagram } from '../diagram/diagram.ts'
import { isSame, nearestOn } from '../regions/clip.ts'
import type { ConvexPolygon } from '../regions/convex-polygon.ts'
import { curveLength } from '../regions/measure.ts'
import { exitOf } from './cell-exit.ts'
import type { ClearestPath } from './clearest-path.ts'
import { Heap } from './heap.ts'

/** Points this close to the boundary, as a share of the bounds and of their coordinates, are linked to it. */
const NEAR_SIDE = 1e-12
const NEAR_SIDE_OF_COORDINATES = 2 ** -50
/** A ray that leaves its cell this close to a side, as a share of its length, ends on the side. */
const NEAR_EXIT = 1e-9

/** A point on a piece, at a parameter of an edge. On the boundary, `place` only orders the stops. */
interface Stop {
  readonly place: number
  readonly point: Point
}

/** A piece of the outline of a cell: a part of an edge, in the direction of the edge, or a part of the boundary. */
interface Piece {
  readonly curve: BoundedCurve
  /** The edge, or `NONE` on the boundary. */
  readonly edge: number
  readonly circle: number
  readonly stops: Stop[]
}

/** A step from one node to another. */
interface Link {
  readonly nodes: readonly [number, number]
  readonly curve: BoundedCurve
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
 * clearest path follows the outlines of cells, which share their points to the bit. They are connected, so there is a
 * path. Bounds are convex, so the segment between any two of their points lies inside: where rounding hides on which
 * piece a ray ends, either is right.
 */
export function pathInBounds(diagram: Diagram, p: Point, q: Point, bounds: ConvexPolygon): ClearestPath {
  const graph = new Graph(diagram, bounds)
  const ends = [p, q].map((point) => graph.addEnd(point))
  const [from, to] = ends as [number, number]
  graph.link()
  const links = graph.route(from, to)
  const clearances = [p, q].map(({ x, y }) => distanceFrom(diagram, diagram.find(x, y), x, y))
  const first = links[0]
  const last = links.at(-1)
  return {
    clearance: Math.min(...clearances, ...links.map(({ clearance }) => clearance)),
    edges: Int32Array.from(
      links.flatMap(({ edge }, k) => (edge === NONE || edge === links[k - 1]?.edge ? [] : [edge])),
    ),
    entry: first?.isRay === true ? first.curve.end : p,
    exit: last?.isRay === true ? last.curve.start : q,
    curves: links.map(({ curve }) => curve),
  }
}

class Graph {
  readonly #diagram: Diagram
  readonly #bounds: ConvexPolygon
  readonly #nodes = new Map<string, number>()
  readonly #links: Link[][] = []
  readonly #pieces: Piece[] = []
  readonly #ofCell: Piece[][]

  constructor(diagram: Diagram, bounds: ConvexPolygon) {
    this.#diagram = diagram
    this.#bounds = bounds
    const ofEdges = new Map<string, Piece>()
    this.#ofCell = Array.from({ length: diagram.circles.length / 3 }, (_, circle) =>
      diagram
        .cellOutline(circle, { bounds })
        .flat()
        .map(({ curve, side }) => {
          const forward = side !== NONE && side % 2 === 1 ? reversed(curve) : curve
          // Both cells of an edge have the same piece.
          const key = `${side >> 1} ${forward.start.x} ${forward.start.y}`
          const known = side === NONE ? undefined : ofEdges.get(key)
          if (known !== undefined) return known
          const piece = { curve: forward, edge: side === NONE ? NONE : side >> 1, circle, stops: [] }
          this.#pieces.push(piece)
          if (side !== NONE) ofEdges.set(key, piece)
          return piece
        }),
    )
  }

  #nodeOf({ x, y }: Point): number {
    const key = `${x} ${y}`
    let node = this.#nodes.get(key)
    if (node === undefined) {
      node = this.#nodes.size
      this.#nodes.set(key, node)
      this.#links.push([])
    }
    return node
  }

  /** Adds an end of the path, with the ray from the nearest center through it. */
  addEnd(point: Point): number {
    const circle = this.#diagram.find(point.x, point.y)
    const { box } = this.#bounds
    const coordinates = Math.max(-box.minX, -box.minY, box.maxX, box.maxY)
    const nearSide = NEAR_SIDE * this.#bounds.reachFrom(point) + NEAR_SIDE_OF_COORDINATES * coordinates
    const onBoundary = this.#stopOnBoundary(circle, point)
    if (lengthOf(between(point, onBoundary)) <= nearSide) this.#addStraight(circle, point, onBoundary)

    const center = circleOf(this.#diagram.circles, circle)
    const toPoint = between(center, point)
    const size = largestOf(toPoint)
    const direction = size === 0 ? { x: 1, y: 0 } : measuredIn(powerOfTwoIn(size), toPoint)
    const ahead = Math.min(
      ...this.#bounds.corners.map((corner, k) => {
        const along = between(corner, this.#bounds.cornerAfter(k))
        const fall = -cross(along, direction)
        return fall > 0 ? Math.max(cross(along, between(corner, point)), 0) / fall : Infinity
      }),
    )
    const exit = exitOf(this.#diagram, circle, point)
    const isAhead = exit !== undefined && facing(direction, between(point, exit.point)) > 0
    const leaves = isAhead
      ? lengthOf(between(point, exit.point)) / lengthOf(direction)
      : exit === undefined
        ? Infinity
        : 0
    const part = this.#ofCell[circle]?.find(
      ({ edge, curve: { from, to } }) =>
        exit?.edge === edge && exit.parameter >= from * (1 - NEAR_EXIT) && exit.parameter <= to * (1 + NEAR_EXIT),
    )
    const reach = Math.min(leaves, ahead)
    const end =
      part !== undefined && leaves < ahead * (1 - NEAR_EXIT)
        ? stopOnEdge(part, exit?.parameter as number)
        : this.#stopOnBoundary(circle, { x: point.x + reach * direction.x, y: point.y + reach * direction.y })
    this.#addStraight(circle, point, end, true)
    return this.#nodeOf(point)
  }

  /** Returns the point of the boundary nearest to a point, as a stop: in a cell, if it has a point as near. */
  #stopOnBoundary(circle: number, point: Point): Point {
    const missOf = ({ curve: { start, end } }: Piece) => lengthOf(between(point, nearestOn(start, end, point)))
    const isOwn = (piece: Piece) => piece.circle === circle
    const piece = this.#pieces
      .filter(({ edge }) => edge === NONE)
      .reduce((one, other) => {
        const [miss, otherMiss] = [missOf(one), missOf(other)]
        return otherMiss < miss || (otherMiss === miss && isOwn(other) && !isOwn(one)) ? other : one
      })
    const { start, end } = piece.curve
    const stop = nearestOn(start, end, point)
    piece.stops.push({ place: dot(between(start, end), between(start, stop)), point: stop })
    return stop
  }

  /** Links the ends of pieces, and the stops between them. */
  link(): void {
    for (const { curve, edge, circle, stops } of this.#pieces) {
      const ends = stops.sort((one, other) => one.place - other.place)
      let last = { place: curve.from, point: curve.start }
      for (const next of [...ends, { place: curve.to, point: curve.end }]) {
        if (edge === NONE) this.#addStraight(circle, last.point, next.point)
        else
          this.#addArc(circle, edge, { ...curve, from: last.place, to: next.place, start: last.point, end: next.point })
        last = next
      }
    }
  }

  #addArc(circle: number, edge: number, curve: BoundedCurve): void {
    if (isSame(curve.start, curve.end)) return
    const { x, y } = pointOf(curve.bisector, Math.min(Math.max(1, curve.from), curve.to))
    const clearance = distanceFrom(this.#diagram, circle, x, y)
    this.#add({ curve, edge, clearance, length: curveLength(curve), isRay: false })
  }

  /** Adds a segment in a cell. */
  #addStraight(circle: number, start: Point, end: Point, isRay = false): void {
    if (isSame(start, end)) return
    const along = between(start, end)
    const size = lengthOf(along)
    const share = dot(measuredIn(size, along), between(start, circleOf(this.#diagram.circles, circle))) / size
    const within = Math.min(Math.max(share, 0), 1)
    const clearance = distanceFrom(this.#diagram, circle, start.x + within * along.x, start.y + within * along.y)
    this.#add({ curve: segment(start, end), edge: NONE, clearance, length: size, isRay })
  }

  #add(step: Omit<Link, 'nodes'>): void {
    const nodes = [this.#nodeOf(step.curve.start), this.#nodeOf(step.curve.end)] as const
    for (const node of nodes) this.#links[node]?.push({ ...step, nodes })
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
      links.push(isForward ? link : { ...link, curve: reversed(link.curve) })
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

/** Returns a new stop at a parameter of a part of an edge. */
function stopOnEdge({ curve, stops }: Piece, parameter: number): Point {
  if (parameter <= curve.from) return curve.start
  if (parameter >= curve.to) return curve.end
  const point = pointOf(curve.bisector, parameter)
  stops.push({ place: parameter, point })
  return point
}
