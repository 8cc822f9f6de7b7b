// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import type { State } from '../../editing/state.ts'
import type { Measure } from '../../view/layers.ts'
import type { Legend } from '../../view/protocol.ts'
import type { Store } from '../../view/store.ts'
import { readStyle, type Style } from '../../view/style.ts'
import type { View } from '../../view/view.ts'
import { byId } from './by-id.ts'

const NAMES: Readonly<Record<Measure, string>> = {
  radius: 'Radius of the circle',
  area: 'Area of the cell',
  filled: 'Share of the cell that the circle fills',
  degree: 'Number of neighbors',
  gap: 'Distance to the nearest circle',
  index: 'Number of the circle',
}

/** The legend on the canvas, shown while colors show a measure. */
export function mountLegend(store: Store<State>, view: View): void {
  const place = byId('legend', HTMLElement)
  let legend: Legend | undefined
  let shown: readonly unknown[] = []

  const draw = () => {
    place.hidden = legend === undefined || !view.hasDiagram
    if (legend === undefined) return
    drawLegend(place, legend, readStyle(byId('figure', HTMLElement)))
  }
  const ask = async () => {
    const asked = shown
    const answer = await view.scene.ask('legend', [])
    // The answer may be outdated.
    if (asked !== shown) return
    legend = answer
    draw()
  }
  store.subscribe(({ layers, domain, scene, edited, history }) => {
    // The circles, their limits or the colors were replaced. Edits leave the meaning of colors unchanged.
    const opened = history.done.length + history.undone.length === 0 ? edited : history.done.findLast(isOpening)
    const limits = [layers.maxDistance, domain.region]
    const now = [layers.cells, layers.column, ...limits, scene?.dataSet, opened, edited === undefined]
    if (now.every((value, k) => value === shown[k])) return
    shown = now
    ask()
  })
  view.on('diagram', draw)
  for (const query of ['(prefers-color-scheme: dark)', '(forced-colors: active)']) {
    matchMedia(query).addEventListener('change', draw)
  }
}

/** Draws a legend in the colors of a figure. `unit`: of the measure. */
export function drawLegend(place: HTMLElement, legend: Legend, { ramp, map }: Style, unit = ''): void {
  render(legend.categories === undefined ? bodyOf(legend, unit) : categoriesOf(legend, map), place)
  for (const [k, swatch] of place.querySelectorAll<HTMLElement>('.swatch').entries()) {
    swatch.style.background = map[k] ?? 'transparent'
  }
  const canvas = place.querySelector('canvas')
  if (canvas !== null) drawRamp(canvas, ramp)
}

const isOpening = ({ kind }: State['history']['done'][number]) => kind === 'opening'

/** The title of the legend. */
function nameOf({ measure, name }: Legend): string {
  return measure === 'column' ? (name ?? '') : NAMES[measure]
}

function categoriesOf(legend: Legend, map: readonly string[]) {
  const { categories = [], hasOthers = false } = legend
  const texts = [...categories.slice(0, map.length), ...(hasOthers ? ['others'] : [])]
  return html`<span>${nameOf(legend)}</span>
    <ul class="categories">${texts.map((text) => html`<li><span class="swatch"></span><span title=${text}>${text}</span></li>`)}</ul>`
}

function bodyOf(legend: Legend, unit: string) {
  const { knots, isClipped } = legend
  const texts = knots.map(text)
  // Equal circles have one color.
  const isOne = knots[0] === knots.at(-1)
  const ends = (value: string, k: number) =>
    !isClipped ? value : k === 0 ? `≤ ${value}` : k === texts.length - 1 ? `≥ ${value}` : value
  const name = `${nameOf(legend)}${unit === '' ? '' : ` (${unit})`}`
  if (isOne) return html`<span>${name}: ${texts[0]} ${isClipped ? 'for nearly all' : 'for all'}</span>`
  return html`<span>${name}</span>
    <canvas height="1" aria-hidden="true"></canvas>
    <span class="knots">${texts.map((value, k) => html`<span>${ends(value, k)}</span>`)}</span>`
}

function drawRamp(canvas: HTMLCanvasElement, ramp: readonly string[]): void {
  canvas.width = ramp.length
  const context = canvas.getContext('2d') as CanvasRenderingContext2D
  for (const [k, color] of ramp.entries()) {
    context.fillStyle = color
    context.fillRect(k, 0, 1, 1)
  }
}

function text(value: number): string {
  if (Number.isInteger(value) && Math.abs(value) < 1e5) return String(value)
  const short = Number(value.toPrecision(2))
  return Math.abs(short) >= 1e6 || (short !== 0 && Math.abs(short) < 1e-3) ? short.toExponential(0) : String(short)
}
