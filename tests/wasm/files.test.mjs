// SPDX-License-Identifier: GPL-3.0-or-later
// Files written in JavaScript have the bytes and errors of files written by the native program.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { loadFiles } from '../../dist/lib/files.js'
import { CircleVoronoiError, loadCircleVoronoi } from '../../dist/lib/index.js'
import { loadMetrics } from '../../dist/lib/metrics.js'
import { loadRegions } from '../../dist/lib/regions.js'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const FIXTURES = readdirSync(`${ROOT}tests/fixtures`).filter((name) => name.endsWith('.csv'))
const CORPUS = `${ROOT}tests/fuzz/reader_corpus`

const library = await loadCircleVoronoi()
const metrics = await loadMetrics({ library })
const files = await loadFiles()
const { region } = await loadRegions()

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
      for (const format of /** @type {const} */ ([
        'json',
        'csv',
        'stats',
        'svg',
        'geojson',
        'geojsonl',
        'wkt',
        'obj',
      ])) {
        const text = files.writeDiagram(diagram, { format })
        assert.equal(withoutTimes(text), run(['compute', path, '--format', format]).text, format)
      }
      const box = /** @type {const} */ ({
        format: 'wkt',
        bounds: [-3, 0.001, 7.25, 10],
        tolerance: 3e-7,
        maxDistance: 0.7,
      })
      const same = ['--format', 'wkt', '--bounds=-3,0.001,7.25,10', '--tolerance', '3e-7', '--max-distance', '0.7']
      assert.equal(files.writeDiagram(diagram, box), run(['compute', path, ...same]).text)
    })
  }

  it('clipped to a region', () => {
    const rings = [
      [
        [10, 10],
        [90, 20],
        [60, 45],
        [80, 90],
        [15, 70],
      ],
      [
        [30, 30],
        [30, 50],
        [50, 40],
      ],
    ]
    const coordinates = rings.map((ring) => [...ring, ring[0]])
    const shape = { type: /** @type {const} */ ('Polygon'), coordinates }
    const folder = mkdtempSync(`${tmpdir()}/circle-voronoi-`)
    const file = `${folder}/region.geojson`
    writeFileSync(file, JSON.stringify(shape))
    const diagram = library.compute(readCirclesOf('waka.csv'))
    const path = `${ROOT}tests/fixtures/waka.csv`
    for (const format of /** @type {const} */ (['svg', 'geojson', 'geojsonl', 'wkt', 'obj'])) {
      const text = files.writeDiagram(diagram, { format, region: region(shape), maxDistance: 8 })
      const args = ['compute', path, '--format', format, '--region', file, '--max-distance', '8']
      assert.equal(withoutTimes(text), run(args).text, format)
      assert.notEqual(text, files.writeDiagram(diagram, { format, maxDistance: 8 }))
    }
    rmSync(folder, { recursive: true })
  })

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

it('a lone surrogate is one character of a text', () => {
  const { circles, attributes } = files.readCircleFile('name,x,y,r,id\n\ud800,1,2,3,\udc00')
  assert.deepEqual([...circles], [1, 2, 3])
  assert.deepEqual(attributes.properties, ['{"name":"\ufffd","id":"\ufffd"}'])
  const lone = { ...attributes, properties: ['{"name":"\ud800"}'], ids: [] }
  const text = files.writeCircles(circles, { format: 'json', attributes: lone })
  assert.deepEqual(JSON.parse(text), [{ x: 1, y: 2, r: 3, name: '\ufffd' }])
})

describe('diagrams by other metrics', () => {
  const circles = readCirclesOf('waka.csv')
  // One weight is smaller than a step of coordinates.
  const signed = circles.map((value, k) => (k === 2 ? 2 ** -150 : k % 6 === 5 ? -value : value))
  for (const [metric, weights] of /** @type {const} */ ([
    ['centers', false],
    ['power', false],
    ['power', true],
  ])) {
    it(`by the metric ${metric}${weights ? ' with weights of any sign' : ''} are read as they were written, and drawn`, () => {
      const diagram = metrics.compute(weights ? signed : circles, { metric, weights })
      assert.equal(diagram.certificate.certified, true)
      assert.deepEqual({ ...files.readDiagram(files.writeDiagram(diagram)) }, { ...diagram })
      assert.match(files.writeDiagram(diagram, { format: 'wkt' }), /^POLYGON /)
    })
  }
})

it('circles go through every format to the bit', () => {
  const circles = Float64Array.of(-0, 5e-324, 0, 7e28, -1 / 3, 2 ** -30, 0.1, 123456789012345680, 1e-7)
  for (const format of /** @type {const} */ (['csv', 'json', 'geojson'])) {
    const text = files.writeCircles(circles, { format })
    assert.deepEqual(files.readCircles(text), circles)
    assert.deepEqual(files.readCircles(new TextEncoder().encode(text)), circles)
    const csv = files.writeCircles(circles)
    assert.equal(text, run(['convert', '-', '--format', format], csv).text)
    assert.equal(files.holdsDiagram(text), false)
  }
})

it('numbers are read as by the program', () => {
  const odd = [
    '1e400',
    '-1e400',
    '1e-400',
    '2e-324',
    '3e-324',
    '0e-400',
    'inf',
    'nan',
    'nan(1)',
    '+1',
    '1e',
    '.5',
    '5.',
  ]
  const long = ['0.1000000000000000055511151231257827021181583404541015625', '9007199254740993', '1e22']
  for (const x of [...odd, ...long, '123456789012345678901', '0x10', '-', '1e99999999999', '7e28', '8e28', '1e151']) {
    for (const text of [`${x},2,3\n`, `[[${x}, 2, 3]]`]) {
      const { status, text: written, problem } = run(['convert', '-', '--format', 'csv'], text)
      const read = () => files.writeCircles(files.readCircles(text, { name: 'standard input' }))
      if (status === 0) assert.equal(read(), written, x)
      else assert.equal(`circle-voronoi: ${errorOf(read).message}`, problem)
    }
  }
})

describe('what cannot be read is said as by the program', () => {
  for (const name of readdirSync(CORPUS)) {
    it(name, () => {
      const bytes = readFileSync(`${CORPUS}/${name}`)
      const { status, problem } = run(['convert', `${CORPUS}/${name}`, '--format', 'json'])
      const read = files.holdsDiagram(bytes) ? files.readDiagramFile : files.readCircleFile
      const action = () => read(bytes, { name: `${CORPUS}/${name}` })
      if (status === 0) action()
      // An option is called differently on the command line.
      else assert.equal(`circle-voronoi: ${errorOf(action).message.replace(/the option (\w+)/, '--$1')}`, problem)
    })
  }
})

function readCirclesOf(fixture) {
  return files.readCircles(readFileSync(`${ROOT}tests/fixtures/${fixture}`))
}
