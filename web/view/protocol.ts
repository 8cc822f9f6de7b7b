// SPDX-License-Identifier: GPL-3.0-or-later
// What goes between a view and the painter's thread. A scene is one view's circles; a thread has many.
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
import type { CircleChange } from './circle-table.ts'
import type { DiagramCounts } from './diagram-counts.ts'
import type { Layers, Measure } from './layers.ts'
import type { OtherModules } from './load.ts'
import type { Frame } from './painter/frame.ts'
import type { RemoteCall, RemoteReply } from './remote-calls.ts'
import type { Style } from './style.ts'

/**
 * A fixed grid of device pixels on the plane: pixel (column, row) has its corner at the anchor + (column, -row) / scale. While
 * a view pans, its grid stays; with another scale or style it has another.
 */
export interface Grid {
  readonly id: number
  /** The plane's point of the corner that is (0, 0). */
  readonly x: number
  readonly y: number
  /** Device pixels per unit. */
  readonly scale: number
  /** Device pixels per CSS pixel. */
  readonly pixelRatio: number
}

/** Pixels of a grid: from (left, top) on, rows downwards. */
export interface PixelBox {
  readonly left: number
  readonly top: number
  readonly width: number
  readonly height: number
}

/** Pixels are painted in squares of this size: small enough for an edit not to wait long between two. */
export const TILE = 256

/** What is to be seen from now on: the pixels of `seen`, and around them, once there is time, `wanted`. */
export interface Wish {
  /** Which wish it is. */
  readonly wish: number
  readonly grid: Grid
  readonly seen: PixelBox
  readonly wanted: PixelBox
}

/** What becomes other than circles where they are opened or edited. */
export interface DomainChange {
  /** What the cells are cut to from now on; `null`: nothing. `undefined`: as before. */
  readonly region?: RegionShape | null | undefined
  /** The periods with which circles repeat from now on; `null`: they do not. `undefined`: as before. */
  readonly lattice?: Lattice | null | undefined
  /** The circles get the radii with which each cell has its share of the region. */
  readonly fit?: Shares | undefined
  /** Whether circles are shown as points from now on, because their radii are only weights. */
  readonly areSites?: boolean | undefined
}

/** Shares of a region, as numbers above 0; `undefined`: all have the same. */
export interface Shares {
  /** Those of circles that are there, by their ids. Who is not named gets the mean of the others. */
  readonly known: ReadonlyMap<number, number> | undefined
  /** Those of circles that an edit inserts, in their order. */
  readonly inserted: readonly number[]
}

/** What a view asks of its circles in the painter's thread. `undefined`: there is nothing, or it could not be drawn. */
export interface Questions {
  /** The circle at a point of the plane; `slack`: how near counts as on it, in units. */
  hit(x: number, y: number, slack: number): Hit | undefined
  /** The disc around the vertex or the point of an edge next to a point of the plane, no farther than `slack`. */
  touch(x: number, y: number, slack: number): Touching | undefined
  /** What a circle would take. */
  try(circle: Circle): Trial | undefined
  /** What a frame shows without what stands out, once all of it is known. */
  svg(frame: Frame, style: Style): DrawnSvg | undefined
  /** The same in pixels. */
  image(frame: Frame, pixelRatio: number, style: Style): ImageBitmap | undefined
  /** What the colors of the layers mean. `undefined`: no measure. */
  legend(): Legend | undefined
  /** How cells are distributed: a moment later, where there are many. */
  measure(): Distribution
  /** What circles and their cells measure: of these ids at once, of all a moment later. */
  tabulate(columns: readonly Column[], ids: Int32Array | undefined): Tabulated
  /** What is so of the diagram and of the cells of some circles. */
  tell(ids: readonly number[]): Facts
  /** All computed once more from nothing, to see how. */
  compute(options: Options): Computed
  /** What a method does with the circles, event by event. */
  trace(options: TraceOptions): Traced
}

/** What a thread was doing when it failed. `find`: what depends on all circles. */
export interface InProgress {
  readonly scene: number
  readonly kind: ToPainter['kind'] | 'paint' | 'find'
}

/** The elements of an SVG, and what is drawn above them that depends on all circles. */
export interface DrawnSvg {
  readonly elements: string
  readonly found: Found
}

export type ToPainter =
  | { readonly kind: 'start'; readonly module: CompiledWasm; readonly others: OtherModules }
  /** A scene without circles. What is for none that is there is not heard. */
  | { readonly kind: 'add'; readonly scene: number }
  /** Other circles; circle i gets id i. */
  | ({
      readonly kind: 'open'
      readonly scene: number
      readonly revision: number
      /** The number of these circles. Their edits carry it. */
      readonly opening: number
      readonly circles: Float64Array
    } & DomainChange)
  /** All or none. */
  | ({
      readonly kind: 'edit'
      readonly scene: number
      readonly revision: number
      /** The number of the circles that the edits are for. If other circles are there, nothing is edited. */
      readonly opening: number
      readonly edits: readonly Edit[]
    } & DomainChange)
  | ({ readonly kind: 'look'; readonly scene: number; readonly style: Style } & Wish)
  /** What is asked by its name, and what is given with it. */
  | ({ readonly kind: 'ask'; readonly scene: number } & RemoteCall<keyof Questions>)
  /** What is drawn; `isPainted`: not only what is found (`Found`) is another. */
  | { readonly kind: 'layers'; readonly scene: number; readonly layers: Layers; readonly isPainted: boolean }
  /** Which circles stand out; what is known of them comes now and with each edit. */
  | {
      readonly kind: 'mark'
      readonly scene: number
      readonly selected: number | undefined
      readonly hovered: number | undefined
    }
  | { readonly kind: 'close'; readonly scene: number }

/** What is drawn is that of a revision: one that is all of it. */
export interface Patch {
  readonly box: PixelBox
  readonly image: ImageBitmap
}

export type FromPainter =
  | {
      readonly kind: 'opened'
      readonly scene: number
      readonly revision: number
      readonly counts: DiagramCounts
      readonly seconds: number
      /** Those with radii that were fitted. */
      readonly circles?: Float64s | undefined
      readonly fitted?: Fitted | undefined
      readonly change?: undefined
    }
  | {
      readonly kind: 'edited'
      readonly scene: number
      readonly revision: number
      readonly counts: DiagramCounts
      readonly grid: number
      readonly patches: readonly Patch[]
      /** Around all that looks different. */
      readonly boxes: readonly Box[]
      readonly change: CircleChange
      readonly marks: Marks
      /** `undefined`: not yet. */
      readonly found: Found | undefined
      readonly fitted?: Fitted | undefined
      readonly seconds: number
    }
  | { readonly kind: 'refused'; readonly scene: number; readonly revision: number; readonly error: PostedError }
  /** The edits were for circles that are no longer there. */
  | { readonly kind: 'superseded'; readonly scene: number; readonly revision: number }
  | {
      readonly kind: 'painted'
      readonly scene: number
      readonly grid: number
      readonly patches: readonly Patch[]
      /** The wish that is painted. */
      readonly wish: number
      /** Whether all of that is painted now. */
      readonly isWhole: boolean
    }
  | ({ readonly kind: 'answer' } & RemoteReply)
  | { readonly kind: 'found'; readonly scene: number; readonly found: Found }
  | { readonly kind: 'marked'; readonly scene: number; readonly marks: Marks }
  /** The same, with outlines for what is looked at now. */
  | { readonly kind: 'outlined'; readonly scene: number; readonly marks: Marks }
  /** The thread cannot go on. `during`: what it was doing, if that was for one scene. */
  | { readonly kind: 'failed'; readonly message: string; readonly during?: InProgress | undefined }

/** How near areas are to what was asked for. */
export interface Fitted {
  /** The largest error, relative to the area. */
  readonly error: number
  readonly steps: number
}

/** What is so of a circle and its cell. */
export interface CellFacts extends Circle {
  /** Whether another circle contains it: then it has no cell. */
  readonly hidden: boolean
  readonly bounded: boolean
  /** How many edges its cell has. */
  readonly edges: number
  /** Whose cells these are shared with: the ids, each once. */
  readonly neighbors: readonly number[]
  /** That inside the region, if there is one. Infinite, if the cell is not bounded. */
  readonly area: number
  /** Likewise. */
  readonly perimeter: number
}

/** What is so of a diagram. */
export interface Facts extends DiagramCounts {
  /** Those that were asked for; there is none of circles that are not there. */
  readonly cells: ReadonlyMap<number, CellFacts>
}

/** The circle under the pointer, and which part of it: its rim, its disc, or only its cell. */
export interface Hit {
  readonly id: number
  readonly part: 'rim' | 'disc' | 'cell'
}

export interface Described {
  readonly id: number
  readonly circle: Circle
  readonly hiddenBy: number | undefined
  readonly isBounded: boolean
  readonly neighbors: Int32Array
  /** The outline of the cell within the box that is looked at (`replay`). */
  readonly outline: Float64Array
  /** Those of the neighbors. */
  readonly neighborhood: Float64Array
}

/** A disc that touches circles, and where: in a diagram it meets no other. */
export interface Touching {
  readonly disc: Vertex
  readonly points: readonly Point[]
}

/** What a circle would take that is not there yet. */
export interface Trial {
  readonly circle: Circle
  /** The circle that would hide it; `undefined`: it has a cell. */
  readonly hiddenBy: number | undefined
  /** That of its cell (`replay`). */
  readonly outline: Float64Array
  readonly area: number
  /** From whom, the most first. */
  readonly taken: readonly Taken[]
}

/** What a circle would take from another one, whose center is x, y. */
export interface Taken extends Point {
  readonly id: number
  /** Infinite where a part has no end, NaN where that is not known. */
  readonly area: number
}

/** What the layers show that depends on all circles. */
export interface Found {
  /** For each arc of the hull its circle's x, y and radius, the angle where it begins, its turn, and the start of the next one. */
  readonly hull: Float64Array | undefined
  /** With the ids of the circles it touches. */
  readonly largestDisc: (Touching & { readonly circles: readonly number[] }) | undefined
  /** How near the clearest path comes to a circle, and the path (`replay`). */
  readonly path: { readonly clearance: number; readonly outline: Float64Array } | undefined
  /** What the touching disc method finds of the diagram. */
  readonly method: MethodFound | undefined
}

/** How many there are, how many of them are found, and how many others that are none. */
export interface Counted {
  readonly all: number
  readonly found: number
  readonly wrong: number
}

export interface MethodFound {
  readonly vertices: Counted
  readonly edges: Counted
  /** Of all circles; 0: all pairs are looked at. */
  readonly samples: number
}

/** How many cells there are of each kind. */
export interface Distribution {
  /** Of each number of neighbors. */
  readonly degrees: Int32Array
  /** Of those that do not go to infinity, in classes of one width from 0 on; what is larger is in the last one. */
  readonly areas: Int32Array
  /** The width of a class, 0 if there is no cell. */
  readonly areaStep: number
  readonly medianArea: number
  readonly certificate: Certificate
}

/** What the ramp of colors means. */
export interface Legend {
  /** `column`: values that a client gives, which have a name (`CellValues`). */
  readonly measure: Measure | 'column'
  readonly name?: string | undefined
  /** The categories that have a color each, in the order of the colors, and whether there are others, which have none. */
  readonly categories?: readonly string[] | undefined
  readonly hasOthers?: boolean | undefined
  /** What its beginning, its quarters and its end stand for. */
  readonly knots: readonly number[]
  /** Whether there may be smaller and larger values than those of its ends, which have their colors. */
  readonly isClipped: boolean
}

/** What a cell measures: its area, how many neighbors it has, and how far the circle is from the nearest other one. */
export type Column = 'area' | 'degree' | 'gap'

/** Numbers of circles: of a hidden one NaN, of an area without end infinity. */
export interface Tabulated {
  readonly ids: Int32Array
  /** For each column that was asked for those of the circles. */
  readonly columns: readonly Float64Array[]
}

/** How a diagram was computed, and what came of it; or why it could not be. */
export type Computed = { readonly stats: Stats; readonly certificate: Certificate } | { readonly problem: string }

/** What a method did with circles. */
export interface Traced {
  /** The circles before, x, y, r each, by increasing ids, and these. */
  readonly circles: Float64Array
  readonly ids: Int32Array
  /** What came of it: circle i has the i-th of the ids. */
  readonly diagram: DiagramData
  /** Circles are named by their ids. */
  readonly events: TraceArrays
}

export interface Marks {
  readonly selected: Described | undefined
  readonly hovered: Described | undefined
}
