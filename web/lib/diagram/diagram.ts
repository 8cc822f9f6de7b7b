// SPDX-License-Identifier: GPL-3.0-or-later

import {
  checkData,
  checkIndex,
  checkMaxDistance,
  checkMemory,
  checkNoOptions,
  checkNumber,
  refuseInput,
  shown,
} from '../base/check.ts'
import { at, circleOf, NONE } from '../base/diagram-data.ts'
import type { Box, Certificate, DiagramData, Float64s, Int32s, Metric, PathSink, Point, Stats } from '../base/types.ts'
import { drawBounds, drawCell, drawCircle, drawDual, drawEdge, drawHull } from '../drawing/draw.ts'
import {
  clippedOutline,
  clippedSides,
  drawClippedEdges,
  drawOutline,
  drawPiecesOf,
  drawPolygons,
  drawRings,
  type MultiPolygon,
  multiPolygonOf,
} from '../drawing/draw-clipped.ts'
import {
  BOUNDS_OPTIONS,
  type BoundsOptions,
  type ContextOptions,
  checkDrawOptions,
  DRAW_OPTIONS,
  type DrawOptions,
  HULL_OPTIONS,
  type HullOptions,
  PATH_OPTIONS,
  POLYGON_OPTIONS,
  type PolygonOptions,
  sinkOf,
  type TextOptions,
  textOf,
  toleranceOf,
} from '../drawing/draw-options.ts'
import { cellRing, hullInRegion, hullRing, type Polygon } from '../drawing/polygon.ts'
import type { Limits } from '../regions/cell-limits.ts'
import { Cells } from '../regions/cells.ts'
import { type Bounds, ConvexPolygon } from '../regions/convex-polygon.ts'
import { exportBoxOf } from '../regions/export-box.ts'
import { AreaJudge, areaOf, centroidOf, perimeterOf } from '../regions/measure.ts'
import { keptParts, outlineOf, wholeLoop } from '../regions/outline.ts'
import type { Outline } from '../regions/outline-piece.ts'
import { type ClippedCells, type ClippedDiagram, type MeasuredCells, Region, regionOption } from '../regions/region.ts'
import { type DiagramFile, fileOf } from './diagram-file.ts'
import { Finder } from './finder.ts'
import { before } from './link-sides.ts'

/**
 * The Voronoi cell of a circle. Its sides are listed counter-clockwise. In an unbounded cell, the side that ends at
 * infinity is followed by the side that begins there. A cell that is the whole plane has no sides.
 *
 * @category Diagrams
 */
export interface Cell {
  readonly circle: number
  /** One number for each side: 2 e if the cell is on the left of edge e, 2 e + 1 if it is on the right. */
  readonly sides: Int32Array
  /** The edge of each side. */
  readonly edges: Int32Array
  /** The circle across each side. A circle appears several times if the two cells share several edges. */
  readonly neighbors: Int32Array
  /** The vertex where each side begins, or `NONE` if the side comes from infinity. */
  readonly vertices: Int32Array
  /** Whether the cell is bounded. */
  readonly isBounded: boolean
}

/**
 * The Voronoi diagram of n circles: flat arrays, and methods that draw, measure and query them. A structured clone, for
 * example one made by `postMessage`, is plain `DiagramData`; `new Diagram(data)` restores the methods, and `fromJSON`
 * reads JSON. A diagram holds no memory that has to be freed. `compute` returns a `ComputedDiagram`, and editors return
 * a `DiagramSnapshot`, which have further methods.
 *
 * Drawing methods take one object of options. With a `context` (a canvas, a `Path2D` or any other `PathSink`) they
 * draw; without one they return the `d` attribute of an SVG path. Curves are approximated by Bézier curves within
 * `tolerance`, by default a hundred-thousandth of the bounds. `bounds` is a box or a convex polygon in the units of the
 * input. Without `bounds` and `region`, drawings and polygons are clipped to `exportBox`.
 *
 * Measures without `bounds`, `region` and `maxDistance` are those of whole cells: an unbounded cell has an infinite area
 * and perimeter, and no centroid.
 *
 * The methods expect a certified diagram. Data structures that they need are built in linear time on first use. All
 * methods throw a `CircleVoronoiError`: `badOption` for options that make no sense, `badInput` for other arguments,
 * and `badInput` or `nonFinite` if a program has changed the arrays so that they no longer fit together.
 *
 * @category Diagrams
 * @example
 * diagram.find(5, 1) // 1
 * diagram.cellArea(0, { bounds: [-5, -5, 10, 10] }) // 72
 * diagram.cellPath(0, { bounds: [-5, -5, 10, 10] }) // 'M-5,-5L3,-5L3,4L-5,4L-5,-5Z'
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
  #cells: Cells | undefined
  #finder: Finder | undefined
  /** The default bounds, by maximum distance. */
  readonly #bounds = new Map<number | undefined, ConvexPolygon>()
  #halfedges: Int32Array | undefined
  #lastLimits: Limits | undefined
  #clip: { region: Region; maxDistance: number | undefined; clipped: ClippedDiagram } | undefined
  /** The number of cells clipped one by one since the last change. */
  #alone = 0

  /** Wraps the arrays of `data` without copying them. */
  constructor(data: DiagramData) {
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
  }

  /** Returns the content of a JSON file as the command line writes and reads it. Only the sign of a zero is lost. */
  toJSON(): DiagramFile {
    checkData(this, 'toJSON')
    return fileOf(this)
  }

  /**
   * @internal Takes the arrays of another diagram and drops all data derived from the old arrays. If `follow` can
   *   update the search structure of `find`, it returns true.
   */
  protected renew(data: Partial<DiagramData>, follow?: (finder: Finder) => boolean): void {
    Object.assign(this, data)
    if (this.#finder !== undefined && !follow?.(this.#finder)) this.#finder = undefined
    this.#bounds.clear()
    this.#clip = undefined
    this.#alone = 0
    this.#halfedges = undefined
  }

  /** The cells with their sides. */
  get cells(): Cells {
    this.#checkMemory()
    this.#cells ??= new Cells(this)
    return this.#cells
  }

  /** Refuses arrays that have lost their memory. Only few diagrams have an empty one of these arrays. */
  #checkMemory(): void {
    const { circles, vertices, vertexCircles, edges, hull, nextSide, vertexSides, firstSide } = this
    const isFull = circles.length * vertices.length * edges.length * hull.length > 0
    const isLinked = vertexCircles.length * nextSide.length * vertexSides.length * firstSide.length > 0
    if (!isFull || !isLinked) checkData(this, 'Diagram')
  }

  /**
   * The triangles of the dual, three circles each, counter-clockwise. This is `vertexCircles` under the name that
   * d3-delaunay uses. Two triangles may share two circles or all three.
   */
  get triangles(): Int32Array {
    return this.vertexCircles
  }

  /**
   * The opposite of each half-edge of the dual, or -1 on the hull, as in d3-delaunay. Half-edge 3 t + k leads from the
   * k-th circle of triangle t to the next one.
   */
  get halfedges(): Int32Array {
    checkData(this, 'halfedges')
    this.#halfedges ??= halfedgesOf(this)
    return this.#halfedges
  }

  /** Returns the cell of circle `i`, or `undefined` if the circle is hidden or does not exist. */
  cell(i: number): Cell | undefined
  cell(i: number, ...others: readonly unknown[]): Cell | undefined {
    checkNoOptions(others, 'cell')
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
   * Returns the circles whose cells share an edge with the cell of circle `i`, counter-clockwise. A circle appears once
   * for each shared edge. The result is empty if circle `i` is hidden.
   *
   * With `bounds`, a `region` or `maxDistance`, it returns each circle once that shares a part of an edge inside.
   */
  neighbors(i: number, options: BoundsOptions = {}): Int32Array {
    this.#checkCircle(i, 'neighbors')
    checkDrawOptions(options, 'neighbors', BOUNDS_OPTIONS)
    const region = this.#regionIn('neighbors', options)
    if (region !== undefined) {
      const kept = clippedSides(this.#cellIn(region, i, options))
      const sides = this.cells.sides(i).filter((side) => kept.has(side))
      return Int32Array.from(new Set(sides.map((side) => this.cells.neighborOf(side))))
    }
    if (options.bounds === undefined && options.maxDistance === undefined) return this.cells.neighbors(i)
    const limits = this.#limitsOf(options)
    const sides = this.cells.sides(i).filter((side) => keptParts(this, side >> 1, limits).length > 0)
    return Int32Array.from(new Set(sides.map((side) => this.cells.neighborOf(side))))
  }

  /** Returns whether (x, y) lies in the cell of circle `i`, up to rounding. Returns false if circle `i` is hidden. */
  contains(i: number, x: number, y: number): boolean
  contains(i: number, x: number, y: number, ...others: readonly unknown[]): boolean {
    checkNoOptions(others, 'contains')
    this.#checkCircle(i, 'contains')
    checkNumber(x, 'contains', 'x')
    checkNumber(y, 'contains', 'y')
    return this.cells.contains(i, x, y)
  }

  /**
   * Returns the circle nearest to (x, y) by the signed distance to its boundary, or by the metric of the diagram. Ties
   * up to rounding may go to any of the nearest circles. Returns `NONE` if there are no circles or a coordinate is not
   * finite. The search walks from a circle near the point, or from `hint` if that is nearer, and needs a step or two if
   * the circles are spread evenly.
   */
  find(x: number, y: number, hint: number = NONE): number {
    checkNumber(x, 'find', 'x')
    checkNumber(y, 'find', 'y')
    checkNumber(hint, 'find', 'hint')
    const { cells } = this
    this.#finder ??= new Finder(cells)
    return this.#finder.find(x, y, hint)
  }

  /**
   * Returns the circle nearest to each of many points, given as x and y of each. This is fastest if consecutive points
   * are close to each other.
   */
  findAll(points: Float64Array | Float32Array | readonly number[]): Int32Array
  findAll(points: Float64Array | Float32Array | readonly number[], ...others: readonly unknown[]): Int32Array {
    checkNoOptions(others, 'findAll')
    const isList = points instanceof Float64Array || points instanceof Float32Array || Array.isArray(points)
    if (!isList) refuseInput(`findAll takes a Float64Array of x and y for each point, not ${shown(points)}.`)
    checkMemory(points, 'findAll', 'points')
    if (points.length % 2 !== 0) {
      refuseInput(`findAll takes two numbers for each point, but there are ${points.length}.`)
    }
    const coordinates = points instanceof Float64Array ? points : Float64Array.from(points, numberOf)
    const { cells } = this
    this.#finder ??= new Finder(cells)
    return this.#finder.findAll(coordinates)
  }

  /**
   * Returns the box to which drawings and polygons are clipped without `bounds` and `region`: the bounding box of the
   * circles, each grown by `maxDistance`, plus a margin of a twentieth of its size.
   */
  exportBox(options: Pick<BoundsOptions, 'maxDistance'> = {}): Box {
    checkDrawOptions(options, 'exportBox', ['maxDistance'])
    return { ...this.#limitsOf(options).bounds.box }
  }

  /** Draws the part of edge `e` inside the bounds. */
  edgePath(e: number, options?: PolygonOptions & TextOptions): string
  edgePath(e: number, options: PolygonOptions & ContextOptions): void
  edgePath(e: number, options: DrawOptions = {}): string | undefined {
    checkIndex(e, this.edges.length / 4, 'edgePath', 'edge')
    return this.#drawn(
      'edgePath',
      options,
      (sink, limits, tolerance) => drawEdge(sink, this, e, limits, tolerance),
      (sink, region, tolerance) => {
        const outline = clippedOutline(this, this.#cellIn(region, at(this.edges, 4 * e), options))
        drawPiecesOf(sink, outline, 2 * e, tolerance)
      },
    )
  }

  /**
   * Draws the outline of the part of cell `i` inside the bounds: a closed counter-clockwise path for each connected
   * piece, and nothing if circle `i` is hidden.
   */
  cellPath(i: number, options?: PolygonOptions & TextOptions): string
  cellPath(i: number, options: PolygonOptions & ContextOptions): void
  cellPath(i: number, options: DrawOptions = {}): string | undefined {
    this.#checkCircle(i, 'cellPath')
    return this.#drawn(
      'cellPath',
      options,
      (sink, limits, tolerance) => drawCell(sink, this.cells, i, limits, tolerance),
      (sink, region, tolerance) => {
        drawOutline(sink, clippedOutline(this, this.#cellIn(region, i, options)), tolerance)
      },
    )
  }

  /** Draws all edges inside the bounds. */
  render(options?: PolygonOptions & TextOptions): string
  render(options: PolygonOptions & ContextOptions): void
  render(options: DrawOptions = {}): string | undefined {
    return this.#drawn(
      'render',
      options,
      (sink, limits, tolerance) => {
        for (let e = 0; e < this.edges.length / 4; e++) drawEdge(sink, this, e, limits, tolerance)
      },
      (sink, region, tolerance) => {
        drawClippedEdges(sink, this, this.#clippedTo(region, options).edges, tolerance)
      },
    )
  }

  /** Draws the outline of the bounds, or of the region. */
  renderBounds(options?: PolygonOptions & TextOptions): string
  renderBounds(options: PolygonOptions & ContextOptions): void
  renderBounds(options: DrawOptions = {}): string | undefined {
    return this.#drawn('renderBounds', options, (sink, { bounds }) => drawBounds(sink, bounds), drawRings)
  }

  /** Draws all circles, including hidden ones. */
  renderCircles(options?: TextOptions): string
  renderCircles(options: ContextOptions): void
  renderCircles(options: TextOptions | ContextOptions = {}): string | undefined {
    checkDrawOptions(options, 'renderCircles', PATH_OPTIONS)
    this.#checkMemory()
    const sink = sinkOf(options, undefined)
    for (let i = 0; i < this.circles.length / 3; i++) drawCircle(sink, this, i)
    return textOf(sink)
  }

  /** Draws the dual: a segment between the centers of the two circles of each edge. */
  renderDual(options?: TextOptions): string
  renderDual(options: ContextOptions): void
  renderDual(options: TextOptions | ContextOptions = {}): string | undefined {
    checkDrawOptions(options, 'renderDual', PATH_OPTIONS)
    this.#checkMemory()
    const sink = sinkOf(options, undefined)
    drawDual(sink, this)
    return textOf(sink)
  }

  /**
   * Draws the convex hull of the circles: arcs and the tangent segments between them. With a `region`, draws polygons
   * within `tolerance` of the part of the hull inside.
   */
  renderHull(options?: HullOptions & TextOptions): string
  renderHull(options: HullOptions & ContextOptions): void
  renderHull(options: HullOptions & (TextOptions | ContextOptions) = {}): string | undefined {
    checkDrawOptions(options, 'renderHull', [...PATH_OPTIONS, ...HULL_OPTIONS])
    const region = this.#regionIn('renderHull', options)
    if (region !== undefined) {
      const tolerance = toleranceOf(options, region)
      const sink = sinkOf(options, tolerance)
      drawPolygons(sink, hullInRegion(this, region, tolerance) ?? [])
      return textOf(sink)
    }
    const sink = sinkOf(options, undefined)
    drawHull(sink, this)
    return textOf(sink)
  }

  /**
   * Returns the part of cell `i` inside the bounds as a closed counter-clockwise polygon that repeats its first point
   * at the end, or `undefined` if the part is empty or thinner than the tolerance. If the bounds cut the cell into
   * several pieces, the ring goes to each further piece and back along the same segment, so that its area and inside
   * are correct; `cellOutline` returns the pieces. With a `region`, returns a `MultiPolygon`. Neighboring cells share
   * their points bit for bit.
   */
  cellPolygon(i: number, options: PolygonOptions & { readonly region: Region }): MultiPolygon | undefined
  cellPolygon(i: number, options?: PolygonOptions & { readonly region?: undefined }): Polygon | undefined
  cellPolygon(i: number, options: PolygonOptions = {}): Polygon | MultiPolygon | undefined {
    this.#checkCircle(i, 'cellPolygon')
    checkDrawOptions(options, 'cellPolygon', POLYGON_OPTIONS)
    const region = this.#regionIn('cellPolygon', options)
    if (region !== undefined) {
      return multiPolygonOf(this.#clippedTo(region, options).polygons(toleranceOf(options, region)), i)
    }
    const limits = this.#limitsOf(options)
    return cellRing(this.cells, i, limits, toleranceOf(options, limits.bounds))
  }

  /** Generates the polygons of all cells that are not empty, each with the `index` of its circle. */
  cellPolygons(options: PolygonOptions & { readonly region: Region }): Generator<MultiPolygon & { index: number }, void>
  cellPolygons(options?: PolygonOptions & { readonly region?: undefined }): Generator<Polygon & { index: number }, void>
  *cellPolygons(options: PolygonOptions = {}): Generator<(Polygon | MultiPolygon) & { index: number }, void> {
    this.#checkMemory()
    for (let index = 0; index < this.circles.length / 3; index++) {
      const polygon = this.cellPolygon(index, options as PolygonOptions & { readonly region?: undefined })
      if (polygon !== undefined) yield Object.assign(polygon, { index })
    }
  }

  /**
   * Returns the convex hull of the circles as a closed counter-clockwise polygon that repeats its first point at the
   * end. With a `region`, returns the part of the hull inside as a `MultiPolygon`, or `undefined` if there is none.
   */
  hullPolygon(options: HullOptions & { readonly region: Region }): MultiPolygon | undefined
  hullPolygon(options?: HullOptions & { readonly region?: undefined }): Polygon | undefined
  hullPolygon(options: HullOptions = {}): Polygon | MultiPolygon | undefined {
    checkDrawOptions(options, 'hullPolygon', HULL_OPTIONS)
    const region = this.#regionIn('hullPolygon', options)
    if (region !== undefined) return hullInRegion(this, region, toleranceOf(options, region))
    return hullRing(this, toleranceOf(options, this.#defaultBounds(undefined)))
  }

  /**
   * Returns the outline of the part of cell `i` inside the bounds, by default `exportBox`: counter-clockwise loops, none
   * if the part is empty, several if the bounds cut the cell into pieces. A cell that only touches the bounds may have a loop without area,
   * which has no centroid and no polygon.
   */
  cellOutline(i: number, options: BoundsOptions = {}): Outline {
    return this.#outline(i, 'cellOutline', options)
  }

  /**
   * Returns the area of cell `i`, exact up to rounding: infinity if the cell is unbounded, 0 if circle `i` is hidden.
   * With `bounds`, a `region` or `maxDistance`, returns the area of the part inside. With `bounds` or `maxDistance`, throws
   * `notCertified` if the area is negative or larger than that of the bounds, because arrays were changed.
   */
  cellArea(i: number, options: BoundsOptions = {}): number {
    const measured = this.#measuredIn(i, 'cellArea', options)
    if (measured !== undefined) return at(measured.clip.areas, measured.row)
    const limits = this.#limitsIn(options)
    const area = sizeOf(this.#outlineIn(i, limits), areaOf)
    if (limits !== undefined) new AreaJudge(limits.bounds).add(area, circleOf(this.circles, i), i)
    return area
  }

  /**
   * Returns the centroid of cell `i`, exact up to rounding, or `undefined` if the cell is unbounded or has no area. With
   * `bounds`, a `region` or `maxDistance`, returns the centroid of the part inside.
   */
  cellCentroid(i: number, options: BoundsOptions = {}): Point | undefined {
    const measured = this.#measuredIn(i, 'cellCentroid', options)
    if (measured !== undefined) {
      const { clip, row } = measured
      const x = at(clip.centroids, 2 * row)
      return Number.isNaN(x) ? undefined : { x, y: at(clip.centroids, 2 * row + 1) }
    }
    return centroidInside(this.#outlineIn(i, this.#limitsIn(options)))
  }

  /**
   * Returns the perimeter of cell `i`, exact up to rounding: infinity if the cell is unbounded, 0 if circle `i` is
   * hidden. With `bounds`, a `region` or `maxDistance`, returns the perimeter of the part inside.
   */
  cellPerimeter(i: number, options: BoundsOptions = {}): number {
    const measured = this.#measuredIn(i, 'cellPerimeter', options)
    if (measured !== undefined) return at(measured.clip.perimeters, measured.row)
    return sizeOf(this.#outlineIn(i, this.#limitsIn(options)), perimeterOf)
  }

  /**
   * Returns what `cellArea` returns for each cell. Inside bounds, throws `notCertified` if an area is negative or, without
   * a maximum distance, the areas do not sum to that of the bounds, up to rounding.
   */
  cellAreas(options: BoundsOptions = {}): Float64Array {
    const areas = this.#ofEach('cellAreas', options, 'areas', (outline) => [sizeOf(outline, areaOf)])
    const limits = options.region === undefined ? this.#limitsIn(options) : undefined
    if (limits === undefined || this.hull.length === 0) return areas
    const judge = new AreaJudge(limits.bounds)
    areas.forEach((area, i) => {
      judge.add(area, circleOf(this.circles, i), i)
    })
    const isWhole = options.maxDistance === undefined
    if (isWhole) judge.checkSum()
    return areas
  }

  /** Returns what `cellCentroid` returns for each cell, as x and y; NaN for a cell without a centroid. */
  cellCentroids(options: BoundsOptions = {}): Float64Array {
    return this.#ofEach('cellCentroids', options, 'centroids', (outline) => {
      const { x, y } = centroidInside(outline) ?? { x: Number.NaN, y: Number.NaN }
      return [x, y]
    })
  }

  /** Returns what `cellPerimeter` returns for each cell. */
  cellPerimeters(options: BoundsOptions = {}): Float64Array {
    return this.#ofEach('cellPerimeters', options, 'perimeters', (outline) => [sizeOf(outline, perimeterOf)])
  }

  /** Returns the limits of measures, which have no default bounds; `undefined` if there are none. */
  #limitsIn(options: BoundsOptions): Limits | undefined {
    const isLimited = options.bounds !== undefined || options.maxDistance !== undefined
    return isLimited ? this.#limitsOf(options) : undefined
  }

  /** Returns the outline of a cell inside limits; `undefined` if there are none and the cell is unbounded. */
  #outlineIn(i: number, limits: Limits | undefined): Outline | undefined {
    const { cells } = this
    if (limits !== undefined) return outlineOf(cells, i, limits)
    if (!cells.exists(i)) return []
    return cells.isBounded(i) ? [wholeLoop(cells, i)] : undefined
  }

  #outline(i: number, caller: string, options: BoundsOptions): Outline {
    this.#checkCircle(i, caller)
    checkDrawOptions(options, caller, BOUNDS_OPTIONS)
    const region = this.#regionIn(caller, options)
    if (region !== undefined) return clippedOutline(this, this.#cellIn(region, i, options))
    return outlineOf(this.cells, i, this.#limitsOf(options))
  }

  /** Returns the clip with the measures of cell `i`, and its row there, if the options have a region. */
  #measuredIn(i: number, caller: string, options: BoundsOptions): { clip: MeasuredCells; row: number } | undefined {
    this.#checkCircle(i, caller)
    checkDrawOptions(options, caller, BOUNDS_OPTIONS)
    const region = this.#regionIn(caller, options)
    return region && this.#clipWith(region, i, options)
  }

  #ofEach(
    caller: string,
    options: BoundsOptions,
    measures: 'areas' | 'centroids' | 'perimeters',
    measure: (outline: Outline | undefined) => readonly number[],
  ): Float64Array {
    checkDrawOptions(options, caller, BOUNDS_OPTIONS)
    const region = this.#regionIn(caller, options)
    if (region !== undefined) return this.#clippedTo(region, options)[measures]
    const limits = this.#limitsIn(options)
    this.#checkMemory()
    const count = this.circles.length / 3
    const size = measures === 'centroids' ? 2 : 1
    const values = new Float64Array(size * count)
    for (let i = 0; i < count; i++) values.set(measure(this.#outlineIn(i, limits)), size * i)
    return values
  }

  /** Draws the parts inside the bounds or the region of the options. */
  #drawn(
    caller: string,
    options: DrawOptions,
    drawWithin: (sink: PathSink, limits: Limits, tolerance: number) => void,
    drawIn: (sink: PathSink, region: Region, tolerance: number) => void,
  ): string | undefined {
    checkDrawOptions(options, caller, DRAW_OPTIONS)
    const region = this.#regionIn(caller, options)
    const limits = region ?? this.#limitsOf(options)
    const tolerance = toleranceOf(options, limits instanceof Region ? limits : limits.bounds)
    const sink = sinkOf(options, tolerance)
    if (limits instanceof Region) drawIn(sink, limits, tolerance)
    else drawWithin(sink, limits, tolerance)
    return textOf(sink)
  }

  /** Returns the checked region of the options, if any. */
  #regionIn(caller: string, options: BoundsOptions): Region | undefined {
    const region = regionOption(options, caller)
    if (region !== undefined) checkMaxDistance(options.maxDistance)
    return region
  }

  /** Returns all cells clipped to a region. The last result is cached. */
  #clippedTo(region: Region, { maxDistance }: BoundsOptions): ClippedDiagram {
    const clipped = this.#keptClip(region, maxDistance) ?? region.module.clip(this, maxDistance)
    this.#clip = { region, maxDistance, clipped }
    return clipped
  }

  #keptClip(region: Region, maxDistance: number | undefined): ClippedDiagram | undefined {
    const last = this.#clip
    return last?.region === region && last.maxDistance === maxDistance ? last.clipped : undefined
  }

  /** Returns clipped cells and the row of cell `i` among them. */
  #cellIn(region: Region, i: number, options: BoundsOptions): [cells: ClippedCells, row: number] {
    const { clip, row } = this.#clipWith(region, i, options)
    return [clip.cells, row]
  }

  /** Returns a clip that has cell `i`, and its row there. */
  #clipWith(region: Region, i: number, options: BoundsOptions): { clip: MeasuredCells; row: number } {
    const { maxDistance } = options
    const alone = this.#isClippedAlone(region, i, maxDistance) && region.module.clipCell(this, i, maxDistance)
    return alone ? { clip: alone, row: 0 } : { clip: this.#clippedTo(region, options), row: i }
  }

  /**
   * Whether a cell is clipped alone. Only the first few are, for editors that read a few cells after each change. When
   * single cells have taken as much time as clipping all cells, all cells are clipped.
   */
  #isClippedAlone(region: Region, i: number, maxDistance: number | undefined): boolean {
    if (this.#keptClip(region, maxDistance) !== undefined || this.metric !== 'circles') return false
    this.#alone += 1
    return CELLS_FOR_ONE * this.#alone <= this.circles.length / 3 && this.cells.sides(i).length > 0
  }

  /** Returns the limits for the bounds and distance of the options, or the cached limits if nothing has changed. */
  #limitsOf({ bounds, maxDistance }: BoundsOptions): Limits {
    this.#checkMemory()
    checkMaxDistance(maxDistance)
    const last = this.#lastLimits
    let polygon: ConvexPolygon
    if (bounds === undefined) {
      polygon = this.#defaultBounds(maxDistance)
    } else {
      polygon = last !== undefined && isBoxOf(last.bounds, bounds) ? last.bounds : ConvexPolygon.of(bounds)
    }
    if (last?.bounds === polygon && last.maxDistance === maxDistance) return last
    this.#lastLimits = { bounds: polygon, maxDistance }
    return this.#lastLimits
  }

  /** Returns the default bounds, which take linear time for each new distance. */
  #defaultBounds(maxDistance: number | undefined): ConvexPolygon {
    let bounds = this.#bounds.get(maxDistance)
    if (bounds === undefined) {
      // A slider passes many distances.
      if (this.#bounds.size === MOST_BOUNDS) this.#bounds.clear()
      bounds = ConvexPolygon.of(exportBoxOf(this, maxDistance))
      this.#bounds.set(maxDistance, bounds)
    }
    return bounds
  }

  #checkCircle(i: number, caller: string): void {
    checkIndex(i, this.circles.length / 3, caller, 'circle')
  }
}

/** Returns the area or the perimeter of an outline; infinity for that of an unbounded cell. */
function sizeOf(outline: Outline | undefined, measure: (outline: Outline) => number): number {
  return outline === undefined ? Number.POSITIVE_INFINITY : measure(outline)
}

/** Returns the centroid of an outline that has an area. */
function centroidInside(outline: Outline | undefined): Point | undefined {
  return outline !== undefined && areaOf(outline) > 0 ? centroidOf(outline) : undefined
}

/** Whether a polygon is a box with the four numbers of `bounds`. */
function isBoxOf({ isBox, box }: ConvexPolygon, bounds: Bounds): boolean {
  if (!isBox || !Array.isArray(bounds) || bounds.length !== 4) return false
  const { minX, minY, maxX, maxY } = box
  return bounds[0] === minX && bounds[1] === minY && bounds[2] === maxX && bounds[3] === maxY
}

/** The largest number of default bounds that are kept. */
const MOST_BOUNDS = 8

/** The number of cells that are clipped together in the time of one cell alone. */
const CELLS_FOR_ONE = 64

function numberOf(value: unknown): number {
  checkNumber(value, 'findAll', 'a coordinate')
  return value as number
}

/**
 * Pairs the half-edges of the triangles. The half-edge from the k-th circle to the next one crosses the edge between
 * them.
 */
function halfedgesOf({ vertexCircles, edges, vertexSides }: DiagramData): Int32Array {
  // For each side, the half-edge that crosses it at its start: from the previous circle to its own circle.
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
