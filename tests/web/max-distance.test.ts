// SPDX-License-Identifier: GPL-3.0-or-later
// Cells clipped at a maximum distance from their circles, compared with the union of the grown circles.
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { type Box, type Diagram, NONE, type Point, REGION_LIMIT } from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { outlineArea } from '../../web/lib/regions/measure.ts'
import { anyCircles, unit } from './arbitrary-circles.ts'
import { library } from './library.ts'
import { boxAround, pointIn, scaleOf, signedDistance } from './oracle.ts'
import { doubleArea, RecordingSink, windingOf } from './recording-sink.ts'
import { tuple } from './tuples.ts'

const ROWS = 4000

/** The area of the union of circles grown by a distance, inside a box, by the midpoint rule over rows. */
function unionArea(circles: Float64Array, more: number, { minX, minY, maxX, maxY }: Box): number {
  const step = (maxY - minY) / ROWS
  let sum = 0
  for (let row = 0; row < ROWS; row++) {
    const y = minY + (row + 0.5) * step
    const spans: [number, number][] = []
    for (let i = 0; i < circles.length; i += 3) {
      const [cx, cy, r] = [circles[i], circles[i + 1], (circles[i + 2] as number) + more] as [number, number, number]
      const square = (r - (y - cy)) * (r + (y - cy))
      if (r > 0 && square > 0) spans.push([cx - Math.sqrt(square), cx + Math.sqrt(square)])
    }
    let at = minX
    for (const [from, to] of spans.sort(([one], [other]) => one - other)) {
      sum += step * Math.max(0, Math.min(to, maxX) - Math.max(at, from))
      at = Math.max(at, Math.min(to, maxX))
    }
  }
  return sum
}

/** The winding number of a path around a point. */
function windings({ strokes }: RecordingSink, point: Point): number {
  return strokes.reduce((count, stroke) => count + windingOf(stroke, point), 0)
}

function cellsOf(diagram: Diagram): number[] {
  return Array.from({ length: diagram.circles.length / 3 }, (_, i) => i)
}

describe('a maximum distance', () => {
  it('makes a disc of one circle', () => {
    const diagram = library.compute([[3, 4, 2]])
    expect(diagram.cellArea(0, { maxDistance: 1 })).toBeCloseTo(9 * Math.PI, 12)
    expect(diagram.cellPerimeter(0, { maxDistance: 1 })).toBeCloseTo(6 * Math.PI, 12)
    expect(diagram.cellArea(0, { maxDistance: -1 })).toBeCloseTo(Math.PI, 12)
    expect(diagram.cellArea(0, { maxDistance: -2 })).toBe(0)
    expect(diagram.cellArea(0, { maxDistance: 1, bounds: [3, 4, 9, 9] })).toBeCloseTo((9 * Math.PI) / 4, 12)
    expect(diagram.cellArea(0, { maxDistance: 1, bounds: [6.5, 4, 9, 9] })).toBe(0)
    expect(diagram.cellArea(0, { maxDistance: 1, bounds: [2, 3, 4, 5] })).toBe(4)
    expect(diagram.cellCentroid(0, { maxDistance: 1 })?.x).toBeCloseTo(3, 12)
    expect(diagram.cellPath(0, { maxDistance: 1, digits: 2 })).toMatch(/^M6,4A3,3 0 0 1 /)
  })

  it('is at most REGION_LIMIT, with either sign', () => {
    const diagram = library.compute([[3, 4, 2]])
    const bounds = [0, 0, 2, 3] as const
    expect(diagram.cellArea(0, { bounds, maxDistance: REGION_LIMIT })).toBe(6)
    expect(diagram.cellArea(0, { bounds, maxDistance: -REGION_LIMIT })).toBe(0)
    for (const maxDistance of [REGION_LIMIT * (1 + 2 ** -52), -REGION_LIMIT * (1 + 2 ** -52)]) {
      expect(() => diagram.cellArea(0, { bounds, maxDistance })).toThrow(expect.objectContaining({ code: 'badOption' }))
    }
  })

  it('leaves the neighbors that share a part of an edge within it, each once', () => {
    const corner = library.compute(Float64Array.of(0, 0, 1, 10, 0, 1, 0, 14, 1))
    expect([...corner.neighbors(0, { maxDistance: 3 })]).toEqual([])
    expect([...corner.neighbors(0, { maxDistance: 5 })]).toEqual([1])
    // The first two share an edge on either side of the third.
    const between = library.compute(Float64Array.of(-5, 0, 4, 5, 0, 4, 0, 0, 0.5))
    expect([...between.neighbors(0, { bounds: [-20, -20, 20, 20] })].sort()).toEqual([1, 2])
  })

  it('makes arcs whose polygons are as fine as is useful', () => {
    const diagram = library.compute([[0, 0, 2]])
    const finest = diagram.cellPolygon(0, { maxDistance: 1, tolerance: 3e-9 })
    expect(diagram.cellPolygon(0, { maxDistance: 1, tolerance: 1e-300 })).toEqual(finest)
  })

  it('cuts two discs along a line', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 1, 4, 0, 1))
    const segment = 9 * Math.acos(2 / 3) - 2 * Math.sqrt(5)
    for (const i of [0, 1]) {
      expect(diagram.cellArea(i, { maxDistance: 0.5 })).toBeCloseTo(2.25 * Math.PI, 12)
      expect(diagram.cellArea(i, { maxDistance: 1 })).toBeCloseTo(4 * Math.PI, 10)
      expect(diagram.cellArea(i, { maxDistance: 2 })).toBeCloseTo(9 * Math.PI - segment, 10)
      const [loop = []] = diagram.cellOutline(i, { bounds: [-9, -9, 13, 9], maxDistance: 2 })
      expect(loop.filter(({ neighbor }) => neighbor === 1 - i)).toHaveLength(1)
      for (const { side, r } of loop) expect(r).toBe(side === NONE ? 3 : 0)
    }
    expect(diagram.edgePath(0, { maxDistance: 0.5 })).toBe('')
    expect(diagram.edgePath(0, { maxDistance: 2, digits: 3 })).toBe('M2,-2.236L2,2.236')
  })

  it('shares out the union of the grown circles', () => {
    fc.assert(
      fc.property(anyCircles, unit, unit, (circles, share, cut) => {
        const diagram = library.compute(circles)
        const scale = scaleOf(circles)
        const box = boxAround(circles, 0.1)
        const maxDistance = scale * share ** 2
        // The whole box, or one part.
        const bounds = cut < 0.3 ? undefined : { ...box, maxX: box.minX + cut * (box.maxX - box.minX) }
        const whole = bounds ?? grown(box, maxDistance)
        const areas = diagram.cellAreas({ maxDistance, bounds })
        const sum = areas.reduce((partial, part) => partial + part, 0)
        const size = Math.max(whole.maxX - whole.minX, whole.maxY - whole.minY)
        expect(Math.abs(sum - unionArea(circles, maxDistance, whole))).toBeLessThan(2e-4 * size * size)
      }),
      { numRuns: 60 },
    )
  })

  it('shares out the union of the discs of a power diagram, in its default bounds', async () => {
    const { compute } = await loadMetrics({ library })
    fc.assert(
      fc.property(anyCircles, unit, fc.boolean(), fc.boolean(), (circles, share, weights, isNegative) => {
        const scale = scaleOf(circles)
        const maxDistance = scale * share ** 2 * (isNegative ? -1 : 1)
        // Weights of either sign.
        const numbers = circles.map((number, k) => (weights && k % 3 === 2 ? number * scale * (share - 0.5) : number))
        const diagram = compute(numbers, { metric: 'power', weights })
        const discs = diagram.circles.map((number, k) => {
          if (k % 3 < 2) return number
          return Math.sqrt(Math.max((weights ? number : number ** 2) + maxDistance * Math.abs(maxDistance), 0))
        })
        const box = diagram.exportBox({ maxDistance })
        for (let i = 0; i < discs.length; i += 3) {
          const [x, y, r] = tuple(discs, i, 3)
          expect(Math.min(x - r - box.minX, box.maxX - x - r, y - r - box.minY, box.maxY - y - r)).toBeGreaterThan(0)
        }
        const sum = diagram.cellAreas({ maxDistance }).reduce((partial, part) => partial + part, 0)
        const size = Math.max(box.maxX - box.minX, box.maxY - box.minY)
        expect(Math.abs(sum - unionArea(discs, 0, grown(box, size)))).toBeLessThan(1e-3 * size * size)
      }),
      { numRuns: 60 },
    )
  })

  it('is that from the centers in the diagram of the centers', async () => {
    const { compute } = await loadMetrics({ library })
    const circles = [
      [0, 0, 3],
      [10, 0, 1],
      [0, 14, 2],
    ] as const
    const centers = compute(circles, { metric: 'centers' })
    const points = library.compute(circles.map(([x, y]) => [x, y, 0]))
    for (const bounds of [undefined, [-9, -9, 4, 20]] as const) {
      for (const maxDistance of [1, 4, 9]) {
        const options = { bounds: bounds ?? [-20, -20, 30, 30], maxDistance } as const
        expect(centers.cellAreas(options)).toEqual(points.cellAreas(options))
        expect(centers.cellPath(0, options)).toBe(points.cellPath(0, options))
        expect(centers.edgePath(0, options)).toBe(points.edgePath(0, options))
      }
    }
  })

  it('keeps of each cell the points that are so near', () => {
    fc.assert(
      fc.property(anyCircles, unit, unit, unit, (circles, share, u, v) => {
        const diagram = library.compute(circles)
        const scale = scaleOf(circles)
        const maxDistance = 0.5 * scale * share
        const box = grown(boxAround(circles, 0.1), maxDistance)
        const p = pointIn(box, u, v)
        const distances = cellsOf(diagram).map((i) => signedDistance(circles, i, p))
        const sorted = [...distances].sort((one, other) => one - other) as [number, ...number[]]
        const margin = 2e-3 * (box.maxX - box.minX)
        const isClear = Math.abs(sorted[0] - maxDistance) > margin && (sorted[1] ?? Infinity) > sorted[0] + 2 * margin
        fc.pre(isClear)
        cellsOf(diagram).forEach((i) => {
          const sink = new RecordingSink(64)
          diagram.cellPath(i, { context: sink, maxDistance, bounds: box, tolerance: margin / 10 })
          const isIn = distances[i] === sorted[0] && sorted[0] < maxDistance
          expect(windings(sink, p)).toBe(isIn ? 1 : 0)
        })
      }),
      { numRuns: 100 },
    )
  })

  it('gives paths, polygons and measures of the same cells', () => {
    fc.assert(
      fc.property(anyCircles, unit, (circles, share) => {
        const diagram = library.compute(circles)
        const maxDistance = 0.3 * scaleOf(circles) * share
        const tolerance = 1e-3 * scaleOf(circles)
        for (const i of cellsOf(diagram)) {
          const exact = diagram.cellArea(i, { maxDistance })
          const slack = tolerance * (diagram.cellPerimeter(i, { maxDistance }) + tolerance)
          const polygon = diagram.cellPolygon(i, { maxDistance, tolerance }) ?? []
          expect(Math.abs(doubleArea(polygon.map(([x, y]) => ({ x, y }))) / 2 - exact)).toBeLessThan(slack)
          const sink = new RecordingSink(64)
          diagram.cellPath(i, { context: sink, maxDistance, tolerance })
          const drawn = sink.strokes.reduce((sum, stroke) => sum + doubleArea(stroke) / 2, 0)
          expect(Math.abs(drawn - exact)).toBeLessThan(slack)
          expect(
            outlineArea(diagram.cellOutline(i, { bounds: grown(boxAround(circles, 0.1), maxDistance), maxDistance })),
          ).toBeCloseTo(exact, 6)
        }
      }),
      { numRuns: 40 },
    )
  })

  it('moves the centroid of a cut disc away from the cut, in any direction', () => {
    // Discs of radius 5, cut 3 from the center of the first one.
    const moment = (2 / 3) * 4 ** 3
    const area = 25 * (Math.PI - Math.acos(3 / 5)) + 3 * 4
    for (const angle of [0, 0.4, 1, 2, 3, 4, 5.5]) {
      const [x, y] = [Math.cos(angle), Math.sin(angle)]
      const centroids = library.compute([0, 6].map((far) => [far * x, far * y, 1])).cellCentroids({ maxDistance: 4 })
      expect(centroids[0]).toBeCloseTo((-moment / area) * x, 9)
      expect(centroids[1]).toBeCloseTo((-moment / area) * y, 9)
    }
  })
})

function grown({ minX, minY, maxX, maxY }: Box, more: number): Box {
  return { minX: minX - more, minY: minY - more, maxX: maxX + more, maxY: maxY + more }
}
