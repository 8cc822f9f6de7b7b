// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'
import type { Frame } from './frame.ts'

/**
 * Takes a path in the plane and draws it in the pixels of a frame. What a canvas is given has single precision: numbers
 * are seen from the middle of the frame, in doubles, before it gets them. The plane is y-up, the frame y-down.
 */
export class FrameSink implements PathSink {
  readonly path: PathSink
  readonly #frame: Frame
  readonly #left: number
  readonly #top: number

  /** `path`: in pixels. */
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
    this.path.moveTo(this.x(x), this.y(y))
  }

  lineTo(x: number, y: number): void {
    this.path.lineTo(this.x(x), this.y(y))
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    this.path.bezierCurveTo(this.x(x1), this.y(y1), this.x(x2), this.y(y2), this.x(x), this.y(y))
  }

  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise = false): void {
    // Upside down angles change their sign, and with it the sense of rotation.
    this.path.arc(this.x(x), this.y(y), radius * this.#frame.scale, -startAngle, -endAngle, !counterclockwise)
  }

  closePath(): void {
    this.path.closePath()
  }
}
