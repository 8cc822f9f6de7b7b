// SPDX-License-Identifier: GPL-3.0-or-later
// The whole page from its start: what it opens and saves, its tools and its other panels.
// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { MOVEMENTS } from '../../web/app/motion/movements.ts'
import { ENGLISH_KEYS } from '../../web/editing/key-help.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { all, buttonOf, control, controls, element, press, send, textOf } from './page-document.ts'
import { box } from './shapes.ts'
import { FIVE, pressed, quiet, soon, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
const figure = () => element('figure')
const status = () => textOf(element('status'))
const said = () => (element('say').hidden ? '' : textOf(element('say')))
const saved = () => decodeLink(location.hash.slice(1))
const EIGHT = /^8 circles · \d+ vertices · \d+ edges · ✓ proven/

describe('the first scene', () => {
  beforeEach(() => {
    sessionStorage.clear()
    localStorage.clear()
  })

  it('is the first data set, which is not saved before it is changed', async () => {
    page = await wholePage('')
    await soon(() => expect([page.store.get().dataSet, status()]).toEqual(['start', expect.stringMatching(EIGHT)]))
    expect(said()).toMatch(/^Every point is colored by its nearest circle\. Drag one\..*Or open a photo\.$/)
    expect(location.hash).toBe('')
    // The circle that moves at first returns when something is pressed.
    send(document, 'pointerdown')
    await page.editing.edit([{ kind: 'remove', id: 0 }])
    await soon(async () =>
      expect(await saved()).toMatchObject({
        dataSet: 'start',
        edits: expect.arrayContaining([{ kind: 'remove', id: 0 }]),
      }),
    )
    expect(said(), 'it says what else can be done').toBe('Drag a rim to resize. Double-click to add a circle.')
  })

  it('is that of a link, and the first data set with the problem of a link that is refused', async () => {
    page = await wholePage({ circles: FIVE, layers: { hull: true }, step: 1 })
    expect([...page.editing.circles.circles()]).toEqual([...FIVE])
    expect([page.view.layers.hull, page.store.get().step]).toEqual([true, 1])
    page = await wholePage('v1.wrong')
    await soon(() => expect([page.store.get().dataSet, element('problem').hidden]).toEqual(['start', false]))
  })
})

describe('the address', () => {
  beforeAll(async () => {
    page = await wholePage()
  })

  it('is opened when it changes, and keeps the circles if it cannot be', async () => {
    location.hash = await encodeLink({ circles: [[7, 8, 9]] })
    await soon(() => expect([...page.editing.circles.circles()]).toEqual([7, 8, 9]))
    location.hash = 'v1.wrong'
    await soon(() => expect(element('problem').hidden).toBe(false))
    expect([...page.editing.circles.circles()]).toEqual([7, 8, 9])
    await soon(async () => expect([...((await saved()).circles as Float64Array)]).toEqual([7, 8, 9]))
  })

  it('has the circles, the layers, the viewport and the step that are shown', async () => {
    await page.open(FIVE)
    page.view.setLayers({ dual: true })
    page.actions.look({ x: 1, y: 2, span: 30 })
    await soon(async () =>
      expect(await saved()).toMatchObject({ layers: { dual: true }, view: { x: 1, y: 2, span: 30 } }),
    )
    page.actions.showStep(3)
    await soon(async () => expect(await saved()).toMatchObject({ step: 3 }))
    page.actions.showStep(undefined)
    await soon(async () => expect((await saved()).step).toBeUndefined())
  })
})

describe('the tools', () => {
  beforeAll(async () => {
    page = await wholePage()
  })
  beforeEach(() => page.open(FIVE))
  const tool = () => page.store.get().tool

  it.each([
    ['add', 'add'],
    ['pan', 'pan'],
    ['select', 'select'],
  ])('%s is used by its button, which is pressed then', async (id, name) => {
    element(id).click()
    await quiet()
    const isPressed = ['select', 'add', 'pan'].filter((other) => element(other).getAttribute('aria-pressed') === 'true')
    expect([tool(), isPressed]).toEqual([name, [id]])
  })

  it('undo and redo take back and repeat, where there is something', async () => {
    const enabled = () => ['undo', 'redo'].map((id) => element<HTMLButtonElement>(id).disabled).map((off) => !off)
    await page.editing.edit([{ kind: 'remove', id: 0 }])
    await quiet()
    expect(enabled()).toEqual([true, false])
    element('undo').click()
    await soon(() => expect(page.editing.circles.count).toBe(5))
    await quiet()
    expect(enabled()[1]).toBe(true)
    element('redo').click()
    await soon(() => expect(page.editing.circles.count).toBe(4))
  })

  it('zoom in and out about the middle, and show everything', async () => {
    const { camera } = page.view
    element('zoom-in').click()
    expect(page.view.camera.scale).toBeGreaterThan(camera.scale)
    element('zoom-out').click()
    expect(page.view.camera.scale).toBeCloseTo(camera.scale, 9)
    page.actions.look({ x: 900, y: 0, span: 1 })
    element('fit').click()
    expect(page.view.camera.x).toBeCloseTo(10, 0)
    expect(page.view.camera.scale).toBeLessThan(30)
  })

  it('have a second row on phones', () => {
    for (const isOpen of [true, false]) {
      element('more').click()
      expect([element('rail').classList.contains('open'), element('more').getAttribute('aria-expanded')]).toEqual([
        isOpen,
        String(isOpen),
      ])
    }
  })

  it.each([
    ['Enter', () => expect(document.activeElement).toBe(element('field-x'))],
    ['p', () => expect(tool()).toBe('draw')],
    ['?', () => soon(() => expect(element<HTMLDialogElement>('help').open).toBe(true))],
  ])('have the key %s', async (key, check) => {
    page.actions.select([1])
    await quiet()
    figure().focus()
    send(figure(), 'keydown', { key })
    send(figure(), 'keyup', { key })
    await quiet()
    await check()
    page.actions.useTool('select')
  })

  it('are explained by the help, which a click beside it closes', async () => {
    element('show-help').click()
    const dialog = element<HTMLDialogElement>('help')
    await soon(() => expect(dialog.open).toBe(true))
    const rows = all(dialog, 'dd').map((text, k) => [textOf(all(dialog, 'dt')[k]), textOf(text)])
    const { select, edit, look } = ENGLISH_KEYS
    for (const row of [select.next, select.neighbor, look.fit, ...Object.values(edit)]) expect(rows).toContainEqual(row)
    dialog.querySelector('h3')?.click()
    expect(dialog.open).toBe(true)
    dialog.click()
    expect(dialog.open).toBe(false)
  })

  it('play the chosen method from its first step, and close the player', async () => {
    const isOpen = () => [!element('player').hidden, element('method').getAttribute('aria-expanded')]
    element('method').click()
    await quiet()
    expect([page.store.get().step, isOpen()]).toEqual([0, [true, 'true']])
    await soon(() => expect(controls(element('played')).size).toBeGreaterThan(3))
    const choice = element<HTMLSelectElement>('player-method')
    expect(choice.value).toBe('touching-disc')
    choice.value = 'auto'
    send(choice, 'change')
    await quiet()
    expect(page.store.get()).toMatchObject({ step: 0, method: 'auto' })
    for (const id of ['close-player', 'method', 'method']) {
      element(id).click()
      await quiet()
    }
    expect([page.store.get().step, isOpen(), document.activeElement]).toEqual([
      undefined,
      [false, 'false'],
      element('method'),
    ])
  })
})

describe('the panels', () => {
  beforeAll(async () => {
    page = await wholePage()
  })
  beforeEach(async () => {
    page.view.setLayers(DEFAULT_LAYERS)
    await page.open(FIVE)
  })

  it('are opened by their buttons, one at a time, and closed by Escape', async () => {
    for (const id of ['generate', 'files', 'layers', 'region', 'numbers', 'table', 'motion', 'share']) {
      await page.panel(id)
      const open = all(document.body, '.panel').filter((panel) => !panel.hidden && controls(panel).has('Close'))
      expect([open.map((panel) => panel.id), buttonOf(id).getAttribute('aria-expanded')]).toEqual([[id], 'true'])
    }
    control(element('share'), 'Copy link').focus()
    send(control(element('share'), 'Copy link'), 'keydown', { key: 'Escape' })
    expect([element('share').hidden, document.activeElement]).toEqual([true, buttonOf('share')])
  })

  it('Motion moves circles until it is stopped, in one step of undo', async () => {
    const panel = await page.panel('motion')
    const checked = () => Object.values(MOVEMENTS).filter((label) => control(panel, label).checked)
    expect(checked()).toEqual(['Bounce'])
    const steps = page.store.get().history.done.length
    press(panel, 'Play')
    await soon(() => expect(page.circle(0)).not.toEqual({ x: 0, y: 0, r: 2 }))
    expect(control(panel, 'Stop').getAttribute('aria-pressed')).toBe('true')
    const label = MOVEMENTS.breathe
    control(panel, label).checked = true
    send(control(panel, label), 'change')
    await soon(() => expect(page.circle(1)?.r).not.toBe(3))
    press(panel, 'Stop')
    await quiet()
    expect([page.store.get().history.done.length - steps, checked()]).toEqual([2, [label]])
    await page.actions.undo()
    await page.actions.undo()
    expect([...page.editing.circles.circles()]).toEqual([...FIVE])
    press(panel, 'Record 6 s')
    await soon(() => expect(page.store.get().problem).not.toBe(''))
    if (controls(panel).has('Stop')) press(panel, 'Stop')
  })

  it('Numbers has the counts, the distributions and the proof, anew after an edit', async () => {
    const panel = await page.panel('numbers')
    const entries = () =>
      Object.fromEntries(all(panel, 'dt').map((name, k) => [textOf(name), textOf(all(panel, 'dd')[k])]))
    const captions = () => all(panel, 'figcaption').map(textOf)
    await soon(() =>
      expect(captions()).toEqual([
        expect.stringMatching(/^Area of the bounded cell: [\d.]+$/),
        'Neighbors: 3.20 on average',
      ]),
    )
    expect(entries()).toEqual({ Circles: '5', Hidden: '0', Vertices: '4', Edges: '8' })
    expect(textOf(panel.querySelector('.certificate'))).toMatch(/^Proven by a judge/)
    await page.editing.edit([{ kind: 'remove', id: 3 }])
    await soon(() =>
      expect([entries().Circles, captions()[1]]).toEqual(['4', expect.stringMatching(/^Neighbors: 2\.50/)]),
    )
  })

  it('Numbers computes once more by each way, and says how', async () => {
    const panel = await page.panel('numbers')
    const menu = control(panel, 'Compute once more by')
    const parts = () => all(panel, 'dt').map(textOf)
    const seen = new Set<string | undefined>()
    for (const [k, part] of [
      'Made by',
      'Antipodal discs',
      'Antipodal discs',
      'Samples',
      'Antipodal discs',
      'Made by',
    ].entries()) {
      menu.selectedIndex = k
      send(menu, 'change')
      press(panel, 'Compute')
      expect([textOf(panel)?.endsWith('Computing …'), control(panel, 'Compute').disabled]).toEqual([true, true])
      await soon(() => expect(textOf(panel)).toMatch(/This one is certified, too\.$/))
      expect(parts()).toEqual(expect.arrayContaining([part, 'Signs by doubles', 'Time in all']))
      for (const name of parts()) seen.add(name)
    }
    // A stage that takes no time is not told.
    const stages = [...seen].filter((name) => name?.startsWith('Time to '))
    expect([stages.length > 0, stages.includes('Time to total')]).toEqual([true, false])
    await page.editing.edit([{ kind: 'remove', id: 0 }])
    await quiet()
    expect(parts(), 'it was about former circles').not.toContain('Made by')
  })

  it('Table has a row for each circle, which is added and deleted', async () => {
    const panel = await page.panel('table')
    await pressed(panel, 'Add')
    await soon(() => expect(page.editing.circles.count).toBe(6))
    page.actions.select([0, 1])
    await pressed(panel, 'Delete')
    await soon(() => expect([...page.editing.circles.ids()]).toEqual([2, 3, 4, 5]))
  })
})

describe('what is said', () => {
  beforeAll(async () => {
    page = await wholePage()
  })

  it('is how many circles there are, each in one or in many', async () => {
    await page.open(Float64Array.of(0, 0, 1))
    expect(status()).toMatch(/^1 circle · 0 vertices · 0 edges · ✓ proven/)
    await page.open(Float64Array.of(0, 0, 9, 1, 0, 1, 30, 0, 1, 60, 0, 1))
    expect(status()).toMatch(/^4 circles · 2 vertices · 4 edges · 1 hidden · ✓ proven/)
    await page.open(FIVE)
    await page.actions.setDomain({
      region: [box(-9, -9, 30, 30)],
      areas: 'equal',
    })
    await quiet()
    expect(status()).toMatch(/ · areas within \de-\d+ · /)
  })

  it('is the source of a data set, for a while, and how to begin without circles', async () => {
    await page.actions.load('spruces')
    await soon(() => expect(said()).toMatch(/^Trunks of Norway spruces.*spatstat\.data$/))
    page.actions.select([0])
    await soon(() => expect(said()).toBe(''))
    await page.open(new Float64Array())
    expect(said()).toBe('No circles.Double-click to add one, or choose a data set above.')
    Object.assign(page.media, { matches: true })
    page.media.dispatchEvent(new Event('change'))
    expect(said()).toMatch(/Double-tap/)
    Object.assign(page.media, { matches: false })
  })

  it('is a problem with its remedy, until something is opened', async () => {
    await page.open(FIVE)
    const problem = element('problem')
    page.actions.complain('It broke.')
    let isDone = false
    page.actions.offer({ problem: 'It broke.', label: 'Mend', act: () => (isDone = true) })
    await quiet()
    expect([problem.hidden, textOf(problem)]).toEqual([false, 'It broke. Mend'])
    // The button keeps the focus.
    const button = control(problem, 'Mend')
    page.actions.useTool('pan')
    await quiet()
    expect(control(problem, 'Mend')).toBe(button)
    page.actions.useTool('select')
    press(problem, 'Mend')
    expect(isDone).toBe(true)
    page.actions.complain('It broke otherwise.')
    await quiet()
    expect(textOf(problem)).toBe('It broke otherwise.')
    await page.open(FIVE)
    expect(problem.hidden).toBe(true)
  })

  it('is the measure that colors cells, with its range or its categories', async () => {
    const legend = () => (element('legend').hidden ? '' : textOf(element('legend')))
    await page.open(FIVE, [{ name: 'kind', values: ['"u"', '"v"', '"u"', '"v"', '"u"'] }])
    for (const [cells, text] of [
      ['radius', /^Radius of the circle ?1.*4$/],
      ['area', /^Area of the cell/],
      ['filled', /^Share of the cell that the circle fills/],
      ['degree', /^Number of neighbors ?3 ?3 ?3 ?4|^Number of neighbors/],
      ['gap', /^Distance to the nearest circle/],
      ['index', /^Number of the circle ?0.*4$/],
      ['none', /^$/],
    ] as const) {
      page.view.setLayers({ cells, column: undefined })
      await soon(() => expect(legend()).toMatch(text))
    }
    page.actions.colorBy('kind')
    await soon(() => expect(legend()).toMatch(/^kind ?u ?v$/))
    page.view.setLayers({ cells: 'radius', column: undefined })
    await page.open(Float64Array.of(0, 0, 2, 9, 0, 2, 0, 9, 2))
    await soon(() => expect(legend()).toBe('Radius of the circle: 2 for all'))
    page.view.setLayers(DEFAULT_LAYERS)
  })

  it('is a length of the picture, and where the pointer is', async () => {
    const part = (name: string) => textOf(element('scale').querySelector(`.${name}`))
    page.view.setCamera({ x: 0, y: 0, scale: 1 })
    await quiet()
    expect([part('length'), element('scale').querySelector('path')?.getAttribute('d')]).toEqual([
      '100',
      'M1 0v6h100v-6',
    ])
    for (const [scale, text] of [
      [1, '-350, 275'],
      [20, '-17.50, 13.75'],
      [1e-20, '-3.500000e+22, 2.750000e+22'],
    ] as const) {
      page.view.setCamera({ x: 0, y: 0, scale })
      send(figure(), 'pointermove', { pointerType: 'mouse', offsetX: 50, offsetY: 25 })
      await quiet()
      expect(part('pointer')).toBe(text)
    }
    send(figure(), 'pointerleave')
    await quiet()
    expect(part('pointer')).toBe('')
  })

  it('is the name of the circle under the pointer', async () => {
    await page.open(FIVE, [{ name: 'name', values: ['"Bonn"', '', '', '', ''] }])
    const tag = element('name-tag')
    const move = async (x: number, y: number) => {
      const { x: offsetX, y: offsetY } = page.view.toScreen({ x, y })
      send(figure(), 'pointermove', { pointerType: 'mouse', offsetX, offsetY })
      await quiet()
      return [tag.hidden, textOf(tag)]
    }
    expect(await move(0, 0)).toEqual([false, 'Bonn'])
    expect(tag.style.translate).toMatch(/^[\d.]+px [\d.]+px$/)
    expect(await move(20, 0)).toEqual([true, ''])
  })

  it('is the stage of a long opening, which can be canceled', async () => {
    await page.open(FIVE)
    const progress = element('progress')
    page.actions.open(() => new Promise(() => {}))
    await soon(() => expect([progress.hidden, textOf(progress)]).toEqual([false, 'Loading …Cancel']))
    await pressed(progress, 'Cancel')
    expect([progress.hidden, textOf(element('toast'))]).toEqual([true, 'Canceled. Nothing has changed.'])
    expect([...page.editing.circles.circles()]).toEqual([...FIVE])
  })
})
