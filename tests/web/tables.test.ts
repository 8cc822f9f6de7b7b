// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of other programs, names of circles, and pictures as circles.
import { describe, expect, it } from 'vitest'
import {
  circlesOfTable,
  guessedColumns,
  nameOfColumn,
  SAME,
  type Table,
  unknownTable,
} from '../../web/app/files/columns.ts'
import { randomNumbers } from '../../web/app/random-numbers.ts'
import { attributesOf, columnsOf } from '../../web/editing/attributes.ts'
import { loadFiles } from '../../web/lib/files.ts'
import { namedCirclesOfText } from '../../web/view/circle-text.ts'

const table = (text: string) => unknownTable(text) as Table

describe('a table whose columns the reader does not know', () => {
  it('has a heading or none, any separator, and separators in quotation marks', () => {
    expect(table('a;b\n1,5;2\n')).toEqual({
      heading: ['a', 'b'],
      hasHeading: true,
      rows: [['1,5', '2']],
      separator: ';',
      hasNumbers: [true, true],
      areMeasures: [true, true],
    })
    expect(table('1,2\n3,4').heading).toEqual(['column 1', 'column 2'])
    expect(table('name,u,v\n"Bonn, am ""Rhein""",1,2').rows).toEqual([['Bonn, am "Rhein"', '1', '2']])
    for (const text of ['\ufeffa|b\r\n1,5|2', 'a b\n1.5 2', '# made by hand\na\tb\n1,5\t2']) {
      expect([text, table(text).heading, table(text).rows.length]).toEqual([text, ['a', 'b'], 1])
    }
    expect(table('a (m in x);b b, b b\n1;2').heading).toEqual(['a (m in x)', 'b b, b b'])
    for (const text of [
      '',
      'words and words',
      'a,b\nc,d',
      '1\n2',
      'a,b\n1,u\n2,v\n3,4\n5,w',
      'a,b\n"1,2',
      '[1,2,3,4]',
      '{"a":1,"b":2,"c":3}',
    ]) {
      expect([text, unknownTable(text)]).toEqual([text, undefined])
    }
  })

  it('is none where the reader knows them, whatever else is wrong', () => {
    for (const text of ['x,y,r\n1,2,word', 'lon;lat;radius;n\n1;2', '1,2,3\n4,5', '1;2;3\n4;5;6;7']) {
      expect([text, unknownTable(text)]).toEqual([text, undefined])
    }
    expect(table('x,lon,y,r\n1,2,3,4')).toBeDefined()
  })

  it.each([
    ['X-Koordinate;Y-Koordinate;Radius', '1;2;3', { x: 0, y: 1, r: 2 }],
    ['Stadt;Rechtswert;Hochwert;Durchmesser', 'A;1;2;3', { x: 1, y: 2, r: 3, kind: 'diameter' }],
    ['longitude,latitude,radius_km,Name', '1,2,3,A', { x: 0, y: 1, r: 2 }],
    ['center_x\tcenter_y\tdbh', '1\t2\t3', { x: 0, y: 1, r: 2, kind: 'diameter' }],
    ['x,y,dbh,height', '1,5,2,9\n2,5,2,9\n3,4,2,9', { x: 0, y: 1, r: 2, kind: 'diameter' }],
    ['x_pos;y_pos;diameter;radius', '1;2;3;4', { x: 0, y: 1, r: 3 }],
    ['x;lon;lat;weight', '1;2;3;4', { x: 0, y: 2, r: 3 }],
    ['Ort,lon,lat', 'A,1,2', { x: 1, y: 2, r: SAME }],
    ['lat,lon', '1,2', { x: 1, y: 0, r: SAME }],
    ['a,b,c', '1,2,3', { x: 0, y: 1, r: 2 }],
    ['a,b', '1,2', { x: 0, y: 1, r: SAME }],
    // A column has one role.
    ['a,x,radius', '1,2,3', { x: 1, y: 0, r: 2 }],
    ['x,a', '1,2', { x: 0, y: 1, r: SAME }],
    // Texts, ids and codes have none.
    ['radius_km,x_pos,y_pos', 'big,1,2', { x: 1, y: 2, r: SAME }],
    ['Tree id,a,b,c', '7,1,2,3', { x: 1, y: 2, r: 3 }],
    ['PLZ;a;b', '12345;1;2', { x: 1, y: 2, r: SAME }],
    ['n,a,b', '01001,1,2', { x: 1, y: 2, r: SAME }],
    ['n,a,b,c', '1,5,6,7\n2,5,6,7\n3,4,4,4', { x: 1, y: 2, r: 3 }],
    // Units are read.
    ['X (m);Y (m);Dia (cm)', '1;2;3', { x: 0, y: 1, r: 2, kind: 'diameter', factor: 0.01 }],
    ['x [mm],y [mm],r [mm]', '1,2,3', { x: 0, y: 1, r: 2 }],
    ['x_km,y_km,radius in meters', '1,2,3', { x: 0, y: 1, r: 2, factor: 0.001 }],
    ['Easting,Northing,DBH (cm)', '1,2,3', { x: 0, y: 1, r: 2, kind: 'diameter', factor: 0.01 }],
    ['x,y,r (cm)', '1,2,3', { x: 0, y: 1, r: 2 }],
    ['x (m),y (ft),r (cm)', '1,2,3', { x: 0, y: 1, r: 2 }],
    ['lon,lat,r (km)', '1,2,3', { x: 0, y: 1, r: 2 }],
    ['lon,lat,r (cm)', '1,2,3', { x: 0, y: 1, r: 2, factor: 0.01 }],
    // The largest circle gets a twentieth of the extent as its radius, in kilometers if coordinates are degrees.
    ['x,y,population', '0,0,10000\n30,40,400', { x: 0, y: 1, r: 2, kind: 'root', factor: 0.03 }],
    ['city,lon,lat,Einwohner', 'A,0,0,10000\nB,3,4,400', { x: 1, y: 2, r: 3, kind: 'root', factor: 0.3 }],
  ])('tells by names, units and values of its columns what they may be: %s', (heading, rows, columns) => {
    expect(guessedColumns(table(`${heading}\n${rows}\n`))).toEqual({ kind: 'radius', factor: 1, ...columns })
  })

  it.each([
    ['x', 'x cx x-coord xwert x_center pos_x lon long lng longitude länge längengrad east easting rechtswert'],
    ['y', 'y cy y-coord ywert y_center pos_y lat latitude breite breitengrad north northing hochwert'],
    ['radius', 'r rad radius radien radii weight gewicht'],
    ['diameter', 'd dia diam diameter durchmesser dbh bhd'],
    ['root', 'pop population people inhabitants einwohner area fläche'],
  ])('knows the words for %s', (kind, words) => {
    for (const word of words.split(' ')) {
      const guess = guessedColumns(table(`a;b;c;${word}\n1;2;3;4\n`))
      const role = kind === 'x' || kind === 'y' ? guess[kind] : guess.r
      expect([role, kind.length > 1 ? guess.kind : kind], word).toEqual([3, kind])
    }
  })

  it('has the circles of its rows, without those that are none', () => {
    const text = 'n;a;b;c\nu;1,5;2;9\nv;;5;6\nw;4;5;-6\nz;4;5;16'
    const columns = { x: 1, y: 2, r: 3, kind: 'root', factor: 2 } as const
    expect([...circlesOfTable(table(text), columns)]).toEqual([1.5, 2, 6, 4, 5, 8])
    expect([...circlesOfTable(table(text), { ...columns, r: { all: 7 } })]).toEqual([1.5, 2, 7, 4, 5, 7, 4, 5, 7])
  })

  it('names its columns as the reader does, to the bit', async () => {
    const files = await loadFiles()
    for (const [text, circles] of [
      ['n;a;b;c\nu;1,5;2;3\nv;4;5;6', [1.5, 2, 3, 4, 5, 6]],
      ['n;a;a;\nu;1,5;2;3\nv;4;5;6', [1.5, 2, 3, 4, 5, 6]],
      ['u;1,5;2;3\nv;4;5;6\nw;7', undefined],
      ['n;"a ""b""";b;c\nu;1,5;2;3', [1.5, 2, 3]],
    ] as const) {
      const [x = '', y = '', radius = ''] = [1, 2, 3].map((column) => nameOfColumn(table(text), column))
      const read = () => files.readCircles(text, { x, y, radius })
      if (circles === undefined) expect(read).toThrow('the text:3:')
      else expect([...read()]).toEqual(circles)
    }
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

it('names and colors are read from tables, objects and GeoJSON', () => {
  const columns = [
    { name: 'name', values: ['"A, B"', ''] },
    { name: 'Farbe', values: ['"red"', '"#12f"'] },
  ]
  expect(namedCirclesOfText('x,y,r,name,n,Farbe\n1,2,3,"A, B",7,red\n4,5,6,,8,#12f\n').columns).toEqual(columns)
  const items = [
    { x: 1, y: 2, r: 3, name: 'A, B', Farbe: 'red', n: 7 },
    { x: 4, y: 5, r: 6, name: '', Farbe: '#12f', title: 7 },
  ]
  expect(namedCirclesOfText(JSON.stringify(items)).columns).toEqual(columns)
  const features = items.map((properties) => ({
    type: 'Feature',
    geometry: { type: 'Point', coordinates: [0, 0] },
    properties,
  }))
  expect(namedCirclesOfText(JSON.stringify({ type: 'FeatureCollection', features })).columns).toEqual(columns)
  expect(namedCirclesOfText('x,y,r\n1,2,3\n').columns).toEqual([])
})

it('pseudorandom numbers are those of mulberry32', () => {
  const random = randomNumbers(1)
  expect([random(), random(), random()]).toEqual([0.6270739405881613, 0.002735721180215478, 0.5274470399599522])
})
