// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { bezierPointAt } from '../../web/lib/curves/bezier.ts'
import { carlson } from '../../web/lib/curves/carlson.ts'
import { reversed, segment } from '../../web/lib/curves/curve.ts'
import {
  type BoundedCurve,
  bisector,
  type CubicBezier,
  cubicBeziers,
  edgeCurve,
  isBoundedCurve,
  type Point,
  parameterAt,
  pointAt,
  polyline,
  rationalBezier,
  traceArc,
} from '../../web/lib/index.ts'
import { curveLength } from '../../web/lib/regions/measure.ts'
import { anyCircles, circlePair, unit } from './arbitrary-circles.ts'
import { library } from './library.ts'
import { distanceFromArc, scaleOf, signedDistance } from './oracle.ts'
import { RecordingSink } from './recording-sink.ts'
import { tuple } from './tuples.ts'

const parameter = fc.double({ min: -7, max: 7, noNaN: true }).map((t) => Math.exp(t))
const tolerances = fc.constantFrom(1, 0.1, 1e-2, 1e-4, 1e-6)

function arcOf(circles: Float64Array, one: number, other: number): BoundedCurve {
  const branch = bisector(circles, 0, 1)
  const [from, to] = [Math.min(one, other), Math.max(one, other)]
  return { bisector: branch, from, to, start: pointAt(branch, from), end: pointAt(branch, to) }
}

const arc = fc.tuple(circlePair, parameter, parameter).map(([circles, one, other]) => ({
  circles,
  curve: arcOf(circles, one, other),
}))

/** The difference of a point's distances from two circles, relative to the largest number involved. */
function residual(circles: Float64Array, left: number, right: number, point: Point): number {
  const scale = Math.max(scaleOf(circles), Math.abs(point.x), Math.abs(point.y))
  return Math.abs(signedDistance(circles, left, point) - signedDistance(circles, right, point)) / scale
}

function cubicPointAt({ start, control1, control2, end }: CubicBezier, u: number): Point {
  const weights = [(1 - u) ** 3, 3 * (1 - u) ** 2 * u, 3 * (1 - u) * u ** 2, u ** 3] as const
  const mix = (a: number, b: number, c: number, d: number) =>
    weights[0] * a + weights[1] * b + weights[2] * c + weights[3] * d
  return { x: mix(start.x, control1.x, control2.x, end.x), y: mix(start.y, control1.y, control2.y, end.y) }
}

const SHARES = Array.from({ length: 17 }, (_, k) => k / 16)

describe('bisector', () => {
  it('is at the same distance from both circles at every parameter', () => {
    fc.assert(
      fc.property(circlePair, parameter, (circles, s) => {
        expect(residual(circles, 0, 1, pointAt(bisector(circles, 0, 1), s))).toBeLessThan(1e-12)
      }),
    )
  })

  it('gives back the parameter of its points', () => {
    fc.assert(
      fc.property(circlePair, parameter, (circles, s) => {
        const branch = bisector(circles, 0, 1)
        const { x, y } = pointAt(branch, s)
        const again = pointAt(branch, parameterAt(branch, x, y))
        expect(Math.hypot(again.x - x, again.y - y)).toBeLessThan(1e-10 * Math.max(scaleOf(circles), Math.hypot(x, y)))
      }),
    )
  })

  it('is finite where two circles touch from inside up to rounding', () => {
    const branch = bisector(Float64Array.of(0, 0, 1, 0.5, 0, 0.5), 0, 1)
    expect(branch.b).toBeGreaterThan(0)
    expect(Number.isFinite(parameterAt(branch, 2, 0))).toBe(true)
  })

  it('has parameters for vertices as far from circles as any, and circles as near to each other as any', () => {
    const step = 2 ** -96
    const pairs = [
      [0, 0, 0, step, 0, 0],
      [0, 0, step, 2 * step, 0, 0],
      [0, 0, 2 ** 30 * step, 2 ** 30 * step, step, 0],
    ]
    for (const pair of pairs) {
      const branch = bisector(Float64Array.from(pair), 0, 1)
      for (const distance of [2 ** 100, 2 ** 876]) {
        const s = distance / (branch.apex + Math.abs(branch.a))
        for (const parameter of [s, 1 / s]) {
          const { x, y } = pointAt(branch, parameter)
          expect(Math.hypot(x, y) / distance).toBeCloseTo(0.5, 9)
          expect(parameterAt(branch, x, y) / parameter).toBeCloseTo(1, 9)
        }
      }
    }
  })

  it('tells the sides of a needle thinner than rounding apart', () => {
    for (const scale of [2 ** -6, 1, 2 ** 90]) {
      const branch = bisector(Float64Array.of(-(2 ** -90) * scale, 0, scale, scale, 0, 0), 0, 1)
      for (const side of [-1, 1]) {
        const p = { x: 50 * scale, y: side * 2 ** -43 * scale }
        const s = parameterAt(branch, p.x, p.y)
        expect(Math.sign(s - 1)).toBe(Math.sign(pointAt(branch, 2).y) * side)
        expect(pointAt(branch, s).x / p.x).toBeCloseTo(1, 12)
      }
    }
  })
})

/** Twice the area of a triangle; positive if r lies on the left of the line from p to q. */
function turnOf(p: Point, q: Point, r: Point): number {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)
}

describe('edgeCurve', () => {
  it('lies between the two circles of its edge and ends in its vertices', () => {
    fc.assert(
      fc.property(anyCircles, unit, (circles, share) => {
        const diagram = library.compute(circles)
        for (let e = 0; e < diagram.edges.length / 4; e++) {
          const [left, right, start, end] = tuple(diagram.edges, 4 * e, 4)
          const curve = edgeCurve(diagram, e)
          const vertex = (v: number) =>
            v === -1 ? undefined : { x: diagram.vertices[3 * v], y: diagram.vertices[3 * v + 1] }
          expect(curve.start).toEqual(vertex(start as number))
          expect(curve.end).toEqual(vertex(end as number))
          expect(curve.from).toBeLessThanOrEqual(curve.to)
          const [from, to] = [Math.max(curve.from, 1e-3), Math.min(curve.to, 1e3)]
          const point = pointAt(curve.bisector, from * (to / from) ** share)
          expect(residual(circles, left as number, right as number, point)).toBeLessThan(1e-11)
        }
      }),
    )
  })

  it('runs the other way when reversed', () => {
    fc.assert(
      fc.property(arc, unit, ({ curve }, share) => {
        const back = reversed(curve)
        expect([back.start, back.end]).toEqual([curve.end, curve.start])
        const s = curve.from * (curve.to / curve.from) ** share
        const [p, q] = [pointAt(curve.bisector, s), pointAt(back.bisector, 1 / s)]
        expect(Math.hypot(p.x - q.x, p.y - q.y)).toBeLessThan(1e-12 * (1 + Math.hypot(p.x, p.y)))
      }),
    )
    const unbounded = edgeCurve(library.compute(Float64Array.of(0, 0, 1, 5, 0, 2)), 0)
    expect(isBoundedCurve(unbounded)).toBe(false)
    expect(reversed(unbounded)).toMatchObject({ from: 0, to: Number.POSITIVE_INFINITY })
  })

  it('may be a segment', () => {
    const curve = segment({ x: 1, y: 2 }, { x: 4, y: 6 })
    for (const [s, x, y] of [
      [curve.from, 1, 2],
      [1, 2.5, 4],
      [curve.to, 4, 6],
    ] as const) {
      expect(pointAt(curve.bisector, s).x).toBeCloseTo(x, 14)
      expect(pointAt(curve.bisector, s).y).toBeCloseTo(y, 14)
    }
    const { left, right } = curve.bisector
    for (const { x, y } of [curve.start, curve.end]) {
      expect(Math.hypot(x - left.x, y - left.y)).toBeCloseTo(Math.hypot(x - right.x, y - right.y), 14)
    }
    expect(turnOf(curve.start, curve.end, left)).toBeGreaterThan(0)
    expect(turnOf(curve.start, curve.end, right)).toBeLessThan(0)
    expect(curveLength(curve)).toBe(5)
    expect(cubicBeziers(curve, Number.MIN_VALUE)).toHaveLength(1)
  })
})

describe('rationalBezier', () => {
  it('is at the same distance from both circles everywhere, within 1e-12 of the scale', () => {
    fc.assert(
      fc.property(arc, unit, ({ circles, curve }, u) => {
        const point = bezierPointAt(rationalBezier(curve), u)
        const scale = Math.max(...[curve.start, curve.end].flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]))
        const difference = Math.abs(signedDistance(circles, 0, point) - signedDistance(circles, 1, point))
        expect(difference).toBeLessThan(1e-12 * Math.max(scale, scaleOf(circles)))
      }),
      { numRuns: 1000 },
    )
  })
})

describe('cubicBeziers', () => {
  it('keep within the tolerance of the arc, and hang together', () => {
    fc.assert(
      fc.property(arc, tolerances, ({ curve }, tolerance) => {
        const cubics = cubicBeziers(curve, tolerance)
        const rounding = 1e-11 * Math.max(...cubics.flatMap(({ start }) => [Math.abs(start.x), Math.abs(start.y)]), 100)
        expect(cubics[0]?.start).toEqual(curve.start)
        expect(cubics.at(-1)?.end).toEqual(curve.end)
        cubics.forEach((cubic, k) => {
          expect(cubic.start).toEqual(k === 0 ? curve.start : cubics[k - 1]?.end)
          for (const u of SHARES) {
            expect(distanceFromArc(curve, cubicPointAt(cubic, u))).toBeLessThanOrEqual(tolerance + rounding)
          }
        })
      }),
    )
  })

  it('are as few as reach the tolerance, each as long as that allows', () => {
    const curve = arcOf(Float64Array.of(0, 0, 300, 500, 0, 50), 0.1, 10)
    const worst = (pieces: readonly CubicBezier[]) =>
      Math.max(...pieces.flatMap((cubic) => SHARES.map((u) => distanceFromArc(curve, cubicPointAt(cubic, u)))))
    for (const tolerance of [10, 1, 0.1, 1e-3, 1e-6]) {
      const pieces = cubicBeziers(curve, tolerance)
      const first = pieces[0] as CubicBezier
      expect(worst(pieces)).toBeLessThanOrEqual(tolerance)
      // The error bound is not too pessimistic: a first piece that is a twentieth longer clearly exceeds the tolerance.
      if (pieces.length > 1) {
        const s = parameterAt(curve.bisector, first.end.x, first.end.y)
        const longer = { ...curve, to: s * 1.5, end: pointAt(curve.bisector, s * 1.5) }
        expect(cubicBeziers(longer, tolerance).length).toBeGreaterThan(1)
        expect(worst([first])).toBeGreaterThan(tolerance / 10)
      }
    }
    expect(cubicBeziers(curve, 0.05).length).toBeLessThanOrEqual(4)
    expect(cubicBeziers(curve, 1e6)).toHaveLength(1)
  })

  it('are one straight line for equal radii', () => {
    const sink = new RecordingSink()
    const branch = bisector(Float64Array.of(0, 0, 1, 4, 0, 1), 0, 1)
    const [start, end] = [
      { x: 2, y: -3 },
      { x: 2, y: 5 },
    ]
    sink.moveTo(start.x, start.y)
    const range = { from: parameterAt(branch, 2, -3), to: parameterAt(branch, 2, 5) }
    traceArc(sink, { bisector: branch, ...range, start, end }, 1e-9)
    expect(sink.curves).toBe(0)
    expect(sink.points.at(-1)).toEqual(end)
    expect(sink.points.every(({ x }) => x === 2)).toBe(true)
  })

  it('end even if the tolerance is next to nothing', () => {
    const curve = arcOf(Float64Array.of(0, 0, 3, 5, 0, 1), 0.01, 100)
    expect(cubicBeziers(curve, Number.MIN_VALUE).length).toBeLessThan(2000)
    expect(polyline(curve, Number.MIN_VALUE).length).toBeLessThan(1e5)
    // The shortest arcs at the tips of needles, where steps are as small as rounding.
    for (const gap of [0, 1e-15, 1e-9, 1e-3]) {
      for (const length of [1e-15, 1e-12, 1e-9, 1e-6, 1e-3]) {
        for (const from of [0.5, 1 - length / 2, 1, 2]) {
          const short = arcOf(Float64Array.of(0, 0, 10, 6 + gap, 0, 4), from, from * (1 + length))
          expect(polyline(short, Number.MIN_VALUE).length).toBeLessThan(1e5)
          expect(cubicBeziers(short, Number.MIN_VALUE).length).toBeLessThan(1e4)
        }
      }
    }
  })
})

describe('polyline', () => {
  it('keeps within the tolerance of the arc, with its points on it', () => {
    fc.assert(
      fc.property(arc, fc.constantFrom(1, 0.1, 1e-2), ({ circles, curve }, tolerance) => {
        const points = polyline(curve, tolerance)
        const rounding = 1e-11 * Math.max(...points.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]), 100)
        expect(points[0]).toEqual(curve.start)
        expect(points.at(-1)).toEqual(curve.end)
        points.forEach((point, k) => {
          expect(residual(circles, 0, 1, point)).toBeLessThan(1e-12)
          const next = points[k + 1]
          if (next === undefined || k > 20) return
          for (const share of [0.25, 0.5, 0.75]) {
            const between = { x: point.x + share * (next.x - point.x), y: point.y + share * (next.y - point.y) }
            expect(distanceFromArc(curve, between)).toBeLessThanOrEqual(tolerance + rounding)
          }
        })
      }),
    )
  })

  it('has as few points as the tolerance allows: no piece could be a tenth longer', () => {
    fc.assert(
      fc.property(arc, fc.constantFrom(1, 0.1, 1e-2), ({ curve }, tolerance) => {
        const { bisector: branch, to: last } = curve
        const points = polyline(curve, tolerance)
        for (let k = 0; k < Math.min(points.length - 2, 10); k++) {
          const [p, next] = [points[k], points[k + 1]] as [Point, Point]
          const from = parameterAt(branch, p.x, p.y)
          const to = from * (parameterAt(branch, next.x, next.y) / from) ** 1.1
          // Around the apex the error is a bound only, which also keeps the tip of a needle.
          if (to >= last || (from < 1 && 1 < to)) continue
          const q = pointAt(branch, to)
          const [x, y] = [
            (q.x - p.x) / Math.hypot(q.x - p.x, q.y - p.y),
            (q.y - p.y) / Math.hypot(q.x - p.x, q.y - p.y),
          ]
          const distances = Array.from({ length: 63 }, (_, i) => {
            const between = pointAt(branch, from * (to / from) ** ((i + 1) / 64))
            return Math.abs((between.x - p.x) * y - (between.y - p.y) * x)
          })
          expect(Math.max(...distances)).toBeGreaterThan(tolerance)
        }
      }),
      { numRuns: 300 },
    )
  })
})

describe('a needle', () => {
  it('is followed to its tip, however narrow', () => {
    // The small circle almost touches the large one from inside.
    const curve = arcOf(Float64Array.of(0, 0, 10, 6.000001, 0, 4), 0.02, 2)
    const tip = pointAt(curve.bisector, 1)
    for (const tolerance of [0.1, 0.01, 1e-3]) {
      const toTip = ({ x, y }: Point) => Math.hypot(x - tip.x, y - tip.y)
      expect(curve.bisector.b).toBeLessThan(0.01)
      const nearest = polyline(curve, tolerance).map((point) => toTip(point))
      expect(Math.min(...nearest)).toBeLessThan(2 * tolerance)
      const drawn = cubicBeziers(curve, tolerance).flatMap((cubic) => SHARES.map((u) => toTip(cubicPointAt(cubic, u))))
      expect(Math.min(...drawn)).toBeLessThan(2 * tolerance)
    }
  })
})

describe('arcLength', () => {
  it('is that of many chords', () => {
    fc.assert(
      fc.property(arc, ({ curve }) => {
        const count = 1500
        const point = (k: number) => pointAt(curve.bisector, curve.from * (curve.to / curve.from) ** (k / count))
        let sum = 0
        for (let k = 0; k < count; k++) {
          const [p, q] = [point(k), point(k + 1)]
          sum += Math.hypot(q.x - p.x, q.y - p.y)
        }
        expect(Math.abs(curveLength(curve) - sum)).toBeLessThanOrEqual(1e-5 * sum + 1e-9)
      }),
      { numRuns: 30 },
    )
  })
})

it("Carlson's integrals of an arc are right to rounding, for half angles from 0.3 to nearly a quarter turn", () => {
  for (let h = 0.3; h < 1.57; h += 0.01) {
    const [sine, cosine] = [Math.sin(h), Math.cos(h)]
    const [first, second] = carlson(cosine, 1, 1)
    // DLMF 19.25: h = sin h R_F, h - sin h cos h = 2 / 3 sin^3 h R_D.
    expect(Math.abs((sine * first) / h - 1)).toBeLessThan(2e-15)
    expect(Math.abs(((2 / 3) * sine ** 3 * second) / (h - sine * cosine) - 1)).toBeLessThan(1e-14)
  }
})
