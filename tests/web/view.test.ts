// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { boundingBox, fitted, panned, toPlane, toScreen, visibleBox, zoomed } from '../../web/app/camera.ts'
import { parseCircles } from '../../web/app/csv.ts'
import { hitTest } from '../../web/app/hit-test.ts'
import { tintClasses } from '../../web/app/tints.ts'

const SIZE = { width: 800, height: 600 }
const camera = fc.record({
  x: fc.double({ min: -100, max: 100, noNaN: true }),
  y: fc.double({ min: -100, max: 100, noNaN: true }),
  scale: fc.double({ min: 0.1, max: 100, noNaN: true }),
})
const pixel = fc.record({ x: fc.integer({ min: 0, max: 800 }), y: fc.integer({ min: 0, max: 600 }) })

describe('camera', () => {
  it('goes from the screen to the plane and back', () => {
    fc.assert(
      fc.property(camera, pixel, (camera, point) => {
        const back = toScreen(camera, SIZE, toPlane(camera, SIZE, point))
        expect(back.x).toBeCloseTo(point.x, 6)
        expect(back.y).toBeCloseTo(point.y, 6)
      }),
    )
  })

  it('has y upwards in the plane', () => {
    const flat = { x: 0, y: 0, scale: 1 }
    expect(toPlane(flat, SIZE, { x: 400, y: 0 }).y).toBe(300)
  })

  it('keeps the anchor in its place while it zooms', () => {
    fc.assert(
      fc.property(camera, pixel, fc.double({ min: 0.1, max: 10, noNaN: true }), (camera, anchor, factor) => {
        const before = toPlane(camera, SIZE, anchor)
        const after = toPlane(zoomed(camera, SIZE, anchor, factor), SIZE, anchor)
        expect(after.x).toBeCloseTo(before.x, 6)
        expect(after.y).toBeCloseTo(before.y, 6)
      }),
    )
  })

  it('takes what is under the pointer along while it pans', () => {
    const before = { x: 3, y: 4, scale: 2 }
    const held = toPlane(before, SIZE, { x: 100, y: 100 })
    expect(toScreen(panned(before, 30, -20), SIZE, held)).toEqual({ x: 130, y: 80 })
  })

  it('fits a box into what the padding leaves', () => {
    const box = { minX: -3, minY: 1, maxX: 9, maxY: 4 }
    const padding = { top: 100, right: 20, bottom: 50, left: 60 }
    const camera = fitted(box, SIZE, padding)
    const low = toScreen(camera, SIZE, { x: box.minX, y: box.minY })
    const high = toScreen(camera, SIZE, { x: box.maxX, y: box.maxY })
    expect(low.x).toBeCloseTo(60)
    expect(high.x).toBeCloseTo(780)
    expect((low.y + high.y) / 2).toBeCloseTo(100 + 450 / 2)
    expect(visibleBox(camera, SIZE).minX).toBeLessThan(box.minX)
  })

  it('finds a box even around nothing or a single point', () => {
    expect(boundingBox(new Float64Array(0))).toEqual({ minX: -1, minY: -1, maxX: 1, maxY: 1 })
    expect(boundingBox(Float64Array.of(5, 5, 0))).toEqual({ minX: 4, minY: 4, maxX: 6, maxY: 6 })
    expect(boundingBox(Float64Array.of(5, 5, 2, 0, 0, 1))).toEqual({ minX: -1, minY: -1, maxX: 7, maxY: 7 })
  })
})

describe('hitTest', () => {
  const circles = Float64Array.of(0, 0, 10, 3, 0, 2, 40, 0, 0.1)

  it.each([
    [
      { x: -5, y: 0 },
      { circle: 0, part: 'disc' },
    ],
    [
      { x: -10.2, y: 0 },
      { circle: 0, part: 'rim' },
    ],
    [
      { x: 3, y: 0.5 },
      { circle: 1, part: 'disc' },
    ],
    [
      { x: 5.1, y: 0 },
      { circle: 1, part: 'rim' },
    ],
    [
      { x: 40.4, y: 0 },
      { circle: 2, part: 'disc' },
    ],
    [
      { x: 38, y: 0 },
      { circle: 2, part: 'cell' },
    ],
  ])('at %j is %j', (point, hit) => {
    expect(hitTest(circles, point, 0.5)).toEqual(hit)
  })

  it('hits nothing where there is nothing', () => {
    expect(hitTest(new Float64Array(0), { x: 0, y: 0 }, 1)).toBeUndefined()
  })
})

describe('parseCircles', () => {
  it('reads lines with a header, blank lines and either line end', () => {
    expect([...parseCircles('x,y,r\r\n1,2,3\r\n\r\n -4e1 , 5.5,0\n')]).toEqual([1, 2, 3, -40, 5.5, 0])
  })

  it('reads lines without a header', () => {
    expect([...parseCircles('1,2,3')]).toEqual([1, 2, 3])
  })

  it.each(['x,y,r\n1,2', '1,2,3,4', '1,2,3\n1,,3', 'x,y,r\nx,y,r'])('names the line that is wrong in %j', (text) => {
    expect(() => parseCircles(text)).toThrow(/^Line \d/)
  })
})

describe('tintClasses', () => {
  it('puts as many circles into each class, smaller ones before larger ones', () => {
    const circles = Float64Array.from([5, 1, 3, 2, 6, 4].flatMap((r) => [0, 0, r]))
    expect([...tintClasses(circles, 3)]).toEqual([2, 0, 1, 0, 2, 1])
  })

  it('gives equal radii one class', () => {
    expect(new Set(tintClasses(new Float64Array(30).fill(1), 6)).size).toBe(1)
  })
})
