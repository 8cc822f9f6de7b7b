// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the static picture of a figure with the library's writer, in the style of the page and with the figure's
// layers. It is shown until the figure runs, in print, and without scripts.
import { readFileSync } from 'node:fs'
import { ROOT } from '../run.mjs'

/** Groups of the writer that figures show on request only. */
const ASKED_FOR = ['dual', 'hull']
/** Groups that figures show by default. */
const USUAL = ['vertices', 'edges', 'circles']

const STYLE = `
svg { background: var(--paper); }
.cells { fill: none; fill-opacity: 0.23; }
.edges { stroke: var(--edge); }
.vertices { fill: var(--edge); }
.circles { fill-opacity: 1; stroke: none; }
.circles .hidden { fill: none; stroke: var(--bad); }
.dual { stroke: var(--good); stroke-width: 1.5; }
.hull { stroke: var(--c4); stroke-dasharray: none; stroke-width: 1.75; }
.c0 { fill: var(--c0); }
.c1 { fill: var(--c1); }
.c2 { fill: var(--c2); }
.c3 { fill: var(--c3); }
.c4 { fill: var(--c4); }
.c5 { fill: var(--c5); }
.lines { fill: none; stroke-width: 1.25; }
.delaunay { stroke: var(--c1); }
.steps { stroke: #c2185b; stroke-width: 2; }
.sampleGraph, .rims { stroke: var(--ink-3); }
.samples { fill: var(--c3); }
.antipodalDiscs { stroke: var(--good); }
.directedEdges { stroke: var(--bad); }
.missedEdges { stroke: var(--bad); stroke-width: 3; }
`

/** Discs are pale below other layers. */
const PALE = '.circles > * { fill: color-mix(in srgb, var(--c0) 32%, var(--paper)); }\n'

/**
 * @param {import('../../dist/lib/index.js').CircleVoronoi} library
 * @param {{ colorsOf: Function, extrasOf: Function }} drawing the page's own code for colors and extra layers of figures
 */
export function posterMaker(library, { colorsOf, extrasOf }) {
  const tokens = readFileSync(`${ROOT}web/style/tokens.css`, 'utf8')

  /**
   * @param {string} svg
   * @param {object} diagram
   * @param {{ layers?: Record<string, unknown>, stepsBetween?: readonly number[] }} spec a figure of a chapter
   */
  return (svg, diagram, { layers = {}, stepsBetween }) => {
    const colors = colorsOf(diagram)
    const left = [...ASKED_FOR, ...USUAL]
      .filter((name) => layers[name] !== true && (ASKED_FOR.includes(name) || layers[name] === false))
      .reduce((rest, name) => rest.replace(new RegExp(`<g class="${name}"[\\s\\S]*?</g>\n`), ''), svg)
    const isPale = layers.samples || layers.sampleGraph || layers.delaunay
    const isPlain = layers.cells === 'none'
    const colored = left
      .replace(/<path data-circle="(\d+)"/g, (all, i) => (isPlain ? all : `<path class="c${colors[i]}"`))
      .replace(/<circle data-circle="(\d+)" class="hidden/g, '<circle class="hidden')
      .replace(/<circle data-circle="(\d+)"( class="[^"]*)?/g, (_, i, names) =>
        names === undefined ? `<circle class="c${colors[i]}"` : `<circle${names} c${colors[i]}`,
      )
    const more = extraLayers(library, diagram, layers, stepsBetween, extrasOf)
    return colored
      .replace('</style>', `${tokens}${STYLE.trimStart()}${isPale ? PALE : ''}</style>`)
      .replace(/<\/g>\s*<\/svg>\s*$/, `${more}</g>\n</svg>\n`)
  }
}

/** The picture of a figure with prescribed areas in a region. */
export function fittedPoster({ region: regionOf, fitAreas }, { colorsOf }) {
  const tokens = readFileSync(`${ROOT}web/style/tokens.css`, 'utf8')
  return (circles, { region: shape, areas, view: [x, y, span] }) => {
    const region = regionOf(shape)
    const shares = areas === 'equal' ? circles.map(() => 1) : areas.split(' ').map(Number)
    const { diagram } = fitAreas(circles, shares, { region, shares: true })
    const colors = colorsOf(diagram)
    const [width, height] = [1.6 * span, span]
    const options = { region, digits: 4, tolerance: span / 4000 }
    const cells = circles.map(
      (_, i) => `<path class="c${colors[i]}" fill-opacity="0.35" d="${diagram.cellPath(i, options)}"/>`,
    )
    const sites = circles.map(([cx, cy], i) => `<circle class="c${colors[i]}" cx="${cx}" cy="${cy}" r="${span / 80}"/>`)
    const lines = [diagram.render(options), diagram.renderBounds(options)].map((d) => `<path class="line" d="${d}"/>`)
    return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${x - width / 2} ${-y - height / 2} ${width} ${height}"><style>
${tokens}${STYLE}.line { fill: none; stroke: var(--edge); stroke-width: 1.5; vector-effect: non-scaling-stroke; }
</style><g transform="scale(1 -1)">${[...cells, ...lines, ...sites].join('\n')}</g></svg>
`
  }
}

/** Layers that the writer lacks: graphs of centers and samples, and intermediate results of the method. */
function extraLayers(library, diagram, layers, stepsBetween, extrasOf) {
  const { circles } = diagram
  const parts = []
  const centerOf = (i) => [circles[3 * i], circles[3 * i + 1]]
  const lines = (name, segments) => {
    const d = segments.map(([[x0, y0], [x1, y1]]) => `M${short(x0)},${short(y0)}L${short(x1)},${short(y1)}`).join('')
    if (d !== '') parts.push(`<path class="lines ${name}" d="${d}"/>`)
  }
  const discs = (name, list) =>
    parts.push(
      `<g class="lines ${name}">${list.map(([x, y, r]) => `<circle cx="${short(x)}" cy="${short(y)}" r="${short(Math.abs(r))}"/>`).join('')}</g>`,
    )
  if (layers.delaunay) {
    const centers = library.compute(Float64Array.from(circles, (value, k) => (k % 3 === 2 ? 0 : value)))
    lines(
      'delaunay',
      pairsOf(centers.edges).map((pair) => pair.map(centerOf)),
    )
  }
  const { samples, sampleGraph, antipodalDiscs, directedEdges, missedEdges, candidates, sampleCount } = layers
  if (samples || sampleGraph || antipodalDiscs || directedEdges || missedEdges) {
    const trace = library.trace(circles, { candidates, samples: sampleCount })
    const state = trace.at(trace.length)
    const pointOf = (k) => [trace.event(k).disc.x, trace.event(k).disc.y]
    if (sampleGraph) {
      const ends = (k) => trace.event(k).numbers.map((sample) => pointOf(state.samples[sample]))
      lines('sampleGraph', [...state.sampleEdges].map(ends))
    }
    if (samples) {
      const [minX, minY, maxX, maxY] = boxOf(circles)
      const r = Math.max(maxX - minX, maxY - minY) / 250
      discs(
        'samples',
        [...state.samples].map((k) => [...pointOf(k), r]),
      )
    }
    if (antipodalDiscs) {
      const discOf = (k) => [trace.event(k).disc.x, trace.event(k).disc.y, trace.event(k).disc.r]
      discs('antipodalDiscs', [...state.antipodalDiscs].map(discOf))
    }
    if (directedEdges)
      lines(
        'directedEdges',
        [...state.directedEdges].map((k) => trace.event(k).circles.map(centerOf)),
      )
  }
  for (const { id, discs: rims, segments } of extrasOf(
    circles,
    { hasRims: samples === true, steps: stepsBetween },
    library,
  )) {
    if (rims) discs(id, chunks(rims, 3))
    if (segments)
      lines(
        id,
        chunks(segments, 4).map(([x0, y0, x1, y1]) => [
          [x0, y0],
          [x1, y1],
        ]),
      )
  }
  return parts.join('\n')
}

function pairsOf(edges) {
  return chunks(edges, 4).map(([a, b]) => [a, b])
}

function chunks(list, size) {
  return Array.from({ length: list.length / size }, (_, k) => [...list.slice(size * k, size * (k + 1))])
}

function boxOf(circles) {
  const numbers = [0, 1].map((first) => [...circles].filter((_, k) => k % 3 === first))
  return [...numbers.map((list) => Math.min(...list)), ...numbers.map((list) => Math.max(...list))]
}

function short(value) {
  return Number(value.toPrecision(6))
}
