// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle } from './diagram-data.ts'
import { CircleVoronoiError } from './errors.ts'

/**
 * A copy of the circles as x, y, r of each.
 *
 * @throws CircleVoronoiError `badInput`: embind would convert whatever it is given, so types are checked here.
 */
export function coordinatesOf(circles: Float64Array | readonly Circle[]): Float64Array<ArrayBuffer> {
  if (circles instanceof Float64Array) {
    if (circles.length % 3 !== 0) {
      throw new CircleVoronoiError(
        'badInput',
        -1,
        `Three numbers per circle are needed, but there are ${circles.length}.`,
      )
    }
    return new Float64Array(circles)
  }
  if (!Array.isArray(circles)) {
    throw new CircleVoronoiError('badInput', -1, 'The circles are neither a Float64Array nor an array.')
  }
  const flat = new Float64Array(3 * circles.length)
  // Not forEach, which leaves out what was never set.
  for (let i = 0; i < circles.length; i++) {
    const { x, y, r }: Partial<Circle> = circles[i] ?? {}
    if (typeof x !== 'number' || typeof y !== 'number' || typeof r !== 'number') {
      throw new CircleVoronoiError('badInput', i, `Circle ${i} does not have three numbers x, y and r.`)
    }
    flat[3 * i] = x
    flat[3 * i + 1] = y
    flat[3 * i + 2] = r
  }
  return flat
}
