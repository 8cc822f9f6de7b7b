// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/diagram-data.ts'
import type { Point } from '../lib/index.ts'

/** The circle under the pointer, and which part of it: its rim, its disc, or only its cell. */
export interface Hit {
  readonly circle: number
  readonly part: 'rim' | 'disc' | 'cell'
}

/**
 * What lies at a point of the plane. `slack` is how near counts as on it, in units of the plane. A rim wins over a disc,
 * and of several discs the smallest wins, so that a circle inside another can be taken hold of.
 */
export function hitTest(circles: Float64Array, point: Point, slack: number): Hit | undefined {
  let rim = -1
  let rimDistance = slack
  let disc = -1
  let discSize = Number.POSITIVE_INFINITY
  let cell = -1
  let cellDistance = Number.POSITIVE_INFINITY
  for (let i = 0; i < circles.length / 3; i++) {
    const dx = at(circles, 3 * i) - point.x
    const dy = at(circles, 3 * i + 1) - point.y
    const r = at(circles, 3 * i + 2)
    const signedDistance = Math.sqrt(dx * dx + dy * dy) - r
    if (signedDistance < cellDistance) {
      cell = i
      cellDistance = signedDistance
    }
    // A small circle is all disc: it can be resized once it is seen larger.
    const hasRim = r > 3 * slack
    if (hasRim && Math.abs(signedDistance) < rimDistance) {
      rim = i
      rimDistance = Math.abs(signedDistance)
    }
    if (signedDistance <= (hasRim ? 0 : slack) && r < discSize) {
      disc = i
      discSize = r
    }
  }
  if (rim >= 0) return { circle: rim, part: 'rim' }
  if (disc >= 0) return { circle: disc, part: 'disc' }
  return cell >= 0 ? { circle: cell, part: 'cell' } : undefined
}
