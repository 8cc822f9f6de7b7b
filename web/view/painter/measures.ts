// SPDX-License-Identifier: GPL-3.0-or-later

import { at, NONE } from '../../lib/base/diagram-data.ts'
import { hypotenuse } from '../../lib/base/scale.ts'
import type { Diagram } from '../../lib/index.ts'
import type { CellValues, Measure } from '../layers.ts'
import type { Legend } from '../protocol.ts'
import { MAP_COLORS, SHADES } from '../style.ts'
import { idOf } from './cell-boxes.ts'
import type { Clip } from './clip.ts'

/** Number of missing areas from which all areas inside a region are computed together. */
const MOST_ALONE = 32
/** Size of the sample that determines quantiles. */
const MOST_SAMPLES = 2000
/** Quantiles at the beginning, the quarters and the end of the color ramp. Outliers share the end colors. */
const SHARES = [0.05, 0.25, 0.5, 0.75, 0.95]
/** Numbers of neighbors with a color each. */
const DEGREES = [4, 5, 6, 7, 8]

/** The limits of cells: the region of a scene, and a distance from their circles. */
export interface CellLimits {
  readonly clip?: Clip | undefined
  readonly maxDistance?: number | undefined
}

/**
 * Maps a measure to shades. The ramp is linear between quantiles, so that all shades are used for any distribution.
 * Equal values have equal shades.
 */
export class Measures {
  readonly measure: Measure | 'column'
  /** The values of a client, if any. */
  readonly #column: CellValues | undefined
  readonly #diagram: Diagram
  readonly #limits: CellLimits
  /** Upper limit for the number of unknown areas inside a region. */
  #missing: number
  #knots: readonly number[] | undefined
  #isClipped = true
  /** Caches areas and gaps by circle id. */
  #known = new Float64Array()

  /** `limits` limit the measured part of a cell. `column` gives the values of the measure `column`. */
  constructor(measure: Measure | 'column', diagram: Diagram, limits: CellLimits = {}, column?: CellValues) {
    this.measure = measure
    this.#column = column
    this.#diagram = diagram
    this.#limits = limits
    this.#missing = limits.clip === undefined ? 0 : diagram.circles.length / 3
  }

  /** The meaning of the shades. It stays fixed while circles are edited. */
  get legend(): Legend {
    const { name, categories } = this.#column ?? {}
    const knots = categories === undefined ? this.#knotsNow : []
    return {
      ...{ measure: this.measure, knots, isClipped: this.#isClipped, name },
      ...(categories && { categories: categories.slice(0, MAP_COLORS), hasOthers: categories.length > MAP_COLORS }),
    }
  }

  /** A shade from 0 to `SHADES` - 1, or the color of a category. An infinite area has `NONE`. */
  shadeOf(i: number): number {
    const value = this.valueOf(i)
    if (Number.isNaN(value) || value === Number.POSITIVE_INFINITY) return NONE
    if (this.#column?.categories !== undefined) return value < MAP_COLORS ? value : NONE
    return Math.round(placeAmong(this.#knotsNow, this.valueOf(i)) * (SHADES - 1))
  }

  get #knotsNow(): readonly number[] {
    this.#knots ??= this.measure === 'degree' ? DEGREES : this.#quantiles()
    return this.#knots
  }

  /** The value of the circle with an index. */
  valueOf(i: number): number {
    const diagram = this.#diagram
    if (this.#column !== undefined) return this.#column.values[idOf(diagram, i)] ?? Number.NaN
    if (this.measure === 'index') return idOf(diagram, i)
    if (this.measure === 'radius') return at(diagram.circles, 3 * i + 2)
    if (this.measure === 'degree') return new Set(diagram.neighbors(i)).size
    const id = idOf(diagram, i)
    if (id >= this.#known.length) {
      const larger = new Float64Array(2 * id + 16).fill(Number.NaN)
      larger.set(this.#known)
      this.#known = larger
    }
    if (Number.isNaN(this.#known[id])) this.#find(i)
    const value = at(this.#known, id)
    if (this.measure !== 'filled') return value
    // An unbounded cell has no share.
    return value === Number.POSITIVE_INFINITY ? Number.NaN : (Math.PI * at(diagram.circles, 3 * i + 2) ** 2) / value
  }

  #find(i: number): void {
    const diagram = this.#diagram
    const id = idOf(diagram, i)
    const { clip, maxDistance } = this.#limits
    if (this.measure === 'gap') {
      this.#known[id] = gap(diagram, i)
    } else if (clip === undefined || this.#missing < MOST_ALONE) {
      this.#known[id] = cellArea(diagram, i, this.#limits)
    } else {
      this.#missing = 0
      diagram.cellAreas({ region: clip.region, maxDistance }).forEach((area, k) => {
        this.#known[idOf(diagram, k)] = area
      })
    }
  }

  /** Drops cached values of circles whose cells have changed, by id. */
  forget(ids: Iterable<number>): void {
    for (const id of ids) {
      this.#missing += 1
      if (id < this.#known.length) this.#known[id] = Number.NaN
    }
  }

  /** The sample takes one circle in each step. */
  get #step(): number {
    return Math.max(Math.ceil(this.#diagram.circles.length / 3 / MOST_SAMPLES), 1)
  }

  /** The quantiles over existing, bounded cells. */
  #quantiles(): number[] {
    const { circles, cells } = this.#diagram
    const step = this.#step
    const some = Array.from({ length: Math.ceil(circles.length / 3 / step) }, (_, k) => k * step)
    const values = Float64Array.from(some.filter((i) => cells.exists(i)).map((i) => this.valueOf(i))).filter(
      Number.isFinite,
    )
    values.sort()
    const knots = SHARES.map((share) => values[Math.round(share * (values.length - 1))] ?? 0)
    this.#isClipped = step > 1 || knots[0] !== values[0] || knots.at(-1) !== values.at(-1)
    return knots
  }
}

/**
 * The position of a value among ascending knots, from 0 to 1: linear between two knots, and in the middle of equal
 * knots.
 */
export function placeAmong(knots: readonly number[], value: number): number {
  const last = knots.length - 1
  const below = knots.filter((knot) => knot < value).length
  const upTo = knots.filter((knot) => knot <= value).length
  if (upTo > below) return (below + upTo - 1) / 2 / last
  if (below === 0) return 0
  if (below > last) return 1
  const [low, high] = [knots[below - 1] as number, knots[below] as number]
  return (below - 1 + (value - low) / (high - low)) / last
}

/** The area of a cell inside its limits: infinite if it is unbounded, 0 if it does not exist. */
export function cellArea(diagram: Diagram, i: number, { clip, maxDistance }: CellLimits = {}): number {
  return clip?.areaOf(diagram, i, maxDistance) ?? diagram.cellArea(i, { maxDistance })
}

/** The perimeter of a cell inside its limits: infinite if it is unbounded, 0 if it does not exist. */
export function cellPerimeter(diagram: Diagram, i: number, { clip, maxDistance }: CellLimits = {}): number {
  return clip?.perimeterOf(diagram, i, maxDistance) ?? diagram.cellPerimeter(i, { maxDistance })
}

/** The distance to the nearest other circle, which is a neighbor; negative if they overlap. */
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
