// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of other programs, names of circles, and pictures as circles.
import { describe, expect, it } from 'vitest'
import { parseNamed } from '../../web/app/csv.ts'
import { circlesFrom, guessedColumns, type Rows, rowsOf } from '../../web/app/files/columns.ts'
import { attributesIn } from '../../web/app/files/names.ts'
import { stippled } from '../../web/app/files/stipple.ts'
import { randomNumbers } from '../../web/app/random-circles.ts'
import { NO_ATTRIBUTES } from '../../web/editing/attributes.ts'

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

describe('columns', () => {
  it('are all other ones of a table, each of one type', () => {
    const text = 'x,y,r,name,fips,people\n1,2,3,A,01001,10\n4,5,6,B,1003,\n7,8,9,,6037,30.5\n'
    expect(attributesIn(text, 3)?.columns).toEqual([
      { name: 'name', values: ['"A"', '"B"', 'null'] },
      { name: 'fips', values: ['"01001"', '"1003"', '"6037"'] },
      { name: 'people', values: ['10', 'null', '30.5'] },
    ])
    expect(attributesIn(text, 2)).toBeUndefined()
    expect(attributesIn('1;2;3;1,5\n4;5;6;2', 2)?.columns).toEqual([{ name: 'Column 4', values: ['1.5', '2'] }])
  })

  it('are the other members of objects and properties of features', () => {
    expect(attributesIn('[{"x":1,"y":2,"r":3,"people":10},{"x":4,"y":5,"r":6}]', 2)?.columns).toEqual([
      { name: 'people', values: ['10', ''] },
    ])
    const feature = (properties: object) => ({ properties: { radius: 1, ...properties } })
    const features = [feature({ label: 'A', isOld: true }), feature({ tags: ['a'] })]
    expect(attributesIn(JSON.stringify({ features }), 2)?.columns).toEqual([
      { name: 'label', values: ['"A"', ''] },
      { name: 'isOld', values: ['true', ''] },
      { name: 'tags', values: ['', '["a"]'] },
    ])
  })

  it('are none where there are centers and radii alone, or it is no such text', () => {
    const texts = ['x,y,r\n1,2,3\n4,5,6', '[[1,2,3],[4,5,6]]', '[{"cx":1,"cy":2,"r":1},{"cx":4,"cy":2,"r":1}]']
    for (const text of [...texts, '{"features":']) expect(attributesIn(text, 2)).toBeUndefined()
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
