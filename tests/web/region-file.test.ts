// SPDX-License-Identifier: GPL-3.0-or-later
// Files that may contain regions are read only as far as needed, and parsed once.
import { expect, it, vi } from 'vitest'
import { FileActions } from '../../web/app/files/file-actions.ts'
import { regionOfFile, regionOfText } from '../../web/app/files/region-file.ts'
import { ring } from './shapes.ts'

const SQUARE = {
  type: 'Polygon',
  coordinates: [ring(0, 0, 9, 0, 9, 9, 0, 9, 0, 0)],
}
const REGION = JSON.stringify({ type: 'Feature', properties: null, geometry: SQUARE })

it('a region is parsed once', () => {
  const parse = vi.spyOn(JSON, 'parse')
  expect(regionOfText(REGION)?.()).toMatchObject({ type: 'MultiPolygon' })
  expect(parse).toHaveBeenCalledTimes(1)
  parse.mockRestore()
})

it('points, with polygons beside them or not, are no region', () => {
  const point = { type: 'Feature', properties: { r: 1 }, geometry: { type: 'Point', coordinates: [1, 2] } }
  const several = { ...point, geometry: { type: 'MultiPoint', coordinates: [[1, 2]] } }
  for (const feature of [point, several]) {
    const features = [feature, { type: 'Feature', properties: null, geometry: SQUARE }]
    expect(regionOfText(JSON.stringify({ type: 'FeatureCollection', features }))).toBeUndefined()
  }
  expect(regionOfText('x,y,r\n1,2,3')).toBeUndefined()
  expect(regionOfText('POLYGON ((0 0, 1 0, 1 1))')?.()).toMatchObject({ type: 'MultiPolygon' })
})

it('polygons of a collection of geometries are a region, unless there are points among them', () => {
  const collection = (...geometries: object[]) => JSON.stringify({ type: 'GeometryCollection', geometries })
  const point = { type: 'Point', coordinates: [1, 2] }
  expect(regionOfText(collection(SQUARE, SQUARE))?.()).toMatchObject({ type: 'MultiPolygon' })
  expect(regionOfText(collection(SQUARE, point))).toBeUndefined()
  expect(regionOfText(collection({ type: 'GeometryCollection', geometries: [SQUARE] }))).toBeDefined()
})

it('a picture is not read as a region', async () => {
  const text = vi.spyOn(Blob.prototype, 'text')
  expect(await regionOfFile(new Blob([REGION], { type: 'image/png' }))).toBeUndefined()
  expect(text).not.toHaveBeenCalled()
  text.mockRestore()
  expect(await regionOfFile(new Blob([REGION], { type: 'application/json' }))).toBeDefined()
})

it('a file whose beginning is no region is read no further', async () => {
  const text = vi.spyOn(Blob.prototype, 'text')
  expect(await regionOfFile(new Blob(['x,y,r\n', '1,2,3\n'.repeat(10_000)]))).toBeUndefined()
  expect(text).toHaveBeenCalledTimes(1)
  text.mockRestore()
})

it('a file that is too large is refused before it is read, whatever it looks like', async () => {
  const said: string[] = []
  const complain = (problem: string) => said.push(problem)
  const actions = {
    complain,
    beginGesture: () => 1,
    openRead: (read: () => Promise<unknown>) => read().catch((error: Error) => complain(error.message)),
  }
  const nothing = undefined as never
  const opening = new FileActions(nothing, nothing, actions as never, nothing, nothing)
  const read = vi.fn()
  const file = {
    name: 'huge.geojson',
    size: 2 ** 28 + 1,
    type: '',
    text: read,
    arrayBuffer: read,
    slice: read,
  } as never
  await opening.openFile(file)
  await opening.openRegion(file)
  expect(said).toEqual(Array(2).fill('huge.geojson: the file is too large.'))
  expect(read).not.toHaveBeenCalled()
})
