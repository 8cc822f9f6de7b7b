// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { cameraOf, cameraShowing, regionOfLink } from '../../web/editing/scene-link.ts'
import { fitted, NO_PADDING } from '../../web/view/camera.ts'
import { NO_DOMAIN } from '../../web/view/domain.ts'
import { ring } from './shapes.ts'

describe('the region of a link', () => {
  const square = [ring(0, 0, 4, 0, 4, 4)]
  const other = [ring(0, 0, 9, 0, 9, 9)]
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

describe('the viewport of a link', () => {
  const size = { width: 200, height: 100 }
  const box = { minX: 10, minY: 20, maxX: 30, maxY: 30 }
  const whole = fitted(box, size, NO_PADDING)
  const look = (x: number, y: number, zoom: number) => {
    const view = { x, y, span: 100 / (zoom * whole.scale) }
    const camera = cameraShowing(view, box, size, NO_PADDING)
    if (camera.scale === whole.scale && camera.x === whole.x && camera.y === whole.y) return 'whole'
    expect(camera).toEqual(cameraOf(view, size))
    return 'own'
  }

  it('is used near the circles, within the limits of zooming', () => {
    expect(cameraShowing(undefined, box, size, NO_PADDING)).toEqual(whole)
    const cases = [
      [-10, 25, 1, 'own'],
      [-10.1, 25, 1, 'whole'],
      [50, 25, 1, 'own'],
      [50.1, 25, 1, 'whole'],
      [20, 10, 1, 'own'],
      [20, 9.9, 1, 'whole'],
      [20, 40, 1, 'own'],
      [20, 40.1, 1, 'whole'],
      [21, 25, 0.051, 'own'],
      [21, 25, 0.049, 'whole'],
      [21, 25, 0.99e7, 'own'],
      [21, 25, 1.01e7, 'whole'],
    ] as const
    for (const [x, y, zoom, used] of cases) expect([x, y, zoom, look(x, y, zoom)]).toEqual([x, y, zoom, used])
  })
})
