// SPDX-License-Identifier: GPL-3.0-or-later
// The single-file build of <circle-voronoi>, alone in a folder, and their requirements on the page's policy.
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { expect, type Page, test } from '@playwright/test'
import { build as bundle } from 'esbuild'
import { soon } from '../soon.ts'
import { ROOT } from './project.mjs'
import { serve } from './static-server.ts'

type Element = HTMLElementTagNameMap['circle-voronoi']

const FIGURE = `<circle-voronoi circles="[[2,2,0.5],[6,3,1],[4,6,0.7]]" region="POLYGON ((0 0, 9 0, 9 8, 0 8))" areas="equal"
  controls="player" lang="de"></circle-voronoi>`

let folder: string
test.beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-one-file-'))
})
test.afterEach(() => rmSync(folder, { recursive: true, force: true }))

function write(name: string, text: string): void {
  writeFileSync(join(folder, name), text)
}

function copy(name: string): void {
  copyFileSync(join(ROOT, 'dist/element', name), join(folder, name))
}

const pageOf = (script: string, head = '') =>
  `<!doctype html><html lang="en"><meta charset="utf-8">${head}<title>One file</title><link rel="icon" href="data:,">${FIGURE}${script}`

/** Uses areas, power diagrams, the player and German texts without any request to another address. */
async function expectAllOfIt(page: Page, address: string, own: RegExp): Promise<void> {
  const problems: string[] = []
  page.on('pageerror', ({ message }) => problems.push(message))
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && problems.push(message.text()))
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  await page.goto(address)
  const figure = page.locator('circle-voronoi')
  await figure.evaluate(async (element: Element) => {
    await element.ready
    await element.updateComplete
  })
  expect(await figure.evaluate((element: Element) => [element.areas, element.region !== undefined])).toEqual([
    'equal',
    true,
  ])
  await expect(figure.locator('.cv-player')).toContainText('Scheibe')
  await figure.evaluate((element: Element) => element.stepTo(10_000))
  await figure.evaluate((element: Element) => {
    element.areas = null
  })
  const drawn = (layers: string) =>
    figure.evaluate(async (element: Element, layers) => {
      element.layers = layers
      return (await element.toSVG()).length
    }, layers)
  const without = await drawn('')
  await soon(() => drawn('power')).toBeGreaterThan(without)
  expect(problems).toEqual([])
  expect(asked.filter((url) => !own.test(url))).toEqual([])
}

for (const [name, script] of [
  ['a script', '<script src="classic.js"></script>'],
  ['a module', '<script type="module" src="classic.js"></script>'],
] as const) {
  test(`classic.js, copied alone, has all that a figure may use, as ${name}`, async ({ page }) => {
    copy('classic.js')
    write('index.html', pageOf(script))
    const server = await serve(folder, "default-src 'self' blob: data: 'wasm-unsafe-eval'")
    try {
      await expectAllOfIt(page, `${server.address}index.html`, /\/(index\.html|classic\.js)$|^(blob|data):/)
    } finally {
      await server.close()
    }
  })
}

test('classic.js works in a page that is opened from a disk', async ({ page }) => {
  copy('classic.js')
  write('index.html', pageOf('<script src="classic.js"></script>'))
  await expectAllOfIt(
    page,
    pathToFileURL(join(folder, 'index.html')).href,
    /\/(index\.html|classic\.js)$|^(blob|data):/,
  )
  expect(
    await page.evaluate(() => Object.keys((globalThis as unknown as { circleVoronoi: object }).circleVoronoi)),
  ).toEqual(expect.arrayContaining(['CircleVoronoiElement', 'defineCircleVoronoi']))
})

test('inline.js survives a bundler that lowers classes and renames functions', async ({ page }) => {
  await bundle({
    stdin: { contents: `import 'circle-voronoi/element/inline'`, resolveDir: ROOT },
    bundle: true,
    minify: true,
    keepNames: true,
    target: 'es2020',
    outfile: join(folder, 'page.js'),
    logLevel: 'error',
  })
  write('index.html', pageOf('<script src="page.js"></script>'))
  const server = await serve(folder, "default-src 'self' blob: data: 'wasm-unsafe-eval'")
  try {
    await expectAllOfIt(page, `${server.address}index.html`, /\/(index\.html|page\.js)$|^(blob|data):/)
  } finally {
    await server.close()
  }
})

for (const [build, more] of [
  ['index', ''],
  ['classic', ' blob:'],
] as const) {
  test(`${build}.js under Trusted Types, by the policy circle-voronoi`, async ({ page }) => {
    mkdirSync(join(ROOT, 'build/one-file'), { recursive: true })
    const server = await serve(
      ROOT,
      `default-src 'self' data:${more} 'wasm-unsafe-eval'; require-trusted-types-for 'script'; trusted-types circle-voronoi lit-html`,
    )
    const path = `build/one-file/trusted-${build}.html`
    writeFileSync(join(ROOT, path), pageOf(`<script type="module" src="/dist/element/${build}.js"></script>`))
    try {
      await expectAllOfIt(page, server.address + path, /./)
    } finally {
      await server.close()
    }
  })
}
