// SPDX-License-Identifier: GPL-3.0-or-later
import { COORDINATE_LIMIT, roundAll } from '../base/coordinate-limits.ts'
import { type Circles, coordinatesOf } from '../base/coordinates.ts'
import { CircleVoronoiError } from '../base/errors.ts'
import type { Metric } from '../base/types.ts'
import { Diagram } from '../diagram/diagram.ts'
import createModule from '../generated/circle-voronoi-comparison.js'
import { defaultComparisonWasm } from './default-wasm.ts'
import type { CircleVoronoi } from './library.ts'
import type { LoadOptions } from './load-options.ts'
import { compileWasm, instantiate, unwrap } from './wasm.ts'

/**
 * Computes two related diagrams of the same circles, to show how they differ: the ordinary Voronoi diagram of the
 * centers, and the power diagram.
 *
 * @category Comparison
 */
export interface Comparison {
  /**
   * Computes the diagram of `circles` by another metric: the ordinary Voronoi diagram of the centers (`centers`), the
   * power diagram (`power`), or the result of `compute` (`circles`). The methods of the result, and functions of cells
   * and curves, use this metric too.
   *
   * With `centers`, the radius of a vertex is its distance from its three centers, and if several circles have the same
   * center, the first one has the cell. With `power`, the radius of a vertex is the radius of the circle at right
   * angles to its three circles. Where the three circles overlap, it is minus the square root of their negative power.
   * A circle without a cell is listed as hidden by a visible circle beside its center, though no circle need contain
   * it. The center of a circle may lie outside its cell. Both diagrams are certified.
   *
   * @throws CircleVoronoiError with one of the codes of `ErrorCode`.
   */
  computeComparison(circles: Circles, metric: Metric): Diagram
}

/**
 * Loads the comparison diagrams of a library.
 *
 * @throws CircleVoronoiError `notLoaded`
 */
export async function comparisonOf(
  library: CircleVoronoi | Promise<CircleVoronoi>,
  wasm: LoadOptions['wasm'],
): Promise<Comparison> {
  const [{ compute }, module] = await Promise.all([
    library,
    compileWasm(wasm, defaultComparisonWasm).then((compiled) => instantiate(createModule, compiled)),
  ])
  return {
    computeComparison(circles, metric) {
      const coordinates = coordinatesOf(circles)
      if (metric === 'power') {
        const data = unwrap(module.powerDiagram(coordinates))
        return new Diagram({ metric, circles: roundAll(coordinates), ...data })
      }
      // The diagram of the centers ignores radii, so invalid radii are refused here.
      const isRefused = coordinates.some((value, k) => k % 3 === 2 && !(value >= 0 && value <= COORDINATE_LIMIT))
      if (metric === 'circles' || isRefused) return compute(coordinates)
      if (metric !== 'centers') {
        throw new CircleVoronoiError('badOption', 'Unknown metric: the choice is circles, centers or power.')
      }
      const centers = compute(coordinates.map((value, k) => (k % 3 === 2 ? 0 : value)))
      return new Diagram({ ...centers, metric, circles: roundAll(coordinates) })
    },
  }
}
