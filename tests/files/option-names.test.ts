// SPDX-License-Identifier: GPL-3.0-or-later
// Options and their values have the same names in TypeScript, in the core, and on the command line, which takes them
// from cpp/options/option_names.h. tests/cpp/cli_documentation_test.cpp compares the manual with the command line.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { CIRCLE_FORMATS, DIAGRAM_FORMATS, type DiagramFileOptions, loadFiles } from '../../web/lib/files.ts'
import { type Flaw, METRICS, type Options, type Way } from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { library } from '../web/library.ts'

const HELP = execFileSync(
  new URL('../../build/native/circle-voronoi', import.meta.url).pathname,
  ['compute', '--help'],
  {
    encoding: 'utf8',
  },
)
const CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)

// These tables do not compile if a name is missing or superfluous.
const OPTIONS: Record<keyof Options, unknown> = {
  weights: true,
  method: 'touching-disc',
  candidates: 'dynamic',
  samples: 1,
  resample: true,
  progress: () => {},
}
const METHODS: Record<NonNullable<Options['method']>, true> = { auto: true, 'touching-disc': true, flip: true }
const CANDIDATES: Record<NonNullable<Options['candidates']>, true> = { dynamic: true, uniform: true, 'all-pairs': true }
const WAYS: Record<Way, true> = {
  flip: true,
  repair: true,
  insert: true,
  'touching-disc': true,
  edit: true,
}
const FLAWS: Record<Flaw, true> = {
  none: true,
  notJudged: true,
  badIndex: true,
  hiddenWithoutHider: true,
  adjacency: true,
  eulerCount: true,
  vertexWithoutDisc: true,
  vertexMisplaced: true,
  edgeOutOfOrder: true,
  cellNotClosed: true,
  hullNotClosed: true,
}
const FILE_OPTIONS: Record<keyof DiagramFileOptions, string | undefined> = {
  format: '--format',
  // Drawing functions accept a polygon, so that the option is called `region` there.
  bounds: '--bounds',
  region: '--region',
  maxDistance: '--max-distance',
  tolerance: '--tolerance',
  digits: '--digits',
  // The command line takes attributes from the input.
  attributes: undefined,
}

/** The words that an option accepts. */
function choicesOf(option: string): string[] {
  return new RegExp(`^  ${option} [A-Z]+:\\{([^}]*)\\}`, 'm').exec(HELP)?.[1]?.split(',').sort() ?? []
}

function messageOf(act: () => unknown): string {
  try {
    act()
  } catch (error) {
    return (error as Error).message
  }
  return ''
}

/** The names in an error message after some words. */
function listedAfter(words: string, message: string): string[] {
  expect(message).toContain(words)
  return message.slice(message.indexOf(words) + words.length, -1).split(/, | and | or /)
}

it('the options of compute are those of the command line and of the core, with the same values', () => {
  const unknown = messageOf(() => library.trace(CIRCLES, { sample: 1 } as object))
  expect(listedAfter('its options are ', unknown)).toEqual([...Object.keys(OPTIONS), 'edits'])
  // On the command line, each stage of progress is a line.
  for (const name of Object.keys(OPTIONS)) expect(HELP).toMatch(new RegExp(`^  --${name}[ \\n]`, 'm'))
  for (const [name, values] of Object.entries({ method: METHODS, candidates: CANDIDATES })) {
    expect(choicesOf(`--${name}`)).toEqual(Object.keys(values).sort())
    const refused = messageOf(() => library.compute(CIRCLES, { [name]: 'none' }))
    expect(listedAfter(`Unknown ${name}: the choice is `, refused)).toEqual(Object.keys(values))
    for (const value of Object.keys(values)) {
      const options = { method: 'touching-disc', [name]: value } as Options
      expect(library.compute(CIRCLES, options).stats).toMatchObject({ [name]: value })
    }
  }
  // The core accepts all options.
  expect(library.compute(CIRCLES, OPTIONS as Options)).toMatchObject({
    weights: true,
    stats: { candidates: 'dynamic' },
  })
})

it('the metrics are those of the command line', async () => {
  expect(choicesOf('--metric')).toEqual([...METRICS].sort())
  const { compute } = await loadMetrics({ library })
  const refused = messageOf(() => compute(CIRCLES, { metric: 'none' as 'power' }))
  expect(listedAfter('Unknown metric: the choice is ', refused)).toEqual(METRICS)
})

it('flaws and ways in results are those of the C++ headers', () => {
  const header = (name: string) =>
    readFileSync(new URL(`../../cpp/include/circle_voronoi/${name}.h`, import.meta.url), 'utf8')
  /** The values of an enumeration, without their descriptions. */
  const valuesOf = (name: string, text: string) =>
    (new RegExp(`enum class ${name} \\{([^}]*)\\}`).exec(text)?.[1] ?? '')
      .replace(/\/\/.*/g, '')
      .split(',')
      .map((value) => value.trim())
      .filter((value) => value !== '')
  const hyphenated = (name: string) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)
  expect(Object.keys(FLAWS)).toEqual(valuesOf('Flaw', header('certificate')))
  expect(Object.keys(WAYS)).toEqual(valuesOf('Way', header('method')).map(hyphenated))
  // A valid diagram and an invalid one produce these values.
  const diagram = library.compute(CIRCLES)
  expect(WAYS[diagram.stats.way as Way]).toBe(true)
  expect(library.edit(CIRCLES).snapshot().stats).toMatchObject({ method: 'auto', way: 'edit', candidates: '' })
  const { flaw } = library.certify({ ...diagram, hull: Int32Array.of(0, 1) })
  expect(FLAWS[flaw]).toBe(true)
  expect([flaw, diagram.certificate.flaw]).toEqual([expect.not.stringMatching('none'), 'none'])
})

it('the options and formats of files are those of the command line', async () => {
  const files = await loadFiles()
  const unknown = messageOf(() => files.writeDiagram(library.compute(CIRCLES), { form: 'svg' } as object))
  expect(listedAfter('its options are ', unknown)).toEqual(Object.keys(FILE_OPTIONS))
  for (const flag of Object.values(FILE_OPTIONS)) if (flag) expect(HELP).toMatch(new RegExp(`^  ${flag} `, 'm'))
  expect(choicesOf('--format')).toEqual([...DIAGRAM_FORMATS].sort())
  expect(DIAGRAM_FORMATS).toEqual(expect.arrayContaining([...CIRCLE_FORMATS]))
})
