// SPDX-License-Identifier: GPL-3.0-or-later

import { checkIndex, checkNoOptions, checkNumber, checkThing, refuseInput } from '../base/check.ts'
import { at } from '../base/diagram-data.ts'
import { hypotenuse } from '../base/scale.ts'
import type { Box, DiagramData, Int32s, Point } from '../base/types.ts'
import { edgeCurve, isBoundedCurve } from '../curves/curve.ts'
import {
  type ContextOptions,
  checkDrawOptions,
  DRAW_OPTIONS,
  POLYGON_OPTIONS,
  type PolygonOptions,
  type TextOptions,
} from '../drawing/draw-options.ts'
import type { Polygon } from '../drawing/polygon.ts'
import { exportBox } from '../regions/export-box.ts'
import { curveLength } from '../regions/measure.ts'
import { Diagram } from './diagram.ts'
import { type Lattice, type Periods, type Shift, shortestPeriods } from './lattice.ts'

/**
 * A copy of a given circle: the circle moved by shift[0] times period a plus shift[1] times period b.
 *
 * @category Periodic diagrams
 */
export interface CircleImage {
  readonly circle: number
  readonly shift: Shift
}

/**
 * The data of a periodic diagram, without its methods, as in a structured clone.
 *
 * @category Periodic diagrams
 */
export interface PeriodicData {
  /** The diagram of the given circles, which come first, and of all images that determine their cells. */
  readonly diagram: DiagramData
  /** The number of given circles. */
  readonly circleCount: number
  /** The periods, rounded to multiples of 2^-50 of the largest coordinate. */
  readonly lattice: Lattice
  /** For each circle of `diagram`, the given circle whose image it is. */
  readonly circleOf: Int32s
  /**
   * Two numbers for each circle of `diagram`: its shift from the given circle. The shift of a given circle is 0, unless
   * the given circles were so far apart that they had to be moved by whole periods.
   */
  readonly shiftOf: Int32s
}

/**
 * The neighbors of all circles, and the measures of a packing. Item k of `lengths` and `gaps` belongs to contact k.
 *
 * @category Periodic diagrams
 */
export interface ContactTable {
  /** Four numbers for each contact: a circle, its neighbor, and the two shifts of the neighbor. */
  readonly contacts: Int32Array
  /** The length of the common border. */
  readonly lengths: Float64Array
  /**
   * The gap between the two circles; negative if they overlap. Where a power diagram has weights, the radius is the root
   * of the weight, with its sign.
   */
  readonly gaps: Float64Array
  /** The area of the cell of each circle; 0 if it is hidden. */
  readonly areas: Float64Array
  /**
   * The share of its cell that each circle covers, from 0 to 1. Of a circle that overlaps another it is NaN, unless the
   * metric is `circles`.
   */
  readonly packingFractions: Float64Array
}

/**
 * The Voronoi diagram of circles that repeat with two periods, made by `library.computePeriodic`. The methods take the
 * given circles, from 0 to `circleCount` - 1, whose cells are complete. Use `diagram`, the diagram of the given circles
 * and the images around them, for everything else.
 *
 * @category Periodic diagrams
 * @example
 * const periodic = library.computePeriodic([[1, 1, 1], [5, 4, 2]], { a: [8, 0], b: [0, 6] })
 * Math.round(periodic.cellArea(0) + periodic.cellArea(1)) // 48
 * periodic.find(-3, 4) // { circle: 1, shift: [ -1, 0 ] }
 */
export class PeriodicDiagram implements PeriodicData {
  readonly diagram: Diagram
  readonly circleCount: number
  readonly lattice: Lattice
  readonly circleOf: Int32s
  readonly shiftOf: Int32s
  readonly #bounds: readonly [number, number, number, number]
  #periods: Periods | undefined

  /** Wraps the arrays of `data` without copying them. */
  constructor(data: PeriodicData) {
    checkThing(data, 'circleOf', 'new PeriodicDiagram', 'the data of a periodic diagram')
    this.diagram = new Diagram(data.diagram)
    this.circleCount = data.circleCount
    this.lattice = data.lattice
    this.circleOf = data.circleOf
    this.shiftOf = data.shiftOf
    this.#bounds = wholeCells(this.diagram, this.lattice)
  }

  /**
   * Returns circle `other` of `diagram` as circle `i` of `diagram` sees it: the given circle, and its shift relative to
   * circle `i`.
   */
  imageFrom(i: number, other: number): CircleImage {
    for (const circle of [i, other]) checkIndex(circle, this.circleOf.length, 'imageFrom', 'circle')
    return this.#imageFrom(i, other)
  }

  /**
   * Returns the images across the sides of cell `i`, counter-clockwise. Their shifts are relative to circle `i`. A
   * circle may be its own neighbor. An image appears once for each shared edge.
   */
  neighbors(i: number): CircleImage[]
  neighbors(i: number, ...others: readonly unknown[]): CircleImage[] {
    checkNoOptions(others, 'neighbors')
    this.#checkCircle(i, 'neighbors')
    return Array.from(this.diagram.cells.neighbors(i), (other) => this.#imageFrom(i, other))
  }

  /**
   * Returns the image nearest to any point of the plane, or `undefined` if there are no circles or a coordinate is not
   * finite.
   *
   * @throws CircleVoronoiError `badInput`, if the shift is 2^30 periods or more
   */
  find(x: number, y: number): CircleImage | undefined
  find(x: number, y: number, ...others: readonly unknown[]): CircleImage | undefined {
    checkNoOptions(others, 'find')
    checkNumber(x, 'find', 'x')
    checkNumber(y, 'find', 'y')
    const { circles } = this.diagram
    if (this.circleCount === 0 || !Number.isFinite(x) || !Number.isFinite(y)) return undefined
    this.#periods ??= shortestPeriods(this.lattice)
    // The nearest circle of a point may be an image. Shifted back by the shift of the image, the point lies near the
    // given circle and no farther from its nearest circle. So the loop ends at a given circle, whose cell is correct.
    const { steps, shift } = this.#periods.nearest(x - at(circles, 0), y - at(circles, 1))
    let p: Point = { x: x - steps.x, y: y - steps.y }
    let [k, l] = shift
    checkShift(k, l)
    let found = this.diagram.find(p.x, p.y)
    // Rounding may lead to an endless loop among images that are equally near.
    for (let tries = 0; tries < 100 && found >= this.circleCount; tries++) {
      const given = at(this.circleOf, found)
      p = {
        x: p.x + (at(circles, 3 * given) - at(circles, 3 * found)),
        y: p.y + (at(circles, 3 * given + 1) - at(circles, 3 * found + 1)),
      }
      const image = this.#imageFrom(given, found)
      k += image.shift[0]
      l += image.shift[1]
      found = this.diagram.find(p.x, p.y, given)
    }
    k += at(this.shiftOf, 2 * found)
    l += at(this.shiftOf, 2 * found + 1)
    checkShift(k, l)
    return { circle: at(this.circleOf, found), shift: [k, l] }
  }

  /** Returns whether (x, y) lies in the cell of circle `i` of `diagram`, up to rounding. */
  contains(i: number, x: number, y: number): boolean
  contains(i: number, x: number, y: number, ...others: readonly unknown[]): boolean {
    checkNoOptions(others, 'contains')
    this.#checkCircle(i, 'contains')
    return this.diagram.contains(i, x, y)
  }

  /** Draws the outline of cell `i`. */
  cellPath(i: number, options?: PolygonOptions & TextOptions): string
  cellPath(i: number, options: PolygonOptions & ContextOptions): void
  cellPath(i: number, options: PolygonOptions & (TextOptions | ContextOptions) = {}): string | undefined {
    this.#checkCircle(i, 'cellPath')
    checkDrawOptions(options, 'cellPath', DRAW_OPTIONS)
    return this.diagram.cellPath(i, this.#whole(options) as PolygonOptions & TextOptions)
  }

  /** Returns the polygon of cell `i`, or `undefined` if circle `i` is hidden. */
  cellPolygon(i: number, options: PolygonOptions & { readonly region?: undefined } = {}): Polygon | undefined {
    this.#checkCircle(i, 'cellPolygon')
    checkDrawOptions(options, 'cellPolygon', POLYGON_OPTIONS)
    return this.diagram.cellPolygon(i, this.#whole(options))
  }

  /** Returns the area of cell `i`. The areas of all cells sum to the area of the box. */
  cellArea(i: number): number
  cellArea(i: number, ...others: readonly unknown[]): number {
    checkNoOptions(others, 'cellArea')
    this.#checkCircle(i, 'cellArea')
    return this.diagram.cellArea(i, { bounds: this.#bounds })
  }

  /** Returns the center of mass of cell `i`, or `undefined` if circle `i` is hidden. */
  cellCentroid(i: number): Point | undefined
  cellCentroid(i: number, ...others: readonly unknown[]): Point | undefined {
    checkNoOptions(others, 'cellCentroid')
    this.#checkCircle(i, 'cellCentroid')
    return this.diagram.cellCentroid(i, { bounds: this.#bounds })
  }

  /** Returns the length of the border of cell `i`. */
  cellPerimeter(i: number): number
  cellPerimeter(i: number, ...others: readonly unknown[]): number {
    checkNoOptions(others, 'cellPerimeter')
    this.#checkCircle(i, 'cellPerimeter')
    return this.diagram.cellPerimeter(i, { bounds: this.#bounds })
  }

  /** Measures all borders and cells, in linear time. Each pair of neighbors occurs twice, once from each side. */
  contacts(): ContactTable
  contacts(...others: readonly unknown[]): ContactTable {
    checkNoOptions(others, 'contacts')
    const { diagram, circleCount } = this
    const { cells } = diagram
    const contacts: number[] = []
    const lengths: number[] = []
    const gaps: number[] = []
    const areas = new Float64Array(circleCount)
    const packingFractions = new Float64Array(circleCount)
    for (let i = 0; i < circleCount; i++) {
      const r = cells.signedRadiusOf(i)
      const met = new Map<string, number>()
      let least = Infinity
      for (const side of cells.sides(i)) {
        const curve = edgeCurve(diagram, side >> 1)
        const length = isBoundedCurve(curve) ? curveLength(curve) : Infinity
        const other = cells.neighborOf(side)
        const { circle, shift } = this.#imageFrom(i, other)
        const key = `${circle},${shift}`
        const before = met.get(key)
        if (before !== undefined) {
          lengths[before] = (lengths[before] as number) + length
          continue
        }
        met.set(key, lengths.length)
        contacts.push(i, circle, ...shift)
        lengths.push(length)
        const gap = this.#distance(i, other) - r - cells.signedRadiusOf(other)
        gaps.push(gap)
        least = Math.min(least, gap)
      }
      if (met.size === 0) continue
      const area = this.cellArea(i)
      areas[i] = area
      if (!(r > 0)) continue
      let covered = Math.PI * r * r
      if (least < 0) {
        const isKnown = diagram.metric === 'circles'
        covered = isKnown ? diagram.cellArea(i, { bounds: this.#bounds, maxDistance: 0 }) : Number.NaN
      }
      packingFractions[i] = area > 0 ? Math.min(covered / area, 1) : 1
    }
    return {
      contacts: Int32Array.from(contacts),
      lengths: Float64Array.from(lengths),
      gaps: Float64Array.from(gaps),
      areas,
      packingFractions,
    }
  }

  /**
   * Returns the table of `contacts` as CSV, with the columns circle, neighbor, shift_a, shift_b, length, gap, area and
   * packing_fraction. The last two columns describe the circle. Hidden circles have no line.
   */
  contactsCsv(): string {
    const { contacts, lengths, gaps, areas, packingFractions } = this.contacts()
    const lines = Array.from(lengths, (length, k) => {
      const [i, ...neighbor] = contacts.subarray(4 * k, 4 * k + 4) as unknown as [number, ...number[]]
      const fraction = at(packingFractions, i)
      return [i, ...neighbor, length, at(gaps, k), at(areas, i), Number.isNaN(fraction) ? '' : fraction].join(',')
    })
    return `${['circle,neighbor,shift_a,shift_b,length,gap,area,packing_fraction', ...lines].join('\n')}\n`
  }

  #distance(i: number, j: number): number {
    const { circles } = this.diagram
    return hypotenuse(at(circles, 3 * j) - at(circles, 3 * i), at(circles, 3 * j + 1) - at(circles, 3 * i + 1))
  }

  #imageFrom(i: number, other: number): CircleImage {
    const { circleOf, shiftOf } = this
    const shift = (period: number) => at(shiftOf, 2 * other + period) - at(shiftOf, 2 * i + period)
    return { circle: at(circleOf, other), shift: [shift(0), shift(1)] }
  }

  #whole<Options extends PolygonOptions>(options: Options): Options {
    const { a, b } = this.lattice
    const tolerance = TOLERANCE * Math.max(...[...a, ...b].map(Math.abs))
    return { ...(options.region === undefined && { bounds: this.#bounds }), tolerance, ...options }
  }

  #checkCircle(i: number, caller: string): void {
    checkIndex(i, this.circleCount, caller, 'circle')
  }
}

/** The default tolerance of curves, as a share of the largest coordinate of the periods. */
const TOLERANCE = 1e-5

/** Returns a box that cuts no given cell: a cell extends from its center by less than the sum of the periods. */
function wholeCells(diagram: Diagram, { a, b }: Lattice): [number, number, number, number] {
  const { minX, minY, maxX, maxY }: Box = exportBox(diagram.circles)
  const margin = Math.abs(a[0]) + Math.abs(a[1]) + Math.abs(b[0]) + Math.abs(b[1])
  return [minX - margin, minY - margin, maxX + margin, maxY + margin]
}

/** @throws CircleVoronoiError `badInput`, if a shift is 2^30 periods or more */
function checkShift(k: number, l: number): void {
  if (!(Math.abs(k) < 2 ** 30 && Math.abs(l) < 2 ** 30)) refuseInput('The point is 2^30 periods away or more.')
}
