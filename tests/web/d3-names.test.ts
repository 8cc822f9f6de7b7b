// SPDX-License-Identifier: GPL-3.0-or-later
// The cookbook names the counterpart of each name of d3-delaunay.
import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { recipes } from '../readme/recipes.mjs'
import { library } from './library.ts'

const { Delaunay, Voronoi } = await import('d3-delaunay' as string)
const COOKBOOK = readFileSync(new URL('../../docs/cookbook.md', import.meta.url), 'utf8')
const [, same = '', table = ''] =
  /recognize\s+many names: ([^.]+)\.[^|]+\n\n(\| d3-delaunay [\s\S]+?)\n\n/.exec(COOKBOOK) ?? []
const diagram = library.compute(Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1))

it('shows five tasks in at most fifteen lines each', () => {
  const [, list = ''] = /Five frequent tasks take at most fifteen lines each: ([\s\S]+?)\n\n/.exec(COOKBOOK) ?? []
  const titles = Array.from(list.matchAll(/\]\(#([\w-]+)\)/g), ([, slug]) => slug as string)
  expect(titles).toHaveLength(5)
  for (const slug of titles) {
    const { code } = recipes().find(({ picture }) => picture.endsWith(`/${slug}.png`)) ?? { code: '' }
    expect(code, slug).not.toBe('')
    expect(code.trim().split('\n').length, slug).toBeLessThanOrEqual(15)
  }
})

it('knows each of its methods', () => {
  const methods = [Delaunay.prototype, Voronoi.prototype]
    .flatMap((methods) => Object.getOwnPropertyNames(methods))
    .filter((name) => !/^(_.*|constructor)$/.test(name))
  expect(methods).toContain('renderCell')
  expect(methods.filter((name) => !`${same}${table}`.match(new RegExp(`\\b${name}\\b`)))).toEqual([])
})

it('names what is there', () => {
  const names = [...same.matchAll(/`(\w+)`/g), ...table.matchAll(/\bdiagram\.(\w+)/g)].map(([, name]) => name as string)
  expect(names).toEqual(expect.arrayContaining(['update', 'cellPath', 'firstSide']))
  expect(names.filter((name) => !(name in diagram))).toEqual([])
  const ofLibrary = Array.from(table.matchAll(/\blibrary\.(\w+)/g), ([, name]) => name as string)
  expect(ofLibrary).not.toEqual([])
  expect(ofLibrary.filter((name) => !(name in library))).toEqual([])
})
