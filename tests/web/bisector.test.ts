// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { bisector, parameterAt, pointAt, rangesWithin, rationalBezier, traceArc } from '../../web/lib/bisector.ts'
import { RecordingSink } from './recording-sink.ts'

/** Two circles, x, y, r each, of which neither contains the other, and how nearly one does. */
const circlePair = fc
  .record({
    x: fc.double({ min: -100, max: 100, noNaN: true }),
    y: fc.double({ min: -100, max: 100, noNaN: true }),
    angle: fc.double({ min: 0, max: 6.28, noNaN: true }),
    distance: fc.double({ min: 1e-3, max: 100, noNaN: true }),
    // (r_left - r_right) / distance, from nearly contained on one side to nearly contained on the other.
    lean: fc.oneof(fc.constant(0), fc.double({ min: -0.999, max: 0.999, noNaN: true })),
    smaller: fc.double({ min: 0, max: 50, noNaN: true }),
  })
  .map(({ x, y, angle, distance, lean, smaller }) => {
    const left = smaller + Math.max(0, lean) * distance
    const right = smaller + Math.max(0, -lean) * distance
    return Float64Array.of(x, y, left, x + distance * Math.cos(angle), y + distance * Math.sin(angle), right)
  })

const parameter = fc.double({ min: -4, max: 4, noNaN: true })

function signedDistances(circles: Float64Array, x: number, y: number): [number, number] {
  const [xl, yl, rl, xr, yr, rr] = circles as unknown as [number, number, number, number, number, number]
  return [Math.hypot(x - xl, y - yl) - rl, Math.hypot(x - xr, y - yr) - rr]
}

/** How far a point is from the bisector at most: the difference of the distances changes by at least this much. */
function distanceToBisector(circles: Float64Array, x: number, y: number): number {
  const [xl, yl, , xr, yr] = circles as unknown as [number, number, number, number, number]
  const [left, right] = signedDistances(circles, x, y)
  const toLeft = Math.hypot(x - xl, y - yl)
  const toRight = Math.hypot(x - xr, y - yr)
  const slope = Math.hypot((x - xl) / toLeft - (x - xr) / toRight, (y - yl) / toLeft - (y - yr) / toRight)
  return Math.abs(left - right) / slope
}

describe('bisector', () => {
  it('has equal signed distances to both circles at every parameter', () => {
    fc.assert(
      fc.property(circlePair, parameter, (circles, t) => {
        const { x, y } = pointAt(bisector(circles, 0, 1), t)
        const [left, right] = signedDistances(circles, x, y)
        expect(left).toBeCloseTo(right, 8)
      }),
    )
  })

  it('gives back the parameter of its points', () => {
    fc.assert(
      fc.property(circlePair, parameter, (circles, t) => {
        const curve = bisector(circles, 0, 1)
        const { x, y } = pointAt(curve, t)
        expect(parameterAt(curve, x, y)).toBeCloseTo(t, 5)
      }),
    )
  })

  it('has the left circle on its left', () => {
    const curve = bisector(Float64Array.of(-1, 0, 0, 1, 0, 0), 0, 1)
    expect(pointAt(curve, 1).y).toBeGreaterThan(pointAt(curve, -1).y)
  })

  it('bends around the smaller circle', () => {
    const curve = bisector(Float64Array.of(-2, 0, 1, 2, 0, 0), 0, 1)
    expect(pointAt(curve, 0).x).toBeCloseTo(0.5)
    expect(pointAt(curve, 2).x).toBeGreaterThan(pointAt(curve, 0).x)
    expect(pointAt(curve, -2).x).toBeGreaterThan(pointAt(curve, 0).x)
  })

  it('is finite where two circles touch from inside up to rounding', () => {
    const curve = bisector(Float64Array.of(0, 0, 1, 0.5, 0, 0.5), 0, 1)
    expect(curve.b).toBeGreaterThan(0)
    expect(Number.isFinite(parameterAt(curve, 2, 0))).toBe(true)
  })
})

describe('rationalBezier', () => {
  it('lies on the bisector everywhere', () => {
    fc.assert(
      fc.property(circlePair, parameter, parameter, fc.double({ min: 0, max: 1, noNaN: true }), (circles, t, u, s) => {
        const { start, control, end, weight } = rationalBezier(bisector(circles, 0, 1), t, u)
        const [a, b, c] = [(1 - s) ** 2, 2 * s * (1 - s) * weight, s ** 2]
        const x = (a * start.x + b * control.x + c * end.x) / (a + b + c)
        const y = (a * start.y + b * control.y + c * end.y) / (a + b + c)
        const [left, right] = signedDistances(circles, x, y)
        expect(left).toBeCloseTo(right, 8)
      }),
    )
  })
})

describe('traceArc', () => {
  const tolerances = fc.constantFrom(1, 0.1, 1e-2, 1e-4, 1e-6)

  it('stays within the tolerance, in either direction', () => {
    fc.assert(
      fc.property(circlePair, parameter, parameter, tolerances, (circles, from, to, tolerance) => {
        const curve = bisector(circles, 0, 1)
        const sink = new RecordingSink(50)
        const start = pointAt(curve, from)
        sink.moveTo(start.x, start.y)
        traceArc(sink, curve, from, to, pointAt(curve, to), tolerance)
        for (const { x, y } of sink.points) {
          expect(distanceToBisector(circles, x, y)).toBeLessThanOrEqual(1.2 * tolerance + 1e-8)
        }
      }),
      { numRuns: 300 },
    )
  })

  it('draws a straight line for equal radii', () => {
    const sink = new RecordingSink()
    const curve = bisector(Float64Array.of(0, 0, 1, 4, 0, 1), 0, 1)
    sink.moveTo(2, -3)
    traceArc(sink, curve, parameterAt(curve, 2, -3), parameterAt(curve, 2, 5), { x: 2, y: 5 }, 1e-9)
    expect(sink.curves).toBe(0)
    expect(sink.points.every(({ x }) => x === 2)).toBe(true)
  })

  it('needs few curves', () => {
    const sink = new RecordingSink()
    const curve = bisector(Float64Array.of(0, 0, 300, 500, 0, 50), 0, 1)
    const start = pointAt(curve, -2)
    sink.moveTo(start.x, start.y)
    traceArc(sink, curve, -2, 2, pointAt(curve, 2), 0.05)
    expect(sink.curves).toBeLessThanOrEqual(4)
  })

  it('ends exactly where it is told', () => {
    const sink = new RecordingSink()
    const curve = bisector(Float64Array.of(0, 0, 3, 5, 0, 1), 0, 1)
    const end = { x: pointAt(curve, 1).x + 1e-13, y: pointAt(curve, 1).y }
    sink.moveTo(pointAt(curve, 0).x, pointAt(curve, 0).y)
    traceArc(sink, curve, 0, 1, end, 1e-6)
    expect(sink.points.at(-1)).toEqual(end)
  })
})

describe('rangesWithin', () => {
  const curve = bisector(Float64Array.of(-2, 0, 1, 2, 0, 0), 0, 1)
  const all = { from: Number.NEGATIVE_INFINITY, to: Number.POSITIVE_INFINITY }
  const distanceAt = (t: number) =>
    signedDistances(Float64Array.of(-2, 0, 0, 2, 0, 0), pointAt(curve, t).x, pointAt(curve, t).y)[0]

  it('is empty where the branch does not come near', () => {
    expect(rangesWithin(curve, all, 0, 2.4)).toEqual([])
  })

  it('is one range around the apex', () => {
    const [range] = rangesWithin(curve, all, 0, 10)
    expect(distanceAt(range?.from as number)).toBeCloseTo(10)
    expect(distanceAt(range?.to as number)).toBeCloseTo(10)
  })

  it('is one range on each side of the apex beyond some distance', () => {
    const ranges = rangesWithin(curve, all, 5, 10)
    expect(ranges).toHaveLength(2)
    expect(ranges.flatMap(({ from, to }) => [distanceAt(from), distanceAt(to)].map(Math.round))).toEqual([10, 5, 5, 10])
  })

  it('keeps to the given range', () => {
    expect(rangesWithin(curve, { from: -1, to: 0.5 }, 0, 1e9)).toEqual([{ from: -1, to: 0.5 }])
  })
})
