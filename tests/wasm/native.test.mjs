// SPDX-License-Identifier: GPL-3.0-or-later
// The WebAssembly build against the native program, on every fixture and in regions: each index and each number to the last bit.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { basename } from 'node:path'
import { after, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { edgeAt, loadCircleVoronoi, vertexAt } from '../../dist/lib/index.js'
import { loadMetrics } from '../../dist/lib/metrics.js'
import { loadRegions } from '../../dist/lib/regions.js'
import { realData } from '../../scripts/data.mjs'
import { innerModule } from './inner-module.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const NATIVE = `${ROOT}build/native/circle-voronoi`
const LARGEST_OUTPUT = 2 ** 28
const METRICS = /** @type {const} */ (['circles', 'power'])

const OPTIONS = [
  { method: 'auto' },
  { method: 'flip' },
  { method: 'touching-disc', candidates: 'dynamic', samples: 1 },
  { method: 'touching-disc', candidates: 'dynamic', samples: 3 },
  { method: 'touching-disc', candidates: 'uniform', samples: 50 },
  { method: 'touching-disc', candidates: 'all-pairs' },
  { metric: 'centers' },
  { metric: 'power' },
]

const { exportBox } = await innerModule('regions/export-box')
const library = await loadCircleVoronoi()
const { compute } = await loadMetrics({ library })
const { region, fitAreas } = await loadRegions()
const folder = mkdtempSync(`${tmpdir()}/circle-voronoi-`)
after(() => rmSync(folder, { recursive: true }))
const fixtures = readdirSync(`${ROOT}tests/fixtures`, { recursive: true, encoding: 'utf8' }).filter(
  // The sites of fits have no radii.
  (name) => name.endsWith('.csv') && !name.startsWith('fits/'),
)

describe('the module', () => {
  it('runs where code generation from strings is forbidden', () => {
    assert.throws(() => new Function('return 1'), EvalError)
  })
})

for (const options of OPTIONS) {
  describe(`the same bits as the native program, ${Object.values(options).join(' ')}`, () => {
    for (const fixture of fixtures) it(fixture, () => void compare(`${ROOT}tests/fixtures/${fixture}`, options))
  })
}

describe('the same bits as the native program, weights of any sign', () => {
  for (const metric of ['circles', 'centers', 'power']) {
    for (const fixture of ['spruces.csv', 'waka.csv']) {
      it(`${metric}: ${fixture}`, () => {
        const { circles } = nativeDiagram(`${ROOT}tests/fixtures/${fixture}`, {})
        const power = metric === 'power' ? 2 : 1
        const rows = circles.map(({ x, y, r }, i) => `${x},${y},${(-1) ** i * (r / 3) ** power}\n`)
        const { certificate } = compare(written('weights.csv', `x,y,r\n${rows.join('')}`), { metric, weights: 'r' })
        assert.equal(certificate.certified, true)
      })
    }
  }
})

describe('the same bits as the native program, certified, on real circles', () => {
  for (const file of realData()) {
    it(basename(file), () => {
      const { certificate } = compare(file, { method: 'auto' })
      assert.equal(certificate.message, '')
      assert.equal(certificate.certified, true)
    })
  }
})

describe('the same measures as the native program without limits, and the same box', () => {
  for (const name of ['bronzefilter.csv', 'spruces.csv', 'waka.csv']) {
    it(name, () => {
      const file = `${ROOT}tests/fixtures/${name}`
      const diagram = library.compute(nativeDiagram(file, {}).circles)
      const { bbox, features } = JSON.parse(printed('compute', file, '--format', 'geojson'))
      assert.deepStrictEqual(bbox, Object.values(diagram.exportBox()))
      const areas = features.map(({ properties }) => properties.area ?? Number.POSITIVE_INFINITY)
      assert.deepStrictEqual([...diagram.cellAreas()], areas)
      assert.ok(areas.includes(Number.POSITIVE_INFINITY))
      const [minX, minY, maxX, maxY] = bbox
      const isOnBox = ({ start: { x, y }, end }) =>
        (x === end.x && (x === minX || x === maxX)) || (y === end.y && (y === minY || y === maxY))
      for (const [i, { properties }] of features.entries()) {
        const isCut = diagram.cellOutline(i).some((loop) => loop.some(({ curve }) => isOnBox(curve)))
        assert.equal(properties.clipped ?? false, isCut, `circle ${i}`)
      }
    })
  }
})

describe('the same bits as the native program, in a region', () => {
  const names = ['bronzefilter.csv', 'spruces.csv', 'waka.csv']
  for (const { name, metric, share } of [
    ...names.map((name) => ({ name, metric: /** @type {const} */ ('circles'), share: undefined })),
    ...names.flatMap((name) => METRICS.map((metric) => ({ name, metric, share: 0.02 }))),
  ]) {
    it(`clipped: ${name}, ${metric}${share ? ', within a distance' : ''}`, () => {
      const file = `${ROOT}tests/fixtures/${name}`
      const diagram = compute(nativeDiagram(file, {}).circles, { metric })
      const box = exportBox(diagram.circles)
      const { json, shape } = regionAround(box)
      const maxDistance = share && share * (box.maxX - box.minX)
      const regionFile = written('region.json', json)
      const tolerance = diagram.circles.length * 1e-6
      const options = [
        '--region',
        regionFile,
        '--tolerance',
        String(tolerance),
        '--digits',
        '40',
        '--format',
        'geojson',
        '--metric',
        metric,
        ...(maxDistance ? ['--max-distance', String(maxDistance)] : []),
      ]
      const native = JSON.parse(printed('compute', file, ...options)).features
      const limits = { region: shape, maxDistance }
      const polygons = Array.from(native, (_, i) => diagram.cellPolygon(i, { ...limits, tolerance }))
      assert.deepStrictEqual(
        polygons.map(geometryOf),
        native.map(({ geometry }) => geometry),
      )
      const areas = native.map(({ properties }) => properties.area)
      assert.deepStrictEqual([...diagram.cellAreas(limits)], areas)
      assert.ok(areas.filter((area) => area > 0).length > 10)
    })
  }

  for (const [count, decades, metric] of /** @type {const} */ ([
    [40, 0, 'circles'],
    [150, 2, 'circles'],
    [150, 2, 'power'],
  ])) {
    it(`fitted: ${count} areas over ${decades} decades, ${metric}`, () => {
      let state = Number(count)
      const random = () => {
        state = (state * 48_271) % 2_147_483_647
        return state / 2_147_483_647
      }
      const sites = Array.from({ length: count }, () => [random(), random()])
      const shares = sites.map(() => 1 + Math.floor((10 ** decades - 1) * random()))
      const { json, shape } = regionAround({ minX: 0, minY: 0, maxX: 1, maxY: 1 })
      const rows = sites.map(([x, y], i) => `${x},${y},0,${shares[i]}\n`)
      const file = written('sites.csv', `x,y,r,share\n${rows.join('')}`)
      const options = ['--areas', 'share', '--shares', '--region', written('region.json', json), '--format', 'json']
      options.push('--metric', metric)
      const native = JSON.parse(printed('fit', file, ...options))
      const { diagram, weights } = fitAreas(sites, shares, { region: shape, shares: true, metric })
      assert.deepStrictEqual(
        [...weights],
        native.circles.map(({ r }) => r),
      )
      const { circles: _, ...rest } = native
      const { seconds: _seconds, ...stats } = rest.stats
      assert.deepStrictEqual(asJson(diagram), { ...rest, stats })
    })
  }
})

/** A star with a hole and an island in it, in a box, as the text of GeoJSON and as a region. */
function regionAround({ minX, minY, maxX, maxY }) {
  const corners = 60
  const at = (radius, k) => {
    const angle = (2 * Math.PI * k) / corners
    return [
      (minX + maxX) / 2 + radius * (maxX - minX) * Math.cos(angle),
      (minY + maxY) / 2 + radius * (maxY - minY) * Math.sin(angle),
    ]
  }
  const ring = (radiusOf) => {
    const open = Array.from({ length: corners }, (_, k) => at(radiusOf(k), k))
    return [...open, open[0]]
  }
  const coordinates = [
    [ring((k) => 0.3 + (0.15 * ((k * k) % 7)) / 6), ring((k) => 0.1 + 0.1 * (k % 2))],
    [ring(() => 0.05)],
  ]
  const json = JSON.stringify({ type: 'MultiPolygon', coordinates })
  return { json, shape: region(JSON.parse(json)) }
}

function written(name, text) {
  const file = `${folder}/${name}`
  writeFileSync(file, text)
  return file
}

function printed(...args) {
  return execFileSync(NATIVE, args, { maxBuffer: LARGEST_OUTPUT, encoding: 'utf8' })
}

/** Converts to a geometry of GeoJSON. */
function geometryOf(polygons) {
  if (polygons === undefined) return null
  if (polygons.length === 1) return { type: 'Polygon', coordinates: polygons[0] }
  return { type: 'MultiPolygon', coordinates: polygons }
}

/** Computes the circles of a file both ways, compares, and returns the diagram. */
function compare(file, options) {
  const { circles, ...native } = nativeDiagram(file, options)
  const { seconds, ...stats } = native.stats
  const wasm = compute(circles, { ...options, weights: options.weights !== undefined })
  assert.deepStrictEqual(asJson(wasm), { ...native, stats })
  assert.deepStrictEqual(Object.keys(wasm.stats.seconds), Object.keys(seconds))
  return wasm
}

function nativeDiagram(file, options) {
  const flags = Object.entries(options).flatMap(([name, value]) => [`--${name}`, String(value)])
  const output = printed('compute', file, ...flags)
  // JSON.parse reads `-0` as -0, and deepStrictEqual distinguishes it from 0.
  return JSON.parse(output)
}

/** The parts of a diagram that the native program prints, without the circles and the time. */
function asJson(diagram) {
  const { metric, weights, vertices, vertexCircles, edges, hidden, hull, certificate } = diagram
  const { seconds: _, ...stats } = diagram.stats
  return {
    format: 'circle-voronoi',
    version: 1,
    ...(metric !== 'circles' && { metric }),
    ...(weights && { weights }),
    hidden: Array.from({ length: hidden.length / 2 }, (_, h) => ({ circle: hidden[2 * h], by: hidden[2 * h + 1] })),
    vertices: Array.from({ length: vertices.length / 3 }, (_, v) => ({
      ...vertexAt(diagram, v),
      circles: [...vertexCircles.subarray(3 * v, 3 * v + 3)],
    })),
    edges: Array.from({ length: edges.length / 4 }, (_, e) => {
      const { left, right, start, end } = edgeAt(diagram, e)
      return { circles: [left, right], vertices: [start, end] }
    }),
    hull: [...hull],
    stats: { ...stats, certificate },
  }
}
