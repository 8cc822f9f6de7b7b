// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The Voronoi diagram of circles. Call `loadCircleVoronoi`, then `compute`, then the methods of `Diagram`. Less common
 * features are standalone functions. All examples begin with these two lines:
 *
 * ```js
 * const library = await loadCircleVoronoi()
 * const diagram = library.compute([[0, 0, 1], [6, 0, 1], [0, 8, 1]])
 * ```
 *
 * @module circle-voronoi
 */

export { REGION_LIMIT } from './base/coordinate-limits.ts'
export type { Accessor, Accessors, CircleLike, Circles } from './base/coordinates.ts'
export { circleAt, edgeAt, NONE, vertexAt } from './base/diagram-data.ts'
export { CircleVoronoiError, ERROR_CODES, type ErrorCode, type ErrorDetails } from './base/errors.ts'
export type {
  Box,
  Candidates,
  Certificate,
  Circle,
  Counts,
  DiagramData,
  Disposal,
  Edge,
  Flaw,
  Float64s,
  HiddenCircle,
  Int32s,
  Method,
  PathSink,
  Point,
  Seconds,
  SnapshotData,
  SnapshotNumbers,
  Stats,
  Vector,
  Vertex,
  Way,
} from './base/types.ts'
export { METRICS, type Metric } from './base/types.ts'
export {
  type CubicBezier,
  cubicBeziers,
  polyline,
  type RationalBezier,
  rationalBezier,
  traceArc,
} from './curves/bezier.ts'
export { type Bisector, bisector, parameterAt, pointAt } from './curves/bisector.ts'
export { type BoundedCurve, type EdgeCurve, edgeCurve, isBoundedCurve } from './curves/curve.ts'
export type { Change, EditWay } from './diagram/change.ts'
export type { ComputedDiagram } from './diagram/computed-diagram.ts'
export { type Cell, Diagram } from './diagram/diagram.ts'
export type { DiagramFile } from './diagram/diagram-file.ts'
export { DiagramSnapshot } from './diagram/diagram-snapshot.ts'
export { fromJSON } from './diagram/from-json.ts'
export { hiddenWarning } from './diagram/hidden-warning.ts'
export type { Lattice, Shift } from './diagram/lattice.ts'
export {
  type CircleImage,
  type ContactTable,
  type PeriodicData,
  PeriodicDiagram,
} from './diagram/periodic-diagram.ts'
export type { MultiPolygon } from './drawing/draw-clipped.ts'
export type {
  BoundsOptions,
  ContextOptions,
  DrawOptions,
  HullOptions,
  PolygonOptions,
  TextOptions,
} from './drawing/draw-options.ts'
export type { Polygon } from './drawing/polygon.ts'
export { SvgPath } from './drawing/svg-path.ts'
export { type ClearestPath, clearestPath } from './queries/clearest-path.ts'
export { largestEmptyDiscInside } from './queries/largest-disc-inside.ts'
export {
  type EmptyDisc,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscCenteredInHull,
} from './queries/largest-empty-disc.ts'
export { type MergedDiagram, mergeVertices } from './queries/merged.ts'
export { type ClosestPair, closestPair } from './queries/queries.ts'
export { Cells } from './regions/cells.ts'
export { clipCurve } from './regions/clip.ts'
export { type Bounds, type ConvexBoundsOptions, ConvexPolygon } from './regions/convex-polygon.ts'
export { convexHull, type Hull, type HullArc } from './regions/hull.ts'
export { outlineArea, outlineCentroid, outlinePerimeter } from './regions/measure.ts'
export type { Outline, OutlinePiece } from './regions/outline-piece.ts'
export type { Region } from './regions/region.ts'
export type { DiagramEditor, Edit, EditorMethods, EditorOptions } from './wasm/editor.ts'
export type { Verifiable } from './wasm/judged-arrays.ts'
export type { CircleVoronoi, FinalCells, Known } from './wasm/library.ts'
export type { LoadOptions } from './wasm/load-options.ts'
export { loadCircleVoronoi } from './wasm/loader.ts'
export type { Options, Progress, Stage } from './wasm/options.ts'
export {
  TRACE_KINDS,
  Trace,
  type TraceArrays,
  type TraceEvent,
  type TraceKind,
  type TraceOptions,
  type TraceState,
} from './wasm/trace.ts'
export type { CompiledWasm, WasmSource } from './wasm/wasm.ts'
