// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import type { Messages } from '../../editing/messages.ts'
import type { Trial } from '../../view/protocol.ts'
import { areaText, namedOf } from '../../view/taken-text.ts'
import type { View } from '../../view/view.ts'
import { byId } from './by-id.ts'

/** Shows the effect of a previewed circle. */
export function mountTrial(view: View, { called }: Pick<Messages, 'called'>): void {
  const panel = byId('trial', HTMLElement)
  view.on('tried', (trial) => {
    panel.hidden = trial === undefined
    if (trial !== undefined) render(body(trial, called), panel)
  })
}

const HEADER = html`<header><h2>A new circle</h2></header>`

function body(trial: Trial, called: (id: number) => string) {
  const { hiddenBy, area, taken } = trial
  if (hiddenBy !== undefined) {
    return html`${HEADER}
      <p>It would be hidden inside ${called(hiddenBy)} and take nothing.</p>`
  }
  const named = namedOf(trial)
  return html`
    ${HEADER}
    <p>${area < Number.POSITIVE_INFINITY ? `Its cell would have the area ${areaText(area)}, taken from` : 'Its cell would have no end; taken from'}</p>
    <dl class="facts">
      ${named.map(({ id, area }) => html`<dt>${called(id)}</dt><dd>${areaText(area)}</dd>`)}
    </dl>
    ${taken.length > named.length ? html`<p>and ${taken.length - named.length} more</p>` : undefined}
    <p>Release to add, Esc to cancel.</p>
  `
}
