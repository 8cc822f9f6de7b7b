import { describe, expect, it } from 'vitest'
import { largestEmptyDiscInside } from '../../web/lib/index.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { library, seededRandom } from './library.ts'
import { ring } from './shapes.ts'

const { region } = await loadRegions()
const ROOM = ring(0, 0, 6, 0, 6, 2, 2, 2, 2, 6, 0, 6)
const square = (half: number): [number, number][] => [
  [-half, -half],
  [half, -half],
  [half, half],
  [-half, half],
]

describe('the largest empty disc inside a region', () => {
  it('touches two walls and the corner of a room without circles', () => {
    const found = largestEmptyDiscInside(library.compute([]), { region: region([ROOM]) })
    const r = (2 * Math.SQRT2) / (1 + Math.SQRT2)
    expect(found?.circles).toEqual([])
    for (const value of Object.values(found?.disc ?? {})) expect(value).toBeCloseTo(r, 14)
  })

  it('keeps away from circles and islands', () => {
    const ring = region([square(4), square(1)])
    const circles = Float64Array.of(-2.5, -2.5, 0, 2.5, -2.5, 0, -2.5, 2.5, 0)
    const found = largestEmptyDiscInside(library.compute(circles), { region: ring })
    expect(found?.disc.r).toBeCloseTo((3 * Math.SQRT2) / (1 + Math.SQRT2), 13)
    expect(found?.disc.x).toBeGreaterThan(0)
    expect(found?.disc.y).toBeGreaterThan(0)
  })

  it('is that of bounds for a box', () => {
    const random = seededRandom(4)
    for (let trial = 0; trial < 20; trial++) {
      const circles = Array.from({ length: trial % 7 }, () => [8 * random() - 4, 8 * random() - 4, random()])
      const diagram = library.compute(circles as [number, number, number][])
      const one = largestEmptyDiscInside(diagram, { bounds: [-4, -4, 4, 4] })
      const other = largestEmptyDiscInside(diagram, { region: region([square(4)]) })
      expect(other?.disc.r).toBeCloseTo(one?.disc.r as number, 12)
    }
  })
})
