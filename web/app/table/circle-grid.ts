// SPDX-License-Identifier: GPL-3.0-or-later
import { columnIn, type DataColumn, isNumeric, numberIn, textIn, valueFrom, valueIn } from '../../editing/attributes.ts'
import type { Editing } from '../../editing/editing.ts'
import type { CircleSet } from '../../editing/history.ts'
import { NAME, nameColumn } from '../../editing/identity.ts'
import type { State } from '../../editing/state.ts'
import type { Circle } from '../../lib/index.ts'
import type { Column as Measured, Tabulated } from '../../view/protocol.ts'
import { short } from '../../view/short.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import type { PageActions } from '../page-actions.ts'
import './table.css'
import { type CellText, Grid, type GridContent, type Heading } from './grid.ts'
import { editsOf, notANumber, numberOf, rowsOf, type Written } from './numbers-written.ts'
import {
  BY_ID,
  COLUMNS,
  type Column,
  dataColumn,
  dataName,
  isFixed,
  isMeasured,
  ordered,
  placesOf,
  ranksOf,
  type Sorting,
} from './order.ts'

/** Pause after changes before rows are sorted again, in milliseconds. */
const SORTING_DELAY = 300
/** The longest text of a value, in letters of JSON. Links keep at most twice as many letters for a circle. */
const LONGEST_VALUE = 5000

const MEASURED: readonly Measured[] = ['area', 'degree', 'gap']
const HEADINGS: Readonly<Record<(typeof COLUMNS)[number], Heading>> = {
  id: { name: '#', title: 'Number of the circle', isEditable: false },
  x: { name: 'x', title: 'Center', isEditable: true },
  y: { name: 'y', title: 'Center', isEditable: true },
  r: { name: 'r', title: 'Radius', isEditable: true },
  area: { name: 'area', title: 'Area of the cell, inside the region if there is one', isEditable: false },
  degree: { name: 'nbrs', title: 'Neighbors: how many cells border on this one', isEditable: false },
  gap: { name: 'nearest', title: 'Distance of the nearest other circle', isEditable: false },
}

/** The columns of the circles. Names can be entered where there are none. */
function columnsIn({ attributes }: Editing): readonly DataColumn[] {
  const { columns } = attributes
  return nameColumn(columns) === undefined ? [...columns, { name: NAME, values: [] }] : columns
}

function isOfFile(column: DataColumn, { attributes }: Editing): boolean {
  return attributes.columns.includes(column)
}

/** Letters of a number that a column has room for. */
const MOST_LETTERS = 9

/** Rounds a number to the width of a column. */
function narrow(value: number, most = 6): string {
  for (let digits = most; digits > 2; digits--) {
    const text = short(value, digits)
    if (text.length <= MOST_LETTERS) return text
  }
  return short(value, 2)
}

/** Rounds a number of a file to the width of a column. A whole number may be a key, so it keeps its digits. */
function cellOf(value: string): CellText {
  const text = textIn(value)
  if (text.length <= MOST_LETTERS) return { text }
  const number = numberIn(value)
  return { text: Number.isFinite(number) && !Number.isInteger(number) ? narrow(number) : text, title: text }
}

/** Shows the circles as rows of a grid. */
export class CircleGrid implements GridContent {
  readonly headings: readonly Heading[]
  readonly #columns: readonly Column[]
  readonly #store: Store<State>
  readonly #editing: Editing
  readonly #actions: PageActions
  readonly #view: View
  readonly #grid: Grid
  #order = new Int32Array()
  #places = new Int32Array()
  #sorting = BY_ID
  #edited: State['edited']
  #scene: CircleSet | undefined
  #selection: readonly number[] = []
  #selected = new Set<number>()
  /** The last selection made in this grid. */
  #own: readonly number[] | undefined
  #anchor = 0
  /** Measures of visible cells, by id. */
  #measured = new Map<number, readonly number[]>()
  #seen: readonly [number, number] = [0, -1]
  #isAsking = false
  #isStale = false
  #rest: ReturnType<typeof setTimeout> | undefined
  #turn = 0

  constructor(element: HTMLElement, store: Store<State>, editing: Editing, actions: PageActions, view: View) {
    this.#store = store
    this.#editing = editing
    this.#actions = actions
    this.#view = view
    const columns = columnsIn(editing)
    this.#columns = [...COLUMNS, ...columns.map(({ name }) => dataColumn(name))]
    this.headings = [
      ...COLUMNS.map((column) => HEADINGS[column]),
      ...columns.map((column) => ({
        name: column.name,
        title: isOfFile(column, editing) ? `${column.name}, of the file` : 'Name of the circle',
        isEditable: true,
        isText: !isNumeric(column),
      })),
    ]
    element.style.setProperty('--data-columns', String(columns.length))
    element.classList.toggle('has-data', editing.attributes.columns.length > 0)
    this.#reorder()
    this.#grid = new Grid(element, this, 'Circles')
    this.update(store.get())
  }

  dispose(): void {
    this.#turn += 1
    clearTimeout(this.#rest)
    this.#grid.dispose()
  }

  /** Call with each new state. */
  update({ edited, selection }: State): void {
    if (edited !== this.#edited) this.#follow(edited)
    if (selection !== this.#selection) {
      this.#selection = selection
      this.#selected = new Set(selection)
      const row = selection.length === 1 ? this.#rowOf(selection[0] as number) : undefined
      if (selection !== this.#own && row !== undefined && !this.#grid.isEditing) {
        this.#anchor = row
        this.#grid.goTo(row)
      }
      this.#grid.render()
    }
  }

  rows(): number {
    return this.#order.length
  }

  isSelected(row: number): boolean {
    return this.#selected.has(this.idOf(row))
  }

  cell(row: number, column: number): CellText {
    const id = this.idOf(row)
    const name = this.#columns[column] as Column
    if (name === 'id') return { text: String(id) }
    if (!isFixed(name)) return cellOf(valueIn(this.#editing.attributes, dataName(name), id))
    if (!isMeasured(name)) {
      const circle = this.#editing.circles.get(id)
      return circle === undefined ? { text: '' } : { text: narrow(circle[name]), title: String(circle[name]) }
    }
    const value = this.#measured.get(id)?.[MEASURED.indexOf(name)]
    if (value === undefined) return { text: '' }
    if (Number.isNaN(value)) return { text: '–', label: 'hidden' }
    return value === Number.POSITIVE_INFINITY ? { text: '∞', label: 'without end' } : { text: narrow(value, 4) }
  }

  sortOf(column: number): 'ascending' | 'descending' | 'none' {
    if (this.#columns[column] !== this.#sorting.column) return 'none'
    return this.#sorting.isDescending ? 'descending' : 'ascending'
  }

  async sort(column: number): Promise<void> {
    const name = this.#columns[column] as Column
    const isDescending = this.#sorting.column === name && !this.#sorting.isDescending
    await this.#sortBy({ column: name, isDescending })
    this.#grid.scrollToTop()
  }

  choose(row: number, how: 'only' | 'toggle' | 'through'): void {
    const id = this.idOf(row)
    if (how === 'through') {
      const [from, to] = [Math.min(this.#anchor, row), Math.max(this.#anchor, row)]
      this.#actions.selection.select([...this.#order.subarray(from, to + 1)])
    } else {
      this.#anchor = row
      if (how === 'toggle') this.#actions.selection.toggle(id)
      else this.#actions.selection.goTo(id)
    }
    this.#own = this.#store.get().selection
  }

  idOf(row: number): number {
    return this.#order[row] ?? -1
  }

  written(id: number, column: number): string {
    const name = this.#columns[column] as Column
    if (!isFixed(name)) return textIn(valueIn(this.#editing.attributes, dataName(name), id))
    return String(this.#editing.circles.get(id)?.[name as Written] ?? '')
  }

  async write(id: number, column: number, text: string): Promise<boolean> {
    const circle = this.#editing.circles.get(id)
    // The circle was deleted in the meantime.
    if (circle === undefined) return true
    const name = this.#columns[column] as Column
    if (!isFixed(name)) return this.#writeValues(name, [[id, text]])
    const value = numberOf(text)
    if (value === undefined) {
      this.#actions.messages.complain(notANumber(text))
      return false
    }
    const changed: Circle = { ...circle, [name as Written]: value }
    return (await this.#actions.circles.edit([{ kind: 'replace', id, circle: changed }])) !== undefined
  }

  /** Writes texts into a column: all or none, as one undo step. Returns whether they were accepted. */
  async #writeValues(name: Column, texts: readonly (readonly [id: number, text: string])[]): Promise<boolean> {
    const column = columnsIn(this.#editing).find((column) => column.name === dataName(name))
    if (column === undefined) return true
    const values = texts.map(([id, text]) => [id, text, valueFrom(text, column)] as const)
    const wrong = values.find(([, , value]) => value === undefined)
    if (wrong !== undefined) {
      this.#actions.messages.complain(notANumber(wrong[1]))
      return false
    }
    const byId = new Map(values.map(([id, , value]) => [id, value as string]))
    const long = values.find(([id]) => (byId.get(id) as string).length > LONGEST_VALUE)
    if (long !== undefined) {
      const [id, { length }] = long
      const [most, got] = [LONGEST_VALUE, length].map(wholeNumber)
      this.#actions.messages.complain(
        `Circle ${id}: ${column.name} must not be longer than ${most} letters (got ${got}).`,
      )
      return false
    }
    return (await this.#editing.setValues(column.name, byId)) !== undefined
  }

  async paste(row: number, column: number, text: string): Promise<void> {
    const name = this.#columns[column] as Column
    if (!isFixed(name)) {
      const lines = text.replace(/\r?\n$/, '').split(/\r?\n/)
      const ids = [...this.#order.subarray(row, row + lines.length)]
      await this.#writeValues(
        name,
        ids.map((id, k) => [id, lines[k] as string]),
      )
      return
    }
    const rows = rowsOf(text)
    if ('problem' in rows) {
      this.#actions.messages.complain(rows.problem)
      return
    }
    if (isMeasured(name)) {
      this.#actions.messages.complain('Numbers can be pasted into x, y and r.')
      return
    }
    const ids = [...this.#order.subarray(row, row + rows.length)]
    const edits = editsOf(rows, name === 'id' ? 'x' : name, ids, (id) => this.#editing.circles.get(id))
    if ('problem' in edits) {
      this.#actions.messages.complain(edits.problem)
      return
    }
    const edited = await this.#actions.circles.edit(edits)
    if (edited === undefined) return
    this.#actions.selection.select([...ids, ...edited.inserted])
    this.#own = this.#store.get().selection
  }

  seen(first: number, last: number): void {
    this.#seen = [first, last]
    this.#ask()
  }

  #rowOf(id: number): number | undefined {
    const row = this.#places[id] ?? -1
    return row < 0 ? undefined : row
  }

  #follow(edited: State['edited']): void {
    this.#edited = edited
    const isOther = edited !== undefined && (edited.inserted.length > 0 || edited.counts.circles !== this.#order.length)
    const isOpened = this.#editing.scene !== this.#scene
    this.#scene = this.#editing.scene
    if (isOpened) {
      this.#measured.clear()
      // The edited circle has been removed.
      this.#grid.cancelEdit()
    }
    if (isOther || isOpened) this.#reorder()
    clearTimeout(this.#rest)
    if (this.#sorting.column !== 'id') this.#sortAtRest()
    this.#ask()
    this.#grid.render()
  }

  /** Keeps the order of existing circles and appends new ones. */
  #reorder(): void {
    const { circles } = this.#editing
    if (this.#sorting.column === 'id') {
      this.#order = new Int32Array(ordered(circles, this.#sorting))
    } else {
      const kept = this.#order.filter((id) => circles.get(id) !== undefined)
      const isKept = placesOf(kept)
      const others = circles.ids().filter((id) => (isKept[id] ?? -1) < 0)
      this.#order = new Int32Array(kept.length + others.length)
      this.#order.set(kept)
      this.#order.set(others, kept.length)
    }
    this.#places = new Int32Array(placesOf(this.#order))
  }

  /** Rows keep their places during a drag or an edit. */
  #sortAtRest(): void {
    clearTimeout(this.#rest)
    this.#rest = setTimeout(() => (this.#grid.isEditing ? this.#sortAtRest() : this.#sortAgain()), SORTING_DELAY)
  }

  /** Keeps the selected row in view. */
  async #sortAgain(): Promise<void> {
    await this.#sortBy(this.#sorting)
    const row = this.#selection.length === 1 ? this.#rowOf(this.#selection[0] as number) : undefined
    if (row !== undefined && !this.#grid.isEditing) this.#grid.goTo(row)
  }

  async #sortBy(sorting: Sorting): Promise<void> {
    this.#sorting = sorting
    this.#turn += 1
    const turn = this.#turn
    let measured: Tabulated | undefined
    if (isMeasured(sorting.column)) {
      this.#grid.render()
      measured = await this.#view.scene.ask('tabulate', [[sorting.column], undefined])
      // A newer request has replaced this one.
      if (turn !== this.#turn) return
    }
    if (this.#grid.isEditing) {
      this.#sortAtRest()
      return
    }
    this.#order = new Int32Array(ordered(this.#editing.circles, sorting, measured, this.#keysOf(sorting.column)))
    this.#places = new Int32Array(placesOf(this.#order))
    this.#ask()
    this.#grid.render()
  }

  /** The sort keys of a file's column, by ascending id. */
  #keysOf(name: Column): number[] {
    if (isFixed(name)) return []
    const column = columnIn(this.#editing.attributes, dataName(name))
    const values = Array.from(this.#editing.circles.ids(), (id) => column?.values[id] ?? '')
    return column !== undefined && isNumeric(column) ? values.map(numberIn) : ranksOf(values.map(textIn))
  }

  /** Requests the measures of visible rows, one request at a time. */
  async #ask(): Promise<void> {
    if (this.#isAsking) {
      this.#isStale = true
      return
    }
    this.#isAsking = true
    do {
      this.#isStale = false
      const ids = this.#order.slice(this.#seen[0], this.#seen[1] + 1)
      // After a refusal, the next change asks again.
      const table =
        ids.length === 0 ? undefined : await this.#view.scene.ask('tabulate', [MEASURED, ids]).catch(() => undefined)
      this.#measured = new Map(
        [...(table?.ids ?? [])].map((id, k) => [id, table?.columns.map((column) => column[k] as number) ?? []]),
      )
    } while (this.#isStale)
    this.#isAsking = false
    this.#grid.render()
  }
}
