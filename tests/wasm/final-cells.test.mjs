// SPDX-License-Identifier: GPL-3.0-or-later
// The final parts of a tile, in WebAssembly and by the native program.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { edgeAt, loadCircleVoronoi, NONE, vertexAt } from '../../dist/lib/index.js'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const NATIVE = `${ROOT}build/native/circle-voronoi`
const FIXTURE = `${ROOT}tests/fixtures/bronzefilter.csv`

const library = await loadCircleVoronoi()
const circles = readFileSync(FIXTURE, 'utf8')
  .trim()
  .split('\n')
  .map((line) => line.split(',').map(Number))
  .filter((numbers) => numbers.every(Number.isFinite))
  .map(([x, y, r]) => ({ x, y, r }))
const diagram = library.compute(circles)
const [low, high] = [Math.min, Math.max].map((extreme) => ({
  x: extreme(...circles.map(({ x }) => x)),
  y: extreme(...circles.map(({ y }) => y)),
}))
const box = { minX: low.x, minY: low.y, maxX: high.x, maxY: high.y }

describe('finalCells', () => {
  for (const maxRadius of [0, (high.x - low.x) / 50]) {
    it(`calls final what the native program writes, radius ${maxRadius}`, () => {
      const { neededHalo } = library.finalCells(diagram, { box, maxRadius })
      const known = `--known=${Object.values(box).join()}`
      const args = [
        'compute',
        FIXTURE,
        known,
        `--max-radius=${maxRadius}`,
        '--format',
        'geojsonl',
        '--bounds=0,0,1e6,1e6',
      ]
      const written = new Set()
      for (const line of finalLines(args)) written.add(JSON.parse(line).properties.circle)
      assert.ok(written.size > 20)
      assert.ok(written.size < circles.length)
      assert.deepEqual(
        [...neededHalo.keys()].filter((i) => neededHalo[i] === 0),
        [...written].sort((a, b) => a - b),
      )
    })
  }

  it('calls a vertex final if its disc lies in the box, an edge if its ends are, and a cell', () => {
    const { neededHalo, vertices, edges } = library.finalCells(diagram, { box, maxRadius: 0 })
    const inside = ({ x, y, r: radius }) => Math.min(x - box.minX, box.maxX - x, y - box.minY, box.maxY - y) - radius
    const halo = new Float64Array(circles.length)
    for (let v = 0; v < vertices.length; v++) {
      const depth = inside(vertexAt(diagram, v))
      assert.equal(vertices[v], depth > 0 ? 1 : 0)
      for (const i of diagram.vertexCircles.subarray(3 * v, 3 * v + 3)) halo[i] = Math.max(halo[i], -depth)
    }
    for (let e = 0; e < edges.length; e++) {
      const { start, end } = edgeAt(diagram, e)
      assert.equal(edges[e], start !== NONE && end !== NONE && vertices[start] === 1 && vertices[end] === 1 ? 1 : 0)
    }
    for (const i of diagram.hull) halo[i] = Infinity
    for (const i of halo.keys()) {
      assert.ok(halo[i] === neededHalo[i] || Math.abs(halo[i] - neededHalo[i]) < 1e-6 * (1 + halo[i]), `${i}`)
    }
  })

  it('calls all final where nothing is outside', () => {
    const plane = { minX: -Infinity, minY: -Infinity, maxX: Infinity, maxY: Infinity }
    const { neededHalo, edges } = library.finalCells(diagram, { box: plane, maxRadius: 0 })
    assert.ok(neededHalo.every((halo) => halo === 0))
    assert.ok(edges.every((isFinal) => isFinal === 1))
  })

  it('refuses what is no box, no radius and no diagram', () => {
    const codeOf = (given, known) => {
      try {
        library.finalCells(given, known)
        return 'none'
      } catch (error) {
        return error.code
      }
    }
    assert.equal(codeOf(diagram, { box: { ...box, maxX: box.minX }, maxRadius: 0 }), 'badOption')
    assert.equal(codeOf(diagram, { box, maxRadius: -1 }), 'badOption')
    assert.equal(codeOf(diagram, { box }), 'badInput')
    assert.equal(codeOf(diagram, { box: [0, 0, 1, 1], maxRadius: 0 }), 'badInput')
    assert.equal(codeOf(diagram, undefined), 'badInput')
    assert.equal(
      codeOf({ ...diagram, vertexCircles: diagram.vertexCircles.map((i) => i + 1000) }, { box, maxRadius: 0 }),
      'badInput',
    )
    assert.equal(codeOf(diagram, { box, maxRadius: 0 }), 'none')
  })
})

/** The lines of the native program, whose exit status says that some parts are not final. */
function finalLines(args) {
  try {
    return execFileSync(NATIVE, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] })
      .trim()
      .split('\n')
  } catch (error) {
    assert.equal(error.status, 3)
    return error.stdout.trim().split('\n')
  }
}
