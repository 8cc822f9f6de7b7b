// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that the C++ library includes headers only along the layers of cpp/src/CMakeLists.txt, and that it uses extensions
// of compilers only in the headers for them. CMake sees the folders of cpp/src, but all public headers are on every layer's
// include path.
import { execFileSync } from 'node:child_process'
import { existsSync, readFileSync } from 'node:fs'
import { isMain, main, ROOT } from './run.mjs'

/** Extensions of GCC and Clang, and the headers that have replacements for other compilers. */
const EXTENSION = /\[\[gnu::|\b__(?:attribute__|builtin_\w+|extension__|int128)\b/
const WITH_EXTENSIONS = /\/(?:base\/portable|circle_voronoi\/abi)\.h$/

/** Returns the layers that a CMake file declares, by name: their public headers, and the layers that each one sees. */
export function layersOf(cmake) {
  const layers = new Map()
  for (const [, call] of cmake.replaceAll(/#.*/g, '').matchAll(/^add_layer\(([^)]*)\)/gm)) {
    const [name, ...words] = call.trim().split(/\s+/)
    const lists = { ON: [], HEADERS: [] }
    let list = []
    for (const word of words) {
      if (/^[A-Z]+$/.test(word)) list = lists[word] ?? []
      else list.push(word)
    }
    const seen = new Set([name])
    for (const other of lists.ON) {
      const layer = layers.get(other)
      if (layer === undefined) throw new Error(`The layer ${name} is declared before ${other}, which it is on.`)
      for (const below of layer.seen) seen.add(below)
    }
    layers.set(name, { headers: lists.HEADERS, seen })
  }
  return layers
}

/**
 * Returns what is wrong with the includes and extensions of files, a sentence each. `files` maps paths to texts: of sources in
 * `cpp/src/LAYER/` and of public headers in `cpp/include/`.
 */
export function flawsOf(layers, files) {
  const flaws = []
  const layerOf = new Map()
  for (const [name, { headers }] of layers) {
    for (const header of headers) {
      const other = layerOf.get(header)
      if (other !== undefined) flaws.push(`${header} is a header of ${other} and of ${name}.`)
      if (!files.has(`cpp/include/${header}`)) flaws.push(`${header}, a header of ${name}, does not exist.`)
      layerOf.set(header, name)
    }
  }
  for (const path of files.keys()) {
    const [, layer, header] = /^cpp\/src\/(\w+)\/([\w.]+)$/.exec(path) ?? []
    if (layers.has(layer) && header.endsWith('.h')) layerOf.set(header, layer)
  }
  for (const [path, text] of files) {
    const [, folder] = /^cpp\/src\/(\w+)\//.exec(path) ?? []
    const layer = layers.has(folder) ? folder : layerOf.get(path.replace('cpp/include/', ''))
    if (layer === undefined) {
      flaws.push(`${path} belongs to no layer.`)
      continue
    }
    const extension = EXTENSION.exec(text)?.[0]
    if (extension !== undefined && !WITH_EXTENSIONS.test(path))
      flaws.push(`${path} uses ${extension}, which belongs in cpp/src/base/portable.h.`)
    for (const [, header] of text.matchAll(/^#include "([^"]+)"/gm)) {
      const other = layerOf.get(header)
      if (other === undefined) flaws.push(`${path} includes ${header}, which belongs to no layer.`)
      else if (!layers.get(layer).seen.has(other)) flaws.push(`${path} of ${layer} includes ${header} of ${other}.`)
    }
  }
  return flaws
}

if (isMain(import.meta.url)) {
  await main(() => {
    const names = execFileSync('git', ['ls-files', '-co', '--exclude-standard', 'cpp/src', 'cpp/include'], {
      cwd: ROOT,
      encoding: 'utf8',
    })
    const paths = names.split('\n').filter((name) => /\.(?:cpp|h)$/.test(name) && existsSync(ROOT + name))
    const files = new Map(paths.map((path) => [path, readFileSync(ROOT + path, 'utf8')]))
    const layers = layersOf(readFileSync(`${ROOT}cpp/src/CMakeLists.txt`, 'utf8'))
    const flaws = flawsOf(layers, files)
    if (flaws.length > 0) throw new Error(`These files do not follow the layers:\n${flaws.join('\n')}`)
    console.log(`The includes of ${files.size} C++ files follow ${layers.size} layers.`)
  })
}
