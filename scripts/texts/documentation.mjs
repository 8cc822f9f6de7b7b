// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the documentation: the repository's own texts, the manual page, the examples and the C++ headers.
import { execFileSync } from 'node:child_process'
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, posix } from 'node:path'
import { ROOT } from '../run.mjs'
import { buildGallery } from './gallery.mjs'
import { renderMarkdown, slugOf } from './markdown.mjs'
import { codeBlock } from './page.mjs'

/** Maps texts of the repository to their places in the site. */
export const TEXTS = {
  'README.md': 'index.html',
  'docs/javascript.md': 'javascript.html',
  'docs/cookbook.md': 'cookbook.html',
  'docs/regions.md': 'regions.html',
  'docs/areas.md': 'areas.html',
  'docs/periodic.md': 'periodic.html',
  'docs/metrics.md': 'metrics.html',
  'docs/element.md': 'element.html',
  'docs/embedding.md': 'embedding.html',
  'docs/put-it-into.md': 'put-it-into.html',
  'docs/cpp.md': 'cpp.html',
  'docs/python.md': 'python.html',
  'docs/shell.md': 'shell.html',
  'docs/tiles.md': 'tiles.html',
  'docs/building.md': 'building.html',
  'docs/results.md': 'results.html',
  'ARCHITECTURE.md': 'architecture.html',
  'public/data/README.md': 'data.html',
  'CONTRIBUTING.md': 'contributing.html',
  'CHANGELOG.md': 'changelog.html',
}
const PICTURE = /\.(jpg|png|svg)$/
const HEADERS = 'cpp/include/circle_voronoi'
const MANUAL = 'cpp/cli/circle-voronoi.1'
const PLAYGROUND = 'web/index.html'

/**
 * Copies the pictures of the documents, and examples that are pages.
 * @param {string} site the folder of the built site
 * @returns {Promise<import('./page.mjs').Text[]>}
 */
export async function documentationTexts(site) {
  const texts = Object.entries(TEXTS).map(([path, file]) => {
    const link = (address) => siteAddress(site, path, address)
    const { title, html } = renderMarkdown(readFileSync(ROOT + path, 'utf8'), { link })
    return { folder: /** @type {const} */ ('docs'), file, title: file === 'index.html' ? 'Overview' : title, html }
  })
  const [first, ...others] = texts
  const after = (file, more) => others.splice(others.findIndex((text) => text.file === file) + 1, 0, more)
  after('cookbook.html', await examples(site))
  after('cpp.html', cppReference())
  after('shell.html', commandLine())
  return [first, ...others]
}

/** The address in the site of a link in a text of the repository. */
function siteAddress(site, from, address) {
  if (/^(\w+:|#)/.test(address)) return address
  const [path, fragment] = address.split('#')
  const target = posix.normalize(posix.join(dirname(from), path))
  const page = TEXTS[target]
  if (page !== undefined) return `${page === 'index.html' ? './' : page}${fragment === undefined ? '' : `#${fragment}`}`
  if (PICTURE.test(target)) {
    const copy = target.replace(/^docs\//, '')
    mkdirSync(dirname(`${site}/docs/${copy}`), { recursive: true })
    copyFileSync(ROOT + target, `${site}/docs/${copy}`)
    return copy
  }
  if (target === PLAYGROUND) return '../'
  if (target === MANUAL) return 'command-line.html'
  if (dirname(target) === HEADERS) return `headers.html#${slugOf(posix.basename(target))}`
  if (target === 'LICENSE') {
    copyFileSync(`${ROOT}LICENSE`, `${site}/docs/license.txt`)
    return 'license.txt'
  }
  const chapter = /^web\/tutorial\/chapters\/(.*)\.md$/.exec(target)
  if (chapter !== null) return `../tutorial/${chapter[1]}.html`
  const example = /^examples(?:\/(.*))?$/.exec(target)
  if (example === null || !existsSync(ROOT + target))
    throw new Error(`${from} links to ${address}, which is not in the site.`)
  return `examples.html${example[1] === undefined ? '' : `#${slugOf(example[1])}`}`
}

function commandLine() {
  const manual = execFileSync('mandoc', ['-T', 'html', '-O', 'fragment', ROOT + MANUAL], {
    encoding: 'utf8',
  })
    // Removes the header and footer of a printed page, and self-links of names.
    .replace(
      /<table class="(head|foot)">[\s\S]*?<\/table>|<section class="Sh">\s*<h1[^>]*id="NAME"[\s\S]*?<\/section>/g,
      '',
    )
    // Options that share a description leave a space in its place.
    .replace(/<dd>&#x00A0;<\/dd>/g, '<dd></dd>')
    .replace(/<a class="permalink"[^>]*>([\s\S]*?)<\/a>/g, '$1')
    // Lowers headings below the page's title. The policy of the page allows no style attributes.
    .replace(/<(\/?)h([12])\b/g, (_, end, level) => `<${end}h${Number(level) + 1}`)
    .replace(/ style="[^"]*"/g, '')
  const title = 'The manual page'
  const html = `<h1>${title}</h1>\n<p>Every command and option of the program <code>circle-voronoi</code>, as <code>man circle-voronoi</code> shows them.</p>\n${manual}`
  return page('command-line.html', title, html)
}

async function examples(site) {
  return page('examples.html', 'Examples', await buildGallery(site))
}

function cppReference() {
  const title = 'The C++ headers'
  // abi.h declares nothing to call.
  const headers = readdirSync(ROOT + HEADERS)
    .filter((name) => name !== 'abi.h')
    .sort()
  const parts = headers.map((header) => {
    const [, declared] =
      /\nnamespace [^{]*\{\n([\s\S]*?)\n\}\s*\/\/ namespace/.exec(
        readFileSync(`${ROOT}${HEADERS}/${header}`, 'utf8'),
      ) ?? []
    if (declared === undefined) return ''
    return `<h2 id="${slugOf(header)}">${header}</h2>\n${codeBlock(withoutPrivate(declared).trim())}`
  })
  const about = `Every public name of the C++ library, in the namespace <code>circle_voronoi</code>, with its contract. Include the headers as
<code>#include &lt;circle_voronoi/compute.h&gt;</code>.`
  return { ...page('headers.html', title, `<h1>${title}</h1>\n<p>${about}</p>\n${parts.join('\n')}`), isBroad: true }
}

/** Removes private members, which nobody can use. */
function withoutPrivate(source) {
  return source.replace(/\n+ private:\n[\s\S]*?\n\};/g, '\n};')
}

function page(file, title, html) {
  return { folder: 'docs', file, title, html }
}
