// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of the region, the areas and the periodic box, and the share of the selected cell.
// @vitest-environment happy-dom
import { render } from 'lit/html.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { FileActions } from '../../web/app/files/file-actions.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import { mountInspectorShare } from '../../web/app/panels/inspector-share.ts'
import { mountRegion } from '../../web/app/panels/region.ts'
import type { RegionPen } from '../../web/app/region-pen.ts'
import type { State } from '../../web/editing/state.ts'
import type { Domain } from '../../web/view/domain.ts'
import {
  all,
  buttonOf,
  choose,
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
import { settled } from './turns.ts'

vi.mock('lit/html.js', { spy: true })

beforeEach(() => void openPage())
afterEach(() => vi.unstubAllGlobals())

const SQUARE = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
] as const

function mounted(domain: Partial<Domain> = {}, columns: readonly string[] = []) {
  const done: unknown[][] = []
  const { store, change } = stateOf({ domain: { region: undefined, areas: undefined, ...domain } })
  const set = (more: Partial<Domain>) => change({ domain: { ...store.get().domain, ...more } })
  /** The next change of the domain is refused. */
  const known = { columns, radii: () => [1, 2, 3], isRefused: false, missing: 0 as number | undefined }
  const give = async (name: string, more: Partial<Domain>) => {
    done.push([name, more])
    await Promise.resolve()
    if (!known.isRefused) set(more)
  }
  const actions = noting(done, {
    ...known,
    setDomain: async (more: Partial<Domain>) => give('setDomain', more),
    setAreas: async (areas: Domain['areas']) => give('setAreas', { areas }),
    setAreasBy: async (name: string) => {
      await give(`setAreasBy ${name}`, { areas: [5, 6, 7] })
      return known.missing
    },
    setLattice: async (lattice: Domain['lattice']) => give('setLattice', { lattice }),
    repeat: async () => give('repeat', { lattice: { a: [10, 0], b: [0, 10] } }),
  })
  const files = { mergesPolygons: false, openRegion: async (file: unknown) => done.push(['openRegion', file]) }
  const pen = noting(done, { count: 0 })
  mountRegion(store, actions as unknown as PageActions, files as unknown as FileActions, pen as unknown as RegionPen)
  buttonOf('region').click()
  const panel = element('region')
  const says = () => all(panel, 'p').map(textOf)
  return { panel, done, change, set, known, files, pen, says, store }
}

const AREAS = 'Areas'
const MERGE = 'Merge polygons that share borders or overlap'
const REPEAT = 'Repeat the circles in a box'

describe('the panel of the region', () => {
  it('says what the region is: outlines and sides, without the point that closes a ring', () => {
    const { says, set } = mounted()
    expect(says()[0]).toBe('Clip the cells to a country, a hall with pillars, or any polygon.')
    set({ region: [SQUARE] })
    expect(says()[0]).toBe('One outline with 4 sides. Cells, areas and files are clipped to it.')
    set({ region: [[...SQUARE, [0, 0]], SQUARE.slice(1)] })
    expect(says()[0]).toBe('2 outlines with 7 sides. Cells, areas and files are clipped to it.')
  })

  it('draws: begins, closes from three corners on, takes corners back, and cancels', () => {
    const { panel, done, change, pen, says } = mounted()
    press(panel, 'Draw')
    expect(done).toStrictEqual([['useTool', 'draw']])
    expect(document.activeElement).toBe(element('figure'))
    change({ tool: 'draw' })
    expect(says()[1]).toMatch(/Inside the region it becomes a hole\.$/)
    const disabled = () => ['Close polygon', 'Undo corner', 'Cancel'].map((name) => control(panel, name).disabled)
    expect(disabled()).toEqual([true, true, false])
    for (const [count, ...expected] of [
      [1, true, false],
      [2, true, false],
      [3, false, false],
    ] as const) {
      Object.assign(pen, { count })
      change({ said: { text: `${count}` } })
      expect(disabled()).toEqual([...expected, false])
    }
    done.length = 0
    for (const name of ['Close polygon', 'Undo corner', 'Cancel']) press(panel, name)
    expect(done).toStrictEqual([['close'], ['undo'], ['useTool', 'select']])
  })

  it('opens a file, the same one again too, and removes the region', async () => {
    const { panel, done, set } = mounted()
    const input = control(panel, 'Open …')
    expect(controls(panel).has('Remove region')).toBe(false)
    const file = new File([], 'a.geojson')
    choose(input, file)
    expect(input.value).toMatch(/a\.geojson$/)
    await settled()
    expect(input.value).toBe('')
    choose(input)
    await settled()
    expect(done).toStrictEqual([['openRegion', file]])
    set({ region: [SQUARE] })
    press(panel, 'Remove region')
    expect(done[1]).toStrictEqual(['removeRegion'])
    expect(controls(panel).has('Draw more')).toBe(true)
  })

  it('merges polygons that are opened, and those that are there', async () => {
    const { panel, done, set, files, change, says } = mounted()
    enter(panel, MERGE, true, ['change'])
    await settled()
    expect([files.mergesPolygons, control(panel, MERGE).checked, done]).toEqual([true, true, []])
    set({ region: [SQUARE] })
    expect(control(panel, MERGE).checked).toBe(false)
    enter(panel, MERGE, true, ['change'])
    await settled()
    expect(done).toStrictEqual([['setDomain', { region: expect.objectContaining({ dissolve: true }) }]])
    expect(control(panel, MERGE).checked).toBe(true)
    change({ tool: 'draw' })
    expect(says()[1]).toMatch(/It is merged with the region\.$/)
    enter(panel, MERGE, false, ['change'])
    await settled()
    expect([control(panel, MERGE).checked, files.mergesPolygons]).toEqual([false, false])
  })
})

describe('areas', () => {
  it.each([
    ['equal', 'setAreas', 'equal'],
    ['radius', 'setAreas', [1, 2, 3]],
    ['disc', 'setAreas', [1, 4, 9]],
    ['column:n', 'setAreasBy n', [5, 6, 7]],
  ])('are chosen by %s, shown as chosen again after undo, and not fixed any more', async (value, name, areas) => {
    const { panel, done, set, store } = mounted({ region: [SQUARE] }, ['n'])
    const labels = { equal: 'equal', radius: 'by radius', disc: 'by disc area', 'column:n': 'by n' } as const
    expect(optionsOf(control(panel, AREAS))).toEqual(['not fixed', ...Object.values(labels)])
    enter(panel, AREAS, value, ['change'])
    await settled()
    expect(done).toStrictEqual([[name, { areas }]])
    expect(chosenOf(control(panel, AREAS))).toBe(labels[value as keyof typeof labels])
    const { areas: given } = store.get().domain
    enter(panel, AREAS, 'free', ['change'])
    await settled()
    expect(done[1]).toStrictEqual(['setAreas', { areas: undefined }])
    expect(chosenOf(control(panel, AREAS))).toBe('not fixed')
    set({ areas: given })
    expect(chosenOf(control(panel, AREAS))).toBe(labels[value as keyof typeof labels])
  })

  it('of their own are a choice that changes nothing, and a refused choice is taken back', async () => {
    const { panel, done, known, set } = mounted({ region: [SQUARE], areas: [3, 2, 1] })
    expect([chosenOf(control(panel, AREAS)), optionsOf(control(panel, AREAS)).at(-1)]).toEqual([
      'one by one',
      'one by one',
    ])
    enter(panel, AREAS, 'own', ['change'])
    await settled()
    expect(done).toStrictEqual([])
    known.isRefused = true
    const select = control(panel, AREAS)
    enter(panel, AREAS, 'equal', ['change'])
    await settled()
    expect(select.value).toBe('own')
    set({ areas: undefined })
    enter(panel, AREAS, 'equal', ['change'])
    await settled()
    expect(chosenOf(control(panel, AREAS))).toBe('not fixed')
  })

  it('by a column say how many circles have no number', async () => {
    const { panel, known } = mounted({ region: [SQUARE] }, ['n'])
    for (const [missing, said] of [
      [undefined, ''],
      [0, ''],
      [1, '1 of the circles have no number in n: they get the mean.'],
    ] as const) {
      known.missing = missing
      enter(panel, AREAS, 'column:n', ['change'])
      await settled()
      expect(textOf(element('toast'))).toBe(said)
    }
    expect(textOf(panel)).toContain('but not the columns of the opened file.')
  })

  it('need a region, and say their largest error', () => {
    const { panel, set, change } = mounted()
    const said = () => textOf(element('areas-said'))
    const isDisabled = () => all(panel, 'fieldset').map(({ disabled }) => disabled)
    expect([said(), isDisabled()]).toEqual(['Areas need a region: the cells divide it.', [true, false]])
    expect(textOf(panel)).not.toContain('columns of the opened file')
    set({ region: [SQUARE] })
    expect([said(), isDisabled()]).toEqual([expect.stringMatching(/^Choose areas,/), [false, false]])
    set({ areas: 'equal' })
    expect(said()).toMatch(/Select one to change its share\.$/)
    change({ edited: { fitted: { error: 1.2e-9 } } as State['edited'] })
    expect(said()).toMatch(/ Largest error of an area: 1e-9\.$/)
  })
})

describe('the periodic box', () => {
  it('is switched on and off, and a refused one stays off', async () => {
    const { panel, done, known, says, set } = mounted()
    expect(says().at(-1)).toBe('For packings, foams and tissues in a box whose opposite sides are glued together.')
    known.isRefused = true
    const box = control(panel, REPEAT)
    enter(panel, REPEAT, true, ['change'])
    await settled()
    expect(box.checked).toBe(false)
    known.isRefused = false
    enter(panel, REPEAT, true, ['change'])
    await settled()
    expect(control(panel, REPEAT).checked).toBe(true)
    expect(says().at(-1)).toMatch(/^Opposite sides are glued together: /)
    enter(panel, REPEAT, false, ['change'])
    await settled()
    expect(done).toStrictEqual([
      ['repeat', expect.anything()],
      ['repeat', expect.anything()],
      ['setLattice', { lattice: undefined }],
    ])
    expect([...controls(panel).keys()].filter((label) => label.startsWith('Period'))).toEqual([])
    set({ region: [SQUARE] })
    expect(says().at(-1)).toMatch(/ It replaces the region\.$/)
  })

  it('has a field for each number, which changes that number alone', async () => {
    const { panel, done, known } = mounted({ lattice: { a: [1, 2], b: [3, 4] } })
    expect(control(panel, REPEAT).checked).toBe(true)
    const fields = [...controls(panel).keys()].filter((label) => label.startsWith('Period'))
    expect(fields).toEqual(['Period a, x', 'Period a, y', 'Period b, x', 'Period b, y'])
    expect(fields.map((label) => control(panel, label).value)).toEqual(['1', '2', '3', '4'])
    known.isRefused = true
    for (const label of fields) {
      const field = control(panel, label)
      enter(panel, label, '9', ['change'])
      await settled()
      expect(field.value, 'goes back').toBe(String(fields.indexOf(label) + 1))
    }
    expect(done.map(([, more]) => Object.values((more as Domain).lattice ?? {}))).toEqual([
      [
        [9, 2],
        [3, 4],
      ],
      [
        [1, 9],
        [3, 4],
      ],
      [
        [1, 2],
        [9, 4],
      ],
      [
        [1, 2],
        [3, 9],
      ],
    ])
    enter(panel, 'Period a, x', '', ['change'])
    await settled()
    expect(done).toHaveLength(4)
  })
})

it('the panel is drawn again with what it shows, and with nothing else', () => {
  const { change, set, known } = mounted()
  const { calls } = vi.mocked(render).mockClear().mock
  const isDrawn = () => calls.splice(0).length > 0
  change({ selection: [1], said: { text: 'a' }, edited: {} as State['edited'] })
  expect(isDrawn()).toBe(false)
  set({ areas: 'equal' })
  expect(isDrawn()).toBe(true)
  change({ edited: { fitted: { error: 0 } } as State['edited'] })
  expect(isDrawn()).toBe(true)
  change({ tool: 'draw' })
  expect(isDrawn()).toBe(true)
  expect(known.columns).toEqual([])
})

describe('the share of the selected cell', () => {
  function share(share: number | undefined) {
    const done: unknown[][] = []
    let gestures = 0
    const { store, change } = stateOf({ edited: { counts: { circles: 4 } } as State['edited'] })
    const radius = element<HTMLInputElement>('field-r')
    const text = radius.labels?.[0]?.firstChild as Node
    const actions = noting(done, { shareOf: () => share, beginGesture: () => ++gestures })
    mountInspectorShare(store, actions as unknown as PageActions)
    const place = element('inspector-share')
    return { done, change, place, radius, text }
  }
  const WITH_AREAS: Partial<State> = { selected: 3, domain: { region: [SQUARE], areas: 'equal' } }
  const [NUMBER, SLIDER] = ['% of the region', 'Share of the region, against the mean']

  it('is shown where areas are given and one circle is selected, and the radius is then a weight', () => {
    const { change, place, radius, text } = share(0.5)
    const isShown = () => [!place.hidden, radius.readOnly, text.textContent]
    expect(isShown()).toEqual([false, false, 'r '])
    change(WITH_AREAS)
    expect(isShown()).toEqual([true, true, 'w '])
    expect([control(place, NUMBER).value, limitsOf(control(place, NUMBER))]).toEqual(['50', ['0.0001', '99', 'any']])
    expect([control(place, SLIDER).value, limitsOf(control(place, SLIDER))]).toEqual(['1', ['-5', '5', 'any']])
    expect(textOf(place.querySelector('output'))).toBe('2.00 × mean')
    change({ selected: undefined })
    expect(isShown()).toEqual([false, false, 'r '])
    change({ selected: 3, domain: { region: [SQUARE], areas: undefined } })
    expect(isShown()).toEqual([false, false, 'r '])
  })

  it('is set by a number in percent, at most 99, and by a slider in powers of two of the mean', () => {
    const { done, change, place } = share(0.5)
    change(WITH_AREAS)
    enter(place, NUMBER, '12', ['change'])
    enter(place, NUMBER, '99', ['change'])
    enter(place, SLIDER, '-1', ['input', 'change'])
    enter(place, SLIDER, '5', ['input', 'change'])
    expect(done).toStrictEqual([
      ['setShare', 3, 0.12, 1],
      ['setShare', 3, 0.99, 2],
      ['setShare', 3, 0.125, 3],
      ['setShare', 3, 0.99, 4],
    ])
    for (const invalid of ['', '99.5', '0']) enter(place, NUMBER, invalid, ['change'])
    expect(done).toHaveLength(4)
  })

  it('of one drag of the slider is one step', () => {
    const { done, change, place } = share(0.5)
    change(WITH_AREAS)
    enter(place, SLIDER, '1', ['input', 'input', 'change', 'input'])
    expect(done.map(([, , , gesture]) => gesture)).toEqual([1, 1, 2])
  })
})
