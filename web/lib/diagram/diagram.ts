// SPDX-License-Identifier: GPL-3.0-or-later

import { checkData, checkIndex, checkMaxDistance, checkNumber, refuseArgument, shown } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import type {
  Certificate,
  DiagramData,
  Float64s,
  Int32s,
  Metric,
  PathSink,
  Point,
  SnapshotNumbers,
  Stats,
} from '../base/types.ts'
import { drawCell, drawCircle, drawDual, drawEdge, drawHull, drawRegion } from '../drawing/draw.ts'
import {
  type BoundsOptions,
  type ContextOptions,
  checkDrawOptions,
  DRAW_OPTIONS,
  type DrawOptions,
  drawn,
  PATH_OPTIONS,
  type PolygonOptions,
  type TextOptions,
  toleranceOf,
} from '../drawing/draw-options.ts'
import { hullRing, type Polygon, ringOf } from '../drawing/polygon.ts'
import type { Limits } from '../regions/cell-limits.ts'
import { Cells } from '../regions/cells.ts'
import { type Bounds, ConvexPolygon } from '../regions/convex-polygon.ts'
import { exportBox } from '../regions/export-box.ts'
import { outlineArea, outlineCentroid, outlinePerimeter } from '../regions/measure.ts'
import { outlineOf } from '../regions/outline.ts'
import type { Outline } from '../regions/outline-piece.ts'
import type { Change } from './change.ts'
import { type DiagramFile, dataFrom, fileOf } from './diagram-file.ts'
import { DiagramPatch } from './diagram-patch.ts'
import { Finder } from './finder.ts'
import { before } from './link-sides.ts'

/**
 * The cell of a circle. Its sides are listed counter-clockwise; where it goes to infinity, the next side after one that ends
 * there begins there. There are none if the cell is the whole plane.
 *
 * @category Diagrams
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
 * its `DiagramData`; `new Diagram(data)` gives that its methods back, `Diagram.fromJSON` those of JSON. There is nothing to
 * free.
 *
 * What draws takes one object of options: on a `context` (a canvas, a `Path2D` or any other `PathSink`) it draws, without
 * one it returns the `d` attribute of an SVG path. Curves are Bezier curves no farther than `tolerance` from the true ones,
 * by default a hundred-thousandth of the bounds. `bounds` are a box or a convex polygon in the units of the input, by
 * default a box with room for a twentieth of the circles' extent around them.
 *
 * The methods presume a certified diagram. What is made to answer them, in linear time, is made once, when first needed.
 * All throw a `CircleVoronoiError`: `badOption`, if options make no sense, `badArgument`, if something else does not.
 *
 * @category Diagrams
 * @example
 * diagram.find(5, 1) // 1
 * diagram.cellArea(0, { bounds: [-5, -5, 10, 10] }) // 72
 * diagram.cellPath(0, { bounds: [-5, -5, 10, 10] }) // 'M3,-5L3,4L-5,4L-5,-5L3,-5Z'
 * new Diagram(structuredClone(diagram)).find(5, 1) // 1
 */
export class Diagram implements DiagramData {
  readonly metric: Metric
  readonly weights: boolean
  readonly circles: Float64s
  readonly vertices: Float64s
  readonly vertexCircles: Int32s
  readonly edges: Int32s
  readonly hidden: Int32s
  readonly hull: Int32s
  readonly nextSide: Int32s
  readonly vertexSides: Int32s
  readonly firstSide: Int32s
  readonly certificate: Certificate
  readonly stats: Stats
  declare readonly numbers?: SnapshotNumbers
  readonly #recompute: ((circles: Float64s) => DiagramData) | undefined
  #cells: Cells | undefined
  #finder: Finder | undefined
  #bounds: ConvexPolygon | undefined
  #halfedges: Int32Array | undefined
  #patch: DiagramPatch | undefined
  #lastRegion: ConvexPolygon | undefined

  /** Around the arrays of `data`, which are not copied. `recompute`: what `update` calls. */
  constructor(data: DiagramData, recompute?: (circles: Float64s) => DiagramData) {
    checkData(data, 'new Diagram')
    this.metric = data.metric
    this.weights = data.weights
    this.circles = data.circles
    this.vertices = data.vertices
    this.vertexCircles = data.vertexCircles
    this.edges = data.edges
    this.hidden = data.hidden
    this.hull = data.hull
    this.nextSide = data.nextSide
    this.vertexSides = data.vertexSides
    this.firstSide = data.firstSide
    this.certificate = data.certificate
    this.stats = data.stats
    if (data.numbers !== undefined) this.numbers = data.numbers
    this.#recompute = recompute
  }

  /**
   * The diagram of a JSON file, or of what `JSON.parse` makes of one, as `JSON.stringify(diagram)` and the command line
   * write it: numbers to the bit. It is not judged; `certify` of the library does that.
   *
   * @throws CircleVoronoiError `badInput`, if it is no such file or an index is none of its circles or vertices;
   *   `negativeRadius`, `coordinateTooLarge`
   */
  static fromJSON(json: string | object): Diagram {
    return new Diagram(dataFrom(json))
  }

  /** What `JSON.stringify` writes: a file as the command line writes and reads it. Only the sign of a zero is lost. */
  toJSON(): DiagramFile {
    return fileOf(this)
  }

  /**
   * Computes the diagram anew after `circles` was changed in place, with the options of the first time. If that fails,
   * the diagram stays as it was.
   *
   * @throws CircleVoronoiError as `compute`; `badArgument`, if the diagram was not made by `compute` here
   */
  update(): this {
    if (this.#recompute === undefined) refuseArgument('update takes a diagram that compute made here.')
    Object.assign(this, this.#recompute(this.circles))
    this.#cells = undefined
    this.#finder = undefined
    this.#bounds = undefined
    this.#halfedges = undefined
    return this
  }

  /**
   * Follows an editor: makes this, a snapshot of it, the diagram after its next change, in the time that the change takes. The
   * arrays are changed in place; one that has to be longer or shorter is another then. `cells` and what `find` has made stay
   * good. Indices have no gaps: where a circle, a vertex or an edge goes, the last one may take its index. `indexOf` has a
   * circle's index, `numbers.circles` the ids. Of a hidden circle `by` is one that contains it, not always the largest.
   *
   * @throws CircleVoronoiError `badArgument`, if the diagram is no snapshot of an editor, or a change has been left out
   *
   * @example
   * ```js
   * const diagram = editor.snapshot()
   * editor.onchange = (change) => {
   *   diagram.apply(change)
   *   for (const id of change.cells) redraw(diagram.cellPath(diagram.indexOf(id)))
   * }
   * ```
   */
  apply(change: Change): this {
    const patch = this.#patchable('apply')
    const changed = patch.apply(change)
    const { hidden, circles } = Object.assign(this, patch.arrays())
    const counts = { ...this.stats.counts, circles: circles.length / 3, hidden: hidden.length / 2 }
    Object.assign(this, { stats: { ...this.stats, counts } })
    if (this.#finder?.follow(changed) === false) this.#finder = undefined
    this.#bounds = undefined
    this.#halfedges = undefined
    return this
  }

  /**
   * Of a snapshot of an editor the index of the circle with this id; `NONE` if there is none.
   *
   * @throws CircleVoronoiError `badArgument`, if it is no such snapshot
   */
  indexOf(id: number): number {
    checkNumber(id, 'indexOf', 'the id of a circle')
    return this.#patchable('indexOf').indexOf(id)
  }

  #patchable(caller: string): DiagramPatch {
    if (this.numbers === undefined) refuseArgument(`${caller} takes a diagram that is a snapshot of an editor.`)
    this.#patch ??= new DiagramPatch(this, this.numbers)
    return this.#patch
  }

  /** The sides of all cells in order. */
  get cells(): Cells {
    this.#cells ??= new Cells(this)
    return this.#cells
  }

  /**
   * The triangles of the dual, three circles each, counter-clockwise: `vertexCircles` by the name that d3-delaunay has
   * for it. Two of them may share two circles or all three.
   */
  get triangles(): Int32Array {
    return this.vertexCircles
  }

  /**
   * For each half-edge of the dual its opposite, or -1 at the hull, as in d3-delaunay: half-edge 3 t + k leads from the
   * k-th circle of triangle t to the next one.
   */
  get halfedges(): Int32Array {
    this.#halfedges ??= halfedgesOf(this)
    return this.#halfedges
  }

  /** The cell of circle `i`; `undefined` if it is hidden, or there is no such circle. */
  cell(i: number): Cell | undefined {
    checkNumber(i, 'cell', 'the index of a circle')
    const { cells } = this
    if (!cells.exists(i)) return undefined
    const sides = cells.sides(i)
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
   * None if `i` is hidden.
   */
  neighbors(i: number): Int32Array {
    this.#checkCircle(i, 'neighbors')
    return this.cells.neighbors(i)
  }

  /** Whether (x, y) is in the cell of circle `i`: no circle is nearer, up to rounding. False if `i` is hidden. */
  contains(i: number, x: number, y: number): boolean {
    this.#checkCircle(i, 'contains')
    checkNumber(x, 'contains', 'x')
    checkNumber(y, 'contains', 'y')
    return this.cells.contains(i, x, y)
  }

  /**
   * The circle nearest to (x, y), by the signed distance to its boundary or the diagram's other metric; one of them, if
   * several are up to rounding. A walk from a circle near the point, or from `hint` if that is nearer: for circles spread
   * evenly a step or two. `NONE` if there are no circles, or a coordinate is not finite.
   */
  find(x: number, y: number, hint: number = NONE): number {
    checkNumber(x, 'find', 'x')
    checkNumber(y, 'find', 'y')
    checkNumber(hint, 'find', 'hint')
    this.#finder ??= new Finder(this.cells)
    return this.#finder.find(x, y, hint)
  }

  /** For each of many points, x and y each, the same; it is fastest if points near in the list are near in the plane. */
  findAll(points: Float64Array | Float32Array | readonly number[]): Int32Array {
    const isList = points instanceof Float64Array || points instanceof Float32Array || Array.isArray(points)
    if (!isList) refuseArgument(`findAll takes a Float64Array of x and y for each point, not ${shown(points)}.`)
    if (points.length % 2 !== 0) {
      refuseArgument(`findAll takes two numbers for each point, but there are ${points.length}.`)
    }
    const coordinates = points instanceof Float64Array ? points : Float64Array.from(points, numberOf)
    this.#finder ??= new Finder(this.cells)
    return this.#finder.findAll(coordinates)
  }

  /** What of edge `e` lies in the bounds. */
  edgePath(e: number, options?: PolygonOptions & TextOptions): string
  edgePath(e: number, options: PolygonOptions & ContextOptions): void
  edgePath(e: number, options: DrawOptions = {}): string | undefined {
    checkIndex(e, this.edges.length / 4, 'edgePath', 'edge')
    return this.#drawn('edgePath', options, (sink, limits, tolerance) => drawEdge(sink, this, e, limits, tolerance))
  }

  /**
   * The outline of what of the cell of circle `i` lies in the bounds: a closed counter-clockwise path for each of its parts,
   * nothing if it is hidden.
   */
  cellPath(i: number, options?: PolygonOptions & TextOptions): string
  cellPath(i: number, options: PolygonOptions & ContextOptions): void
  cellPath(i: number, options: DrawOptions = {}): string | undefined {
    this.#checkCircle(i, 'cellPath')
    return this.#drawn('cellPath', options, (sink, limits, tolerance) =>
      drawCell(sink, this.cells, i, limits, tolerance),
    )
  }

  /** All edges within the bounds. */
  render(options?: PolygonOptions & TextOptions): string
  render(options: PolygonOptions & ContextOptions): void
  render(options: DrawOptions = {}): string | undefined {
    return this.#drawn('render', options, (sink, limits, tolerance) => {
      for (let e = 0; e < this.edges.length / 4; e++) drawEdge(sink, this, e, limits, tolerance)
    })
  }

  /** The bounds themselves. */
  renderBounds(options?: PolygonOptions & TextOptions): string
  renderBounds(options: PolygonOptions & ContextOptions): void
  renderBounds(options: DrawOptions = {}): string | undefined {
    return this.#drawn('renderBounds', options, (sink, { region }) => drawRegion(sink, region))
  }

  /** All circles, hidden ones too. */
  renderCircles(options?: TextOptions): string
  renderCircles(options: ContextOptions): void
  renderCircles(options: TextOptions | ContextOptions = {}): string | undefined {
    checkDrawOptions(options, 'renderCircles', PATH_OPTIONS)
    return drawn(options, undefined, (sink) => {
      for (let i = 0; i < this.circles.length / 3; i++) drawCircle(sink, this, i)
    })
  }

  /** The dual: a segment from centre to centre for each edge. */
  renderDual(options?: TextOptions): string
  renderDual(options: ContextOptions): void
  renderDual(options: TextOptions | ContextOptions = {}): string | undefined {
    checkDrawOptions(options, 'renderDual', PATH_OPTIONS)
    return drawn(options, undefined, (sink) => drawDual(sink, this))
  }

  /** The convex hull of the circles: arcs and the tangent segments between them. */
  renderHull(options?: TextOptions): string
  renderHull(options: ContextOptions): void
  renderHull(options: TextOptions | ContextOptions = {}): string | undefined {
    checkDrawOptions(options, 'renderHull', PATH_OPTIONS)
    return drawn(options, undefined, (sink) => drawHull(sink, this))
  }

  /**
   * What of the cell of circle `i` lies in the bounds as a closed polygon, counter-clockwise, its first point again at the
   * end; `undefined` if there is nothing. Of a cell that the bounds cut apart the ring goes to each further part and back
   * along one segment, so that its area and what is inside are right; `outline` has the parts. Neighbours share their
   * points bit for bit.
   */
  cellPolygon(i: number, options: PolygonOptions = {}): Polygon | undefined {
    this.#checkCircle(i, 'cellPolygon')
    const limits = this.#limitsOf('cellPolygon', options, ['bounds', 'maxDistance', 'tolerance'])
    return ringOf(outlineOf(this.cells, i, limits), toleranceOf(options, limits.region))
  }

  /** The polygons of all cells that have one, each with the `index` of its circle. */
  *cellPolygons(options: PolygonOptions = {}): Generator<Polygon & { index: number }, void> {
    for (let index = 0; index < this.circles.length / 3; index++) {
      const polygon = this.cellPolygon(index, options)
      if (polygon !== undefined) yield Object.assign(polygon, { index })
    }
  }

  /** The convex hull of the circles as a closed polygon, counter-clockwise, its first point again at the end. */
  hullPolygon(options: Pick<PolygonOptions, 'tolerance'> = {}): Polygon | undefined {
    checkDrawOptions(options, 'hullPolygon', ['tolerance'])
    return hullRing(this, toleranceOf(options, this.#defaultBounds()))
  }

  /**
   * The outline of a cell inside some bounds, counter-clockwise: nothing if they do not meet, several loops if the bounds cut
   * the cell apart.
   */
  cellOutline(i: number, options: BoundsOptions = {}): Outline {
    return this.#outline(i, 'cellOutline', options)
  }

  /** The area of what of the cell of circle `i` lies in the bounds; 0 if it is hidden. Exact up to rounding. */
  cellArea(i: number, options: BoundsOptions = {}): number {
    return outlineArea(this.#outline(i, 'cellArea', options))
  }

  /** Its centre of mass, likewise; `undefined` if there is nothing. */
  cellCentroid(i: number, options: BoundsOptions = {}): Point | undefined {
    const outline = this.#outline(i, 'cellCentroid', options)
    return outline.length === 0 ? undefined : outlineCentroid(outline)
  }

  /** The length of its outline, likewise; 0 if there is nothing. */
  cellPerimeter(i: number, options: BoundsOptions = {}): number {
    return outlinePerimeter(this.#outline(i, 'cellPerimeter', options))
  }

  /** The areas of all cells. */
  cellAreas(options: BoundsOptions = {}): Float64Array {
    return this.#ofEach('cellAreas', options, 1, (outline) => [outlineArea(outline)])
  }

  /** The centres of mass of all cells, x and y each; NaN where there is nothing. */
  cellCentroids(options: BoundsOptions = {}): Float64Array {
    return this.#ofEach('cellCentroids', options, 2, (outline) => {
      if (outline.length === 0) return [Number.NaN, Number.NaN]
      const { x, y } = outlineCentroid(outline)
      return [x, y]
    })
  }

  /** The lengths of the outlines of all cells. */
  cellPerimeters(options: BoundsOptions = {}): Float64Array {
    return this.#ofEach('cellPerimeters', options, 1, (outline) => [outlinePerimeter(outline)])
  }

  #outline(i: number, caller: string, options: BoundsOptions): Outline {
    this.#checkCircle(i, caller)
    return outlineOf(this.cells, i, this.#limitsOf(caller, options, ['bounds', 'maxDistance']))
  }

  #ofEach(
    caller: string,
    options: BoundsOptions,
    size: number,
    measure: (outline: Outline) => readonly number[],
  ): Float64Array {
    const limits = this.#limitsOf(caller, options, ['bounds', 'maxDistance'])
    const count = this.circles.length / 3
    const values = new Float64Array(size * count)
    for (let i = 0; i < count; i++) values.set(measure(outlineOf(this.cells, i, limits)), size * i)
    return values
  }

  #drawn(
    caller: string,
    options: DrawOptions,
    draw: (sink: PathSink, limits: Limits, tolerance: number) => void,
  ): string | undefined {
    const limits = this.#limitsOf(caller, options, DRAW_OPTIONS)
    const tolerance = toleranceOf(options, limits.region)
    return drawn(options, tolerance, (sink) => draw(sink, limits, tolerance))
  }

  #limitsOf(caller: string, options: BoundsOptions, known: readonly string[]): Limits {
    checkDrawOptions(options, caller, known)
    const { bounds, maxDistance } = options
    checkMaxDistance(this, caller, maxDistance)
    if (bounds !== undefined) return { region: this.#regionOf(bounds), maxDistance }
    const isCut = maxDistance !== undefined
    return {
      region: isCut ? ConvexPolygon.of(exportBox(this.circles, maxDistance)) : this.#defaultBounds(),
      maxDistance,
    }
  }

  /** What is drawn cell by cell has the same box each time. */
  #regionOf(bounds: Bounds): ConvexPolygon {
    const last = this.#lastRegion
    if (last !== undefined && Array.isArray(bounds) && bounds.length === 4) {
      const { minX, minY, maxX, maxY } = last.box
      if (bounds[0] === minX && bounds[1] === minY && bounds[2] === maxX && bounds[3] === maxY) return last
    }
    const region = ConvexPolygon.of(bounds)
    if (region.isBox) this.#lastRegion = region
    return region
  }

  #defaultBounds(): ConvexPolygon {
    this.#bounds ??= ConvexPolygon.of(exportBox(this.circles))
    return this.#bounds
  }

  #checkCircle(i: number, caller: string): void {
    checkIndex(i, this.circles.length / 3, caller, 'circle')
  }
}

function numberOf(value: unknown): number {
  checkNumber(value, 'findAll', 'a coordinate')
  return value as number
}

/** The half-edge from the k-th circle of a triangle to the next one crosses the edge between their sides. */
function halfedgesOf({ vertexCircles, edges, vertexSides }: DiagramData): Int32Array {
  // Of each side the half-edge that crosses it where it begins: towards its own circle from the one before.
  const crossing = new Int32Array(edges.length / 2).fill(NONE)
  vertexSides.forEach((side, slot) => {
    crossing[side] = before(slot)
  })
  const opposite = new Int32Array(vertexCircles.length)
  crossing.forEach((halfedge, side) => {
    if (halfedge !== NONE) opposite[halfedge] = at(crossing, side ^ 1)
  })
  return opposite
}
