// SPDX-License-Identifier: GPL-3.0-or-later

import { circleAt } from '../../lib/base/diagram-data.ts'
import type { Diagram } from '../../lib/index.ts'
import type { DiagramCounts } from '../diagram-counts.ts'
import type { CellFacts, Facts } from '../protocol.ts'
import { cellArea } from './measures.ts'
import type { Picture } from './picture.ts'

/** Counts of a diagram, and descriptions of some cells by circle id. */
export function factsOf(
  picture: Pick<Picture, 'diagram' | 'clip'>,
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

function cellFacts({ diagram, clip }: Pick<Picture, 'diagram' | 'clip'>, i: number): CellFacts {
  const { circles, numbers } = diagram
  const around = diagram.neighbors(i)
  return {
    ...circleAt(circles, i),
    hidden: !diagram.cells.exists(i),
    bounded: diagram.cells.isBounded(i),
    edges: around.length,
    neighbors: [...new Set(Array.from(around, (k) => numbers?.circles[k] ?? k))],
    area: clip?.areaOf(diagram, i) ?? cellArea(diagram, i),
    perimeter: clip?.perimeterOf(diagram, i) ?? perimeterOf(diagram, i),
  }
}

function perimeterOf(diagram: Diagram, i: number): number {
  return diagram.cells.isBounded(i) ? diagram.cellPerimeter(i) : Number.POSITIVE_INFINITY
}
