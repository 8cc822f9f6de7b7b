// SPDX-License-Identifier: GPL-3.0-or-later
// @ts-expect-error: it has no types
import { Delaunay } from 'd3-delaunay'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { reversed } from '../../web/lib/curves/curve.ts'
import {
  type Bounds,
  type Box,
  ConvexPolygon,
  clipCurve,
  type Diagram,
  edgeAt,
  edgeCurve,
  NONE,
  type Point,
  type Polygon,
  pointAt,
} from '../../web/lib/index.ts'
import { outlineArea, outlineCentroid, outlinePerimeter } from '../../web/lib/regions/measure.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { anyCircles, KINDS, unit } from './arbitrary-circles.ts'
import { dataSet, library, seededRandom } from './library.ts'
import { boxAround, depthIn, leastDistance, pointIn, scaleOf, signedDistance } from './oracle.ts'
import { doubleArea } from './recording-sink.ts'
import { box } from './shapes.ts'

const { region } = await loadRegions()

/** A convex polygon near the middle of a box. */
function polygonIn(box: Box, turns: readonly number[], size: number): ConvexPolygon {
  const middle = pointIn(box, 0.3 + 0.4 * size, 0.6 - 0.3 * size)
  const radius = (0.05 + size) * (box.maxX - box.minX)
  return ConvexPolygon.from(
    [...new Set(turns.map((turn) => Math.round(turn * 1000)))]
      .sort((one, other) => one - other)
      .map((turn) => ({
        x: middle.x + radius * Math.cos((2 * Math.PI * turn) / 1001),
        y: middle.y + radius * Math.sin((2 * Math.PI * turn) / 1001),
      })),
  )
}

const turns = fc
  .uniqueArray(fc.integer({ min: 0, max: 1000 }), { minLength: 3, maxLength: 8 })
  .map((list) => list.map((turn) => turn / 1000))

/** Expects closed loops, no negative part, and a total of the region's area. */
function expectPartition(diagram: Diagram, bounds: Bounds): void {
  const whole = ConvexPolygon.of(bounds).area()
  let sum = 0
  for (let i = 0; i < diagram.circles.length / 3; i++) {
    const parts = diagram.cellOutline(i, { bounds })
    for (const loop of parts) {
      loop.forEach(({ curve }, k) => {
        expect(curve.end).toEqual(loop[(k + 1) % loop.length]?.curve.start)
      })
    }
    const part = outlineArea(parts)
    expect(part).toBeGreaterThanOrEqual(-1e-12 * whole)
    sum += part
  }
  expect(Math.abs(sum / whole - 1)).toBeLessThan(1e-9)
}

describe.each(Object.entries(KINDS))('cells of circles that are %s', (_, arbitrary) => {
  it('have sides that turn counter-clockwise and link up', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const diagram = library.compute(circles)
        const isHidden = new Set(diagram.hidden.filter((__, k) => k % 2 === 0))
        let count = 0
        for (let i = 0; i < circles.length / 3; i++) {
          const cell = diagram.cell(i)
          expect(cell === undefined).toBe(isHidden.has(i))
          if (cell === undefined) continue
          const { sides, edges, neighbors, vertices, isBounded } = cell
          count += sides.length
          expect(isBounded).toBe(sides.length > 0 && !vertices.includes(NONE))
          expect(diagram.neighbors(i)).toEqual(neighbors)
          sides.forEach((side, k) => {
            expect(edges[k]).toBe(side >> 1)
            expect(diagram.cells.circleOf(side)).toBe(i)
            expect(diagram.cells.targetOf(side)).toBe(vertices[(k + 1) % sides.length])
          })
          for (const j of neighbors) {
            const times = (list: Int32Array, circle: number) => list.filter((other) => other === circle).length
            expect(times(diagram.neighbors(j), i)).toBe(times(neighbors, j))
          }
        }
        expect(count).toBe(diagram.edges.length / 2)
      }),
    )
  })

  it('contain what is nearest, which find finds', () => {
    fc.assert(
      fc.property(arbitrary, unit, unit, fc.nat(), (circles, across, up, hint) => {
        const diagram = library.compute(circles)
        const point = pointIn(boxAround(circles, 0.2), across, up)
        const rounding = 1e-14 * (scaleOf(circles) + Math.hypot(point.x, point.y))
        const least = leastDistance(circles, point)
        for (let i = 0; i < circles.length / 3; i++) {
          const lead = signedDistance(circles, i, point) - least
          if (diagram.contains(i, point.x, point.y)) expect(lead).toBeLessThanOrEqual(rounding)
          else if (diagram.cell(i) !== undefined) expect(lead).toBeGreaterThanOrEqual(-rounding)
        }
        for (const found of [
          diagram.find(point.x, point.y),
          diagram.find(point.x, point.y, hint % (circles.length / 3)),
        ]) {
          expect(diagram.cell(found)).toBeDefined()
          expect(signedDistance(circles, found, point) - least).toBeLessThanOrEqual(rounding)
        }
      }),
      { numRuns: 200 },
    )
  })

  it('fill every box and every convex polygon, to 1e-9 of its area', () => {
    fc.assert(
      fc.property(arbitrary, turns, unit, (circles, corners, size) => {
        const diagram = library.compute(circles)
        const whole = boxAround(circles, 0.25)
        expectPartition(diagram, whole)
        expectPartition(diagram, boxAround(circles, 0))
        expectPartition(diagram, boxAround(circles, 500))
        expectPartition(diagram, polygonIn(whole, corners, size))
      }),
    )
  })
})

describe('the outline of a cell', () => {
  const boxes = fc.tuple(anyCircles, fc.constantFrom(-0.2, 0, 0.3))

  it('has the area, centroid and perimeter of a polygon with thousands of corners', () => {
    fc.assert(
      fc.property(boxes, ([circles, share]) => {
        const diagram = library.compute(circles)
        const box = boxAround(circles, share)
        const size = box.maxX - box.minX
        if (!(size > 0 && box.maxY > box.minY)) return
        for (let i = 0; i < circles.length / 3; i++) {
          const parts = diagram.cellOutline(i, { bounds: box })
          const origin = pointIn(box, 0.5, 0.5)
          let [twice, x, y, around] = [0, 0, 0, 0]
          for (const { bisector, from, to } of parts.flat().map(({ curve }) => curve)) {
            const count = bisector.a === 0 ? 1 : 2000
            const step = (to / from) ** (1 / count)
            let q = pointAt(bisector, from)
            let s = from
            for (let k = 1; k <= count; k++) {
              s *= step
              const p = pointAt(bisector, s)
              const [ux, uy, vx, vy] = [q.x - origin.x, q.y - origin.y, p.x - origin.x, p.y - origin.y]
              const cross = ux * vy - uy * vx
              twice += cross
              x += (cross * (ux + vx)) / 3
              y += (cross * (uy + vy)) / 3
              around += Math.sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y))
              q = p
            }
          }
          expect(Math.abs(outlineArea(parts) - twice / 2)).toBeLessThan(2e-5 * size * (around + size))
          expect(Math.abs(outlinePerimeter(parts) - around)).toBeLessThan(1e-4 * (around + size))
          if (twice < 0.01 * size * size) continue
          const middle = outlineCentroid(parts)
          expect(Math.hypot(middle.x - origin.x - x / twice, middle.y - origin.y - y / twice)).toBeLessThan(1e-3 * size)
        }
      }),
      { numRuns: 25 },
    )
  })

  it('has the area that pixels have', () => {
    const circles = dataSet('introduction')
    const diagram = library.compute(circles)
    const box = boxAround(circles, 0.1)
    const pixels = 400
    const counts = new Float64Array(circles.length / 3)
    for (let k = 0; k < pixels * pixels; k++) {
      const point = pointIn(box, ((k % pixels) + 0.5) / pixels, (Math.floor(k / pixels) + 0.5) / pixels)
      const least = leastDistance(circles, point)
      const nearest = counts.findIndex((__, i) => signedDistance(circles, i, point) === least)
      counts[nearest] = (counts[nearest] as number) + 1
    }
    const pixel = ((box.maxX - box.minX) * (box.maxY - box.minY)) / pixels ** 2
    counts.forEach((count, i) => {
      const parts = diagram.cellOutline(i, { bounds: box })
      // Each pixel on the outline may be wrong by one half.
      const wrong = (0.5 * outlinePerimeter(parts)) / Math.sqrt(pixel)
      expect(Math.abs(outlineArea(parts) / pixel - count)).toBeLessThan(wrong + 4)
    })
  })

  it('is the box of a single circle', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 1, 0.1, 0, 0.5))
    const box = { minX: 2, minY: 3, maxX: 5, maxY: 4 }
    const parts = diagram.cellOutline(0, { bounds: box })
    expect(diagram.cell(0)).toMatchObject({ sides: new Int32Array(0), isBounded: false })
    expect([outlineArea(parts), outlinePerimeter(parts), outlineCentroid(parts)]).toEqual([3, 8, { x: 3.5, y: 3.5 }])
    expect(diagram.cellOutline(1, { bounds: box })).toEqual([])
    expect([outlineArea([]), outlinePerimeter([]), outlineCentroid([])]).toEqual([0, 0, { x: 0, y: 0 }])
  })

  it('is none of what is no circle, and of a hidden one empty', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 1, 5, 0, 1, 2, 7, 1))
    for (const i of [-1, 3, 99]) {
      expect(diagram.cell(i)).toBeUndefined()
      const asks = [
        () => diagram.neighbors(i),
        () => diagram.contains(i, 0, 0),
        () => diagram.cellPath(i),
        () => diagram.cellPolygon(i),
        () => diagram.cellArea(i),
      ]
      for (const ask of asks) {
        expect(ask).toThrow(expect.objectContaining({ code: 'badInput' }))
      }
    }
    const nested = library.compute(Float64Array.of(0, 0, 5, 1, 0, 1))
    expect(nested.neighbors(1)).toHaveLength(0)
    expect(nested.contains(1, 1, 0)).toBe(false)
    expect([nested.cellPath(1), nested.cellPolygon(1), nested.cellArea(1)]).toEqual(['', undefined, 0])
  })

  it('has two loops where a box cuts the cell apart', () => {
    // The branch bends around the small circle: a box above its apex sees the large circle's cell on both sides of it.
    const diagram = library.compute(Float64Array.of(0, 0, 10, 0, 10.6, 0.1))
    const box = { minX: -8, minY: 10.5, maxX: 8, maxY: 14 }
    expect(diagram.cellOutline(0, { bounds: box })).toHaveLength(2)
    expect(diagram.cellOutline(1, { bounds: { ...box, minY: 10.3 } })).toHaveLength(1)
    expect(
      outlineArea(diagram.cellOutline(0, { bounds: box })) + outlineArea(diagram.cellOutline(1, { bounds: box })),
    ).toBeCloseTo(56, 11)
  })

  it('has an edge that bulges into the region from both ends outside', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 2, 4, 0, 0, 4, 6, 0, 4, -6, 0))
    const edge = [...Array(diagram.edges.length / 4).keys()].find((e) => {
      const { left, right } = edgeAt(diagram, e)
      return Math.max(left, right) === 1
    }) as number
    const curve = edgeCurve(diagram, edge)
    for (const end of [curve.start, curve.end]) expect(end?.x).toBeGreaterThan(3.05)
    expect(clipCurve(curve, { bounds: { minX: -9, minY: -9, maxX: 3.05, maxY: 9 } })).toHaveLength(1)
  })

  it('does not contain what is nearer to one beyond a neighbor that is equally near up to rounding', () => {
    const far = 2 ** 94
    const narrow = [-1.984375 * 2 ** 82, 0, 2 ** -63]
    const circles = [[2, -far, far], [0, 1.625 * 2 ** 95, 1], [0, 1.5 * 2 ** 58, 0], [-128, 0, 0], narrow]
    const diagram = library.compute(Float64Array.from(circles.flat()))
    expect([0, 1, 2, 3, 4].filter((i) => diagram.contains(i, -(2 ** 92), 1.140625 * 2 ** 122))).toEqual([1])
  })

  it('contains no place that is not a number, and none at infinity', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 1, 4, 0, 1, 0, 4, 1))
    for (const x of [Number.NaN, Number.POSITIVE_INFINITY]) {
      expect([0, 1, 2].filter((i) => diagram.contains(i, x, 0))).toEqual([])
    }
  })

  it('contains a place that is as near to another', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 1, 4, 0, 1, 0, 4, 1, 4, 4, 1))
    for (const [x, y, near] of [
      [2, 0, [0, 1]],
      [0, 2, [0, 2]],
      [2, 9, [2, 3]],
      [2, 2, [0, 1, 2, 3]],
    ] as const) {
      expect([0, 1, 2, 3].filter((i) => diagram.contains(i, x, y))).toEqual(near)
    }
  })

  it('as one polygon has the area of all its loops', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 10, 0, 10.6, 0.1))
    const bounds = { minX: -8, minY: 10.5, maxX: 8, maxY: 14 }
    const ring = (diagram.cellPolygon(0, { bounds, tolerance: 1e-9 }) as Polygon).map(([x, y]) => ({ x, y }))
    expect(doubleArea(ring) / 2).toBeCloseTo(diagram.cellArea(0, { bounds }), 6)
  })

  it('bears a boundary along an edge, or touching one', () => {
    const square = library.compute(Float64Array.of(0, 0, 0.5, 2, 0, 0.5, 0, 2, 0.5, 2, 2, 0.5))
    for (const [minX, minY, maxX, maxY] of [
      [0, 0, 1, 1],
      [0, 0, 1, 2],
      [-1, -1, 1, 3],
      [1, 1, 2, 2],
    ] as const) {
      expectPartition(square, { minX, minY, maxX, maxY })
    }
    expect(outlineArea(square.cellOutline(3, { bounds: { minX: 1, minY: 1, maxX: 2, maxY: 2 } }))).toBe(1)
    const touching = library.compute(Float64Array.of(1, 3, 0, 1, 0, 1)) // The apex of their edge is (1, 2).
    for (const [minX, minY, maxX, maxY] of [
      [1, 0, 3, 2],
      [0, 0, 2, 2],
      [0, 2, 2, 3],
      [-1, 1, 1, 2],
    ] as const) {
      expectPartition(touching, { minX, minY, maxX, maxY })
    }
  })

  it('of the bronze filter: all cells fill its box', () => {
    const circles = dataSet('bronzefilter')
    const diagram = library.compute(circles)
    const box = boxAround(circles, 0.01)
    expectPartition(diagram, box)
    for (let i = 0; i < circles.length / 3; i++) {
      expect(outlineArea(diagram.cellOutline(i, { bounds: box })) > 0).toBe(diagram.cell(i) !== undefined)
    }
  })

  it('fills a box whose corner has all other cells', () => {
    const tiny = -300 * 2 ** -68
    const tinier = [-300 * 2 ** -96, 160 * 2 ** -98]
    const diagram = library.compute(Float64Array.of(9, 0, 0, 0, 0, 0, tiny, tiny, 0, ...tinier, 0))
    expectPartition(diagram, { minX: -2.9e28, minY: -2.2e28, maxX: 0, maxY: 0 })
  })

  it('fills a box whose edge ends so far out that its vertex hides on which side of the axis', () => {
    const huge = 508 * 2 ** 67
    const first = [-1.5 * 2 ** 95, 1.125 * 2 ** 60, 0, 2, 1.5 * 2 ** -92, 0, 1.84375 * 2 ** -26, -huge, huge]
    const others = [2, 1.5 * 2 ** -36, 0, 2 ** 61, 1.5 * 2 ** -32, 2 ** -40]
    const diagram = library.compute(Float64Array.of(...first, ...others))
    const [minX, minY, maxX, maxY] = [-0x1a668, -0x1a666, 0x1a664, 0x1a667].map((number) => number * 2 ** 83)
    expectPartition(diagram, { minX, minY, maxX, maxY } as Box)
  })

  it('has its centroid in the box, if it is a needle', () => {
    // Its two curves are far longer than their ends are apart.
    const huge = 2 ** 94
    const thin = [-66, -(2 ** -90), 1.25 * 2 ** -88]
    const diagram = library.compute(Float64Array.of(2, -huge, huge, ...thin, -1.28125 * 2 ** 81, 38, 4))
    const { x, y } = diagram.cellCentroid(1, { bounds: [-1e30, -3e29, 1e30, 1e30] }) as Point
    expect(Math.abs(x)).toBeLessThan(1e30)
    expect(y).toBeGreaterThanOrEqual(0)
    expect(y).toBeLessThanOrEqual(1e30)
  })

  it.each([
    ['left', [3, -9, 9, 9]],
    ['right', [-9, -9, 3, 9]],
    ['below', [-9, 3, 9, 9]],
    ['above', [-9, -9, 9, 3]],
    ['below and left', [3, 3, 9, 9]],
    ['above and right', [-9, -9, 3, 3]],
  ] satisfies readonly [string, [number, number, number, number]][])(
    'has no centroid and no polygon if the cell touches the bounds from %s, as in a region',
    (_, bounds) => {
      const diagram = library.compute([0, 6].flatMap((x) => [0, 6].map((y) => [x, y, 1])))
      const areas = diagram.cellAreas({ bounds })
      expect(areas.some((area) => area === 0)).toBe(true)
      for (const limits of [{ bounds }, { region: region([box(...bounds)]) }]) {
        const centroids = diagram.cellCentroids(limits)
        areas.forEach((area, i) => {
          const centroid = diagram.cellCentroid(i, limits)
          const polygon = diagram.cellPolygon(i, limits as { bounds: typeof bounds })
          expect([centroid !== undefined, polygon !== undefined]).toEqual([area > 0, area > 0])
          expect(Number.isNaN(centroids[2 * i])).toBe(area === 0)
        })
      }
    },
  )

  it('is empty if the cell touches the box in its vertex alone', () => {
    const size = 2 ** 94
    const far = [-1.09375 * 2 ** -74, -2.1875 * size, 58]
    const diagram = library.compute(Float64Array.of(0, 0, 0, 0, 2 ** -10, 1, ...far, 15, 0.9375, 7))
    const bounds = { minX: -1.3125 * size, minY: -3.5 * size, maxX: 1.09375 * size, maxY: -1.09375 * size }
    expect(diagram.cellCentroid(1, { bounds })).toBeUndefined()
  })

  it('fills a box with a side on its edge to a circle far away', () => {
    const far = 356 * 2 ** 86
    const diagram = library.compute(Float64Array.of(far, 0, 1.25 * 2 ** 30, -296 * 2 ** 17, -(2 ** 28), 8, 0, 0, 8))
    expectPartition(diagram, { minX: -1.2 * far, minY: -1.2 * far, maxX: far / 2, maxY: far / 2 })
  })
})

describe('clip', () => {
  it('leaves what is inside, all of it and nothing else', () => {
    fc.assert(
      fc.property(anyCircles, turns, unit, (circles, corners, size) => {
        const diagram = library.compute(circles)
        const whole = boxAround(circles, 0.25)
        const region = polygonIn(whole, corners, size)
        const extent = whole.maxX - whole.minX
        const depth = (point: Point) => depthIn(region, point)
        for (let e = 0; e < diagram.edges.length / 4; e++) {
          const curve = edgeCurve(diagram, e)
          const pieces = clipCurve(curve, { bounds: region })
          for (const piece of pieces) {
            expect(depth(piece.start)).toBeGreaterThan(-1e-11 * extent)
            expect(depth(piece.end)).toBeGreaterThan(-1e-11 * extent)
          }
          const [from, to] = [Math.max(curve.from, 1e-4), Math.min(curve.to, 1e4)]
          for (let k = 0; k <= 20; k++) {
            const s = Math.min(from * (to / from) ** (k / 20), to)
            const inside = depth(pointAt(curve.bisector, s))
            if (Math.abs(inside) < 1e-9 * extent) continue
            expect(pieces.some((piece) => piece.from <= s && s <= piece.to)).toBe(inside > 0)
          }
        }
      }),
    )
  })

  it('leaves an edge in one piece that begins or ends on a side', () => {
    // The vertex is the middle of the longest side of a right triangle, and the tip of the edge that begins there.
    const diagram = library.compute(Float64Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0))
    const e = [0, 1, 2].find((e) => edgeAt(diagram, e).left + edgeAt(diagram, e).right === 3) as number
    const curve = edgeCurve(diagram, e)
    for (const given of [curve, reversed(curve)]) {
      const pieces = clipCurve(given, { bounds: { minX: 1, minY: 0, maxX: 3, maxY: 4 } })
      expect(pieces).toHaveLength(1)
      const xs = pieces.flatMap(({ start, end }) => [start.x, end.x]).sort()
      expect(xs[0]).toBeCloseTo(1, 12)
      expect(xs[1]).toBeCloseTo(3, 12)
      expect(clipCurve(given, { bounds: { minX: -1, minY: -1, maxX: 1, maxY: 4 } })).toEqual([])
    }
  })

  it('cuts an arc that leaves and comes back into two', () => {
    const diagram = library.compute(Float64Array.of(-2, 0, 1, 2, 0, 0))
    const pieces = clipCurve(edgeCurve(diagram, 0), { bounds: { minX: 1, minY: -9, maxX: 9, maxY: 9 } })
    expect(pieces).toHaveLength(2)
    expect(pieces.map(({ start, end }) => [start.x, end.x].some((x) => x === 1))).toEqual([true, true])
  })
})

describe('a convex polygon', () => {
  const corner = (x: number, y: number) => ({ x, y })

  it('has an area, a middle, a box, and points that it contains', () => {
    const polygon = ConvexPolygon.from([corner(0, 0), corner(4, 0), corner(4, 2), corner(2, 2), corner(0, 2)])
    expect(polygon.area()).toBe(8)
    expect(polygon.middle().x).toBe(2)
    expect(polygon.middle().y).toBeCloseTo(1.2, 14)
    expect(polygon.box).toEqual({ minX: 0, minY: 0, maxX: 4, maxY: 2 })
    expect(polygon.contains(corner(4, 1))).toBe(true)
    expect(polygon.contains(corner(4.1, 1))).toBe(false)
  })

  it.each([
    ['two corners', [corner(0, 0), corner(1, 0)]],
    ['a corner at infinity', [corner(0, 0), corner(1, 0), corner(Number.POSITIVE_INFINITY, 1)]],
    ['equal corners in a row', [corner(0, 0), corner(1, 0), corner(1, 0), corner(0, 1)]],
    ['clockwise corners', [corner(0, 0), corner(0, 1), corner(1, 0)]],
    ['a dent', [corner(0, 0), corner(4, 0), corner(1, 1), corner(0, 4)]],
    ['no area', [corner(0, 0), corner(1, 0), corner(0, 0), corner(-1, 0)]],
    ['two turns', [0, 2, 4, 1, 3].map((k) => corner(Math.cos(0.4 * Math.PI * k), Math.sin(0.4 * Math.PI * k)))],
  ])('refuses %s', (__, corners) => {
    expect(() => ConvexPolygon.from(corners)).toThrow(expect.objectContaining({ code: 'badOption', circle: undefined }))
  })
})

describe('of equal radii, as d3-delaunay', () => {
  const random = seededRandom(5)
  const points = Array.from({ length: 300 }, () => [random() * 100, random() * 100] as const)
  const diagram = library.compute(points.map(([x, y]) => ({ x, y, r: 0.2 })))
  const delaunay = Delaunay.from(points)
  const box = { minX: -10, minY: -20, maxX: 110, maxY: 102 }
  const voronoi = delaunay.voronoi([box.minX, box.minY, box.maxX, box.maxY])

  it('neighbors are the same, in the same turn', () => {
    points.forEach((_, i) => {
      const theirs = [...delaunay.neighbors(i)]
      const ours = [...diagram.neighbors(i)]
      expect([...ours].sort()).toEqual([...theirs].sort())
      const start = ours.indexOf(theirs[0] as number)
      const turned = [...ours.slice(start), ...ours.slice(0, start)]
      if (diagram.cell(i)?.isBounded) expect(turned).toEqual(theirs)
    })
  })

  it('cells are the same polygons', () => {
    points.forEach((_, i) => {
      const polygon = (voronoi.cellPolygon(i) as [number, number][]).slice(1).map(([x, y]) => ({ x, y }))
      const parts = diagram.cellOutline(i, { bounds: box })
      expect(outlineArea(parts)).toBeCloseTo(Math.abs(doubleArea(polygon)) / 2, 7)
      const corners = parts.flat().map(({ curve }) => curve.start)
      for (const { x, y } of polygon) {
        expect(Math.min(...corners.map((corner) => Math.hypot(corner.x - x, corner.y - y)))).toBeLessThan(1e-7)
      }
    })
  })

  it('polygons, triangles and half-edges are those of the same names', () => {
    const bounds = [box.minX, box.minY, box.maxX, box.maxY] as const
    const polygons = [...diagram.cellPolygons({ bounds })]
    expect(polygons.map(({ index }) => index)).toEqual(points.map((_, i) => i))
    polygons.forEach((polygon, i) => {
      expect(polygon).toEqual(Object.assign(diagram.cellPolygon(i, { bounds }) as Polygon, { index: i }))
      expect(polygon.at(-1)).toEqual(polygon[0])
      const ring = polygon.slice(1).map(([x, y]) => ({ x, y }))
      expect(doubleArea(ring) / 2).toBeCloseTo(diagram.cellArea(i, { bounds }), 9)
      const theirs = voronoi.cellPolygon(i) as [number, number][]
      const lengthOf = (list: readonly (readonly number[])[]) =>
        list.slice(1).reduce((sum, [x, y], k) => {
          const [fromX, fromY] = list[k] as [number, number]
          return sum + Math.hypot((x as number) - fromX, (y as number) - fromY)
        }, 0)
      expect(diagram.cellPerimeter(i, { bounds })).toBeCloseTo(lengthOf(theirs), 7)
    })
    const triangleSet = (triangles: ArrayLike<number>) =>
      Array.from({ length: triangles.length / 3 }, (_, t) =>
        [0, 1, 2]
          .map((k) => triangles[3 * t + k] as number)
          .sort((a, b) => a - b)
          .join(),
      ).sort()
    expect(triangleSet(diagram.triangles)).toEqual(triangleSet(delaunay.triangles))
    const { triangles, halfedges } = diagram
    expect([...halfedges].filter((h) => h === NONE)).toHaveLength(diagram.hull.length)
    halfedges.forEach((t, h) => {
      if (t === NONE) return
      const next = (edge: number) => (edge % 3 === 2 ? edge - 2 : edge + 1)
      expect([halfedges[t], triangles[t], triangles[next(t)]]).toEqual([h, triangles[next(h)], triangles[h]])
    })
    expect(diagram.renderBounds({ bounds })).toBe('M-10,-20L110,-20L110,102L-10,102Z')
  })

  it('for all cells is for each', () => {
    const each = <Value>(ask: (i: number) => Value) => points.map((_, i) => ask(i))
    expect([...diagram.cellAreas()]).toEqual(each((i) => diagram.cellArea(i)))
    expect([...diagram.cellPerimeters()]).toEqual(each((i) => diagram.cellPerimeter(i)))
    const none = { x: Number.NaN, y: Number.NaN }
    const centroids = each((i) => diagram.cellCentroid(i) ?? none)
    expect([...diagram.cellCentroids()]).toEqual(centroids.flatMap(({ x, y }) => [x, y]))
  })

  it('without limits are measured whole, and drawn in the export box', () => {
    let [outside, unbounded] = [0, 0]
    const { minX, minY, maxX, maxY } = diagram.exportBox()
    const bounds = [minX, minY, maxX, maxY] as const
    const around = [-1e4, -1e4, 1e4, 1e4] as const
    const areas = diagram.cellAreas()
    areas.forEach((area, i) => {
      expect(diagram.cellPath(i)).toBe(diagram.cellPath(i, { bounds }))
      expect(diagram.cellPolygon(i)).toEqual(diagram.cellPolygon(i, { bounds }))
      const isBounded = diagram.cells.isBounded(i)
      expect(area < Number.POSITIVE_INFINITY).toBe(isBounded)
      expect(diagram.cellPerimeter(i) < Number.POSITIVE_INFINITY).toBe(isBounded)
      expect(diagram.cellCentroid(i) !== undefined).toBe(isBounded)
      if (!isBounded) unbounded += 1
      else if (Math.abs(diagram.cells.reach(i)) < 1e3) {
        expect(area).toBeCloseTo(diagram.cellArea(i, { bounds: around }), 6)
        if (area > diagram.cellArea(i, { bounds }) + 1e-3) outside += 1
      }
      expect(diagram.cellArea(i, { maxDistance: 1 })).toBeLessThan(Number.POSITIVE_INFINITY)
    })
    expect(unbounded).toBe(diagram.hull.length)
    expect(outside).toBeGreaterThan(0)
    const grown = diagram.exportBox({ maxDistance: 40 })
    expect(grown.minX).toBeLessThan(minX - 40)
  })

  it('find and contains give the same circle', () => {
    for (let k = 0; k < 1000; k++) {
      const { x, y } = pointIn(box, random(), random())
      const found = diagram.find(x, y)
      expect(found).toBe(delaunay.find(x, y))
      expect(diagram.contains(found, x, y)).toBe(true)
    }
  })
})
