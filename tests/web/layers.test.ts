// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { loadGenerators } from '../../web/app/generators/generators.ts'
import { at } from '../../web/lib/base/diagram-data.ts'
import { circleAt, type Diagram, type Edit, type Float64s, mergeVertices, type PathSink } from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import {
  checkedLayers,
  checkLayers,
  DEFAULT_LAYERS,
  isAnythingFound,
  keptLayers,
  type Layers,
  layersFrom,
} from '../../web/view/layers.ts'
import { idOf } from '../../web/view/painter/cell-boxes.ts'
import { Centers } from '../../web/view/painter/centers.ts'
import { Clip } from '../../web/view/painter/clip.ts'
import { Coloring } from '../../web/view/painter/coloring.ts'
import { replay } from '../../web/view/painter/commands.ts'
import { distributionOf } from '../../web/view/painter/distribution.ts'
import type { Drawing } from '../../web/view/painter/drawing.ts'
import { factsOf } from '../../web/view/painter/facts.ts'
import { found } from '../../web/view/painter/found.ts'
import type { Frame } from '../../web/view/painter/frame.ts'
import { cells } from '../../web/view/painter/layers/cells.ts'
import { ordinary, power } from '../../web/view/painter/layers/edges.ts'
import { mergedWith } from '../../web/view/painter/layers/vertices.ts'
import { cellArea, Measures, placeAmong } from '../../web/view/painter/measures.ts'
import { methodResult } from '../../web/view/painter/method-layers.ts'
import { methodOutcome } from '../../web/view/painter/method-outcome.ts'
import { type Layer, PaintContext } from '../../web/view/painter/paint-context.ts'
import { PaintedScene } from '../../web/view/painter/painted-scene.ts'
import { Picture } from '../../web/view/painter/picture.ts'
import { finished } from '../../web/view/painter/scheduler.ts'
import { SvgDrawing } from '../../web/view/painter/svg-drawing.ts'
import { tabulated } from '../../web/view/painter/tabulate.ts'
import { touchingAround, touchingNear } from '../../web/view/painter/touching.ts'
import { ENOUGH_COLORS, MAP_COLORS, rampThrough, SHADES, type Style } from '../../web/view/style.ts'
import { dataSet, library, seededRandom } from './library.ts'
import { NAMED_STYLE } from './named-style.ts'
import { leastDistance, signedDistance } from './oracle.ts'
import { RecordingSink } from './recording-sink.ts'
import { box } from './shapes.ts'
import { tickingClock } from './turns.ts'

const random = seededRandom(23)
const metrics = await loadMetrics({ library })

function randomCircles(count: number): Float64s {
  return Float64Array.from({ length: 3 * count }, (_, k) => (k % 3 === 2 ? 0.9 * random() ** 3 : 20 * random()))
}

/** A scene of the painting thread, with further layers. */
function sceneOf(circles: Float64s, layers: Partial<Layers> = {}): PaintedScene {
  const scene = new PaintedScene(library)
  scene.open(circles)
  scene.setLayers({ ...DEFAULT_LAYERS, ...layers })
  return scene
}

function randomEdits(ids: ArrayLike<number>): Edit[] {
  const id = ids[Math.floor(random() * ids.length)] as number
  const circle = { x: 20 * random(), y: 20 * random(), r: random() ** 4 * 4 }
  const choice = random()
  if (choice < 0.3) return [{ kind: 'insert', circle }]
  if (choice < 0.5 && ids.length > 20) return [{ kind: 'remove', id }]
  return [{ kind: 'replace', id, circle }]
}

describe('colors of which neighbors have different ones', () => {
  const expectProper = ({ diagram }: Picture, colorOf: (i: number) => number) => {
    for (let e = 0; e < diagram.edges.length; e += 4) {
      const [one, other] = [colorOf(at(diagram.edges, e)), colorOf(at(diagram.edges, e + 1))]
      expect(one).not.toBe(other)
      expect(Math.max(one, other)).toBeLessThan(ENOUGH_COLORS)
    }
  }

  it.each(['bronzefilter', 'waka', 'introduction'])('are six at most, in %s', (name) => {
    const picture = new Picture(library.edit(dataSet(name)))
    const coloring = new Coloring(picture.diagram)
    expectProper(picture, (i) => coloring.colorOf(idOf(picture.diagram, i)))
  })

  it('are one for each of eight circles, such as those of the first scene', () => {
    const coloring = new Coloring(library.compute(dataSet('start')))
    expect(new Set([0, 1, 2, 3, 4, 5, 6, 7].map((i) => coloring.colorOf(i))).size).toBe(MAP_COLORS)
  })

  it('stay with their circles in all edits, while other colors are shown, and in a box that repeats', () => {
    const scene = sceneOf(randomCircles(150), { cells: 'different' })
    const colorsOf = ({ editor, diagram, colorOf }: Picture) =>
      new Map(Array.from(editor.ids(), (id) => [id, colorOf.call(scene.picture, diagram.indexOf(id))]))
    const known = colorsOf(scene.picture)
    const expectKept = () => {
      for (const [id, color] of colorsOf(scene.picture)) {
        expect(known.get(id) ?? color, `circle ${id}`).toBe(color)
        known.set(id, color)
      }
    }
    for (let k = 0; k < 200; k++) {
      scene.edit(randomEdits(scene.picture.editor.ids()))
      expectKept()
    }
    scene.setLayers({ ...DEFAULT_LAYERS, cells: 'radius' })
    scene.edit([{ kind: 'insert', circle: { x: 5, y: 5, r: 0.01 } }])
    scene.setLayers({ ...DEFAULT_LAYERS, cells: 'different' })
    expectKept()
    scene.edit([], { lattice: { a: [24, 0], b: [0, 24] } })
    scene.edit([{ kind: 'insert', circle: { x: 15, y: 15, r: 0.01 } }])
    expectKept()
    scene.edit([], { lattice: null })
    expectKept()
  })

  it('are given to new circles so that they differ from their neighbors', () => {
    const picture = new Picture(library.edit(randomCircles(40)))
    picture.layers = { ...DEFAULT_LAYERS, cells: 'different' }
    for (let k = 0; k < 30; k++) {
      const change = picture.editor.insert({ x: 20 * random(), y: 20 * random(), r: 0 })
      picture.apply(change)
      const i = picture.diagram.indexOf(at(change.inserted, 0))
      const taken = new Set(Array.from(picture.diagram.neighbors(i), (j) => picture.colorOf(j)))
      if (taken.size < ENOUGH_COLORS) expect(taken).not.toContain(picture.colorOf(i))
    }
  })

  it('come back with circles that undo restores', () => {
    const circles = randomCircles(40)
    const scene = sceneOf(circles, { cells: 'different' })
    const table = new CircleTable(Float64Array.from(circles))
    const colorOf = (id: number) => scene.picture.colorOf(scene.picture.diagram.indexOf(id))
    for (const id of [3, 17, 29]) {
      const color = colorOf(id)
      const back = table.follow(scene.edit([{ kind: 'remove', id }]).change)
      // Something else takes the room meanwhile.
      table.follow(scene.edit([{ kind: 'insert', circle: { x: 0.1 * id, y: 0.5, r: 0.2 } }]).change)
      const { change } = scene.edit(back)
      table.follow(change)
      expect(change.inserted).toHaveLength(1)
      expect(colorOf(at(change.inserted, 0)), `circle ${id}`).toBe(color)
    }
  })
})

describe('what cells are measured by', () => {
  it('is the area of the cell', () => {
    const { diagram } = new Picture(library.edit(dataSet('bronzefilter')))
    const bounds = { minX: -1e4, minY: -1e4, maxX: 1e4, maxY: 1e4 }
    for (let i = 0; i < diagram.circles.length / 3; i++) {
      if (!diagram.cells.isBounded(i)) expect(cellArea(diagram, i)).toBe(Number.POSITIVE_INFINITY)
      else expect(cellArea(diagram, i)).toBeCloseTo(diagram.cellArea(i, { bounds }), 9)
    }
  })

  it.each(['area', 'gap', 'radius', 'index'] as const)(
    'has a quarter of the cells in each quarter of the ramp: %s',
    (measure) => {
      const { diagram } = new Picture(library.edit(randomCircles(1200)))
      const measures = new Measures(measure, diagram)
      const counts = new Int32Array(4)
      const isMeasured = (i: number) => diagram.cells.exists(i) && Number.isFinite(measures.valueOf(i))
      const visible = Array.from({ length: 1200 }, (_, i) => i).filter(isMeasured)
      for (const i of visible) (counts[Math.min(Math.floor((4 * measures.shadeOf(i)) / SHADES), 3)] as number)++
      for (const count of counts) expect(Math.abs(count - visible.length / 4)).toBeLessThan(30)
      // The legend gives the values at the ends and quarters of the ramp.
      const { knots, isClipped } = measures.legend
      const values = visible.map((i) => measures.valueOf(i)).sort((a, b) => a - b)
      // Outliers have the colors of the ends.
      const at = (share: number) => values[Math.round(share * (values.length - 1))]
      expect(knots).toEqual([0.05, 0.25, 0.5, 0.75, 0.95].map(at))
      expect(isClipped).toBe(true)
      expect([
        measures.shadeOf(visible.find((i) => measures.valueOf(i) === values[0]) as number),
        measures.shadeOf(visible.find((i) => measures.valueOf(i) === values.at(-1)) as number),
      ]).toEqual([0, SHADES - 1])
      // Unbounded cells have no color.
      const endless = Array.from({ length: 1200 }, (_, i) => i).filter(
        (i) => diagram.cells.exists(i) && measures.valueOf(i) === Number.POSITIVE_INFINITY,
      )
      expect(endless.length > 0).toBe(measure === 'area')
      expect(endless.every((i) => measures.shadeOf(i) === -1)).toBe(true)
      const least = visible.find((i) => measures.valueOf(i) === knots[0]) as number
      const largest = visible.find((i) => measures.valueOf(i) === knots[4]) as number
      expect([measures.shadeOf(least), measures.shadeOf(largest)]).toEqual([0, SHADES - 1])
    },
  )

  it('is placed among the knots of the ramp', () => {
    const knots = [1, 2, 2, 4, 8]
    expect([0, 1, 1.5, 2, 3, 4, 6, 8, 9, Infinity].map((value) => placeAmong(knots, value))).toEqual([
      0, 0, 0.125, 0.375, 0.625, 0.75, 0.875, 1, 1, 1,
    ])
    expect(placeAmong([3, 3, 3, 3, 3], 3)).toBe(0.5)
  })

  it('has a ramp through the colors that are set, evenly', () => {
    const ramp = rampThrough(['rgb(0, 0, 0)', 'rgb(200, 100, 0)', 'rgb(200, 100, 60)'])
    expect(ramp).toHaveLength(SHADES)
    expect([ramp[0], ramp[15], ramp[30], ramp[45], ramp[60]]).toEqual([
      'rgb(0, 0, 0)',
      'rgb(100, 50, 0)',
      'rgb(200, 100, 0)',
      'rgb(200, 100, 30)',
      'rgb(200, 100, 60)',
    ])
    // Other color formats fall back to the given colors.
    expect(new Set(rampThrough(['oklch(0.5 0.1 20)', 'rgb(1, 2, 3)']))).toEqual(
      new Set(['oklch(0.5 0.1 20)', 'rgb(1, 2, 3)']),
    )
  })

  it('is the distance to the nearest circle of all', () => {
    const circles = randomCircles(200)
    const { diagram } = new Picture(library.edit(circles))
    const measures = new Measures('gap', diagram)
    for (let i = 0; i < 200; i++) {
      if (!diagram.cells.exists(i)) continue
      let least = Number.POSITIVE_INFINITY
      for (let j = 0; j < 200; j++) {
        if (j === i || !diagram.cells.exists(j)) continue
        const center = circleAt(circles, i)
        least = Math.min(least, signedDistance(circles, j, center) - center.r)
      }
      expect(measures.valueOf(i)).toBeCloseTo(least, 9)
    }
  })

  it('is the share of a bounded cell that the circle fills', async () => {
    const picture = new Picture(
      library.edit(Float64Array.of(0, 0, 1, 2, 0, 1, -2, 0, 1, 0, 2, 0.5, 0, -2, 1, 0.2, 0, 0.1)),
    )
    picture.layers = { ...DEFAULT_LAYERS, cells: 'filled' }
    const { diagram } = picture
    const measures = new Measures('filled', diagram)
    expect(measures.valueOf(0)).toBeCloseTo(Math.PI / diagram.cellArea(0, { bounds: [-9, -9, 9, 9] }), 9)
    expect(measures.valueOf(1)).toBeNaN()
    expect(picture.colorOf(1)).toBe(-1)
    // In a region every cell has an area.
    const square = (await loadRegions()).region([box(-9, -9, 9, 9)])
    picture.clip = new Clip(library, square)
    expect(picture.colorOf(1)).not.toBe(-1)
    expect(picture.legend?.measure).toBe('filled')
  })

  it('is that of the cell that a distance and a region limit, everywhere', async () => {
    const circles = randomCircles(60)
    const picture = new Picture(library.edit(circles))
    const region = (await loadRegions()).region([box(-20, -20, 40, 60)])
    const everywhere = () => {
      picture.layers = { ...DEFAULT_LAYERS, cells: 'area', maxDistance: 1.5 }
      const ids = Int32Array.from({ length: 60 }, (_, i) => i)
      const options = { maxDistance: 1.5, ...(picture.clip && { region }) }
      const areas = picture.diagram.cellAreas(options)
      const there = [...ids].filter((i) => picture.diagram.cells.exists(i))
      const { cells } = factsOf(picture, { circles: 60, hidden: 0, vertices: 0, edges: 0 }, there)
      const [column] = tabulated(picture, ['area'], ids).columns
      for (const i of there) {
        for (const area of [column?.[i], cells.get(i)?.area]) expect(area).toBeCloseTo(areas[i] as number, 9)
        expect(cells.get(i)?.perimeter).toBeCloseTo(picture.diagram.cellPerimeter(i, options), 9)
        expect(picture.colorOf(i)).not.toBe(-1)
      }
      expect(picture.legend?.knots.at(-1)).toBeLessThanOrEqual(Math.max(...areas))
      const steps = distributionOf(picture)
      let step = steps.next()
      while (step.done !== true) step = steps.next()
      expect(step.value.areas.reduce((sum, count) => sum + count)).toBe(there.length)
    }
    everywhere()
    picture.clip = new Clip(library, region)
    everywhere()
    picture.layers = { ...DEFAULT_LAYERS, cells: 'area' }
    expect(picture.areas().valueOf(0)).toBeCloseTo(picture.diagram.cellArea(0, { region }), 9)
  })

  it('changes nowhere but in the boxes that are painted anew', () => {
    for (const cells of ['area', 'filled', 'degree', 'gap', 'different'] as const) {
      const picture = new Picture(library.edit(randomCircles(120)))
      picture.layers = { ...DEFAULT_LAYERS, cells }
      const colors = () => {
        const { diagram } = picture
        const visible = [...picture.editor.ids()].filter((id) => diagram.cells.exists(diagram.indexOf(id)))
        return new Map(visible.map((id) => [id, picture.colorOf(diagram.indexOf(id))]))
      }
      for (let k = 0; k < 60; k++) {
        const before = colors()
        const { boxes, isEverywhere } = picture.apply(picture.editor.apply(randomEdits(picture.editor.ids())))
        if (isEverywhere) continue
        for (const [id, color] of colors()) {
          if (before.get(id) === color) continue
          const cell = picture.index.get(id)
          const isInside = boxes.some(
            (box) => box.minX <= cell.minX && box.minY <= cell.minY && box.maxX >= cell.maxX && box.maxY >= cell.maxY,
          )
          expect(isInside, `${cells}, edit ${k}, circle ${id}`).toBe(true)
        }
      }
    }
  })

  it('is counted by neighbors and by areas of bounded cells, beside the certificate', () => {
    const picture = new Picture(library.edit(dataSet('bronzefilter')))
    const steps = distributionOf(picture)
    let step = steps.next()
    while (step.done !== true) step = steps.next()
    const { degrees, areas, certificate } = step.value
    const bounded = Array.from({ length: 678 }, (_, i) => i).filter((i) => picture.diagram.cells.isBounded(i))
    expect(degrees.reduce((sum, count) => sum + count)).toBe(678)
    // Hidden circles have no cell.
    const hiding = distributionOf(new Picture(library.edit(Float64Array.of(0, 0, 4, 1, 0, 1, 9, 0, 1))))
    let last = hiding.next()
    while (last.done !== true) last = hiding.next()
    expect([...last.value.degrees]).toEqual([0, 2])
    expect(areas.reduce((sum, count) => sum + count)).toBe(bounded.length)
    expect(certificate.certified).toBe(true)
  })

  it('is known anew after each edit', () => {
    const picture = new Picture(library.edit(randomCircles(60)))
    for (let k = 0; k < 40; k++) {
      const { diagram } = picture
      for (let i = 0; i < diagram.circles.length / 3; i++) {
        if (!diagram.cells.exists(i)) continue
        expect(picture.gaps().valueOf(i)).toBeCloseTo(new Measures('gap', diagram).valueOf(i), 9)
        expect(picture.areas().valueOf(i)).toBeCloseTo(new Measures('area', diagram).valueOf(i), 9)
      }
      picture.apply(picture.editor.apply(randomEdits(picture.editor.ids())))
    }
  })
})

it('each cell is filled once, however many have the same color', () => {
  const picture = new Picture(library.edit(randomCircles(600)))
  picture.layers = { ...DEFAULT_LAYERS, cells: 'different' }
  const drawing = new SvgDrawing()
  const style = { ramp: [], map: [...'abcdefgh'], cellOpacity: 0.5 } as Partial<Style> as Style
  cells.draw(new PaintContext(drawing, { x: 10, y: 10, scale: 40, width: 800, height: 800 }, 1, picture, style))
  const { diagram } = picture
  const visible = picture.circlesIn({ minX: 0, minY: 0, maxX: 20, maxY: 20 }).filter((i) => diagram.cells.exists(i))
  expect(visible.length).toBeGreaterThan(6 * 64)
  expect(String(drawing).match(/M/g)).toHaveLength(visible.length)
})

describe('merged vertices', () => {
  it.each([0, 1e-9, 0.5])('are those of the library, up to length %d', (nearZero) => {
    const grid = Array.from({ length: 49 }, (_, k): [number, number, number] => [
      k % 7,
      Math.floor(k / 7),
      k < 20 ? 0.2 : 0.1,
    ])
    const { diagram } = new Picture(library.edit(grid))
    const expected = mergeVertices(diagram, nearZero).vertices.length / 3
    const shown = Array.from({ length: diagram.vertices.length / 3 }, (_, v) => mergedWith(diagram, v, nearZero))
    expect(shown.filter((others) => others >= 0).length).toBe(expected)
    expect(shown.reduce((sum, others) => sum + (others < 0 ? 0 : others + 1), 0)).toBe(shown.length)
  })
})

describe('the diagram of the centers', () => {
  it('follows the edits of the circles', () => {
    const picture = new Picture(library.edit(randomCircles(60)))
    for (let k = 0; k < 10; k++) picture.apply(picture.editor.apply(randomEdits(picture.editor.ids())))
    // The layer is requested after circles were inserted and removed.
    const centers = new Centers(library, picture.diagram)
    picture.centers = centers
    for (let k = 0; k < 150; k++) picture.apply(picture.editor.apply(randomEdits(picture.editor.ids())))
    const { circles } = picture.editor.snapshot()
    const expected = library.compute(circles.map((value, k) => (k % 3 === 2 ? 0 : value)))
    const { diagram } = centers.picture
    expect(diagram.edges.length).toBe(expected.edges.length)
    const keys = (list: Float64Array) =>
      Array.from({ length: list.length / 3 }, (_, k) => `${list.slice(3 * k, 3 * k + 3)}`)
    expect(keys(diagram.circles).sort()).toEqual(keys(expected.circles).sort())
    expect(keys(diagram.vertices).sort()).toEqual(keys(expected.vertices).sort())
  })
})

describe('the power diagram', () => {
  /** The duration of one clock step in milliseconds, and whether the power diagram exists after an edit. */
  it.each([
    [0.1, true],
    [1000, false],
  ])('follows each edit where it is there quickly, and else comes at rest: %s ms', (step, follows) => {
    const endClock = tickingClock(step)
    const scene = sceneOf(randomCircles(40), { power: true })
    scene.edit([{ kind: 'remove', id: 0 }])
    expect(scene.isPowerMissing).toBe(true)
    scene.addPower(metrics)
    const circle = { x: 3, y: 4, r: 5 }
    scene.edit([{ kind: 'insert', circle }])
    expect(scene.isPowerMissing).toBe(!follows)
    endClock()
  })
})

/** The dashes of a layer in a frame, each as its two ends in the plane. */
function dashesIn(picture: Picture, layer: Layer, frame: Frame): number[][] {
  const drawing = new SvgDrawing()
  const style = { ordinary: 'gray', power: 'teal' } as Style
  layer.draw(new PaintContext(drawing, frame, 1, picture, style))
  const numbers = [...String(drawing).matchAll(/M([-\d.]+),([-\d.]+)L([-\d.]+),([-\d.]+)/g)]
  return numbers.map(([, ...ends]) =>
    ends.map(Number).map((value, k) => {
      const { x, y, scale, width, height } = frame
      return k % 2 === 0 ? x + (value - width / 2) / scale : y + (height / 2 - value) / scale
    }),
  )
}

describe('dashed edges', () => {
  const all: Frame = { x: 10, y: 10, scale: 40, width: 800, height: 800 }
  /** A frame contains the start, the end or both of a dash. Complete dashes must be equal, in either direction. */
  function missing(dashes: number[][], others: number[][], { x, y, scale, width, height }: Frame): number[][] {
    const isInside = ([px, py]: [number, number]) =>
      Math.abs(px - x) < width / 2 / scale && Math.abs(py - y) < height / 2 / scale
    const endsOf = (list: number[][]) =>
      list.flatMap(([a, b, c, d]) => [
        [a, b],
        [c, d],
      ]) as [number, number][]
    const known = endsOf(others)
    return endsOf(dashes)
      .filter(isInside)
      .filter(([px, py]) => !known.some(([qx, qy]) => Math.abs(px - qx) + Math.abs(py - qy) < 2e-3))
  }

  it('are where they are in whichever part of the picture is painted', () => {
    const picture = new Picture(library.edit(randomCircles(60)))
    picture.centers = new Centers(library, picture.diagram)
    picture.setPower(metrics.compute(picture.diagram.circles, { metric: 'power' }))
    const part: Frame = { x: 9, y: 12, scale: 40, width: 160, height: 120 }
    for (const layer of [ordinary, power]) {
      const [whole, few] = [dashesIn(picture, layer, all), dashesIn(picture, layer, part)]
      expect(few.length).toBeGreaterThan(20)
      expect(missing(few, whole, part)).toEqual([])
      expect(missing(whole, few, part)).toEqual([])
    }
  })

  it('stay outside of the boxes that an edit has painted anew', () => {
    const picture = new Picture(library.edit(randomCircles(60)))
    picture.centers = new Centers(library, picture.diagram)
    for (let k = 0; k < 20; k++) {
      const before = dashesIn(picture, ordinary, all)
      const edits: Edit[] = [{ kind: 'insert', circle: { x: 20 * random(), y: 20 * random(), r: 0.1 } }]
      const { boxes } = picture.apply(picture.editor.apply(edits))
      const isElsewhere = ([x, y]: number[]) =>
        boxes.every(
          ({ minX, minY, maxX, maxY }) =>
            (x as number) < minX - 0.1 ||
            (x as number) > maxX + 0.1 ||
            (y as number) < minY - 0.1 ||
            (y as number) > maxY + 0.1,
        )
      const after = dashesIn(picture, ordinary, all)
      expect(after.length).toBeGreaterThan(100)
      expect(missing(before, after, all).filter(isElsewhere)).toEqual([])
      expect(missing(after, before, all).filter(isElsewhere)).toEqual([])
    }
  })
})

describe('the disc at a point', () => {
  it('touches circles where it says, and meets none', () => {
    const picture = new Picture(library.edit(randomCircles(80)))
    const { diagram } = picture
    let discs = 0
    for (let k = 0; k < 300; k++) {
      const [x, y] = [20 * random(), 20 * random()]
      const slack = 0.5
      const near = picture.circlesIn({ minX: x - slack, minY: y - slack, maxX: x + slack, maxY: y + slack })
      const touching = touchingNear(diagram, near, x, y, slack)
      if (touching === undefined) continue
      discs += 1
      const { disc, points } = touching
      expect(Math.hypot(disc.x - x, disc.y - y)).toBeLessThanOrEqual(slack)
      expect(points.length).toBeGreaterThanOrEqual(2)
      for (const point of points) {
        expect(Math.hypot(point.x - disc.x, point.y - disc.y)).toBeCloseTo(Math.abs(disc.r), 7)
      }
      expect(leastDistance(diagram.circles, disc)).toBeGreaterThan(disc.r - 1e-7)
    }
    expect(discs).toBeGreaterThan(100)
  })

  it('touches the nearest circle wherever it is, and there is none inside a circle', () => {
    const { diagram } = new Picture(library.edit(Float64Array.of(0, 0, 2, 10, 0, 1)))
    expect(touchingAround(diagram, 0, 3, 4)).toEqual({ disc: { x: 3, y: 4, r: 3 }, points: [{ x: 1.2, y: 1.6 }] })
    expect(touchingAround(diagram, 0, 1, 1)).toBeUndefined()
  })
})

describe('what depends on all circles', () => {
  it('has a path from one point to the other that comes no nearer to a circle than it says', () => {
    for (let round = 0; round < 100; round++) {
      const picture = new Picture(library.edit(randomCircles(30)))
      const point = () => ({ x: 30 * random() - 5, y: 30 * random() - 5 })
      const [from, to] = [point(), point()]
      picture.layers = { ...DEFAULT_LAYERS, path: { from, to } }
      const { path } = finished(found(picture, 1e-4))
      const { clearance, outline } = path as NonNullable<typeof path>
      expect([...outline.slice(0, 3)]).toEqual([0, from.x, from.y])
      expect([...outline.slice(-3)]).toEqual([1, to.x, to.y])
      const { circles } = picture.diagram
      const sink = new RecordingSink()
      replay(outline, sink)
      const least = Math.min(...sink.points.map((point) => leastDistance(circles, point)))
      expect(least, `round ${round}`).toBeGreaterThan(clearance - 1e-3)
    }
  })

  it('is nothing where nothing is asked for, and of no circles', () => {
    const picture = new Picture(library.edit([]))
    expect(finished(found(picture, 1))).toEqual({ hull: undefined, largestDisc: undefined, path: undefined })
    const ask = { hull: true, largestDisc: true, path: { from: { x: 0, y: 0 }, to: { x: 1, y: 1 } } }
    picture.layers = { ...DEFAULT_LAYERS, ...ask }
    expect(finished(found(picture, 1))).toEqual({ hull: new Float64Array(), largestDisc: undefined, path: undefined })
  })
})

describe('what the touching disc method makes on its way', () => {
  it('lies where it says: samples on circles, discs that touch two and meet none, directed edges around the hull', () => {
    const circles = randomCircles(60)
    const diagram = library.compute(circles)
    const { hull, hidden } = diagram
    const [samples, graph, antipodal, directed] = methodResult(library, diagram, DEFAULT_LAYERS).data
    const gapsAt = (x: number, y: number) => Array.from({ length: 60 }, (_, i) => signedDistance(circles, i, { x, y }))
    const points = samples?.points as Float64Array
    // Hidden circles are removed first.
    const visible = Array.from({ length: 60 }, (_, i) => i).filter((i) => diagram.cells.exists(i))
    const smallest = Math.min(...visible.map((i) => at(circles, 3 * i + 2)))
    expect(points.length).toBeGreaterThan(2 * (60 - hidden.length / 2))
    for (let k = 0; k < points.length; k += 2) {
      const gaps = gapsAt(at(points, k), at(points, k + 1)).map((gap) => Math.abs(gap + smallest))
      expect(Math.min(...gaps)).toBeLessThan(1e-6)
    }
    const discs = antipodal?.discs as Float64Array
    expect(discs.length).toBeGreaterThan(0)
    for (let k = 0; k < discs.length; k += 3) {
      const gaps = gapsAt(at(discs, k), at(discs, k + 1)).sort((a, b) => a - b)
      expect(gaps[0]).toBeCloseTo(at(discs, k + 2), 6)
      expect(gaps[1]).toBeCloseTo(at(discs, k + 2), 6)
    }
    expect(graph?.segments?.length).toBeGreaterThan(points.length)
    const segments = directed?.segments as Float64Array
    const centerOf = (circle: number) => [...circles.subarray(3 * circle, 3 * circle + 2)].join()
    const ends = Array.from({ length: segments.length / 2 }, (_, k) => segments.subarray(2 * k, 2 * k + 2).join())
    expect(ends.toSorted()).toEqual(
      Array.from(hull)
        .flatMap((circle) => [centerOf(circle), centerOf(circle)])
        .toSorted(),
    )
  })
})

describe('what the touching disc method finds', () => {
  const generators = loadGenerators()
  const figure = async (figure: string) => library.compute((await generators).make({ kind: 'figure', figure }))

  it('is all of it where its own diagram is certified, ties too', async () => {
    for (const name of ['6', '9b', '10', '11', '13b', '15b', '15e']) {
      const diagram = await figure(name)
      const { found, missed } = methodResult(library, diagram, { ...DEFAULT_LAYERS, sampleCount: 3 })
      expect(found.vertices, name).toMatchObject({ found: found.vertices.all, wrong: 0 })
      expect(found.edges, name).toMatchObject({ found: found.edges.all, wrong: 0 })
      expect(missed.size, name).toBe(0)
    }
    const grid = methodResult(library, await figure('15d'), DEFAULT_LAYERS)
    // A hundred circles on a grid have 81 vertices of four circles, and no edge of length zero counts as missed.
    expect(grid.found.vertices.all).toBe(81)
    expect(grid.found.edges.all).toBe(180)
  })

  it('lacks the edges that it misses: too few samples for the neighbors that are far apart among the centers', async () => {
    const diagram = await figure('5d')
    const { found, missed } = methodResult(library, diagram, {
      ...DEFAULT_LAYERS,
      candidates: 'uniform',
      sampleCount: 3,
    })
    expect(missed.size).toBeGreaterThan(0)
    expect(found.edges.all - found.edges.found).toBe(missed.size)
    expect(found.edges.all).toBe(diagram.edges.length / 4)
    expect(found.vertices.all).toBe(diagram.vertices.length / 3)
  })

  it('is computed anew with other candidates or samples, and kept with the same ones while it is shown', () => {
    const scene = sceneOf(randomCircles(30))
    const now = (layers: Partial<Layers>) => {
      scene.setLayers({ ...DEFAULT_LAYERS, ...layers })
      const isMissing = scene.isMethodMissing
      if (isMissing) scene.addMethod()
      return [isMissing, scene.picture.method?.found.samples]
    }
    const [, usual] = now({ samples: true })
    expect(now({ samples: true })).toEqual([false, usual])
    expect(now({ samples: true, sampleCount: 1 })).toEqual([true, usual])
    const [isMissing, more] = now({ directedEdges: true, sampleCount: 5 })
    expect([isMissing, (more as number) > (usual as number)]).toEqual([true, true])
    expect(now({ missedEdges: true, sampleCount: 5 })).toEqual([false, more])
    const visible = 30 - scene.counts().hidden
    expect(now({ samples: true, candidates: 'uniform', sampleCount: 5 })).toEqual([true, 5 * visible])
    expect(now({ samples: true, candidates: 'uniform' })).toEqual([true, 50 * visible])
    expect(now({})).toEqual([false, undefined])
  })

  it('is told apart from what is wrong, by circles and ends', () => {
    const circles = randomCircles(80)
    const right = library.compute(circles)
    const moved = circles.slice()
    // The other side is far from the former cell.
    const circle = right.find(5, 5)
    moved.set([25, 25], 3 * circle)
    const other = library.compute(moved)
    const { vertices, edges, missed } = methodOutcome(right, other)
    // A vertex is known by its circles, in their turn.
    const cornersOf = ({ vertexCircles }: Diagram) =>
      Array.from({ length: vertexCircles.length / 3 }, (_, v) => {
        const around = [...vertexCircles.subarray(3 * v, 3 * v + 3)]
        const start = around.indexOf(Math.min(...around))
        return [...around.slice(start), ...around.slice(0, start)].join()
      })
    const [known, seen] = [new Set(cornersOf(right)), new Set(cornersOf(other))]
    expect(vertices).toEqual({
      all: known.size,
      found: [...known].filter((corner) => seen.has(corner)).length,
      wrong: [...seen].filter((corner) => !known.has(corner)).length,
    })
    expect(edges.all - edges.found).toBe(missed.length)
    expect(edges.wrong).toBe(other.edges.length / 4 - edges.found)
    // All edges of the removed cell are missed, and none far from it.
    for (const side of right.cells.sides(circle)) expect(missed).toContain(side >> 1)
    expect(edges.found).toBeGreaterThan(0.7 * edges.all)
    expect(methodOutcome(right, right)).toEqual({
      vertices: { all: vertices.all, found: vertices.all, wrong: 0 },
      edges: { all: edges.all, found: edges.all, wrong: 0 },
      missed: [],
    })
  })
})

/** Whether layers that are set are refused as bad input. */
function isRefused(change: object): boolean {
  try {
    checkLayers({ ...DEFAULT_LAYERS, ...change } as Layers)
    return false
  } catch (error) {
    expect(error).toMatchObject({ name: 'CircleVoronoiError', code: 'badInput' })
    return true
  }
}

describe('layers that are set', () => {
  const path = { from: { x: 0, y: 0 }, to: { x: 1, y: 1 } }

  it('are refused, if there is nothing that could be drawn of one', () => {
    for (const data of [undefined, null, 5, {}, 'data', [5], [null], [{ points: 5 }], [{ discs: null }]])
      expect(isRefused({ data })).toBe(true)
    for (const wrong of [
      { path: { from: { x: 0, y: 0 } } },
      { cells: 'red' },
      { candidates: 'red' },
      { maxDistance: 'far' },
      { nearZero: -1 },
      { hull: 'yes' },
      { dsic: true },
    ])
      expect([wrong, isRefused(wrong)]).toEqual([wrong, true])
  })

  it('are as by default where nothing is said of them', () => {
    expect(checkedLayers({ hull: true, nearZero: null, cells: undefined })).toEqual({ ...DEFAULT_LAYERS, hull: true })
    expect(() => checkedLayers([])).toThrow(expect.objectContaining({ code: 'badInput' }))
  })

  it('are taken, if they can be drawn', () => {
    const data = [{ id: 'own', color: 'red', points: Float64Array.of(1, 2), discs: [1, 2, 3], segments: undefined }]
    expect(isRefused({})).toBe(false)
    expect(isRefused({ data, path, nearZero: 0, maxDistance: -1, candidates: 'uniform', sampleCount: 5 })).toBe(false)
  })
})

it.each([
  ['dynamic', 0, 20],
  ['uniform', 1, 100],
  ['all-pairs', 0, 0],
] as const)('candidates %s have %d to %d samples, in links and in layers that are set', (candidates, least, most) => {
  for (const sampleCount of [least, most, least - 1, most + 1, least + 0.5, '1']) {
    const isRight = sampleCount === least || sampleCount === most
    const layers = { ...DEFAULT_LAYERS, candidates, sampleCount } as Layers
    expect(layersFrom(layers)).toMatchObject({ candidates, sampleCount: isRight ? sampleCount : undefined })
    expect(isRefused({ candidates, sampleCount })).toBe(!isRight)
  }
})

it('a neighbor with whom a cell shares two edges is counted once, by facts, tables, colors and descriptions', () => {
  // The small circle is between the large ones.
  const scene = sceneOf(Float64Array.of(0, 0, 4, 10, 0, 4, 5, 0, 0.5))
  const { picture } = scene
  expect([...picture.diagram.neighbors(0)].sort()).toEqual([1, 1, 2])
  const told = factsOf(picture, scene.counts(), [0, 2]).cells
  expect([told.get(0)?.edges, told.get(0)?.neighbors.toSorted()]).toEqual([3, [1, 2]])
  expect([told.get(2)?.edges, told.get(2)?.neighbors.toSorted()]).toEqual([2, [0, 1]])
  expect([...(tabulated(picture, ['degree'], Int32Array.of(0, 1, 2)).columns[0] as Float64Array)]).toEqual([2, 2, 2])
  expect([0, 1, 2].map((i) => new Measures('degree', picture.diagram).valueOf(i))).toEqual([2, 2, 2])
  expect([...(scene.mark(0, undefined).selected?.neighbors ?? [])].sort()).toEqual([1, 2])
})

describe('layers that are kept', () => {
  it('are what differs, and come back', () => {
    expect(keptLayers(DEFAULT_LAYERS)).toEqual({})
    const layers = {
      ...DEFAULT_LAYERS,
      circles: false,
      cells: 'gap',
      nearZero: 0.25,
      maxDistance: -1,
      path: { from: { x: 1, y: 2 }, to: { x: 3, y: 4 } },
      candidates: 'uniform',
      sampleCount: 1,
    } as const
    expect(layersFrom(JSON.parse(JSON.stringify(keptLayers(layers))))).toEqual(layers)
  })

  it('are as by default where they make no sense', () => {
    fc.assert(
      fc.property(fc.jsonValue(), fc.constantFrom(...Object.keys(DEFAULT_LAYERS)), (value, name) => {
        for (const kept of [value, { [name]: value }]) {
          const layers = layersFrom(kept)
          expect(Object.keys(layers)).toEqual(Object.keys(DEFAULT_LAYERS))
          expect(layers.data).toEqual([])
          expect(layersFrom(keptLayers(layers))).toEqual(layers)
        }
      }),
    )
    const wrong = { circles: 1, cells: 'red', nearZero: -1, maxDistance: 'x', path: { from: { x: 1 } }, other: true }
    expect(layersFrom(wrong)).toEqual(DEFAULT_LAYERS)
  })
})

it('lines from hidden circles end on the rim of what hides them, and do not meet', () => {
  const scene = sceneOf(Float64Array.of(0, 0, 5, 1, 0, 1, 0, 2, 1, 30, 0, 1))
  const only = { circles: false, cells: 'none', edges: false, vertices: false, hidden: true } as const
  scene.setLayers({ ...DEFAULT_LAYERS, ...only })
  const lines = () => {
    const drawing = new SvgDrawing()
    scene.draw(drawing, { x: 0, y: 0, scale: 10, width: 800, height: 600 }, 1, NAMED_STYLE)
    const path = /stroke="hidden"[^>]* d="([^"]*)"/.exec(String(drawing))?.[1] ?? ''
    return path.match(/[\d.]+/g)?.map(Number)
  }
  expect(lines()).toEqual([410, 300, 450, 300, 400, 280, 400, 250])
  scene.edit([{ kind: 'remove', id: 1 }])
  expect(lines()).toEqual([400, 280, 400, 250])
})

it('marks are none of circles that were opened since, and results are found anew for another scale', () => {
  const scene = sceneOf(Float64Array.of(0, 0, 1, 9, 0, 1))
  expect([scene.mark(0, 1).selected?.id, scene.marks().hovered?.id, scene.isAnythingMarked]).toEqual([0, 1, true])
  scene.open(Float64Array.of(0, 0, 1, 9, 0, 1))
  expect([scene.marks(), scene.isAnythingMarked]).toEqual([{ selected: undefined, hovered: undefined }, false])
  scene.setLayers({ ...DEFAULT_LAYERS, hull: true })
  const box = { left: 0, top: 0, width: 256, height: 256 }
  const look = (id: number, scale: number) => {
    const grid = { id, x: 0, y: 0, scale, pixelRatio: 1 }
    scene.look({
      paintId: id,
      grid,
      seen: box,
      wanted: box,
      style: { map: ['red'], ramp: ['red'] } as Partial<Style> as Style,
    })
    const isMissing = scene.isAnythingToFind
    scene.find()
    return isMissing
  }
  expect([look(1, 10), look(2, 10), look(3, 20), look(4, 20)]).toEqual([true, false, true, false])
  // Radii are weights where areas are given.
  scene.open(Float64Array.of(0, 0, 1, 9, 0, 1), { areSites: true })
  expect(scene.mark(0, undefined).selected?.circle).toEqual({ x: 0, y: 0, r: 0 })
  // Cells around a circle are outlined up to a number of them.
  for (const [count, isOutlined] of [
    [500, true],
    [501, false],
  ] as const) {
    const around = Array.from({ length: count }, (_, k) => (2 * Math.PI * k) / count)
    scene.open(Float64Array.of(0, 0, 10, ...around.flatMap((angle) => [20 * Math.cos(angle), 20 * Math.sin(angle), 0])))
    const { selected } = scene.mark(0, undefined)
    expect([selected?.neighbors.length, (selected?.neighborhood.length ?? 0) > 0]).toEqual([count, isOutlined])
    // The neighbors are listed in their order around the cell, from the least id on.
    const steps = new Set(selected?.neighbors.map((id, k, ring) => ((ring[k + 1] ?? 1) - id + count) % count))
    expect([selected?.neighbors[0], steps.size]).toEqual([1, 1])
  }
})

it('colors are told once after each change', () => {
  const picture = new Picture(library.edit(Float64Array.of(0, 0, 1, 9, 0, 1, 0, 9, 1)))
  picture.layers = { ...DEFAULT_LAYERS, cells: 'different' }
  const first = picture.newColors()
  expect([first?.length, picture.newColors()]).toEqual([3, undefined])
  picture.recolor('21')
  expect([picture.newColors(), picture.newColors()]).toEqual([`21${first?.[2]}`, undefined])
  picture.apply(picture.editor.apply([{ kind: 'replace', id: 1, circle: { x: 9, y: 1, r: 1 } }]))
  expect(picture.newColors()).toBeUndefined()
  picture.apply(picture.editor.apply([{ kind: 'remove', id: 0 }]))
  expect([picture.newColors(), picture.newColors()]).toEqual([`1${first?.[2]}`, undefined])
})

it('stars and areas are those of the circles and the region that are there', async () => {
  const regions = await loadRegions()
  const picture = new Picture(library.edit(Float64Array.of(0, 0, 1, 9, 0, 1, 0, 9, 1, 9, 9, 1)))
  picture.layers = { ...DEFAULT_LAYERS, dual: true }
  const all = { minX: -99, minY: -99, maxX: 99, maxY: 99 }
  expect(picture.starsIn(all)).toEqual([0, 1, 2, 3])
  picture.apply(picture.editor.apply([{ kind: 'remove', id: 1 }]))
  expect(picture.starsIn(all)).toEqual([0, 1, 2])
  expect(picture.areas().valueOf(0)).toBe(Infinity)
  const square = (side: number) => new Clip(library, regions.region([box(0, 0, side, side)]))
  for (const [clip, total] of [
    [square(9), 81],
    [square(3), 9],
    [undefined, Infinity],
  ] as const) {
    picture.clip = clip
    const areas = [0, 1, 2].map((i) => picture.areas().valueOf(i))
    expect(areas.reduce((sum, area) => sum + area)).toBeCloseTo(total, 6)
  }
})

it('data of clients are where they say, in pixels of the screen, and those elsewhere are left out', () => {
  const scene = sceneOf(Float64Array.of(0, 0, 1, 10, 0, 1))
  const data = [
    {
      id: 'own',
      color: 'own',
      points: Float64Array.of(5, 2, 500, 500),
      segments: Float64Array.of(1, 1, 4, 3, 500, 500, 501, 501),
      discs: Float64Array.of(2, -3, 2, 500, 500, 1, 7, -3, -1),
    },
  ]
  scene.setLayers({ ...DEFAULT_LAYERS, data })
  const drawn: unknown[] = []
  const box = (path: PathSink) => {
    const { points } = path as RecordingSink
    const ends = (list: number[]) => [Math.min(...list), Math.max(...list)].map((end) => Math.round(10 * end) / 10)
    return points.length === 0 ? [] : [...ends(points.map(({ x }) => x)), ...ends(points.map(({ y }) => y))]
  }
  const drawing: Drawing = {
    path: () => new RecordingSink(4),
    cover() {},
    clip() {},
    write() {},
    fill: (path, color) => color === 'own' && drawn.push(['fill', box(path)]),
    stroke: (path, color, width, dash) => color === 'own' && drawn.push(['stroke', width, dash, box(path)]),
  }
  for (const pixelRatio of [1, 2]) {
    drawn.length = 0
    const frame = { x: 5, y: 0, scale: 10 * pixelRatio, width: 200 * pixelRatio, height: 100 * pixelRatio }
    scene.draw(drawing, frame, pixelRatio, NAMED_STYLE)
    const [[, width, , lines], [, dots]] = drawn as [unknown[], unknown[]]
    expect(drawn).toHaveLength(2)
    expect(lines).toEqual([50, 130, 20, 100].map((end) => end * pixelRatio))
    const [left = 0, right = 0, top = 0, bottom = 0] = dots as number[]
    expect([(left + right) / 2, (top + bottom) / 2]).toEqual([100 * pixelRatio, 30 * pixelRatio])
    expect([right - left, width]).toEqual([expect.closeTo(5 * pixelRatio, 3), expect.closeTo(1.25 * pixelRatio, 3)])
  }
})

it('of the layers, those that depend on all circles are the hull, the largest disc, the path and the method', () => {
  const path = { from: { x: 0, y: 0 }, to: { x: 1, y: 1 } }
  for (const layers of [{ hull: true }, { largestDisc: true }, { path }, { samples: true }, { missedEdges: true }]) {
    expect(isAnythingFound({ ...DEFAULT_LAYERS, ...layers })).toBe(true)
  }
  expect(isAnythingFound({ ...DEFAULT_LAYERS, vertices: true, dual: true, disc: true })).toBe(false)
})

it.each([
  { vertices: true },
  { vertices: true, nearZero: 1 },
  { hidden: true, dual: true },
  { delaunay: true, ordinary: true, power: true },
  { missedEdges: true, samples: true, sampleGraph: true, directedEdges: true },
  { data: [{ id: 'own', color: 'teal', points: Float64Array.of(1, 1), segments: Float64Array.of(0, 0, 1, 3) }] },
])('lines, dashes and dots have twice as many pixels on a screen of twice the resolution: %o', (layers) => {
  const scene = sceneOf(Float64Array.of(0, 0, 5, 1, 0, 1, 0, 2, 1, 12, 0, 1, 3, 11, 2, -9, 4, 1.5, 2, -10, 0.5))
  scene.setLayers({ ...DEFAULT_LAYERS, ...layers } as Layers)
  if (scene.isPowerMissing) scene.addPower(metrics)
  if (scene.isMethodMissing) scene.addMethod()
  const lengthsAt = (pixelRatio: number) => {
    const drawing = new SvgDrawing()
    const [scale, width, height] = [30, 800, 700].map((pixels) => pixels * pixelRatio) as [number, number, number]
    scene.draw(drawing, { x: 0, y: 0, scale, width, height }, pixelRatio, NAMED_STYLE)
    const lengths = String(drawing).matchAll(/stroke-width="(.+?)"|stroke-dasharray="(\S+) \S+"|A([\d.]+)/g)
    return [...lengths].map(([, width, dash, radius]) => Number(width ?? dash ?? radius))
  }
  const [one, two] = [lengthsAt(1), lengthsAt(2)]
  expect(one.length).toBeGreaterThan(8)
  expect(two.map((length) => length / 2)).toEqual(one.map((length) => expect.closeTo(length, 1)))
})
