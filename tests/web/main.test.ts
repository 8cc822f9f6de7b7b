// SPDX-License-Identifier: GPL-3.0-or-later
// The whole page from its start: what it opens, saves and says.
// @vitest-environment happy-dom

import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { showStep } from '../../web/editing/state.ts'
import { decodeLink } from '../../web/lib/link.ts'
import { buttonOf, element, press, send, textOf } from './page-document.ts'
import { box } from './shapes.ts'
import { entered, FIVE, quiet, soon, wholePage } from './whole-page.ts'

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
    await soon(() =>
      expect([page.store.get().scene?.dataSet, status()]).toEqual(['start', expect.stringMatching(/^8 /)]),
    )
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
    await soon(() => expect([page.store.get().scene?.dataSet, element('problem').hidden]).toEqual(['start', false]))
  })
})

describe('circles that move by themselves', () => {
  const radii = () => [0, 1, 2, 3, 4].map((id) => page.circle(id)?.r)
  const stop = () => element<HTMLButtonElement>('stop')
  const started = async () => {
    const panel = await page.panel('motion')
    await entered(panel, 'Breathe', 'on')
    press(panel, 'Play')
    await soon(() => expect(radii()).not.toEqual([2, 3, 1, 2, 4]))
    press(panel, 'Close')
    expect([stop().hidden, buttonOf('motion').ariaPressed]).toEqual([false, 'true'])
  }
  beforeAll(async () => {
    page = await wholePage()
  })
  beforeEach(() => page.open(FIVE))

  it.each<[string, () => unknown, boolean]>([
    ['the button on the picture', () => stop().click(), false],
    ['Escape anywhere', () => send(buttonOf('files'), 'keydown', { key: 'Escape' }), false],
    ['undo, which brings them back', () => element('undo').click(), true],
    ['a method that is played', () => showStep(page.store, 0), false],
  ])('are stopped by %s', async (_, act, areBack) => {
    await started()
    act()
    await soon(() => expect(stop().hidden).toBe(true))
    await quiet()
    const now = radii()
    await quiet()
    expect([radii(), buttonOf('motion').ariaPressed]).toEqual([now, null])
    if (areBack) expect(now).toEqual([2, 3, 1, 2, 4])
    showStep(page.store, undefined)
  })
})

describe('what is said', () => {
  beforeAll(async () => {
    page = await wholePage()
  })

  it('is to screen readers once how many circles were opened, and not each step of an edit', async () => {
    const heard: (string | null)[] = []
    const hearing = new MutationObserver(() => heard.push(element('said').textContent))
    hearing.observe(element('said'), { childList: true })
    await page.open(FIVE)
    await soon(() => expect(heard).toEqual([expect.stringContaining('5 ')]))
    for (let r = 1; r < 4; r++) await page.actions.circles.edit([{ kind: 'replace', id: 3, circle: [10, 9, r] }])
    await new Promise((resolve) => setTimeout(resolve, 400))
    hearing.disconnect()
    expect(heard).toHaveLength(1)
    expect(element('status').closest('[role=status], [aria-live]')).toBeNull()
  })

  it('is how many circles, vertices, edges and hidden circles there are, and how right areas are', async () => {
    /** The numbers before the words about the proof. */
    const numbers = () => (status()?.split('✓')[0]?.match(/\d+/g) ?? []).map(Number)
    await page.open(Float64Array.of(0, 0, 1))
    expect(numbers()).toEqual([1, 0, 0])
    await page.open(Float64Array.of(0, 0, 9, 1, 0, 1, 30, 0, 1, 60, 0, 1))
    expect(numbers()).toEqual([4, 2, 4, 1])
    await page.open(FIVE)
    await page.actions.circles.setDomain({ region: [box(-9, -9, 30, 30)], areas: 'equal' })
    await quiet()
    expect(status()).toMatch(/ \de-\d+ /)
  })

  it('is how long a thousand circles or more took, which fewer circles do not tell', async () => {
    const circles = Float64Array.from({ length: 3000 }, (_, k) => (k % 3 === 2 ? 0.1 : (k * 7919) % 1009))
    await page.open(circles.slice(3))
    expect(status()).not.toMatch(/\d m?s\b/)
    await page.open(circles)
    expect(status()).toMatch(/\d m?s\b/)
  })
})
