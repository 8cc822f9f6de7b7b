// SPDX-License-Identifier: GPL-3.0-or-later

import { at, NONE } from '../../lib/base/diagram-data.ts'
import { hypotenuse } from '../../lib/base/scale.ts'
import type { BoundedCurve } from '../../lib/curves/curve.ts'
import { type Diagram, outlineArea } from '../../lib/index.ts'
import type { Measure } from '../layers.ts'
import { TINTS } from '../style.ts'
import { idOf } from './cell-boxes.ts'

/** So many cells say which are the small ones. */
const MOST_SAMPLES = 2000

/** The tints of cells by a measure: each tint as many as others, equal measures one; the number of neighbors up to 4, 5 … 8, more. */
export class Measures {
  readonly measure: Measure
  readonly #diagram: Diagram
  #bounds: readonly number[] | undefined
  /** What takes long to find, by the circles' ids. */
  #known = new Float64Array()

  constructor(measure: Measure, diagram: Diagram) {
    this.measure = measure
    this.#diagram = diagram
  }

  /** From 0 to 5. */
  tintOf(i: number): number {
    this.#bounds ??= this.measure === 'degree' ? [5, 6, 7, 8, 9] : this.#quantiles()
    const value = this.valueOf(i)
    let tint = 0
    while (tint < TINTS - 1 && (this.#bounds[tint] as number) <= value) tint += 1
    return tint
  }

  /** Of a circle by its index. */
  valueOf(i: number): number {
    const diagram = this.#diagram
    if (this.measure === 'index') return idOf(diagram, i)
    if (this.measure === 'radius') return at(diagram.circles, 3 * i + 2)
    if (this.measure === 'degree') return new Set(diagram.neighbors(i)).size
    const id = idOf(diagram, i)
    if (id >= this.#known.length) {
      const larger = new Float64Array(2 * id + 16).fill(Number.NaN)
      larger.set(this.#known)
      this.#known = larger
    }
    if (Number.isNaN(this.#known[id]))
      this.#known[id] = this.measure === 'area' ? cellArea(diagram, i) : gap(diagram, i)
    return at(this.#known, id)
  }

  /** Circles by their ids whose cells have changed. */
  forget(ids: Iterable<number>): void {
    for (const id of ids) if (id < this.#known.length) this.#known[id] = Number.NaN
  }

  /** Of cells that there are. */
  #quantiles(): number[] {
    const { circles, cells } = this.#diagram
    const count = circles.length / 3
    const step = Math.max(Math.ceil(count / MOST_SAMPLES), 1)
    const some = Array.from({ length: Math.floor(count / step) }, (_, k) => k * step).filter((i) => cells.exists(i))
    const values = Float64Array.from(some, (i) => this.valueOf(i)).sort()
    return Array.from({ length: TINTS - 1 }, (_, k) => values[Math.floor(((k + 1) * values.length) / TINTS)] ?? 0)
  }
}

/** The area of a cell; infinite, if it goes to infinity; 0 if there is none. */
export function cellArea({ cells }: Diagram, i: number): number {
  if (!cells.exists(i)) return 0
  if (!cells.isBounded(i)) return Number.POSITIVE_INFINITY
  const pieces = Array.from(cells.sides(i), (side) => ({
    curve: cells.curveOf(side) as BoundedCurve,
    side,
    neighbor: NONE,
    r: 0,
  }))
  return outlineArea([pieces])
}

/** The distance from a circle to the nearest other one, a neighbor: negative if they overlap. */
function gap(diagram: Diagram, i: number): number {
  const { circles } = diagram
  let least = Number.POSITIVE_INFINITY
  for (const j of diagram.neighbors(i)) {
    const distance = hypotenuse(
      at(circles, 3 * i) - at(circles, 3 * j),
      at(circles, 3 * i + 1) - at(circles, 3 * j + 1),
    )
    least = Math.min(least, distance - at(circles, 3 * i + 2) - at(circles, 3 * j + 2))
  }
  return least
}
