// SPDX-License-Identifier: GPL-3.0-or-later
// Attributes that a table brings go through each format that the page saves, and come back.
import { expect, it } from 'vitest'
import { attributesIn } from '../../web/app/files/names.ts'
import { withAttributes } from '../../web/app/files/with-attributes.ts'
import { attributesOf, columnsOf, NO_ATTRIBUTES } from '../../web/editing/attributes.ts'
import { loadFiles } from '../../web/lib/files.ts'
import type { LinkAttributes } from '../../web/lib/link.ts'
import { library } from './library.ts'

const files = await loadFiles()
const CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const FILE: LinkAttributes = {
  properties: [
    '{"name":"a, \\"b\\"","fips":"01001","n":12345678901234567890}',
    '{"name":" c","fips":"1003","n":null}',
    '{"name":"$&","fips":"06037","n":2.50}',
  ],
  ids: ['"x"', '7', ''],
  heights: ['1.5', '', '2'],
  collection: '{"crs":{"type":"name"},"bbox":[1]}',
}
const diagram = library.compute(CIRCLES)
const written = (format: 'csv' | 'geojson' | 'json' | 'cells') => {
  const plain =
    format === 'json'
      ? files.writeDiagram(diagram)
      : format === 'cells'
        ? files.writeDiagram(diagram, { format: 'geojson' })
        : files.writeCircles(CIRCLES, { format })
  return withAttributes(plain, format, FILE)
}

it('CSV has the other columns, and texts that look like numbers stay texts', () => {
  const text = written('csv')
  expect(text).toBe(
    'x,y,r,name,fips,n\n0,0,1,"a, ""b""","01001",12345678901234567890\n6,0,1," c","1003",\n0,8,1,$&,"06037",2.50\n',
  )
  expect(files.readCircles(text)).toEqual(CIRCLES)
})

it('GeoJSON has properties, ids, heights and the members of the collection', () => {
  const text = written('geojson')
  expect(files.readCircles(text)).toEqual(CIRCLES)
  const [first, second, third] = JSON.parse(text).features
  expect(JSON.parse(text).crs).toEqual({ type: 'name' })
  expect(JSON.parse(text).bbox).toBeUndefined()
  expect(first).toEqual({
    type: 'Feature',
    id: 'x',
    properties: { circle: 0, r: 1, name: 'a, "b"', fips: '01001', n: Number('12345678901234567890') },
    geometry: { type: 'Point', coordinates: [0, 0, 1.5] },
  })
  expect(text).toContain('"n":12345678901234567890')
  expect([second.id, second.geometry.coordinates, second.properties.n]).toEqual([7, [6, 0], null])
  expect(['id' in third, third.properties.name]).toEqual([false, '$&'])
})

it('cells and the diagram have them, too; a name that is taken gets another one', () => {
  const { features } = JSON.parse(written('cells'))
  expect(features.map(({ properties }: { properties: object }) => Object.keys(properties))).toEqual(
    Array(3).fill(['circle', 'r', 'area', 'neighbors', 'name', 'fips', 'n']),
  )
  const json = written('json')
  expect(files.readDiagram(json).circles).toEqual(CIRCLES)
  expect(JSON.parse(json).circles[0]).toEqual({
    ...{ x: 0, y: 0, r: 1, id: 'x', z: 1.5 },
    properties: { name: 'a, "b"', fips: '01001', n: Number('12345678901234567890') },
  })
  const own = { ...FILE, properties: ['{"area":1}', '{"area":2}', '{}'] }
  const cells = withAttributes(files.writeDiagram(diagram, { format: 'geojson' }), 'cells', own)
  expect(JSON.parse(cells).features[1].properties).toMatchObject({ area: 32.34375, input_area: 2 })
})

it('what is saved is read again, by each route', () => {
  const table = 'x,y,r,name,fips,n\n0,0,1,A,01001,1\n6,0,1,B,1003,2.5\n0,8,1,,06037,\n'
  const read = attributesIn(table, 3)
  for (const format of ['csv', 'geojson', 'json'] as const) {
    const plain = format === 'json' ? files.writeDiagram(diagram) : files.writeCircles(CIRCLES, { format })
    const text = withAttributes(plain, format, attributesOf(read as never, [0, 1, 2]))
    expect([format, attributesIn(text, 3)?.columns]).toEqual([format, read?.columns])
  }
  const { ids, heights, collection } = attributesIn(written('geojson'), 3) ?? NO_ATTRIBUTES
  expect([ids, heights, collection]).toEqual([FILE.ids, FILE.heights, '{"crs":{"type":"name"}}'])
  expect(attributesIn('x,y,r\n0,0,1', 1)).toBeUndefined()
  expect(columnsOf({ ...NO_ATTRIBUTES, properties: [] }, 1).columns).toEqual([])
})
