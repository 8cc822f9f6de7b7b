// SPDX-License-Identifier: GPL-3.0-or-later
// Highlights, selections and sketches above the picture: each is visible where it is, and all are twice as large at twice the pixel ratio.
import { describe, expect, it } from 'vitest'
import type { PathSink } from '../../web/lib/index.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { drawOverlay, isOverlayEmpty, NOT_HIGHLIGHTED } from '../../web/view/overlay.ts'
import { commandsOf } from '../../web/view/painter/commands.ts'
import type { Drawing } from '../../web/view/painter/drawing.ts'
import { NAMED_STYLE } from './named-style.ts'
import { RecordingSink } from './recording-sink.ts'

type Above = Parameters<typeof drawOverlay>[4]

const FRAME = { x: 0, y: 0, scale: 10, width: 400, height: 300 }
const NO_NAMES = { list: [], circles: new CircleTable(new Float64Array()), domain: {} }
const EMPTY: Above = {
  ...NOT_HIGHLIGHTED,
  overlays: [],
  found: undefined,
  layers: DEFAULT_LAYERS,
  names: NO_NAMES,
  covered: NO_PADDING,
}

/** Keeps every operation with its lengths, in pixels. */
class RecordedDrawing implements Drawing {
  readonly operations: {
    readonly kind: string
    readonly color: string
    readonly lengths: readonly number[]
    /** The width and the dashes of a stroke. */
    readonly line: readonly number[]
    readonly box: readonly number[]
  }[] = []

  path(): PathSink {
    return new RecordingSink(4)
  }

  cover(color: string): void {
    this.#add('cover', color, [])
  }

  fill(path: PathSink, color: string, opacity = 1): void {
    this.#add(`fill ${opacity}`, color, [], path)
  }

  stroke(path: PathSink, color: string, width: number, dash: readonly number[] = [], opacity = 1): void {
    this.#add(`stroke ${opacity}`, color, [width, ...dash], path)
  }

  clip(): void {
    throw new Error('The overlay has no clip.')
  }

  write(text: string, x: number, y: number, size: number, color: string, rim: string): void {
    this.#add(`write ${text} on ${rim}`, color, [x, y, size])
  }

  #add(kind: string, color: string, line: readonly number[], path?: PathSink): void {
    const points = path === undefined ? [] : lengthsOf(path)
    this.operations.push({ kind, color, line, lengths: [...line, ...points], box: boxOf(points) })
  }

  /** The colors with which anything is drawn, except paper. */
  get colors(): Set<string> {
    const visible = this.operations.filter(({ kind, lengths }) => lengths.length > 2 && !kind.endsWith(' 0'))
    return new Set(visible.map(({ color }) => color).filter((color) => color !== 'paper'))
  }
}

function lengthsOf(path: PathSink): number[] {
  return (path as RecordingSink).points.flatMap(({ x, y }) => [x, y])
}

/** The left, upper, right and lower ends of points, in tenths of pixels. */
function boxOf(points: readonly number[]): number[] {
  if (points.length === 0) return []
  const [x, y] = [0, 1].map((axis) => points.filter((_, k) => k % 2 === axis)) as [number[], number[]]
  return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)].map((end) => Math.round(10 * end) / 10)
}

function drawn(content: Partial<Above>, pixelRatio = 1): RecordedDrawing {
  const drawing = new RecordedDrawing()
  const { x, y, scale, width, height } = FRAME
  const [pixels, rows] = [width * pixelRatio, height * pixelRatio]
  const frame = { x, y, scale: scale * pixelRatio, width: pixels, height: rows }
  drawOverlay(drawing, frame, pixelRatio, NAMED_STYLE, { ...EMPTY, ...content })
  return drawing
}

const square = (half: number) =>
  commandsOf((sink) => {
    sink.moveTo(-half, -half)
    sink.lineTo(half, -half)
    sink.lineTo(half, half)
    sink.lineTo(-half, half)
    sink.closePath()
  })

const described = (hiddenBy?: number) => ({
  id: 1,
  circle: { x: 1, y: 2, r: 3 },
  color: undefined,
  hiddenBy,
  isBounded: true,
  neighbors: Int32Array.of(0),
  outline: square(4),
  neighborhood: square(8),
})
const touching = (r: number) => ({ disc: { x: -3, y: 1, r }, points: [{ x: -3 + Math.abs(r), y: 1 }] })
const found = { hull: undefined, largestDisc: undefined, path: undefined, method: undefined }
const withLayers = (layers: Partial<Above['layers']>) => ({ ...DEFAULT_LAYERS, ...layers })
const path = { from: { x: -5, y: -5 }, to: { x: 5, y: 5 } }
const AT_ORIGIN = { from: { x: 0, y: 0 }, to: { x: 0, y: 0 } }
const SMALL = [160, 110, 240, 190] as const
const LARGE = [120, 70, 280, 230] as const
/** The place of texts, which are written without a path. */
const NOWHERE = [Infinity, Infinity, -Infinity, -Infinity] as const
const trial = {
  circle: { x: 0, y: 0, r: 1 },
  outline: square(5),
  area: 100,
}

type Box = readonly [left: number, top: number, right: number, bottom: number]

/** Everything that can be drawn above a picture, alone, with its colors and where they are, in pixels. */
const THINGS: Record<string, readonly [Partial<Above>, Readonly<Record<string, Box>>]> = {
  'a selected circle': [
    { highlights: { selected: described(), hovered: undefined } },
    { selectedCell: SMALL, selectedDisc: [180, 100, 240, 160], neighborCell: LARGE },
  ],
  'a selected circle under the pointer': [
    { highlights: { selected: described(), hovered: described() } },
    { selectedCell: SMALL, selectedDisc: [180, 100, 240, 160], neighborCell: LARGE },
  ],
  'a circle under the pointer': [
    { highlights: { selected: undefined, hovered: described() } },
    { edge: [160, 100, 240, 190] },
  ],
  'a disc that touches circles': [
    { touching: touching(2), layers: withLayers({ disc: true }) },
    { touching: [150, 120, 193, 160] },
  ],
  'a new circle': [{ trial: { ...trial, hiddenBy: undefined, taken: [] } }, { accent: [150, 100, 250, 200] }],
  'one selected circle': [
    { selection: { circles: Float64Array.of(1, 1, 2), box: { minX: -1, minY: -1, maxX: 3, maxY: 3 } } },
    { accent: [233, 163, 241, 171] },
  ],
  'several selected circles, of which one is outside': [
    {
      selection: {
        circles: Float64Array.of(1, 1, 2, -4, 1, 1, 90, 0, 1),
        box: { minX: -5, minY: -1, maxX: 3, maxY: 3 },
      },
    },
    { accent: [150, 120, 241, 171], selectedDisc: [150, 120, 230, 160] },
  ],
  'a rectangle that selects': [
    { rectangle: { from: { x: 90, y: 20 }, to: { x: 10, y: 70 } } },
    { accent: [10, 20, 90, 70] },
  ],
  'a polygon that is being drawn': [{ sketch: Float64Array.of(-5, -5, 5, -5, 0, 5) }, { accent: [146, 96, 254, 204] }],
  // A disc of radius 3 around (1, 2), half a turn from its right, and the way back to there.
  'the hull': [
    {
      found: { ...found, hull: Float64Array.of(1, 2, 3, 0, Math.PI, 4, 2) },
      layers: withLayers({ hull: true }),
    },
    { hull: [180, 100, 240, 130] },
  ],
  'the largest empty disc': [
    { found: { ...found, largestDisc: { ...touching(2), circles: [1] } }, layers: withLayers({ largestDisc: true }) },
    { touching: [150, 120, 193, 160] },
  ],
  'the clearest path': [
    { found: { ...found, path: { clearance: 1, outline: square(4) } }, layers: withLayers({ path: AT_ORIGIN }) },
    { path: SMALL },
  ],
  'the ends of a path that is not found': [{ layers: withLayers({ path }) }, { path: [143, 93, 257, 207] }],
  'names of circles': [
    {
      names: {
        ...NO_NAMES,
        list: [{ id: 0, text: 'Hamburg' }],
        circles: new CircleTable(Float64Array.of(4, -3, 1)),
      },
      layers: withLayers({ labels: true }),
    },
    { edge: NOWHERE },
  ],
  'axes and a grid': [{ layers: withLayers({ grid: true }) }, { edge: [0, 0, 400, 300] }],
  'points of a client': [
    { overlays: [{ id: 'own', color: 'red', points: Float64Array.of(1, 1, 2, 2), dot: 4 }] },
    { red: [206, 126, 224, 144] },
  ],
  'numbers of a client': [
    { overlays: [{ id: 'own', color: 'red', points: Float64Array.of(1, 1), numbers: Int32Array.of(7) }] },
    { red: NOWHERE },
  ],
  'segments of a client': [
    { overlays: [{ id: 'own', color: 'red', segments: Float64Array.of(1, 1, 5, 4), dash: [3, 1], width: 2 }] },
    { red: [210, 110, 250, 140] },
  ],
  'discs of a client': [
    { overlays: [{ id: 'own', color: 'red', discs: Float64Array.of(1, 1, 2, -2, -4, -2), fill: 0.5 }] },
    { red: [160, 120, 230, 210] },
  ],
}

describe('above the picture', () => {
  it.each(Object.entries(THINGS))('%s is visible alone, in its colors, where it is', (_, [content, places]) => {
    expect(isOverlayEmpty({ ...EMPTY, ...content })).toBe(false)
    const { colors, operations } = drawn(content)
    expect(colors).toEqual(new Set(Object.keys(places)))
    for (const [color, place] of Object.entries(places)) {
      const boxes = operations
        .filter((each) => each.color === color)
        .flatMap(({ box }) => (box.length > 0 ? [box] : []))
      const ends = [0, 1, 2, 3].map((k) => (k < 2 ? Math.min : Math.max)(...boxes.map((box) => box[k] as number)))
      expect([color, ...ends]).toEqual([color, ...place])
    }
  })

  it.each(Object.entries(THINGS))('%s is twice as large at a pixel ratio of 2', (_, [above]) => {
    const [once, twice] = [drawn(above, 1).operations, drawn(above, 2).operations]
    expect(twice.map(({ kind, color }) => [kind, color])).toEqual(once.map(({ kind, color }) => [kind, color]))
    for (const [k, { lengths }] of once.entries()) {
      const larger = twice[k]?.lengths ?? []
      expect(larger).toHaveLength(lengths.length)
      for (const [i, length] of lengths.entries()) expect(larger[i]).toBeCloseTo(2 * length, 9)
    }
  })

  it.each<[string, Partial<Above>, Partial<Above>]>([
    [
      'a selected circle that is hidden',
      { highlights: { selected: described(0), hovered: undefined } },
      { highlights: { selected: described(), hovered: undefined } },
    ],
    [
      'a new circle that is hidden',
      { trial: { ...trial, hiddenBy: 0, taken: [] } },
      { trial: { ...trial, hiddenBy: undefined, taken: [] } },
    ],
    [
      'a disc of negative radius',
      { touching: touching(-2), layers: withLayers({ disc: true }) },
      { touching: touching(2), layers: withLayers({ disc: true }) },
    ],
  ])('%s has a dashed rim, and is where another one is', (_, dashed, other) => {
    const [one, two] = [drawn(dashed).operations, drawn(other).operations]
    expect(one.map(({ box }) => box)).toEqual(two.map(({ box }) => box))
    const dashes = [one, two].map((list) => list.filter(({ line }) => line.length > 1).length)
    expect(dashes[0]).toBe((dashes[1] as number) + 1)
  })

  it('a circle that is tried tells what it takes beside it, where there is room', () => {
    const written = (...taken: (readonly [x: number, y: number, area: number])[]) =>
      drawn({
        trial: { ...trial, hiddenBy: undefined, taken: taken.map(([x, y, area], id) => ({ id, x, y, area })) },
      }).operations.flatMap(({ kind, lengths }) => (kind.startsWith('write') ? [[kind, ...lengths]] : []))
    expect(written([8, 8, 60])).toEqual([['write −60 on paper', 280, 70, expect.any(Number)]])
    // No area is written in the circle, without a number, or where another one is.
    expect(written([0.9, 0, 60], [0, 1.1, 50], [9, 9, Number.NaN])).toHaveLength(1)
    expect(written([0, 5, 60], [5.9, 5, 50], [0, 3.7, 40])).toHaveLength(1)
    expect(written([0, 5, 60], [6.1, 5, 50], [0, 3.5, 40])).toHaveLength(3)
  })

  it('each number of a client is written at its point', () => {
    const overlays = [{ id: 'own', color: 'red', points: Float64Array.of(1, 1, 2, 3), numbers: Int32Array.of(7, 8) }]
    expect(drawn({ overlays }).operations.filter(({ kind }) => kind.startsWith('write'))).toMatchObject([
      { kind: 'write 7 on paper', lengths: [210, 140, expect.any(Number)] },
      { kind: 'write 8 on paper', lengths: [220, 120, expect.any(Number)] },
    ])
  })

  it('nothing is drawn where nothing stands out', () => {
    expect(isOverlayEmpty(EMPTY)).toBe(true)
    expect(drawn({}).operations).toEqual([])
  })

  it('layers that are off are not drawn, though they are known', () => {
    const off = withLayers({ hull: false, largestDisc: false, disc: false, path: undefined })
    const known = {
      hull: Float64Array.of(0, 0, 1, 0, 6, 0, 1),
      largestDisc: { ...touching(2), circles: [1] },
      path: { clearance: 1, outline: square(3) },
      method: undefined,
    }
    expect(drawn({ found: known, touching: touching(2), layers: off }).colors).toEqual(new Set())
  })
})
