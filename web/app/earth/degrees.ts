// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether the columns of a table are longitude and latitude (`CircleFile::areDegrees` of cpp/include/circle_voronoi/io.h).
import type { Degrees } from '../../editing/history.ts'
import { at } from '../../lib/base/diagram-data.ts'
import type { Float64s } from '../../lib/index.ts'
import { boundingBox } from '../../view/camera.ts'
import { type ColumnNames, DEGREE, isLatitude, isLongitude, KILOMETER, unitOf } from '../files/columns.ts'

/** Half of the way around the Earth in kilometers. */
const FARTHEST = 20_015

/** Returns what the columns of a file say about places on the Earth; `undefined` if the circles are not in degrees. */
export function degreesIn(circles: Float64s, names: ColumnNames | undefined, file: string): Degrees | undefined {
  if (names === undefined || circles.length === 0) return undefined
  if (!isLongitude(names.x) || !isLatitude(names.y)) return undefined
  const isInRange = circles.every((value, k) => k % 3 === 2 || Math.abs(value) <= (k % 3 === 0 ? 360 : 90))
  return isInRange ? { file, unit: unitIn(names.radius) ?? likelyUnit(circles) } : undefined
}

/** The unit of radii by the name of their column. Other units than kilometers were converted to meters. */
function unitIn(name = ''): Degrees['unit'] | undefined {
  const unit = unitOf(name)
  return unit === undefined ? undefined : unit === KILOMETER ? 'km' : 'm'
}

/** Radii beyond the extent of all places in kilometers are meters. */
function likelyUnit(circles: Float64s): Degrees['unit'] {
  const { minX, minY, maxX, maxY } = boundingBox(circles.map((value, k) => (k % 3 === 2 ? 0 : value)))
  const extent = Math.min(DEGREE * Math.hypot(maxX - minX, maxY - minY), FARTHEST)
  let largest = 0
  for (let k = 2; k < circles.length; k += 3) largest = Math.max(largest, at(circles, k))
  return extent > 0 && largest > extent ? 'm' : 'km'
}
