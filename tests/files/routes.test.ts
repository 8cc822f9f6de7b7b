// SPDX-License-Identifier: GPL-3.0-or-later
// The attributes that survive each conversion: the table of docs/shell.md, cell by cell, in the program and in
// JavaScript. Cells that say "no" are tested, too.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, describe, expect, it } from 'vitest'
import { loadFiles } from '../../web/lib/files.ts'
import { library } from '../web/library.ts'

const PROGRAM = new URL('../../build/native/circle-voronoi', import.meta.url).pathname
const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-routes-'))
afterAll(() => rmSync(folder, { recursive: true }))
const files = await loadFiles()

/** Three stores in an arbitrary order, with all attributes of circles. */
const STORES = JSON.stringify({
  type: 'FeatureCollection',
  name: 'stores',
  crs: { type: 'name', properties: { name: 'urn:ogc:def:crs:OGC:1.3:CRS84' } },
  features: [
    ['c3', '01003', 149.3, -35.5, 600.5],
    ['a1', '01001', 149.149, -35.315, 578.25],
    ['b2', '06037', 149, -35.2, 612],
  ].map(([id, fips, x, y, z], k) => ({
    type: 'Feature',
    id,
    properties: {
      radius: 0.01 + k / 100,
      fips,
      count: k + 1,
      address: { zip: '01730', tags: ['a', 'b'] },
      empty: null,
    },
    geometry: { type: 'Point', coordinates: [x, y, z] },
  })),
}).replaceAll('"count":1', '"count":12345678901234567890')
const REGION = 'POLYGON ((148 -37, 151 -37, 151 -34, 148 -34))'

/** The attributes that remain after a conversion. */
type Survival = Readonly<Record<(typeof ATTRIBUTES)[number], boolean>>
const ATTRIBUTES = ['columns', 'type', 'digits', 'nested', 'id', 'height', 'collection', 'order'] as const

/** The features of a text of cells or points, as GeoJSON. */
function survivalIn(text: string): Survival {
  const { crs, features } = JSON.parse(text) as {
    readonly crs?: { readonly properties: { readonly name: string } }
    readonly features: readonly {
      readonly id?: string
      readonly properties: Readonly<Record<string, unknown>> & { readonly address?: { readonly zip: string } }
      readonly geometry: { readonly type: string; readonly coordinates: readonly unknown[] }
    }[]
  }
  const each = (isSo: (feature: (typeof features)[number], k: number) => boolean) => features.every(isSo)
  const fips = ['01003', '01001', '06037']
  return {
    columns: each(({ properties }) => properties.fips !== undefined && properties.count !== undefined),
    type: each(
      ({ properties }, k) => typeof properties.fips === 'string' && typeof properties.count === 'number' && k < 3,
    ),
    digits: text.includes('"count":12345678901234567890'),
    nested: each(({ properties }) => properties.address?.zip === '01730'),
    id: each(({ id }, k) => id === ['c3', 'a1', 'b2'][k]),
    height: each(({ properties, geometry }, k) => {
      const height = geometry.type === 'Point' ? geometry.coordinates[2] : properties.z
      return height === [600.5, 578.25, 612][k]
    }),
    collection: crs?.properties.name === 'urn:ogc:def:crs:OGC:1.3:CRS84',
    order: each(({ properties }, k) => Number(properties.fips) === Number(fips[k])),
  }
}

function program(args: readonly string[], input?: string): string {
  return execFileSync(PROGRAM, args, { input, encoding: 'utf8', stdio: ['pipe', 'pipe', 'ignore'] })
}

function file(name: string, text: string): string {
  const path = join(folder, name)
  writeFileSync(path, text)
  return path
}

const script = file('script.csv', 'replace,0,149.3,-35.4,0.01\n')
const region = file('region.wkt', REGION)
const points = ['convert', '-', '--format', 'geojson']
const cells = (more: readonly string[]) => ['--format', 'geojson', ...more]

/** The conversions by their names in the table. The last step of each gives GeoJSON. */
const routes: Readonly<Record<string, () => string>> = {
  '`convert` to `csv`': () => program(points, program(['convert', '-', '--format', 'csv'], STORES)),
  '`convert` to `json`': () => program(points, program(['convert', '-', '--format', 'json'], STORES)),
  '`convert` to `geojson`': () => program(points, STORES),
  '`compute` to `json`, then `convert`': () => program(points, program(['compute', '-'], STORES)),
  '`compute` to `json`, then `convert --circles` to `csv`': () =>
    program(points, program(['convert', '-', '--circles', '--format', 'csv'], program(['compute', '-'], STORES))),
  '`compute` to `geojson`': () => program(['compute', '-', ...cells([])], STORES),
  '`compute` to `geojsonl`': () => collectionOf(program(['compute', '-', '--format', 'geojsonl'], STORES)),
  '`compute` to `cells`': () => program(points, program(['compute', '-', '--format', 'cells'], STORES)),
  '`compute --region` to `geojson`': () => program(['compute', '-', ...cells(['--region', region])], STORES),
  '`edit` to `geojson`': () => program(['edit', '-', ...cells(['--script', script])], STORES),
  '`edit` of a diagram to `json`, then `convert`': () =>
    program(points, program(['edit', '-', '--script', script], program(['compute', '-'], STORES))),
  '`fit` to `geojson`': () =>
    program(['fit', '-', '--areas', 'radius2', '--shares', ...cells(['--region', region])], withAreas()),
  '`certify` of `json`, then `convert`': () => {
    const diagram = file('diagram.json', program(['compute', '-'], STORES))
    program(['certify', diagram])
    return program(points, readFileSync(diagram, 'utf8'))
  },
  'JavaScript, circles as `csv`': () => circlesThrough('csv'),
  'JavaScript, circles as `json`': () => circlesThrough('json'),
  'JavaScript, circles as `geojson`': () => circlesThrough('geojson'),
  'JavaScript, diagrams as `json`': () => {
    const { circles, attributes } = files.readCircleFile(STORES)
    const read = files.readDiagramFile(files.writeDiagram(library.compute(circles), { attributes }))
    return files.writeDiagram(read.diagram, { format: 'geojson', attributes: read.attributes })
  },
}

function withAreas(): string {
  return STORES.replaceAll('"radius":', '"radius2":1,"radius":')
}

function collectionOf(lines: string): string {
  return `{"type":"FeatureCollection","features":[${lines.trimEnd().split('\n').join(',')}]}`
}

function circlesThrough(format: 'csv' | 'json' | 'geojson'): string {
  const { circles, attributes } = files.readCircleFile(STORES)
  const read = files.readCircleFile(files.writeCircles(circles, { format, attributes }))
  expect(read.circles).toEqual(circles)
  return files.writeCircles(read.circles, { format: 'geojson', attributes: read.attributes })
}

/** The document's table: each conversion with its attributes. */
function documented(): ReadonlyMap<string, Survival> {
  const text = readFileSync(new URL('../../docs/shell.md', import.meta.url), 'utf8')
  const lines = text.split('\n').filter((line) => line.startsWith('|'))
  const start = lines.findIndex((line) => line.startsWith('| route |'))
  const rows = lines.slice(start).map((line) =>
    line
      .split('|')
      .slice(1, -1)
      .map((field) => field.trim()),
  )
  const [heading = [], , ...body] = rows
  expect(heading.slice(1)).toEqual([...ATTRIBUTES])
  return new Map(
    body
      .slice(0, Object.keys(routes).length)
      .map(([route = '', ...says]) => [
        route,
        Object.fromEntries(ATTRIBUTES.map((name, k) => [name, says[k] === 'yes'])) as Survival,
      ]),
  )
}

describe('attributes survive as the document says', () => {
  const table = documented()
  it('on all routes', () => {
    expect([...table.keys()]).toEqual(Object.keys(routes))
  })
  it.each(Object.entries(routes))('%s', (name, route) => {
    expect(survivalIn(route())).toEqual(table.get(name))
  })
})

it('a table goes to GeoJSON and back', () => {
  const table = 'x,y,r,id,z,fips,n,note\n0,0,1,A,1.50,01001,1,"a ""b"", c"\n5,0,1,B,2,"1003",,\n'
  expect(program(['convert', '-', '--format', 'csv'], program(points, table))).toBe(table)
  const read = files.readCircleFile(table)
  const geojson = files.writeCircles(read.circles, { format: 'geojson', attributes: read.attributes })
  const back = files.readCircleFile(geojson)
  expect(files.writeCircles(back.circles, { attributes: back.attributes })).toBe(table)
})
