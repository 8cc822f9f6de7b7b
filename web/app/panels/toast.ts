// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render } from 'lit/html.js'
import { wholeNumber } from '../../view/whole-number.ts'
import { byId } from './by-id.ts'

/** Duration of a toast, in milliseconds. */
const SAID = 6000

export interface Offer {
  readonly label: string
  act(): void
}

let timer: ReturnType<typeof setTimeout> | undefined

/** Shows a short message above all panels, with an optional action. */
export function toast(text: string, offer?: Offer): void {
  const place = byId('toast', HTMLElement)
  const hide = () => {
    place.hidden = true
  }
  const act = () => {
    hide()
    offer?.act()
  }
  clearTimeout(timer)
  render(
    html`<span>${text}</span>${offer === undefined ? nothing : html`<button type="button" @click=${act}>${offer.label}</button>`}`,
    place,
  )
  place.hidden = false
  timer = setTimeout(hide, offer === undefined ? SAID : 2 * SAID)
}

/** Letters of a text that other programs may cut. */
const LONG = 8000

/** Says that a text is in the clipboard, and whether other programs may cut it. */
export function toastCopied(what: string, length: number): void {
  const isIn = `${what} is in the clipboard.`
  const warning = `It has ${wholeNumber(length)} letters, and some programs cut long ones: a file is safer.`
  toast(length > LONG ? `${isIn} ${warning}` : isIn)
}
