// SPDX-License-Identifier: GPL-3.0-or-later
// The types of the exports of cpp/wasm/bindings.cpp, metrics_bindings.cpp and files_bindings.cpp.

type WasmError = import('./wasm.ts').WasmError

interface WasmOptions {
  readonly weights: boolean | undefined
  readonly method: string | undefined
  readonly candidates: string | undefined
  readonly samples: number | undefined
  readonly resample: boolean | undefined
  /** Whether to go on; must not throw. */
  readonly progress: ((...told: Parameters<import('./options.ts').Progress>) => boolean) | undefined
}

type WasmDiagram = Omit<import('../base/types.ts').DiagramData, 'metric' | 'circles'>

type JudgedArrays = Omit<import('../base/types.ts').DiagramData, 'metric' | 'certificate' | 'stats'>

interface WasmPeriodicDiagram {
  readonly diagram: WasmDiagram
  readonly circles: import('../base/types.ts').Float64s
  /** ax, ay, bx, by */
  readonly lattice: Float64Array
  readonly circleOf: import('../base/types.ts').Int32s
  readonly shiftOf: import('../base/types.ts').Int32s
}

interface WasmModule {
  compute(circles: Float64Array, options: WasmOptions): WasmError | WasmDiagram
  /** `lattice`: ax, ay, bx, by. */
  computePeriodic(circles: Float64Array, lattice: Float64Array, options: WasmOptions): WasmError | WasmPeriodicDiagram
  trace(
    circles: Float64Array,
    options: WasmOptions,
  ): WasmError | { readonly diagram: WasmDiagram; readonly events: import('./trace.ts').TraceArrays }
  traceKindNames(): string[]
  certify(diagram: JudgedArrays): WasmError | import('../base/types.ts').Certificate
  /** `box`: minX, minY, maxX, maxY. */
  finalCells(diagram: JudgedArrays, box: Float64Array, maxRadius: number): WasmError | import('./library.ts').FinalCells
  errorCodeNames(): string[]

  /** No ids stand for 0, 1 and so on; -1 as `nextId` for one more than the largest id. */
  createEditor(
    circles: Float64Array,
    weights: boolean,
    ids: Int32Array,
    nextId: number,
  ): WasmError | { readonly editor: number }
  deleteEditor(editor: number): void
  // cpp/wasm/editor_bindings.cpp describes the bytes of a change; they are valid until the next call.
  /** `kind`: 0 insert, 1 remove, 2 replace. */
  editCircle(
    editor: number,
    kind: number,
    id: number,
    x: number,
    y: number,
    r: number,
    hint: number,
  ): WasmError | Uint8Array
  /** For each edit its kind, id, x, y and r. */
  applyEdits(editor: number, edits: Float64Array): WasmError | Uint8Array
  /** Applies edits and returns their events; the change is not reported. */
  traceEdits(editor: number, edits: Float64Array): WasmError | import('./trace.ts').TraceArrays
  nearestCircle(editor: number, x: number, y: number, hint: number): number
  editorSize(editor: number): number
  /** Returns x, y, r and whether the circle is hidden. */
  circleOfEditor(editor: number, id: number): Float64Array | undefined
  idsOfEditor(editor: number): WasmError | import('../base/types.ts').Int32s
  snapshotOfEditor(editor: number):
    | WasmError
    | (Omit<import('../base/types.ts').DiagramData, 'metric' | 'numbers'> & {
        readonly numbers: Omit<import('../base/types.ts').SnapshotNumbers, 'revision'>
      })
  certificateOfEditor(editor: number): WasmError | import('../base/types.ts').Certificate
}

interface WasmMetricsModule {
  powerDiagram(
    circles: Float64Array,
    weights: boolean,
    reporter: import('./reporting.ts').Reporter | undefined,
  ): WasmError | (WasmDiagram & { readonly circles: import('../base/types.ts').Float64s })
  /** `lattice`: ax, ay, bx, by. */
  periodicPower(
    circles: Float64Array,
    lattice: Float64Array,
    weights: boolean,
    reporter: import('./reporting.ts').Reporter | undefined,
  ): WasmError | WasmPeriodicDiagram
  certifyPower(diagram: JudgedArrays): WasmError | import('../base/types.ts').Certificate
  /** Returns the circles rounded. */
  validCircles(
    circles: Float64Array,
    weights: boolean,
  ): WasmError | { readonly circles: import('../base/types.ts').Float64s }
}

interface WasmRegionsModule {
  createRegion(
    points: Float64Array,
    ringOffsets: Int32Array,
    polygonOffsets: Int32Array | undefined,
    dissolve: boolean,
  ):
    | WasmError
    | ({ readonly address: number } & Pick<
        import('../regions/region.ts').Region,
        'points' | 'ringOffsets' | 'polygonOffsets' | 'area' | 'perimeter'
      >)
  deleteRegion(region: number): void
  regionContains(region: number, x: number, y: number): boolean
  createClip(
    region: number,
    diagram: JudgedArrays & { readonly metric: string },
    maxDistance: number | undefined,
  ): WasmError | { readonly address: number }
  deleteClip(clip: number): void
  /** Returns one cell of the diagram of a few circles, and the sides of that diagram. */
  clipCell(
    region: number,
    circles: Float64Array,
    weights: boolean,
    chosen: number,
    maxDistance: number | undefined,
  ): WasmError | (import('../regions/few-circles.ts').Sides & import('../regions/region.ts').MeasuredCells)
  /**
   * Clips the cell of the first point. `points` are circles of radius 0. Row i belongs to point i, and only row 0 has
   * polygons.
   */
  clipFirstCell(region: number, points: Float64Array): WasmError | import('../regions/region.ts').ClippedPolygons
  clippedCells(clip: number): WasmError | import('../regions/region.ts').ClippedCells
  clippedEdges(clip: number): WasmError | import('../regions/region.ts').ClippedEdges
  clippedAreas(clip: number): WasmError | Float64Array<ArrayBuffer>
  clippedCentroids(clip: number): WasmError | Float64Array<ArrayBuffer>
  clippedPerimeters(clip: number): WasmError | Float64Array<ArrayBuffer>
  /** x, y and r of the disc, and three circles or -1; both are empty if there is none. */
  clippedLargestEmptyDisc(clip: number): WasmError | { readonly disc: Float64Array; readonly circles: Int32Array }
  clippedLargestEmptyDiscInside(clip: number): WasmError | { readonly disc: Float64Array; readonly circles: Int32Array }
  /** The path from one point to another; `found` is false between different parts of the region. */
  clippedClearestPath(
    clip: number,
    x: number,
    y: number,
    toX: number,
    toY: number,
  ): WasmError | { readonly found: false } | ({ readonly found: true } & import('../regions/region.ts').ClippedPath)
  clippedPolygons(clip: number, tolerance: number): WasmError | import('../regions/region.ts').ClippedPolygons
  /** `domain`: a region, or a lattice as ax, ay, bx, by. `sites`: x, y and the weight of each. */
  fitAreas(
    domain: number | Float64Array,
    sites: Float64Array,
    areas: Float64Array,
    options: {
      readonly metric: string
      readonly shares: boolean
      readonly tolerance: number
      readonly maxSteps: number
      readonly relax: number
      /** Whether to go on; must not throw. */
      readonly onStep: (steps: number, error: number, weights: Float64Array<ArrayBuffer>) => boolean
    },
  ):
    | WasmError
    | (WasmFit & {
        readonly circles: import('../base/types.ts').Float64s
        readonly diagram: WasmDiagram
      })
    | (WasmFit & { readonly periodic: WasmPeriodicDiagram })
  treemap(
    region: number,
    parents: Int32Array,
    values: Float64Array,
    options: Omit<import('./treemap.ts').TreemapInput, 'parents' | 'values'> & {
      /** Whether to go on; must not throw. */
      readonly progress: (done: number, count: number) => boolean
    },
  ): WasmError | import('./treemap.ts').TreemapArrays
}

interface WasmFit {
  readonly weights: Float64Array<ArrayBuffer>
  readonly areas: Float64Array<ArrayBuffer>
  readonly relativeError: number
  readonly steps: number
  readonly tolerance: number
}

/** The options of writers. Missing options have their defaults. `bounds`: minX, minY, maxX, maxY. */
interface WasmWriteOptions {
  readonly bounds: Float64Array | undefined
  readonly region: import('../regions/region-shape.ts').RingArrays | undefined
  readonly maxDistance: number | undefined
  readonly tolerance: number | undefined
  readonly digits: number | undefined
  readonly attributes: WasmAttributes | undefined
}

/** Selects the columns of circles. An empty name stands for the usual names. */
interface WasmReadOptions {
  readonly weights: boolean
  readonly points: boolean
  readonly skipInvalid: boolean
  readonly crs: string
  readonly x: string
  readonly y: string
  readonly radius: string
  readonly id: string
}

/** The attributes of circles as JSON: one line for each circle, or an empty text. Objects have no braces. */
interface WasmAttributes {
  readonly properties: string
  readonly ids: string
  readonly heights: string
  readonly collection: string
}

interface WasmFilesModule {
  readCircles(
    text: string | Uint8Array,
    name: string,
    options: WasmReadOptions,
  ): WasmError | { readonly circles: import('../base/types.ts').Float64s }
  readCircleFile(
    text: string | Uint8Array,
    name: string,
    options: WasmReadOptions,
  ):
    | WasmError
    | {
        readonly circles: import('../base/types.ts').Float64s
        readonly attributes: WasmAttributes
        readonly areDegrees: boolean
        readonly skipped: readonly { readonly circle: number; readonly message: string }[]
      }
  readDiagram(
    text: string | Uint8Array,
    name: string,
  ): WasmError | (import('../base/types.ts').DiagramData & { readonly attributes: WasmAttributes })
  holdsDiagram(text: string | Uint8Array): boolean
  writeCircles(
    circles: Float64Array,
    format: string,
    attributes: WasmAttributes | undefined,
  ): WasmError | { readonly text: Uint8Array }
  writeDiagram(
    diagram: Omit<import('../base/types.ts').DiagramData, 'certificate'>,
    format: string,
    options: WasmWriteOptions,
  ): WasmError | { readonly text: Uint8Array }
}

declare module '*/generated/circle-voronoi-files.js' {
  export default function createModule(options: import('./wasm.ts').EmscriptenOptions): Promise<WasmFilesModule>
}

declare module '*/generated/circle-voronoi.js' {
  export default function createModule(options: import('./wasm.ts').EmscriptenOptions): Promise<WasmModule>
}

declare module '*/generated/circle-voronoi-regions.js' {
  export default function createModule(options: import('./wasm.ts').EmscriptenOptions): Promise<WasmRegionsModule>
}

declare module '*/generated/circle-voronoi-sphere.js' {
  export default function createModule(options: import('./wasm.ts').EmscriptenOptions): Promise<object>
}

declare module '*/generated/circle-voronoi-metrics.js' {
  export default function createModule(options: import('./wasm.ts').EmscriptenOptions): Promise<WasmMetricsModule>
}

// Exists only in bundles: gzip as base64.
declare module '*/generated/circle-voronoi-metrics.wasm' {
  const compressed: string
  export default compressed
}

declare module '*/generated/circle-voronoi-regions.wasm' {
  const compressed: string
  export default compressed
}

declare module '*/generated/circle-voronoi.wasm' {
  const compressed: string
  export default compressed
}

/** Exists only in the element's script: the text of its thread. */
declare module '*/painter.thread' {
  const text: string
  export default text
}
