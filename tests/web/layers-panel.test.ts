// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of layers on the whole page: each control, and the layers that are drawn afterwards.
// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { CELL_COLORS, DEFAULT_LAYERS, type Layers, MOST_PAIRED, MOST_TRACED, SAMPLES } from '../../web/view/layers.ts'
import { all, chosenOf, control, controls, element, limitsOf, optionsOf, press } from './page-document.ts'
import { box } from './shapes.ts'
import { entered, FIVE, found, pressed, quiet, SIZE, soon, wholePage } from './whole-page.ts'

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

describe('a switch of the panel of layers', () => {
  it.each([
    ['Circles', 'circles'],
    ['Names', 'labels'],
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
    page.actions.toggleSnapping()
    await pressed(panel, 'Axes and grid')
    expectLayers({ grid: true })
    expect(page.store.get().isSnapping, 'it was on before').toBe(true)
    page.actions.toggleSnapping()
  })

  it('for the path draws one across the picture and shows how near it comes to a circle', async () => {
    await pressed(panel, 'Clearest path')
    const { camera } = page.view
    const half = (0.6 * SIZE.width) / camera.scale / 2
    expectLayers({ path: { from: { x: camera.x - half, y: camera.y }, to: { x: camera.x + half, y: camera.y } } })
    const numbers = () => all(panel, 'small').map(({ title, textContent }) => [title, textContent])
    await soon(() => expect(numbers()).toEqual([['How near it comes to a circle', expect.stringMatching(/^[\d.]+$/)]]))
    expect(Number(numbers()[0]?.[1])).toBeCloseTo(page.store.get().found?.path?.clearance as number, 2)
    await pressed(panel, 'Clearest path')
    expectLayers({})
    await pressed(panel, 'Largest empty disc')
    await soon(() => expect(numbers()).toEqual([['Its radius', expect.stringMatching(/^[\d.]+$/)]]))
    expect(Number(numbers()[0]?.[1])).toBeCloseTo(page.store.get().found?.largestDisc?.disc.r as number, 2)
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

describe('the colors of cells', () => {
  it('are by each measure, and by a column of the file if it has columns', async () => {
    expect(optionsOf(control(panel, 'Colors'))).toHaveLength(CELL_COLORS.length)
    for (const cells of CELL_COLORS) {
      await entered(panel, 'Colors', cells)
      expectLayers({ cells })
      expect(control(panel, 'Colors').value).toBe(cells)
    }
    await entered(panel, 'Colors', 'area')
    await page.open(FIVE, [{ name: 'n', values: ['5', '4', '3', '2', '1'] }])
    expect(optionsOf(control(panel, 'Colors')).at(-1)).toBe('n')
    await entered(panel, 'Colors', 'column:n')
    expect([layers().column?.name, chosenOf(control(panel, 'Colors'))]).toEqual(['n', 'n'])
    expect([...(layers().column?.values ?? [])].slice(0, 5)).toEqual([5, 4, 3, 2, 1])
    await entered(panel, 'Colors', 'radius')
    expectLayers({ cells: 'radius' })
  })
})

describe('the touching disc method', () => {
  const count = () => all(panel, '#sample-count')[0] as HTMLInputElement | undefined

  it('has candidates with their own number of samples, which is checked', async () => {
    expect(controls(panel).has('Candidates')).toBe(false)
    await pressed(panel, 'Samples')
    for (const candidates of ['uniform', 'dynamic'] as const) {
      await entered(panel, 'Candidates', candidates)
      expectLayers({ samples: true, candidates })
      const { least, usual, most } = SAMPLES[candidates]
      expect(count()?.value).toBe(String(usual))
      expect(limitsOf(count() as Element)).toEqual([String(least), String(most), '1'])
      const name = candidates === 'dynamic' ? 'N_s, samples inside an angle' : 'm, samples on a circle'
      await entered(panel, name, String(usual + 1))
      expectLayers({ samples: true, candidates, sampleCount: usual + 1 })
      await entered(panel, name, String(least - 1))
      await entered(panel, name, String(least))
      expectLayers({ samples: true, candidates, sampleCount: least })
    }
    await entered(panel, 'Candidates', 'all-pairs')
    expectLayers({ samples: true, candidates: 'all-pairs' })
    expect(count()).toBeUndefined()
    await soon(() => expect(element('method-found').textContent).not.toBe('…'))
  })

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

describe('the radii', () => {
  it('are scaled by the slider in one step of undo, but not where areas are given', async () => {
    const radii = () => [0, 1, 2].map((id) => page.circle(id)?.r)
    await entered(panel, 'Radii', '0.5', '0', '0.25')
    expect(radii()).toEqual([0.5, 0.75, 0.25])
    await page.actions.undo()
    expect(radii()).toEqual([2, 3, 1])
    await page.actions.setDomain({
      region: [box(-9, -9, 30, 30)],
      areas: 'equal',
    })
    await quiet()
    expect(controls(panel).has('Radii')).toBe(false)
  })

  it('are animated together with the diagrams to compare, until the button is pressed again', async () => {
    press(panel, 'Play')
    expectLayers({ edges: true, ordinary: true, power: true })
    await soon(() => expect(page.circle(0)?.r).not.toBe(2))
    await pressed(panel, 'Stop')
    expect(control(panel, 'Play').getAttribute('aria-pressed')).toBe('false')
  })
})

it('the panel says that layers are seen only after the method was played', async () => {
  const isSaid = () => panel.textContent?.includes('layers are seen at its end')
  expect(isSaid()).toBe(false)
  page.actions.showStep(0)
  await soon(() => expect(isSaid()).toBe(true))
  page.actions.showStep(undefined)
  await soon(() => expect(isSaid()).toBe(false))
})
