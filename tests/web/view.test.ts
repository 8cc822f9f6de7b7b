// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { roundLength } from '../../web/app/panels/scale.ts'
import type { Box, Edit } from '../../web/lib/index.ts'
import { boundingBox, fitted, panned, toPlane, toScreen, zoomed } from '../../web/view/camera.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { DEFAULT_LAYERS, type Layers, MOST_MAPPED } from '../../web/view/layers.ts'
import { BoxIndex } from '../../web/view/painter/box-index.ts'
import { addAround } from '../../web/view/painter/boxes.ts'
import { mergeOverlapping } from '../../web/view/painter/grid.ts'
import { PaintedScene } from '../../web/view/painter/painted-scene.ts'
import { Picture } from '../../web/view/painter/picture.ts'
import { pictureFrame } from '../../web/view/picture-frame.ts'
import type { PixelBox } from '../../web/view/protocol.ts'
import { library, seededRandom } from './library.ts'
import { signedDistance } from './oracle.ts'

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
  })

  it('finds a box even around nothing or a single point', () => {
    expect(boundingBox(new Float64Array(0))).toEqual({ minX: -1, minY: -1, maxX: 1, maxY: 1 })
    expect(boundingBox(Float64Array.of(5, 5, 0))).toEqual({ minX: 4, minY: 4, maxX: 6, maxY: 6 })
    expect(boundingBox(Float64Array.of(5, 5, 2, 0, 0, 1))).toEqual({ minX: -1, minY: -1, maxX: 7, maxY: 7 })
  })
})

describe('the frame of a picture', () => {
  const camera = { x: 1, y: 2, scale: 3 }

  it('has so many pixels for each that is seen, one at least', () => {
    expect(pictureFrame(camera, SIZE, 1.5)).toEqual({ x: 1, y: 2, scale: 4.5, width: 1200, height: 900 })
    expect(pictureFrame(camera, { width: 0, height: 0 }, 1)).toMatchObject({ width: 1, height: 1 })
  })

  it.each([
    ...[0, -1, Number.NaN, '2', undefined, 21, Number.POSITIVE_INFINITY].map((scale) => [SIZE, scale] as const),
    [{ width: 10_000, height: 10_000 }, 1.2] as const,
  ])('is none that no browser draws: %j times %j', (size, scale) => {
    expect(() => pictureFrame(camera, size, scale as number)).toThrow(expect.objectContaining({ code: 'badInput' }))
  })
})

describe('what is hit', () => {
  const circles = new CircleTable(Float64Array.of(0, 0, 10, 3, 0, 2, 40, 0, 0.1))

  it.each([
    [-5, 0, 0, 'disc'],
    [-10.2, 0, 0, 'rim'],
    [3, 0.5, 1, 'disc'],
    [5.1, 0, 1, 'rim'],
    [40.4, 0, 2, 'disc'],
    [38, 0, 2, 'cell'],
  ])('at %d, %d is circle %d by its %s', (x, y, id, part) => {
    expect(circles.hitAt({ x, y }, 0.5)).toEqual({ id, part })
  })

  it('is the nearest of two rims that overlap', () => {
    const two = new CircleTable(Float64Array.of(0, 0, 10, 1, 0, 10))
    expect(two.hitAt({ x: 10.2, y: 0 }, 1)).toEqual({ id: 0, part: 'rim' })
    expect(two.hitAt({ x: 10.8, y: 0 }, 1)).toEqual({ id: 1, part: 'rim' })
  })

  it('of a finger is the nearest small circle in its reach, also above a large one and beside others', () => {
    const scene = new CircleTable(Float64Array.of(0, 0, 10, 2, 0, 0.2, 4, 0, 0.2, 30, 0, 5))
    expect(scene.hitAt({ x: 2.9, y: 0 }, 0.5, 2)).toEqual({ id: 1, part: 'disc', inReach: 2 })
    expect(scene.hitAt({ x: 3.1, y: 0 }, 0.5, 2)).toEqual({ id: 2, part: 'disc', inReach: 2 })
    expect(scene.hitAt({ x: -5, y: 0 }, 0.5, 2)).toEqual({ id: 0, part: 'disc' })
    expect(scene.hitAt({ x: 25.2, y: 0 }, 0.5, 2)).toEqual({ id: 3, part: 'rim' })
    expect(scene.hitAt({ x: 20, y: 0 }, 0.5, 2)).toEqual({ id: 3, part: 'cell' })
    // A mouse needs less room.
    expect(scene.hitAt({ x: 3.1, y: 0 }, 0.5)).toEqual({ id: 0, part: 'disc' })
  })

  it('is nothing where there is nothing', () => {
    expect(new CircleTable(new Float64Array()).hitAt({ x: 0, y: 0 }, 1)).toBeUndefined()
  })
})

describe('the cell that is hit', () => {
  it('is that of the diagram, also where circles hide others', () => {
    const random = seededRandom(11)
    for (const most of [0, 0.05, 0.6]) {
      const circles = Float64Array.from({ length: 300 }, (_, k) => (k % 3 === 2 ? most * random() : random()))
      const scene = new PaintedScene(library)
      scene.open(circles)
      const table = new CircleTable(circles)
      for (let k = 0; k < 200; k++) {
        const [x, y] = [2 * random() - 0.5, 2 * random() - 0.5]
        const hit = table.hitAt({ x, y }, 0)
        if (hit?.part === 'cell') expect(hit.id).toBe(scene.nearest(x, y))
        else expect(signedDistance(circles, hit?.id as number, { x, y })).toBeLessThanOrEqual(0)
      }
    }
  })

  it('is that of the nearest image of a circle that repeats', () => {
    const lattice = { a: [3, 0], b: [7, 0.5] } as const
    const random = seededRandom(12)
    const circles = Float64Array.from({ length: 30 }, (_, k) => (k % 3 === 2 ? 0.05 * random() : random()))
    const scene = new PaintedScene(library)
    const { circles: wrapped = circles } = scene.open(circles, { lattice })
    const table = new CircleTable(wrapped as Float64Array<ArrayBuffer>)
    for (let k = 0; k < 300; k++) {
      const [x, y] = [20 * random() - 10, 20 * random() - 10]
      const hit = table.hitAt({ x, y }, 0, 0, { lattice })
      if (hit?.part === 'cell') expect(hit.id).toBe(scene.nearest(x, y))
    }
  })
})

describe('the length of the scale bar', () => {
  it('is the largest round one that fits', () => {
    fc.assert(
      fc.property(fc.double({ min: 1e-12, max: 1e12, noNaN: true }), (most) => {
        const length = roundLength(most)
        expect(length).toBeLessThanOrEqual(most)
        expect(length).toBeGreaterThan(most / 2.5001)
        expect(String(length)).toMatch(/^(0\.0*)?[125]0*(e[+-]\d+)?$/)
      }),
    )
    expect([roundLength(1), roundLength(0.99), roundLength(3), roundLength(49)]).toEqual([1, 0.5, 2, 20])
  })
})

describe('the color of a circle', () => {
  const colorsOf = (radii: readonly number[], cells: Layers['cells']) => {
    const picture = new Picture(library.edit(radii.map((r, k) => [10 * k, 0, r])))
    picture.layers = { ...DEFAULT_LAYERS, cells }
    return radii.map((_, i) => picture.colorOf(i))
  }

  it('is darker for larger ones by radius', () => {
    expect(colorsOf([5, 1, 3, 2, 4], 'radius')).toEqual([60, 0, 30, 15, 45])
  })

  it('is the same for equal radii', () => {
    expect(new Set(colorsOf(new Array(30).fill(1), 'radius')).size).toBe(1)
  })

  it('is another one than those of neighbors by itself, and of many circles by radius', () => {
    const few = colorsOf([1, 1, 1, 1], 'auto')
    expect(few.every((color, i) => i === 0 || color !== few[i - 1])).toBe(true)
    expect(colorsOf([5, 1, 3, 2, 4, ...new Array(MOST_MAPPED).fill(3)], 'auto').slice(0, 2)).toEqual([60, 0])
  })
})

describe('circles that are brought far out', () => {
  it('have cells wherever a new picture has them', () => {
    const picture = new Picture(library.edit([]))
    for (const distance of [1, 30, 1e3, 1e5, 1e8]) {
      const edits = [-1, 1].map((side) => ({ kind: 'insert', circle: [side * distance, distance / 3, 0] }) as const)
      picture.apply(picture.editor.apply(edits))
      const fresh = new Picture(library.edit(picture.diagram.circles))
      const [far, width] = [100 * distance, distance / 10]
      const between = [
        { minX: -width, minY: far, maxX: width, maxY: far + width },
        { minX: -width, minY: -far - width, maxX: width, maxY: -far },
      ]
      for (const box of between) expect(picture.circlesIn(box)).toEqual(fresh.circlesIn(box))
    }
  })
})

describe('parts of a picture that are painted anew', () => {
  const coverOf = (boxes: readonly PixelBox[]) => {
    const pixels = new Map<string, number>()
    for (const { left, top, width, height } of boxes) {
      for (let y = top; y < top + height; y++) {
        for (let x = left; x < left + width; x++) pixels.set(`${x} ${y}`, (pixels.get(`${x} ${y}`) ?? 0) + 1)
      }
    }
    return pixels
  }

  it('cover all boxes, and no pixel twice', () => {
    const random = seededRandom(4)
    const some = (most: number) => 1 + Math.floor(most * random())
    for (let k = 0; k < 200; k++) {
      const boxes = Array.from({ length: some(5) }, () => ({
        left: some(30),
        top: some(30),
        width: some(12),
        height: some(12),
      }))
      const covered = coverOf(mergeOverlapping(boxes))
      expect([...covered.values()].every((count) => count === 1)).toBe(true)
      expect([...coverOf(boxes).keys()].every((pixel) => covered.has(pixel))).toBe(true)
    }
    expect(mergeOverlapping([{ left: 0, top: 0, width: 2, height: 2 }])).toEqual([
      { left: 0, top: 0, width: 2, height: 2 },
    ])
  })
})

describe('what an edit changes in a picture', () => {
  const random = seededRandom(5)
  const circles = () => Float64Array.from({ length: 600 }, (_, k) => (k % 3 === 2 ? 0.3 * random() : 20 * random()))

  it('lies in the boxes that are painted anew', () => {
    const picture = new Picture(library.edit(circles()))
    for (let k = 0; k < 200; k++) {
      const before = outlines(picture)
      const ids = picture.editor.ids()
      const id = ids[Math.floor(random() * ids.length)] as number
      const circle = { x: 20 * random(), y: 20 * random(), r: random() ** 4 * 3 }
      const [edit] = [
        [{ kind: 'replace', id, circle } as const],
        [{ kind: 'insert', circle } as const],
        [{ kind: 'remove', id } as const],
      ].slice(k % 3)
      const { boxes } = picture.apply(picture.editor.apply(edit as Edit[]))
      const after = outlines(picture)
      for (const [x, y, look] of [...before.filter(isNotIn(after)), ...after.filter(isNotIn(before))]) {
        const isInside = boxes.some(
          ({ minX, minY, maxX, maxY }) => x >= minX - 1e-6 && x <= maxX + 1e-6 && y >= minY - 1e-6 && y <= maxY + 1e-6,
        )
        expect(isInside, `edit ${k}: ${look}`).toBe(true)
      }
    }
  })

  /** The vertices of a picture in a canonical form. */
  function outlines({ diagram }: Picture): [number, number, string][] {
    return Array.from({ length: diagram.vertices.length / 3 }, (_, v) => {
      const [x, y] = [diagram.vertices[3 * v] as number, diagram.vertices[3 * v + 1] as number]
      return [x, y, `${x.toFixed(9)} ${y.toFixed(9)}`]
    })
  }

  function isNotIn(list: readonly [number, number, string][]): (entry: [number, number, string]) => boolean {
    const known = new Set(list.map(([, , look]) => look))
    return ([, , look]) => !known.has(look)
  }
})

describe('the box of a circle and its cell', () => {
  const reachOf = (circles: Float64Array) => {
    const { minX, minY, maxX, maxY } = boundingBox(circles)
    return Math.max(maxX - minX, maxY - minY)
  }
  const inputs = fc.array(
    fc.tuple(
      fc.integer({ min: -20, max: 20 }),
      fc.integer({ min: -20, max: 20 }),
      fc.oneof(fc.constant(0), fc.double({ min: 0.001, max: 9, noNaN: true }), fc.constant(3)),
    ),
    { minLength: 1, maxLength: 12 },
  )

  it('holds every point of the cell, near and far', () => {
    const random = seededRandom(3)
    fc.assert(
      fc.property(inputs, (list) => {
        const picture = new Picture(library.edit(list))
        const { diagram, index } = picture
        const extent = reachOf(diagram.circles)
        for (let k = 0; k < 60; k++) {
          const spread = extent * (k % 2 === 0 ? 1 : 200)
          const box = boundingBox(diagram.circles)
          const x = (box.minX + box.maxX) / 2 + spread * (random() - 0.5)
          const y = (box.minY + box.maxY) / 2 + spread * (random() - 0.5)
          const { minX, minY, maxX, maxY } = index.get(diagram.find(x, y))
          const slack = 1e-9 * spread
          expect(x).toBeGreaterThanOrEqual(minX - slack)
          expect(y).toBeGreaterThanOrEqual(minY - slack)
          expect(x).toBeLessThanOrEqual(maxX + slack)
          expect(y).toBeLessThanOrEqual(maxY + slack)
        }
      }),
      { numRuns: 300, seed: 11 },
    )
  })

  it('is the same at the start and after an edit', () => {
    fc.assert(
      fc.property(inputs, ([first, ...others]) => {
        const whole = new Picture(library.edit(others.length === 0 ? [first as never] : [...others, first as never]))
        const grown = new Picture(library.edit(others))
        // Both pictures must cut unbounded edges at the same length.
        if (reachOf(whole.diagram.circles) !== reachOf(grown.diagram.circles)) return
        const [x, y, r] = first as [number, number, number]
        grown.apply(grown.editor.apply([{ kind: 'insert', circle: { x, y, r } }]))
        for (const id of whole.editor.ids()) {
          const [one, other] = [whole.index.get(id), grown.index.get(id)]
          const size = reachOf(whole.diagram.circles)
          for (const side of ['minX', 'minY', 'maxX', 'maxY'] as const) {
            expect(Math.abs(one[side] - other[side])).toBeLessThan(1e-6 * size)
          }
        }
      }),
      { numRuns: 300, seed: 12 },
    )
  })
})

describe('the index of boxes', () => {
  const meets = (a: Box, b: Box) => a.minX <= b.maxX && b.minX <= a.maxX && a.minY <= b.maxY && b.minY <= a.maxY

  it('finds those that meet a box, after any changes', () => {
    const random = seededRandom(9)
    const index = new BoxIndex()
    const boxes = new Map<number, Box>()
    for (let k = 0; k < 9000; k++) {
      const number = Math.floor(4000 * random())
      if (random() < 0.2) {
        index.delete(number)
        boxes.delete(number)
      } else {
        const [x, y] = [100 * random(), 100 * random()]
        // Points, and segments along an axis, have boxes without an area.
        const [width, height] = [Math.max(3 * random() - 1, 0), Math.max(3 * random() - 1, 0)]
        const box = { minX: x, minY: y, maxX: x + width, maxY: y + height }
        index.set(number, (list, k) => {
          addAround(list, k, box.minX, box.minY, 0)
          addAround(list, k, box.maxX, box.maxY, 0)
        })
        boxes.set(number, box)
      }
      if (k % 300 !== 0) continue
      const [x, y] = [90 * random(), 90 * random()]
      const asked = { minX: x, minY: y, maxX: x + 10, maxY: y + 10 }
      const expected = [...boxes].flatMap(([number, box]) => (meets(box, asked) ? [number] : []))
      expect(index.search(asked).sort((a, b) => a - b)).toEqual(expected.sort((a, b) => a - b))
    }
  })
})
