// SPDX-License-Identifier: GPL-3.0-or-later
import { Cells } from './cells.ts'
import { type Bounds, ConvexPolygon } from './convex-polygon.ts'
import { type Certificate, type DiagramData, NONE, type Stats } from './diagram-data.ts'
import { drawCell, drawCircle, drawDual, drawEdge, drawHull } from './draw.ts'
import { exportBox, exportTolerance } from './export-box.ts'
import { Finder } from './finder.ts'
import type { Metric } from './metric.ts'
import type { PathSink } from './path-sink.ts'
import { SvgPath } from './svg-path.ts'

/**
 * The cell of a circle. Its sides are listed counter-clockwise; where it goes to infinity, the next side after one that ends
 * there begins there. There are none if the cell is the whole plane.
 */
export interface Cell {
  readonly circle: number
  /** For each side 2 e, or 2 e + 1 if the cell is on the right of edge e. */
  readonly sides: Int32Array
  /** For each side its edge. */
  readonly edges: Int32Array
  /** For each side the circle across; one recurs if the two cells share several edges. */
  readonly neighbors: Int32Array
  /** For each side the vertex where it begins, or `NONE` if it comes from infinity. */
  readonly vertices: Int32Array
  /** Whether it does not go to infinity. */
  readonly isBounded: boolean
}

/**
 * The Voronoi diagram of n circles: flat arrays, and what one asks of them. A structured clone, as `postMessage` makes, is
 * its `DiagramData`; `new Diagram(data)` gives that its methods back. There is nothing to free.
 *
 * What draws takes a canvas, a `Path2D` or any other `PathSink`, or returns the `d` attribute of an SVG path. Curves are
 * Bezier curves no farther than `tolerance` from the true ones, by default a hundred-thousandth of the bounds. Bounds are
 * a box or a convex polygon in the units of the input, by default a box with room for a twentieth of the circles' extent
 * around them.
 *
 * The methods presume a certified diagram. What is made to answer them, in linear time, is made once, when first needed.
 */
export class Diagram implements DiagramData {
  readonly metric: Metric
  readonly circles: Float64Array
  readonly vertices: Float64Array
  readonly vertexCircles: Int32Array
  readonly edges: Int32Array
  readonly hidden: Int32Array
  readonly hull: Int32Array
  readonly certificate: Certificate
  readonly stats: Stats
  #cells: Cells | undefined
  #finder: Finder | undefined
  #bounds: ConvexPolygon | undefined

  /** Around the arrays of `data`, which are not copied. */
  constructor(data: DiagramData) {
    this.metric = data.metric
    this.circles = data.circles
    this.vertices = data.vertices
    this.vertexCircles = data.vertexCircles
    this.edges = data.edges
    this.hidden = data.hidden
    this.hull = data.hull
    this.certificate = data.certificate
    this.stats = data.stats
  }

  /** The sides of all cells in order. */
  get cells(): Cells {
    this.#cells ??= new Cells(this)
    return this.#cells
  }

  /** The cell of circle `i`; `undefined` if it is hidden, or there is no such circle. */
  cell(i: number): Cell | undefined {
    const { cells } = this
    if (!cells.exists(i)) return undefined
    const sides = cells.sides(i).slice()
    return {
      circle: i,
      sides,
      edges: sides.map((side) => side >> 1),
      neighbors: cells.neighbors(i),
      vertices: sides.map((side) => cells.originOf(side)),
      isBounded: cells.isBounded(i),
    }
  }

  /**
   * The circles whose cells share an edge with that of circle `i`, counter-clockwise: one recurs if they share several.
   */
  neighbors(i: number): Int32Array {
    return this.cells.neighbors(i)
  }

  /** Whether (x, y) is in the cell of circle `i`: no circle is nearer, up to rounding. False if `i` is hidden. */
  contains(i: number, x: number, y: number): boolean {
    return this.cells.contains(i, x, y)
  }

  /**
   * The circle nearest to (x, y), by the signed distance to its boundary or the diagram's other metric; one of them, if
   * several are up to rounding. A walk from a circle near the point, or from `hint` if that is nearer: for circles spread
   * evenly a step or two. `NONE` if there are no circles, or a coordinate is not finite.
   */
  find(x: number, y: number, hint: number = NONE): number {
    this.#finder ??= new Finder(this.cells)
    return this.#finder.find(x, y, hint)
  }

  /** For each of many points, x and y each, the same; it is fastest if points near in the list are near in the plane. */
  findAll(points: Float64Array): Int32Array {
    this.#finder ??= new Finder(this.cells)
    return this.#finder.findAll(points)
  }

  /** What of edge `e` lies in the bounds; nothing if there is no such edge. */
  edgePath(e: number, context?: undefined, bounds?: Bounds, tolerance?: number): string
  edgePath(e: number, context: PathSink, bounds?: Bounds, tolerance?: number): void
  edgePath(e: number, context?: PathSink, bounds?: Bounds, tolerance?: number): string | undefined {
    const region = this.#regionOf(bounds)
    return drawn(context, (sink) => drawEdge(sink, this, e, region, toleranceOr(tolerance, region)))
  }

  /**
   * The outline of what of the cell of circle `i` lies in the bounds: a closed counter-clockwise path for each of its parts,
   * nothing if it is hidden, or there is no such circle.
   */
  cellPath(i: number, bounds?: Bounds, context?: undefined, tolerance?: number): string
  cellPath(i: number, bounds: Bounds | undefined, context: PathSink, tolerance?: number): void
  cellPath(i: number, bounds?: Bounds, context?: PathSink, tolerance?: number): string | undefined {
    const region = this.#regionOf(bounds)
    return drawn(context, (sink) => drawCell(sink, this.cells, i, region, toleranceOr(tolerance, region)))
  }

  /** All edges within the bounds. */
  render(context?: undefined, bounds?: Bounds, tolerance?: number): string
  render(context: PathSink, bounds?: Bounds, tolerance?: number): void
  render(context?: PathSink, bounds?: Bounds, tolerance?: number): string | undefined {
    const region = this.#regionOf(bounds)
    return drawn(context, (sink) => {
      for (let e = 0; e < this.edges.length / 4; e++) drawEdge(sink, this, e, region, toleranceOr(tolerance, region))
    })
  }

  /** All circles, hidden ones too. */
  renderCircles(context?: undefined): string
  renderCircles(context: PathSink): void
  renderCircles(context?: PathSink): string | undefined {
    return drawn(context, (sink) => {
      for (let i = 0; i < this.circles.length / 3; i++) drawCircle(sink, this, i)
    })
  }

  /** The dual: a segment from centre to centre for each edge. */
  renderDual(context?: undefined): string
  renderDual(context: PathSink): void
  renderDual(context?: PathSink): string | undefined {
    return drawn(context, (sink) => drawDual(sink, this))
  }

  /** The convex hull of the circles: arcs and the tangent segments between them. */
  renderHull(context?: undefined): string
  renderHull(context: PathSink): void
  renderHull(context?: PathSink): string | undefined {
    return drawn(context, (sink) => drawHull(sink, this))
  }

  #regionOf(bounds: Bounds | undefined): ConvexPolygon {
    if (bounds !== undefined) return ConvexPolygon.of(bounds)
    this.#bounds ??= ConvexPolygon.of(exportBox(this.circles))
    return this.#bounds
  }
}

function toleranceOr(tolerance: number | undefined, region: ConvexPolygon): number {
  return tolerance ?? exportTolerance(region.box)
}

function drawn(context: PathSink | undefined, draw: (sink: PathSink) => void): string | undefined {
  if (context !== undefined) {
    draw(context)
    return undefined
  }
  const path = new SvgPath()
  draw(path)
  return path.toString()
}
