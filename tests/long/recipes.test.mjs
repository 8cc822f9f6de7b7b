// SPDX-License-Identifier: GPL-3.0-or-later
// The cookbook with the newest versions of the packages that its recipes import: a reader's `npm install` brings these, and they may
// lay out their files differently.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { pathToFileURL } from 'node:url'
import { OTHERS, recipes } from '../readme/recipes.mjs'

let folder
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-recipes-'))
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }')
  const packages = OTHERS.map((name) => `${name}@latest`)
  execFileSync('npm', ['install', '--ignore-scripts', '--no-audit', '--no-fund', '--silent', ...packages], {
    cwd: folder,
  })
})
after(() => rmSync(folder, { recursive: true, force: true }))

/** The files of other packages that a recipe names. */
const filesOf = (code) =>
  [...code.matchAll(/['"]\.\/(node_modules\/(?!circle-voronoi\/)[^'"]+)['"]/g)].map(([, path]) => path)
/** The names that a recipe imports, by package or file. */
const importsOf = (code) =>
  [...code.matchAll(/^ *import \{ ([^}]+) \} from '([^']+)'$/gm)]
    .map(([, names, from]) => ({ names: names.split(', '), from }))
    .filter(({ from }) => OTHERS.some((name) => from === name || from.startsWith(`./node_modules/${name}/`)))

describe('with the newest packages', () => {
  const found = recipes().flatMap(({ title, code }) => [
    ...filesOf(code).map((path) => ({ title, path })),
    ...importsOf(code).map(({ names, from }) => ({ title, names, from })),
  ])

  it('all of these packages are used', () => {
    const text = found.map(({ path, from }) => path ?? from).join(' ')
    for (const name of OTHERS) assert.match(text, new RegExp(`\\b${name}\\b`))
  })

  for (const { title, path, names, from } of found) {
    if (path !== undefined) {
      it(`${title}: ${path} is there`, () => assert.ok(existsSync(join(folder, path))))
      continue
    }
    it(`${title}: ${from} has ${names.join(', ')}`, async () => {
      const entry = join(folder, `${names.join('-')}.js`)
      writeFileSync(entry, `export { ${names.join(', ')} } from '${from}'\n`)
      const module = await import(pathToFileURL(entry).href)
      for (const name of names) assert.notEqual(module[name], undefined)
    })
  }
})
