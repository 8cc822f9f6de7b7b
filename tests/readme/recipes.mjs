// SPDX-License-Identifier: GPL-3.0-or-later
// The recipes of docs/cookbook.md: pages and scripts, with a picture each. They import from a folder `node_modules`.
import { existsSync, mkdirSync, readFileSync, symlinkSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { build } from 'esbuild'
import { slugOf } from '../../scripts/texts/markdown.mjs'
import { blocksOfMarkdown } from './blocks.mjs'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
/** Further libraries that recipes use. */
export const OTHERS = ['d3-array', 'd3-delaunay', 'd3-geo', 'd3-selection', 'internmap', 'leaflet']

/** @returns {(import('./blocks.mjs').Block & { title: string, picture: string })[]} `picture` is its file */
export function recipes() {
  return blocksOfMarkdown('docs/cookbook.md', readFileSync(`${ROOT}docs/cookbook.md`, 'utf8')).map((block) => {
    const title = block.headings.at(-1)
    return { ...block, title, picture: `docs/cookbook/${slugOf(title)}.png` }
  })
}

/** Links the imports of recipes into a project's folder, and the library unless it is installed. */
export function addModules(folder) {
  const modules = join(folder, 'node_modules')
  mkdirSync(modules, { recursive: true })
  for (const name of OTHERS) symlinkSync(join(ROOT, 'node_modules', name), join(modules, name))
  if (existsSync(join(modules, 'circle-voronoi'))) return
  mkdirSync(join(modules, 'circle-voronoi'))
  for (const name of ['dist', 'package.json']) symlinkSync(join(ROOT, name), join(modules, 'circle-voronoi', name))
}

/** Completes a recipe to a page. */
export function pageOf(code) {
  return `<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>Recipe</title><body style="margin: 0">\n${code}`
}

/** Makes a page of a React component that shows a diagram. */
export async function pageOfComponent(code) {
  const contents = `${code}
    import { createRoot } from 'react-dom/client'
    import { loadCircleVoronoi } from './node_modules/circle-voronoi/dist/lib/index.js'
    const { compute } = await loadCircleVoronoi()
    const diagram = compute([[90, 90, 50], [240, 70, 20], [380, 120, 40], [180, 220, 35]])
    createRoot(document.getElementById('root')).render(<Cells diagram={diagram} />)`
  const { outputFiles } = await build({
    stdin: { contents, loader: 'jsx', resolveDir: ROOT },
    jsx: 'automatic',
    bundle: true,
    minify: true,
    format: 'esm',
    define: { 'process.env.NODE_ENV': '"production"' },
    external: ['./node_modules/circle-voronoi/*'],
    write: false,
  })
  return pageOf(`<div id="root"></div><script type="module">${outputFiles[0].text}</script>`)
}

/** Replaces the element in a notebook's output by that of the folder's own modules. */
export function withOwnElement(html) {
  return html.replace('https://example.com/circle-voronoi/', './node_modules/circle-voronoi/')
}

/** Allows style attributes, which Leaflet and these recipes use. */
export const POLICY =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval' 'unsafe-inline'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; worker-src 'self' blob:"
