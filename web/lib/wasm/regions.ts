// SPDX-License-Identifier: GPL-3.0-or-later
import { checkOptionNames, refuseArgument, refuseOption, shown } from '../base/check.ts'
import { type Circles, coordinatesOf } from '../base/coordinates.ts'
import type { DiagramData, Float64s } from '../base/types.ts'
import { Diagram } from '../diagram/diagram.ts'
import { type ClippedDiagram, Region } from '../regions/region.ts'
import { type RegionShape, ringArraysOf } from '../regions/region-shape.ts'
import { judgedArrays } from './judged-arrays.ts'
import type { LoadOptions } from './load-options.ts'
import { loadRegionsScript } from './module-scripts.ts'
import { compileWasm, instantiate, scriptNotLoaded, unwrap } from './wasm.ts'

/**
 * Options of `Regions.fitAreas`.
 *
 * @category Regions
 */
export interface FitOptions {
  /** The region that the cells divide. */
  readonly region: Region
  /** Whether `areas` are shares of the region's area: they are scaled so that they sum to it. Default: false. */
  readonly shares?: boolean | undefined
  /** The largest relative error allowed for each area, above 0 and below 1. Default: 1e-9. */
  readonly tolerance?: number | undefined
  /** The largest number of steps. Default: 500. */
  readonly maxSteps?: number | undefined
  /** The weights to start from, for example those of an earlier fit. Default: the radii of the sites. */
  readonly weights?: Float64Array | readonly number[] | undefined
  /** Called before the first step and after each one. If it throws, the fit stops and the error is passed on. */
  readonly onStep?: ((step: FitStep) => void) | undefined
}

/**
 * What a fit has reached.
 *
 * @category Regions
 */
export interface FitStep {
  /** The number of steps so far. */
  readonly steps: number
  /** The largest relative error of an area. */
  readonly error: number
  /** The weight of each site. */
  readonly weights: Float64Array
}

/**
 * Weights for which the cells have the areas asked for.
 *
 * @category Regions
 */
export interface AreaFit extends FitStep {
  /** The certified diagram of the sites, with the weights as radii. The least weight is 0. */
  readonly diagram: Diagram
  /** The area of each cell inside the region. */
  readonly areas: Float64Array
}

/**
 * Clips diagrams to regions, and fits cells to given areas.
 *
 * @category Regions
 */
export interface Regions {
  /**
   * Makes a region from GeoJSON or a list of rings, and checks it.
   *
   * @throws CircleVoronoiError `badOption`, if it is none, or rings cross themselves or one another; the message names
   *   the rings, the sides and the point
   */
  region(shape: RegionShape): Region
  /**
   * Finds weights for which each site's cell has a given area inside the region. A point belongs to the site with the
   * smallest distance minus weight, so sites with larger weights get larger cells. Sites are circles, whose radii are
   * the weights to start from, or points `[x, y]` or `{ x, y }`.
   *
   * @throws CircleVoronoiError `badInput`, if there are not as many areas as sites, an area is not positive and finite,
   *   two sites are equal, or the areas do not sum to that of the region; `notConverged`, which says what was reached: `onStep`
   *   was called with the best weights last;
   *   `badOption`, `badArgument`, and the codes of `compute`
   * @example
   * const { region, fitAreas } = await library.loadRegions()
   * const square = region([[[0, 0], [1, 0], [1, 1], [0, 1]]])
   * const fit = fitAreas([[0.3, 0.3], [0.7, 0.6]], [3, 1], { region: square, shares: true })
   * fit.areas // Float64Array(2) [ 0.75, 0.25 ]
   */
  fitAreas(sites: Circles | Iterable<SiteLike>, areas: Float64Array | readonly number[], options: FitOptions): AreaFit
}

/** A site: a point, as an array or an object. */
export type SiteLike =
  | readonly [x: number, y: number, r?: number]
  | { readonly x: number; readonly y: number; readonly r?: number }

/**
 * Loads regions and fits.
 *
 * @throws CircleVoronoiError `notLoaded`
 */
export async function loadRegions({ wasm }: LoadOptions): Promise<Regions> {
  const { default: createModule } = await loadRegionsScript().catch(scriptNotLoaded('The regions'))
  const beside = () => new URL('../generated/circle-voronoi-regions.wasm', import.meta.url)
  return regionsOf(await instantiate(createModule, await compileWasm(wasm, beside)))
}

/** The regions and fits of a module. */
function regionsOf(module: WasmRegionsModule): Regions {
  // Free what is no longer used.
  const regions = new FinalizationRegistry((address: number) => module.deleteRegion(address))
  const clips = new FinalizationRegistry((address: number) => module.deleteClip(address))
  const addresses = new WeakMap<Region, number>()

  const clippedOf = (region: number, keeper: Region, diagram: DiagramData, maxDistance: number | undefined) => {
    const { metric } = diagram
    const { address } = unwrap(module.createClip(region, { ...judgedArrays(diagram), metric }, maxDistance))
    const clipped = new Clipped(module, address, keeper)
    clips.register(clipped, address)
    return clipped
  }

  return {
    region(shape) {
      const { points, ringOffsets, polygonOffsets } = ringArraysOf(shape)
      const { address, ...arrays } = unwrap(module.createRegion(points, ringOffsets, polygonOffsets))
      const region: Region = new Region(arrays, {
        contains: (x, y) => module.regionContains(address, x, y),
        clip: (diagram, maxDistance) => clippedOf(address, region, diagram, maxDistance),
      })
      regions.register(region, address)
      addresses.set(region, address)
      return region
    },
    fitAreas(sites, areas, options) {
      checkOptionNames(options, 'fitAreas', ['region', 'shares', 'tolerance', 'maxSteps', 'weights', 'onStep'])
      const { region, shares = false, tolerance = 1e-9, maxSteps = 500, weights, onStep } = options
      const address = addresses.get(region)
      if (address === undefined) refuseOption('fitAreas needs a region made by the same module.')
      if (typeof shares !== 'boolean') refuseOption(`shares is true or false, not ${shown(shares)}.`)
      if (typeof tolerance !== 'number') refuseOption(`tolerance is a number, not ${shown(tolerance)}.`)
      if (!Number.isInteger(maxSteps) || maxSteps > 2 ** 31 - 1) {
        refuseOption(`maxSteps is a whole number, not ${shown(maxSteps)}.`)
      }
      const circles = sitesWith(sites, weights)
      let thrown: unknown
      let hasThrown = false
      const tell = (steps: number, error: number, now: Float64Array) => {
        try {
          onStep?.({ steps, error, weights: now })
        } catch (reason) {
          thrown = reason
          hasThrown = true
        }
        return !hasThrown
      }
      const result = module.fitAreas(address, circles, numbersOf(areas, 'areas'), {
        shares,
        tolerance,
        maxSteps,
        onStep: tell,
      })
      if (hasThrown) throw thrown
      const { relativeError: error, diagram, circles: weighted, ...rest } = unwrap(result)
      return { ...rest, error, diagram: new Diagram({ metric: 'circles', circles: weighted, ...diagram }) }
    },
  }
}

/** A clipped diagram in the module's memory. */
class Clipped implements ClippedDiagram {
  readonly #module: WasmRegionsModule
  readonly #address: number
  /** The module's diagram refers to its region. */
  readonly region: Region
  #cells: ClippedDiagram['cells'] | undefined
  #edges: ClippedDiagram['edges'] | undefined
  #areas: Float64Array | undefined

  constructor(module: WasmRegionsModule, address: number, region: Region) {
    this.#module = module
    this.#address = address
    this.region = region
  }

  get cells() {
    this.#cells ??= unwrap(this.#module.clippedCells(this.#address))
    return this.#cells
  }

  get edges() {
    this.#edges ??= unwrap(this.#module.clippedEdges(this.#address))
    return this.#edges
  }

  get areas() {
    this.#areas ??= unwrap(this.#module.clippedAreas(this.#address))
    return this.#areas
  }

  get centroids() {
    return unwrap(this.#module.clippedCentroids(this.#address))
  }

  get perimeters() {
    return unwrap(this.#module.clippedPerimeters(this.#address))
  }

  neighbors(circle: number) {
    return unwrap(this.#module.clippedNeighbors(this.#address, circle))
  }

  polygons(tolerance: number) {
    return unwrap(this.#module.clippedPolygons(this.#address, tolerance))
  }
}

/** Points get the radius 0; weights take the place of radii. */
function sitesWith(
  sites: Circles | Iterable<SiteLike>,
  weights: Float64Array | readonly number[] | undefined,
): Float64s {
  const isFlat = sites instanceof Float64Array || sites instanceof Float32Array
  const circles = isFlat
    ? coordinatesOf(sites)
    : coordinatesOf(
        Array.from(sites as Iterable<SiteLike>, (site) => {
          const [x, y, r = 0] = Array.isArray(site) ? site : [Object(site).x, Object(site).y, Object(site).r]
          return [x, y, r] as const
        }),
      )
  if (weights === undefined) return circles
  const start = numbersOf(weights, 'weights')
  if (start.length !== circles.length / 3) {
    refuseOption(`There are ${start.length} weights for ${circles.length / 3} sites.`)
  }
  return circles.map((value, k) => (k % 3 === 2 ? (start[(k - 2) / 3] as number) : value))
}

function numbersOf(list: unknown, name: string): Float64s {
  const isList = list instanceof Float64Array || list instanceof Float32Array || Array.isArray(list)
  if (!isList || !Array.prototype.every.call(list, (item) => typeof item === 'number')) {
    refuseArgument(`fitAreas takes a list of numbers as ${name}, not ${shown(list)}.`)
  }
  return Float64Array.from(list as readonly number[])
}
