// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the examples: a page with the source of each, and the examples that are pages themselves.
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { basename, dirname, posix } from 'node:path'
import { buildSite as buildMarkdown } from '../../examples/element/markdown/build.mjs'
import { ROOT } from '../run.mjs'
import { slugOf } from './markdown.mjs'
import { codeBlock, escaped } from './page.mjs'

const EXAMPLES = `${ROOT}examples`
/** Sources of examples. A text of the same name holds a program's output, which tests compare. */
const SOURCE = /(CMakeLists\.txt|(?<!\.d)\.(cpp|css|csv|html|js|jsx|md|mjs|py|sh))$/
/** Maps files of dist/ and public/ that examples use to files of the site's folder. */
const IN_SITE = {
  'dist/element/index.js': 'element/index.js',
  'dist/element/classic.js': 'element.js',
  'dist/element/element.css': 'element.css',
  'dist/lib/index.js': 'lib/bundle.js',
  'dist/lib/regions.js': 'lib/bundle.js',
  'dist/site/': '',
  'public/data/': 'data/',
}
const IN_DIST = new RegExp(`(?:\\.\\./)+(${Object.keys(IN_SITE).join('|')})`, 'g')

/**
 * Lists the folders of the examples in their order, pages first.
 * @returns {{ folder: string, files: string[], about: string, isLive: boolean }[]}
 */
export function readGallery() {
  const all = readdirSync(EXAMPLES, { recursive: true, encoding: 'utf8' })
    .filter((path) => SOURCE.test(path))
    .sort()
  const folders = [...new Set(all.map(dirname))].map((folder) => {
    const files = all.filter((path) => dirname(path) === folder)
    const isLive = files.some((path) => /(index\.html|page\.md)$/.test(path))
    return { folder, files, about: aboutOf(files), isLive }
  })
  return [...folders.filter(({ isLive }) => isLive), ...folders.filter(({ isLive }) => !isLive)]
}

/** The description of an example: its page's title, or the first sentence of a program's first comment. */
function aboutOf(files) {
  const said = files.map((path) => {
    const source = readFileSync(`${EXAMPLES}/${path}`, 'utf8')
    const [, title] = /<title>(.*)<\/title>/.exec(source) ?? []
    const [, comment] = /^(?:#!.*\n)?(?:(?:\/\/|#) SPDX.*\n)\n?(?:\/\/|#|""") ?(.*)/.exec(source) ?? []
    return title ?? comment?.replace(/: \S+ .*$|:$/, '')
  })
  return said.find((about) => about !== undefined) ?? ''
}

/**
 * Copies the examples that are pages into the site's folder `examples`, with their scripts and pictures.
 * @param {string} site the folder of the built site
 * @returns {Promise<string>} the page of all examples
 */
export async function buildGallery(site) {
  copyFileSync(`${ROOT}web/element/element.css`, `${site}/element.css`)
  const ofElement = readdirSync(`${ROOT}dist/element`).filter((name) => /^(?!classic|inline|react).*\.js$/.test(name))
  mkdirSync(`${site}/element`, { recursive: true })
  for (const name of ofElement) copyFileSync(`${ROOT}dist/element/${name}`, `${site}/element/${name}`)
  // The library's single file fetches further modules.
  mkdirSync(`${site}/lib/generated`, { recursive: true })
  copyFileSync(`${ROOT}dist/lib/bundle.js`, `${site}/lib/bundle.js`)
  const modules = ['-metrics', '-regions'].flatMap((name) => [`${name}.js`, `${name}.wasm`])
  // Scripts of examples contain those of these modules.
  for (const name of [...modules, '.wasm', '-files.wasm', '-sphere.wasm']) {
    const file = `lib/generated/circle-voronoi${name}`
    copyFileSync(`${ROOT}dist/${file}`, `${site}/${file}`)
  }
  const examples = readGallery()
  for (const { folder, files } of examples.filter(({ isLive }) => isLive)) {
    await putPage(folder, files, `${site}/examples/${folder}`)
  }
  mkdirSync(`${site}/docs/examples`, { recursive: true })
  const parts = examples.map((example, k) => `${placeOfParent(examples, k)}${partOf(example, site)}`)
  return `<h1>Examples</h1>
<p>Small pages and programs that use the library. You can run the pages here, and the source is below each one. The folder
<code>examples</code> of the repository contains all of them. The <a href="cookbook.html">cookbook</a> has shorter recipes.</p>
${parts.join('\n')}`
}

async function putPage(folder, files, target) {
  const root = posix.relative(`/examples/${folder}`, '/')
  mkdirSync(target, { recursive: true })
  const script = files.find((path) => /main\.jsx?$/.test(path))
  if (folder.endsWith('markdown')) buildMarkdown(target, `${root}/element.js`)
  else if (script !== undefined) await bundle(script, `${target}/main.js`, root)
  const copied = script === undefined ? /\.(css|html|js)$/ : /\.(css|html)$/
  for (const path of files.filter((path) => copied.test(path))) {
    writeFileSync(
      `${target}/${basename(path)}`,
      sourceInSite(`${EXAMPLES}/${path}`, root).replace('main.jsx', 'main.js'),
    )
  }
}

/** Returns the source of an example with the addresses of the site. */
function sourceInSite(path, root) {
  return readFileSync(path, 'utf8').replace(IN_DIST, (_, name) => `${root}/${IN_SITE[name]}`)
}

/** Bundles an example with other packages, except for the element and the WebAssembly, which the site contains. */
async function bundle(script, outfile, root) {
  const { build } = await import('esbuild')
  await build({
    absWorkingDir: ROOT,
    entryPoints: [`examples/${script}`],
    outfile,
    bundle: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    jsx: 'automatic',
    legalComments: 'none',
    define: {
      'process.env.NODE_ENV': '"production"',
      __VUE_OPTIONS_API__: 'true',
      __VUE_PROD_DEVTOOLS__: 'false',
      __VUE_PROD_HYDRATION_MISMATCH_DETAILS__: 'false',
    },
    plugins: [
      {
        name: 'element-of-the-site',
        setup: ({ onResolve }) =>
          onResolve({ filter: /^circle-voronoi\/element$/ }, () => ({ path: `${root}/element.js`, external: true })),
      },
      {
        name: 'addresses-of-the-site',
        setup: ({ onLoad }) => {
          onLoad({ filter: /\/examples\/.*\.js$/ }, ({ path }) => ({ contents: sourceInSite(path, root) }))
          onLoad({ filter: /\/dist\/lib\/.*\.js$/ }, ({ path }) => ({
            contents: readFileSync(path, 'utf8').replace(/'[./]+(generated\/[\w-]+\.wasm)'/g, `'${root}/lib/$1'`),
          }))
        },
      },
    ],
    logLevel: 'warning',
  })
}

/** A folder of folders is linked to, too. */
function placeOfParent(examples, k) {
  const parent = dirname(examples[k].folder)
  const isFirst = examples.findIndex(({ folder }) => dirname(folder) === parent) === k
  return parent === '.' || !isFirst ? '' : `<span id="${slugOf(parent)}"></span>`
}

function partOf({ folder, files, about, isLive }, site) {
  const sources = files.map(
    (path) =>
      `<details id="${slugOf(path)}"><summary>${basename(path)}</summary>${code(`${EXAMPLES}/${path}`)}</details>`,
  )
  const prints = files
    .map((path) => path.replace(/\.\w+$/, '.txt'))
    .filter((path) => path !== `${folder}/CMakeLists.txt` && existsSync(`${EXAMPLES}/${path}`))
    .map(
      (path) =>
        `<p>The first lines that <code>${basename(path, '.txt')}</code> prints:</p>\n${code(`${EXAMPLES}/${path}`)}`,
    )
  return `<h2 id="${slugOf(folder)}">${folder}</h2>
<p>${escaped(about)}</p>
${[...(isLive ? [preview(folder, about, site)] : []), ...prints, ...sources].join('\n')}`
}

/** The picture of an example. web/docs/gallery.ts replaces it by the page. */
function preview(folder, about, site) {
  const picture = pictureOf(folder)
  // `npm run picture` takes it from the built page.
  if (existsSync(`${ROOT}docs/${picture}`)) copyFileSync(`${ROOT}docs/${picture}`, `${site}/docs/${picture}`)
  const address = `../examples/${folder}/`
  return `<figure class="example" data-page="${address}">
<img src="${picture}" alt="The page of this example" width="736" height="589" loading="lazy">
<figcaption><button type="button" hidden>Run it here<span class="hidden">: ${escaped(about)}</span></button> <a href="${address}">Open the page<span class="hidden">: ${escaped(about)}</span></a></figcaption>
</figure>`
}

/** The picture of an example that is a page, relative to docs/. */
export function pictureOf(folder) {
  return `examples/${basename(folder)}.jpg`
}

function code(path) {
  return codeBlock(readFileSync(path, 'utf8'))
}
