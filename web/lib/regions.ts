// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Clips diagrams to regions, and fits cells to given areas.
 *
 * @module circle-voronoi/regions
 */
import createModule from './generated/circle-voronoi-regions.js'
import { defaultRegionsWasm } from './wasm/default-wasm.ts'
import { checkLoadOptions, type LoadOptions } from './wasm/load-options.ts'
import { type Regions, regionsOf } from './wasm/regions.ts'
import { compileWasm } from './wasm/wasm.ts'

export { Region } from './regions/region.ts'
export type { RegionShape, RingShape } from './regions/region-shape.ts'
export type {
  AreaFit,
  CommonFitOptions,
  FitOptions,
  FitStep,
  PeriodicAreaFit,
  PeriodicFitOptions,
  SiteLike,
} from './wasm/fit.ts'
export type { DissolveOptions, Regions } from './wasm/regions.ts'
export type { TreemapCell, TreemapOptions, TreeNode, TreeWithCells } from './wasm/treemap.ts'

/**
 * Loads the WebAssembly that clips diagrams to regions, and fits cells to given areas.
 *
 * @param options `wasm`: the source of `circle-voronoi-regions.wasm`. Default: the file next to this module.
 * @throws CircleVoronoiError `notLoaded`, `badOption`. Each as a rejection.
 *
 * @category Regions
 * @example
 * const { region } = await loadRegions()
 * const triangle = region([[[0, 0], [9, 0], [0, 9]]])
 * diagram.cellArea(0, { region: triangle }) // 12
 */
export async function loadRegions(options: LoadOptions = {}): Promise<Regions> {
  checkLoadOptions(options, 'loadRegions')
  const wasm = await compileWasm(options.wasm, defaultRegionsWasm)
  const { region, fitAreas, treemap } = await regionsOf(createModule, wasm)
  return { region, fitAreas, treemap }
}
