// SPDX-License-Identifier: GPL-3.0-or-later
// The cards of the selection and of a previewed circle, the menu at the pointer, and the dialog for columns.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { Table } from '../../web/app/files/columns.ts'
import { pictureOf } from '../../web/app/generators/sample-picture.ts'
import { listenToMenu } from '../../web/app/input/menu-key.ts'
import { markTabbing } from '../../web/app/input/tabbing.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import { chooseColumns } from '../../web/app/panels/choose-columns.ts'
import { contextMenu } from '../../web/app/panels/context-menu.ts'
import { mountGroup } from '../../web/app/panels/group.ts'
import { mountInspector } from '../../web/app/panels/inspector.ts'
import { mountInspectorFacts } from '../../web/app/panels/inspector-facts.ts'
import { mountOneLine } from '../../web/app/panels/one-line.ts'
import { mountTrial } from '../../web/app/panels/trial.ts'
import type { Editing } from '../../web/editing/editing.ts'
import { ENGLISH_EDITING } from '../../web/editing/words.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import type { CellFacts, Described, Trial } from '../../web/view/protocol.ts'
import type { View } from '../../web/view/view.ts'
import { noting, PageElement, render, stateOf, stubPage } from './page-document.ts'

vi.mock('lit/html.js', async (load) => ({
  ...(await load<object>()),
  render: (await import('./page-document.ts')).render,
}))

let stub: ReturnType<typeof stubPage>
beforeEach(() => {
  stub = stubPage()
})
afterEach(() => vi.unstubAllGlobals())

const settled = async () => {
  for (let k = 0; k < 9; k++) await Promise.resolve()
}
const called = (id: number) => `circle ${id}`
const send = (target: EventTarget, type: string, more: object = {}) => {
  const event = Object.assign(new Event(type, { cancelable: true }), more)
  target.dispatchEvent(event)
  return event
}

describe('the card of several circles', () => {
  it('has their number, is there for two or more, and acts on them', () => {
    const done: unknown[][] = []
    const { store, change } = stateOf()
    const actions = noting(done, { ownColorOf: (id: number) => (id === 3 ? '#fff' : undefined), beginGesture: () => 7 })
    mountGroup(store, actions as unknown as PageActions)
    const card = stub.element('group')
    expect(card.hidden).toBe(true)
    change({ selection: [1] })
    expect(card.hidden).toBe(true)
    change({ selection: [1, 2] })
    expect([card.hidden, card.querySelector('h2')?.text, card.controls.has('Automatic color')]).toEqual([
      false,
      '2 circles',
      false,
    ])
    change({ selection: [1, 3] })
    card.enter('Color', '#123456')
    for (const label of ['Automatic color', 'Zoom to', 'Duplicate', 'Delete', 'Deselect']) {
      stub.page.activeElement = undefined
      card.press(label)
      expect([label, stub.page.activeElement]).toEqual([label, stub.element('figure')])
    }
    expect(done).toEqual([
      ['setColor', [1, 3], '#123456', 7],
      ['setColor', [1, 3], undefined],
      ['zoomToSelection'],
      ['duplicateSelected'],
      ['removeSelected'],
      ['select', []],
    ])
  })
})

describe('the card of a circle', () => {
  const FACTS = { hidden: false, area: 12.34567, perimeter: Number.POSITIVE_INFINITY } as CellFacts
  const describedOf = (id: number, more: Partial<Described> = {}) =>
    ({ id, hiddenBy: undefined, isBounded: true, neighbors: Int32Array.of(), ...more }) as Described

  function facts() {
    const { store, change } = stateOf()
    const names = ['', 'Bonn']
    const columns = [
      { name: 'name', values: names },
      { name: 'n', values: ['7', '"a"', ''] },
    ]
    const editing = {
      circles: new CircleTable(Float64Array.of(0, 0, 1, 4, 0, 1), 0, { ids: Int32Array.of(0, 2), nextId: 3 } as never),
      nameOf: (id: number) => names[id] ?? '',
      valueOf: (id: number, name: string) => columns.find((column) => column.name === name)?.values[id] ?? '',
    }
    const answers: ((told: unknown) => void)[] = []
    const asked: unknown[] = []
    const view = {
      ask: (...what: unknown[]) => {
        asked.push(what)
        return new Promise((resolve) => answers.push(resolve))
      },
    }
    const actions = noting([], { ownColorOf: () => undefined })
    mountInspectorFacts(
      store,
      editing as unknown as Editing,
      actions as unknown as PageActions,
      view as unknown as View,
    )
    const shown = () => stub.element('inspector-facts').text
    const tell = async (id: number, cell: Partial<CellFacts> = {}) => {
      answers.shift()?.({ cells: new Map([[id, { ...FACTS, ...cell }]]) })
      await settled()
    }
    return {
      change,
      asked,
      answers,
      tell,
      shown,
      columns,
      place: stub.element('inspector-place'),
      data: stub.element('inspector-data'),
    }
  }

  it('has the measures of its cell, or of the part inside the region', async () => {
    const { change, asked, tell, shown } = facts()
    change({ selected: 0, described: describedOf(0) })
    expect(asked).toEqual([['tell', [0]]])
    await tell(0)
    expect(shown()).toBe('Area of the cell12.35 Perimeter of the cell∞')
    change({ domain: { region: [], areas: undefined } })
    expect(asked, 'nothing is described anew').toHaveLength(1)
    change({ described: describedOf(0) })
    await tell(0, { perimeter: 5 })
    expect(shown()).toBe('Area inside the region12.35 Perimeter inside the region5')
    change({ described: describedOf(0) })
    await tell(0, { hidden: true })
    expect(shown()).toBe('')
  })

  it('drops measures of a circle that is not selected any more', async () => {
    const { change, answers, tell, shown } = facts()
    change({ selected: 0, described: describedOf(0) })
    change({ selected: 2, described: describedOf(2) })
    await tell(0)
    expect(shown()).toBe('')
    await tell(2)
    expect([shown(), answers]).toEqual([expect.stringMatching(/^Area/), []])
    change({ selected: 2, described: describedOf(2) })
    answers.shift()?.(undefined)
    await settled()
    expect(shown()).toBe('')
  })

  it('has the number of a circle with a name, and its place if that is another one', () => {
    const { change, place } = facts()
    const shown = (selected: number) => {
      change({ selected })
      return [place.hidden, place.text]
    }
    expect(shown(0)).toEqual([true, ''])
    expect(shown(1)).toEqual([false, 'Circle 1'])
    expect(shown(2)).toEqual([false, '2 of 2; numbers are not used again'])
  })

  it('has the columns of the file beside name and color, and the actions', () => {
    const { change, columns, data } = facts()
    expect(data.text).toBe('')
    change({ selected: 0 })
    expect(data.hidden).toBe(true)
    const attributes = { columns, ids: [], heights: [], collection: '' }
    for (const [selected, text] of [
      [0, '7'],
      [1, 'a'],
      [2, '–'],
    ] as const) {
      change({ selected, attributes })
      expect([
        data.hidden,
        data.querySelectorAll('dt').map((name) => name.text),
        data.querySelector('dd')?.text,
      ]).toEqual([false, ['n'], text])
    }
    expect([...stub.element('inspector-actions').controls.keys()]).toEqual(['Zoom to', 'Duplicate', 'Delete'])
    const [first] = data.elements
    change({ hovered: 1 })
    expect(data.elements[0], 'nothing has changed').toBe(first)
  })

  function inspector() {
    const done: unknown[][] = []
    const { store, change } = stateOf()
    const names = new Map([[5, 'Kiel']])
    const actions = noting(done, {
      words: ENGLISH_EDITING,
      called,
      nameOf: (id: number) => names.get(id) ?? '',
      selectedCircles: () => [],
    })
    mountInspector(store, actions as unknown as PageActions)
    return { done, change, chips: stub.element('inspector-neighbors'), card: stub.element('inspector') }
  }
  const CIRCLE = { x: 1.23456, y: -2, r: 3 }

  it('has its numbers in one line, and its neighbors as buttons', () => {
    const { done, change, chips, card } = inspector()
    expect(card.hidden).toBe(true)
    change({ selected: 1, circle: CIRCLE, described: describedOf(1, { neighbors: Int32Array.of(4, 5) }) })
    expect([card.hidden, stub.element('inspector-line').textContent]).toEqual([false, 'x 1.23  y -2  r 3'])
    expect(stub.element('field-x').title).toBe('1.23456')
    expect(stub.element('inspector-cell').text).toBe('Bounded cell, 2 neighbors')
    expect([...chips.controls].map(([label, chip]) => [label, chip.text])).toEqual([
      ['Circle 4', '4'],
      ['Kiel', 'Kiel'],
    ])
    const chip = chips.control('Kiel')
    for (const type of ['pointerenter', 'pointerleave', 'click']) send(chip, type)
    expect(done).toEqual([
      ['hover', 5],
      ['hover', undefined],
      ['goTo', 5],
    ])
    change({ described: describedOf(1, { neighbors: Int32Array.of(4, 5) }) })
    expect(chips.control('Kiel'), 'they are the same').toBe(chip)
  })

  it('has at most 500 neighbors', () => {
    const { change, chips } = inspector()
    const neighborsOf = (count: number) => Int32Array.from({ length: count }, (_, k) => k + 10)
    const shown = (count: number) => {
      change({ selected: 1, circle: CIRCLE, described: describedOf(1, { neighbors: neighborsOf(count) }) })
      return [chips.controls.size, chips.querySelectorAll('li')[500]?.text]
    }
    expect(shown(500)).toEqual([500, undefined])
    expect(shown(501)).toEqual([500, 'and 1 more'])
    expect(shown(1734)).toEqual([500, 'and 1,234 more'])
  })

  it('keeps the focus among the neighbors, and gives it to the figure where there are none', () => {
    const { change, chips, card, done } = inspector()
    const show = (...neighbors: number[]) =>
      change({ selected: 1, circle: CIRCLE, described: describedOf(1, { neighbors: Int32Array.from(neighbors) }) })
    const other = new PageElement()
    other.focus()
    show(4, 5)
    expect(stub.page.activeElement).toBe(other)
    chips.control('Kiel').focus()
    show(7)
    expect(stub.page.activeElement).toBe(chips.control('Circle 7'))
    show()
    expect(stub.page.activeElement).toBe(stub.element('figure'))
    const field = new PageElement('input')
    card.append(field)
    field.focus()
    change({ selected: undefined, circle: undefined })
    expect(stub.page.activeElement).toBe(stub.element('figure'))
    stub.page.activeElement = undefined
    stub.element('deselect').click()
    expect([done, stub.page.activeElement]).toEqual([[['select', []]], stub.element('figure')])
  })
})

describe('the card of a previewed circle', () => {
  function tried(more: Partial<Trial>) {
    let show = (_: Trial | undefined) => {}
    const view = {
      on: (_: string, act: typeof show) => {
        show = act
      },
    }
    mountTrial(view as unknown as View, { called })
    const card = stub.element('trial')
    show({ hiddenBy: undefined, area: 1, taken: [], ...more } as Trial)
    return { card, show }
  }

  it('says what the circle would take, the greatest losses first, and what hides it', () => {
    const taken = Array.from({ length: 10 }, (_, id) => ({
      id,
      x: 0,
      y: 0,
      area: id === 0 ? Number.POSITIVE_INFINITY : 1 / id,
    }))
    const { card, show } = tried({ area: 2.3456, taken })
    expect(card.hidden).toBe(false)
    expect(card.text).toMatch(/^A new circle Its cell would have the area 2\.35, taken from circle 0∞circle 11/)
    expect(card.text).toMatch(/and 2 more Release to add, Esc to cancel\.$/)
    show(undefined)
    expect(card.hidden).toBe(true)
    expect(tried({ area: Number.POSITIVE_INFINITY, taken: taken.slice(0, 8) }).card.text).toMatch(
      /Its cell would have no end; taken from.*0\.143 Release/,
    )
    expect(tried({ hiddenBy: 0 }).card.text).toBe('A new circle It would be hidden inside circle 0 and take nothing.')
  })
})

describe('the menu at the pointer', () => {
  function menu(hit: object | undefined, selection: number[] = []) {
    const done: unknown[][] = []
    const { store, change } = stateOf({ selection })
    const asked: unknown[] = []
    const view = {
      camera: { x: 10, y: 20, scale: 2 },
      size: { width: 100, height: 100 },
      hitAt: (...what: unknown[]) => {
        asked.push(what)
        return hit
      },
    }
    const actions = noting(done, {
      isSelected: (id: number) => store.get().selection.includes(id),
      select: (selection: number[]) => change({ selection }),
    })
    const place = stub.element('menu')
    const shown = { isOpen: false }
    Object.assign(place, {
      showPopover: () => Object.assign(shown, { isOpen: true }),
      hidePopover: () => Object.assign(shown, { isOpen: false }),
      getBoundingClientRect: () => ({ width: 80, height: 60 }),
    })
    vi.stubGlobal('innerWidth', 300)
    vi.stubGlobal('innerHeight', 200)
    const open = contextMenu(store, actions as unknown as PageActions, view as unknown as View, () =>
      done.push(['name']),
    )
    open({ x: 60, y: 40 })
    const labels = () => place.querySelectorAll('span').map(({ text }) => text)
    const press = (label: string) => place.querySelectorAll('button')[labels().indexOf(label)]?.click()
    return { done, place, shown, asked, open, labels, press, store }
  }

  it('of an empty place adds a circle there, selects all, and shows everything', () => {
    const items = ['Add a circle here', 'Select all', 'Show everything']
    for (const hit of [undefined, { id: 3, part: 'cell' }]) {
      const { done, asked, labels, press, shown, place } = menu(hit)
      expect([asked, labels()]).toEqual([[[{ x: 15, y: 25 }, 2.5]], items])
      expect(place.querySelectorAll('kbd').map(({ text }) => text)).toEqual(['double-click', 'Ctrl+A', '0'])
      expect([shown.isOpen, stub.page.activeElement]).toEqual([true, place.querySelector('button')])
      for (const item of items) press(item)
      expect(done).toEqual([['addFitting', { x: 15, y: 25 }], ['selectAll'], ['fit']])
      expect([shown.isOpen, stub.page.activeElement]).toEqual([false, stub.element('figure')])
    }
  })

  it('of a circle selects it, unless it is selected with others', () => {
    const { done, labels, press, store, place } = menu({ id: 3, part: 'disc' }, [1])
    expect([store.get().selection, labels()]).toEqual([[3], ['Name …', 'Zoom to', 'Duplicate', 'Delete']])
    expect(place.querySelectorAll('kbd').map(({ text }) => text)).toEqual(['', 'F', 'Ctrl+D', 'Delete'])
    for (const item of labels()) press(item)
    expect(done).toEqual([['name'], ['zoomToSelection'], ['duplicateSelected'], ['removeSelected']])
    const several = menu({ id: 3, part: 'rim' }, [1, 3])
    expect([several.store.get().selection, several.labels()]).toEqual([
      [1, 3],
      ['Zoom to', 'Duplicate', 'Delete'],
    ])
  })

  it('is inside the window', () => {
    const { open, place } = menu(undefined)
    const at = (x: number, y: number) => {
      open({ x, y })
      return [place.style.left, place.style.top]
    }
    expect(at(60, 40)).toEqual(['60px', '40px'])
    expect(at(290, 190)).toEqual(['215px', '135px'])
    vi.stubGlobal('innerWidth', 50)
    vi.stubGlobal('innerHeight', 50)
    expect(at(20, 20)).toEqual(['0px', '0px'])
  })

  it('is used with arrows, around its ends, and closed by Escape', () => {
    const { place, shown } = menu(undefined)
    const buttons = place.querySelectorAll('button')
    const key = (name: string) => {
      const event = Object.assign(new Event('keydown', { cancelable: true }), { key: name })
      const stop = vi.spyOn(event, 'stopPropagation')
      place.dispatchEvent(event)
      expect(stop, 'the shortcuts of the page are not meant').toHaveBeenCalled()
      return [buttons.indexOf(stub.page.activeElement as PageElement), event.defaultPrevented]
    }
    expect(['ArrowDown', 'ArrowDown', 'ArrowDown', 'ArrowUp', 'ArrowUp', 'a'].map(key)).toEqual([
      [1, true],
      [2, true],
      [0, true],
      [2, true],
      [1, true],
      [1, false],
    ])
    key('Escape')
    expect(shown.isOpen).toBe(false)
  })

  it('gives the focus to the figure as it closes, unless something else has it', () => {
    const { place } = menu(undefined)
    const { body } = stub.page
    const other = new PageElement()
    const figure = stub.element('figure')
    for (const [focused, newState, expected] of [
      [place.querySelector('button'), 'open', place.querySelector('button')],
      [place.querySelector('button'), 'closed', figure],
      [body, 'closed', figure],
      [null, 'closed', figure],
      [other, 'closed', other],
    ] as const) {
      Object.assign(stub.page, { activeElement: focused })
      send(place, 'toggle', { newState })
      expect(stub.page.activeElement).toBe(expected)
    }
  })

  it('opens at the pointer, or by its key at the selected circle, and not after a long press', () => {
    const figure = stub.element('figure')
    const opened: unknown[] = []
    let circle: object | undefined = { x: 1, y: 2, r: 3 }
    const view = { toScreen: ({ x, y }: { x: number; y: number }) => ({ x: 10 * x, y: 10 * y }) }
    listenToMenu(
      figure as unknown as HTMLElement,
      view as unknown as View,
      () => circle as never,
      (at) => opened.push(at),
    )
    vi.stubGlobal('getComputedStyle', () => ({}))
    Object.assign(figure, { currentCSSZoom: 1 })
    const ask = () => send(figure, 'contextmenu', { offsetX: 7, offsetY: 8 }).defaultPrevented
    expect(ask()).toBe(true)
    send(figure, 'pointerdown', { pointerType: 'touch' })
    expect(ask()).toBe(false)
    send(figure, 'pointerdown', { pointerType: 'mouse' })
    ask()
    send(figure, 'keydown')
    ask()
    circle = undefined
    ask()
    expect(opened).toEqual([
      { x: 7, y: 8 },
      { x: 7, y: 8 },
      { x: 10, y: 20 },
      { x: 7, y: 8 },
    ])
  })
})

describe('on a phone', () => {
  it('the card is one line from the press of a finger until a tap', () => {
    mountOneLine()
    const figure = stub.element('figure')
    const { classList } = stub.page.body
    const press = (type: string, clientX: number, pointerType = 'touch') => {
      send(figure, type, { pointerType, clientX, clientY: 0 })
      return classList.has('one-line')
    }
    expect(press('pointerup', 0)).toBe(false)
    expect(press('pointerdown', 0, 'mouse')).toBe(false)
    expect([press('pointerdown', 0), press('pointerup', 4)]).toEqual([true, true])
    expect([press('pointerdown', 0), press('pointerup', 3.9)]).toEqual([true, false])
    for (const id of ['inspector', 'group']) {
      press('pointerdown', 0)
      stub.element(id).click()
      expect(classList.has('one-line')).toBe(false)
    }
  })

  it('the focus is marked while Tab moves it, until a pointer is pressed', () => {
    const listening = new EventTarget()
    vi.stubGlobal('addEventListener', listening.addEventListener.bind(listening))
    markTabbing()
    const { classList } = stub.page.body
    send(listening, 'keydown', { key: 'a' })
    expect(classList.has('tabbing')).toBe(false)
    send(listening, 'keydown', { key: 'Tab' })
    expect(classList.has('tabbing')).toBe(true)
    send(listening, 'pointerdown')
    expect(classList.has('tabbing')).toBe(false)
  })
})

describe('the dialog for columns', () => {
  const tableOf = (heading: string[], more: Partial<Table> = {}): Table => ({
    heading,
    hasHeading: true,
    rows: Array.from({ length: 7 }, (_, k) => heading.map((_, i) => `${k}${i}`)),
    hasNumbers: heading.map(() => true),
    ...more,
  })
  function asked(table: Table) {
    const dialog = Object.assign(stub.element('columns'), { isShown: false, returnValue: 'open' })
    Object.assign(dialog, { showModal: () => Object.assign(dialog, { isShown: true }) })
    const chosen = chooseColumns(table, 'a.csv')
    const close = (returnValue: string) => {
      dialog.returnValue = returnValue
      send(dialog, 'close')
      return chosen
    }
    return { dialog, chosen, close }
  }

  it('is not there where the names say everything', async () => {
    for (const [heading, expected] of [
      [['n', 'y', 'x', 'radius'], { x: 'x', y: 'y', radius: 'radius', isDiameter: false }],
      [['x', 'y', 'diameter'], { x: 'x', y: 'y', radius: 'diameter', isDiameter: true }],
    ] as const) {
      const { dialog, chosen } = asked(tableOf([...heading]))
      expect([await chosen, dialog.isShown]).toEqual([expected, false])
    }
  })

  it.each([['x,y,r,radius'], ['x,lon,y,r'], ['x,y,lat,r'], ['x,y,n'], ['y,r,n'], ['x,r,n']])(
    'is there where the names do not say everything: %s',
    (heading) => {
      expect(asked(tableOf(heading.split(','))).dialog.isShown).toBe(true)
    },
  )

  it('has the guesses, and gives what is chosen', async () => {
    const { dialog, close } = asked(tableOf(['n', 'a', 'lon', 'lat']))
    expect(dialog.isShown).toBe(true)
    const chosen = () => ['x', 'y', 'radius'].map((label) => dialog.control(label).chosen)
    expect(chosen()).toEqual(['lon', 'lat', 'lon'])
    expect(dialog.text).toContain('a.csv has 7 rows.')
    dialog.enter('radius', '1', ['change'])
    dialog.enter('x', '3', ['change'])
    dialog.enter('y', '2', ['change'])
    expect(chosen()).toEqual(['lat', 'lon', 'a'])
    expect(dialog.querySelectorAll('th').map(({ classList }) => classList.has('used'))).toEqual([
      false,
      true,
      true,
      true,
    ])
    const cells = dialog.querySelectorAll('td')
    expect([cells.length, cells.map(({ text }) => text).slice(0, 5)]).toEqual([20, ['00', '01', '02', '03', '10']])
    expect(cells.slice(0, 4).map(({ classList }) => classList.has('used'))).toEqual([false, true, true, true])
    dialog.enter('diameters', true, ['change'])
    dialog.enter('x', '3', ['change'])
    expect(dialog.control('diameters').checked).toBe(true)
    expect(await close('open')).toEqual({ x: 'lat', y: 'lon', radius: 'a', isDiameter: true })
  })

  it('gives one radius to all circles', async () => {
    const { dialog, close } = asked(tableOf(['a', 'b']))
    expect(dialog.control('radius').chosen, 'there is no third column').toBe('the same for all')
    expect(dialog.control('r').limits).toEqual(['0', null, 'any'])
    dialog.enter('r', '2.5', ['change'])
    dialog.control('r').isValid = false
    dialog.enter('r', '-1', ['change'])
    dialog.enter('x', '0', ['change'])
    expect(dialog.control('r').value).toBe('2.5')
    expect(await close('open')).toEqual({ x: 'a', y: 'b', radius: { all: 2.5 }, isDiameter: false })
    const other = asked(tableOf(['a', 'b', 'd']))
    expect(other.dialog.control('radius').chosen).toBe('d')
    expect(other.dialog.control('diameters').checked).toBe(true)
    other.dialog.enter('radius', '-1', ['change'])
    expect(other.dialog.control('r').value).toBe('1')
    expect(await other.close('open')).toEqual({ x: 'a', y: 'b', radius: { all: 1 }, isDiameter: false })
  })

  it('says what is wrong with the choice, and opens nothing then or when it is canceled', async () => {
    const { dialog, close } = asked(tableOf(['a', 'b', 'c'], { hasNumbers: [true, true, false] }))
    const wrong = () => [dialog.querySelector('.wrong')?.text, dialog.control('Open').disabled]
    expect(wrong()).toEqual(['There are no numbers in column c.', true])
    dialog.enter('radius', '1', ['change'])
    expect(wrong()).toEqual(['', false])
    dialog.enter('y', '0', ['change'])
    expect(wrong()).toEqual(['x and y are the same column.', true])
    dialog.enter('y', '2', ['change'])
    expect(wrong()).toEqual(['There are no numbers in column c.', true])
    expect(await close('')).toBeUndefined()
  })
})

it('a thumbnail has the circles in its middle, small ones large enough to be seen, and none that is huge or outside', () => {
  const pathOf = (...circles: number[]) => {
    const place = new PageElement()
    render(pictureOf(Float64Array.from(circles)), place)
    return place.querySelector('path')?.getAttribute('d')
  }
  // The box of 48 x 36 has a margin of 3: the circles are 30 high.
  expect(pathOf(0, 0, 1, 2, 0, 1)).toBe(
    'M3 18a10.5 10.5 0 1 0 21 0a10.5 10.5 0 1 0 -21 0M24 18a10.5 10.5 0 1 0 21 0a10.5 10.5 0 1 0 -21 0',
  )
  expect(pathOf(0, 0, 0, 0, 2, 0)).toBe(
    'M23.3 33a0.7 0.7 0 1 0 1.4 0a0.7 0.7 0 1 0 -1.4 0M23.3 3a0.7 0.7 0 1 0 1.4 0a0.7 0.7 0 1 0 -1.4 0',
  )
  const many = Array.from({ length: 40 }, (_, k) => [k % 6, Math.floor(k / 6), 0.3]).flat()
  const count = (more: number[]) => pathOf(...many, ...more)?.match(/M/g)?.length
  expect([count([]), count([1e6, 0, 1]), count([-1e9, 0, 1e9])]).toEqual([40, 40, 40])
})
