// SPDX-License-Identifier: GPL-3.0-or-later
import { checkData, checkIndex, checkNumber } from './check.ts'
import { at } from './diagram-data.ts'
import { lengthOf } from './scale.ts'
import type { DiagramData } from './types.ts'

/**
 * Returns the distance from a circle of the diagram to the point (x, y), in the metric of the diagram.
 *
 * @throws CircleVoronoiError `badArgument`
 *
 * @category Diagrams
 * @example
 * distanceFrom(diagram, 1, 6, 4) // 3
 */
export function distanceFrom(diagram: DiagramData, circle: number, x: number, y: number): number {
  checkData(diagram, 'distanceFrom')
  const { circles, metric } = diagram
  checkIndex(circle, circles.length / 3, 'distanceFrom', 'circle')
  checkNumber(x, 'distanceFrom', 'x')
  checkNumber(y, 'distanceFrom', 'y')
  const toCenter = lengthOf({ x: x - at(circles, 3 * circle), y: y - at(circles, 3 * circle + 1) })
  const r = at(circles, 3 * circle + 2)
  if (metric === 'circles') return toCenter - r
  return metric === 'centers' ? toCenter : (toCenter - r) * (toCenter + r)
}
