// SPDX-License-Identifier: GPL-3.0-or-later
// The table of circles on the whole page: its cells, keys, clicks, order and selection, and what is written and pasted.
// @vitest-environment happy-dom
import fc from 'fast-check'
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import { FilesClient } from '../../web/app/files/files-client.ts'
import { LinkWriter } from '../../web/app/link-writer.ts'
import { attributesOfLink, valueIn } from '../../web/editing/attributes.ts'
import { decodeLink, type LinkInput } from '../../web/lib/link.ts'
import { all, element, send, textOf } from './page-document.ts'
import { quiet, soon, wholePage } from './whole-page.ts'

const CIRCLES = Float64Array.of(0, 9, 1, 30.123456789, 5, 3, 60, 7, 2, 30, 20, 1)
const COLUMNS = [
  { name: 'name', values: ['"b 10"', '"b 9"', '', '"a"'] },
  { name: 'n', values: ['3', '', '1', '2'] },
]

let page: Awaited<ReturnType<typeof wholePage>>
const grid = () => element('circle-grid')
const headings = () => all(grid(), '[role=columnheader]')
const columnOf = (name: string) => headings().findIndex((heading) => textOf(heading) === name)
const rows = () =>
  all(grid(), '[role=rowgroup] [role=row]')
    .filter(({ hidden }) => !hidden)
    .sort((a, b) => Number(a.ariaRowIndex) - Number(b.ariaRowIndex))
const ids = () => rows().map(({ children }) => Number(textOf(children[0])))
const cell = (id: number, column: string) => {
  const row = rows().find(({ children }) => textOf(children[0]) === String(id))
  return row?.children[columnOf(column)] as HTMLElement
}
const texts = (column: string) => rows().map(({ children }) => textOf(children[columnOf(column)]))
/** The id of the current row and the name of the current column. */
const current = () => {
  const found = element(grid().getAttribute('aria-activedescendant') ?? '')
  const name = textOf(headings()[Number(found.ariaColIndex) - 1])
  return found.role === 'columnheader' ? `heading ${name}` : `${textOf(found.parentElement?.children[0])} ${name}`
}
const input = () => grid().querySelector('input')
const field = () => input() as HTMLInputElement
const selection = () => page.store.get().selection
const problem = () => page.store.get().problem

async function key(name: string, more: object = {}) {
  const { defaultPrevented } = send(document.activeElement as Element, 'keydown', { key: name, ...more })
  await quiet()
  return defaultPrevented
}
async function click(target: Element | undefined, more: object = {}, type = 'click') {
  send(target as Element, type, more)
  await quiet()
}
async function write(text: string, end = 'Enter', more: object = {}) {
  field().value = text
  await key(end, more)
}
async function paste(text: string) {
  const { defaultPrevented } = send(document.activeElement as Element, 'paste', {
    clipboardData: { getData: () => text },
  })
  await quiet()
  return defaultPrevented
}
/** Begins to edit a cell by two clicks. */
async function edit(id: number, column: string) {
  for (const type of ['click', 'dblclick']) await click(cell(id, column), {}, type)
}

/** Sorts the rows by number, if they are not. */
async function byNumber() {
  while (headings()[0]?.ariaSort !== 'ascending') await click(headings()[0])
}

beforeAll(async () => {
  page = await wholePage()
  // Five rows are as high as the grid.
  for (const name of ['offsetHeight', 'clientHeight']) {
    Object.defineProperty(HTMLElement.prototype, name, {
      configurable: true,
      get(this: HTMLElement) {
        return this.id === 'circle-grid' ? 100 : this.role === 'row' ? 20 : 0
      },
    })
  }
  await page.panel('table')
})
beforeEach(async () => {
  await page.open(CIRCLES, COLUMNS)
  await soon(() => expect([headings().length, ids().length]).toEqual([9, 4]))
  await byNumber()
  await soon(() => expect(ids()).toEqual([0, 1, 2, 3]))
  await soon(() => expect(texts('nbrs')).toEqual(['2', '3', '2', '3']))
  grid().focus()
})
// Rows by number are not sorted again a while after the next circles are opened.
afterEach(async () => {
  vi.useRealTimers()
  await byNumber()
})

describe('the cells of the table of circles', () => {
  it('round long numbers of a file and keep whole ones and texts', async () => {
    const values = ['37.142857142857146', '1234567890123', '"37.142857142857146"', '0.000012345678912']
    await page.open(CIRCLES, [{ name: 'long', values }])
    await soon(() => expect(texts('long')).toEqual(['37.1429', '1234567890123', '37.142857142857146', '0.0000123']))
    expect(cell(0, 'long').title).toBe('37.142857142857146')
  })

  it('have the numbers of circles, their columns, and what is measured', () => {
    expect(headings().map(textOf)).toEqual(['#', 'x', 'y', 'r', 'area', 'nbrs', 'nearest', 'name', 'n'])
    expect(['x', 'area', 'nearest', 'name', 'n'].map(texts)).toEqual([
      ['0', '30.1235', '60', '30'],
      ['∞', '∞', '∞', '∞'],
      ['26.39', '11', '24.94', '11'],
      ['b 10', 'b 9', '', 'a'],
      ['3', '', '1', '2'],
    ])
    expect(cell(1, 'x').title).toBe('30.123456789')
    const roles = ['x', 'area'].map((name) => [
      cell(1, name).role,
      cell(1, name).ariaReadOnly,
      cell(1, name).ariaColIndex,
    ])
    expect(roles).toEqual([
      ['gridcell', 'false', '2'],
      ['gridcell', 'true', '5'],
    ])
    expect([grid().ariaRowCount, grid().ariaColCount, rows()[1]?.ariaRowIndex]).toEqual(['5', '9', '3'])
    expect([cell(1, 'name'), cell(1, 'n')].map(({ classList }) => classList.contains('text'))).toEqual([true, false])
  })

  it('of hidden circles have no measure, and numbers are at most nine letters long', async () => {
    await page.open(Float64Array.of(-12345.678901, 0, 9, -12345, 0, 1, -1.23456789e-10, 0, 1, -1.23456789e-100, 50, 1))
    await soon(() => expect(texts('area')).toEqual(['∞', '–', '∞', '∞']))
    expect(texts('x')).toEqual(['-12345.7', '-12345', '-1.23e-10', '-1.2e-100'])
  })
})

it('a name of any length is in the link, or refused in one sentence', async () => {
  const kept = async () => attributesOfLink(await decodeLink(await linkNow()), 4)?.columns[0]?.values[1]
  const linkNow = () => new LinkWriter(new FilesClient()).linkOf(page.actions.opening.linkState() as LinkInput)
  const letter = fc.string({ unit: 'grapheme', minLength: 1, maxLength: 5 }).filter((text) => text.trim() === text)
  await fc.assert(
    fc.asyncProperty(letter, fc.constantFrom(1, 9, 200, 900, 5000, 20_000), async (letters, times) => {
      const [before, text] = [valueIn(page.editing.attributes, 'name', 1), letters.repeat(times)]
      page.actions.messages.complain('')
      await edit(1, 'name')
      await write(text)
      if (problem() !== '') {
        expect(problem()).toMatch(/^Circle 1: .*\.$/)
        expect([valueIn(page.editing.attributes, 'name', 1), text.length > 4000]).toEqual([before, true])
        await key('Escape')
      }
      expect(await kept()).toBe(problem() === '' ? JSON.stringify(text) : before)
    }),
    { numRuns: 20 },
  )
})

it('measures are there again after a question that was refused', async () => {
  const asking = vi.spyOn(page.view.scene, 'ask').mockRejectedValueOnce(new Error('refused'))
  await page.actions.circles.edit([{ kind: 'replace', id: 0, circle: [0, 8, 1] }])
  await quiet()
  await page.actions.circles.edit([{ kind: 'remove', id: 3 }])
  await soon(() => expect(texts('nbrs')).toEqual(['2', '2', '2']))
  asking.mockRestore()
})

describe('the rows of the table', () => {
  it.each([
    ['#', [3, 2, 1, 0], [0, 1, 2, 3]],
    ['x', [0, 3, 1, 2], [2, 1, 3, 0]],
    ['y', [1, 2, 0, 3], [3, 0, 2, 1]],
    ['nbrs', [0, 2, 1, 3], [1, 3, 0, 2]],
    ['nearest', [1, 3, 2, 0], [0, 2, 1, 3]],
    ['name', [3, 1, 0, 2], [0, 1, 3, 2]],
    ['n', [2, 3, 0, 1], [0, 3, 2, 1]],
  ])('are sorted by %s at a click, and the other way at the next', async (name, first, second) => {
    const directions = () => headings().flatMap(({ ariaSort }) => (ariaSort === 'none' ? [] : [ariaSort]))
    const ways = name === '#' ? ['descending', 'ascending'] : ['ascending', 'descending']
    for (const [k, order] of [first, second].entries()) {
      await click(headings()[columnOf(name)])
      await soon(() => expect([ids(), directions()]).toEqual([order, [ways[k]]]))
    }
  })

  it('are sorted by the column that was chosen last, whichever is measured first', async () => {
    for (const name of ['area', 'nearest', 'nbrs']) send(headings()[columnOf(name)] as Element, 'click')
    await soon(() => expect(ids()).toEqual([0, 2, 1, 3]))
    await quiet()
    expect(ids()).toEqual([0, 2, 1, 3])
  })

  it('keep their places during edits, with new ones last, and are sorted again after a pause', async () => {
    await click(headings()[columnOf('y')])
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
    await page.editing.edit([
      { kind: 'replace', id: 1, circle: { x: 0, y: 99, r: 1 } },
      { kind: 'insert', circle: { x: 90, y: 8, r: 1 } },
      { kind: 'remove', id: 2 },
    ])
    await quiet()
    expect(ids()).toEqual([1, 0, 3, 4])
    await vi.advanceTimersByTimeAsync(1000)
    vi.useRealTimers()
    await soon(() => expect(ids()).toEqual([4, 0, 3, 1]))
  })
})

describe('keys in the table', () => {
  it.each([
    ['x', '1', {}, '1'],
    ['x', '.', {}, '.'],
    ['x', '\u2212', {}, '\u2212'],
    ['x', 'Enter', {}, '30.123456789'],
    ['x', 'F2', {}, '30.123456789'],
    ['name', 'a', {}, 'a'],
    ['name', '😀', {}, '😀'],
    ['x', 'a', {}, undefined],
    ['x', '1', { ctrlKey: true }, undefined],
    ['x', '1', { altKey: true }, undefined],
    ['name', 'Tab', {}, undefined],
    ['area', '1', {}, undefined],
  ])('begin to edit a cell of %s: %s %j', async (column, name, more, text) => {
    await click(cell(1, column))
    await key(name, more)
    expect(input()?.value).toBe(text)
    if (input() !== null) await key('Escape')
  })
})

describe('clicks in the table', () => {
  it('choose one row, toggle rows, or choose all rows since the last one', async () => {
    await click(headings()[columnOf('y')])
    grid().blur()
    for (const [id, more, chosen] of [
      [3, {}, [3]],
      [0, { shiftKey: true }, [0, 3]],
      [1, { shiftKey: true }, [1, 2, 0, 3]],
      [0, { ctrlKey: true }, [1, 2, 3]],
      [2, { shiftKey: true }, [2, 0]],
      [2, { metaKey: true }, [0]],
    ] as const) {
      await click(cell(id, 'n'), more)
      expect([selection(), current()]).toEqual([chosen, `${id} n`])
      expect(rows().filter(({ ariaSelected }) => ariaSelected === 'true')).toHaveLength(chosen.length)
    }
    expect(document.activeElement).toBe(grid())
  })

  it('choose all rows since the circle that was selected last, also in the picture', async () => {
    page.actions.selection.select([1])
    await quiet()
    await click(cell(3, 'n'), { shiftKey: true })
    expect(selection()).toEqual([1, 2, 3])
  })

  it('are not needed where a circle is selected elsewhere, which becomes the current row', async () => {
    await click(cell(0, 'x'))
    page.actions.selection.select([2])
    await quiet()
    expect(current()).toBe('2 x')
    page.actions.selection.select([0, 1])
    await quiet()
    expect(current()).toBe('2 x')
    await edit(1, 'y')
    page.actions.selection.select([3])
    await quiet()
    expect([input()?.parentElement, current()]).toEqual([cell(1, 'y'), '1 y'])
    await key('Escape')
  })
})

describe('a cell that is edited', () => {
  it.each([
    ['Enter', {}, '2 y', 2.5],
    ['Enter', { shiftKey: true }, '0 y', 2.5],
    ['Tab', {}, '1 r', 2.5],
    ['Tab', { shiftKey: true }, '1 x', 2.5],
    ['Escape', {}, '1 y', 5],
  ])('is written in one step at %s %j, which goes on', async (name, more, place, y) => {
    const steps = page.store.get().history.done.length
    await edit(1, 'y')
    await write(' 2,5 ', name, more)
    expect([page.circle(1), current(), document.activeElement]).toEqual([{ x: 30.123456789, y, r: 3 }, place, grid()])
    expect([input(), page.store.get().history.done.length - steps]).toEqual([null, y === 5 ? 0 : 1])
  })

  it('goes on from the last editable cell of a row to the next row, and stays at both ends', async () => {
    for (const [id, column, more, place] of [
      [1, 'n', {}, '2 x'],
      [1, 'x', { shiftKey: true }, '0 n'],
      [0, 'x', { shiftKey: true }, '0 x'],
      [3, 'n', {}, '3 n'],
    ] as const) {
      await edit(id, column)
      await key('Tab', more)
      expect(current()).toBe(place)
    }
    await edit(3, 'x')
    await key('Enter')
    expect(current()).toBe('3 x')
  })

  it('is written when it loses the focus, and closed even if it is refused', async () => {
    for (const [text, r] of [
      ['4', 4],
      ['a', 4],
    ] as const) {
      await edit(1, 'r')
      field().value = text
      field().blur()
      await quiet()
      expect([input(), page.circle(1)?.r]).toEqual([null, r])
    }
  })
})

describe('a text that is pasted into the table', () => {
  const pasteAt = async (id: number, column: string, text: string) => {
    await click(cell(id, column))
    await paste(text)
  }

  it('goes into a column of texts line by line, as one step', async () => {
    await pasteAt(1, 'name', 'Kiel\tX\r\nBonn\r\n')
    expect(texts('name')).toEqual(['b 10', 'Kiel\tX', 'Bonn', 'a'].map((name) => name.replace('\t', ' ')))
    await page.actions.circles.undo()
    await quiet()
    expect(texts('name')).toEqual(['b 10', 'b 9', '', 'a'])
    await pasteAt(3, 'name', 'Kiel\nBonn')
    expect(texts('name')).toEqual(['b 10', 'b 9', '', 'Kiel'])
  })

  it.each([
    ['x', 'a\tb'],
    ['area', '1\t2'],
    ['r', '1\t2'],
    ['n', '1\na'],
    ['x', '100\t5\t-6'],
  ])('into %s as %j is a problem, and changes nothing', async (column, text) => {
    await pasteAt(0, column, text)
    expect(problem()).not.toBe('')
    expect(texts('n')).toEqual(['3', '', '1', '2'])
    expect([...page.editing.circles.circles()]).toEqual([...CIRCLES])
  })

  it.each([
    ['1', false],
    [' 1\n', false],
    ['1\t2', true],
    ['1\n2', true],
    ['1;2', true],
  ])('goes into the open field if it is one number: %j', async (text, isTable) => {
    await edit(1, 'x')
    expect(await paste(text)).toBe(isTable)
    expect([input() === null, page.circle(1)?.x === 30.123456789]).toEqual([isTable, !isTable])
    if (!isTable) await key('Escape')
  })
})
