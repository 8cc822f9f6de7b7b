// SPDX-License-Identifier: GPL-3.0-or-later

import type { PathSink } from '../base/types.ts'
import { DecimalText } from './decimal.ts'

/** Many small strings that live long are much work for a garbage collector. */
const FEW_COMMANDS = 500

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
  readonly #decimal: DecimalText
  /** What is drawn, and the last commands that are still to be added to it. */
  #text = ''
  #commands: string[] = []
  #x = Number.NaN
  #y = Number.NaN

  /** `digits` is the number of digits after the decimal point. By default numbers have all their digits. */
  constructor(digits = Number.POSITIVE_INFINITY) {
    this.#decimal = new DecimalText(digits)
  }

  /** Returns the text, which is empty if nothing was drawn. */
  toString(): string {
    this.#flush()
    return this.#text
  }

  moveTo(x: number, y: number): void {
    this.#go('M', x, y)
  }

  lineTo(x: number, y: number): void {
    this.#go('L', x, y)
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    this.#go(`C${this.#decimal.of(x1)},${this.#decimal.of(y1)} ${this.#decimal.of(x2)},${this.#decimal.of(y2)} `, x, y)
  }

  /** As on a canvas, a line leads to the start of the arc. */
  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise = false): void {
    const pointAt = (angle: number) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const
    const [startX, startY] = pointAt(startAngle)
    if (this.#commands.length === 0 && this.#text === '') this.moveTo(startX, startY)
    else if (this.#x !== startX || this.#y !== startY) this.lineTo(startX, startY)
    // An arc of SVG is less than a full turn: two halves are as good as any.
    const middle = (startAngle + endAngle) / 2
    const size = this.#decimal.of(radius)
    for (const angle of [middle, endAngle]) {
      this.#go(`A${size},${size} 0 0 ${counterclockwise ? 0 : 1} `, ...pointAt(angle))
    }
  }

  closePath(): void {
    this.#add('Z')
  }

  #go(command: string, x: number, y: number): void {
    this.#add(`${command}${this.#decimal.of(x)},${this.#decimal.of(y)}`)
    this.#x = x
    this.#y = y
  }

  #add(command: string): void {
    if (this.#commands.push(command) === FEW_COMMANDS) this.#flush()
  }

  #flush(): void {
    this.#text += this.#commands.join('')
    this.#commands = []
  }
}
