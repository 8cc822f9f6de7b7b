// SPDX-License-Identifier: GPL-3.0-or-later
// What documents the library: the repository's own texts, its manual page, its examples and its C++ headers.
import { execFileSync } from 'node:child_process'
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, posix } from 'node:path'
import { ROOT } from '../run.mjs'
import { buildGallery } from './gallery.mjs'
import { renderMarkdown, slugOf } from './markdown.mjs'
import { codeBlock } from './page.mjs'

/** Of the repository, and where they stand in the site. */
export const TEXTS = {
  'README.md': 'index.html',
  'docs/element.md': 'element.html',
  'docs/results.md': 'results.html',
  'ARCHITECTURE.md': 'architecture.html',
  'public/data/README.md': 'data.html',
  'CONTRIBUTING.md': 'contributing.html',
  'CHANGELOG.md': 'changelog.html',
}
const PICTURE = /\.(jpg|svg)$/
const HEADERS = 'cpp/include/circle_voronoi'

/**
 * Copies the pictures that these show, and examples that are pages.
 *
 * @param {string} site the folder of the built site
 * @returns {Promise<import('./page.mjs').Text[]>}
 */
export async function documentationTexts(site) {
  const texts = Object.entries(TEXTS).map(([path, file]) => {
    const link = (address) => siteAddress(site, path, address)
    const { title, html } = renderMarkdown(readFileSync(ROOT + path, 'utf8'), { link })
    return { folder: 'docs', file, title, html }
  })
  const [readme, element, ...others] = texts
  return [readme, commandLine(), element, cppReference(), await examples(site), ...others]
}

/** Where a link of a text of the repository leads in the site. */
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
  const manual = execFileSync('mandoc', ['-T', 'html', '-O', 'fragment', `${ROOT}cpp/cli/circle-voronoi.1`], {
    encoding: 'utf8',
  })
    // What frames a page of paper, and links of names to themselves.
    .replace(
      /<table class="(head|foot)">[\s\S]*?<\/table>|<section class="Sh">\s*<h1[^>]*id="NAME"[\s\S]*?<\/section>/g,
      '',
    )
    .replace(/<a class="permalink"[^>]*>([\s\S]*?)<\/a>/g, '$1')
    // Below the title of this page, whose policy allows no styles in attributes.
    .replace(/<(\/?)h([12])\b/g, (_, end, level) => `<${end}h${Number(level) + 1}`)
    .replace(/ style="[^"]*"/g, '')
  const title = 'The command line'
  const html = `<h1>${title}</h1>\n<p>The manual page of <code>circle-voronoi</code>.</p>\n${manual}`
  return page('command-line.html', title, html)
}

async function examples(site) {
  return page('examples.html', 'Examples', await buildGallery(site))
}

function cppReference() {
  const title = 'The C++ headers'
  const headers = readdirSync(ROOT + HEADERS).sort()
  const parts = headers.map((header) => {
    const [, declared] =
      /\nnamespace [^{]*\{\n([\s\S]*?)\n\}\s*\/\/ namespace/.exec(
        readFileSync(`${ROOT}${HEADERS}/${header}`, 'utf8'),
      ) ?? []
    if (declared === undefined) return ''
    return `<h2 id="${slugOf(header)}">${header}</h2>\n${codeBlock(withoutPrivate(declared).trim())}`
  })
  const about = `What the public headers declare, in the namespace <code>circle_voronoi</code>: each name with what it promises.
<code>#include &lt;circle_voronoi/compute.h&gt;</code> and so on.`
  return page('cpp.html', title, `<h1>${title}</h1>\n<p>${about}</p>\n${parts.join('\n')}`)
}

/** Nobody can use what is private. */
function withoutPrivate(source) {
  return source.replace(/\n+ private:\n[\s\S]*?\n\};/g, '\n};')
}

function page(file, title, html) {
  return { folder: 'docs', file, title, html }
}
