// SPDX-License-Identifier: GPL-3.0-or-later
// The recipes of docs/cookbook.md: pages with a picture each, and scripts. What they import is in a folder `node_modules`.
import { existsSync, mkdirSync, readFileSync, symlinkSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { slugOf } from '../../scripts/texts/markdown.mjs'
import { blocksOfMarkdown } from './blocks.mjs'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
/** What recipes use besides this library. */
const OTHERS = ['d3-delaunay', 'd3-selection', 'leaflet']

/** @returns {(import('./blocks.mjs').Block & { title: string, picture: string })[]} `picture`: its file, if it is a page */
export function recipes() {
  return blocksOfMarkdown('docs/cookbook.md', readFileSync(`${ROOT}docs/cookbook.md`, 'utf8')).map((block) => {
    const title = block.headings.at(-1)
    return { ...block, title, picture: `docs/cookbook/${slugOf(title)}.png` }
  })
}

/** Puts what recipes import into a project's folder; the library itself only where it is not installed. */
export function addModules(folder) {
  const modules = join(folder, 'node_modules')
  mkdirSync(modules, { recursive: true })
  for (const name of OTHERS) symlinkSync(join(ROOT, 'node_modules', name), join(modules, name))
  if (existsSync(join(modules, 'circle-voronoi'))) return
  mkdirSync(join(modules, 'circle-voronoi'))
  symlinkSync(join(ROOT, 'dist'), join(modules, 'circle-voronoi/dist'))
}

/** A whole page around a recipe. */
export function pageOf(code) {
  return `<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>Recipe</title><body style="margin: 0">\n${code}`
}

/** Pages may have styles in attributes, as Leaflet and these recipes do. */
export const POLICY =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval' 'unsafe-inline'; style-src 'self' 'unsafe-inline'; img-src 'self' data:"
