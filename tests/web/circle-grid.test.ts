// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the table of circles: cells, sorting, selecting, writing and pasting, with a grid that notes its calls.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { PageActions } from '../../web/app/page-actions.ts'
import { CircleGrid } from '../../web/app/table/circle-grid.ts'
import { NO_ATTRIBUTES } from '../../web/editing/attributes.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { editingSession, sceneOf } from './editing-session.ts'
import { settled } from './turns.ts'

const { grid, done } = vi.hoisted(() => ({ grid: { isEditing: false }, done: [] as unknown[][] }))
vi.mock('../../web/app/table/grid.ts', () => ({
  Grid: class {
    get isEditing() {
      return grid.isEditing
    }
    render() {
      done.push(['render'])
    }
    goTo(row: number) {
      done.push(['goTo', row])
    }
    cancelEdit() {
      done.push(['cancelEdit'])
    }
    scrollToTop() {
      done.push(['scrollToTop'])
    }
    dispose() {
      done.push(['dispose'])
    }
  },
}))

beforeEach(() => {
  grid.isEditing = false
  done.length = 0
  vi.stubGlobal('requestAnimationFrame', (act: () => void) => queueMicrotask(act))
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.useRealTimers()
})

const CIRCLES = [0, 9, 1, 30.123456789, 5, 3, 60, 7, 2]
const COLUMNS = [
  { name: 'name', values: ['"b 10"', '"b 9"', ''] },
  { name: 'n', values: ['3', '', '1'] },
]

async function started({ circles = CIRCLES, columns = COLUMNS as readonly (typeof COLUMNS)[number][] } = {}) {
  const session = editingSession()
  const { store, editing, view, fake } = session
  const actions = new PageActions(store, editing, view, () => NO_PADDING, {} as never)
  const answers: ((answer: unknown) => void)[] = []
  const asked: unknown[][] = []
  fake.ask = (...what: unknown[]) => {
    asked.push(what)
    return new Promise((resolve) => answers.push(resolve))
  }
  const attributes = columns.length === 0 ? undefined : { ...NO_ATTRIBUTES, columns }
  await editing.open({ ...sceneOf(Float64Array.from(circles)), attributes })
  await settled()
  const styles = new Map<string, string>()
  const classes = new Map<string, boolean>()
  const element = {
    style: { setProperty: (name: string, value: string) => styles.set(name, value) },
    classList: { toggle: (name: string, isOn: boolean) => classes.set(name, isOn) },
  }
  const table = new CircleGrid(element as never, store, editing, actions, view)
  store.subscribe((state) => table.update(state))
  const ids = () => Array.from({ length: table.rows() }, (_, row) => table.idOf(row))
  const column = (name: string) => table.headings.findIndex((heading) => heading.name === name)
  const texts = (name: string) => ids().map((_, row) => table.cell(row, column(name)).text)
  const selection = () => store.get().selection
  const problem = () => store.get().problem
  const answer = async (answer: unknown) => {
    answers.shift()?.(answer)
    await settled()
  }
  return { ...session, actions, asked, answers, answer, table, styles, classes, ids, column, texts, selection, problem }
}

describe('cells', () => {
  it('have the numbers of circles, shortened to the column, and the columns of the file', async () => {
    const { table, column, texts, styles, classes } = await started()
    expect(table.headings.map(({ name, isEditable, isText }) => [name, isEditable, isText])).toEqual([
      ['#', false, undefined],
      ['x', true, undefined],
      ['y', true, undefined],
      ['r', true, undefined],
      ['area', false, undefined],
      ['nbrs', false, undefined],
      ['nearest', false, undefined],
      ['name', true, true],
      ['n', true, false],
    ])
    expect(table.headings.slice(-2).map(({ title }) => title)).toEqual(['name, of the file', 'n, of the file'])
    expect([styles.get('--data-columns'), classes.get('has-data')]).toEqual(['2', true])
    expect([texts('#'), texts('x'), texts('name'), texts('n')]).toEqual([
      ['0', '1', '2'],
      ['0', '30.1235', '60'],
      ['b 10', 'b 9', ''],
      ['3', '', '1'],
    ])
    expect(table.cell(1, column('x')).title).toBe('30.123456789')
    expect(table.cell(7, column('x'))).toEqual({ text: '' })
  })

  it('are nine letters long at most, with two digits or more', async () => {
    const { texts } = await started({ circles: [-12345.678901, 0, 1, -1.23456789e-10, 0, 1, -1.23456789e-100, 0, 1] })
    expect(texts('x')).toEqual(['-12345.7', '-1.23e-10', '-1.2e-100'])
  })

  it('of names can be written where there are none', async () => {
    const { table, column, styles, classes, editing } = await started({ columns: [] })
    expect(table.headings.at(-1)).toEqual({ name: 'name', title: 'Name of the circle', isEditable: true, isText: true })
    expect([styles.get('--data-columns'), classes.get('has-data')]).toEqual(['1', false])
    expect(await table.write(1, column('name'), 'Kiel')).toBe(true)
    expect(editing.nameOf(1)).toBe('Kiel')
  })

  it('of measures are asked for in the rows that are seen, one request at a time', async () => {
    const { table, asked, answer, texts, editing } = await started()
    const MEASURED = ['area', 'degree', 'gap']
    expect(asked, 'nothing is seen yet').toEqual([])
    table.seen(0, 1)
    table.seen(1, 1)
    table.seen(1, 2)
    expect(asked).toEqual([['tabulate', MEASURED, Int32Array.of(0, 1)]])
    done.length = 0
    await answer({ ids: Int32Array.of(0), columns: [[7], [7], [7]] })
    expect(asked.slice(1)).toEqual([['tabulate', MEASURED, Int32Array.of(1, 2)]])
    expect(done, 'drawn once').toEqual([])
    const columns = [
      [Number.NaN, Number.POSITIVE_INFINITY],
      [3, 4],
      [-0.123456, 2],
    ]
    await answer({ ids: Int32Array.of(1, 2), columns })
    expect(done).toEqual([['render']])
    expect([texts('area'), texts('nbrs'), texts('nearest')]).toEqual([
      ['', '–', '∞'],
      ['', '3', '4'],
      ['', '-0.1235', '2'],
    ])
    expect([1, 2].map((row) => table.cell(row, 4).label)).toEqual(['hidden', 'without end'])
    await editing.edit([{ kind: 'replace', id: 1, circle: { x: 0, y: 99, r: 1 } }])
    await settled()
    expect(asked.splice(0), 'again after an edit').toHaveLength(3)
    await editing.open(sceneOf(Float64Array.from(CIRCLES)))
    await settled()
    expect(texts('area'), 'of other circles').toEqual(['', '', ''])
  })
})

describe('rows', () => {
  it('are sorted by a column, and the other way again, and by another column up', async () => {
    const { table, column, ids } = await started()
    const sorted = async (name: string) => {
      await table.sort(column(name))
      return [ids(), table.sortOf(column(name))]
    }
    expect(table.sortOf(0)).toBe('ascending')
    expect(await sorted('#')).toEqual([[2, 1, 0], 'descending'])
    expect(await sorted('y')).toEqual([[1, 2, 0], 'ascending'])
    expect(await sorted('y')).toEqual([[0, 2, 1], 'descending'])
    expect(await sorted('r')).toEqual([[0, 2, 1], 'ascending'])
    expect(table.sortOf(column('y'))).toBe('none')
    expect(await sorted('n')).toEqual([[2, 0, 1], 'ascending'])
    expect(await sorted('name')).toEqual([[1, 0, 2], 'ascending'])
    expect(done.filter(([name]) => name === 'scrollToTop')).toHaveLength(6)
  })

  it('are sorted by a measure once it is known, unless another column is chosen meanwhile', async () => {
    const { table, column, ids, asked, answer, answers, actions, editing } = await started()
    const first = table.sort(column('area'))
    expect([asked, table.sortOf(column('area')), ids()]).toEqual([
      [['tabulate', ['area'], undefined]],
      'ascending',
      [0, 1, 2],
    ])
    const tabulated = { ids: Int32Array.of(0, 1, 2), columns: [[3, 2, 1]] }
    await answer(tabulated)
    await first
    expect(ids()).toEqual([2, 1, 0])
    actions.select([1])
    await editing.edit([{ kind: 'replace', id: 1, circle: { x: 0, y: 99, r: 1 } }])
    await settled()
    done.length = 0
    await vi.advanceTimersByTimeAsync(300)
    expect(done, 'the measures are not known yet').not.toContainEqual(['goTo', 1])
    await answer({ ids: Int32Array.of(0, 1, 2), columns: [[3, 1, 2]] })
    expect([ids(), done.filter(([name]) => name === 'goTo')]).toEqual([[1, 2, 0], [['goTo', 0]]])
    await editing.edit([{ kind: 'replace', id: 1, circle: { x: 0, y: 98, r: 1 } }])
    await settled()
    await vi.advanceTimersByTimeAsync(300)
    done.length = 0
    grid.isEditing = true
    await answer({ ids: Int32Array.of(0, 1, 2), columns: [[3, 1, 2]] })
    expect(
      done.filter(([name]) => name === 'goTo'),
      'while a cell is edited',
    ).toEqual([])
    grid.isEditing = false
    const late = table.sort(column('nearest'))
    await table.sort(column('y'))
    for (const act of answers.splice(0)) act(tabulated)
    await late
    expect([ids(), table.sortOf(column('y'))]).toEqual([[2, 0, 1], 'ascending'])
  })

  it('keep their places during edits, new ones are last, and are sorted again after a pause', async () => {
    const { table, column, ids, editing, actions } = await started()
    await table.sort(column('y'))
    expect(ids()).toEqual([1, 2, 0])
    await editing.edit([{ kind: 'replace', id: 1, circle: { x: 0, y: 99, r: 1 } }])
    await settled()
    await actions.add([{ x: 90, y: 8, r: 1 }])
    await editing.edit([{ kind: 'remove', id: 2 }])
    await settled()
    expect(ids()).toEqual([1, 0, 3])
    done.length = 0
    await vi.advanceTimersByTimeAsync(299)
    expect(ids()).toEqual([1, 0, 3])
    await vi.advanceTimersByTimeAsync(1)
    await settled()
    expect(ids()).toEqual([3, 0, 1])
    // The new circle is selected.
    expect(done.filter(([name]) => name === 'goTo')).toEqual([['goTo', 0]])
  })

  it('are not sorted while a cell is edited', async () => {
    const { table, column, ids, editing } = await started()
    await table.sort(column('y'))
    await editing.edit([{ kind: 'replace', id: 1, circle: { x: 0, y: 99, r: 1 } }])
    await settled()
    grid.isEditing = true
    await vi.advanceTimersByTimeAsync(1000)
    expect(ids()).toEqual([1, 2, 0])
    grid.isEditing = false
    await vi.advanceTimersByTimeAsync(300)
    await settled()
    expect(ids()).toEqual([2, 0, 1])
  })

  it('by number are those of the circles at once', async () => {
    const { table, ids, editing, actions } = await started()
    done.length = 0
    await editing.edit([{ kind: 'remove', id: 1 }])
    await actions.add([{ x: 90, y: 8, r: 1 }])
    await settled()
    expect(ids()).toEqual([0, 2, 3])
    expect(done.map(([name]) => name)).not.toContain('cancelEdit')
    await editing.open(sceneOf(Float64Array.of(0, 0, 1)))
    await settled()
    expect([ids(), done.filter(([name]) => name === 'cancelEdit').length]).toEqual([[0], 1])
    await table.sort(0)
    await actions.add([{ x: 90, y: 8, r: 1 }])
    await settled()
    expect(ids()).toEqual([1, 0])
  })

  it('of a table that is gone are not sorted any more', async () => {
    const { table, column, answer, ids, editing } = await started()
    await table.sort(column('y'))
    await editing.edit([{ kind: 'replace', id: 1, circle: { x: 0, y: 99, r: 1 } }])
    await settled()
    const sorting = table.sort(column('area'))
    table.dispose()
    await answer({ ids: Int32Array.of(0, 1, 2), columns: [[3, 2, 1]] })
    await sorting
    await vi.advanceTimersByTimeAsync(1000)
    expect([ids(), done.at(-1)?.[0]]).toEqual([[1, 2, 0], 'scrollToTop'])
  })
})

describe('the selection', () => {
  it('is one row, toggled rows, or all rows since the last one', async () => {
    const { table, column, selection } = await started({ circles: [...CIRCLES, 90, 6, 1] })
    await table.sort(column('y'))
    const choose = (row: number, how: 'only' | 'toggle' | 'through') => {
      table.choose(row, how)
      return selection()
    }
    // The rows are the circles 1, 3, 2, 0.
    expect(choose(1, 'only')).toEqual([3])
    expect(choose(3, 'through')).toEqual([3, 2, 0])
    expect(choose(0, 'through')).toEqual([1, 3])
    expect(choose(3, 'toggle')).toEqual([1, 3, 0])
    expect(choose(2, 'through')).toEqual([2, 0])
    await settled()
    expect([0, 1, 2, 3].map((row) => table.isSelected(row))).toEqual([false, false, true, true])
  })

  it('made elsewhere is brought into view, and begins the next range', async () => {
    const { table, actions, selection } = await started()
    const shown = () => done.splice(0).filter(([name]) => name === 'goTo')
    table.choose(2, 'only')
    await settled()
    expect(shown(), 'made here').toEqual([])
    actions.select([1])
    await settled()
    expect(shown()).toEqual([['goTo', 1]])
    table.choose(2, 'through')
    expect(selection()).toEqual([1, 2])
    await settled()
    actions.select([0, 1])
    await settled()
    expect(shown(), 'of several').toEqual([])
    grid.isEditing = true
    actions.select([0])
    await settled()
    expect(shown(), 'during an edit').toEqual([])
    expect(table.isSelected(0)).toBe(true)
  })
})

describe('writing', () => {
  it('begins with the whole number or text', async () => {
    const { table, column } = await started()
    expect(table.written(1, column('x'))).toBe('30.123456789')
    expect([table.written(0, column('name')), table.written(2, column('n')), table.written(9, column('x'))]).toEqual([
      'b 10',
      '1',
      '',
    ])
  })

  it('changes one number of a circle, or says what is wrong', async () => {
    const { table, column, editing, problem } = await started()
    expect(await table.write(1, column('y'), ' 2,5 ')).toBe(true)
    expect(editing.circles.get(1)).toMatchObject({ x: 30.123456789, y: 2.5, r: 3 })
    expect(await table.write(1, column('r'), 'a')).toBe(false)
    expect(problem()).toBe('“a” is not a number. Nothing has changed.')
    expect(await table.write(1, column('r'), '-1')).toBe(false)
    expect(problem()).toMatch(/negative/)
    expect(await table.write(9, column('r'), 'a'), 'the circle is gone').toBe(true)
  })

  it('changes a value of a column, or says what is wrong', async () => {
    const { table, column, editing, problem } = await started()
    expect(await table.write(1, column('name'), 'Kiel')).toBe(true)
    expect(await table.write(1, column('n'), '7')).toBe(true)
    expect([editing.valueOf(1, 'name'), editing.valueOf(1, 'n')]).toEqual(['"Kiel"', '7'])
    expect(await table.write(0, column('n'), 'a')).toBe(false)
    expect([problem(), editing.valueOf(0, 'n')]).toEqual(['“a” is not a number. Nothing has changed.', '3'])
  })
})

describe('pasting', () => {
  it('goes into rows from a cell on, and into new circles below', async () => {
    const { table, column, editing, selection } = await started()
    await table.sort(column('y'))
    await table.paste(1, column('y'), '10\t1\n11\t2\n')
    expect([editing.circles.get(2), editing.circles.get(0)]).toMatchObject([
      { x: 60, y: 10, r: 1 },
      { x: 0, y: 11, r: 2 },
    ])
    await table.paste(2, column('#'), '1\t2\t3\n100\t5\t6')
    expect([editing.circles.get(0), editing.circles.get(3)]).toMatchObject([
      { x: 1, y: 2, r: 3 },
      { x: 100, y: 5, r: 6 },
    ])
    expect(selection()).toEqual([0, 3])
  })

  it('goes into a column of texts, line by line, as one step', async () => {
    const { table, column, editing, actions } = await started()
    await table.paste(1, column('name'), 'Kiel\tX\r\nBonn\r\n')
    expect([0, 1, 2].map((id) => editing.nameOf(id))).toEqual(['b 10', 'Kiel\tX', 'Bonn'])
    await actions.undo()
    expect([0, 1, 2].map((id) => editing.nameOf(id))).toEqual(['b 10', 'b 9', ''])
    await table.paste(2, column('name'), 'Kiel\nBonn')
    expect(editing.nameOf(2), 'there is no row below').toBe('Kiel')
  })

  it.each([
    ['x', 'a\tb', '“a” is not a number. Nothing has changed.'],
    ['area', '1\t2', 'Numbers can be pasted into x, y and r.'],
    ['r', '1\t2', 'There are 2 columns to paste and only r to take them.'],
    ['n', '1\na', '“a” is not a number. Nothing has changed.'],
  ])('into %s of %j changes nothing and says why', async (name, text, said) => {
    const { table, column, problem, circles } = await started()
    const before = circles()
    await table.paste(0, column(name), text)
    await settled()
    expect([problem(), circles()]).toEqual([said, before])
  })

  it('of many circles selects the new ones, and none where it is refused', async () => {
    const { table, selection, problem } = await started()
    await table.paste(0, 1, '100\t5\t-6')
    expect([selection(), problem()]).toEqual([[], expect.stringMatching(/negative/)])
    await table.paste(3, 1, '100\t5\t6\n200\t5\t6')
    expect(selection()).toEqual([3, 4])
  })
})
