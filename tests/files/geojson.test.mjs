// SPDX-License-Identifier: GPL-3.0-or-later
// Reads GeoJSON of 135,233 cities back with d3-geo in the plane.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { geoPath } from 'd3-geo'
import { realData } from '../../scripts/data.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const NATIVE = `${ROOT}build/native/circle-voronoi`

let folder
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-files-'))
})
after(() => rmSync(folder, { recursive: true, force: true }))

for (const input of realData().filter((file) => basename(file).startsWith('cities-'))) {
  describe(basename(input), () => {
    // Without a projection d3-geo computes in the plane.
    const path = geoPath()
    let circles
    let bbox
    let features
    let diagram

    before(() => {
      const [json, geojson] = ['diagram.json', 'cells.geojson'].map((name) => join(folder, name))
      execFileSync(NATIVE, ['compute', input, '-o', json])
      execFileSync(NATIVE, ['convert', json, '-o', geojson])
      diagram = JSON.parse(readFileSync(json, 'utf8'))
      circles = diagram.circles
      ;({ bbox, features } = JSON.parse(readFileSync(geojson, 'utf8')))
    })

    it('has a feature for each circle, and a polygon for each that is visible', () => {
      const hiders = new Map(diagram.hidden.map(({ circle, by }) => [circle, by]))
      assert.equal(features.length, 135233)
      for (const [i, { properties, geometry }] of features.entries()) {
        assert.equal(properties.circle, i)
        assert.equal(properties.r, circles[i].r)
        assert.equal(properties.hiddenBy, hiders.get(i))
        assert.equal(geometry?.type, hiders.has(i) ? undefined : 'Polygon', `circle ${i}`)
      }
    })

    it('has polygons whose areas are those of the box and of the cells', () => {
      const [[minX, minY], [maxX, maxY]] = path.bounds({ type: 'FeatureCollection', features })
      const box = (maxX - minX) * (maxY - minY)
      assert.deepEqual(bbox, [minX, minY, maxX, maxY])
      // The box of the circles has a margin of a twentieth of its longer side.
      const left = circles.reduce((least, { x, r }) => Math.min(least, x - r), Number.POSITIVE_INFINITY)
      const right = circles.reduce((most, { x, r }) => Math.max(most, x + r), Number.NEGATIVE_INFINITY)
      assert.ok(Math.abs((maxX - minX) / (right - left) - 1.1) < 1e-9)
      let polygons = 0
      for (const feature of features) {
        if (feature.geometry === null) continue
        const area = path.area(feature)
        // The polygon deviates from the cell by at most the tolerance along the perimeter.
        const tolerance = 1e-5 * Math.max(maxX - minX, maxY - minY)
        const { area: whole, clipped } = feature.properties
        const beyond = (whole ?? Number.POSITIVE_INFINITY) - area
        assert.ok(clipped ? beyond > 0 : Math.abs(beyond) <= tolerance * path.measure(feature))
        polygons += area
      }
      assert.ok(Math.abs(polygons / box - 1) < 1e-9)
    })

    it('has rings that are closed, counter-clockwise and simple', () => {
      for (const { geometry, properties } of features) {
        for (const ring of geometry?.coordinates ?? []) {
          assert.deepEqual(ring[0], ring.at(-1))
          assert.ok(ring.length >= 4)
          assert.ok(signedArea(ring) > 0)
          assert.ok(isSimple(ring), `circle ${properties.circle}`)
        }
      }
    })

    it('has the neighbors of the diagram', () => {
      const count = features.reduce((sum, { properties }) => sum + properties.neighbors.length, 0)
      assert.equal(count, 2 * diagram.edges.length)
      for (const { circles: pair } of diagram.edges) {
        for (const [i, j] of [pair, [...pair].reverse()]) assert.ok(features[i].properties.neighbors.includes(j))
      }
    })
  })
}

/**
 * The signed area, positive if counter-clockwise, relative to the first point, so that small distant rings keep their
 * digits.
 */
function signedArea(ring) {
  let twice = 0
  for (let k = 2; k < ring.length - 1; ++k) twice += turn(ring[0], ring[k - 1], ring[k])
  return twice / 2
}

/** Twice the area of the triangle p, q, r: positive if it is counter-clockwise. */
function turn([px, py], [qx, qy], [rx, ry]) {
  return (qx - px) * (ry - py) - (qy - py) * (rx - px)
}

/** Whether no two sides of a ring cross. */
function isSimple(ring) {
  for (let i = 0; i + 1 < ring.length; ++i) {
    for (let j = i + 2; j + 1 < ring.length; ++j) {
      if (cross(ring[i], ring[i + 1], ring[j], ring[j + 1])) return false
    }
  }
  return true
}

/** Whether the interiors of two segments intersect. */
function cross(p, q, r, s) {
  return turn(p, q, r) * turn(p, q, s) < 0 && turn(r, s, p) * turn(r, s, q) < 0
}
