// SPDX-License-Identifier: GPL-3.0-or-later
// The parsers of the element for attributes, data and checks; and its manifest.
import { readFileSync } from 'node:fs'
import { afterEach, describe, expect, test, vi } from 'vitest'
import { manifest } from '../../scripts/manifest.mjs'
import {
  parseControls,
  parseLayers,
  parseMethod,
  parseRegion,
  parseSamples,
  parseStep,
  parseView,
} from '../../web/element/attributes.ts'
import { checkCircles, holds, idsOf, parseCheck, withIds } from '../../web/element/check.ts'
import { CircleVoronoiElement } from '../../web/element/circle-voronoi-element.ts'
import { regionAt, requestAt } from '../../web/element/data-of.ts'
import { ENGLISH_GOALS, goalRings, goalSentence, goalsOf } from '../../web/element/goals.ts'
import { loadWords, wordsOf } from '../../web/element/language.ts'
import { circlesOfMarkdown, readCircles } from '../../web/element/read-circles.ts'
import { type ElementRefusals, ENGLISH } from '../../web/element/refusals.ts'
import type { Edit } from '../../web/lib/index.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { questionAfter } from '../../web/player/prediction.ts'
import { sentenceOf } from '../../web/player/sentences.ts'
import { stepsOf } from '../../web/player/steps.ts'
import { ENGLISH_PLAYER, type PlayerWords } from '../../web/player/words.ts'
import { CELL_COLORS, DEFAULT_LAYERS, keptLayers } from '../../web/view/layers.ts'
import type { CellFacts, Facts } from '../../web/view/protocol.ts'
import { Refusal } from '../../web/view/refusal.ts'
import { library } from './library.ts'

const read = (path: string) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')

describe('circles', () => {
  test('as the arrays of a diagram are written', () => {
    expect(readCircles('{"circles": [0, 0, 1, 5, 0, 2]}').circles).toEqual(Float64Array.of(0, 0, 1, 5, 0, 2))
    expect(readCircles('[]').circles).toHaveLength(0)
  })

  test('in a Markdown table have bars around them or not', () => {
    const circles = Float64Array.of(1, 2, 3, 4, 5, 6)
    for (const text of [
      '| x | y | r |\n|---|:-:|--:|\n| 1 | 2 | 3 |\n| 4 | 5 | 6 |',
      'x | y | r\n--- | --- | ---\n1|2|3\n4|5|6',
    ]) {
      expect(circlesOfMarkdown(text).circles).toEqual(circles)
    }
    for (const end of ['\n', '\r\n', '\r']) expect(circlesOfMarkdown(`|1|2|3|${end}|4|5|6|`).circles).toEqual(circles)
    // The bars separate the numbers, so commas are decimal marks.
    expect(circlesOfMarkdown('|1,5|2|3|\n|4|5|6,25|').circles).toEqual(Float64Array.of(1.5, 2, 3, 4, 5, 6.25))
  })

  test.each([
    ['', 0],
    ['x,y,r\n', 0],
    ['1,2,3\n4,5\n', 2],
    ['name,x,y,r\r\n"a\r\nb",1,2,3\r\nc,4,5\r\n', 4],
    ['1,2,3,4\n', 1],
    ['x,y,r\n1,2,0x10\n', 2],
    ['1,2,Infinity\n', 1],
    ['[[1, 2]]', 0],
    ['[1, 2]', 0],
    ['{"circles": [1, 2]}', 0],
    ['{"circles": 7}', 0],
    ['[[1, 2, 3]', 0],
    ['{"type": "FeatureCollection", "features": [null]}', 0],
  ])('%j is refused, by its line if one is wrong: %d', (text, line) => {
    expect(() => readCircles(text)).toThrow(line === 0 ? /./ : `Line ${line} `)
  })
})

describe('circles at an address', () => {
  const { signal } = new AbortController()
  const asked: unknown[][] = []
  const gives = (text: string, status = 200) =>
    vi.stubGlobal('fetch', async (...args: unknown[]) => {
      asked.push(args)
      return new Response(text, { status })
    })
  afterEach(() => {
    vi.unstubAllGlobals()
    asked.length = 0
  })
  const THREE = Float64Array.of(0, 0, 1, 5, 0, 2, 0, 5, 1)

  test('are a file, a file that holds a link, or a link of the playground itself', async () => {
    const link = await encodeLink({ circles: THREE, step: 2 })
    gives('x,y,r,name\n0,0,1,A\n5,0,2,B\n0,5,1,C\n')
    const table = await requestAt('a.csv', signal)
    expect(table).toMatchObject({ circles: THREE, attributes: { columns: [{ name: 'name' }] } })
    expect(asked).toEqual([['a.csv', { signal }]])
    gives('[[0, 0, 1], [5, 0, 2], [0, 5, 1]]')
    expect(await requestAt('a.json', signal)).toEqual({ circles: THREE, dataSet: '', isEdited: false })
    for (const text of [link, `https://example.org/#${link}\n`]) {
      gives(text)
      expect(await requestAt('a.txt', signal)).toMatchObject({ circles: THREE, step: 2 })
    }
    asked.length = 0
    expect(await requestAt(`https://example.org/page.html#${link}`, signal)).toMatchObject({ circles: THREE, step: 2 })
    expect(asked).toEqual([])
  })

  test('that cannot be read are bad input, which says of what file, in any language', async () => {
    const others = { ...ENGLISH, notLoaded: () => 'Sorry', within: () => 'Sorry' }
    for (const [text, status] of [
      ['', 404],
      ['1,2\n', 200],
      ['x,y,r\n', 200],
    ] as const) {
      gives(text, status)
      const error = await requestAt('a.csv', signal).catch((error: Refusal<ElementRefusals>) => error)
      expect(error).toBeInstanceOf(Refusal)
      const { code, say } = error as Refusal<ElementRefusals>
      expect([code, (error as Error).message]).toEqual(['badInput', expect.stringContaining('a.csv')])
      expect(say(others)).toBe('Sorry')
    }
  })

  test('of a region are text or at an address beside the page', async () => {
    const square = 'POLYGON ((0 0, 1 0, 1 1, 0 1))'
    gives(square)
    expect(await regionAt('b.wkt', signal)).toEqual(parseRegion(square))
    expect(asked).toEqual([['b.wkt', { signal }]])
    expect(parseRegion('b.wkt')).toBe('b.wkt')
    gives('', 500)
    await expect(regionAt('b.wkt', signal)).rejects.toMatchObject({ code: 'badInput' })
  })
})

describe('attributes', () => {
  test('layers are words or JSON', () => {
    expect(parseLayers('hull  no-edges,cells=degree max-distance=2')).toEqual({
      ...DEFAULT_LAYERS,
      hull: true,
      edges: false,
      cells: 'degree',
      maxDistance: 2,
    })
    expect(parseLayers('no-cells sample-graph')).toEqual({ ...DEFAULT_LAYERS, cells: 'none', sampleGraph: true })
    expect(parseLayers('{"dual": true}')).toEqual({ ...DEFAULT_LAYERS, dual: true })
    expect(parseLayers('')).toEqual(DEFAULT_LAYERS)
  })

  test.each([
    ...['nonsense', 'hull=2', 'no-nearZero', 'cells', 'max-distance', 'path', '__proto__', 'cells=blue'],
    ...['max-distance=far', 'near-zero=-1', '{"dsic": true}', '{"dual"'],
  ])('layers are not %s', (word) => {
    expect(() => parseLayers(word)).toThrow(expect.objectContaining({ code: 'badInput' }))
    expect(() => parseLayers(`hull ${word}`)).toThrow()
  })

  test.each([
    [parseMethod, 'flip', 'flip', ['magic']],
    [parseSamples, '3', 3, ['', 'many', '-1', '1.5']],
    [parseView, '1, -2.5  4', { x: 1, y: -2.5, span: 4 }, ['', '1 2', '1 2 0', '1 2 -3', '1 2 3 4', 'a b c']],
    [parseStep, ' 12 ', 12, ['', 'last', '-1', '1.5', '1e300']],
  ] as const)('%O of %j is %j, and others are refused', (parse, text, value, wrong) => {
    expect(parse(text)).toEqual(value)
    for (const other of wrong) expect(() => parse(other)).toThrow(Refusal)
  })

  test('controls are buttons, the player or both', () => {
    const both = (text: string) => Object.values(parseControls(text))
    for (const text of ['', 'controls', 'true']) expect(both(text)).toEqual([true, false])
    expect(both('player')).toEqual([false, true])
    expect(both(' buttons  player ')).toEqual([true, true])
    for (const text of ['buttns', 'player buttns', 'false', 'true player']) {
      expect(() => parseControls(text)).toThrow(Refusal)
    }
  })
})

describe('what it says', () => {
  test('is in the language of its page, if that is known, with its numbers', async () => {
    // The language is loaded on demand.
    for (const lang of ['', 'fr', 'den', 'zh-Hant', 'en']) expect(loadWords(lang)).toBeUndefined()
    expect(wordsOf('de').lang).toBe('en')
    await loadWords('de')
    expect(loadWords('de')).toBeUndefined()
    for (const lang of ['de', 'DE', 'de-CH', 'de-']) expect(wordsOf(lang).lang, lang).toMatch(/^de/i)
    for (const lang of ['', 'fr', 'den', 'zh-Hant', 'en-@']) expect(wordsOf(lang).lang, lang).toMatch(/^en/)
    const numbers = (lang: string) => wordsOf(lang).describe({ circles: 12345, hidden: 1, vertices: 1, edges: 2 })
    expect([numbers('en'), numbers('de')]).toEqual([
      expect.stringContaining('12,345'),
      expect.stringContaining('12.345'),
    ])
  })

  test('has the same values in each language, and all that it is given in one of them', async () => {
    await loadWords('de')
    const german = wordsOf('de')
    type Text = (...args: unknown[]) => unknown
    /** The values of arguments that a text has, whichever kinds of arguments it takes. */
    const valuesIn = (say: Text, count: number) => {
      const numbers = [31, 37, 41, 43].slice(0, count)
      const lists = numbers.map((value) => [value, value])
      const places = numbers.map((_, k) => numbers.map((value, j) => (j === k ? lists[j] : value)))
      const marks = numbers.map((value) => [{ other: value, isOut: true }])
      const found = new Set<string>()
      for (const args of [numbers, numbers.map(String), lists, ...places, [numbers[0], ...marks.slice(1)]]) {
        try {
          for (const text of String(say(...args)).match(/\d+/g) ?? []) if (Number(text) > 30) found.add(text)
        } catch {
          // The text takes arguments of another kind.
        }
      }
      return [...found].sort()
    }
    let count = 0
    for (const [one, other] of [
      [wordsOf('en').editing, german.editing],
      [ENGLISH, german.others?.refusals],
      [ENGLISH_PLAYER, german.others?.player],
    ] as unknown as Record<string, Text>[][]) {
      for (const [name, text] of Object.entries(one ?? {})) {
        if (typeof text !== 'function' || name === 'coded') continue
        const inGerman = (other as Record<string, Text>)[name] as Text
        const values = valuesIn(text.bind(one), text.length)
        expect(valuesIn(inGerman.bind(other), text.length), name).toEqual(values)
        if (text.length > 0) expect(values, name).not.toEqual([])
        count += 1
      }
    }
    expect(count).toBeGreaterThan(80)
  })

  test('of every step of the method is another sentence in German', async () => {
    await loadWords('de')
    const german = wordsOf('de').others?.player as PlayerWords
    const circles = Float64Array.of(0, 0, 2, 10, 1, 1, 5, 8, 1.5, 2, 6, 0.8, 9, 6, 2.2, 6, 3, 0.6, 12, 10, 1, 9, 6, 1)
    const edits: Edit[] = [
      { kind: 'insert', circle: { x: 4, y: 4, r: 1 } },
      { kind: 'remove', id: 0 },
      { kind: 'replace', id: 1, circle: { x: 8, y: 1, r: 1.5 } },
    ]
    for (const options of [{}, { method: 'auto' }, { edits }] as const) {
      const trace = library.trace(circles, options)
      const steps = stepsOf(trace)
      for (const [k, step] of steps.entries()) {
        const [one, other] = [sentenceOf(trace, step, [1, 2]), sentenceOf(trace, step, [1, 2], german)]
        expect(other, one).not.toBe(one)
        expect(other).not.toMatch(/undefined|NaN|\b(the|circle|disc|edge)s?\b/)
        // Both texts describe the same circles.
        const numbers = (text: string) => (text.match(/\d+(\.\d+)?/g) ?? []).sort()
        if (step.line !== 'finish') expect(numbers(other), one).toEqual(numbers(one))
        expect(questionAfter(trace, steps, k, german)?.right).toBe(questionAfter(trace, steps, k)?.right)
      }
    }
  })
})

describe('a check', () => {
  const cell: CellFacts = {
    x: 1,
    y: 2,
    r: 3,
    hidden: false,
    bounded: true,
    edges: 3,
    neighbors: [0, 2],
    area: 7.5,
    perimeter: 11,
  }
  const facts: Facts = {
    circles: 4,
    hidden: 1,
    vertices: 3,
    edges: 6,
    cells: new Map([1, 2].map((id) => [id, { ...cell, neighbors: [id - 1, id + 1] }])),
  }

  test.each([
    [{ cell: 1, edges: 3 }, true],
    [{ cell: 1, edges: 4 }, false],
    [{ cell: 1, neighbors: 2, bounded: true, hidden: false }, true],
    [{ cell: 1, edges: 3, bounded: false }, false],
    [{ cell: 1, neighbor: 2 }, true],
    [{ cell: 1, neighbor: 3 }, false],
    [{ cell: 2, neighbor: 0 }, false],
    [{ cell: 1, area: { min: 7, max: 8 } }, true],
    [{ cell: 1, area: { max: 7 } }, false],
    [{ cell: 1, x: 1, y: { min: 2 }, r: { max: 3 } }, true],
    [{ cell: 5, edges: 0 }, false],
    [{ circles: 4, hidden: 1, vertices: 3, edges: { min: 6 } }, true],
    [{ circles: 5 }, false],
    [{ all: [{ circles: 4 }, { cell: 1, edges: 3 }] }, true],
    [{ all: [{ circles: 4 }, { cell: 1, edges: 4 }] }, false],
    [{ any: [{ circles: 5 }, { cell: 1, edges: 3 }] }, true],
    [{ any: [{ circles: 5 }, { cell: 1, edges: 4 }] }, false],
    [{ not: { cell: 1, hidden: true } }, true],
    [{ not: { circles: 4 } }, false],
  ])('%j is %s', (given, expected) => {
    expect(holds(parseCheck(JSON.stringify(given)), facts)).toBe(expected)
  })

  test('has goals with their values, in a sentence and at each circle', () => {
    const check = parseCheck(
      '{ "all": [{ "cell": 1, "edges": 4, "neighbor": 3 }, { "cell": 2, "edges": 4, "r": 3 }, { "hidden": { "max": 1 } }] }',
    )
    const goals = goalsOf(check, facts)
    expect(goals.map(({ name, cell, value, isMet }) => [name, cell, value, isMet])).toEqual([
      ['edges', 1, 3, false],
      ['neighbor', 1, false, false],
      ['edges', 2, 3, false],
      ['r', 2, 3, true],
      ['hidden', undefined, 1, true],
    ])
    // Equal goals are told together, and an exact number that a reader has set is not told.
    expect(goalSentence(goals, ENGLISH_GOALS)).toBe(
      'Edges: now 3, 3, goal 4; cells share an edge: now no, goal yes; hidden circles: now 1, goal at most 1',
    )
    const rings = (isMet: boolean) =>
      goalRings(check, goals, isMet, ENGLISH_GOALS).map(({ id, text, isClosed }) => [id, text, isClosed])
    expect(rings(false)).toEqual([
      [1, '3 edges', false],
      [3, '', false],
      [2, '3 edges', false],
    ])
    expect(rings(true).map(([, , isClosed]) => isClosed)).toEqual([true, true, true])
    // The goals of one circle may be reached before those of others.
    const either = parseCheck('{ "all": [{ "cell": 1, "edges": 3 }, { "cell": 2, "edges": 4 }] }')
    const part = goalRings(either, goalsOf(either, facts), false, ENGLISH_GOALS)
    expect(part.map(({ isClosed }) => isClosed)).toEqual([true, false])
  })

  test('names other ids for all its circles, which have been there', () => {
    const text =
      '{ "all": [{ "cell": 1, "neighbor": 2 }, { "not": { "any": [{ "cell": 3, "x": 1 }, { "circles": 2 }] } }] }'
    const check = parseCheck(text)
    expect(withIds(check, (number) => number + 10)).toEqual(JSON.parse(text.replace(/(cell|neighbor)": /g, '$&1')))
    expect(idsOf(check)).toEqual([1, 3])
    expect(() => checkCircles(check, 4)).not.toThrow()
    for (const count of [3, 1, 0]) expect(() => checkCircles(check, count)).toThrow(Refusal)
  })

  test.each([
    'edges == 3',
    '[]',
    '{}',
    '{"cell": 3}',
    '{"cell": -1, "edges": 3}',
    '{"cell": 0.5, "edges": 3}',
    '{"cell": 1, "edges": "3"}',
    '{"cell": 1, "edges": {}}',
    '{"cell": 1, "edges": {"least": 1}}',
    '{"cell": 1, "bounded": 1}',
    '{"cell": 1, "constructor": 1}',
    '{"area": 1}',
    '{"all": []}',
    '{"any": {"circles": 1}}',
    '{"not": {"circles": 1}, "circles": 1}',
  ])('%s is refused', (text) => {
    expect(() => parseCheck(text)).toThrow(Refusal)
  })
})

test('a check may be as deep and have as many parts as it may, and no more', () => {
  const nested = (depth: number): unknown => (depth === 0 ? { circles: 1 } : { not: nested(depth - 1) })
  const many = (count: number) => JSON.stringify({ all: Array(count).fill({ circles: 1 }) })
  expect(parseCheck(JSON.stringify(nested(7)))).toEqual(nested(7))
  expect(() => parseCheck(JSON.stringify(nested(8)))).toThrow(Refusal)
  expect(parseCheck(many(199))).toHaveProperty('all')
  expect(() => parseCheck(many(200))).toThrow(Refusal)
})

interface Named {
  readonly name: string
  readonly description: string
  readonly fieldName?: string
}
interface Manifest {
  readonly modules: readonly [
    {
      readonly declarations: readonly [
        Readonly<
          Record<'attributes' | 'members' | 'events' | 'slots' | 'cssParts' | 'cssProperties', readonly Named[]>
        >,
      ]
    },
  ]
}

describe('the manifest', () => {
  const [{ declarations }] = (manifest() as Manifest).modules
  const [element] = declarations
  const names = (list: readonly { name: string }[]) => list.map(({ name }) => name)

  test('has the members and attributes that there are', () => {
    const prototype = Object.getOwnPropertyNames(CircleVoronoiElement.prototype)
    const ofElements =
      /^(constructor|.*Callback|addEventListener|focus|form|validity|validationMessage|checkValidity|reportValidity)$/
    expect(names(element.members).sort()).toEqual(prototype.filter((name) => !ofElements.test(name)).sort())
    for (const { name, description } of element.members) expect(description, name).toMatch(/\.$/)
    for (const { fieldName } of element.attributes) expect(prototype).toContain(fieldName)
    expect(names(element.attributes).sort()).toEqual([...CircleVoronoiElement.observedAttributes].sort())
  })

  test('has the parts, slots and custom properties that there are', () => {
    const shell = read('web/element/shell.ts') + read('web/view/rings.ts')
    const said = (pattern: RegExp, text: string) => [...text.matchAll(pattern)].map(([, name]) => name as string)
    expect(names(element.cssParts).sort()).toEqual(said(/setAttribute\('part', '([\w-]+)'\)/g, shell).sort())
    expect(names(element.slots).sort()).toEqual(said(/slot\('(\w*)'\)/g, shell).sort())
    const theme = new Set(said(/^ {2}--([\w-]+):/gm, read('web/view/theme.css')))
    const properties = names(element.cssProperties).map((name) => name.replace('--circle-voronoi-', ''))
    expect(properties.filter((name) => name !== 'aspect-ratio').sort()).toEqual([...theme].sort())
  })

  test('is told of in docs/element.md', () => {
    const page = read('docs/element.md')
    const { attributes, members, events, slots, cssParts } = element
    expect(names(events)).toContain('circleschange')
    for (const { name } of [...attributes, ...members, ...events, ...slots, ...cssParts]) {
      if (name !== '') expect(page, name).toMatch(new RegExp(`\`${name}[\`(]`))
    }
    expect([attributes.length, members.length, events.length].every((count) => count > 5)).toBe(true)
    // The tables list nothing else: each attribute and event is one of these.
    const known = new Set([...attributes, ...members, ...events, ...slots, ...cssParts].map(({ name }) => name))
    const rows = [...page.matchAll(/^\| `([\w-]+)(?:\([^`]*\))?`/gm)].map(([, name]) => name as string)
    expect(rows.length).toBeGreaterThan(attributes.length)
    expect(rows.filter((name) => !known.has(name))).toEqual([])
  })

  test('has all layers in docs/element.md, and no others', () => {
    const row = read('docs/element.md')
      .split('\n')
      .find((line) => line.startsWith('| `layers` |'))
    const [words = '', more = ''] = (row as string).split('Or an object in JSON')
    const said = [...words.matchAll(/`([\w=.-]+)`/g)].map(([, word]) => word as string).slice(1)
    const colors = said.filter((word) => (CELL_COLORS as readonly string[]).includes(word))
    const layers = said.filter((word) => !colors.includes(word))
    const meant = layers.flatMap((word) => Object.keys(keptLayers(parseLayers(word))))
    const inJson = [...more.matchAll(/`(\w+)`/g)].map(([, name]) => name as string)
    expect([...new Set([...meant, ...inJson])].sort()).toEqual(
      Object.keys(DEFAULT_LAYERS)
        .filter((name) => !['data', 'column'].includes(name))
        .sort(),
    )
    expect(['none', ...colors].sort()).toEqual([...CELL_COLORS].sort())
  })
})
