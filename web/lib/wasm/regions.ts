// SPDX-License-Identifier: GPL-3.0-or-later
import { checkOptionNames, refuseOption } from '../base/check.ts'
import type { Circles } from '../base/coordinates.ts'
import { at, NONE } from '../base/diagram-data.ts'
import type { DiagramData, Point } from '../base/types.ts'
import { Diagram } from '../diagram/diagram.ts'
import { circlesOfConvexCell } from '../regions/convex-cell.ts'
import { fewCircles, sidesOfFew } from '../regions/few-circles.ts'
import { type ClippedDiagram, type ClippedPolygons, Region } from '../regions/region.ts'
import { isDissolved, type RegionShape, type RingArrays, ringArraysOf } from '../regions/region-shape.ts'
import {
  type AreaFit,
  type FitOptions,
  fitInput,
  type PeriodicAreaFit,
  type PeriodicFitOptions,
  type SiteLike,
} from './fit.ts'
import { judgedArrays } from './judged-arrays.ts'
import { periodicOf } from './module-periodic.ts'
import { goingOn, type Reporter, reporting } from './reporting.ts'
import {
  type TreemapArrays,
  type TreemapInput,
  type TreemapOptions,
  type TreeNode,
  type TreeWithCells,
  treeOf,
} from './treemap.ts'
import { type CompiledWasm, type EmscriptenOptions, instantiate, unwrap } from './wasm.ts'

/**
 * Options of `region`.
 *
 * @category Regions
 */
export interface DissolveOptions {
  /**
   * Whether polygons that share borders or overlap, as administrative areas do, become their union. Points where sides
   * cross are rounded. Default: false; such polygons are then an error.
   */
  readonly dissolve?: boolean | undefined
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
   * @throws CircleVoronoiError `badOption`, if the shape is not a region, or its rings cross and `dissolve` is not set.
   *   The message then names the rings, the sides and the point.
   * @example
   * const counties = { type: 'MultiPolygon', coordinates: [[[[0, 0], [5, 0], [5, 9]]], [[[5, 0], [9, 9], [5, 9]]]] }
   * region(counties, { dissolve: true }).area // 40.5
   */
  region(shape: RegionShape, options?: DissolveOptions): Region
  /**
   * Finds weights for which each site's cell has a given area inside the region. A point belongs to the site with the
   * smallest distance minus weight, so sites with larger weights get larger cells. Sites are circles, whose radii are
   * the weights to start from, or points `[x, y]` or `{ x, y }`.
   *
   * @throws CircleVoronoiError `badInput`, if the numbers of areas and sites differ, an area is not positive and
   *   finite, two sites are equal, or the areas do not sum to the area of the region; `notConverged`, with the number
   *   of steps and their result in the message, and the last weights as `error.weights`; `badOption`, and the codes of
   *   `compute`
   * @example
   * const { region, fitAreas } = await loadRegions()
   * const square = region([[[0, 0], [1, 0], [1, 1], [0, 1]]])
   * const fit = fitAreas([[0.3, 0.3], [0.7, 0.6]], [3, 1], { region: square, shares: true })
   * fit.areas // Float64Array(2) [ 0.75, 0.25 ]
   */
  fitAreas(sites: Circles | Iterable<SiteLike>, areas: Float64Array | readonly number[], options: FitOptions): AreaFit
  /**
   * Finds weights for which each site's cell has a given area in a box whose opposite sides are glued together. The
   * areas must sum to the area of the box. Sites may lie outside the box.
   *
   * @throws CircleVoronoiError as with a region, and as `computePeriodic`; sites that differ by whole periods are equal
   * @example
   * const { fitAreas } = await loadRegions()
   * const fit = fitAreas([[0.3, 0.3], [0.7, 0.6]], [3, 1], { lattice: { a: [1, 0], b: [0, 1] }, shares: true })
   * fit.periodic.cellArea(0) // 0.75
   */
  fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: PeriodicFitOptions,
  ): PeriodicAreaFit
  /**
   * Divides a region among the nodes of a tree, so that each area is in proportion to the value of the node, and the cells
   * of its children fill its cell. Takes what `d3.hierarchy(data).sum(...)` returns, or nodes with `children` and
   * `value`, sets `polygon`, `polygons`, `area` and `site` on each node, and returns the root.
   *
   * @throws CircleVoronoiError `badInput`, with the names of the node, if a value is no number, negative or not finite,
   *   all are zero, or a node is twice in the tree; `notConverged` and other codes of `fitAreas`; `badOption`
   * @example
   * const { region, treemap } = await loadRegions()
   * const square = region([[[0, 0], [2, 0], [2, 2], [0, 2]]])
   * const root = treemap({ children: [{ name: 'a', value: 3 }, { name: 'b', value: 1 }] }, { region: square })
   * root.children[0].area // 3
   */
  treemap<Node extends TreeNode>(root: Node, options: TreemapOptions): TreeWithCells<Node>
}

/** The functions of a module of regions. */
export interface RegionsOfModule extends Regions {
  regionOf(rings: RingArrays): Region
  cellsOfTree(
    region: Region,
    input: TreemapInput,
    progress: TreemapOptions['progress'],
    signal?: AbortSignal,
  ): TreemapArrays
}

/** The script of the module, as written by Emscripten. The types of the package omit the types of its functions. */
export type RegionsScript = (options: EmscriptenOptions) => Promise<object>

/** Returns the WebAssembly that made a region, so that a worker can make the region again. */
export function wasmOf(region: Region): CompiledWasm | undefined {
  return compiled.get(region)
}

const compiled = new WeakMap<Region, CompiledWasm>()

/** Returns the WebAssembly that this thread loaded last, for a worker that fits in a box. */
export function newestWasm(): CompiledWasm | undefined {
  return newest
}

let newest: CompiledWasm | undefined

/**
 * Creates the functions for regions and fits from a module.
 *
 * @throws CircleVoronoiError `notLoaded`
 */
export async function regionsOf(createModule: RegionsScript, wasm: CompiledWasm): Promise<RegionsOfModule> {
  const module = (await instantiate(createModule, wasm)) as WasmRegionsModule
  newest = wasm
  // Frees the memory of regions that are no longer used.
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

  const regionOf = ({ points, ringOffsets, polygonOffsets }: RingArrays, dissolve = false) => {
    const { address, ...arrays } = unwrap(module.createRegion(points, ringOffsets, polygonOffsets, dissolve))
    const region: Region = new Region(arrays, {
      contains: (x, y) => module.regionContains(address, x, y),
      clip: (diagram, maxDistance) => clippedOf(address, region, diagram, maxDistance),
      clipCell(diagram, circle, maxDistance) {
        const few = fewCircles(diagram, [circle])
        const chosen = at(few.chosen, 0)
        const result = module.clipCell(address, few.circles, diagram.weights, chosen, maxDistance)
        // Errors for a few circles are dropped, because the computation for all circles reports them better.
        if ('error' in result) return undefined
        const { cells, areas, centroids, perimeters, ...small } = result
        const sides = sidesOfFew(diagram, few, small)
        if (sides === undefined) return undefined
        const side = cells.side.map((its) => sides.get(its) ?? NONE)
        return { cells: { ...cells, side }, areas, centroids, perimeters }
      },
      clipConvex(corners) {
        const circles = circlesOfConvexCell(corners)
        return circles && unwrap(module.clipFirstCell(address, circles))
      },
    })
    regions.register(region, address)
    addresses.set(region, address)
    compiled.set(region, wasm)
    return region
  }

  return {
    region(shape, options = {}) {
      checkOptionNames(options, 'region', ['dissolve'])
      const { dissolve = isDissolved(shape) }: { dissolve?: unknown } = options
      if (typeof dissolve !== 'boolean') refuseOption('The option dissolve is true or false.')
      return regionOf(ringArraysOf(shape), dissolve)
    },
    regionOf: (rings) => regionOf(rings),
    fitAreas,
    cellsOfTree,
    treemap(root, options) {
      const tree = treeOf(root, options)
      const { region, progress, signal } = options
      try {
        return tree.finish(cellsOfTree(region, tree.input, progress, signal))
      } catch (error) {
        throw tree.named(error)
      }
    },
  }

  function cellsOfTree(
    region: Region,
    { parents, values, ...chosen }: TreemapInput,
    progress: TreemapOptions['progress'],
    signal?: AbortSignal,
  ): TreemapArrays {
    const domain = addresses.get(region)
    if (domain === undefined) refuseOption('The region of treemap was made by another module of regions.')
    const result = whileTelling(progress, signal, (tell) =>
      module.treemap(domain, parents, values, { ...chosen, progress: tell }),
    )
    return unwrap(result)
  }

  function fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: FitOptions,
  ): AreaFit
  function fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: PeriodicFitOptions,
  ): PeriodicAreaFit
  function fitAreas(
    sites: Circles | Iterable<SiteLike>,
    areas: Float64Array | readonly number[],
    options: FitOptions | PeriodicFitOptions,
  ): AreaFit | PeriodicAreaFit {
    const { sites: circles, areas: targets, lattice, ...chosen } = fitInput(sites, areas, options)
    const { region, onStep, signal } = options
    const domain = lattice ?? (region && addresses.get(region))
    if (domain === undefined) refuseOption('The region of fitAreas was made by another module of regions.')
    const result = whileTelling(
      (steps: number, error: number, weights: Float64Array) => onStep?.({ steps, error, weights }),
      signal,
      (tell) => module.fitAreas(domain, circles, targets, { ...chosen, onStep: tell }),
    )
    const { relativeError: error, ...fit } = unwrap(result)
    const { metric } = chosen
    if ('periodic' in fit) return { ...fit, error, periodic: periodicOf(fit.periodic, circles.length / 3, metric) }
    const { diagram, circles: weighted, ...rest } = fit
    return { ...rest, error, diagram: new Diagram({ metric, circles: weighted, ...diagram }) }
  }
}

/** Runs a computation that a listener follows, by calls of `tell`, and that it or a signal may end. */
function whileTelling<Told extends unknown[], Value>(
  listener: ((...told: Told) => void) | undefined,
  signal: AbortSignal | undefined,
  run: (tell: (...told: Told) => boolean) => Value,
): Value {
  signal?.throwIfAborted()
  const told = (...all: Told) => {
    listener?.(...all)
    signal?.throwIfAborted()
  }
  return reporting(told, (reporter) => run(goingOn(reporter as Reporter<Told>)))
}

/** A clipped diagram in the module's memory. */
class Clipped implements ClippedDiagram {
  readonly #module: WasmRegionsModule
  readonly #address: number
  /** Keeps the region alive, to which the module's diagram refers. */
  readonly region: Region
  #cells: ClippedDiagram['cells'] | undefined
  #edges: ClippedDiagram['edges'] | undefined
  #areas: Float64Array | undefined
  #centroids: Float64Array | undefined
  #perimeters: Float64Array | undefined
  #polygons: { readonly tolerance: number; readonly polygons: ClippedPolygons } | undefined

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
    this.#centroids ??= unwrap(this.#module.clippedCentroids(this.#address))
    return this.#centroids
  }

  get perimeters() {
    this.#perimeters ??= unwrap(this.#module.clippedPerimeters(this.#address))
    return this.#perimeters
  }

  largestEmptyDisc() {
    return discOf(unwrap(this.#module.clippedLargestEmptyDisc(this.#address)))
  }

  largestEmptyDiscInside() {
    return discOf(unwrap(this.#module.clippedLargestEmptyDiscInside(this.#address)))
  }

  clearestPath(p: Point, q: Point) {
    const path = unwrap(this.#module.clippedClearestPath(this.#address, p.x, p.y, q.x, q.y))
    return path.found ? path : undefined
  }

  polygons(tolerance: number) {
    if (this.#polygons?.tolerance !== tolerance) {
      this.#polygons = { tolerance, polygons: unwrap(this.#module.clippedPolygons(this.#address, tolerance)) }
    }
    return this.#polygons.polygons
  }
}

function discOf({ disc, circles }: { readonly disc: Float64Array; readonly circles: Int32Array }) {
  if (disc.length === 0) return undefined
  const [x, y, r] = disc as unknown as [number, number, number]
  return { disc: { x, y, r }, circles: Array.from(circles).filter((circle) => circle !== NONE) }
}
