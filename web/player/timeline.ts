// SPDX-License-Identifier: GPL-3.0-or-later
import { type Sort, type Step, sortOf } from './steps.ts'

/** The rows of marks, from the top: what each sort is drawn in, and how high it reaches. */
const ROWS: readonly (readonly [sort: Sort, color: string, top: number, bottom: number])[] = [
  ['stage', '--player-past', 0, 1],
  ['circle', '--player-current', 0, 0.3],
  ['disc', '--player-sample', 0.72, 0.95],
  ['rejected', '--player-bad', 0.42, 0.66],
  ['edge', '--player-past', 0.2, 0.36],
  ['vertex', '--player-edge', 0.04, 0.36],
]

/** Those of steps that are shown, as wide as they are. */
const known = new WeakMap<readonly Step[], readonly ReadonlySet<Sort>[]>()

function knownColumns(steps: readonly Step[], width: number): readonly ReadonlySet<Sort>[] {
  const before = known.get(steps)
  if (before?.length === width) return before
  const columns = columnsOf(steps, width)
  known.set(steps, columns)
  return columns
}

/** For each column of pixels the sorts of its steps. */
export function columnsOf(steps: readonly Step[], width: number): readonly ReadonlySet<Sort>[] {
  const columns = Array.from({ length: width }, () => new Set<Sort>())
  const last = Math.max(steps.length - 1, 1)
  for (const [k, step] of steps.entries()) {
    const sort = sortOf(step)
    if (sort !== undefined) columns[Math.round((k / last) * (width - 1))]?.add(sort)
  }
  return columns
}

/** Draws marks by sort, the breakpoints, and where the reader is. */
export function drawTimeline(
  canvas: HTMLCanvasElement,
  steps: readonly Step[],
  current: number,
  breakpoints: ReadonlySet<number>,
  colorOf: (property: string) => string,
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
    context.fillStyle = colorOf(color)
    for (const [x, sorts] of columns.entries()) {
      if (sorts.has(sort)) context.fillRect(x, top * height, thick, (bottom - top) * height)
    }
  }
  const place = (k: number) => (k / Math.max(steps.length - 1, 1)) * (width - 1)
  context.fillStyle = colorOf('--player-bad')
  for (const k of breakpoints) {
    context.beginPath()
    context.arc(place(k), height - 4 * devicePixelRatio, 4 * devicePixelRatio, 0, 2 * Math.PI)
    context.fill()
  }
  context.fillStyle = colorOf('--player-ink')
  context.fillRect(place(current) - thick, 0, 2 * thick, height)
}
