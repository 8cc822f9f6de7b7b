// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers in the chapters equal those that `npm run reproduce` has written into docs/results.md, or are counted
// here.
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { loadFigureCircles } from '../../scripts/texts/figure-circles.mjs'
import { readBook } from '../../scripts/texts/tutorial.mjs'
import { edgeCurve, pointAt, rationalBezier } from '../../web/lib/index.ts'
import { compare, loadPrintedRules } from '../../web/tutorial/printed-rules.ts'
import { library } from './library.ts'

const RESULTS = readFileSync(new URL('../../docs/results.md', import.meta.url), 'utf8')
const BOOK = readBook()
const FIGURES = BOOK.flatMap(({ blocks }) => blocks.map(({ spec }) => spec)).filter(({ name }) => name !== undefined)
const circlesOf = await loadFigureCircles()

/** Expects words in a chapter, ignoring line breaks. */
function expectSaid(number: number, words: string): void {
  expect(BOOK[number - 1]?.markdown.replace(/\s+/g, ' ')).toContain(words)
}

function figure(name: string) {
  const spec = FIGURES.find((each) => each.name === name)
  if (spec === undefined) throw new Error(`There is no figure ${name}.`)
  return spec
}

/** The numbers that a pattern matches in the results. */
function measured(pattern: RegExp): number[] {
  const found = pattern.exec(RESULTS)
  if (found === null) throw new Error(`docs/results.md has nothing like ${pattern}.`)
  return found.slice(1).map((text) => Number(text.replaceAll(',', '')))
}

/** The other cells of the first table row that begins with a text. */
function row(start: string, text = RESULTS): string[] {
  const line = text.split('\n').find((each) => each.startsWith(`| ${start}`))
  if (line === undefined) throw new Error(`docs/results.md has no row ${start}.`)
  return line
    .split('|')
    .slice(2, -1)
    .map((cell) => cell.trim())
}

const seconds = (time: string) => Number.parseFloat(time) * (/µs/.test(time) ? 1e-6 : /ms/.test(time) ? 1e-3 : 1)

test('chapter 2: a shorter piece of a hyperbola has a weight nearer to 1, and none less', () => {
  expectSaid(2, 'For hyperbolas $w$ is above 1')
  expect(figure('bezier-arc').answer).toMatch(/^It comes nearer to 1/)
  const { bisector } = edgeCurve(library.compute(Float64Array.of(0, 0, 3, 10, 1, 1, 4, 9, 2)), 0)
  const start = pointAt(bisector, 1)
  const weights = [8, 4, 2, 1.1].map(
    (to) => rationalBezier({ bisector, from: 1, to, start, end: pointAt(bisector, to) }).weight,
  )
  expect(weights).toEqual(weights.toSorted((a, b) => b - a))
  expect(weights.at(-1)).toBeGreaterThan(1)
  expect(weights.at(-1)).toBeLessThan(1.01)
})

describe('chapter 4', () => {
  test('of a thousand random circles about three thousand pairs of half a million have a border', () => {
    expectSaid(4, 'a thousand circles have half a million pairs, but only about three thousand borders')
    const borders = library.compute(circlesOf({ name: '', dataSet: 'uniform:1:1000' })).edges.length / 4
    expect(borders).toBeGreaterThan(2900)
    expect(borders).toBeLessThan(3000)
  })

  test('2 or 4 equally spaced samples join the two largest circles, 3 or 5 do not', () => {
    expect(figure('uniform-samples').ask).toContain('With 2 samples or 4 the two largest')
    const circles = circlesOf(figure('uniform-samples'))
    const areJoined = (samples: number) => {
      const trace = library.trace(circles, { candidates: 'uniform', samples })
      const pairs = [...trace.at(trace.length).pairs].map((k) => [...trace.event(k).circles].sort().join())
      return pairs.includes('0,1')
    }
    expect([2, 3, 4, 5].map(areJoined)).toEqual([true, false, true, false])
  })

  test('two neighbors are six steps apart among the centers', () => {
    expect(figure('layers-between').caption).toContain('from center to center it takes six steps')
    expect(measured(/its neighbor is (\d+) steps away/)).toEqual([6])
  })

  test('one pair of circles has several borders', () => {
    expectSaid(4, 'a pair of circles with several borders')
    const { edges } = library.compute(circlesOf(figure('several-edges')))
    const pairs = Array.from({ length: edges.length / 4 }, (_, e) => `${edges.slice(4 * e, 4 * e + 2).sort()}`)
    expect(new Set(pairs.filter((pair, e) => pairs.indexOf(pair) < e)).size).toBe(1)
  })
})

describe('chapter 6', () => {
  test('how many samples miss', () => {
    expectSaid(
      6,
      'more than half of the results are wrong with $N_s = 0$. With $N_s = 1$ it is about one in a hundred, and with $N_s = 3$ a few in a thousand',
    )
    const table = RESULTS.slice(RESULTS.indexOf('| family | as printed'))
    const [, none, one, three] = row('one-huge', table).map(Number.parseFloat) as [number, number, number, number]
    expect(none).toBeGreaterThan(50)
    expect(none).toBeLessThan(100)
    expect(one).toBeGreaterThanOrEqual(0.5)
    expect(one).toBeLessThan(2)
    expect(three).toBeGreaterThan(0)
    expect(three).toBeLessThan(0.5)
    // This family is the worst of all.
    const others = table.split('\n').filter((line) => /^\| [a-z-]+ \|( [^|]*\|){7}$/.test(line))
    expect(others.length).toBeGreaterThan(30)
    for (const line of others) expect(Number.parseFloat(line.split('|')[3] as string) || 0).toBeLessThanOrEqual(none)
  })

  test('the printed rules were tried on thousands of inputs, and a ring does not prove', () => {
    expectSaid(6, 'We tried them on thousands of random inputs')
    const [inputs = 0, families = 0] = [
      ...measured(/, (\d+) for the printed rules/),
      ...measured(/in \d+ of (\d+) families; in/),
    ]
    expect(inputs * families).toBeGreaterThan(2000)
    expectSaid(6, 'most of the wrong diagrams that were tried pass it')
    const [wrong = 0, passing = 0] = measured(/of (\d+) wrong diagrams (\d+) pass that check/)
    expect(passing).toBeGreaterThan(wrong / 2)
    expect(passing).toBeLessThan(wrong)
    expect(RESULTS).toContain('the certificate of this library accepts none of them')
  })

  test('three circles are enough', () => {
    expectSaid(6, 'Three circles are enough for the rule to take the wrong one')
    expect(measured(/smallest counterexample of this run[^:]*: (\d+) circles/)).toEqual([3])
    expect(figure('third-edge').circles).toHaveLength(3)
  })
})

describe('chapter 7', () => {
  test('how many edges there must be', () => {
    const { vertices, edges, hull } = library.compute(figure('corrupt').circles as number[][])
    expectSaid(7, 'Then there must be $2n - 2 - h$ vertices and $3n - 3 - h$ edges')
    expect([5, hull.length, vertices.length / 3, edges.length / 4]).toEqual([5, 4, 2 * 5 - 2 - 4, 3 * 5 - 3 - 4])
    expectSaid(7, 'Five circles with cells and four edges that go on forever, as above, have 3 · 5 − 3 − 4 = 8 edges')
  })
})

describe('chapter 8', () => {
  const ways = {
    auto: row('auto (this library'),
    dynamic: row('dynamic sampling, N_s = 1'),
    pairs: row('all pairs |'),
  }
  const exponent = (cells: readonly string[]) => Number(/^n\^([\d.]+)/.exec(cells.at(-1) as string)?.[1])

  test('how the times grow', () => {
    expectSaid(8, 'Twice as many circles take about twice the time, unless you try all pairs.')
    expect(exponent(ways.auto)).toBeLessThan(1.12)
    expectSaid(8, 'twice as many circles take more than four times the time')
    expect(2 ** exponent(ways.pairs)).toBeGreaterThan(4)
    expectSaid(8, 'about twelve samples per circle with $N_s = 1$; twice as many circles take about twice the time')
    expect(measured(/([\d.]+) a circle; n\^1\.0/)[0]).toBeCloseTo(12, 0)
    expect(2 ** exponent(ways.dynamic)).toBeCloseTo(2, 0)
  })

  test('flips take about a tenth of what samples take, and a hundred thousand circles a fraction of a second', () => {
    expectSaid(8, '| flips | about a tenth of the time that samples take |')
    for (const [k, time] of ways.auto.slice(0, -1).entries()) {
      const ratio = seconds(ways.dynamic[k] as string) / seconds(time)
      expect(ratio).toBeGreaterThan(7)
      expect(ratio).toBeLessThan(16)
    }
    expectSaid(8, '(figure 14 of the paper) take a fraction of a second')
    expect(seconds(ways.auto.at(-2) as string)).toBeLessThan(1)
  })

  test('an edit changes about seven cells, however many circles there are', () => {
    expectSaid(8, 'about seven cells change, among a hundred circles as among ten thousand')
    for (const count of [100, 10_000]) {
      const circles = circlesOf({ name: '', dataSet: `uniform:1:${count}` })
      const editor = library.edit(circles)
      const changes = Array.from({ length: 50 }, (_, k) => {
        const id = (k * count) / 50
        const [x, y, r] = circles[id] as [number, number, number]
        return editor.replace(id, { x: x + 0.3, y, r }).cells.length
      })
      editor.dispose()
      expect(changes.reduce((sum, n) => sum + n) / changes.length, `${count}`).toBeCloseTo(7, 0)
    }
  })
})

test('chapter 9: how many circles the data have', () => {
  for (const [name, count] of [
    ['bronze', 678],
    ['spruces', 134],
    ['waka', 504],
  ] as const) {
    expect(figure(name).caption).toContain(`${count} `)
    expect(circlesOf(figure(name))).toHaveLength(count)
  }
})

test('chapter 9: the widest gap between wires, with wires on all sides', () => {
  expect(figure('wires').answer).toContain('the disc there has a radius of 0.44')
  const { vertices } = library.compute(circlesOf(figure('wires')))
  const gaps = Array.from({ length: vertices.length / 3 }, (_, v) => [...vertices.slice(3 * v, 3 * v + 3)])
  const inside = gaps.filter(([x = 0, y = 0]) => Math.hypot(x, y) < 3.6).map(([, , r]) => r as number)
  expect(Math.max(...inside)).toBeCloseTo(0.44, 2)
  // The largest gap is at the lower left.
  const [x = 0, y = 0] = gaps.find(([, , r]) => r === Math.max(...inside)) ?? []
  expect([Math.sign(x), Math.sign(y)]).toEqual([-1, -1])
  // Gaps outside the bundle are larger.
  expect(Math.max(...gaps.map(([, , r]) => r as number))).toBeGreaterThan(2)
})

test('chapter 5: borders begin at vertices in its player, too, and a disc is thrown away for a circle', () => {
  const trace = library.trace(circlesOf(figure('whole-method')))
  const kinds = Array.from({ length: trace.length }, (_, k) => trace.event(k).kind)
  expect(kinds).toContain('antipodalDiscNotEmpty')
  const after = kinds.lastIndexOf('antipodalDiscAccepted')
  const begun = kinds.map((kind, k) => [kind, k] as const).filter(([kind]) => kind === 'branchDisc')
  const follows = begun.map(([, k]) => kinds.slice(k + 1, begun.find(([, next]) => next > k)?.[1]))
  expect(
    follows.some((events) => events.includes('directedEdgePlaced') && !events.includes('antipodalDiscAccepted')),
  ).toBe(true)
  expect(after).toBeGreaterThan(0)
})

test('chapter 13: four circles without a vertex', () => {
  expect(figure('exercise-vertices').answer).toContain(
    'Or put three small circles around a large one, far from each other',
  )
  const around = [0, 1, 2].map((k) => [4 * Math.cos((2 * Math.PI * k) / 3), 4 * Math.sin((2 * Math.PI * k) / 3), 0.2])
  const { vertices, edges } = library.compute([[0, 0, 3], ...around])
  expect([vertices.length / 3, edges.length / 4]).toEqual([0, 3])
})

test('chapter 6: the printed rule of the right side can fail where there are two vertices, and not where there is one', async () => {
  const rules = await loadPrintedRules()
  const [first, ...others] = circlesOf(figure('forward')) as number[][]
  const [x = 0, y = 0, r = 0] = first ?? []
  const seen = new Set<string>()
  for (let k = 0; k <= 40; k++) {
    for (const [u, v] of [
      [-0.45, -0.9],
      [-0.9, -0.4],
      [-0.3, -1],
    ] as const) {
      const circles = Float64Array.from([x + (u * k) / 20, y + (v * k) / 20, r, ...others.flat()])
      const diagram = library.compute(circles)
      const { wrong, missing } = compare(diagram, rules.run(circles, ['side']))
      seen.add(`${diagram.vertices.length / 3}: ${wrong.length + missing.length > 0 ? 'fails' : 'works'}`)
    }
  }
  expect(seen).toContain('2: fails')
  expect(seen).toContain('1: works')
  expect(seen).not.toContain('1: fails')
})

test('chapter 10: ten billion circles take more than a million megabytes', () => {
  expectSaid(10, 'they would take more than a million megabytes')
  const [, , , bytes] = row('10,000,000 |')
  expect(Number(bytes) * 1e10).toBeGreaterThan(1e12)
})

test('chapter 11: the middle cell of the honeycomb', () => {
  expect(figure('exercise-area').ask).toContain('has an area of 31.2.')
  expect(library.compute(circlesOf(figure('exercise-area'))).cellArea(0)).toBeCloseTo(31.2, 6)
})
