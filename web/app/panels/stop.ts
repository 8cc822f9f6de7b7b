// SPDX-License-Identifier: GPL-3.0-or-later
import { byId } from './by-id.ts'

/** Shows the button that stops circles that move by themselves. */
export function showStop(isShown: boolean): void {
  const stop = byId('stop', HTMLButtonElement)
  if (!isShown && stop.matches(':focus')) byId('figure', HTMLElement).focus()
  stop.hidden = !isShown
}
