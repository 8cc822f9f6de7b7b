// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a claimed diagram, right or wrong: its listed edges and vertices, and the part that the judge rejects.
import {
  type Certificate,
  clipCurve,
  type DiagramData,
  edgeCurve,
  isBoundedCurve,
  NONE,
  type Point,
  polyline,
} from '../lib/index.ts'
import type { DataLayer } from '../view/layers.ts'

/** Colors that are visible on light and on dark paper. */
const LINES = '#7a8594'
const MARK = '#d2491b'
/** Unbounded edges are drawn this far beyond circles and vertices, as a multiple of their extent. */
const REACH = 3
/** Distance of a chord from its curve, as a part of the extent. */
const TOLERANCE = 1e-3

/** A part of a diagram to mark; each list has indices. */
export interface Marked {
  readonly circles: readonly number[]
  readonly vertices: readonly number[]
  readonly edges: readonly number[]
}

/** Returns the edges and vertices of a diagram at the places that it lists. */
export function claimedLayer(diagram: DiagramData): DataLayer {
  const count = diagram.edges.length / 4
  const segments = segmentsOf(
    diagram,
    Array.from({ length: count }, (_, e) => e),
  )
  const points = diagram.vertices.filter((_, k) => k % 3 < 2)
  return { id: 'claimed', color: LINES, segments, points }
}

/** Returns marks on vertices with their discs, on circles, and on edges. */
export function markedLayer(diagram: DiagramData, { circles, vertices, edges }: Marked): DataLayer {
  const discs = [
    ...circles.flatMap((i) => [...diagram.circles.subarray(3 * i, 3 * i + 3)]),
    ...vertices.flatMap((v) => [...diagram.vertices.subarray(3 * v, 3 * v + 3)]),
  ]
  const points = vertices.flatMap((v) => [...diagram.vertices.subarray(3 * v, 3 * v + 2)])
  return {
    id: 'marked',
    color: MARK,
    discs: Float64Array.from(discs),
    points: Float64Array.from(points),
    segments: segmentsOf(diagram, edges),
  }
}

/** Returns a vertex and the circles that it is claimed to touch. */
export function markedVertex({ vertexCircles }: DiagramData, vertex: number): Marked {
  return { circles: [...vertexCircles.subarray(3 * vertex, 3 * vertex + 3)], vertices: [vertex], edges: [] }
}

/** Returns the part of a diagram that its certificate rejects. */
export function flawOf(diagram: DiagramData, { flaw, circle, vertex, edge }: Certificate): Marked {
  const { edges, hidden } = diagram
  if (edge !== NONE) return { circles: [...edges.subarray(4 * edge, 4 * edge + 2)], vertices: [], edges: [edge] }
  if (vertex !== NONE) return markedVertex(diagram, vertex)
  if (flaw === 'eulerCount') return { circles: circlesWithoutCell(diagram), vertices: [], edges: [] }
  if (circle === NONE) return { circles: [], vertices: [], edges: [] }
  const hiders = pairsOf(hidden).flatMap(([inner, by]) => (inner === circle ? [by] : []))
  return { circles: [circle, ...hiders], vertices: [], edges: [] }
}

/** Returns the circles that have neither an edge nor a hider. */
function circlesWithoutCell({ circles, edges, hidden }: DiagramData): number[] {
  const placed = new Set<number>(pairsOf(hidden).map(([inner]) => inner))
  for (let k = 0; k < edges.length; k += 4) placed.add(edges[k] as number).add(edges[k + 1] as number)
  return Array.from({ length: circles.length / 3 }, (_, i) => i).filter((i) => !placed.has(i))
}

function pairsOf(list: Int32Array): (readonly [number, number])[] {
  return Array.from({ length: list.length / 2 }, (_, k) => [list[2 * k] as number, list[2 * k + 1] as number] as const)
}

function segmentsOf(diagram: DiagramData, edges: readonly number[]): Float64Array {
  const { box, size } = extentOf(diagram)
  const reach = REACH * size
  const bounds = { minX: box.minX - reach, minY: box.minY - reach, maxX: box.maxX + reach, maxY: box.maxY + reach }
  const segments: number[] = []
  for (const e of edges) {
    const curve = edgeCurve(diagram, e)
    for (const arc of isBoundedCurve(curve) ? [curve] : clipCurve(curve, { bounds })) {
      // A straight line joins ends that are not on the bisector.
      const isArc = [arc.start, arc.end].every((end) => isBetween(diagram, e, end, TOLERANCE * size))
      const points = isArc ? polyline(arc, TOLERANCE * size) : [arc.start, arc.end]
      for (const [k, { x, y }] of points.entries()) {
        const before = points[k - 1]
        if (before !== undefined) segments.push(before.x, before.y, x, y)
      }
    }
  }
  return Float64Array.from(segments)
}

/** Whether a point is equally far from both circles of an edge. */
function isBetween({ circles, edges }: DiagramData, edge: number, point: Point, tolerance: number): boolean {
  const [left, right] = [0, 1].map((side) => {
    const [x = 0, y = 0, r = 0] = circles.subarray(3 * (edges[4 * edge + side] as number))
    return Math.hypot(point.x - x, point.y - y) - r
  }) as [number, number]
  return Math.abs(left - right) <= tolerance
}

function extentOf({ circles, vertices }: DiagramData) {
  const along = (axis: number) => [...circles, ...vertices].filter((_, k) => k % 3 === axis)
  const [xs, ys] = [along(0), along(1)]
  const box = { minX: Math.min(...xs), minY: Math.min(...ys), maxX: Math.max(...xs), maxY: Math.max(...ys) }
  return { box, size: Math.max(box.maxX - box.minX, box.maxY - box.minY) }
}
