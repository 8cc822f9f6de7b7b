// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, type TemplateResult } from 'lit/html.js'
import type { State } from '../../editing/state.ts'
import { CANDIDATES, type Candidates } from '../../lib/base/types.ts'
import {
  CELL_COLORS,
  type CellColors,
  isMethodShown,
  type Layers,
  MOST_PAIRED,
  MOST_TRACED,
  SAMPLES,
} from '../../view/layers.ts'
import type { MethodFound } from '../../view/protocol.ts'
import { short } from '../../view/short.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import { MOST_MOVING, type Motion } from '../motion/motion.ts'
import type { Radii } from '../motion/radii.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'
import { type Pictured, pictureOf } from './layer-pictures.ts'
import { saidOf } from './method-found.ts'
import { panelOf } from './panel.ts'

/** Range of the slider relative to the viewport: the least length merges only vertices that differ by rounding. */
const NEAR_ZERO = 1e-9
const FARTHEST = 0.25

const COLOR_NAMES: Readonly<Record<CellColors, string>> = {
  auto: 'automatic',
  none: 'none',
  radius: 'by radius',
  area: 'by area of the cell',
  filled: 'by share filled',
  degree: 'by neighbors',
  gap: 'by nearest distance',
  index: 'by number',
  different: 'neighbors differ',
}
/** Prefix of a column's name among the choices. */
const COLUMN = 'column:'
const CANDIDATE_NAMES: Readonly<Record<Candidates, string>> = {
  dynamic: 'dynamic samples',
  uniform: 'equally spaced samples',
  'all-pairs': 'all pairs of circles',
}
/** The layers, each with an icon and a switch. */
export function mountLayers(store: Store<State>, actions: PageActions, view: View, motion: Motion, radii: Radii): void {
  const panel = byId('layers', HTMLElement)
  const draw = () => folded.render(() => html`${waiting()} ${body(store.get())}`)
  view.on('diagram', () => draw())
  const folded = panelOf(panel, 'Layers', draw)
  motion.onchange(() => draw())

  const toggle = (name: keyof Layers & Pictured, label: string, note: unknown = nothing): TemplateResult => {
    const layers = store.get().layers
    const change = (event: Event) => view.setLayers({ [name]: (event.target as HTMLInputElement).checked })
    return row(name, label, layers[name] === true, change, note)
  }

  const waiting = () =>
    view.hasDiagram ? nothing : html`<p class="quiet">The method is played: layers are seen at its end.</p>`

  const extent = () => Math.max(view.size.width, view.size.height) / view.camera.scale

  const methodLayers = (layers: Layers, circles: number, found: MethodFound | undefined) => html`
    <fieldset>
      <legend>Touching disc method</legend>
      ${toggle('samples', 'Samples')} ${toggle('sampleGraph', 'Delaunay of samples')}
      ${toggle('antipodalDiscs', 'Antipodal discs')} ${toggle('directedEdges', 'Directed edges left')}
      ${toggle('missedEdges', 'Edges that it misses')}
      ${isMethodShown(layers) ? methodControls(layers, circles, found) : nothing}
    </fieldset>
  `

  const methodControls = ({ candidates, sampleCount }: Layers, circles: number, found: MethodFound | undefined) => {
    const { least, usual, most } = SAMPLES[candidates]
    const choose = (event: Event) => {
      const chosen = (event.target as HTMLSelectElement).value as Candidates
      view.setLayers({ candidates: chosen, sampleCount: undefined })
    }
    const count = (event: Event) => {
      const input = event.target as HTMLInputElement
      if (input.reportValidity()) view.setLayers({ sampleCount: input.valueAsNumber })
    }
    return html`
      <div class="layer">
        <label for="candidates">Candidates</label>
        <select id="candidates" @change=${choose}>
          ${CANDIDATES.map(
            (name) =>
              html`<option value=${name} .selected=${name === candidates} ?disabled=${name === 'all-pairs' && circles > MOST_PAIRED}>
                ${CANDIDATE_NAMES[name]}
              </option>`,
          )}
        </select>
      </div>
      ${
        candidates === 'all-pairs'
          ? nothing
          : html`<div class="layer">
              <label for="sample-count">${candidates === 'dynamic' ? 'N_s, samples inside an angle' : 'm, samples on a circle'}</label>
              <input id="sample-count" type="number" min=${least} max=${most} step="1" required .value=${String(sampleCount ?? usual)} @change=${count} />
            </div>`
      }
      <p class="quiet" id="method-found" aria-live="polite">${
        candidates === 'all-pairs' && circles > MOST_PAIRED
          ? `All pairs of more than ${wholeNumber(MOST_PAIRED)} circles are too many.`
          : found === undefined
            ? '…'
            : saidOf(found)
      }</p>
    `
  }

  const chooseColors = (event: Event) => {
    const { value } = event.target as HTMLSelectElement
    if (value.startsWith(COLUMN)) actions.coloring.colorBy(value.slice(COLUMN.length))
    else view.setLayers({ cells: value as CellColors, column: undefined })
  }

  const body = ({ layers, found, edited, domain, attributes }: State) => html`
    <fieldset>
      <legend>Diagram</legend>
      ${toggle('circles', 'Circles')} ${toggle('labels', 'Names')}
      <div class="layer">
        ${pictureOf('cells')}<label for="cell-colors">Colors</label>
        <select id="cell-colors" @change=${chooseColors}>
          ${CELL_COLORS.map((name) => html`<option value=${name} .selected=${layers.column === undefined && name === layers.cells}>${COLOR_NAMES[name]}</option>`)}
          ${
            attributes.columns.length === 0
              ? nothing
              : html`<optgroup label="Columns of the file">
                  ${attributes.columns.map(({ name }) => html`<option value=${COLUMN + name} .selected=${layers.column?.name === name}>${name}</option>`)}
                </optgroup>`
          }
        </select>
      </div>
      ${toggle('fullColor', 'Cells in full color')} ${toggle('edges', 'Edges')} ${toggle('vertices', 'Vertices')}
      ${layers.vertices ? mergeControl(layers) : nothing} ${toggle('hidden', 'What hides hidden circles')}
      ${cutControl(layers)} ${row('grid', 'Axes and grid', layers.grid, toggleGrid)}
    </fieldset>
    <fieldset>
      <legend>Ask</legend>
      ${toggle('disc', 'Disc at the pointer')}
      ${toggle('largestDisc', 'Largest empty disc', layers.largestDisc ? numberOf(found?.largestDisc?.disc.r, 'Its radius') : nothing)}
      ${row('path', 'Clearest path', layers.path !== undefined, togglePath, layers.path === undefined ? nothing : numberOf(found?.path?.clearance, 'How near it comes to a circle'))}
      ${toggle('hull', 'Convex hull')}
    </fieldset>
    <fieldset>
      <legend>Compare</legend>
      ${toggle('dual', 'Dual graph')} ${toggle('delaunay', 'Delaunay of centers')}
      ${toggle('ordinary', 'Voronoi of centers')} ${toggle('power', 'Power diagram')}
      ${(edited?.counts.circles ?? 0) > MOST_MOVING || domain.areas !== undefined ? nothing : radiusControl()}
    </fieldset>
    ${(edited?.counts.circles ?? 0) > MOST_TRACED ? nothing : methodLayers(layers, edited?.counts.circles ?? 0, found?.method)}
  `

  /** All three diagrams are equal without radii. */
  const radiusControl = () => html`
    <div class="layer sub">
      <label for="radii" title="Without radii, all three diagrams are the same">Radii</label>
      <input
        id="radii"
        type="range"
        min="0"
        max="1"
        step="any"
        .value=${String(radii.share)}
        @input=${(event: Event) => radii.scale((event.target as HTMLInputElement).valueAsNumber)}
      />
      ${
        matchMedia('(prefers-reduced-motion: reduce)').matches
          ? nothing
          : html`<button
              type="button"
              aria-pressed=${motion.isMoving}
              title="Watch the three diagrams part as the radii grow"
              @click=${() => (motion.isMoving ? motion.stop() : motion.start('compare'))}
            >
              ${motion.isMoving ? 'Stop' : 'Play'}
            </button>`
      }
    </div>
  `

  /** Circles snap to the grid while it is visible. */
  const toggleGrid = (event: Event) => {
    const grid = (event.target as HTMLInputElement).checked
    view.setLayers({ grid })
    if (store.get().isSnapping !== grid) actions.tools.toggleSnapping()
  }

  const togglePath = (event: Event) => {
    if (!(event.target as HTMLInputElement).checked) {
      view.setLayers({ path: undefined })
      return
    }
    view.setLayers({ path: actions.opening.pathAcross() })
  }

  const mergeControl = ({ nearZero }: Layers) => html`
    <div class="layer sub">
      <label>
        <input
          type="checkbox"
          .checked=${nearZero !== undefined}
          @change=${(event: Event) => {
            const isOn = (event.target as HTMLInputElement).checked
            view.setLayers({ nearZero: isOn ? rounded(NEAR_ZERO * extent()) : undefined })
          }}
        />merged up to length</label
      >
      ${
        nearZero === undefined
          ? nothing
          : html`<input
              type="number"
              min="0"
              step="any"
              aria-label="Length up to which vertices are merged"
              .value=${String(nearZero)}
              @change=${(event: Event) => {
                const value = (event.target as HTMLInputElement).valueAsNumber
                if (value >= 0) view.setLayers({ nearZero: value })
              }}
            />`
      }
    </div>
  `

  const cutControl = ({ maxDistance }: Layers) => html`
    ${row('maxDistance', 'Cells end at a distance', maxDistance !== undefined, (event) => {
      const isOn = (event.target as HTMLInputElement).checked
      view.setLayers({ maxDistance: isOn ? rounded(FARTHEST * 0.1 * extent()) : undefined })
    })}
    ${
      maxDistance === undefined
        ? nothing
        : html`<div class="layer sub">
            <input
              type="range"
              min="0"
              max="1"
              step="any"
              aria-label="Distance at which cells end"
              .value=${String(Math.sqrt(maxDistance / (FARTHEST * extent())))}
              @input=${(event: Event) => {
                const value = (event.target as HTMLInputElement).valueAsNumber
                view.setLayers({ maxDistance: rounded(value * value * FARTHEST * extent()) })
              }}
            /><output>${maxDistance.toPrecision(3)}</output>
          </div>`
    }
  `

  let shown: readonly unknown[] = []
  store.subscribe(({ layers, found, edited, domain, attributes }) => {
    const now = [layers, found, edited?.counts.circles, domain.areas, radii.share, attributes.columns]
    if (now.every((value, k) => value === shown[k])) return
    shown = now
    draw()
  })
}

function row(
  picture: Pictured,
  label: string,
  isOn: boolean,
  change: (event: Event) => void,
  note: unknown = nothing,
): TemplateResult {
  return html`<div class="layer">
    <label>${pictureOf(picture)}<span>${label}</span>${note}<input type="checkbox" .checked=${isOn} @change=${change} /></label>
  </div>`
}

function numberOf(value: number | undefined, name: string): TemplateResult {
  return html`<small title=${name}>${value === undefined ? '…' : short(value, 4)}</small>`
}

function rounded(value: number): number {
  return Number(short(value, 3))
}
