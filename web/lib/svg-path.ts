// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from './path-sink.ts'

/** Collects what is drawn as the `d` attribute of an SVG path. */
export class SvgPath implements PathSink {
  readonly #scale: number
  #text = ''
  #x = Number.NaN
  #y = Number.NaN

  /** `digits`: how many of them numbers have after the decimal point; all, if it is left out or more than doubles have. */
  constructor(digits = Number.POSITIVE_INFINITY) {
    this.#scale = 10 ** digits
  }

  /** The text; empty if nothing was drawn. */
  toString(): string {
    return this.#text
  }

  moveTo(x: number, y: number): void {
    this.#go('M', x, y)
  }

  lineTo(x: number, y: number): void {
    this.#go('L', x, y)
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    this.#go(`C${this.#rounded(x1)},${this.#rounded(y1)} ${this.#rounded(x2)},${this.#rounded(y2)} `, x, y)
  }

  /** As on a canvas, a line leads to the start of the arc. */
  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise = false): void {
    const pointAt = (angle: number) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const
    const [startX, startY] = pointAt(startAngle)
    if (this.#text === '') this.moveTo(startX, startY)
    else if (this.#x !== startX || this.#y !== startY) this.lineTo(startX, startY)
    // An arc of SVG is less than a full turn: two halves are as good as any.
    const middle = (startAngle + endAngle) / 2
    const size = this.#rounded(radius)
    for (const angle of [middle, endAngle]) {
      this.#go(`A${size},${size} 0 0 ${counterclockwise ? 0 : 1} `, ...pointAt(angle))
    }
  }

  closePath(): void {
    this.#text += 'Z'
  }

  #go(command: string, x: number, y: number): void {
    this.#text += `${command}${this.#rounded(x)},${this.#rounded(y)}`
    this.#x = x
    this.#y = y
  }

  #rounded(value: number): number {
    const scaled = value * this.#scale
    // Beyond that a double has no digits to round off.
    return Math.abs(scaled) < 2 ** 53 ? Math.round(scaled) / this.#scale : value
  }
}
