// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit'
import type { Trial } from '../../view/protocol.ts'
import type { View } from '../../view/view.ts'
import { byId } from './by-id.ts'

/** So many circles are named from which most is taken. */
const MOST_NAMED = 8

/** What the circle would take that is tried. */
export function mountTrial(view: View): void {
  const panel = byId('trial', HTMLElement)
  view.on('tried', (trial) => {
    panel.hidden = trial === undefined
    if (trial !== undefined) render(body(trial), panel)
  })
}

function body({ hiddenBy, area, taken }: Trial) {
  if (hiddenBy !== undefined) {
    return html`<h2>A new circle</h2>
      <p>It would be hidden inside circle ${hiddenBy} and take nothing.</p>`
  }
  return html`
    <h2>A new circle</h2>
    <p>${area < Number.POSITIVE_INFINITY ? `Its cell would have the area ${text(area)}, taken from` : 'Its cell would have no end; taken from'}</p>
    <dl>
      ${taken.slice(0, MOST_NAMED).map(({ id, area }) => html`<div><dt>circle ${id}</dt><dd>${text(area)}</dd></div>`)}
    </dl>
    ${taken.length > MOST_NAMED ? html`<p>and ${taken.length - MOST_NAMED} more</p>` : undefined}
    <p>Release: it is added. Escape: it is not.</p>
  `
}

function text(area: number): string {
  if (Number.isNaN(area)) return '…'
  return area === Number.POSITIVE_INFINITY ? '∞' : String(Number(area.toPrecision(3)))
}
