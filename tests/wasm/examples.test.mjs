// SPDX-License-Identifier: GPL-3.0-or-later
// The examples in the doc comments of web/lib, on the built package. Each function, class and constant has an example
// whose result stands behind it. Examples of methods are run without comparison.
import assert from 'node:assert/strict'
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { after, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { inspect } from 'node:util'
import { blocksRunBy } from '../readme/blocks.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const MODULES = ['index', 'worker', 'regions', 'metrics', 'sphere', 'files', 'link']
/** The common beginning of the examples, as the module's own comment gives it. */
const BEGIN = `
const library = await loadCircleVoronoi()
const diagram = library.compute([[0, 0, 1], [6, 0, 1], [0, 8, 1]])
`

const sources = readdirSync(`${ROOT}web/lib`, { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.ts'))
  .map((name) => readFileSync(`${ROOT}web/lib/${name}`, 'utf8'))
const names = Object.fromEntries(
  await Promise.all(MODULES.map(async (name) => [name, Object.keys(await import(`${ROOT}dist/lib/${name}.js`))])),
)
const imports = MODULES.map((name) => `import { ${names[name]} } from '${ROOT}dist/lib/${name}.js'\n`).join('')
const folder = mkdtempSync(`${tmpdir()}/circle-voronoi-`)
after(() => rmSync(folder, { recursive: true }))

/** The example code of an exported name, or `undefined`. */
function exampleOf(name) {
  const declaration = new RegExp(
    `/\\*\\*((?:(?!\\*/)[^])*)\\*/\\nexport (?:async )?(?:function|class|const) ${name}\\b`,
  )
  const comments = sources.map((source) => declaration.exec(source)?.[1])
  return comments
    .find((comment) => comment?.includes('@example\n'))
    ?.split('@example\n')[1]
    ?.replace(/^ \* ?/gm, '')
    .trimEnd()
}

for (const module of MODULES) {
  describe(`the example in circle-voronoi/${module}`, () => {
    for (const name of names[module]) {
      it(`of ${name} gives what it says`, async () => {
        const example = exampleOf(name)
        assert.ok(example, `${name} has no example`)
        const expected = []
        const code = example.replace(/^( *)(\S.*) \/\/ (.*)$/gm, (_, indent, expression, text) => {
          expected.push(text)
          return `${indent}said.push(${expression})`
        })
        assert.notEqual(expected.length, 0, `the example of ${name} says nothing`)
        const file = `${folder}/${name}.mjs`
        const begin = code.includes('const library') ? '' : BEGIN
        writeFileSync(file, `${imports}export const said = []\n${begin}${code}\n`)
        const { said } = await import(file)
        assert.deepEqual(
          said.map((value) => inspect(value, { breakLength: Infinity })),
          expected,
        )
      })
    }
  })
}

describe('the code in a comment', () => {
  for (const { file, line, code } of blocksRunBy('tests/wasm/examples.test.mjs')) {
    it(`${file}:${line} runs, and what it asks to be told it is told`, async () => {
      const module = `${folder}/${file.replaceAll('/', '-')}-${line}.mjs`
      const given = ['library', 'diagram', 'editor', 'worker', 'circles', 'canvas']
      // An inner block allows the example to redeclare names.
      const made = [...code.matchAll(/^const (?:\[id\]|\{ (\w+) \}|(\w+)) = /gm)].flatMap(([, ...names]) =>
        names.filter(Boolean),
      )
      assert.notEqual(made.length, 0)
      const source = `export async function run({ ${given.join(', ')} }) {\n{\n${code}\nreturn { ${made.join(', ')} }\n}\n}\n`
      writeFileSync(module, imports + source)
      const { run } = await import(module)
      const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
      const { createWorker } = await import(`${ROOT}dist/lib/worker.js`)
      const circles = [
        [0, 0, 1],
        [6, 0, 1],
        [0, 8, 1],
      ]
      const library = await loadCircleVoronoi()
      const canvas = {}
      const worker = createWorker()
      const editor = library.edit(circles)
      try {
        const computed = library.compute(circles)
        const { diagram = computed } = await run({
          library,
          diagram: computed,
          editor,
          worker,
          circles,
          canvas,
        })
        assert.equal(diagram.vertices.length, 3)
        if (code.includes('onpointermove')) {
          await canvas.onpointermove({ offsetX: 1, offsetY: 2 })
          assert.deepEqual([...diagram.circles.subarray(0, 3)], [1, 2, 5])
        }
      } finally {
        worker.dispose()
        editor.dispose()
      }
    })
  }
})
