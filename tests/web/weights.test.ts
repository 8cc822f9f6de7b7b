// SPDX-License-Identifier: GPL-3.0-or-later
// Additive weights of any sign: only the differences of radii matter.
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  convexHull,
  type Diagram,
  fromJSON,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscCenteredInHull,
  mergeVertices,
} from '../../web/lib/index.ts'
import { KINDS } from './arbitrary-circles.ts'
import { library } from './library.ts'
import { boxAround } from './oracle.ts'

const WEIGHTS = { weights: true } as const
const NEGATIVE = Float64Array.of(0, 0, -3, 6, 0, -1, 3, 7, -2, 6.5, 0, -2)

function withMore(circles: Float64Array, more: number): Float64Array {
  return circles.map((value, k) => (k % 3 === 2 ? value + more : value))
}

describe('weights', () => {
  it('are an error where they are not asked for', () => {
    const refused = expect.objectContaining({ code: 'negativeRadius', circle: 0 })
    expect(() => library.compute(NEGATIVE)).toThrow(refused)
    const diagram = library.compute(NEGATIVE, WEIGHTS)
    expect(diagram.weights).toBe(true)
    expect(library.compute(Float64Array.of(0, 0, 1)).weights).toBe(false)
    expect([...diagram.hidden]).toEqual([3, 1])
    expect(library.certify(diagram).certified).toBe(true)
    expect(() => library.certify({ ...diagram, weights: false })).toThrow(refused)
  })

  it('change nothing by one number added to all', () => {
    // Whole numbers, so that no sum is rounded.
    fc.assert(
      fc.property(fc.oneof(KINDS.integers, KINDS.tangent), fc.integer({ min: -1000, max: -1 }), (circles, more) => {
        const expected = library.compute(circles)
        const actual = library.compute(withMore(circles, more), WEIGHTS)
        expect(actual.hidden).toEqual(expected.hidden)
        expect(actual.hull).toEqual(expected.hull)
        const placesOf = ({ vertices, vertexCircles }: Diagram) =>
          Array.from({ length: vertices.length / 3 }, (_, v) =>
            [...vertexCircles.subarray(3 * v, 3 * v + 3), vertices[3 * v], vertices[3 * v + 1]].join(),
          ).sort()
        expect(placesOf(actual)).toEqual(placesOf(expected))
        const bounds = boxAround(circles, 0.1)
        expect(actual.cellAreas({ bounds })).toEqual(expected.cellAreas({ bounds }))
        expect(mergeVertices(actual).vertices.length).toBe(mergeVertices(expected).vertices.length)
        const disc = largestEmptyDiscCenteredIn(actual, { bounds })
        expect(disc?.disc.r).toBeCloseTo((largestEmptyDiscCenteredIn(expected, { bounds })?.disc.r ?? 0) - more, 6)
      }),
      { numRuns: 60 },
    )
  })

  it('have the hull of grown circles', () => {
    const diagram = library.compute(NEGATIVE, WEIGHTS)
    const grown = library.compute(withMore(NEGATIVE, 3))
    expect(convexHull(diagram)).toEqual(convexHull(grown))
    const [disc, other] = [largestEmptyDiscCenteredInHull(diagram), largestEmptyDiscCenteredInHull(grown)]
    expect(disc?.disc.r).toBeCloseTo((other?.disc.r ?? 0) + 3, 12)
    expect(diagram.renderHull({ digits: 3 })).toBe(grown.renderHull({ digits: 3 }))
    expect(diagram.hullPolygon({ tolerance: 0.01 })).toEqual(grown.hullPolygon({ tolerance: 0.01 }))
  })

  it('of negative sign are drawn as points', () => {
    const diagram = library.compute(NEGATIVE, WEIGHTS)
    expect(diagram.renderCircles({ digits: 3 })).not.toContain('-3')
    expect(diagram.cellPath(0)).toBe(
      library.compute(withMore(NEGATIVE, 3)).cellPath(0, { bounds: [-0.35, -0.35, 6.85, 7.35] }),
    )
  })

  it('are what files say they are', () => {
    const diagram = library.compute(NEGATIVE, WEIGHTS)
    const text = JSON.stringify(diagram)
    const read = fromJSON(text)
    expect(read.weights).toBe(true)
    expect(read.circles).toEqual(diagram.circles)
    expect(library.certify(read).certified).toBe(true)
    expect(() => fromJSON(text.replace('"weights":true,', ''))).toThrow(
      expect.objectContaining({ code: 'negativeRadius' }),
    )
    expect(() => fromJSON(text.replace('"weights":true', '"weights":1'))).toThrow(
      expect.objectContaining({ code: 'badInput' }),
    )
    expect(JSON.stringify(library.compute([[0, 0, 1]]))).not.toContain('weights')
  })
})
