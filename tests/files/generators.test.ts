// SPDX-License-Identifier: GPL-3.0-or-later
// The page's generators give the same bits as the program.
import { execFileSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'
import { loadGenerators } from '../../web/app/generators/generators.ts'
import { circlesOfText } from '../../web/view/circle-text.ts'

const PROGRAM = fileURLToPath(new URL('../../build/native/circle-voronoi', import.meta.url))
const generators = await loadGenerators()
const { families, figures } = generators.catalogue()

it('there are the families of the program', () => {
  const lines = execFileSync(PROGRAM, ['generate', '--list'], { encoding: 'utf8' }).trim().split('\n')
  expect(families.map(({ name, description }) => `${name} ${description}`)).toEqual(
    lines.map((line) => line.replace(/ {2,}/, ' ')),
  )
})

it('they have the bits of the program', () => {
  for (const [k, { name }] of families.entries()) {
    const seed = k % 2 === 0 ? k : Number.MAX_SAFE_INTEGER - k
    const text = execFileSync(PROGRAM, ['generate', name, '123', '--seed', String(seed)], { encoding: 'utf8' })
    expect(generators.make({ kind: 'family', family: name, seed, count: 123 }), name).toEqual(circlesOfText(text))
  }
})

it('the figures that are of a family are its circles of seed 1', () => {
  const figure = (name: string) => generators.make({ kind: 'figure', figure: name })
  expect(figure('7b')).toEqual(generators.make({ kind: 'family', family: 'ring', seed: 1, count: 199 }))
  expect(figure('14')).toEqual(generators.make({ kind: 'family', family: 'uniform', seed: 1, count: 100_000 }))
  expect(figure('13a')).toEqual(figure('5d'))
  for (const number of [5, 6, 7, 9, 10, 11, 12, 13, 14, 15]) {
    expect(
      figures.some(({ name }) => Number.parseInt(name, 10) === number),
      String(number),
    ).toBe(true)
  }
})

it('what is none is refused by name', () => {
  expect(() => generators.make({ kind: 'family', family: 'nonsense', seed: 1, count: 3 })).toThrow(
    'There is no family "nonsense".',
  )
  expect(() => generators.make({ kind: 'figure', figure: '99' })).toThrow('There is no figure "99".')
})
