// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render, svg } from 'lit'
import type { State } from '../../editing/state.ts'
import type { Store } from '../../editing/store.ts'
import { Stepping } from '../../player/stepping.ts'
import type { Padding } from '../../view/camera.ts'
import type { View } from '../../view/view.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

const ICON = svg`<path d="M4.500 4v12l8-6zM16 4v12" />`
const METHODS = [
  ['touching-disc', 'Touching discs'],
  ['auto', 'Edge flips'],
] as const
/** In narrower windows the player stands below the picture, unless they are low, too. */
const BELOW = '(max-width: 40em) and (min-height: 30.01em)'
/** Around circles that are all seen, in pixels: at the right, and where the panels at the bottom are. */
const ROOM = 32
const ROOM_BELOW = 64

/** What is covered of the picture at the right and at the bottom, in pixels, by the player if it is there. */
export function playerPadding(): Pick<Padding, 'right' | 'bottom'> {
  const { hidden, offsetWidth, offsetHeight } = byId('player', HTMLElement)
  if (hidden) return { right: ROOM, bottom: ROOM_BELOW }
  return matchMedia(BELOW).matches
    ? { right: ROOM, bottom: ROOM + offsetHeight }
    : { right: ROOM + offsetWidth, bottom: ROOM_BELOW }
}

/** A button that has the method played on the circles that are shown, and where that is told. */
export function mountMethod(store: Store<State>, actions: PageActions, view: View): void {
  const place = byId('method', HTMLElement)
  const player = byId('player', HTMLElement)
  const close = () => {
    actions.showStep(undefined)
    place.querySelector('button')?.focus()
  }
  const choose = (event: Event) => actions.showStep(0, (event.target as HTMLSelectElement).value)
  render(
    html`<header class="row">
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
    // Where all circles are seen, they are seen beside the player, too.
    const state = actions.linkState()
    const isWhole = state !== undefined && state.view === undefined
    player.hidden = !isOpen
    if (isWhole) actions.look(undefined)
    render(
      html`<h2>
        <button
          type="button"
          aria-expanded=${isOpen}
          aria-controls="player"
          @click=${() => (isOpen ? close() : actions.showStep(0))}
        >
          <svg viewBox="0 0 20 20" aria-hidden="true">${ICON}</svg>Play the method
        </button>
      </h2>`,
      place,
    )
  }
  show(false)
  store.subscribe(({ step }) => {
    if (player.hidden === (step !== undefined)) show(step !== undefined)
  })
}
