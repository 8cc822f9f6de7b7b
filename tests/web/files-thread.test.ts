// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of the files thread: what it reads and writes, and its failures.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { HowRead, NamedCircles, NamedColumns, Read, SavedFormat } from '../../web/app/files/files-protocol.ts'
import { regionOfText } from '../../web/app/files/region-file.ts'
import { attributesOf } from '../../web/editing/attributes.ts'
import type { Lattice } from '../../web/lib/index.ts'
import { decodeLink } from '../../web/lib/link.ts'
import type { FromThread } from '../../web/lib/threads/channel.ts'
import { library } from './library.ts'

const replies: FromThread[] = []
beforeEach(async () => {
  vi.stubGlobal('postMessage', (reply: FromThread) => replies.push(reply))
  await import('../../web/app/files/files-thread.ts')
})
afterEach(() => vi.unstubAllGlobals())

async function ask(data: object) {
  const { onmessage } = globalThis as unknown as { onmessage: (event: object) => Promise<void> }
  await onmessage({ data })
  return replies.at(-1)
}
const call = async (name: string, ...args: unknown[]) =>
  ((await ask({ id: 9, name, args })) as { value?: unknown }).value
const read = (text: string, how?: HowRead, name = 'a.csv') =>
  call('read', new TextEncoder().encode(text), name, how) as Promise<Read & { circles: Float64Array }>

it('says what went wrong, about which circle if about one, and tries again when it is asked again', async () => {
  vi.stubGlobal('fetch', () => Promise.reject(new Error('The network is gone')))
  const platform = vi.spyOn(process, 'getBuiltinModule').mockReturnValue(undefined as never)
  const error = { code: 'notLoaded', circle: undefined, message: expect.stringContaining('The network is gone') }
  expect(await ask({ id: 1, name: 'catalogue', args: [] })).toEqual({ id: 1, error })
  platform.mockRestore()
  const value = { families: expect.anything(), figures: expect.anything() }
  expect(await ask({ id: 2, name: 'catalogue', args: [] })).toEqual({ id: 2, value })
  const wrong = { id: 3, name: 'read', args: [new TextEncoder().encode('0,0,1\n5,0,-1\n'), 'a.csv'] }
  const refused = { code: 'negativeRadius', circle: 1, message: expect.stringMatching(/^a\.csv:2: Circle 1 /) }
  expect(await ask(wrong)).toEqual({ id: 3, error: refused })
})

it('generates circles and writes links', async () => {
  expect(await call('make', { kind: 'family', family: 'grid', seed: 1, count: 9 })).toHaveLength(27)
  const link = await call('link', { circles: Float64Array.of(1, 2, 3) })
  expect((await decodeLink(link as string)).circles).toEqual(Float64Array.of(1, 2, 3))
})

describe('a file', () => {
  it('of circles alone has no attributes', async () => {
    expect(await read('1,2,3\n')).toEqual({ circles: Float64Array.of(1, 2, 3) })
  })

  it('has its other columns, and counts the rows that are skipped if it is asked to skip them', async () => {
    const text = 'x,y,r,n\n1,2,3,7\n4,5,a,8\n4,5,6,9\n'
    const { circles, ...rest } = await read(text, { skipsInvalid: true })
    expect(circles).toEqual(Float64Array.of(1, 2, 3, 4, 5, 6))
    expect(rest).toEqual({
      attributes: { columns: [{ name: 'n', values: ['7', '9'] }], ids: [], heights: [], collection: '' },
      skipped: 1,
    })
    expect(await read(text)).toBeUndefined()
    expect(await read('1,2,3\n', { skipsInvalid: true })).toEqual({ circles: Float64Array.of(1, 2, 3), skipped: 0 })
  })

  const TABLE = 'n,a,b,c\n7,1,2,4\n8,4,5,9\n'
  const ROW = { x: 'a', y: 'b', radius: 'c', kind: 'radius', factor: 1 } as const
  it.each<[NamedColumns, number[], string[]]>([
    [ROW, [1, 2, 4, 4, 5, 9], ['n']],
    [{ ...ROW, x: 'b', y: 'a', kind: 'diameter' }, [2, 1, 2, 5, 4, 4.5], ['c', 'n']],
    [{ ...ROW, kind: 'root', factor: 0.5 }, [1, 2, 1, 4, 5, 1.5], ['c', 'n']],
    [{ ...ROW, factor: 10 }, [1, 2, 40, 4, 5, 90], ['c', 'n']],
    [{ ...ROW, radius: { all: 9 } }, [1, 2, 9, 4, 5, 9], ['n', 'c']],
  ])('has the columns that were chosen, and keeps numbers that are no radii: %j', async (columns, expected, names) => {
    const { circles, attributes } = (await read(TABLE, { columns })) as NamedCircles
    expect([...circles]).toEqual(expected)
    expect(attributes?.columns.map(({ name }) => name)).toEqual(names)
    if (names[0] === 'c') expect(attributes?.columns[0]?.values).toEqual(['4', '9'])
  })

  const feature = (geometry: object, properties: object = {}) => ({ type: 'Feature', properties, geometry })
  const point = (x: number, properties: object = { radius: 2 }) =>
    feature({ type: 'Point', coordinates: [x, 0] }, properties)
  const POLYGON = feature({
    type: 'Polygon',
    coordinates: [
      [
        [0, 0],
        [9, 0],
        [0, 9],
        [0, 0],
      ],
    ],
  })
  const collection = (...features: object[]) => JSON.stringify({ type: 'FeatureCollection', features })

  it('of points has no polygons that are its region, but names those that are not', async () => {
    const text = collection(point(1), POLYGON, point(5))
    expect([...(await read(text, { polygons: [1] })).circles]).toEqual([1, 0, 2, 5, 0, 2])
    expect(await read(text)).toBeUndefined()
    expect(await read(collection(point(1), POLYGON, point(5, {})), { polygons: [1] })).toBeUndefined()
    expect(replies.at(-1)).toMatchObject({ error: { message: expect.stringContaining('feature 2') } })
  })

  it('of a diagram has its circles', async () => {
    const text = await call('write', Float64Array.of(0, 0, 1, 9, 0, 2), 'json', {}, undefined)
    expect(await read(text as string, {}, 'a.json')).toEqual({ circles: Float64Array.of(0, 0, 1, 9, 0, 2) })
  })

  it('of a drawing has its link, its table or its circles', async () => {
    const svg = (content: string) =>
      `<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg">\n${content}\n</svg>\n`
    expect(await read(svg('<metadata id="circle-voronoi">v1.abc</metadata>'), {}, 'a.svg')).toEqual({ link: 'v1.abc' })
    const table = '<metadata id="circle-voronoi-circles">\nx,y,r\n1,2,3\n</metadata>'
    expect((await read(svg(table), {}, 'a.svg')).circles).toEqual(Float64Array.of(1, 2, 3))
    const circle = '<circle data-circle="0" class="c" cx="1" cy="2" r="3"/>'
    for (const head of ['', '<!-- by hand -->\n', '<!DOCTYPE svg>\n']) {
      const text = `${head}<svg>\n<g class="circles">\n${circle}\n</g>\n</svg>`
      expect((await read(text, {}, 'a.svg')).circles, head).toEqual(Float64Array.of(1, 2, 3))
    }
    const group = (lines: string[]) => svg(`<g class="circles">\n${lines.join('\n')}\n</g>`)
    const wrong = [
      svg(''),
      group([]),
      group([circle.replace('"0"', '"1"')]),
      group([circle, circle]),
      group([circle.replace('cx="1"', 'cx="a"')]),
      svg(`<g id="given-1"></g><g class="circles">\n${circle}\n</g>`),
    ]
    for (const text of wrong) {
      await read(text, {}, 'a.svg')
      expect(replies.at(-1)).toMatchObject({
        error: { code: 'badInput', message: expect.stringContaining('a.svg') },
      })
    }
  })
})

it('a preview counts the circles that others hide, and has the edges around the origin', async () => {
  const far = Float64Array.of(1e7, 1e7, 5, 1e7 + 1, 1e7, 1, 1e7 + 20, 1e7, 2, 1e7, 1e7 + 20, 2)
  const { hidden, edges } = (await call('preview', far)) as { hidden: number[]; edges: string }
  expect(hidden).toEqual([1])
  const numbers = edges.match(/-?\d+(\.\d+)?/g)?.map(Number) ?? []
  expect(numbers.length).toBeGreaterThan(5)
  expect(Math.max(...numbers.map(Math.abs))).toBeLessThan(60)
})

describe('saved data', () => {
  const CIRCLES = Float64Array.of(0, 0, 1, 10, 0, 2, 0, 20, 3)
  const ATTRIBUTES = {
    properties: ['{"n":1.50}', '{}', '{ "a" : "}" }'],
    ids: ['"p"', '', '7'],
    heights: [],
    collection: '',
  }
  const write = (format: SavedFormat, domain: object = {}, attributes?: object) =>
    call('write', CIRCLES, format, domain, attributes) as Promise<string>

  it.each([
    ['Ost;"Nord, m";Gewicht\n0;0;1\n9;0;2\n', { x: 'Ost', y: 'Nord, m', radius: 'Gewicht' }, 'Ost,"Nord, m",Gewicht'],
    ['lon,LAT,rad,n\n0,0,1,7\n9,0,2,8\n', undefined, 'lon,LAT,rad,n'],
    ['a b c\n0 0 1\n9 0 2\n', { x: 'a', y: 'b', radius: 'c', kind: 'diameter' }, 'a,b,r,c'],
    ['0;0;1\n9;0;2\n', undefined, 'x,y,r'],
    ['7;0;0;1\n8;9;0;2\n', { x: '#2', y: '#3', radius: '#4' }, 'x,y,r,column 1'],
    ['[{"cx":0,"cy":0,"r":1},{"cx":9,"cy":0,"r":2}]', undefined, 'cx,cy,r'],
  ])('keeps the headings of a table: %s', async (text, columns, heading) => {
    const chosen = columns && ({ kind: 'radius', factor: 1, ...columns } as NamedColumns)
    const { circles, attributes, headings } = (await read(text, { columns: chosen })) as NamedCircles
    const rows = attributes && attributesOf(attributes, [0, 1])
    const csv = (await call('write', circles, 'csv', {}, rows, headings)) as string
    expect(csv.split('\n')[0]).toBe(heading)
    expect([
      ...((await read(csv, { columns: undefined })) ?? (await read(csv, { columns: inCsv(heading) }))).circles,
    ]).toEqual([...circles])
  })
  const inCsv = (heading: string): NamedColumns => {
    const [x = '', y = '', radius = ''] = [...heading.matchAll(/"([^"]*)"|([^,]+)/g)].map(([, a, b]) => a ?? b)
    return { x, y, radius, kind: 'radius', factor: 1 } as NamedColumns
  }

  it('keeps the name of the radius in GeoJSON, and has the region as its last feature', async () => {
    const text = JSON.stringify({
      type: 'FeatureCollection',
      features: [
        {
          type: 'Feature',
          id: 'a"b',
          properties: { Radius: 2, n: { properties: { r: 1 } } },
          geometry: { type: 'Point', coordinates: [0, 0] },
        },
      ],
    })
    const { circles, attributes, headings } = (await read(text, {}, 'a.geojson')) as NamedCircles
    const region = [
      [
        [-1, -1],
        [5, -1],
        [5, 5],
        [-1, 5],
      ],
      [
        [1, 1],
        [2, 1],
        [2, 2],
        [1, 2],
      ],
    ]
    const rows = attributes && attributesOf(attributes, [0])
    const saved = (await call('write', circles, 'geojson', { region }, rows, headings)) as string
    const { features } = JSON.parse(saved)
    expect(features[0]).toEqual(JSON.parse(text).features[0])
    expect(features).toHaveLength(2)
    expect(features[1].geometry.coordinates.map((rings: number[][][]) => rings.map(({ length }) => length))).toEqual([
      [5, 5],
    ])
    const found = regionOfText(saved)
    expect(found?.polygons).toEqual([1])
    expect([...(await read(saved, { polygons: found?.polygons })).circles]).toEqual([0, 0, 2])
    const none = (await call('write', new Float64Array(), 'geojson', { region })) as string
    expect(JSON.parse(none).features).toHaveLength(1)
  })

  it('of cells that repeat has whole cells, with ids and properties as they are written in the file', async () => {
    const lattice: Lattice = { a: [40, 0], b: [0, 50] }
    const text = await write('cells', { lattice }, ATTRIBUTES)
    expect(text.endsWith('\n]}\n')).toBe(true)
    const { features } = JSON.parse(text)
    expect(features.map(({ id }: { id: unknown }) => id)).toEqual(['p', undefined, 7])
    expect(text).toContain('"n":1.50}')
    const properties = features.map((feature: { properties: object }) => feature.properties)
    expect(properties[2]).toMatchObject({ circle: 2, r: 3, a: '}' })
    expect(properties.reduce((sum: number, { area }: { area: number }) => sum + area, 0)).toBeCloseTo(2000, 6)
    const periodic = library.computePeriodic(CIRCLES, lattice)
    for (const [circle, { neighbors, shifts }] of properties.entries()) {
      const images = periodic.neighbors(circle)
      expect([neighbors, shifts]).toEqual([images.map((image) => image.circle), images.map((image) => image.shift)])
    }
    expect(features[0].geometry.type).toBe('Polygon')
    expect(Object.keys(JSON.parse(await write('cells', { lattice })).features[0])).toEqual([
      'type',
      'properties',
      'geometry',
    ])
  })
})
