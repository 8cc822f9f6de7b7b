// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/base/diagram-data.ts'
import type { PathSink } from '../../lib/index.ts'

/** Adds a polygon by its corners, x and y of each. */
export function addPolygon(path: PathSink, corners: Float64Array): void {
  if (corners.length === 0) return
  path.moveTo(at(corners, 0), at(corners, 1))
  for (let k = 2; k < corners.length; k += 2) path.lineTo(at(corners, k), at(corners, k + 1))
  path.closePath()
}

/** Adds a rectangle by two opposite corners. */
export function addRectangle(path: PathSink, left: number, top: number, right: number, bottom: number): void {
  addPolygon(path, Float64Array.of(left, top, right, top, right, bottom, left, bottom))
}
