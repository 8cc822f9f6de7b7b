// SPDX-License-Identifier: GPL-3.0-or-later
// Readers and writers of files, and their errors. tests/wasm/files.test.mjs and tests/files/round-trips.test.ts compare
// them with the program.
import { describe, expect, it } from 'vitest'
import { CIRCLE_FORMATS, DIAGRAM_FORMATS, loadFiles } from '../../web/lib/files.ts'
import { ConvexPolygon, Diagram } from '../../web/lib/index.ts'
import { untyped } from './errors.ts'
import { library } from './library.ts'

const CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const CSV = 'x,y,r\n0,0,1\n6,0,1\n0,8,1\n'
const diagram = library.compute(CIRCLES)
const files = await loadFiles()

it('circles are read and written, from text or bytes', () => {
  expect(files.writeCircles(CIRCLES)).toBe(CSV)
  for (const format of CIRCLE_FORMATS) {
    const text = files.writeCircles([[0, 0, 1], { x: 6, y: 0, r: 1 }, [0, 8, 1]], { format })
    expect(files.readCircles(text)).toEqual(CIRCLES)
    expect(files.readCircles(new TextEncoder().encode(text), { name: 'a.csv' })).toEqual(CIRCLES)
    expect(files.holdsDiagram(text)).toBe(false)
  }
  expect(files.readCircles('0,0,-1\n', { weights: true })).toEqual(Float64Array.of(0, 0, -1))
})

it('a diagram is read as it was written', () => {
  const text = files.writeDiagram(diagram)
  expect(files.holdsDiagram(text)).toBe(true)
  expect({ ...files.readDiagram(text) }).toEqual({ ...diagram })
  expect(files.writeDiagram({ ...diagram })).toBe(text)
  expect(new Set(DIAGRAM_FORMATS.map((format) => files.writeDiagram(diagram, { format }))).size).toBe(
    DIAGRAM_FORMATS.length,
  )
})

it('a diagram is drawn where, how far and how closely it is asked for', () => {
  const wkt = (options: object) => files.writeDiagram(diagram, { format: 'wkt', ...options }).split('\n')[0]
  const square = 'POLYGON ((-5 4, -5 -5, 3 -5, 3 4, -5 4))'
  expect(wkt({ bounds: [-5, -5, 10, 10] })).toBe(square)
  expect(wkt({ bounds: { minX: -5, minY: -5, maxX: 10, maxY: 10 } })).toBe(square)
  const sides = (options: object) => wkt(options)?.split(',').length ?? 0
  expect(sides({ maxDistance: 0.5, tolerance: 0.1 })).toBeLessThan(sides({ maxDistance: 0.5, tolerance: 0.001 }))
  expect(wkt({ maxDistance: 0.5, digits: 1e10 })).toBe(wkt({ maxDistance: 0.5, digits: 999 }))
  expect(wkt({ maxDistance: 0.5, digits: 1 })).toMatch(/^POLYGON \(\((-?\d(\.\d)? -?\d(\.\d)?(, )?)+\)\)$/)
})

describe('circles with attributes', () => {
  const read = (text: string, options?: object) => {
    const { circles, attributes, skipped } = files.readCircleFile(text, options)
    return { circles: [...circles], ...attributes, skipped }
  }
  it('says whether the columns are longitude and latitude', () => {
    const areDegrees = (text: string, options?: object) => files.readCircleFile(text, options).areDegrees
    expect(areDegrees('lon,lat,r\n8,50,1\n')).toBe(true)
    expect(areDegrees('Latitude;Longitude\n50;8\n', { points: true })).toBe(true)
    expect(areDegrees('[{"lng":8,"lat":50,"r":1}]')).toBe(true)
    expect(areDegrees('x,y,r\n8,50,1\n')).toBe(false)
    expect(areDegrees('lon,lat,r\n8,95,1\n')).toBe(false)
    expect(areDegrees('8,50,1\n')).toBe(false)
  })

  const NONE = { properties: [], ids: [], heights: [], collection: '', skipped: [] }

  it('are read with each option', () => {
    expect(read('1,2,3\n')).toEqual({ ...NONE, circles: [1, 2, 3] })
    expect(read('x,y,r\n1,2,-3\n', { weights: true })).toEqual({ ...NONE, circles: [1, 2, -3] })
    expect(read('x,y,r,name\n1,2,3,A\n', { points: true })).toMatchObject({ circles: [1, 2, 0] })
    const columns = { x: 'east', y: 'north', radius: 'size', id: 'code' }
    expect(read('east,north,size,code\n1,2,3,a\n4,5,6,b\n', columns)).toEqual({
      ...NONE,
      circles: [1, 2, 3, 4, 5, 6],
      properties: ['{"code":"a"}', '{"code":"b"}'],
      ids: ['"a"', '"b"'],
    })
    expect(read('x,y,r\n1,2,3\n4,,6\n7,8,9\n', { skipInvalid: true, name: 'a.csv' })).toEqual({
      ...NONE,
      circles: [1, 2, 3, 7, 8, 9],
      skipped: [{ index: 1, message: expect.stringMatching(/^a\.csv:3: /) }],
    })
    const wrong = (text: string, options: object) =>
      expect(() => read(text, options)).toThrow(expect.objectContaining({ code: 'badOption' }))
    for (const name of ['x', 'y', 'radius', 'id']) wrong('1,2,3\n', { [name]: 5 })
    for (const name of ['weights', 'points', 'skipInvalid']) wrong('1,2,3\n', { [name]: 'no' })
    wrong('1,2,3\n', { points: true, radius: 'r' })
    expect(() => read('n;a;b\nA;1;2\n', { x: 'a', y: 'b' })).toThrow('radius')
    expect(read('n;a;b\nA;1;2\nB;;2\n', { x: 'a', y: 'b', points: true, id: 'n', skipInvalid: true }).skipped).toEqual([
      { index: 1, message: expect.stringMatching(/^the text:3: /) },
    ])
  })

  const TWO = Float64Array.of(1, 2, 3, 9, 9, 1)
  const ATTRIBUTES = {
    properties: ['{"n":2}', '{}'],
    ids: ['"p"', '7'],
    heights: ['5', ''],
    collection: '{"crs":{"a":1}}',
  }

  it('are written in one line each, without the members that the format adds', () => {
    const geojson = files.writeCircles(TWO, { format: 'geojson', attributes: ATTRIBUTES })
    expect(geojson.split('\n')).toEqual([
      '{"type":"FeatureCollection","crs":{"a":1},"features":[',
      '{"type":"Feature","id":"p","properties":{"r":3,"n":2},"geometry":{"type":"Point","coordinates":[1,2,5]}},',
      '{"type":"Feature","id":7,"properties":{"r":1},"geometry":{"type":"Point","coordinates":[9,9]}}',
      ']}',
      '',
    ])
    expect(read(geojson)).toEqual({ ...NONE, ...ATTRIBUTES, circles: [...TWO] })
    const spaced = {
      properties: ['\n{\n"n":\r2 }\n', ''],
      ids: ['"p"\n', '\r7'],
      heights: ['\n5', ''],
      collection: '{"type":"a", "features":[],\n"bbox":[1],"crs":{"a":1}}',
    }
    expect(files.writeCircles(TWO, { format: 'geojson', attributes: spaced }).replaceAll(' ', '')).toBe(geojson)
    for (const member of ['type', 'features', 'bbox']) {
      const attributes = { ...ATTRIBUTES, collection: `{"${member}":1}` }
      const [head] = files.writeCircles(TWO, { format: 'geojson', attributes }).split('\n')
      expect(head).toBe('{"type":"FeatureCollection","features":[')
    }
    const nothing = { properties: [], ids: [], heights: [], collection: '' }
    for (const format of CIRCLE_FORMATS) {
      const plain = files.writeCircles(TWO, { format })
      expect(files.writeCircles(TWO, { format, attributes: nothing })).toBe(plain)
      expect(files.writeCircles(TWO, { format, attributes: untyped({}) })).toBe(plain)
    }
  })

  it('are written with diagrams in some formats', () => {
    const two = library.compute(TWO)
    for (const format of DIAGRAM_FORMATS) {
      const write = () => files.writeDiagram(two, { format, attributes: ATTRIBUTES })
      if (['json', 'geojson', 'geojsonl'].includes(format)) expect(write()).toContain('"n":2')
      else if (format === 'cells') expect(write()).toMatch(/,n\n.*,2\n/)
      else if (format === 'svg') expect(write()).not.toContain('</title></path>')
      else expect(write).toThrow(`The format ${format} takes no attributes.`)
    }
    const named = { ...ATTRIBUTES, properties: ['{"Name":"A"}', '{}'] }
    expect(files.writeDiagram(two, { format: 'svg', attributes: named })).toContain('<title>A</title></path>')
    const kept = files.readDiagramFile(files.writeDiagram(two, { attributes: ATTRIBUTES }), { name: 'a.json' })
    expect(kept.attributes).toEqual(ATTRIBUTES)
    expect({ ...kept.diagram }).toEqual({ ...two })
  })

  it.each([
    { properties: 5 },
    { ids: ['1'] },
    { properties: ['{}', '[]'] },
    { ids: ['1', 'true'] },
    { ids: ['1', 'x'] },
    { heights: ['"1"', '1'] },
    { collection: '[]' },
    { collection: 'x' },
  ])('are refused: %j', (attributes) => {
    const refused = expect.objectContaining({ code: 'badOption' })
    expect(() => files.writeCircles(TWO, { attributes: untyped(attributes) })).toThrow(refused)
    expect(() => files.writeDiagram(library.compute(TWO), { attributes: untyped(attributes) })).toThrow(refused)
  })
})

it('what is not right is said, and not drawn', () => {
  const moved = new Diagram({ ...diagram, vertices: diagram.vertices.map((value) => value + 0.001) })
  expect(() => files.writeDiagram(moved, { format: 'svg' })).toThrow(expect.objectContaining({ code: 'notCertified' }))
  expect(JSON.parse(files.writeDiagram(moved, { format: 'stats' })).certificate.certified).toBe(false)
  expect(files.readDiagram(files.writeDiagram(moved)).certificate.certified).toBe(false)
  expect(files.readDiagram(files.writeDiagram(diagram)).certificate.certified).toBe(true)
})

/** Removes the types, as in a program without them. Other misuse is in arguments.test.ts. */
const f = files as unknown as Record<keyof typeof files, (...args: unknown[]) => unknown>
const TRIANGLE = ConvexPolygon.from([
  { x: 0, y: 0 },
  { x: 1, y: 0 },
  { x: 0, y: 1 },
])

describe('misuse is one clear error', () => {
  it.each([
    ['a row of two numbers', 'badInput', () => f.readCircles('1,2')],
    ['an empty file', 'badInput', () => f.readCircles('', { name: 'a.csv' })],
    ['a negative radius', 'negativeRadius', () => f.readCircles('0,0,-1')],
    ['a name that is a number', 'badOption', () => f.readCircles('', { name: 3 })],
    [
      'a vertex without circles',
      'badInput',
      () => f.writeDiagram({ ...diagram, vertexCircles: new Int32Array(0) }, { format: 'csv' }),
    ],
    ['statistics with digits', 'badOption', () => f.writeDiagram(diagram, { format: 'stats', digits: 2 })],
    ['bounds that are no box', 'badOption', () => f.writeDiagram(diagram, { format: 'svg', bounds: TRIANGLE })],
    ...(['json', 'csv', 'stats'] as const).flatMap((format) =>
      (['bounds', 'region', 'maxDistance', 'tolerance'] as const).map(
        (name) =>
          [`${format} with ${name}`, 'badOption', () => f.writeDiagram(diagram, { format, [name]: 1 })] as const,
      ),
    ),
  ] as const)('%s', (_, code, act) => {
    expect(act).toThrow(expect.objectContaining({ name: 'CircleVoronoiError', code }))
  })

  it('where the module cannot be loaded', async () => {
    await expect(loadFiles({ wasm: new Uint8Array(8) })).rejects.toThrow(expect.objectContaining({ code: 'notLoaded' }))
  })
})

it('statistics that make no sense are written as if there were none', () => {
  const stats = {
    ...diagram.stats,
    method: 'a"b',
    counts: { ...diagram.stats.counts, exact: Number.NaN, flips: -1, samples: 0.5, filtered: 7 },
    seconds: { ...diagram.stats.seconds, total: Number.NaN },
  }
  const written = JSON.parse(files.writeDiagram({ ...diagram, stats } as unknown as typeof diagram, { format: 'json' }))
  expect(written.stats).toMatchObject({
    method: '',
    counts: { exact: 0, flips: 0, samples: 0, filtered: 7 },
    seconds: { total: 0 },
  })
})
