// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of the files thread: what it reads and writes, and its failures.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { HowRead, Read, SavedFormat } from '../../web/app/files/files-protocol.ts'
import type { Lattice } from '../../web/lib/index.ts'
import { decodeLink } from '../../web/lib/link.ts'
import type { RemoteReply } from '../../web/view/remote-calls.ts'
import { library } from './library.ts'

const replies: RemoteReply[] = []
beforeEach(async () => {
  vi.stubGlobal('postMessage', (reply: RemoteReply) => replies.push(reply))
  await import('../../web/app/files/files-thread.ts')
})
afterEach(() => vi.unstubAllGlobals())

async function ask(data: object) {
  const { onmessage } = globalThis as unknown as { onmessage: (event: object) => Promise<void> }
  await onmessage({ data })
  return replies.at(-1)
}
const call = async (name: string, ...args: unknown[]) =>
  ((await ask({ request: 9, name, args })) as { value?: unknown }).value
const read = (text: string, how?: HowRead, name = 'a.csv') =>
  call('read', new TextEncoder().encode(text), name, how) as Promise<Read & { circles: Float64Array }>

it('says what went wrong, about which circle if about one, and tries again when it is asked again', async () => {
  vi.stubGlobal('fetch', () => Promise.reject(new Error('The network is gone')))
  const platform = vi.spyOn(process, 'getBuiltinModule').mockReturnValue(undefined as never)
  const error = { code: 'notLoaded', circle: undefined, message: expect.stringContaining('The network is gone') }
  expect(await ask({ request: 1, name: 'catalogue', args: [] })).toEqual({ request: 1, error })
  platform.mockRestore()
  const value = { families: expect.anything(), figures: expect.anything() }
  expect(await ask({ request: 2, name: 'catalogue', args: [] })).toEqual({ request: 2, value })
  const wrong = { request: 3, name: 'read', args: [new TextEncoder().encode('0,0,1\n5,0,-1\n'), 'a.csv'] }
  const refused = { code: 'negativeRadius', circle: 1, message: expect.stringMatching(/^a\.csv:2: Circle 1 /) }
  expect(await ask(wrong)).toEqual({ request: 3, error: refused })
})

it('generates circles and writes links', async () => {
  expect(await call('make', { kind: 'family', family: 'grid', seed: 1, count: 9 })).toHaveLength(27)
  const link = await call('link', { circles: Float64Array.of(1, 2, 3) })
  expect((await decodeLink(link as string)).circles).toEqual(Float64Array.of(1, 2, 3))
})

describe('a file', () => {
  it('of circles alone has no attributes', async () => {
    expect(await read('1,2,3\n')).toEqual({ circles: Float64Array.of(1, 2, 3) })
  })

  it('has its other columns, and counts the rows that are skipped if it is asked to skip them', async () => {
    const text = 'x,y,r,n\n1,2,3,7\n4,5,a,8\n4,5,6,9\n'
    const { circles, ...rest } = await read(text, { skipsInvalid: true })
    expect(circles).toEqual(Float64Array.of(1, 2, 3, 4, 5, 6))
    expect(rest).toEqual({
      attributes: { columns: [{ name: 'n', values: ['7', '9'] }], ids: [], heights: [], collection: '' },
      skipped: 1,
    })
    expect(await read(text)).toBeUndefined()
    expect(await read('1,2,3\n', { skipsInvalid: true })).toEqual({ circles: Float64Array.of(1, 2, 3), skipped: 0 })
  })

  const TABLE = 'n,a,b,c\n7,1,2,3\n8,4,5,6\n'
  it.each([
    [{ x: 'a', y: 'b', radius: 'c', isDiameter: false }, [1, 2, 3, 4, 5, 6]],
    [{ x: 'b', y: 'a', radius: 'c', isDiameter: true }, [2, 1, 1.5, 5, 4, 3]],
    [{ x: 'a', y: 'b', radius: { all: 9 }, isDiameter: true }, [1, 2, 9, 4, 5, 9]],
  ])('has the columns that were chosen: %j', async (columns, expected) => {
    expect([...(await read(TABLE, { columns })).circles]).toEqual(expected)
  })

  it('of a diagram has its circles', async () => {
    const text = await call('write', Float64Array.of(0, 0, 1, 9, 0, 2), 'json', {}, undefined)
    expect(await read(text as string, {}, 'a.json')).toEqual({ circles: Float64Array.of(0, 0, 1, 9, 0, 2) })
  })

  it('of a drawing has its link, its table or its circles', async () => {
    const svg = (content: string) =>
      `<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg">\n${content}\n</svg>\n`
    expect(await read(svg('<metadata id="circle-voronoi">v1.abc</metadata>'), {}, 'a.svg')).toEqual({ link: 'v1.abc' })
    const table = '<metadata id="circle-voronoi-circles">\nx,y,r\n1,2,3\n</metadata>'
    expect((await read(svg(table), {}, 'a.svg')).circles).toEqual(Float64Array.of(1, 2, 3))
    const circle = '<circle data-circle="0" class="c" cx="1" cy="2" r="3"/>'
    for (const head of ['', '<!-- by hand -->\n', '<!DOCTYPE svg>\n']) {
      const text = `${head}<svg>\n<g class="circles">\n${circle}\n</g>\n</svg>`
      expect((await read(text, {}, 'a.svg')).circles, head).toEqual(Float64Array.of(1, 2, 3))
    }
    const group = (lines: string[]) => svg(`<g class="circles">\n${lines.join('\n')}\n</g>`)
    const wrong = [
      svg(''),
      group([]),
      group([circle.replace('"0"', '"1"')]),
      group([circle, circle]),
      group([circle.replace('cx="1"', 'cx="a"')]),
      svg(`<g id="given-1"></g><g class="circles">\n${circle}\n</g>`),
    ]
    for (const text of wrong) {
      await read(text, {}, 'a.svg')
      expect(replies.at(-1)).toMatchObject({
        error: { code: 'badInput', message: expect.stringContaining('a.svg') },
      })
    }
  })
})

describe('saved data', () => {
  const CIRCLES = Float64Array.of(0, 0, 1, 10, 0, 2, 0, 20, 3)
  const ATTRIBUTES = {
    properties: ['{"n":1.50}', '{}', '{ "a" : "}" }'],
    ids: ['"p"', '', '7'],
    heights: [],
    collection: '',
  }
  const write = (format: SavedFormat, domain: object = {}, attributes?: object) =>
    call('write', CIRCLES, format, domain, attributes) as Promise<string>

  it('of cells that repeat has whole cells, with ids and properties as they are written in the file', async () => {
    const lattice: Lattice = { a: [40, 0], b: [0, 50] }
    const text = await write('cells', { lattice }, ATTRIBUTES)
    expect(text.endsWith('\n]}\n')).toBe(true)
    const { features } = JSON.parse(text)
    expect(features.map(({ id }: { id: unknown }) => id)).toEqual(['p', undefined, 7])
    expect(text).toContain('"n":1.50}')
    const properties = features.map((feature: { properties: object }) => feature.properties)
    expect(properties[2]).toMatchObject({ circle: 2, r: 3, a: '}' })
    expect(properties.reduce((sum: number, { area }: { area: number }) => sum + area, 0)).toBeCloseTo(2000, 6)
    const periodic = library.computePeriodic(CIRCLES, lattice)
    for (const [circle, { neighbors, shifts }] of properties.entries()) {
      const images = periodic.neighbors(circle)
      expect([neighbors, shifts]).toEqual([images.map((image) => image.circle), images.map((image) => image.shift)])
    }
    expect(features[0].geometry.type).toBe('Polygon')
    expect(Object.keys(JSON.parse(await write('cells', { lattice })).features[0])).toEqual([
      'type',
      'properties',
      'geometry',
    ])
  })
})
