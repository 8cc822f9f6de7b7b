// SPDX-License-Identifier: GPL-3.0-or-later
// The cones of the tutorial, on a page without a browser.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { turnCones } from '../../web/tutorial/cones.ts'

const painted: unknown[][] = []
vi.mock('../../web/tutorial/drawn/paint-cones.ts', () => ({
  paintCones: (...[, , pose, width, height]: unknown[]) => painted.push([pose, width, height]),
}))

/** A slider with the output beside it. */
class Slider extends EventTarget {
  readonly output = { value: '' }
  readonly parentElement = { querySelector: () => this.output }
  valueAsNumber: number
  constructor(value: number) {
    super()
    this.valueAsNumber = value
  }
}

let width: number
let frames: (() => void)[]
let resized: () => void
let canvas: EventTarget & { attributes: Map<string, string> }
const draw = () => {
  painted.length = 0
  for (const frame of frames.splice(0)) frame()
  return painted
}
beforeEach(() => {
  width = 300
  frames = []
  vi.stubGlobal('devicePixelRatio', 1)
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
  vi.stubGlobal('ImageData', class {})
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
afterEach(() => vi.unstubAllGlobals())

function started() {
  const attributes = new Map<string, string>()
  const captured = new Set<number>()
  canvas = Object.assign(new EventTarget(), {
    attributes,
    setAttribute: (name: string, value: string) => attributes.set(name, value),
    getBoundingClientRect: () => ({ width }),
    getContext: () => ({ putImageData() {} }),
    setPointerCapture: (id: number) => captured.add(id),
    hasPointerCapture: (id: number) => captured.has(id),
  })
  const shown: unknown[] = []
  const picture = {
    querySelector: () => ({ alt: 'Three cones' }),
    replaceChildren: (...children: unknown[]) => shown.push(...children),
  }
  const sliders = [new Slider(60), new Slider(170)] as const
  const figure = {
    querySelector: () => picture,
    querySelectorAll: () => sliders,
    ownerDocument: { createElement: () => canvas },
    dataset: { cones: '{"circles": [], "view": [0, 0, 1]}' },
  }
  turnCones({ querySelectorAll: () => [figure] } as unknown as Document)
  return { sliders, shown, captured }
}

it('cones take the place of their picture, with its name, and are drawn once they have a size', () => {
  const { shown } = started()
  expect(shown).toEqual([canvas])
  expect(canvas.attributes.get('aria-label')).toBe('Three cones')
  width = 0
  resized()
  expect(draw()).toEqual([])
  width = 300
  resized()
  resized()
  expect(draw()).toEqual([[{ tilt: 60, turn: 170 }, 450, 281]])
  expect(draw()).toEqual([])
  vi.stubGlobal('devicePixelRatio', 3)
  resized()
  expect(draw()).toEqual([[{ tilt: 60, turn: 170 }, 600, 375]])
})

it('cones are turned by the sliders, and by a drag with the pointer once around', () => {
  const { sliders, captured } = started()
  const [tilt, spin] = sliders
  tilt.valueAsNumber = 45.4
  tilt.dispatchEvent(new Event('input'))
  expect([tilt.output.value, draw()]).toEqual(['45°', [[{ tilt: 45.4, turn: 170 }, 450, 281]]])
  const send = (type: string, movementX: number, movementY: number) =>
    canvas.dispatchEvent(Object.assign(new Event(type), { pointerId: 7, movementX, movementY }))
  send('pointermove', 10, 10)
  expect(draw()).toEqual([])
  send('pointerdown', 0, 0)
  expect([...captured]).toEqual([7])
  send('pointermove', -50, 10)
  expect([tilt.valueAsNumber, spin.valueAsNumber]).toEqual([48.4, -170].map((value) => expect.closeTo(value)))
  expect(spin.output.value).toBe('-170°')
  send('pointermove', 50, 0)
  expect(spin.valueAsNumber).toBeCloseTo(170)
  expect(draw()).toHaveLength(1)
})
