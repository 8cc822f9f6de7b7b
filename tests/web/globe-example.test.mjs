// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of examples/globe that need no page: shapes for d3-geo, columns, colors and views. tests/e2e/globe.spec.ts
// uses the page.
import { geoArea, geoOrthographic, geoPath } from 'd3-geo'
import { describe, expect, it } from 'vitest'
import { valueColors } from '../../examples/globe/colors.js'
import { columnsIn, headingOf, nameColumn } from '../../examples/globe/columns.js'
import { shapeOf } from '../../examples/globe/rings.js'
import { placeAt, projectionOf, viewOf, withPlaceAt, zoomedAt } from '../../examples/globe/view.js'
import { loadSphere } from '../../web/lib/sphere.ts'
import { seededRandom } from './library.ts'

const { computeSphere } = await loadSphere()
const SIZE = { width: 600, height: 400 }

function randomCaps(count) {
  const random = seededRandom(count)
  return Array.from({ length: count }, () => [
    360 * random() - 180,
    (Math.asin(2 * random() - 1) * 180) / Math.PI,
    400 * random(),
  ])
}

/** A grid of places, with the poles. */
function gridOfPlaces() {
  const caps = [-180, -135, -90, -45, 0, 45, 90, 135].flatMap((longitude) =>
    [-60, -30, 0, 30, 60].map((latitude) => [longitude, latitude, 100]),
  )
  return [...caps, [0, 90, 100], [0, -90, 100]]
}

const FAMILIES = {
  'random circles': randomCaps(200),
  'few circles': randomCaps(4),
  'a grid of degrees with poles': gridOfPlaces(),
  'the poles': [
    [0, 90, 0],
    [0, -90, 500],
  ],
  'one circle': [[10, 20, 300]],
  'two circles': [
    [10, 20, 100],
    [-100, -50, 900],
  ],
  'three on the equator, a border along 180 degrees': [
    [170, 0, 0],
    [-170, 0, 0],
    [0, 0, 0],
  ],
  'an octahedron': [
    [0, 0, 0],
    [90, 0, 0],
    [180, 0, 0],
    [-90, 0, 0],
    [0, 90, 0],
    [0, -90, 0],
  ],
  'across 180 degrees': [
    [179, 60, 10],
    [-179, 60, 10],
    [179, -60, 20],
    [-179, -60, 20],
    [0, 0, 0],
  ],
}

describe.each(Object.entries(FAMILIES))('the shapes of %s', (_, caps) => {
  const diagram = computeSphere(caps)
  const cells = caps.flatMap((_, circle) => {
    const coordinates = diagram.cellPolygon(circle, { tolerance: 2 })
    return coordinates === undefined ? [] : [{ circle, shape: shapeOf(coordinates) }]
  })

  it('have the areas of the cells', () => {
    for (const { circle, shape } of cells) {
      const area = geoArea(shape)
      expect(Math.abs(area - diagram.cellArea(circle) / diagram.radius ** 2)).toBeLessThan(1e-3)
    }
  })

  it('cover the globe from every side', () => {
    const random = seededRandom(7)
    for (let k = 0; k < 120; k++) {
      // Round numbers are those of keys, and of places in tables.
      const [longitude, latitude] = k < 40 ? [45 * (k % 8), 15 * (k % 7) - 45] : [360 * random(), 180 * random() - 90]
      const path = geoPath(projectionOf({ longitude, latitude, zoom: 1 }, SIZE))
      const whole = path.area({ type: 'Sphere' })
      const sum = cells.reduce((sum, { shape }) => sum + path.area(shape), 0)
      expect(Math.abs(sum / whole - 1), `${longitude}, ${latitude}`).toBeLessThan(2e-3)
    }
  })

  it('have no line along 180 degrees, except a border', () => {
    for (const { shape } of cells) {
      const lines = (shape.coordinates ?? []).flatMap((ring) => ring.slice(1).map((to, k) => [ring[k], to]))
      const along = lines.filter(([from, to]) => Math.abs(from[0]) === 180 && from[0] === to[0])
      for (const [[, from], [, to]] of along) {
        // Two circles have the place between both ends, a little aside, on either side.
        const middle = (from + to) / 2
        expect(diagram.find(179.99, middle)).not.toBe(diagram.find(-179.99, middle))
      }
    }
  })
})

describe('views', () => {
  const view = { longitude: 15, latitude: 40, zoom: 2 }

  it('put a place at a point, with north up', () => {
    const random = seededRandom(5)
    for (let k = 0; k < 200; k++) {
      const place = [360 * random() - 180, 170 * random() - 85]
      const point = [SIZE.width * random(), SIZE.height * random()]
      const found = withPlaceAt(view, SIZE, place, point)
      if (found === undefined) continue
      const [x, y] = geoOrthographic()
        .translate([300, 200])
        .scale(projectionOf(found, SIZE).scale())
        .rotate([-found.longitude, -found.latitude])(place)
      expect(Math.hypot(x - point[0], y - point[1])).toBeLessThan(0.01)
    }
  })

  it('keep the place under the pointer when they zoom', () => {
    const point = [340, 150]
    const place = placeAt(view, SIZE, point)
    for (const factor of [0.8, 1.5, 20]) {
      const [longitude, latitude] = placeAt(zoomedAt(view, SIZE, factor, point), SIZE, point)
      expect(longitude).toBeCloseTo(place[0], 3)
      expect(latitude).toBeCloseTo(place[1], 3)
    }
  })

  it('show all places, or the whole globe', () => {
    const near = viewOf([149, -35, 1, 150, -36, 1])
    expect(near.longitude).toBeCloseTo(149.5, 1)
    expect(near.zoom).toBeGreaterThan(10)
    for (const place of [
      [149, -35],
      [150, -36],
    ]) {
      const [x, y] = projectionOf(near, SIZE)(place)
      expect([x > 0 && x < SIZE.width, y > 0 && y < SIZE.height]).toEqual([true, true])
    }
    expect(viewOf([0, 0, 1, 180, 0, 1]).zoom).toBe(1)
    expect(viewOf([]).zoom).toBe(1)
  })
})

describe('columns', () => {
  it.each([
    ['name,lat,lon,r', { longitude: 'lon', latitude: 'lat', radius: 'r', unit: undefined }],
    [
      'Latitude;Longitude;Radius (km)',
      { longitude: 'Longitude', latitude: 'Latitude', radius: 'Radius (km)', unit: 'km' },
    ],
    [
      'latitude_deg,longitude_deg,radius_m',
      { longitude: 'longitude_deg', latitude: 'latitude_deg', radius: 'radius_m', unit: 'm' },
    ],
    ['decimalLatitude\tdecimalLongitude', { longitude: 'decimalLongitude', latitude: 'decimalLatitude' }],
    [
      'Längengrad|Breitengrad|Radius in Metern',
      { longitude: 'Längengrad', latitude: 'Breitengrad', radius: 'Radius in Metern', unit: 'm' },
    ],
    ['lat lng km', { longitude: 'lng', latitude: 'lat', radius: 'km', unit: 'km' }],
    [
      '# comment\n"lat","lon","reach (kilometers)"',
      { longitude: 'lon', latitude: 'lat', radius: 'reach (kilometers)', unit: 'km' },
    ],
    ['minimum,lat,lon', { longitude: 'lon', latitude: 'lat' }],
    ['[{"lng":1,"lat":2,"r":3}]', { longitude: 'lng', latitude: 'lat', radius: 'r' }],
    ['[[1,2,3]]', {}],
    ['[1,', {}],
  ])('are found in %s', (text, columns) => {
    const found = { longitude: undefined, latitude: undefined, radius: undefined, unit: undefined, ...columns }
    expect(columnsIn(headingOf(text))).toEqual(found)
  })

  it('have a name in one of the usual columns, or in the first one of texts', () => {
    expect(nameColumn([{ code: 'a', name: 'b' }])).toBe('name')
    expect(nameColumn([{ size: 1, what: 'b' }])).toBe('what')
    expect(nameColumn([{ size: 1 }])).toBeUndefined()
    expect(nameColumn([])).toBeUndefined()
  })
})

describe('colors by values', () => {
  const diagram = computeSphere(randomCaps(60))

  it('are classes of equal size for numbers', () => {
    const values = Array.from({ length: 60 }, (_, k) => (k < 54 ? k ** 3 : undefined))
    const { colors, legend } = valueColors(diagram, values)
    expect(legend.map(({ color }) => color)).toEqual([...[0, 1, 2, 3, 4, 5].map((k) => `tints ${k}`), 'none'])
    for (const { color } of legend.slice(0, -1)) expect(colors.filter((other) => other === color)).toHaveLength(9)
    expect(colors.slice(54)).toEqual(Array(6).fill('none'))
    expect(legend[0].label).toBe('0 to 512')
  })

  it('differ between neighbors if values are too many for a legend', () => {
    const values = Array.from({ length: 60 }, (_, k) => `group ${k % 20}`)
    const { colors, legend } = valueColors(diagram, values)
    expect(legend).toEqual([])
    for (const [k, value] of values.entries()) expect(colors[values.indexOf(value)]).toBe(colors[k])
    const few = valueColors(
      diagram,
      values.map((value) => value.slice(-1)).map((digit) => Number(digit) % 3 === 0),
    )
    expect(few.legend.map(({ label }) => label)).toEqual(['false', 'true'])
  })
})
