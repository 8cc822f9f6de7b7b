// SPDX-License-Identifier: GPL-3.0-or-later
import { readdirSync, readFileSync } from 'node:fs'
import { expect, it } from 'vitest'

const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')
const namesIn = (path, pattern) => new Set([...read(path).matchAll(new RegExp(pattern, 'g'))].map(([, name]) => name))
const CMAKE = read('CMakeLists.txt')
const VERSION = /project\(circle_voronoi VERSION ([\d.]+)/.exec(CMAKE)[1]

it('all files that carry the version have the same', () => {
  const versions = {
    'package.json': /"version": "([\d.]+)"/,
    'cpp/packaging/vcpkg/circle-voronoi/vcpkg.json': /"version": "([\d.]+)"/,
    'cpp/packaging/conda/meta.yaml': /version: "([\d.]+)"/,
    'docs/cpp.md': /GIT_TAG v([\d.]+)\)/,
    'examples/fetch_content/CMakeLists.txt': /\/v([\d.]+)\.tar\.gz/,
    'docs/javascript.md': /circle-voronoi-([\d.]+)\.tgz/,
  }
  for (const [path, pattern] of Object.entries(versions))
    expect([path, ...namesIn(path, pattern)]).toEqual([path, VERSION])
})

it('examples find the installed package, which is compatible with its own minor version alone', () => {
  const minor = VERSION.split('.').slice(0, 2).join('.')
  for (const path of ['docs/cpp.md', 'examples/find_package/CMakeLists.txt']) {
    expect([path, /find_package\(circle_voronoi ([\d.]+)/.exec(read(path))?.[1]]).toEqual([path, minor])
  }
})

it('recipes of package managers set options that exist', () => {
  const folder = 'cpp/packaging'
  const recipes = readdirSync(new URL(`../../${folder}`, import.meta.url), { recursive: true })
    .filter((name) => /\.(cmake|py|yaml)$/.test(name))
    .map((name) => `${folder}/${name}`)
  expect(recipes).toHaveLength(3)
  for (const path of recipes) {
    for (const [, name] of read(path).matchAll(/(CIRCLE_VORONOI_[A-Z_]+)/g)) {
      expect(CMAKE, `${path}: ${name}`).toMatch(new RegExp(`option\\(${name}\\b`))
    }
  }
})
