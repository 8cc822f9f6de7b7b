import { describe, expect, it, vi } from 'vitest'
import { Editing } from '../../web/editing/editing.ts'
import { requestOf } from '../../web/editing/open-request.ts'
import { initialState } from '../../web/editing/state.ts'
import type { Circle, Diagram, Edit } from '../../web/lib/index.ts'
import type { RegionShape } from '../../web/lib/regions.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { SceneBackend } from '../../web/picture/scene-backend.ts'
import { boxOf } from '../../web/view/domain.ts'
import { DEFAULT_LAYERS, type Layers } from '../../web/view/layers.ts'
import { answers } from '../../web/view/painter/answers.ts'
import { Clip } from '../../web/view/painter/clip.ts'
import type { Frame } from '../../web/view/painter/frame.ts'
import { PaintedScene } from '../../web/view/painter/painted-scene.ts'
import { Picture } from '../../web/view/painter/picture.ts'
import { addBorder, addInside, addOutside, partShown } from '../../web/view/painter/region-path.ts'
import { SvgDrawing } from '../../web/view/painter/svg-drawing.ts'
import { tabulated } from '../../web/view/painter/tabulate.ts'
import { isRegionText, readRegion } from '../../web/view/region-text.ts'
import { createStore } from '../../web/view/store.ts'
import { library, seededRandom } from './library.ts'
import { NAMED_STYLE } from './named-style.ts'
import { RecordingSink, windingOf } from './recording-sink.ts'
import { box, ring } from './shapes.ts'

const regions = await loadRegions()

const SQUARE: RegionShape = [box(0, 0, 8, 8)]
const RINGS: RegionShape = [...SQUARE, ring(3, 3, 5, 3, 5, 6, 3, 5)]
const BOW: RegionShape = [ring(0, 0, 4, 4, 4, 0, 0, 4)]
const BOX: RegionShape = [box(1, 1, 7, 7)]
/** A star with deep bays. */
const STAR: RegionShape = [
  Array.from({ length: 40 }, (_, k) => {
    const [angle, radius] = [(Math.PI * k) / 20, k % 2 === 0 ? 9 : 3]
    return [4 + radius * Math.cos(angle), 4 + radius * Math.sin(angle)]
  }),
]

function circlesOf(count: number, seed = 3): Float64Array<ArrayBuffer> {
  const random = seededRandom(seed)
  return Float64Array.from({ length: 3 * count }, (_, k) => (k % 3 === 2 ? 0.2 * random() : 8 * random()))
}

const CIRCLES = circlesOf(20)

describe('a region as text', () => {
  const polygon = {
    type: 'MultiPolygon',
    coordinates: [[ring(0, 0, 9, 0, 9, 9, 0, 0), ring(4, 1, 5, 1, 5, 2)]],
  }
  const feature = (geometry: unknown) => ({ type: 'Feature', properties: { name: 'hall' }, geometry })

  it.each([
    ['POLYGON ((0 0, 9 0, 9 9, 0 0), (4 1, 5 1, 5 2))'],
    ['srid=4326;MultiPolygon Z (((0 0 7, 9 0 7, 9 9 7, 0 0 7), (4 1 7,5 1 7,5 2 7)))'],
    [JSON.stringify({ type: 'Polygon', coordinates: polygon.coordinates[0] })],
    [
      JSON.stringify({
        type: 'FeatureCollection',
        features: [feature(polygon), feature({ type: 'Point', coordinates: [1, 2] })],
      }),
    ],
  ])('is read: %s', (text) => {
    expect(isRegionText(text)).toBe(true)
    expect(readRegion(text)).toEqual(polygon)
  })

  it('can be opened without areas, and areas without a region', () => {
    const circles = Float64Array.of(1, 1, 1)
    expect(requestOf({ circles, region: RINGS }).domain).toEqual({ region: RINGS, areas: undefined })
    expect(requestOf({ circles, areas: 'equal' }).domain).toEqual({ region: undefined, areas: 'equal' })
    expect(requestOf({ circles }).domain).toBeUndefined()
  })

  it('may be rings that belong to no polygon yet', () => {
    expect(readRegion(JSON.stringify(RINGS))).toEqual(RINGS)
  })

  it.each([
    'POLYGON (0 0, 9 0',
    '[[[0, 0]',
    '{"type": "Point", "coordinates": [1, 2]}',
    'POLYGON ((0 zero, 9 0, 9 9))',
  ])('is refused: %s', (text) => {
    expect(() => readRegion(text)).toThrow(expect.objectContaining({ code: expect.stringMatching(/^bad/) }))
  })

  it('is told from the address of a file', () => {
    expect(isRegionText('country.geojson')).toBe(false)
    expect(isRegionText('./polygons/POLYGON.wkt')).toBe(false)
  })
})

describe('a region on the screen', () => {
  const region = regions.region(STAR)
  /** The winding number of a path around a point of the frame. */
  const turns = (add: (sink: RecordingSink) => void, x: number, y: number) => {
    const sink = new RecordingSink(1)
    add(sink)
    return sink.strokes.reduce((count, ring) => count + windingOf(ring, { x, y }), 0)
  }

  it.each([
    ['whole', { x: 4, y: 4, scale: 20, width: 400, height: 400 }],
    ['a part', { x: 7, y: 6, scale: 60, width: 300, height: 200 }],
    ['magnified', { x: 6.9, y: 4.4, scale: 1e9, width: 300, height: 200 }],
  ] as [string, Frame][])(
    'is inside and outside as the region itself, and never far from the frame: %s',
    (_, frame) => {
      const random = seededRandom(7)
      for (let k = 0; k < 200; k++) {
        const [x, y] = [frame.width * random(), frame.height * random()]
        const isInside = region.contains(
          frame.x + (x - frame.width / 2) / frame.scale,
          frame.y - (y - frame.height / 2) / frame.scale,
        )
        expect(turns((sink) => addInside(sink, frame, region), x, y) !== 0).toBe(isInside)
        expect(turns((sink) => addOutside(sink, frame, region), x, y) === 0).toBe(isInside)
      }
      for (const add of [addInside, addOutside, addBorder]) {
        const sink = new RecordingSink(1)
        add(sink, frame, region)
        for (const { x, y } of sink.points) {
          expect(Math.abs(x - frame.width / 2)).toBeLessThanOrEqual(frame.width / 2 + 17)
          expect(Math.abs(y - frame.height / 2)).toBeLessThanOrEqual(frame.height / 2 + 17)
        }
      }
    },
  )

  const drawn = (frame: Frame, layers: Partial<Layers> = {}) => {
    const scene = new PaintedScene(library)
    scene.open(CIRCLES, { region: RINGS }, regions)
    scene.setLayers({ ...DEFAULT_LAYERS, dual: true, ...layers })
    const drawing = new SvgDrawing()
    scene.draw(drawing, frame, 1, NAMED_STYLE)
    return String(drawing)
  }

  it.each([
    ['whole, with a hole', 4, 4, 20, 'border'],
    ['a corner', 7, 7, 60, 'border'],
    ['beside the hole', 1.5, 1.5, 200, 'inside'],
    ['in the hole', 4, 4, 400, 'outside'],
    ['far away', 40, 40, 20, 'outside'],
  ] as const)('clips only where its border is seen: %s', (_, x, y, scale, part) => {
    const frame = { x, y, scale, width: 200, height: 200 }
    expect(partShown(frame, regions.region(RINGS))).toBe(part)
    const text = drawn(frame)
    expect(text.includes('clip-path')).toBe(part === 'border')
    expect(text.includes('stroke="edge"')).toBe(part !== 'outside')
    // The veil covers the outside.
    expect(text.includes('fill="paper" fill-opacity="0.6"')).toBe(part !== 'inside')
  })

  it('has no line around cells in full color without edges, whose seams are covered', () => {
    const frame = { x: 4, y: 4, scale: 20, width: 200, height: 200 }
    const layers = { fullColor: true, circles: false, dual: false }
    const [lined, mosaic] = [drawn(frame, layers), drawn(frame, { ...layers, edges: false, vertices: false })]
    for (const text of [lined, mosaic]) expect(text).not.toMatch(/fill="map" fill-opacity/)
    expect(lined).toContain('stroke="region"')
    expect(new Set([...mosaic.matchAll(/stroke="(\w+)"/g)].map(([, color]) => color))).toEqual(new Set(['map']))
  })

  it('cuts cells and edges in an SVG, and not circles', () => {
    const text = drawn({ x: 4, y: 4, scale: 20, width: 200, height: 200 })
    const groups = [...text.matchAll(/<g clip-path="url\(#([\w-]+)\)">\n(.*?)\n<\/g>/gs)]
    expect(groups).not.toHaveLength(0)
    const names = new Set(groups.map(([, name]) => name))
    expect([...text.matchAll(/<clipPath id="([\w-]+)">/g)].map(([, name]) => name)).toEqual([...names])
    const outside = text.replace(/<g .*?<\/g>/gs, '')
    expect(outside).toContain('stroke="dual"')
    expect(outside).not.toContain('stroke="edge"')
  })

  it('has a box around it and the circles, and alone where areas are given', () => {
    const circles = { minX: -3, minY: 1, maxX: 5, maxY: 12 }
    expect(boxOf(circles, { region: SQUARE, areas: undefined })).toEqual({ minX: -3, minY: 0, maxX: 8, maxY: 12 })
    expect(boxOf(circles, { region: SQUARE, areas: 'equal' })).toEqual({ minX: 0, minY: 0, maxX: 8, maxY: 8 })
    expect(boxOf(circles, { region: undefined, areas: undefined })).toBe(circles)
    // Periods have a margin of a tenth of the longer side all around, and the circles do not count.
    for (const [lattice, box] of [
      [
        { a: [10, 0], b: [0, 40] },
        { minX: -4, minY: -4, maxX: 14, maxY: 44 },
      ],
      [
        { a: [40, 0], b: [-10, 10] },
        { minX: -15, minY: -5, maxX: 45, maxY: 15 },
      ],
    ] as const)
      expect(boxOf(circles, { region: undefined, areas: undefined, lattice })).toEqual(box)
  })
})

describe('areas inside a region', () => {
  const region = regions.region(RINGS)
  const close = (diagram: Diagram, value: (i: number) => number) => {
    diagram.cellAreas({ region }).forEach((area, i) => {
      expect(value(i)).toBeCloseTo(area, 9)
    })
  }

  it('are those of the whole diagram, one by one and all at once, after edits, too', () => {
    const picture = new Picture(library.edit(circlesOf(60)), new Clip(library, region))
    const random = seededRandom(5)
    for (let k = 0; k < 15; k++) {
      close(picture.diagram, (i) => picture.areaOf(i))
      close(picture.diagram, (i) => picture.areas().valueOf(i))
      const [id = 0] = picture.editor.ids()
      const circle = { x: 8 * random(), y: 8 * random(), r: random() }
      const edits: Edit[] = [
        { kind: 'remove', id },
        { kind: 'insert', circle },
        { kind: 'replace', id, circle },
      ]
      picture.apply(picture.editor.apply([edits[k % 3] as Edit]))
    }
  })

  it('are told of a cell, and others once the region is another one or none', () => {
    const scene = new PaintedScene(library)
    scene.open(CIRCLES, { region: RINGS }, regions)
    const areaOf = (id: number) => answers.tell(scene, [id]).cells.get(id)?.area
    const { diagram } = new Picture(library.edit(CIRCLES))
    expect(areaOf(4)).toBeCloseTo(diagram.cellArea(4, { region }), 9)
    expect(tabulated(scene.picture, ['area'], Int32Array.of(4)).columns[0]?.[0]).toBeCloseTo(areaOf(4) as number, 9)
    scene.edit([], { region: SQUARE }, regions)
    expect(areaOf(4)).toBeCloseTo(diagram.cellArea(4, { region: regions.region(SQUARE) }), 9)
    scene.edit([], { region: null }, regions)
    expect(areaOf(4)).toBe(diagram.cellArea(4))
  })

  it('are those of the trial of a circle: what it takes is what it gets', () => {
    const scene = new PaintedScene(library)
    scene.open(CIRCLES, { region: RINGS }, regions)
    const trial = answers.try(scene, { x: 2, y: 2, r: 0.4 })
    const taken = trial?.taken.reduce((sum, { area }) => sum + area, 0)
    expect(taken).toBeCloseTo(trial?.area as number, 9)
    expect(taken).toBeGreaterThan(0)
  })

  it('are none of a region that crosses itself, and all stays as it was', () => {
    const scene = new PaintedScene(library)
    scene.open(CIRCLES, { region: RINGS }, regions)
    const before = answers.tell(scene, [4]).cells.get(4)?.area
    expect(() => scene.edit([], { region: BOW }, regions)).toThrow(expect.objectContaining({ code: 'badOption' }))
    expect(() => scene.open(CIRCLES.slice(3), { region: BOW }, regions)).toThrow(
      expect.objectContaining({ code: 'badOption' }),
    )
    expect(answers.tell(scene, [4]).cells.get(4)?.area).toBe(before)
    expect(scene.counts().circles).toBe(20)
  })
})

/** Editing with a painted scene as its backend. */
async function started(circles = CIRCLES, domain = {}) {
  const backend = new SceneBackend(library)
  const problems: string[] = []
  const errors: (number | undefined)[] = []
  const editing = new Editing(
    createStore(initialState()),
    backend,
    (outcome) => errors.push(outcome.edited.fitted?.error),
    ({ message }) => problems.push(message),
  )
  await editing.open({ circles, dataSet: '', isEdited: false, domain: { region: RINGS, areas: undefined, ...domain } })
  /** The areas by circle id. */
  const areas = () => {
    const ids = editing.circles.ids()
    const { cells } = answers.tell(backend.scene, [...ids])
    return Array.from(ids, (id) => cells.get(id)?.area ?? Number.NaN)
  }
  return { backend, editing, problems, errors, areas, circles: () => [...editing.circles.circles()] }
}

const TOTAL = regions.region(RINGS).area

describe('areas that are given', () => {
  const expectShares = (areas: readonly number[], shares: readonly number[]) => {
    const sum = shares.reduce((all, share) => all + share, 0)
    areas.forEach((area, k) => {
      expect(area / TOTAL).toBeCloseTo((shares[k] as number) / sum, 6)
    })
    expect(areas).toHaveLength(shares.length)
  }
  const equal = (count: number) => Array<number>(count).fill(1)

  it('are reached when circles are opened, moved, added and removed, and nothing else moves', async () => {
    const { editing, areas, errors, circles } = await started(CIRCLES, { areas: 'equal' })
    expectShares(areas(), equal(20))
    const centers = circles().filter((_, k) => k % 3 !== 2)
    expect(centers).toEqual([...CIRCLES].filter((_, k) => k % 3 !== 2))
    await editing.edit([{ kind: 'replace', id: 3, circle: { x: 6.5, y: 6.5, r: 0 } }])
    expectShares(areas(), equal(20))
    expect(editing.circles.get(3)).toMatchObject({ x: 6.5, y: 6.5 })
    await editing.edit([{ kind: 'insert', circle: { x: 1, y: 1, r: 3 } }])
    expectShares(areas(), equal(21))
    await editing.edit([{ kind: 'remove', id: 0 }])
    expectShares(areas(), equal(20))
    for (const error of errors) expect(error).toBeLessThanOrEqual(1e-6)
  })

  it('are undone with what they were given for: one step each', async () => {
    const { editing, areas, circles } = await started()
    const before = circles()
    await editing.edit([], undefined, { areas: 'equal' })
    const fitted = circles()
    expectShares(areas(), equal(20))
    await editing.edit([{ kind: 'replace', id: 3, circle: { x: 6.5, y: 6.5, r: 0 } }])
    await editing.undo()
    expect(circles()).toEqual(fitted)
    await editing.undo()
    expect(circles()).toEqual(before)
    expect(editing.domain.areas).toBeUndefined()
    await editing.redo()
    expect(circles()).toEqual(fitted)
    expect(editing.domain.areas).toBe('equal')
  })

  it('belong to circles, also to one that comes back by undo; one that is added gets the mean', async () => {
    const shares = Array.from({ length: 20 }, (_, k) => 1 + k)
    const { editing, areas } = await started(CIRCLES, { areas: shares })
    expectShares(areas(), shares)
    await editing.edit([{ kind: 'remove', id: 19 }])
    expect(editing.areas).toEqual(shares.slice(0, 19))
    await editing.edit([{ kind: 'insert', circle: { x: 1, y: 1, r: 0 } }])
    expect(editing.areas).toEqual([...shares.slice(0, 19), 10])
    expectShares(areas(), editing.areas as number[])
    await editing.undo()
    await editing.undo()
    expect(editing.areas).toEqual(shares)
    expectShares(areas(), shares)
  })

  it('are in the order of the circles as they are, and come back with other circles', async () => {
    const { editing, areas } = await started(circlesOf(5), { areas: [1, 2, 3, 4, 5] })
    await editing.edit([{ kind: 'remove', id: 1 }])
    await editing.edit([], undefined, { areas: [9, 3, 4, 5] })
    expectShares(areas(), [9, 3, 4, 5])
    await editing.open({ circles: circlesOf(3, 8), dataSet: '', isEdited: false })
    expect(editing.domain.region).toBeUndefined()
    await editing.undo()
    expect(editing.areas).toEqual([9, 3, 4, 5])
    expectShares(areas(), [9, 3, 4, 5])
  })

  it('that cannot be are refused, and the last ones stay', async () => {
    const { editing, areas, problems } = await started(CIRCLES, { areas: 'equal' })
    const { x, y } = editing.circles.get(7) as Circle
    await editing.edit([{ kind: 'replace', id: 3, circle: { x, y, r: 0 } }])
    await editing.edit([], undefined, { areas: [1, 2] })
    await editing.edit([], undefined, { region: undefined })
    expect(problems).toHaveLength(3)
    expectShares(areas(), equal(20))
    expect(editing.domain).toMatchObject({ areas: 'equal' })
  })
})

it('another region replaces one that waits only if both belong to one gesture', async () => {
  const { backend, editing } = await started()
  const edit = vi.spyOn(backend, 'edit')
  const regions = [SQUARE, RINGS, STAR, BOX].map((region, k) => editing.edit([], k < 3 ? 5 : 6, { region }))
  await Promise.all(regions)
  expect(edit.mock.calls.map(([, change]) => change?.region)).toEqual([SQUARE, STAR, BOX])
  await editing.undo()
  expect(editing.domain.region).toEqual(STAR)
  await editing.undo()
  expect(editing.domain.region).toEqual(RINGS)
})
