// SPDX-License-Identifier: GPL-3.0-or-later
// Readers and writers of files, and their errors. tests/wasm/files.test.mjs and tests/files/round-trips.test.ts compare
// them with the program.
import { describe, expect, it } from 'vitest'
import { CIRCLE_FORMATS, DIAGRAM_FORMATS, loadFiles } from '../../web/lib/files.ts'
import { CircleVoronoiError, ConvexPolygon, Diagram } from '../../web/lib/index.ts'
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
  expect(new Set(DIAGRAM_FORMATS.map((format) => files.writeDiagram(diagram, { format }))).size).toBe(8)
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
      skipped: [{ index: 1, message: 'a.csv:3: y is empty.' }],
    })
    for (const name of ['x', 'y', 'radius', 'id']) {
      const says = `The option ${name} is the name of a column, not 5.`
      expect(() => read('1,2,3\n', { [name]: 5 })).toThrow(says)
    }
    for (const name of ['weights', 'points', 'skipInvalid']) {
      expect(() => read('1,2,3\n', { [name]: 'no' })).toThrow(`The option ${name} is true or false.`)
    }
    expect(() => read('1,2,3\n', { points: true, radius: 'r' })).toThrow('The option points takes no radius.')
    expect(() => read('n;a;b\nA;1;2\n', { x: 'a', y: 'b' })).toThrow('name one by the option radius.')
    expect(read('n;a;b\nA;1;2\nB;;2\n', { x: 'a', y: 'b', points: true, id: 'n', skipInvalid: true }).skipped).toEqual([
      { index: 1, message: 'the text:3: a is empty (circle 1, n B).' },
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
      else expect(write).toThrow(`The format ${format} takes no attributes.`)
    }
    const kept = files.readDiagramFile(files.writeDiagram(two, { attributes: ATTRIBUTES }), { name: 'a.json' })
    expect(kept.attributes).toEqual(ATTRIBUTES)
    expect({ ...kept.diagram }).toEqual({ ...two })
  })

  it.each<[object, string]>([
    [{ properties: 5 }, 'The properties of attributes are a list, not 5.'],
    [{ ids: ['1'] }, 'There are 1 ids in the attributes of 2 circles.'],
    [{ properties: ['{}', '[]'] }, 'The properties of circle 1 are "[]", which is not such JSON.'],
    [{ ids: ['1', 'true'] }, 'The ids of circle 1 are "true", which is not such JSON.'],
    [{ ids: ['1', 'x'] }, 'The ids of circle 1 are "x", which is not such JSON.'],
    [{ heights: ['"1"', '1'] }, 'The heights of circle 0 are "\\"1\\"", which is not such JSON.'],
    [{ collection: '[]' }, 'The collection of attributes is no JSON object.'],
    [{ collection: 'x' }, 'The collection of attributes is no JSON object.'],
  ])('are refused: %j', (attributes, message) => {
    for (const write of [
      () => files.writeCircles(TWO, { attributes: untyped(attributes) }),
      () => files.writeDiagram(library.compute(TWO), { attributes: untyped(attributes) }),
    ]) {
      expect(write).toThrow(expect.objectContaining({ code: 'badOption', message }))
    }
  })
})

it('what is not right is said, and not drawn', () => {
  const moved = new Diagram({ ...diagram, vertices: diagram.vertices.map((value) => value + 0.001) })
  expect(() => files.writeDiagram(moved, { format: 'svg' })).toThrow(expect.objectContaining({ code: 'notCertified' }))
  expect(JSON.parse(files.writeDiagram(moved, { format: 'stats' })).certificate.certified).toBe(false)
  expect(files.readDiagram(files.writeDiagram(moved)).certificate.certified).toBe(false)
  expect(files.readDiagram(files.writeDiagram(diagram)).certificate.certified).toBe(true)
})

/** Removes the types, as in a program without them. */
const f = files as unknown as Record<keyof typeof files, (...args: unknown[]) => unknown>
const MISUSE: readonly (readonly [code: string, says: string, act: () => unknown])[] = [
  ['badInput', 'readCircles takes a text or its bytes, not 5.', () => f.readCircles(5)],
  ['badInput', 'readDiagram takes a text or its bytes, not an object.', () => f.readDiagram({})],
  ['badInput', 'holdsDiagram takes a text or its bytes, not undefined.', () => f.holdsDiagram()],
  ['badInput', 'the text:1: expected three numbers x,y,r separated by commas.', () => f.readCircles('1,2')],
  ['badInput', 'a.csv:1: the text is empty.', () => f.readCircles('', { name: 'a.csv' })],
  ['negativeRadius', 'the text:1: Circle 0 has a negative radius.', () => f.readCircles('0,0,-1')],
  ['badOption', 'The name of a file is a string, not 3.', () => f.readCircles('', { name: 3 })],
  ['badOption', 'The option weights is true or false.', () => f.readCircles('0,0,-1', { weights: 1 })],
  [
    'badOption',
    'There is no option weights of readDiagram; its only one is name.',
    () => f.readDiagram('', { weights: true }),
  ],
  ['badInput', 'The circles are neither a typed array nor a list, but "0,0,1".', () => f.writeCircles('0,0,1')],
  [
    'badOption',
    'There is no format "svg" for this: the choice is csv, json, geojson.',
    () => f.writeCircles([], { format: 'svg' }),
  ],
  [
    'badOption',
    'There is no option digits of writeCircles; its options are format and attributes.',
    () => f.writeCircles([], { digits: 3 }),
  ],
  ['badInput', 'circles is no Float64Array of 3 numbers each.', () => f.writeDiagram({})],
  ['badInput', 'circles is no Float64Array of 3 numbers each.', () => f.writeDiagram()],
  [
    'badInput',
    'circles is no Float64Array of 3 numbers each.',
    () => f.writeDiagram(undefined, { format: 'svg', maxDistance: 1 }),
  ],
  [
    'badInput',
    'There are not as many vertexCircles as vertices.',
    () => f.writeDiagram({ ...diagram, vertexCircles: new Int32Array(0) }, { format: 'csv' }),
  ],
  ['nonFinite', 'Circle 0 has an x that is not a finite number.', () => f.writeCircles([[Number.NaN, 0, 1]])],
  [
    'coordinateTooLarge',
    'Circle 1 has a coordinate or a radius beyond 7.9e28 (2^96).',
    () =>
      f.writeCircles([
        [0, 0, 1],
        [0, 1e160, 1],
      ]),
  ],
  ['badInput', 'weights is not true or false, but "no".', () => f.writeDiagram({ ...diagram, weights: 'no' })],
  [
    'badOption',
    'There is no format "xml" for this: the choice is json, csv, stats, svg, geojson, geojsonl, wkt, obj.',
    () => f.writeDiagram(diagram, { format: 'xml' }),
  ],
  ...(['json', 'csv', 'stats'] as const).flatMap((format) =>
    (['bounds', 'region', 'maxDistance', 'tolerance'] as const).map(
      (name) =>
        [
          'badOption',
          `The format ${format} takes no ${name}.`,
          () => f.writeDiagram(diagram, { format, [name]: 1 }),
        ] as const,
    ),
  ),
  [
    'badOption',
    'The region of writeDiagram is made by loadRegions().region, not 1.',
    () => f.writeDiagram(diagram, { format: 'svg', region: 1 }),
  ],
  ['badOption', 'The format stats takes no digits.', () => f.writeDiagram(diagram, { format: 'stats', digits: 2 })],
  ...[-1, 2.5, '2', Number.NaN].map(
    (digits) =>
      [
        'badOption',
        `The number of digits is a whole number from 0, not ${JSON.stringify(digits).replace('null', 'NaN')}.`,
        () => f.writeDiagram(diagram, { digits }),
      ] as const,
  ),
  ...[0, -1, Number.POSITIVE_INFINITY, Number.NaN].map(
    (tolerance) =>
      [
        'badOption',
        `The tolerance is a finite number above 0, not ${tolerance}.`,
        () => f.writeDiagram(diagram, { format: 'svg', tolerance }),
      ] as const,
  ),
  [
    'badOption',
    'The box is empty, or a coordinate is not finite, or beyond 1.2e30 (2^100).',
    () => f.writeDiagram(diagram, { format: 'svg', bounds: [0, 0, 0, 1] }),
  ],
  [
    'badOption',
    'The bounds of a file are a box.',
    () =>
      f.writeDiagram(diagram, {
        format: 'svg',
        bounds: ConvexPolygon.from([
          { x: 0, y: 0 },
          { x: 1, y: 0 },
          { x: 0, y: 1 },
        ]),
      }),
  ],
  [
    'badOption',
    'The maximum distance is a number up to 1.2e30 (2^100), not "1".',
    () => f.writeDiagram(diagram, { format: 'svg', maxDistance: '1' }),
  ],
  [
    'badOption',
    'There is no option box of writeDiagram; its options are format, bounds, region, maxDistance, tolerance, digits and attributes.',
    () => f.writeDiagram(diagram, { box: [0, 0, 1, 1] }),
  ],
]

describe('misuse is one clear error', () => {
  for (const [code, says, act] of MISUSE) {
    it(`${code}: ${says}`, () => {
      expect(act).toThrow(CircleVoronoiError)
      expect(act).toThrow(expect.objectContaining({ code, message: says }))
    })
  }

  it('where the module cannot be loaded', async () => {
    await expect(loadFiles({ wasm: new Uint8Array(8) })).rejects.toThrow(expect.objectContaining({ code: 'notLoaded' }))
    await expect(loadFiles({ url: 'x' } as object)).rejects.toThrow('There is no option url of loadFiles')
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
