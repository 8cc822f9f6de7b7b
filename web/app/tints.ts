// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/diagram-data.ts'

/** A class from 0 to `classes` - 1 for each circle, by radius: each class has about as many circles, equal radii one class. */
export function tintClasses(circles: Float64Array, classes: number): Uint8Array {
  const count = circles.length / 3
  const radii = new Float64Array(count).map((_, i) => at(circles, 3 * i + 2))
  const sorted = radii.slice().sort()
  const bounds = Array.from({ length: classes - 1 }, (_, k) => at(sorted, Math.floor(((k + 1) * count) / classes)))
  return new Uint8Array(count).map((_, i) => bounds.filter((bound) => bound <= at(radii, i)).length)
}
