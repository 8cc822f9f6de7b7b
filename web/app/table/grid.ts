// SPDX-License-Identifier: GPL-3.0-or-later
import { elementScroll, observeElementOffset, observeElementRect, Virtualizer } from '@tanstack/virtual-core'

/** The contents of a cell. */
export interface CellText {
  readonly text: string
  /** Shown in full at the pointer if the text may be shortened. */
  readonly title?: string
  /** Read out in place of the text if the text alone is unclear. */
  readonly label?: string
}

/** A column's heading. */
export interface Heading {
  readonly name: string
  readonly title: string
  readonly isEditable: boolean
  /** Whether the cells contain text rather than numbers. */
  readonly isText?: boolean
}

/** The data of a grid, and the callbacks for its changes. */
export interface GridContent {
  readonly headings: readonly Heading[]
  rows(): number
  cell(row: number, column: number): CellText
  isSelected(row: number): boolean
  sortOf(column: number): 'ascending' | 'descending' | 'none'
  sort(column: number): void
  /**
   * Called when a row becomes current. `how`: selected alone, toggled, or together with all rows since the last such
   * one.
   */
  choose(row: number, how: 'only' | 'toggle' | 'through'): void
  /** The id of a row. Rows may be reordered while one is edited. */
  idOf(row: number): number
  /** The text with which editing a cell begins. */
  written(id: number, column: number): string
  /** Resolves to whether the text was accepted. */
  write(id: number, column: number, text: string): Promise<boolean>
  paste(row: number, column: number, text: string): void
  /** Called when other rows become visible. */
  seen(first: number, last: number): void
}

const HEADING = -1
const OVERSCAN = 6
const TYPED = /^[\d.+\-\u2212]$/

/**
 * A virtualized grid: only visible rows have elements. The grid is a single tab stop. Arrow keys move the current cell;
 * Enter, F2 or a digit edits it.
 */
export class Grid {
  readonly #element: HTMLElement
  readonly #content: GridContent
  readonly #head: HTMLElement
  readonly #body: HTMLElement
  readonly #rowHeight: number
  readonly #virtualizer: Virtualizer<HTMLElement, HTMLElement>
  readonly #unmount: () => void
  readonly #elements: HTMLElement[] = []
  readonly #prefix: string
  #row = 0
  #column: number
  #frame = 0
  #input: HTMLInputElement | undefined
  #seen: readonly [number, number] = [0, 0]

  /** `element` is empty and has the class `grid` of table.css. */
  constructor(element: HTMLElement, content: GridContent, label: string) {
    this.#element = element
    this.#content = content
    this.#prefix = `${element.id}-`
    this.#column = Math.max(
      content.headings.findIndex(({ isEditable }) => isEditable),
      0,
    )
    element.role = 'grid'
    element.tabIndex = 0
    element.ariaLabel = label
    element.ariaMultiSelectable = 'true'
    element.ariaColCount = String(content.headings.length)
    this.#head = element.appendChild(this.#rowElement('columnheader'))
    this.#head.classList.add('head')
    this.#head.ariaRowIndex = '1'
    this.#body = element.appendChild(document.createElement('div'))
    this.#body.role = 'rowgroup'
    for (const [column, { name, title }] of content.headings.entries()) {
      const cell = this.#head.children[column] as HTMLElement
      cell.textContent = name
      cell.title = title
      cell.id = this.#elementIdOf(HEADING, column)
    }
    this.#rowHeight = this.#head.offsetHeight
    this.#virtualizer = new Virtualizer<HTMLElement, HTMLElement>({
      count: content.rows(),
      getScrollElement: () => element,
      estimateSize: () => this.#rowHeight,
      scrollPaddingStart: this.#rowHeight,
      overscan: OVERSCAN,
      scrollToFn: elementScroll,
      observeElementRect,
      observeElementOffset,
      onChange: () => this.render(),
    })
    this.#unmount = this.#virtualizer._didMount()
    this.#virtualizer._willUpdate()
    element.addEventListener('click', (event) => this.#click(event))
    element.addEventListener('dblclick', (event) => this.#cellAt(event)?.role === 'gridcell' && this.#edit())
    element.addEventListener('keydown', (event) => this.#key(event))
    element.addEventListener('paste', (event) => this.#paste(event))
    this.render()
  }

  dispose(): void {
    this.#unmount()
    cancelAnimationFrame(this.#frame)
  }

  get isEditing(): boolean {
    return this.#input !== undefined
  }

  /** Cancels the editing of a cell. */
  cancelEdit(): void {
    const input = this.#input
    if (input === undefined) return
    const hadFocus = document.activeElement === input
    this.#input = undefined
    input.remove()
    if (hadFocus) this.focus()
    this.render()
  }

  /** Renders at the next frame. */
  render(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#draw())
  }

  /** Makes a row current and scrolls to it. */
  goTo(row: number): void {
    this.#row = row
    this.#count()
    this.#virtualizer.scrollToIndex(row, { align: 'auto' })
    this.render()
  }

  scrollToTop(): void {
    this.#virtualizer.scrollToOffset(0)
  }

  focus(): void {
    this.#element.focus()
  }

  /** Passes the same functions again, because new ones would make the virtualizer measure all rows. */
  #count(): void {
    const { options } = this.#virtualizer
    const count = this.#content.rows()
    if (count !== options.count) this.#virtualizer.setOptions({ ...options, count })
  }

  #draw(): void {
    this.#frame = 0
    const count = this.#content.rows()
    this.#row = Math.max(Math.min(this.#row, count - 1), HEADING)
    this.#count()
    this.#virtualizer._willUpdate()
    this.#element.ariaRowCount = String(count + 1)
    this.#body.style.height = `${this.#virtualizer.getTotalSize()}px`
    this.#content.headings.forEach((_, column) => {
      const cell = this.#head.children[column] as HTMLElement
      cell.ariaSort = this.#content.sortOf(column)
      cell.classList.toggle('current', this.#row === HEADING && column === this.#column)
    })
    const items = this.#virtualizer.getVirtualItems()
    const rows = items.map(({ index }) => index)
    // The current cell must exist to be read out, and an edited one to be edited.
    if (this.#row >= 0 && !rows.includes(this.#row)) rows.push(this.#row)
    this.#drawRows(rows)
    this.#element.setAttribute('aria-activedescendant', this.#elementIdOf(this.#row, this.#column))
    const [first, last] = [items[0]?.index ?? 0, items.at(-1)?.index ?? -1]
    if (first !== this.#seen[0] || last !== this.#seen[1]) this.#content.seen(first, last)
    this.#seen = [first, last]
  }

  /** Keeps the element of each row while the row is visible, so that focus stays. */
  #drawRows(rows: readonly number[]): void {
    const free = this.#elements.filter(({ dataset }) => !rows.includes(Number(dataset.row)))
    for (const row of rows) {
      const known = this.#elements.find(({ dataset }) => dataset.row === String(row))
      const element = known ?? free.pop() ?? this.#newRow()
      element.hidden = false
      if (known === undefined) {
        element.dataset.row = String(row)
        element.ariaRowIndex = String(row + 2)
        element.style.transform = `translateY(${row * this.#rowHeight}px)`
      }
      const isSelected = this.#content.isSelected(row)
      element.ariaSelected = String(isSelected)
      for (const [column, cell] of [...element.children].entries() as Iterable<[number, HTMLElement]>) {
        const isCurrent = row === this.#row && column === this.#column
        cell.id = this.#elementIdOf(row, column)
        cell.classList.toggle('current', isCurrent)
        if (isCurrent && this.#input?.parentElement === cell) continue
        const { text, label, title = '' } = this.#content.cell(row, column)
        if (cell.textContent !== text) cell.textContent = text
        if (cell.title !== title) cell.title = title
        if (label === undefined) cell.removeAttribute('aria-label')
        else cell.ariaLabel = label
      }
    }
    for (const element of free) {
      element.hidden = true
      element.ariaSelected = null
      delete element.dataset.row
      for (const cell of element.children) cell.removeAttribute('id')
    }
  }

  #newRow(): HTMLElement {
    const element = this.#body.appendChild(this.#rowElement('gridcell'))
    this.#content.headings.forEach(({ isEditable }, column) => {
      ;(element.children[column] as HTMLElement).ariaReadOnly = String(!isEditable)
    })
    this.#elements.push(element)
    return element
  }

  #rowElement(role: 'columnheader' | 'gridcell'): HTMLElement {
    const row = document.createElement('div')
    row.role = 'row'
    this.#content.headings.forEach(({ isText = false }, column) => {
      const cell = row.appendChild(document.createElement('div'))
      cell.classList.toggle('text', isText)
      cell.role = role
      cell.ariaColIndex = String(column + 1)
    })
    return row
  }

  #elementIdOf(row: number, column: number): string {
    return `${this.#prefix}${row}-${column}`
  }

  /** The clicked cell, unless it is being edited. */
  #cellAt(event: MouseEvent): HTMLElement | undefined {
    const cell = (event.target as Element).closest<HTMLElement>('[role=gridcell], [role=columnheader]')
    return cell === null || this.#input?.parentElement === cell ? undefined : cell
  }

  #click(event: MouseEvent): void {
    const cell = this.#cellAt(event)
    if (cell === undefined) return
    this.#column = Number(cell.ariaColIndex) - 1
    this.#element.focus()
    if (cell.role === 'columnheader') {
      this.#content.sort(this.#column)
      return
    }
    this.#row = Number((cell.parentElement as HTMLElement).dataset.row)
    this.#content.choose(this.#row, event.shiftKey ? 'through' : event.ctrlKey || event.metaKey ? 'toggle' : 'only')
    this.render()
  }

  #key(event: KeyboardEvent): void {
    if (event.target !== this.#element) return
    const page = Math.max(Math.floor(this.#element.clientHeight / this.#rowHeight) - 2, 1)
    const last = this.#content.rows() - 1
    const isCommand = event.ctrlKey || event.metaKey
    const rows: Readonly<Record<string, number>> = {
      ArrowUp: this.#row - 1,
      ArrowDown: this.#row + 1,
      PageUp: Math.max(this.#row - page, 0),
      PageDown: this.#row + page,
      ...(isCommand && { Home: 0, End: last }),
    }
    const columns: Readonly<Record<string, number>> = {
      ArrowLeft: this.#column - 1,
      ArrowRight: this.#column + 1,
      ...(!isCommand && { Home: 0, End: this.#content.headings.length - 1 }),
    }
    if (rows[event.key] !== undefined) {
      this.#moveTo(Math.min(rows[event.key] as number, last), event.shiftKey)
    } else if (columns[event.key] !== undefined) {
      this.#column = Math.max(Math.min(columns[event.key] as number, this.#content.headings.length - 1), 0)
      this.render()
    } else if (event.key === 'Enter' || event.key === 'F2') {
      if (this.#row === HEADING) this.#content.sort(this.#column)
      else this.#edit()
    } else if (event.key === ' ') {
      if (this.#row === HEADING) this.#content.sort(this.#column)
      else this.#content.choose(this.#row, 'toggle')
    } else if (this.#isTyped(event.key) && !isCommand && !event.altKey) {
      this.#edit(event.key)
    } else {
      return
    }
    event.preventDefault()
    event.stopPropagation()
  }

  /** Whether a key starts editing the current column. */
  #isTyped(key: string): boolean {
    const isText = this.#content.headings[this.#column]?.isText === true
    return TYPED.test(key) || (isText && [...key].length === 1)
  }

  #moveTo(row: number, isThrough: boolean): void {
    this.#row = Math.max(row, HEADING)
    if (this.#row >= 0) {
      this.#content.choose(this.#row, isThrough ? 'through' : 'only')
      this.#virtualizer.scrollToIndex(this.#row, { align: 'auto' })
    }
    this.render()
  }

  /** Edits the current cell. `typed` replaces its content. */
  #edit(typed?: string): void {
    const { headings } = this.#content
    if (this.#row < 0 || this.#row >= this.#content.rows() || headings[this.#column]?.isEditable !== true) return
    this.#virtualizer.scrollToIndex(this.#row, { align: 'auto' })
    this.#draw()
    const cell = document.getElementById(this.#elementIdOf(this.#row, this.#column)) as HTMLElement
    const input = document.createElement('input')
    input.inputMode = headings[this.#column]?.isText === true ? 'text' : 'decimal'
    input.autocomplete = 'off'
    input.ariaLabel = `${headings[this.#column]?.name} of row ${this.#row + 1}`
    const column = this.#column
    const id = this.#content.idOf(this.#row)
    input.value = typed ?? this.#content.written(id, column)
    this.#input = input
    cell.replaceChildren(input)
    input.focus()
    if (typed === undefined) input.select()
    let isWriting = false
    const close = () => {
      if (this.#input === input) this.#input = undefined
      input.remove()
      this.render()
    }
    /** Refused text stays for correction. */
    const commit = async (): Promise<boolean> => {
      if (isWriting || this.#input !== input) return false
      isWriting = true
      const isTaken =
        input.value === this.#content.written(id, column) || (await this.#content.write(id, column, input.value))
      isWriting = false
      if (isTaken) close()
      else input.ariaInvalid = 'true'
      return isTaken
    }
    input.addEventListener('keydown', async (event) => {
      if (!['Enter', 'Escape', 'Tab'].includes(event.key)) return
      event.preventDefault()
      event.stopPropagation()
      if (event.key === 'Escape') {
        close()
        this.focus()
        return
      }
      if (!(await commit())) return
      this.focus()
      if (event.key === 'Tab') this.#moveAlong(event.shiftKey ? -1 : 1)
      else this.#moveTo(Math.min(this.#row + (event.shiftKey ? -1 : 1), this.#content.rows() - 1), false)
    })
    input.addEventListener('blur', async () => {
      // A user who has moved on has seen the error.
      if (!(await commit()) && document.activeElement !== input && !isWriting) close()
    })
  }

  /** Moves to the next or previous editable cell. */
  #moveAlong(step: 1 | -1): void {
    const editable = this.#content.headings.flatMap(({ isEditable }, column) => (isEditable ? [column] : []))
    const next = editable.indexOf(this.#column) + step
    const turn = next < 0 ? -1 : next >= editable.length ? 1 : 0
    const row = this.#row + turn
    if (row < 0 || row >= this.#content.rows()) return
    this.#column = editable[(next + editable.length) % editable.length] as number
    this.#moveTo(row, false)
  }

  #paste(event: ClipboardEvent): void {
    const text = event.clipboardData?.getData('text/plain') ?? ''
    const isOne = !/[\t\n;]/.test(text.trim())
    // A single number is pasted into the open field.
    if (event.target !== this.#element && isOne) return
    event.preventDefault()
    event.stopPropagation()
    this.cancelEdit()
    this.focus()
    if (this.#row >= 0) this.#content.paste(this.#row, this.#column, text)
  }
}
