// SPDX-License-Identifier: GPL-3.0-or-later
// A small site generator: it turns page.md into index.html in a folder.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import markdownIt from 'markdown-it'

const here = (name) => new URL(name, import.meta.url)

/** Writes the page. `module` is the address of circle-voronoi/element. */
export function buildSite(folder, module) {
  mkdirSync(folder, { recursive: true })
  copyFileSync(here('trees.csv'), `${folder}/trees.csv`)
  const body = markdownIt({ html: true }).render(readFileSync(here('page.md'), 'utf8'))
  writeFileSync(
    `${folder}/index.html`,
    `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>A page in Markdown</title>
<link rel="icon" href="data:,">
<script type="module" src="${module}"></script>
${body}</html>
`,
  )
}
