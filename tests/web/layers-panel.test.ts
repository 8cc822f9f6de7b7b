// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of layers: each control changes its layer and no other one.
// @vitest-environment happy-dom
import { render } from 'lit/html.js'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { Motion } from '../../web/app/motion/motion.ts'
import type { Radii } from '../../web/app/motion/radii.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import { mountLayers } from '../../web/app/panels/layers.ts'
import type { State } from '../../web/editing/state.ts'
import { CELL_COLORS, DEFAULT_LAYERS, type Layers, MOST_PAIRED, MOST_TRACED, SAMPLES } from '../../web/view/layers.ts'
import type { View } from '../../web/view/view.ts'
import {
  all,
  buttonOf,
  chosenOf,
  control,
  controls,
  element,
  enter,
  limitsOf,
  noting,
  openPage,
  optionsOf,
  press,
  stateOf,
  textOf,
} from './page-document.ts'

vi.mock('lit/html.js', { spy: true })

let page: ReturnType<typeof openPage>
beforeEach(() => {
  page = openPage()
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
  const panel = element('layers')
  buttonOf('layers').click()
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
    const shown = [...controls(panel).keys()].find((other) => other.startsWith(label)) as string
    expect(control(panel, shown).checked).toBe(isOn)
    enter(panel, shown, !isOn, ['change'])
    expect(done.pop()).toStrictEqual(['setLayers', { [name]: !isOn }])
  }
})

it('colors are by a measure or by a column of the file', () => {
  const { panel, done, change, layers } = mounted()
  expect(optionsOf(control(panel, 'Colors'))).toHaveLength(CELL_COLORS.length)
  change({ attributes: { columns: [{ name: 'n', values: [] }], ids: [], heights: [], collection: '' } })
  expect(optionsOf(control(panel, 'Colors')).slice(-2)).toEqual(['neighbors differ', 'n'])
  const values = all(control(panel, 'Colors'), 'option').map(({ value }) => value)
  expect(values).toEqual([...CELL_COLORS, 'column:n'])
  enter(panel, 'Colors', 'area', ['change'])
  enter(panel, 'Colors', 'column:n', ['change'])
  expect(done).toStrictEqual([
    ['setLayers', { cells: 'area', column: undefined }],
    ['colorBy', 'n'],
  ])
  layers({ cells: 'degree' })
  expect([control(panel, 'Colors').value, chosenOf(control(panel, 'Colors'))]).toEqual(['degree', 'by neighbors'])
  layers({ cells: 'degree', column: { name: 'n', values: new Float64Array() } })
  expect([control(panel, 'Colors').value, chosenOf(control(panel, 'Colors'))]).toEqual(['column:n', 'n'])
})

it('the grid is switched together with snapping', () => {
  const { panel, done, change } = mounted()
  enter(panel, 'Axes and grid', true, ['change'])
  change({ isSnapping: true })
  enter(panel, 'Axes and grid', true, ['change'])
  enter(panel, 'Axes and grid', false, ['change'])
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
  enter(panel, 'Clearest path', true, ['change'])
  enter(panel, 'Clearest path', false, ['change'])
  expect(done).toStrictEqual([
    ['setLayers', { path }],
    ['setLayers', { path: undefined }],
  ])
  expect(control(panel, 'Clearest path').checked).toBe(false)
  layers({ path, largestDisc: true })
  expect([...controls(panel)].find(([label]) => label.startsWith('Clearest path'))?.[1].checked).toBe(true)
  const notes = () => all(panel, 'small').map((note) => [note.title, textOf(note)])
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
  expect(controls(panel).has('merged up to length')).toBe(false)
  layers({ vertices: true })
  expect(control(panel, 'merged up to length').checked).toBe(false)
  enter(panel, 'merged up to length', true, ['change'])
  enter(panel, 'merged up to length', false, ['change'])
  layers({ vertices: true, nearZero: 0.5 })
  expect(control(panel, 'merged up to length').checked).toBe(true)
  const field = 'Length up to which vertices are merged'
  expect([control(panel, field).value, limitsOf(control(panel, field))]).toEqual(['0.5', ['0', null, 'any']])
  for (const text of ['0', '-1', '', '2']) enter(panel, field, text, ['change'])
  expect(done).toStrictEqual(
    [{ nearZero: 5e-8 }, { nearZero: undefined }, { nearZero: 0 }, { nearZero: 2 }].map((change) => [
      'setLayers',
      change,
    ]),
  )
})

it('the distance at which cells end grows with the square of the slider, up to a quarter of the picture', () => {
  const { panel, done, layers } = mounted()
  expect(control(panel, 'Cells end at a distance').checked).toBe(false)
  enter(panel, 'Cells end at a distance', true, ['change'])
  enter(panel, 'Cells end at a distance', false, ['change'])
  layers({ maxDistance: 3.125 })
  expect(control(panel, 'Cells end at a distance').checked).toBe(true)
  const slider = 'Distance at which cells end'
  // The picture is 50 units wide.
  expect([control(panel, slider).value, limitsOf(control(panel, slider))]).toEqual(['0.5', ['0', '1', 'any']])
  expect(textOf(panel.querySelector('output'))).toBe('3.13')
  enter(panel, slider, '1', ['input'])
  enter(panel, slider, '0.5', ['input'])
  expect(done).toStrictEqual([1.25, undefined, 12.5, 3.13].map((maxDistance) => ['setLayers', { maxDistance }]))
})

it('candidates are chosen without the former number of samples, all pairs only of few circles', () => {
  const { panel, done, change, layers } = mounted()
  expect(controls(panel).has('Candidates')).toBe(false)
  layers({ samples: true })
  expect(control(panel, 'N_s, samples inside an angle').value).toBe(String(SAMPLES.dynamic.usual))
  enter(panel, 'Candidates', 'uniform', ['change'])
  expect(done.pop()).toStrictEqual(['setLayers', { candidates: 'uniform', sampleCount: undefined }])
  layers({ samples: true, candidates: 'uniform', sampleCount: 7 })
  const count = control(panel, 'm, samples on a circle')
  expect(limitsOf(count)).toEqual([String(SAMPLES.uniform.least), String(SAMPLES.uniform.most), '1'])
  expect([count.value, control(panel, 'Candidates').value, chosenOf(control(panel, 'Candidates'))]).toEqual([
    '7',
    'uniform',
    'equally spaced samples',
  ])
  enter(panel, 'm, samples on a circle', '9', ['change'])
  expect(done.pop()).toStrictEqual(['setLayers', { sampleCount: 9 }])
  enter(panel, 'm, samples on a circle', '-1', ['change'])
  expect(done).toStrictEqual([])
  const pairs = () => all(panel, 'option').find((option) => textOf(option) === 'all pairs of circles')?.disabled
  expect(pairs()).toBe(false)
  change({ edited: countsOf(MOST_PAIRED) })
  expect(pairs()).toBe(false)
  layers({ samples: true, candidates: 'all-pairs' })
  expect(chosenOf(control(panel, 'Candidates'))).toBe('all pairs of circles')
  expect([...controls(panel).keys()].filter((label) => label.includes('samples on'))).toEqual([])
  expect(textOf(panel)).toMatch(/all pairs of circles …$/)
  change({ edited: countsOf(MOST_PAIRED + 1) })
  expect(pairs()).toBe(true)
  expect(textOf(panel)).toMatch(/All pairs of more than [\d,]+ circles are too many\.$/)
})

it('the method is for few circles, and the radii are for few without areas', () => {
  const { panel, change } = mounted()
  const has = () => [controls(panel).has('Samples'), controls(panel).has('Radii')]
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
  expect([control(panel, 'Radii').value, limitsOf(control(panel, 'Radii'))]).toEqual(['0.5', ['0', '1', 'any']])
  enter(panel, 'Radii', '0.25', ['input'])
  press(panel, 'Play')
  motion.isMoving = true
  events.get('motion')?.()
  expect(control(panel, 'Stop').getAttribute('aria-pressed')).toBe('true')
  press(panel, 'Stop')
  expect(done).toStrictEqual([['scale', 0.25], ['start', 'compare'], ['stop']])
  radii.share = 0.75
  change({})
  expect(control(panel, 'Radii').value).toBe('0.75')
  page.media.matches = true
  events.get('motion')?.()
  expect(controls(panel).has('Stop')).toBe(false)
})

it('is drawn again with each change that it shows, and with no other one', () => {
  const { panel, change, view, events } = mounted()
  const { calls } = vi.mocked(render).mockClear().mock
  const isDrawn = () => calls.splice(0).length > 0
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
  expect(textOf(panel)).not.toContain(says)
  view.hasDiagram = false
  events.get('diagram')?.()
  expect(textOf(panel)).toContain(says)
})
