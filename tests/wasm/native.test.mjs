// SPDX-License-Identifier: GPL-3.0-or-later
// The WebAssembly build against the native program, on every fixture: each index and each number to the last bit.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readdirSync } from 'node:fs'
import { basename } from 'node:path'
import { describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { edgeAt, loadCircleVoronoi, vertexAt } from '../../dist/lib/index.js'
import { realData } from '../../scripts/data.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const NATIVE = `${ROOT}build/native/circle-voronoi`
const LARGEST_OUTPUT = 2 ** 28

const OPTIONS = [
  { method: 'auto' },
  { method: 'flip' },
  { method: 'touching-disc', candidates: 'dynamic', samples: 1 },
  { method: 'touching-disc', candidates: 'dynamic', samples: 3 },
  { method: 'touching-disc', candidates: 'uniform', samples: 50 },
  { method: 'touching-disc', candidates: 'all-pairs' },
]

const library = await loadCircleVoronoi()
const fixtures = readdirSync(`${ROOT}tests/fixtures`, { recursive: true }).filter((name) => name.endsWith('.csv'))

describe('the module', () => {
  it('runs where code generation from strings is forbidden', () => {
    assert.throws(() => new Function('return 1'), EvalError)
  })
})

for (const options of OPTIONS) {
  describe(`the same bits as the native program, ${Object.values(options).join(' ')}`, () => {
    for (const fixture of fixtures) it(fixture, () => compare(`${ROOT}tests/fixtures/${fixture}`, options))
  })
}

describe('the same bits as the native program, certified, on real circles', () => {
  for (const file of realData()) {
    it(basename(file), () => {
      const { certificate } = compare(file, { method: 'auto' })
      assert.equal(certificate.message, '')
      assert.equal(certificate.certified, true)
    })
  }
})

/** Computes the circles of a file both ways, compares, and returns the diagram. */
function compare(file, options) {
  const { circles, ...native } = nativeDiagram(file, options)
  const { seconds, ...stats } = native.stats
  const wasm = library.compute(circles, options)
  assert.deepStrictEqual(asJson(wasm), { ...native, stats })
  assert.deepStrictEqual(Object.keys(wasm.stats.seconds), Object.keys(seconds))
  return wasm
}

function nativeDiagram(file, options) {
  const flags = Object.entries(options).flatMap(([name, value]) => [`--${name}`, String(value)])
  const output = execFileSync(NATIVE, ['compute', file, ...flags], { maxBuffer: LARGEST_OUTPUT, encoding: 'utf8' })
  // JSON has no sign of zero to lose: `-0` is read as -0, and deepStrictEqual tells the two apart.
  return JSON.parse(output)
}

/** The parts of a diagram that the native program prints, but for the circles and the time they took. */
function asJson(diagram) {
  const { vertices, vertexCircles, edges, hidden, hull, certificate } = diagram
  const { seconds: _, ...stats } = diagram.stats
  return {
    format: 'circle-voronoi',
    version: 1,
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
