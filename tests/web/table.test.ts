// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { editsOf, notANumber, numberOf, rowsOf } from '../../web/app/table/numbers-written.ts'
import { BY_ID, COLUMNS, isMeasured, ordered, placesOf } from '../../web/app/table/order.ts'
import { circleAt } from '../../web/lib/index.ts'
import { CircleTable, NO_CHANGE } from '../../web/view/circle-table.ts'
import { cellArea } from '../../web/view/painter/measures.ts'
import { Picture } from '../../web/view/painter/picture.ts'
import { tabulated, tabulatedAll } from '../../web/view/painter/tabulate.ts'
import { dataSet, library } from './library.ts'

const FOUR = Float64Array.of(3, 0, 1, 1, 9, 2, 2, 5, 1, 1, 7, 4)

describe('the order of rows', () => {
  const by = (column: (typeof COLUMNS)[number], isDescending = false) => [
    ...ordered(new CircleTable(FOUR), { column, isDescending }),
  ]

  it('is by any column, both ways, and of equal numbers by id', () => {
    expect(by('id')).toEqual([0, 1, 2, 3])
    expect(by('id', true)).toEqual([3, 2, 1, 0])
    expect(by('x')).toEqual([1, 3, 2, 0])
    expect(by('x', true)).toEqual([0, 2, 1, 3])
    expect(by('r')).toEqual([0, 2, 1, 3])
  })

  it('has what the thread has measured, and last those without a number', () => {
    const circles = new CircleTable(FOUR)
    circles.follow({ ...NO_CHANGE, removed: Int32Array.of(1) })
    const table = { ids: Int32Array.of(0, 2, 3), columns: [Float64Array.of(Number.NaN, Number.POSITIVE_INFINITY, 2)] }
    expect([...ordered(circles, { column: 'area', isDescending: false }, table)]).toEqual([3, 2, 0])
    expect([...ordered(circles, { column: 'area', isDescending: true }, table)]).toEqual([2, 3, 0])
    // Rows without a measure yet are ordered by id.
    expect([...ordered(circles, { column: 'gap', isDescending: true })]).toEqual([0, 2, 3])
    expect([...placesOf(Int32Array.of(3, 0, 2))]).toEqual([1, -1, 2, 0])
    expect(ordered(new CircleTable(new Float64Array()), BY_ID)).toHaveLength(0)
  })

  it('knows which columns are measured', () => {
    expect(COLUMNS.filter(isMeasured)).toEqual(['area', 'degree', 'gap'])
  })
})

describe('numbers as they are written', () => {
  it('are those of programs and of spreadsheets', () => {
    for (const [text, value] of [
      ['1', 1],
      [' -2.5 ', -2.5],
      ['1e-3', 0.001],
      ['.5', 0.5],
      ['3.', 3],
      ['1,5', 1.5],
      ['−4', -4],
    ] as const) {
      expect(numberOf(text), text).toBe(value)
    }
    for (const text of ['', 'x', '1 2', '0x10', 'Infinity', 'NaN', '1,2,3', '1.2.3', '--1', '1e']) {
      expect(numberOf(text), text).toBeUndefined()
    }
  })

  it('that are none are quoted in part, if they are long', () => {
    expect(notANumber(` ${'a'.repeat(41)}`)).toBe(`“${'a'.repeat(40)}” is not a number. Nothing has changed.`)
  })

  it('come in rows, with a heading or without', () => {
    const rows = [
      [1, 2, 3],
      [4, 5, 6.5],
    ]
    expect(rowsOf('1\t2\t3\n4\t5\t6,5\n')).toEqual(rows)
    expect(rowsOf('x\ty\tr\r\n1\t2\t3\r\n4\t5\t6.5\r\n\r\n')).toEqual(rows)
    expect(rowsOf('1;2;3\n4;5;6,5')).toEqual(rows)
    expect(rowsOf('1,2,3\n4,5,6.5')).toEqual(rows)
    expect(rowsOf('1 2 3\n4  5 6.5')).toEqual(rows)
    expect(rowsOf('1,5')).toEqual([[1.5]])
    expect(rowsOf('7\n8')).toEqual([[7], [8]])
    expect(rowsOf('1\t2\n3\tfour')).toEqual({ problem: '“four” is not a number. Nothing has changed.' })
    expect(rowsOf('1\t\t3')).toEqual({ problem: '“” is not a number. Nothing has changed.' })
    expect(rowsOf('1,5\n2,5')).toEqual([[1.5], [2.5]])
    expect(rowsOf('1|2|3')).toEqual([[1, 2, 3]])
    expect(rowsOf('"1,5",2,3')).toEqual([[1.5, 2, 3]])
    // Rows stay where they are.
    expect(rowsOf('1\n\n2')).toEqual({ problem: '“” is not a number. Nothing has changed.' })
    expect(rowsOf('1\t"2')).toEqual({ problem: '“1\t"2” is not a number. Nothing has changed.' })
    expect(rowsOf('\n')).toEqual({ problem: 'There is nothing to paste.' })
  })

  it('go into circles from a column on, and into new ones below', () => {
    const circles = new CircleTable(FOUR)
    const get = (id: number) => circles.get(id)
    expect(editsOf([[8], [9]], 'y', [2, 0], get)).toEqual([
      { kind: 'replace', id: 2, circle: { x: 2, y: 8, r: 1 } },
      { kind: 'replace', id: 0, circle: { x: 3, y: 9, r: 1 } },
    ])
    expect(
      editsOf(
        [
          [8, 7, 6],
          [5, 4, 3],
        ],
        'x',
        [1],
        get,
      ),
    ).toEqual([
      { kind: 'replace', id: 1, circle: { x: 8, y: 7, r: 6 } },
      { kind: 'insert', circle: { x: 5, y: 4, r: 3 } },
    ])
    expect(editsOf([[8, 7, 6]], 'y', [1], get)).toMatchObject({ problem: expect.stringContaining('3 columns') })
    expect(editsOf([[1], [2]], 'x', [3], get)).toMatchObject({ problem: expect.stringContaining('need x, y and r') })
  })
})

describe('what cells measure', () => {
  it('is that of their circles, by ids, in steps and after edits', () => {
    const picture = new Picture(library.edit(dataSet('introduction')))
    picture.apply(
      picture.editor.apply([
        { kind: 'remove', id: 3 },
        { kind: 'insert', circle: { x: 0.2, y: 0.1, r: 0.05 } },
      ]),
    )
    const columns = ['area', 'degree', 'gap'] as const
    const steps = tabulatedAll(picture, columns)
    let step = steps.next()
    // The circles may change between two steps.
    picture.apply(picture.editor.apply([{ kind: 'remove', id: 5 }]))
    while (step.done !== true) step = steps.next()
    const all = step.value
    expect([...all.ids].sort((a, b) => a - b)).toEqual([...picture.editor.ids()].sort((a, b) => a - b))
    const { diagram } = picture
    for (const [k, id] of all.ids.entries()) {
      const i = diagram.indexOf(id)
      if (!diagram.cells.exists(i)) {
        for (const column of all.columns) expect(column[k]).toBeNaN()
        continue
      }
      expect(all.columns[0]?.[k]).toBe(cellArea(diagram, i))
      expect(all.columns[1]?.[k]).toBe(new Set(diagram.neighbors(i)).size)
      const { x, y, r } = circleAt(diagram.circles, i)
      const gaps = [...diagram.neighbors(i)].map((j) => {
        const other = circleAt(diagram.circles, j)
        return Math.hypot(x - other.x, y - other.y) - r - other.r
      })
      expect(all.columns[2]?.[k]).toBeCloseTo(Math.min(...gaps), 12)
    }
    const some = tabulated(picture, ['degree'], Int32Array.of(4, 5, 0))
    expect([...some.ids]).toEqual([4, 0])
    expect(some.columns).toHaveLength(1)
  })
})
