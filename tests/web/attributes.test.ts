// SPDX-License-Identifier: GPL-3.0-or-later
// Attributes of circles beyond centers and radii: kept, shown, sorted, colored by, edited, undone and linked.
import { describe, expect, it, vi } from 'vitest'
import { cellValues } from '../../web/app/cell-values.ts'
import { LinkWriter } from '../../web/app/link-writer.ts'
import {
  attributesOf,
  columnsOf,
  fileAttributes,
  isNumeric,
  membersOf,
  numberIn,
  textIn,
  valueFrom,
  valueIn,
} from '../../web/editing/attributes.ts'
import { nameColumn, namesBy } from '../../web/editing/identity.ts'
import { NONE } from '../../web/lib/base/diagram-data.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { checkLayers, DEFAULT_LAYERS, keptLayers, layersFrom } from '../../web/view/layers.ts'
import { factsOf } from '../../web/view/painter/facts.ts'
import { Picture } from '../../web/view/painter/picture.ts'
import { tabulated } from '../../web/view/painter/tabulate.ts'
import { fail, pageSession } from './editing-session.ts'
import { library } from './library.ts'

const THREE = Float64Array.of(0, 0, 1, 9, 0, 1, 0, 9, 1)
const PROPERTIES = [
  '{"name":"A","fips":"01001","n":12345678901234567890}',
  '{"name":"B","fips":"1003","n":2.50}',
  '{"fips":"06037","n":null,"tags":["a, b",{"c":"}"}]}',
]
const FILE = { properties: PROPERTIES, ids: ['"x"', '7', ''], heights: ['1.5', '', '2'], collection: '{"crs":{}}' }
const ATTRIBUTES = columnsOf(FILE, 3)
const scene = { circles: THREE, dataSet: '', isEdited: false, attributes: ATTRIBUTES }
const column = (name: string) => ATTRIBUTES.columns.find((column) => column.name === name) as never

describe('attributes', () => {
  it('are texts of JSON by columns, and files have them again with all digits', () => {
    expect(membersOf(' { "a\\"{" : [1, {"b": "x,]"}] , "c":-0.50,"d":{}} ')).toEqual([
      ['a"{', '[1, {"b": "x,]"}]'],
      ['c', '-0.50'],
      ['d', '{}'],
    ])
    expect(membersOf('{}')).toEqual([])
    expect(ATTRIBUTES.columns).toEqual([
      { name: 'name', values: ['"A"', '"B"', ''] },
      { name: 'fips', values: ['"01001"', '"1003"', '"06037"'] },
      { name: 'n', values: ['12345678901234567890', '2.50', 'null'] },
      { name: 'tags', values: ['', '', '["a, b",{"c":"}"}]'] },
    ])
    expect(attributesOf(ATTRIBUTES, [0, 1, 2])).toEqual(FILE)
    expect(attributesOf(ATTRIBUTES, [2, 9, 0])).toEqual({
      properties: [PROPERTIES[2], '{}', PROPERTIES[0]],
      ids: ['', '', '"x"'],
      heights: ['2', '', '1.5'],
      collection: '{"crs":{}}',
    })
  })

  it('have a type for each column: numbers, or what is written', () => {
    expect(ATTRIBUTES.columns.map(isNumeric)).toEqual([false, false, true, false])
    expect([numberIn('2.50'), numberIn('"1"'), numberIn('null'), numberIn(undefined)]).toEqual([2.5, NaN, NaN, NaN])
    expect(['"A\\n"', '2.50', 'null', '', undefined, '[1]'].map(textIn)).toEqual(['A\n', '2.50', '', '', '', '[1]'])
    expect(nameColumn(ATTRIBUTES.columns)?.name).toBe('name')
    const named = (...names: string[]) => namesBy(names.map((name) => ({ name, values: [`"${name} 0"`] })))(0)
    expect([named('ID', 'Ort'), named('n', 'id'), named('n')]).toEqual(['Ort 0', 'id 0', ''])
  })

  it('take what is written as a value of their column', () => {
    expect(
      ['', ' 7 ', '1,5', '\u22122', '1e3', '12345678901234567890', '+.5'].map((text) => valueFrom(text, column('n'))),
    ).toEqual(['null', '7', '1.5', '-2', '1e3', '12345678901234567890', '0.5'])
    for (const text of ['x', '1 2', '0x10', 'Infinity']) expect(valueFrom(text, column('n'))).toBeUndefined()
    expect(['007', ' a"', ''].map((text) => valueFrom(text, column('fips')))).toEqual(['"007"', '" a\\""', 'null'])
    expect(['[2]', 'x'].map((text) => valueFrom(text, column('tags')))).toEqual(['[2]', '"x"'])
  })
})

async function started() {
  vi.stubGlobal('requestAnimationFrame', () => {})
  const session = pageSession({ onproblem: fail })
  await session.actions.opening.open(async () => scene)
  return session
}

describe('in the page, attributes', () => {
  it('are void for circles that have come since', async () => {
    const { editing } = await started()
    const [, set] = await Promise.all([editing.open(scene), editing.setValues('n', new Map([[0, '1']]))])
    expect([set, valueIn(editing.attributes, 'n', 0)]).toEqual([undefined, '12345678901234567890'])
  })

  it('are in a link with few circles, with the column of the colors, and in none that has no room', async () => {
    const { editing, actions, fake: view } = await started()
    await editing.edit([{ kind: 'remove', id: 1 }])
    actions.coloring.colorBy('n')
    const said = actions.opening.linkState()
    expect(said?.layers).toEqual({ column: 'n' })
    const link = await encodeLink(said ?? {})
    expect((await decodeLink(link)).attributes).toEqual(attributesOf(ATTRIBUTES, [0, 2]))
    view.layers = DEFAULT_LAYERS
    await actions.data.openLink(link)
    expect(fileAttributes(editing)).toEqual(attributesOf(ATTRIBUTES, [0, 2]))
    expect(view.layers.column?.name).toBe('n')

    const tried: unknown[] = []
    const files = {
      call: async (_: string, state: { attributes?: unknown; headings?: unknown }) => {
        tried.push([state.attributes, state.headings])
        if (tried.length % 2 === 1) throw new Error('too large')
        return 'v1.x'
      },
    }
    const circles = new Float64Array(9000)
    const headings = ['a', 'b', 'c'] as const
    for (const more of [{ attributes: FILE }, { headings }]) {
      expect(await new LinkWriter(files as never).linkOf({ circles, ...more })).toBe('v1.x')
    }
    expect(tried).toEqual([
      [FILE, undefined],
      [undefined, undefined],
      [undefined, headings],
      [undefined, undefined],
    ])
  })

  it('of a link are refused unless they are those of its circles', async () => {
    const wrong: object[] = [
      { ...FILE, properties: PROPERTIES.slice(1) },
      { ...FILE, properties: ['{', '{}', '{}'] },
      { ...FILE, properties: ['[]', '{}', '{}'] },
      { ...FILE, ids: ['{}', '1', '2'] },
      { ...FILE, heights: ['"a"', '1', '2'] },
      { ...FILE, collection: '[' },
      { ...FILE, properties: [`{"a":"${'x'.repeat(10_001 - 8)}"}`, '{}', '{}'] },
      {},
    ]
    for (const attributes of wrong) {
      await expect(encodeLink({ circles: THREE, attributes: attributes as never })).rejects.toThrow()
    }
    const longest = { ...FILE, properties: [`{"a":"${'x'.repeat(10_000 - 8)}"}`, '{}', '{}'] }
    expect((await decodeLink(await encodeLink({ circles: THREE, attributes: longest }))).attributes).toEqual(longest)
    const none = { properties: [], ids: [], heights: [], collection: '' }
    expect((await decodeLink(await encodeLink({ circles: THREE, attributes: none }))).attributes).toEqual(none)
  })
})

describe('colors by a column', () => {
  const table = new CircleTable(THREE.slice())
  const valuesOf = (name: string) => cellValues(column(name), table)

  it('are numbers, or categories, the most frequent first', () => {
    expect(valuesOf('n')).toEqual({ name: 'n', values: Float64Array.of(Number('12345678901234567890'), 2.5, NaN) })
    const kinds = { name: 'kind', values: ['"b"', '"a"', '"b"'] }
    expect(cellValues(kinds, table)).toEqual({
      name: 'kind',
      values: Float64Array.of(0, 1, 0),
      categories: ['b', 'a'],
    })
    expect([...valuesOf('name').values]).toEqual([0, 1, Number.NaN])
  })

  it('are those of a ramp or of a map, and no color where there is no value', () => {
    const picture = new Picture(library.edit(THREE))
    const before = picture.colors
    picture.layers = { ...DEFAULT_LAYERS, column: { name: 'n', values: Float64Array.of(1, 5, NaN) } }
    expect([picture.colors, [0, 1, 2].map((i) => picture.colorOf(i))]).toEqual(['column', [8, 45, NONE]])
    expect(picture.legend).toMatchObject({ measure: 'column', name: 'n', knots: [1, 1, 5, 5, 5] })
    picture.layers = { ...DEFAULT_LAYERS, column: valuesOf('name') }
    expect([0, 1, 2].map((i) => picture.colorOf(i))).toEqual([0, 1, NONE])
    expect(picture.legend).toMatchObject({ name: 'name', categories: ['A', 'B'], hasOthers: false })
    const many = { name: 'many', values: Float64Array.of(7, 8, 9), categories: [...'abcdefghij'] }
    picture.layers = { ...DEFAULT_LAYERS, column: many }
    expect([0, 1, 2].map((i) => picture.colorOf(i))).toEqual([7, NONE, NONE])
    expect(picture.legend).toMatchObject({ categories: [...'abcdefgh'], hasOthers: true })
    picture.layers = DEFAULT_LAYERS
    expect([picture.colors, picture.legend]).toEqual([before, undefined])
  })

  it('are kept by their name, and refused where they are no values', () => {
    const column = { name: 'n', values: new Float64Array(3) }
    expect(keptLayers({ ...DEFAULT_LAYERS, column })).toEqual({ column: 'n' })
    expect(layersFrom({ column: 'n' }).column).toBeUndefined()
    checkLayers({ ...DEFAULT_LAYERS, column })
    for (const wrong of ['n', { name: 'n' }, { name: 1, values: column.values }, { ...column, categories: [1] }]) {
      expect(() => checkLayers({ ...DEFAULT_LAYERS, column: wrong as never })).toThrow()
    }
  })
})

it('an unbounded cell is infinite wherever it is told, and a bounded one is not cut to a box', () => {
  const picture = new Picture(library.edit(Float64Array.of(...THREE, 3, 3, 0.5, 40, 40, 1)))
  const ids = [0, 1, 2, 3, 4]
  const told = factsOf(picture, { circles: 5, hidden: 0, vertices: 0, edges: 0 }, ids).cells
  const [areas] = tabulated(picture, ['area'], Int32Array.from(ids)).columns
  expect(ids.map((id) => told.get(id)?.area)).toEqual([...(areas as Float64Array)])
  expect([told.get(0)?.area, told.get(0)?.perimeter, told.get(3)?.bounded]).toEqual([Infinity, Infinity, true])
})
