// SPDX-License-Identifier: GPL-3.0-or-later
// The recipes of docs/put-it-into.md. Each tool has several files, whose names stand above them.
import { readFileSync } from 'node:fs'

const TEXT = new URL('../../docs/put-it-into.md', import.meta.url)

/**
 * The files of the recipe below a heading.
 * @param {readonly import('./blocks.mjs').Block[]} blocks the page's blocks that a test runs
 * @param {string} heading
 * @returns {Record<string, string>} the texts by their paths
 */
export function recipeOf(blocks, heading) {
  const lines = readFileSync(TEXT, 'utf8').split('\n')
  const own = blocks.filter(({ headings }) => headings.at(-1) === heading)
  if (own.length === 0) throw new Error(`There is no recipe for ${heading}.`)
  return Object.fromEntries(
    own.map(({ line, code }) => {
      // Before the block are the fence, an empty line, and the name.
      const [, path] = /^`(.+)`:$/.exec(lines[line - 4]) ?? []
      if (path === undefined) throw new Error(`The block at line ${line} has no name.`)
      return [path, code]
    }),
  )
}
