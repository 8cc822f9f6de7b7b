// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry in TypeScript against that in C++, function by function, bit by bit, on every fixture by every metric, with
// additive weights, and at extreme scales. The other side is tests/geometry.
import assert from 'node:assert/strict'
import { execFileSync, spawn } from 'node:child_process'
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { createInterface } from 'node:readline'
import { after, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import {
  clearestPath,
  closestPair,
  convexHull,
  cubicBeziers,
  edgeCurve,
  hiddenWarning,
  largestEmptyDiscCenteredInHull,
  loadCircleVoronoi,
  mergeVertices,
  outlineArea,
  outlineCentroid,
  outlinePerimeter,
  parameterAt,
  pointAt,
  polyline,
  rationalBezier,
} from '../../dist/lib/index.js'
import { loadMetrics } from '../../dist/lib/metrics.js'
import { innerModule } from './inner-module.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const NATIVE = `${ROOT}build/native/circle-voronoi`
const ANSWERS = `${ROOT}build/native/tests/geometry/circle_voronoi_geometry_answers`
const LARGEST_OUTPUT = 2 ** 28
/** Query points along each side of the box. */
const PLACES = 7
/** The parameter at which a piece of an unbounded edge begins, or the inverse of that at which it ends. */
const NEAR_PARAMETER = 0.1
/** Results of an arctangent, which differs between platforms. */
const ROUNDED = { name: 'hull measures', tolerance: 1e-14 }

const { distanceFrom } = await innerModule('base/metric')
const { bezierPointAt } = await innerModule('curves/bezier')
const { linkSides } = await innerModule('diagram/link-sides')
const { exportBox, exportBoxOf } = await innerModule('regions/export-box')
const { curveLength } = await innerModule('regions/measure')
const { wholeLoop } = await innerModule('regions/outline')
const library = await loadCircleVoronoi()
const { compute } = await loadMetrics({ library })
const folder = mkdtempSync(`${tmpdir()}/circle-voronoi-`)
/** Answers requests in order. */
const child = spawn(ANSWERS, { stdio: ['pipe', 'pipe', 'inherit'] })
const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]()
after(() => {
  child.stdin.end()
  rmSync(folder, { recursive: true })
})

/** The circles of a fixture, x, y, r each. */
function circlesOf(fixture) {
  const args = ['compute', `${ROOT}tests/fixtures/${fixture}`, '--format', 'json']
  const { circles } = JSON.parse(execFileSync(NATIVE, args, { maxBuffer: LARGEST_OUTPUT, encoding: 'utf8' }))
  return Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r]))
}

const fixtures = readdirSync(`${ROOT}tests/fixtures`)
  .filter((name) => name.endsWith('.csv'))
  .map((name) => ({ name, circles: circlesOf(name) }))
const scaled = ['waka.csv', 'missed-antipodal-disc-mixed-6.csv'].flatMap((name) =>
  [-40, 30].map((exponent) => ({
    name: `2^${exponent} times ${name}`,
    circles: fixtures.filter((fixture) => fixture.name === name)[0].circles.map((value) => value * 2 ** exponent),
  })),
)
/**
 * A point that touches a circle from inside up to a share of its radius, and distant vertices on both sides of their
 * edge.
 */
const needles = [
  [2 ** -40, 2 ** -56],
  [1, 2 ** -96],
  [2 ** 40, 2 ** -130],
].map(([scale, share]) => ({
  name: `a needle thinner than rounding at the scale ${scale}`,
  circles: Float64Array.of(-share, 0, 1, 1, 0, 0, 1, 1, 0.01).map((value) => value * scale),
}))

for (const { name, circles } of [...fixtures, ...scaled, ...needles]) {
  describe(name, () => {
    for (const metric of /** @type {const} */ (['circles', 'centers', 'power'])) {
      it(`has the geometry of C++ by the metric ${metric}`, () => {
        return compare(compute(circles, { metric }), metric)
      })
    }

    it('has the geometry of C++ with weights of any sign', () => {
      const most = circles.reduce((most, value, k) => (k % 3 === 2 ? Math.max(most, value) : most), 0)
      const weights = circles.map((value, k) => (k % 3 === 2 ? value - most / 2 : value))
      return compare(library.compute(weights, { weights: true }), 'weights')
    })

    it('has the geometry of C++ by the metric power with weights of any sign', () => {
      const most = circles.reduce((most, value, k) => (k % 3 === 2 ? Math.max(most, value) : most), 0)
      const weights = circles.map((value, k) => (k % 3 === 2 ? value - most / 2 : value))
      return compare(compute(weights, { metric: 'power', weights: true }), 'power-weights')
    })

    it('has the geometry of C++ with one weight far below zero', () => {
      const size = circles.reduce((most, value) => Math.max(most, Math.abs(value)), 0)
      const weights = circles.map((value, k) => (k % 3 === 2 ? Math.max(-(2 ** 52) * size, -(2 ** 96)) : value))
      return compare(library.compute(weights, { weights: true }), 'weights')
    })
  })
}

async function compare(diagram, metric) {
  const box = exportBox(diagram.circles)
  // The distance clips some cells but not all.
  const maxDistance = Math.max(box.maxX - box.minX, box.maxY - box.minY) / 40
  const ours = answersOf(diagram, box, maxDistance)
  const theirs = await native(diagram.circles, metric, box, maxDistance)
  assert.equal(ours.length, theirs.length, 'the number of answers')
  ours.forEach(([question, numbers], k) => {
    const [theirQuestion, theirNumbers] = theirs[k]
    assert.equal(question, theirQuestion)
    const isSame = (number, i) =>
      Object.is(number, theirNumbers[i]) ||
      (question === ROUNDED.name &&
        Math.abs(number - theirNumbers[i]) <= ROUNDED.tolerance * Math.max(Math.abs(number), 1e-300))
    if (numbers.length !== theirNumbers.length || !numbers.every(isSame)) {
      assert.deepEqual({ question, numbers }, { question, numbers: theirNumbers })
    }
  })
}

function fileOf(circles) {
  const file = `${folder}/circles.csv`
  const rows = Array.from({ length: circles.length / 3 }, (_, i) => circles.subarray(3 * i, 3 * i + 3).join())
  writeFileSync(file, `x,y,r\n${rows.map((row) => `${row}\n`).join('')}`)
  return file
}

/** The native program's answers: questions with their numbers. */
async function native(circles, metric, { minX, minY, maxX, maxY }, maxDistance) {
  const file = fileOf(circles)
  child.stdin.write(`${[file, metric, minX, minY, maxX, maxY, maxDistance].join('\t')}\n`)
  const answers = []
  for (;;) {
    const { value: line, done } = await lines.next()
    if (done) throw new Error(`${ANSWERS} has ended.`)
    if (line === '') return answers
    const [question, numbers] = line.split(':')
    answers.push([question, numbers.split(' ').slice(1).map(numberOf)])
  }
}

function numberOf(text) {
  if (text.endsWith('inf')) return text.startsWith('-') ? -Infinity : Infinity
  return Number(text)
}

/** The answers of TypeScript. */
function answersOf(diagram, box, maxDistance) {
  const answers = []
  const say = (question, ...numbers) => answers.push([question, numbers.map(Number)])
  const of = (p) => [p.x, p.y]
  const { minX, minY, maxX, maxY } = box
  const tolerance = 1e-4 * Math.max(maxX - minX, maxY - minY)
  const places = Array.from({ length: PLACES * PLACES }, (_, k) => ({
    x: minX + ((k % PLACES) / (PLACES - 1)) * (maxX - minX),
    y: minY + (Math.floor(k / PLACES) / (PLACES - 1)) * (maxY - minY),
  }))
  const { circles, cells, edges, metric } = diagram
  const count = circles.length / 3

  say('exportBox', ...Object.values(exportBox(circles)))
  say('exportBox of a distance', ...Object.values(exportBoxOf(diagram, maxDistance)))
  say('hiddenWarning', ...Array.from(hiddenWarning(diagram), (letter) => letter.charCodeAt(0)))
  const { nextSide, vertexSides, firstSide } = diagram
  assert.deepEqual(linkSides(diagram), { nextSide, vertexSides, firstSide })

  const sayPiece = (name, piece) => {
    say(`${name} ends`, piece.from, piece.to, ...of(piece.start), ...of(piece.end))
    say(`${name} arcLength`, curveLength(piece))
    const rational = rationalBezier(piece)
    const { start, control, end, weight } = rational
    say(`${name} rationalBezier`, ...[start, control, end].flatMap(of), weight, ...of(bezierPointAt(rational, 0.3)))
    const cubics = cubicBeziers(piece, tolerance)
    say(
      `${name} cubicBeziers`,
      ...cubics.flatMap(({ start, control1, control2, end }) => [start, control1, control2, end].flatMap(of)),
    )
    say(`${name} polyline`, ...polyline(piece, tolerance).flatMap(of))
  }
  for (let e = 0; e < edges.length / 4; e++) {
    const curve = edgeCurve(diagram, e)
    const { left, right, a, b, origin, along, across, apex } = curve.bisector
    say(`bisector ${e}`, ...of(left), ...of(right), a, b, ...of(origin), ...of(along), ...of(across), apex)
    say(`edgeCurve ${e}`, curve.from, curve.to, ...[curve.start, curve.end].filter(Boolean).flatMap(of))
    for (const s of [0.3, 1, 5]) {
      const p = pointAt(curve.bisector, s)
      say(`pointAt ${e}`, ...of(p), parameterAt(curve.bisector, p.x, p.y))
    }
    // A bounded piece of the edge, between parameters.
    const from = curve.start === undefined ? Math.min(NEAR_PARAMETER, curve.to / 2) : curve.from
    const to = curve.end === undefined ? Math.max(1 / NEAR_PARAMETER, 2 * from) : curve.to
    const { start = pointAt(curve.bisector, from), end = pointAt(curve.bisector, to) } = curve
    sayPiece(`piece ${e}`, { bisector: curve.bisector, from, to, start, end })
  }

  const sayOutline = (name, parts) => {
    for (const loop of parts) {
      say(
        `${name} loop`,
        ...loop.flatMap(({ curve: { from, to, start, end }, side, neighbor, r }) => {
          return [from, to, ...of(start), ...of(end), side, neighbor, r]
        }),
      )
    }
    say(`${name} area`, outlineArea(parts))
    say(`${name} centroid`, ...of(outlineCentroid(parts)))
    say(`${name} perimeter`, outlinePerimeter(parts))
  }
  for (let i = 0; i < count; i++) {
    const sides = cells.sides(i)
    say(`cell ${i}`, cells.exists(i), ...sides, ...cells.neighbors(i))
    for (const side of sides) {
      const { from, to, bisector } = cells.curveOf(side)
      const around = [cells.circleOf(side), cells.neighborOf(side), cells.originOf(side), cells.targetOf(side)]
      say(`side ${side}`, ...around, from, to, bisector.a, ...of(bisector.across))
    }
    sayOutline(`outline ${i}`, cells.isBounded(i) ? [wholeLoop(cells, i)] : [])
    say(`whole cell ${i}`, diagram.cellArea(i), diagram.cellPerimeter(i))
  }

  if (count > 0) {
    say('findAll', ...diagram.findAll(places.flatMap(of)))
    places.forEach((p, k) => {
      const [x, y] = of(p)
      const found = diagram.find(x, y)
      const hint = k % count
      say(
        `place ${k}`,
        ...[found, diagram.find(x, y, hint), distanceFrom(diagram, found, x, y), diagram.contains(found, x, y)],
        ...[diagram.contains(hint, x, y), cells.distanceDifference(hint, found, x, y)],
        ...Array.from(diagram.neighbors(found), (other) => cells.distanceDifference(found, other, x, y)),
      )
    })
  }

  const around = convexHull(diagram)
  for (const { circle, r, start, end } of around.arcs) {
    say(`hull arc ${circle}`, r, ...of(start), ...of(end))
  }
  say(ROUNDED.name, around.length, around.area, ...around.arcs.map(({ angle }) => angle))

  for (const nearZero of [undefined, 0, tolerance, 1000 * tolerance]) {
    const merged = mergeVertices(diagram, nearZero)
    const { vertices, firstCircle, circles, mergedVertex, edges } = merged
    say('mergeVertices', ...vertices, ...firstCircle, ...circles, ...mergedVertex, ...edges)
  }

  if (metric !== 'circles') return answers
  const pair = closestPair(diagram)
  if (pair !== undefined) say('closestPair', pair.first, pair.second, pair.gap)
  const sayDisc = (name, found) =>
    say(name, ...(found === undefined ? [] : [found.disc.x, found.disc.y, found.disc.r, ...found.circles]))
  sayDisc('largestEmptyDiscCenteredInHull', largestEmptyDiscCenteredInHull(diagram))
  if (count === 0) return answers
  for (let k = 0; k < places.length; k += 3) {
    const to = places[places.length - 1 - ((5 * k) % places.length)]
    const { clearance, entry, exit, edges } = clearestPath(diagram, places[k], to)
    say(`clearestPath ${k}`, clearance, ...[entry, exit].filter(Boolean).flatMap(of), ...edges)
  }
  return answers
}
