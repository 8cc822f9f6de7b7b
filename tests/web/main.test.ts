// SPDX-License-Identifier: GPL-3.0-or-later
// The whole page from its start: what it opens and saves, its tools and its other panels.
// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { decodeLink } from '../../web/lib/link.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { all, buttonOf, control, controls, element, send, textOf } from './page-document.ts'
import { box } from './shapes.ts'
import { FIVE, quiet, soon, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
const status = () => textOf(element('status'))
const said = () => (element('say').hidden ? '' : textOf(element('say')))
const saved = () => decodeLink(location.hash.slice(1))

describe('the first scene', () => {
  beforeEach(() => {
    sessionStorage.clear()
    localStorage.clear()
  })

  it('is the first data set, which is not saved before it is changed', async () => {
    page = await wholePage('')
    await soon(() => expect([page.store.get().dataSet, status()]).toEqual(['start', expect.stringMatching(/^8 /)]))
    const first = said()
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
    expect([first, said()], 'it says what else can be done').not.toContain('')
    expect(said()).not.toBe(first)
  })

  it('is that of a link, and the first data set with the problem of a link that is refused', async () => {
    page = await wholePage({ circles: FIVE, layers: { hull: true }, step: 1 })
    expect([...page.editing.circles.circles()]).toEqual([...FIVE])
    expect([page.view.layers.hull, page.store.get().step]).toEqual([true, 1])
    page = await wholePage('v1.wrong')
    await soon(() => expect([page.store.get().dataSet, element('problem').hidden]).toEqual(['start', false]))
  })
})

describe('the tools', () => {
  beforeAll(async () => {
    page = await wholePage()
  })
  beforeEach(() => page.open(FIVE))

  it('have a second row on phones', () => {
    for (const isOpen of [true, false]) {
      element('more').click()
      expect([element('rail').classList.contains('open'), element('more').getAttribute('aria-expanded')]).toEqual([
        isOpen,
        String(isOpen),
      ])
    }
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
})

describe('what is said', () => {
  beforeAll(async () => {
    page = await wholePage()
  })

  it('is how many circles, vertices, edges and hidden circles there are, and how right areas are', async () => {
    /** The numbers before the words about the proof. */
    const numbers = () => (status()?.split('✓')[0]?.match(/\d+/g) ?? []).map(Number)
    await page.open(Float64Array.of(0, 0, 1))
    expect(numbers()).toEqual([1, 0, 0])
    await page.open(Float64Array.of(0, 0, 9, 1, 0, 1, 30, 0, 1, 60, 0, 1))
    expect(numbers()).toEqual([4, 2, 4, 1])
    await page.open(FIVE)
    await page.actions.setDomain({ region: [box(-9, -9, 30, 30)], areas: 'equal' })
    await quiet()
    expect(status()).toMatch(/ \de-\d+ /)
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
})
