// SPDX-License-Identifier: GPL-3.0-or-later
// `--project` with longitude, latitude and radii in meters, compared with distances on the ellipsoid (T. Vincenty
// 1975).
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, describe, expect, it } from 'vitest'
import { mapped, recordOf } from '../../web/app/earth/map-projection.ts'

const PROGRAM = new URL('../../build/native/circle-voronoi', import.meta.url).pathname
const FILE = new URL('brought/degrees-and-metres.csv', import.meta.url).pathname
const KINDS = ['local', 'equal-area', 'mercator'] as const
const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-projection-'))
afterAll(() => rmSync(folder, { recursive: true }))

type Position = readonly [number, number]
interface Cell {
  readonly properties: { readonly area: number; readonly neighbors: readonly number[]; readonly r: number }
  readonly geometry: { readonly coordinates: readonly (readonly Position[])[] }
}

const CIRCLES = readFileSync(FILE, 'utf8')
  .trim()
  .split('\n')
  .slice(1)
  .map((line) => line.split(',').map(Number) as [number, number, number])

function run(args: readonly string[], input?: string) {
  const { status, stdout, stderr } = spawnSync(PROGRAM, args, { input, encoding: 'utf8' })
  return { status, stdout, stderr }
}

function cellsOf(args: readonly string[], input?: string): readonly Cell[] {
  const { status, stdout, stderr } = run([...args, '--format', 'geojson'], input)
  expect([status, stderr]).toEqual([0, ''])
  return JSON.parse(stdout).features
}

/** The distance of two places in meters. */
function distance([lon1, lat1]: Position, [lon2, lat2]: Position): number {
  const [a, f] = [6378137, 1 / 298.257223563]
  const radians = (degrees: number) => (degrees * Math.PI) / 180
  const [u1, u2] = [lat1, lat2].map((lat) => Math.atan((1 - f) * Math.tan(radians(lat)))) as [number, number]
  let [lambda, sigma, sinSigma, cosSigma, cosSquare, cosMiddle] = [radians(lon2 - lon1), 0, 0, 0, 0, 0]
  for (let step = 0; step < 100; step++) {
    const across = Math.cos(u2) * Math.sin(lambda)
    const along = Math.cos(u1) * Math.sin(u2) - Math.sin(u1) * Math.cos(u2) * Math.cos(lambda)
    sinSigma = Math.hypot(across, along)
    if (sinSigma === 0) return 0
    cosSigma = Math.sin(u1) * Math.sin(u2) + Math.cos(u1) * Math.cos(u2) * Math.cos(lambda)
    sigma = Math.atan2(sinSigma, cosSigma)
    const sinAlpha = (Math.cos(u1) * Math.cos(u2) * Math.sin(lambda)) / sinSigma
    cosSquare = 1 - sinAlpha ** 2
    cosMiddle = cosSquare > 0 ? cosSigma - (2 * Math.sin(u1) * Math.sin(u2)) / cosSquare : 0
    const c = (f / 16) * cosSquare * (4 + f * (4 - 3 * cosSquare))
    const inner = cosMiddle + c * cosSigma * (2 * cosMiddle ** 2 - 1)
    lambda = radians(lon2 - lon1) + (1 - c) * f * sinAlpha * (sigma + c * sinSigma * inner)
  }
  const square = (cosSquare * (1 - (1 - f) ** 2)) / (1 - f) ** 2
  const big = 1 + (square / 16384) * (4096 + square * (square * (320 - 175 * square) - 768))
  const small = (square / 1024) * (256 + square * (square * (74 - 47 * square) - 128))
  const last = (small / 6) * cosMiddle * (4 * sinSigma ** 2 - 3) * (4 * cosMiddle ** 2 - 3)
  const delta = small * sinSigma * (cosMiddle + (small / 4) * (cosSigma * (2 * cosMiddle ** 2 - 1) - last))
  return a * (1 - f) * big * (sigma - delta)
}

function pointsOf({ geometry }: Cell): readonly Position[] {
  return geometry.coordinates.flat()
}

describe.each(KINDS)('--project %s', (kind) => {
  // Error limits in meters for circles of some hundred meters within 30 km of the center, where Mercator's scale
  // differs by 0.4 %.
  const error = { local: 0.5, 'equal-area': 0.5, mercator: 60 }[kind]

  it('has cells whose points are as near to one circle as to its neighbor, in meters', () => {
    const cells = cellsOf(['compute', FILE, '--project', kind])
    // The cells of the outer two circles meet far away.
    expect(cells.map(({ properties }) => properties.neighbors.length)).toEqual([2, 2, 2])
    const near = cellsOf(['compute', FILE, '--project', kind, '--bounds', '148.9,-35.6,149.4,-35.1'])
    expect(near.map(({ properties }) => properties.neighbors.length)).toEqual([2, 1, 1])
    let shared = 0
    for (const [i, cell] of cells.entries()) {
      for (const j of cell.properties.neighbors) {
        const others = new Set(pointsOf(cells[j] as Cell).map(String))
        for (const point of pointsOf(cell).filter((point) => others.has(String(point)))) {
          const [p, q] = [CIRCLES[i], CIRCLES[j]] as [Position & { 2: number }, Position & { 2: number }]
          const difference = distance(point, [p[0], p[1]]) - p[2] - (distance(point, [q[0], q[1]]) - q[2])
          expect(Math.abs(difference)).toBeLessThan(error)
          shared += 1
        }
      }
    }
    expect(shared).toBeGreaterThan(20)
  })

  it('has a vertex far away that is as near to all three circles, in meters', () => {
    const cells = cellsOf(['compute', FILE, '--project', kind, '--bounds', '148,-36.2,149.6,-35'])
    const [first, ...others] = cells.map((cell) => new Set(pointsOf(cell).map(String))) as [
      Set<string>,
      ...Set<string>[],
    ]
    const common = [...first].filter((point) => others.every((points) => points.has(point)))
    expect(common).toHaveLength(1)
    const vertex = common[0]?.split(',').map(Number) as unknown as Position
    const distances = CIRCLES.map(([x, y, r]) => distance(vertex, [x, y]) - r)
    // The center is 94 km away, where Mercator's scale differs by 0.65 %.
    const most = { local: 2, 'equal-area': 2, mercator: 600 }[kind]
    expect(Math.max(...distances) - Math.min(...distances)).toBeLessThan(most)
  })

  it('goes through a diagram in JSON, which says what its plane is', () => {
    const { stdout } = run(['compute', FILE, '--project', kind])
    const { collection, circles } = JSON.parse(stdout)
    expect(collection.projection).toMatchObject({ type: kind, unit: 'meter' })
    expect(circles).toHaveLength(3)
    expect(cellsOf(['convert', '-'], stdout)).toEqual(cellsOf(['compute', FILE, '--project', kind]))
    const bounds = ['--bounds', '149.1,-35.4,149.2,-35.3']
    expect(cellsOf(['convert', '-', ...bounds], stdout)).toEqual(
      cellsOf(['compute', FILE, '--project', kind, ...bounds]),
    )
    const points = JSON.parse(run(['convert', '-', '--circles', '--format', 'geojson'], stdout).stdout)
    expect(points.projection).toBeUndefined()
    for (const [k, [x, y, r]] of CIRCLES.entries()) {
      const { geometry, properties } = points.features[k]
      expect(geometry.coordinates[0]).toBeCloseTo(x, 8)
      expect(geometry.coordinates[1]).toBeCloseTo(y, 8)
      expect(properties.r).toBeCloseTo(r, 5)
    }
    const script = join(folder, 'none.csv')
    writeFileSync(script, '# none\n')
    const edit = ['edit', '-', '--script', script]
    expect(JSON.parse(run(edit, stdout).stdout)).toMatchObject({ collection, circles })
    // The editor's edges have other directions, along which areas are summed.
    const sized = ['--max-distance', '30000']
    const areas = cellsOf(['convert', '-', ...sized], stdout).map(({ properties }) => properties.area)
    const edited = cellsOf([...edit, ...sized], stdout)
    expect(edited).toHaveLength(areas.length)
    for (const [k, area] of areas.entries()) {
      expect(Math.abs((edited[k] as Cell).properties.area / area - 1)).toBeLessThan(1e-12)
    }
  })

  it('takes a box and a region in degrees', () => {
    const box = '148.9,-35.6,149.4,-35.1'
    const region = join(folder, 'region.wkt')
    writeFileSync(region, 'POLYGON ((148.9 -35.6, 149.4 -35.6, 149.4 -35.1, 148.9 -35.1))')
    const cells = cellsOf(['compute', FILE, '--project', kind, '--bounds', box])
    expect(cellsOf(['compute', FILE, '--project', kind, '--region', region])).toEqual(cells)
    const points = cells.flatMap(pointsOf)
    const [x, y] = [points.map(([x]) => x), points.map(([, y]) => y)]
    for (const [got, wanted] of [
      [Math.min(...x), 148.9],
      [Math.max(...x), 149.4],
      [Math.min(...y), -35.6],
      [Math.max(...y), -35.1],
    ] as const) {
      expect(Math.abs(got - wanted)).toBeLessThan(1e-8)
    }
    // An area of half a degree of longitude and latitude on the ellipsoid: 2,523 square kilometers.
    const area = cells.reduce((sum, { properties }) => sum + properties.area, 0)
    expect(Math.abs(area / areaOfBox(148.9, -35.6, 149.4, -35.1) - 1)).toBeLessThan(
      { local: 1e-4, 'equal-area': 1e-6, mercator: 0.02 }[kind],
    )
  })

  it('keeps the members beside it in the file, also of circles that are written again', () => {
    const points = run(['convert', FILE, '--format', 'geojson']).stdout
    for (const members of ['"name":"stores",', '"name":"stores","crs":{"type":"name"},']) {
      const input = points.replace('{"type":"FeatureCollection",', `{"type":"FeatureCollection",${members}`)
      const { stdout } = run(['compute', '-', '--project', kind], input)
      const { projection, ...others } = JSON.parse(stdout).collection
      expect(projection.type).toBe(kind)
      expect(others).toEqual(JSON.parse(`{${members.slice(0, -1)}}`))
      const again = JSON.parse(run(['convert', '-', '--circles', '--format', 'geojson'], stdout).stdout)
      const { type, features, ...rest } = again
      expect(rest).toEqual(others)
    }
  })

  it('refuses limits that are no degrees, or too large', () => {
    const region = join(folder, 'far.wkt')
    const refused = (wkt: string) => {
      writeFileSync(region, wkt)
      return run(['compute', FILE, '--project', kind, '--format', 'geojson', '--region', region])
    }
    const far = refused('POLYGON ((148.9 -35.6, 400 -35.6, 149.4 -35.1))')
    expect([far.status, far.stderr]).toEqual([
      2,
      `circle-voronoi: ${region}: (400, -35.6) has no place on the map of --project, which takes degrees.\n`,
    ])
    expect(refused('POLYGON ((148.9 -35.6, 149.4 -89, 149.4 -35.1))').status).toBe(kind === 'mercator' ? 2 : 0)
    const teeth = Array.from({ length: 40 }, (_, k) => {
      const south = k / 5
      return `350 ${south}, 350 ${south + 0.1}, -350 ${south + 0.1}, -350 ${south + 0.2}`
    })
    expect(refused(`POLYGON ((-355 0, ${teeth.join(', ')}, -355 8))`).stderr).toBe(
      `circle-voronoi: ${region}: the sides of the region are too long for --project.\n`,
    )
    const north = run(['compute', FILE, '--project', kind, '--format', 'wkt', '--bounds', '148,-91,149,-35'])
    expect([north.status, north.stderr.startsWith('circle-voronoi: --bounds: (')]).toEqual([2, true])
  })

  it('crosses the antimeridian', () => {
    const cells = cellsOf(['compute', '-', '--project', kind], 'lon,lat,r\n179.9,10,100\n-179.9,10,100\n180,10.2,100\n')
    const x = cells.flatMap(pointsOf).map(([x]) => x)
    expect(Math.max(...x) - Math.min(...x)).toBeLessThan(1)
  })

  it('refuses what is no place', () => {
    const refused = (text: string) => run(['compute', '-', '--project', kind], text)
    expect(refused('x,y,r\n1,1,1\n500000,5400000,1\n')).toEqual({
      status: 2,
      stdout: '',
      stderr:
        'circle-voronoi: standard input: circle 1 is at (5e+05, 5400000), which is no longitude and latitude in degrees.\n',
    })
    for (const place of ['361,1', '1,91', '-361,1', '1,-91']) {
      expect(refused(`lon,lat,r\n0,0,1\n${place},1\n`).stderr).toContain('is no longitude and latitude in degrees.')
    }
    const far = refused('lon,lat,r\n0,0,1\n150,10,1\n')
    expect(far.status).toBe(kind === 'mercator' ? 0 : 2)
    if (kind !== 'mercator') expect(far.stderr).toContain('circle 0 is more than 60 degrees from the middle')
    const polar = refused('lon,lat,r\n0,0,1\n0,89,1\n')
    expect(polar.status).toBe(kind === 'mercator' ? 2 : 0)
    if (kind === 'mercator') expect(polar.stderr).toContain('circle 1 is too near a pole for --project mercator')
  })
})

/** The area of a box of degrees on the ellipsoid, by the trapezoidal rule over parallels. */
function areaOfBox(west: number, south: number, east: number, north: number): number {
  const [a, f, parts] = [6378137, 1 / 298.257223563, 2000]
  const square = f * (2 - f)
  const step = ((north - south) / parts) * (Math.PI / 180)
  let sum = 0
  for (let k = 0; k <= parts; k++) {
    const lat = (south * Math.PI) / 180 + k * step
    const w = 1 - square * Math.sin(lat) ** 2
    const density = (a * Math.cos(lat) * a * (1 - square)) / w ** 2
    sum += (k === 0 || k === parts ? 0.5 : 1) * density * step
  }
  return (sum * ((east - west) * Math.PI)) / 180
}

it('--project equal-area has a map around a pole', () => {
  const table = 'lon,lat,r\n0,90,1\n90,89.9,2\n-90,89.9,2\n180,89.9,3\n0,89.9,2\n'
  const { circles, collection } = JSON.parse(run(['compute', '-', '--project', 'equal-area'], table).stdout)
  expect(collection.projection).toMatchObject({ latitude: 90 })
  const [pole, ...others] = circles
  const degree = 111693.9
  for (const { x, y } of others) expect(Math.hypot(x - pole.x, y - pole.y) / degree).toBeCloseTo(0.1, 6)
})

it.each(['local', 'equal-area'])('--project %s has the poles on its map', (kind) => {
  for (const pole of [90, -90]) {
    const places = [
      [0, pole],
      [10, pole * 0.99],
      [130, pole * 0.98],
      [-110, pole * 0.99],
    ]
    const table = `lon,lat,r\n${places.map((place) => `${place},1\n`).join('')}`
    const diagram = run(['compute', '-', '--project', kind], table).stdout
    const points = JSON.parse(run(['convert', '-', '--circles', '--format', 'geojson'], diagram).stdout)
    for (const [k, [lon, lat]] of places.entries()) {
      const [x, y] = points.features[k].geometry.coordinates
      expect(y).toBeCloseTo(lat as number, 7)
      if (k > 0) expect((x - (lon as number)) % 360).toBeCloseTo(0, 7)
    }
  }
})

it('--project mercator is straight across the equator', () => {
  const table = 'lon,lat,r\n-1,0,1\n1,0,1\n0,2,1\n0,-2,1\n'
  const diagram = JSON.parse(run(['compute', '-', '--project', 'mercator'], table).stdout)
  expect(diagram.collection.projection).toMatchObject({ longitude: 0, latitude: 0 })
  const [west, east, north, south] = diagram.circles
  const degree = (6378137 * Math.PI) / 180
  expect([west.x / degree, west.y, east.x / degree, east.y]).toEqual([
    expect.closeTo(-1, 12),
    0,
    expect.closeTo(1, 12),
    0,
  ])
  expect(north.y).toBe(-south.y)
  expect(north.y).toBeGreaterThan(2 * (1 - 0.007) * degree)
  // One meter is larger away from the equator.
  expect(north.r).toBeGreaterThan(1.0005)
  expect(west.r).toBe(1)
})

it('fit gives cells areas in square meters', () => {
  const region = join(folder, 'box.wkt')
  writeFileSync(region, 'POLYGON ((148.9 -35.6, 149.4 -35.6, 149.4 -35.1, 148.9 -35.1))')
  const table = 'lon,lat,people\n149.149,-35.315,3\n149.3,-35.5,1\n149,-35.2,2\n'
  const args = ['fit', '-', '--areas', 'people', '--shares', '--region', region, '--project', 'equal-area']
  const areas = cellsOf(args, table).map(({ properties }) => properties.area)
  const whole = areaOfBox(148.9, -35.6, 149.4, -35.1)
  for (const [k, share] of [3, 1, 2].entries()) {
    expect(Math.abs((areas[k] as number) / ((share * whole) / 6) - 1)).toBeLessThan(1e-6)
  }
})

describe('the map of the playground', () => {
  it('is that of equal-area, and the program converts it to degrees again', () => {
    const { circles, center } = mapped(Float64Array.from(CIRCLES.flat()))
    const { collection, ...given } = JSON.parse(run(['compute', FILE, '--project', 'equal-area']).stdout)
    const record = JSON.parse(`{${recordOf(center)}}`)
    expect(record).toEqual({ projection: collection.projection })
    const expected = (given.circles as { x: number; y: number; r: number }[]).flatMap(({ x, y, r }) => [x, y, r])
    for (const [k, value] of expected.entries()) expect(Math.abs((circles[k] as number) - value)).toBeLessThan(2e-6)

    const features = CIRCLES.map((_, k) => ({
      type: 'Feature',
      properties: { r: circles[3 * k + 2] },
      geometry: { type: 'Point', coordinates: [circles[3 * k], circles[3 * k + 1]] },
    }))
    const saved = `{"type":"FeatureCollection",${recordOf(center)},"features":${JSON.stringify(features)}}`
    const { stdout } = run(['compute', '-'], saved)
    const points = JSON.parse(run(['convert', '-', '--circles', '--format', 'geojson'], stdout).stdout)
    for (const [k, [x, y]] of CIRCLES.entries()) {
      expect(points.features[k].geometry.coordinates[0]).toBeCloseTo(x, 8)
      expect(points.features[k].geometry.coordinates[1]).toBeCloseTo(y, 8)
    }
  })
})
