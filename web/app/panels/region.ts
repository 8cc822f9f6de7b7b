// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing } from 'lit/html.js'
import type { State } from '../../editing/state.ts'
import type { Lattice } from '../../lib/index.ts'
import { isDissolved, plainRegion } from '../../lib/regions/region-shape.ts'
import { icon } from '../../player/icon.ts'
import { ringsOf } from '../../view/domain.ts'
import { BIN, FOLDER, PEN } from '../../view/icons.ts'
import type { Store } from '../../view/store.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import type { FileActions } from '../files/file-actions.ts'
import type { PageActions } from '../page-actions.ts'
import type { RegionPen } from '../region-pen.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'
import { toast } from './toast.ts'

/** The choices for areas, as numbers above 0. */
const BY = { equal: 'equal', radius: 'by radius', disc: 'by disc area' } as const
const FREE = 'free'
const OWN = 'own'
/** Prefix of a column's name among the choices. */
const COLUMN = 'column:'

/** The panel for the region and the areas. */
export function mountRegion(store: Store<State>, actions: PageActions, files: FileActions, pen: RegionPen): void {
  const figure = byId('figure', HTMLElement)
  const draw = () => panel.render(() => body(store.get()))
  const panel = panelOf(byId('region', HTMLElement), 'Region', draw)
  /** The choice that each list of areas came from, for when undo restores the areas. */
  const chosen = new WeakMap<readonly number[], string>()

  const begin = () => {
    actions.tools.useTool('draw')
    figure.focus()
  }
  const open = async ({ target }: Event) => {
    const input = target as HTMLInputElement
    const file = input.files?.[0]
    if (file !== undefined) await files.openRegion(file)
    // Allows choosing the same file again.
    input.value = ''
  }
  const merge = async ({ target }: Event) => {
    const input = target as HTMLInputElement
    const { region } = store.get().domain
    files.mergesPolygons = input.checked
    if (region !== undefined) await actions.domain.setDomain({ region: plainRegion(region, input.checked) })
    draw()
  }
  const choose = async ({ target }: Event) => {
    const select = target as HTMLSelectElement
    const { value } = select
    if (value === FREE) await actions.domain.setAreas(undefined)
    else if (value === 'equal') await actions.domain.setAreas('equal')
    else if (value.startsWith(COLUMN)) await chooseColumn(value.slice(COLUMN.length))
    else if (value !== OWN)
      await actions.domain.setAreas(actions.domain.radii().map((r) => (value === 'disc' ? r * r : r)))
    const { areas } = store.get().domain
    if (Array.isArray(areas) && !chosen.has(areas)) chosen.set(areas, value)
    draw()
    // Resets a refused choice.
    select.value = chosenOf(areas)
  }

  const chooseColumn = async (name: string) => {
    const missing = (await actions.domain.setAreasBy(name)) ?? 0
    if (missing > 0) toast(`${wholeNumber(missing)} of the circles have no number in ${name}: they get the mean.`)
  }

  const drawing = (after: string) => html`
    <p>Click the corners. Close the polygon at its first corner, or with a double click. ${after}</p>
    <div class="choices">
      <button type="button" class="primary" ?disabled=${pen.count < 3} @click=${() => pen.close()}>Close polygon</button>
      <button type="button" ?disabled=${pen.count === 0} @click=${() => pen.undo()}>Undo corner</button>
      <button type="button" @click=${() => actions.tools.useTool('select')}>Cancel</button>
    </div>
  `

  const repeat = async ({ target }: Event) => {
    const input = target as HTMLInputElement
    await (input.checked ? actions.domain.repeat() : actions.domain.setLattice(undefined))
    draw()
    // A refused lattice leaves the box unchecked.
    input.checked = store.get().domain.lattice !== undefined
  }
  const setPeriod = async (lattice: Lattice, name: 'a' | 'b', axis: 0 | 1, input: HTMLInputElement) => {
    if (!input.reportValidity()) return
    const period = lattice[name].with(axis, input.valueAsNumber) as [number, number]
    await actions.domain.setLattice({ ...lattice, [name]: period })
    // A refused period goes back to its value.
    input.value = String(store.get().domain.lattice?.[name][axis] ?? '')
  }
  const periods = (lattice: Lattice) => html`<div class="fields">
    ${(['a', 'b'] as const).flatMap((name) =>
      ([0, 1] as const).map(
        (axis) => html`<label>Period ${name}, ${'xy'[axis]} <input
          type="number"
          step="any"
          required
          autocomplete="off"
          .value=${String(lattice[name][axis])}
          @change=${({ target }: Event) => setPeriod(lattice, name, axis, target as HTMLInputElement)}
        /></label>`,
      ),
    )}
  </div>`

  const body = ({ domain: { region, lattice, areas }, tool, edited }: State) => {
    const isMerged = region === undefined ? files.mergesPolygons : isDissolved(region)
    return html`
    <p>${region === undefined ? 'Clip the cells to a country, a hall with pillars, or any polygon.' : saidOf(region)}</p>
    ${
      tool === 'draw'
        ? drawing(isMerged ? 'It is merged with the region.' : 'Inside the region it becomes a hole.')
        : html`<div class="choices">
            <button type="button" @click=${begin} title="Draw a polygon, corner by corner (P)">
              ${icon(PEN)}${region === undefined ? 'Draw' : 'Draw more'}
            </button>
            <label class="button">
              ${icon(FOLDER)}Open …
              <input type="file" class="visually-hidden" accept=".geojson,.json,.wkt,.txt" @change=${open} />
            </label>
            ${
              region === undefined
                ? nothing
                : html`<button type="button" @click=${() => actions.domain.removeRegion()}>${icon(BIN)}Remove region</button>`
            }
          </div>`
    }
    <div class="layer">
      <label>
        <input
          type="checkbox"
          .checked=${isMerged}
          @change=${merge}
        />
        Merge polygons that share borders or overlap
      </label>
    </div>
    <fieldset ?disabled=${region === undefined}>
      <legend>Areas of the cells inside</legend>
      <div class="layer">
        <label for="areas">Areas</label>
        <select id="areas" @change=${choose}>
          ${optionsOf(areas).map(
            ([value, label]) => html`<option value=${value} .selected=${value === chosenOf(areas)}>${label}</option>`,
          )}
        </select>
      </div>
    </fieldset>
    <p class="quiet" id="areas-said" aria-live="polite">${aboutAreas(region, areas, edited)}</p>
    <fieldset>
      <legend>Periodic box</legend>
      <div class="layer">
        <label>
          <input type="checkbox" .checked=${lattice !== undefined} @change=${repeat} />
          Repeat the circles in a box
        </label>
      </div>
      ${lattice === undefined ? nothing : periods(lattice)}
    </fieldset>
    <p class="quiet">${aboutBox(region, lattice)}</p>
  `
  }

  const chosenOf = (areas: State['domain']['areas']) => {
    if (areas === undefined) return FREE
    if (areas === 'equal') return 'equal'
    return chosen.get(areas) ?? OWN
  }
  const optionsOf = (areas: State['domain']['areas']) => [
    [FREE, 'not fixed'],
    ...Object.entries(BY),
    ...actions.domain.columns.map((name) => [COLUMN + name, `by ${name}`]),
    ...(chosenOf(areas) === OWN ? [[OWN, 'one by one']] : []),
  ]

  let shown: readonly unknown[] = []
  store.subscribe(({ domain, tool, edited, said }) => {
    const now = [domain, tool, edited?.fitted, tool === 'draw' && said, actions.domain.columns.join()]
    if (now.every((value, k) => value === shown[k])) return
    shown = now
    draw()
  })
}

function saidOf(region: NonNullable<State['domain']['region']>): string {
  const rings = ringsOf(region)
  // A ring of GeoJSON repeats its first point at its end.
  const isClosed = (ring: (typeof rings)[number]) => String(ring[0]) === String(ring.at(-1))
  const sides = rings.reduce((sum, ring) => sum + ring.length - Number(isClosed(ring)), 0)
  const outlines = rings.length === 1 ? 'One outline' : `${wholeNumber(rings.length)} outlines`
  return `${outlines} with ${wholeNumber(sides)} sides. Cells, areas and files are clipped to it.`
}

function aboutBox(region: unknown, lattice: unknown): string {
  if (lattice !== undefined)
    return 'Opposite sides are glued together: a circle that you drag out comes in on the other side.'
  const replaced = region === undefined ? '' : ' It replaces the region.'
  return `For packings, foams and tissues in a box whose opposite sides are glued together.${replaced}`
}

function aboutAreas(region: unknown, areas: unknown, edited: State['edited']): string {
  if (region === undefined) return 'Areas need a region: the cells divide it.'
  if (areas === undefined)
    return 'Choose areas, and the diagram finds the weights of the points for which each cell has its own.'
  const error = edited?.fitted?.error
  const said = error === undefined ? '' : ` Largest error of an area: ${error.toExponential(0)}.`
  return `Drag a point: all cells keep their areas. Select one to change its share.${said}`
}
