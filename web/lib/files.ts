// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Reads and writes the files of the command line, with the same bytes.
 *
 * @module circle-voronoi/files
 */
import {
  checkDigits,
  checkMaxDistance,
  checkMemory,
  checkOptionNames,
  checkTolerance,
  isRecord,
  refuseInput,
  refuseOption,
  shown,
} from './base/check.ts'
import { type Circles, coordinatesOf } from './base/coordinates.ts'
import type { Box, DiagramData, Float64s } from './base/types.ts'
import { Diagram } from './diagram/diagram.ts'
import { statsOf } from './diagram/diagram-file.ts'
import createModule from './generated/circle-voronoi-files.js'
import { ConvexPolygon } from './regions/convex-polygon.ts'
import { type Region, regionOption } from './regions/region.ts'
import { judgedArrays } from './wasm/judged-arrays.ts'
import { checkLoadOptions, type LoadOptions } from './wasm/load-options.ts'
import { compileWasm, instantiate, unwrap } from './wasm/wasm.ts'

/**
 * The formats of files of circles.
 *
 * @category Files
 * @example
 * CIRCLE_FORMATS.includes('geojson') // true
 */
export const CIRCLE_FORMATS = ['csv', 'json', 'geojson'] as const
/**
 * The formats of files of diagrams. The formats from `svg` to `obj` are clipped to bounds.
 *
 * @category Files
 * @example
 * DIAGRAM_FORMATS.includes('wkt') // true
 */
export const DIAGRAM_FORMATS = ['json', 'csv', 'cells', 'stats', 'svg', 'geojson', 'geojsonl', 'wkt', 'obj'] as const
const DRAWN: readonly string[] = ['cells', 'svg', 'geojson', 'geojsonl', 'wkt', 'obj']
/** The formats that say more about circles than x, y and r. */
const ATTRIBUTED: readonly string[] = ['json', 'cells', 'svg', 'geojson', 'geojsonl']
const READ_OPTIONS = ['weights', 'points', 'x', 'y', 'radius', 'id', 'skipInvalid', 'crs'] as const
const DRAWN_OPTIONS = ['bounds', 'region', 'maxDistance', 'tolerance'] as const

/**
 * Options for writing circles.
 *
 * @category Files
 */
export interface CircleFileOptions {
  /** `csv` with a header, `json` objects, or `geojson` points with a property r. Default: `csv`. */
  readonly format?: (typeof CIRCLE_FORMATS)[number] | undefined
  /** Further data of the file about the circles. `csv` and `json` have no place for `collection`. Default: nothing. */
  readonly attributes?: CircleAttributes | undefined
}

/**
 * The data of a file about its circles beyond x, y and r. Each list is empty or has an entry for each circle. Entries
 * are the text of JSON values, so that no number loses digits: `JSON.parse(attributes.properties[i]).name`.
 *
 * @category Files
 */
export interface CircleAttributes {
  /** The other columns, properties or members of each circle: a JSON object. */
  readonly properties: readonly string[]
  /** The id of each circle: a JSON string or number, or empty if there is none. */
  readonly ids: readonly string[]
  /** The height of each circle, which is the third coordinate: a JSON number, or empty if there is none. */
  readonly heights: readonly string[]
  /** The members of a GeoJSON collection beside its features, such as `crs`: a JSON object, or empty. */
  readonly collection: string
}

/**
 * The circles of a file and their attributes.
 *
 * @category Files
 */
export interface CircleFile {
  /** x, y and r of each circle. */
  readonly circles: Float64s
  readonly attributes: CircleAttributes
  /**
   * Whether x and y are called longitude and latitude, in any of the usual spellings, and are in their range. Use
   * `circle-voronoi/sphere` for such circles: a plane has no places in degrees.
   */
  readonly areDegrees: boolean
  /** The rows and features that `skipInvalid` skipped: the index of each in the file, and the reason. */
  readonly skipped: readonly { readonly index: number; readonly message: string }[]
}

/**
 * A diagram and the attributes of its circles.
 *
 * @category Files
 */
export interface ReadDiagram {
  readonly diagram: Diagram
  readonly attributes: CircleAttributes
}

/**
 * Options for writing diagrams.
 *
 * @category Files
 */
export interface DiagramFileOptions {
  /**
   * The format. `json` can be read again; `csv`: vertices and edges; `cells`: a table (CSV) with circle, x, y, r, area,
   * perimeter, neighbors and hiddenBy, where unbounded cells have the area `inf` unless something clips them; `stats`: counters and times; `svg`: a drawing with
   * true curves, one group for each layer; `geojson`: cells as polygons, with circle, r, area (`null` for unbounded cells
   * unless something clips them), neighbors, and `clipped` for clipped cells; its `bbox` is the box to clip to;
   * `geojsonl`: one cell per line; `wkt`: one line for each circle; `obj`: edges and cells. Default: `json`.
   */
  readonly format?: (typeof DIAGRAM_FORMATS)[number] | undefined
  /** The box to clip to. Default: the bounding box of the circles plus a margin of a twentieth of its size. */
  readonly bounds?: Box | readonly [minX: number, minY: number, maxX: number, maxY: number] | undefined
  /**
   * The region to clip to, in place of bounds. A cell without a part in the region is a feature without a geometry.
   * Cells at the boundary keep all their digits.
   */
  readonly region?: Region | undefined
  /** The distance from their circles at which cells and edges are cut. Default: no limit. */
  readonly maxDistance?: number | undefined
  /** The largest distance from the true curves, above 0. Default: a hundred-thousandth of the box. */
  readonly tolerance?: number | undefined
  /**
   * The largest number of digits after the decimal point of coordinates and areas, from 0. Circles are not rounded, and
   * polygons that rounding would make cross themselves are not rounded either. A `json` diagram with few digits may
   * fail certification. Default: enough digits for a tenth of the tolerance; all digits in `json` and `csv`.
   */
  readonly digits?: number | undefined
  /**
   * Further data about the circles, for `json`, `cells`, `geojson` and `geojsonl`; in `svg`, names are tooltips. Default:
   * nothing.
   */
  readonly attributes?: CircleAttributes | undefined
}

/**
 * Options for reading.
 *
 * @category Files
 */
export interface ReadOptions {
  /** The name of the file in errors. Default: `the text`. */
  readonly name?: string | undefined
}

/**
 * Options for reading circles.
 *
 * @category Files
 */
export interface ReadCirclesOptions extends ReadOptions {
  /** Whether radii are additive weights, and may be negative. Default: false. */
  readonly weights?: boolean | undefined
  /** Whether all radii are 0, so that no column is needed for them. Default: false. */
  readonly points?: boolean | undefined
  /**
   * The column of a table, or the member of JSON objects, that has x. Columns are also called `#1`, `#2` and so on.
   * Default: one of the usual names.
   */
  readonly x?: string | undefined
  /** The column or member that has y. Default: one of the usual names. */
  readonly y?: string | undefined
  /** The column, member or property of GeoJSON points that has the radius. Default: one of the usual names. */
  readonly radius?: string | undefined
  /** The column, member or property that has the id. Default: `id`. */
  readonly id?: string | undefined
  /**
   * Whether rows and features that are not circles are skipped instead of refused. They have no place or no radius, a
   * number that is not finite, or a geometry other than a point. Default: false.
   */
  readonly skipInvalid?: boolean | undefined
  /**
   * The coordinate reference system, such as `EPSG:25832`, or its URN. GeoJSON names it in `collection`, unless it is
   * `EPSG:4326`. Default: as the file says.
   */
  readonly crs?: string | undefined
}

/**
 * The loaded readers and writers. Texts to read may be UTF-8 bytes. All methods throw a `CircleVoronoiError`.
 *
 * @category Files
 */
export interface Files {
  /**
   * Reads circles from CSV (x, y, r, or columns found by name, or a column of well-known text), JSON (`[[x, y, r], ...]`
   * or objects) or GeoJSON points (also one a line) with a property r, rad or radius, and returns x, y, r of each.
   *
   * @throws CircleVoronoiError whose message begins with the file's name and the line: `badInput`, and the codes of
   *   `compute`
   */
  readCircles(text: string | Uint8Array, options?: ReadCirclesOptions): Float64s
  /**
   * Reads circles like `readCircles`, and their attributes. A column of a table has one type: numbers, booleans,
   * JSON or text.
   *
   * @throws CircleVoronoiError as `readCircles`
   */
  readCircleFile(text: string | Uint8Array, options?: ReadCirclesOptions): CircleFile
  /**
   * Reads a diagram from JSON and checks it: its certificate says whether it is correct.
   *
   * @throws CircleVoronoiError as `readCircles`
   */
  readDiagram(text: string | Uint8Array, options?: ReadOptions): Diagram
  /**
   * Reads a diagram like `readDiagram`, and the attributes of its circles.
   *
   * @throws CircleVoronoiError as `readCircles`
   */
  readDiagramFile(text: string | Uint8Array, options?: ReadOptions): ReadDiagram
  /** Returns whether a text contains a diagram for `readDiagram` rather than circles for `readCircles`. */
  holdsDiagram(text: string | Uint8Array): boolean
  /** Writes circles. `readCircleFile` reads the same bits and the same attributes again. */
  writeCircles(circles: Circles, options?: CircleFileOptions): string
  /**
   * Writes a diagram and checks it again.
   *
   * @throws CircleVoronoiError `notCertified`, if a format that draws gets a diagram that is not correct; `badOption`,
   *   also if it gets a power diagram, which has no proof; `badInput`, if the arrays are not a diagram
   */
  writeDiagram(diagram: DiagramData, options?: DiagramFileOptions): string
}

/**
 * Loads the WebAssembly module with the readers and writers.
 *
 * @param options `wasm`: `circle-voronoi-files.wasm`. Default: the file beside this module.
 * @throws CircleVoronoiError `notLoaded`, `badOption`
 *
 * @category Files
 * @example
 * const files = await loadFiles()
 * files.readCircles('x;y;r\n0;0;1\n6;0;1') // Float64Array(6) [ 0, 0, 1, 6, 0, 1 ]
 * files.writeDiagram(diagram, { format: 'csv' }).split('\n')[1] // 'vertex,0,3,4,4,0,1,2,,'
 * files.readDiagram(files.writeDiagram(diagram)).find(5, 1) // 1
 */
export async function loadFiles(options: LoadOptions = {}): Promise<Files> {
  checkLoadOptions(options, 'loadFiles')
  const beside = () => new URL('./generated/circle-voronoi-files.wasm', import.meta.url)
  const module = await instantiate(createModule, await compileWasm(options.wasm, beside))
  const decoder = new TextDecoder()

  return {
    readCircles(text, options = {}) {
      const name = nameOf(options, 'readCircles', ['name', ...READ_OPTIONS])
      return unwrap(module.readCircles(textOf(text, 'readCircles'), name, columnsOf(options))).circles
    },
    readCircleFile(text, options = {}) {
      const name = nameOf(options, 'readCircleFile', ['name', ...READ_OPTIONS])
      const read = unwrap(module.readCircleFile(textOf(text, 'readCircleFile'), name, columnsOf(options)))
      const skipped = read.skipped.map(({ circle, message }) => ({ index: circle, message }))
      const { circles, areDegrees } = read
      return { circles, attributes: attributesFrom(read.attributes), areDegrees, skipped }
    },
    readDiagram(text, options = {}) {
      const name = nameOf(options, 'readDiagram', ['name'])
      return new Diagram(unwrap(module.readDiagram(textOf(text, 'readDiagram'), name)))
    },
    readDiagramFile(text, options = {}) {
      const name = nameOf(options, 'readDiagramFile', ['name'])
      const { attributes, ...data } = unwrap(module.readDiagram(textOf(text, 'readDiagramFile'), name))
      return { diagram: new Diagram(data), attributes: attributesFrom(attributes) }
    },
    holdsDiagram(text) {
      return module.holdsDiagram(textOf(text, 'holdsDiagram'))
    },
    writeCircles(circles, options = {}) {
      checkOptionNames(options, 'writeCircles', ['format', 'attributes'])
      const format = formatOf(options.format, 'csv', CIRCLE_FORMATS)
      const coordinates = coordinatesOf(circles)
      const attributes = linesOf(options.attributes, coordinates.length / 3)
      return decoder.decode(unwrap(module.writeCircles(coordinates, format, attributes)).text)
    },
    writeDiagram(diagram, options = {}) {
      checkOptionNames(options, 'writeDiagram', ['format', ...DRAWN_OPTIONS, 'digits', 'attributes'])
      const format = formatOf(options.format, 'json', DIAGRAM_FORMATS)
      const unused = DRAWN.includes(format) ? undefined : DRAWN_OPTIONS.find((name) => options[name] !== undefined)
      if (unused !== undefined) refuseOption(`The format ${format} takes no ${unused}.`)
      if (options.attributes !== undefined && !ATTRIBUTED.includes(format)) {
        refuseOption(`The format ${format} takes no attributes.`)
      }
      const { bounds, maxDistance, tolerance, digits } = options
      const region = regionOption(options, 'writeDiagram')
      if (format === 'stats' && digits !== undefined) refuseOption('The format stats takes no digits.')
      checkDigits(digits)
      if (tolerance !== undefined) checkTolerance(tolerance)
      const sides = bounds === undefined ? undefined : sidesOf(bounds)
      const arrays = judgedArrays(diagram)
      checkMaxDistance(maxDistance)
      const { metric, stats } = diagram
      const data = { metric, ...arrays, stats: statsOf(stats) }
      const attributes = linesOf(options.attributes, arrays.circles.length / 3)
      const written = { bounds: sides, region, maxDistance, tolerance, digits, attributes }
      return decoder.decode(unwrap(module.writeDiagram(data, format, written)).text)
    },
  }
}

/** Returns the options about columns, with an empty text for each that is missing. */
function columnsOf(options: ReadCirclesOptions) {
  const flag = (name: 'weights' | 'points' | 'skipInvalid'): boolean => {
    const { [name]: value = false }: { readonly [Name in typeof name]?: unknown } = options
    if (typeof value !== 'boolean') refuseOption(`The option ${name} is true or false.`)
    return value
  }
  const text = (name: 'x' | 'y' | 'radius' | 'id' | 'crs'): string => {
    const { [name]: value = '' }: { readonly [Name in typeof name]?: unknown } = options
    const what = name === 'crs' ? 'a reference system' : 'a column'
    if (typeof value !== 'string') refuseOption(`The option ${name} is the name of ${what}, not ${shown(value)}.`)
    return value
  }
  const columns = {
    weights: flag('weights'),
    points: flag('points'),
    skipInvalid: flag('skipInvalid'),
    x: text('x'),
    y: text('y'),
    radius: text('radius'),
    id: text('id'),
    crs: text('crs'),
  }
  if (columns.points && columns.radius !== '') refuseOption('The option points takes no radius.')
  return columns
}

function attributesFrom({ properties, ids, heights, collection }: WasmAttributes): CircleAttributes {
  const entries = (lines: string) => (lines === '' ? [] : lines.split('\n'))
  return {
    properties: entries(properties).map((members) => `{${members}}`),
    ids: entries(ids),
    heights: entries(heights),
    collection: collection === '' ? '' : `{${collection}}`,
  }
}

/** Checks the attributes of `count` circles and returns them as lines. */
function linesOf(attributes: CircleAttributes | undefined, count: number): WasmAttributes | undefined {
  if (attributes === undefined) return undefined
  const { properties = [], ids = [], heights = [], collection = '' }: Partial<CircleAttributes> = Object(attributes)
  const members = (text: string) => withoutLineEnds(text).slice(1, -1).trim()
  const lines = (name: string, list: readonly string[], isRight: (value: unknown) => boolean) => {
    if (!Array.isArray(list)) refuseOption(`The ${name} of attributes are a list, not ${shown(list)}.`)
    if (list.length !== 0 && list.length !== count) {
      refuseOption(`There are ${list.length} ${name} in the attributes of ${count} circles.`)
    }
    const wrong = list.findIndex((text: unknown) => text !== '' && !isRight(parsed(text)))
    if (wrong >= 0) refuseOption(`The ${name} of circle ${wrong} are ${shown(list[wrong])}, which is not such JSON.`)
    return list
  }
  if (collection !== '' && !isRecord(parsed(collection)))
    refuseOption('The collection of attributes is no JSON object.')
  return {
    properties: lines('properties', properties, isRecord).map(members).join('\n'),
    ids: lines('ids', ids, (value) => typeof value === 'string' || typeof value === 'number')
      .map(withoutLineEnds)
      .join('\n'),
    heights: lines('heights', heights, Number.isFinite).map(withoutLineEnds).join('\n'),
    collection: members(collection),
  }
}

/** Removes line ends, which JSON allows only between values, and lone surrogates. */
function withoutLineEnds(json: string): string {
  return wellFormed(json.trim().replace(/[\r\n]/g, ' '))
}

/** Parses JSON; `undefined` if the text is not valid. */
function parsed(json: unknown): unknown {
  try {
    return JSON.parse(json as string)
  } catch {
    return undefined
  }
}

function textOf(text: unknown, caller: string): string | Uint8Array {
  if (typeof text !== 'string' && !(text instanceof Uint8Array)) {
    refuseInput(`${caller} takes a text or its bytes, not ${shown(text)}.`)
  }
  checkMemory(text, caller, 'the bytes')
  return typeof text === 'string' ? wellFormed(text) : text
}

/** Replaces lone surrogates, as a `TextEncoder` does; the glue of Emscripten would swallow the character after them. */
function wellFormed(text: string): string {
  return text.replace(/\p{Surrogate}/gu, '\uFFFD')
}

function nameOf(options: ReadOptions, caller: string, known: readonly string[]): string {
  checkOptionNames(options, caller, known)
  const { name = 'the text' }: { name?: unknown } = options
  if (typeof name !== 'string') refuseOption(`The name of a file is a string, not ${shown(name)}.`)
  return name
}

function formatOf(given: unknown, usual: string, known: readonly string[]): string {
  const format = given === undefined ? usual : given
  if (!known.includes(format as string)) {
    refuseOption(`There is no format ${shown(format)} for this: the choice is ${known.join(', ')}.`)
  }
  return format as string
}

function sidesOf(bounds: NonNullable<DiagramFileOptions['bounds']>): Float64Array {
  if ((bounds as unknown) instanceof ConvexPolygon) refuseOption('The bounds of a file are a box.')
  const { minX, minY, maxX, maxY } = ConvexPolygon.of(bounds).box
  return Float64Array.of(minX, minY, maxX, maxY)
}
