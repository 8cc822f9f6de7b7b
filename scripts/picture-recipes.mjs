// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of the cookbook's pages, docs/cookbook, and of the three circles of the first page.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import sirv from 'sirv'
import { addModules, pageOf, pageOfComponent, recipes, withOwnElement } from '../tests/readme/recipes.mjs'
import { recipeDrawings } from './recipe-drawings.mjs'
import { isMain, main, ROOT } from './run.mjs'
import { chromiumPath } from './setup.mjs'
import { loadDrawn } from './texts/drawn.mjs'
import { posterMaker } from './texts/poster.mjs'

/** The size that recipes draw. */
const SIZE = { width: 480, height: 300 }

/** The time of the captured frame in milliseconds, so that animations look the same in each run. */
const PICTURED_AT = 2000

/** @param {import('@playwright/test').Browser} browser */
export async function pictureRecipes(browser) {
  await pictureThreeCircles()
  const folder = mkdtempSync(join(tmpdir(), 'cookbook-'))
  addModules(folder)
  const server = createServer(sirv(folder, { dev: true }))
  await new Promise((resolve) => server.listen(0, 'localhost', () => resolve(undefined)))
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address())
  const address = `http://localhost:${port}/`
  /** Takes the picture of a page that is written into the folder. */
  const take = async (html, picture) => {
    writeFileSync(join(folder, 'index.html'), html)
    const page = await browser.newPage({ viewport: SIZE, deviceScaleFactor: 2 })
    await page.addInitScript(`const { requestAnimationFrame: request } = globalThis
      globalThis.requestAnimationFrame = (draw) => request.call(globalThis, () => draw(${PICTURED_AT}))`)
    await page.goto(address, { waitUntil: 'networkidle' })
    await page.screenshot({ path: ROOT + picture })
    await page.close()
  }
  const takeDrawing = (svg, picture) =>
    take(pageOf(`<style>svg { display: block; width: 100vw; height: 100vh }</style>${svg}`), picture)
  const drawings = await recipeDrawings()
  for (const { language, title, code, picture } of recipes()) {
    if (language === 'html') await take(pageOf(code), picture)
    else if (language === 'jsx') await take(await pageOfComponent(code), picture)
    else if (language === 'py') {
      const [, html = ''] = /"""([\s\S]*)"""/.exec(code) ?? []
      await take(pageOf(withOwnElement(html)), picture)
    } else {
      const { names, draw } = drawings[title]
      await takeDrawing(draw(await valuesOf(folder, code, names)), picture)
    }
  }
  await takeDrawing(drawings['Compute in tiles'].draw({}), 'docs/cookbook/compute-in-tiles.png')
  server.close()
  rmSync(folder, { recursive: true })
}

/** Runs a script in the folder of its modules, and returns variables by name. */
async function valuesOf(folder, code, names) {
  const file = join(folder, `${names.join('-')}-${Date.now()}.mjs`)
  const inFolder = code.replaceAll("writeFileSync('", `writeFileSync('${folder}/`)
  writeFileSync(file, `const console = { log() {} }\n${inFolder}\nexport { ${names.join(', ')} }\n`)
  return import(pathToFileURL(file).href)
}

async function pictureThreeCircles() {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const { loadFiles } = await import(`${ROOT}dist/lib/files.js`)
  const [library, files] = [await loadCircleVoronoi(), await loadFiles()]
  const diagram = library.compute([
    [0, 0, 1],
    [6, 0, 1],
    [0, 8, 1],
  ])
  const svg = files.writeDiagram(diagram, { format: 'svg', bounds: [-8, -3, 14, 11], digits: 3, tolerance: 0.001 })
  const posterOf = posterMaker(library, await loadDrawn(library))
  writeFileSync(`${ROOT}docs/three-circles.svg`, posterOf(svg, diagram, {}))
}

if (isMain(import.meta.url)) {
  const { chromium } = await import('@playwright/test')
  await main(async () => {
    const browser = await chromium.launch({ executablePath: chromiumPath(), args: ['--headless', '--no-sandbox'] })
    await pictureRecipes(browser).finally(() => browser.close())
  })
}
