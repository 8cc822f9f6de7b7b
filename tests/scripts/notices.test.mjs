// SPDX-License-Identifier: GPL-3.0-or-later
// THIRD-PARTY-NOTICES.txt names each package that a bundle contains, with its license, and each library that C++ includes.
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { build } from 'esbuild'
import { expect, it } from 'vitest'

const ROOT = new URL('../..', import.meta.url).pathname
const ENTRIES = [
  ...['element/index', 'element/react', 'view/painter/start-thread', 'picture/index', 'picture/command'],
  ...[
    'lib/index',
    'lib/worker',
    'lib/files',
    'lib/regions',
    'lib/metrics',
    'lib/sphere',
    'lib/link',
    'lib/worker-thread',
  ],
  'cli/circle-voronoi',
]

/** A text with single spaces. */
const spaced = (text) => text.replace(/\s+/g, ' ').trim()
const notices = spaced(readFileSync(`${ROOT}THIRD-PARTY-NOTICES.txt`, 'utf8'))

it('names the packages in bundles, with their licenses', async () => {
  const { metafile } = await build({
    absWorkingDir: ROOT,
    bundle: true,
    write: false,
    metafile: true,
    format: 'esm',
    platform: 'node',
    outdir: 'unused',
    logLevel: 'error',
    entryPoints: ENTRIES.map((name) => `web/${name}.ts`),
    external: ['react', 'circle-voronoi/*'],
    plugins: [
      {
        name: 'others',
        setup: ({ onResolve }) => onResolve({ filter: /\?|\/generated\// }, () => ({ external: true })),
      },
    ],
  })
  const packages = new Set(
    Object.keys(metafile.inputs).flatMap((file) => /^node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(file)?.[1] ?? []),
  )
  expect(packages).toContain('lit-html')
  for (const name of packages) {
    expect(notices).toMatch(new RegExp(`(^|[ ,])${name}[,:]`))
    const [license] = readdirSync(`${ROOT}node_modules/${name}`).filter((file) => /^licen[sc]e/i.test(file))
    const text = readFileSync(join(ROOT, 'node_modules', name, license), 'utf8')
    for (const paragraph of text.split(/\n\s*\n/)) expect(notices, name).toContain(spaced(paragraph))
  }
})

it('names the libraries that C++ includes', () => {
  const sources = ['cpp/src', 'cpp/wasm', 'cpp/cli', 'cpp/include'].flatMap((folder) =>
    readdirSync(ROOT + folder, { recursive: true }).map((name) => join(ROOT, folder, name)),
  )
  const included = sources
    .filter((file) => /\.(h|cpp)$/.test(file) && existsSync(file))
    .flatMap((file) => Array.from(readFileSync(file, 'utf8').matchAll(/^#include <(\w+)\//gm), ([, folder]) => folder))
  const libraries = [...new Set(included)].filter((folder) => folder !== 'sys')
  expect(libraries).toContain('Eigen')
  for (const library of libraries) expect(notices).toContain(`(${library}):`)
})
