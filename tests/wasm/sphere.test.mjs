// SPDX-License-Identifier: GPL-3.0-or-later
// Circles on a sphere in WebAssembly: the bits of the native program, and the methods against brute force.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { EARTH_RADIUS, loadSphere } from '../../dist/lib/sphere.js'
import { createWorker } from '../../dist/lib/worker.js'
import { randomOf } from './tie-families.mjs'

const NATIVE = fileURLToPath(new URL('../../build/native/circle-voronoi', import.meta.url))
const { computeSphere } = await loadSphere()
const DEGREE = Math.PI / 180

function randomCaps(seed, count, largest) {
  const next = randomOf(seed)
  return Array.from({ length: count }, () => [
    360 * next() - 180,
    Math.asin(2 * next() - 1) / DEGREE,
    largest * next() ** 2,
  ])
}

const grid = []
for (let x = -180; x < 180; x += 15) for (let y = -90; y <= 90; y += 15) grid.push([x, y, 0])

const FAMILIES = {
  none: [],
  one: [[12, 34, 5]],
  two: [
    [0, 90, 100],
    [20, -40, 0],
  ],
  octahedron: [
    [0, 0, 0],
    [90, 0, 0],
    [180, 0, 0],
    [-90, 0, 0],
    [0, 90, 0],
    [0, -90, 0],
  ],
  grid,
  points: randomCaps(1, 400, 0),
  caps: randomCaps(2, 400, 900),
  covering: randomCaps(3, 60, 9000),
  near: randomCaps(4, 100, 0.01).map(([x, y, r]) => [24 + x * 1e-7, 60 + y * 1e-7, r * 1e-5]),
}

/** The distance of a place from a cap by the spherical law of cosines and its stable form. */
function distanceTo([longitude, latitude, r], x, y, radius) {
  const half = Math.sin(((latitude - y) * DEGREE) / 2) ** 2
  const turn = Math.sin(((longitude - x) * DEGREE) / 2) ** 2
  const square = half + Math.cos(latitude * DEGREE) * Math.cos(y * DEGREE) * turn
  return 2 * radius * Math.asin(Math.min(1, Math.sqrt(square))) - r
}

/** Whether a place is inside polygons in degrees. */
function contains(polygons, x, y) {
  let isInside = false
  for (const [[ax, ay], [bx, by]] of polygons.flat().flatMap((ring) => ring.slice(1).map((q, k) => [ring[k], q]))) {
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isInside = !isInside
  }
  return isInside
}

for (const [family, caps] of Object.entries(FAMILIES)) {
  describe(`the diagram of the family ${family} on a sphere`, () => {
    it('has the bits of the native program', () => {
      const text = execFileSync(NATIVE, ['compute', '-', '--sphere', '--format', 'json'], {
        input: JSON.stringify(caps),
        maxBuffer: 2 ** 28,
        stdio: ['pipe', 'pipe', 'ignore'],
        encoding: 'utf8',
      })
      const native = JSON.parse(text)
      const diagram = computeSphere(caps)
      assert.equal(diagram.rounding, native.rounding)
      const vertices = native.vertices.flatMap(({ longitude, latitude, distance }) => [longitude, latitude, distance])
      assert.deepEqual([...diagram.vertices], vertices)
      assert.deepEqual(
        [...diagram.vertexCaps],
        native.vertices.flatMap((vertex) => vertex.caps),
      )
      assert.deepEqual(
        [...diagram.edges],
        native.edges.flatMap((edge) => [...edge.caps, ...edge.vertices]),
      )
      assert.deepEqual(
        [...diagram.hidden],
        native.hidden.flatMap(({ cap, by }) => [cap, by]),
      )
    })

    it('has areas that sum to that of the sphere, and a nearest cap for each place', () => {
      const diagram = computeSphere(caps)
      const whole = 4 * Math.PI * EARTH_RADIUS ** 2
      const sum = diagram.cellAreas().reduce((a, b) => a + b, 0)
      assert.ok(Math.abs(sum / whole - (caps.length === 0 ? 0 : 1)) < 1e-12, `${sum}`)
      const next = randomOf(9)
      for (let trial = 0; trial < 100; trial++) {
        const [x, y] = [720 * next() - 360, Math.asin(2 * next() - 1) / DEGREE]
        const found = diagram.find(x, y)
        if (caps.length === 0) {
          assert.equal(found, -1)
          continue
        }
        const least = Math.min(...caps.map((cap) => distanceTo(cap, x, y, EARTH_RADIUS)))
        assert.ok(distanceTo(caps[found], x, y, EARTH_RADIUS) < least + 1e-6, `${x} ${y}`)
        assert.ok(Math.abs(diagram.distanceFrom(found, x, y) - least) < 1e-6)
      }
    })

    it('has polygons that contain the places of their cells', () => {
      const diagram = computeSphere(caps)
      const tolerance = 2
      const collection = diagram.toGeoJSON({ tolerance })
      assert.equal(collection.features.length, caps.length)
      const next = randomOf(5)
      for (let trial = 0; trial < 40 && caps.length > 0; trial++) {
        const [x, y] = [360 * next() - 180, Math.asin(2 * next() - 1) / DEGREE]
        const least = diagram.distanceFrom(diagram.find(x, y), x, y)
        for (const { properties, geometry } of collection.features) {
          if (geometry === null || !contains(geometry.coordinates, x, y)) continue
          assert.ok(diagram.distanceFrom(Number(properties.circle), x, y) < least + 2 * tolerance, `${x} ${y}`)
        }
      }
    })

    it('is the same from a worker', async () => {
      const worker = createWorker()
      const [diagram, there] = [computeSphere(caps), await worker.computeSphere(caps)]
      worker.dispose()
      assert.deepEqual(there, diagram)
      assert.deepEqual(there.cellAreas(), diagram.cellAreas())
      assert.deepEqual(there.farthestPlace(), diagram.farthestPlace())
    })
  })
}

describe('a diagram on a sphere', () => {
  it('cuts cells at a distance', () => {
    const diagram = computeSphere([
      [0, 0, 40],
      [90, 10, 0],
    ])
    const angle = 100 / diagram.radius
    const disc = 2 * Math.PI * diagram.radius ** 2 * (1 - Math.cos(angle))
    assert.ok(Math.abs(diagram.cellArea(0, { maxDistance: 60 }) / disc - 1) < 1e-10)
    const around = 2 * Math.PI * diagram.radius * Math.sin(angle)
    assert.ok(Math.abs(diagram.cellPerimeter(0, { maxDistance: 60 }) / around - 1) < 1e-10)
    assert.equal(diagram.cellPolygon(0, { maxDistance: -41 }), undefined)
  })

  it('has neighbors on both sides', () => {
    const diagram = computeSphere(FAMILIES.caps)
    for (let i = 0; i < FAMILIES.caps.length; i++) {
      for (const j of diagram.neighbors(i)) assert.ok(diagram.neighbors(j).includes(i), `${i} ${j}`)
    }
  })

  it('has the farthest place and the closest pair of the octahedron', () => {
    const diagram = computeSphere(FAMILIES.octahedron, { radius: 1 })
    assert.ok(Math.abs(Number(diagram.farthestPlace()?.distance) - Math.acos(1 / Math.sqrt(3))) < 1e-14)
    assert.ok(Math.abs(Number(diagram.closestPair()?.gap) - Math.PI / 2) < 1e-14)
    assert.equal(computeSphere([]).farthestPlace(), undefined)
    assert.equal(computeSphere([[1, 2, 3]]).closestPair(), undefined)
  })

  it('is the same from objects, arrays, data and typed arrays', () => {
    const flat = computeSphere(Float64Array.from(FAMILIES.caps.flat()))
    const objects = FAMILIES.caps.map(([longitude, latitude, r]) => ({ longitude, latitude, r }))
    const data = objects.map((cap) => ({ cap }))
    const fields = { longitude: (d) => d.cap.longitude, latitude: (d) => d.cap.latitude, r: (d) => d.cap.r }
    for (const other of [computeSphere(FAMILIES.caps), computeSphere(objects), computeSphere(data, fields)]) {
      assert.deepEqual(other, flat)
    }
  })

  it('of a worker is canceled by its signal', async () => {
    const worker = createWorker()
    const reason = new Error('enough')
    const canceled = worker.computeSphere(randomCaps(7, 1000, 1), { signal: AbortSignal.abort(reason) })
    await assert.rejects(canceled, reason)
    await assert.rejects(worker.computeSphere([[0, 99, 0]]), { code: 'coordinateTooLarge', circle: 0 })
    worker.dispose()
  })
})
