// SPDX-License-Identifier: GPL-3.0-or-later
import { withWarning } from '../diagram/hidden-warning.ts'
import { type CircleVoronoi, circleVoronoiOf } from './library.ts'
import { checkLoadOptions, compileCircleVoronoi, type LoadOptions } from './load-options.ts'

/**
 * Loads the library in a page, in a worker or in Node. Each call creates an instance with its own memory. To compile
 * the WebAssembly only once, compile the module yourself and pass it as `wasm`. The memory stays as large as the
 * largest input required, until the library is garbage-collected. Diagrams do not use it.
 *
 * @throws CircleVoronoiError `notLoaded`, `badOption`
 *
 * @category Loading
 * @example
 * const library = await loadCircleVoronoi()
 * library.compute([[0, 0, 1], [6, 0, 1], [0, 8, 1]]).vertices // Float64Array(3) [ 3, 4, 4 ]
 */
export async function loadCircleVoronoi(options: LoadOptions = {}): Promise<CircleVoronoi> {
  checkLoadOptions(options, 'loadCircleVoronoi')
  const library = await loadLibrary(options)
  const compute = (...given: Parameters<CircleVoronoi['compute']>) => withWarning(library.compute(...given))
  return { ...library, compute }
}

/** Loads the library like `loadCircleVoronoi`, but without warnings on the console, for pages that show hidden circles. */
export async function loadLibrary(options: LoadOptions = {}): Promise<CircleVoronoi> {
  return circleVoronoiOf(await compileCircleVoronoi(options))
}
