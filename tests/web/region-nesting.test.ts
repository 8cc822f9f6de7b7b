import { describe, expect, it } from 'vitest'
import type { RegionShape } from '../../web/lib/regions.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { readRegion } from '../../web/view/region-text.ts'
import { errorOf } from './errors.ts'

const { region } = await loadRegions()

const POLYGON = '{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4]]]}'
const LEVELS = [
  ['{"type":"Feature","geometry":', '}'],
  ['{"type":"GeometryCollection","geometries":[', ']}'],
  ['{"type":"FeatureCollection","features":[', ']}'],
] as const

function nested([begin, end]: readonly [string, string], depth: number): string {
  return begin.repeat(depth) + POLYGON + end.repeat(depth)
}

describe('geometries inside geometries', () => {
  it.each(LEVELS)('are one error where they are too deep: %s', (...level) => {
    const text = nested(level, 200_000)
    const error = { code: 'badOption' }
    expect(errorOf(() => region(JSON.parse(text)))).toMatchObject(error)
    expect(errorOf(() => readRegion(text))).toMatchObject(error)
  })

  it('are one error where one is part of itself', () => {
    const shape = { type: 'GeometryCollection', geometries: [] as RegionShape[] } as const
    shape.geometries.push(shape)
    expect(errorOf(() => region(shape))).toMatchObject({ code: 'badOption' })
  })

  it.each(LEVELS)('are read where they are not: %s', (...level) => {
    expect(region(JSON.parse(nested(level, 99))).area).toBe(8)
  })
})
