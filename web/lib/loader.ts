// SPDX-License-Identifier: GPL-3.0-or-later
import { type CircleVoronoi, circleVoronoiOf } from './library.ts'
import { checkLoadOptions, compileCircleVoronoi, type LoadOptions } from './load-options.ts'

/**
 * Loads the library, in a page, in a worker or in Node. Each call gives one with a memory of its own; to compile only
 * once, compile the module yourself and give it as `wasm`.
 *
 * @throws CircleVoronoiError `notLoaded`, `badOption`
 */
export async function loadCircleVoronoi(options: LoadOptions = {}): Promise<CircleVoronoi> {
  checkLoadOptions(options, 'loadCircleVoronoi')
  return circleVoronoiOf(await compileCircleVoronoi(options))
}
