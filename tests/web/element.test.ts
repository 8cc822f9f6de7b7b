// SPDX-License-Identifier: GPL-3.0-or-later
// What an element reads: attributes, data, checks; and what its manifest says of it.
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { parseControls, parseLayers, parseStep, parseView } from '../../web/element/attributes.ts'
import { holds, idsOf, parseCheck } from '../../web/element/check.ts'
import { CircleVoronoiElement } from '../../web/element/circle-voronoi-element.ts'
import { readCircles } from '../../web/element/read-circles.ts'
import { wordsOf } from '../../web/element/words.ts'
import { loadFiles } from '../../web/lib/files.ts'
import { CELL_COLORS, DEFAULT_LAYERS, keptLayers } from '../../web/view/layers.ts'
import type { CellFacts, Facts } from '../../web/view/protocol.ts'

const read = (path: string) => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')

describe('circles', () => {
  const wasm = readFileSync(new URL('../../web/lib/generated/circle-voronoi-files.wasm', import.meta.url))
  const texts = [
    read('tests/fixtures/spruces.csv'),
    '0.1,1e-300,3\n1.7976931348623157e149,-0,+5\n',
    '# trees\nname; r ; y;x\noak;0,5;2;1\nbirch;1,25;3;1\n',
    'x\ty\tr\r\n1\t2\t3\r\n\r\n',
    '1 2 3\n 4  5 6\n',
    '"lon","lat","radius"\n8.5,47.25,2\n',
    '[[1, 2, 3], {"r": 4, "x": 5, "y": 6, "name": "oak"}]',
    '{"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Point","coordinates":[1,2]},"properties":{"r":0.1}}]}',
  ]

  test('are those that the reader of files reads, to the bit', async () => {
    const files = await loadFiles({ wasm })
    for (const text of texts) expect(readCircles(text), text.slice(0, 40)).toEqual(files.readCircles(text))
  })

  test('as the arrays of a diagram are written', () => {
    expect(readCircles('{"circles": [0, 0, 1, 5, 0, 2]}')).toEqual(Float64Array.of(0, 0, 1, 5, 0, 2))
    expect(readCircles('[]')).toHaveLength(0)
  })

  test.each([
    ['', 'There are no circles in this.'],
    ['x,y,r\n', 'There are no circles in this.'],
    ['1,2,3\n4,5\n', 'Line 2 is not three numbers x, y and r: 4 5'],
    ['1,2,3,4\n', 'Line 1 is not three numbers x, y and r: 1 2 3 4'],
    ['x,y,r\n1,2,0x10\n', 'Line 2 is not three numbers x, y and r: 1 2 0x10'],
    ['1,2,Infinity\n', 'Line 1 is not three numbers x, y and r: 1 2 Infinity'],
    ['[[1, 2]]', 'Circle 0 does not have three numbers x, y and r.'],
    ['[1, 2]', 'Three numbers per circle are needed, but there are 2.'],
    ['{"circles": 7}', 'The circles are neither a typed array nor a list, but 7.'],
    ['[[1, 2, 3]', /^The circles are no JSON: /],
    ['{"features": [null]}', 'Circle 0 does not have three numbers x, y and r.'],
  ])('%j is refused', (text, message) => {
    expect(() => readCircles(text)).toThrow(message)
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

  test.each(['nonsense', 'hull=2', 'cells=blue', 'cells', 'max-distance=far', 'max-distance', 'path', '__proto__'])(
    'there is no layer %s',
    (word) => {
      expect(() => parseLayers(`hull ${word}`)).toThrow(`There is no layer ${word}.`)
    },
  )

  test('a view is three numbers', () => {
    expect(parseView('1, -2.5  4')).toEqual({ x: 1, y: -2.5, span: 4 })
    for (const text of ['', '1 2', '1 2 0', '1 2 -3', '1 2 3 4', 'a b c'])
      expect(() => parseView(text)).toThrow('A view is')
  })

  test('a step is a whole number', () => {
    expect(parseStep(' 12 ')).toBe(12)
    for (const text of ['', 'last', '-1', '1.5', '1e300']) expect(() => parseStep(text)).toThrow('A step is')
  })

  test('controls are buttons, the player or both', () => {
    const both = (text: string | null) => Object.values(parseControls(text))
    expect(both(null)).toEqual([false, false])
    for (const text of ['', 'controls', 'true']) expect(both(text)).toEqual([true, false])
    expect(both('player')).toEqual([false, true])
    expect(both(' buttons  player ')).toEqual([true, true])
  })
})

describe('what it says', () => {
  const counts = { circles: 12345, hidden: 1, vertices: 1, edges: 2 }

  test('is in the language of its page, if that is known, with its numbers', () => {
    const english = (number: string) =>
      `${number} circles, 1 of them hidden inside others; the diagram has 1 vertex and 2 edges.`
    const german = (number: string) =>
      `${number} Kreise, 1 davon in anderen verborgen; das Diagramm hat 1 Ecke und 2 Kanten.`
    expect(wordsOf('en').describe(counts)).toBe(english('12,345'))
    expect(wordsOf('de').describe(counts)).toBe(german('12.345'))
    expect(wordsOf('de-CH').describe(counts)).toMatch(/^12[^.]345 Kreise/)
    expect(wordsOf('DE').describe({ ...counts, circles: 1, hidden: 0 })).toMatch(/^1 Kreis; /)
    for (const lang of ['', 'fr', 'den', 'zh-Hant']) expect(wordsOf(lang)).toMatchObject({ lang: 'en' })
    // No page is broken by what stands there.
    expect(wordsOf('de-').describe(counts)).toBe(german('12.345'))
    expect(wordsOf('en-@').describe(counts)).toBe(english('12,345'))
  })

  test('is all there in each language', () => {
    const [english, german] = [wordsOf('en'), wordsOf('de')]
    const texts = (words: typeof english) => [...Object.values(words), ...Object.values(words.buttons)].map(String)
    expect(Object.keys(german)).toEqual(Object.keys(english))
    expect(Object.keys(german.buttons)).toEqual(Object.keys(english.buttons))
    for (const [k, text] of texts(german).entries()) expect(text, texts(english)[k]).not.toBe('')
  })
})

describe('a check', () => {
  const cell: CellFacts = { x: 1, y: 2, r: 3, hidden: false, bounded: true, edges: 3, neighbors: [0, 2], area: 7.5 }
  const facts: Facts = { circles: 4, hidden: 1, vertices: 3, edges: 6, cells: new Map([[1, cell]]) }

  test.each([
    [{ cell: 1, edges: 3 }, true],
    [{ cell: 1, edges: 4 }, false],
    [{ cell: 1, neighbors: 2, bounded: true, hidden: false }, true],
    [{ cell: 1, edges: 3, bounded: false }, false],
    [{ cell: 1, neighbor: 2 }, true],
    [{ cell: 1, neighbor: 3 }, false],
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

  test('knows which circles it is about', () => {
    const text =
      '{ "all": [{ "cell": 3, "edges": 3 }, { "not": { "any": [{ "cell": 5, "x": 1 }, { "circles": 2 }] } }] }'
    expect(idsOf(parseCheck(text))).toEqual([3, 5])
  })

  test.each([
    ['edges == 3', 'it is no JSON'],
    ['[]', 'each part is an object'],
    ['{}', 'a part says nothing'],
    ['{"cell": 3}', 'it says nothing of the cell'],
    ['{"cell": -1, "edges": 3}', 'cell is the number of a circle'],
    ['{"cell": 0.5, "edges": 3}', 'cell is the number of a circle'],
    ['{"cell": 1, "edges": "3"}', 'edges is a number, or an object with min and max'],
    ['{"cell": 1, "edges": {}}', 'edges is a number, or an object with min and max'],
    ['{"cell": 1, "edges": {"least": 1}}', 'edges is a number, or an object with min and max'],
    ['{"cell": 1, "bounded": 1}', 'bounded is true or false'],
    ['{"cell": 1, "constructor": 1}', 'a cell has no constructor'],
    ['{"area": 1}', 'a diagram has no area'],
    ['{"all": []}', 'all has a list'],
    ['{"any": {"circles": 1}}', 'any has a list'],
    ['{"not": {"circles": 1}, "circles": 1}', 'not stands alone'],
    [`${'{"not":'.repeat(9)}{"circles":1}${'}'.repeat(9)}`, 'it has too many parts'],
    [JSON.stringify({ all: Array(300).fill({ circles: 1 }) }), 'it has too many parts'],
  ])('%.40s is refused', (text, reason) => {
    expect(() => parseCheck(text)).toThrow(`The check cannot be read: ${reason}.`)
  })
})

test('a check may be as deep and have as many parts as it may, and no more', () => {
  const nested = (depth: number): unknown => (depth === 0 ? { circles: 1 } : { not: nested(depth - 1) })
  const many = (count: number) => JSON.stringify({ all: Array(count).fill({ circles: 1 }) })
  expect(parseCheck(JSON.stringify(nested(7)))).toEqual(nested(7))
  expect(() => parseCheck(JSON.stringify(nested(8)))).toThrow('it has too many parts')
  expect(parseCheck(many(199))).toHaveProperty('all')
  expect(() => parseCheck(many(200))).toThrow('it has too many parts')
})

describe('the manifest', () => {
  const [{ declarations }] = JSON.parse(read('web/element/custom-elements.json')).modules
  const [element] = declarations
  const names = (list: { name: string }[]) => list.map(({ name }) => name)

  test('has the members and attributes that there are', () => {
    const prototype = Object.getOwnPropertyNames(CircleVoronoiElement.prototype)
    const ofElements =
      /^(constructor|.*Callback|addEventListener|focus|form|validity|validationMessage|checkValidity|reportValidity)$/
    // `ready` is a field.
    expect(names(element.members).sort()).toEqual(
      [...prototype.filter((name) => !ofElements.test(name)), 'ready'].sort(),
    )
    // Every element has a language.
    for (const { fieldName } of element.attributes) expect([...prototype, 'lang']).toContain(fieldName)
    // Its name is read when it is needed.
    const observed = names(element.attributes).filter((name) => name !== 'name')
    expect(observed.sort()).toEqual([...CircleVoronoiElement.observedAttributes].sort())
  })

  test('has the parts, slots and custom properties that there are', () => {
    const shell = read('web/element/shell.ts')
    const said = (pattern: RegExp, text: string) => [...text.matchAll(pattern)].map(([, name]) => name as string)
    expect(names(element.cssParts).sort()).toEqual(said(/setAttribute\('part', '([\w-]+)'\)/g, shell).sort())
    expect(names(element.slots).sort()).toEqual(said(/slot\('(\w*)'\)/g, shell).sort())
    const theme = new Set(said(/--([\w-]+): light-dark/g, read('web/view/theme.css')))
    const properties = names(element.cssProperties).map((name) => name.replace('--circle-voronoi-', ''))
    expect(properties.filter((name) => name !== 'aspect-ratio').sort()).toEqual([...theme].sort())
  })

  test('is told of in docs/element.md', () => {
    const page = read('docs/element.md')
    const { attributes, members, events, slots, cssParts } = element
    for (const { name } of [...attributes, ...members, ...events, ...slots, ...cssParts]) {
      if (name !== '') expect(page, name).toMatch(new RegExp(`\`${name}[\`(]`))
    }
    expect([attributes.length, members.length, events.length].every((count) => count > 5)).toBe(true)
    // And nothing else: each attribute and event of its tables is one of these.
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
        .filter((name) => name !== 'data')
        .sort(),
    )
    expect(['none', ...colors].sort()).toEqual([...CELL_COLORS].sort())
  })
})
