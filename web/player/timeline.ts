// SPDX-License-Identifier: GPL-3.0-or-later
import type { Colors } from './step-overlay.ts'
import { kindOf, type Step } from './steps.ts'
import type { StepKind } from './words.ts'

/** The rows of marks from top to bottom: the color of each kind, and its vertical range. */
const ROWS: readonly (readonly [sort: StepKind, color: keyof Colors, top: number, bottom: number])[] = [
  ['stage', 'past', 0, 1],
  ['circle', 'current', 0, 0.3],
  ['disc', 'sample', 0.72, 0.95],
  ['rejected', 'bad', 0.42, 0.66],
  ['edge', 'past', 0.2, 0.36],
  ['vertex', 'edge', 0.04, 0.36],
]

/** The columns of the timelines on screen, by width. */
const known = new WeakMap<readonly Step[], readonly ReadonlyMap<StepKind, number>[]>()
/** Opacity of a mark in the columns where its kind is rarest. */
const WEAKEST = 0.15

function knownColumns(steps: readonly Step[], width: number): readonly ReadonlyMap<StepKind, number>[] {
  const before = known.get(steps)
  if (before?.length === width) return before
  const columns = columnsOf(steps, width)
  known.set(steps, columns)
  return columns
}

/** Counts the steps of each kind in every column of pixels. */
export function columnsOf(steps: readonly Step[], width: number): readonly ReadonlyMap<StepKind, number>[] {
  const columns = Array.from({ length: width }, () => new Map<StepKind, number>())
  const last = Math.max(steps.length - 1, 1)
  for (const [k, step] of steps.entries()) {
    const sort = kindOf(step)
    const column = columns[Math.round((k / last) * (width - 1))]
    if (sort !== undefined) column?.set(sort, (column.get(sort) ?? 0) + 1)
  }
  return columns
}

/** Draws the marks of each kind, the breakpoints, and the current position. */
export function drawTimeline(
  canvas: HTMLCanvasElement,
  steps: readonly Step[],
  current: number,
  breakpoints: ReadonlySet<number>,
  colors: Colors,
): void {
  const width = Math.max(Math.round(canvas.clientWidth * devicePixelRatio), 1)
  const height = Math.max(Math.round(canvas.clientHeight * devicePixelRatio), 1)
  canvas.width = width
  canvas.height = height
  const context = canvas.getContext('2d')
  if (context === null) return
  const thick = Math.max(1, Math.round(devicePixelRatio))
  const columns = knownColumns(steps, width)
  for (const [sort, color, top, bottom] of ROWS) {
    context.fillStyle = colors[color]
    const most = columns.reduce((most, counts) => Math.max(most, counts.get(sort) ?? 0), 1)
    for (const [x, counts] of columns.entries()) {
      const count = counts.get(sort)
      if (count === undefined) continue
      // A column that stands for many steps shows their number by opacity.
      context.globalAlpha = most === 1 ? 1 : WEAKEST + ((1 - WEAKEST) * count) / most
      context.fillRect(x, top * height, thick, (bottom - top) * height)
    }
  }
  context.globalAlpha = 1
  const place = (k: number) => (k / Math.max(steps.length - 1, 1)) * (width - 1)
  context.fillStyle = colors.bad
  for (const k of breakpoints) {
    context.beginPath()
    context.arc(place(k), height - 4 * devicePixelRatio, 4 * devicePixelRatio, 0, 2 * Math.PI)
    context.fill()
  }
  context.fillStyle = colors.ink
  context.fillRect(place(current) - thick, 0, 2 * thick, height)
}
