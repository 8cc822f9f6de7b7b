// SPDX-License-Identifier: GPL-3.0-or-later
// Cells and hulls as polygons.
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { reversed } from '../../web/lib/curves/curve.ts'
import { convexHull, type Diagram, type Outline, type Point, type Polygon, polyline } from '../../web/lib/index.ts'
import { anyCircles, KINDS, unit } from './arbitrary-circles.ts'
import { library } from './library.ts'
import { boxAround, pointIn, signedDistance } from './oracle.ts'
import { doubleArea, windingOf } from './recording-sink.ts'

const pointsOf = (polygon: Polygon): Point[] => polygon.slice(1).map(([x, y]) => ({ x, y }))

/** The signed distance of `c` from the line from `a` to `b`, positive on the left. */
function height(a: Point, b: Point, c: Point): number {
  const length = Math.hypot(b.x - a.x, b.y - a.y)
  return length === 0 ? 0 : ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / length
}

/** Whether two sides of a polygon cross by more than a margin. */
function crossesItself(polygon: readonly Point[], margin: number): boolean {
  const isApart = (one: number, other: number) => Math.min(one, other) < -margin && Math.max(one, other) > margin
  return polygon.some((p, j) => {
    const q = polygon[(j + 1) % polygon.length] as Point
    const heights = polygon.map((u) => height(p, q, u))
    return heights.some((h, k) => {
      const next = (k + 1) % polygon.length
      if (k <= j || !isApart(h, heights[next] as number)) return false
      const [u, v] = [polygon[k], polygon[next]] as [Point, Point]
      return isApart(height(u, v, p), height(u, v, q))
    })
  })
}

/**
 * Returns the points of a loop at a tolerance, seen from the first one. Points of a curve are found in the direction of
 * its edge.
 */
function ringOf(loop: Outline[number], tolerance: number): Point[] {
  const points = loop.flatMap(({ curve, side }) => {
    const own = side % 2 === 1 ? polyline(reversed(curve), tolerance).reverse() : polyline(curve, tolerance)
    return own.slice(1)
  })
  return points.map(({ x, y }) => ({ x: x - (points[0] as Point).x, y: y - (points[0] as Point).y }))
}

function* indicesOf({ circles }: Diagram): Generator<number> {
  for (let i = 0; i < circles.length / 3; i++) yield i
}

describe.each(Object.entries(KINDS))('polygons of the cells of circles that are %s', (_, arbitrary) => {
  it('are closed, simple, counter-clockwise, and have the areas of the cells', () => {
    fc.assert(
      fc.property(arbitrary, fc.constantFrom(-0.2, 0.1, 1), (circles, share) => {
        const diagram = library.compute(circles)
        const bounds = boxAround(circles, share)
        const size = Math.max(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY)
        fc.pre(size > 1e-3 && bounds.minX < bounds.maxX && bounds.minY < bounds.maxY)
        const tolerance = 3e-3 * size
        let sum = 0
        for (const i of indicesOf(diagram)) {
          const polygon = diagram.cellPolygon(i, { bounds, tolerance })
          const area = diagram.cellArea(i, { bounds })
          const around = diagram.cellPerimeter(i, { bounds })
          const loops = diagram.cellOutline(i, { bounds }).map((loop) => ringOf(loop, tolerance))
          // Thin loops whose chords enclose no area are left out, but their neighbors have those chords.
          const areas = loops.map((ring) => doubleArea(ring) / 2)
          sum += areas.reduce((all, one) => all + one, 0)
          expect(polygon !== undefined).toBe(loops.some((ring) => doubleArea(ring) > 0))
          if (polygon === undefined) continue
          expect(polygon.at(-1)).toEqual(polygon[0])
          const points = pointsOf(polygon)
          const beyond = points.map(({ x, y }) =>
            Math.max(bounds.minX - x, x - bounds.maxX, bounds.minY - y, y - bounds.maxY),
          )
          expect(Math.max(...beyond)).toBeLessThan(tolerance)
          const isRepeated = points.some(({ x, y }, k) => x === points.at(k - 1)?.x && y === points.at(k - 1)?.y)
          if (diagram.cellOutline(i, { bounds }).length === 1) expect(isRepeated).toBe(false)
          const own = doubleArea(points) / 2
          expect(Math.abs(own - areas.reduce((all, one) => all + Math.max(one, 0), 0))).toBeLessThan(
            1e-10 * size * size,
          )
          // Chords deviate from their arc by at most the tolerance.
          expect(Math.abs(own - area)).toBeLessThanOrEqual(tolerance * around + 1e-12 * size * size)
          expect(crossesItself(points, 2 * tolerance)).toBe(false)
        }
        // Neighbors share the chords of an arc.
        const whole = (bounds.maxX - bounds.minX) * (bounds.maxY - bounds.minY)
        expect(Math.abs(sum / whole - 1)).toBeLessThan(1e-9)
      }),
      { numRuns: 25 },
    )
  })

  it('go once around what is in the cell, and not around anything else', () => {
    fc.assert(
      fc.property(arbitrary, unit, unit, (circles, across, up) => {
        const diagram = library.compute(circles)
        const bounds = boxAround(circles, 0.2)
        const p = pointIn(bounds, across, up)
        const tolerance = 1e-4 * (bounds.maxX - bounds.minX)
        const distances = [...indicesOf(diagram)].map((i) => signedDistance(circles, i, p)).sort((a, b) => a - b)
        fc.pre(across > 0.01 && across < 0.99 && up > 0.01 && up < 0.99)
        fc.pre((distances[1] ?? Infinity) > (distances[0] as number) + 20 * tolerance)
        const found = diagram.find(p.x, p.y)
        for (const polygon of diagram.cellPolygons({ bounds, tolerance })) {
          expect(windingOf(pointsOf(polygon), p)).toBe(polygon.index === found ? 1 : 0)
        }
      }),
      { numRuns: 50 },
    )
  })

  it('share their points with their neighbors, to the bit', () => {
    fc.assert(
      fc.property(arbitrary, fc.constantFrom(1e-2, 1e-4), (circles, share) => {
        const diagram = library.compute(circles)
        const bounds = boxAround(circles, 0.1)
        const tolerance = share * (bounds.maxX - bounds.minX)
        const onBounds = (x: number, y: number) =>
          x === bounds.minX || x === bounds.maxX || y === bounds.minY || y === bounds.maxY
        const met = new Map<string, number>()
        const polygons = [...diagram.cellPolygons({ bounds, tolerance })]
        // The neighbors of a cell that is too thin for a polygon have their points alone.
        fc.pre(polygons.length === [...indicesOf(diagram)].filter((i) => diagram.cellOutline(i, { bounds })[0]).length)
        for (const polygon of polygons) {
          const own = new Set(polygon.filter(([x, y]) => !onBounds(x, y)).map(String))
          for (const point of own) met.set(point, (met.get(point) ?? 0) + 1)
        }
        expect([...met].filter(([, count]) => count < 2)).toEqual([])
      }),
      { numRuns: 40 },
    )
  })

  it('are those of one cell each, in the order of the circles that have one', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const diagram = library.compute(circles)
        const expected = [...indicesOf(diagram)].flatMap((index) => {
          const polygon = diagram.cellPolygon(index)
          return polygon === undefined ? [] : [Object.assign(polygon, { index })]
        })
        expect([...diagram.cellPolygons()]).toEqual(expected)
      }),
      { numRuns: 30 },
    )
  })

  it('have a hull of three corners where the tolerance is larger than the only circle', () => {
    const ring = library.compute([[2, 3, 1]]).hullPolygon({ tolerance: 10 })
    expect(ring).toHaveLength(4)
    expect(doubleArea(pointsOf(ring as Polygon)) / 2).toBeCloseTo((3 * Math.sqrt(3)) / 4, 12)
  })

  it('have hulls that are convex, closed, inside the hull and as near as the tolerance says', () => {
    fc.assert(
      fc.property(arbitrary, fc.constantFrom(0.3, 1e-2, 1e-4), (circles, share) => {
        const diagram = library.compute(circles)
        const { area, length } = convexHull(diagram)
        const tolerance = share * Math.max(length, 1e-3)
        const ring = diagram.hullPolygon({ tolerance })
        if (ring === undefined) throw new Error('There is no hull.')
        expect(ring.at(-1)).toEqual(ring[0])
        const points = pointsOf(ring)
        const rounding = 1e-9 * length
        points.forEach((p, k) => {
          const [q, r] = [points[(k + 1) % points.length], points[(k + 2) % points.length]] as [Point, Point]
          // The direction between points that differ only by rounding is meaningless.
          if (Math.hypot(q.x - p.x, q.y - p.y) > rounding)
            expect(height(p, q, r)).toBeGreaterThanOrEqual(-1e3 * rounding)
        })
        const own = doubleArea(points) / 2
        expect(own).toBeLessThanOrEqual(area + rounding * length)
        expect(own).toBeGreaterThanOrEqual(area - 1.01 * tolerance * length - rounding * length)
      }),
      { numRuns: 50 },
    )
  })
})

it('more of a cell is in a polygon of a smaller tolerance', () => {
  fc.assert(
    fc.property(anyCircles, (circles) => {
      const diagram = library.compute(circles)
      const bounds = boxAround(circles, 0.2)
      const size = bounds.maxX - bounds.minX
      for (const i of indicesOf(diagram)) {
        const area = diagram.cellArea(i, { bounds })
        const error = (tolerance: number) => {
          const polygon = diagram.cellPolygon(i, { bounds, tolerance })
          return polygon === undefined ? 0 : Math.abs(doubleArea(pointsOf(polygon)) / 2 - area)
        }
        expect(error(1e-7 * size)).toBeLessThanOrEqual(1e-7 * size * diagram.cellPerimeter(i, { bounds }) + 1e-9 * size)
      }
    }),
    { numRuns: 20 },
  )
})
