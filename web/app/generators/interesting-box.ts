// SPDX-License-Identifier: GPL-3.0-or-later

import type { Box, Float64s } from '../../lib/index.ts'
import { boundingBox } from '../../view/camera.ts'
import { CircleTable } from '../../view/circle-table.ts'

/** Where the whole is so many times as large as what most circles fill, that is what there is to see. */
const FAR = 8
/** Of fewer circles none lies far outside. */
const FEW = 20

/** The box of circles, or that of most of them, if the others would make them too small to be seen. */
export function interestingBox(circles: Float64s): Box {
  const [whole, core] = [boundingBox(circles), new CircleTable(circles).core()]
  return circles.length > 3 * FEW && sizeOf(whole) > FAR * sizeOf(core) ? core : whole
}

export function sizeOf({ minX, minY, maxX, maxY }: Box): number {
  return Math.max(maxX - minX, maxY - minY)
}
