// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Reads and writes the files of the command line, with the same bytes.
 *
 * @module circle-voronoi/files
 */
import {
  checkDigits,
  checkMaxDistance,
  checkOptionNames,
  checkTolerance,
  refuseArgument,
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
export const DIAGRAM_FORMATS = ['json', 'csv', 'stats', 'svg', 'geojson', 'geojsonl', 'wkt', 'obj'] as const
const DRAWN: readonly string[] = ['svg', 'geojson', 'geojsonl', 'wkt', 'obj']
const DRAWN_OPTIONS = ['bounds', 'region', 'maxDistance', 'tolerance'] as const

/**
 * Options for writing circles.
 *
 * @category Files
 */
export interface CircleFileOptions {
  /** `csv` with a header, `json` objects, or `geojson` points with a property r. Default: `csv`. */
  readonly format?: (typeof CIRCLE_FORMATS)[number] | undefined
}

/**
 * Options for writing diagrams.
 *
 * @category Files
 */
export interface DiagramFileOptions {
  /**
   * The format. `json` can be read again; `csv`: vertices and edges; `stats`: counters and times; `svg`: a drawing with
   * true curves, one group for each layer; `geojson`: cells as polygons, with circle, r, area and neighbors;
   * `geojsonl`: one cell per line; `wkt`: one line for each circle; `obj`: edges and cells. Default: `json`.
   */
  readonly format?: (typeof DIAGRAM_FORMATS)[number] | undefined
  /** The box to clip to. Default: the bounding box of the circles plus a margin of a twentieth of its size. */
  readonly bounds?: Box | readonly [minX: number, minY: number, maxX: number, maxY: number] | undefined
  /**
   * The region to clip to, in place of bounds. A cell without a part in the region is a feature without a geometry. Cells at
   * the boundary keep all their digits.
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
}

/**
 * The loaded readers and writers. Texts to read may be UTF-8 bytes. All methods throw a `CircleVoronoiError`.
 *
 * @category Files
 */
export interface Files {
  /**
   * Reads circles from CSV (x, y, r, or columns found by name), JSON (`[[x, y, r], ...]` or objects) or GeoJSON points
   * with a property r, and returns x, y, r of each.
   *
   * @throws CircleVoronoiError whose message begins with the file's name and the line: `badInput`, and what `compute`
   *   would refuse
   */
  readCircles(text: string | Uint8Array, options?: ReadCirclesOptions): Float64s
  /**
   * Reads a diagram from JSON and checks it: its certificate says whether it is correct. There is no certificate for
   * power diagrams.
   *
   * @throws CircleVoronoiError as `readCircles`
   */
  readDiagram(text: string | Uint8Array, options?: ReadOptions): Diagram
  /** Returns whether a text contains a diagram for `readDiagram` rather than circles for `readCircles`. */
  holdsDiagram(text: string | Uint8Array): boolean
  /** Writes circles. `readCircles` reads the same bits again. */
  writeCircles(circles: Circles, options?: CircleFileOptions): string
  /**
   * Writes a diagram and checks it again.
   *
   * @throws CircleVoronoiError `notCertified`, if something is to be drawn of a diagram that is not right; `badOption`, also
   *   if it is to be drawn of a power diagram, of which there is no proof; `badInput`, if arrays are not those of a diagram
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
  const decoder = new TextDecoder('utf-8', { ignoreBOM: true })

  return {
    readCircles(text, options = {}) {
      const name = nameOf(options, 'readCircles', ['name', 'weights'])
      const { weights = false }: { weights?: unknown } = options
      if (typeof weights !== 'boolean') refuseOption('The option weights is true or false.')
      return unwrap(module.readCircles(textOf(text, 'readCircles'), name, weights)).circles
    },
    readDiagram(text, options = {}) {
      const name = nameOf(options, 'readDiagram', ['name'])
      return new Diagram(unwrap(module.readDiagram(textOf(text, 'readDiagram'), name)))
    },
    holdsDiagram(text) {
      return module.holdsDiagram(textOf(text, 'holdsDiagram'))
    },
    writeCircles(circles, options = {}) {
      checkOptionNames(options, 'writeCircles', ['format'])
      const format = formatOf(options.format ?? 'csv', CIRCLE_FORMATS)
      return decoder.decode(unwrap(module.writeCircles(coordinatesOf(circles), format)).text)
    },
    writeDiagram(diagram, options = {}) {
      checkOptionNames(options, 'writeDiagram', ['format', ...DRAWN_OPTIONS, 'digits'])
      const format = formatOf(options.format ?? 'json', DIAGRAM_FORMATS)
      const unused = DRAWN.includes(format) ? undefined : DRAWN_OPTIONS.find((name) => options[name] !== undefined)
      if (unused !== undefined) refuseOption(`The format ${format} takes no ${unused}.`)
      const { bounds, maxDistance, tolerance, digits } = options
      const region = regionOption(options, 'writeDiagram')
      if (format === 'stats' && digits !== undefined) refuseOption('The format stats takes no digits.')
      checkDigits(digits)
      if (tolerance !== undefined) checkTolerance(tolerance)
      const sides = bounds === undefined ? undefined : sidesOf(bounds)
      const arrays = judgedArrays(diagram)
      checkMaxDistance(diagram, 'writeDiagram', maxDistance)
      const { metric, stats } = diagram
      const data = { metric, ...arrays, stats: statsOf(stats) }
      return decoder.decode(
        unwrap(module.writeDiagram(data, format, { bounds: sides, region, maxDistance, tolerance, digits })).text,
      )
    },
  }
}

function textOf(text: unknown, caller: string): string | Uint8Array {
  if (typeof text !== 'string' && !(text instanceof Uint8Array)) {
    refuseArgument(`${caller} takes a text or its bytes, not ${shown(text)}.`)
  }
  return text
}

function nameOf(options: ReadOptions, caller: string, known: readonly string[]): string {
  checkOptionNames(options, caller, known)
  const { name = 'the text' }: { name?: unknown } = options
  if (typeof name !== 'string') refuseOption(`The name of a file is a string, not ${shown(name)}.`)
  return name
}

function formatOf(format: unknown, known: readonly string[]): string {
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
