// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that no two types of the C++ core have the same name: the linker would keep one destructor for both, silently.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { isMain, main, ROOT } from './run.mjs'

/** Returns the qualified names of the types that a source text defines at namespace scope, except in unnamed namespaces. */
export function typesOf(text) {
  const spaces = []
  const names = []
  for (const line of text.split('\n')) {
    const space = /^(?:inline )?namespace ?([\w:]*) ?\{/.exec(line)
    if (space !== null && !line.trimEnd().endsWith('}')) spaces.push(space[1])
    if (/^\} {2}\/\/ namespace/.test(line)) spaces.pop()
    const type = /^(?:struct|class|union|enum(?: class)?) (\w+)(?: final)?(?: :.*)? ?\{/.exec(line)
    if (type !== null && !spaces.includes('')) names.push([...spaces, type[1]].join('::'))
  }
  return names
}

if (isMain(import.meta.url)) {
  await main(() => {
    const files = execFileSync('git', ['ls-files', 'cpp/include', 'cpp/src'], { cwd: ROOT, encoding: 'utf8' })
    const fileOf = new Map()
    for (const file of files.trim().split('\n')) {
      if (!/\.(?:cpp|h)$/.test(file)) continue
      for (const name of typesOf(readFileSync(ROOT + file, 'utf8'))) {
        const other = fileOf.get(name)
        if (other !== undefined) throw new Error(`Two types are named ${name}: in ${other} and in ${file}.`)
        fileOf.set(name, file)
      }
    }
    console.log(`Checked the names of ${fileOf.size} types of the core.`)
  })
}
