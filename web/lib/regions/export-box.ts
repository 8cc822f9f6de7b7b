// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../base/diagram-data.ts'
import type { Box, DiagramData } from '../base/types.ts'
import { reachFrom } from './cell-limits.ts'

const MARGIN = 0.05
/** The smallest margin, relative to the farthest coordinate. */
const LEAST_MARGIN = 2 ** -50
const TOLERANCE = 1e-5

/**
 * Returns the default bounds of drawings: the bounding box of the circles, each grown by `maxDistance`, plus a margin
 * of a twentieth of its size. `circles` has x, y, r of each circle.
 */
export function exportBox(circles: Float64Array, maxDistance = 0): Box {
  if (circles.length === 0) return { minX: 0, minY: 0, maxX: 1, maxY: 1 }
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity]
  for (let i = 0; i < circles.length; i += 3) {
    // A circle of negative radius is drawn as a point.
    const [x, y, r] = [
      at(circles, i),
      at(circles, i + 1),
      Math.max(at(circles, i + 2), at(circles, i + 2) + maxDistance, 0),
    ]
    minX = Math.min(minX, x - r)
    minY = Math.min(minY, y - r)
    maxX = Math.max(maxX, x + r)
    maxY = Math.max(maxY, y + r)
  }
  const size = Math.max(maxX - minX, maxY - minY)
  const farthest = Math.max(-minX, -minY, maxX, maxY)
  // The minimum prevents rounding from losing the margin.
  const margin = Math.max(size > 0 ? MARGIN * size : 1, LEAST_MARGIN * farthest)
  return { minX: minX - margin, minY: minY - margin, maxX: maxX + margin, maxY: maxY + margin }
}

/**
 * Returns the default bounds of drawings of a diagram. For the metric `power` and a maximum distance there is room for
 * the discs in which cells are kept.
 */
export function exportBoxOf(diagram: DiagramData, maxDistance?: number): Box {
  const { circles, metric } = diagram
  if (metric !== 'power' || maxDistance === undefined) return exportBox(circles, maxDistance)
  const discs = circles.map((number, k) =>
    k % 3 === 2 ? Math.max(number, reachFrom(diagram, (k - 2) / 3, maxDistance)) : number,
  )
  return exportBox(discs)
}

/** Returns the default tolerance of drawn curves: a hundred-thousandth of the box. */
export function exportTolerance({ minX, minY, maxX, maxY }: Box): number {
  return TOLERANCE * Math.max(maxX - minX, maxY - minY)
}
