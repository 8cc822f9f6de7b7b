// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of other programs, names of circles, and pictures as circles.
import { describe, expect, it } from 'vitest'
import { parseNamed } from '../../web/app/csv.ts'
import { circlesFrom, guessedColumns, type Rows, rowsOf } from '../../web/app/files/columns.ts'
import { stippled } from '../../web/app/files/stipple.ts'
import { randomNumbers } from '../../web/app/random-circles.ts'
import { attributesOf, columnsOf, NO_ATTRIBUTES } from '../../web/editing/attributes.ts'
import { loadFiles } from '../../web/lib/files.ts'

const rows = (text: string) => rowsOf(text) as Rows

describe('a table', () => {
  it('has a heading or none, any separator, decimal commas, and separators in quotes', () => {
    expect(rows('a;b\n1,5;2\n')).toEqual({
      heading: ['a', 'b'],
      hasHeading: true,
      rows: [['1,5', '2']],
      hasDecimalCommas: true,
    })
    expect(rows('1,2\n3,4').heading).toEqual(['Column 1', 'Column 2'])
    expect(rows('name,x,y\n"Bonn, am Rhein",1,2').rows).toEqual([['Bonn, am Rhein', '1', '2']])
    for (const text of ['', 'words and words', 'a,b\nc,d', '1\n2']) expect(rowsOf(text)).toBeUndefined()
  })

  it.each([
    ['X-Koordinate;Y-Koordinate;Radius', { x: 0, y: 1, r: 2 }],
    ['Stadt;Rechtswert;Hochwert;Durchmesser', { x: 1, y: 2, r: 3, name: 0, isDiameter: true }],
    ['longitude,latitude,radius_km,Name', { x: 0, y: 1, r: 2, name: 3 }],
    ['center_x\tcenter_y\tdbh', { x: 0, y: 1, r: 2, isDiameter: true }],
    ['x;y;diameter;radius', { x: 0, y: 1, r: 3 }],
    ['a,b,c', {}],
  ])('tells by the names of its columns what they are: %s', (heading, columns) => {
    const separator = /[;\t,]/.exec(heading)?.[0] as string
    const line = heading.split(separator).map((_, k) => String(k + 1))
    expect(guessedColumns(rows(`${heading}\n${line.join(separator)}`))).toEqual({
      name: undefined,
      isDiameter: false,
      ...columns,
    })
  })

  it('becomes circles, by diameters, with one radius or with names, or says which row is none', () => {
    const table = rows('n;a;b;c\nu;1,5;2;3\nv;4;5;6')
    const columns = { x: 1, y: 2, r: 3, name: 0 }
    expect(circlesFrom(table, columns, false, 'f')).toEqual({
      circles: Float64Array.of(1.5, 2, 3, 4, 5, 6),
      attributes: { ...NO_ATTRIBUTES, columns: [{ name: 'n', values: ['"u"', '"v"'] }] },
    })
    expect(circlesFrom(table, columns, true, 'f').circles).toEqual(Float64Array.of(1.5, 2, 1.5, 4, 5, 3))
    const same = { ...columns, r: { all: 0.5 }, name: undefined }
    expect(circlesFrom(table, same, false, 'f')).toEqual({
      circles: Float64Array.of(1.5, 2, 0.5, 4, 5, 0.5),
      attributes: {
        ...NO_ATTRIBUTES,
        columns: [
          { name: 'n', values: ['"u"', '"v"'] },
          { name: 'c', values: ['3', '6'] },
        ],
      },
    })
    expect(() => circlesFrom(table, { ...columns, r: 0 }, false, 'f')).toThrow(
      'f, row 1: “u” in column n is not a number.',
    )
    expect(() => circlesFrom(rows('a,b,c\n1,2,-3'), { x: 0, y: 1, r: 2, name: undefined }, false, 'f')).toThrow(
      'f, row 1: the radius must not be negative (got -3).',
    )
  })
})

describe('columns', async () => {
  const files = await loadFiles()
  const columnsIn = (text: string, count: number) => columnsOf(files.readCircleFile(text).attributes, count).columns

  it('are all other ones of a table, each of one type', () => {
    const text = 'x,y,r,name,fips,people\n1,2,3,A,01001,10\n4,5,6,B,1003,\n7,8,9,,6037,30.5\n'
    expect(columnsIn(text, 3)).toEqual([
      { name: 'name', values: ['"A"', '"B"', 'null'] },
      { name: 'fips', values: ['"01001"', '"1003"', '"6037"'] },
      { name: 'people', values: ['10', 'null', '30.5'] },
    ])
  })

  it('are the other members of objects and properties of features, with all digits', () => {
    const objects = '[{"x":1,"y":2,"r":3,"people":12345678901234567890},{"x":4,"y":5,"r":6}]'
    expect(columnsIn(objects, 2)).toEqual([{ name: 'people', values: ['12345678901234567890', ''] }])
    const feature = (properties: object) => ({
      type: 'Feature',
      properties: { radius: 1, ...properties },
      geometry: { type: 'Point', coordinates: [0, 0] },
    })
    const features = [feature({ label: 'A', isOld: true }), feature({ tags: ['a'] })]
    expect(columnsIn(JSON.stringify({ type: 'FeatureCollection', features }), 2)).toEqual([
      { name: 'label', values: ['"A"', ''] },
      { name: 'isOld', values: ['true', ''] },
      { name: 'tags', values: ['', '["a"]'] },
    ])
  })

  it('are none where there are centers and radii alone', () => {
    for (const text of ['x,y,r\n1,2,3\n4,5,6', '[[1,2,3],[4,5,6]]', '[{"cx":1,"cy":2,"r":1},{"cx":4,"cy":2,"r":1}]']) {
      expect(columnsIn(text, 2)).toEqual([])
    }
  })

  it('are written as they were read, in each format', () => {
    const table = 'x,y,r,name,fips,n\n0,0,1,A,01001,1\n6,0,1,B,1003,2.5\n0,8,1,,06037,\n'
    const read = files.readCircleFile(table)
    const attributes = attributesOf(columnsOf(read.attributes, 3), [0, 1, 2])
    for (const format of ['csv', 'geojson', 'json'] as const) {
      const back = files.readCircleFile(files.writeCircles(read.circles, { format, attributes }))
      expect([format, columnsOf(back.attributes, 3)]).toEqual([format, columnsOf(read.attributes, 3)])
    }
  })
})

describe('names', () => {
  it('are read from the data sets of the page', () => {
    expect(parseNamed('x,y,r,name\n1,2,3,A\n')).toEqual({ circles: Float64Array.of(1, 2, 3), names: ['A'] })
    expect(parseNamed('x,y,r\n1,2,3\n').names).toBeUndefined()
    expect(() => parseNamed('x,y,r,name\n1,2,3\n')).toThrow('Line 2')
  })
})

it('a picture becomes circles that do not overlap, most of them where it is dark, the same each time', () => {
  const [width, height] = [60, 40]
  const tones = Float32Array.from({ length: width * height }, (_, k) => (k % width < 30 ? 1 : 0))
  const circles = stippled({ width, height, tones }, randomNumbers(1), 120)
  expect(stippled({ width, height, tones }, randomNumbers(1), 120)).toEqual(circles)
  const all = Array.from({ length: 120 }, (_, i) => [...circles.subarray(3 * i, 3 * i + 3)] as [number, number, number])
  expect(all.filter(([x]) => x < 30).length).toBeGreaterThan(90)
  for (const [i, [x, y, r]] of all.entries()) {
    expect(r).toBeGreaterThan(0)
    for (const [u, v, s] of all.slice(i + 1)) expect(Math.hypot(x - u, y - v)).toBeGreaterThan(r + s)
  }
})
