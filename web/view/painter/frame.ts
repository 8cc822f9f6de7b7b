// SPDX-License-Identifier: GPL-3.0-or-later
import { ConvexPolygon } from '../../lib/regions/convex-polygon.ts'

/** A rectangle of the plane with the pixels that it is drawn on. */
export interface Frame {
  /** The point of the plane in the middle of the frame. */
  readonly x: number
  readonly y: number
  /** Device pixels per unit. */
  readonly scale: number
  /** In device pixels. */
  readonly width: number
  readonly height: number
}

/** Drawing is cut off this far outside the frame, in device pixels. Clipped cells have outlines along this border. */
const MARGIN = 4

/** Tolerance for curves, in device pixels. */
const TOLERANCE = 0.05

/** The tolerance in units of the plane. */
export function toleranceOf({ scale }: Pick<Frame, 'scale'>): number {
  return TOLERANCE / scale
}

/** The visible part of the plane, with a margin that hides the ends of strokes. */
export function boundsOf({ x, y, scale, width, height }: Frame): ConvexPolygon {
  const halfWidth = (width / 2 + MARGIN) / scale
  const halfHeight = (height / 2 + MARGIN) / scale
  return ConvexPolygon.of({ minX: x - halfWidth, minY: y - halfHeight, maxX: x + halfWidth, maxY: y + halfHeight })
}
