// SPDX-License-Identifier: GPL-3.0-or-later
// The reference of the package: what TypeDoc has written (build/api), as pages of this site. Of its own pages the text is
// taken, without their scripts, which would need styles that the site's policy forbids.
import { readdirSync, readFileSync } from 'node:fs'
import { posix } from 'node:path'
import { ROOT } from '../run.mjs'
import { escaped } from './page.mjs'

const FOLDER = `${ROOT}build/api`
const CONTENT = /<div class="col-content">([\s\S]*?)<\/div>\s*<div class="col-sidebar">/
/** What scripts and pages of TypeDoc are for: icons, links to where one is, buttons, links to its tree of types. */
const TRIMMINGS =
  /<svg[\s\S]*?<\/svg>|<a [^>]*class="tsd-anchor-icon"[^>]*>[\s\S]*?<\/a>|<button[\s\S]*?<\/button>|\(<a href="[^"]*hierarchy\.html[^"]*">[^<]*<\/a>\)/g

/** @returns {import('./page.mjs').Text[]} first the modules, in their order */
export function referenceTexts() {
  const files = readdirSync(FOLDER, { recursive: true })
    .filter((file) => /^\w+\/[^/]+\.html$/.test(file))
    .sort()
  const isModule = (file) => file.startsWith('modules/')
  const pages = [...files.filter(isModule), ...files.filter((file) => !isModule(file))].map((file) => {
    const page = readFileSync(`${FOLDER}/${file}`, 'utf8')
    const [, content] = CONTENT.exec(page) ?? []
    const [, title] = /<h1>(?:<\w+>)*(?:Module )?(.*?)<\/h1>/.exec(content ?? '') ?? []
    if (title === undefined) throw new Error(`TypeDoc wrote ${file} otherwise than is known here.`)
    const html = relinked(
      headingsInOrder(withoutColours(content).replace(TRIMMINGS, '').replaceAll('<pre>', '<pre tabindex="0">')),
      file,
    )
    return {
      folder: 'api',
      file: flat(file),
      title: wordsOf(title),
      html,
      text: wordsOf(html),
      isListed: isModule(file),
    }
  })
  return [contents(pages.filter(({ isListed }) => isListed)), ...pages]
}

function contents(modules) {
  const title = 'All modules'
  const items = modules.map(({ file, title, html }) => {
    const [, about = ''] = /<p>([\s\S]*?)<\/p>/.exec(html) ?? []
    return `<dt><a href="${file}">${escaped(title)}</a></dt><dd>${about}</dd>`
  })
  const html = `<h1>Reference</h1>
<p>Every name that the package for JavaScript exports, by its modules, and in these by what it is for. The examples are run by tests.</p>
<dl>
${items.join('\n')}
</dl>`
  return { folder: 'api', file: 'index.html', title, html, text: '', isListed: true }
}

/** TypeDoc has a folder for each kind of names. */
function flat(file) {
  return file.replace('/', '-')
}

function relinked(html, file) {
  return html.replace(/ href="([^"#:]*)(#[^"]*)?"/g, (_, path, place = '') => {
    const target = path === '' ? '' : flat(posix.join(posix.dirname(file), path))
    return ` href="${target}${place}"`
  })
}

function withoutColours(html) {
  return html.replace(/<code class="\w+">[\s\S]*?<\/code>/g, (code) => code.replace(/<\/?span[^>]*>/g, ''))
}

/** On pages of functions those of the fourth level follow the first. */
function headingsInOrder(html) {
  if (/<h2/.test(html)) return html
  return html.replace(/<(\/?)h([45])/g, (_, end, level) => `<${end}h${level - 2}`)
}

function wordsOf(html) {
  return html
    .replace(/<[^>]*>/g, ' ')
    .replace(/&\w+;/g, ' ')
    .replace(/\s+/g, ' ')
    .trim()
}
