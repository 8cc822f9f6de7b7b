// SPDX-License-Identifier: GPL-3.0-or-later
// Finishes dist/lib, dist/element and dist/cli after the TypeScript compiler: copies the output of C++, and makes the
// bundles. Vite is not used, because it would inline the threads and the WebAssembly, which other bundlers have to find
// as files.
import { chmodSync, copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { dirname, join, posix, relative } from 'node:path'
import { promisify } from 'node:util'
import { build, transform } from 'esbuild'
import { ROOT } from './run.mjs'

const LICENSE = '// SPDX-License-Identifier: GPL-3.0-or-later'
/** @type {import('esbuild').BuildOptions} */
const BUNDLED = {
  absWorkingDir: ROOT,
  bundle: true,
  minify: true,
  format: 'esm',
  target: 'es2022',
  legalComments: 'none',
  banner: { js: LICENSE },
  logLevel: 'warning',
}

/** Copies the WebAssembly modules of web/lib, and makes bundle.js, which contains everything. */
async function lib() {
  mkdirSync(`${ROOT}dist/lib/generated`, { recursive: true })
  for (const name of ['', '-files', '-metrics', '-regions', '-sphere'].flatMap((name) => [
    `${name}.js`,
    `${name}.wasm`,
  ])) {
    const file = `lib/generated/circle-voronoi${name}`
    copyFileSync(`${ROOT}web/${file}`, `${ROOT}dist/${file}`)
  }
  const entries = ['index', 'link', 'metrics', 'regions', 'sphere', 'worker']
  const exported = await Promise.all(entries.map((name) => import(`${ROOT}dist/lib/${name}.js`)))
  const names = exported.flatMap(Object.keys)
  // Code that is pasted after the file can use its exports, because they are variables.
  const ending = `const{${names}}=wholeFile(import.meta.url);export{${names}}`
  writeFileSync(`${ROOT}dist/lib/bundle.js`, `${LICENSE}\n${await oneFile()}\n${ending}\n`)
  // Removes the source map and the declarations that the compiler made of web/lib/bundle.ts.
  for (const ending of ['js.map', 'd.ts']) rmSync(`${ROOT}dist/lib/bundle.${ending}`)
  removeUnusedDeclarations()
}

/**
 * Bundles the library with the WebAssembly as a function of its address that returns its exports. Threads run the text of
 * this function where a page cannot start a worker from a file.
 */
async function oneFile() {
  const { outputFiles } = await build({
    ...BUNDLED,
    banner: {},
    format: 'iife',
    globalName: 'exported',
    define: { 'import.meta.url': 'addressOfFile' },
    write: false,
    entryPoints: ['web/lib/bundle.ts'],
    plugins: [
      wasmInside,
      replacing('web/lib/threads/thread-file.ts', 'web/lib/bundled/threads/thread-file.ts'),
      replacing('web/lib/wasm/default-wasm.ts', 'web/lib/bundled/wasm/default-wasm.ts'),
    ],
  })
  return `function wholeFile(addressOfFile){${outputFiles[0].text}return exported}`
}

/**
 * Bundles `<circle-voronoi>`: with its thread as a separate file (index.js, define.js, react.js) and the WebAssembly of
 * dist/lib; and in one file (classic.js), which inline.js turns into a module for any bundler.
 */
async function element() {
  copyDeclarations('element/index.d.ts', 'element/define.d.ts', 'element/react.d.ts')
  await build({
    ...BUNDLED,
    outdir: 'dist/element',
    splitting: true,
    external: ['react'],
    plugins: [...ELEMENT, painterBeside, wasmBeside, elementOfPackage],
    entryPoints: {
      index: 'web/element/index.ts',
      define: 'web/element/define.ts',
      painter: 'web/view/painter/start-thread.ts',
      react: 'web/element/react.ts',
    },
  })
  await elementInOneFile()
  copyFileSync(`${ROOT}web/element/element.css`, `${ROOT}dist/element/element.css`)
  const { manifest } = await import('./manifest.mjs')
  writeFileSync(`${ROOT}dist/element/custom-elements.json`, `${JSON.stringify(manifest(), undefined, 2)}\n`)
}

/**
 * Writes the element as a script with a global variable, and as a module of that script. The thread's text is a string
 * in it, because bundlers would change a function's references.
 */
async function elementInOneFile() {
  const inOneFile = [...ELEMENT, wasmInside]
  const { outputFiles } = await build({
    ...BUNDLED,
    banner: {},
    format: 'iife',
    write: false,
    entryPoints: ['web/view/painter/start-thread.ts'],
    plugins: [...inOneFile, replacing('web/lib/wasm/default-wasm.ts', 'web/lib/bundled/wasm/thread-wasm.ts')],
  })
  const text = {
    name: 'thread-text',
    setup({ onResolve, onLoad }) {
      onResolve({ filter: /\/painter\.thread$/ }, ({ path }) => ({ path, namespace: 'thread' }))
      onLoad({ filter: /./, namespace: 'thread' }, () => ({ contents: outputFiles[0].text, loader: 'text' }))
    },
  }
  await build({
    ...BUNDLED,
    format: 'iife',
    globalName: 'circleVoronoi',
    footer: { js: 'globalThis.circleVoronoi=circleVoronoi' },
    outfile: 'dist/element/classic.js',
    entryPoints: ['web/element/index.ts'],
    plugins: [
      ...inOneFile,
      text,
      replacing('web/view/painter-file.ts', 'web/lib/bundled/threads/thread-text.ts'),
      replacing('web/lib/wasm/default-wasm.ts', 'web/lib/bundled/wasm/page-wasm.ts'),
      replacing('web/lib/wasm/other-wasm.ts', 'web/lib/bundled/wasm/no-other-wasm.ts'),
    ],
  })
  const names = 'CircleVoronoiElement, defineCircleVoronoi'
  writeFileSync(
    `${ROOT}dist/element/inline.js`,
    `${LICENSE}\nimport './classic.js'\nexport const { ${names} } = globalThis.circleVoronoi\n`,
  )
}

/** Copies the declarations of the element from build/element-types. The declarations of dist/lib exist already. */
function copyDeclarations(...files) {
  for (const name of declarationsFrom(`${ROOT}build/element-types/`, files)) {
    if (name.startsWith('lib/')) continue
    mkdirSync(dirname(`${ROOT}dist/${name}`), { recursive: true })
    copyFileSync(`${ROOT}build/element-types/${name}`, `${ROOT}dist/${name}`)
  }
}

/** Removes the declarations of dist/lib that no entry imports. */
function removeUnusedDeclarations() {
  const folder = `${ROOT}dist/lib/`
  const all = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.d.ts'))
  const used = declarationsFrom(
    folder,
    all.filter((name) => !name.includes('/')),
  )
  for (const name of all) if (!used.has(name)) rmSync(folder + name)
}

/** Returns declaration files of a folder with all that they import. */
function declarationsFrom(folder, files) {
  const found = new Set(files)
  for (const file of found) {
    for (const [, path] of readFileSync(folder + file, 'utf8').matchAll(/(?:from |import\()'(\.[^']+)\.[jt]s'/g)) {
      found.add(`${posix.join(dirname(file), path)}.d.ts`)
    }
  }
  return found
}

/** Bundles pictures without a browser: the library's part, and the command of the program. */
async function picture() {
  copyDeclarations('picture/index.d.ts')
  await build({
    ...BUNDLED,
    outdir: 'dist/picture',
    platform: 'neutral',
    mainFields: ['module', 'main'],
    external: ['node:*'],
    splitting: true,
    plugins: [styles, libraryBeside],
    entryPoints: { index: 'web/picture/index.ts', command: 'web/picture/command.ts' },
  })
}

/** Bundles the program for Node. */
function cli() {
  chmodSync(`${ROOT}dist/cli/circle-voronoi.js`, 0o755)
  mkdirSync(`${ROOT}dist/cli/generated`)
  // Emscripten writes CommonJS, whose extension must differ from the modules around it.
  copyFileSync(`${ROOT}web/cli/generated/program.js`, `${ROOT}dist/cli/generated/program.cjs`)
  copyFileSync(`${ROOT}web/cli/generated/program.wasm`, `${ROOT}dist/cli/generated/program.wasm`)
}

/**
 * Deflated before base64, because compression by a server leaves plain base64 half as long again. Zopfli takes two
 * seconds and saves a twentieth over zlib.
 */
const wasmInside = {
  name: 'wasm-inside',
  setup({ onLoad }) {
    onLoad({ filter: /\.wasm$/ }, async ({ path }) => {
      if (!compressed.has(path)) compressed.set(path, zopfli(readFileSync(path)))
      return { contents: await compressed.get(path), loader: 'base64' }
    })
  },
}

/** Caches results by path, because several builds contain the same modules. */
const compressed = new Map()

async function zopfli(bytes) {
  const { gzip } = await import('@gfx/zopfli')
  // Zopfli's listeners would print its own minified code in place of an error of this script.
  for (const event of ['uncaughtException', 'unhandledRejection']) process.removeAllListeners(event)
  return promisify(gzip)(bytes, {})
}

/** Lets bundles find the WebAssembly of dist/lib relative to their folder. */
const wasmBeside = rewriting(
  /web\/lib\/(files|wasm\/default-wasm)\.ts$/,
  /'[./]+(generated\/[\w-]+\.wasm)'/g,
  "'../lib/$1'",
)

/** Lets bundles import the modules of dist/lib. */
const libraryBeside = {
  name: 'library-beside',
  setup({ onResolve }) {
    onResolve({ filter: /^\..*\.ts$/ }, ({ path, resolveDir }) => {
      const module = relative(`${ROOT}web/lib`, join(resolveDir, path))
      return module.startsWith('..') ? undefined : { path: `../lib/${module.replace(/ts$/, 'js')}`, external: true }
    })
  },
}

/** Points the element to its thread's file in dist/element. */
const painterBeside = rewriting(/web\/view\/painter-file\.ts$/, /'\.\/painter\/start-thread\.ts'/g, "'./painter.js'")

/** Makes the React component import the package's element, so that a bundler picks the right file. */
const elementOfPackage = {
  name: 'element-of-package',
  setup({ onResolve }) {
    onResolve({ filter: /^\.\/index\.ts$/ }, ({ importer }) =>
      importer.endsWith('/web/element/react.ts') ? { path: 'circle-voronoi/element', external: true } : undefined,
    )
  },
}

/** Imports style sheets as text. */
const styles = {
  name: 'styles',
  setup({ onLoad, onResolve }) {
    onResolve({ filter: /\.css$/ }, ({ path, resolveDir }) => ({ path: join(resolveDir, path), sideEffects: false }))
    onResolve({ filter: /\.css\?inline$/ }, ({ path, resolveDir }) => ({
      path: join(resolveDir, path.replace('?inline', '')),
      sideEffects: false,
    }))
    onLoad({ filter: /\.css$/ }, async ({ path }) => {
      const { code } = await transform(readFileSync(path, 'utf8'), { loader: 'css', minify: true })
      return { contents: code, loader: 'text' }
    })
  },
}

/** Rewrites addresses in modules. */
function rewriting(filter, address, other) {
  return {
    name: `rewriting-${other}`,
    setup({ onLoad }) {
      onLoad({ filter }, ({ path }) => ({
        contents: readFileSync(path, 'utf8').replace(address, other),
        loader: 'ts',
      }))
    },
  }
}

/** Replaces one module by another. */
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

/** The element's replacements: no JSON of diagrams, and a thread with the scripts of all modules. */
const ELEMENT = [
  styles,
  replacing('web/lib/diagram/diagram-file.ts', 'web/element/no-diagram-file.ts'),
  replacing('web/view/painter/other-modules.ts', 'web/element/modules-inside.ts'),
]

await { lib, element, picture, cli }[process.argv[2]]()
