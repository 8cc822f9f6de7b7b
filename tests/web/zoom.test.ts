// SPDX-License-Identifier: GPL-3.0-or-later
// The viewport after "zoom to" and "show everything", without a browser.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { toScreen } from '../../web/view/camera.ts'
import { editingSession, sceneOf } from './editing-session.ts'

const SIZE = { width: 400, height: 300 }
const PADDING = { top: 20, right: 40, bottom: 60, left: 80 }

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => 0)
})
afterEach(() => vi.unstubAllGlobals())

async function started(...circles: number[]) {
  const { store, editing, fake: view, actions } = editingSession({ size: SIZE, padding: PADDING })
  await editing.open(sceneOf(Float64Array.from(circles)))
  const select = (...selection: number[]) => store.update((state) => ({ ...state, selection }))
  /** The positions of points in the part of the view that panels leave free, from 0 to 1. */
  const shares = (...points: [number, number][]) =>
    points.map(([x, y]) => {
      const p = toScreen(view.camera, SIZE, { x, y })
      const [width, height] = [SIZE.width - PADDING.left - PADDING.right, SIZE.height - PADDING.top - PADDING.bottom]
      return [(p.x - PADDING.left) / width, (p.y - PADDING.top) / height]
    })
  return { actions, view, select, shares }
}

it('selected circles fill the free part of the view, whole and in its middle', async () => {
  const { actions, select, shares } = await started(0, 0, 1, 50, 20, 2, 60, 20, 3, 500, 500, 1)
  select(1, 2)
  actions.zoomToSelection()
  const [middle, low, high] = shares([55.5, 20], [48, 17], [63, 23]) as [number[], number[], number[]]
  for (const share of middle) expect(share).toBeCloseTo(0.5, 6)
  for (const share of [...low, ...high]) {
    expect(share).toBeGreaterThan(0)
    expect(share).toBeLessThan(1)
  }
  expect((high[0] as number) - (low[0] as number)).toBeGreaterThan(0.1)
})

it.each([
  [0, 0],
  [0.001, 0],
])('a point, or several at one place, is shown at a finite size (radius %s)', async (r) => {
  const { actions, view, select, shares } = await started(3, 4, r, 3, 4, r, 100, 0, 1)
  select(0)
  actions.zoomToSelection()
  expect(Number.isFinite(view.camera.scale)).toBe(true)
  expect(view.camera.scale).toBeGreaterThan(0)
  for (const share of shares([3, 4])[0] as number[]) expect(share).toBeCloseTo(0.5, 6)
})

it('circles around one center are shown at their size, and points apart all together', async () => {
  const { actions, select, shares } = await started(3, 4, 10, 3, 4, 5, 100, 0, 0, 900, 0, 0)
  const top = () => shares([3, 14])[0]?.[1] as number
  select(0, 1)
  actions.zoomToSelection()
  expect(0.5 - top()).toBeGreaterThan(0.1)
  expect(0.5 - top()).toBeLessThan(0.25)
  select(2, 3)
  actions.zoomToSelection()
  for (const share of shares([100, 0], [900, 0]).flat()) {
    expect(share).toBeGreaterThan(0)
    expect(share).toBeLessThan(1)
  }
})

it('a point is shown at the size of a new circle, which depends on the scale', async () => {
  const { actions, view, select } = await started(3, 4, 0, 100, 0, 1)
  select(0)
  const scales = [1, 7].map((scale) => {
    view.camera = { x: 0, y: 0, scale }
    actions.zoomToSelection()
    return view.camera.scale
  })
  expect((scales[1] as number) / (scales[0] as number)).toBeCloseTo(7, 6)
})

it('nothing selected changes nothing', async () => {
  const { actions, view } = await started(0, 0, 1, 5, 5, 1)
  const before = view.camera
  actions.zoomToSelection()
  expect(view.camera).toBe(before)
})
