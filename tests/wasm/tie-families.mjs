// SPDX-License-Identifier: GPL-3.0-or-later
// Circles with bounds and maximum distances that make ties: exact ones, and some that rounding makes.

/** Mulberry32: small, seeded, good enough. */
export function randomOf(seed) {
  let state = seed
  return () => {
    state = (state + 0x6d2b79f5) | 0
    let t = Math.imul(state ^ (state >>> 15), 1 | state)
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32
  }
}

const TRIPLES = [
  [3, 4, 5],
  [5, 12, 13],
  [8, 15, 17],
  [7, 24, 25],
  [20, 21, 29],
]

class Maker {
  constructor(random, verticesOf) {
    this.random = random
    this.verticesOf = verticesOf
  }
  whole = (least, most) => least + Math.floor(this.random() * (most - least + 1))
  real = (size) => (2 * this.random() - 1) * size
  chance = (share) => this.random() < share
  one = (list) => list[Math.floor(this.random() * list.length)]

  circles(isWhole, size = 8) {
    const count = this.whole(1, 6)
    const most = this.one([0, 2, size])
    return Array.from({ length: count }, () =>
      isWhole
        ? [this.whole(-size, size), this.whole(-size, size), this.whole(0, most)]
        : [this.real(size), this.real(size), this.random() * most],
    )
  }

  box(isWhole, size = 10) {
    const pair = () => {
      const [a, b] = isWhole ? [this.whole(-size, size), this.whole(-size, size)] : [this.real(size), this.real(size)]
      return a === b ? [a, a + 1] : [Math.min(a, b), Math.max(a, b)]
    }
    const [minX, maxX] = pair()
    const [minY, maxY] = pair()
    return boxOf(minX, minY, maxX, maxY)
  }

  /** The convex hull of points. */
  hull(isWhole, size = 10) {
    for (;;) {
      const points = Array.from({ length: this.whole(3, 7) }, () =>
        isWhole ? [this.whole(-size, size), this.whole(-size, size)] : [this.real(size), this.real(size)],
      )
      const corners = hullOf(points)
      if (corners.length > 2) return corners
    }
  }

  /** Inserts corners next to sides. */
  withCornersOnSides(corners, offset) {
    return corners.flatMap(([x, y], k) => {
      const [u, v] = corners[(k + 1) % corners.length]
      if (this.chance(0.4)) return [[x, y]]
      const share = this.chance(0.3) ? 0.5 : this.random()
      const out = offset() / Math.hypot(u - x, v - y)
      const between = [x + share * (u - x) + out * (v - y), y + share * (v - y) - out * (u - x)]
      return [[x, y], between]
    })
  }
}

function boxOf(minX, minY, maxX, maxY) {
  return [
    [minX, minY],
    [maxX, minY],
    [maxX, maxY],
    [minX, maxY],
  ]
}

function hullOf(points) {
  const sorted = [...points].sort(([a, b], [c, d]) => a - c || b - d)
  const half = (list) => {
    const chain = []
    for (const p of list) {
      while (chain.length > 1) {
        const [[ax, ay], [bx, by]] = chain.slice(-2)
        if ((bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax) > 0) break
        chain.pop()
      }
      chain.push(p)
    }
    return chain.slice(0, -1)
  }
  return [...half(sorted), ...half(sorted.reverse())]
}

/** Each family returns circles, corners, and a maximum distance or `undefined`. */
export const FAMILIES = {
  'integers in a box': (m) => ({
    circles: m.circles(true),
    corners: m.box(true),
    maxDistance: m.chance(0.6) ? m.whole(-2, 6) : undefined,
  }),
  'integers in a polygon with corners on its sides': (m) => ({
    circles: m.circles(true),
    corners: m.withCornersOnSides(m.hull(true), () => 0),
    maxDistance: m.chance(0.3) ? m.whole(0, 6) : undefined,
  }),
  'points on a grid, with a box along edges': (m) => {
    const count = m.whole(2, 3)
    const circles = []
    for (let x = 0; x < count; x++) for (let y = 0; y < count; y++) circles.push([2 * x, 2 * y, 0])
    const corners = boxOf(m.whole(-2, 2), m.whole(-2, 2), m.whole(3, 7), m.whole(3, 7))
    return { circles, corners, maxDistance: m.chance(0.5) ? m.one([0, 1, Math.SQRT2, 2, 2.5]) : undefined }
  },
  'a corner off its neighbors by an ulp': (m) => ({
    circles: m.circles(false),
    corners: m.withCornersOnSides(m.hull(false), () => 10 ** -(13 + 4 * m.random())),
    maxDistance: undefined,
  }),
  'corners on sides, rounded': (m) => ({
    circles: m.circles(false),
    corners: m.withCornersOnSides(m.hull(false), () => 0),
    maxDistance: m.chance(0.3) ? m.real(8) : undefined,
  }),
  'corners next to bisectors': (m) => {
    const circles = m.circles(true)
    const [x, y, r] = circles[0]
    const [u, v, s] = m.one(circles)
    const d = Math.hypot(u - x, v - y)
    const share = d > 0 ? (d + r - s) / 2 / d : 0
    const apex = [x + share * (u - x), y + share * (v - y)]
    const corners = hullOf([apex, ...m.hull(true)])
    return {
      circles,
      corners: m.withCornersOnSides(corners, () => 10 ** -(13 + 4 * m.random())),
      maxDistance: undefined,
    }
  },
  'discs through corners': (m) => {
    const circles = m.circles(true)
    const corners = m.chance(0.5) ? m.box(true) : m.hull(true)
    const [x, y] = m.one(corners)
    const [a, b, c] = m.one(TRIPLES)
    const [dx, dy] = m.one([
      [a, b],
      [b, a],
      [c, 0],
      [0, c],
    ])
    const r = m.whole(0, c)
    circles[0] = [x + m.one([-1, 1]) * dx, y + m.one([-1, 1]) * dy, r]
    return { circles, corners, maxDistance: c - r }
  },
  'discs that touch sides': (m) => {
    const circles = m.circles(true)
    const corners = m.box(true)
    const [x, y, r] = m.one(circles)
    const [sx, sy] = m.one(corners)
    return { circles, corners, maxDistance: Math.abs(m.chance(0.5) ? x - sx : y - sy) - r }
  },
  'a distance at which discs touch or vertices lie': (m) => {
    const circles = m.circles(true)
    const [a, b] = [m.one(circles), m.one(circles)]
    const touch = (Math.hypot(a[0] - b[0], a[1] - b[1]) - a[2] - b[2]) / 2
    return { circles, corners: m.chance(0.5) ? m.box(true) : m.hull(true), maxDistance: touch }
  },
  'vertices at a whole distance': (m) => {
    // Points on a circle whose radius is whole.
    const [a, b, c] = m.one(TRIPLES)
    const points = [
      [a, b],
      [-a, b],
      [b, a],
      [b, -a],
      [-b, -a],
      [c, 0],
      [0, -c],
      [-c, 0],
    ]
    const r = m.whole(0, 2)
    const circles = points.filter(() => m.chance(0.5)).map(([x, y]) => [x, y, r])
    if (circles.length === 0) circles.push([c, 0, r])
    const corners = m.chance(0.5) ? boxOf(-c, -c, m.one([0, c]), m.one([0, c])) : m.hull(true, c)
    return { circles, corners, maxDistance: c - r + m.one([0, 0, 1, -1]) }
  },
  'bounds through rounded vertices and centers': (m) => {
    const circles = m.circles(m.chance(0.5))
    const places = [...circles, ...m.verticesOf(circles)]
    const [[x1, y1], [x2, y2]] = [m.one(places), m.one(places)]
    const corners = boxOf(Math.min(x1, x2), Math.min(y1, y2), Math.max(x1, x2, x1 + 1), Math.max(y1, y2, y1 + 1))
    return { circles, corners, maxDistance: m.chance(0.5) ? m.one(places)[2] : undefined }
  },
  'corners at rounded vertices and centers': (m) => {
    const circles = m.circles(m.chance(0.5))
    const places = [...circles, ...m.verticesOf(circles)]
    const corners = hullOf([m.one(places), m.one(places), ...m.hull(false)].map(([x, y]) => [x, y]))
    return { circles, corners, maxDistance: m.chance(0.5) ? m.one(places)[2] : undefined }
  },
  'many circles': (m) => ({
    circles: Array.from({ length: 15 }, () => [m.whole(-9, 9), m.whole(-9, 9), m.whole(0, 3)]),
    corners: m.chance(0.5) ? m.box(true) : m.withCornersOnSides(m.hull(false), () => 0),
    maxDistance: m.chance(0.5) ? m.whole(0, 4) : undefined,
  }),
  anything: (m) => ({
    circles: m.circles(false),
    corners: m.chance(0.5) ? m.box(false) : m.hull(false),
    maxDistance: m.chance(0.5) ? m.real(8) : undefined,
  }),
  'circles that nearly hide others': (m) => {
    const circles = m.circles(true)
    const [x, y, r] = circles[0]
    const big = [x + 3, y + 4, r + 5 - 2 ** -m.whole(1, 40)]
    return {
      circles: [...circles, big],
      corners: m.chance(0.5) ? m.box(true) : m.hull(false),
      maxDistance: m.chance(0.3) ? m.whole(0, 5) : undefined,
    }
  },
}

/** Makes a case of a family, at a scale: a power of two. `verticesOf` returns the vertices of circles. */
export function makeCase(family, random, verticesOf) {
  const maker = new Maker(random, verticesOf)
  const { circles: all, corners, maxDistance } = FAMILIES[family](maker)
  // Of equal centers, one circle.
  const circles = [...new Map(all.map((circle) => [circle.slice(0, 2).join(), circle])).values()]
  const scale = maker.chance(0.1) ? 2 ** maker.whole(-40, 80) : 1
  const scaled = (list) => list.map((numbers) => numbers.map((x) => x * scale))
  const metric = maker.one(['circles', 'circles', 'circles', 'centers', 'power'])
  const made = { circles, maxDistance, weights: false }
  if (metric === 'power' && maxDistance !== undefined && maker.chance(0.6)) {
    // Weights whose discs are the circles that the family has grown.
    made.weights = true
    made.maxDistance = maker.whole(-4, 4)
    made.circles = circles.map(([x, y, r]) => {
      const reach = r + maxDistance
      return [x, y, reach * Math.abs(reach) - made.maxDistance * Math.abs(made.maxDistance)]
    })
  }
  return {
    circles: scaled(made.circles).map(([x, y, r]) => [x, y, made.weights ? r * scale : r]),
    corners: scaled(corners),
    maxDistance: made.maxDistance === undefined ? undefined : made.maxDistance * scale,
    weights: made.weights,
    scale,
    isBox:
      corners.length === 4 &&
      corners[0][1] === corners[1][1] &&
      corners[1][0] === corners[2][0] &&
      corners[2][1] === corners[3][1] &&
      corners[3][0] === corners[0][0],
    metric,
  }
}
