// SPDX-License-Identifier: GPL-3.0-or-later

import { COORDINATE_STEP } from '../base/coordinate-limits.ts'
import { circleOf } from '../base/diagram-data.ts'
import { between } from '../base/point.ts'
import { facing, largestOf, measuredIn, unitFor } from '../base/scale.ts'
import type { Point } from '../base/types.ts'
import { pointOf } from '../curves/bisector.ts'
import { curveOf } from '../curves/curve.ts'
import type { Diagram } from '../diagram/diagram.ts'
import { LineCrossing } from '../regions/clip.ts'

/** The point where a ray from a cell's center leaves the cell. */
export interface Exit {
  readonly edge: number
  /** The parameter on the curve of the edge. */
  readonly parameter: number
  readonly point: Point
}

/** Returns the exit of the ray through p, or `undefined` if the ray never leaves the cell. */
export function exitOf(diagram: Diagram, circle: number, p: Point): Exit | undefined {
  const c = circleOf(diagram.circles, circle)
  // The point may lie anywhere. If it is nearer to the center than the step of all numbers, every direction is right.
  const toPoint = between(c, p)
  const size = largestOf(toPoint)
  const direction = size < COORDINATE_STEP ? { x: 1, y: 0 } : measuredIn(unitFor(size), toPoint)
  // The ray crosses one side. Near a vertex, rounding may hide which side.
  let leastMiss = 1 + 1e-9
  let exit: Exit | undefined
  for (const side of diagram.cells.sides(circle)) {
    const { bisector, from, to } = curveOf(diagram, side >> 1)
    for (const s of new LineCrossing(bisector, c, direction).parameters) {
      const point = pointOf(bisector, s)
      const miss = s < from ? from / s : s > to ? s / to : 1
      if (!(facing(direction, between(c, point)) > 0) || miss >= leastMiss) continue
      leastMiss = miss
      exit = { edge: side >> 1, parameter: Math.min(Math.max(s, from), to), point }
    }
  }
  return exit
}
