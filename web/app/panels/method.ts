// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit'
import type { State } from '../../editing/state.ts'
import type { Store } from '../../editing/store.ts'
import { Stepping } from '../../player/stepping.ts'
import type { View } from '../../view/view.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

const METHODS = [
  ['touching-disc', 'Touching discs'],
  ['auto', 'Edge flips'],
] as const

/** A button that has the method played on the circles that are shown, and where that is told. */
export function mountMethod(store: Store<State>, actions: PageActions, view: View): void {
  const button = byId('method', HTMLButtonElement)
  const player = byId('player', HTMLElement)
  const close = () => {
    actions.showStep(undefined)
    button.focus()
  }
  const choose = (event: Event) => actions.showStep(0, (event.target as HTMLSelectElement).value)
  render(
    html`<header>
        <h2>
          <select aria-label="Method" @change=${choose}>
            ${METHODS.map(([value, name]) => html`<option value=${value}>${name}</option>`)}
          </select>
        </h2>
        <button type="button" class="icon" aria-label="Close the player" title="Close the player" @click=${close}>
          <svg viewBox="0 0 20 20" aria-hidden="true"><path d="m6 6 8 8M14 6l-8 8" /></svg>
        </button>
      </header>
      <div id="played"></div>`,
    player,
  )
  const container = byId('played', HTMLDivElement)
  const select = player.querySelector('select') as HTMLSelectElement
  new Stepping({
    container,
    view,
    store,
    actions,
    options: (kept) => {
      // A link may name any.
      const [method] = METHODS.find(([value]) => value === kept) ?? METHODS[0]
      select.value = method
      return { method }
    },
  })

  const show = (isOpen: boolean) => {
    player.hidden = !isOpen
    button.setAttribute('aria-expanded', String(isOpen))
  }
  button.addEventListener('click', () => (player.hidden ? actions.showStep(0) : close()))
  show(false)
  store.subscribe(({ step }) => {
    if (player.hidden === (step !== undefined)) show(step !== undefined)
  })
}
