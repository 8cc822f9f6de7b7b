// SPDX-License-Identifier: GPL-3.0-or-later
// Files that may contain regions are read only as far as needed, and parsed once.
import { expect, it, vi } from 'vitest'
import { regionOfFile, regionOfText } from '../../web/app/files/region-file.ts'
import { ring } from './shapes.ts'

const SQUARE = {
  type: 'Polygon',
  coordinates: [ring(0, 0, 9, 0, 9, 9, 0, 9, 0, 0)],
}
const REGION = JSON.stringify({ type: 'Feature', properties: null, geometry: SQUARE })

it('a region is parsed once', () => {
  const parse = vi.spyOn(JSON, 'parse')
  expect(regionOfText(REGION)?.read()).toMatchObject({ type: 'MultiPolygon' })
  expect(parse).toHaveBeenCalledTimes(1)
  parse.mockRestore()
})

it('points are no region, and polygons beside them are the region of circles', () => {
  const point = { type: 'Feature', properties: { r: 1 }, geometry: { type: 'Point', coordinates: [1, 2] } }
  const several = { ...point, geometry: { type: 'MultiPoint', coordinates: [[1, 2]] } }
  const polygon = { type: 'Feature', properties: null, geometry: SQUARE }
  const found = (...features: object[]) => regionOfText(JSON.stringify({ type: 'FeatureCollection', features }))
  for (const feature of [point, several]) {
    expect(found(feature)).toBeUndefined()
    const region = found(polygon, feature, polygon)
    expect(region?.polygons).toEqual([0, 2])
    expect(region?.read()).toMatchObject({ coordinates: [SQUARE.coordinates, SQUARE.coordinates] })
  }
  expect(found(polygon)?.polygons).toBeUndefined()
  // The reader refuses a feature with both.
  const both = { type: 'GeometryCollection', geometries: [SQUARE, point.geometry] }
  expect(found({ ...point, geometry: both }, polygon)?.polygons).toEqual([1])
  expect(regionOfText('x,y,r\n1,2,3')).toBeUndefined()
  expect(regionOfText('POLYGON ((0 0, 1 0, 1 1))')?.read()).toMatchObject({ type: 'MultiPolygon' })
})

it('polygons of a collection of geometries are a region, unless there are points among them', () => {
  const collection = (...geometries: object[]) => JSON.stringify({ type: 'GeometryCollection', geometries })
  const point = { type: 'Point', coordinates: [1, 2] }
  expect(regionOfText(collection(SQUARE, SQUARE))?.read()).toMatchObject({ type: 'MultiPolygon' })
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
