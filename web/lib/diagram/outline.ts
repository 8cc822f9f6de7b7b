// SPDX-License-Identifier: GPL-3.0-or-later
import { checkDiagram, checkIndex, checkMaxDistance } from '../base/check.ts'
import { type Bounds, ConvexPolygon } from '../regions/convex-polygon.ts'
import { outlineOf } from '../regions/outline.ts'
import type { Outline } from '../regions/outline-piece.ts'
import type { Diagram } from './diagram.ts'

/**
 * The part of the cell of a circle inside some bounds: empty if they do not meet, several loops if the bounds cut the cell
 * apart. With a maximum distance it is cut by the circle of radius r + maxDistance around the same centre as well.
 *
 * @throws CircleVoronoiError `badArgument`, `badOption`
 *
 * @category Cells
 * @example
 * const [loop] = outline(diagram, 0, [-5, -5, 10, 10])
 * loop.map(({ neighbor }) => neighbor).includes(1) // true
 */
export function outline(diagram: Diagram, circle: number, bounds: Bounds, maxDistance?: number): Outline {
  checkDiagram(diagram, 'outline')
  checkIndex(circle, diagram.circles.length / 3, 'outline', 'circle')
  checkMaxDistance(diagram, 'outline', maxDistance)
  return outlineOf(diagram.cells, circle, { region: ConvexPolygon.of(bounds), maxDistance })
}
