// SPDX-License-Identifier: GPL-3.0-or-later
// The package as its users have it, without a browser: packed, installed in a project of its own, and used in Node. The
// documentation's code for Node is tested, too. package.spec.ts tests pages with the package.
import assert from 'node:assert/strict'
import { existsSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs'
import { basename, join } from 'node:path'
import { after, describe, it } from 'node:test'
import { build as bundle } from 'esbuild'
import { blocksRunBy } from '../readme/blocks.mjs'
import { BIN, Project, ROOT, run, tarball } from './project.mjs'
import { hasTypes } from './types.mjs'

/** The result of consumer/main.js: three circles of radius 1 at the corners of a triangle with sides 6, 8 and 10. */
const EXPECTED = JSON.stringify(JSON.parse(readFileSync(new URL('expected.json', import.meta.url), 'utf8')))

/** The modules of the element. */
const ELEMENT = ['/element', '/element/define', '/element/inline', '/react']

const project = new Project()
after(() => project.remove())

it('holds the built library and nothing else', () => {
  const packed = project.path('node_modules/circle-voronoi')
  const files = readdirSync(packed, { recursive: true }).filter((name) => statSync(join(packed, name)).isFile())
  const built = readdirSync(join(ROOT, 'web/lib'), { recursive: true })
    .filter((name) => /(?<!\.d)\.ts$/.test(name) && !name.startsWith('bundled/'))
    .flatMap((name) => ['.js', '.js.map', '.d.ts'].map((ending) => `dist/lib/${name.replace(/\.ts$/, ending)}`))
    // The single file has neither a map nor types.
    .filter((name) => !/^dist\/lib\/bundle\.(js\.map|d\.ts)$/.test(name))
    // Types are there if those of an entry need them. Tests of the types find out whether one is missing.
    .filter((name) => !/\/lib\/.+\/.+\.d\.ts$/.test(name) || files.includes(name))
  const generated = readdirSync(join(ROOT, 'web/lib/generated')).map((name) => `dist/lib/generated/${name}`)
  const program = readdirSync(join(ROOT, 'web/cli'))
    .filter((name) => name.endsWith('.ts'))
    .map((name) => `dist/cli/${name.replace(/\.ts$/, '.js')}`)
  const compiled = ['dist/cli/generated/program.cjs', 'dist/cli/generated/program.wasm']
  const others = ['LICENSE', 'README.md', 'THIRD-PARTY-NOTICES.txt', 'package.json']
  // The names of shared chunks are derived from their contents.
  const shared = /^dist\/(element|picture)\/(chunk|circle-voronoi-(metrics|regions)|german|link|player)-[A-Z0-9]+\.js$/
  assert.notEqual(files.filter((name) => shared.test(name)).length, 0)
  const element = [
    ...['index', 'define', 'painter', 'classic', 'inline', 'react'].map((name) => `${name}.js`),
    ...['index', 'define', 'react', 'exports', 'circle-voronoi-element', 'frame-types', 'frameworks', 'goal-types'].map(
      (name) => `${name}.d.ts`,
    ),
    ...['element.css', 'custom-elements.json'],
  ].map((name) => `dist/element/${name}`)
  const picture = ['command.js', 'index.js', 'index.d.ts', 'render.d.ts', 'scheme.d.ts'].map(
    (name) => `dist/picture/${name}`,
  )
  const view = ['diagram-counts', 'domain', 'layers', 'load'].map((name) => `dist/view/${name}.d.ts`)
  assert.deepEqual(
    files.filter((name) => !shared.test(name)).sort(),
    [...others, ...built, ...generated, ...element, ...picture, ...view, ...program, ...compiled].sort(),
  )

  // The sources are not published, so the maps include them.
  for (const name of files.filter((file) => file.endsWith('.map'))) {
    const map = JSON.parse(readFileSync(join(packed, name), 'utf8'))
    assert.equal(map.sourcesContent.length, map.sources.length, name)
  }
})

it('shows the pictures of its README on a registry page', () => {
  // Relative paths resolve to the repository, if it is known.
  const { repository, homepage, bugs } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'))
  const [place] = /https:\/\/github\.com\/[\w-]+\/[\w-]+(?=\.git$)/.exec(repository.url)
  assert.deepEqual([homepage, bugs], [`${place}#readme`, `${place}/issues`])
  const pictures = [...readFileSync(join(ROOT, 'README.md'), 'utf8').matchAll(/ (?:src|srcset)="([^"]+\.jpg)"/g)]
  assert.notEqual(pictures.length, 0)
  for (const [, path] of pictures) assert.equal(run(ROOT, 'git', 'ls-files', path), `${path}\n`)
})

it('depends on nothing', () => {
  assert.deepEqual(
    readdirSync(project.path('node_modules')).filter((name) => !name.startsWith('.')),
    ['circle-voronoi'],
  )
})

describe('is well made', () => {
  it('to publint', () => {
    assert.match(project.run(join(BIN, 'publint'), 'run', tarball(), '--strict'), /All good!/)
  })

  it('to are-the-types-wrong', () => {
    const others = ['*.wasm', 'element/element.css', 'custom-elements.json']
    const options = ['--profile', 'esm-only', '--exclude-entrypoints', ...others, '--no-emoji']
    const judged = project.run(join(BIN, 'attw'), tarball(), ...options)
    for (const name of [
      '',
      '/worker',
      '/worker-thread',
      '/regions',
      '/metrics',
      '/sphere',
      '/files',
      '/link',
      ...ELEMENT,
    ])
      assert.ok(judged.includes(`"circle-voronoi${name}"`), judged)
  })

  it('to size-limit', () => {
    const sizes = JSON.parse(run(ROOT, join(BIN, 'size-limit'), '--json'))
    assert.equal(sizes.length, 9)
    for (const { name, passed, size } of sizes) assert.equal(passed, true, `${name}: ${size} bytes`)
  })
})

describe('in Node', () => {
  for (const source of ['default', 'url', 'bytes']) {
    it(`as a module and in a worker, the WebAssembly from the ${source}`, () => {
      assert.equal(project.run(process.execPath, 'node.js', source), `${EXPECTED}\n`)
    })
  }

  it('where code generation from strings is forbidden', () => {
    const printed = project.run(process.execPath, '--disallow-code-generation-from-strings', 'node.js', 'default')
    assert.equal(printed, `${EXPECTED}\n`)
  })

  it('in a bundle of CommonJS and as a data: module, which have no address, given the bytes', async () => {
    const entry = project.path('bundled.mjs')
    project.write(
      'bundled.mjs',
      `import { readFileSync } from 'node:fs'
      import { loadCircleVoronoi } from 'circle-voronoi'
      const wasm = readFileSync(${JSON.stringify(project.path('node_modules/circle-voronoi/dist/lib/generated/circle-voronoi.wasm'))})
      loadCircleVoronoi({ wasm }).then((library) => console.log(library.compute([[0, 0, 1], [6, 0, 1], [0, 8, 1]]).vertices.join()))`,
    )
    const options = { entryPoints: [entry], bundle: true, platform: 'node', logLevel: 'error', write: false }
    // The test is about CommonJS, which has no import.meta.
    const silenced = { logOverride: { 'empty-import-meta': 'silent' } }
    const common = (await bundle({ ...options, ...silenced, format: 'cjs' })).outputFiles[0].text
    project.write('bundled.cjs', common)
    assert.equal(project.run(process.execPath, 'bundled.cjs'), '3,4,4\n')
    const module = (await bundle({ ...options, format: 'esm' })).outputFiles[0].text
    project.write('data.mjs', `import ${JSON.stringify(`data:text/javascript,${encodeURIComponent(module)}`)}`)
    assert.equal(project.run(process.execPath, 'data.mjs'), '3,4,4\n')
  })

  it('in a bundle of CommonJS that does not give it, with an error that says what to do', async () => {
    project.write(
      'forgetful.mjs',
      `import { readFileSync } from 'node:fs'
      import { CircleVoronoiError, loadCircleVoronoi } from 'circle-voronoi'
      import { loadMetrics } from 'circle-voronoi/metrics'
      import { createWorker } from 'circle-voronoi/worker'
      const module = WebAssembly.compile(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]))
      const wasm = readFileSync(${JSON.stringify(project.path('node_modules/circle-voronoi/dist/lib/generated/circle-voronoi.wasm'))})
      const failed = [
        loadCircleVoronoi(), loadCircleVoronoi({ wasm }).then((library) => loadMetrics({ library })), createWorker().compute([]), createWorker({ wasm: module }).compute([]),
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
    project.write('forgetful.cjs', bundled.outputFiles[0].text)
    const lines = project.run(process.execPath, 'forgetful.cjs').trim().split('\n')
    const beside = /^notLoaded: .+ from beside this module, which has no address \(give it as \{ wasm \}\): .+\.$/
    for (const line of lines.slice(0, 3)) assert.match(line, beside)
    assert.match(lines[3], /^internal: The worker failed: .+\.$/)
    assert.match(lines[4], /^notLoaded: The WebAssembly cannot be loaded from this module: .+\.$/)
    assert.equal(lines[5], 'notLoaded: The WebAssembly cannot be loaded from what was given: none.')
    assert.equal(lines.length, 6)
  })

  it('its program, by npx', () => {
    project.write('circles.csv', '0,0,1\n6,0,1\n0,8,1\n')
    const npx = (...args) => project.run('npx', '--offline', '--no', 'circle-voronoi', ...args)
    npx('compute', 'circles.csv', '-o', 'diagram.json')
    assert.equal(npx('certify', 'diagram.json'), 'certified: 3 circles, 0 of them hidden; 1 vertices, 3 edges\n')
    assert.throws(() => npx('compute', 'none.csv'), /Cannot read none\.csv: No such file or directory\./)
  })

  it('from the bundle, its worker too', () => {
    project.write(
      'bundle-main.mjs',
      `import * as library from './node_modules/circle-voronoi/dist/lib/bundle.js'
      import { useBundle } from './bundle.js'
      globalThis.fetch = () => { throw new Error('Something was asked for.') }
      console.log(await useBundle(library))`,
    )
    assert.equal(project.run(process.execPath, 'bundle-main.mjs'), '3,4,4 3,4,4\n')
  })

  it('from the bundle, fits and power diagrams in its worker', () => {
    project.write(
      'bundle-fit.mjs',
      `import { createWorker, loadRegions } from './node_modules/circle-voronoi/dist/lib/bundle.js'
      const { region } = await loadRegions()
      const square = region([[[0, 0], [4, 0], [4, 4], [0, 4]]])
      const { areas } = await createWorker().fitAreas([[1, 1], [3, 2]], [4, 12], { region: square })
      const power = await createWorker().compute([[0, 0, -4], [10, 0, 20]], { metric: 'power', weights: true })
      console.log(Array.from(areas, Math.round).join(), power.find(3.9, 0))`,
    )
    assert.equal(project.run(process.execPath, 'bundle-fit.mjs'), '4,12 1\n')
  })

  it('by require, where Node requires modules', () => {
    const command = ['--no-warnings', 'require.cjs']
    if (process.features.require_module === true) {
      assert.equal(project.run(process.execPath, ...command), '3,4,4\n')
    } else assert.throws(() => project.run(process.execPath, ...command), /ERR_REQUIRE_ESM/)
  })
})

describe('has types', () => hasTypes(project, { tsc: join(BIN, 'tsc') }))

describe('the code for Node in the documentation', () => {
  const blocks = blocksRunBy('tests/pack/package.test.mjs')
  const inLanguage = (name) => blocks.filter(({ language }) => language === name)

  it('is all run', () => {
    assert.deepEqual(new Set(blocks.map(({ language }) => language)), new Set(['sh', 'js']))
    assert.equal(inLanguage('sh').length, 1)
  })

  for (const [i, { file, code, line }] of inLanguage('js').entries()) {
    it(`${file}:${line}`, () => {
      // Comments behind each call contain the expected output.
      const expected = [...code.matchAll(/^console\.log\(.*\) \/\/ (.*)$/gm)].map(([, text]) => `${text}\n`)
      assert.notEqual(expected.length, 0)
      project.write(`readme-${i}.js`, code)
      assert.equal(project.run(process.execPath, `readme-${i}.js`), expected.join(''))
    })
  }

  it('installs the package', () => {
    const [pack, install] = inLanguage('sh')[0].code.split('\n')
    assert.match(pack, /^npm pack +# .*: builds ([\w.-]+\.tgz)$/)
    assert.ok(pack.includes(basename(tarball())), pack)
    rmSync(project.path('node_modules'), { recursive: true })
    project.run('sh', '-c', `npm_config_offline=true ${install}`)
    assert.ok(existsSync(project.path('node_modules/circle-voronoi/package.json')))
  })
})
