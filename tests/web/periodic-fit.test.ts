import { describe, expect, it } from 'vitest'
import { type Lattice, PeriodicDiagram } from '../../web/lib/index.ts'
import { loadRegions, type PeriodicFitOptions } from '../../web/lib/regions.ts'
import { problemOf } from './errors.ts'
import { library, seededRandom } from './library.ts'

const { fitAreas } = await loadRegions()
const BOX: Lattice = { a: [4, 0], b: [1, 3] }

function sitesInBox(count: number): [number, number][] {
  const random = seededRandom(count)
  return Array.from({ length: count }, () => {
    const [u, v] = [random(), random()]
    return [4 * u + v, 3 * v]
  })
}

const sum = (values: Iterable<number>) => Array.from(values).reduce((total, value) => total + value, 0)

describe('areas in a box', () => {
  for (const count of [1, 2, 3, 50]) {
    it(`are those of the periodic diagram of ${count} sites`, () => {
      const sites = sitesInBox(count)
      const shares = sites.map((_, i) => 1 + (i % 5))
      const errors: number[] = []
      const fit = fitAreas(sites, shares, { lattice: BOX, shares: true, onStep: ({ error }) => errors.push(error) })
      expect(fit.periodic).toBeInstanceOf(PeriodicDiagram)
      expect(fit.periodic.circleCount).toBe(count)
      expect(fit.periodic.diagram.certificate.certified).toBe(true)
      expect(Math.min(...fit.weights)).toBe(0)
      expect(errors).toHaveLength(fit.steps + 1)
      const circles = sites.map(([x, y], i) => [x, y, fit.weights[i] as number] as const)
      const judge = library.computePeriodic(circles, BOX)
      const areas = circles.map((_, i) => judge.cellArea(i))
      expect(sum(areas)).toBeCloseTo(12, 11)
      areas.forEach((area, i) => {
        const target = (12 * (shares[i] as number)) / sum(shares)
        expect(Math.abs(area - target)).toBeLessThan(2e-9 * target)
        expect(Math.abs((fit.areas[i] as number) - area)).toBeLessThan(1e-10)
      })
      const again = fitAreas(sites, shares, { lattice: BOX, shares: true, weights: fit.weights })
      expect([again.steps, [...again.weights]]).toEqual([0, [...fit.weights]])
    })
  }

  it('say what is wrong', () => {
    const problem = (
      options: object,
      sites: [number, number][] = [
        [0, 0],
        [1, 1],
      ],
      areas = [6, 6],
    ) => {
      return problemOf(() => fitAreas(sites, areas, options as PeriodicFitOptions))
    }
    expect(problem({ lattice: BOX })).toBe('no problem')
    expect(problem({ lattice: { a: [1, 0], b: [2, 0] } })).toMatch(/^badOption: The periods must not be zero or par/)
    expect(problem({ lattice: { a: [1, 0], b: [Infinity, 0] } })).toMatch(/^badOption: The periods must be finite/)
    expect(
      problem({ lattice: BOX }, [
        [0, 0],
        [5, 3],
      ]),
    ).toMatch(/^badInput: Site 1 .* as an image of site 0\.$/)
    expect(problem({ lattice: BOX }, undefined, [6, 7])).toMatch(
      /^badInput: The areas sum to 13, .* of the box is 12\./,
    )
    expect(problem({ lattice: BOX, maxSteps: 1 }, undefined, [1, 11])).toMatch(/^notConverged: /)
  })
})
