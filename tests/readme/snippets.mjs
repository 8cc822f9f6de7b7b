// SPDX-License-Identifier: GPL-3.0-or-later
// The code that a Markdown file shows, for the tests that run it.
import { readFileSync } from 'node:fs'

const README = new URL('../../README.md', import.meta.url)

/** The code of README.md under one heading, as `snippets` gives it. */
export function readmeSnippets(heading) {
  return snippets(readFileSync(README, 'utf8'), heading)
}

/**
 * The fenced code blocks under a heading, in order, up to the next heading of the same or a higher level: the language
 * after the fence, the code, and the line of the file on which it begins. Throws if there is no such heading, or none of
 * them: a test of the code that is shown must not pass because nothing was found.
 */
export function snippets(markdown, heading) {
  const found = []
  let level = 0
  let fence
  let inside = false
  for (const [i, line] of markdown.split('\n').entries()) {
    if (fence !== undefined) {
      if (line.trim() === fence) fence = undefined
      else if (inside) found.at(-1).code += `${line}\n`
      continue
    }
    const [, marks, title] = /^(#+)\s+(.*?)\s*$/.exec(line) ?? []
    if (marks !== undefined) {
      if (!inside) level = marks.length
      inside = title === heading || (inside && marks.length > level)
      continue
    }
    const [, ticks, language] = /^(`{3,})\s*(\S*)/.exec(line) ?? []
    if (ticks !== undefined) {
      fence = ticks
      if (inside) found.push({ language, code: '', line: i + 2 })
    }
  }
  if (found.length === 0) throw new Error(`There is no code under a heading "${heading}".`)
  return found
}
