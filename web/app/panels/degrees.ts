// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render } from 'lit/html.js'
import type { Editing } from '../../editing/editing.ts'
import type { Degrees } from '../../editing/history.ts'
import type { State } from '../../editing/state.ts'
import { icon } from '../../player/icon.ts'
import { CLOSE } from '../../view/icons.ts'
import type { Store } from '../../view/store.ts'
import { EarthActions } from '../earth/earth-actions.ts'
import type { FilesClient } from '../files/files-client.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'
import './degrees.css'

const UNITS: Readonly<Record<Degrees['unit'], string>> = { km: 'kilometers', m: 'meters' }

/** A notice that the circles are in degrees, with the offers to show them on a globe or to project them. */
export function mountDegrees(
  store: Store<State>,
  editing: Editing,
  pageActions: PageActions,
  files: Pick<FilesClient, 'call'>,
): void {
  const actions = new EarthActions(editing, pageActions, files)
  const place = byId('degrees', HTMLElement)
  let shown: Degrees | undefined
  let unit: Degrees['unit'] = 'km'

  const act = (name: 'showOnGlobe' | 'projectToMap') => () => {
    if (shown !== undefined) actions[name]({ ...shown, unit })
  }
  const choose = ({ target }: Event) => {
    unit = (target as HTMLSelectElement).value as Degrees['unit']
  }
  const close = () => {
    place.hidden = true
  }
  const choice = () => html`
    <label>Radii are in
      <select @change=${choose}>
        ${Object.entries(UNITS).map(([value, label]) => html`<option value=${value} .selected=${value === unit}>${label}</option>`)}
      </select>
    </label>
  `
  const draw = () =>
    render(
      html`
        <header>
          <p>
            <b>These are longitudes and latitudes.</b> The diagram is that of a plane where all degrees are equally long,
            so its cells are wrong on the Earth.
          </p>
          <button type="button" class="icon" aria-label="Dismiss" title="Dismiss" @click=${close}>${icon(CLOSE)}</button>
        </header>
        <div class="choices">
          ${hasRadii(editing) ? choice() : nothing}
          <button type="button" class="primary" @click=${act('showOnGlobe')}>Show on a globe</button>
          <button type="button" @click=${act('projectToMap')}>Project to a map</button>
        </div>
      `,
      place,
    )

  store.subscribe(({ scene }) => {
    const degrees = scene?.degrees
    if (degrees === shown) return
    shown = degrees
    place.hidden = degrees === undefined
    if (degrees === undefined) return
    unit = degrees.unit
    draw()
  })
}

function hasRadii({ circles }: Editing): boolean {
  return circles.circles().some((value, k) => k % 3 === 2 && value > 0)
}
