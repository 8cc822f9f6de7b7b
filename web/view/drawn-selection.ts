// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Circle } from '../lib/index.ts'
import { boundingBox } from './camera.ts'

/** The selected circles, x, y and r each, and their bounding box, whose corner has the resize handle. */
export interface DrawnSelection {
  readonly circles: Float64Array
  readonly box: Box
}

/** Returns `undefined` if no circle is selected. */
export function drawnSelection(circles: readonly Circle[]): DrawnSelection | undefined {
  const flat = Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r]))
  const [first, ...others] = circles
  // The handle of a single circle is at its rim.
  const box = first !== undefined && others.length === 0 ? boxInCircle(first) : boundingBox(flat)
  return first && { circles: flat, box }
}

/** The square whose corners lie on a circle. */
function boxInCircle({ x, y, r }: Circle): Box {
  const half = r * Math.SQRT1_2
  return { minX: x - half, minY: y - half, maxX: x + half, maxY: y + half }
}
