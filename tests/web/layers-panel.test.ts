// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of layers: each control changes its layer and no other one.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { Motion } from '../../web/app/motion/motion.ts'
import type { Radii } from '../../web/app/motion/radii.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import { mountLayers } from '../../web/app/panels/layers.ts'
import type { State } from '../../web/editing/state.ts'
import { CELL_COLORS, DEFAULT_LAYERS, type Layers, MOST_PAIRED, MOST_TRACED, SAMPLES } from '../../web/view/layers.ts'
import type { View } from '../../web/view/view.ts'
import { noting, stateOf, stubPage } from './page-document.ts'

vi.mock('lit/html.js', async (load) => ({
  ...(await load<object>()),
  render: (await import('./page-document.ts')).render,
}))

let stub: ReturnType<typeof stubPage>
beforeEach(() => {
  stub = stubPage()
})
afterEach(() => vi.unstubAllGlobals())

const countsOf = (circles: number) => ({ counts: { circles } }) as unknown as State['edited']

function mounted(state: Partial<State> = {}) {
  const done: unknown[][] = []
  const { store, change } = stateOf({ edited: countsOf(8), ...state })
  const path = { from: { x: 0, y: 1 }, to: { x: 2, y: 3 } }
  const actions = noting(done, { pathAcross: () => path })
  const events = new Map<string, () => void>()
  const view = {
    camera: { x: 0, y: 0, scale: 4 },
    size: { width: 200, height: 100 },
    hasDiagram: true,
    on: (name: string, act: () => void) => events.set(name, act),
  }
  const known = { isMoving: false, onchange: (act: () => void) => events.set('motion', act) }
  const radii = { share: 0.5, scale: (share: number) => done.push(['scale', share]) }
  const motion = noting(done, known)
  mountLayers(
    store,
    actions as unknown as PageActions,
    view as unknown as View,
    motion as unknown as Motion,
    radii as unknown as Radii,
  )
  const panel = stub.element('layers')
  stub.element('layers-button').click()
  const layers = (more: Partial<Layers>) => change({ layers: { ...DEFAULT_LAYERS, ...more } })
  return { panel, done, change, layers, view, motion: known, events, path, radii }
}

const SWITCHES: readonly (readonly [string, keyof Layers])[] = [
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
]

it.each(SWITCHES)('%s is a switch of its layer', (label, name) => {
  const { panel, done, layers } = mounted()
  for (const isOn of [true, false]) {
    // Measures stand beside the names of some layers.
    layers({ [name]: isOn })
    const shown = [...panel.controls.keys()].find((other) => other.startsWith(label)) as string
    expect(panel.control(shown).checked).toBe(isOn)
    panel.enter(shown, !isOn, ['change'])
    expect(done.pop()).toStrictEqual(['setLayers', { [name]: !isOn }])
  }
})

it('colors are by a measure or by a column of the file', () => {
  const { panel, done, change, layers } = mounted()
  expect(panel.control('Colors').options).toHaveLength(CELL_COLORS.length)
  change({ attributes: { columns: [{ name: 'n', values: [] }], ids: [], heights: [], collection: '' } })
  expect(panel.control('Colors').options.slice(-2)).toEqual(['neighbors differ', 'n'])
  const values = panel
    .control('Colors')
    .querySelectorAll('option')
    .map(({ value }) => value)
  expect(values).toEqual([...CELL_COLORS, 'column:n'])
  panel.enter('Colors', 'area', ['change'])
  panel.enter('Colors', 'column:n', ['change'])
  expect(done).toStrictEqual([
    ['setLayers', { cells: 'area', column: undefined }],
    ['colorBy', 'n'],
  ])
  layers({ cells: 'degree' })
  expect([panel.control('Colors').value, panel.control('Colors').chosen]).toEqual(['degree', 'by neighbors'])
  layers({ cells: 'degree', column: { name: 'n', values: new Float64Array() } })
  expect([panel.control('Colors').value, panel.control('Colors').chosen]).toEqual(['column:n', 'n'])
})

it('the grid is switched together with snapping', () => {
  const { panel, done, change } = mounted()
  panel.enter('Axes and grid', true, ['change'])
  change({ isSnapping: true })
  panel.enter('Axes and grid', true, ['change'])
  panel.enter('Axes and grid', false, ['change'])
  expect(done).toStrictEqual([
    ['setLayers', { grid: true }],
    ['toggleSnapping'],
    ['setLayers', { grid: true }],
    ['setLayers', { grid: false }],
    ['toggleSnapping'],
  ])
})

it('the path goes across the picture, and its clearance and the radius of the largest disc are shown once found', () => {
  const { panel, done, change, layers, path } = mounted()
  panel.enter('Clearest path', true, ['change'])
  panel.enter('Clearest path', false, ['change'])
  expect(done).toStrictEqual([
    ['setLayers', { path }],
    ['setLayers', { path: undefined }],
  ])
  expect(panel.control('Clearest path').checked).toBe(false)
  layers({ path, largestDisc: true })
  expect([...panel.controls].find(([label]) => label.startsWith('Clearest path'))?.[1].checked).toBe(true)
  const notes = () => panel.querySelectorAll('small').map(({ title, text }) => [title, text])
  expect(notes()).toEqual([
    ['Its radius', '…'],
    ['How near it comes to a circle', '…'],
  ])
  change({ found: { largestDisc: { disc: { x: 0, y: 0, r: 1.23456 } }, path: { clearance: 7 } } as State['found'] })
  expect(notes().map(([, text]) => text)).toEqual(['1.235', '7'])
  layers({})
  expect(notes()).toEqual([])
})

it('vertices are merged up to a length, which is at first just above rounding errors', () => {
  const { panel, done, layers } = mounted()
  layers({ vertices: false })
  expect(panel.controls.has('merged up to length')).toBe(false)
  layers({ vertices: true })
  expect(panel.control('merged up to length').checked).toBe(false)
  panel.enter('merged up to length', true, ['change'])
  panel.enter('merged up to length', false, ['change'])
  layers({ vertices: true, nearZero: 0.5 })
  expect(panel.control('merged up to length').checked).toBe(true)
  const field = 'Length up to which vertices are merged'
  expect([panel.control(field).value, panel.control(field).limits]).toEqual(['0.5', ['0', null, 'any']])
  for (const text of ['0', '-1', '', '2']) panel.enter(field, text, ['change'])
  expect(done).toStrictEqual(
    [{ nearZero: 5e-8 }, { nearZero: undefined }, { nearZero: 0 }, { nearZero: 2 }].map((change) => [
      'setLayers',
      change,
    ]),
  )
})

it('the distance at which cells end grows with the square of the slider, up to a quarter of the picture', () => {
  const { panel, done, layers } = mounted()
  expect(panel.control('Cells end at a distance').checked).toBe(false)
  panel.enter('Cells end at a distance', true, ['change'])
  panel.enter('Cells end at a distance', false, ['change'])
  layers({ maxDistance: 3.125 })
  expect(panel.control('Cells end at a distance').checked).toBe(true)
  const slider = 'Distance at which cells end'
  // The picture is 50 units wide.
  expect([panel.control(slider).value, panel.control(slider).limits]).toEqual(['0.5', ['0', '1', 'any']])
  expect(panel.querySelector('output')?.text).toBe('3.13')
  panel.enter(slider, '1', ['input'])
  panel.enter(slider, '0.5', ['input'])
  expect(done).toStrictEqual([1.25, undefined, 12.5, 3.13].map((maxDistance) => ['setLayers', { maxDistance }]))
})

it('candidates are chosen without the former number of samples, all pairs only of few circles', () => {
  const { panel, done, change, layers } = mounted()
  expect(panel.controls.has('Candidates')).toBe(false)
  layers({ samples: true })
  expect(panel.control('N_s, samples inside an angle').value).toBe(String(SAMPLES.dynamic.usual))
  panel.enter('Candidates', 'uniform', ['change'])
  expect(done.pop()).toStrictEqual(['setLayers', { candidates: 'uniform', sampleCount: undefined }])
  layers({ samples: true, candidates: 'uniform', sampleCount: 7 })
  const count = panel.control('m, samples on a circle')
  expect(count.limits).toEqual([String(SAMPLES.uniform.least), String(SAMPLES.uniform.most), '1'])
  expect([count.value, panel.control('Candidates').value, panel.control('Candidates').chosen]).toEqual([
    '7',
    'uniform',
    'equally spaced samples',
  ])
  panel.enter('m, samples on a circle', '9', ['change'])
  expect(done.pop()).toStrictEqual(['setLayers', { sampleCount: 9 }])
  count.isValid = false
  panel.enter('m, samples on a circle', '-1', ['change'])
  expect(done).toStrictEqual([])
  const pairs = () => panel.querySelectorAll('option').find(({ text }) => text === 'all pairs of circles')?.disabled
  expect(pairs()).toBe(false)
  change({ edited: countsOf(MOST_PAIRED) })
  expect(pairs()).toBe(false)
  layers({ samples: true, candidates: 'all-pairs' })
  expect([...panel.controls.keys()].filter((label) => label.includes('samples on'))).toEqual([])
  expect(panel.text).toMatch(/all pairs of circles …$/)
  change({ edited: countsOf(MOST_PAIRED + 1) })
  expect(pairs()).toBe(true)
  expect(panel.text).toMatch(/All pairs of more than [\d,]+ circles are too many\.$/)
})

it('the method is for few circles, and the radii are for few without areas', () => {
  const { panel, change } = mounted()
  const has = () => [panel.controls.has('Samples'), panel.controls.has('Radii')]
  expect(has()).toEqual([true, true])
  change({ edited: countsOf(MOST_TRACED) })
  expect(has()).toEqual([true, false])
  change({ edited: countsOf(MOST_TRACED + 1) })
  expect(has()).toEqual([false, false])
  change({ edited: countsOf(2000) })
  expect(has()).toEqual([true, true])
  change({ domain: { region: undefined, areas: 'equal' } })
  expect(has()).toEqual([true, false])
})

it('radii are scaled by a slider, and animated where motion is welcome', () => {
  const { panel, done, motion, events, change, radii } = mounted()
  expect([panel.control('Radii').value, panel.control('Radii').limits]).toEqual(['0.5', ['0', '1', 'any']])
  panel.enter('Radii', '0.25', ['input'])
  panel.press('Play')
  motion.isMoving = true
  events.get('motion')?.()
  expect(panel.control('Stop').getAttribute('aria-pressed')).toBe('true')
  panel.press('Stop')
  expect(done).toStrictEqual([['scale', 0.25], ['start', 'compare'], ['stop']])
  radii.share = 0.75
  change({})
  expect(panel.control('Radii').value).toBe('0.75')
  stub.media.matches = true
  events.get('motion')?.()
  expect(panel.controls.has('Stop')).toBe(false)
})

it('is drawn again with each change that it shows, and with no other one', () => {
  const { panel, change, view, events } = mounted()
  const first = () => panel.elements[0]
  let before = first()
  const isDrawn = () => {
    const isNew = first() !== before
    before = first()
    return isNew
  }
  change({ selection: [1] })
  expect(isDrawn()).toBe(false)
  const changes: Partial<State>[] = [
    { layers: { ...DEFAULT_LAYERS, hull: true } },
    { found: {} as State['found'] },
    { edited: countsOf(9) },
    { domain: { region: undefined, areas: 'equal' } },
    { attributes: { columns: [], ids: [], heights: [], collection: '' } },
  ]
  for (const more of changes) {
    change(more)
    expect(isDrawn(), Object.keys(more).join()).toBe(true)
  }
  const says = 'The method is played: layers are seen at its end.'
  expect(panel.text).not.toContain(says)
  view.hasDiagram = false
  events.get('diagram')?.()
  expect(panel.text).toContain(says)
})
