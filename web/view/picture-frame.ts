// SPDX-License-Identifier: GPL-3.0-or-later
import { refuseInput, shown } from '../lib/base/check.ts'
import type { Camera, Size } from './camera.ts'
import type { Frame } from './painter/frame.ts'

/** Limits of browsers: pixels per side, and in total. */
const LONGEST_SIDE = 16_384
const MOST_PIXELS = 2 ** 27

/**
 * The frame of a camera in a picture of `scale` pixels per CSS pixel.
 * @throws CircleVoronoiError `badInput` if the picture is too large for browsers
 */
export function pictureFrame(camera: Camera, { width, height }: Size, scale: number): Frame {
  if (typeof scale !== 'number' || !(scale > 0)) {
    refuseInput(`The scale of a picture is a positive number, not ${shown(scale)}.`)
  }
  if (scale * Math.max(width, height) > LONGEST_SIDE || scale * scale * width * height > MOST_PIXELS) {
    refuseInput(`A picture ${scale} times as large as this one is too large.`)
  }
  const pixels = (length: number) => Math.max(Math.round(length * scale), 1)
  return { ...camera, scale: camera.scale * scale, width: pixels(width), height: pixels(height) }
}
