// SPDX-License-Identifier: GPL-3.0-or-later
// Repeating circles in the painting thread.
import { describe, expect, it } from 'vitest'
import type { Lattice } from '../../web/lib/index.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { DEFAULT_LAYERS, repeatingLayers } from '../../web/view/layers.ts'
import { answers } from '../../web/view/painter/answers.ts'
import { PaintedScene } from '../../web/view/painter/painted-scene.ts'
import { SvgDrawing } from '../../web/view/painter/svg-drawing.ts'
import { tabulated } from '../../web/view/painter/tabulate.ts'
import { library, seededRandom } from './library.ts'
import { NAMED_STYLE } from './named-style.ts'

const LATTICE: Lattice = { a: [8, 0], b: [2, 6] }

function circles(count: number, seed: number): Float64Array {
  const random = seededRandom(seed)
  return Float64Array.from(
    Array.from({ length: count }, () => {
      const [u, v] = [random(), random()]
      return [8 * u + 2 * v, 6 * v, 0.3 * random()]
    }).flat(),
  )
}

function sceneOf(coordinates: Float64Array, lattice = LATTICE): PaintedScene {
  const scene = new PaintedScene(library)
  scene.open(coordinates, { lattice })
  scene.setLayers(DEFAULT_LAYERS)
  return scene
}

const replace = (id: number, x: number, y: number, r: number) => ({ kind: 'replace' as const, id, circle: { x, y, r } })

describe('circles that repeat', () => {
  it('are counted without images', () => {
    expect(sceneOf(circles(20, 1)).counts()).toEqual({ circles: 20, hidden: 0, vertices: 40, edges: 60 })
  })

  it('come in on the other side of the box', () => {
    const scene = sceneOf(circles(5, 2))
    const { change } = scene.edit([replace(2, 8.5, 1, 0.2)])
    expect([...change.circles]).toEqual([0.5, 1, 0.2])
    const { change: up } = scene.edit([replace(2, 3, 6.5, 0.2)])
    expect([...up.circles]).toEqual([1, 0.5, 0.2])
    // Circles that are opened outside of the box are moved into it, and the view is informed.
    const opened = scene.open(Float64Array.of(-1, 1, 0.5, 3, 3, 0.1))
    expect([...(opened.circles as Float64Array)]).toEqual([7, 1, 0.5, 3, 3, 0.1])
  })

  it('are refused for the coordinate that is too large', () => {
    for (const [x, y] of [
      [1e308, 1],
      [1, 1e308],
    ] as const) {
      const scene = sceneOf(circles(5, 2), { a: [8, 0], b: [0, 6] })
      expect(() => scene.edit([replace(2, x, y, 0.2)])).toThrow(expect.objectContaining({ code: 'coordinateTooLarge' }))
    }
  })

  it('have whole cells after each edit, whose areas fill the box', () => {
    const random = seededRandom(4)
    const scene = sceneOf(circles(12, 3))
    for (let step = 0; step < 20; step++) {
      scene.edit([replace(Math.floor(12 * random()), 20 * random() - 10, 20 * random() - 10, random())])
      const { columns } = tabulated(
        scene.picture,
        ['area'],
        Int32Array.from({ length: 12 }, (_, i) => i),
      )
      const areas = (columns[0] as Float64Array).map((area) => (Number.isNaN(area) ? 0 : area))
      expect(areas.reduce((sum, area) => sum + area, 0)).toBeCloseTo(48, 9)
    }
    scene.edit([
      { kind: 'remove', id: 3 },
      { kind: 'insert', circle: { x: 1, y: 1, r: 0.1 } },
    ])
    expect(scene.counts().circles).toBe(12)
    expect(scene.nearest(1, 1)).toBe(12)
  })

  it('are found by any image, and name their neighbors by their own ids', () => {
    const coordinates = circles(9, 5).map((value, k) => (k % 3 === 2 ? 0.05 : value))
    const scene = sceneOf(coordinates)
    const table = new CircleTable(coordinates)
    for (let i = 0; i < 9; i++) {
      const [x, y] = [coordinates[3 * i] as number, coordinates[3 * i + 1] as number]
      for (const [k, l] of [
        [0, 0],
        [1, 0],
        [-2, 1],
        [0, -3],
      ] as const) {
        const place = { x: x + 0.05 + 8 * k + 2 * l, y: y + 6 * l }
        expect(table.hitAt(place, 0.01, 0, { lattice: LATTICE })).toEqual({
          id: i,
          part: k === 0 && l === 0 ? 'rim' : 'disc',
        })
        expect(scene.nearest(x + 8 * k + 2 * l, y + 6 * l)).toBe(i)
      }
    }
    const { selected } = scene.mark(0, undefined)
    const neighbors = [...(selected?.neighbors ?? [])]
    expect(neighbors.length).toBeGreaterThan(2)
    expect(new Set(neighbors).size).toBe(neighbors.length)
    expect(Math.max(...neighbors)).toBeLessThan(9)
    expect(selected?.isBounded).toBe(true)
    const { cells } = answers.tell(scene, [0])
    expect([...(cells.get(0)?.neighbors ?? [])].sort()).toEqual(neighbors.sort())
  })

  it('touch discs one period away as they do in the box', () => {
    const scene = sceneOf(circles(9, 5))
    const touched = (x: number, y: number) => answers.touch(scene, x, y, 1e-9)
    for (const [x, y] of [
      [4, 3],
      [5, 1],
    ] as const) {
      const [here, there] = [touched(x, y), touched(x + 10, y + 6)]
      expect(there?.points).toHaveLength(here?.points.length ?? 0)
      for (const disc of [here?.disc, there?.disc]) expect(disc?.r).toBeCloseTo(here?.disc.r ?? 0, 9)
      expect(there?.disc.x).toBeCloseTo((here?.disc.x ?? 0) + 10, 9)
      expect(there?.disc.y).toBeCloseTo((here?.disc.y ?? 0) + 6, 9)
      for (const point of there?.points ?? []) {
        const { x: cx, y: cy, r } = there?.disc ?? { x: 0, y: 0, r: 0 }
        expect(Math.hypot(point.x - cx, point.y - cy)).toBeCloseTo(Math.abs(r), 9)
      }
    }
  })

  it('are drawn with their images, the border of the box, and a veil around it', () => {
    const drawn = (x: number, y: number, scale = 40) => {
      const drawing = new SvgDrawing()
      sceneOf(circles(6, 6)).draw(drawing, { x, y, scale, width: 320, height: 320 }, 1, NAMED_STYLE)
      return String(drawing)
    }
    // A corner of the box is visible.
    expect(drawn(8, 0)).toContain('stroke="region"')
    expect(drawn(8, 0)).toMatch(/fill="paper"[^>]*opacity="0\.6"/)
    // The inside of the box shows neither border nor veil.
    expect(drawn(5, 3, 400)).not.toContain('stroke="region"')
    // One period away, everything except the veil is the same.
    const cellsOf = (text: string) => text.split('\n').filter((line) => line.includes('"edge"'))
    const [here, there] = [cellsOf(drawn(8, 0)), cellsOf(drawn(0, 0))]
    expect(here.length).toBeGreaterThan(0)
    expect(there).toHaveLength(here.length)
    expect(sceneOf(circles(6, 6)).picture.copiesIn({ minX: 200, minY: 0, maxX: 210, maxY: 10 })).toEqual([])
  })

  it.each(['radius', 'degree', 'gap', 'area', 'filled', 'index', 'column'] as const)(
    'have the colors of their new cells after an edit: by %s',
    (cells) => {
      const column = { name: 'town', values: Float64Array.from({ length: 15 }, (_, i) => (i * 7) % 15) }
      const layers = { ...DEFAULT_LAYERS, dual: true, ...(cells === 'column' ? { column } : { cells }) }
      const colorsOf = ({ picture }: PaintedScene) => Array.from({ length: 15 }, (_, i) => picture.colorOf(i))
      const scene = sceneOf(circles(15, 7))
      scene.setLayers(layers)
      const box = { minX: 3, minY: 1, maxX: 6, maxY: 4 }
      const hiddenIn = ({ picture }: PaintedScene) => [0, 3, 7].map((i) => picture.hiddenBy(i))
      const shownIn = (scene: PaintedScene) => [colorsOf(scene), hiddenIn(scene), scene.picture.starsIn(box)]
      const before = shownIn(scene)
      const { change } = scene.edit([replace(3, 4.5, 2, 1.5), replace(7, 5, 3, 0.1)])
      expect(change.replaced).toHaveLength(2)
      const again = sceneOf(scene.picture.diagram.circles.slice(0, 45))
      again.setLayers(layers)
      const after = shownIn(scene)
      expect(after).toEqual(shownIn(again))
      for (const [k, part] of after.entries()) if (k > 0 || cells !== 'column') expect(part).not.toEqual(before[k])
      expect(scene.picture.legend?.measure).toBe(cells)
    },
  )

  it('draw each border once', () => {
    const drawnOf = (coordinates: Float64Array) => {
      const { picture } = sceneOf(coordinates)
      const sides = Array.from({ length: coordinates.length / 3 }, (_, i) => [...picture.diagram.cells.sides(i)])
      return sides.flat().filter((side) => picture.draws(side)).length
    }
    expect(drawnOf(circles(15, 7))).toBe(45)
    // All neighbors of a circle alone are its images.
    expect(drawnOf(circles(1, 7))).toBe(3)
  })

  it('show no layers of the whole plane', () => {
    const scene = sceneOf(circles(6, 8))
    scene.setLayers({
      ...DEFAULT_LAYERS,
      hull: true,
      ordinary: true,
      delaunay: true,
      power: true,
      missedEdges: true,
      samples: true,
    })
    expect(scene.picture.layers).toEqual(repeatingLayers(DEFAULT_LAYERS))
    expect(scene.picture.centers).toBeUndefined()
    // These layers come back with circles that do not repeat.
    scene.edit([], { lattice: null })
    expect(scene.picture.layers.hull).toBe(true)
    expect(scene.counts().circles).toBe(6)
    scene.edit([], { lattice: { a: [9, 0], b: [0, 9] } })
    expect(scene.counts().edges).toBe(18)
  })
})
