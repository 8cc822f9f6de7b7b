// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run bench:js [-- --sizes N,...]`: the package against d3-delaunay on the centers of the same circles, in Node and in
// Chromium, task by task: two tables, and build/bench/js.json. With `-- --twins` instead: what functions take that stand in
// C++ as well, in Node, and what a call into WebAssembly would.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { benchJs, benchTwins } from './bench-js-tasks.mjs'
import { build, main, ROOT } from './run.mjs'
import { chromiumPath, setup } from './setup.mjs'

const SIZES = [1_000, 10_000, 100_000, 1_000_000]
const TWINS_SIZE = 10_000

await main(async () => {
  await setup('tests')
  await build('build:lib')
  const given = process.argv.indexOf('--sizes')
  const sizes = given < 0 ? SIZES : process.argv[given + 1].split(',').map(Number)
  mkdirSync(`${ROOT}build/bench`, { recursive: true })
  const geometry = await import(`${ROOT}dist/lib/index.js`)
  const library = await geometry.loadCircleVoronoi()
  if (process.argv.includes('--twins')) {
    console.table(benchTwins(library, geometry, TWINS_SIZE))
    return
  }
  const rows = { Node: benchJs(library, sizes), Chromium: await inChromium(sizes) }
  for (const [where, table] of Object.entries(rows)) {
    console.log(where)
    console.table(table)
  }
  writeFileSync(`${ROOT}build/bench/js.json`, `${JSON.stringify(rows, undefined, 1)}\n`)
})

/** Measures in a page with a single file that contains everything. */
async function inChromium(sizes) {
  const esbuild = await import('esbuild')
  const { chromium } = await import('@playwright/test')
  const outfile = `${ROOT}build/bench/js.mjs`
  await esbuild.build({
    stdin: {
      contents: `
        import { loadCircleVoronoi } from './dist/lib/bundle.js'
        import { benchJs } from './scripts/bench-js-tasks.mjs'
        globalThis.bench = async (sizes) => benchJs(await loadCircleVoronoi(), sizes)`,
      resolveDir: ROOT,
    },
    bundle: true,
    format: 'esm',
    outfile,
  })
  const browser = await chromium.launch({ executablePath: chromiumPath(), args: ['--headless', '--no-sandbox'] })
  try {
    const page = await browser.newPage()
    page.setDefaultTimeout(0)
    await page.addScriptTag({ type: 'module', content: readFileSync(outfile, 'utf8') })
    return await page.evaluate(async (list) => globalThis.bench(list), sizes)
  } finally {
    await browser.close()
  }
}
