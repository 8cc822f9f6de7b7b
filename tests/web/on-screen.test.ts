// SPDX-License-Identifier: GPL-3.0-or-later
// Positions and lengths on the screen, of elements that are scaled, rotated and zoomed.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { pointOf, scaleOnScreen } from '../../web/view/on-screen.ts'

/** An element in others, with its CSS `zoom`. Engines that know `currentCSSZoom` give it, too. */
interface Fake {
  readonly zoom: string
  readonly currentCSSZoom?: number
  readonly assignedSlot?: Fake | null
  readonly parentElement: Fake | null
  readonly parentNode: unknown
}

class Root {
  readonly host: Fake
  constructor(host: Fake) {
    this.host = host
  }
}
beforeEach(() => {
  vi.stubGlobal('ShadowRoot', Root)
  vi.stubGlobal('getComputedStyle', ({ zoom }: Fake) => ({
    getPropertyValue: (name: string) => (name === 'zoom' ? zoom : ''),
  }))
})
afterEach(() => vi.unstubAllGlobals())

const inside = (parent: Fake | null, zoom: string, more: object = {}): Fake => ({
  zoom,
  parentElement: parent,
  parentNode: parent,
  ...more,
})
const at = (target: Fake | null) => pointOf({ offsetX: 60, offsetY: 30, target } as unknown as MouseEvent)

it('a point is in pixels of its element before zoom, also across slots and shadow roots', () => {
  expect(at(null)).toEqual({ x: 60, y: 30 })
  expect(at(inside(null, '9', { currentCSSZoom: 2 }))).toEqual({ x: 30, y: 15 })
  const page = inside(null, '1.5')
  expect(at(inside(page, '2'))).toEqual({ x: 20, y: 10 })
  expect(at(inside(page, ''))).toEqual({ x: 40, y: 20 })
  const host = inside(page, '2')
  expect(at({ zoom: '1', parentElement: null, parentNode: new Root(host) })).toEqual({ x: 20, y: 10 })
  const slot = inside(host, '1')
  expect(at(inside(page, '1', { assignedSlot: slot }))).toEqual({ x: 20, y: 10 })
  expect(at({ zoom: '2', parentElement: null, parentNode: {} })).toEqual({ x: 30, y: 15 })
})

/** The scale of an element of these sides that is scaled and turned. Its own zoom is 3. */
function scaled(width: number, height: number, scale: number, turn: number, more: object = {}): number {
  const [cos, sin] = [Math.abs(Math.cos(turn)), Math.abs(Math.sin(turn))]
  const box = { width: scale * (width * cos + height * sin), height: scale * (width * sin + height * cos) }
  const element = { offsetWidth: width, offsetHeight: height, getBoundingClientRect: () => box, ...more }
  return scaleOnScreen(element as unknown as HTMLElement)
}

it.each([
  [300, 200],
  [200, 300],
  [300, 294],
])('a length of %d by %d pixels is known at each scale and angle', (width, height) => {
  for (const scale of [0.5, 1, 2.5]) {
    for (const turn of [0, 0.4, Math.PI / 2, 2.5])
      expect(scaled(width, height, scale, turn, { currentCSSZoom: 3 })).toBeCloseTo(scale, 9)
  }
})

it('a square is as large as its box, a side of no length is as it is, and zoom counts once', () => {
  expect(scaled(300, 300, 2, 0, { currentCSSZoom: 3 })).toBeCloseTo(2, 9)
  expect(scaled(300, 295, 2, 0, { currentCSSZoom: 3 })).toBeCloseTo(2, 9)
  for (const [width, height] of [
    [0, 100],
    [100, 0],
  ] as const)
    expect(scaled(width, height, 2, 0)).toBe(1)
  const zoomed = inside(null, '3')
  expect(scaled(300, 200, 2, 0.4, zoomed)).toBeCloseTo(6, 9)
  expect(scaled(300, 300, 2, 0, zoomed)).toBeCloseTo(6, 9)
})
