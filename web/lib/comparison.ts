// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The diagrams that are confused with that of circles: of their centres, and by their power.
 *
 * @module circle-voronoi/comparison
 */
import { checkThing } from './base/check.ts'
import { COORDINATE_LIMIT } from './base/coordinate-limits.ts'
import { type Circles, coordinatesOf } from './base/coordinates.ts'
import { CircleVoronoiError } from './base/errors.ts'
import type { Metric } from './base/types.ts'
import { Diagram } from './diagram/diagram.ts'
import createModule from './generated/circle-voronoi-comparison.js'
import type { CircleVoronoi } from './wasm/library.ts'
import { checkLoadOptions, type LoadOptions } from './wasm/load-options.ts'
import { compileWasm, instantiate, unwrap } from './wasm/wasm.ts'

/**
 * Diagrams of the same circles by other distances, to show how they differ.
 *
 * @category Comparison
 */
export interface Comparison {
  /**
   * The diagram of `circles`, as `compute` takes them, by another distance: with `centers` the ordinary Voronoi diagram of
   * the centres, with `power` the power diagram, with `circles` that of `compute`. The methods of the result and the
   * functions of cells and curves take that distance too.
   *
   * Of `centers`: a vertex has the distance from its three centres as its radius, and of circles with one centre the first
   * has a cell. Of `power`: the radius of a vertex is that of the circle at right angles to its three, or, negative, the
   * root of minus their power where they overlap; a circle without a cell is listed as hidden by `NONE`, though no circle
   * need contain it; a circle's centre may lie outside its cell; and no certificate is made.
   *
   * @throws CircleVoronoiError with one of the codes of `ErrorCode`.
   */
  computeComparison(circles: Circles, metric: Metric): Diagram
}

/**
 * Loads what makes power diagrams, a WebAssembly module of its own, beside a loaded library.
 *
 * @param options `wasm`: `circle-voronoi-comparison.wasm`. Default: the file beside this module.
 * @throws CircleVoronoiError `notLoaded`, `badArgument`, `badOption`
 *
 * @category Comparison
 * @example
 * const { computeComparison } = await loadComparison(library)
 * computeComparison([[0, 0, 3], [10, 0, 1]], 'power').find(5.2, 0) // 0
 */
export async function loadComparison(library: CircleVoronoi, options: LoadOptions = {}): Promise<Comparison> {
  checkThing(library, 'compute', 'loadComparison', 'a loaded library')
  checkLoadOptions(options, 'loadComparison')
  const beside = () => new URL('./generated/circle-voronoi-comparison.wasm', import.meta.url)
  const module = await instantiate(createModule, await compileWasm(options.wasm, beside))

  return {
    computeComparison(circles, metric) {
      const coordinates = coordinatesOf(circles)
      if (metric === 'power') {
        return new Diagram({ metric, circles: coordinates, ...unwrap(module.powerDiagram(coordinates)) })
      }
      // Without radii nobody would see what is wrong with them.
      const isRefused = coordinates.some((value, k) => k % 3 === 2 && !(value >= 0 && value <= COORDINATE_LIMIT))
      if (metric === 'circles' || isRefused) return library.compute(coordinates)
      if (metric !== 'centers') {
        throw new CircleVoronoiError('badOption', -1, 'Unknown metric: the choice is circles, centers or power.')
      }
      const centres = library.compute(coordinates.map((value, k) => (k % 3 === 2 ? 0 : value)))
      return new Diagram({ ...centres, metric, circles: coordinates })
    },
  }
}
