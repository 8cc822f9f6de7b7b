// SPDX-License-Identifier: GPL-3.0-or-later
import { type State, showStep } from '../../editing/state.ts'
import type { TraceOptions } from '../../lib/wasm/trace.ts'
import type { Store } from '../../view/store.ts'
import { byId } from './by-id.ts'

/**
 * A button that plays a method, and a menu of methods. Returns a function that maps a link's method to an available
 * one.
 */
export function mountMethod(store: Store<State>): (kept: string | undefined) => TraceOptions {
  const button = byId('method', HTMLButtonElement)
  const player = byId('player', HTMLElement)
  const choice = byId('player-method', HTMLSelectElement)
  const close = () => {
    showStep(store, undefined)
    button.focus()
  }
  choice.addEventListener('change', () => showStep(store, 0, choice.value))
  byId('share-player', HTMLButtonElement).addEventListener('click', () => byId('open-share', HTMLButtonElement).click())
  byId('close-player', HTMLButtonElement).addEventListener('click', close)
  button.addEventListener('click', () => (player.hidden ? showStep(store, 0) : close()))
  store.subscribe(({ step }) => {
    player.hidden = step === undefined
    button.setAttribute('aria-expanded', String(!player.hidden))
  })
  return (kept = '') => {
    choice.value = kept
    // A link may name an unknown method.
    if (choice.selectedIndex < 0) choice.selectedIndex = 0
    return { method: choice.value as TraceOptions['method'] }
  }
}
