// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a text into a page of the site: web/tutorial/page.html or web/docs/page.html as built by Vite.
import { firstSentence, headingsOf, wordsOf } from './sections.mjs'

/** The main pages, relative to the site's folder. */
const MAIN = [
  { href: '', title: 'Playground' },
  { href: 'tutorial/', title: 'Tutorial' },
  { href: 'docs/', title: 'Docs' },
  { href: 'docs/examples.html', title: 'Examples' },
  { href: 'api/', title: 'Reference' },
]

/** A page with this many sections has a table of contents. */
const LONG = 3
/** Subsections are listed if there are not more than this. */
const MOST_LISTED = 40

const NAMES = { tutorial: 'Chapters', docs: 'Documentation', api: 'Modules' }

/**
 * Links to the main parts of the site. `root` is the site's address from the page, `here` the page's address from
 * there.
 */
function linksTo(root, here) {
  return MAIN.map(({ href, title }) => link({ href: root + href, title }, href === here)).join(' ')
}

function link({ href, title }, isCurrent) {
  return `<a href="${href}"${isCurrent ? ' aria-current="page"' : ''}>${escaped(title)}</a>`
}

/**
 * @typedef {object} Text a page before it has one
 * @property {'tutorial' | 'docs' | 'api'} folder of the site
 * @property {string} file its name there
 * @property {string} title
 * @property {string} html the text
 * @property {boolean} [isListed] whether other pages of its folder name it: by default so
 * @property {boolean} [isChapter] whether it is a numbered chapter
 * @property {boolean} [isOpen] whether it is as wide as the window, without a list of pages beside it
 * @property {boolean} [isBroad] whether its table of contents leaves the room beside it to long lines of code
 * @property {boolean} [isFound] whether the search finds it: by default so
 */

/**
 * @param {string} template
 * @param {Text} text
 * @param {readonly Text[]} all the pages of its folder, in their order
 */
export function pageOf(template, text, all) {
  const { title, html } = text
  // Signatures come first, as quotations.
  const [, paragraph = ''] = /<p>([\s\S]*?)<\/p>/.exec(html.replace(/<blockquote>[\s\S]*?<\/blockquote>/g, '')) ?? []
  const description = firstSentence(wordsOf(paragraph)) || `${title}.`
  const filled = { title: escaped(title), description: escaped(description), body: bodyOf(text, all) }
  const styled = html.includes('<math')
    ? template.replace('</head>', '<link rel="stylesheet" href="../tutorial/math.css">\n</head>')
    : template
  return styled.replace(/\{\{(\w+)\}\}/g, (_, name) => filled[name])
}

/**
 * @param {Text} text
 * @param {readonly Text[]} all
 */
function bodyOf({ folder, file, html, isChapter, isOpen, isBroad }, all) {
  const here = `${folder}/${file === 'index.html' ? '' : file}`
  const items = (pages) =>
    pages.map((page) => `<li>${link({ href: addressOf(page), title: page.title }, page.file === file)}</li>`).join('\n')
  const chapters = all.filter((page) => page.isChapter)
  const others = all.filter(({ isChapter, isListed = true }) => !isChapter && isListed)
  const k = chapters.findIndex((page) => page.file === file)
  /** @type {(Text | undefined)[]} */
  const [previous, next] = isChapter ? [chapters[k - 1] ?? all[0], chapters[k + 1]] : []
  const pages = `<nav class="pages" aria-label="${NAMES[folder]}">
${chapters.length === 0 ? '' : `<ol>\n${items(chapters)}\n</ol>\n`}<ul>
${items(others)}
</ul>
</nav>
`
  const contents = isOpen ? '' : tableOfContents(html)
  return `<a class="skip" href="#text">Skip to the text</a>
<header>
<a class="brand" href="../">circle-voronoi</a>
<nav class="site" aria-label="Site">${linksTo('../', here)}</nav>
<search><form class="search"><input type="search" name="q" autocomplete="off" aria-label="Search" placeholder="Search"></form><ol class="found" aria-live="polite" hidden></ol></search>
</header>
<div class="columns${isOpen ? ' open' : ''}${isBroad ? ' broad' : ''}">
${isOpen ? '' : `${pages}${contents === '' ? '' : `<nav class="toc" aria-labelledby="toc"><p id="toc">On this page</p>\n${contents}</nav>\n`}`}<main id="text">
${contents === '' ? html : withContents(html, contents)}
${
  isChapter
    ? `<nav class="turn" aria-label="Next and previous chapter">
<a rel="prev" href="${addressOf(previous)}">← ${escaped(previous.title)}</a>
${next ? `<a rel="next" href="${addressOf(next)}">${escaped(next.title)} →</a>` : ''}
</nav>`
    : ''
}
</main>
</div>`
}

/** The table of contents of a long page. */
function tableOfContents(html) {
  const all = headingsOf(html).filter(({ level }) => level < 4)
  const headings = all.length > MOST_LISTED ? all.filter(({ level }) => level === 2) : all
  if (headings.filter(({ level }) => level === 2).length < LONG) return ''
  const items = headings.map(
    ({ level, id, title }) => `<li${level === 3 ? ' class="deep"' : ''}><a href="#${id}">${escaped(title)}</a></li>`,
  )
  return `<ul>\n${items.join('\n')}\n</ul>\n`
}

/** In narrow windows the table of contents is folded below the title. */
function withContents(html, contents) {
  const folded = `<details class="toc-folded"><summary>On this page</summary>\n${contents}</details>`
  return html.replace('</h1>', () => `</h1>\n${folded}`)
}

/**
 * The address relative to another page of the same folder. A folder's address has no file name, under which it is
 * cached for offline use.
 */
function addressOf({ file }) {
  return file === 'index.html' ? './' : file
}

export function escaped(text) {
  return text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c])
}

/** The source code of a file as a block in a text. */
export function codeBlock(source) {
  return `<pre><code>${escaped(source)}</code></pre>`
}
