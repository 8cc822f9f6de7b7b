// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import type { Point } from '../../web/lib/index.ts'
import { FrameSink } from '../../web/view/painter/frame-sink.ts'
import { seededRandom } from './library.ts'
import { windingOf } from './recording-sink.ts'

const FRAME = { x: 0, y: 0, scale: 1, width: 400, height: 300 }
/** Browsers draw curves with coordinates up to this quickly, in pixels. */
const QUICK = 150_000

type Curve = readonly [Point, Point, Point, Point]

function pointOn([a, b, c, d]: Curve, t: number): Point {
  const s = 1 - t
  const [wa, wb, wc, wd] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t]
  return { x: wa * a.x + wb * b.x + wc * c.x + wd * d.x, y: wa * a.y + wb * b.y + wc * c.y + wd * d.y }
}

/** Flattens a loop of curves to points, `count` for each curve. */
function chordsOf(curves: readonly Curve[], count: number): Point[] {
  return curves.flatMap((curve) => Array.from({ length: count }, (_, k) => pointOn(curve, k / count)))
}

/**
 * Draws a closed loop of curves in the frame. Returns the drawn curves, with lines as curves, and the largest
 * coordinate.
 */
function drawn(curves: readonly Curve[]) {
  const out: Curve[] = []
  let start: Point = { x: 0, y: 0 }
  let at = start
  const curveTo = (b: Point, c: Point, d: Point) => {
    out.push([at, b, c, d])
    at = d
  }
  const sink = new FrameSink(FRAME, {
    moveTo(x, y) {
      start = at = { x, y }
    },
    lineTo: (x, y) => curveTo(at, { x, y }, { x, y }),
    bezierCurveTo: (x1, y1, x2, y2, x, y) => curveTo({ x: x1, y: y1 }, { x: x2, y: y2 }, { x, y }),
    arc() {},
    closePath: () => curveTo(at, start, start),
  })
  const toPlane = ({ x, y }: Point) => [x - FRAME.width / 2, FRAME.height / 2 - y] as const
  sink.moveTo(...toPlane((curves[0] as Curve)[0]))
  // `closePath` draws the last curve if it is straight.
  curves.forEach(([a, b, c, d], k) => {
    const isLine = a === b && c === d
    if (isLine && k === curves.length - 1) sink.closePath()
    else if (isLine) sink.lineTo(...toPlane(d))
    else sink.bezierCurveTo(...toPlane(b), ...toPlane(c), ...toPlane(d))
  })
  const largest = Math.max(...out.flat().flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]))
  return { out, largest }
}

describe('a path in a frame', () => {
  const random = seededRandom(2)
  const within = (least: number, most: number) => least + (most - least) * random()

  it('is cut to what is near, and fills the same pixels', () => {
    let inside = 0
    let cut = 0
    for (let round = 0; round < 80; round++) {
      const size = 10 ** within(2, 6.5)
      const corner = () => ({ x: 200 + within(-size, size), y: 150 + within(-size, size) })
      const corners = Array.from({ length: 3 + Math.floor(within(0, 4)) }, corner)
      const curves = corners.map((a, k): Curve => {
        const d = corners[(k + 1) % corners.length] as Point
        return random() < 0.5 ? [a, a, d, d] : [a, corner(), corner(), d]
      })
      const { out, largest } = drawn(curves)
      expect(largest).toBeLessThan(QUICK)
      if (out.length > curves.length) cut += 1
      const [whole, near] = [chordsOf(curves, 2000), chordsOf(out, 400)]
      for (let k = 0; k < 5; k++) {
        const pixel = { x: within(0, 400), y: within(0, 300) }
        const winding = windingOf(whole, pixel)
        if (winding !== 0) inside += 1
        expect(windingOf(near, pixel), `round ${round}`).toBe(winding)
      }
    }
    expect([cut > 15, inside > 25]).toEqual([true, true])
  })

  it('is unchanged if all of it is near', () => {
    const curve: Curve = [
      { x: 10, y: 20 },
      { x: 500, y: -90 },
      { x: -30, y: 200 },
      { x: 60, y: 70 },
    ]
    expect(drawn([curve]).out).toEqual([curve])
  })

  it('ends for any numbers', () => {
    for (const far of [1e300, Number.MAX_VALUE, Number.POSITIVE_INFINITY, Number.NaN]) {
      const ends = [-far, far].map((x) => ({ x, y: x / 3 })) as [Point, Point]
      const { out } = drawn([[ends[0], { x: far, y: -far }, { x: -far, y: far }, ends[1]]])
      expect(out.length).toBeLessThan(10_000)
    }
  })

  it('has arcs in pixels, which turn the other way because y points down, and lines on from their ends', () => {
    const calls: unknown[][] = []
    const path = Object.fromEntries(
      ['moveTo', 'lineTo', 'bezierCurveTo', 'arc', 'closePath'].map((name) => [
        name,
        (...args: unknown[]) =>
          calls.push([name, ...args.map((arg) => (typeof arg === 'number' ? Math.round(1e6 * arg) / 1e6 : arg))]),
      ]),
    )
    const sink = new FrameSink({ x: 10, y: 20, scale: 2, width: 400, height: 300 }, path as never)
    sink.moveTo(13, 20)
    sink.arc(10, 20, 3, 0, Math.PI / 2, true)
    sink.closePath()
    sink.moveTo(13, 20)
    sink.arc(10, 20, 3, 0, Math.PI / 2)
    sink.arc(10, 20, 3, Math.PI / 2, 2 * Math.PI, true)
    sink.closePath()
    const turn = -Math.round((1e6 * Math.PI) / 2) / 1e6
    expect(calls).toEqual([
      ['moveTo', 206, 150],
      ['arc', 200, 150, 6, -0, turn, false],
      ['closePath'],
      ['moveTo', 206, 150],
      ['arc', 200, 150, 6, -0, turn, true],
      ['arc', 200, 150, 6, turn, -Math.round(2e6 * Math.PI) / 1e6, false],
      ['closePath'],
    ])
    // The side from an arc that ended far away to the start is cut to what is near.
    calls.length = 0
    sink.moveTo(13, 20)
    sink.arc(10, 20, 1e6, 0, Math.PI / 2)
    sink.closePath()
    expect(calls.slice(0, 2).map(([name]) => name)).toEqual(['moveTo', 'arc'])
    expect(calls.length).toBeGreaterThan(3)
    expect(calls.at(-2)?.slice(-2)).toEqual([206, 150])
  })
})
