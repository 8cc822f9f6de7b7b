// SPDX-License-Identifier: GPL-3.0-or-later
// The code of docs/embedding.md, as a reader would use it.
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { blocksRunBy } from '../readme/blocks.mjs'
import { Project, ROOT } from './project.mjs'

const BLOCKS = blocksRunBy('tests/pack/embedding.spec.ts')
const below = (heading: string) => BLOCKS.filter(({ headings }) => headings.at(-1) === heading).map(({ code }) => code)

test('a script in Node writes the link of a question', () => {
  const project = new Project()
  const [code] = below('Questions in a frame') as [string]
  project.write('question.js', code)
  expect(project.run(process.execPath, 'question.js')).toBe('v1.\n')
  project.remove()
})

test('the script of the page around a frame is that of the example', () => {
  const [code] = below('A frame that talks to its page') as [string]
  expect(readFileSync(join(ROOT, 'examples/element/question-frame/host.js'), 'utf8')).toContain(code)
})
