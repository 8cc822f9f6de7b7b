// SPDX-License-Identifier: GPL-3.0-or-later
import { checkData, checkIndex, checkNumber } from './check.ts'
import { at } from './diagram-data.ts'
import { hypotenuse } from './scale.ts'
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
  checkIndex(circle, diagram.circles.length / 3, 'distanceFrom', 'circle')
  checkNumber(x, 'distanceFrom', 'x')
  checkNumber(y, 'distanceFrom', 'y')
  return distanceOf(diagram, circle, x, y)
}

/** Does what `distanceFrom` does, for arguments that have been checked. */
export function distanceOf({ circles, metric }: DiagramData, circle: number, x: number, y: number): number {
  const toCenter = hypotenuse(x - at(circles, 3 * circle), y - at(circles, 3 * circle + 1))
  const r = at(circles, 3 * circle + 2)
  if (metric === 'circles') return toCenter - r
  return metric === 'centers' ? toCenter : (toCenter - r) * (toCenter + r)
}
