// SPDX-License-Identifier: GPL-3.0-or-later
// The arguments and results of fits, in this thread and in a worker.
import { checkMemory, checkOptionNames, refuseInput, refuseOption, shown } from '../base/check.ts'
import { type Circles, circleRadius, coordinatesOf } from '../base/coordinates.ts'
import type { Float64s } from '../base/types.ts'
import type { Diagram } from '../diagram/diagram.ts'
import { type Lattice, latticeNumbers } from '../diagram/lattice.ts'
import type { PeriodicDiagram } from '../diagram/periodic-diagram.ts'
import { Region } from '../regions/region.ts'

/**
 * Options of `fitAreas` in a region.
 *
 * @category Regions
 */
export interface FitOptions extends CommonFitOptions {
  /** The region that the cells divide. */
  readonly region: Region
  readonly lattice?: undefined
}

/**
 * Options of `fitAreas` in a box whose opposite sides are glued together.
 *
 * @category Regions
 */
export interface PeriodicFitOptions extends CommonFitOptions {
  /** The periods of the box that the cells divide. */
  readonly lattice: Lattice
  readonly region?: undefined
}

/**
 * Options of all fits.
 *
 * @category Regions
 */
export interface CommonFitOptions {
  /**
   * The distance of a point from a site: the distance less the weight (`circles`), or its square less the weight
   * (`power`), which makes borders straight. Default: `circles`.
   */
  readonly metric?: 'circles' | 'power' | undefined
  /** Whether `areas` are shares, which are scaled so that they sum to the area of the region or box. Default: false. */
  readonly shares?: boolean | undefined
  /**
   * The largest relative error of each area, above 0 and below 1. Default: 1e-9. A larger error remains only if the
   * last bits of the weights or the coordinates cause it, as for a sliver behind a close neighbor. The result has the
   * tolerance that was allowed.
   */
  readonly tolerance?: number | undefined
  /** The largest number of steps. Default: 500. */
  readonly maxSteps?: number | undefined
  /**
   * The number of times that all sites move to the centroids of their cells, after which the areas are fitted again.
   * Cells become rounder each time. The diagram of the result has the moved sites. Default: 0.
   */
  readonly relax?: number | undefined
  /** The weights to start from, for example the result of an earlier fit. Default: the radii of the sites. */
  readonly weights?: Float64Array | readonly number[] | undefined
  /**
   * Called before the first step, after each one, and after `relax` has moved the sites. If it throws, the fit stops
   * and the error is passed on. The callback may call any function of the library.
   */
  readonly onStep?: ((step: FitStep) => void) | undefined
  /**
   * A signal that cancels the fit with the reason of the signal. A worker stops at once. Without a worker, `onStep` can
   * abort the signal, and the fit stops before the next step.
   */
  readonly signal?: AbortSignal | undefined
}

/**
 * The state of a fit after a step.
 *
 * @category Regions
 */
export interface FitStep {
  /** The number of completed steps. */
  readonly steps: number
  /** The largest relative error of an area. */
  readonly error: number
  /** The weight of each site. */
  readonly weights: Float64Array
}

/**
 * The result of a fit: weights for which each cell has its area.
 *
 * @category Regions
 */
export interface AreaFit extends FitStep {
  /** The certified diagram of the sites with these weights. The least weight is 0. */
  readonly diagram: Diagram
  /** The area of each cell inside the region. */
  readonly areas: Float64Array
  /** The relative error that was allowed: that of the options, or more if last bits allow no less. */
  readonly tolerance: number
}

/**
 * The result of a fit in a box whose opposite sides are glued together.
 *
 * @category Regions
 */
export interface PeriodicAreaFit extends FitStep {
  /** The certified diagram of the sites with these weights. The least weight is 0. */
  readonly periodic: PeriodicDiagram
  /** The area of each cell. */
  readonly areas: Float64Array
  /** The relative error that was allowed: that of the options, or more if last bits allow no less. */
  readonly tolerance: number
}

/** A site: a point, as an array or an object. */
export type SiteLike =
  | readonly [x: number, y: number, r?: number]
  | { readonly x: number; readonly y: number; readonly r?: number }

/** The input of a fit, with checked types. The core checks the values. */
export interface FitInput {
  /** x, y and starting weight of each site. */
  readonly sites: Float64s
  readonly areas: Float64s
  readonly metric: 'circles' | 'power'
  readonly shares: boolean
  readonly tolerance: number
  readonly maxSteps: number
  readonly relax: number
  /** ax, ay, bx, by of the periods; without them the fit has a region. */
  readonly lattice?: Float64s | undefined
}

/** @throws CircleVoronoiError `badInput`, `badOption` */
export function fitInput(
  sites: Circles | Iterable<SiteLike>,
  areas: Float64Array | readonly number[],
  options: FitOptions | PeriodicFitOptions,
): FitInput {
  checkOptionNames(options, 'fitAreas', NAMES)
  const { region, metric = 'circles', shares = false, tolerance = 1e-9, maxSteps = 500, relax = 0 } = options
  const { weights, onStep, signal } = options
  const lattice = options.lattice === undefined ? undefined : latticeNumbers(options.lattice, 'fitAreas')
  if (lattice === undefined && !(region instanceof Region)) {
    refuseOption(
      'fitAreas needs a region, which `region` of `loadRegions` makes, as its option region, or periods as its option lattice.',
    )
  }
  if (lattice !== undefined && region !== undefined) refuseOption('fitAreas takes a region or a lattice, not both.')
  if (metric !== 'circles' && metric !== 'power') refuseOption(`metric is circles or power, not ${shown(metric)}.`)
  if (typeof shares !== 'boolean') refuseOption(`shares is true or false, not ${shown(shares)}.`)
  if (typeof tolerance !== 'number') refuseOption(`tolerance is a number, not ${shown(tolerance)}.`)
  checkCount(maxSteps, 'maxSteps')
  checkCount(relax, 'relax')
  if (onStep !== undefined && typeof onStep !== 'function') refuseOption('The option onStep is a function.')
  checkSignal(signal)
  const numbers = { sites: sitesWith(sites, weights), areas: numbersOf(areas, 'areas') }
  return { ...numbers, metric, shares, tolerance, maxSteps, relax, lattice }
}

function checkCount(count: unknown, name: string): void {
  if (!Number.isInteger(count) || Math.abs(count as number) > 2 ** 31 - 1) {
    refuseOption(`${name} is a whole number, not ${shown(count)}.`)
  }
}

/** @throws CircleVoronoiError `badOption` */
export function checkSignal(signal: unknown): void {
  if (signal !== undefined && !(signal instanceof AbortSignal)) refuseOption('The option signal is an AbortSignal.')
}

const NAMES = ['region', 'lattice', 'metric', 'shares', 'tolerance', 'maxSteps', 'relax', 'weights', 'onStep', 'signal']

/** Returns x, y and starting weight of each site. Points have the weight 0; the option `weights` replaces radii. */
function sitesWith(
  sites: Circles | Iterable<SiteLike>,
  weights: Float64Array | readonly number[] | undefined,
): Float64s {
  const isFlat = sites instanceof Float64Array || sites instanceof Float32Array
  const circles = coordinatesOf(sites, isFlat ? {} : { r: (site) => circleRadius(site) ?? 0 }, false)
  if (weights === undefined) return circles
  const start = numbersOf(weights, 'weights')
  if (start.length !== circles.length / 3) {
    const are = start.length === 1 ? 'There is 1 weight' : `There are ${start.length} weights`
    refuseOption(`${are} for ${circles.length === 3 ? '1 site' : `${circles.length / 3} sites`}.`)
  }
  return circles.map((value, k) => (k % 3 === 2 ? (start[(k - 2) / 3] as number) : value))
}

function numbersOf(list: unknown, name: string): Float64s {
  const isList = list instanceof Float64Array || list instanceof Float32Array || Array.isArray(list)
  if (!isList) refuseInput(`fitAreas takes a list of numbers as ${name}, not ${shown(list)}.`)
  checkMemory(list, 'fitAreas', name)
  const items = list as readonly unknown[]
  for (let k = 0; k < items.length; k++) {
    if (typeof items[k] === 'number') continue
    refuseInput(`fitAreas takes a list of numbers as ${name}, but item ${k} is ${shown(items[k])}.`)
  }
  return Float64Array.from(items as readonly number[])
}
