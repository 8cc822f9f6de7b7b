// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/base/diagram-data.ts'
import type { Box, Point } from '../lib/index.ts'

/** The visible part of the plane: the point in the middle of the canvas, and CSS pixels per unit. */
export interface Camera {
  readonly x: number
  readonly y: number
  readonly scale: number
}

/** A size in CSS pixels. */
export interface Size {
  readonly width: number
  readonly height: number
}

/** Free space at each side of the canvas, in pixels. */
export interface Padding {
  readonly top: number
  readonly right: number
  readonly bottom: number
  readonly left: number
}

export const NO_PADDING: Padding = { top: 0, right: 0, bottom: 0, left: 0 }

// The plane is y-up and the screen is y-down. Only these two functions and the sink in painter/frame-sink.ts flip the
// axis.
export function toScreen({ x, y, scale }: Camera, { width, height }: Size, point: Point): Point {
  return { x: width / 2 + (point.x - x) * scale, y: height / 2 - (point.y - y) * scale }
}

export function toPlane({ x, y, scale }: Camera, { width, height }: Size, point: Point): Point {
  return { x: x + (point.x - width / 2) / scale, y: y - (point.y - height / 2) / scale }
}

export function panned(camera: Camera, dx: number, dy: number): Camera {
  return { ...camera, x: camera.x - dx / camera.scale, y: camera.y + dy / camera.scale }
}

/** Zooms by `factor` about the pixel `anchor`, whose point of the plane stays in place. */
export function zoomed(camera: Camera, size: Size, anchor: Point, factor: number): Camera {
  const fixed = toPlane(camera, size, anchor)
  const scale = camera.scale * factor
  return { x: fixed.x + (camera.x - fixed.x) / factor, y: fixed.y + (camera.y - fixed.y) / factor, scale }
}

/** The camera that shows a whole box in the middle of the space that the padding leaves. */
export function fitted(box: Box, { width, height }: Size, padding: Padding): Camera {
  const innerWidth = Math.max(width - padding.left - padding.right, 1)
  const innerHeight = Math.max(height - padding.top - padding.bottom, 1)
  const boxWidth = box.maxX - box.minX
  const boxHeight = box.maxY - box.minY
  const scale = Math.min(innerWidth / boxWidth, innerHeight / boxHeight)
  return {
    x: (box.minX + box.maxX) / 2 - (padding.left - padding.right) / 2 / scale,
    y: (box.minY + box.maxY) / 2 + (padding.top - padding.bottom) / 2 / scale,
    scale,
  }
}

/** The bounding box of all circles; a point at the origin if there are none. */
export function boundingBox(circles: Float64Array): Box {
  let minX = Number.POSITIVE_INFINITY
  let minY = Number.POSITIVE_INFINITY
  let maxX = Number.NEGATIVE_INFINITY
  let maxY = Number.NEGATIVE_INFINITY
  for (let i = 0; i < circles.length; i += 3) {
    const x = at(circles, i)
    const y = at(circles, i + 1)
    const r = at(circles, i + 2)
    minX = Math.min(minX, x - r)
    minY = Math.min(minY, y - r)
    maxX = Math.max(maxX, x + r)
    maxY = Math.max(maxY, y + r)
  }
  if (!(minX <= maxX)) return { minX: -1, minY: -1, maxX: 1, maxY: 1 }
  // A single point has no extent to fit.
  const least = Math.max(maxX - minX, maxY - minY) > 0 ? 0 : 1
  return { minX: minX - least, minY: minY - least, maxX: maxX + least, maxY: maxY + least }
}
