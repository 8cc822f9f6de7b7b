// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it, vi } from 'vitest'
import { compressText } from '../../web/lib/base/compressed-text.ts'
import { CircleVoronoiError, type Edit } from '../../web/lib/index.ts'
import {
  type Check,
  decodeLink,
  encodeLink,
  encodeLinkAtOnce,
  LINK_LIMITS,
  type LinkInput,
  type LinkState,
} from '../../web/lib/link.ts'
import { library } from './library.ts'
import { ring as ringOf } from './shapes.ts'

const TOO_MUCH = expect.objectContaining({ code: 'linkTooLong', message: 'Too large for a link.' })

const finite = fc.double({ noNaN: true, noDefaultInfinity: true }).map((value) => value + 0)
const coordinate = fc.double({ min: -7.9e28, max: 7.9e28, noNaN: true }).map((value) => value + 0)
const radius = fc.double({ min: 0, max: 7.9e28, noNaN: true })
const circle = fc.record({ x: coordinate, y: coordinate, r: radius }, { noNullPrototype: true })
const id = fc.nat(2 ** 31 - 1)
const edit: fc.Arbitrary<Edit> = fc.oneof(
  fc.record({ kind: fc.constant('insert' as const), circle }, { noNullPrototype: true }),
  fc.record({ kind: fc.constant('remove' as const), id }, { noNullPrototype: true }),
  fc.record({ kind: fc.constant('replace' as const), id, circle }, { noNullPrototype: true }),
)
const value = fc.oneof(fc.boolean(), finite, fc.string(), fc.constant(null))
const name = fc.string().filter((name) => name !== '__proto__')
const ring = fc.array(fc.tuple(finite, finite), { maxLength: 6 })
const multiPolygon = fc.record(
  {
    type: fc.constant('MultiPolygon' as const),
    coordinates: fc.array(fc.array(ring, { maxLength: 3 }), { maxLength: 3 }),
  },
  { noNullPrototype: true },
)
const leaf = fc.record(
  { cell: fc.nat(), edges: fc.oneof(fc.nat(), fc.record({ min: finite }, { noNullPrototype: true })) },
  { noNullPrototype: true },
)
const check: fc.Arbitrary<Check> = fc.oneof(
  leaf,
  fc.record({ all: fc.array(leaf) }, { noNullPrototype: true }),
  fc.record({ not: leaf }, { noNullPrototype: true }),
)
const options = { requiredKeys: [] as never[], noNullPrototype: true }
const rest = {
  edits: fc.array(edit, { maxLength: 20 }),
  view: fc.record(
    { x: finite, y: finite, span: fc.double({ min: 5e-324, noNaN: true, noDefaultInfinity: true }) },
    { noNullPrototype: true },
  ),
  layers: fc.dictionary(name, fc.oneof(value, fc.array(value), fc.dictionary(name, value, { noNullPrototype: true })), {
    noNullPrototype: true,
  }),
  step: fc.maxSafeNat(),
  lattice: fc.oneof(
    fc.constant(null),
    fc.record({ a: fc.tuple(finite, finite), b: fc.tuple(finite, finite) }, { noNullPrototype: true }),
  ),
  region: fc.oneof(fc.constant(null), fc.array(ring, { maxLength: 4 }), multiPolygon),
  areas: fc.oneof(fc.constant('equal' as const), fc.array(fc.double({ min: 5e-324, max: 1e300, noNaN: true }))),
  method: fc.string({ maxLength: 200 }),
  headings: fc.tuple(fc.string({ maxLength: 200 }), fc.string(), fc.string()),
  title: fc.string({ maxLength: 200 }),
  question: fc.string({ maxLength: 2000 }),
  check,
  readonly: fc.boolean(),
  alt: fc.string({ maxLength: 200 }),
  lang: fc.constantFrom('en', 'de-AT'),
}
const state: fc.Arbitrary<LinkState> = fc.oneof(
  fc.record({ ...rest, dataSet: fc.string({ maxLength: 200 }) }, options),
  fc.record(
    {
      ...rest,
      circles: fc
        .array(fc.tuple(coordinate, coordinate, radius), { maxLength: 30 })
        .map((list) => Float64Array.from(list.flat())),
    },
    options,
  ),
)

// Links that people have stored. They must stay readable.
const OLD_LINKS: [string, LinkState][] = [
  [
    'v1.XY47CsMwEETvMm1GQiuTD4KcRKgQ9haGxYVsJwTjuwelzEzxYODBHBjnNpquSDkwUHhj8EKhE3V3Phj88JdC6DRvXcm4gMLIoTDDgbHzCYZfo7-WQrxmfSNloYuUvhFWP9pWpAOjmq1IqE0riGmvhrS1XYlFa-u_vHDZzcp5fgE',
    {
      circles: Float64Array.of(0, 0, 1, 6, 0.1, 1, -1e-7, 8, 1 / 3),
      edits: [
        { kind: 'insert', circle: { x: 1, y: 2, r: 3 } },
        { kind: 'remove', id: 2 },
        { kind: 'replace', id: 0, circle: { x: 0, y: 0, r: 2.5 } },
      ],
      view: { x: 1, y: -2, span: 12.5 },
      layers: { cells: 'area', dual: true, near: [0.1, null] },
    },
  ],
  [
    'v1.q1ZKSSxJDE4tUbJSSirKz6tKTcvMKUktUtJRSk3JLClWsoqOVtJV0jEzNYiNrQUA',
    { dataSet: 'bronzefilter', edits: [{ kind: 'remove', id: 650 }] },
  ],
]

/** Circles that need all their digits. */
const numberOf = (_: unknown, k: number) => (k % 3 === 2 ? Math.abs(Math.sin(k)) : Math.sin(k))

describe('a link', () => {
  it('says what it was made of, with a # or without', async () => {
    await fc.assert(
      fc.asyncProperty(state, async (state) => {
        const link = await encodeLink(state)
        expect(link).toMatch(/^v1\.[\w-]+$/)
        expect(await decodeLink(link)).toEqual(state)
        expect(await decodeLink(`#${link}`)).toEqual(state)
        expect(await decodeLink(encodeLinkAtOnce(state))).toEqual(state)
      }),
      { numRuns: 100 },
    )
  })

  it('takes circles in any form', async () => {
    const link = await encodeLink({ circles: [[0, 0, 1], { x: 6, y: -0, r: 0.1 }] })
    expect(await decodeLink(link)).toStrictEqual({ circles: Float64Array.of(0, 0, 1, 6, 0, 0.1) })
    const edits = [{ kind: 'insert', circle: [1, 2, 3] }] as const
    expect(await decodeLink(await encodeLink({ edits }))).toEqual({
      edits: [{ kind: 'insert', circle: { x: 1, y: 2, r: 3 } }],
    })
  })

  it('is written at once, too, longer than a block that is stored', async () => {
    const circles = Float64Array.from({ length: 3 * 3000 }, numberOf)
    expect((await decodeLink(encodeLinkAtOnce({ circles }))).circles).toEqual(circles)
  })

  it('has circles up to the limits of `compute`', async () => {
    const state = { circles: Float64Array.of(-7.9e28, 7.9e28, 7.9e28, 0, 0, 0) }
    expect(await decodeLink(await encodeLink(state))).toEqual(state)
    expect(library.compute(state.circles).certificate).toBeDefined()
  })

  it('has the names of its circles', async () => {
    const state = { circles: Float64Array.of(0, 0, 1, 5, 0, 1), names: ['Å', ''] }
    expect(await decodeLink(await encodeLink(state))).toEqual(state)
    await expect(encodeLink({ ...state, names: ['one'] })).rejects.toMatchObject({ code: 'badInput' })
  })

  it('has the colors of its circles', async () => {
    for (const colors of ['05', '']) {
      const state = { circles: Float64Array.of(0, 0, 1, 5, 0, 1), colors }
      expect(await decodeLink(await encodeLink(state))).toEqual(state)
    }
  })

  it('keeps fields of any value, and no others', async () => {
    const state = {
      circles: new Float64Array(),
      names: [],
      edits: [],
      layers: {},
      step: 0,
      method: '',
      colors: '',
      region: [],
      areas: [],
      title: '',
      question: '',
      readonly: false,
      alt: '',
      lang: '',
    }
    expect(await decodeLink(await encodeLink(state))).toStrictEqual(state)
    expect(await decodeLink(await encodeLink({ dataSet: '' }))).toStrictEqual({ dataSet: '' })
    expect(await decodeLink(await said({ more: 1 }))).toStrictEqual({})
    const triangle = { type: 'Polygon', coordinates: [ringOf(0, 0, 1, 0, 0, 1)] }
    const { region } = await decodeLink(await said({ region: { type: 'Feature', geometry: triangle, more: 1 } }))
    expect(region).toStrictEqual({ type: 'MultiPolygon', coordinates: [triangle.coordinates] })
  })

  it('is short', async () => {
    const circles = Float64Array.from({ length: 3 * 1000 }, (_, k) => ((k * 7919) % 1000) / 100)
    expect((await encodeLink({ circles })).length).toBeLessThan(9000)
  })

  it.each(OLD_LINKS)('of version 1 is read: %s', async (link, state) => {
    expect(await decodeLink(link)).toEqual(state)
  })

  it('may have as many circles as it says', async () => {
    const circles = Float64Array.from({ length: 3 * LINK_LIMITS.circles }, numberOf)
    const link = await encodeLink({ circles })
    expect(link.length).toBeLessThanOrEqual(LINK_LIMITS.letters)
    // Comparing element by element would take long.
    const read = (await decodeLink(link)).circles as Float64Array<ArrayBuffer>
    expect(Buffer.from(read.buffer).equals(Buffer.from(circles.buffer))).toBe(true)
    const more = new Float64Array(3 * (LINK_LIMITS.circles + 1))
    await expect(encodeLink({ circles: more })).rejects.toThrow(TOO_MUCH)
  })
})

const said = async (value: unknown) =>
  `v1.${await compressText(typeof value === 'string' ? value : JSON.stringify(value))}`
const nested = (depth: number): unknown => (depth === 0 ? 1 : [nested(depth - 1)])

describe('what is no link', () => {
  const isRefused = (link: Promise<unknown>) =>
    expect(link).rejects.toThrow(expect.objectContaining({ name: 'CircleVoronoiError', code: 'badInput' }))

  it.each(['', '#', 'figure', 'v1.a+b', 'v2.', 'v01.', 'v1.', 'v1.A', 'v1.AAAA'])('is refused: %j', async (text) => {
    await isRefused(decodeLink(text))
  })

  /** Wrong values of each field. */
  const WRONG: Record<string, readonly unknown[]> = {
    circles: [
      [1, 2],
      [1, 2, '3'],
      [0, 0, 1, 2, 0, -1],
      [0, 0, 1, 2, 0, 1, 1e200, 0, 1],
      [0, -8e28, 1],
      [0, 0, 8e28],
      { length: 3 },
    ],
    edits: [
      ...[
        {},
        [[]],
        [{ 0: '-', 1: 1 }],
        ['-1'],
        [['*', 1]],
        [[['-'], 1]],
        [['toString', 1]],
        [['+', 1, 2]],
        [['-', 0.5]],
      ],
      ...[
        [['-', -1]],
        [['-', 2 ** 31]],
        [['=', 1, 2, 3]],
        [
          ['-', 1],
          ['+', 0, 0, -1],
        ],
        [['=', 1, 0, 1e200, 1]],
      ],
    ],
    names: [['a']],
    headings: ['xyr', ['x', 'y'], ['x', 'y', 7], ['x', 'y', 'a'.repeat(201)]],
    step: [1.5, -1],
    method: [7, 'a'.repeat(201)],
    dataSet: [7, 'a'.repeat(201)],
    view: [[1, 2], [1, 2, 0], [1, 2, 3, 4], '123', { length: 3, 2: 1 }],
    region: ['square', { type: 'Point', coordinates: [1, 2] }],
    lattice: [[1, 0, 0]],
    areas: ['all', [1, 0]],
    title: [7],
    alt: ['a'.repeat(201)],
    lang: [null],
    question: ['a'.repeat(2001)],
    readonly: ['no'],
    check: [[]],
    layers: [[1]],
  }

  it.each([
    ...[null, [], '{', '{"circles":[1,2,1e999]}', '{"lattice":[1,0,0,1e999]}', '{"region":[[[0,0],[1,1e999],[2,2]]]}'],
    ...[
      '{"check":{"__proto__":{"cell":1}}}',
      '{"layers":{"__proto__":{"polluted":true}}}',
      '{"layers":{"a":{"__proto__":1}}}',
    ],
    ...['{"layers":{"a":1e999}}', { dataSet: 'a', circles: [] }],
    ...['a', [7], ['a'.repeat(201)]].map((names) => ({ circles: [0, 0, 1], names })),
    ...['8', 5].map((colors) => ({ circles: [0, 0, 1], colors })),
    ...Object.entries(WRONG).flatMap(([name, values]) => values.map((value) => ({ [name]: value }))),
  ])('is refused once it is unpacked: %j', async (value) => {
    await isRefused(said(value).then(decodeLink))
  })

  it('may be as large as it may be', async () => {
    const circles = Float64Array.of(7.9e28, -7.9e28, 7.9e28)
    expect(await decodeLink(await said({ circles: [...circles] }))).toEqual({ circles })
    expect(await decodeLink(await said({ edits: [['=', 2 ** 31 - 1, ...circles]] }))).toMatchObject({
      edits: [{ kind: 'replace', id: 2 ** 31 - 1, circle: { x: 7.9e28, y: -7.9e28, r: 7.9e28 } }],
    })
    const dataSet = 'x'.repeat(200)
    expect(await decodeLink(await said({ dataSet }))).toEqual({ dataSet })
    const edits = new Array(LINK_LIMITS.edits).fill(['-', 1])
    expect((await decodeLink(await said({ edits }))).edits).toHaveLength(LINK_LIMITS.edits)
    // Counts the object, the list and its items.
    const layers = { a: new Array(LINK_LIMITS.layerValues - 2).fill(1) }
    expect(await decodeLink(await said({ layers }))).toEqual({ layers })
    expect(await decodeLink(await said({ layers: { a: nested(6) } }))).toEqual({ layers: { a: nested(6) } })
    await expect(decodeLink(await said({ layers: { a: nested(7) } }))).rejects.toThrow(TOO_MUCH)
    layers.a.push(1)
    await expect(decodeLink(await said({ layers }))).rejects.toThrow(TOO_MUCH)
  })

  it('is refused where its bytes are no text', async () => {
    // One stored block with a byte that is invalid in UTF-8.
    await expect(
      decodeLink(`v1.${btoa('\x01\x04\x00\xfb\xff"\xff"\n').replaceAll('+', '-').replaceAll('/', '_')}`),
    ).rejects.toThrow(expect.objectContaining({ code: 'badInput' }))
  })

  it.each<[string, () => unknown]>([
    ['circles', () => ({ circles: new Array(3 * (LINK_LIMITS.circles + 1)).fill(1) })],
    ['edits', () => ({ edits: new Array(LINK_LIMITS.edits + 1).fill(['-', 1]) })],
    ['layers', () => ({ layers: { a: new Array(LINK_LIMITS.layerValues).fill(1) } })],
    ['layers in one another', () => ({ layers: { a: nested(8) } })],
    ['conditions in one another', () => ({ check: { a: nested(20) } })],
  ])('is refused with too many %s', async (_, value) => {
    await expect(decodeLink(await said(value()))).rejects.toThrow(TOO_MUCH)
  })

  it('may unpack to a text up to a limit', async () => {
    const longest = `{"step":1}${' '.repeat(LINK_LIMITS.bytes - 10)}`
    expect(await decodeLink(await said(longest))).toEqual({ step: 1 })
    const bomb = await said(`${longest} `)
    expect(bomb.length).toBeLessThan(30_000)
    await expect(decodeLink(bomb)).rejects.toThrow(TOO_MUCH)
    await expect(encodeLink({ layers: { a: ' '.repeat(LINK_LIMITS.bytes) } })).rejects.toThrow(TOO_MUCH)
  })

  it('may be a text up to a limit', async () => {
    await expect(decodeLink('a'.repeat(LINK_LIMITS.letters + 1))).rejects.toThrow(TOO_MUCH)
    await expect(decodeLink('a'.repeat(LINK_LIMITS.letters))).rejects.toThrow(
      expect.objectContaining({ code: 'badInput' }),
    )
    const linkOf = (count: number) => encodeLinkAtOnce({ layers: { a: ' '.repeat(count) } })
    const count = 3_145_000
    // A letter of base64 has six bits.
    const more = Math.floor(((LINK_LIMITS.letters - linkOf(count).length) * 6) / 8)
    const { length } = linkOf(count + more)
    expect(length > LINK_LIMITS.letters - 2 && length <= LINK_LIMITS.letters).toBe(true)
    expect(() => linkOf(count + more + 2)).toThrow(TOO_MUCH)
  })

  it('is refused, whatever it is: random text, and links with letters changed, gone or added', async () => {
    const link = await encodeLink({
      circles: [
        [0, 0, 1],
        [6, 0, 1],
      ],
      layers: { dual: true },
    })
    const letter = fc.constantFrom(...'ABCdefgh0189-_.+#v')
    const spoilt = fc
      .record({ at: fc.nat(link.length), gone: fc.nat(4), put: fc.string({ unit: letter, maxLength: 4 }) })
      .map(({ at, gone, put }) => link.slice(0, at) + put + link.slice(at + gone))
    const wrapped = fc.oneof(fc.string(), fc.json()).map((json) => ({ json }))
    await fc.assert(
      fc.asyncProperty(fc.oneof(fc.string(), spoilt, wrapped), async (text) => {
        const link = typeof text === 'string' ? text : await said(text.json)
        try {
          await encodeLink(await decodeLink(link))
        } catch (error) {
          expect(error).toBeInstanceOf(CircleVoronoiError)
          expect((error as CircleVoronoiError).message).toMatch(/^[A-Z].*\.$/)
        }
      }),
      { numRuns: 300 },
    )
  })

  it.each([
    null,
    { edits: 5 },
    { edits: [null] },
    { edits: [{ kind: 'insert' }] },
    { circles: [[Number.NaN, 0, 0]] },
    { circles: [[0, 0, -1]] },
    { view: {} },
    { layers: { a: () => 1 } },
  ])('is made of no such state: %j', async (state) => {
    await isRefused(encodeLink(state as LinkInput))
  })

  it('is said where the streams are missing', async () => {
    vi.stubGlobal('CompressionStream', undefined)
    const { DecompressionStream } = globalThis
    vi.stubGlobal('DecompressionStream', undefined)
    try {
      await expect(encodeLink({})).rejects.toThrow(expect.objectContaining({ code: 'notLoaded' }))
      await expect(decodeLink('v1.AAAA')).rejects.toThrow(expect.objectContaining({ code: 'notLoaded' }))
    } finally {
      vi.unstubAllGlobals()
    }
    expect(globalThis.DecompressionStream).toBe(DecompressionStream)
  })
})
