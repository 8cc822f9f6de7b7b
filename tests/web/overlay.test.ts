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
  readonly operations: { readonly kind: string; readonly color: string; readonly lengths: readonly number[] }[] = []

  path(): PathSink {
    return new RecordingSink(4)
  }

  cover(color: string): void {
    this.operations.push({ kind: 'cover', color, lengths: [] })
  }

  fill(path: PathSink, color: string, opacity = 1): void {
    this.operations.push({ kind: `fill ${opacity}`, color, lengths: lengthsOf(path) })
  }

  stroke(path: PathSink, color: string, width: number, dash: readonly number[] = [], opacity = 1): void {
    this.operations.push({ kind: `stroke ${opacity}`, color, lengths: [width, ...dash, ...lengthsOf(path)] })
  }

  clip(): void {
    throw new Error('The overlay has no clip.')
  }

  write(text: string, x: number, y: number, size: number, color: string, rim: string): void {
    this.operations.push({ kind: `write ${text} on ${rim}`, color, lengths: [x, y, size] })
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

  it('strokes of hidden circles and of discs of negative radius are dashed', () => {
    const strokes = (above: Partial<Above>, color: string) =>
      drawn(above).operations.filter((operation) => operation.color === color && operation.kind.startsWith('stroke'))
    const disc = { marks: { selected: described(), hovered: undefined } }
    const hidden = { marks: { selected: described(0), hovered: undefined } }
    const extra = (dashed: Partial<Above>, whole: Partial<Above>, color: string) =>
      (strokes(dashed, color)[0]?.lengths.length ?? 0) - (strokes(whole, color)[0]?.lengths.length ?? 0)
    expect(extra(hidden, disc, 'selectedDisc')).toBe(2)
    const layers = withLayers({ disc: true })
    expect(extra({ touching: touching(-2), layers }, { touching: touching(2), layers }, 'touching')).toBe(2)
  })

  it('a polygon that is being drawn is filled, and has its sides, a dashed one to its start, and its corners', () => {
    const { operations } = drawn({ sketch: Float64Array.of(-5, -5, 5, -5, 0, 5) })
    // A recorded segment has four points.
    const cornersOf = (lengths: readonly number[]) => lengths.filter((_, k) => k % 8 < 2)
    const parts = operations.slice(0, 4).map(({ kind, color, lengths }) => {
      const dash = lengths.length % 2 === 0 ? 0 : lengths[1] === 5 ? 3 : 1
      return [kind, color, lengths.slice(0, dash), cornersOf(lengths.slice(dash))]
    })
    const corners = [150, 200, 250, 200, 200, 100]
    expect(parts).toEqual([
      ['fill 0.18', 'accent', [], corners],
      ['stroke 1', 'paper', [5.75], corners],
      ['stroke 1', 'accent', [1.75], corners],
      ['stroke 1', 'accent', [1.75, 5, 4], [200, 100, 150, 200]],
    ])
    const [filled, rims] = operations.slice(4)
    expect([filled?.kind, filled?.color, rims?.kind, rims?.color]).toEqual(['fill 1', 'paper', 'stroke 1', 'accent'])
    expect(rims?.lengths).toEqual([1.75, ...(filled?.lengths ?? [])])
    const along = (axis: number) => filled?.lengths.filter((_, k) => k % 2 === axis) ?? []
    expect([0, 1].map((axis) => [Math.min(...along(axis)), Math.max(...along(axis))])).toEqual([
      [146, 254],
      [96, 204],
    ])
  })

  it('a grid has fine lines, numbered ones and axes, one darker than the other', () => {
    const { operations } = drawn({ layers: withLayers({ grid: true }) })
    const lines = operations.filter(({ kind }) => kind.startsWith('stroke'))
    expect(lines.map(({ kind, color, lengths: [width] }) => [kind, color, width])).toEqual([
      ['stroke 0.09', 'edge', 1],
      ['stroke 0.22', 'edge', 1],
      ['stroke 0.7', 'edge', 1.5],
    ])
    for (const { lengths } of lines) expect(lengths.length).toBeGreaterThan(4)
  })
})
