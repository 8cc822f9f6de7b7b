// SPDX-License-Identifier: GPL-3.0-or-later
// Statements of the tutorial that can be checked without a browser.
import { describe, expect, test } from 'vitest'
import { loadFigureCircles } from '../../scripts/texts/figure-circles.mjs'
import { renderMarkdown } from '../../scripts/texts/markdown.mjs'
import { readBook } from '../../scripts/texts/tutorial.mjs'
import { holds, idsOf, parseCheck } from '../../web/element/check.ts'
import { ENGLISH_GOALS, goalSentence, goalsOf } from '../../web/element/goals.ts'
import { distanceFrom } from '../../web/lib/base/metric.ts'
import { edgeCurve, isBoundedCurve } from '../../web/lib/index.ts'
import { countSamples, sentenceOf } from '../../web/tutorial/count-samples.ts'
import { compare, loadPrintedRules, RULES, type Rule, sentenceOf as whatOf } from '../../web/tutorial/printed-rules.ts'
import { layersFrom } from '../../web/view/layers.ts'
import { factsOf } from '../../web/view/painter/facts.ts'
import { library, seededRandom } from './library.ts'

const BOOK = readBook()
const BLOCKS = BOOK.flatMap(({ file, blocks }) => blocks.map((block) => ({ file, ...block })))
const figures = BLOCKS.filter(({ spec }) => spec.name !== undefined)

describe('what is to be reached', () => {
  test.each(figures.filter(({ kind }) => kind === 'try').map(({ spec }) => [spec.name, spec] as const))(
    '%s is not so at first, and is so of its answer',
    (_, { circles, solution, check }) => {
      const asked = parseCheck(JSON.stringify(check))
      const isSo = (circles: readonly (readonly number[])[]) => {
        const diagram = library.edit(circles).snapshot()
        const { hidden, vertices, edges } = diagram
        const counts = {
          circles: circles.length,
          hidden: hidden.length / 2,
          vertices: vertices.length / 3,
          edges: edges.length / 4,
        }
        const facts = factsOf({ diagram, limits: {} }, counts, idsOf(asked))
        // The reader is told a number with each goal.
        expect(goalSentence(goalsOf(asked, facts), ENGLISH_GOALS)).toMatch(/ (\d|∞).* (\d|∞)/)
        return holds(asked, facts)
      }
      expect(isSo(circles as number[][])).toBe(false)
      expect(isSo(solution)).toBe(true)
    },
  )
})

test('every question has one right answer among others, and every chapter has something to try', () => {
  for (const { file, spec } of BLOCKS.filter(({ kind }) => kind === 'question')) {
    expect(spec.choices.length, file).toBeGreaterThan(1)
    expect(spec.choices[spec.right], file).toBeDefined()
  }
  const asking = new Set(BLOCKS.filter(({ kind }) => kind === 'question' || kind === 'try').map(({ file }) => file))
  expect([...asking]).toEqual(BOOK.filter(({ isChapter }) => isChapter).map(({ file }) => file))
})

test('every figure comes with a question, a hint and an answer', () => {
  const unasked = BOOK.flatMap(({ blocks }) =>
    blocks.filter(({ spec: { name, ask, hint, answer } }, k) => {
      const isAsked = [ask, hint, answer].every((text) => text !== undefined) || blocks[k + 1]?.kind === 'question'
      return name !== undefined && !isAsked
    }),
  )
  expect(unasked.map(({ spec }) => spec.name)).toEqual([])
})

test('every term of the glossary is an entry', () => {
  const glossary = BOOK.find(({ file }) => file === 'glossary.html')?.markdown ?? ''
  const { html } = renderMarkdown(glossary)
  const terms = [...html.matchAll(/<dt>(.*?)<\/dt>/g)].map(([, term]) => term)
  expect(terms).toContain('hidden circle')
  // No paragraph but the introduction is left over.
  expect(html.match(/<p>/g)).toHaveLength(1)
})

test('figures draw what there is to be drawn', () => {
  for (const { spec } of figures) expect(layersFrom(spec.layers ?? {}), spec.name).toMatchObject(spec.layers ?? {})
})

describe('rules as printed', async () => {
  const [rules, circlesOf] = [await loadPrintedRules(), await loadFigureCircles()]
  const said = (circles: readonly (readonly number[])[], asPrinted: readonly Rule[]) => {
    const coordinates = Float64Array.from(circles.flat())
    return whatOf(compare(library.compute(coordinates), rules.run(coordinates, asPrinted)))
  }
  const SAME = 'As printed: the same diagram here.'
  const printed = figures.filter(({ kind }) => kind === 'printed').map(({ spec }) => [spec.name, spec] as const)

  test.each(printed)('%s goes wrong by the rules it names, and is right without them', (_, spec) => {
    const circles = spec.circles ?? circlesOf(spec as typeof spec & { dataSet: string })
    expect(said(circles, spec.rules)).not.toBe(SAME)
    expect(said(circles, [])).toBe(SAME)
    expect(said(circles, RULES)).not.toBe(SAME)
  })

  test('of random circles that cross many go wrong as printed, and hardly any once all rules are corrected', () => {
    const random = seededRandom(1)
    const inputs = Array.from({ length: 1000 }, () =>
      Array.from({ length: 4 }, () => [6 * random(), 4 * random(), 0.4 + 1.6 * random()]),
    ).filter((circles) => library.compute(circles).hidden.length === 0)
    const wrong = (asPrinted: readonly Rule[]) => inputs.filter((circles) => said(circles, asPrinted) !== SAME).length
    expect(inputs.length).toBeGreaterThan(500)
    expect(wrong(RULES) / inputs.length).toBeGreaterThan(0.3)
    expect(wrong([]) / inputs.length).toBeLessThan(0.01)
  })

  test('what goes wrong is counted', () => {
    const [, { circles = [] }] = printed.find(([name]) => name === 'third-edge') as (typeof printed)[number]
    expect(said(circles, ['third'])).toBe('As printed: 2 of 4 borders found, and 1 line where there is no border.')
  })

  test('of the four circles that cross, the first gets an edge with two others in places that the second covers', () => {
    const { circles = [], caption, answer } = printed.find(([name]) => name === 'crossing-antipodal')?.[1] ?? {}
    const diagram = library.compute(circles)
    const found = rules.run(diagram.circles, ['crossing'])
    const pairs = [...found.segmentCircles, ...found.leftoverCircles]
    // Each segment has two discs, at its start and its end.
    const begins = found.segmentDiscs.filter((_, k) => k % 6 < 3)
    const discs = [...begins, ...found.leftoverDiscs]
    const covered = Array.from({ length: pairs.length / 2 }, (_, k) => {
      const [x, y, r] = discs.slice(3 * k, 3 * k + 3) as [number, number, number]
      const by = [0, 1, 2, 3].filter((i) => distanceFrom(diagram, i, x, y) < r - 1e-9)
      return by.length === 0 ? '' : `${pairs.slice(2 * k, 2 * k + 2).sort()} by ${by}`
    })
    expect(new Set(covered)).toEqual(new Set(['', '0,3 by 1', '0,2 by 1']))
    expect(caption).toContain('Two pairs get an edge')
    expect(answer).toContain('with the one at the lower left and with the one at the right')
  })

  test('the changes that the captions ask for lead to the right diagram', () => {
    const circlesIn = (name: string) => (printed.find(([its]) => its === name)?.[1].circles ?? []).map((c) => [...c])
    const [[x, y, r], ...others] = circlesIn('forward') as [[number, number, number], ...number[][]]
    for (const distance of [3, 6, 30]) {
      for (let angle = 0; angle < 2 * Math.PI; angle += 0.05) {
        const circles = [[x + distance * Math.cos(angle), y + distance * Math.sin(angle), r], ...others]
        expect(said(circles, ['side'])).toBe(SAME)
        // A border that does not begin at an antipodal disc (parameter 1) leads to no vertex.
        const diagram = library.compute(circles)
        const curves = Array.from({ length: diagram.edges.length / 4 }, (_, e) => edgeCurve(diagram, e))
        const late = curves.filter(({ from, to }) => from < to && (from > 1 || to < 1))
        expect(late.filter(isBoundedCurve)).toEqual([])
      }
    }
    const [first, second, third] = circlesIn('third-edge') as [number[], number[], number[]]
    expect(said([first, second, [6, 0, third[2] as number]], ['third'])).toBe(SAME)
  })
})

test('in chapter 6 the pair is missed without samples between, and found with one', () => {
  const circles = figures.find(({ spec }) => spec.name === 'missed')?.spec.circles ?? []
  const found = [0, 1, 2].map((samples) => library.compute(circles, { method: 'touching-disc', samples }))
  expect(found.map(({ certificate }) => certificate.certified)).toEqual([false, true, true])
})

test('chapter 4 counts the samples of Table 1', async () => {
  const circlesOf = await loadFigureCircles()
  const said = (dataSet: string) =>
    sentenceOf(countSamples(library, Float64Array.from(circlesOf({ name: dataSet, dataSet }).flat()), 3))
  expect(said('figure-7a')).toBe('192 samples on the largest circle, 9 on each other one, 12.735 on average.')
  expect(said('figure-7b')).toBe('792 samples on the largest circle, 9 on each other one, 12.935 on average.')
  // The largest circle may be anywhere.
  const circles = circlesOf({ name: 'figure-7a', dataSet: 'figure-7a' })
  const counts = [circles, circles.toReversed()].map((list) => countSamples(library, Float64Array.from(list.flat()), 3))
  expect(counts[1]).toEqual(counts[0])
})
