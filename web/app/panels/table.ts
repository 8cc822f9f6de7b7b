// SPDX-License-Identifier: GPL-3.0-or-later
import { keyed } from 'lit/directives/keyed.js'
import { html } from 'lit/html.js'
import { isNumeric } from '../../editing/attributes.ts'
import type { Editing } from '../../editing/editing.ts'
import type { State } from '../../editing/state.ts'
import type { Store } from '../../editing/store.ts'
import { icon } from '../../player/icon.ts'
import { MINUS, PLUS } from '../../view/icons.ts'
import type { View } from '../../view/view.ts'
import type { PageActions } from '../page-actions.ts'
import type { CircleGrid } from '../table/circle-grid.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'

/** The panel with the table of all circles. The table is loaded when the panel opens for the first time. */
export function mountTable(store: Store<State>, editing: Editing, actions: PageActions, view: View): void {
  const panel = byId('table', HTMLElement)
  let grid: CircleGrid | undefined
  let problem = ''
  /** The names and types of the file's columns. */
  let shownColumns = ''

  const draw = () => {
    folded.render(body)
    if (folded.isOpen) fill()
    else {
      grid?.dispose()
      grid = undefined
    }
  }
  const folded = panelOf(panel, 'Table', draw)
  /** Reads the element at the time of the call, because drawing may replace it. */
  const fill = async () => {
    try {
      const { CircleGrid } = await import('../table/circle-grid.ts')
      const place = document.getElementById('circle-grid')
      if (place !== null && grid === undefined) grid = new CircleGrid(place, store, editing, actions, view)
    } catch {
      problem = 'The table could not be loaded.'
      folded.render(body)
    }
  }

  const body = () => html`
    ${keyed(shownColumns, html`<div id="circle-grid" class="grid"></div>`)}
    <div class="choices">
      <button type="button" title="Add a circle where there is room in the view" @click=${() => actions.addInRoom()}>
        ${icon(PLUS)}Add
      </button>
      <button type="button" title="Delete the selected circles (Delete)" @click=${() => actions.removeSelected()}>
        ${icon(MINUS)}Delete
      </button>
      <p>${problem || 'Enter edits; rows of a spreadsheet can be pasted.'}</p>
    </div>
  `

  store.subscribe((state) => {
    const columns = state.attributes.columns.map((column) => `${column.name} ${isNumeric(column)}`).join('\n')
    if (columns === shownColumns) {
      grid?.update(state)
      return
    }
    // The columns of a grid are fixed, so it is created again.
    shownColumns = columns
    grid?.dispose()
    grid = undefined
    draw()
  })
  draw()
}
