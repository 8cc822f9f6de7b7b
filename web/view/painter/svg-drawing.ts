// SPDX-License-Identifier: GPL-3.0-or-later
import { escaped } from '../../lib/drawing/escaped.ts'
import { SvgPath } from '../../lib/drawing/svg-path.ts'
import type { PathSink } from '../../lib/index.ts'
import type { Drawing } from './drawing.ts'

/** Decimal places of pixel coordinates. */
const DIGITS = 2

export class SvgDrawing implements Drawing {
  readonly #elements: string[] = []
  readonly #clips = new Set<string>()
  #isClipped = false

  path(): PathSink {
    return new SvgPath(DIGITS)
  }

  cover(color: string): void {
    this.#elements.push(`<rect width="100%" height="100%" fill="${escaped(color)}"/>`)
  }

  fill(path: PathSink, color: string, opacity = 1): void {
    this.#add(path, `fill="${escaped(color)}"${opacity === 1 ? '' : ` fill-opacity="${opacity}"`}`)
  }

  write(text: string, x: number, y: number, size: number, color: string, rim: string): void {
    const place = `x="${x.toFixed(DIGITS)}" y="${y.toFixed(DIGITS)}" text-anchor="middle" dominant-baseline="central"`
    const font = `font-family="system-ui, sans-serif" font-weight="600" font-size="${size}"`
    const look = `fill="${escaped(color)}" stroke="${escaped(rim)}" stroke-width="${size / 4}" paint-order="stroke"`
    this.#elements.push(`<text ${place} ${font} ${look}>${escaped(text)}</text>`)
  }

  stroke(path: PathSink, color: string, width: number, dash: readonly number[] = [], opacity = 1): void {
    const dashes = dash.length === 0 ? '' : ` stroke-dasharray="${dash.join(' ')}"`
    const alpha = opacity === 1 ? '' : ` stroke-opacity="${opacity}"`
    this.#add(
      path,
      `fill="none" stroke="${escaped(color)}" stroke-width="${Number(width.toFixed(2))}"${dashes}${alpha}`,
    )
  }

  clip(path: PathSink | undefined): void {
    if (this.#isClipped) this.#elements.push('</g>')
    this.#isClipped = path !== undefined
    if (path === undefined) return
    const shape = String(path)
    const id = nameOf(shape)
    if (!this.#clips.has(id)) this.#elements.push(`<clipPath id="${id}"><path d="${shape}"/></clipPath>`)
    this.#clips.add(id)
    this.#elements.push(`<g clip-path="url(#${id})">`)
  }

  /** Adds an invisible area with a tooltip. */
  title(path: PathSink, text: string): void {
    const shape = String(path)
    if (shape === '') return
    const title = `<title>${escaped(text)}</title>`
    this.#elements.push(`<path fill="none" pointer-events="all" d="${shape}">${title}</path>`)
  }

  #add(path: PathSink, look: string): void {
    const text = String(path)
    if (text !== '') this.#elements.push(`<path ${look} d="${text}"/>`)
  }

  /** The markup of all elements. */
  toString(): string {
    return this.#elements.join('\n')
  }
}

/** An id that depends on the shape, to avoid collisions between pictures in one page. */
function nameOf(shape: string): string {
  let hash = 0
  for (let k = 0; k < shape.length; k++) hash = (Math.imul(hash, 31) + shape.charCodeAt(k)) >>> 0
  return `region-${hash.toString(36)}-${shape.length}`
}

/** The markup of an SVG with these elements, which screen readers call `title`. */
export function svgOf(width: number, height: number, elements: readonly string[], title: string): string {
  const body = elements.filter((text) => text !== '').join('\n')
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img" stroke-linejoin="round" stroke-linecap="round">\n<title>${escaped(title)}</title>\n${body}\n</svg>\n`
}
