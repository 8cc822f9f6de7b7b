// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, type TemplateResult } from 'lit/html.js'
import type { State } from '../../editing/state.ts'
import type { Options } from '../../lib/index.ts'
import type { Computed, Distribution } from '../../view/protocol.ts'
import type { Edited } from '../../view/scene-client.ts'
import { short } from '../../view/short.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import { byId } from './by-id.ts'
import type { Histogram } from './histogram.ts'
import { panelOf } from './panel.ts'

/** Pause after a change before cells are counted, in milliseconds. */
const COUNTING_DELAY = 250

/** The options of `compute` that can be compared. */
const WAYS: readonly (readonly [string, Options])[] = [
  ['the fastest way', {}],
  ['touching discs, dynamic samples', { method: 'touching-disc' }],
  ['the same, resampled where it fails', { method: 'touching-disc', resample: true }],
  ['touching discs, 50 samples a circle', { method: 'touching-disc', candidates: 'uniform' }],
  ['touching discs, all pairs', { method: 'touching-disc', candidates: 'all-pairs' }],
  ['edge flips', { method: 'flip' }],
]

/** The panel of counts, distributions and the certificate. */
export function mountNumbers(store: Store<State>, view: View): void {
  const panel = byId('numbers', HTMLElement)
  let edited: Edited | undefined
  let distribution: Distribution | undefined
  let computed: Computed | undefined
  /** Aborts the computation that is running. */
  let computing: AbortController | undefined
  let measuring: AbortController | undefined
  let way = 0
  let rest: ReturnType<typeof setTimeout> | undefined
  let charts: readonly Histogram[] | undefined

  const draw = () => {
    folded.render(body)
    const places = [...panel.querySelectorAll('.chart')]
    if (
      charts !== undefined &&
      !(charts.length === places.length && charts.every(({ place }, k) => place === places[k]))
    ) {
      for (const chart of charts) chart.dispose()
      charts = undefined
    }
    if (folded.isOpen && distribution !== undefined) drawCharts(distribution)
  }
  const measureAtRest = () => {
    clearTimeout(rest)
    if (folded.isOpen) rest = setTimeout(measure, COUNTING_DELAY)
  }
  const folded = panelOf(panel, 'Numbers', draw, { onopen: measureAtRest })

  const measure = async () => {
    measuring = new AbortController()
    const answer = await view.scene.ask('measure', [], measuring.signal)
    if (answer === undefined) return
    distribution = answer
    draw()
  }

  const drawCharts = async ({ areas, areaStep, degrees }: Distribution) => {
    const { Histogram } = await import('./histogram.ts')
    if (!folded.isOpen) return
    const places = [...panel.querySelectorAll<HTMLElement>('.chart')]
    charts ??= places.map((place) => new Histogram(place))
    charts.at(-1)?.show(degrees, 1, -0.5)
    // A single cell has no histogram of areas.
    if (charts.length > 1) charts[0]?.show(areas, areaStep, 0)
  }

  const compute = async () => {
    computed = undefined
    computing = new AbortController()
    const { signal } = computing
    draw()
    const answer = await view.scene.ask('compute', [(WAYS[way] as (typeof WAYS)[number])[1]], signal)
    if (signal.aborted) return
    computed = answer
    computing = undefined
    draw()
  }

  const cancel = () => {
    computing?.abort()
    computing = undefined
    draw()
  }

  const body = () => html`
    ${edited === undefined ? nothing : countsOf(edited)}
    ${distribution === undefined ? html`<p class="quiet">Counting …</p>` : distributionOf(distribution)}
    <div class="again">
      <label for="way">Compute once more by</label>
      <select
        id="way"
        @change=${(event: Event) => {
          way = (event.target as HTMLSelectElement).selectedIndex
        }}
      >
        ${WAYS.map(([name], k) => html`<option ?selected=${k === way}>${name}</option>`)}
      </select>
      <button type="button" @click=${computing === undefined ? compute : cancel}>
        ${computing === undefined ? 'Compute' : 'Cancel'}
      </button>
    </div>
    ${computing === undefined ? nothing : html`<p class="quiet">Computing …</p>`}
    ${computed === undefined ? nothing : resultOf(computed)}
  `

  store.subscribe((state) => {
    if (state.edited === edited) return
    edited = state.edited
    distribution = undefined
    computed = undefined
    // Answers about former circles are worth nothing.
    measuring?.abort()
    computing?.abort()
    computing = undefined
    measureAtRest()
    draw()
  })
}

function countsOf({ counts }: Edited): TemplateResult {
  return list([
    ['Circles', counts.circles],
    ['Hidden', counts.hidden],
    ['Vertices', counts.vertices],
    ['Edges', counts.edges],
  ])
}

function distributionOf({ certificate, medianArea, areas, areaStep, degrees }: Distribution): TemplateResult {
  const cells = degrees.reduce((sum, count) => sum + count, 0)
  const mean = degrees.reduce((sum, count, degree) => sum + degree * count, 0) / cells
  const largest = areaStep * (areas.length - 1)
  const bounded = areas.reduce((sum, count) => sum + count, 0)
  const middle = short(medianArea, 3)
  // Cells outside of the region have no area, and an axis of length zero would have endless ticks.
  const hasAreas = bounded > 1 && areaStep > 0
  return html`
    <figure>
      <figcaption>${bounded === 0 ? 'No cell is bounded' : bounded === 1 ? `Area of the bounded cell: ${middle}` : `Areas of bounded cells: half are below ${middle}${hasAreas ? `; the last bar: above ${short(largest, 3)}` : ''}`}</figcaption>
      ${!hasAreas ? nothing : html`<div class="chart" role="img" aria-label=${`Histogram of areas up to ${short(largest, 3)}; larger ones are in the last bar`}></div>`}
    </figure>
    ${
      cells === 0
        ? nothing
        : html`<figure>
            <figcaption>Neighbors: ${mean.toFixed(2)} on average</figcaption>
            <div class="chart" role="img" aria-label="Histogram of the number of neighbors"></div>
          </figure>`
    }
    <p class="certificate">
      ${
        certificate.certified
          ? 'Proven by a judge that knows nothing of how the diagram was made, with exact signs: no disc around a vertex reaches into a circle, and all cells and edges fit together.'
          : `Not proven: ${certificate.message}`
      }
    </p>
  `
}

function resultOf(computed: Computed): TemplateResult {
  if ('problem' in computed) return html`<p class="wrong">${computed.problem}</p>`
  const { stats, certificate } = computed
  const { counts, seconds } = stats
  const ms = (value: number) => `${(1000 * value).toFixed(value < 0.01 ? 2 : 0)} ms`
  const stages = Object.entries(seconds).filter(([name, value]) => name !== 'total' && value > 0)
  return html`
    ${list(
      (
        [
          ['Made by', stats.way],
          ['Samples', counts.samples],
          ['Antipodal discs', counts.antipodalDiscs],
          ['Three-touch discs', counts.threeTouchDiscs],
          ['Flips', counts.flips],
          ['Repairs', counts.repairs],
          ['Signs by doubles', counts.filtered],
          ['by twice the digits', counts.refined],
          ['by exact numbers', counts.exact + counts.inCircle],
          ...stages.map(([name, value]) => [`Time to ${name}`, ms(value)] as const),
          ['Time in all', ms(seconds.total)],
        ] as const
      ).filter(([, value]) => value !== 0),
    )}
    <p class=${certificate.certified ? 'certificate' : 'wrong'}>
      ${certificate.certified ? 'This one is certified, too.' : `This one is wrong: ${certificate.message}`}
    </p>
  `
}

function list(entries: readonly (readonly [string, string | number])[]): TemplateResult {
  return html`<dl>
    ${entries.map(([name, value]) => html`<div><dt>${name}</dt><dd>${typeof value === 'number' ? wholeNumber(value) : value}</dd></div>`)}
  </dl>`
}
