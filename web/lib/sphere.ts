// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Circles on a sphere: places with longitude, latitude and a radius along the ground.
 *
 * @module circle-voronoi/sphere
 */
import createModule from './generated/circle-voronoi-sphere.js'
import { defaultSphereWasm } from './wasm/default-wasm.ts'
import { checkLoadOptions, type LoadOptions } from './wasm/load-options.ts'
import { type Spheres, spheresOf } from './wasm/sphere.ts'
import { compileWasm } from './wasm/wasm.ts'

export type { Cap, CapAccessors, Caps, PlaceAccessor, SphereOptions, Spheres } from './wasm/sphere.ts'
export { EARTH_RADIUS } from './wasm/sphere.ts'
export type {
  CellCollection,
  FarthestPlace,
  SphereCellOptions,
  SphereData,
  SphereDiagram,
  SpherePolygonOptions,
} from './wasm/sphere-diagram.ts'

/**
 * Loads the WebAssembly for circles on a sphere.
 *
 * @param options `wasm`: the source of `circle-voronoi-sphere.wasm`. Default: the file next to this module.
 * @throws CircleVoronoiError `notLoaded`, `badOption`. Each as a rejection.
 *
 * @category Spheres
 * @example
 * const { computeSphere } = await loadSphere()
 * const poles = computeSphere([{ longitude: 0, latitude: 90, r: 0 }, { longitude: 0, latitude: -90, r: 500 }])
 * poles.find(20, -2) // 1
 */
export async function loadSphere(options: LoadOptions = {}): Promise<Spheres> {
  checkLoadOptions(options, 'loadSphere')
  const { computeSphere } = await spheresOf(createModule, await compileWasm(options.wasm, defaultSphereWasm))
  return { computeSphere }
}
