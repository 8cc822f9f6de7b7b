// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'
import { SvgPath } from '../../lib/svg-path.ts'

/** What pictures are drawn on, in pixels: a canvas, or the text of an SVG. */
export interface Drawing {
  /** A path of this drawing, without anything yet. */
  path(): PathSink
  /** Covers all of it. */
  cover(color: string): void
  fill(path: PathSink, color: string, opacity?: number): void
  stroke(path: PathSink, color: string, width: number, dash?: readonly number[], opacity?: number): void
}

export class CanvasDrawing implements Drawing {
  readonly #context: OffscreenCanvasRenderingContext2D | CanvasRenderingContext2D

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
}

/** Digits after the decimal point of pixels. */
const DIGITS = 2

export class SvgDrawing implements Drawing {
  readonly #elements: string[] = []

  path(): PathSink {
    return new SvgPath(DIGITS)
  }

  cover(color: string): void {
    this.#elements.push(`<rect width="100%" height="100%" fill="${color}"/>`)
  }

  fill(path: PathSink, color: string, opacity = 1): void {
    this.#add(path, `fill="${color}"${opacity === 1 ? '' : ` fill-opacity="${opacity}"`}`)
  }

  stroke(path: PathSink, color: string, width: number, dash: readonly number[] = [], opacity = 1): void {
    const dashes = dash.length === 0 ? '' : ` stroke-dasharray="${dash.join(' ')}"`
    const alpha = opacity === 1 ? '' : ` stroke-opacity="${opacity}"`
    this.#add(path, `fill="none" stroke="${color}" stroke-width="${Number(width.toFixed(2))}"${dashes}${alpha}`)
  }

  #add(path: PathSink, look: string): void {
    const text = String(path)
    if (text !== '') this.#elements.push(`<path ${look} d="${text}"/>`)
  }

  /** The elements, in their order. */
  toString(): string {
    return this.#elements.join('\n')
  }
}

/** The text of an SVG with these elements. */
export function svgOf(width: number, height: number, elements: readonly string[]): string {
  const body = elements.filter((text) => text !== '').join('\n')
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" stroke-linejoin="round" stroke-linecap="round">\n${body}\n</svg>\n`
}
