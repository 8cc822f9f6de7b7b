// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of docs/results.md, from the data of scripts/reproduce.mjs, as SVG in light and dark.
import { parse, View } from 'vega'
import { compile } from 'vega-lite'
import { METHODS } from './methods.mjs'

/** Maps the colors of the light picture to the dark one. */
const DARK = {
  '#ffffff': '#12161d',
  '#1b2430': '#e6ebf2',
  '#dfe3e8': '#2b333f',
  '#27447c': '#8fb3ef',
  '#c0392b': '#ff8a75',
  '#b0701c': '#e6b06a',
  '#2e7d5b': '#6fcfa3',
  '#7a4fa3': '#c39bea',
  '#5f6b78': '#a3afbe',
}
const [PAPER, INK, GRID, BLUE, RED, BROWN, GREEN, VIOLET, GRAY] = Object.keys(DARK)
const COLORS = [BLUE, RED, BROWN, GREEN, VIOLET, GRAY]

const CONFIG = {
  background: PAPER,
  padding: 12,
  font: 'Helvetica, Arial, sans-serif',
  view: { stroke: null },
  axis: {
    labelColor: INK,
    titleColor: INK,
    domainColor: INK,
    tickColor: INK,
    gridColor: GRID,
    labelFontSize: 12,
    titleFontSize: 13,
    titleFontWeight: 'normal',
    labelLimit: 200,
  },
  point: { opacity: 1 },
  tick: { opacity: 1 },
  legend: { labelColor: INK, titleColor: INK, labelFontSize: 12, symbolStrokeWidth: 2, labelLimit: 320, rowPadding: 4 },
  title: { color: INK, fontSize: 13, fontWeight: 'normal', anchor: 'start' },
}

/** Maps the name of each plot to its SVG. */
export async function plots(data) {
  const specs = {
    counts: countsPlot(data.counts),
    times: timesPlot(data.times),
    'needed-samples': neededPlot(data.needed),
    failures: failuresPlot(data),
    large: largePlot(data.large),
  }
  const entries = Object.entries(specs).map(async ([name, spec]) => [name, await draw(spec)])
  return Object.fromEntries(await Promise.all(entries))
}

async function draw(spec) {
  const view = new View(parse(compile({ ...spec, config: CONFIG }).spec), { renderer: 'none' })
  const svg = await view.toSVG()
  view.finalize()
  const rules = Object.entries(DARK).flatMap(([light, dark]) =>
    ['fill', 'stroke'].map((name) => `[${name}="${light}"]{${name}:${dark}}`),
  )
  const style = `<style>@media (prefers-color-scheme: dark){${rules.join('')}}</style>`
  return `${svg.replace(/(<svg[^>]*>)/, `$1${style}`)}\n`
}

const CIRCLES = { field: 'n', type: 'quantitative', scale: { type: 'log' }, title: 'circles' }
/** Labels only powers of ten. */
function powers(format) {
  return {
    labelExpr: `abs(log(datum.value) / LN10 - round(log(datum.value) / LN10)) < 1e-6 ? format(datum.value, '${format}') : ''`,
  }
}
const LARGE = powers('~s')
const SMALL = powers('~g')

function colors(names) {
  return { field: 'what', type: 'nominal', title: null, scale: { domain: names, range: COLORS }, sort: null }
}

function countsPlot(counts) {
  const names = { samples: 'samples', threeTouchDiscs: 'three-touch discs', antipodalDiscs: 'antipodal discs' }
  const values = counts.flatMap((row) =>
    Object.entries(names).map(([key, what]) => ({ n: row.n, what, count: row[key] })),
  )
  return {
    width: 460,
    height: 300,
    data: { values },
    encoding: {
      x: { ...CIRCLES, axis: LARGE },
      y: { field: 'count', type: 'quantitative', scale: { type: 'log' }, title: 'number', axis: LARGE },
      color: colors(Object.values(names)),
    },
    layer: [
      { mark: { type: 'point', filled: true, size: 28 } },
      { mark: { type: 'line', strokeWidth: 1.5 }, encoding: { y: { aggregate: 'median', field: 'count' } } },
    ],
  }
}

function timesPlot(times) {
  const values = times.flatMap(({ n, method, repetitions }) =>
    repetitions.map((seconds) => ({ n, what: METHODS[method], seconds })),
  )
  return {
    width: 460,
    height: 360,
    data: { values },
    encoding: {
      x: { ...CIRCLES, axis: LARGE },
      y: { field: 'seconds', type: 'quantitative', scale: { type: 'log' }, title: 'seconds', axis: SMALL },
      color: colors(Object.values(METHODS)),
    },
    layer: [
      { mark: { type: 'point', filled: true, size: 22 } },
      { mark: { type: 'line', strokeWidth: 1.5 }, encoding: { y: { aggregate: 'median', field: 'seconds' } } },
    ],
  }
}

function neededPlot(needed) {
  const names = { uniform: 'uniform sampling', dynamic: 'dynamic sampling' }
  const goals = { nothingMissed: 'until no empty antipodal disc is missed', right: 'until the diagram is right' }
  const values = needed.flatMap((row) =>
    Object.entries(names).flatMap(([key, what]) =>
      Object.entries(goals)
        .filter(([goal]) => row[key][goal].most > 0)
        .map(([goal, title]) => ({ family: row.family, what, goal: title, ...row[key][goal] })),
    ),
  )
  const order = [...needed]
    .sort((a, b) => (b.uniform.nothingMissed.most ?? 1e9) - (a.uniform.nothingMissed.most ?? 1e9))
    .map(({ family }) => family)
  const panel = (title, k) => ({
    title,
    width: 250,
    height: { step: 15, for: 'position' },
    transform: [{ filter: { field: 'goal', equal: title } }],
    encoding: {
      y: {
        field: 'family',
        type: 'nominal',
        sort: order,
        title: null,
        axis: k === 0 ? {} : { labels: false, ticks: false },
      },
      yOffset: { field: 'what', sort: Object.values(names) },
      color: colors(Object.values(names)),
    },
    layer: [
      {
        mark: { type: 'rule', strokeWidth: 1.5 },
        encoding: {
          x: {
            field: 'median',
            type: 'quantitative',
            scale: { type: 'log', domain: [1, 1000] },
            title: 'samples a circle: median and most',
            axis: SMALL,
          },
          x2: { field: 'most' },
        },
      },
      { mark: { type: 'point', filled: true, size: 24 }, encoding: { x: { field: 'median', type: 'quantitative' } } },
      { mark: { type: 'tick', thickness: 2, size: 6 }, encoding: { x: { field: 'most', type: 'quantitative' } } },
    ],
  })
  return { data: { values }, hconcat: Object.values(goals).map(panel) }
}

function failuresPlot({ printed, correctness, trials }) {
  const rowOf = new Map(correctness.map((row) => [row.family, row]))
  const ways = {
    'as printed, all pairs': (row) => row.wrongOfAllPairs / trials.printed,
    'corrected, N_s = 0': (row) => rowOf.get(row.family).wrong['N_s = 0'] / trials.correctness,
    'corrected, N_s = 1': (row) => rowOf.get(row.family).wrong['N_s = 1'] / trials.correctness,
    'corrected, all pairs': (row) => rowOf.get(row.family).wrong['all pairs'] / trials.correctness,
  }
  const values = printed.families.flatMap((row) =>
    Object.entries(ways).map(([what, part]) => ({ family: row.family, what, percent: 100 * part(row) })),
  )
  const order = [...printed.families].sort((a, b) => b.wrongOfAllPairs - a.wrongOfAllPairs).map(({ family }) => family)
  return {
    width: 420,
    height: { step: 15 },
    data: { values },
    mark: { type: 'point', filled: true, size: 46, opacity: 0.9 },
    encoding: {
      x: { field: 'percent', type: 'quantitative', title: 'percent of wrong diagrams' },
      y: { field: 'family', type: 'nominal', sort: order, title: null, axis: { grid: true } },
      color: { ...colors(Object.keys(ways)), scale: { domain: Object.keys(ways), range: [RED, BROWN, BLUE, GREEN] } },
      shape: {
        field: 'what',
        sort: null,
        title: null,
        scale: { domain: Object.keys(ways), range: ['diamond', 'square', 'circle', 'triangle-up'] },
      },
    },
  }
}

function largePlot(large) {
  const values = large.map(({ n, seconds, peakMegabytes }) => ({
    n,
    microseconds: (1e6 * seconds) / n,
    bytes: (1e6 * peakMegabytes) / n,
  }))
  const panel = (field, title) => ({
    width: 250,
    height: 200,
    mark: { type: 'line', point: { filled: true, size: 40, color: BLUE }, color: BLUE, strokeWidth: 1.5 },
    encoding: {
      x: { ...CIRCLES, axis: LARGE },
      y: { field, type: 'quantitative', title, scale: { zero: true } },
    },
  })
  return {
    data: { values },
    hconcat: [panel('microseconds', 'microseconds a circle'), panel('bytes', 'bytes a circle, at the peak')],
  }
}
