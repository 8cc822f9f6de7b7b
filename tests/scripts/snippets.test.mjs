// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { readmeSnippets, snippets } from '../readme/snippets.mjs'

const MARKDOWN = `# Title

\`\`\`sh
before
\`\`\`

## Use

Text.

\`\`\`js
# no heading
one()

two()
\`\`\`

### In detail

\`\`\`\`cpp
\`\`\`
three();
\`\`\`\`

## After

\`\`\`js
after()
\`\`\`
`

it('finds the code under a heading and the headings below it', () => {
  expect(snippets(MARKDOWN, 'Use')).toEqual([
    { language: 'js', code: '# no heading\none()\n\ntwo()\n', line: 12 },
    { language: 'cpp', code: '```\nthree();\n', line: 21 },
  ])
})

it('refuses a heading that has no code', () => {
  expect(() => snippets(MARKDOWN, 'Absent')).toThrow('"Absent"')
  expect(() => snippets('## Use\n\nText.\n', 'Use')).toThrow('"Use"')
})

it('reads README.md', () => {
  expect(readmeSnippets('In Node')[0]).toMatchObject({ language: 'js' })
})
