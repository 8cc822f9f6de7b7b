// SPDX-License-Identifier: GPL-3.0-or-later
import { circleAt, type Diagram } from '../../lib/index.ts'
import type { CellFacts, Counts, Facts } from '../protocol.ts'

/** What is so of a diagram and of the cells of circles, by their ids. */
export function factsOf(diagram: Diagram, counts: Counts, ids: readonly number[]): Facts {
  const cells = new Map<number, CellFacts>()
  for (const id of ids) {
    const i = diagram.indexOf(id)
    if (i >= 0) cells.set(id, cellFacts(diagram, i))
  }
  return { ...counts, cells }
}

function cellFacts(diagram: Diagram, i: number): CellFacts {
  const { circles, numbers } = diagram
  const around = diagram.neighbors(i)
  return {
    ...circleAt(circles, i),
    hidden: !diagram.cells.exists(i),
    bounded: diagram.cells.isBounded(i),
    edges: around.length,
    neighbors: [...new Set(around)].map((k) => numbers?.circles[k] ?? k),
    area: diagram.cellArea(i),
    perimeter: diagram.cells.isBounded(i) ? diagram.cellPerimeter(i) : Number.POSITIVE_INFINITY,
  }
}
