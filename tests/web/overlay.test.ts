// SPDX-License-Identifier: GPL-3.0-or-later
// Highlights, selections and sketches above the picture: each is visible where it is, and all are twice as large at twice the pixel ratio.
import { describe, expect, it } from 'vitest'
import type { PathSink } from '../../web/lib/index.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { drawOverlay, isNothingAbove, NOTHING_STANDS_OUT } from '../../web/view/overlay.ts'
import { commandsOf } from '../../web/view/painter/commands.ts'
import type { Drawing } from '../../web/view/painter/drawing.ts'
import type { Style } from '../../web/view/style.ts'
import { RecordingSink } from './recording-sink.ts'

type Above = Parameters<typeof drawOverlay>[4]

/** The colors of a style are the names of its properties. */
const STYLE = new Proxy({}, { get: (_, name) => name }) as Style
const FRAME = { x: 0, y: 0, scale: 10, width: 400, height: 300 }
const NO_NAMES = { list: [], circleOf: () => undefined }
const EMPTY: Above = {
  ...NOTHING_STANDS_OUT,
  above: [],
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

function drawn(above: Partial<Above>, pixelRatio = 1): RecordedDrawing {
  const drawing = new RecordedDrawing()
  const { x, y, scale, width, height } = FRAME
  const [pixels, rows] = [width * pixelRatio, height * pixelRatio]
  const frame = { x, y, scale: scale * pixelRatio, width: pixels, height: rows }
  drawOverlay(drawing, frame, pixelRatio, STYLE, { ...EMPTY, ...above })
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
const trial = {
  circle: { x: 0, y: 0, r: 1 },
  outline: square(5),
  area: 100,
  taken: [
    { id: 0, x: 8, y: 8, area: 60 },
    { id: 2, x: -8, y: 8, area: Number.POSITIVE_INFINITY },
    // There is no room for this one beside the first.
    { id: 3, x: 12, y: 9, area: 20 },
  ],
}

/** Everything that can be drawn above a picture, alone, with the colors that it has. */
const THINGS: Record<string, readonly [Partial<Above>, ...string[]]> = {
  'a selected circle': [
    { marks: { selected: described(), hovered: undefined } },
    'selectedCell',
    'selectedDisc',
    'neighborCell',
  ],
  'a selected circle that is hidden': [
    { marks: { selected: described(0), hovered: undefined } },
    'selectedCell',
    'selectedDisc',
    'neighborCell',
  ],
  'a circle under the pointer': [{ marks: { selected: undefined, hovered: described() } }, 'edge'],
  'a disc that touches circles': [{ touching: touching(2), layers: withLayers({ disc: true }) }, 'touching'],
  'a disc of negative radius': [{ touching: touching(-2), layers: withLayers({ disc: true }) }, 'touching'],
  'a new circle': [{ trial: { ...trial, hiddenBy: undefined } }, 'accent'],
  'a new circle that is hidden': [{ trial: { ...trial, hiddenBy: 0, taken: [] } }, 'accent'],
  'one selected circle': [
    { chosen: { circles: Float64Array.of(1, 1, 2), box: { minX: -1, minY: -1, maxX: 3, maxY: 3 } } },
    'accent',
  ],
  'several selected circles': [
    {
      chosen: {
        circles: Float64Array.of(1, 1, 2, -4, 1, 0),
        box: { minX: -4, minY: -1, maxX: 3, maxY: 3 },
      },
    },
    'accent',
    'selectedDisc',
  ],
  'a rectangle that selects': [{ band: { from: { x: 10, y: 20 }, to: { x: 90, y: 70 } } }, 'accent'],
  'a polygon that is being drawn': [{ sketch: Float64Array.of(-5, -5, 5, -5, 0, 5) }, 'accent'],
  'the hull': [
    {
      found: { ...found, hull: Float64Array.of(-6, 0, 2, -1.5, 3, 6, 2, 6, 0, 2, 1.5, 3, -6, -2) },
      layers: withLayers({ hull: true }),
    },
    'hull',
  ],
  'the largest empty disc': [
    { found: { ...found, largestDisc: { ...touching(2), circles: [1] } }, layers: withLayers({ largestDisc: true }) },
    'touching',
  ],
  'the clearest path': [
    { found: { ...found, path: { clearance: 1, outline: square(3) } }, layers: withLayers({ path }) },
    'path',
  ],
  'the ends of a path that is not found': [{ layers: withLayers({ path }) }, 'path'],
  'names of circles': [
    {
      names: { list: [{ id: 3, text: 'Hamburg' }], circleOf: () => ({ x: 4, y: -3, r: 1 }) },
      layers: withLayers({ labels: true }),
    },
    'edge',
  ],
  'axes and a grid': [{ layers: withLayers({ grid: true }) }, 'edge'],
  'points of a client': [{ above: [{ id: 'own', color: 'red', points: Float64Array.of(1, 1, 2, 2), dot: 4 }] }, 'red'],
  'numbers of a client': [
    { above: [{ id: 'own', color: 'red', points: Float64Array.of(1, 1), numbers: Int32Array.of(7) }] },
    'red',
  ],
  'segments of a client': [
    { above: [{ id: 'own', color: 'red', segments: Float64Array.of(1, 1, 5, 5), dash: [3, 1], width: 2 }] },
    'red',
  ],
  'discs of a client': [{ above: [{ id: 'own', color: 'red', discs: Float64Array.of(1, 1, 2), fill: 0.5 }] }, 'red'],
}

describe('above the picture', () => {
  it.each(Object.entries(THINGS))('%s is visible alone, in its colors', (_, [above, ...colors]) => {
    expect(isNothingAbove({ ...EMPTY, ...above })).toBe(false)
    expect(drawn(above).colors).toEqual(new Set(colors))
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

  /** The operations that draw: the kind, the color, the width with the dashes, and the box in whole pixels. */
  const seen = (above: Partial<Above>, pixelRatio = 1) =>
    drawn(above, pixelRatio).operations.flatMap(({ kind, color, line, box }) => {
      const [what, opacity] = kind.split(' ')
      return box.length === 0 ? [] : [[`${what} ${color}`, ...(what === 'fill' ? [Number(opacity)] : line), box]]
    })
  const haloed = (color: string, width: number, box: number[], ...dash: number[]) => [
    ['stroke paper', width + 4, box],
    [`stroke ${color}`, width, ...dash, box],
  ]
  const [SMALL, LARGE, DISC] = [
    [160, 110, 240, 190],
    [120, 70, 280, 230],
    [180, 100, 240, 160],
  ]

  it('the selected circle has its cell, its rim and those around it, and the hovered one has its own', () => {
    const [selected, hovered] = [described(), { ...described(), id: 2, neighborhood: square(9) }]
    const ofSelected = [
      ['stroke neighborCell', 1.5, LARGE],
      ...haloed('selectedCell', 2.5, SMALL),
      ...haloed('selectedDisc', 2.5, DISC),
    ]
    expect(seen({ marks: { selected, hovered: undefined } })).toEqual(ofSelected)
    expect(seen({ marks: { selected, hovered: selected } })).toEqual(ofSelected)
    expect(seen({ marks: { selected: undefined, hovered } })).toEqual([
      ...haloed('edge', 2.5, SMALL),
      ...haloed('edge', 2.5, DISC),
    ])
    expect(seen({ marks: { selected: { ...selected, hiddenBy: 0 }, hovered: undefined } }).slice(3)).toEqual(
      haloed('selectedDisc', 2.5, DISC, 4, 4),
    )
  })

  it('discs have their contacts and their middle, and paths their ends', () => {
    const ofDisc = (...dash: number[]) => [
      ['fill touching', 0.18, [150, 120, 190, 160]],
      ['stroke touching', 1.75, ...dash, [150, 120, 190, 160]],
      ['fill touching', 1, [168, 138, 172, 142]],
      ['fill touching', 1, [187, 137, 193, 143]],
    ]
    expect(seen({ touching: touching(2), layers: withLayers({ disc: true }) })).toEqual(ofDisc())
    expect(seen({ touching: touching(-2), layers: withLayers({ disc: true }) })).toEqual(ofDisc(4, 3))
    const largestDisc = { ...touching(2), circles: [0] }
    expect(seen({ found: { ...found, largestDisc }, layers: withLayers({ largestDisc: true }) })).toEqual(ofDisc())
    const ends = [
      ['fill paper', 1, [143, 193, 157, 207]],
      ['stroke path', 2.5, [143, 193, 157, 207]],
      ['fill paper', 1, [243, 93, 257, 107]],
      ['stroke path', 2.5, [243, 93, 257, 107]],
    ]
    expect(seen({ layers: withLayers({ path }) })).toEqual(ends)
    const way = { from: path.from, to: path.to, outline: square(4) } as never
    expect(seen({ found: { ...found, path: way }, layers: withLayers({ path }) })).toEqual([
      ['stroke path', 2.5, SMALL],
      ...ends,
    ])
    // A disc of radius 3 around (1, 2), half a turn from its right, and the way back to there.
    const hull = Float64Array.of(1, 2, 3, 0, Math.PI, 4, 2)
    expect(seen({ found: { ...found, hull }, layers: withLayers({ hull: true }) })).toEqual([
      ['stroke hull', 1.75, [180, 100, 240, 130]],
    ])
  })

  it('layers of clients have their lines, discs and dots', () => {
    const layer = {
      id: 'a',
      color: 'red',
      segments: Float64Array.of(-8, 1, -6, 5),
      discs: Float64Array.of(2, 3, 1, -2, -4, -2),
      points: Float64Array.of(5, 6),
    }
    expect(seen({ above: [layer] })).toEqual([
      ['stroke red', 1.25, [120, 100, 230, 210]],
      ['fill red', 1, [247.5, 87.5, 252.5, 92.5]],
    ])
    expect(seen({ above: [{ ...layer, width: 3, dash: [2, 1], dot: 5, fill: 0.4 }] })).toEqual([
      ['fill red', 0.4, [210, 110, 230, 130]],
      ['fill red', 0.4, [160, 170, 200, 210]],
      ['stroke red', 3, 2, 1, [120, 100, 230, 210]],
      ['fill red', 1, [245, 85, 255, 95]],
    ])
  })

  it('several circles that are chosen have their rims, a dashed box and its handle; one has its handle alone', () => {
    const box = { minX: -2, minY: -3, maxX: 6, maxY: 5 }
    // The corner at the lower right is at (260, 180).
    const handle = [
      ['fill paper', 1, [263, 183, 271, 191]],
      ['stroke accent', 1.5, [263, 183, 271, 191]],
    ]
    const chosen = (...circles: number[]) => seen({ chosen: { circles: Float64Array.from(circles), box } })
    expect(chosen(0, 0, 2)).toEqual(handle)
    const frame = ['stroke accent', 1, 4, 4, [180, 100, 260, 180]]
    expect(chosen(0, 0, 2, 5, 4, 1, 6, -3, 0)).toEqual([
      ...haloed('selectedDisc', 1.5, [180, 130, 220, 170]),
      ...haloed('selectedDisc', 1.5, [240, 100, 261.5, 181.5]),
      frame,
      ...handle,
    ])
    // Circles beyond each side of the frame are left out, and those that reach into it are not.
    for (const [x, y] of [
      [-20, 0],
      [20, 0],
      [0, -15],
      [0, 15],
    ] as const) {
      const rims = (r: number) =>
        chosen(0, 0, 2, x * 1.1, y * 1.1, r).filter(([what]) => what === 'stroke selectedDisc')
      expect([rims(0.1 * Math.hypot(x, y) - 0.1).length, rims(0.1 * Math.hypot(x, y) + 0.1).length]).toEqual([1, 2])
    }
  })

  it('a band is where it is drawn, and a circle that is tried shows what it takes', () => {
    expect(seen({ band: { from: { x: 30, y: 90 }, to: { x: 10, y: 20 } } })).toEqual([
      ['fill accent', 0.1, [10, 20, 30, 90]],
      ['stroke accent', 1, [10, 20, 30, 90]],
    ])
    const cell = [150, 100, 250, 200]
    const rim = [190, 140, 210, 160]
    const ofTrial = (...dash: number[]) => [
      ['fill accent', 0.3, cell],
      ['fill accent', 0.3, rim],
      ['stroke paper', 6.5, cell],
      ['stroke accent', 2.5, 6, 4, cell],
      ['stroke paper', 6.5, rim],
      ['stroke accent', 2.5, ...dash, rim],
    ]
    const strokes = (how: Partial<typeof trial & { hiddenBy: number }>) =>
      seen({ trial: { ...trial, hiddenBy: undefined, ...how } }).filter(([what]) => !String(what).startsWith('write'))
    expect(strokes({})).toEqual(ofTrial())
    expect(strokes({ hiddenBy: 0 })).toEqual(ofTrial(4, 4))
    const written = (...taken: (readonly [x: number, y: number, area: number])[]) =>
      drawn({
        trial: { ...trial, hiddenBy: undefined, taken: taken.map(([x, y, area], id) => ({ id, x, y, area })) },
      }).operations.flatMap(({ kind, lengths }) => (kind.startsWith('write') ? [[kind, ...lengths]] : []))
    expect(written([8, 8, 60])).toEqual([['write −60 on paper', 280, 70, 12]])
    // No area is written in the circle, without a number, or where another one is.
    expect(written([0.9, 0, 60], [0, 1.1, 50], [9, 9, Number.NaN])).toHaveLength(1)
    expect(written([0, 5, 60], [5.9, 5, 50], [0, 3.7, 40])).toHaveLength(1)
    expect(written([0, 5, 60], [6.1, 5, 50], [0, 3.5, 40])).toHaveLength(3)
  })

  it('each number of a client is written at its point', () => {
    const above = [{ id: 'own', color: 'red', points: Float64Array.of(1, 1, 2, 3), numbers: Int32Array.of(7, 8) }]
    expect(drawn({ above }).operations.filter(({ kind }) => kind.startsWith('write'))).toMatchObject([
      { kind: 'write 7 on paper', lengths: [210, 140, expect.any(Number)] },
      { kind: 'write 8 on paper', lengths: [220, 120, expect.any(Number)] },
    ])
  })

  it('nothing is drawn where nothing stands out', () => {
    expect(isNothingAbove(EMPTY)).toBe(true)
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

  it('a grid has fine lines, numbered ones and axes', () => {
    const { operations } = drawn({ layers: withLayers({ grid: true }) })
    const lines = operations.filter(({ kind }) => kind.startsWith('stroke'))
    expect(lines.map(({ lengths }) => lengths.length > 4)).toEqual([true, true, true])
  })

  it('a polygon that is being drawn is filled, and has its sides, a dashed one to its start, and its corners', () => {
    const sides = [150, 100, 250, 200]
    const corners = [146, 96, 254, 204]
    expect(seen({ sketch: Float64Array.of(-5, -5, 5, -5, 0, 5) })).toEqual([
      ['fill accent', 0.18, sides],
      ...haloed('accent', 1.75, sides),
      ['stroke accent', 1.75, 5, 4, [150, 100, 200, 200]],
      ['fill paper', 1, corners],
      ['stroke accent', 1.75, corners],
    ])
  })
})
