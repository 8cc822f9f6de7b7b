// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a large diagram in a small one: some circles and their neighbors have a diagram of their own, in which the
// cells of
// these circles are the same. To clip them to a region, nothing else of the large diagram is needed.
import { at } from '../base/diagram-data.ts'
import type { DiagramData, Float64s, Int32s } from '../base/types.ts'
import { Cells } from './cells.ts'

/** Some circles and their neighbors, in the order of the large diagram, which decides how bisectors are computed. */
export interface FewCircles {
  readonly indices: Int32s
  /** x, y and r of each. */
  readonly circles: Float64s
  /** The indices of these circles among all circles. */
  readonly chosen: Int32s
}

/** The parts of a diagram that tell the sides of cells. */
export type Sides = Pick<DiagramData, 'edges' | 'nextSide' | 'firstSide'>

/** Finds the neighbors of some circles. */
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
 * Returns the side of the large diagram for each side of the first cell in the small one, or `undefined` if the cell
 * has other
 * sides there. No input is known for which it has: where more than three circles touch one disc, their places decide
 * which are
 * neighbors, in any diagram of them. The cell has sides.
 */
export function sidesOfFew(diagram: DiagramData, few: FewCircles, small: Sides): Map<number, number> | undefined {
  const { indices } = few
  const chosen = at(few.chosen, 0)
  const cells = new Cells(diagram)
  const ours = cells.sides(at(indices, chosen))
  const theirs = sidesFrom(small, chosen)
  if (theirs.length !== ours.length) return undefined
  const neighborOf = (side: number) => at(indices, at(small.edges, 4 * (side >> 1) + (1 - (side & 1))))
  // Neighbors do not alternate (a, b, a, b), as the borders against two of them cross at most twice. So there is one
  // way.
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
