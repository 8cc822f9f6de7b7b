// SPDX-License-Identifier: GPL-3.0-or-later
// Lists all code blocks of the site, and the test that runs each. Tests take their blocks from here.
import { readdirSync, readFileSync } from 'node:fs'
import MarkdownIt from 'markdown-it'
import { BLOCKS as FIGURES } from '../../scripts/texts/markdown.mjs'

const ROOT = new URL('../../', import.meta.url)
const CHAPTERS = 'web/tutorial/chapters'
const MANUAL_PAGE = 'cpp/cli/circle-voronoi.1'
/** Markdown files of the site: the texts of scripts/texts/documentation.mjs, and the chapters. */
const MARKDOWN = [
  ...['README.md', 'ARCHITECTURE.md', 'public/data/README.md', 'CONTRIBUTING.md', 'CHANGELOG.md'],
  ...[
    'areas',
    'building',
    'cookbook',
    'cpp',
    'element',
    'embedding',
    'put-it-into',
    'javascript',
    'metrics',
    'periodic',
    'python',
    'regions',
    'results',
    'shell',
    'tiles',
  ].map((name) => `docs/${name}.md`),
  ...readdirSync(new URL(CHAPTERS, ROOT)).map((name) => `${CHAPTERS}/${name}`),
]
const LISTED = 'tests/scripts/blocks.test.mjs'
const NATIVE = 'tests/readme/native.test.mjs'
const PACKAGE = 'tests/pack/package.test.mjs'
const PAGE = 'tests/pack/readme.spec.ts'
const ELEMENT = 'tests/pack/element.spec.ts'
const COOKBOOK = 'tests/pack/cookbook.spec.ts'
const EMBEDDING = 'tests/pack/embedding.spec.ts'
const TOOLS = 'tests/long/builds.test.mjs'
const PYTHON = 'cpp/python/tests/test_documentation.py'
const COMMENTS = 'tests/wasm/examples.test.mjs'

/**
 * The test that runs the blocks of a file, or of a section if a heading is given. `what` is the kind of a block that
 * does not run as it stands.
 */
const RUN_BY = [
  { by: PACKAGE, file: 'README.md', heading: 'In JavaScript' },
  { by: NATIVE, file: 'README.md', heading: 'In C++' },
  { by: PAGE, file: 'README.md', heading: 'As a figure in a page' },
  { by: NATIVE, file: 'README.md', heading: 'In the shell' },
  { by: LISTED, file: 'README.md', language: '', what: 'commands' },
  { by: LISTED, file: 'docs/building.md', what: 'commands' },
  { by: NATIVE, file: 'docs/shell.md', language: 'sh' },
  { by: LISTED, file: 'docs/shell.md', language: '', what: 'file' },
  { by: PAGE, file: 'docs/javascript.md', language: 'html' },
  ...['js', 'sh'].map((language) => ({ by: PACKAGE, file: 'docs/javascript.md', language })),
  ...['docs/regions.md', 'docs/areas.md', 'docs/periodic.md', 'docs/metrics.md'].flatMap((file) => [
    { by: PACKAGE, file, language: 'js' },
    { by: NATIVE, file, language: 'sh' },
  ]),
  { by: NATIVE, file: 'docs/tiles.md' },
  { by: NATIVE, file: 'docs/cpp.md' },
  { by: PYTHON, file: 'docs/python.md', language: 'python' },
  { by: 'tests/long/python.test.mjs', file: 'docs/python.md', language: 'sh' },
  { by: COOKBOOK, file: 'docs/cookbook.md' },
  { by: PAGE, file: 'docs/element.md', language: 'html' },
  ...['js', 'sh', 'jsx'].map((language) => ({ by: ELEMENT, file: 'docs/element.md', language })),
  { by: EMBEDDING, file: 'docs/embedding.md' },
  ...['Quarto', 'Moodle, WordPress and other systems'].map((heading) => ({
    by: EMBEDDING,
    file: 'docs/put-it-into.md',
    heading,
  })),
  ...[
    ...[
      'VitePress',
      'Docusaurus',
      'Next',
      'Nuxt',
      'Angular',
      'Astro Starlight',
      'Eleventy',
      'MkDocs',
      'reveal.js',
      'Slidev',
    ],
    'Observable Framework',
  ].map((heading) => ({ by: TOOLS, file: 'docs/put-it-into.md', heading })),
  { by: LISTED, file: 'docs/results.md', what: 'commands' },
  { by: LISTED, file: 'CONTRIBUTING.md', what: 'commands' },
  { by: LISTED, file: 'ARCHITECTURE.md', heading: 'Folders', what: 'folders' },
  ...['The core', 'The page'].map((heading) => ({
    by: LISTED,
    file: 'ARCHITECTURE.md',
    heading,
    what: 'drawing',
  })),
  { by: 'tests/e2e/tutorial.spec.ts', file: `${CHAPTERS}/teachers.md` },
  { by: NATIVE, file: MANUAL_PAGE },
  ...['index', 'wasm/editor', 'wasm/library', 'worker'].map((name) => ({
    by: COMMENTS,
    file: `web/lib/${name}.ts`,
  })),
  { by: PAGE, file: 'web/element/index.ts' },
]

/**
 * @typedef {object} Block
 * @property {string} file of the repository
 * @property {number} line on which it begins, from 1
 * @property {string} language after its fence; '' without one
 * @property {string} code
 * @property {readonly string[]} headings that it stands below, from the title on
 */

/** @returns {Block[]} all blocks of the site */
export function blocks() {
  const comments = ['lib', 'element', 'view'].flatMap((folder) =>
    readdirSync(new URL(`web/${folder}`, ROOT), { recursive: true })
      .filter((name) => name.endsWith('.ts'))
      .map((name) => `web/${folder}/${name}`),
  )
  const headers = readdirSync(new URL('cpp/include/circle_voronoi', ROOT)).map(
    (name) => `cpp/include/circle_voronoi/${name}`,
  )
  return [
    ...MARKDOWN.flatMap((file) => blocksOfMarkdown(file, read(file))),
    ...blocksOfManual(read(MANUAL_PAGE)),
    ...[...comments, ...headers].flatMap((file) => blocksOfComments(file, read(file))),
  ]
}

/** The entries of `RUN_BY` that match a block. */
export function runnersOf({ file, language, headings }) {
  return RUN_BY.filter(
    (runner) =>
      runner.file === file &&
      (runner.heading === undefined || headings.includes(runner.heading)) &&
      (runner.language === undefined || runner.language === language),
  )
}

/** The blocks that a test has to run, each with its kind `what`. Throws if there are none. */
export function blocksRunBy(test) {
  const own = blocks().flatMap((block) => {
    const runner = runnersOf(block).find(({ by }) => by === test)
    return runner === undefined ? [] : [{ ...block, what: runner.what }]
  })
  if (own.length === 0) throw new Error(`There are no blocks for ${test}.`)
  return own
}

export { MARKDOWN, RUN_BY }

function read(file) {
  return readFileSync(new URL(file, ROOT), 'utf8')
}

/** Parses Markdown like the site. */
export function blocksOfMarkdown(file, text) {
  const tokens = new MarkdownIt({ html: true }).parse(text, {})
  const found = []
  let headings = []
  for (const [i, { type, tag, info, content, map }] of tokens.entries()) {
    if (type === 'heading_open') {
      const level = Number(tag.slice(1))
      headings = [...headings.slice(0, level - 1), tokens[i + 1].content]
    }
    const language = info.trim()
    if ((type === 'fence' && !FIGURES.includes(language)) || type === 'code_block')
      found.push({ file, line: map[0] + (type === 'fence' ? 2 : 1), language, code: content, headings })
  }
  return found
}

/** Lines that are shown together are one block. */
function blocksOfManual(mdoc) {
  const found = []
  for (const [i, line] of mdoc.split('\n').entries()) {
    const [, command] = /^\.Dl (.*)$/.exec(line) ?? []
    if (command === undefined) continue
    const last = found.at(-1)
    const isNext = last !== undefined && last.line + last.code.split('\n').length - 1 === i + 1
    if (isNext) last.code += `${command}\n`
    else found.push({ file: MANUAL_PAGE, line: i + 1, language: 'sh', code: `${command}\n`, headings: ['EXAMPLES'] })
  }
  return found
}

/**
 * Fenced blocks in doc comments. Code after `@example` without a fence is tested by name
 * (tests/wasm/examples.test.mjs).
 */
function blocksOfComments(file, source) {
  const fenced = /^( *(?:\*|\/\/\/?) ?)(?:```(\w*)|@code)\n((?:\1?.*\n)*?)\1(?:```|@endcode)$/gm
  return [...source.matchAll(fenced)].map(({ index, 2: language = '', 3: code }) => ({
    file,
    line: source.slice(0, index).split('\n').length + 1,
    language,
    code: code.replace(/^ *(?:\*|\/\/\/?) ?/gm, ''),
    headings: [],
  }))
}
