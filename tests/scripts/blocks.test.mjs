// SPDX-License-Identifier: GPL-3.0-or-later
// All code in the site is tested: each block has a test that runs it, and each test takes its blocks from
// tests/readme/blocks.mjs. Blocks that a test cannot run, such as commands that take hours, are checked here for the
// names that they use.
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { TEXTS } from '../../scripts/texts/documentation.mjs'
import { readGallery } from '../../scripts/texts/gallery.mjs'
import { blocks, blocksOfMarkdown, blocksRunBy, MARKDOWN, RUN_BY, runnersOf } from '../readme/blocks.mjs'
import { library } from '../web/library.ts'

const ROOT = new URL('../../', import.meta.url)
const read = (path) => readFileSync(new URL(path, ROOT), 'utf8')
const all = blocks()
const own = blocksRunBy('tests/scripts/blocks.test.mjs')
const ownOf = (what) =>
  own.filter((block) => block.what === what).map((block) => [`${block.file}:${block.line}`, block])

describe('each block of code in the site is run by one test', () => {
  it.each(all.map((block) => [`${block.file}:${block.line}`, block]))('%s', (_, block) => {
    expect(runnersOf(block).map(({ by }) => by)).toHaveLength(1)
  })

  it('and each of these tests takes its blocks from the list', () => {
    for (const by of new Set(RUN_BY.map(({ by }) => by))) {
      expect(read(by), by).toMatch(new RegExp(`blocksRunBy\\(\\s*'${by}'`))
    }
    for (const runner of RUN_BY) {
      expect(
        all.filter((block) => runnersOf(block).includes(runner)),
        JSON.stringify(runner),
      ).not.toEqual([])
    }
  })

  it('of all texts that the site has', () => {
    expect(MARKDOWN).toEqual(expect.arrayContaining(Object.keys(TEXTS)))
  })
})

it('finds fenced and indented blocks below their headings, and not what chapters show', () => {
  const text =
    '# A\n\n    one\n\n## B\n\n```js\ntwo()\n```\n\n### C\n\n```figure\n{}\n```\n\n- item\n\n  ```sh\n  three\n  ```\n'
  expect(
    blocksOfMarkdown('x.md', text).map(({ line, language, code, headings }) => [line, language, code, headings]),
  ).toEqual([
    [3, '', 'one\n', ['A']],
    [8, 'js', 'two()\n', ['A', 'B']],
    [20, 'sh', 'three\n', ['A', 'B', 'C']],
  ])
})

/** Maps examples, by the first part of their path, to the file that opens, builds or runs them. */
const EXAMPLES = {
  bouncing: 'tests/e2e/examples.spec.ts',
  districts: 'tests/pack/areas.spec.ts',
  element: 'tests/e2e/examples.spec.ts',
  fetch_content: 'tests/package/check.cmake',
  find_package: 'tests/package/check.cmake',
  globe: 'tests/e2e/globe.spec.ts',
  packing: 'tests/wasm/packing.test.mjs',
  tiles: 'tests/tiles/tiles.test.mjs',
  treemap: 'tests/pack/areas.spec.ts',
}
it.each(readGallery().map(({ folder }) => folder))('the example %s has a test', (folder) => {
  const [name] = folder.split('/')
  expect(read(EXAMPLES[name])).toContain(name)
})

const { scripts } = JSON.parse(read('package.json'))
const presets = JSON.parse(read('CMakePresets.json'))
/** The programs that parse options: scripts, the programs that they start, and StrykerJS. */
const PROGRAMS = [
  ...['scripts', 'scripts/results', 'cpp/bench', 'tests/soak', 'tests/mutants'].flatMap((folder) =>
    readdirSync(new URL(folder, ROOT))
      .filter((name) => /\.(mjs|cpp|h)$/.test(name))
      .map((name) => `${folder}/${name}`),
  ),
  'node_modules/@stryker-mutator/core/dist/src/stryker-cli.js',
]
  .map(read)
  .join('\n')

it.each(ownOf('commands'))('the commands at %s are there, with their options', (_, { code }) => {
  const named = [...code.matchAll(/\bnpm (?:run )?([\w:-]+)/g)].map(([, name]) => name)
  expect(named).not.toEqual([])
  for (const name of named) expect(scripts).toHaveProperty([name])
  for (const [, program, name] of code.matchAll(/\b(cmake --build|cmake|ctest) --preset (\w+)/g)) {
    const kind = { cmake: 'configurePresets', 'cmake --build': 'buildPresets', ctest: 'testPresets' }[program]
    expect(presets[kind].map((preset) => preset.name)).toContain(name)
  }
  for (const [, option] of code.matchAll(/--(?!preset|build)([a-z][\w-]*)/gi)) {
    expect(PROGRAMS, option).toMatch(new RegExp(`\\b${option}\\b`))
  }
})

it.each(ownOf('file'))('the file at %s is as the library writes it', (_, { code }) => {
  const file = JSON.parse(
    JSON.stringify(
      library.compute([
        [0, 0, 1],
        [6, 0, 1],
        [0, 8, 1],
        [0, 0, 0.5],
      ]),
    ),
  )
  const keysOf = (value) =>
    value === null || typeof value !== 'object'
      ? []
      : [...(Array.isArray(value) ? [] : Object.keys(value)), ...Object.values(value).flatMap(keysOf)]
  const shown = [...code.matchAll(/"(\w+)":/g)].map(([, key]) => key)
  for (const key of shown) expect(keysOf(file), key).toContain(key)
  for (const key of Object.keys({ ...file, ...file.stats })) expect(shown).toContain(key)
})

it.each(ownOf('folders'))('the folders at %s are there', (_, { code }) => {
  const lines = code.split('\n').filter((line) => /^\S/.test(line))
  expect(lines.length).toBeGreaterThan(20)
  for (const line of lines) {
    const [first, ...others] = line.split(/ {2,}| (?=the |curves|names)/)[0].split(', ')
    const parent = first.includes('/') ? `${first.split('/')[0]}/` : ''
    for (const folder of [first, ...others.map((name) => (name.includes('/') ? name : parent + name))]) {
      expect(existsSync(new URL(folder, ROOT)), `${folder} in ${line}`).toBe(true)
    }
  }
})

it.each(ownOf('drawing'))('what is at %s is a drawing', (_, { code }) => {
  expect(code).toContain('─►')
})
