// SPDX-License-Identifier: GPL-3.0-or-later
// The cards of the selection and of a previewed circle, the menu at the pointer, and the dialog for columns.
// @vitest-environment happy-dom
import { render } from 'lit/html.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { Table } from '../../web/app/files/columns.ts'
import { pictureOf } from '../../web/app/generators/sample-picture.ts'
import { restoreInvalidNumbers } from '../../web/app/input/invalid-numbers.ts'
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
import {
  all,
  chosenOf,
  control,
  controls,
  element,
  enter,
  limitsOf,
  noting,
  openPage,
  press,
  send,
  stateOf,
  textOf,
} from './page-document.ts'
import { settled } from './turns.ts'

vi.mock('lit/html.js', { spy: true })

beforeEach(() => void openPage())
afterEach(() => vi.unstubAllGlobals())

const called = (id: number) => `circle ${id}`

describe('the card of several circles', () => {
  it('has their number, is there for two or more, and acts on them', () => {
    const done: unknown[][] = []
    const { store, change } = stateOf()
    const actions = noting(done, { ownColorOf: (id: number) => (id === 3 ? '#fff' : undefined), beginGesture: () => 7 })
    mountGroup(store, actions as unknown as PageActions)
    const card = element('group')
    expect(card.hidden).toBe(true)
    change({ selection: [1] })
    expect(card.hidden).toBe(true)
    change({ selection: [1, 2] })
    expect([card.hidden, textOf(card.querySelector('h2')), controls(card).has('Automatic color')]).toEqual([
      false,
      '2 circles',
      false,
    ])
    change({ selection: [1, 3] })
    enter(card, 'Color', '#123456')
    for (const label of ['Automatic color', 'Zoom to', 'Duplicate', 'Delete', 'Deselect']) {
      element('figure').blur()
      press(card, label)
      expect([label, document.activeElement]).toEqual([label, element('figure')])
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
    const shown = () => textOf(element('inspector-facts'))
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
      place: element('inspector-place'),
      data: element('inspector-data'),
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
      return [place.hidden, textOf(place)]
    }
    expect(shown(0)).toEqual([true, ''])
    expect(shown(1)).toEqual([false, 'Circle 1'])
    expect(shown(2)).toEqual([false, '2 of 2; numbers are not used again'])
  })

  it('has the columns of the file beside name and color, and the actions', () => {
    const { change, columns, data } = facts()
    expect(textOf(data)).toBe('')
    change({ selected: 0 })
    expect(data.hidden).toBe(true)
    const attributes = { columns, ids: [], heights: [], collection: '' }
    for (const [selected, text] of [
      [0, '7'],
      [1, 'a'],
      [2, '–'],
    ] as const) {
      change({ selected, attributes })
      expect([data.hidden, all(data, 'dt').map(textOf), textOf(data.querySelector('dd'))]).toEqual([false, ['n'], text])
    }
    expect([...controls(element('inspector-actions')).keys()]).toEqual(['Zoom to', 'Duplicate', 'Delete'])
    vi.mocked(render).mockClear()
    change({ hovered: 1 })
    expect(render, 'nothing has changed').not.toHaveBeenCalled()
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
    return { done, change, chips: element('inspector-neighbors'), card: element('inspector') }
  }
  const CIRCLE = { x: 1.23456, y: -2, r: 3 }

  it('has its numbers in one line, and its neighbors as buttons', () => {
    const { done, change, chips, card } = inspector()
    expect(card.hidden).toBe(true)
    change({ selected: 1, circle: CIRCLE, described: describedOf(1, { neighbors: Int32Array.of(4, 5) }) })
    expect([card.hidden, element('inspector-line').textContent]).toEqual([false, 'x 1.23  y -2  r 3'])
    expect(element('field-x').title).toBe('1.23456')
    expect(textOf(element('inspector-cell'))).toBe('Bounded cell, 2 neighbors')
    expect([...controls(chips)].map(([label, chip]) => [label, textOf(chip)])).toEqual([
      ['Circle 4', '4'],
      ['Kiel', 'Kiel'],
    ])
    const chip = control(chips, 'Kiel')
    for (const type of ['pointerenter', 'pointerleave', 'click']) send(chip, type)
    expect(done).toEqual([
      ['hover', 5],
      ['hover', undefined],
      ['goTo', 5],
    ])
    change({ described: describedOf(1, { neighbors: Int32Array.of(4, 5) }) })
    expect(control(chips, 'Kiel'), 'they are the same').toBe(chip)
  })

  it('has at most 500 neighbors', () => {
    const { change, chips } = inspector()
    const neighborsOf = (count: number) => Int32Array.from({ length: count }, (_, k) => k + 10)
    const shown = (count: number) => {
      change({ selected: 1, circle: CIRCLE, described: describedOf(1, { neighbors: neighborsOf(count) }) })
      return [controls(chips).size, textOf(all(chips, 'li')[500])]
    }
    expect(shown(500)).toEqual([500, undefined])
    expect(shown(501)).toEqual([500, 'and 1 more'])
    expect(shown(1734)).toEqual([500, 'and 1,234 more'])
  })

  it('keeps the focus among the neighbors, and gives it to the figure where there are none', () => {
    const { change, chips, card, done } = inspector()
    const show = (...neighbors: number[]) =>
      change({ selected: 1, circle: CIRCLE, described: describedOf(1, { neighbors: Int32Array.from(neighbors) }) })
    element('undo').focus()
    show(4, 5)
    expect(document.activeElement).toBe(element('undo'))
    control(chips, 'Kiel').focus()
    show(7)
    expect(document.activeElement).toBe(control(chips, 'Circle 7'))
    show()
    expect(document.activeElement).toBe(element('figure'))
    control(card, 'x').focus()
    change({ selected: undefined, circle: undefined })
    expect(document.activeElement).toBe(element('figure'))
    element('figure').blur()
    element('deselect').click()
    expect([done, document.activeElement]).toEqual([[['select', []]], element('figure')])
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
    const card = element('trial')
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
    expect(textOf(card)).toMatch(/^A new circle Its cell would have the area 2\.35, taken from circle 0∞circle 11/)
    expect(textOf(card)).toMatch(/and 2 more Release to add, Esc to cancel\.$/)
    show(undefined)
    expect(card.hidden).toBe(true)
    expect(textOf(tried({ area: Number.POSITIVE_INFINITY, taken: taken.slice(0, 8) }).card)).toMatch(
      /Its cell would have no end; taken from.*0\.143 Release/,
    )
    expect(textOf(tried({ hiddenBy: 0 }).card)).toBe(
      'A new circle It would be hidden inside circle 0 and take nothing.',
    )
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
    const place = element('menu')
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
    const labels = () => all(place, 'span').map(textOf)
    const pick = (label: string | undefined) => all(place, 'button')[labels().indexOf(label)]?.click()
    return { done, place, shown, asked, open, labels, pick, store }
  }

  it('of an empty place adds a circle there, selects all, and shows everything', () => {
    const items = ['Add a circle here', 'Select all', 'Show everything']
    for (const hit of [undefined, { id: 3, part: 'cell' }]) {
      const { done, asked, labels, pick, shown, place } = menu(hit)
      expect([asked, labels()]).toEqual([[[{ x: 15, y: 25 }, 2.5]], items])
      expect(all(place, 'kbd').map(textOf)).toEqual(['double-click', 'Ctrl+A', '0'])
      expect([shown.isOpen, document.activeElement]).toEqual([true, place.querySelector('button')])
      for (const item of items) pick(item)
      expect(done).toEqual([['addFitting', { x: 15, y: 25 }], ['selectAll'], ['fit']])
      expect([shown.isOpen, document.activeElement]).toEqual([false, element('figure')])
    }
  })

  it('of a circle selects it, unless it is selected with others', () => {
    const { done, labels, pick, store, place } = menu({ id: 3, part: 'disc' }, [1])
    expect([store.get().selection, labels()]).toEqual([[3], ['Name …', 'Zoom to', 'Duplicate', 'Delete']])
    expect(all(place, 'kbd').map(textOf)).toEqual(['', 'F', 'Ctrl+D', 'Delete'])
    for (const item of labels()) pick(item)
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
    const buttons = all(place, 'button')
    const key = (name: string) => {
      const event = Object.assign(new Event('keydown', { cancelable: true }), { key: name })
      const stop = vi.spyOn(event, 'stopPropagation')
      place.dispatchEvent(event)
      expect(stop, 'the shortcuts of the page are not meant').toHaveBeenCalled()
      return [buttons.indexOf(document.activeElement as HTMLButtonElement), event.defaultPrevented]
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
    const [figure, other] = [element('figure'), element('undo')]
    const button = place.querySelector('button') as HTMLElement
    for (const [focused, newState, expected] of [
      [button, 'open', button],
      [button, 'closed', figure],
      [document.body, 'closed', figure],
      [other, 'closed', other],
    ] as const) {
      figure.blur()
      focused.focus()
      send(place, 'toggle', { newState })
      expect(document.activeElement).toBe(expected)
    }
    figure.blur()
    const focused = vi.spyOn(document, 'activeElement', 'get').mockReturnValue(null)
    send(place, 'toggle', { newState: 'closed' })
    focused.mockRestore()
    expect(document.activeElement).toBe(figure)
  })

  it('opens at the pointer, or by its key at the selected circle, and not after a long press', () => {
    const figure = element('figure')
    const opened: unknown[] = []
    let circle: object | undefined = { x: 1, y: 2, r: 3 }
    const view = { toScreen: ({ x, y }: { x: number; y: number }) => ({ x: 10 * x, y: 10 * y }) }
    listenToMenu(
      figure,
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
    const figure = element('figure')
    const { classList } = document.body
    const touch = (type: string, clientX: number, pointerType = 'touch') => {
      send(figure, type, { pointerType, clientX, clientY: 0 })
      return classList.contains('one-line')
    }
    expect(touch('pointerup', 0)).toBe(false)
    expect(touch('pointerdown', 0, 'mouse')).toBe(false)
    expect([touch('pointerdown', 0), touch('pointerup', 4)]).toEqual([true, true])
    expect([touch('pointerdown', 0), touch('pointerup', 3.9)]).toEqual([true, false])
    for (const id of ['inspector', 'group']) {
      touch('pointerdown', 0)
      element(id).click()
      expect(classList.contains('one-line')).toBe(false)
    }
  })

  it('the focus is marked while Tab moves it, until a pointer is pressed', () => {
    markTabbing()
    const { classList } = document.body
    send(window, 'keydown', { key: 'a' })
    expect(classList.contains('tabbing')).toBe(false)
    send(window, 'keydown', { key: 'Tab' })
    expect(classList.contains('tabbing')).toBe(true)
    send(window, 'pointerdown')
    expect(classList.contains('tabbing')).toBe(false)
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
    const dialog = element<HTMLDialogElement>('columns')
    const chosen = chooseColumns(table, 'a.csv')
    const close = (returnValue: string) => {
      dialog.close(returnValue)
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
      expect([await chosen, dialog.open]).toEqual([expected, false])
    }
  })

  it.each([['x,y,r,radius'], ['x,lon,y,r'], ['x,y,lat,r'], ['x,y,n'], ['y,r,n'], ['x,r,n']])(
    'is there where the names do not say everything: %s',
    (heading) => {
      expect(asked(tableOf(heading.split(','))).dialog.open).toBe(true)
    },
  )

  it('has the guesses, and gives what is chosen', async () => {
    const { dialog, close } = asked(tableOf(['n', 'a', 'lon', 'lat']))
    expect(dialog.open).toBe(true)
    const chosen = () => ['x', 'y', 'radius'].map((label) => chosenOf(control(dialog, label)))
    expect(chosen()).toEqual(['lon', 'lat', 'lon'])
    expect(textOf(dialog)).toContain('a.csv has 7 rows.')
    enter(dialog, 'radius', '1', ['change'])
    enter(dialog, 'x', '3', ['change'])
    enter(dialog, 'y', '2', ['change'])
    expect(chosen()).toEqual(['lat', 'lon', 'a'])
    expect(all(dialog, 'th').map(({ classList }) => classList.contains('used'))).toEqual([false, true, true, true])
    const cells = all(dialog, 'td')
    expect([cells.length, cells.map(textOf).slice(0, 5)]).toEqual([20, ['00', '01', '02', '03', '10']])
    expect(cells.slice(0, 4).map(({ classList }) => classList.contains('used'))).toEqual([false, true, true, true])
    enter(dialog, 'diameters', true, ['change'])
    enter(dialog, 'x', '3', ['change'])
    expect(control(dialog, 'diameters').checked).toBe(true)
    expect(await close('open')).toEqual({ x: 'lat', y: 'lon', radius: 'a', isDiameter: true })
  })

  it('gives one radius to all circles', async () => {
    restoreInvalidNumbers(document)
    const { dialog, close } = asked(tableOf(['a', 'b']))
    expect(chosenOf(control(dialog, 'radius')), 'there is no third column').toBe('the same for all')
    expect(limitsOf(control(dialog, 'r'))).toEqual(['0', null, 'any'])
    enter(dialog, 'r', '2.5', ['change'])
    enter(dialog, 'r', '-1')
    send(control(dialog, 'r'), 'focusout')
    expect(control(dialog, 'r').value).toBe('2.5')
    enter(dialog, 'x', '0', ['change'])
    expect(await close('open')).toEqual({ x: 'a', y: 'b', radius: { all: 2.5 }, isDiameter: false })
    const other = asked(tableOf(['a', 'b', 'd']))
    expect(chosenOf(control(other.dialog, 'radius'))).toBe('d')
    expect(control(other.dialog, 'diameters').checked).toBe(true)
    enter(other.dialog, 'radius', '-1', ['change'])
    expect(control(other.dialog, 'r').value).toBe('1')
    expect(await other.close('open')).toEqual({ x: 'a', y: 'b', radius: { all: 1 }, isDiameter: false })
  })

  it('has the guesses also after another file', async () => {
    const { dialog, close } = asked(tableOf(['a', 'b', 'c']))
    for (const label of ['x', 'y', 'radius']) {
      for (const column of ['0', '1', '2', '0']) enter(dialog, label, column, ['change'])
    }
    await close('')
    asked(tableOf(['a', 'b', 'c']))
    expect(['x', 'y', 'radius'].map((label) => chosenOf(control(dialog, label)))).toEqual(['a', 'b', 'c'])
  })

  it('says what is wrong with the choice, and opens nothing then or when it is canceled', async () => {
    const { dialog, close } = asked(tableOf(['a', 'b', 'c'], { hasNumbers: [true, true, false] }))
    const wrong = () => [textOf(dialog.querySelector('.wrong')), control(dialog, 'Open').disabled]
    expect(wrong()).toEqual(['There are no numbers in column c.', true])
    enter(dialog, 'radius', '1', ['change'])
    expect(wrong()).toEqual(['', false])
    enter(dialog, 'y', '0', ['change'])
    expect(wrong()).toEqual(['x and y are the same column.', true])
    enter(dialog, 'y', '2', ['change'])
    expect(wrong()).toEqual(['There are no numbers in column c.', true])
    expect(await close('')).toBeUndefined()
  })
})

it('a thumbnail has the circles in its middle, small ones large enough to be seen, and none that is huge or outside', () => {
  const pathOf = (...circles: number[]) => {
    const place = document.createElement('div')
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
