// SPDX-License-Identifier: GPL-3.0-or-later

import { html, nothing, render } from 'lit/html.js'
import { textIn, valueIn } from '../../editing/attributes.ts'
import type { Editing } from '../../editing/editing.ts'
import { isIdentity } from '../../editing/identity.ts'
import type { State } from '../../editing/state.ts'
import type { Described } from '../../view/protocol.ts'
import { short } from '../../view/short.ts'
import type { Store } from '../../view/store.ts'
import { describedIn, selectedIn } from '../../view/view-state.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'
import { selectionActions } from './group.ts'

const DIGITS = 4

/** Shows the place and the measures of the selected circle, with its actions. */
export function mountInspectorFacts(store: Store<State>, editing: Editing, actions: PageActions): void {
  const place = byId('inspector-place', HTMLParagraphElement)
  const facts = byId('inspector-facts', HTMLElement)
  const data = byId('inspector-data', HTMLElement)
  let shownData: readonly unknown[] = []
  const buttons = byId('inspector-actions', HTMLElement)

  store.subscribe((state) => {
    const { attributes, domain } = state
    const selected = selectedIn(state)
    if (selected === undefined) return
    if (shownData[0] !== selected || shownData[1] !== attributes) {
      shownData = [selected, attributes]
      render(selectionActions(actions, [selected]), buttons)
      const others = attributes.columns.filter((column) => !isIdentity(column, attributes.columns))
      data.hidden = others.length === 0
      render(
        others.map(({ name }) => {
          const text = textIn(valueIn(editing.attributes, name, selected))
          return html`<dt title=${name}>${name}</dt><dd title=${text}>${text === '' ? '–' : text}</dd>`
        }),
        data,
      )
    }
    const number = actions.identity.nameOf(selected) === '' ? '' : `Circle ${selected}`
    const about = [number, placeOf(editing, selected)].filter((text) => text !== '').join(' · ')
    place.hidden = about === ''
    if (place.textContent !== about) place.textContent = about
    const described = describedIn(state)
    if (described !== undefined) render(factsOf(described, domain.region !== undefined), facts)
  })
}

/**
 * Explains the number of a circle if it differs from its position, because numbers of removed circles are not reused.
 */
function placeOf({ circles }: Editing, id: number): string {
  const place = circles.countBelow(id)
  return place === id ? '' : `${wholeNumber(place + 1)} of ${wholeNumber(circles.count)}; numbers are not used again`
}

function factsOf({ size, hiddenBy }: Described, isInside: boolean) {
  if (size === undefined || hiddenBy !== undefined) return nothing
  const text = (value: number) =>
    Number.isFinite(value)
      ? short(value, DIGITS)
      : html`<span aria-label="infinite" title="The cell has no end">∞</span>`
  return html`<dt>${isInside ? 'Area inside the region' : 'Area of the cell'}</dt><dd>${text(size.area)}</dd>
    <dt>${isInside ? 'Perimeter inside the region' : 'Perimeter of the cell'}</dt><dd>${text(size.perimeter)}</dd>`
}
