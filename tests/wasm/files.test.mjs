// SPDX-License-Identifier: GPL-3.0-or-later
// Files in JavaScript against those of the native program: the same bytes, the same errors.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { readdirSync, readFileSync } from 'node:fs'
import { describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { loadComparison } from '../../dist/lib/comparison.js'
import { loadFiles } from '../../dist/lib/files.js'
import { CircleVoronoiError, Diagram, loadCircleVoronoi } from '../../dist/lib/index.js'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const FIXTURES = readdirSync(`${ROOT}tests/fixtures`).filter((name) => name.endsWith('.csv'))
const CORPUS = `${ROOT}tests/fuzz/reader_corpus`

const library = await loadCircleVoronoi()
const comparison = await loadComparison(library)
const files = await loadFiles()

function run(args, input) {
  const { status, stdout, stderr } = spawnSync(`${ROOT}build/native/circle-voronoi`, args, {
    input,
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
  })
  return { status, text: stdout.replace(/"seconds": \{[^}]*\}/g, ''), problem: stderr.trimEnd() }
}

function errorOf(action) {
  try {
    action()
  } catch (error) {
    assert.ok(error instanceof CircleVoronoiError, String(error))
    return error
  }
  throw new Error('Nothing was thrown.')
}

const withoutTimes = (text) => text.replace(/"seconds": \{[^}]*\}/g, '')

describe('a diagram is written as by the program', () => {
  for (const fixture of FIXTURES) {
    it(fixture, () => {
      const path = `${ROOT}tests/fixtures/${fixture}`
      const circles = files.readCircles(readFileSync(path))
      const diagram = library.compute(circles)
      for (const format of ['json', 'csv', 'stats', 'svg', 'geojson', 'geojsonl', 'wkt', 'obj']) {
        const text = files.writeDiagram(diagram, { format })
        assert.equal(withoutTimes(text), run(['compute', path, '--format', format]).text, format)
      }
      const box = { format: 'wkt', bounds: [-3, 0.001, 7.25, 10], tolerance: 3e-7, maxDistance: 0.7 }
      const same = ['--format', 'wkt', '--box=-3,0.001,7.25,10', '--tolerance', '3e-7', '--max-distance', '0.7']
      assert.equal(files.writeDiagram(diagram, box), run(['compute', path, ...same]).text)
    })
  }

  it('as JSON, and read again', () => {
    const diagram = library.compute(readCirclesOf('waka.csv'))
    const read = files.readDiagram(files.writeDiagram(diagram))
    assert.deepEqual({ ...read }, { ...diagram })
    assert.deepEqual({ ...files.readDiagram(JSON.stringify(diagram)) }, { ...diagram })
    assert.equal(read.render(), diagram.render())
  })
})

it('a diagram of weights says that it is one', () => {
  const circles = files.readCircles('0,0,-1\n6,0,2\n0,8,-3\n', { weights: true })
  const diagram = library.compute(circles, { weights: true })
  const text = files.writeDiagram(diagram)
  assert.equal(withoutTimes(text), run(['compute', '-', '--weights'], '0,0,-1\n6,0,2\n0,8,-3\n').text)
  assert.deepEqual({ ...files.readDiagram(text) }, { ...diagram })
})

describe('the diagrams to compare with', () => {
  const circles = readCirclesOf('waka.csv')
  it('of centres', () => {
    const diagram = comparison.computeComparison(circles, 'centres')
    const read = files.readDiagram(files.writeDiagram(diagram))
    assert.deepEqual({ ...read }, { ...diagram })
    assert.match(files.writeDiagram(diagram, { format: 'wkt' }), /^POLYGON /)
  })
  it('of powers, which are not drawn', () => {
    const diagram = comparison.computeComparison(circles, 'power')
    assert.deepEqual({ ...files.readDiagram(files.writeDiagram(diagram)) }, { ...diagram })
    const { message } = errorOf(() => files.writeDiagram(diagram, { format: 'svg' }))
    assert.equal(message, 'There is no certificate for a power diagram.')
  })
})

it('circles go through every format to the bit', () => {
  const circles = Float64Array.of(-0, 5e-324, 0, 1e150, -1 / 3, 2 ** -30, 0.1, 123456789012345680, 1e-7)
  for (const format of ['csv', 'json', 'geojson']) {
    const text = files.writeCircles(circles, { format })
    assert.deepEqual(files.readCircles(text), circles)
    assert.deepEqual(files.readCircles(new TextEncoder().encode(text)), circles)
    const csv = files.writeCircles(circles)
    assert.equal(text, run(['convert', '-', '--format', format], csv).text)
    assert.equal(files.holdsDiagram(text), false)
  }
})

describe('what cannot be read is said as by the program', () => {
  for (const name of readdirSync(CORPUS)) {
    it(name, () => {
      const bytes = readFileSync(`${CORPUS}/${name}`)
      const { status, problem } = run(['convert', `${CORPUS}/${name}`, '--format', 'json'])
      const read = files.holdsDiagram(bytes) ? files.readDiagram : files.readCircles
      const action = () => read(bytes, { name: `${CORPUS}/${name}` })
      if (status === 0) action()
      else assert.equal(`circle-voronoi: ${errorOf(action).message}`, problem)
    })
  }
})

describe('misuse is one clear error', () => {
  const diagram = library.compute([
    [0, 0, 1],
    [6, 0, 1],
    [0, 8, 1],
  ])
  const wrong = [
    ['badArgument', () => files.readCircles(5), 'readCircles takes a text or its bytes, not 5.'],
    ['badInput', () => files.readCircles('1,2'), 'the text:1: expected three numbers x,y,r separated by commas.'],
    ['badOption', () => files.readCircles('', { name: 3 }), 'The name of a file is a string, not 3.'],
    [
      'badOption',
      () => files.writeDiagram(diagram, { format: 'xml' }),
      'There is no format "xml" for this: the choice is json, csv, stats, svg, geojson, geojsonl, wkt, obj.',
    ],
    [
      'badOption',
      () => files.writeCircles([], { format: 'svg' }),
      'There is no format "svg" for this: the choice is csv, json, geojson.',
    ],
    [
      'badOption',
      () => files.writeDiagram(diagram, { format: 'csv', tolerance: 1 }),
      'The format csv takes no tolerance.',
    ],
    [
      'badOption',
      () => files.writeDiagram(diagram, { format: 'svg', tolerance: 0 }),
      'The tolerance is a number above 0, not 0.',
    ],
    [
      'badOption',
      () => files.writeDiagram(diagram, { format: 'svg', bounds: [0, 0, 0, 1] }),
      'The box is empty, or a coordinate is not finite, or beyond 1e152.',
    ],
    [
      'badOption',
      () => files.writeDiagram(diagram, { box: [0, 0, 1, 1] }),
      'There is no option box of writeDiagram; its options are format, bounds, maxDistance and tolerance.',
    ],
    [
      'badOption',
      () => files.writeDiagram(diagram, { format: 'svg', maxDistance: '1' }),
      'The maximum distance is a number up to 1e152, not "1".',
    ],
    ['badOption', () => files.readCircles('0,0,-1', { weights: 1 }), 'The option weights is true or false.'],
    ['negativeRadius', () => files.readCircles('0,0,-1'), 'the text:1: Circle 0 has a negative radius.'],
    ['badInput', () => files.writeDiagram({}), 'circles is no Float64Array of 3 numbers each.'],
  ]
  for (const [code, action, message] of wrong) {
    it(message, () => {
      const error = errorOf(action)
      assert.equal(error.message, message)
      assert.equal(error.code, code)
    })
  }

  it('a diagram that is not right is not drawn', () => {
    const moved = new Diagram({ ...diagram, vertices: diagram.vertices.map((value) => value + 0.001) })
    assert.equal(errorOf(() => files.writeDiagram(moved, { format: 'svg' })).code, 'notCertified')
    assert.equal(JSON.parse(files.writeDiagram(moved, { format: 'stats' })).certificate.certified, false)
    assert.equal(files.readDiagram(files.writeDiagram(moved)).certificate.certified, false)
  })
})

function readCirclesOf(fixture) {
  return files.readCircles(readFileSync(`${ROOT}tests/fixtures/${fixture}`))
}
