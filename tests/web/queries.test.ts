// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  type Circle,
  ConvexPolygon,
  circleAt,
  closestPair,
  convexHull,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscCenteredInHull,
  largestEmptyDiscInside,
  type Point,
} from '../../web/lib/index.ts'
import { KINDS, unit } from './arbitrary-circles.ts'
import { library, seededRandom } from './library.ts'
import { boxAround, depthIn, leastDistance, pointIn, scaleOf, signedDistance } from './oracle.ts'

const DIRECTIONS = Array.from({ length: 720 }, (_, k) => ({
  x: Math.cos((2 * Math.PI * k) / 720),
  y: Math.sin((2 * Math.PI * k) / 720),
}))

/** The extent of the circles in each direction from a point. The smallest one is the point's depth in the hull. */
function reaches(circles: Float64Array, from: Point): number[] {
  const all: Circle[] = Array.from({ length: circles.length / 3 }, (_, i) => circleAt(circles, i))
  return DIRECTIONS.map(({ x, y }) =>
    all.reduce((most, c) => Math.max(most, (c.x - from.x) * x + (c.y - from.y) * y + c.r), Number.NEGATIVE_INFINITY),
  )
}

describe.each(Object.entries(KINDS))('circles that are %s', (_, arbitrary) => {
  it('have a hull as long and as large as that of how far they reach', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const { arcs, length, area } = convexHull(library.compute(circles))
        const origin = circleAt(circles, 0)
        const reach = reaches(circles, origin)
        const step = (2 * Math.PI) / reach.length
        // Cauchy's formula: the length is the integral of the support function h. The area is that of (h^2 - h'^2) / 2,
        // from the polygon of the tangents.
        const expected = reach.reduce((sum, h) => sum + h * step, 0)
        const size = Math.max(...reach)
        expect(Math.abs(length - expected)).toBeLessThanOrEqual(1e-3 * size)
        const corners = DIRECTIONS.map((u, k) => {
          const [v, h, g] = [DIRECTIONS[(k + 1) % 720] as Point, reach[k] as number, reach[(k + 1) % 720] as number]
          return { x: (h * v.y - g * u.y) / Math.sin(step), y: (g * u.x - h * v.x) / Math.sin(step) }
        })
        const around = corners.reduce((sum, p, k) => {
          const q = corners[(k + 1) % 720] as Point
          return sum + (p.x * q.y - q.x * p.y) / 2
        }, 0)
        expect(Math.abs(area - around)).toBeLessThanOrEqual(0.02 * size * size)
        expect(arcs.reduce((sum, { angle }) => sum + angle, 0)).toBeCloseTo(2 * Math.PI, 6)
        const rounding = 1e-12 * (scaleOf(circles) + 1)
        for (const { circle, start, end } of arcs) {
          const { x, y, r } = circleAt(circles, circle)
          for (const p of [start, end]) expect(Math.abs(Math.hypot(p.x - x, p.y - y) - r)).toBeLessThan(rounding)
        }
      }),
    )
  })

  it('have the closest pair that scanning finds', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const diagram = library.compute(circles)
        let least = Number.POSITIVE_INFINITY
        for (let i = 0; i < circles.length / 3; i++) {
          for (let j = 0; j < i; j++) {
            if (diagram.cell(i) === undefined || diagram.cell(j) === undefined) continue
            const [c, d] = [circleAt(circles, i), circleAt(circles, j)]
            least = Math.min(least, Math.hypot(c.x - d.x, c.y - d.y) - c.r - d.r)
          }
        }
        const closest = closestPair(diagram)
        expect(closest?.gap ?? Number.POSITIVE_INFINITY).toBeCloseTo(least, 8)
        if (closest === undefined) return
        expect(closest.first).toBeLessThan(closest.second)
        const [c, d] = [circleAt(circles, closest.first), circleAt(circles, closest.second)]
        expect(Math.hypot(c.x - d.x, c.y - d.y) - c.r - d.r).toBeCloseTo(closest.gap, 8)
      }),
    )
  })

  it('have no larger empty disc in a box than that which is found', () => {
    fc.assert(
      fc.property(arbitrary, fc.constantFrom(-0.3, 0, 0.4), fc.nat(), (circles, share, seed) => {
        const random = seededRandom(seed)
        const diagram = library.compute(circles)
        const box = boxAround(circles, share)
        const largest = largestEmptyDiscCenteredIn(diagram, { bounds: box })
        if (largest === undefined) throw new Error('There is no disc.')
        const { x, y, r: radius } = largest.disc
        const rounding = 1e-12 * (scaleOf(circles) + Math.abs(radius))
        expect(ConvexPolygon.of(box).contains({ x, y })).toBe(true)
        expect(Math.abs(leastDistance(circles, { x, y }) - radius)).toBeLessThanOrEqual(rounding)
        for (const i of largest.circles) {
          const c = circleAt(circles, i)
          expect(Math.abs(Math.hypot(x - c.x, y - c.y) - c.r - radius)).toBeLessThanOrEqual(rounding)
        }
        let most = Number.NEGATIVE_INFINITY
        for (let k = 0; k < 300; k++) most = Math.max(most, leastDistance(circles, pointIn(box, random(), random())))
        expect(most).toBeLessThanOrEqual(radius + rounding)
      }),
      { numRuns: 50 },
    )
  })

  it('have no larger empty disc inside a region than that which is found, and it sticks out nowhere', () => {
    const corners = [0, 1, 2, 3, 4, 5, 6].map((k) => ({ x: Math.cos(k) / 2, y: Math.sin(k) / 3 }))
    fc.assert(
      fc.property(arbitrary, fc.constantFrom(-0.3, 0, 0.4), fc.nat(), fc.boolean(), (circles, share, seed, isBox) => {
        const random = seededRandom(seed)
        const diagram = library.compute(circles)
        const box = boxAround(circles, share)
        const [width, height] = [box.maxX - box.minX, box.maxY - box.minY]
        const region = isBox
          ? ConvexPolygon.of(box)
          : ConvexPolygon.from(corners.map(({ x, y }) => pointIn(box, 0.5 + x, 0.5 + y)))
        const depthOf = (point: Point) => depthIn(region, point)
        const largest = largestEmptyDiscInside(diagram, { bounds: region })
        if (largest === undefined) throw new Error('There is no disc.')
        const { disc, circles: touched } = largest
        const rounding = 1e-12 * (scaleOf(circles) + width + height)
        if (disc.r <= 0) {
          const centered = largestEmptyDiscCenteredIn(diagram, { bounds: region })
          expect(Math.abs(disc.r - (centered?.disc.r as number))).toBeLessThanOrEqual(rounding)
        } else {
          expect(depthOf(disc)).toBeGreaterThanOrEqual(disc.r - rounding)
          expect(leastDistance(circles, disc)).toBeGreaterThanOrEqual(disc.r - rounding)
          for (const i of touched) {
            expect(Math.abs(signedDistance(circles, i, disc) - disc.r)).toBeLessThanOrEqual(
              1e-9 * (width + height) + rounding,
            )
          }
        }
        let most = Number.NEGATIVE_INFINITY
        for (let k = 0; k < 300; k++) {
          const p = pointIn(box, random(), random())
          if (depthOf(p) >= 0) most = Math.max(most, Math.min(depthOf(p), leastDistance(circles, p)))
        }
        expect(most).toBeLessThanOrEqual(disc.r + rounding)
      }),
      { numRuns: 50 },
    )
  })

  it('have no larger empty disc in their hull than that which is found', () => {
    fc.assert(
      fc.property(arbitrary, fc.array(fc.tuple(unit, unit), { minLength: 60, maxLength: 60 }), (circles, places) => {
        const largest = largestEmptyDiscCenteredInHull(library.compute(circles))
        if (largest === undefined) throw new Error('There is no disc.')
        const { x, y, r: radius } = largest.disc
        const box = boxAround(circles, 0)
        const rounding = 1e-11 * scaleOf(circles)
        expect(radius).toBeGreaterThanOrEqual(0)
        expect(Math.abs(leastDistance(circles, { x, y }) - radius)).toBeLessThanOrEqual(rounding)
        expect(Math.min(...reaches(circles, { x, y }))).toBeGreaterThanOrEqual(-rounding)
        for (const [across, up] of places) {
          const point = pointIn(box, across, up)
          if (leastDistance(circles, point) <= radius + rounding) continue
          // The sampled directions may miss that the point is slightly outside.
          expect(Math.min(...reaches(circles, point))).toBeLessThan(1e-3 * (box.maxX - box.minX + box.maxY - box.minY))
        }
      }),
      { numRuns: 50 },
    )
  })
})

it('the largest empty disc in the hull of one circle is a point of it', () => {
  const disc = { x: 4, y: 2, r: 0 }
  expect(largestEmptyDiscCenteredInHull(library.compute([[1, 2, 3]]))).toEqual({ disc, circles: [0] })
})

it('the largest empty disc may touch two circles from the edge of the hull', () => {
  const largest = largestEmptyDiscCenteredInHull(library.compute(Float64Array.of(0, 0, 1, 10, 0, 1)))
  expect(largest?.disc.x).toBeCloseTo(5, 14)
  expect(Math.abs(largest?.disc.y as number)).toBeCloseTo(1, 14)
  expect(largest?.disc.r).toBeCloseTo(Math.sqrt(26) - 1, 13)
  expect([...(largest?.circles ?? [])].sort()).toEqual([0, 1])
})

it.each([
  ['three circles', [10, 0, 1, -5, 5 * Math.sqrt(3), 1, -5, -5 * Math.sqrt(3), 1], [-9.5, -9.25, 9.75, 9.5], 9, 3],
  ['two circles and a side', [-3, 0, 1, 3, 0, 1], [-3, -4, 3, 4], 2.4, 2],
  ['one circle and two sides', [0, 0, 1], [0, 0, 4, 4], (4 * Math.SQRT2 - 1) / (1 + Math.SQRT2), 1],
  ['a circle between parallel sides', [-0.5, 0, 0.6, 8.5, 0, 0.6], [-1, -1, 9, 1], 1, 1],
  ['three sides', [50, 0, 1], [0, 0, 4, 3], 1.5, 0],
  ['two sides, though an edge passes through its center', [4, 0, 0, 4, 1, 0], [3.9, 0, 4.1, 1], 0.1, 0],
] as const)('the largest empty disc inside a box touches %s', (_, circles, [minX, minY, maxX, maxY], radius, count) => {
  const diagram = library.compute(Float64Array.from(circles))
  const largest = largestEmptyDiscInside(diagram, { bounds: { minX, minY, maxX, maxY } })
  expect(largest?.disc.r).toBeCloseTo(radius, 12)
  expect(largest?.circles).toHaveLength(count)
})

it('no circles have no answers', () => {
  const diagram = library.compute([])
  expect(closestPair(diagram)).toBeUndefined()
  expect(largestEmptyDiscCenteredIn(diagram, { bounds: { minX: 0, minY: 0, maxX: 1, maxY: 1 } })).toBeUndefined()
  expect(largestEmptyDiscCenteredInHull(diagram)).toBeUndefined()
  // Bounds alone have a largest disc.
  const inside = { disc: { x: 0.5, y: 0.5, r: 0.5 }, circles: [] }
  expect(largestEmptyDiscInside(diagram, { bounds: [0, 0, 1, 1] })).toEqual(inside)
  expect(convexHull(diagram)).toEqual({ arcs: [], length: 0, area: 0 })
  for (const bounds of [undefined, [0, 0, 1, 1]] as const) {
    const all = [diagram.cellAreas({ bounds }), diagram.cellCentroids({ bounds }), diagram.cellPerimeters({ bounds })]
    expect(all).toEqual([new Float64Array(), new Float64Array(), new Float64Array()])
    expect([...diagram.cellPolygons({ bounds })]).toEqual([])
  }
  expect([diagram.hullPolygon(), diagram.renderHull(), diagram.render()]).toEqual([undefined, '', ''])
})

it('of several closest pairs that with the smallest indices is found', () => {
  for (const seed of [1, 2, 3, 4, 5]) {
    const random = seededRandom(seed)
    const grid = Array.from({ length: 25 }, (_, k) => [4 * (k % 5), 4 * Math.floor(k / 5), 1, random()] as const)
    const circles = grid.toSorted((one, other) => one[3] - other[3]).flatMap((circle) => circle.slice(0, 3))
    const diagram = library.compute(Float64Array.from(circles))
    const pairs = Array.from({ length: 25 }, (_, i) => Array.from(diagram.neighbors(i).sort(), (j) => [i, j] as const))
    const closest = pairs.flat().find(([i, j]) => {
      const [c, d] = [circleAt(diagram.circles, i), circleAt(diagram.circles, j)]
      return Math.hypot(c.x - d.x, c.y - d.y) - c.r - d.r === 2
    })
    expect(closestPair(diagram)).toEqual({ first: closest?.[0], second: closest?.[1], gap: 2 })
  }
})

it('one circle is its own hull', () => {
  const { arcs, length, area } = convexHull(library.compute(Float64Array.of(1, 2, 3)))
  expect(arcs).toEqual([{ circle: 0, r: 3, start: { x: 4, y: 2 }, end: { x: 4, y: 2 }, angle: 2 * Math.PI }])
  expect(length).toBeCloseTo(6 * Math.PI, 12)
  expect(area).toBeCloseTo(9 * Math.PI, 12)
})

it('the hull turns around the larger of two circles that nearly touch inside', () => {
  // The common tangents coincide up to rounding.
  const small = [0.2823275086840536, 0.05996925804686018, 0.71137371209393407]
  const large = [0.0015071996752053401, 0.0003201446669926927, 0.99845917441975318]
  const { arcs, length, area } = convexHull(library.compute(Float64Array.from([...small, ...large])))
  const r = large[2] as number
  expect(arcs.find(({ circle }) => circle === 1)?.angle).toBeCloseTo(2 * Math.PI, 6)
  expect(length).toBeCloseTo(2 * Math.PI * r, 6)
  expect(area).toBeCloseTo(Math.PI * r * r, 6)
})

it.each([2 ** -30, 2 ** 90])('the hull is the same at %d times the size', (size) => {
  const circles = Float64Array.of(0, 0, 0.1, 1, 0, 0.2, 0, 1, 0.3, 0.9, 0.9, 0.05)
  const scaled = ({ x, y }: Point) => ({ x: size * x, y: size * y })
  const large = convexHull(library.compute(circles)).arcs
  const small = convexHull(library.compute(circles.map((value) => size * value))).arcs
  expect(small).toEqual(
    large.map((arc) => ({ ...arc, r: size * arc.r, start: scaled(arc.start), end: scaled(arc.end) })),
  )
})

it('the hull of two circles has two arcs and two tangent segments', () => {
  const { arcs, length, area } = convexHull(library.compute(Float64Array.of(0, 0, 1, 4, 0, 1)))
  expect(arcs.map(({ angle }) => angle)).toEqual([Math.PI, Math.PI])
  expect(length).toBeCloseTo(2 * Math.PI + 8, 12)
  expect(area).toBeCloseTo(Math.PI + 8, 12)
})
