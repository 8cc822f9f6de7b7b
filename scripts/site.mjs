// SPDX-License-Identifier: GPL-3.0-or-later
// dist/site: the page, the tutorial and the documentation, static, for any folder of a server. A service worker knows all files.
// Each file has a compressed copy for servers that do not compress.
import { createHash } from 'node:crypto'
import { copyFileSync, cpSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join, relative } from 'node:path'
import { promisify } from 'node:util'
import { brotliCompress, gzip } from 'node:zlib'
import { build } from 'esbuild'
import { isMain, ROOT } from './run.mjs'
import { addFirstPicture } from './texts/first-picture.mjs'
import { buildTexts } from './texts/texts.mjs'

const SERVICE_WORKER = 'service-worker.js'
/**
 * Files that are not available offline: files for other pages, among them examples, and the large pictures and
 * reference of the documentation.
 */
const NOT_KEPT = /^(element\.(css|js)|(api|element|examples|lib)\/.*|docs\/.*\.(jpg|png|svg|txt))$/
/** Compressing other files would gain nothing. */
const COMPRESSED = /\.(css|csv|html|js|json|md|svg|txt|wasm|webmanifest)$/
/** Smaller files fit into one packet uncompressed. */
const SMALLEST = 1000

async function buildSite(folder) {
  cpSync(`${ROOT}build/page`, folder, { recursive: true })
  // Pages with an element that the playground writes use this file.
  copyFileSync(`${ROOT}dist/element/classic.js`, `${folder}/element.js`)
  await addFirstPicture(folder)
  await buildTexts(folder)
  const compressed = filesOf(folder).filter((name) => isCompressed(`${folder}/${name}`))
  await Promise.all(compressed.map((name) => compress(`${folder}/${name}`)))
  await writeServiceWorker(folder)
}

/** Lists the files that have been built so far. */
function filesOf(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)))
    .filter((name) => name !== SERVICE_WORKER && !/\.(br|gz)$/.test(name))
    .sort()
}

/** Writes the service worker, which makes a site work offline. */
export async function writeServiceWorker(folder) {
  const own = filesOf(folder).filter((name) => !NOT_KEPT.test(name))
  const list = own.map((name) => {
    const hash = createHash('sha256')
      .update(readFileSync(`${folder}/${name}`))
      .digest('base64')
    // The address of a page is its folder, because some servers redirect index.html there.
    return [name.replace(/(^|\/)index\.html$/, '$1') || './', `sha256-${hash}`]
  })
  const version = createHash('sha256').update(JSON.stringify(list)).digest('hex').slice(0, 16)
  await build({
    absWorkingDir: ROOT,
    entryPoints: ['web/app/service-worker.ts'],
    outfile: `${folder}/${SERVICE_WORKER}`,
    bundle: true,
    minify: true,
    target: 'es2022',
    define: { FILES: JSON.stringify(list), VERSION: JSON.stringify(version) },
    logLevel: 'warning',
  })
}

function isCompressed(path) {
  return COMPRESSED.test(path) && readFileSync(path).length >= SMALLEST
}

async function compress(path) {
  const bytes = readFileSync(path)
  writeFileSync(`${path}.br`, await promisify(brotliCompress)(bytes))
  writeFileSync(`${path}.gz`, await promisify(gzip)(bytes, { level: 9 }))
}

if (isMain(import.meta.url)) await buildSite(`${ROOT}dist/site`)
