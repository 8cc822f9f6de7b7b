// SPDX-License-Identifier: GPL-3.0-or-later
// The requests of views to the painting thread, and its events. A scene holds the circles of one view; a thread has many
// scenes.
import type { PostedError } from '../lib/base/errors.ts'
import type {
  Box,
  Certificate,
  Circle,
  DiagramData,
  Edit,
  Float64s,
  Lattice,
  Options,
  Point,
  Stats,
  Vertex,
} from '../lib/index.ts'
import type { RegionShape } from '../lib/regions/region-shape.ts'
import type { TraceArrays, TraceOptions } from '../lib/wasm/trace.ts'
import type { CompiledWasm } from '../lib/wasm/wasm.ts'
import type { CircleChange, KeptIds } from './circle-table.ts'
import type { DiagramCounts } from './diagram-counts.ts'
import type { Name } from './labels.ts'
import type { CellColors, Measure, PaintedLayers } from './layers.ts'
import type { OtherModules } from './load.ts'
import type { Frame } from './painter/frame.ts'
import type { Style } from './style.ts'

/**
 * A grid of device pixels fixed to the plane: pixel (column, row) has its corner at the anchor + (column, -row) /
 * scale. Panning keeps the grid; another scale or style needs a new one.
 */
export interface Grid {
  readonly id: number
  /** The point of the plane at the corner (0, 0). */
  readonly x: number
  readonly y: number
  /** Device pixels per unit. */
  readonly scale: number
  /** Device pixels per CSS pixel. */
  readonly pixelRatio: number
}

/** A box of pixels of a grid: starts at (left, top), rows downward. */
export interface PixelBox {
  readonly left: number
  readonly top: number
  readonly width: number
  readonly height: number
}

/**
 * Size of the squares in which pixels are painted, small enough that an edit does not wait long for the current one.
 */
export const TILE = 256

/** A paint request: the visible pixels `seen` first, then their surroundings `wanted`. */
export interface PaintRequest {
  /** The number of the request. */
  readonly paintId: number
  readonly grid: Grid
  readonly seen: PixelBox
  readonly wanted: PixelBox
}

/** The settings that change together with an opening or an edit. */
export interface DomainChange {
  /** The new clipping region; `null` removes it, `undefined` keeps it. */
  readonly region?: RegionShape | null | undefined
  /** The new periods; `null` removes them, `undefined` keeps them. */
  readonly lattice?: Lattice | null | undefined
  /** Whether circles are drawn as points, because their radii are only weights. */
  readonly areSites?: boolean | undefined
  /** The colors of the circles afterwards, by ascending id (`Coloring`); `undefined` keeps those that are known. */
  readonly colors?: string | undefined
  /** The lasting parts of the picture, if another thread had the same circles. */
  readonly lasting?: Lasting | undefined
}

/** The parts of a picture that depend on the circles as they were opened, so that no edit changes all of it. */
export interface Lasting {
  /** The meaning of the colors `auto`. */
  readonly automatic: CellColors
  /** The approximate distance between neighboring circles, on which the width of edges depends. */
  readonly cellWidth: number
}

/**
 * The questions about a view's circles. `undefined` means that there is no answer, or that a drawing was impossible.
 */
export interface Questions {
  /** A circle in the nearest free room between circles; `undefined` if there is none. */
  room(x: number, y: number): Circle | undefined
  /** The disc at the nearest vertex or point of an edge, within `slack`. */
  touch(x: number, y: number, slack: number): Touching | undefined
  /** The area that a new circle would take. */
  try(circle: Circle): Trial | undefined
  /** A frame as SVG without highlights, once all results are known. `names` are tooltips. */
  svg(frame: Frame, style: Style, names: readonly Name[]): DrawnSvg | undefined
  /** A frame as a bitmap without highlights. */
  image(frame: Frame, pixelRatio: number, style: Style): ImageBitmap | undefined
  /** The meaning of the colors; `undefined` if they show no measure. */
  legend(): Legend | undefined
  /** The distribution of cells, computed in steps. */
  measure(): Distribution
  /** Measures of circles and cells: for given ids at once, for all in steps. */
  tabulate(columns: readonly Column[], ids: Int32Array | undefined): Tabulated
  /** Counts of the diagram, and descriptions of some cells. */
  tell(ids: readonly number[]): Facts
}

/** The long computations with a view's circles, which run in threads of their own. */
export interface Computations {
  /** Fits the radii of circles so that each cell has its share of a region. In `shares`, NaN stands for the mean. */
  fit(circles: Float64Array, shares: readonly number[], region: RegionShape): Fit
  /** Recomputes everything from scratch for statistics. */
  compute(options: Options): Computed
  /** The events of a method. */
  trace(options: TraceOptions): Traced
}

/** The elements of an SVG, and the global results to draw above them. */
export interface DrawnSvg {
  readonly elements: string
  readonly found: GlobalResults
}

/** The functions of each thread. `start` is the first request. */
interface ThreadRequests {
  start(module: CompiledWasm, others: OtherModules): void
}

/** The functions of the painting thread. All but `start` take the number of a scene. */
export interface PainterRequests extends ThreadRequests, SceneQuestions {
  /** Adds a scene without circles. */
  add(scene: number): void
  /**
   * Replaces the circles. Without `kept`, circle i gets id i. `opening` identifies the circles. Their edits carry the
   * same number.
   */
  open(scene: number, opening: number, circles: Float64Array, kept: KeptIds | undefined, change: DomainChange): Opened
  /** Applies all edits or none. Returns `undefined` if the edits are for circles that have been replaced. */
  edit(scene: number, opening: number, edits: readonly Edit[], change: DomainChange): EditedPicture | undefined
  look(scene: number, request: PaintRequest, style: Style): void
  /** Sets the layers. `isPainted`: they change the painting, not only the global results. */
  layers(scene: number, layers: PaintedLayers, isPainted: boolean): void
  /** Sets the highlighted circles. Their descriptions follow now and after each edit. */
  mark(scene: number, selected: number | undefined, hovered: number | undefined): Highlights
  close(scene: number): void
}

type SceneQuestions = {
  readonly [Name in keyof Questions]: (
    scene: number,
    ...args: Parameters<Questions[Name]>
  ) => ReturnType<Questions[Name]>
}

/** The functions of a computing thread. */
export interface ComputingRequests extends ThreadRequests, Pick<Computations, 'fit'> {
  /** Computes the diagram of the circles, and of their images if they repeat. */
  compute(circles: Float64Array, lattice: Lattice | undefined, options: Options): Computed
  /** Traces a method in the plane, without images. The circles are in ascending order of their ids. */
  trace(circles: Float64Array, ids: Int32Array, options: TraceOptions): Traced
}

/** Pixels of one revision. A patch never mixes revisions. */
export interface Patch {
  readonly box: PixelBox
  readonly image: ImageBitmap
}

/** The result of opening circles. */
export interface Opened {
  readonly counts: DiagramCounts
  readonly seconds: number
  /** The circles if they have changed, because they repeat. */
  readonly circles: Float64s | undefined
  readonly colors: string | undefined
  readonly lasting: Lasting
}

/** The result of an edit, and what it changed in the picture. */
export interface EditedPicture extends Omit<Opened, 'circles'> {
  readonly kind: 'edited'
  readonly grid: number
  readonly patches: readonly Patch[]
  /** Boxes around the visible difference. */
  readonly boxes: readonly Box[]
  readonly change: CircleChange
  readonly marks: Highlights
  /** `undefined`: not computed yet. */
  readonly found: GlobalResults | undefined
}

/** Tiles for a paint request. */
export interface PaintedTiles {
  readonly kind: 'painted'
  readonly grid: number
  readonly patches: readonly Patch[]
  /** The number of the paint request. */
  readonly paintId: number
  /** Whether the request is complete. */
  readonly isWhole: boolean
}

/** The changes of a picture. */
export type Painted = PaintedTiles | EditedPicture

/** The events of the painting thread. All are about one scene. */
export interface PainterEvents {
  readonly painted: PaintedTiles & { readonly scene: number }
  readonly found: { readonly scene: number; readonly found: GlobalResults }
  /** The same highlights with outlines for the current viewport and layers. */
  readonly outlined: { readonly scene: number; readonly marks: Highlights }
  /** Painting or a search for global results failed. The scene stays. */
  readonly failed: { readonly scene: number; readonly error: PostedError }
}

/** The accuracy of fitted areas. */
export interface Fitted {
  /** The largest relative error of an area. */
  readonly error: number
  readonly steps: number
}

/** The circles with fitted radii. */
export interface Fit {
  readonly circles: Float64s
  readonly fitted: Fitted
  /** The computing time. */
  readonly seconds: number
}

/** The description of a circle and its cell. */
export interface CellFacts extends Circle {
  /** Whether another circle contains the circle, so that it has no cell. */
  readonly hidden: boolean
  readonly bounded: boolean
  /** The number of edges of the cell. */
  readonly edges: number
  /** The ids of the neighbors, each once. */
  readonly neighbors: readonly number[]
  /** The area of the cell inside the region, if there is one; infinite for an unbounded cell. */
  readonly area: number
  /** The perimeter of the cell inside the region, if there is one; infinite for an unbounded cell. */
  readonly perimeter: number
}

/** The description of a diagram. */
export interface Facts extends DiagramCounts {
  /** The requested cells. Missing circles have no entry. */
  readonly cells: ReadonlyMap<number, CellFacts>
}

export interface Described {
  readonly id: number
  readonly circle: Circle
  /** The CSS color of the circle or its cell, if it has one. */
  readonly color: string | undefined
  readonly hiddenBy: number | undefined
  readonly isBounded: boolean
  readonly neighbors: Int32Array
  /** The area and the perimeter of the selected cell inside its limits; infinite without an end. */
  readonly size?: { readonly area: number; readonly perimeter: number } | undefined
  /** The outline of the cell within the viewport (`replay`). */
  readonly outline: Float64Array
  /** The outlines of the neighbors' cells. */
  readonly neighborhood: Float64Array
}

/** A disc that touches circles, and the contact points. It meets no other circle of the diagram. */
export interface Touching {
  readonly disc: Vertex
  readonly points: readonly Point[]
}

/** The effect of a circle that has not been inserted. */
export interface Trial {
  readonly circle: Circle
  /** The circle that would hide the new one; `undefined` if it has a cell. */
  readonly hiddenBy: number | undefined
  /** The outline of the new cell (`replay`). */
  readonly outline: Float64Array
  readonly area: number
  /** The circles that lose area, the greatest loss first. */
  readonly taken: readonly Taken[]
}

/** The area that a new circle would take from another one, whose center is x, y. */
export interface Taken extends Point {
  readonly id: number
  /** Infinite for an unbounded part, NaN if unknown. */
  readonly area: number
}

/** The results for layers that depend on all circles. */
export interface GlobalResults {
  /**
   * The arcs of the hull, with six numbers each: the circle's x, y and radius, the start angle, the turn, and the start
   * of the next arc.
   */
  readonly hull: Float64Array | undefined
  /** The largest empty disc, with the ids of the circles that it touches. */
  readonly largestDisc: (Touching & { readonly circles: readonly number[] }) | undefined
  /** The clearance of the path and its outline (`replay`). */
  readonly path: { readonly clearance: number; readonly outline: Float64Array } | undefined
  /** The touching disc method's result compared with the diagram. */
  readonly method: MethodFound | undefined
}

/** The number of parts, of those found, and of wrong ones. */
export interface Counted {
  readonly all: number
  readonly found: number
  readonly wrong: number
}

export interface MethodFound {
  readonly vertices: Counted
  readonly edges: Counted
  /** The total number of samples; 0 if all pairs are candidates. */
  readonly samples: number
}

/** The numbers of cells by class. */
export interface Distribution {
  /** Indexed by the number of neighbors. */
  readonly degrees: Int32Array
  /** The bounded cells in equal classes of area from 0. The last class includes all larger areas. */
  readonly areas: Int32Array
  /** The width of a class; 0 without cells. */
  readonly areaStep: number
  readonly medianArea: number
  readonly certificate: Certificate
}

/** The meaning of the color ramp. */
export interface Legend {
  /** `column` stands for a client's values, which have a name (`CellValues`). */
  readonly measure: Measure | 'column'
  readonly name?: string | undefined
  /** The categories with a color each, in the order of the colors, and whether further categories have none. */
  readonly categories?: readonly string[] | undefined
  readonly hasOthers?: boolean | undefined
  /** The values at the beginning, the quarters and the end of the ramp. */
  readonly knots: readonly number[]
  /** Whether values may lie beyond the ends of the ramp. They get the colors of the ends. */
  readonly isClipped: boolean
}

/** A measure of a cell: its area, its number of neighbors, or the distance to the nearest other circle. */
export type Column = 'area' | 'degree' | 'gap'

/** Values by circle: NaN for a hidden circle, infinity for an unbounded area. */
export interface Tabulated {
  readonly ids: Int32Array
  /** The values of each requested column. */
  readonly columns: readonly Float64Array[]
}

/** The statistics of a computation, or the reason why it failed. */
export type Computed = { readonly stats: Stats; readonly certificate: Certificate } | { readonly problem: string }

/** The trace of a method. */
export interface Traced {
  /** The circles before the method, x, y and r each, by ascending id, and these ids. */
  readonly circles: Float64Array
  readonly ids: Int32Array
  /** The resulting diagram. Its circle i has the i-th id. */
  readonly diagram: DiagramData
  /** The events name circles by id. */
  readonly events: TraceArrays
}

export interface Highlights {
  readonly selected: Described | undefined
  readonly hovered: Described | undefined
}
