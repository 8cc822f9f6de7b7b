// SPDX-License-Identifier: GPL-3.0-or-later
// The tutorial's texts from web/tutorial/chapters, with a picture of each figure by the library's own writer.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { ROOT } from '../run.mjs'
import { blockRenderer, paperFigures } from './blocks.mjs'
import { loadFigureCircles } from './figure-circles.mjs'
import { renderMarkdown } from './markdown.mjs'
import { posterOf } from './poster.mjs'
import { loadPrinted } from './printed.mjs'

const CHAPTERS = `${ROOT}web/tutorial/chapters`
/** A link that a text has into the playground: `playground:figure-14`. */
const PLAYGROUND_LINK = /playground:([\w:-]+)/g
/** Of the paper. */
const FIGURES = 16
/** Of figures; those beside what rules find as printed are squares (web/tutorial/tutorial.css). */
const ASPECT = 8 / 5

/**
 * @typedef {object} Made what there is of a figure
 * @property {number[][]} circles
 * @property {string} link what stands after the # of its link
 * @property {string} poster the file of its picture
 * @property {{ poster: string, sentence: string }} [printed] what the rules as printed find
 */

/** The chapters in their order, then what is not one of them, each with its figures and questions. */
export function readBook() {
  return readdirSync(CHAPTERS)
    .sort()
    .map((name) => {
      const markdown = readFileSync(`${CHAPTERS}/${name}`, 'utf8')
      const { title, blocks } = renderMarkdown(markdown, { block: () => '' })
      return { file: name.replace(/\.md$/, '.html'), isChapter: /^\d/.test(name), markdown, title, blocks }
    })
}

/**
 * Writes the pictures of figures.
 *
 * @param {string} folder of the built site
 * @returns {Promise<import('./page.mjs').Text[]>}
 */
export async function tutorialTexts(folder) {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const { loadFiles } = await import(`${ROOT}dist/lib/files.js`)
  const { encodeLink } = await import(`${ROOT}dist/lib/link.js`)
  const [library, files, circlesOf] = [await loadCircleVoronoi(), await loadFiles(), await loadFigureCircles()]
  const printedOf = await loadPrinted(library)
  const book = readBook()
  mkdirSync(`${folder}/tutorial/pictures`, { recursive: true })

  const picture = (diagram, { view, rules }) => {
    const bounds = view && frameOf(view, rules === undefined ? ASPECT : 1)
    // As exactly as can be seen.
    const [minX, minY, maxX, maxY] = bounds ?? boundsOf(diagram.circles)
    const tolerance = Math.max(maxX - minX, maxY - minY) / 2000
    const digits = Math.max(0, Math.ceil(-Math.log10(tolerance)))
    return files.writeDiagram(diagram, { format: 'svg', tolerance, digits, bounds })
  }
  const printed = (spec, circles) => {
    const { svg, sentence } = printedOf(circles, spec)
    const poster = `pictures/${spec.name}-printed.svg`
    writeFileSync(`${folder}/tutorial/${poster}`, svg)
    return { poster, sentence }
  }
  const made = new Map()
  for (const { spec } of book.flatMap(({ blocks }) => blocks).filter(({ spec }) => spec.name !== undefined)) {
    if (made.has(spec.name)) throw new Error(`Two figures are called ${spec.name}.`)
    const circles = circlesOf(spec)
    const poster = `pictures/${spec.name}.svg`
    writeFileSync(`${folder}/tutorial/${poster}`, posterOf(picture(library.compute(circles), spec), spec.layers))
    const { view, layers, controls, method } = spec
    const [x, y, span] = view ?? []
    const link = await encodeLink({
      circles,
      layers,
      view: view && { x, y, span },
      ...(controls === 'player' && { step: 0, method }),
    })
    made.set(spec.name, { circles, poster, link, ...(spec.rules && { printed: printed(spec, circles) }) })
  }
  const links = new Map()
  for (const [, dataSet] of book.flatMap(({ markdown }) => [...markdown.matchAll(PLAYGROUND_LINK)])) {
    links.set(dataSet, await encodeLink({ dataSet }))
  }

  const block = blockRenderer(made)
  const pages = book.map(({ file, isChapter, markdown }) => {
    const linked = markdown.replace(PLAYGROUND_LINK, (_, dataSet) => `../#${links.get(dataSet)}`)
    const { title, html } = renderMarkdown(linked, { block })
    return { folder: 'tutorial', file, isChapter, title, html }
  })
  return [contents(book), ...pages, paperPage(book)]
}

/** What a figure shows at first. */
function frameOf([x, y, span], aspect) {
  const half = { x: (aspect * span) / 2, y: span / 2 }
  return [x - half.x, y - half.y, x + half.x, y + half.y]
}

function boundsOf(circles) {
  const numbers = [0, 1].map((first) => circles.filter((_, k) => k % 3 === first))
  return [...numbers.map((list) => Math.min(...list)), ...numbers.map((list) => Math.max(...list))]
}

function contents(book) {
  const chapters = book.filter(({ isChapter }) => isChapter)
  const title = 'Contents'
  const html = `<h1>Voronoi diagrams of circles</h1>
<p>Which circle is nearest? A tutorial with pictures to drag: school geometry is enough.</p>
<ol class="contents">
${chapters.map(({ file, title }) => `<li><a href="${file}">${title}</a></li>`).join('\n')}
</ol>`
  return { folder: 'tutorial', file: 'index.html', title, html, isFound: false }
}

/** Where each figure of the paper is alive. */
function paperPage(book) {
  const title = "The paper's figures"
  const rows = Array.from({ length: FIGURES }, (_, k) => {
    const places = book.flatMap(({ file, title, blocks }) =>
      blocks
        .filter(({ spec }) => spec.paper?.figures.some((figure) => Number.parseInt(figure, 10) === k + 1))
        .map(({ spec }) => `<a href="${file}#${spec.name}">${title}</a> (${paperFigures(spec.paper).toLowerCase()})`),
    )
    if (places.length === 0) throw new Error(`Figure ${k + 1} of the paper is nowhere.`)
    return `<tr><th scope="row">Figure ${k + 1}</th><td>${places.join('<br>')}</td></tr>`
  })
  const html = `<h1>The paper’s figures</h1>
<p>The method of chapters 3 to 5 is that of “A dynamic sampling approach towards computing Voronoi diagram of a set of circles”.
Each of its figures is alive in this tutorial.</p>
<table>
<thead><tr><th scope="col">In the paper</th><th scope="col">Here</th></tr></thead>
<tbody>
${rows.join('\n')}
</tbody>
</table>`
  return { folder: 'tutorial', file: 'paper.html', title, html, isFound: false }
}
