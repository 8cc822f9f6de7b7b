// SPDX-License-Identifier: GPL-3.0-or-later
// Clipped cells are checked: a changed array causes an error instead of a wrong result.
import { describe, expect, it } from 'vitest'
import { Diagram } from '../../web/lib/index.ts'
import { problemOf } from './errors.ts'
import { library } from './library.ts'
import { tuple } from './tuples.ts'

const bounds = [0.5, 0.5, 3.5, 3.25] as const
/** The circle in the middle. */
const MIDDLE = 12

function grid(): Diagram {
  const circles = Array.from({ length: 25 }, (_, k) => [Math.floor(k / 5), k % 5, 0.1 * ((Math.floor(k / 5) + k) % 3)])
  return new Diagram(structuredClone(library.compute(circles as [number, number, number][])))
}

/** Moves the vertex at the start of the middle circle's first side. The arrays stay consistent. */
function moveVertex({ cells, firstSide, vertices }: Diagram, dx: number, dy: number): void {
  const vertex = cells.originOf(firstSide[MIDDLE] as number)
  const [x, y] = tuple(vertices, 3 * vertex, 2)
  vertices.set([x + dx, y + dy], 3 * vertex)
}

/** Changes a neighbor of the middle circle that comes after it. */
function setNeighbor({ cells, edges }: Diagram, circle: number): void {
  const side = cells.sides(MIDDLE).find((side) => cells.neighborOf(side) > MIDDLE) as number
  edges.set([circle], 4 * (side >> 1) + 1 - (side & 1))
}

it('a cell stays bounded however far away its vertices are', () => {
  const diagram = grid()
  moveVertex(diagram, 1.7e308, 1.7e308)
  expect(diagram.cells.isBounded(MIDDLE)).toBe(true)
})

describe('cells in bounds', () => {
  it('are accepted where they are right', () => {
    const areas = grid().cellAreas({ bounds })
    expect(areas.reduce((sum, area) => sum + area)).toBeCloseTo(8.25, 12)
    expect(grid().cellAreas({ bounds, maxDistance: 0.2 })).toHaveLength(25)
  })

  const doNotFit = /^badInput: The arrays of the diagram do not fit together at circle 12\./

  it.each<[string, (diagram: Diagram) => void]>([
    ['a cell begins at a side of another', ({ firstSide }) => firstSide.set([firstSide[MIDDLE + 1] as number], MIDDLE)],
    ['a side has a neighbor too many', (diagram) => setNeighbor(diagram, 25)],
    ['a cell begins across its side', ({ firstSide }) => firstSide.set([(firstSide[MIDDLE] as number) ^ 1], MIDDLE)],
  ])('are refused where %s', (_, corrupt) => {
    const diagram = grid()
    corrupt(diagram)
    expect(problemOf(() => diagram.cellAreas({ bounds }))).toMatch(doNotFit)
    expect(problemOf(() => diagram.cellArea(MIDDLE, { bounds }))).toMatch(doNotFit)
  })

  // The remaining sides lead around their cells, so that only the enclosed area is wrong.
  it.each<[string, RegExp, (diagram: Diagram) => void]>([
    [
      'a cell has no sides',
      /^notCertified: The areas of the cells sum to 7\.07/,
      ({ firstSide }) => firstSide.set([-1], MIDDLE),
    ],
    [
      'two circles trade places',
      /^notCertified: The outline of cell 0 does not close/,
      ({ circles }) => {
        const first = circles.slice(0, 3)
        circles.copyWithin(0, 3 * MIDDLE, 3 * MIDDLE + 3)
        circles.set(first, 3 * MIDDLE)
      },
    ],
    [
      'a vertex lies beyond its cell',
      /^notCertified: The area of cell 12, -0\.\d+, is not between 0/,
      (d) => moveVertex(d, 2, 0),
    ],
    [
      'a vertex lies beyond other cells',
      /^notCertified: The outline of cell 11 does not close/,
      (d) => moveVertex(d, 0, 2),
    ],
  ])('are refused where %s', (_, problem, corrupt) => {
    const diagram = grid()
    corrupt(diagram)
    expect(problemOf(() => diagram.cellAreas({ bounds }))).toMatch(problem)
  })
})
