// SPDX-License-Identifier: GPL-3.0-or-later
import type { Float64s } from '../../lib/index.ts'
import { boundingBox } from '../../view/camera.ts'

/** Size of a preview. Coordinates in SVG have single precision, so circles far from the origin are moved to it. */
const SIZE = 100
const MARGIN = 4

/** Circles moved and scaled to a square around the origin, and the bounds of the square. */
export function previewFrame(circles: Float64s) {
  const { minX, minY, maxX, maxY } = boundingBox(circles)
  const scale = SIZE / (Math.max(maxX - minX, maxY - minY) || 1)
  const middle = [(minX + maxX) / 2, (minY + maxY) / 2, 0]
  const shown = circles.map((value, k) => (value - (middle[k % 3] as number)) * scale)
  const half = SIZE / 2 + MARGIN
  return { shown, half, bounds: [-half, -half, half, half] as const }
}
