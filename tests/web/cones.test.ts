// SPDX-License-Identifier: GPL-3.0-or-later
// The cones of the tutorial, which readers turn.
// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from 'vitest'
import { turnCones } from '../../web/tutorial/cones.ts'
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
