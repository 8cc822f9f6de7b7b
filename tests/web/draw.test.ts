// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { randomCircles } from '../../web/app/random-circles.ts'
import { type Box, Cells, circleAt, type Point, traceCell, traceEdge } from '../../web/lib/index.ts'
import { dataSet, library, seededRandom } from './library.ts'
import { doubleArea, RecordingSink } from './recording-sink.ts'

const SETS: readonly (readonly [string, Float64Array])[] = [
  ['bronzefilter', dataSet('bronzefilter')],
  ['spruces', dataSet('spruces')],
  ['waka', dataSet('waka')],
  ['introduction', dataSet('introduction')],
  ['random circles', randomCircles(200, seededRandom(7))],
  ['overlapping circles', randomCircles(60, seededRandom(8)).map((value, i) => (i % 3 === 2 ? 2 * value : value))],
  ['a row', Float64Array.of(0, 0, 1, 4, 0, 1, 8, 0, 1, 12, 0, 1)],
  ['a small circle near a huge one', Float64Array.of(0, 0, 1000, 1001, 0, 0.5, 3000, 10, 1)],
  ['two circles', Float64Array.of(0, 0, 3, 5, 0, 1)],
  ['one circle', Float64Array.of(0, 0, 3)],
]

function boxAround(circles: Float64Array, margin: number): Box {
  const xs = [...circles].filter((_, i) => i % 3 === 0)
  const ys = [...circles].filter((_, i) => i % 3 === 1)
  const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 1) * margin
  return {
    minX: Math.min(...xs) - size,
    minY: Math.min(...ys) - size,
    maxX: Math.max(...xs) + size,
    maxY: Math.max(...ys) + size,
  }
}

function signedDistance(circles: Float64Array, i: number, { x, y }: Point): number {
  const circle = circleAt(circles, i)
  return Math.hypot(x - circle.x, y - circle.y) - circle.r
}

describe.each(SETS)('%s', (_, circles) => {
  const diagram = library.compute(circles)
  const cells = new Cells(diagram)
  const box = boxAround(circles, 0.5)
  const size = box.maxX - box.minX
  const tolerance = 1e-6 * size
  const indices = Array.from({ length: circles.length / 3 }, (_, i) => i)

  it('draws every edge where both circles are equally near and no other is nearer', () => {
    for (let e = 0; e < diagram.edges.length / 4; e++) {
      const sink = new RecordingSink(4)
      traceEdge(sink, diagram, e, box, tolerance)
      const [left, right] = diagram.edges.subarray(4 * e, 4 * e + 2) as unknown as [number, number]
      for (const point of sink.points) {
        const distance = signedDistance(circles, left, point)
        expect(Math.abs(distance - signedDistance(circles, right, point))).toBeLessThan(4 * tolerance)
        const nearest = Math.min(...indices.map((i) => signedDistance(circles, i, point)))
        expect(distance - nearest).toBeLessThan(4 * tolerance)
      }
    }
  })

  it('draws nothing far outside the box', () => {
    const reach = 4 * (box.maxX - box.minX + box.maxY - box.minY)
    for (let e = 0; e < diagram.edges.length / 4; e++) {
      const sink = new RecordingSink(4)
      traceEdge(sink, diagram, e, box, tolerance)
      for (const { x, y } of sink.points) expect(Math.hypot(x - box.minX, y - box.minY)).toBeLessThan(reach)
    }
  })

  it('draws each cell as a counter-clockwise outline, where its own circle is the nearest', () => {
    for (const i of indices) {
      const sink = new RecordingSink(8)
      traceCell(sink, cells, i, box, tolerance)
      if (!cells.exists(i)) {
        expect(sink.strokes).toEqual([])
        continue
      }
      expect(sink.strokes).toHaveLength(1)
      expect(doubleArea(sink.points)).toBeGreaterThanOrEqual(0)
      for (const point of sink.points) {
        const nearest = Math.min(...indices.map((j) => signedDistance(circles, j, point)))
        expect(signedDistance(circles, i, point) - nearest).toBeLessThan(4 * tolerance)
      }
    }
  })

  it('covers the box with cells, and each point once', () => {
    const random = seededRandom(1)
    const outlines = indices.map((i) => {
      const sink = new RecordingSink(16)
      traceCell(sink, cells, i, box, tolerance)
      return sink.points
    })
    for (let k = 0; k < 100; k++) {
      const point = {
        x: box.minX + random() * (box.maxX - box.minX),
        y: box.minY + random() * (box.maxY - box.minY),
      }
      const distances = indices.map((i) => signedDistance(circles, i, point)).sort((one, other) => one - other)
      // The outlines are sampled: a point next to an edge may fall on the wrong side.
      if ((distances[1] ?? Number.POSITIVE_INFINITY) - (distances[0] as number) < 0.01 * size) continue
      expect(outlines.filter((outline) => isInside(outline, point))).toHaveLength(1)
    }
  })

  it('has symmetric neighbours', () => {
    for (const i of indices) for (const j of cells.neighbors(i)) expect(cells.neighbors(j)).toContain(i)
  })
})

it('draws the same curve when magnified ten million times', () => {
  const circles = dataSet('introduction')
  const diagram = library.compute(circles)
  const size = 1e-6
  for (let e = 0; e < diagram.edges.length / 4; e++) {
    const whole = new RecordingSink(3)
    traceEdge(whole, diagram, e, boxAround(circles, 0.5), 1e-12)
    for (const { x, y } of whole.points.slice(0, 40)) {
      const box = { minX: x - size, minY: y - size, maxX: x + size, maxY: y + size }
      const part = new RecordingSink(64)
      traceEdge(part, diagram, e, box, 1e-9)
      expect(Math.min(...part.strokes.map((stroke) => distanceToPolyline(stroke, { x, y })))).toBeLessThan(size / 10)
    }
  }
})

function isInside(polygon: readonly Point[], { x, y }: Point): boolean {
  let inside = false
  polygon.forEach((p, k) => {
    const q = polygon[(k + 1) % polygon.length] as Point
    if (p.y > y !== q.y > y && x < p.x + ((y - p.y) / (q.y - p.y)) * (q.x - p.x)) inside = !inside
  })
  return inside
}

function distanceToPolyline(polyline: readonly Point[], { x, y }: Point): number {
  let least = Number.POSITIVE_INFINITY
  for (let k = 1; k < polyline.length; k++) {
    const [p, q] = polyline.slice(k - 1, k + 1) as [Point, Point]
    const [dx, dy] = [q.x - p.x, q.y - p.y]
    const along = ((x - p.x) * dx + (y - p.y) * dy) / (dx * dx + dy * dy)
    const s = Math.min(Math.max(along, 0), 1)
    least = Math.min(least, Math.hypot(p.x + s * dx - x, p.y + s * dy - y))
  }
  return least
}
