// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'
import type { Frame } from './frame.ts'

/** Ends of strokes are invisible this far outside the frame, in pixels. */
const MARGIN = 16

/** Adds the visible part of a segment to a path. Coordinates are in pixels and may be far outside. */
export function addSegment(path: PathSink, frame: Frame, x0: number, y0: number, x1: number, y1: number): void {
  const [dx, dy] = [x1 - x0, y1 - y0]
  let from = 0
  let to = 1
  /** Keeps the parameters t with offset + t * slope at least 0. */
  const keep = (offset: number, slope: number) => {
    const t = -offset / slope
    if (slope > 0) from = Math.max(from, t)
    else if (slope < 0) to = Math.min(to, t)
    else if (offset < 0) to = -1
  }
  keep(x0 + MARGIN, dx)
  keep(frame.width + MARGIN - x0, -dx)
  keep(y0 + MARGIN, dy)
  keep(frame.height + MARGIN - y0, -dy)
  if (from > to) return
  path.moveTo(x0 + from * dx, y0 + from * dy)
  path.lineTo(x0 + to * dx, y0 + to * dy)
}
