// SPDX-License-Identifier: GPL-3.0-or-later
// Renders the blocks of a chapter as HTML. Without scripts, readers see pictures, questions and their answers.
import { escaped } from './page.mjs'

/** The playground's address relative to a chapter. */
const PLAYGROUND = '../'
/** Colors of cells that mean no number. */
const PLAIN_CELLS = [undefined, 'auto', 'none', 'different']

/**
 * @param {{ get(name: string): Required<import('./tutorial.mjs').Made> }} made the links and picture files of figures by name, the
 * result of the printed rules where they are compared, and the first drawing of the tutorial's own figures
 */
export function blockRenderer(made) {
  let questions = 0
  const renderers = {
    figure: (spec, inline) => figure(spec, inline),
    corrupt: (spec, inline) => figure(spec, inline, ' data-corrupt'),
    printed,
    drawn,
    cones,
    try: trial,
    question,
  }
  return (kind, spec, inline) => renderers[kind](spec, inline)

  function figure(spec, inline, more = '') {
    const { name, caption, layers = {}, unit = '', sliders = [], hasCounts, stepsBetween } = spec
    const steps = stepsBetween === undefined ? '' : ` data-steps="${stepsBetween.join(' ')}"`
    const isPale = layers.samples || layers.sampleGraph || layers.delaunay
    const legend = PLAIN_CELLS.includes(layers.cells) ? '' : `<div class="legend" data-unit="${escaped(unit)}"></div>\n`
    return `<figure id="${name}"${isPale ? ' class="pale"' : ''}${more}${layers.samples ? ' data-rims' : ''}${steps}>
${more === '' ? element(spec) : `<div class="numbered">${element(spec)}</div>`}
${sliders.map((slider) => range(name, slider, inline)).join('')}${hasCounts ? '<p><output class="counts"></output></p>\n' : ''}${legend}<figcaption>${inline(caption)} ${links(spec, inline)}</figcaption>
</figure>
${rules(spec, inline)}${asked(spec, inline)}`
  }

  /** Two pictures: by the corrected rules and by the printed ones. */
  function printed(spec, inline) {
    const { name, rules, caption } = spec
    const { poster, sentence } = made.get(name).printed
    const what = rules.length === 1 ? 'rule' : 'rules'
    return `<figure id="${name}" class="printed" data-rules="${rules.join(' ')}">
<div class="pair">
<div><p class="title">With the corrected ${what}</p>
${element(spec)}</div>
<div><p class="title">With the ${what} as printed</p>
<div class="picture"><img src="${poster}" alt="The same circles, with what the ${what} as printed find." loading="lazy"></div></div>
</div>
<p><output>${escaped(sentence)}</output></p>
<figcaption>${inline(caption)} ${links(spec, inline)}</figcaption>
</figure>
${asked(spec, inline)}`
  }

  /** A figure that the tutorial draws itself (web/tutorial/drawn). */
  function drawn(spec, inline) {
    const { name, kind, point, region, view, at = 0, label, plays, caption, alt } = spec
    const { circles, drawing } = made.get(name)
    const data = escaped(JSON.stringify({ kind, circles, point, region, view, at }))
    const button = (names, text) => `<button type="button" class="${names}">${text}</button>`
    return `<figure id="${name}" class="drawn-figure" data-drawn="${data}">
<div class="picture ${kind}"><img src="${drawing.poster}" alt="${escaped(alt)}" width="640" height="${drawing.height}" loading="lazy"></div>
<div class="drive">${plays ? `${button('play', 'Play')}${button('back', 'Back')}${button('forth', 'Next')}` : ''}<label class="slider"><span>${inline(label)}</span> <input type="range" min="0" max="${drawing.last}" step="${drawing.step}" value="${at}"></label></div>
<p class="telling"><output class="told">${escaped(drawing.told)}</output></p>
<figcaption>${inline(caption)} ${links(spec, inline)}</figcaption>
</figure>
${rules(spec, inline)}${asked(spec, inline)}`
  }

  /** The picture of cones that readers can turn. */
  function cones(spec, inline) {
    const { name, view, tilt, turn, caption, alt } = spec
    const { circles, drawing } = made.get(name)
    const slider = (label, from, to, at) =>
      `<label class="slider"><span>${label}</span> <input type="range" min="${from}" max="${to}" step="1" value="${at}"> <output>${at}°</output></label>`
    return `<figure id="${name}" class="drawn-figure" data-cones="${escaped(JSON.stringify({ circles, view }))}">
<div class="picture"><img src="${drawing.poster}" alt="${escaped(alt)}" width="640" height="400" loading="lazy"></div>
<div class="drive">${slider('Height of your eye', 0, 90, tilt)}${slider('Turn', -180, 180, turn)}</div>
<figcaption>${inline(caption)} ${links(spec, inline)}</figcaption>
</figure>
${asked(spec, inline)}`
  }

  function trial(spec, inline) {
    const { name, ask, solution } = spec
    return `<div class="try" role="group" aria-labelledby="${name}-ask">
<p class="title">Try it</p>
<p id="${name}-ask">${inline(ask)}</p>
<figure id="${name}">
${element(spec)}
<div class="drive"><p class="now"></p><button type="button" class="undo">Undo</button><button type="button" class="reset">Reset</button></div>
<figcaption><output data-done="Well done."></output> ${links(spec, inline)}</figcaption>
</figure>
${help(spec, inline, `<button type="button" class="show" data-circles="${escaped(JSON.stringify(solution))}">Show me</button>`)}</div>
`
  }

  function element(spec) {
    const { layers, controls, method, view, check, region, areas, alt } = spec
    const { circles, poster } = made.get(spec.name)
    const attributes = {
      circles: JSON.stringify(circles),
      layers: layers && JSON.stringify(layers),
      region: region && JSON.stringify(region),
      areas,
      controls,
      method,
      view: view?.join(' '),
      check: check && JSON.stringify(check),
      alt,
    }
    const written = Object.entries(attributes)
      .filter(([, value]) => value !== undefined)
      .map(([name, value]) => `${name}="${escaped(String(value))}"`)
    return `<circle-voronoi ${written.join(' ')}><img slot="poster" src="${poster}" alt="${escaped(alt)}" loading="lazy"></circle-voronoi>`
  }

  function links({ name, kind, paper }, inline) {
    // The playground has no globe.
    if (kind?.startsWith('globe')) return `<a href="${PLAYGROUND}examples/globe/">Open a globe of cities</a>`
    const open = `<a class="open" href="${PLAYGROUND}#${made.get(name).link}">Open in the playground</a>`
    if (paper === undefined) return open
    return `${open} <span class="paper">${paperFigures(paper)} of the paper: ${inline(paper.note)}</span>`
  }

  function question(spec, inline) {
    const { ask, choices, right } = spec
    const name = `question-${++questions}`
    const options = choices.map(
      (choice, k) => `<label><input type="radio" name="${name}" value="${k}"> <span>${inline(choice)}</span></label>`,
    )
    return `<form class="question" data-right="${right}">
<fieldset><legend>${inline(ask)}</legend>
${options.join('\n')}
</fieldset>
<button>Check</button> <output></output>
${help(spec, inline)}</form>
`
  }
}

/** Formats `Figure 5`, or `figures 5 d and 13 a`. */
export function paperFigures({ figures }) {
  return figures.length === 1
    ? `Figure ${figures[0]}`
    : `Figures ${figures.slice(0, -1).join(', ')} and ${figures.at(-1)}`
}

function range(name, { label, changes, from, to, at, step = 'any' }, inline) {
  return `<label class="slider"><span>${inline(label)}</span> <input type="range" data-figure="${name}" data-changes="${changes}" min="${from}" max="${to}" step="${step}" value="${at}"> <output>${at}</output></label>
`
}

/**
 * The rules that the figure above shows. Each names a place of the figure: an event, or a change. With scripts, readers see
 * one rule at a time.
 */
function rules({ name, rulesShown, show }, inline) {
  if (rulesShown === undefined) return ''
  const items = rulesShown.map(
    ({ at, text }) => `<li${at === undefined ? '' : ` data-at="${at}"`}>${inline(text)}</li>`,
  )
  return `<div class="rules" data-figure="${name}" data-show="${show}">
<ol>
${items.join('\n')}
</ol>
</div>
`
}

/** An exercise with the figure above. */
function asked(spec, inline) {
  if (spec.ask === undefined) return ''
  return `<div class="asked"><p>${inline(spec.ask)}</p>
${help(spec, inline)}</div>
`
}

function help({ hint, answer }, inline, more = '') {
  return `<details class="hint"><summary>Hint</summary><p>${inline(hint)}</p></details>
<details class="answer"><summary>Answer</summary><p>${inline(answer)} ${more}</p></details>
`
}
