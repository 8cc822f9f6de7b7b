// SPDX-License-Identifier: GPL-3.0-or-later
export {
  type Bisector,
  bisector,
  type Point,
  parameterAt,
  pointAt,
  type Range,
  type RationalBezier,
  rationalBezier,
  traceArc,
} from './bisector.ts'
export { Cells } from './cells.ts'
export {
  at,
  type Certificate,
  type Circle,
  type Counts,
  circleAt,
  type Diagram,
  type Edge,
  edgeAt,
  type HiddenCircle,
  NONE,
  type Seconds,
  type Stats,
  type Vertex,
  vertexAt,
} from './diagram.ts'
export { type Box, traceCell, traceEdge } from './draw.ts'
export { CircleVoronoiError, ERROR_CODES, type ErrorCode } from './errors.ts'
export { type CircleVoronoi, type LoadOptions, loadCircleVoronoi, type Options } from './loader.ts'
export type { PathSink } from './path-sink.ts'
