// SPDX-License-Identifier: GPL-3.0-or-later

import type { PathSink } from '../base/types.ts'
import { DecimalText } from './decimal.ts'

/**
 * Collects drawing commands as the `d` attribute of an SVG path.
 *
 * @category Drawing
 * @example
 * const path = new SvgPath(1)
 * path.moveTo(0, 0)
 * path.lineTo(1.25, 2)
 * `${path}` // 'M0,0L1.3,2'
 */
export class SvgPath implements PathSink {
  readonly #text: DecimalText
  /** The unit of the last digit. Points closer than this are equal in the text. */
  readonly #unit: number
  #x = Number.NaN
  #y = Number.NaN

  /**
   * Creates an empty path that writes its numbers with at most `digits` digits after the decimal point. By default
   * numbers have all their digits.
   */
  constructor(digits = Number.POSITIVE_INFINITY) {
    this.#text = new DecimalText(digits)
    this.#unit = digits < Number.POSITIVE_INFINITY ? 10 ** -digits : 0
  }

  /** Returns the text, which is empty if nothing was drawn. */
  toString(): string {
    return this.#text.toString()
  }

  /** @internal Returns the text and begins again with an empty one. */
  take(): string {
    this.#x = Number.NaN
    this.#y = Number.NaN
    return this.#text.take()
  }

  moveTo(x: number, y: number): void {
    this.#text.add('M')
    this.#go(x, y)
  }

  lineTo(x: number, y: number): void {
    this.#text.add('L')
    this.#go(x, y)
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    this.#text.add('C')
    this.#addPoint(x1, y1)
    this.#text.add(' ')
    this.#addPoint(x2, y2)
    this.#text.add(' ')
    this.#go(x, y)
  }

  /**
   * Adds an arc of a circle from one angle to another, in radians, towards larger angles, or towards smaller ones if
   * `counterclockwise`. As on a canvas, a line leads from the current point to the start of the arc.
   */
  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise = false): void {
    const pointAt = (angle: number) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const
    const [startX, startY] = pointAt(startAngle)
    if (this.#text.isEmpty) this.moveTo(startX, startY)
    else if (!this.#isAt(startX, startY)) this.lineTo(startX, startY)
    // An arc of SVG is less than a full turn, so the arc is split into two halves.
    const middle = (startAngle + endAngle) / 2
    for (const angle of [middle, endAngle]) {
      this.#text.add('A')
      this.#addPoint(radius, radius)
      this.#text.add(counterclockwise ? ' 0 0 0 ' : ' 0 0 1 ')
      this.#go(...pointAt(angle))
    }
  }

  closePath(): void {
    this.#text.add('Z')
  }

  /** Whether the path is at (x, y), up to the last bits of a cosine, in which engines may differ. */
  #isAt(x: number, y: number): boolean {
    if (this.#x === x && this.#y === y) return true
    return Math.abs(this.#x - x) < this.#unit && Math.abs(this.#y - y) < this.#unit
  }

  #go(x: number, y: number): void {
    this.#addPoint(x, y)
    this.#x = x
    this.#y = y
  }

  #addPoint(x: number, y: number): void {
    this.#text.addNumber(x)
    this.#text.add(',')
    this.#text.addNumber(y)
  }
}
