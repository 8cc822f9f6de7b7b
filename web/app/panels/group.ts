// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render, type TemplateResult } from 'lit/html.js'
import type { State } from '../../editing/state.ts'
import { icon } from '../../player/icon.ts'
import { CLOSE } from '../../view/icons.ts'
import type { Store } from '../../view/store.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'
import { colorPicker, hexOf } from './identity.ts'

/** The card of a selection of several circles: their number and the actions. */
export function mountGroup(store: Store<State>, actions: PageActions): void {
  const panel = byId('group', HTMLElement)
  const figure = byId('figure', HTMLElement)
  const deselect = () => {
    actions.selection.select([])
    figure.focus()
  }
  const pick = colorPicker(actions, store)
  store.subscribe(({ selection }) => {
    panel.hidden = selection.length < 2
    if (panel.hidden) return
    const first = actions.identity.ownColorOf(selection[0] as number)
    const isOneColor = selection.every((id) => actions.identity.ownColorOf(id) === first)
    const color = isOneColor ? hexOf(first ?? '') : undefined
    render(
      html`
        <header>
          <h2>${wholeNumber(selection.length)} circles</h2>
          <button type="button" class="icon" aria-label="Deselect" title="Deselect (Escape)" @click=${deselect}>
            ${icon(CLOSE)}
          </button>
        </header>
        <div class="choices">
          <label>Color <input type="color" class=${color === undefined ? 'mixed' : nothing} .value=${color ?? '#888888'} @input=${pick.input} @change=${pick.change} /></label>
          ${selectionActions(actions, selection)}
        </div>
      `,
      panel,
    )
  })
}

/** The buttons that act on selected circles. */
export function selectionActions(actions: PageActions, selection: readonly number[]): TemplateResult {
  const figure = byId('figure', HTMLElement)
  const act = (action: () => void) => () => {
    action()
    figure.focus()
  }
  return html`
    ${
      selection.some((id) => actions.identity.ownColorOf(id) !== undefined)
        ? html`<button type="button" title="The color that tells it from its neighbors" @click=${act(() => actions.identity.setColor(selection, undefined))}>
            Automatic color
          </button>`
        : nothing
    }
    <button type="button" title="Zoom to the selection (F)" @click=${act(() => actions.camera.zoomToSelection())}>Zoom to</button>
    <button type="button" title="Duplicate (Ctrl+D)" @click=${act(() => actions.circles.duplicateSelected())}>Duplicate</button>
    <button type="button" title="Delete (Delete)" @click=${act(() => actions.circles.removeSelected())}>Delete</button>
  `
}
