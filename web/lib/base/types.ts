// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Numbers whose memory can be handed over to a worker: `Float64Array<ArrayBuffer>`, also before TypeScript 5.7.
 *
 * @category Diagrams
 */
export interface Float64s extends Float64Array {
  readonly buffer: ArrayBuffer
}

/**
 * Indices, likewise.
 *
 * @category Diagrams
 */
export interface Int32s extends Int32Array {
  readonly buffer: ArrayBuffer
}

/**
 * A circle with centre (x, y) and radius r >= 0; r = 0 is a point. As an additive weight (the option `weights`) r has any
 * sign. Mathematics is y-up.
 *
 * @category Diagrams
 */
export interface Circle {
  readonly x: number
  readonly y: number
  readonly r: number
}

/**
 * A Voronoi vertex: the centre of the disc that touches its three circles from outside. `r` is signed: it is
 * negative where the three circles overlap.
 *
 * @category Diagrams
 */
export interface Vertex {
  readonly x: number
  readonly y: number
  readonly r: number
}

/**
 * An arc of the bisector of circles `left` and `right`, as seen when going from vertex `start` to vertex `end`; an end
 * at infinity is `NONE`. Two circles may share several edges.
 *
 * @category Diagrams
 */
export interface Edge {
  readonly left: number
  readonly right: number
  readonly start: number
  readonly end: number
}

/**
 * A circle without a cell, and a circle that contains it and is not hidden itself: of several the largest, of equal ones
 * the first.
 *
 * @category Diagrams
 */
export interface HiddenCircle {
  readonly circle: number
  readonly by: number
}

/**
 * The outcome of judging a diagram: a proof that it is the Voronoi diagram, or the first thing that is wrong.
 *
 * @category Diagrams
 */
export interface Certificate {
  readonly certified: boolean
  /** The first flaw by the name of the C++ enumeration `Flaw` (circle_voronoi/certificate.h); `none` if certified. */
  readonly flaw: string
  /** The circle concerned, or `NONE`. */
  readonly circle: number
  /** The vertex concerned, or `NONE`. */
  readonly vertex: number
  /** The edge concerned, or `NONE`. */
  readonly edge: number
  /** One sentence; empty if certified. */
  readonly message: string
}

/**
 * How much each stage had to do.
 *
 * @category Diagrams
 */
export interface Counts {
  /** Input circles. */
  readonly circles: number
  /** Of these, hidden ones. */
  readonly hidden: number
  /** Sample points on circles. */
  readonly samples: number
  /** Candidate pairs, each with one antipodal disc. */
  readonly antipodalDiscs: number
  /** Three-touch discs formed. */
  readonly threeTouchDiscs: number
  /** Discs taken from the queue. */
  readonly events: number
  /** Cycles of leftover directed edges; 1 in a right diagram of two circles or more. */
  readonly leftoverCycles: number
  /** How often the touching disc method took more samples and tried again. */
  readonly resamplings: number
  /** Edges flipped. */
  readonly flips: number
  /** Places where a local diagram was spliced in. */
  readonly repairs: number
  /** Predicates decided in floating point, with an error bound. */
  readonly filtered: number
  /** Predicates decided so with twice the digits: near ties. */
  readonly refined: number
  /** Predicates decided by the exact in-circle test of centres (equal radii). */
  readonly inCircle: number
  /** Predicates decided in full integer arithmetic. */
  readonly exact: number
}

/**
 * Wall-clock seconds of each stage.
 *
 * @category Diagrams
 */
export interface Seconds {
  /** Ordering, finding hidden circles, and the Delaunay triangulation of the centers. */
  readonly triangulate: number
  readonly sample: number
  readonly pair: number
  readonly touch: number
  readonly flip: number
  readonly repair: number
  readonly certify: number
  readonly total: number
}

/**
 * How a diagram came about.
 *
 * @category Diagrams
 */
export interface Stats {
  /** The method asked for. */
  readonly method: string
  /** The construction that made the result: `flip`, `repair`, `insert`, `touching-disc` or `apollonius-graph`. */
  readonly way: string
  /** The candidates of the touching disc method, or empty. */
  readonly candidates: string
  readonly counts: Counts
  readonly seconds: Seconds
}

/**
 * What the indices of a snapshot of an editor stand for.
 *
 * @category Diagrams
 */
export interface SnapshotNumbers {
  /** How many changes the editor had made. */
  readonly revision: number
  /** For each circle its id. */
  readonly circles: Int32s
  /** For each vertex its number. */
  readonly vertices: Int32s
  /** For each edge its number. */
  readonly edges: Int32s
  /**
   * For each hidden circle the id of the one that the editor keeps it with: a visible one that contains it. Only until a change is
   * applied: then `hidden` says it.
   */
  readonly hiders?: Int32s
}

/**
 * The Voronoi diagram of n circles, by indices into flat arrays. Plain data: it can be posted to and from a worker, and
 * `new Diagram(data)` gives it its methods back.
 *
 * A vertex that touches more than three circles appears as several vertices joined by edges of length zero, so every
 * vertex has exactly three circles and three edges.
 *
 * An edge seen from one of its two cells is a *side* of that cell: a half-edge. Side 2 e of edge e belongs to the left
 * circle and runs from start to end; side 2 e + 1, its twin, belongs to the right circle and runs back. So every side has
 * its own cell on its left, and the sides of a cell run counter-clockwise around it.
 *
 * @category Diagrams
 */
export interface DiagramData {
  /** The distance that makes the cells. */
  readonly metric: Metric
  /** Whether the radii are additive weights of any sign: the option `weights`. */
  readonly weights: boolean
  /** Three per circle: x, y, r, in input order. */
  readonly circles: Float64s
  /** Three per vertex: x, y, r. */
  readonly vertices: Float64s
  /** Three per vertex: its circles, counter-clockwise. */
  readonly vertexCircles: Int32s
  /** Four per edge: left, right, start, end. */
  readonly edges: Int32s
  /** Two per hidden circle: circle, by; in increasing order of `circle`. */
  readonly hidden: Int32s
  /** The circles on the convex hull, counter-clockwise; a circle recurs if the hull touches it more than once. */
  readonly hull: Int32s
  /**
   * Two per edge: for each side the one that follows it around its cell. Where the cell goes to infinity, the next side
   * after one that ends there begins there.
   */
  readonly nextSide: Int32s
  /** Three per vertex: the sides that begin there, the first of the first of its circles, and so on. */
  readonly vertexSides: Int32s
  /** For each circle the smallest of its sides; `NONE` if it has no cell, or its cell is the whole plane. */
  readonly firstSide: Int32s
  readonly certificate: Certificate
  readonly stats: Stats
  /** Of a snapshot of an editor: what its circles, vertices and edges are called in changes. */
  readonly numbers?: SnapshotNumbers
}

/**
 * A point of the plane; mathematics is y-up, and counter-clockwise is positive.
 *
 * @category Diagrams
 */
export interface Point {
  readonly x: number
  readonly y: number
}

/**
 * A difference of points, or a direction of any length.
 *
 * @category Diagrams
 */
export interface Vector {
  readonly x: number
  readonly y: number
}

/**
 * The distance from circle (c, r) to a point p that makes a diagram: a point belongs to the cell of the circle of smallest
 * distance.
 * - `circles`: |p - c| - r, negative inside: the Voronoi diagram of circles;
 * - `centers`: |p - c|: the ordinary Voronoi diagram of the centres;
 * - `power`: |p - c|^2 - r^2: the power (Laguerre) diagram.
 *
 * @category Diagrams
 */
export type Metric = (typeof METRICS)[number]

/**
 * Their names.
 *
 * @category Diagrams
 * @example
 * METRICS // [ 'circles', 'centers', 'power' ]
 */
export const METRICS = ['circles', 'centers', 'power'] as const

/**
 * An axis-parallel rectangle, minX < maxX and minY < maxY.
 *
 * @category Cells
 */
export interface Box {
  readonly minX: number
  readonly minY: number
  readonly maxX: number
  readonly maxY: number
}

/**
 * `dispose` for `using`, to compilers that know it.
 *
 * @category Editing
 */
export type Disposal = SymbolConstructor extends { readonly dispose: infer Key extends symbol }
  ? Record<Key, () => void>
  : unknown

/**
 * What curves are drawn on: the part of `CanvasRenderingContext2D` and `Path2D` that is used.
 *
 * @category Drawing
 */
export interface PathSink {
  /** Begins a part of the path at (x, y). */
  moveTo(x: number, y: number): void
  /** A segment to (x, y). */
  lineTo(x: number, y: number): void
  /** A cubic Bezier curve to (x, y), with two control points. */
  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void
  /** An arc of a circle, by growing angles in radians, or by falling ones if `counterclockwise`. */
  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise?: boolean): void
  /** A segment back to where the part began. */
  closePath(): void
}
