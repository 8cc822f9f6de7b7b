// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of layers on the whole page: each control, and the layers that are drawn afterwards.
// @vitest-environment happy-dom

import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { uncoverPath } from '../../web/app/arrange.ts'
import type { Point } from '../../web/lib/index.ts'
import { toPlane, toScreen } from '../../web/view/camera.ts'
import { DEFAULT_LAYERS, type Layers, MOST_PAIRED, MOST_TRACED } from '../../web/view/layers.ts'
import { all, control, controls } from './page-document.ts'
import { entered, FIVE, found, pressed, quiet, SIZE, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
let panel: HTMLElement
const layers = () => page.store.get().layers

beforeAll(async () => {
  page = await wholePage()
  panel = await page.panel('layers')
})
beforeEach(async () => {
  page.view.setLayers(DEFAULT_LAYERS)
  await page.open(FIVE)
})

const expectLayers = (more: Partial<Layers>) => expect(layers()).toEqual({ ...DEFAULT_LAYERS, ...more })

it('the ends of a new path are in the part of the picture that no panel covers', async () => {
  const { view, actions } = page
  const covered = { top: 10, right: 300, bottom: 20, left: 400 }
  const { camera } = actions
  const free = camera.covered
  camera.covered = () => covered
  const { from, to } = actions.opening.pathAcross()
  camera.covered = free
  for (const end of [from, to]) {
    const { x, y } = toScreen(view.camera, view.size, end)
    expect(x).toBeGreaterThan(covered.left)
    expect(x).toBeLessThan(view.size.width - covered.right)
    expect(y).toBeGreaterThan(covered.top)
    expect(y).toBeLessThan(view.size.height - covered.bottom)
  }
})

it('an end of a path that a panel begins to cover moves to where it is seen, and no other end', async () => {
  const { view, actions } = page
  const at = (x: number, y = 0.5) => toPlane(view.camera, view.size, { x: x * SIZE.width, y: y * SIZE.height })
  const { camera } = actions
  const free = camera.covered
  const before = camera.covered()
  const uncover = (from: Point, to: Point) => {
    view.setLayers({ path: { from, to } })
    uncoverPath(view, actions, before)
    return view.layers.path
  }
  camera.covered = () => ({ ...before, left: 0.5 * SIZE.width })
  const moved = uncover(at(0.2), at(0.8))
  const across = actions.opening.pathAcross()
  const isLeft = uncover(at(0.9), at(0.45))
  // The first end is outside of the window, and the second one was covered before.
  const [outside, under] = [at(-0.2), at(0.3, 1 - (0.5 * before.bottom) / SIZE.height)]
  const kept = uncover(outside, under)
  camera.covered = free
  expect(moved).toEqual({ from: across.from, to: at(0.8) })
  expect(isLeft).toEqual({ from: at(0.9), to: across.to })
  expect(kept).toEqual({ from: outside, to: under })
})

it('the ends of a new path are outside of circles where there is room', async () => {
  const { view, actions } = page
  const { from, to } = actions.opening.pathAcross()
  await page.open(Float64Array.of(from.x, from.y, 1, to.x, to.y, 1))
  const ends = actions.opening.pathAcross()
  for (const end of [ends.from, ends.to]) expect(view.hitAt(end, 0)?.part).toBe('cell')
})

describe('a switch of the panel of layers', () => {
  it.each([
    ['Circles', 'circles'],
    ['Names', 'labels'],
    ['Cells in full color', 'fullColor'],
    ['Edges', 'edges'],
    ['Vertices', 'vertices'],
    ['What hides hidden circles', 'hidden'],
    ['Disc at the pointer', 'disc'],
    ['Largest empty disc', 'largestDisc'],
    ['Convex hull', 'hull'],
    ['Dual graph', 'dual'],
    ['Delaunay of centers', 'delaunay'],
    ['Voronoi of centers', 'ordinary'],
    ['Power diagram', 'power'],
    ['Samples', 'samples'],
    ['Delaunay of samples', 'sampleGraph'],
    ['Antipodal discs', 'antipodalDiscs'],
    ['Directed edges left', 'directedEdges'],
    ['Edges that it misses', 'missedEdges'],
  ] as const)('%s shows and hides this layer alone', async (label, name) => {
    const before = DEFAULT_LAYERS[name]
    expect((await found(panel, label)).checked).toBe(before)
    for (const isOn of [!before, before]) {
      await pressed(panel, label)
      expectLayers({ [name]: isOn })
      expect((await found(panel, label)).checked).toBe(isOn)
    }
  })

  it('for the grid also turns snapping on and off', async () => {
    for (const grid of [true, false]) {
      await pressed(panel, 'Axes and grid')
      expectLayers({ grid })
      expect(page.store.get().isSnapping).toBe(grid)
    }
    page.actions.tools.toggleSnapping()
    await pressed(panel, 'Axes and grid')
    expectLayers({ grid: true })
    expect(page.store.get().isSnapping, 'it was on before').toBe(true)
    page.actions.tools.toggleSnapping()
  })
})

describe('a number in the panel of layers', () => {
  it('merges vertices up to a length that is at first just above rounding errors', async () => {
    await pressed(panel, 'merged up to length')
    const length = 'Length up to which vertices are merged'
    const extent = SIZE.width / page.view.camera.scale
    expect((layers().nearZero as number) / extent).toBeCloseTo(1e-9, 11)
    await entered(panel, length, '0.5')
    expectLayers({ nearZero: 0.5 })
    await entered(panel, length, '-1')
    await entered(panel, length, '0')
    expectLayers({ nearZero: 0 })
    await pressed(panel, 'merged up to length')
    expectLayers({})
  })

  it('ends cells at a distance that grows with the square of the slider, up to a quarter of the picture', async () => {
    const extent = SIZE.width / page.view.camera.scale
    const slider = 'Distance at which cells end'
    await pressed(panel, 'Cells end at a distance')
    expect(layers().maxDistance).toBeCloseTo(0.025 * extent, 2)
    expect(Number(control(panel, slider).value)).toBeCloseTo(Math.sqrt(0.1), 3)
    for (const [value, share] of [
      ['1', 1],
      ['0.5', 0.25],
    ] as const) {
      await entered(panel, slider, value)
      expect(layers().maxDistance).toBeCloseTo((share * extent) / 4, 1)
    }
    await pressed(panel, 'Cells end at a distance')
    expectLayers({})
  })
})

describe('the touching disc method', () => {
  it('is offered for few circles, and all pairs for fewer', async () => {
    await pressed(panel, 'Samples')
    const offered = async (circles: number) => {
      page.store.update((state) => {
        const edited = state.edited as NonNullable<typeof state.edited>
        return { ...state, edited: { ...edited, counts: { ...edited.counts, circles } } }
      })
      await quiet()
      return [controls(panel).has('Samples'), ...all(panel, '[value=all-pairs]:not(:disabled)').map(() => 'all pairs')]
    }
    expect(await offered(MOST_PAIRED)).toEqual([true, 'all pairs'])
    expect(await offered(MOST_PAIRED + 1)).toEqual([true])
    expect(await offered(MOST_TRACED)).toEqual([true])
    expect(await offered(MOST_TRACED + 1)).toEqual([false])
  })
})
