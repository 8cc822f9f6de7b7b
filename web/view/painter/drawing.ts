// SPDX-License-Identifier: GPL-3.0-or-later

import { SvgPath } from '../../lib/drawing/svg-path.ts'
import type { PathSink } from '../../lib/index.ts'

/** What pictures are drawn on, in pixels: a canvas, or the text of an SVG. */
export interface Drawing {
  /** A path of this drawing, without anything yet. */
  path(): PathSink
  /** Covers all of it. */
  cover(color: string): void
  fill(path: PathSink, color: string, opacity?: number): void
  stroke(path: PathSink, color: string, width: number, dash?: readonly number[], opacity?: number): void
  /** A word in the middle of a place, `size` high, with a rim of another color so that it is read on anything. */
  write(text: string, x: number, y: number, size: number, color: string, rim: string): void
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

  write(text: string, x: number, y: number, size: number, color: string, rim: string): void {
    const place = `x="${x.toFixed(DIGITS)}" y="${y.toFixed(DIGITS)}" text-anchor="middle" dominant-baseline="central"`
    const font = `font-family="system-ui, sans-serif" font-weight="600" font-size="${size}"`
    const look = `fill="${color}" stroke="${rim}" stroke-width="${size / 4}" paint-order="stroke"`
    this.#elements.push(`<text ${place} ${font} ${look}>${text}</text>`)
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
