// SPDX-License-Identifier: GPL-3.0-or-later
import type { Padding } from './camera.ts'
import type { Label } from './labels.ts'
import type { Frame } from './painter/frame.ts'
import { roundStep } from './round-step.ts'

/** Spacing of a grid's lines, in pixels, and the spacing that their numbers need. */
const SPACING = 16
/** Lines per number, by the first digit of the spacing: numbers stand at 5, 10 and 20 times a power of ten. */
const PER_NUMBER: Readonly<Record<string, number>> = { 1: 5, 2: 5, 5: 4 }
/** Farther lines cannot be counted exactly. */
const MOST_COUNTED = 2 ** 50
/** Height of the numbers, their distance from an axis, and the estimated width of a digit, in pixels. */
export const NUMBER_SIZE = 11
const ASIDE = 10
const DIGIT = 0.62

/** The distance between the lines of a grid, at a scale in pixels per unit. */
export function gridSpacing(scale: number): number {
  return roundStep(SPACING / scale)
}

/** The places of lines along one direction, in pixels. */
interface Lines {
  readonly fine: readonly number[]
  /** The lines with numbers. */
  readonly numbered: readonly number[]
  /** The axis, or none. */
  readonly axis: readonly number[]
}

/** The lines of a grid and the numbers at its axes, in pixels of a frame. */
export interface Axes {
  readonly vertical: Lines
  readonly horizontal: Lines
  readonly numbers: readonly Label[]
}

/** The grid of a frame, in CSS pixels. An axis that is not visible has its numbers at the border, off what covers it. */
export function axesOf(frame: Frame, covered: Padding): Axes {
  const { x, y, scale, width, height } = frame
  const spacing = gridSpacing(scale)
  const perNumber = PER_NUMBER[spacing.toExponential().charAt(0)] as number
  const numbers: Label[] = []
  const across = (place: number) => width / 2 + (place - x) * scale
  const down = (place: number) => height / 2 - (place - y) * scale
  const linesOf = (
    from: number,
    to: number,
    toPixel: (place: number) => number,
    write: (text: string, at: number) => void,
  ): Lines => {
    const [first, last] = [Math.ceil(from / spacing), Math.floor(to / spacing)]
    if (!(Math.max(Math.abs(first), Math.abs(last)) < MOST_COUNTED)) return { fine: [], numbered: [], axis: [] }
    const [fine, numbered]: [number[], number[]] = [[], []]
    for (let k = first; k <= last; k++) {
      const place = toPixel(k * spacing)
      if (k % perNumber !== 0) fine.push(place)
      else if (k !== 0) numbered.push(place)
      if (k % perNumber === 0) write(textOf(k * spacing), place)
    }
    return { fine, numbered, axis: first <= 0 && last >= 0 ? [toPixel(0)] : [] }
  }
  const middleY = Math.min(Math.max(down(0) + ASIDE, covered.top + ASIDE), height - covered.bottom - ASIDE)
  const vertical = linesOf(x - width / scale / 2, x + width / scale / 2, across, (text, at) => {
    // The origin is written once, beside both axes.
    if (text !== '0') numbers.push({ text, x: at, y: middleY })
  })
  const horizontal = linesOf(y - height / scale / 2, y + height / scale / 2, down, (text, at) => {
    const half = (text.length * DIGIT * NUMBER_SIZE) / 2
    const left = across(0) - 4 - half
    const middleX = Math.min(Math.max(left, covered.left + half + 4), width - covered.right - half - 4)
    numbers.push({ text, x: middleX, y: text === '0' ? at + ASIDE : at })
  })
  return { vertical, horizontal, numbers }
}

function textOf(value: number): string {
  return String(Number(value.toPrecision(12))).replace('-', '−')
}
