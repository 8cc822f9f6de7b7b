// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'
import type { Frame } from './frame.ts'

/** Radius in pixels above which the single precision of canvas arcs becomes visible. */
const LARGEST_ARC = 4096
/** Number of cubic curves for the visible part of a large circle. Each turns by less than 0.1. */
const PIECES = 8
const FULL_TURN = 2 * Math.PI

/**
 * Adds a circle to a path. The center is in pixels from the frame's top left, and may be far outside. Of a large circle
 * only the visible part is exact; a curve outside the frame closes it, so that fill and stroke look right.
 */
export function addDisc(path: PathSink, { width, height }: Frame, x: number, y: number, radius: number): void {
  if (radius <= LARGEST_ARC) {
    path.moveTo(x + radius, y)
    path.arc(x, y, radius, 0, 2 * Math.PI)
    return
  }
  const toMiddleX = width / 2 - x
  const toMiddleY = height / 2 - y
  const distance = Math.hypot(toMiddleX, toMiddleY)
  const seen = Math.hypot(width, height)
  // The point of the rim nearest to the middle of the frame.
  if (distance - radius > seen) return
  if (radius - distance > seen) {
    path.moveTo(-seen, -seen)
    path.lineTo(width + seen, -seen)
    path.lineTo(width + seen, height + seen)
    path.lineTo(-seen, height + seen)
    path.closePath()
    return
  }
  const angle = Math.atan2(toMiddleY, toMiddleX)
  const half = (2 * seen) / radius
  traceArc(path, x, y, radius, angle - half, angle + half)
  const at = (turn: number, r: number) => [x + r * Math.cos(turn), y + r * Math.sin(turn)] as const
  path.lineTo(...at(angle + half, radius - 4 * seen))
  path.lineTo(...at(angle - half, radius - 4 * seen))
  path.closePath()
}

/** Adds the visible part of an arc to a path. Angles increase clockwise, as on a canvas. */
export function addArc(
  path: PathSink,
  frame: Frame,
  x: number,
  y: number,
  radius: number,
  from: number,
  turn: number,
): void {
  if (radius <= LARGEST_ARC) {
    path.moveTo(x + radius * Math.cos(from), y + radius * Math.sin(from))
    path.arc(x, y, radius, from, from + turn)
    return
  }
  const toMiddleX = frame.width / 2 - x
  const toMiddleY = frame.height / 2 - y
  const seen = Math.hypot(frame.width, frame.height)
  if (Math.abs(Math.hypot(toMiddleX, toMiddleY) - radius) > seen) return
  const half = (2 * seen) / radius
  const middle = Math.atan2(toMiddleY, toMiddleX)
  // The angle from the arc's start to the middle of the visible part, which may lie just before the start.
  const toMiddle = (((middle - from) % FULL_TURN) + FULL_TURN) % FULL_TURN
  for (const offset of [toMiddle, toMiddle - FULL_TURN]) {
    const first = Math.max(offset - half, 0)
    const last = Math.min(offset + half, turn)
    if (first < last) traceArc(path, x, y, radius, from + first, from + last)
  }
}

/** Nearby points of cubic curves are precise enough in single precision. */
function traceArc(path: PathSink, x: number, y: number, radius: number, first: number, last: number): void {
  const step = (last - first) / PIECES
  const handle = (4 / 3) * Math.tan(step / 4) * radius
  path.moveTo(x + radius * Math.cos(first), y + radius * Math.sin(first))
  for (let k = 0; k < PIECES; k++) {
    const [from, to] = [first + k * step, first + (k + 1) * step]
    const [x0, y0] = [x + radius * Math.cos(from), y + radius * Math.sin(from)]
    const [x1, y1] = [x + radius * Math.cos(to), y + radius * Math.sin(to)]
    path.bezierCurveTo(
      x0 - handle * Math.sin(from),
      y0 + handle * Math.cos(from),
      x1 + handle * Math.sin(to),
      y1 - handle * Math.cos(to),
      x1,
      y1,
    )
  }
}
