// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * A `Float64Array` whose memory can be transferred to a worker: `Float64Array<ArrayBuffer>`, also before TypeScript
 * 5.7.
 *
 * @category Diagrams
 */
export interface Float64s extends Float64Array {
  readonly buffer: ArrayBuffer
}

/**
 * An `Int32Array` whose memory can be transferred to a worker.
 *
 * @category Diagrams
 */
export interface Int32s extends Int32Array {
  readonly buffer: ArrayBuffer
}

/**
 * A circle with center (x, y) and radius r >= 0; a circle with r = 0 is a point. As an additive weight (the option
 * `weights`), r may have any sign. The y axis points up.
 *
 * @category Diagrams
 */
export interface Circle {
  readonly x: number
  readonly y: number
  readonly r: number
}

/**
 * A Voronoi vertex: the center and radius of the disc that touches three circles from outside. The radius `r` is
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
 * An edge: an arc of the bisector of the circles `left` and `right`, as seen on the way from vertex `start` to vertex
 * `end`. An end at infinity is `NONE`. Two circles may share several edges.
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
 * A hidden circle, which has no cell, and the largest visible circle that contains it. Among equal circles, it is the
 * first.
 *
 * @category Diagrams
 */
export interface HiddenCircle {
  readonly circle: number
  readonly by: number
}

/**
 * The first reason why a diagram is not certified, named as in the C++ enumeration `Flaw` (circle_voronoi/certificate.h).
 *
 * - `none`: the diagram is correct
 * - `notJudged`: the diagram has not been checked
 * - `badIndex`: an index is out of range, or a vertex, an edge or the hull names a circle twice or a hidden circle
 * - `hiddenWithoutHider`: the circle that is named as the hider of a hidden circle does not contain it
 * - `adjacency`: edges, vertices and hull do not fit together
 * - `eulerCount`: the numbers of vertices and hull circles contradict Euler's formula
 * - `vertexWithoutDisc`: no disc touches the three circles of a vertex in that order
 * - `vertexMisplaced`: the disc that touches the three circles of a vertex lies elsewhere
 * - `edgeOutOfOrder`: the ends of an edge are in the wrong order along their bisector
 * - `cellNotClosed`: the edges of a cell do not turn exactly once around its circle
 * - `hullNotClosed`: the tangent lines of the hull do not turn exactly once
 *
 * @category Diagrams
 */
export type Flaw =
  | 'none'
  | 'notJudged'
  | 'badIndex'
  | 'hiddenWithoutHider'
  | 'adjacency'
  | 'eulerCount'
  | 'vertexWithoutDisc'
  | 'vertexMisplaced'
  | 'edgeOutOfOrder'
  | 'cellNotClosed'
  | 'hullNotClosed'

/**
 * The result of checking a diagram: a proof that it is the Voronoi diagram, or the first flaw.
 *
 * @category Diagrams
 */
export interface Certificate {
  readonly certified: boolean
  /** The first flaw; `none` if the diagram is certified. */
  readonly flaw: Flaw
  /** The circle with the flaw, or `NONE`. */
  readonly circle: number
  /** The vertex with the flaw, or `NONE`. */
  readonly vertex: number
  /** The edge with the flaw, or `NONE`. */
  readonly edge: number
  /** A sentence that describes the flaw; empty if the diagram is certified. */
  readonly message: string
}

/**
 * Counters of the work that each stage did.
 *
 * @category Diagrams
 */
export interface Counts {
  /** Number of input circles. */
  readonly circles: number
  /** Number of hidden circles. */
  readonly hidden: number
  /** Number of sample points on circles. */
  readonly samples: number
  /** Number of candidate pairs, each with one antipodal disc. */
  readonly antipodalDiscs: number
  /** Number of three-touch discs formed. */
  readonly threeTouchDiscs: number
  /** Number of discs taken from the queue. */
  readonly events: number
  /** Number of cycles of leftover directed edges; 1 in a correct diagram of two or more circles. */
  readonly leftoverCycles: number
  /** Number of times that the touching disc method added samples and started again. */
  readonly resamplings: number
  /** Number of edge flips. */
  readonly flips: number
  /** Number of places where a locally computed diagram was spliced in. */
  readonly repairs: number
  /** Number of predicates decided in floating point with an error bound. */
  readonly filtered: number
  /** Number of predicates decided with twice the digits, because they were nearly ties. */
  readonly refined: number
  /** Number of predicates decided by the exact in-circle test of centers (equal radii). */
  readonly inCircle: number
  /** Number of predicates decided in exact integer arithmetic. */
  readonly exact: number
}

/**
 * Wall-clock time of each stage in seconds.
 *
 * @category Diagrams
 */
export interface Seconds {
  /** Checking the circles, and bringing them into spatial order. */
  readonly order: number
  /** Finding hidden circles, and the Delaunay triangulation of the centers. */
  readonly triangulate: number
  readonly sample: number
  readonly pair: number
  readonly touch: number
  readonly flip: number
  readonly repair: number
  readonly certify: number
  /** Assembling vertices, edges, hull and links from the certified dual. */
  readonly assemble: number
  readonly total: number
}

/** The names of the methods, candidates and ways, in the order of the C++ enumerations (circle_voronoi/method.h). */
export const METHODS = ['auto', 'touching-disc', 'flip'] as const
export const CANDIDATES = ['dynamic', 'uniform', 'all-pairs'] as const
export const WAYS = ['flip', 'repair', 'insert', 'touching-disc', 'edit'] as const

/**
 * A construction method. `auto`: the fastest construction that leads to a certified diagram. `touching-disc`: the method
 * of the paper, candidate pairs followed by the event loop. `flip`: edge flips that start from the Delaunay
 * triangulation of the centers. The last two may give a wrong diagram; its certificate says so.
 *
 * @category Loading
 */
export type Method = (typeof METHODS)[number]

/**
 * The pairs of circles that get an antipodal disc in the touching disc method: neighbors in the Delaunay graph of
 * dynamically chosen samples (`dynamic`) or of equally spaced samples (`uniform`), or all pairs (`all-pairs`).
 *
 * @category Loading
 */
export type Candidates = (typeof CANDIDATES)[number]

/**
 * The construction that produced a diagram: edge flips (`flip`), flips and locally computed diagrams (`repair`),
 * insertion of one circle after the other (`insert`), the touching disc method (`touching-disc`), or an editor (`edit`).
 *
 * @category Diagrams
 */
export type Way = (typeof WAYS)[number]

/**
 * Statistics of a computation. A name is empty if it does not apply or is not known.
 *
 * @category Diagrams
 */
export interface Stats {
  /** The requested method. */
  readonly method: Method | ''
  /** The construction that produced the result. */
  readonly way: Way | ''
  /** The kind of candidates of the touching disc method; empty for other methods. */
  readonly candidates: Candidates | ''
  readonly counts: Counts
  readonly seconds: Seconds
}

/**
 * The ids and numbers that an editor uses for the circles, vertices and edges of a snapshot.
 *
 * @category Editing
 */
export interface SnapshotNumbers {
  /** The number of changes that the editor had made. */
  readonly revision: number
  /** The id of each circle. */
  readonly circles: Int32s
  /** The number of each vertex in changes. */
  readonly vertices: Int32s
  /** The number of each edge in changes. */
  readonly edges: Int32s
  /**
   * For each hidden circle the id of a visible circle that contains it, as the editor stores it. Present only until the
   * first change is applied; from then on `hidden` contains this circle.
   */
  readonly hiders?: Int32s
}

/**
 * The Voronoi diagram of n circles as flat arrays with indices. It is plain data that can be posted to and from a
 * worker; `new Diagram(data)` adds the methods.
 *
 * A vertex that touches more than three circles appears as several vertices joined by edges of length zero. So every
 * vertex has exactly three circles and three edges.
 *
 * A *side* (half-edge) is an edge seen from one of its two cells. Side 2 e of edge e belongs to the left circle and
 * runs from start to end. Its twin, side 2 e + 1, belongs to the right circle and runs back. So every side has its own
 * cell on its left, and the sides of a cell run counter-clockwise around it.
 *
 * @category Diagrams
 */
export interface DiagramData {
  /** The metric that defines the cells. */
  readonly metric: Metric
  /** Whether the radii are additive weights of any sign (the option `weights`). */
  readonly weights: boolean
  /** Three numbers for each circle, in input order: x, y, r. */
  readonly circles: Float64s
  /** Three numbers for each vertex: x, y, r. */
  readonly vertices: Float64s
  /** Three circles for each vertex, counter-clockwise. */
  readonly vertexCircles: Int32s
  /** Four numbers for each edge: left circle, right circle, start vertex, end vertex. */
  readonly edges: Int32s
  /** Two numbers for each hidden circle, in increasing order of `circle`: circle, by. */
  readonly hidden: Int32s
  /**
   * The circles on the convex hull, counter-clockwise. A circle appears several times if the hull touches it more than
   * once.
   */
  readonly hull: Int32s
  /**
   * Two numbers for each edge: for each of its sides, the next side around the cell. In an unbounded cell, the side
   * that ends at infinity is followed by the side that begins there.
   */
  readonly nextSide: Int32s
  /**
   * Three sides for each vertex, which begin there; the first one belongs to the first circle of the vertex, and so on.
   */
  readonly vertexSides: Int32s
  /** The smallest side of each circle; `NONE` if the circle has no cell, or its cell is the whole plane. */
  readonly firstSide: Int32s
  readonly certificate: Certificate
  readonly stats: Stats
}

/**
 * A snapshot of an editor as plain data; `new DiagramSnapshot(data)` adds the methods.
 *
 * @category Editing
 */
export interface SnapshotData extends DiagramData {
  readonly numbers: SnapshotNumbers
}

/**
 * A point of the plane. The y axis points up, and counter-clockwise is positive.
 *
 * @category Diagrams
 */
export interface Point {
  readonly x: number
  readonly y: number
}

/**
 * A difference between two points, or a direction of any length.
 *
 * @category Diagrams
 */
export interface Vector {
  readonly x: number
  readonly y: number
}

/**
 * The distance from a circle (c, r) to a point p that defines a diagram. A point belongs to the cell of the circle with
 * the smallest distance.
 *
 * - `circles`: |p - c| - r, negative inside the circle: the Voronoi diagram of circles
 * - `centers`: |p - c|: the ordinary Voronoi diagram of the centers
 * - `power`: |p - c|^2 - r^2: the power (Laguerre) diagram
 *
 * @category Diagrams
 */
export type Metric = (typeof METRICS)[number]

/**
 * The names of all metrics.
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
 * Support for `using`, in versions of TypeScript that have it.
 *
 * @category Editing
 */
export type Disposal = SymbolConstructor extends { readonly dispose: infer Key extends symbol }
  ? Record<Key, () => void>
  : unknown

/**
 * A target for drawing: the methods of `CanvasRenderingContext2D` and `Path2D` that the library uses.
 *
 * @category Drawing
 */
export interface PathSink {
  /** Starts a new subpath at (x, y). */
  moveTo(x: number, y: number): void
  /** Adds a segment to (x, y). */
  lineTo(x: number, y: number): void
  /** Adds a cubic Bézier curve to (x, y) with two control points. */
  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void
  /**
   * Adds an arc of a circle. Angles are in radians; the arc runs towards larger angles, or towards smaller ones if
   * `counterclockwise`.
   */
  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise?: boolean): void
  /** Closes the current subpath. */
  closePath(): void
}
