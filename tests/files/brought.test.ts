// SPDX-License-Identifier: GPL-3.0-or-later
// Unmodified files of other programs: in the program, in JavaScript, and in the reader of the element and the page.
import { spawnSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { guessedColumns, SAME, type Table, unknownTable } from '../../web/app/files/columns.ts'
import { columnsOf } from '../../web/editing/attributes.ts'
import { loadFiles, type ReadCirclesOptions } from '../../web/lib/files.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { circlesOfText } from '../../web/view/circle-text.ts'
import { readRegion } from '../../web/view/region-text.ts'
import { library } from '../web/library.ts'

const PROGRAM = new URL('../../build/native/circle-voronoi', import.meta.url).pathname
const files = await loadFiles()

const pathOf = (name: string) => new URL(`brought/${name}`, import.meta.url).pathname
const textOf = (name: string) => readFileSync(pathOf(name), 'utf8')

/** The points to which the program converts a file, and its messages. */
function converted(name: string, ...options: string[]) {
  const args = ['convert', pathOf(name), '--format', 'geojson', ...options]
  const { status, stdout, stderr } = spawnSync(PROGRAM, args, { encoding: 'utf8' })
  return { status, said: stderr.replaceAll(pathOf(name), name), points: status === 0 ? JSON.parse(stdout) : undefined }
}

const propertiesIn = (points: { features: { properties: object }[] }) => points.features.map((f) => f.properties)
const columnsIn = (name: string, options: ReadCirclesOptions = {}) => {
  const { circles, attributes } = files.readCircleFile(textOf(name), { name, ...options })
  return Object.fromEntries(columnsOf(attributes, circles.length / 3).columns.map(({ name, values }) => [name, values]))
}

/** Every reader gives the same circles. */
function expectCircles(name: string, circles: readonly number[]): void {
  const points = converted(name).points.features.flatMap(
    ({ geometry, properties }: { geometry: { coordinates: number[] }; properties: { r: number } }) => [
      ...geometry.coordinates.slice(0, 2),
      properties.r,
    ],
  )
  expect([points, [...files.readCircles(textOf(name))], [...circlesOfText(textOf(name))]]).toEqual([
    circles,
    circles,
    circles,
  ])
}

/** Every reader refuses the file, and skips `count` rows on request. */
function expectSkipped(name: string, message: string, count: number, left: number): void {
  expect(converted(name)).toMatchObject({ status: 2, said: `circle-voronoi: ${message}\n` })
  expect(() => files.readCircles(textOf(name), { name })).toThrow(message)
  expect(() => circlesOfText(textOf(name))).toThrow()
  const { circles, skipped } = files.readCircleFile(textOf(name), { name, skipInvalid: true })
  expect([circles.length / 3, skipped.length, skipped[0]?.message]).toEqual([left, count, message])
  const { points, said } = converted(name, '--skip-invalid')
  expect(points.features).toHaveLength(left)
  expect(said).toContain(`${count} of ${count + left} ${count === 1 ? 'was' : 'were'} skipped; the first: ${message}`)
}

describe('files that people bring', () => {
  it('fips.csv: one type for a column, and zeros stay', () => {
    expectCircles('fips.csv', [0, 0, 1, 5, 0, 1, 0, 5, 1])
    expect(columnsIn('fips.csv')).toEqual({ fips: ['"01001"', '"1003"', '"06037"'], n: ['1', '2', '3.5'] })
    expect(propertiesIn(converted('fips.csv').points)).toEqual([
      { r: 1, fips: '01001', n: 1 },
      { r: 1, fips: '1003', n: 2 },
      { r: 1, fips: '06037', n: 3.5 },
    ])
  })

  it('filialen.csv: the columns of a semicolon table with decimal commas are named, or asked for', () => {
    const message = 'filialen.csv:1: no column is called r, rad or radius, only name, lat, lon, umsatz; name one by '
    expect(converted('filialen.csv').said).toBe(`circle-voronoi: ${message}--radius.\n`)
    expect(() => files.readCircles(textOf('filialen.csv'), { name: 'filialen.csv' })).toThrow(message)
    expect(() => circlesOfText(textOf('filialen.csv'))).toThrow()
    expect(columnsIn('filialen.csv', { points: true })).toEqual({
      name: ['"Zürich; Nord"', '"Bern"', '"Basel"'],
      umsatz: ['1200', '400', '800'],
    })
    const { points } = converted('filialen.csv', '--radius', 'umsatz', '--id', 'name')
    expect(points.features[0]).toMatchObject({
      id: 'Zürich; Nord',
      geometry: { coordinates: [8.55, 47.4] },
      properties: { r: 1200 },
    })
    const table = unknownTable(textOf('filialen.csv')) as Table
    expect(guessedColumns(table)).toEqual({ x: 2, y: 1, r: SAME, kind: 'radius', factor: 1 })
  })

  it('heights-and-ids.geojson: ids, heights, digits, nested values and the coordinate system stay', () => {
    expectCircles('heights-and-ids.geojson', [149.149, -35.315, 0.01, 149.3, -35.5, 0.02])
    const { attributes } = files.readCircleFile(textOf('heights-and-ids.geojson'))
    expect([attributes.ids, attributes.heights]).toEqual([
      ['"a1"', '7'],
      ['578.2', '600'],
    ])
    const given = JSON.parse(textOf('heights-and-ids.geojson'))
    const { points } = converted('heights-and-ids.geojson')
    expect([points.name, points.crs]).toEqual([given.name, given.crs])
    for (const [k, { id, properties, geometry }] of points.features.entries()) {
      const { radius, ...others } = given.features[k].properties
      expect({ id, properties, geometry }).toEqual({
        id: given.features[k].id,
        properties: { r: radius, ...others },
        geometry: given.features[k].geometry,
      })
    }
    expect(attributes.properties[0]).toContain('"big":12345678901234567890')
  })

  it('multipoint.geojson: a MultiPoint of one point is a point', () => {
    expectCircles('multipoint.geojson', [149.149, -35.315, 0.01, 149.3, -35.5, 0.01])
    expect(columnsIn('multipoint.geojson')).toEqual({ ref: ['"0042"', '"0043"'] })
  })

  it('null-geometry.geojson, missing.csv, missing-radius.csv: rows without a place are refused, or skipped and counted', () => {
    expectSkipped('null-geometry.geojson', 'null-geometry.geojson:1: feature 1 has no geometry.', 1, 2)
    expectSkipped('missing.csv', 'missing.csv:3: lon is empty (circle 1, id 2).', 2, 3)
    expectSkipped('missing-radius.csv', 'missing-radius.csv:3: r is empty (circle 1, id 2).', 1, 2)
  })

  it('eight-rows.csv, utm-survey.csv, robots.csv: rows are as they are written', () => {
    for (const name of ['eight-rows.csv', 'utm-survey.csv', 'robots.csv']) {
      const [, ...rows] = textOf(name).trim().split('\n')
      expectCircles(
        name,
        rows.flatMap((row) => row.split(',').map(Number)),
      )
    }
  })

  it('degrees-and-metres.csv: most circles are hidden, and that is said', () => {
    const args = ['compute', pathOf('degrees-and-metres.csv'), '--format', 'wkt']
    expect(spawnSync(PROGRAM, args, { encoding: 'utf8' }).stderr).toContain('2 of 3 circles are hidden')
  })

  it('shared-border.wkt: the error names dissolve, and it helps', async () => {
    const regions = await loadRegions()
    const shape = readRegion(textOf('shared-border.wkt'))
    expect(() => regions.region(shape)).toThrow('`dissolve`')
    expect(regions.region(shape, { dissolve: true }).area).toBe(100)
  })

  it('bubbles.csv: power cells are cut by their circles, in files too', async () => {
    expectCircles('bubbles.csv', [8, 10, 6, 20, 8, 4, 18, 20, 12])
    const { compute } = await loadMetrics({ library })
    const diagram = compute(circlesOfText(textOf('bubbles.csv')), { metric: 'power' })
    const areas = diagram.cellAreas({ maxDistance: 0 })
    const { features } = JSON.parse(files.writeDiagram(diagram, { format: 'geojson', maxDistance: 0 }))
    areas.forEach((area, i) => {
      expect(area).toBeLessThan(Math.PI * (diagram.circles[3 * i + 2] as number) ** 2 * (1 + 1e-12))
      expect(features[i].properties.area).toBeCloseTo(area, 8)
    })
    expect(Math.max(...areas)).toBeGreaterThan(0)
  })
})
