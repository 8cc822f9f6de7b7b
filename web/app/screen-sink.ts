// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../lib/index.ts'
import { type Camera, type Size, toScreen } from './camera.ts'

/**
 * Takes a path in the plane and draws it on a path in pixels. The numbers are converted here and not by a transform of the
 * canvas, whose single precision fails when the picture is magnified.
 */
export class ScreenSink implements PathSink {
  readonly path = new Path2D()
  readonly #left: number
  readonly #top: number
  readonly #scale: number

  constructor(camera: Camera, size: Size) {
    const origin = toScreen(camera, size, { x: 0, y: 0 })
    this.#left = origin.x
    this.#top = origin.y
    this.#scale = camera.scale
  }

  #x(x: number): number {
    return this.#left + x * this.#scale
  }

  #y(y: number): number {
    return this.#top - y * this.#scale
  }

  moveTo(x: number, y: number): void {
    this.path.moveTo(this.#x(x), this.#y(y))
  }

  lineTo(x: number, y: number): void {
    this.path.lineTo(this.#x(x), this.#y(y))
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    this.path.bezierCurveTo(this.#x(x1), this.#y(y1), this.#x(x2), this.#y(y2), this.#x(x), this.#y(y))
  }

  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise = false): void {
    // The screen is upside down: angles change their sign, and with it the sense of rotation.
    this.path.arc(this.#x(x), this.#y(y), radius * this.#scale, -startAngle, -endAngle, !counterclockwise)
  }

  closePath(): void {
    this.path.closePath()
  }
}
