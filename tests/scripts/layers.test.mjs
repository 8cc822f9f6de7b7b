// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { flawsOf, layersOf } from '../../scripts/layers.mjs'

const CMAKE = `
# Below all.
add_layer(base HOT HEADERS voronoi/error.h SOURCES
  error.cpp)
add_layer(dual ON base  # half-edges
  HEADERS
  voronoi/dual.h
  SOURCES
  flip.cpp)
add_layer(judge HOT ON dual SOURCES
  judge.cpp)
add_layer(io ON base SOURCES
  read.cpp)
set(core base dual judge)
`
const FILES = {
  'cpp/include/voronoi/error.h': '#pragma once\n#include <string>\n',
  'cpp/include/voronoi/dual.h': '#include "voronoi/error.h"\n',
  'cpp/src/base/names.h': '',
  'cpp/src/dual/flip.h': '#include "voronoi/dual.h"\n',
  'cpp/src/judge/judge.cpp': '#include "flip.h"\n#include "names.h"\n// #include "read.h"\n',
  'cpp/src/io/read.h': '#include "voronoi/error.h"\n',
}

const flawsWith = (changes) => flawsOf(layersOf(CMAKE), new Map(Object.entries({ ...FILES, ...changes })))

it('reads what each layer sees, and its public headers', () => {
  const layers = layersOf(CMAKE)
  expect([...layers.keys()]).toEqual(['base', 'dual', 'judge', 'io'])
  expect([...layers.get('judge').seen].sort()).toEqual(['base', 'dual', 'judge'])
  expect([...layers.get('io').seen].sort()).toEqual(['base', 'io'])
  expect(layers.get('dual').headers).toEqual(['voronoi/dual.h'])
})

it('refuses a layer on a layer that is declared later', () => {
  expect(() => layersOf('add_layer(dual ON base SOURCES a.cpp)\nadd_layer(base SOURCES b.cpp)')).toThrow(
    'The layer dual is declared before base',
  )
})

describe('the includes of a library', () => {
  it('may lead to layers below, also over several', () => {
    expect(flawsWith({})).toEqual([])
  })

  it('may belong to files with extensions of compilers, if they are for all others', () => {
    expect(flawsWith({ 'cpp/src/base/portable.h': 'inline void f() { __builtin_trap(); }\n' })).toEqual([])
  })

  it.each([
    ['a source that includes a header of a layer above', { 'cpp/src/base/a.cpp': '#include "flip.h"\n' }],
    [
      'a source that includes a header of a layer beside it',
      { 'cpp/src/io/a.cpp': '#include "names.h"\n#include "flip.h"\n' },
    ],
    [
      'a public header that includes one of a layer above',
      { 'cpp/include/voronoi/error.h': '#include "voronoi/dual.h"\n' },
    ],
    ['a source that includes a public header of a layer above', { 'cpp/src/base/a.h': '#include "voronoi/dual.h"\n' }],
    ['a public header without a layer', { 'cpp/include/voronoi/new.h': '' }],
    ['an include of an unknown header', { 'cpp/src/io/a.cpp': '#include "nowhere.h"\n' }],
    ['a source outside of all layers', { 'cpp/src/lost/a.cpp': '' }],
    ['a source that uses an extension of a compiler', { 'cpp/src/io/a.cpp': 'void f() { __builtin_trap(); }\n' }],
  ])('are refused for %s', (_, changes) => {
    const flaws = flawsWith(changes)
    expect(flaws).toHaveLength(1)
    expect(flaws[0]).toContain(Object.keys(changes)[0])
  })

  it('are refused if a public header is missing or has two layers', () => {
    const files = new Map(Object.entries(FILES))
    files.delete('cpp/include/voronoi/dual.h')
    files.delete('cpp/src/dual/flip.h')
    files.delete('cpp/src/judge/judge.cpp')
    expect(flawsOf(layersOf(CMAKE), files)).toEqual(['voronoi/dual.h, a header of dual, does not exist.'])
    const twice = CMAKE.replace('add_layer(io ON base', 'add_layer(io ON base HEADERS voronoi/error.h')
    expect(flawsOf(layersOf(twice), new Map(Object.entries(FILES)))).toContain(
      'voronoi/error.h is a header of base and of io.',
    )
  })
})
