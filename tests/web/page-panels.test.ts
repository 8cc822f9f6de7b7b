// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of circles, motion, numbers and the table, the help, and the button of the method.
// @vitest-environment happy-dom
import { render } from 'lit/html.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { DATA_SETS, nameOf } from '../../web/app/data-sets.ts'
import type { FileActions } from '../../web/app/files/file-actions.ts'
import type { FilesClient } from '../../web/app/files/files-client.ts'
import type { Catalogue, Family } from '../../web/app/generators/generators.ts'
import { filmed } from '../../web/app/motion/film.ts'
import type { Motion } from '../../web/app/motion/motion.ts'
import { MOVEMENTS } from '../../web/app/motion/movements.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import { mountFiles } from '../../web/app/panels/files.ts'
import { mountGenerate } from '../../web/app/panels/generate.ts'
import { showHelp } from '../../web/app/panels/help.ts'
import { mountMethod } from '../../web/app/panels/method.ts'
import { mountMotion } from '../../web/app/panels/motion.ts'
import { mountNumbers } from '../../web/app/panels/numbers.ts'
import { mountTable } from '../../web/app/panels/table.ts'
import { mountToolbar } from '../../web/app/panels/toolbar.ts'
import { mountViewControls } from '../../web/app/panels/view-controls.ts'
import type { Editing } from '../../web/editing/editing.ts'
import { ENGLISH_KEYS } from '../../web/editing/key-help.ts'
import type { State } from '../../web/editing/state.ts'
import type { Computed, Distribution } from '../../web/view/protocol.ts'
import type { View } from '../../web/view/view.ts'
import {
  all,
  buttonOf,
  choose,
  chosenOf,
  control,
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
vi.mock('../../web/app/motion/film.ts', () => ({ filmed: vi.fn() }))
const { saved, charts, grids, world } = vi.hoisted(() => ({
  world: { isTableBroken: false },
  saved: [] as unknown[],
  charts: [] as unknown[][],
  grids: [] as unknown[][],
}))
vi.mock('../../web/app/files/saving.ts', () => ({ save: (...what: unknown[]) => saved.push(what) }))
vi.mock('../../web/app/panels/histogram.ts', () => ({
  Histogram: class {
    readonly place: unknown
    constructor(place: unknown) {
      this.place = place
      charts.push(['new'])
    }
    show(...what: unknown[]) {
      charts.push(['show', ...what])
    }
    dispose() {
      charts.push(['dispose'])
    }
  },
}))
vi.mock('../../web/app/table/circle-grid.ts', () => ({
  CircleGrid: class {
    constructor(place: unknown) {
      if (world.isTableBroken) throw new Error('broken')
      grids.push(['new', place])
    }
    update(state: unknown) {
      grids.push(['update', state])
    }
    dispose() {
      grids.push(['dispose'])
    }
  },
}))

beforeEach(() => {
  openPage()
  for (const list of [saved, charts, grids]) list.length = 0
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.useRealTimers()
})

/** Waits for modules that panels import. */
const imported = () => vi.dynamicImportSettled()

describe('the panel of circles', () => {
  const family = (name: string, isDisjoint: boolean, isDegenerate: boolean) =>
    ({ name, description: `about ${name}`, isDisjoint, isDegenerate, sample: Float64Array.of(0, 0, 1) }) as Family
  const CATALOGUE = {
    families: [
      family('uniform', true, false),
      family('dense', false, false),
      family('grid', true, true),
      family('rings', false, true),
    ],
    figures: [{ name: '3', description: 'about 3', sample: Float64Array.of(0, 0, 1) }],
  } as unknown as Catalogue

  function mounted(call: () => Promise<Catalogue> = async () => CATALOGUE) {
    const done: unknown[][] = []
    const actions = noting(done, {})
    const files = { call }
    const generate = mountGenerate(actions as unknown as PageActions, files as unknown as FilesClient)
    const panel = element('generate')
    const listed = () =>
      all(panel, 'ul').map((list) => [
        list.getAttribute('aria-label'),
        all(list, 'button').map((button) => button.getAttribute('data-name')),
      ])
    const button = (name: string) =>
      all(panel, 'button').find((other) => other.getAttribute('data-name') === name) as HTMLElement
    const isShown = () =>
      all(panel, 'button')
        .filter((other) => other.getAttribute('aria-current') === 'true')
        .map((other) => other.getAttribute('data-name'))
    return { done, generate, panel, listed, button, isShown }
  }

  it('lists prepared circles, families by their kind, and figures, and opens each', async () => {
    const { done, generate, panel, listed, button } = mounted()
    generate.open()
    expect(textOf(panel)).toContain('Loading …')
    await imported()
    await settled()
    const prepared = DATA_SETS.filter(({ random }) => random === undefined).map(({ id }) => id)
    expect(listed()).toEqual([
      ['Prepared circles', prepared],
      ['Apart', ['uniform']],
      ['Overlapping', ['dense']],
      ['In special position', ['grid', 'rings']],
      ['Figures of the paper', ['3']],
    ])
    for (const { id, label, about, credit = '' } of DATA_SETS.filter(({ id }) => prepared.includes(id))) {
      expect(textOf(button(id))).toBe(`${label}${about}${credit}`)
    }
    expect(textOf(button('3'))).toBe('Figure 3about 3')
    for (const name of ['spruces', 'grid', '3']) button(name).click()
    expect(done).toEqual([
      ['load', 'spruces'],
      ['generate', { kind: 'family', family: 'grid', seed: 1, count: 300 }],
      ['generate', { kind: 'figure', figure: '3' }],
    ])
  })

  it('marks the circles that are shown, and has their number and seed', async () => {
    const { generate, panel, isShown } = mounted()
    generate.open()
    await imported()
    await settled()
    const fields = () => ['n', 'seed'].map((label) => control(panel, label).value)
    for (const [name, shown, ...values] of [
      ['spruces', 'spruces', '300', '1'],
      [nameOf({ kind: 'family', family: 'dense', seed: 7, count: 50 }), 'dense', '50', '7'],
      [nameOf({ kind: 'figure', figure: '3' }), '3', '50', '7'],
    ] as const) {
      generate.show(name)
      expect([isShown(), fields()]).toEqual([[shown], values])
    }
    vi.mocked(render).mockClear()
    generate.show('figure-3')
    expect(render, 'nothing has changed').not.toHaveBeenCalled()
  })

  it('generates the family that is shown again where its number or its seed is changed', () => {
    const { done, generate, panel } = mounted()
    generate.open()
    enter(panel, 'n', '9', ['change'])
    vi.spyOn(Math, 'random').mockReturnValueOnce(0.25)
    press(panel, 'Another seed')
    expect([done, control(panel, 'seed').value]).toEqual([[], '250000'])
    generate.show('dense:5:9')
    enter(panel, 'n', '8', ['change'])
    enter(panel, 'seed', '6', ['change'])
    press(panel, 'Another seed')
    const recipe = { kind: 'family', family: 'dense' }
    expect(done).toEqual([
      ['generate', { ...recipe, seed: 5, count: 8 }],
      ['generate', { ...recipe, seed: 6, count: 8 }],
      ['generate', { ...recipe, seed: expect.any(Number), count: 8 }],
    ])
    enter(panel, 'n', '-1', ['change'])
    expect(done).toHaveLength(3)
    expect(limitsOf(control(panel, 'n'))).toEqual(['1', '1000000', '1'])
    expect(limitsOf(control(panel, 'seed'))).toEqual(['0', String(Number.MAX_SAFE_INTEGER), '1'])
  })

  it('says that the lists were not loaded, and loads them when it is opened again', async () => {
    let call = () => Promise.reject<Catalogue>(new Error('no network'))
    const { generate, panel, listed } = mounted(() => call())
    generate.open()
    await imported()
    await settled()
    expect(textOf(panel.querySelector('.quiet'))).toBe('no network')
    call = async () => CATALOGUE
    press(panel, 'Close')
    generate.open()
    await imported()
    await settled()
    expect(listed()).toHaveLength(5)
  })

  it('has the focus at its first control when it is opened from the menu', () => {
    const { generate } = mounted()
    generate.open()
    expect((document.activeElement as HTMLElement).getAttribute('data-name')).toBe('start')
  })
})

describe('the panel of motion', () => {
  function mounted() {
    const done: unknown[][] = []
    let change = () => {}
    const known = {
      isMoving: false,
      onchange: (act: () => void) => {
        change = act
      },
      start: (name: string) => {
        done.push(['start', name])
        known.isMoving = true
        change()
      },
      stop: () => {
        done.push(['stop'])
        known.isMoving = false
        change()
      },
    }
    const view = { stream: () => 'stream' }
    mountMotion(known as unknown as Motion, view as unknown as View, noting(done, {}) as unknown as PageActions)
    buttonOf('motion').click()
    return { done, panel: element('motion') }
  }

  it('plays and stops the chosen animation, and changes it while it plays', () => {
    const { done, panel } = mounted()
    const checked = () => Object.values(MOVEMENTS).filter((label) => control(panel, label).checked)
    expect(checked()).toEqual(['Bounce'])
    enter(panel, 'Breathe', true, ['change'])
    expect([checked(), done]).toEqual([['Breathe'], []])
    expect(textOf(panel)).toContain('Each circle grows and shrinks at its own time.')
    press(panel, 'Play')
    expect(control(panel, 'Stop').getAttribute('aria-pressed')).toBe('true')
    enter(panel, 'Grow from points', true, ['change'])
    press(panel, 'Stop')
    expect(control(panel, 'Play').getAttribute('aria-pressed')).toBe('false')
    expect(done).toEqual([['start', 'breathe'], ['start', 'grow'], ['stop']])
  })

  it('records one video at a time of what moves, and says what went wrong', async () => {
    const { done, panel } = mounted()
    let end: (film: object) => void = () => {}
    let fail: (error: Error) => void = () => {}
    vi.mocked(filmed).mockImplementation(
      () =>
        new Promise((resolve, reject) => {
          end = resolve as typeof end
          fail = reject
        }),
    )
    press(panel, 'Record 6 s')
    expect(done).toEqual([['start', 'bounce']])
    expect(vi.mocked(filmed).mock.lastCall).toEqual(['stream', 6])
    expect(control(panel, 'Recording …').disabled).toBe(true)
    end({ film: 'film', ending: '.mp4' })
    await settled()
    expect(saved).toEqual([['film', 'circles-bounce.mp4']])
    press(panel, 'Record 6 s')
    fail(new Error('no video'))
    await settled()
    expect(done).toEqual([
      ['start', 'bounce'],
      ['complain', 'no video'],
    ])
    expect(control(panel, 'Record 6 s').disabled).toBe(false)
  })
})

describe('the panel of numbers', () => {
  const DISTRIBUTION: Distribution = {
    certificate: { certified: true, message: '' },
    medianArea: 1.5,
    areas: Int32Array.of(3, 0, 2),
    areaStep: 0.5,
    degrees: Int32Array.of(0, 0, 1, 3),
  } as unknown as Distribution
  const STATS = {
    way: 'flip',
    counts: {
      samples: 0,
      antipodalDiscs: 1,
      threeTouchDiscs: 2,
      flips: 3,
      repairs: 4,
      filtered: 5,
      refined: 6,
      exact: 7,
      inCircle: 8,
    },
    seconds: { total: 0.25, order: 0.0012, judge: 0 },
  }
  const editedOf = (circles: number) =>
    ({ counts: { circles, hidden: 1, vertices: 3, edges: 4000 } }) as State['edited']

  function mounted() {
    vi.useFakeTimers()
    const asked: unknown[][] = []
    const answers: ((answer: unknown) => void)[] = []
    const view = {
      ask: (...what: unknown[]) => {
        asked.push(what)
        return new Promise((resolve) => answers.push(resolve))
      },
    }
    const { store, change } = stateOf({ edited: editedOf(2) })
    mountNumbers(store, view as unknown as View)
    const panel = element('numbers')
    const answer = async (value: unknown) => {
      answers.shift()?.(value)
      await settled()
      await imported()
      await settled()
    }
    const entries = () =>
      Object.fromEntries(all(panel, 'dt').map((name, k) => [textOf(name), textOf(all(panel, 'dd')[k])]))
    const toggle = () => buttonOf('numbers').click()
    return { change, panel, asked, answers, answer, entries, toggle }
  }

  it('has the counts, and measures after a pause while it is open', async () => {
    const { change, panel, asked, answer, entries, toggle } = mounted()
    vi.runAllTimers()
    change({ edited: editedOf(3) })
    vi.runAllTimers()
    expect(asked, 'closed').toEqual([])
    toggle()
    expect(entries()).toEqual({ Circles: '3', Hidden: '1', Vertices: '3', Edges: '4,000' })
    expect(textOf(panel)).toContain('Counting …')
    vi.advanceTimersByTime(249)
    change({ edited: editedOf(4) })
    vi.advanceTimersByTime(249)
    expect(asked).toEqual([])
    vi.advanceTimersByTime(1)
    expect(asked).toEqual([['measure']])
    await answer(DISTRIBUTION)
    expect(textOf(panel)).not.toContain('Counting …')
    change({ selection: [1] })
    vi.runAllTimers()
    expect(asked).toHaveLength(1)
    change({ edited: editedOf(5) })
    expect(textOf(panel)).toContain('Counting …')
    toggle()
    toggle()
    vi.runAllTimers()
    expect(asked).toHaveLength(2)
  })

  it('draws the distributions, in new charts after each change', async () => {
    const { panel, change, answer, toggle } = mounted()
    toggle()
    vi.runAllTimers()
    await answer(DISTRIBUTION)
    expect(charts).toEqual([
      ['new'],
      ['new'],
      ['show', DISTRIBUTION.areas, 0.5, 0],
      ['show', DISTRIBUTION.degrees, 1, -0.5],
    ])
    expect(all(panel, 'figcaption').map(textOf)).toEqual([
      'Areas of bounded cells: half are below 1.5; the last bar: above 1',
      'Neighbors: 2.75 on average',
    ])
    charts.length = 0
    change({ edited: editedOf(9) })
    expect(charts).toEqual([['dispose'], ['dispose']])
    vi.runAllTimers()
    await answer({
      ...DISTRIBUTION,
      areas: Int32Array.of(1),
      degrees: Int32Array.of(),
      certificate: { certified: false, message: 'a disc.' },
    })
    expect(all(panel, 'figcaption').map(textOf)).toEqual([
      'Area of the bounded cell: 1.5',
      'Neighbors: 0.00 on average',
    ])
    expect(textOf(panel.querySelector('.certificate'))).toBe('Not proven: a disc.')
    vi.advanceTimersByTime(0)
    charts.length = 0
    toggle()
    expect(charts).toEqual([['dispose'], ['dispose']])
  })

  it('drops an answer about former circles, and none', async () => {
    const { change, panel, answer, answers, toggle } = mounted()
    toggle()
    vi.runAllTimers()
    change({ edited: editedOf(5) })
    await answer(DISTRIBUTION)
    expect(textOf(panel)).toContain('Counting …')
    vi.runAllTimers()
    expect(answers).toHaveLength(1)
    await answer(undefined)
    expect(textOf(panel)).toContain('Counting …')
  })

  it('computes once more by the chosen way, and says how', async () => {
    const { change, panel, asked, answer, entries, toggle } = mounted()
    toggle()
    const ways = [
      {},
      { method: 'touching-disc' },
      { method: 'touching-disc', resample: true },
      { method: 'touching-disc', candidates: 'uniform' },
      { method: 'touching-disc', candidates: 'all-pairs' },
      { method: 'flip' },
    ]
    press(panel, 'Compute')
    expect(asked.pop()).toEqual(['compute', {}])
    await answer(undefined)
    for (const [selectedIndex, options] of ways.entries()) {
      const menu = control(panel, 'Compute once more by')
      menu.selectedIndex = selectedIndex
      menu.dispatchEvent(new Event('change'))
      press(panel, 'Compute')
      expect([asked.pop(), control(panel, 'Compute').disabled]).toEqual([['compute', options], true])
      expect(textOf(panel)).toMatch(/Computing …$/)
      toggle()
      toggle()
      expect(control(panel, 'Compute once more by').selectedIndex).toBe(selectedIndex)
      await answer({ stats: STATS, certificate: { certified: true, message: '' } } as unknown as Computed)
      expect(control(panel, 'Compute').disabled).toBe(false)
    }
    expect(entries()).toMatchObject({
      'Made by': 'flip',
      'Antipodal discs': '1',
      'Three-touch discs': '2',
      Flips: '3',
      Repairs: '4',
      'Signs by doubles': '5',
      'by twice the digits': '6',
      'by exact numbers': '15',
      'Time to order': '1.20 ms',
      'Time in all': '250 ms',
    })
    expect(Object.keys(entries())).not.toContain('Samples')
    expect(Object.keys(entries())).not.toContain('Time to judge')
    expect(textOf(panel)).toMatch(/This one is certified, too\.$/)
    press(panel, 'Compute')
    await answer({ stats: STATS, certificate: { certified: false, message: 'an edge.' } })
    expect(textOf(panel)).toMatch(/This one is wrong: an edge\.$/)
    press(panel, 'Compute')
    await answer({ problem: 'It failed.' })
    expect(textOf(panel.querySelector('.wrong'))).toBe('It failed.')
    change({ edited: editedOf(6) })
    expect(panel.querySelector('.wrong')).toBeNull()
    press(panel, 'Compute')
    change({ edited: editedOf(7) })
    await answer({ problem: 'It failed.' })
    expect(panel.querySelector('.wrong'), 'of former circles').toBeNull()
  })
})

describe('the panel of the table', () => {
  it('makes a table when it opens, updates it, and makes another one for other columns', async () => {
    const done: unknown[][] = []
    const { store, change } = stateOf()
    const actions = noting(done, {}) as unknown as PageActions
    mountTable(store, {} as Editing, actions, {} as View)
    const panel = element('table')
    change({ selection: [1] })
    expect(grids).toEqual([])
    buttonOf('table').click()
    await imported()
    await settled()
    expect(grids).toEqual([['new', element('circle-grid')]])
    change({ selection: [2] })
    expect(grids.splice(0)[1]).toEqual(['update', store.get()])
    const columns = (values: string[]) => ({ columns: [{ name: 'n', values }], ids: [], heights: [], collection: '' })
    for (const values of [['1'], ['"a"']]) {
      change({ attributes: columns(values) })
      await imported()
      await settled()
      expect(grids.splice(0).map(([name]) => name)).toEqual(['dispose', 'new'])
    }
    change({ attributes: columns(['"b"']) })
    expect(grids.splice(0).map(([name]) => name)).toEqual(['update'])
    for (const label of ['Add', 'Delete']) press(panel, label)
    expect(done).toEqual([['addInRoom'], ['removeSelected']])
    buttonOf('table').click()
    expect(grids).toEqual([['dispose']])
    change({ selection: [] })
    expect(grids).toHaveLength(1)
  })

  it('says that the table was not loaded', async () => {
    world.isTableBroken = true
    mountTable(stateOf().store, {} as Editing, noting([], {}) as unknown as PageActions, {} as View)
    buttonOf('table').click()
    await imported()
    await settled()
    world.isTableBroken = false
    expect(textOf(element('table'))).toMatch(/The table could not be loaded\.$/)
  })
})

describe('the panel for files', () => {
  function mounted() {
    const done: unknown[][] = []
    const actions = noting(done, { openFile: async (file: unknown) => done.push(['openFile', file]) })
    mountFiles(actions as unknown as FileActions)
    buttonOf('files').click()
    return { done, panel: element('files') }
  }

  it('opens a file, the same one again too', async () => {
    const { done, panel } = mounted()
    const input = control(panel, 'Open …')
    expect(input.getAttribute('accept')).toBe('.csv,.tsv,.txt,.json,.geojson,.wkt,.svg,image/*')
    const file = new File([], 'a.csv')
    for (const files of [[file], []]) {
      choose(input, ...files)
      await settled()
      expect(input.value).toBe('')
    }
    expect(done).toEqual([['openFile', file]])
  })

  it('saves the picture of a part, as large as it is said, and the data', () => {
    const { done, panel } = mounted()
    const save = (...labels: string[]) => {
      for (const label of labels) press(panel, label)
      return done.splice(0)
    }
    expect(optionsOf(control(panel, 'What the picture shows'))).toEqual(['what you see', 'all circles'])
    expect(save('SVG', 'Poster, A3', 'PNG')).toEqual([
      ['saveDrawing', 'seen'],
      ['savePoster', 'seen'],
      ['savePicture', 'seen', 2],
    ])
    enter(panel, 'What the picture shows', 'all', ['change'])
    enter(panel, '× its size', '3.5', ['change'])
    expect(save('SVG', 'Poster, A3', 'PNG')).toEqual([
      ['saveDrawing', 'all'],
      ['savePoster', 'all'],
      ['savePicture', 'all', 3.5],
    ])
    for (let k = 0; k < 2; k++) buttonOf('files').click()
    expect(chosenOf(control(panel, 'What the picture shows'))).toBe('all circles')
    const field = control(panel, '× its size')
    expect(field.value).toBe('3.5')
    expect(limitsOf(field)).toEqual(['0.1', null, 'any'])
    enter(panel, '× its size', '0', ['change'])
    expect([field.value, save('PNG')]).toEqual(['3.5', [['savePicture', 'all', 3.5]]])
    expect(save('CSV', 'JSON', 'GeoJSON', 'Cells').map(([, format]) => format)).toEqual([
      'csv',
      'json',
      'geojson',
      'cells',
    ])
  })
})

describe('the menu of circles', () => {
  function mounted() {
    const { store, change } = stateOf()
    mountToolbar(store, noting([], {}) as unknown as PageActions, () => {})
    const menu = element<HTMLSelectElement>('data-set')
    const own = all(menu, 'option')[0] as HTMLElement
    const history = (kind?: string) =>
      ({ done: kind === undefined ? [] : [{ kind }], undone: [] }) as unknown as State['history']
    return { change, menu, own, history, again: element('again') }
  }

  it('has the open circles, and says whether they are edited', () => {
    const { change, menu, own, history } = mounted()
    expect([optionsOf(menu), own.hidden]).toEqual([
      ['Your circles', ...DATA_SETS.map(({ label }) => label), 'More …'],
      true,
    ])
    const shown = (dataSet: string, kind?: string, circles = 8) => {
      change({ dataSet, history: history(kind), edited: { counts: { circles } } as State['edited'] })
      return [menu.value, textOf(own)]
    }
    expect(shown('spruces')).toEqual(['spruces', 'Spruces'])
    expect(shown('spruces', 'opening')).toEqual(['spruces', 'Spruces'])
    expect(shown('spruces', 'edits')).toEqual(['', 'Spruces, edited'])
    expect(shown('dense:7:300')).toEqual(['random', 'dense, 300'])
    expect(shown('dense:7:50')).toEqual(['', 'dense, 50'])
    expect(shown('')).toEqual(['', 'Your circles'])
    expect(shown('', 'edits')).toEqual(['', 'Your circles'])
    expect(shown('spruces', 'edits', 0)).toEqual(['', 'No circles'])
  })

  it('offers other random circles for families alone', () => {
    const { change, again } = mounted()
    const isOffered = (dataSet: string) => {
      change({ dataSet })
      return !again.hidden
    }
    expect(['dense:7:50', 'spruces', 'figure-3', ''].map(isOffered)).toEqual([true, false, false, false])
  })

  it('has a second row of tools on phones', () => {
    mounted()
    const [more, rail] = [element('more'), element('rail')]
    for (const isOpen of [true, false]) {
      more.click()
      expect([rail.classList.contains('open'), more.getAttribute('aria-expanded')]).toEqual([isOpen, String(isOpen)])
    }
  })
})

it('the help has the shortcuts of figures and of the page, and is closed by a click beside it', () => {
  const dialog = element<HTMLDialogElement>('help')
  element<HTMLAnchorElement>('source').href = 'https://source.example/'
  showHelp()
  expect(dialog.open).toBe(true)
  expect(all(dialog, 'h3').map(textOf)).toEqual(['Look', 'Select', 'Tools', 'Edit'])
  const rows = all(dialog, 'dd').map((text, k) => [textOf(all(dialog, 'dt')[k]), textOf(text)])
  const { select, edit, look } = ENGLISH_KEYS
  for (const row of [select.next, select.neighbor, select.all, select.zoom, look.fit, ...Object.values(edit)]) {
    expect(rows).toContainEqual(row)
  }
  expect(rows).toContainEqual(['wheel, pinch, + −', 'zoom'])
  expect(all(dialog).map((element) => element.getAttribute('href'))).toContain('https://source.example/')
  dialog.querySelector('h3')?.click()
  expect(dialog.open).toBe(true)
  dialog.click()
  expect(dialog.open).toBe(false)
})

describe('the button of the method', () => {
  function mounted() {
    const done: unknown[][] = []
    const { store, change } = stateOf()
    const choice = element<HTMLSelectElement>('player-method')
    const played = mountMethod(store, noting(done, {}) as unknown as PageActions)
    const [button, player] = [element('method'), element('player')]
    return { done, change, choice, played, button, player }
  }

  it('opens the player at its first step, and closes it', () => {
    const { done, change, button, player } = mounted()
    expect([player.hidden, button.getAttribute('aria-expanded')]).toEqual([true, 'false'])
    button.click()
    change({ step: 0 })
    expect([player.hidden, button.getAttribute('aria-expanded')]).toEqual([false, 'true'])
    button.click()
    expect(document.activeElement).toBe(button)
    element('close-player').click()
    expect(done).toEqual([
      ['showStep', 0],
      ['showStep', undefined],
      ['showStep', undefined],
    ])
  })

  it('plays the method of the menu, and for an unknown one of a link the first', () => {
    const { done, choice, played } = mounted()
    choice.value = 'auto'
    choice.dispatchEvent(new Event('change'))
    expect(done).toEqual([['showStep', 0, 'auto']])
    for (const kept of [undefined, 'auto', 'unknown']) {
      const method = kept === 'auto' ? kept : 'touching-disc'
      expect([played(kept), choice.value]).toEqual([{ method }, method])
    }
  })
})

it('the buttons beside the picture zoom in and out and show everything', () => {
  const done: unknown[][] = []
  mountViewControls(noting(done, {}) as unknown as PageActions)
  for (const id of ['zoom-in', 'zoom-out', 'fit']) element(id).click()
  expect(done).toEqual([['zoomAtMiddle', 1], ['zoomAtMiddle', -1], ['fit']])
})
