// SPDX-License-Identifier: GPL-3.0-or-later
import { keyed } from 'lit/directives/keyed.js'
import { html } from 'lit/html.js'
import { isNumeric } from '../../editing/attributes.ts'
import type { Editing } from '../../editing/editing.ts'
import type { State } from '../../editing/state.ts'
import { icon } from '../../player/icon.ts'
import { MINUS, PLUS } from '../../view/icons.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import type { PageActions } from '../page-actions.ts'
import { CircleGrid } from '../table/circle-grid.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'

/** The panel with the table of all circles. */
export function mountTable(store: Store<State>, editing: Editing, actions: PageActions, view: View): void {
  const panel = byId('table', HTMLElement)
  let grid: CircleGrid | undefined
  /** The names and types of the file's columns. */
  let shownColumns = ''

  const draw = () => {
    folded.render(body)
    if (folded.isOpen) {
      // Rendering may have replaced the place.
      grid ??= new CircleGrid(byId('circle-grid', HTMLElement), store, editing, actions, view)
    } else {
      grid?.dispose()
      grid = undefined
    }
  }
  const folded = panelOf(panel, 'Table', draw)
  const body = () => html`
    ${keyed(shownColumns, html`<div id="circle-grid" class="grid"></div>`)}
    <div class="choices">
      <button type="button" title="Add a circle where there is room in the view" @click=${() => actions.circles.addInRoom()}>
        ${icon(PLUS)}Add
      </button>
      <button type="button" title="Delete the selected circles (Delete)" @click=${() => actions.circles.removeSelected()}>
        ${icon(MINUS)}Delete
      </button>
      <p>Enter edits; rows of a spreadsheet can be pasted.</p>
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
