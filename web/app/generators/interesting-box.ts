// SPDX-License-Identifier: GPL-3.0-or-later

import type { Box, Float64s } from '../../lib/index.ts'
import { boundingBox } from '../../view/camera.ts'
import { CircleTable } from '../../view/circle-table.ts'

/** Ratio of sizes from which the box of most circles replaces the box of all. */
const FAR = 8
/** Fewer circles have no outliers. */
const FEW = 20

/** The bounding box of circles, without outliers that would make most circles too small to see. */
export function interestingBox(circles: Float64s): Box {
  const [whole, core] = [boundingBox(circles), new CircleTable(circles).core()]
  return circles.length > 3 * FEW && sizeOf(whole) > FAR * sizeOf(core) ? core : whole
}

export function sizeOf({ minX, minY, maxX, maxY }: Box): number {
  return Math.max(maxX - minX, maxY - minY)
}
