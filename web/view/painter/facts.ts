// SPDX-License-Identifier: GPL-3.0-or-later

import { circleAt } from '../../lib/base/diagram-data.ts'
import type { DiagramCounts } from '../diagram-counts.ts'
import type { CellFacts, Facts } from '../protocol.ts'
import { cellArea, cellPerimeter } from './measures.ts'
import type { Picture } from './picture.ts'

/** Counts of a diagram, and descriptions of some cells by circle id. */
export function factsOf(
  picture: Pick<Picture, 'diagram' | 'limits'>,
  counts: DiagramCounts,
  ids: readonly number[],
): Facts {
  const cells = new Map<number, CellFacts>()
  for (const id of ids) {
    const i = picture.diagram.indexOf(id)
    if (i >= 0) cells.set(id, cellFacts(picture, i))
  }
  return { ...counts, cells }
}

function cellFacts({ diagram, limits }: Pick<Picture, 'diagram' | 'limits'>, i: number): CellFacts {
  const { circles, numbers } = diagram
  const around = diagram.neighbors(i)
  return {
    ...circleAt(circles, i),
    hidden: !diagram.cells.exists(i),
    bounded: diagram.cells.isBounded(i),
    edges: around.length,
    neighbors: [...new Set(Array.from(around, (k) => numbers?.circles[k] ?? k))],
    area: cellArea(diagram, i, limits),
    perimeter: cellPerimeter(diagram, i, limits),
  }
}
