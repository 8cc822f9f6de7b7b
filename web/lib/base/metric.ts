// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from './diagram-data.ts'
import { hypotenuse } from './scale.ts'
import type { DiagramData } from './types.ts'

/** The distance from a circle of the diagram to the point (x, y), in the metric of the diagram. */
export function distanceFrom({ circles, metric, weights }: DiagramData, circle: number, x: number, y: number): number {
  const toCenter = hypotenuse(x - at(circles, 3 * circle), y - at(circles, 3 * circle + 1))
  const r = at(circles, 3 * circle + 2)
  if (metric === 'circles') return toCenter - r
  if (metric === 'centers') return toCenter
  return weights ? toCenter * toCenter - r : (toCenter - r) * (toCenter + r)
}
