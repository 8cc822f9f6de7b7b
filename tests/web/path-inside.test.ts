import { describe, expect, it } from 'vitest'
import { type Circles, ConvexPolygon, clearestPath, type Diagram, type Point, pointAt } from '../../web/lib/index.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { library, seededRandom } from './library.ts'
import { leastDistance } from './oracle.ts'
import { box, ring } from './shapes.ts'

const { region } = await loadRegions()

/** Robots in a field, after a report about a planner whose paths left the field. */
const ROBOTS: Circles = [
  [-3, 0, 0.09],
  [-1.5, 1.2, 0.09],
  [-1.4, -1.6, 0.09],
  [0.4, 0.3, 0.09],
  [1.9, -0.7, 0.09],
  [2.6, 1.9, 0.09],
]
const FIELD = [-4, -2, 4, 2] as const
const ROOM = ring(0, 0, 6, 0, 6, 2, 2, 2, 2, 6, 0, 6)

/** Sample points along a path. */
function pointsOf(path: NonNullable<ReturnType<typeof clearestPath>>): Point[] {
  return (path.curves ?? []).flatMap((curve) => {
    const { bisector, from, to, start, end } = curve
    const between = Array.from({ length: 15 }, (_, k) =>
      bisector.a === 0
        ? { x: start.x + ((k + 1) / 16) * (end.x - start.x), y: start.y + ((k + 1) / 16) * (end.y - start.y) }
        : pointAt(bisector, from * (to / from) ** ((k + 1) / 16)),
    )
    return [start, ...between, end]
  })
}

/** The clearance of the best path between squares of a grid. */
function flooded(diagram: Diagram, contains: (p: Point) => boolean, size: number, p: Point, q: Point, count = 90) {
  const placeOf = (k: number) => ({
    x: -size + (2 * size * ((k % count) + 0.5)) / count,
    y: -size + (2 * size * (Math.floor(k / count) + 0.5)) / count,
  })
  const clearances = Array.from({ length: count * count }, (_, k) => {
    const place = placeOf(k)
    return contains(place) ? leastDistance(diagram.circles, place) : -Infinity
  })
  const nearest = (point: Point) => {
    let best = -1
    let least = Infinity
    clearances.forEach((clearance, k) => {
      const place = placeOf(k)
      const distance = Math.hypot(place.x - point.x, place.y - point.y)
      if (clearance > -Infinity && distance < least) [best, least] = [k, distance]
    })
    return best
  }
  const [from, to] = [nearest(p), nearest(q)]
  const reached = new Float64Array(count * count).fill(-Infinity)
  reached[from] = clearances[from] as number
  const pending = new Set([from])
  while (pending.size > 0) {
    const k = [...pending].reduce((one, other) => ((reached[other] as number) > (reached[one] as number) ? other : one))
    pending.delete(k)
    if (k === to) return reached[k] as number
    for (const [dx, dy] of [
      [-1, 0],
      [1, 0],
      [0, -1],
      [0, 1],
    ] as const) {
      const [column, row] = [(k % count) + dx, Math.floor(k / count) + dy]
      if (column < 0 || column >= count || row < 0 || row >= count) continue
      const next = column + count * row
      const clearance = Math.min(reached[k] as number, clearances[next] as number)
      if (!(clearance > (reached[next] as number))) continue
      reached[next] = clearance
      pending.add(next)
    }
  }
  return -Infinity
}

/** Expects a path from p to q that stays inside and has its stated clearance. */
function expectPath(
  diagram: Diagram,
  p: Point,
  q: Point,
  path: ReturnType<typeof clearestPath> | undefined,
  contains: (p: Point) => boolean,
) {
  const curves = path?.curves ?? []
  if (path === undefined || curves.length === 0) throw new Error('There is no path.')
  expect(curves[0]?.start).toEqual(p)
  expect(curves.at(-1)?.end).toEqual(q)
  curves.forEach(({ start }, k) => {
    if (k > 0) expect(start).toEqual(curves[k - 1]?.end)
  })
  const points = pointsOf(path)
  for (const { x, y } of points) {
    const isInside = [0, 1e-9, -1e-9].some((dx) => [0, 1e-9, -1e-9].some((dy) => contains({ x: x + dx, y: y + dy })))
    expect(isInside, `(${x}, ${y})`).toBe(true)
  }
  const least = Math.min(...points.map((point) => leastDistance(diagram.circles, point)))
  expect(least, JSON.stringify({ circles: [...diagram.circles], p, q })).toBeGreaterThanOrEqual(path.clearance - 1e-9)
}

describe('a clearest path in bounds', () => {
  const [minX, minY, maxX, maxY] = FIELD
  const contains = ({ x, y }: Point) => minX <= x && x <= maxX && minY <= y && y <= maxY

  it('stays in the field', () => {
    const diagram = library.compute(ROBOTS)
    const [p, q] = [
      { x: -3.8, y: 0.1 },
      { x: 3.8, y: 0.2 },
    ]
    const path = clearestPath(diagram, p, q, { bounds: FIELD })
    expectPath(diagram, p, q, path, contains)
    expect(path?.clearance).toBeCloseTo(flooded(diagram, contains, 4, p, q), 1)
    // Within a narrow strip, the path around the first robot is blocked.
    const free = clearestPath(diagram, p, q)
    const strip = [-4, -0.5, 4, 0.5] as const
    const narrow = clearestPath(diagram, p, q, { bounds: strip })
    expectPath(diagram, p, q, narrow, ({ x, y }) => Math.abs(x) <= 4 && Math.abs(y) <= 0.5)
    expect(narrow?.clearance).toBeLessThan(free.clearance)
    expect(free.curves).toBeUndefined()
  })

  it('may run along the border', () => {
    const diagram = library.compute([[0, 0, 1]])
    const bounds = [-3, -2, 3, 2] as const
    const path = clearestPath(diagram, { x: -2.5, y: 0 }, { x: 2.5, y: 0 }, { bounds })
    expect(path?.clearance).toBe(1)
    expect(path?.edges).toHaveLength(0)
    expectPath(diagram, { x: -2.5, y: 0 }, { x: 2.5, y: 0 }, path, ({ x, y }) => Math.abs(x) <= 3 && Math.abs(y) <= 2)
  })

  it('starts at a center', () => {
    const diagram = library.compute(ROBOTS)
    const q = { x: 3.8, y: 0.2 }
    for (const [x, y] of ROBOTS as [number, number, number][]) {
      const path = clearestPath(diagram, { x, y }, q, { bounds: FIELD })
      expect(path?.clearance).toBeCloseTo(-0.09, 12)
      expectPath(diagram, { x, y }, q, path, contains)
      const free = clearestPath(diagram, { x, y }, q)
      expect(free.clearance).toBeCloseTo(-0.09, 12)
      // A path that starts at the center has no direction away from it, and goes to the right.
      if (free.entry !== undefined) {
        expect(free.entry.y).toBeCloseTo(y, 12)
        expect(free.entry.x).toBeGreaterThan(x)
      }
    }
  })

  it('says what it does not take', () => {
    const diagram = library.compute(ROBOTS)
    const [p, q] = [
      { x: 0, y: 0 },
      { x: 1, y: 1 },
    ]
    const call = (options: object) => () => clearestPath(diagram, p, q, options as { bounds: typeof FIELD })
    for (const [options, code] of [
      [{ bound: FIELD }, 'badOption'],
      [{ bounds: [2, 2, 3, 3] }, 'badInput'],
      [{ bounds: FIELD, region: region([ROOM]) }, 'badOption'],
    ] as const) {
      expect(call(options)).toThrow(expect.objectContaining({ code }))
    }
  })

  it('is as clear as flooding finds', () => {
    const random = seededRandom(11)
    for (let trial = 0; trial < 25; trial++) {
      const count = 1 + Math.floor(8 * random())
      const circles = Array.from({ length: count }, () => [8 * random() - 4, 4 * random() - 2, 0.5 * random()])
      const diagram = library.compute(circles as [number, number, number][])
      const at = () => ({ x: 7.8 * random() - 3.9, y: 3.8 * random() - 1.9 })
      const [p, q] = [at(), at()]
      const path = clearestPath(diagram, p, q, { bounds: FIELD })
      expectPath(diagram, p, q, path, contains)
      const best = flooded(diagram, contains, 4, p, q)
      expect(path?.clearance).toBeGreaterThan(best - 0.13)
      expect(path?.clearance).toBeLessThan(best + 0.13)
    }
  })
})

describe('a clearest path in a region', () => {
  it('goes around the corner of a room', () => {
    const room = region([ROOM])
    const diagram = library.compute(Float64Array.of(5, 5, 1, 1, 3, 0.1))
    const [p, q] = [
      { x: 0.5, y: 5.5 },
      { x: 5.5, y: 0.5 },
    ]
    const path = clearestPath(diagram, p, q, { region: room })
    expectPath(diagram, p, q, path, ({ x, y }) => room.contains(x, y))
    // The path passes the small circle along a wall.
    expect(path?.clearance).toBeCloseTo(0.9, 12)
  })

  it('leaps past a corner that hides the boundary', () => {
    // A wall from below ends near the circle. Behind it the ray past its corner is the clearest path.
    const room = region([ring(-5, 0, -0.1, 0, -0.1, 1, 0.1, 1, 0.1, 0, 5, 0, 5, 6, -5, 6)])
    const diagram = library.compute([[0, -1, 0.5]])
    const [p, q] = [
      { x: -4, y: 0.5 },
      { x: 4, y: 0.5 },
    ]
    const path = clearestPath(diagram, p, q, { region: room })
    expectPath(diagram, p, q, path, ({ x, y }) => room.contains(x, y))
    expect(path?.clearance).toBeCloseTo(Math.hypot(4, 1.5) - 0.5, 12)
  })

  it('is none from one part to another', () => {
    const islands = region([box(0, 0, 1, 1), box(2, 0, 3, 1)])
    const diagram = library.compute([[0.2, 0.2, 0.1]])
    expect(clearestPath(diagram, { x: 0.5, y: 0.5 }, { x: 2.5, y: 0.5 }, { region: islands })).toBeUndefined()
    expect(clearestPath(diagram, { x: 2.5, y: 0.5 }, { x: 2.6, y: 0.4 }, { region: islands })).toBeDefined()
  })

  it('is as clear as flooding finds, among walls', () => {
    const random = seededRandom(5)
    for (let trial = 0; trial < 25; trial++) {
      // A star around the origin.
      const corners = 5 + Math.floor(8 * random())
      const ring = Array.from({ length: corners }, (_, k): [number, number] => {
        const angle = (2 * Math.PI * (k + 0.7 * random())) / corners
        const r = 1.2 + 2.7 * random()
        return [r * Math.cos(angle), r * Math.sin(angle)]
      })
      const star = region([ring])
      const count = 1 + Math.floor(6 * random())
      const circles = Array.from({ length: count }, () => [6 * random() - 3, 6 * random() - 3, 0.4 * random()])
      const diagram = library.compute(circles as [number, number, number][])
      const corner = (k: number) => {
        const [x, y] = ring[k % corners] as [number, number]
        return { x: 0.9 * x, y: 0.9 * y }
      }
      const [p, q] = [corner(0), corner(Math.floor(corners / 2))]
      if (!star.contains(p.x, p.y) || !star.contains(q.x, q.y)) continue
      const contains = ({ x, y }: Point) => star.contains(x, y)
      const path = clearestPath(diagram, p, q, { region: star })
      expectPath(diagram, p, q, path, contains)
      const best = flooded(diagram, contains, 4, p, q)
      expect(path?.clearance, `trial ${trial}`).toBeGreaterThan(best - 0.13)
      expect(path?.clearance, `trial ${trial}`).toBeLessThan(best + 0.3)
    }
  })
})

describe('a clearest path among ties', () => {
  it('starts at a corner on a bisector, at a center on the border and beside a notch', () => {
    const cases: [Circles, [number, number][], Point, Point, number][] = [
      [Float64Array.of(0, 0, 0, 0, 2, 0), ring(0, 1, 1, 1, 1, 2, 0, 2), { x: 0, y: 1 }, { x: 1, y: 2 }, 1],
      [[[1, 1, 0]], ring(0, 0, 1, 0, 1, 1, 0, 1), { x: 1, y: 1 }, { x: 0, y: 0 }, 0],
      [[[1, 2, 0]], ring(0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3), { x: 1, y: 2 }, { x: 2.5, y: 2.5 }, 0],
    ]
    for (const [circles, corners, p, q, clearance] of cases) {
      const diagram = library.compute(circles)
      const room = region([corners])
      const path = clearestPath(diagram, p, q, { region: room })
      expectPath(diagram, p, q, path, ({ x, y }) => room.contains(x, y))
      expect(path?.clearance).toBe(clearance)
    }
    const two = library.compute(Float64Array.of(0, 0, 0, 0, 2, 0))
    const path = clearestPath(two, { x: 0, y: 1 }, { x: 1, y: 2 }, { bounds: [0, 1, 1, 2] })
    expectPath(two, { x: 0, y: 1 }, { x: 1, y: 2 }, path, ({ x, y }) => 0 <= x && x <= 1 && 1 <= y && y <= 2)
    expect(path?.clearance).toBe(1)
  })

  it('leads from anywhere to anywhere in bounds, as clear as in the region of the same corners', () => {
    const random = seededRandom(Number(process.env.CIRCLE_VORONOI_SEED ?? 3))
    const trials = Number(process.env.CIRCLE_VORONOI_PATH_TRIALS ?? 40)
    const below = (count: number) => Math.floor(count * random())
    for (let trial = 0; trial < trials; trial++) {
      const offset = random() < 0.2 ? 2 ** 20 : 0
      const place = () => ({ x: offset + below(7), y: below(7) })
      const corners = randomBounds(place)
      if (corners === undefined) continue
      const isGrid = random() < 0.7
      const circles = Array.from({ length: 1 + below(6) }, (): [number, number, number] => {
        const { x, y } = place()
        return isGrid ? [x, y, below(2) * 0.5 * below(3)] : [x + random(), y + random(), random()]
      })
      const diagram = library.compute(circles)
      const bounds = ConvexPolygon.from(corners)
      const same = region([corners])
      const contains = ({ x, y }: Point) => same.contains(x, y)
      const inside = [
        ...corners,
        ...Array.from({ length: 12 }, () => ({ x: offset + below(13) / 2, y: below(13) / 2 })),
      ]
        .concat(circles.map(([x, y]) => ({ x, y })))
        .filter(contains)
      for (let k = 0; k < 5; k++) {
        const [p, q] = [inside[below(inside.length)] as Point, inside[below(inside.length)] as Point]
        const path = clearestPath(diagram, p, q, { bounds })
        const other = clearestPath(diagram, p, q, { region: same })
        const about = JSON.stringify({ trial, circles, corners, p, q })
        if (p.x !== q.x || p.y !== q.y) {
          expectPath(diagram, p, q, path, contains)
          expectPath(diagram, p, q, other, contains)
        }
        expect(Math.abs((path?.clearance as number) - (other?.clearance as number)), about).toBeLessThan(1e-8)
      }
    }
  })
})

/** The convex hull of some points, with points on its sides; `undefined` if it has no area. */
function randomBounds(place: () => Point): Point[] | undefined {
  const points = Array.from({ length: 5 }, place).sort((p, q) => p.x - q.x || p.y - q.y)
  const chain = (list: readonly Point[]) => {
    const kept: Point[] = []
    for (const p of list) {
      for (;;) {
        const [a, b] = kept.slice(-2)
        if (a === undefined || b === undefined) break
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) >= 0) break
        kept.pop()
      }
      const last = kept.at(-1)
      if (last === undefined || last.x !== p.x || last.y !== p.y) kept.push(p)
    }
    return kept.slice(0, -1)
  }
  const corners = [...chain(points), ...chain([...points].reverse())]
  try {
    return [...ConvexPolygon.from(corners).corners]
  } catch {
    return undefined
  }
}
