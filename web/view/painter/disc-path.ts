// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'
import type { Frame } from './frame.ts'

/** Beyond this radius, in pixels, single precision shows in the arcs of a canvas. */
const LARGEST_ARC = 4096
/** How many cubic curves the seen part of a large circle takes: each turns by less than 0.1. */
const PIECES = 8
const FULL_TURN = 2 * Math.PI

/**
 * Adds a circle to a path: center in pixels from the top left of the frame, which may be far outside. Of a large one only
 * what can be seen in the frame is there, as a curve that goes around outside of it: right to fill, and to stroke.
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
  // The rim nearest to the middle, seen from there.
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

/** Adds what can be seen of an arc to a path, by growing angles as the canvas has them, clockwise. */
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
  // The turn from where the arc begins to the middle of what is seen, also where that comes just before it.
  const toMiddle = (((middle - from) % FULL_TURN) + FULL_TURN) % FULL_TURN
  for (const offset of [toMiddle, toMiddle - FULL_TURN]) {
    const first = Math.max(offset - half, 0)
    const last = Math.min(offset + half, turn)
    if (first < last) traceArc(path, x, y, radius, from + first, from + last)
  }
}

/** As cubic curves: single precision is enough for points that are near. */
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
