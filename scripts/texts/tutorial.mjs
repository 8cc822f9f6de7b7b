// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the tutorial's texts from web/tutorial/chapters, and draws each figure with the library's writer.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { ROOT } from '../run.mjs'
import { blockRenderer, paperFigures } from './blocks.mjs'
import { loadDrawn } from './drawn.mjs'
import { loadFigureCircles } from './figure-circles.mjs'
import { renderMarkdown } from './markdown.mjs'
import { fittedPoster, posterMaker } from './poster.mjs'
import { loadPrinted } from './printed.mjs'

const CHAPTERS = `${ROOT}web/tutorial/chapters`
/** Matches a text's link into the playground, such as `playground:figure-14`. */
const PLAYGROUND_LINK = /playground:([\w:-]+)/g
/** The figure on the page of contents. */
const HERO = {
  name: 'hero',
  dataSet: 'introduction',
  layers: { cells: 'different', vertices: false },
  alt: 'Fourteen circles of different sizes, each in a cell of its own color.',
  caption: 'Drag a circle or its rim.',
}
/** The kinds of blocks that the tutorial draws itself. */
const DRAWN = ['drawn', 'cones']
/** The number of figures in the paper. */
const FIGURES = 16
/** Aspect ratio of figures. Figures beside results of printed rules are squares (web/tutorial/tutorial.css). */
const ASPECT = 8 / 5

/** The chapters in their order, then the other pages, each with its figures and questions. */
export function readBook() {
  return readdirSync(CHAPTERS)
    .sort()
    .map((name) => {
      const markdown = readFileSync(`${CHAPTERS}/${name}`, 'utf8')
      const { title, blocks } = renderMarkdown(markdown, { block: () => '' })
      // The picture and the line for a chapter in the contents.
      const [, shown, line] = /^<!-- ([\w-]+): (.*) -->\n/.exec(markdown) ?? []
      return { file: name.replace(/\.md$/, '.html'), isChapter: /^\d/.test(name), markdown, title, shown, line, blocks }
    })
}

/**
 * Writes the pictures of figures.
 * @param {string} folder the folder of the built site
 * @returns {Promise<import('./page.mjs').Text[]>}
 */
export async function tutorialTexts(folder) {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const { loadFiles } = await import(`${ROOT}dist/lib/files.js`)
  const { loadRegions } = await import(`${ROOT}dist/lib/regions.js`)
  const { encodeLink } = await import(`${ROOT}dist/lib/link.js`)
  const [library, files, circlesOf] = [await loadCircleVoronoi(), await loadFiles(), await loadFigureCircles()]
  const printedOf = await loadPrinted(library)
  const drawing = await loadDrawn(library)
  const posterOf = posterMaker(library, drawing)
  const fittedOf = fittedPoster(await loadRegions(), drawing)
  const book = readBook()
  mkdirSync(`${folder}/tutorial/pictures`, { recursive: true })

  const picture = (diagram, { view, rules }) => {
    const bounds = view && frameOf(view, rules === undefined ? ASPECT : 1)
    // Uses a tolerance below visibility.
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
  const drawn = (spec, circles) => {
    const put = (name, picture) => {
      const poster = `pictures/${name}.${typeof picture === 'string' ? 'svg' : 'png'}`
      writeFileSync(`${folder}/tutorial/${poster}`, picture)
      return poster
    }
    const { picture, ...others } = drawing.draw(spec, circles)
    // The most telling place of a slider is not always the first one.
    const tile = spec.tile && put(`${spec.name}-tile`, drawing.draw({ ...spec, at: spec.tile }, circles).picture)
    return { ...others, poster: put(spec.name, picture), tile }
  }
  const made = new Map()
  for (const { kind, spec } of [{ kind: 'figure', spec: HERO }, ...book.flatMap(({ blocks }) => blocks)].filter(
    ({ spec }) => spec.name !== undefined,
  )) {
    if (made.has(spec.name)) throw new Error(`Two figures are called ${spec.name}.`)
    const circles = circlesOf(spec)
    if (DRAWN.includes(kind)) {
      made.set(spec.name, { circles, link: await encodeLink({ circles }), drawing: drawn(spec, circles) })
      continue
    }
    const poster = `pictures/${spec.name}.svg`
    const diagram = library.compute(circles)
    const { view, layers, controls, method, region, areas } = spec
    const shown = areas === undefined ? posterOf(picture(diagram, spec), diagram, spec) : fittedOf(circles, spec)
    writeFileSync(`${folder}/tutorial/${poster}`, shown)
    const [x, y, span] = view ?? []
    const link = await encodeLink({
      circles,
      layers,
      view: view && { x, y, span },
      region,
      areas,
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
  return [
    contents(
      book,
      made,
      block('figure', HERO, (text) => text),
    ),
    ...pages,
    paperPage(book),
  ]
}

/** The part of the plane that a figure shows at first. */
function frameOf([x, y, span], aspect) {
  const half = { x: (aspect * span) / 2, y: span / 2 }
  return [x - half.x, y - half.y, x + half.x, y + half.y]
}

function boundsOf(circles) {
  const numbers = [0, 1].map((first) => circles.filter((_, k) => k % 3 === first))
  return [...numbers.map((list) => Math.min(...list)), ...numbers.map((list) => Math.max(...list))]
}

function contents(book, made, hero) {
  const chapters = book.filter(({ isChapter }) => isChapter)
  const [first] = chapters
  const tiles = chapters.map(({ file, title, shown, line }, k) => {
    const { poster, drawing } = made.get(shown)
    return `<li><a href="${file}"><img src="${drawing?.tile ?? drawing?.poster ?? poster}" alt="" loading="lazy"><span class="number">${k + 1}</span><strong>${title}</strong> <span>${line}</span></a></li>`
  })
  const html = `<div class="hero">
<div>
<h1>Which circle is nearest?</h1>
<p>Circles divide the plane among themselves, along curved borders. Thirteen short chapters show how to find these borders, why the method is right, and what it is good for. You can drag everything. School geometry is enough, with a little calculus in chapter 11.</p>
<a class="go" href="${first.file}">Start with chapter 1</a>
</div>
${hero}</div>
<h2 class="hidden">Chapters</h2>
<ol class="gallery">
${tiles.join('\n')}
</ol>
<p class="more">There is also a <a href="glossary.html">glossary</a>, a page <a href="teachers.html">for teachers</a>, and a list of
<a href="paper.html">the paper’s figures</a>.</p>`
  return { folder: 'tutorial', file: 'index.html', title: 'Contents', html, isOpen: true, isFound: false }
}

/** A page that links each figure of the paper to its interactive version. */
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
<p>Chapters 3 to 5 explain the method of “A dynamic sampling approach towards computing Voronoi diagram of a set of circles”, which the tutorial calls the paper. The copy that we have names no authors.
This tutorial has a live version of each of its figures.</p>
<table>
<thead><tr><th scope="col">In the paper</th><th scope="col">Here</th></tr></thead>
<tbody>
${rows.join('\n')}
</tbody>
</table>`
  return { folder: 'tutorial', file: 'paper.html', title, html, isFound: false }
}
