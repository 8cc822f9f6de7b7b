// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'
import type { Frame } from './frame.ts'

/** Browsers take minutes for curves with larger coordinates, in pixels. */
const FARTHEST = 2 ** 17
/** Larger than the width of any stroke, in pixels. */
const MARGIN = 256
/** Enough halvings to bring any finite number near the frame. */
const MOST_HALVES = 1200

/**
 * Transforms a path from the plane to pixels of a frame. Canvases have single precision, so coordinates are first made
 * relative to the middle of the frame in doubles. The plane is y-up, the frame y-down. Distant parts are cut off
 * without changing the visible pixels of fills and strokes.
 */
export class FrameSink implements PathSink {
  readonly path: PathSink
  readonly #frame: Frame
  readonly #left: number
  readonly #top: number
  /** The first point of the current loop, and the last point of the path, in pixels. */
  #startX = 0
  #startY = 0
  #atX = 0
  #atY = 0

  /** `path` is in pixels. */
  constructor(frame: Frame, path: PathSink) {
    this.path = path
    this.#frame = frame
    this.#left = frame.width / 2
    this.#top = frame.height / 2
  }

  x(x: number): number {
    return this.#left + (x - this.#frame.x) * this.#frame.scale
  }

  y(y: number): number {
    return this.#top - (y - this.#frame.y) * this.#frame.scale
  }

  moveTo(x: number, y: number): void {
    this.#atX = this.#startX = this.x(x)
    this.#atY = this.#startY = this.y(y)
    this.path.moveTo(nearest(this.#atX), nearest(this.#atY))
  }

  lineTo(x: number, y: number): void {
    this.#lineTo(this.x(x), this.y(y))
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    const endX = this.x(x)
    const endY = this.y(y)
    this.#curve(this.#atX, this.#atY, this.x(x1), this.y(y1), this.x(x2), this.y(y2), endX, endY, MOST_HALVES)
    this.#atX = endX
    this.#atY = endY
  }

  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise = false): void {
    // Flipping y changes the sign of angles and the sense of rotation.
    this.path.arc(this.x(x), this.y(y), radius * this.#frame.scale, -startAngle, -endAngle, !counterclockwise)
    this.#atX = this.x(x + radius * Math.cos(endAngle))
    this.#atY = this.y(y + radius * Math.sin(endAngle))
  }

  closePath(): void {
    if (!isNear(this.#startX, this.#startY, this.#atX, this.#atY)) this.#lineTo(this.#startX, this.#startY)
    this.path.closePath()
    this.#atX = this.#startX
    this.#atY = this.#startY
  }

  /** Draws a line to a point in pixels. */
  #lineTo(x: number, y: number): void {
    if (isNear(this.#atX, this.#atY, x, y)) this.path.lineTo(x, y)
    else this.#curve(this.#atX, this.#atY, this.#atX, this.#atY, x, y, x, y, MOST_HALVES)
    this.#atX = x
    this.#atY = y
  }

  /**
   * Draws a cubic curve, halved until each part is near the frame or beyond one of its sides. A part beyond a side
   * becomes a line between clamped ends, which stay beyond the same side.
   */
  #curve(
    x0: number,
    y0: number,
    x1: number,
    y1: number,
    x2: number,
    y2: number,
    x3: number,
    y3: number,
    halves: number,
  ): void {
    if (isNear(x0, y0, x1, y1) && isNear(x2, y2, x3, y3)) {
      this.path.bezierCurveTo(x1, y1, x2, y2, x3, y3)
      return
    }
    const { width, height } = this.#frame
    const isBeside = isBeyond(x0, x1, x2, x3, width) || isBeyond(y0, y1, y2, y3, height)
    if (isBeside || halves === 0 || !Number.isFinite(x0 + y0 + x1 + y1 + x2 + y2 + x3 + y3)) {
      this.path.lineTo(nearest(x3), nearest(y3))
      return
    }
    const [x01, x12, x23] = [(x0 + x1) / 2, (x1 + x2) / 2, (x2 + x3) / 2]
    const [y01, y12, y23] = [(y0 + y1) / 2, (y1 + y2) / 2, (y2 + y3) / 2]
    const [x012, x123, y012, y123] = [(x01 + x12) / 2, (x12 + x23) / 2, (y01 + y12) / 2, (y12 + y23) / 2]
    const [x, y] = [(x012 + x123) / 2, (y012 + y123) / 2]
    this.#curve(x0, y0, x01, y01, x012, y012, x, y, halves - 1)
    this.#curve(x, y, x123, y123, x23, y23, x3, y3, halves - 1)
  }
}

/** Whether all coordinates are small enough for browsers. */
function isNear(a: number, b: number, c: number, d: number): boolean {
  return Math.abs(a) <= FARTHEST && Math.abs(b) <= FARTHEST && Math.abs(c) <= FARTHEST && Math.abs(d) <= FARTHEST
}

/** Whether all coordinates lie on the same side of the interval from 0 to `size`. */
function isBeyond(a: number, b: number, c: number, d: number, size: number): boolean {
  return Math.max(a, b, c, d) < -MARGIN || Math.min(a, b, c, d) > size + MARGIN
}

/** Clamps a coordinate to the range that browsers handle. */
function nearest(value: number): number {
  return Math.min(Math.max(value, -FARTHEST), FARTHEST)
}
