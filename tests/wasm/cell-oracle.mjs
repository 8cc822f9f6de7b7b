// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a cell inside a polygon and a maximum distance, by brute force with numbers of 544 bits. The polygon is
// really moved by (e, f), so nothing is a tie. All curves are cut at all others, and the piece between two cuts is kept
// if the point in its middle lies inside everything else. Nothing is shared with the library.

const BITS = 544n
const ONE = 1n << BITS
/** The shift of the polygon: f is far smaller than e and its square. */
const [E, F] = [ONE >> 100n, ONE >> 230n]
/** Numbers closer than this are equal. */
const CLOSE = ONE >> 260n
/** Values above this are decided in doubles, as a share of the sizes. */
const CLEAR = 1e-9

const abs = (a) => (a < 0n ? -a : a)
/** @type {(a: bigint, b: bigint) => bigint} */
const mul = (a, b) => (a * b) >> BITS
/** @type {(a: bigint, b: bigint) => bigint} */
const div = (a, b) => (a << BITS) / b
const toNumber = (a) => Number(a >> (BITS - 200n)) / 2 ** 200

/**
 * @param {bigint} a
 * @returns {bigint}
 */
function root(a) {
  if (a <= 0n) return 0n
  const square = a << BITS
  const bits = square.toString(16).length * 4
  // Correct to 50 bits, which Newton's method doubles.
  const shift = BigInt(Math.max(0, bits - 100) & ~1)
  let guess = BigInt(Math.floor(Math.sqrt(Number(square >> shift)))) << (shift / 2n)
  for (let k = 0; k < 6; k++) guess = (guess + square / guess) >> 1n
  return guess
}

/** The roots of a x^2 + 2 b x + c. */
function rootsOf(a, b, c) {
  if (abs(a) < CLOSE) return abs(b) < CLOSE ? [] : [-div(c, 2n * b)]
  const square = mul(b, b) - mul(a, c)
  if (square < 0n) return []
  const sum = b > 0n ? 0n - b - root(square) : root(square) - b
  return sum === 0n ? [0n] : [div(sum, a), div(c, sum)]
}

const dot = (u, v) => mul(u.x, v.x) + mul(u.y, v.y)
const cross = (u, v) => mul(u.x, v.y) - mul(u.y, v.x)
const plus = (p, u, t) => ({ x: p.x + mul(t, u.x), y: p.y + mul(t, u.y) })
const lengthOf = (u) => root(dot(u, u))
const isClose = (p, q) => abs(p.x - q.x) < CLOSE && abs(p.y - q.y) < CLOSE
const inDoubles = ({ x, y }) => ({ x: toNumber(x), y: toNumber(y) })

/**
 * Returns the part of the cell of circle `i` inside the corners of a polygon and `maxDistance`: its area, and its loops
 * of pieces. A piece has a `label` (the neighbor's index, 'bounds k' or 'arc') and a `length`. All lengths are divided
 * by `unit`, a power of two.
 */
export function cellByBruteForce(circles, i, corners, maxDistance, metric, unit, weights = false) {
  const big = (x) => BigInt(Math.round((x / unit) * 2 ** 400)) << (BITS - 400n)
  const at = (k) => ({
    x: big(circles[k][0]),
    y: big(circles[k][1]),
    r: metric === 'circles' ? big(circles[k][2]) : 0n,
    weight: metric !== 'power' ? 0n : weights ? big(circles[k][2] / unit) : mul(big(circles[k][2]), big(circles[k][2])),
  })
  const own = at(i)
  // Everything is seen from the circle's center.
  const polygon = corners.map(([x, y]) => ({ x: big(x) - own.x + E, y: big(y) - own.y + F }))
  let radius
  if (maxDistance !== undefined) {
    const most = big(maxDistance)
    radius = metric === 'power' ? root(own.weight + mul(most, abs(most))) : own.r + most
  }
  const nothing = { area: 0, loops: [] }
  if (radius !== undefined && radius <= 0n) return nothing
  const others = []
  for (let j = 0; j < circles.length; j++) {
    if (j === i) continue
    const c = at(j)
    const way = { x: c.x - own.x, y: c.y - own.y }
    const square = dot(way, way)
    const s = c.r - own.r
    const weight = own.weight - c.weight
    const k = square - mul(s, s) + weight
    const isHiding = metric !== 'power' && k <= 0n
    if (isHiding && (s > 0n || (s === 0n && j < i))) return nothing
    if (isHiding) continue
    if (square === 0n) {
      if (weight < 0n || (weight === 0n && j < i)) return nothing
      continue
    }
    const d = root(square)
    const unitWay = { x: div(way.x, d), y: div(way.y, d) }
    others.push({ j, way, d, s, k, along: unitWay, across: { x: -unitWay.y, y: unitWay.x } })
  }
  // Two bisectors that are one leave a cell of no width between them.
  const isOne = (one, other) => {
    const turned = dot(one.way, other.way) > 0n ? one.d : -one.d
    return (
      abs(cross(one.way, other.way)) < CLOSE &&
      abs(mul(one.k, other.d) - mul(other.k, turned)) < CLOSE &&
      abs(mul(one.s, other.d) - mul(other.s, turned)) < CLOSE
    )
  }
  if (others.some((one, k) => others.slice(k + 1).some((other) => isOne(one, other)))) return undefined
  for (const other of others) {
    other.near = { way: inDoubles(other.way), s: toNumber(other.s), k: toNumber(other.k) }
  }

  const isNearer = (p, q, { way, s, k, near }) => {
    if (metric === 'power') {
      const value = near.k - 2 * (q.x * near.way.x + q.y * near.way.y)
      const size = Math.abs(near.k) + 4 * Math.hypot(q.x, q.y) * Math.hypot(near.way.x, near.way.y)
      return Math.abs(value) > CLEAR * size ? value > 0 : k - 2n * dot(p, way) > 0n
    }
    const to = Math.hypot(q.x - near.way.x, q.y - near.way.y)
    const from = Math.hypot(q.x, q.y)
    const value = to - from - near.s
    if (Math.abs(value) > CLEAR * (to + from + Math.abs(near.s))) return value > 0
    return lengthOf({ x: p.x - way.x, y: p.y - way.y }) - lengthOf(p) - s > 0n
  }
  const inCell = (p, except) => {
    const q = inDoubles(p)
    return others.every((other) => other === except || isNearer(p, q, other))
  }
  const nearPolygon = polygon.map(inDoubles)
  const inPolygon = (p) => {
    let isInside = false
    polygon.forEach((a, k) => {
      const b = polygon[(k + 1) % polygon.length]
      if (a.y > p.y === b.y > p.y) return
      const [c, d, q] = [nearPolygon[k], nearPolygon[(k + 1) % polygon.length], inDoubles(p)]
      const value = (d.x - c.x) * (q.y - c.y) - (d.y - c.y) * (q.x - c.x)
      const size =
        (Math.abs(d.x - c.x) + Math.abs(d.y - c.y)) * (Math.abs(c.x) + Math.abs(c.y) + Math.abs(q.x) + Math.abs(q.y))
      const isLeft =
        Math.abs(value) > CLEAR * size
          ? value > 0
          : cross({ x: b.x - a.x, y: b.y - a.y }, { x: p.x - a.x, y: p.y - a.y }) > 0n
      if (isLeft === b.y > a.y) isInside = !isInside
    })
    return isInside
  }
  const inDisc = (p) => radius === undefined || dot(p, p) < mul(radius, radius)
  /** Whether a distance from the center, and the one from the neighbor that goes with it, are not negative. */
  const isDistance = (rho, { s }) => rho >= 0n && rho + s >= 0n

  const pieces = []
  const addPieces = (label, cuts, pointAt, isKept, bend) => {
    cuts.sort((a, b) => (a < b ? -1 : a > b ? 1 : 0))
    for (let k = 0; k + 1 < cuts.length; k++) {
      const [from, to] = [cuts[k], cuts[k + 1]]
      if (to - from < CLOSE) continue
      if (!isKept(pointAt((from + to) / 2n))) continue
      const last = pieces.at(-1)
      const end = pointAt(to)
      // The cut may be by a curve that does not bound the part here.
      if (last?.cuts === cuts && from - last.to < CLOSE) Object.assign(last, { end, to })
      else pieces.push({ label, start: pointAt(from), end, from, to, bend, cuts })
    }
  }

  for (const other of others) {
    const { j, way, d, s, k, along, across } = other
    const inFrame = (u, v) => ({ x: mul(u, along.x) + mul(v, across.x), y: mul(u, along.y) + mul(v, across.y) })
    const pointAt = (v) => {
      if (s === 0n) return inFrame(div(k, 2n * d), v)
      const rho = (mul(d, root(ONE + div(4n * mul(v, v), k))) - s) / 2n
      return inFrame(div(k - 2n * mul(rho, s), 2n * d), v)
    }
    const cuts = []
    const cutAt = (p) => cuts.push(dot(p, across))
    for (const third of others) {
      if (third === other) continue
      // 2 p . way + 2 rho s = k for both, so p = a + rho b.
      const turn = cross(way, third.way)
      const solve = (m, n) => ({
        x: div(mul(m, third.way.y) - mul(n, way.y), turn),
        y: div(mul(n, way.x) - mul(m, third.way.x), turn),
      })
      const isOne = (rho) => metric === 'power' || (isDistance(rho, other) && isDistance(rho, third))
      if (abs(turn) > CLOSE) {
        const a = solve(k / 2n, third.k / 2n)
        const b = solve(-s, -third.s)
        if (metric === 'power') cutAt(a)
        else {
          for (const rho of rootsOf(dot(b, b) - ONE, dot(a, b), dot(a, a))) if (isOne(rho)) cutAt(plus(a, b, rho))
        }
        continue
      }
      if (metric === 'power') continue
      const factor = div(dot(third.way, along), d)
      const rest = third.s - mul(factor, s)
      if (abs(rest) < CLOSE) continue
      const rho = div(third.k - mul(factor, k), 2n * rest)
      const u = div(k - 2n * mul(rho, s), 2n * d)
      const v = mul(rho, rho) - mul(u, u)
      if (isOne(rho) && v >= 0n) cuts.push(root(v), -root(v))
    }
    polygon.forEach((a, n) => {
      const b = polygon[(n + 1) % polygon.length]
      const line = { x: b.x - a.x, y: b.y - a.y }
      const half = dot(line, way)
      const rest = k - 2n * dot(a, way)
      if (s === 0n) {
        if (abs(half) > CLOSE) cutAt(plus(a, line, div(rest, 2n * half)))
        return
      }
      // rho = (rest - 2 t half) / (2 s), and rho^2 = |a + t line|^2.
      const [m, g] = [div(rest, 2n * s), -div(half, s)]
      for (const t of rootsOf(dot(line, line) - mul(g, g), dot(a, line) - mul(m, g), dot(a, a) - mul(m, m))) {
        if (isDistance(m + mul(g, t), other)) cutAt(plus(a, line, t))
      }
    })
    if (radius !== undefined && isDistance(radius, other)) {
      const u = div(k - 2n * mul(radius, s), 2n * d)
      const v = mul(radius, radius) - mul(u, u)
      if (v > 0n) cuts.push(root(v), -root(v))
    }
    const isKept = (p) => inPolygon(p) && inDisc(p) && inCell(p, other)
    addPieces(String(j), cuts, pointAt, isKept, s === 0n ? undefined : { other })
  }

  polygon.forEach((a, n) => {
    const b = polygon[(n + 1) % polygon.length]
    const line = { x: b.x - a.x, y: b.y - a.y }
    const cuts = [0n, ONE]
    const cutAt = (t) => {
      if (t > 0n && t < ONE) cuts.push(t)
    }
    for (const other of others) {
      const { way, s, k } = other
      const half = dot(line, way)
      const rest = k - 2n * dot(a, way)
      if (s === 0n) {
        if (abs(half) > CLOSE) cutAt(div(rest, 2n * half))
        continue
      }
      const [m, g] = [div(rest, 2n * s), -div(half, s)]
      for (const t of rootsOf(dot(line, line) - mul(g, g), dot(a, line) - mul(m, g), dot(a, a) - mul(m, m))) {
        if (isDistance(m + mul(g, t), other)) cutAt(t)
      }
    }
    if (radius !== undefined) {
      for (const t of rootsOf(dot(line, line), dot(a, line), dot(a, a) - mul(radius, radius))) cutAt(t)
    }
    addPieces(
      `bounds ${n}`,
      cuts,
      (t) => plus(a, line, t),
      (p) => inDisc(p) && inCell(p, undefined),
      undefined,
    )
  })

  if (radius !== undefined) {
    const axes = [
      { x: 1n, y: 0n },
      { x: 0n, y: 1n },
      { x: -1n, y: 0n },
      { x: 0n, y: -1n },
    ]
    const points = []
    for (const other of others) {
      if (!isDistance(radius, other)) continue
      const { d, s, k, along, across } = other
      const u = div(k - 2n * mul(radius, s), 2n * d)
      const v = mul(radius, radius) - mul(u, u)
      if (v <= 0n) continue
      for (const w of [root(v), -root(v)])
        points.push({ x: mul(u, along.x) + mul(w, across.x), y: mul(u, along.y) + mul(w, across.y) })
    }
    polygon.forEach((a, n) => {
      const b = polygon[(n + 1) % polygon.length]
      const line = { x: b.x - a.x, y: b.y - a.y }
      for (const t of rootsOf(dot(line, line), dot(a, line), dot(a, a) - mul(radius, radius)))
        points.push(plus(a, line, t))
    })
    axes.forEach((axis, quarter) => {
      const next = axes[(quarter + 1) % 4]
      // A place on a quarter is how much farther it is along the next axis than along its own.
      const ahead = (p, along) => along.x * p.x + along.y * p.y
      const cuts = [-radius, radius]
      for (const p of points) {
        if (ahead(p, axis) > 0n && ahead(p, next) > 0n) cuts.push(ahead(p, next) - ahead(p, axis))
      }
      const pointAt = (place) => {
        const sum = root(2n * mul(radius, radius) - mul(place, place))
        const [w, h] = [(sum - place) / 2n, (sum + place) / 2n]
        return { x: axis.x * w + next.x * h, y: axis.y * w + next.y * h }
      }
      addPieces('arc', cuts, pointAt, (p) => inPolygon(p) && inCell(p, undefined), { quarter })
    })
  }
  return joined(pieces, radius)
}

function joined(pieces, radius) {
  const loops = []
  const isDone = new Set()
  let area = 0
  // The farther apart two points, the less their rounding matters.
  const origin = pieces[0]?.start ?? { x: 0n, y: 0n }
  for (const first of pieces) {
    if (isDone.has(first)) continue
    const loop = []
    for (let piece = first; !isDone.has(piece); ) {
      isDone.add(piece)
      const u = inDoubles({ x: piece.start.x - origin.x, y: piece.start.y - origin.y })
      const v = inDoubles({ x: piece.end.x - origin.x, y: piece.end.y - origin.y })
      const chord = Math.hypot(u.x - v.x, u.y - v.y)
      area += (u.x * v.y - u.y * v.x) / 2 + beyondChord(piece, radius, chord)
      loop.push({ label: piece.label, length: lengthOfPiece(piece, chord), start: inDoubles(piece.start) })
      const next = pieces.find(({ start }) => isClose(start, piece.end))
      // At a tie of many, brute force has left out pieces that are as good as points.
      if (next === undefined) return undefined
      piece = next
    }
    loops.push(loop)
  }
  return { area, loops }
}

function lengthOfPiece({ bend, from, to }, chord) {
  return bend?.other === undefined ? chord : Math.max(chord, toNumber(to - from))
}

/** The area between the chord of a piece and the piece, positive if the piece is to the right of its chord. */
function beyondChord({ bend, from, to }, radius, chord) {
  if (bend === undefined) return 0
  if (bend.other === undefined) {
    const r = toNumber(radius)
    const h = Math.asin(Math.min(1, chord / 2 / r))
    return (
      r * r * (h < 1e-2 ? (2 / 3) * h ** 3 * (1 - (h * h) / 5 + (2 * h ** 4) / 105) : h - Math.sin(h) * Math.cos(h))
    )
  }
  const { s, k } = bend.other
  const b = root(k) / 2n
  const cosh = (v) => root(ONE + div(4n * mul(v, v), k))
  const sine = toNumber(div(mul(to, cosh(from)) - mul(from, cosh(to)), b))
  const d = Math.asinh(sine)
  const excess =
    d < 0.1 ? (d ** 3 / 6) * (1 + d ** 2 / 20 + d ** 4 / 840 + d ** 6 / 60480 + d ** 8 / 6652800) : sine - d
  // The branch bends around the smaller circle.
  return (toNumber(s) * toNumber(b) * excess) / 4
}
