// SPDX-License-Identifier: GPL-3.0-or-later
// Cells in bounds are checked: what a changed array makes of them is an error and no result.
import { describe, expect, it } from 'vitest'
import { CircleVoronoiError, Diagram } from '../../web/lib/index.ts'
import { library } from './library.ts'

const bounds = [0.5, 0.5, 3.5, 3.25] as const
/** The circle in the middle. */
const MIDDLE = 12

function grid(): Diagram {
  const circles = Array.from({ length: 25 }, (_, k) => [Math.floor(k / 5), k % 5, 0.1 * ((Math.floor(k / 5) + k) % 3)])
  return new Diagram(structuredClone(library.compute(circles as [number, number, number][])))
}

function codeOf(act: () => unknown): string | undefined {
  try {
    act()
  } catch (error) {
    return error instanceof CircleVoronoiError ? error.code : String(error)
  }
  return undefined
}

describe('cells in bounds', () => {
  it('are accepted where they are right', () => {
    const areas = grid().cellAreas({ bounds })
    expect(areas.reduce((sum, area) => sum + area)).toBeCloseTo(8.25, 12)
    expect(grid().cellAreas({ bounds, maxDistance: 0.2 })).toHaveLength(25)
  })

  it.each<[string, (diagram: Diagram) => void]>([
    ['a cell begins at a side of another', ({ firstSide }) => firstSide.set([firstSide[MIDDLE + 1] as number], MIDDLE)],
    ['a cell begins across its side', ({ firstSide }) => firstSide.set([(firstSide[MIDDLE] as number) ^ 1], MIDDLE)],
    ['a cell has no sides', ({ firstSide }) => firstSide.set([-1], MIDDLE)],
  ])('are refused where %s', (_, corrupt) => {
    const diagram = grid()
    corrupt(diagram)
    expect(codeOf(() => diagram.cellAreas({ bounds }))).toBe('notCertified')
  })
})
