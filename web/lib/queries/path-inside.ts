// SPDX-License-Identifier: GPL-3.0-or-later
import { COORDINATE_STEP } from '../base/coordinate-limits.ts'
import { circleOf, NONE } from '../base/diagram-data.ts'
import { distanceFrom } from '../base/metric.ts'
import { between, cross, dot } from '../base/point.ts'
import { facing, largestOf, lengthOf, measuredIn, turn } from '../base/scale.ts'
import type { Circle, Point, Vector } from '../base/types.ts'
import { pointOf } from '../curves/bisector.ts'
import { type BoundedCurve, reversed, segment } from '../curves/curve.ts'
import type { Diagram } from '../diagram/diagram.ts'
import { isSame, LineCrossing } from '../regions/clip.ts'
import { lengthOfPiece } from '../regions/measure.ts'
import type { Outline } from '../regions/outline-piece.ts'
import type { ClearestPath } from './clearest-path.ts'
import { Heap } from './heap.ts'

/** The relative error of points on curves. */
const SLACK = 1e-9

/** A piece of the outline of a cell: a part of an edge, in the direction of the edge, or a part of the boundary. */
interface Piece {
  readonly curve: BoundedCurve
  /** The edge, or `NONE` on the boundary. */
  readonly edge: number
  readonly circle: number
  readonly hits: Hit[]
}

/** The point where a ray meets a piece, as a parameter of an edge or a fraction of a segment. */
interface Hit {
  readonly piece: Piece
  readonly place: number
  readonly point: Point
}

/** A step from one node to another. */
interface Link {
  readonly nodes: readonly [number, number]
  readonly curve: BoundedCurve
  readonly edge: number
  readonly clearance: number
  readonly length: number
}

/**
 * Finds the clearest path from `p` to `q` inside the outlines of all cells; `undefined` if no path exists. If several
 * paths are equally clear, it is the shortest along edges and boundary.
 *
 * Moving straight away from the nearest center never loses clearance and leads to an edge or the boundary. So some
 * clearest path follows edges and boundary, with one exception. Where the ray from the center passes a corner of the
 * region inside the cell, the end of the ray jumps, and the path may follow the ray.
 */
export function pathInside(
  diagram: Diagram,
  p: Point,
  q: Point,
  outlines: readonly Outline[],
): ClearestPath | undefined {
  const graph = new Graph(diagram, outlines)
  const ends = [p, q].map((point) => graph.shoot(diagram.find(point.x, point.y), point, -SLACK))
  const [from, to] = ends
  if (from === undefined || to === undefined) return undefined
  graph.link()
  const route = graph.route(from.point, to.point)
  if (route === undefined) return undefined
  const clearanceAt = (point: Point) => distanceFrom(diagram, diagram.find(point.x, point.y), point.x, point.y)
  const legs = [segmentsOf(p, from.point), route.map(({ curve }) => curve), segmentsOf(to.point, q)]
  return {
    clearance: Math.min(clearanceAt(p), clearanceAt(q), ...route.map(({ clearance }) => clearance)),
    edges: Int32Array.from(route.flatMap(({ edge }) => (edge === NONE ? [] : [edge]))),
    entry: from.point,
    exit: to.point,
    curves: legs.flat(),
  }
}

function segmentsOf(start: Point, end: Point): BoundedCurve[] {
  return isSame(start, end) ? [] : [segment(start, end)]
}

class Graph {
  readonly #diagram: Diagram
  readonly #nodes = new Map<string, number>()
  readonly #links: Link[][] = []
  readonly #pieces: Piece[] = []
  readonly #ofCell = new Map<number, Piece[]>()

  constructor(diagram: Diagram, outlines: readonly Outline[]) {
    this.#diagram = diagram
    const ofEdges = new Map<string, Piece>()
    outlines.forEach((outline, circle) => {
      const own: Piece[] = []
      for (const { curve, side } of outline.flat()) {
        const forward = side !== NONE && side % 2 === 1 ? reversed(curve) : curve
        // Both cells of an edge have the same piece.
        const key = `${side >> 1} ${forward.start.x} ${forward.start.y}`
        let piece = side === NONE ? undefined : ofEdges.get(key)
        if (piece === undefined) {
          piece = { curve: forward, edge: side === NONE ? NONE : side >> 1, circle, hits: [] }
          this.#pieces.push(piece)
          if (side !== NONE) ofEdges.set(key, piece)
        }
        own.push(piece)
      }
      this.#ofCell.set(circle, own)
    })
    outlines.forEach((outline, circle) => {
      for (const loop of outline) {
        loop.forEach((piece, k) => {
          const before = loop.at(k - 1)
          if (piece.side === NONE && before?.side === NONE) this.#passCorner(circle, before.curve, piece.curve)
        })
      }
    })
  }

  /** Adds the ray from a center past a corner of the region inside its cell. */
  #passCorner(circle: number, before: BoundedCurve, after: BoundedCurve): void {
    const corner = after.start
    const along = between(before.start, before.end)
    const onward = between(after.start, after.end)
    const ray = between(circleOf(this.#diagram.circles, circle), corner)
    if (!(turn(along, onward) < 0) || !(turn(along, ray) > 0 || turn(onward, ray) > 0)) return
    const hit = this.shoot(circle, corner, SLACK)
    if (hit === undefined) return
    this.#add(segment(corner, hit.point), NONE, distanceFrom(this.#diagram, circle, corner.x, corner.y))
  }

  /**
   * Follows the ray from a circle's center through `from`, from there to its exit from the cell or the region. `least`
   * is the smallest distance to the exit, as a share of the distance of `from` from the center.
   */
  shoot(circle: number, from: Point, least: number): Hit | undefined {
    const center = circleOf(this.#diagram.circles, circle)
    const toPoint = between(center, from)
    const isCenter = largestOf(toPoint) < COORDINATE_STEP
    const direction = isCenter ? { x: 1, y: 0 } : measuredIn(lengthOf(toPoint), toPoint)
    let first: Hit | undefined
    let nearest = Infinity
    for (const piece of this.#ofCell.get(circle) ?? []) {
      for (const { place, point } of crossingsOf(piece, center, direction)) {
        const ahead = dot(direction, between(from, point))
        const scale = lengthOf(between(center, point))
        if (ahead >= least * scale && ahead < nearest) {
          nearest = ahead
          first = { piece, place, point }
        }
      }
    }
    first?.piece.hits.push(first)
    return first
  }

  /** Links the ends of pieces, and the hits of rays between them. */
  link(): void {
    for (const { curve, edge, circle, hits } of this.#pieces) {
      const isEdge = edge !== NONE
      const sorted = hits.sort((one, other) => one.place - other.place)
      const ends = [...sorted, { place: isEdge ? curve.to : 1, point: curve.end }]
      let last = { place: isEdge ? curve.from : 0, point: curve.start }
      for (const next of ends) {
        if (!isSame(last.point, next.point)) {
          const part = isEdge
            ? { bisector: curve.bisector, from: last.place, to: next.place, start: last.point, end: next.point }
            : segment(last.point, next.point)
          this.#add(part, edge, this.#clearanceOf(part, isEdge, circle))
        }
        last = next
      }
    }
  }

  /** Returns the least distance from a circle along a curve. */
  #clearanceOf({ bisector, from, to, start, end }: BoundedCurve, isEdge: boolean, circle: number): number {
    if (isEdge) {
      const { x, y } = pointOf(bisector, Math.min(Math.max(1, from), to))
      return distanceFrom(this.#diagram, circle, x, y)
    }
    const along = between(start, end)
    const size = lengthOf(along)
    const share = dot(measuredIn(size, along), between(start, circleOf(this.#diagram.circles, circle))) / size
    const within = Math.min(Math.max(share, 0), 1)
    return distanceFrom(this.#diagram, circle, start.x + within * along.x, start.y + within * along.y)
  }

  #add(curve: BoundedCurve, edge: number, clearance: number): void {
    const nodes = [this.#nodeOf(curve.start), this.#nodeOf(curve.end)] as const
    const link = { nodes, curve, edge, clearance, length: lengthOfPiece({ curve, side: edge, neighbor: NONE, r: 0 }) }
    for (const node of nodes) this.#links[node]?.push(link)
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

  /** Returns the shortest of the clearest routes between two points. */
  route(from: Point, to: Point): Link[] | undefined {
    const [start, goal] = [this.#nodeOf(from), this.#nodeOf(to)]
    const clearest = this.#best(start, Infinity, (clearance, link) => Math.min(clearance, link.clearance))
    const clearance = clearest.keys[goal] as number
    if (!(clearance > -Infinity)) return undefined
    const { keys: _, by } = this.#best(start, 0, (length, link) =>
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

/** Returns the points where the ray from a center meets a piece. */
function crossingsOf(
  { curve, edge }: Piece,
  center: Circle,
  direction: Vector,
): { readonly place: number; readonly point: Point }[] {
  const { bisector, from, to, start, end } = curve
  if (edge !== NONE) {
    return new LineCrossing(bisector, center, direction).parameters.flatMap((s) => {
      const place = Math.min(Math.max(s, from), to)
      const point = place === from ? start : place === to ? end : pointOf(bisector, place)
      const isNear = s >= from * (1 - SLACK) && s <= to * (1 + SLACK)
      return isNear && facing(direction, between(center, point)) > 0 ? [{ place, point }] : []
    })
  }
  const along = between(start, end)
  const share = cross(direction, between(start, center)) / cross(direction, along)
  const place = Math.min(Math.max(share, 0), 1)
  if (!(Math.abs(share - place) <= SLACK)) return []
  const point = place === 0 ? start : place === 1 ? end : { x: start.x + place * along.x, y: start.y + place * along.y }
  return facing(direction, between(center, point)) > 0 ? [{ place, point }] : []
}
