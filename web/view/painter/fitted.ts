// SPDX-License-Identifier: GPL-3.0-or-later
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import type { Fit } from '../protocol.ts'

/** Smaller errors are invisible. If a region has distant parts, rounding of weights alone causes errors of 1e-8. */
const TOLERANCE = 1e-6

/**
 * Fits the radii of circles so that each cell has its share of a region. In `shares`, NaN stands for the mean.
 * @throws CircleVoronoiError as `region` and `fitAreas`
 */
export function fitted(
  { region, fitAreas }: Pick<Regions, 'region' | 'fitAreas'>,
  circles: Float64Array,
  shares: readonly number[],
  shape: RegionShape,
): Fit {
  const start = performance.now()
  const named = shares.filter((share) => share > 0)
  const mean = named.length === 0 ? 1 : named.reduce((sum, share) => sum + share, 0) / named.length
  const all = shares.map((share) => (share > 0 ? share : mean))
  const fit = fitAreas(circles, all, { region: region(shape), shares: true, tolerance: TOLERANCE })
  const { diagram, error, steps } = fit
  return { circles: diagram.circles, fitted: { error, steps }, seconds: (performance.now() - start) / 1000 }
}
