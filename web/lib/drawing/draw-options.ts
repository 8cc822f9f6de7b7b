// SPDX-License-Identifier: GPL-3.0-or-later
import { checkDigits, checkOptionNames, checkTolerance, refuseOption, shown } from '../base/check.ts'
import type { Box, PathSink } from '../base/types.ts'
import type { Bounds } from '../regions/convex-polygon.ts'
import { exportTolerance } from '../regions/export-box.ts'
import type { Region } from '../regions/region.ts'
import { SvgPath } from './svg-path.ts'

/**
 * Options for clipping curves and cells.
 *
 * @category Drawing
 */
export interface BoundsOptions {
  /**
   * The region to clip to, in the units of the input. Default: the bounding box of the circles plus a margin of a
   * twentieth of its size.
   */
  readonly bounds?: Bounds | undefined
  /** The region to clip to, in place of bounds: polygons with holes (`Regions.region`). */
  readonly region?: Region | undefined
  /**
   * The distance from their circles at which cells and edges are cut. A cell is cut by the circle of radius r +
   * maxDistance around the same center, so all cells together are the union of the grown circles and do not overlap. A
   * negative distance keeps the points that deep inside the circles. In a power diagram the squared radius is the weight
   * plus maxDistance squared, or minus it for a negative distance. The default bounds have room for the grown circles.
   * Default: no limit.
   */
  readonly maxDistance?: number | undefined
}

/**
 * Options for the accuracy of curves, and for clipping.
 *
 * @category Drawing
 */
export interface PolygonOptions extends BoundsOptions {
  /** The largest distance from the true curves, above 0. Default: a hundred-thousandth of the bounds. */
  readonly tolerance?: number | undefined
}

/**
 * Options for the convex hull.
 *
 * @category Drawing
 */
export type HullOptions = Pick<PolygonOptions, 'region' | 'tolerance'>

/**
 * Options for returning the `d` attribute of an SVG path.
 *
 * @category Drawing
 */
export interface TextOptions {
  readonly context?: undefined
  /**
   * The number of digits after the decimal point, from 0. Default: enough for a tenth of the tolerance; all digits if
   * there is no tolerance.
   */
  readonly digits?: number | undefined
}

/**
 * Options for drawing on a context.
 *
 * @category Drawing
 */
export interface ContextOptions {
  /** The target: a canvas context, a `Path2D` or any other `PathSink`. */
  readonly context: PathSink
  readonly digits?: undefined
}

/**
 * Options for drawing. Without a `context`, the drawing is returned as text.
 *
 * @category Drawing
 */
export type DrawOptions = PolygonOptions & (TextOptions | ContextOptions)

/** @throws CircleVoronoiError `badOption`, if the tolerance is given and invalid */
export function toleranceOf({ tolerance }: PolygonOptions, region: { readonly box: Box }): number {
  if (tolerance === undefined) return exportTolerance(region.box)
  checkTolerance(tolerance)
  return tolerance
}

/**
 * The path of the last text and its number of digits. Both are kept, because most texts have the same number of digits.
 */
let path = new SvgPath()
let pathDigits: number | undefined

/**
 * Returns the context of the options, or a path whose text `textOf` returns. Call `textOf` before drawing anything
 * else.
 *
 * @throws CircleVoronoiError `badOption`, if an option is invalid
 */
export function sinkOf({ context, digits }: TextOptions | ContextOptions, tolerance: number | undefined): PathSink {
  if (context !== undefined) {
    if (typeof context?.moveTo !== 'function') refuseOption(`The context is nothing to draw on, but ${shown(context)}.`)
    return context
  }
  checkDigits(digits)
  const count = digits ?? (tolerance === undefined ? undefined : digitsFor(tolerance))
  if (count !== pathDigits) path = new SvgPath(count)
  pathDigits = count
  // An error may have left text.
  path.take()
  return path
}

/** Returns the text of the path from `sinkOf`; `undefined` if the sink is the context of the options. */
export function textOf(sink: PathSink): string | undefined {
  return sink === path ? path.take() : undefined
}

/** The names of the options of drawing functions, with and without bounds. */
export const BOUNDS_OPTIONS = ['bounds', 'region', 'maxDistance']
export const POLYGON_OPTIONS = [...BOUNDS_OPTIONS, 'tolerance']
export const DRAW_OPTIONS = ['context', ...POLYGON_OPTIONS, 'digits']
export const HULL_OPTIONS = ['region', 'tolerance']
export const PATH_OPTIONS = ['context', 'digits']

/** @throws CircleVoronoiError `badOption`, if there are options other than `known` */
export function checkDrawOptions(options: object, caller: string, known: readonly string[]): void {
  if (typeof (options as Partial<PathSink> | null)?.moveTo === 'function') {
    refuseOption(`What ${caller} draws on is an option: { context }.`)
  }
  checkOptionNames(options, caller, known)
}

/**
 * Returns the number of digits for which rounding moves points by at most a tenth of a tolerance. Rounding moves a
 * point by up to sqrt(1/2) in the last digit.
 */
function digitsFor(tolerance: number): number {
  return Math.max(0, Math.ceil(-Math.log10(0.14 * tolerance)))
}
