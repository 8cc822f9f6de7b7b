// SPDX-License-Identifier: GPL-3.0-or-later
// The four builds: native (library, command line, tests), wasm, lib (the npm package) and site (the page).
import {
  chmodSync,
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs'
import { delimiter, dirname, join, posix } from 'node:path'
import { gzipSync } from 'node:zlib'
import { isMain, main, ROOT, run } from './run.mjs'
import { setup } from './setup.mjs'
import { finishSite } from './site.mjs'

const NPM_BIN = `${ROOT}node_modules/.bin`
const WASM_OUTPUT = ['', '-comparison', '-files'].flatMap((name) =>
  ['js', 'wasm'].map((type) => `circle-voronoi${name}.${type}`),
)

/** build/native: the library, the program build/native/circle-voronoi and the tests. */
export async function buildNative() {
  await cmakeBuild('build/native', 'cmake', ['--preset', 'native'])
}

/**
 * web/lib/generated, web/app/generated and web/tutorial/generated, the WebAssembly modules of the package and of the page
 * alone; for the package web/cli/generated, its program, too, for which setup has to install more.
 */
export async function buildWasm(purpose) {
  const isPackage = purpose === 'package'
  const configure = [
    ...['cmake', '-S', '.', '-B', 'build/wasm', '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release'],
    '-DCIRCLE_VORONOI_BUILD_TESTS=OFF',
    `-DCIRCLE_VORONOI_BUILD_CLI=${isPackage ? 'ON' : 'OFF'}`,
    // CGAL and Boost are headers of the machine, where a cross build does not look.
    '-DCMAKE_INCLUDE_PATH=/usr/include;/usr/local/include',
  ]
  const modules = ['', '_comparison', '_files', '_families', '_printed'].map((name) => `circle_voronoi${name}_wasm`)
  const targets = isPackage ? ['all'] : modules
  await cmakeBuild('build/wasm', 'emcmake', configure, targets)
}

/** dist/lib: web/lib as JavaScript with declarations, the WebAssembly modules, and bundle.js, which is all in one. */
export async function buildLib() {
  const outputs = [
    'dist/lib/index.js',
    'dist/lib/bundle.js',
    ...WASM_OUTPUT.map((name) => `dist/lib/generated/${name}`),
  ]
  if (isUpToDate(outputs, ['web/lib', 'tsconfig.json', 'tsconfig.lib.json', 'package-lock.json'])) return
  // Files whose source is gone would be packed.
  rmSync(`${ROOT}dist/lib`, { recursive: true, force: true })
  await run(`${NPM_BIN}/tsc`, ['-p', 'tsconfig.lib.json'])
  mkdirSync(`${ROOT}dist/lib/generated`, { recursive: true })
  for (const name of WASM_OUTPUT) {
    copyFileSync(`${ROOT}web/lib/generated/${name}`, `${ROOT}dist/lib/generated/${name}`)
  }
  await bundle()
}

/**
 * dist/element: `<circle-voronoi>`, with its thread beside it (index.js, define.js), and all in one (bundle.js). Its
 * WebAssembly is that of dist/lib.
 */
export async function buildElement() {
  const outputs = ['index.js', 'define.js', 'painter.js', 'bundle.js', 'index.d.ts'].map(
    (name) => `dist/element/${name}`,
  )
  const inputs = ['lib', 'view', 'editing', 'player', 'element'].map((name) => `web/${name}`)
  if (isUpToDate(outputs, [...inputs, 'tsconfig.json', 'tsconfig.element.json', 'package-lock.json'])) return
  for (const folder of ['element', 'view']) rmSync(`${ROOT}dist/${folder}`, { recursive: true, force: true })
  await buildDeclarations()
  const { build } = await import('esbuild')
  await build({
    ...BUNDLED,
    outdir: 'dist/element',
    splitting: true,
    plugins: [styles, replacing('web/view/painter-file.ts', 'web/element/built/painter-file.ts'), wasmBeside],
    entryPoints: {
      index: 'web/element/index.ts',
      define: 'web/element/define.ts',
      painter: 'web/view/painter/start-thread.ts',
    },
  })
  await bundleElement('dist/element/bundle.js')
  for (const name of ['element.css', 'custom-elements.json']) {
    copyFileSync(`${ROOT}web/element/${name}`, `${ROOT}dist/element/${name}`)
  }
}

/** The element in one file. */
async function bundleElement(outfile) {
  const { build } = await import('esbuild')
  await build({
    ...BUNDLED,
    entryPoints: ['web/element/bundle.ts'],
    outfile,
    plugins: [
      styles,
      wasmInside,
      replacing('web/view/painter-file.ts', 'web/element/bundled/painter-file.ts'),
      replacing('web/lib/default-wasm.ts', 'web/lib/bundled/default-wasm.ts'),
      wasmBeside,
    ],
  })
}

/** What of the declarations belongs to the element: those of dist/lib are there. */
async function buildDeclarations() {
  const out = 'build/element-types'
  rmSync(ROOT + out, { recursive: true, force: true })
  await run(`${NPM_BIN}/tsc`, ['-p', 'tsconfig.element.json', '--outDir', out])
  const copied = new Set()
  const copy = (file) => {
    if (copied.has(file) || file.startsWith('lib/')) return
    copied.add(file)
    const text = readFileSync(`${ROOT}${out}/${file}`, 'utf8')
    mkdirSync(dirname(`${ROOT}dist/${file}`), { recursive: true })
    writeFileSync(`${ROOT}dist/${file}`, text)
    for (const [, path] of text.matchAll(/from '(\.[^']+)\.ts'/g)) copy(`${posix.join(dirname(file), path)}.d.ts`)
  }
  for (const name of ['index', 'define', 'bundle']) copy(`element/${name}.d.ts`)
}

/** dist/cli: the program in WebAssembly, for Node. */
export async function buildCli() {
  const outputs = ['circle-voronoi.js', 'generated/program.cjs', 'generated/program.wasm'].map(
    (name) => `dist/cli/${name}`,
  )
  if (isUpToDate(outputs, ['web/cli', 'tsconfig.json', 'tsconfig.cli.json', 'package-lock.json'])) return
  rmSync(`${ROOT}dist/cli`, { recursive: true, force: true })
  await run(`${NPM_BIN}/tsc`, ['-p', 'tsconfig.cli.json'])
  chmodSync(`${ROOT}dist/cli/circle-voronoi.js`, 0o755)
  mkdirSync(`${ROOT}dist/cli/generated`)
  // Emscripten writes CommonJS, which has to be told from the modules around it.
  copyFileSync(`${ROOT}web/cli/generated/program.js`, `${ROOT}dist/cli/generated/program.cjs`)
  copyFileSync(`${ROOT}web/cli/generated/program.wasm`, `${ROOT}dist/cli/generated/program.wasm`)
}

/** What all bundles have in common. */
const BUNDLED = {
  absWorkingDir: ROOT,
  bundle: true,
  minify: true,
  format: 'esm',
  target: 'es2022',
  legalComments: 'none',
  banner: { js: '// SPDX-License-Identifier: GPL-3.0-or-later' },
  logLevel: 'warning',
}

/** Compressed once more by a server, base64 of the bytes themselves would be half as long again. */
const wasmInside = {
  name: 'wasm-inside',
  setup({ onLoad }) {
    onLoad({ filter: /\.wasm$/ }, ({ path }) => ({
      contents: gzipSync(readFileSync(path), { level: 9 }),
      loader: 'base64',
    }))
  },
}

/** Modules find the WebAssembly of dist/lib from dist/element. */
const wasmBeside = {
  name: 'wasm-beside',
  setup({ onLoad }) {
    onLoad({ filter: /web\/lib\/(default-wasm|comparison)\.ts$/ }, ({ path }) => ({
      contents: readFileSync(path, 'utf8').replace("'./generated/circle-voronoi", (text) =>
        text.replace('./', '../lib/'),
      ),
      loader: 'ts',
    }))
  },
}

/** Style sheets as texts. */
const styles = {
  name: 'styles',
  setup({ onLoad, onResolve }) {
    onResolve({ filter: /\.css$/ }, ({ path, resolveDir }) => ({ path: join(resolveDir, path), sideEffects: false }))
    onResolve({ filter: /\.css\?inline$/ }, ({ path, resolveDir }) => ({
      path: join(resolveDir, path.replace('?inline', '')),
      sideEffects: false,
    }))
    onLoad({ filter: /\.css$/ }, async ({ path }) => {
      const { transform } = await import('esbuild')
      const { code } = await transform(readFileSync(path, 'utf8'), { loader: 'css', minify: true })
      return { contents: code, loader: 'text' }
    })
  },
}

/** Takes one module in place of another one. */
function replacing(module, other) {
  return {
    name: `replacing-${module}`,
    setup({ onLoad }) {
      const filter = new RegExp(`/${module.replaceAll('.', '\\.')}$`)
      onLoad({ filter }, () => ({
        contents: readFileSync(ROOT + other, 'utf8'),
        loader: 'ts',
        resolveDir: dirname(ROOT + other),
      }))
    },
  }
}

/** dist/lib/bundle.js, with the files of web/lib/bundled in place of those of their name in web/lib. */
async function bundle() {
  const replaced = readdirSync(`${ROOT}web/lib/bundled`)
  // Installed with the npm packages, so not before setup has run.
  const { build } = await import('esbuild')
  await build({
    ...BUNDLED,
    entryPoints: ['web/lib/bundle.ts'],
    outfile: 'dist/lib/bundle.js',
    allowOverwrite: true,
    plugins: [wasmInside, ...replaced.map((name) => replacing(`web/lib/${name}`, `web/lib/bundled/${name}`))],
  })
  // That of the module that tsc made.
  rmSync(`${ROOT}dist/lib/bundle.js.map`)
}

/** build/api: the reference of the package. Fails if anything exported is not documented, or a link in a comment is broken. */
async function buildReference() {
  const inputs = ['web/lib', 'web/element', 'web/view', 'typedoc.json', 'tsconfig.element.json', 'package-lock.json']
  if (isUpToDate(['build/api/index.html'], inputs)) return
  // The site has the README as a page of its own.
  await run(`${NPM_BIN}/typedoc`, ['--out', 'build/api', '--readme', 'none', '--logLevel', 'Warn'])
}

/**
 * dist/site: the page, the tutorial and the documentation, static, for any folder of a server. `withPage` is called as soon
 * as the page is there, which is long before the rest.
 */
export async function buildSite(withPage = async () => {}) {
  const texts = [
    'README.md',
    'ARCHITECTURE.md',
    'CONTRIBUTING.md',
    'CHANGELOG.md',
    'docs',
    'examples',
    'cpp/cli',
    'cpp/include',
  ]
  const inputs = [
    'web',
    'public',
    ...texts,
    'vite.config.ts',
    'typedoc.json',
    'package-lock.json',
    'scripts/site.mjs',
    'scripts/texts',
  ]
  if (isUpToDate(['dist/site/service-worker.js'], inputs)) return withPage()
  await run(`${NPM_BIN}/vite`, ['build'])
  await withPage()
  // For who copies the code of an element from the page.
  await bundleElement('dist/site/element.js')
  // Its libraries are installed with the npm packages, so not before setup has run.
  await buildLib()
  await buildReference()
  const { buildTexts } = await import('./texts/texts.mjs')
  await buildTexts(`${ROOT}dist/site`)
  await finishSite(`${ROOT}dist/site`)
}

/** All that tests ask for. */
export async function buildTests() {
  await buildWasm('package')
  await buildNative()
  await buildLib()
  await buildElement()
  await buildCli()
  await buildSite()
}

async function cmakeBuild(folder, program, configure, targets = ['all']) {
  // Emscripten's optimiser looks for its acorn module there on Debian.
  const env = { NODE_PATH: ['/usr/share/nodejs', process.env.NODE_PATH].filter(Boolean).join(delimiter) }
  // Ninja itself configures again when a CMake file has changed, but not for other options.
  const stamp = `${ROOT}${folder}/.configured`
  const options = configure.join('\n')
  if (!existsSync(stamp) || readFileSync(stamp, 'utf8') !== options) {
    await run(program, configure, env)
    writeFileSync(stamp, options)
  }
  await run('cmake', ['--build', folder, '--target', ...targets], env)
}

/** Whether every output is at least as new as each file of the inputs (files or folders). */
function isUpToDate(outputs, inputs) {
  if (!outputs.every((path) => existsSync(ROOT + path))) return false
  const oldest = Math.min(...outputs.map((path) => statSync(ROOT + path).mtimeMs))
  return inputs.every((path) => newestChange(ROOT + path) <= oldest)
}

function newestChange(path) {
  const status = statSync(path)
  if (!status.isDirectory()) return status.mtimeMs
  return Math.max(status.mtimeMs, ...readdirSync(path).map((name) => newestChange(`${path}/${name}`)))
}

if (isMain(import.meta.url)) {
  const forPage = () => buildWasm('page')
  const forPackage = () => buildWasm('package')
  const builds = {
    native: { purpose: 'tests', steps: [buildNative] },
    wasm: { purpose: 'package', steps: [forPackage] },
    lib: { purpose: 'package', steps: [forPackage, buildLib, buildElement, buildCli] },
    site: { purpose: 'page', steps: [forPage, buildSite] },
  }
  const name = process.argv[2]
  await main(async () => {
    if (!(name in builds)) throw new Error(`Say which build: ${Object.keys(builds).join(', ')}.`)
    const { purpose, steps } = builds[name]
    await setup(purpose)
    for (const step of steps) await step()
  })
}
