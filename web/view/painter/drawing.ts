// SPDX-License-Identifier: GPL-3.0-or-later

import type { PathSink } from '../../lib/index.ts'

/** The target of a picture, in pixels: a canvas, or the text of an SVG. */
export interface Drawing {
  /** Creates an empty path. */
  path(): PathSink
  /** Fills the whole drawing. */
  cover(color: string): void
  fill(path: PathSink, color: string, opacity?: number): void
  stroke(path: PathSink, color: string, width: number, dash?: readonly number[], opacity?: number): void
  /** Limits all further drawing to the inside of a path; `undefined` removes the limit. */
  clip(path: PathSink | undefined): void
  /** Writes centered text of height `size`, with an outline that keeps it readable on any background. */
  write(text: string, x: number, y: number, size: number, color: string, rim: string): void
}

export class CanvasDrawing implements Drawing {
  readonly #context: OffscreenCanvasRenderingContext2D | CanvasRenderingContext2D
  #isClipped = false

  constructor(context: OffscreenCanvasRenderingContext2D | CanvasRenderingContext2D) {
    this.#context = context
    context.lineJoin = 'round'
    context.lineCap = 'round'
  }

  path(): PathSink {
    return new Path2D()
  }

  cover(color: string): void {
    this.#context.fillStyle = color
    this.#context.fillRect(0, 0, this.#context.canvas.width, this.#context.canvas.height)
  }

  fill(path: PathSink, color: string, opacity = 1): void {
    this.#context.globalAlpha = opacity
    this.#context.fillStyle = color
    this.#context.fill(path as Path2D)
    this.#context.globalAlpha = 1
  }

  stroke(path: PathSink, color: string, width: number, dash: readonly number[] = [], opacity = 1): void {
    this.#context.globalAlpha = opacity
    this.#context.strokeStyle = color
    this.#context.lineWidth = width
    this.#context.setLineDash([...dash])
    this.#context.stroke(path as Path2D)
    this.#context.globalAlpha = 1
  }

  clip(path: PathSink | undefined): void {
    if (this.#isClipped) this.#context.restore()
    this.#isClipped = path !== undefined
    if (path === undefined) return
    this.#context.save()
    this.#context.clip(path as Path2D)
  }

  write(text: string, x: number, y: number, size: number, color: string, rim: string): void {
    const context = this.#context
    context.font = `600 ${size}px system-ui, sans-serif`
    context.textAlign = 'center'
    context.textBaseline = 'middle'
    context.lineWidth = size / 4
    context.setLineDash([])
    context.strokeStyle = rim
    context.strokeText(text, x, y)
    context.fillStyle = color
    context.fillText(text, x, y)
  }
}
