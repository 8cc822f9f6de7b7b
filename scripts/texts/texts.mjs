// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to be read in the site, with one search for all of it.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import MiniSearch from 'minisearch'
import { documentationTexts } from './documentation.mjs'
import { writeMathFont } from './math-font.mjs'
import { pageOf } from './page.mjs'
import { referenceTexts } from './reference.mjs'
import { sectionsOf } from './sections.mjs'
import { tutorialTexts } from './tutorial.mjs'

/** What is searched, section by section; web/reading/search.ts says the same. */
const SEARCHED = { fields: ['title', 'heading', 'text'], storeFields: ['title', 'heading', 'address', 'shown'] }
/** So many characters of a section of the reference are shown at most; of other pages all may be. */
const SHOWN_OF_REFERENCE = 160

/** Fills the built templates of a site, which are gone then. */
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

/** The sections of a page, as the search knows them. */
function entriesOf({ folder, file, title, html }) {
  return sectionsOf(html).map(({ id: place, heading, text }) => {
    const address = `${folder}/${file}${place === '' ? '' : `#${place}`}`
    const shown = folder === 'api' ? text.slice(0, SHOWN_OF_REFERENCE) : text
    return { address, title, heading, text, shown }
  })
}
