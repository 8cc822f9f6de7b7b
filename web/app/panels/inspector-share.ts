// SPDX-License-Identifier: GPL-3.0-or-later

import { html, render } from 'lit/html.js'
import type { State } from '../../editing/state.ts'
import { short } from '../../view/short.ts'
import type { Store } from '../../view/store.ts'
import { selectedIn } from '../../view/view-state.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

const DIGITS = 4
/** The slider ranges from the mean share halved this often to the mean share doubled this often. */
const DOUBLINGS = 5
const MOST_PERCENT = 99

/** The selected cell's prescribed share of the region, as a number and a slider. */
export function mountInspectorShare(store: Store<State>, actions: PageActions): void {
  const place = byId('inspector-share', HTMLElement)
  const radius = byId('field-r', HTMLInputElement)
  /** One drag of the slider is one undo step. */
  let gesture: number | undefined

  const set = (id: number, share: number) => {
    gesture ??= actions.circles.beginGesture()
    actions.domain.setShare(id, Math.min(share, MOST_PERCENT / 100), gesture)
  }
  const end = () => {
    gesture = undefined
  }
  const draw = (state: State) => {
    const { domain, edited } = state
    const selected = selectedIn(state)
    const isGiven = selected !== undefined && domain.areas !== undefined
    place.hidden = !isGiven
    // The radius is then a weight that results from the area.
    radius.readOnly = isGiven
    const [label] = radius.labels ?? []
    if (label?.firstChild) label.firstChild.textContent = isGiven ? 'w ' : 'r '
    if (!isGiven) return
    const share = actions.domain.shareOf(selected) ?? 0
    const mean = 1 / (edited?.counts.circles ?? 1)
    const type = (event: Event) => {
      const input = event.target as HTMLInputElement
      if (input.reportValidity()) set(selected, input.valueAsNumber / 100)
      end()
    }
    const slide = (event: Event) => set(selected, mean * 2 ** (event.target as HTMLInputElement).valueAsNumber)
    render(
      html`<div class="layer">
          <label for="share-of-region">% of the region</label>
          <input
            id="share-of-region"
            type="number"
            min="0.0001"
            max=${MOST_PERCENT}
            step="any"
            required
            autocomplete="off"
            .value=${short(100 * share, DIGITS)}
            @change=${type}
          />
        </div>
        <div class="layer">
          <input
            type="range"
            min=${-DOUBLINGS}
            max=${DOUBLINGS}
            step="any"
            aria-label="Share of the region, against the mean"
            .value=${String(Math.log2(share / mean))}
            @input=${slide}
            @change=${end}
          /><output>${(share / mean).toPrecision(3)} × mean</output>
        </div>`,
      place,
    )
  }
  store.subscribe(draw)
}
