// SPDX-License-Identifier: GPL-3.0-or-later
// The cones of the tutorial, which readers turn.
// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from 'vitest'
import { turnCones } from '../../web/tutorial/cones.ts'
import { paintCones } from '../../web/tutorial/drawn/paint-cones.ts'
import { make, send } from './page-document.ts'

/** The pixels of each drawing. */
const drawn: { readonly data: Uint8ClampedArray; readonly size: readonly [number, number] }[] = []
let width: number
let frames: (() => void)[]
let resized: () => void
const draw = () => {
  drawn.length = 0
  for (const frame of frames.splice(0)) frame()
  return drawn.map(({ size }) => size)
}

beforeEach(() => {
  width = 300
  frames = []
  vi.stubGlobal('devicePixelRatio', 1)
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
  vi.stubGlobal(
    'ImageData',
    class {
      constructor(data: Uint8ClampedArray, ...size: [number, number]) {
        drawn.push({ data, size })
      }
    },
  )
  vi.stubGlobal(
    'ResizeObserver',
    class {
      constructor(changed: () => void) {
        resized = changed
      }
      observe() {}
    },
  )
})

function started() {
  const sliders = [make('input', { type: 'range', min: 0, max: 90, step: 'any', value: 60 }), make('input')] as const
  Object.assign(sliders[1], { type: 'range', min: -180, max: 180, step: 'any', value: 170 })
  const outputs = sliders.map(() => make('output'))
  const picture = make('div', { className: 'picture' }, Object.assign(make('img'), { alt: 'Three cones' }))
  const labels = sliders.map((slider, k) => make('label', {}, slider, outputs[k] as Node))
  const figure = make('figure', {}, picture, ...labels)
  figure.dataset.cones = JSON.stringify({
    circles: [
      [0, 0, 1],
      [3, 0, 1],
      [1, 2, 0.5],
    ],
    view: [1, 1, 6],
  })
  document.body.replaceChildren(figure)
  turnCones(document)
  const canvas = picture.querySelector('canvas') as HTMLCanvasElement
  const captured = new Set<number>()
  Object.assign(canvas, {
    getBoundingClientRect: () => ({ width }),
    getContext: () => ({ putImageData() {} }),
    setPointerCapture: (id: number) => captured.add(id),
    hasPointerCapture: (id: number) => captured.has(id),
  })
  return { picture, canvas, sliders, outputs }
}

it('cones take the place of their picture, with its name, and are drawn as large as they are', () => {
  const { picture, canvas } = started()
  expect([[...picture.children], canvas.getAttribute('aria-label')]).toEqual([[canvas], 'Three cones'])
  for (const [pageWidth, ratio, size] of [
    [0, 1, []],
    // Lines are smooth also where a pixel of the screen is one of the page.
    [300, 1, [[450, 281]]],
    [300, 1.75, [[525, 328]]],
    [300, 3, [[600, 375]]],
  ] as const) {
    width = pageWidth
    vi.stubGlobal('devicePixelRatio', ratio)
    resized()
    resized()
    expect(draw()).toEqual(size)
  }
})

it('cones are turned by the sliders, and by a drag with the pointer once around', () => {
  const { canvas, sliders, outputs } = started()
  const [tilt, spin] = sliders
  resized()
  draw()
  const before = drawn[0]?.data
  tilt.valueAsNumber = 45.4
  send(tilt, 'input')
  expect([outputs[0]?.value, draw().length, drawn[0]?.data.join() === before?.join()]).toEqual(['45°', 1, false])
  const move = (movementX: number, movementY: number) => {
    send(canvas, 'pointermove', { pointerId: 7, movementX, movementY })
    return sliders.map(({ valueAsNumber }) => Math.round(10 * valueAsNumber) / 10)
  }
  expect([move(10, 10), draw()]).toEqual([[45.4, 170], []])
  send(canvas, 'pointerdown', { pointerId: 7 })
  expect(move(-50, 10)).toEqual([48.4, -170])
  expect([outputs[1]?.value, draw().length]).toEqual(['-170°', 1])
  expect(move(50, 0)).toEqual([48.4, 170])
  expect(spin.valueAsNumber).toBeCloseTo(170)
})

it('each pixel shows the cone that its ray meets first, in the color of the cone and never white', () => {
  const CONES = [
    [-4.6, 1.4, 2.2],
    [1.2, 2.6, 1.2],
    [5.6, -0.4, 1.9],
    [0.3, -2.2, 1.5],
    [-3.6, -3.4, 0.6],
    [4.4, 4.2, 0.5],
  ] as const
  const [columns, rows, span] = [64, 40, 20]
  const colorAt = (pixels: Uint8ClampedArray, k: number) => [...pixels.slice(4 * k, 4 * k + 3)]
  // Each cone alone, from above: its color, and the paler one below the ground.
  const palette = CONES.flatMap((_, i) => {
    const circles = CONES.map(([x, y, r], j): number[] => (i === j ? [0, 0, 5] : [x, y, r - 100]))
    const seen = paintCones(circles, [0, 0, span], { tilt: 90, turn: 0 }, columns, rows)
    return [colorAt(seen, 0), colorAt(seen, columns * 20 + 32)]
  })
  /** The number of a color whatever the light on it, or -1. */
  const partOf = (color: number[]) => {
    const likeness = palette.map((own) => {
      const product = own.reduce((sum, value, c) => sum + value * (color[c] as number), 0)
      return product / Math.hypot(...own) / Math.hypot(...color)
    })
    const best = Math.max(...likeness)
    return best > 0.9995 ? likeness.indexOf(best) : -1
  }
  for (const [tilt, turn] of [
    [34, -42],
    [0, 100],
    [45, 170],
    [62, -90],
    [90, 20],
  ] as const) {
    const pixels = paintCones(CONES, [0, 0.6, span], { tilt, turn }, columns, rows)
    const [sin, cos] = [Math.sin((tilt * Math.PI) / 180), Math.cos((tilt * Math.PI) / 180)]
    const [turnX, turnY] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)]
    const placed = CONES.map(([x, y, r]) => [x * turnX - (y - 0.6) * turnY, x * turnY + (y - 0.6) * turnX, r] as const)
    const partAlong = (u: number, s: number) => {
      for (let t = -30; t < 60; t += 0.1) {
        const [v, z] = [s * sin + t * cos, s * cos - t * sin]
        const i = placed.findIndex(([cu, cv, r]) => z <= r - Math.hypot(u - cu, v - cv))
        if (i >= 0) return 2 * i + (z >= 0 ? 1 : 0)
      }
      return undefined
    }
    let compared = 0
    for (let k = 0; k < columns * rows; k += 31) {
      const [column, row] = [k % columns, Math.floor(k / columns)]
      const [u, s] = [
        ((column + 0.5 - columns / 2) * span) / columns,
        ((rows / 2 - row - 0.5) * span) / columns - (0.35 * cos * span * rows) / columns / 2,
      ]
      const part = partAlong(u, s)
      const isNear = [-0.5, 0.5].some((d) => partAlong(u + d, s) !== part || partAlong(u, s + d) !== part)
      if (isNear || pixels[4 * k + 3] === 0) {
        if (!isNear) expect([tilt, turn, k, part]).toEqual([tilt, turn, k, undefined])
        continue
      }
      const color = colorAt(pixels, k)
      expect([tilt, turn, k, partOf(color)]).toEqual([tilt, turn, k, part])
      expect(Math.max(...color)).toBeLessThan(255)
      compared += 1
    }
    expect(compared).toBeGreaterThan(20)
  }
})
