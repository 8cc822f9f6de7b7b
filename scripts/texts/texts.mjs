// SPDX-License-Identifier: GPL-3.0-or-later
// Builds all texts of the site and one search index over them.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import MiniSearch from 'minisearch'
import { documentationTexts } from './documentation.mjs'
import { writeMathFont } from './math-font.mjs'
import { pageOf } from './page.mjs'
import { referenceTexts } from './reference.mjs'
import { sectionsOf } from './sections.mjs'
import { tutorialTexts } from './tutorial.mjs'

/** Options of the search index, the same as in web/reading/search.ts. */
const SEARCHED = { fields: ['title', 'heading', 'text'], storeFields: ['title', 'heading', 'address', 'shown'] }
/** Length of the excerpts from the reference, in characters. Other pages are stored in full. */
const SHOWN_OF_REFERENCE = 160

/** Fills the built templates of a site and removes them. */
export async function buildTexts(site) {
  const texts = [...(await tutorialTexts(site)), ...(await documentationTexts(site)), ...referenceTexts()]
  const templates = { tutorial: 'tutorial/page.html', docs: 'docs/page.html', api: 'docs/page.html' }
  for (const [folder, name] of Object.entries(templates)) {
    const template = readFileSync(`${site}/${name}`, 'utf8')
    const all = texts.filter((text) => text.folder === folder)
    mkdirSync(`${site}/${folder}`, { recursive: true })
    for (const text of all) writeFileSync(`${site}/${folder}/${text.file}`, pageOf(template, text, all))
  }
  for (const name of new Set(Object.values(templates))) rmSync(`${site}/${name}`)
  const search = new MiniSearch(SEARCHED)
  await writeMathFont(`${site}/tutorial`, texts.map(({ html }) => html).join(''))
  const entries = texts.filter(({ isFound = true }) => isFound).flatMap(entriesOf)
  search.addAll(entries.map((entry, id) => ({ id, ...entry })))
  writeFileSync(`${site}/search.json`, JSON.stringify(search))
}

/** The index entries of a page. */
function entriesOf({ folder, file, title, html }) {
  return sectionsOf(html).map(({ id: place, heading, text }) => {
    const address = `${folder}/${file}${place === '' ? '' : `#${place}`}`
    const shown = folder === 'api' ? text.slice(0, SHOWN_OF_REFERENCE) : text
    return { address, title, heading, text, shown }
  })
}
