// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The Voronoi diagram of circles: `loadCircleVoronoi`, then `compute`, then the methods of `Diagram`. What is not needed
 * for every diagram is a function of its own. In the examples, `library` and `diagram` are those of these two lines.
 *
 * ```js
 * const library = await loadCircleVoronoi()
 * const diagram = library.compute([[0, 0, 1], [6, 0, 1], [0, 8, 1]])
 * ```
 *
 * @module circle-voronoi
 */
export {
  bezierPointAt,
  type CubicBezier,
  cubicBeziers,
  polyline,
  type RationalBezier,
  rationalBezier,
  traceArc,
} from './bezier.ts'
export { type Bisector, bisector, parameterAt, pointAt } from './bisector.ts'
export { Cells } from './cells.ts'
export type { Change, EditWay } from './change.ts'
export { type ClearestPath, clearestPath } from './clearest-path.ts'
export { clip } from './clip.ts'
export { type Bounds, type Box, ConvexPolygon } from './convex-polygon.ts'
export { REGION_LIMIT } from './coordinate-limits.ts'
export type { Accessor, CircleLike, Circles } from './coordinates.ts'
export { type BoundedCurve, type EdgeCurve, edgeCurve, isBoundedCurve } from './curve.ts'
export { type Cell, Diagram } from './diagram.ts'
export {
  type Certificate,
  type Circle,
  type Counts,
  circleAt,
  type DiagramData,
  type Edge,
  edgeAt,
  type Float64s,
  type HiddenCircle,
  type Int32s,
  NONE,
  type Seconds,
  type SnapshotNumbers,
  type Stats,
  type Vertex,
  vertexAt,
} from './diagram-data.ts'
export type { DiagramFile } from './diagram-file.ts'
export type { Disposal } from './disposal.ts'
export type { BoundsOptions, ContextOptions, DrawOptions, PolygonOptions, TextOptions } from './draw-options.ts'
export type { DiagramEditor, Edit, EditorMethods } from './editor.ts'
export { CircleVoronoiError, ERROR_CODES, type ErrorCode } from './errors.ts'
export { exportBox } from './export-box.ts'
export { convexHull, type Hull, type HullArc } from './hull.ts'
export type { Verifiable } from './judged-arrays.ts'
export { largestEmptyDiscInside } from './largest-disc-inside.ts'
export { type EmptyDisc, largestEmptyDiscCenteredIn, largestEmptyDiscCenteredInHull } from './largest-empty-disc.ts'
export type { CircleVoronoi, FinalCells, Known } from './library.ts'
export type { LoadOptions } from './load-options.ts'
export { loadCircleVoronoi } from './loader.ts'
export { arcLength, area, centroid, perimeter } from './measure.ts'
export { type MergedDiagram, mergeVertices } from './merged.ts'
export { distance, METRICS, type Metric } from './metric.ts'
export type { Options, Progress, Stage } from './options.ts'
export { type Outline, type OutlinePiece, outline } from './outline.ts'
export type { PathSink } from './path-sink.ts'
export type { Point, Vector } from './point.ts'
export type { Polygon } from './polygon.ts'
export { type ClosestPair, closestPair, neighborPairs } from './queries.ts'
export { SvgPath } from './svg-path.ts'
export {
  TRACE_KINDS,
  Trace,
  type TraceArrays,
  type TraceEvent,
  type TraceKind,
  type TraceOptions,
  type TraceState,
} from './trace.ts'
export type { CompiledWasm, WasmSource } from './wasm.ts'
