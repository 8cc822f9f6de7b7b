// SPDX-License-Identifier: GPL-3.0-or-later
// Clips a few cells of a large diagram with a small diagram. The diagram of some circles and their neighbors has the
// same cells for these circles, so clipping them to a region needs no other circles.
import { at } from '../base/diagram-data.ts'
import type { DiagramData, Float64s, Int32s } from '../base/types.ts'
import { Cells } from './cells.ts'

/**
 * Some circles and their neighbors, in the order of the large diagram, because the order decides how bisectors are
 * computed.
 */
export interface FewCircles {
  readonly indices: Int32s
  /** x, y and r of each circle. */
  readonly circles: Float64s
  /** The places of the chosen circles in `circles`. */
  readonly chosen: Int32s
}

/** The arrays of a diagram that describe the sides of cells. */
export type Sides = Pick<DiagramData, 'edges' | 'nextSide' | 'firstSide'>

/** Collects some circles and their neighbors. */
export function fewCircles(diagram: DiagramData, circlesOfCells: readonly number[]): FewCircles {
  const cells = new Cells(diagram)
  const indices = Int32Array.from(new Set(circlesOfCells.flatMap((i) => [i, ...cells.neighbors(i)]))).sort()
  const circles = new Float64Array(3 * indices.length)
  indices.forEach((index, k) => {
    circles.set(diagram.circles.subarray(3 * index, 3 * index + 3), 3 * k)
  })
  const placeOf = new Map(Array.from(indices, (index, place) => [index, place]))
  return { indices, circles, chosen: Int32Array.from(circlesOfCells, (i) => placeOf.get(i) as number) }
}

/**
 * Maps each side of the first chosen cell from the small diagram to the large one, or returns `undefined` if the sides
 * differ. No input is known for which they differ, because ties are broken by the places of the circles, which both
 * diagrams share. The cell must have sides.
 */
export function sidesOfFew(diagram: DiagramData, few: FewCircles, small: Sides): Map<number, number> | undefined {
  const { indices } = few
  const chosen = at(few.chosen, 0)
  const cells = new Cells(diagram)
  const ours = cells.sides(at(indices, chosen))
  const theirs = sidesFrom(small, chosen)
  if (theirs.length !== ours.length) return undefined
  const neighborOf = (side: number) => at(indices, at(small.edges, 4 * (side >> 1) + (1 - (side & 1))))
  // The neighbors of a cell cannot alternate (a, b, a, b), because its borders with two circles cross at most twice. So
  // at most one shift fits.
  const shift = theirs.findIndex((_, start) =>
    ours.every((side, k) => cells.neighborOf(side) === neighborOf(theirs[(start + k) % theirs.length] as number)),
  )
  if (shift === -1) return undefined
  return new Map(Array.from(ours, (side, k) => [theirs[(shift + k) % theirs.length] as number, side]))
}

function sidesFrom({ firstSide, nextSide }: Sides, circle: number): number[] {
  const first = at(firstSide, circle)
  const sides = [first]
  for (let side = at(nextSide, first); side !== first; side = at(nextSide, side)) sides.push(side)
  return sides
}
