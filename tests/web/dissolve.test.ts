import { expect, it } from 'vitest'
import type { RegionShape } from '../../web/lib/regions.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { problemOf } from './errors.ts'
import { library } from './library.ts'
import { box } from './shapes.ts'

const { region } = await loadRegions()

const multi = (...rings: number[][][]): RegionShape => ({
  type: 'MultiPolygon',
  coordinates: rings.map((ring) => [ring]),
})

it('polygons that share a border become their union', () => {
  const counties = multi(box(0, 0, 5, 10), box(5, 0, 10, 10))
  expect(problemOf(() => region(counties))).toMatch(
    /^badOption: Side 1 .* overlap beside \(5, 0\)\. Set `dissolve` to merge them\.$/,
  )
  const land = region(counties, { dissolve: true })
  expect([land.area, land.perimeter, land.ringOffsets.length]).toEqual([100, 40, 2])
  const dissolved = { ...counties, dissolve: true } as RegionShape
  expect(region(dissolved).area).toBe(100)
  expect(problemOf(() => region(dissolved, { dissolve: false }))).toMatch(/overlap beside/)
  const diagram = library.compute(Float64Array.of(2, 2, 1, 8, 7, 0))
  expect(diagram.cellAreas({ region: land }).reduce((sum, area) => sum + area)).toBeCloseTo(100, 10)
})

it('polygons that overlap, nest or repeat become their union', () => {
  const shapes: [RegionShape, number][] = [
    [multi(box(0, 0, 4, 4), box(2, 2, 6, 6)), 28],
    [multi(box(0, 0, 9, 9), box(2, 2, 6, 6)), 81],
    [multi(box(0, 0, 3, 3), box(0, 0, 3, 3)), 9],
    [
      {
        type: 'FeatureCollection',
        features: [
          { type: 'Feature', geometry: { type: 'Polygon', coordinates: [box(0, 0, 9, 9), box(2, 2, 6, 6)] } },
          { type: 'Feature', geometry: { type: 'Polygon', coordinates: [box(2, 2, 6, 6)] } },
        ],
      },
      81,
    ],
    [[box(0, 0, 4, 4), box(4, 0, 6, 4), box(1, 1, 2, 2)], 23],
  ]
  for (const [shape, area] of shapes) expect(region(shape, { dissolve: true }).area).toBe(area)
})

it('polygons without an area are refused', () => {
  expect(problemOf(() => region(multi(box(0, 0, 0, 1)), { dissolve: true }))).toBe('badOption: The region has no area.')
})
