// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of the table: rows that are seen, keys, clicks and the editing of cells, on elements without a browser.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { Grid, type GridContent } from '../../web/app/table/grid.ts'
import { all, element, measure, openPage, send, textOf } from './page-document.ts'
import { settled } from './turns.ts'

const { world } = vi.hoisted(() => ({
  world: { first: 0, last: 3, scrolled: [] as unknown[][], mounted: 0, counted: [] as number[] },
}))
vi.mock('@tanstack/virtual-core', () => ({
  elementScroll: 'scroll',
  observeElementOffset: 'offset',
  observeElementRect: 'rect',
  Virtualizer: class {
    options: { count: number; estimateSize(): number }
    constructor(options: { count: number; estimateSize(): number }) {
      this.options = options
    }
    setOptions(options: { count: number; estimateSize(): number }) {
      this.options = options
      world.counted.push(options.count)
    }
    _didMount() {
      world.mounted += 1
      return () => {
        world.mounted -= 1
      }
    }
    _willUpdate() {}
    getTotalSize() {
      return this.options.count * this.options.estimateSize()
    }
    getVirtualItems() {
      const last = Math.min(world.last, this.options.count - 1)
      return Array.from({ length: Math.max(last - world.first + 1, 0) }, (_, k) => ({ index: world.first + k }))
    }
    scrollToIndex(row: number, options: unknown) {
      world.scrolled.push([row, options])
    }
    scrollToOffset(offset: number) {
      world.scrolled.push(['offset', offset])
    }
  },
}))

let frames: (() => void)[]
beforeEach(() => {
  frames = []
  Object.assign(world, { first: 0, last: 3, scrolled: [], mounted: 0, counted: [] })
  vi.stubGlobal('requestAnimationFrame', (act: () => void) => frames.push(act))
  vi.stubGlobal('cancelAnimationFrame', () => {
    frames = []
  })
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

function gridOf({ rows = 10 } = {}) {
  const done: unknown[][] = []
  const known = { rows, selected: new Set<number>(), isTaken: true, sorted: 1, cells: new Map<string, object>() }
  const content: GridContent = {
    headings: [
      { name: '#', title: 'Number', isEditable: false },
      { name: 'x', title: 'Center', isEditable: true },
      { name: 'area', title: 'Area', isEditable: false },
      { name: 'name', title: 'Name', isEditable: true, isText: true },
    ],
    rows: () => known.rows,
    cell: (row, column) =>
      (known.cells.get(`${row} ${column}`) as { text: string } | undefined) ?? { text: `${row}/${column}` },
    isSelected: (row) => known.selected.has(row),
    sortOf: (column) => (column === known.sorted ? 'descending' : 'none'),
    sort: (column) => done.push(['sort', column]),
    choose: (row, how) => done.push(['choose', row, how]),
    idOf: (row) => 100 + row,
    written: (id, column) => `w${id}/${column}`,
    write: async (id, column, text) => {
      done.push(['write', id, column, text])
      await Promise.resolve()
      return known.isTaken
    },
    paste: (row, column, text) => done.push(['paste', row, column, text]),
    seen: (first, last) => done.push(['seen', first, last]),
  }
  openPage('<div id="g"></div><button id="other"></button>')
  const table = element('g')
  measure(table, { clientHeight: 100 })
  vi.spyOn(HTMLElement.prototype, 'offsetHeight', 'get').mockReturnValue(20)
  const grid = new Grid(table, content, 'Circles')
  const draw = () => {
    for (const frame of frames.splice(0)) frame()
  }
  draw()
  const [head, body] = table.children as unknown as [HTMLElement, HTMLElement]
  const childrenOf = (parent: HTMLElement) => [...parent.children] as HTMLElement[]
  /** The elements of rows that are shown. */
  const rowElements = () => childrenOf(body).filter(({ hidden }) => !hidden)
  /** The numbers of the rows that are shown. */
  const shown = () =>
    rowElements()
      .map(({ dataset }) => Number(dataset.row))
      .sort((a, b) => a - b)
  const cell = (row: number, column: number) =>
    rowElements().find(({ dataset }) => dataset.row === String(row))?.children[column] as HTMLElement
  const dispatch = (type: string, target: HTMLElement, more: object = {}) => {
    const none = { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false }
    const { defaultPrevented } = send(target, type, { ...none, ...more })
    draw()
    return defaultPrevented
  }
  const key = (name: string, more: object = {}) => dispatch('keydown', table, { key: name, ...more })
  const current = () => table.getAttribute('aria-activedescendant')
  const input = () => table.querySelector('input') as HTMLInputElement
  /** Presses a key in the field of a cell. */
  const type = async (name: string, more: object = {}) => {
    const isUsed = dispatch('keydown', input(), { key: name, ...more })
    await settled()
    draw()
    return isUsed
  }
  done.length = 0
  return {
    grid,
    done,
    known,
    table,
    headings: childrenOf(head),
    head,
    body,
    draw,
    shown,
    cell,
    dispatch,
    key,
    current,
    input,
    type,
  }
}

describe('the grid', () => {
  it('is described to screen readers', () => {
    const { table, headings, head, body, cell, grid } = gridOf()
    expect(table).toMatchObject({
      role: 'grid',
      tabIndex: 0,
      ariaLabel: 'Circles',
      ariaMultiSelectable: 'true',
      ariaColCount: '4',
      ariaRowCount: '11',
    })
    expect(head).toMatchObject({ role: 'row', ariaRowIndex: '1' })
    expect(
      headings.map(({ textContent, title, id, role, ariaColIndex }) => [textContent, title, id, role, ariaColIndex]),
    ).toEqual([
      ['#', 'Number', 'g--1-0', 'columnheader', '1'],
      ['x', 'Center', 'g--1-1', 'columnheader', '2'],
      ['area', 'Area', 'g--1-2', 'columnheader', '3'],
      ['name', 'Name', 'g--1-3', 'columnheader', '4'],
    ])
    expect(headings.map(({ ariaSort }) => ariaSort)).toEqual(['none', 'descending', 'none', 'none'])
    expect([body.role, body.style.height]).toEqual(['rowgroup', '200px'])
    expect(cell(2, 0)).toMatchObject({ role: 'gridcell', id: 'g-2-0', ariaReadOnly: 'true', textContent: '2/0' })
    expect(cell(2, 1)).toMatchObject({ ariaReadOnly: 'false' })
    expect([cell(2, 3).classList.contains('text'), cell(2, 1).classList.contains('text')]).toEqual([true, false])
    expect(cell(2, 0).parentElement).toMatchObject({
      ariaRowIndex: '4',
      ariaSelected: 'false',
      style: { transform: 'translateY(40px)' },
    })
    expect(world.mounted).toBe(1)
    grid.render()
    grid.dispose()
    expect([world.mounted, frames]).toEqual([0, []])
  })

  it('has elements for the rows that are seen and for the current one, and uses them again', () => {
    const { grid, draw, shown, body, done, cell, current } = gridOf()
    expect(shown()).toEqual([0, 1, 2, 3])
    Object.assign(world, { first: 5, last: 7 })
    grid.render()
    grid.render()
    expect(frames).toHaveLength(1)
    draw()
    expect(shown()).toEqual([0, 5, 6, 7])
    expect([body.children.length, textOf(cell(6, 0)), done]).toEqual([4, '6/0', [['seen', 5, 7]]])
    grid.goTo(6)
    draw()
    expect([shown(), current(), world.scrolled]).toEqual([[5, 6, 7], 'g-6-1', [[6, { align: 'auto' }]]])
    // A row that is not needed has no ids, so that no two elements share one.
    const free = all(body, '[hidden]')[0] as HTMLElement
    expect([[...free.children].map(({ id }) => id), free.dataset.row]).toEqual([['', '', '', ''], undefined])
    grid.render()
    draw()
    expect(done, 'the same rows').toHaveLength(1)
  })

  it('shows texts with their titles and labels, the current cell, and selected rows', () => {
    const { grid, draw, known, cell } = gridOf()
    known.cells.set('1 2', { text: '∞', title: 'all', label: 'without end' })
    known.selected.add(1)
    grid.render()
    draw()
    expect(cell(1, 2)).toMatchObject({ textContent: '∞', title: 'all', ariaLabel: 'without end' })
    expect([0, 1].map((row) => cell(row, 0).parentElement?.ariaSelected)).toEqual(['false', 'true'])
    expect([cell(0, 1), cell(0, 0), cell(1, 1)].map(({ classList }) => classList.contains('current'))).toEqual([
      true,
      false,
      false,
    ])
    known.cells.clear()
    grid.render()
    draw()
    expect(cell(1, 2)).toMatchObject({ textContent: '1/2', title: '', ariaLabel: null })
  })

  it('follows the number of rows, and stays in the last one', () => {
    const { grid, draw, known, table, current, shown } = gridOf()
    grid.goTo(9)
    known.rows = 3
    grid.render()
    draw()
    expect([table, current(), shown(), world.counted]).toMatchObject([{ ariaRowCount: '4' }, 'g-2-1', [0, 1, 2], [3]])
    known.rows = 0
    grid.render()
    draw()
    expect([current(), shown()]).toEqual(['g--1-1', []])
    grid.scrollToTop()
    expect(world.scrolled.at(-1)).toEqual(['offset', 0])
  })
})

describe('keys', () => {
  it('go to rows, alone or with all between, as far as there are any', () => {
    const { key, current, done } = gridOf()
    const ctrlKey = true
    for (const [name, more, row] of [
      ['ArrowDown', {}, 1],
      ['ArrowDown', { shiftKey: true }, 2],
      ['ArrowUp', {}, 1],
      // Five rows are as high as the grid. A page leaves out two.
      ['PageDown', {}, 4],
      ['PageDown', {}, 7],
      ['PageUp', {}, 4],
      ['End', { ctrlKey }, 9],
      ['ArrowDown', {}, 9],
      ['PageDown', {}, 9],
      ['Home', { ctrlKey }, 0],
      ['PageUp', {}, 0],
      ['End', { metaKey: true }, 9],
      ['Home', { metaKey: true }, 0],
    ] as const) {
      expect([name, key(name, more), current()]).toEqual([name, true, `g-${row}-1`])
      expect(done.filter(([name]) => name === 'choose').at(-1)).toEqual([
        'choose',
        row,
        'shiftKey' in more ? 'through' : 'only',
      ])
      expect(world.scrolled.at(-1)).toEqual([row, { align: 'auto' }])
    }
    done.length = 0
    expect([key('ArrowUp'), current(), key('ArrowUp'), current()]).toEqual([true, 'g--1-1', true, 'g--1-1'])
    expect(done, 'the heading is no row').toEqual([])
  })

  it('go to columns, as far as there are any', () => {
    const { key, current } = gridOf()
    const columnAfter = (name: string, more: object = {}) => {
      expect(key(name, more)).toBe(true)
      return current()?.at(-1)
    }
    expect(['ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowLeft'].map((name) => columnAfter(name))).toEqual([
      '2',
      '3',
      '3',
      '2',
    ])
    expect(['Home', 'ArrowLeft', 'End'].map((name) => columnAfter(name))).toEqual(['0', '0', '3'])
  })

  it('sort from the heading, and toggle a row', () => {
    const { key, done } = gridOf()
    key(' ')
    expect(done.pop()).toEqual(['choose', 0, 'toggle'])
    key('ArrowUp')
    for (const name of ['Enter', 'F2', ' ']) {
      key(name)
      expect(done.pop()).toEqual(['sort', 1])
    }
  })

  it('begin to edit a cell: digits and signs of numbers, all letters of texts', () => {
    for (const [name, column, more, isTyped] of [
      ['1', 1, {}, true],
      ['.', 1, {}, true],
      ['-', 1, {}, true],
      ['\u2212', 1, {}, true],
      ['a', 1, {}, false],
      ['1', 1, { ctrlKey: true }, false],
      ['1', 1, { altKey: true }, false],
      ['a', 3, {}, true],
      ['😀', 3, {}, true],
      ['Tab', 3, {}, false],
      ['Escape', 1, {}, false],
    ] as const) {
      const { key, input } = gridOf()
      for (let k = 1; k < column; k++) key('ArrowRight')
      expect([name, key(name, more), input()?.value]).toEqual([name, isTyped, isTyped ? name : undefined])
    }
    const { key, input } = gridOf()
    key('ArrowRight')
    key('1')
    expect(input(), 'the column is not editable').toBeNull()
  })

  it('in a field of the grid are not those of the grid', () => {
    const { dispatch, input, key, done } = gridOf()
    key('Enter')
    done.length = 0
    dispatch('keydown', input(), { key: 'ArrowDown' })
    expect(done).toEqual([])
  })
})

describe('clicks', () => {
  it('choose rows, sort by headings, and give the focus to the grid', () => {
    const { dispatch, cell, headings, done, current, table } = gridOf()
    dispatch('click', cell(2, 3))
    expect([done.pop(), current(), document.activeElement]).toEqual([['choose', 2, 'only'], 'g-2-3', table])
    for (const [more, how] of [
      [{ shiftKey: true }, 'through'],
      [{ ctrlKey: true }, 'toggle'],
      [{ metaKey: true }, 'toggle'],
    ] as const) {
      dispatch('click', cell(1, 0), more)
      expect(done.pop()).toEqual(['choose', 1, how])
    }
    dispatch('click', headings[2] as HTMLElement)
    expect([done, current()]).toEqual([[['sort', 2]], 'g-1-0'])
    dispatch('click', table)
    expect(done).toHaveLength(1)
  })

  it('twice edit a cell, not a heading', () => {
    const { dispatch, cell, headings, input, done } = gridOf()
    dispatch('dblclick', headings[1] as HTMLElement)
    expect(input()).toBeNull()
    dispatch('click', cell(2, 1))
    dispatch('dblclick', cell(2, 1))
    expect(input().parentElement).toBe(cell(2, 1))
    done.length = 0
    dispatch('click', input())
    expect(done, 'the cell is being edited').toEqual([])
  })
})

describe('a cell that is edited', () => {
  function editing(more: { column?: number; typed?: string } = {}) {
    const session = gridOf()
    session.grid.goTo(2)
    session.draw()
    for (let k = 1; k < (more.column ?? 1); k++) session.key('ArrowRight')
    session.key(more.typed ?? 'Enter')
    session.done.length = 0
    return session
  }

  it('begins with its text, or with what was typed', () => {
    const { input, grid } = editing()
    expect(input()).toMatchObject({
      value: 'w102/1',
      inputMode: 'decimal',
      ariaLabel: 'x of row 3',
      autocomplete: 'off',
      selectionStart: 0,
      selectionEnd: 6,
    })
    expect([grid.isEditing, document.activeElement]).toEqual([true, input()])
    expect(editing({ typed: '7' }).input()).toMatchObject({ value: '7', selectionStart: 1 })
    expect(editing({ column: 3 }).input()).toMatchObject({ inputMode: 'text', ariaLabel: 'name of row 3' })
  })

  it.each([
    ['Enter', {}, 3],
    ['Enter', { shiftKey: true }, 1],
  ])('is written at %s %j, which goes on to the next row', async (name, more, row) => {
    const { input, type, done, grid, current, table } = editing()
    input().value = '5'
    expect(await type(name, more)).toBe(true)
    expect(done).toEqual([
      ['write', 102, 1, '5'],
      ['choose', row, 'only'],
    ])
    expect([grid.isEditing, current(), document.activeElement]).toEqual([false, `g-${row}-1`, table])
  })

  it('in the last row stays there', async () => {
    const { grid, draw, key, type, current } = gridOf()
    grid.goTo(9)
    draw()
    key('Enter')
    await type('Enter')
    expect(current()).toBe('g-9-1')
  })

  it('is written at Tab, which goes along the editable cells', async () => {
    const { key, type, current } = editing()
    const along = async (more: object = {}) => {
      key('Enter')
      await type('Tab', more)
      return current()
    }
    await type('Tab')
    expect(current()).toBe('g-2-3')
    expect([await along(), await along({ shiftKey: true }), await along({ shiftKey: true })]).toEqual([
      'g-3-1',
      'g-2-3',
      'g-2-1',
    ])
    const first = gridOf()
    first.key('Enter')
    await first.type('Tab', { shiftKey: true })
    expect(first.current(), 'there is no cell before').toBe('g-0-1')
    const last = gridOf()
    last.grid.goTo(9)
    last.draw()
    for (const name of ['ArrowRight', 'ArrowRight', 'Enter']) last.key(name)
    await last.type('Tab')
    expect(last.current(), 'there is no cell after').toBe('g-9-3')
  })

  it('is not written where its text is the same, nor at Escape', async () => {
    const { type, done, grid, table, input } = editing()
    await type('a')
    expect([grid.isEditing, done]).toEqual([true, []])
    input().value = '5'
    await type('Escape')
    expect([grid.isEditing, done, document.activeElement]).toEqual([false, [], table])
    const same = editing()
    await same.type('Enter')
    expect(same.done).toEqual([['choose', 3, 'only']])
  })

  it('stays for correction where it is refused', async () => {
    const { input, type, done, known, grid, current } = editing()
    known.isTaken = false
    input().value = 'a'
    await type('Enter')
    expect([grid.isEditing, input(), current(), done]).toMatchObject([
      true,
      { ariaInvalid: 'true', value: 'a' },
      'g-2-1',
      [['write', 102, 1, 'a']],
    ])
    known.isTaken = true
    await type('Tab')
    expect(grid.isEditing).toBe(false)
  })

  it.each([true, false])('is written when it loses the focus, and closed: taken %s', async (isTaken) => {
    const { input, done, known, grid, current } = editing()
    known.isTaken = isTaken
    const field = input()
    field.value = '5'
    field.blur()
    field.dispatchEvent(new Event('blur'))
    expect(grid.isEditing, 'until it is written').toBe(true)
    await settled()
    expect([grid.isEditing, done, current(), field.parentElement]).toEqual([
      false,
      [['write', 102, 1, '5']],
      'g-2-1',
      null,
    ])
  })

  it('stays where it is refused while it has the focus', async () => {
    const { input, known, grid } = editing()
    known.isTaken = false
    input().value = 'a'
    input().dispatchEvent(new Event('blur'))
    await settled()
    expect(grid.isEditing).toBe(true)
  })

  it('belongs to its circle, wherever its row goes', async () => {
    const { input, done, grid, draw, type, cell } = editing()
    input().value = '5'
    grid.render()
    draw()
    expect(input().parentElement, 'it is not drawn over').toBe(cell(2, 1))
    grid.goTo(3)
    await type('Enter')
    expect(done[0]).toEqual(['write', 102, 1, '5'])
  })

  it('is canceled, which gives the focus to the grid if the field had it', () => {
    const { grid, table, input, done, draw, cell } = editing()
    const field = input()
    grid.cancelEdit()
    grid.cancelEdit()
    draw()
    expect([grid.isEditing, done, field.parentElement, document.activeElement, textOf(cell(2, 1))]).toEqual([
      false,
      [],
      null,
      table,
      '2/1',
    ])
    const other = editing()
    element('other').focus()
    other.grid.cancelEdit()
    expect(document.activeElement).toBe(element('other'))
  })

  it('that is canceled is not written as it loses the focus', async () => {
    const { grid, input, done } = editing()
    const field = input()
    field.value = '5'
    grid.cancelEdit()
    field.dispatchEvent(new Event('blur'))
    await settled()
    expect(done).toEqual([])
  })

  it('that is written leaves another one open that was begun meanwhile', async () => {
    const { input, dispatch, cell, grid, key } = editing()
    const field = input()
    field.value = '5'
    field.dispatchEvent(new Event('blur'))
    dispatch('click', cell(3, 1))
    key('Enter')
    await settled()
    expect([grid.isEditing, input().parentElement, field.parentElement]).toEqual([true, cell(3, 1), null])
  })

  it('is in sight', () => {
    editing()
    expect(world.scrolled.at(-1)).toEqual([2, { align: 'auto' }])
  })
})

describe('pasted text', () => {
  const dataOf = (text: string) => ({ clipboardData: { getData: () => text } })

  it('goes to the current cell', () => {
    const { dispatch, table, done } = gridOf()
    expect(dispatch('paste', table, dataOf('1'))).toBe(true)
    expect(done).toEqual([['paste', 0, 1, '1']])
  })

  it.each([
    ['1', false],
    [' 1\n', false],
    ['1\t2', true],
    ['1\n2', true],
    ['1;2', true],
  ])('in a field goes into the field if it is one number: %j', (text, isTable) => {
    const { dispatch, key, input, done, grid } = gridOf()
    key('Enter')
    done.length = 0
    expect(dispatch('paste', input(), dataOf(text))).toBe(isTable)
    expect([done, grid.isEditing]).toEqual([isTable ? [['paste', 0, 1, text]] : [], !isTable])
  })

  it('at the heading goes nowhere', () => {
    const { dispatch, key, table, done } = gridOf()
    key('ArrowUp')
    dispatch('paste', table, dataOf('1'))
    expect(done).toEqual([])
  })
})
