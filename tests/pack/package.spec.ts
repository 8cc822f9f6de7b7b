// SPDX-License-Identifier: GPL-3.0-or-later
// The package as its users have it: packed, installed in a project of its own, and used in each of the ways it promises.
import { readdirSync, readFileSync, statSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { type BuildOptions, build as bundle } from 'esbuild'
import { build, createServer } from 'vite'
import webpack from 'webpack'
import { BIN, Project, ROOT, run } from './project.ts'
import { serve } from './static-server.ts'

/** What consumer/main.js finds: three circles of radius 1 at the corners of a triangle with sides 6, 8 and 10. */
const EXPECTED = JSON.stringify({
  vertex: [3, 4, 4],
  certified: true,
  found: [1, 2],
  path: true,
  power: [3, 4],
  stages: true,
  canceled: 'changed my mind',
  areas: ['4.000000', '12.000000'],
  code: 'negativeRadius',
})

/** The oldest TypeScript that the declarations are for, which scripts/setup.mjs installs apart from the others. */
const OLDEST_TSC = join(ROOT, 'tests/pack/typescript-5.0/node_modules/.bin/tsc')

/** The modules of the element. */
const ELEMENT = ['/element', '/element/define']

let project: Project
test.beforeAll(() => {
  project = new Project()
})
test.afterAll(() => project.remove())

test('holds the built library and nothing else', () => {
  const packed = project.path('node_modules/circle-voronoi')
  const files = readdirSync(packed, { recursive: true, encoding: 'utf8' }).filter((name) =>
    statSync(join(packed, name)).isFile(),
  )
  const built = readdirSync(join(ROOT, 'web/lib'), { recursive: true, encoding: 'utf8' })
    .filter((name) => /(?<!\.d)\.ts$/.test(name) && !name.startsWith('bundled/'))
    .flatMap((name) => ['.js', '.js.map', '.d.ts'].map((ending) => `dist/lib/${name.replace(/\.ts$/, ending)}`))
    .filter((name) => name !== 'dist/lib/bundle.js.map')
  const generated = readdirSync(join(ROOT, 'web/lib/generated')).map((name) => `dist/lib/generated/${name}`)
  const program = readdirSync(join(ROOT, 'web/cli'))
    .filter((name) => name.endsWith('.ts'))
    .map((name) => `dist/cli/${name.replace(/\.ts$/, '.js')}`)
  const compiled = ['dist/cli/generated/program.cjs', 'dist/cli/generated/program.wasm']
  const others = ['LICENSE', 'README.md', 'package.json']
  // The names of what two modules of the element have in common are those of its contents.
  const shared = /^dist\/element\/(chunk|circle-voronoi-(comparison|regions)|german|player)-[A-Z0-9]+\.js$/
  expect(files.filter((name) => shared.test(name))).not.toHaveLength(0)
  const element = [
    ...['index', 'define', 'painter', 'bundle'].map((name) => `${name}.js`),
    ...['index', 'define', 'bundle', 'exports', 'circle-voronoi-element', 'check-types', 'frameworks'].map(
      (name) => `${name}.d.ts`,
    ),
    ...['element.css', 'custom-elements.json'],
  ].map((name) => `dist/element/${name}`)
  const view = ['domain', 'layers'].map((name) => `dist/view/${name}.d.ts`)
  expect(files.filter((name) => !shared.test(name)).sort()).toEqual(
    [...others, ...built, ...generated, ...element, ...view, ...program, ...compiled].sort(),
  )

  // The sources are not there, so the maps have them.
  for (const name of files.filter((file) => file.endsWith('.map'))) {
    const map = JSON.parse(readFileSync(join(packed, name), 'utf8'))
    expect(map.sourcesContent, name).toHaveLength(map.sources.length)
  }
})

test('shows the pictures of its README on a registry page', () => {
  // There a path is looked for in the repository, if that is known.
  const { repository, homepage, bugs } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'))
  const [place] = /https:\/\/github\.com\/[\w-]+\/[\w-]+(?=\.git$)/.exec(repository.url) as RegExpExecArray
  expect([homepage, bugs]).toEqual([`${place}#readme`, `${place}/issues`])
  const pictures = [...readFileSync(join(ROOT, 'README.md'), 'utf8').matchAll(/ (?:src|srcset)="([^"]+\.jpg)"/g)]
  expect(pictures).not.toHaveLength(0)
  for (const [, path] of pictures) expect(run(ROOT, 'git', 'ls-files', path as string)).toBe(`${path}\n`)
})

test('depends on nothing', () => {
  expect(readdirSync(project.path('node_modules')).filter((name) => !name.startsWith('.'))).toEqual(['circle-voronoi'])
})

test.describe('is well made', () => {
  test('to publint', () => {
    expect(project.run(join(BIN, 'publint'), 'run', project.tarball, '--strict')).toContain('All good!')
  })

  test('to are-the-types-wrong', () => {
    const wasm = ['', '-comparison', '-files', '-regions'].map((name) => `circle-voronoi${name}.wasm`)
    const others = [...wasm, 'element/element.css', 'custom-elements.json']
    const options = ['--profile', 'esm-only', '--exclude-entrypoints', ...others, '--no-emoji']
    const judged = project.run(join(BIN, 'attw'), project.tarball, ...options)
    for (const name of ['', '/worker', '/worker-thread', '/files', ...ELEMENT])
      expect(judged).toContain(`"circle-voronoi${name}"`)
  })

  test('to size-limit', () => {
    const sizes = JSON.parse(run(ROOT, join(BIN, 'size-limit'), '--json'))
    expect(sizes).toHaveLength(8)
    for (const { name, passed, size } of sizes) expect(passed, `${name}: ${size} bytes`).toBe(true)
  })
})

test.describe('in Node', () => {
  for (const source of ['default', 'url', 'bytes']) {
    test(`as a module and in a worker, the WebAssembly from the ${source}`, () => {
      expect(project.run(process.execPath, 'node.js', source)).toBe(`${EXPECTED}\n`)
    })
  }

  test('where code generation from strings is forbidden', () => {
    const printed = project.run(process.execPath, '--disallow-code-generation-from-strings', 'node.js', 'default')
    expect(printed).toBe(`${EXPECTED}\n`)
  })

  test('in a bundle of CommonJS and as a data: module, which have no address, given the bytes', async () => {
    const entry = project.path('bundled.mjs')
    project.write(
      'bundled.mjs',
      `import { readFileSync } from 'node:fs'
      import { loadCircleVoronoi } from 'circle-voronoi'
      const wasm = readFileSync(${JSON.stringify(project.path('node_modules/circle-voronoi/dist/lib/generated/circle-voronoi.wasm'))})
      loadCircleVoronoi({ wasm }).then((library) => console.log(library.compute([[0, 0, 1], [6, 0, 1], [0, 8, 1]]).vertices.join()))`,
    )
    const options: BuildOptions = {
      entryPoints: [entry],
      bundle: true,
      platform: 'node',
      logLevel: 'error',
      write: false,
    }
    // That there is no import.meta in CommonJS is what is tested.
    const silenced = { logOverride: { 'empty-import-meta': 'silent' } } as const
    const common = (await bundle({ ...options, ...silenced, format: 'cjs' })).outputFiles?.[0]?.text as string
    project.write('bundled.cjs', common)
    expect(project.run(process.execPath, 'bundled.cjs')).toBe('3,4,4\n')
    const module = (await bundle({ ...options, format: 'esm' })).outputFiles?.[0]?.text as string
    project.write('data.mjs', `import ${JSON.stringify(`data:text/javascript,${encodeURIComponent(module)}`)}`)
    expect(project.run(process.execPath, 'data.mjs')).toBe('3,4,4\n')
  })

  test('in a bundle of CommonJS that does not give it, with an error that says what to do', async () => {
    project.write(
      'forgetful.mjs',
      `import { readFileSync } from 'node:fs'
      import { CircleVoronoiError, loadCircleVoronoi } from 'circle-voronoi'
      import { createWorker } from 'circle-voronoi/worker'
      const module = WebAssembly.compile(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]))
      const wasm = readFileSync(${JSON.stringify(project.path('node_modules/circle-voronoi/dist/lib/generated/circle-voronoi.wasm'))})
      const failed = [
        loadCircleVoronoi(), loadCircleVoronoi({ wasm }).then((library) => library.loadComparison()), createWorker().compute([]), createWorker({ wasm: module }).compute([]),
        loadCircleVoronoi({ wasm: module }), loadCircleVoronoi({ wasm: Promise.reject('none') }),
      ].map((promise) => promise.catch((error) => error instanceof CircleVoronoiError ? error.code + ': ' + error.message : 'raw: ' + error))
      Promise.all(failed).then((lines) => console.log(lines.join('\\n')))`,
    )
    const bundled = await bundle({
      entryPoints: [project.path('forgetful.mjs')],
      bundle: true,
      platform: 'node',
      format: 'cjs',
      write: false,
      logOverride: { 'empty-import-meta': 'silent' },
    })
    project.write('forgetful.cjs', bundled.outputFiles[0]?.text as string)
    const lines = project.run(process.execPath, 'forgetful.cjs').trim().split('\n')
    const beside = /^notLoaded: .+ from beside this module, which has no address \(give it as \{ wasm \}\): .+\.$/
    for (const line of lines.slice(0, 3)) expect(line).toMatch(beside)
    expect(lines[3]).toMatch(/^internal: The worker failed: .+\.$/)
    expect(lines[4]).toMatch(/^notLoaded: The WebAssembly cannot be loaded from this module: .+\.$/)
    expect(lines[5]).toBe('notLoaded: The WebAssembly cannot be loaded from what was given: none.')
    expect(lines).toHaveLength(6)
  })

  test('its program, by npx', () => {
    project.write('circles.csv', '0,0,1\n6,0,1\n0,8,1\n')
    const npx = (...args: string[]) => project.run('npx', '--offline', '--no', 'circle-voronoi', ...args)
    npx('compute', 'circles.csv', '-o', 'diagram.json')
    expect(npx('certify', 'diagram.json')).toBe('certified: 3 circles, 0 of them hidden; 1 vertices, 3 edges\n')
    expect(() => npx('compute', 'none.csv')).toThrow('Cannot read none.csv: No such file or directory.')
  })

  test('from the bundle, its worker too', () => {
    project.write(
      'bundle-main.mjs',
      `import * as library from './node_modules/circle-voronoi/dist/lib/bundle.js'
      import { useBundle } from './bundle.js'
      globalThis.fetch = () => { throw new Error('Something was asked for.') }
      console.log(await useBundle(library))`,
    )
    expect(project.run(process.execPath, 'bundle-main.mjs')).toBe('3,4,4 3,4,4\n')
  })

  test('from the bundle, fits in its worker', () => {
    project.write(
      'bundle-fit.mjs',
      `import { createWorker, loadCircleVoronoi } from './node_modules/circle-voronoi/dist/lib/bundle.js'
      const { region } = await (await loadCircleVoronoi()).loadRegions()
      const square = region([[[0, 0], [4, 0], [4, 4], [0, 4]]])
      const { areas } = await createWorker().fitAreas([[1, 1], [3, 2]], [4, 12], { region: square })
      console.log(Array.from(areas, Math.round).join())`,
    )
    expect(project.run(process.execPath, 'bundle-fit.mjs')).toBe('4,12\n')
  })

  test('by require, where Node requires modules', () => {
    const requires = (process.features as { require_module?: boolean }).require_module === true
    const command = ['--no-warnings', 'require.cjs']
    if (requires) expect(project.run(process.execPath, ...command)).toBe('3,4,4\n')
    else expect(() => project.run(process.execPath, ...command)).toThrow('ERR_REQUIRE_ESM')
  })
})

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

test.describe('has types', () => {
  const SETTINGS = {
    'a page with a bundler': { module: 'esnext', moduleResolution: 'bundler', lib: ['es2022', 'dom'], types: [] },
    Node: { module: 'nodenext', moduleResolution: 'nodenext', lib: ['es2022'], types: ['node'] },
    'a project from before exports': {
      ...{ module: 'esnext', moduleResolution: 'node10', lib: ['es2022', 'dom'], types: [] },
    },
  }
  for (const [place, settings] of Object.entries(SETTINGS)) {
    for (const compiler of ['tsc', 'tsc6', OLDEST_TSC]) {
      // TypeScript 7 no longer knows that way.
      if (compiler === 'tsc' && settings.moduleResolution === 'node10') continue
      const name = compiler === OLDEST_TSC ? 'TypeScript 5.0' : compiler
      test(`for ${place}, to ${name}`, { tag: compiler === 'tsc' ? [] : '@long' }, () => {
        const compilerOptions = {
          ...settings,
          ...(compiler === 'tsc6' && { ignoreDeprecations: '6.0' }),
          target: 'es2022',
          strict: true,
          skipLibCheck: false,
          // Those of the compiler itself take most of the time.
          skipDefaultLibCheck: true,
          noEmit: true,
          typeRoots: [join(ROOT, 'node_modules/@types')],
        }
        const files = settings.lib.includes('dom') ? ['types.ts', 'element-types.ts'] : ['types.ts']
        project.write('tsconfig.json', JSON.stringify({ compilerOptions, files }))
        expect(project.run(resolve(BIN, compiler), '-p', 'tsconfig.json')).toBe('')
      })
    }
  }
})

/** The page that a server of files serves prints what is expected. */
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

/** plain.html: a page without a bundler, which finds modules by their addresses. */
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
    // It advises against files over 244 KiB, before compression.
    performance: { hints: false },
  })
  const stats = await new Promise<webpack.Stats | undefined>((resolve, reject) =>
    compiler.run((error, result) => (error ? reject(error) : resolve(result))),
  )
  expect(stats?.toJson({ all: false, errors: true, warnings: true })).toMatchObject({ errors: [], warnings: [] })
  await new Promise((resolve) => compiler.close(resolve))
}
