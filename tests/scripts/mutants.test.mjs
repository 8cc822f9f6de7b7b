// SPDX-License-Identifier: GPL-3.0-or-later
// The changes that `npm run mutate:core` makes fit the sources: a run, which takes an hour, can begin.
import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'

const ROOT = new URL('../../', import.meta.url)
const read = (path) => readFileSync(new URL(path, ROOT), 'utf8')

test('the text that a change replaces stands once in its file', () => {
  const misfits = JSON.parse(read('tests/mutants/core.json')).filter(
    ({ file, old }) => read(file).split(old).length !== 2,
  )
  expect(misfits.map(({ name }) => name)).toEqual([])
})
