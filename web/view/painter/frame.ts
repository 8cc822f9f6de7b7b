// SPDX-License-Identifier: GPL-3.0-or-later
import { ConvexPolygon } from '../../lib/regions/convex-polygon.ts'

/** A rectangle of the plane and the pixels it is drawn on. */
export interface Frame {
  /** The plane's point in its middle. */
  readonly x: number
  readonly y: number
  /** Device pixels per unit. */
  readonly scale: number
  /** In device pixels. */
  readonly width: number
  readonly height: number
}

/** What lies so far outside, in device pixels, is not drawn; the outlines of cells run along that border. */
const MARGIN = 4

/** How far a drawn curve may be from the true one, in device pixels. */
const TOLERANCE = 0.05

/** The same in the units of the plane. */
export function toleranceOf({ scale }: Pick<Frame, 'scale'>): number {
  return TOLERANCE / scale
}

/** The part of the plane that a frame shows, with a margin in which the ends of strokes are. */
export function regionOf({ x, y, scale, width, height }: Frame): ConvexPolygon {
  const halfWidth = (width / 2 + MARGIN) / scale
  const halfHeight = (height / 2 + MARGIN) / scale
  return ConvexPolygon.of({ minX: x - halfWidth, minY: y - halfHeight, maxX: x + halfWidth, maxY: y + halfHeight })
}
