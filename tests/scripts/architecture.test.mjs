// SPDX-License-Identifier: GPL-3.0-or-later
// ARCHITECTURE.md and the pages beside the code name files that exist, so the checklists lead somewhere.
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const FOLDERS = ['cpp', 'web', 'tests', 'scripts', 'examples', 'docs', 'public']
const PAGES = [
  'ARCHITECTURE.md',
  ...['cpp/src', 'cpp/src/edit', 'cpp/src/regions', 'web', 'web/lib', 'web/element', 'web/tutorial'].map(
    (folder) => `${folder}/README.md`,
  ),
]

/** The paths in inline code, and the targets of links, as paths in the repository. */
function pathsIn(page) {
  const text = readFileSync(join(ROOT, page), 'utf8').replace(/^```[\s\S]*?^```|^ {4}.*$/gm, '')
  const inCode = [...text.matchAll(/`([\w.*-]+(?:\/[\w.*-]+)+)`/g)]
    .map(([, path]) => path)
    .filter((path) => FOLDERS.includes(path.split('/')[0]))
  const linked = [...text.matchAll(/\]\(([^)#:]+)(?:#[^)]*)?\)/g)].map(([, path]) => join(dirname(page), path))
  return [...new Set([...inCode, ...linked])]
}

/** Whether a path exists; a name may have one `*`. */
function exists(path) {
  if (!path.includes('*')) return existsSync(join(ROOT, path))
  const [before, after] = path.slice(path.lastIndexOf('/') + 1).split('*')
  return readdirSync(join(ROOT, dirname(path))).some((name) => name.startsWith(before) && name.endsWith(after))
}

it.each(PAGES)('%s names files that exist', (page) => {
  const paths = pathsIn(page)
  if (page === 'ARCHITECTURE.md') expect(paths.length).toBeGreaterThan(60)
  expect(paths.filter((path) => !exists(path))).toEqual([])
})

/** Headers and sources that stand without their folder. */
it('ARCHITECTURE.md names headers and sources that exist', () => {
  const text = readFileSync(join(ROOT, 'ARCHITECTURE.md'), 'utf8')
  const names = new Set([...text.matchAll(/`(\w+\.(?:h|cpp|ts))`/g)].map(([, name]) => name))
  const all = new Set(
    ['cpp', 'web'].flatMap((folder) =>
      readdirSync(join(ROOT, folder), { recursive: true }).map((path) => path.slice(path.lastIndexOf('/') + 1)),
    ),
  )
  expect(names.size).toBeGreaterThan(5)
  expect([...names].filter((name) => !all.has(name))).toEqual([])
})

describe('a checklist', () => {
  const checklists = readFileSync(join(ROOT, 'ARCHITECTURE.md'), 'utf8').split(/^### /m).slice(1)
  it('is there for each kind of change, with its tests', () => {
    expect(checklists.map((text) => text.slice(0, text.indexOf('\n')))).toEqual([
      'To add a query',
      'To add a layer',
      'To add a file format',
      'To add an option of the program',
      'To add an option of compute',
    ])
    for (const text of checklists) expect(text).toMatch(/^Tests: .*`(?:tests|cpp\/python\/tests)\//m)
  })
})
