// SPDX-License-Identifier: GPL-3.0-or-later
// The four builds: native (library, command line, tests), wasm, lib (the npm package) and app (the page).
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
import { delimiter } from 'node:path'
import { gzipSync } from 'node:zlib'
import { isMain, main, ROOT, run } from './run.mjs'
import { setup } from './setup.mjs'

const NPM_BIN = `${ROOT}node_modules/.bin`
const WASM_OUTPUT = ['', '-comparison', '-files'].flatMap((name) =>
  ['js', 'wasm'].map((type) => `circle-voronoi${name}.${type}`),
)

/** build/native: the library, the program build/native/circle-voronoi and the tests. */
export async function buildNative() {
  await cmakeBuild('build/native', 'cmake', ['--preset', 'native'])
}

/**
 * web/lib/generated, the WebAssembly modules: those of the page, or those of the npm package and in web/cli/generated its
 * program, for which setup has to install more.
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
  const modules = ['', '_comparison', '_files'].map((name) => `circle_voronoi${name}_wasm`)
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

/** dist/lib/bundle.js, with the files of web/lib/bundled in place of those of their name in web/lib. */
async function bundle() {
  const replaced = readdirSync(`${ROOT}web/lib/bundled`)
  // Installed with the npm packages, so not before setup has run.
  const { build } = await import('esbuild')
  await build({
    absWorkingDir: ROOT,
    entryPoints: ['web/lib/bundle.ts'],
    outfile: 'dist/lib/bundle.js',
    allowOverwrite: true,
    bundle: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    legalComments: 'none',
    banner: { js: '// SPDX-License-Identifier: GPL-3.0-or-later' },
    logLevel: 'warning',
    plugins: [
      {
        name: 'bundled',
        setup({ onLoad, onResolve }) {
          // Compressed once more by a server, base64 of the bytes themselves would be half as long again.
          onLoad({ filter: /\.wasm$/ }, ({ path }) => ({
            contents: gzipSync(readFileSync(path), { level: 9 }),
            loader: 'base64',
          }))
          onResolve({ filter: /^\.\/[\w-]+\.ts$/ }, ({ path, resolveDir }) =>
            replaced.includes(path.slice(2)) && resolveDir === `${ROOT}web/lib`
              ? { path: `${ROOT}web/lib/bundled/${path.slice(2)}` }
              : undefined,
          )
        },
      },
    ],
  })
  // That of the module that tsc made.
  rmSync(`${ROOT}dist/lib/bundle.js.map`)
}

/** dist/app: the page. */
export async function buildApp() {
  if (isUpToDate(['dist/app/index.html'], ['web', 'public', 'vite.config.ts', 'package-lock.json'])) return
  await run(`${NPM_BIN}/vite`, ['build'])
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
    lib: { purpose: 'package', steps: [forPackage, buildLib, buildCli] },
    app: { purpose: 'page', steps: [forPage, buildApp] },
  }
  const name = process.argv[2]
  await main(async () => {
    if (!(name in builds)) throw new Error(`Say which build: ${Object.keys(builds).join(', ')}.`)
    const { purpose, steps } = builds[name]
    await setup(purpose)
    for (const step of steps) await step()
  })
}
