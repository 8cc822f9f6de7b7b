// SPDX-License-Identifier: GPL-3.0-or-later
// The package as its users have it: packed, installed in a project of its own, and used in pages in each of the ways it promises.
// In Node: package.test.mjs.
import { readFileSync } from 'node:fs'
import { expect, type Page, test } from '@playwright/test'
import { type BuildOptions, build as bundle } from 'esbuild'
import { build, createServer } from 'vite'
import webpack from 'webpack'
import { Project } from './project.mjs'
import { serve } from './static-server.ts'

/** The result of consumer/main.js: three circles of radius 1 at the corners of a triangle with sides 6, 8 and 10. */
const EXPECTED = JSON.stringify(JSON.parse(readFileSync(new URL('expected.json', import.meta.url), 'utf8')))

let project: Project
test.beforeAll(() => {
  project = new Project()
})
test.afterAll(() => project.remove())

test.describe('in a page', () => {
  test('from a Vite build', async ({ page }) => {
    const outDir = project.path('vite-build')
    await build({ root: project.folder, configFile: false, logLevel: 'error', build: { outDir, target: 'es2022' } })
    await expectToWork(page, outDir)
  })

  test('from the server of Vite', async ({ page }) => {
    const server = await createServer({
      root: project.folder,
      configFile: false,
      logLevel: 'error',
      server: { host: '127.0.0.1', port: 0 },
    })
    await server.listen()
    try {
      await expectToPrint(page, server.resolvedUrls?.local[0] as string)
    } finally {
      await server.close()
    }
  })

  test('from a webpack build', { tag: '@long' }, async ({ page }) => {
    const outDir = project.path('webpack-build')
    await buildWithWebpack(outDir)
    project.write('webpack-build/index.html', '<output></output><script src="main.js" defer></script>')
    await expectToWork(page, outDir)
  })

  test('from an esbuild build, as the README says', async ({ page }) => {
    const outdir = project.path('esbuild-build')
    await bundle({
      absWorkingDir: project.folder,
      entryPoints: ['esbuild.js', 'circle-voronoi/worker-thread'],
      entryNames: '[name]',
      bundle: true,
      format: 'esm',
      loader: { '.wasm': 'file' },
      outdir,
      logLevel: 'error',
    })
    project.write('esbuild-build/index.html', '<output></output><script src="esbuild.js" type="module"></script>')
    await expectToWork(page, outdir)
  })

  test('from a script without a bundler', async ({ page }) => {
    writePlainPage()
    await expectToWork(page, project.folder, 'plain.html')
  })

  test('from another origin, the worker too', async ({ page }) => {
    writePlainPage()
    const elsewhere = await serve(project.folder)
    const origin = new URL(elsewhere.address).origin
    const policy = `default-src 'self' ${origin}; script-src 'self' ${origin} blob: 'wasm-unsafe-eval'; worker-src ${origin} blob:`
    const here = await serve(project.folder, policy)
    try {
      const script = readFileSync(project.path('plain-main.js'), 'utf8').replaceAll(
        "'./node_modules",
        `'${elsewhere.address}node_modules`,
      )
      project.write('elsewhere-main.js', script)
      project.write(
        'elsewhere.js',
        readFileSync(project.path('page.js'), 'utf8').replace('./main.js', './elsewhere-main.js'),
      )
      project.write('elsewhere.html', '<output></output><script type="module" src="elsewhere.js"></script>')
      await expectToPrint(page, `${here.address}elsewhere.html`)
    } finally {
      await elsewhere.close()
      await here.close()
    }
  })

  test('from the bundle in another origin, of which nothing else is asked', async ({ page }) => {
    const elsewhere = await serve(project.folder)
    const { origin } = new URL(elsewhere.address)
    const here = await serve(
      project.folder,
      `default-src 'self'; script-src 'self' ${origin} blob: 'wasm-unsafe-eval'; worker-src ${origin} blob:`,
    )
    const asked = new Set<string>()
    page.on('request', (request) => request.url().startsWith(origin) && asked.add(request.url()))
    const address = `${elsewhere.address}node_modules/circle-voronoi/dist/lib/bundle.js`
    project.write(
      'bundle-page.js',
      `import * as library from '${address}'
      import { useBundle } from './bundle.js'
      import { show } from './show.js'
      show(useBundle(library))`,
    )
    project.write('bundle.html', '<output></output><script type="module" src="bundle-page.js"></script>')
    try {
      await expectToPrint(page, `${here.address}bundle.html`, '3,4,4 3,4,4')
      expect([...asked]).toEqual([address])
    } finally {
      await elsewhere.close()
      await here.close()
    }
  })

  for (const place of ['the page itself', 'a frame that has no origin']) {
    test(`from the bundle inside ${place}`, async ({ page }) => {
      const text = readFileSync(project.path('node_modules/circle-voronoi/dist/lib/bundle.js'), 'utf8')
      const use = readFileSync(project.path('bundle.js'), 'utf8').replaceAll('export ', '')
      const show = readFileSync(project.path('show.js'), 'utf8').replaceAll('export ', '')
      project.write(
        'pasted.html',
        `<output></output><script type="module">${text}${use}${show}show(useBundle({ createWorker, loadCircleVoronoi }))</script>`,
      )
      project.write('framing.html', '<iframe sandbox="allow-scripts" src="pasted.html"></iframe>')
      const server = await serve(
        project.folder,
        "default-src 'none'; frame-src 'self'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:",
      )
      try {
        if (place === 'the page itself') {
          await expectToPrint(page, `${server.address}pasted.html`, '3,4,4 3,4,4')
        } else {
          await page.goto(`${server.address}framing.html`)
          await expect(page.frameLocator('iframe').locator('output')).toHaveText('3,4,4 3,4,4')
        }
      } finally {
        await server.close()
      }
    })
  }

  test('in a frame that has no origin, the worker too', async ({ page }) => {
    writePlainPage()
    project.write('framing.html', '<iframe sandbox="allow-scripts" src="plain.html"></iframe>')
    const server = await serve(
      project.folder,
      "default-src 'self'; script-src * data: 'wasm-unsafe-eval'; connect-src *; worker-src * data:",
    )
    try {
      await page.goto(`${server.address}framing.html`)
      await expect(page.frameLocator('iframe').locator('output')).toHaveText(EXPECTED)
    } finally {
      await server.close()
    }
  })

  test('as a blob: module, given the bytes, or the bundle', async ({ page }) => {
    const lib = './node_modules/circle-voronoi/dist/lib'
    const options: BuildOptions = { entryPoints: ['circle-voronoi'], bundle: true, format: 'esm', outfile: 'whole.js' }
    await bundle({ ...options, absWorkingDir: project.folder, logLevel: 'error' })
    project.write(
      'blob.js',
      `import { useBundle } from './bundle.js'
      import { show } from './show.js'
      const blobOf = async (url) => import(URL.createObjectURL(new Blob([await (await fetch(url)).text()], { type: 'text/javascript' })))
      const circles = [[0, 0, 1], [6, 0, 1], [0, 8, 1]]
      const use = async () => {
        const { loadCircleVoronoi } = await blobOf('whole.js')
        const library = await loadCircleVoronoi({ wasm: fetch('${lib}/generated/circle-voronoi.wasm') })
        return library.compute(circles).vertices.join() + ' ' + (await useBundle(await blobOf('${lib}/bundle.js')))
      }
      show(use())`,
    )
    project.write('blob.html', '<output></output><script type="module" src="blob.js"></script>')
    const server = await serve(
      project.folder,
      "default-src 'self'; script-src 'self' blob: 'wasm-unsafe-eval'; worker-src blob:",
    )
    try {
      await expectToPrint(page, `${server.address}blob.html`, '3,4,4 3,4,4 3,4,4')
    } finally {
      await server.close()
    }
  })

  test('that cannot fetch a file, with an error that says so', async ({ page }) => {
    const server = await serve(project.folder)
    const output = page.locator('output')
    const openWithout = async (file: string) => {
      await page.route(`**/${file}`, (route) => route.fulfill({ status: 404 }))
      await page.goto(`${server.address}plain.html`)
      await expect(output).not.toBeEmpty()
      await page.unrouteAll()
    }
    try {
      writePlainPage()
      await openWithout('circle-voronoi.wasm')
      expect(await output.textContent()).toMatch(/^The WebAssembly cannot be loaded from http:.*\.wasm: .*404.*\.$/)
      await openWithout('worker-thread.js')
      expect(await output.textContent()).toBe('The worker failed: its file cannot be loaded.')
    } finally {
      await server.close()
    }
  })
})

/** Expects that a page on a file server prints the expected result. */
async function expectToWork(page: Page, folder: string, name = ''): Promise<void> {
  const server = await serve(folder)
  try {
    await expectToPrint(page, server.address + name)
  } finally {
    await server.close()
  }
}

async function expectToPrint(page: Page, address: string, expected = EXPECTED): Promise<void> {
  const complaints: string[] = []
  page.on('pageerror', (error) => complaints.push(error.message))
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(`${message.text()} (${message.location().url})`)
  })
  await page.goto(address)
  const output = page.locator('output')
  await expect(output).not.toBeEmpty({ timeout: 30_000 })
  expect({ text: await output.textContent(), complaints }).toEqual({ text: expected, complaints: [] })
}

/** Writes plain.html, a page without a bundler that imports modules by their addresses. */
function writePlainPage(): void {
  const plain = readFileSync(project.path('main.js'), 'utf8').replace(
    /'circle-voronoi(?:\/(\w+))?'/g,
    (_, entry = 'index') => `'./node_modules/circle-voronoi/dist/lib/${entry}.js'`,
  )
  project.write('plain-main.js', plain)
  project.write('plain.js', readFileSync(project.path('page.js'), 'utf8').replace('./main.js', './plain-main.js'))
  project.write('plain.html', '<output></output><script type="module" src="plain.js"></script>')
}

async function buildWithWebpack(path: string): Promise<void> {
  const compiler = webpack({
    mode: 'production',
    context: project.folder,
    entry: './page.js',
    output: { path },
    // Disables the warning about files over 244 KiB before compression.
    performance: { hints: false },
  })
  const stats = await new Promise<webpack.Stats | undefined>((resolve, reject) =>
    compiler.run((error, result) => (error ? reject(error) : resolve(result))),
  )
  expect(stats?.toJson({ all: false, errors: true, warnings: true })).toMatchObject({ errors: [], warnings: [] })
  await new Promise((resolve) => compiler.close(resolve))
}
