// SPDX-License-Identifier: GPL-3.0-or-later
// The cards of the selection, the menu and the clipboard on the whole page: what is done there, and the circles afterwards.
// @vitest-environment happy-dom

import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { nameIn } from '../../web/editing/identity.ts'
import { all, control, controls, element, send, textOf } from './page-document.ts'
import { entered, FIVE, pressed, quiet, soon, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
const card = () => element('inspector')
const ids = () => [...page.editing.circles.ids()]
const selection = () => page.store.get().selection
const COLUMNS = [
  { name: 'name', values: ['"Aa"', '"Bb"', '', '"Dd"', ''] },
  { name: 'n', values: ['7', '"x"', '', '4', '5'] },
]

beforeAll(async () => {
  page = await wholePage()
})
beforeEach(async () => {
  await page.open(FIVE, COLUMNS)
})

async function select(...chosen: number[]) {
  page.actions.selection.select(chosen)
  // The cards are loaded with the first selection.
  const shown = element(chosen.length > 1 ? 'group' : 'inspector')
  await soon(() => expect(shown.hidden).toBe(chosen.length === 0))
  await quiet()
}

/** Does something, and expects that one step of undo takes it back. */
async function expectOneStep(act: () => Promise<unknown>) {
  const before = page.editing.circles.circles()
  const steps = page.store.get().history.done.length
  await act()
  await quiet()
  expect(page.store.get().history.done).toHaveLength(steps + 1)
  await page.actions.circles.undo()
  await quiet()
  expect(page.editing.circles.circles()).toEqual(before)
}

describe('the card of the selected circle', () => {
  beforeEach(() => select(3))

  it.each([
    ['x', '12', { x: 12, y: 9, r: 2 }],
    ['y', '-3.5', { x: 10, y: -3.5, r: 2 }],
    ['r', '0', { x: 10, y: 9, r: 0 }],
  ])('sets %s by its field in one step', async (label, value, expected) => {
    await expectOneStep(async () => {
      await entered(card(), label, value)
      expect(page.circle(3)).toEqual(expected)
      expect(control(card(), label).title).toBe(String(Number(value)))
      send(control(card(), label), 'blur')
    })
    expect(control(card(), label).value).toBe(String({ x: 10, y: 9, r: 2 }[label as 'x']))
  })

  it('never shows the cell of one circle beside the numbers of another', async () => {
    const cell = () =>
      [element('inspector-cell'), element('inspector-facts'), element('inspector-neighbors')].map(textOf)
    await select(0)
    const ofFirst = cell()
    await select(3)
    expect(cell()).not.toEqual(ofFirst)
    page.actions.selection.select([0])
    for (let frame = 0; frame < 200 && cell()[0] !== ofFirst[0]; frame++) {
      await new Promise((resolve) => requestAnimationFrame(resolve))
      const isOfFirst = card().classList.contains('awaiting') || cell().join() === ofFirst.join()
      expect([control(card(), 'x').value, isOfFirst]).toEqual(['0', true])
    }
    expect(cell()).toEqual(ofFirst)
  })

  it('has at most 500 neighbors', async () => {
    const around = (count: number) => {
      const angles = Array.from({ length: count }, (_, k) => (2 * Math.PI * k) / count)
      return Float64Array.from([
        0,
        0,
        90,
        ...angles.flatMap((angle) => [100 * Math.cos(angle), 100 * Math.sin(angle), 0.1]),
      ])
    }
    await page.open(around(502))
    await select(0)
    const chips = element('inspector-neighbors')
    await soon(() => expect(controls(chips).size).toBe(500))
    expect(textOf(chips.lastElementChild)).toBe('and 2 more')
  })

  it('acts on its circle by its buttons', async () => {
    const { camera } = page.view
    await pressed(card(), 'Zoom to')
    expect(page.view.camera.scale).toBeGreaterThan(camera.scale)
    await expectOneStep(async () => {
      await pressed(card(), 'Duplicate')
      expect([ids(), selection(), document.activeElement]).toEqual([[0, 1, 2, 3, 4, 5], [5], element('figure')])
      expect(page.circle(5)?.r).toBe(2)
    })
    await select(3)
    await expectOneStep(async () => {
      await pressed(card(), 'Delete')
      expect(ids()).toEqual([0, 1, 2, 4])
    })
  })
})

describe('the name of the selected circle', () => {
  const name = () => control(card(), 'Name')
  const type = (text: string) => {
    name().value = text
    send(name(), 'input')
  }
  const named = () => [0, 1, 2, 3, 4].map((id) => nameIn(page.editing.attributes, id))

  it('is given to the circle for which it was begun, also if another one is selected meanwhile', async () => {
    await select(2)
    type('Second')
    await page.editing.edit([{ kind: 'replace', id: 2, circle: { x: 21, y: 20, r: 1 } }])
    await quiet()
    expect(name().value, 'it stays while the circle moves').toBe('Second')
    page.actions.selection.select([4])
    send(name(), 'change')
    await quiet()
    expect([named()[2], named()[4], name().value]).toEqual(['Second', '', ''])
  })
})

describe('the color of the selection', () => {
  it('is shown where all have it, and several colors are none', async () => {
    const field = () => control(element('group'), 'Color')
    await select(1, 2)
    expect([field().className, field().value]).not.toContain('#000000')
    expect(field().className).toBe('mixed')
    await page.actions.identity.setColor([1, 2], '#123456')
    await select(1, 2)
    expect([field().className, field().value]).toEqual(['', '#123456'])
    await page.actions.identity.setColor([2], '#654321')
    await select(1, 2)
    expect(field().className).toBe('mixed')
  })

  it('of several circles is set on their card', async () => {
    const group = element('group')
    await select(1, 4)
    expect([group.hidden, card().hidden, textOf(group.querySelector('h2'))]).toEqual([false, true, '2 circles'])
    await expectOneStep(() => entered(group, 'Color', '#abcdef'))
    await page.actions.circles.redo()
    expect([0, 1, 4].map((id) => page.actions.identity.ownColorOf(id))).toEqual([undefined, '#abcdef', '#abcdef'])
    await expectOneStep(() => pressed(group, 'Automatic color'))
    await expectOneStep(() => pressed(group, 'Duplicate'))
    await select(1, 4)
    await expectOneStep(() => pressed(group, 'Delete'))
    await select(1, 4)
    await pressed(group, 'Deselect')
    expect([selection(), group.hidden]).toEqual([[], true])
    await select(1)
    expect(group.hidden).toBe(true)
  })
})

describe('the menu', () => {
  const menu = () => element('menu')
  const labels = () => all(menu(), 'span').map(textOf)
  const figure = () => element('figure')
  const pick = async (label: string) => {
    all(menu(), 'button')[labels().indexOf(label)]?.click()
    await quiet()
  }
  async function openAt(point: { readonly x: number; readonly y: number }, pressedBy = 'mouse') {
    menu().style.left = ''
    Object.assign(menu(), { showPopover() {}, hidePopover() {} })
    const { x: offsetX, y: offsetY } = page.view.toScreen(point)
    send(figure(), 'pointerdown', { pointerType: pressedBy, button: 2, pointerId: 1, offsetX, offsetY })
    const event = send(figure(), 'contextmenu', { offsetX, offsetY })
    if (event.defaultPrevented) await soon(() => expect(menu().style.left).not.toBe(''))
    await quiet()
    return event.defaultPrevented
  }

  it('of a circle selects it, unless it is selected with others, of which it has no name', async () => {
    await openAt({ x: 10, y: 9 })
    const ofOne = labels()
    expect(selection()).toEqual([3])
    await select(1, 3)
    await openAt({ x: 20, y: 0 })
    expect([selection(), labels()]).toEqual([[1, 3], ofOne.slice(1)])
    await expectOneStep(() => pick('Duplicate'))
  })
})

describe('the clipboard', () => {
  /** Data that is copied or pasted. */
  const dataOf = (known: Record<string, string> = {}) => ({
    known,
    files: [] as File[],
    setData: (type: string, text: string) => {
      known[type] = text
    },
    getData: (type: string) => known[type] ?? '',
  })
  const clipboard = (type: string, clipboardData = dataOf(), target: Element = element('figure')) => {
    const event = send(target, type, { clipboardData })
    return { isTaken: event.defaultPrevented, known: clipboardData.known }
  }

  it.each(['', '[]', '{}', '[[1,2]]', '[[1,2,"3"]]', '[[1,2,null]]', '[1,2,3]', 'circles'])(
    'with %j in the format of the page pastes nothing',
    async (text) => {
      expect(clipboard('paste', dataOf({ 'application/x-circle-voronoi': text })).isTaken).toBe(false)
      await quiet()
      expect(ids()).toHaveLength(5)
    },
  )
})
