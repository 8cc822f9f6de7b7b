// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the parts inside a region, from the flat arrays of the module that clips.
import { at, NONE } from '../base/diagram-data.ts'
import type { DiagramData, PathSink, Point } from '../base/types.ts'
import { addArc } from '../curves/bezier.ts'
import { parameterOf } from '../curves/bisector.ts'
import { type BoundedCurve, curveOf, reversed, segment } from '../curves/curve.ts'
import { isCircleArc, traceCircleArc } from '../regions/circle-arc.ts'
import type { Outline, OutlinePiece } from '../regions/outline-piece.ts'
import type { ClippedCells, ClippedEdges, ClippedPolygons, Region } from '../regions/region.ts'

/**
 * The coordinates of a GeoJSON MultiPolygon: a list of polygons, each a list of closed rings that repeat their first
 * point. The first ring of a polygon is its outer ring, counter-clockwise; the others are holes, clockwise.
 *
 * @category Regions
 */
export type MultiPolygon = [x: number, y: number][][][]

/** Returns the outline of the kept part of the cell in a row. */
export function clippedOutline(
  diagram: DiagramData,
  [cells, row]: readonly [cells: ClippedCells, row: number],
): Outline {
  const loops: OutlinePiece[][] = []
  for (let loop = at(cells.loopOffsets, row); loop < at(cells.loopOffsets, row + 1); loop++) {
    loops.push(loopOf(diagram, cells, at(cells.pieceOffsets, loop), at(cells.pieceOffsets, loop + 1)))
  }
  return loops
}

/** Returns the sides that the cell in a row keeps in whole or in part. */
export function clippedSides([cells, row]: readonly [cells: ClippedCells, row: number]): ReadonlySet<number> {
  const [first, last] = [at(cells.loopOffsets, row), at(cells.loopOffsets, row + 1)]
  return new Set(cells.side.subarray(at(cells.pieceOffsets, first), at(cells.pieceOffsets, last)))
}

function loopOf(diagram: DiagramData, cells: ClippedCells, from: number, to: number): OutlinePiece[] {
  const pieces: OutlinePiece[] = []
  for (let k = from; k < to; k++) {
    const next = k + 1 < to ? k + 1 : from
    const start = { x: at(cells.x, k), y: at(cells.y, k) }
    const end = { x: at(cells.x, next), y: at(cells.y, next) }
    const side = at(cells.side, k)
    const isOfCell = side !== NONE
    pieces.push({
      curve: isOfCell ? sideBetween(diagram, side, start, end) : segment(start, end),
      side,
      neighbor: isOfCell ? at(diagram.edges, 4 * (side >> 1) + (1 - (side & 1))) : NONE,
      regionSide: at(cells.regionSide, k),
      r: at(cells.r, k),
    })
  }
  return pieces
}

/** Returns the part of a side between two of its points. */
function sideBetween(diagram: DiagramData, side: number, start: Point, end: Point): BoundedCurve {
  const isForward = side % 2 === 0
  const { bisector } = curveOf(diagram, side >> 1)
  const [first, last] = isForward ? [start, end] : [end, start]
  let [from, to] = [parameterOf(bisector, first.x, first.y), parameterOf(bisector, last.x, last.y)]
  // If rounding contradicts the order of the points, the part has length zero.
  if (from > to) from = to = Math.sqrt(from) * Math.sqrt(to)
  const curve = { bisector, from, to, start: first, end: last }
  return isForward ? curve : reversed(curve)
}

/** Draws an outline: a closed path for each loop. */
export function drawOutline(sink: PathSink, outline: Outline, tolerance: number): void {
  for (const loop of outline) {
    loop.forEach((piece, k) => {
      const { curve } = piece
      if (k === 0) sink.moveTo(curve.start.x, curve.start.y)
      if (isCircleArc(piece)) traceCircleArc(sink, piece)
      else addArc(sink, curve, tolerance)
    })
    sink.closePath()
  }
}

/** Draws the pieces of an outline that belong to one side. */
export function drawPiecesOf(sink: PathSink, outline: Outline, side: number, tolerance: number): void {
  for (const piece of outline.flat()) {
    if (piece.side !== side) continue
    sink.moveTo(piece.curve.start.x, piece.curve.start.y)
    addArc(sink, piece.curve, tolerance)
  }
}

/** Draws the parts of all edges inside. */
export function drawClippedEdges(sink: PathSink, diagram: DiagramData, parts: ClippedEdges, tolerance: number): void {
  parts.edge.forEach((edge, k) => {
    const start = { x: at(parts.start, 2 * k), y: at(parts.start, 2 * k + 1) }
    const end = { x: at(parts.end, 2 * k), y: at(parts.end, 2 * k + 1) }
    const { bisector } = curveOf(diagram, edge)
    sink.moveTo(start.x, start.y)
    addArc(sink, { bisector, from: at(parts.from, k), to: at(parts.to, k), start, end }, tolerance)
  })
}

/** Draws the rings of a region. */
export function drawRings(sink: PathSink, { points, ringOffsets }: Region): void {
  for (let ring = 0; ring + 1 < ringOffsets.length; ring++) {
    for (let k = at(ringOffsets, ring); k < at(ringOffsets, ring + 1); k++) {
      const [x, y] = [at(points, 2 * k), at(points, 2 * k + 1)]
      if (k === at(ringOffsets, ring)) sink.moveTo(x, y)
      else sink.lineTo(x, y)
    }
    sink.closePath()
  }
}

/** Draws polygons. */
export function drawPolygons(sink: PathSink, polygons: MultiPolygon): void {
  for (const ring of polygons.flat()) {
    ring.slice(0, -1).forEach(([x, y], k) => {
      if (k === 0) sink.moveTo(x, y)
      else sink.lineTo(x, y)
    })
    sink.closePath()
  }
}

/** Returns the polygons of a row, or `undefined` if it has none. */
export function multiPolygonOf(polygons: ClippedPolygons, row: number): MultiPolygon | undefined {
  const { polygonOffsets, ringOffsets } = polygons
  const [first, last] = [at(polygonOffsets, row), at(polygonOffsets, row + 1)]
  if (first === last) return undefined
  const parts: MultiPolygon = []
  for (let polygon = first; polygon < last; polygon++) {
    const rings: MultiPolygon[number] = []
    for (let ring = at(ringOffsets, polygon); ring < at(ringOffsets, polygon + 1); ring++) {
      rings.push(closedRing(polygons, ring))
    }
    parts.push(rings)
  }
  return parts
}

function closedRing({ pointOffsets, points }: ClippedPolygons, ring: number): MultiPolygon[number][number] {
  const [first, last] = [at(pointOffsets, ring), at(pointOffsets, ring + 1)]
  const result: MultiPolygon[number][number] = []
  for (let k = first; k < last; k++) result.push([at(points, 2 * k), at(points, 2 * k + 1)])
  result.push([at(points, 2 * first), at(points, 2 * first + 1)])
  return result
}
