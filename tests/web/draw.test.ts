// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { ConvexPolygon, convexHull, Diagram, edgeAt, type Point } from '../../web/lib/index.ts'
import { exportBox, exportTolerance } from '../../web/lib/regions/export-box.ts'
import { disjointCircles } from './disjoint-circles.ts'
import { dataSet, library, seededRandom } from './library.ts'
import { boxAround, leastDistance, signedDistance } from './oracle.ts'
import { doubleArea, RecordingSink, windingOf } from './recording-sink.ts'
import { tuple } from './tuples.ts'

const SETS: readonly (readonly [string, Float64Array])[] = [
  ['bronzefilter', dataSet('bronzefilter')],
  ['spruces', dataSet('spruces')],
  ['waka', dataSet('waka')],
  ['introduction', dataSet('introduction')],
  ['random circles', disjointCircles(200, seededRandom(7))],
  ['overlapping circles', disjointCircles(60, seededRandom(8)).map((value, i) => (i % 3 === 2 ? 2 * value : value))],
  ['a row', Float64Array.of(0, 0, 1, 4, 0, 1, 8, 0, 1, 12, 0, 1)],
  ['a small circle near a huge one', Float64Array.of(0, 0, 1000, 1001, 0, 0.5, 3000, 10, 1)],
  ['two circles', Float64Array.of(0, 0, 3, 5, 0, 1)],
  ['one circle', Float64Array.of(0, 0, 3)],
]

describe.each(SETS)('%s', (_, circles) => {
  const diagram = library.compute(circles)
  const box = boxAround(circles, 0.5)
  const size = box.maxX - box.minX
  const tolerance = 1e-6 * size
  const indices = Array.from({ length: circles.length / 3 }, (_, i) => i)

  it('draws every edge where both circles are equally near and no other is nearer', () => {
    for (let e = 0; e < diagram.edges.length / 4; e++) {
      const sink = new RecordingSink(4)
      diagram.edgePath(e, { context: sink, bounds: box, tolerance })
      const [left, right] = tuple(diagram.edges, 4 * e, 2)
      for (const point of sink.points) {
        const distance = signedDistance(circles, left, point)
        expect(Math.abs(distance - signedDistance(circles, right, point))).toBeLessThan(4 * tolerance)
        expect(distance - leastDistance(circles, point)).toBeLessThan(4 * tolerance)
      }
    }
  })

  it('draws nothing outside the box', () => {
    const sink = new RecordingSink(4)
    diagram.render({ context: sink, bounds: box, tolerance })
    for (const i of indices) diagram.cellPath(i, { context: sink, bounds: box, tolerance })
    for (const { x, y } of sink.points) {
      expect(Math.max(box.minX - x, x - box.maxX, box.minY - y, y - box.maxY)).toBeLessThanOrEqual(tolerance)
    }
  })

  it('draws each cell as a counter-clockwise outline, where its own circle is the nearest', () => {
    for (const i of indices) {
      const sink = new RecordingSink(8)
      diagram.cellPath(i, { context: sink, bounds: box, tolerance })
      if (diagram.cell(i) === undefined) {
        expect(sink.strokes).toEqual([])
        continue
      }
      expect(sink.strokes.length).toBeGreaterThan(0)
      for (const stroke of sink.strokes) expect(doubleArea(stroke)).toBeGreaterThanOrEqual(-1e-9 * size * size)
      const leads = sink.points.map((point) => signedDistance(circles, i, point) - leastDistance(circles, point))
      expect(Math.max(...leads)).toBeLessThan(4 * tolerance)
    }
  })

  it('covers the box with cells, and each point once', () => {
    const random = seededRandom(1)
    const outlines = indices.map((i) => {
      const sink = new RecordingSink(16)
      diagram.cellPath(i, { context: sink, bounds: box, tolerance })
      return sink.strokes
    })
    for (let k = 0; k < 100; k++) {
      const point = {
        x: box.minX + random() * (box.maxX - box.minX),
        y: box.minY + random() * (box.maxY - box.minY),
      }
      const distances = indices.map((i) => signedDistance(circles, i, point)).sort((one, other) => one - other)
      // Outlines are flattened, so that a point next to an edge may fall on the wrong side.
      if ((distances[1] ?? Number.POSITIVE_INFINITY) - (distances[0] as number) < 0.01 * size) continue
      expect(outlines.flat().filter((stroke) => windingOf(stroke, point) !== 0)).toHaveLength(1)
    }
  })
})

it('draws nothing of an arc beyond a side between its ends', () => {
  // The edge of the first two circles bends around the first one, from x = -4 past its apex at x = 0.5 and back.
  const diagram = library.compute(Float64Array.of(0, 0, 0, 10, 0, 9, -8, 0, 0))
  const e = [0, 1, 2].find((e) => edgeAt(diagram, e).left + edgeAt(diagram, e).right === 1) as number
  const reachOf = (maxX: number) => {
    const sink = new RecordingSink()
    diagram.edgePath(e, { context: sink, bounds: [-20, -30, maxX, 30] })
    return Math.max(...sink.points.map(({ x }) => x))
  }
  expect(reachOf(20)).toBeCloseTo(0.5, 2)
  expect(reachOf(0.3)).toBeLessThanOrEqual(0.3 + 1e-9)
})

it('draws the same curve when magnified ten million times', () => {
  const circles = dataSet('introduction')
  const diagram = library.compute(circles)
  const size = 1e-6
  for (let e = 0; e < diagram.edges.length / 4; e++) {
    const whole = new RecordingSink(3)
    diagram.edgePath(e, { context: whole, bounds: boxAround(circles, 0.5), tolerance: 1e-12 })
    for (const { x, y } of whole.points.slice(0, 40)) {
      const box = { minX: x - size, minY: y - size, maxX: x + size, maxY: y + size }
      const part = new RecordingSink(64)
      diagram.edgePath(e, { context: part, bounds: box, tolerance: 1e-9 })
      expect(Math.min(...part.strokes.map((stroke) => distanceToPolyline(stroke, { x, y })))).toBeLessThan(size / 10)
    }
  }
})

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

describe('an SVG path', () => {
  const circles = dataSet('introduction')
  const diagram = library.compute(circles)

  /** Replays a path with the same numbers. */
  function replayed(path: string): RecordingSink {
    const sink = new RecordingSink()
    for (const [, command, text] of path.matchAll(/([MLCZ])([^MLCZA]*)/g)) {
      const numbers = (text as string).split(/[ ,]/).filter(Boolean).map(Number)
      if (command === 'M') sink.moveTo(...(numbers as [number, number]))
      if (command === 'L') sink.lineTo(...(numbers as [number, number]))
      if (command === 'C') sink.bezierCurveTo(...(numbers as [number, number, number, number, number, number]))
      if (command === 'Z') sink.closePath()
    }
    return sink
  }

  it('says the same as a context is told', () => {
    const bounds = ConvexPolygon.of(boxAround(circles, 0.05))
    const digits = 99 // All digits.
    const all = new RecordingSink()
    diagram.render({ context: all, bounds })
    expect(replayed(diagram.render({ bounds, digits })).strokes).toEqual(all.strokes)
    for (let e = 0; e < diagram.edges.length / 4; e++) {
      const sink = new RecordingSink()
      diagram.edgePath(e, { context: sink })
      expect(replayed(diagram.edgePath(e, { digits })).strokes).toEqual(sink.strokes)
    }
    for (let i = 0; i < circles.length / 3; i++) {
      const sink = new RecordingSink()
      diagram.cellPath(i, { context: sink, bounds })
      expect(replayed(diagram.cellPath(i, { digits })).strokes).toEqual(sink.strokes)
    }
  })

  it('of one circle is the default box, with room for a twentieth', () => {
    expect(library.compute(Float64Array.of(1, 2, 10)).cellPath(0)).toBe('M-10,-9L12,-9L12,13L-10,13L-10,-9Z')
  })

  it('of points at one place is within a box around it', () => {
    expect(exportBox(Float64Array.of(3, 4, 0))).toEqual({ minX: 2, minY: 3, maxX: 4, maxY: 5 })
    expect(exportBox(new Float64Array())).toEqual({ minX: 0, minY: 0, maxX: 1, maxY: 1 })
    // A margin of a twentieth would be lost by rounding.
    const far = exportBox(Float64Array.of(1e18, 0, 1))
    expect([far.minX < 1e18 - 1, far.maxX > 1e18 + 1]).toEqual([true, true])
  })

  it('errs by a hundred-thousandth of the longer side of the box', () => {
    expect(exportTolerance({ minX: 0, minY: 0, maxX: 10, maxY: 1 })).toBeCloseTo(1e-4, 15)
    expect(exportTolerance({ minX: 0, minY: 0, maxX: 1, maxY: 10 })).toBeCloseTo(1e-4, 15)
  })

  it('of a hidden circle, or of no circles, is empty', () => {
    const nested = library.compute(Float64Array.of(0, 0, 5, 1, 0, 1))
    expect(nested.cellPath(1)).toBe('')
    expect(library.compute([]).render()).toBe('')
    expect(library.compute([]).renderHull()).toBe('')
    expect(library.compute(Float64Array.of(0, 0, 0, 6, 0, 0, 0, 8, 0)).renderHull()).toBe('M0,0L6,0L0,8Z')
  })

  it('has digits enough for a tenth of the tolerance, or as many as are asked for', () => {
    const bounds = boxAround(circles, 0.05)
    const tolerance = 1e-3 * (bounds.maxX - bounds.minX)
    const numbersOf = (path: string) => path.match(/-?[\d.]+(e[+-]?\d+)?/g) ?? []
    const exact = numbersOf(diagram.render({ bounds, tolerance, digits: 99 })).map(Number)
    const rounded = numbersOf(diagram.render({ bounds, tolerance })).map(Number)
    expect(rounded).toHaveLength(exact.length)
    for (let k = 0; k < exact.length; k += 2) {
      const moved = Math.hypot(...[k, k + 1].map((place) => (exact[place] as number) - (rounded[place] as number)))
      expect(moved).toBeLessThanOrEqual(0.1 * tolerance)
    }
    const longest = (digits: number) =>
      Math.max(0, ...numbersOf(diagram.render({ bounds, digits })).map((text) => text.split('.')[1]?.length ?? 0))
    expect(longest(0)).toBe(0)
    expect(longest(2)).toBeLessThanOrEqual(2)
  })

  it('has all digits after one with few, and whole numbers for a tolerance above 1', () => {
    const diagram = library.compute([
      [1 / 3, 0, 1],
      [6, 0, 1],
    ])
    const dual = `M${1 / 3},0L6,0`
    for (const digits of [1, undefined, 2]) {
      expect(diagram.renderDual({ digits })).toBe(digits === undefined ? dual : `M${(1 / 3).toFixed(digits)},0L6,0`)
      expect(diagram.renderDual()).toBe(dual)
    }
    const bounds = [-54321, -54321, 54321, 54321] as const
    expect(diagram.cellPath(0, { bounds, tolerance: 1000 })).toBe(
      'M-54321,-54321L3,-54321L3,54321L-54321,54321L-54321,-54321Z',
    )
  })

  it('has nothing of a drawing that an error ended', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1))
    const text = diagram.render()
    const edges = new Proxy(diagram.edges, {
      get(target, key) {
        if (key === '8') throw new RangeError('broken')
        return Reflect.get(target, key)
      },
    })
    expect(() => new Diagram({ ...diagram, edges }).render()).toThrow('broken')
    expect(diagram.render()).toBe(text)
  })

  it('draws circles, the dual and the hull', () => {
    const two = library.compute(Float64Array.of(0, 0, 1, 4, 0, 1))
    const number = '-?[0-9.e-]+'
    const disc = (right: number, left: number) =>
      `M${right},0A1,1 0 0 1 ${left},${number}A1,1 0 0 1 ${right},${number}Z`
    expect(two.renderCircles()).toMatch(new RegExp(`^${disc(1, -1)}${disc(5, 3)}$`))
    expect(two.renderDual()).toMatch(/^M[04],0L[04],0$/)
    const hull = two.renderHull()
    expect(hull.match(/A1,1 0 0 1/g)).toHaveLength(4)
    expect(hull).toMatch(/^M.*Z$/)
  })
})

describe('a hull drawn on a context', () => {
  it.each(SETS)('of %s has every circle inside', (_, circles) => {
    const diagram = library.compute(circles)
    const sink = new RecordingSink(400)
    diagram.renderHull({ context: sink })
    const box = boxAround(circles, 0)
    const size = Math.max(box.maxX - box.minX, box.maxY - box.minY)
    const [stroke] = sink.strokes as [Point[]]
    expect(sink.strokes).toHaveLength(1)
    for (let turn = 0; turn < 1; turn += 1 / 64) {
      const [x, y] = [Math.cos(2 * Math.PI * turn), Math.sin(2 * Math.PI * turn)]
      const drawn = Math.max(...stroke.map((point) => point.x * x + point.y * y))
      let reach = Number.NEGATIVE_INFINITY
      for (let i = 0; i < circles.length; i += 3) {
        const [cx, cy, r] = tuple(circles, i, 3)
        reach = Math.max(reach, cx * x + cy * y + r)
      }
      expect(Math.abs(drawn - reach)).toBeLessThan(1e-4 * size)
    }
  })
})

describe('the polygon of a hull', () => {
  const areaOf = (scale: number, tolerance?: number) => {
    const circles = Float64Array.of(0, 0, 3, 8, 1, 1, 2, 7, 0).map((value) => value * scale)
    const ring = library.compute(circles).hullPolygon({ tolerance })
    expect(ring?.at(-1)).toEqual(ring?.[0])
    return doubleArea((ring ?? []).map(([x, y]) => ({ x: x / scale, y: y / scale })).slice(1)) / 2
  }
  const { area } = convexHull(library.compute(Float64Array.of(0, 0, 3, 8, 1, 1, 2, 7, 0)))

  it.each([1, 2 ** 90, 2 ** -50])('has the area of the hull, %d times as large', (scale) => {
    expect(Math.abs(areaOf(scale) - area)).toBeLessThan(1e-2)
  })

  it('takes a tolerance that is too small as the least there is', () => {
    expect(Math.abs(areaOf(1, 1e-300) - area)).toBeLessThan(1e-6)
  })
})

it('goes to a worker and back as plain data', () => {
  const diagram = library.compute(dataSet('introduction'))
  const path = diagram.render()
  const data = structuredClone(diagram)
  expect(data).not.toBeInstanceOf(Diagram)
  expect(Object.keys(data)).toEqual([
    ...['metric', 'weights', 'circles', 'vertices', 'vertexCircles', 'edges', 'hidden', 'hull'],
    ...['nextSide', 'vertexSides', 'firstSide', 'certificate', 'stats'],
  ])
  const revived = new Diagram(data)
  expect(revived.render()).toBe(path)
  expect(revived.find(0, 0)).toBe(diagram.find(0, 0))
})

describe('a context that draws from its own callbacks', () => {
  const diagram = library.compute(disjointCircles(60, seededRandom(5)))
  const options = { bounds: boxAround(diagram.circles, 2), tolerance: 1e-9 }
  const drawn = (draw: (context: RecordingSink) => void) => {
    const sink = new RecordingSink()
    draw(sink)
    return sink
  }

  it('gets the same cells and edges, though it asks for others meanwhile', () => {
    class Asking extends RecordingSink {
      override bezierCurveTo(...args: Parameters<RecordingSink['bezierCurveTo']>): void {
        for (const other of [3, 4]) diagram.cellPath(other, { ...options, context: new RecordingSink() })
        super.bezierCurveTo(...args)
      }
    }
    for (const draw of [
      (context: RecordingSink) => diagram.cellPath(0, { ...options, context }),
      (context: RecordingSink) => diagram.render({ ...options, context }),
    ]) {
      const asking = new Asking()
      draw(asking)
      expect({ ...asking }).toEqual({ ...drawn(draw) })
    }
  })
})
