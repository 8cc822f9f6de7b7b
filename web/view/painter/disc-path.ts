// SPDX-License-Identifier: GPL-3.0-or-later
import type { Frame } from './frame.ts'

/** Beyond this radius, in pixels, single precision shows in the arcs of a canvas. */
const LARGEST_ARC = 4096
/** How many cubic curves the seen part of a large circle takes: each turns by less than 0.1. */
const PIECES = 8

/**
 * Adds a circle to a path: centre in pixels from the top left of the frame, which may be far outside. Of a large one only
 * what can be seen in the frame is there, as a curve that goes around outside of it: right to fill, and to stroke.
 */
export function addDisc(path: Path2D, { width, height }: Frame, x: number, y: number, radius: number): void {
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
    path.rect(-seen, -seen, width + 2 * seen, height + 2 * seen)
    return
  }
  const angle = Math.atan2(toMiddleY, toMiddleX)
  const half = (2 * seen) / radius
  const at = (turn: number, r: number) => [x + r * Math.cos(turn), y + r * Math.sin(turn)] as const
  const step = (2 * half) / PIECES
  const handle = (4 / 3) * Math.tan(step / 4) * radius
  path.moveTo(...at(angle - half, radius))
  for (let k = 0; k < PIECES; k++) {
    const from = angle - half + k * step
    const to = from + step
    const [x0, y0] = at(from, radius)
    const [x1, y1] = at(to, radius)
    path.bezierCurveTo(
      x0 - handle * Math.sin(from),
      y0 + handle * Math.cos(from),
      x1 + handle * Math.sin(to),
      y1 - handle * Math.cos(to),
      x1,
      y1,
    )
  }
  path.lineTo(...at(angle + half, radius - 4 * seen))
  path.lineTo(...at(angle - half, radius - 4 * seen))
  path.closePath()
}
