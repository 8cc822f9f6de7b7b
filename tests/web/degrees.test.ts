// SPDX-License-Identifier: GPL-3.0-or-later
// Circles whose centers are longitude and latitude: how the page notices, and its map.
import { describe, expect, it } from 'vitest'
import { degreesIn } from '../../web/app/earth/degrees.ts'
import { mapped } from '../../web/app/earth/map-projection.ts'
import { guessedColumns, knownColumns, SAME, type Table, unknownTable } from '../../web/app/files/columns.ts'

const PLACES = Float64Array.of(8.68, 50.11, 5, 13.4, 52.52, 10)
const degreesOf = (x: string, y: string, radius?: string, circles = PLACES) =>
  degreesIn(circles, { x, y, radius }, 'places.csv')

describe('columns in degrees', () => {
  it.each([
    ['lon', 'lat'],
    ['Longitude', 'Latitude'],
    ['longitude_deg', 'latitude_deg'],
    ['decimalLongitude', 'decimalLatitude'],
    ['Länge', 'Breite'],
    ['Längengrad (°)', 'Breitengrad (°)'],
    ['lng', 'lat'],
    ['lon_wgs84', 'lat_wgs84'],
  ])('are %s and %s', (x, y) => {
    expect(degreesOf(x, y)).toEqual({ file: 'places.csv', unit: 'km' })
    expect(guessedColumns(unknownTable(`name,${y},${x}\nA,50,8\n`) as Table)).toMatchObject({ x: 2, y: 1, r: SAME })
  })

  it.each([
    ['x', 'y'],
    ['easting', 'northing'],
    ['long axis', 'lat'],
    ['lon', 'y'],
  ])('are not %s and %s', (x, y) => expect(degreesOf(x, y)).toBeUndefined())

  it('are in their range', () => {
    expect(degreesOf('lon', 'lat', 'r', Float64Array.of(3.5e5, 5.5e6, 1))).toBeUndefined()
    expect(degreesOf('lon', 'lat', 'r', Float64Array.of(359, -90, 1e5))).toBeDefined()
    expect(degreesOf('lon', 'lat', 'r', new Float64Array())).toBeUndefined()
  })

  it.each([
    ['radius_km', 'km'],
    ['Radius (m)', 'm'],
    ['radius in meters', 'm'],
    ['r [km]', 'km'],
    ['radius (cm)', 'm'],
    ['Radius Kilometer', 'km'],
  ])('have the unit of %s', (radius, unit) => {
    expect(degreesOf('lon', 'lat', radius)?.unit).toBe(unit)
  })

  it('have radii in meters if these are longer than the extent of all places in kilometers', () => {
    const near = Float64Array.of(149.149, -35.315, 500, 149.3, -35.5, 800, 149, -35.2, 300)
    expect(degreesOf('lon', 'lat', 'radius', near)?.unit).toBe('m')
    expect(degreesOf('lon', 'lat', 'radius')?.unit).toBe('km')
  })
})

describe('the columns that readers know', () => {
  it.each([
    ['# a comment\nid;Longitude;Latitude;r\n1;8;50;1\n', { x: 'Longitude', y: 'Latitude', radius: 'r' }],
    ['[{"tags":{"a":1},"lat":1,"lon":2,"r":3},{"lat":1}]', { x: 'lon', y: 'lat', radius: 'r' }],
    ['[[1,2,3]]', undefined],
    ['8 50 1\n9 50 1\n', undefined],
    ['{"type":"FeatureCollection","features":[]}', undefined],
  ])('of %s', (text, columns) => expect(knownColumns(text)).toEqual(columns))
})

describe('the map', () => {
  it('has areas as on the ellipsoid, also across 180 degrees and around a pole', () => {
    // The area of a quarter of a degree squared (Snyder 1987, 3-12).
    const e = Math.sqrt(0.0066943799901413165)
    const q = (degrees: number) => {
      const s = Math.sin((degrees * Math.PI) / 180)
      return (1 - e * e) * (s / (1 - e * e * s * s) + Math.atanh(e * s) / e)
    }
    const middles = [
      [10, 50],
      [179.9, -16],
      [-70, 89],
    ] as const
    for (const [longitude, latitude] of middles) {
      const corners = [
        [0, 0],
        [0.5, 0],
        [0.5, 0.5],
        [0, 0.5],
      ].map(([right = 0, up = 0]) => [longitude + right, latitude + up, 1] as const)
      const { circles } = mapped(Float64Array.from(corners.flat()))
      const points = corners.map((_, k) => [circles[3 * k] as number, circles[3 * k + 1] as number] as const)
      const area = points.reduce((sum, [x, y], k) => {
        const [u, v] = points[(k + 1) % 4] as readonly [number, number]
        return sum + (x * v - u * y) / 2
      }, 0)
      const expected = ((6378137 ** 2 * 0.5 * Math.PI) / 360) * (q(latitude + 0.5) - q(latitude))
      expect(area / expected).toBeCloseTo(1, 3)
    }
  })

  it('has the middle of the circles at its origin, and their radii', () => {
    const { circles, center } = mapped(Float64Array.of(-1, 0, 5, 1, 0, 7))
    expect(center).toEqual({ longitude: 0, latitude: 0 })
    const [x = 0, y = 0, r, u = 0] = circles
    expect([y, r, circles[5]]).toEqual([0, 5, 7])
    expect(x).toBe(-u)
    // A degree of the equator, within the map's change of scale.
    expect(u / 111319.49).toBeCloseTo(1, 4)
  })

  it('around a pole is finite', () => {
    const { circles } = mapped(Float64Array.of(0, 90, 1, 0, 89, 1, 90, 89, 1, 180, 89, 1, -90, 89, 1))
    expect(circles.every(Number.isFinite)).toBe(true)
    expect(Math.hypot(circles[0] as number, circles[1] as number)).toBeLessThan(1)
  })

  it('refuses places that are too far apart', () => {
    expect(() => mapped(Float64Array.of(0, 0, 1, 130, 0, 1))).toThrow(/^Circle 0 is more than 60° from the middle/)
  })
})
