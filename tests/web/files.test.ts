// SPDX-License-Identifier: GPL-3.0-or-later
// Readers and writers of files, and their errors. tests/wasm/files.test.mjs and tests/files/round-trips.test.ts compare
// them with the program.
import { describe, expect, it } from 'vitest'
import { CIRCLE_FORMATS, DIAGRAM_FORMATS, loadFiles } from '../../web/lib/files.ts'
import { CircleVoronoiError, ConvexPolygon, Diagram } from '../../web/lib/index.ts'
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
  expect(wkt({ maxDistance: 0.5, digits: 1 })).toMatch(/^POLYGON \(\((-?\d(\.\d)? -?\d(\.\d)?(, )?)+\)\)$/)
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
