// SPDX-License-Identifier: GPL-3.0-or-later
// The reference of the package: the Markdown that TypeDoc has written (build/api), as pages of this site.
import { readdirSync, readFileSync } from 'node:fs'
import { posix } from 'node:path'
import { ROOT } from '../run.mjs'
import { renderMarkdown } from './markdown.mjs'

const FOLDER = `${ROOT}build/api`

/** @returns {import('./page.mjs').Text[]} the list of all modules, then the modules in their order */
export function referenceTexts() {
  const files = readdirSync(FOLDER, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.md'))
    .sort((a, b) => rankOf(a) - rankOf(b) || (a < b ? -1 : 1))
  return files.map((file) => {
    const link = (address) => siteAddress(file, address)
    return {
      folder: /** @type {const} */ ('api'),
      file: nameOf(file),
      ...renderMarkdown(readFileSync(`${FOLDER}/${file}`, 'utf8'), { link }),
      isListed: rankOf(file) < 2,
    }
  })
}

function rankOf(file) {
  return file === 'README.md' ? 0 : file.startsWith('modules/') ? 1 : 2
}

/** TypeDoc has a folder for each kind of names. */
function nameOf(file) {
  return file === 'README.md' ? 'index.html' : file.replace('/', '-').replace(/\.md$/, '.html')
}

function siteAddress(from, address) {
  if (/^(\w+:|#)/.test(address)) return address
  const [path, fragment] = address.split('#')
  return `${nameOf(posix.normalize(posix.join(posix.dirname(from), path)))}${fragment === undefined ? '' : `#${fragment}`}`
}
