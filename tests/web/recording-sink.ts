// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink, Point } from '../../web/lib/index.ts'

/** Records points along everything drawn. A move without drawing begins a new stroke. */
export class RecordingSink implements PathSink {
  readonly strokes: Point[][] = []
  /** The number of cubic Bezier curves. */
  curves = 0
  readonly #pointsPerCurve: number

  constructor(pointsPerCurve = 16) {
    this.#pointsPerCurve = pointsPerCurve
  }

  get points(): Point[] {
    return this.strokes.flat()
  }

  moveTo(x: number, y: number): void {
    this.strokes.push([{ x, y }])
  }

  lineTo(x: number, y: number): void {
    const from = this.#last()
    this.#spread((s) => ({ x: from.x + s * (x - from.x), y: from.y + s * (y - from.y) }))
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    const from = this.#last()
    const cubic = (p0: number, p1: number, p2: number, p3: number, s: number) =>
      (1 - s) ** 3 * p0 + 3 * (1 - s) ** 2 * s * p1 + 3 * (1 - s) * s ** 2 * p2 + s ** 3 * p3
    this.#spread((s) => ({ x: cubic(from.x, x1, x2, x, s), y: cubic(from.y, y1, y2, y, s) }))
    this.curves += 1
  }

  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number): void {
    this.#spread((s) => {
      const angle = startAngle + s * (endAngle - startAngle)
      return { x: x + radius * Math.cos(angle), y: y + radius * Math.sin(angle) }
    })
  }

  closePath(): void {
    const stroke = this.strokes.at(-1) as Point[]
    stroke.push(stroke[0] as Point)
  }

  #last(): Point {
    return this.strokes.at(-1)?.at(-1) as Point
  }

  #spread(pointAt: (s: number) => Point): void {
    const stroke = this.strokes.at(-1) as Point[]
    for (let k = 1; k <= this.#pointsPerCurve; k++) stroke.push(pointAt(k / this.#pointsPerCurve))
  }
}

/** Twice the area of a closed polygon, positive if it is counter-clockwise. */
export function doubleArea(polygon: readonly Point[]): number {
  return polygon.reduce((sum, p, k) => {
    const q = polygon[(k + 1) % polygon.length] as Point
    return sum + p.x * q.y - q.x * p.y
  }, 0)
}

/** The winding number of a closed polygon around a point. */
export function windingOf(polygon: readonly Point[], { x, y }: Point): number {
  return polygon.reduce((count, a, k) => {
    const b = polygon[(k + 1) % polygon.length] as Point
    if (a.y <= y === b.y <= y) return count
    const side = (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)
    const turn = b.y > a.y ? 1 : -1
    return side * turn > 0 ? count + turn : count
  }, 0)
}
