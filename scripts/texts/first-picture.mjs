// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the first scene into the page with the page's own code.
import { readFileSync, writeFileSync } from 'node:fs'
import { pathToFileURL } from 'node:url'
import { build } from 'esbuild'
import { loadCircleVoronoi } from '../../dist/lib/index.js'
import { ROOT } from '../run.mjs'

const BUNDLE = `${ROOT}build/first-picture.mjs`
const PLACE = '<!-- first picture -->'

/** @param {string} folder the folder of the site */
export async function addFirstPicture(folder) {
  await build({
    entryPoints: [`${ROOT}web/app/first-picture.ts`],
    outfile: BUNDLE,
    bundle: true,
    format: 'esm',
    platform: 'node',
    logLevel: 'warning',
  })
  const { firstPicture } = await import(pathToFileURL(BUNDLE).href)
  const rows = readFileSync(`${ROOT}public/data/start.csv`, 'utf8').trim().split('\n').slice(1)
  // Uses an editor as the view does, because colors depend on the order of edges.
  const editor = (await loadCircleVoronoi()).edit(rows.map((row) => row.split(',').map(Number)))
  const file = `${folder}/index.html`
  const page = readFileSync(file, 'utf8')
  if (!page.includes(PLACE)) throw new Error(`${file} has no place for the first picture.`)
  writeFileSync(
    file,
    page.replace(PLACE, () => firstPicture(editor.snapshot())),
  )
}
