// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoi, Diagram } from '../../lib/index.ts'

/**
 * The diagram of some circles and all of their neighbors. These circles have the indices from 0 on, and the cells that they
 * have among all, for a cell depends on its neighbors alone.
 */
export function localDiagram(library: CircleVoronoi, diagram: Diagram, circles: readonly number[]): Diagram {
  const taken = new Set(circles)
  for (const i of circles) for (const j of diagram.neighbors(i)) taken.add(j)
  const coordinates = new Float64Array(3 * taken.size)
  let place = 0
  for (const i of taken) {
    coordinates.set(diagram.circles.subarray(3 * i, 3 * i + 3), place)
    place += 3
  }
  return library.compute(coordinates)
}
