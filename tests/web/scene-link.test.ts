// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { regionOfLink } from '../../web/editing/scene-link.ts'
import { NO_DOMAIN } from '../../web/view/domain.ts'
import { ring } from './shapes.ts'

describe('the region of a link', () => {
  const square = ring(0, 0, 4, 0, 4, 4) as never
  const other = ring(0, 0, 9, 0, 9, 9) as never
  const scene = {
    circles: Float64Array.of(0, 0, 1),
    dataSet: 'rooms',
    isEdited: false,
    domain: { ...NO_DOMAIN, region: square },
  }
  const regionOf = (region: typeof square | undefined, changed = {}) =>
    regionOfLink({ ...scene, ...changed }, { ...NO_DOMAIN, region })

  it('is left out if it is that of the data set, or if there is none', () => {
    expect(regionOf(square)).toEqual({})
    expect(regionOf(undefined, { dataSet: '' })).toEqual({})
  })

  it('is told if it is another one, or was taken away', () => {
    expect(regionOf(other)).toEqual({ region: other })
    expect(regionOf(undefined)).toEqual({ region: null })
    expect(regionOf(square, { isEdited: true })).toEqual({ region: square })
    expect(regionOf(square, { dataSet: '' })).toEqual({ region: square })
  })
})
