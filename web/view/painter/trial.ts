// SPDX-License-Identifier: GPL-3.0-or-later
import { at, NONE } from '../../lib/base/diagram-data.ts'
import type { Box, Circle, Diagram } from '../../lib/index.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import type { Trial } from '../protocol.ts'
import { boxAt, emptyBoxes } from './boxes.ts'
import { addCell, idOf } from './cell-boxes.ts'
import { cellArea } from './measures.ts'
import type { Picture } from './picture.ts'

/** A diagram of a new circle and its surroundings, in which the cells of interest equal those among all circles. */
interface Local {
  readonly diagram: Diagram
  /** The index of the new circle. */
  readonly tried: number
  /** Maps the other circles to indices of the picture. */
  readonly indices: readonly number[]
}

/** Computes the area that a new circle would take from each cell, without changing the diagram. */
export function trialOf(
  library: CircleVoronoi,
  picture: Picture,
  circle: Circle,
  nearest: number,
  outlineOf: (diagram: Diagram, i: number) => Float64Array,
): Trial {
  const local = localDiagram(library, picture.diagram, circle, nearest)
  const { diagram, tried, indices } = local
  const idOfLocal = (k: number) => idOf(picture.diagram, indices[k] as number)
  if (!diagram.cells.exists(tried)) {
    const { hidden } = diagram
    let by = 0
    for (let h = 0; h < hidden.length; h += 2) if (at(hidden, h) === tried) by = at(hidden, h + 1)
    return { circle, hiddenBy: idOfLocal(by), outline: new Float64Array(), area: 0, taken: [] }
  }
  const taken = affectedCircles(local).map((k) => ({
    id: idOfLocal(k),
    x: at(diagram.circles, 3 * k),
    y: at(diagram.circles, 3 * k + 1),
    area: takenFrom(picture, local, k),
  }))
  taken.sort((one, other) => other.area - one.area || one.id - other.id)
  return {
    circle,
    hiddenBy: undefined,
    outline: outlineOf(diagram, tried),
    area: cellArea(diagram, tried, picture.limits),
    taken,
  }
}

/**
 * Builds the local diagram. Only circles near the new one affect its cell. If every circle that loses area has all of
 * its neighbors in the local diagram, its former cell was the same as among all circles, because a cell depends on its
 * neighbors alone. So the area lost here equals the area lost among all circles, and the new cell is the same, too.
 */
function localDiagram(library: CircleVoronoi, whole: Diagram, { x, y, r }: Circle, nearest: number): Local {
  const indices: number[] = []
  const known = new Set<number>()
  const take = (i: number) => {
    if (known.has(i)) return
    known.add(i)
    indices.push(i)
  }
  if (nearest !== NONE) for (const i of [nearest, ...whole.neighbors(nearest)]) take(i)
  for (;;) {
    const count = indices.length
    const circles = new Float64Array(3 * count + 3)
    indices.forEach((i, k) => {
      circles.set(whole.circles.subarray(3 * i, 3 * i + 3), 3 * k)
    })
    circles.set([x, y, r], 3 * count)
    const local = { diagram: library.compute(circles), tried: count, indices: indices.slice() }
    for (const k of affectedCircles(local)) for (const i of whole.neighbors(indices[k] as number)) take(i)
    if (indices.length === count) return local
  }
}

/** The circles that lose area: the neighbors of the new circle, and the circles that it hides. */
function affectedCircles({ diagram, tried }: Local): number[] {
  const { hidden } = diagram
  const ks = new Set<number>(diagram.cells.exists(tried) ? diagram.neighbors(tried) : [])
  for (let h = 0; h < hidden.length; h += 2) if (at(hidden, h + 1) === tried) ks.add(at(hidden, h))
  return [...ks]
}

/** Infinite for an unbounded part; NaN if unknown. */
function takenFrom(picture: Picture, { diagram, tried, indices }: Local, k: number): number {
  const i = indices[k] as number
  const before = picture.areaOf(i)
  const after = cellArea(diagram, k, picture.limits)
  if (before < Number.POSITIVE_INFINITY) return before - after
  if (after < Number.POSITIVE_INFINITY) return Number.POSITIVE_INFINITY
  if (!diagram.cells.isBounded(tried)) return Number.NaN
  // The new circle takes area only inside its own cell.
  const bounds = boxOf(diagram, tried, picture.reach)
  return picture.diagram.cellArea(i, { bounds }) - diagram.cellArea(k, { bounds })
}

function boxOf(diagram: Diagram, i: number, reach: number): Box {
  const boxes = emptyBoxes(1)
  addCell(boxes, 0, diagram, i, reach)
  return boxAt(boxes, 0)
}
