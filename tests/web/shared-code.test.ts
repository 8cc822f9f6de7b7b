// SPDX-License-Identifier: GPL-3.0-or-later
// Links and code that a page copies, without a browser.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { FileActions } from '../../web/app/files/file-actions.ts'
import { CircleVoronoiError } from '../../web/lib/base/errors.ts'
import { decodeLink, encodeLink, type LinkInput } from '../../web/lib/link.ts'

const CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const AREAS = [1, 2, 3]
const REGION = {
  type: 'Polygon',
  coordinates: [
    [
      [-9, -9],
      [20, -9],
      [0, 20],
      [-9, -9],
    ],
  ],
} as const
const SEEN = { x: 1, y: 2, span: 3 }

let copied: string
let problem: string | undefined
let shown: LinkInput
let linkOf: (state: LinkInput) => Promise<string>
let actions: FileActions

beforeEach(() => {
  copied = ''
  problem = undefined
  shown = { dataSet: 'mine', view: SEEN, layers: { hull: true }, areas: AREAS }
  linkOf = encodeLink
  vi.stubGlobal('location', { origin: 'https://example.org', pathname: '/circles/' })
  vi.stubGlobal(
    'ClipboardItem',
    class {
      readonly text: Promise<Blob>
      constructor(items: { 'text/plain': Promise<Blob> }) {
        this.text = items['text/plain']
      }
    },
  )
  vi.stubGlobal('navigator', {
    clipboard: {
      write: async ([item]: [{ text: Promise<Blob> }]) => {
        copied = await (await item.text).text()
      },
    },
  })
  const store = { update: (change: (state: object) => { problem?: string }) => (problem = change({}).problem) }
  // The second circle was deleted, so the ids are 0, 2 and 3.
  const ids = [0, 2, 3]
  const editing = {
    circles: { circles: () => CIRCLES, countBelow: (id: number) => ids.filter((other) => other < id).length },
    domain: { region: REGION },
    idOf: (number: number) => number,
  }
  const page = { linkState: () => shown }
  const threads = { links: { linkOf: (state: LinkInput) => linkOf(state) } }
  actions = new FileActions(store as never, editing as never, page as never, undefined as never, threads as never)
})
afterEach(() => vi.unstubAllGlobals())

it('a link has the state as it is', async () => {
  expect(await actions.copyLink()).toBe(copied.length)
  expect(copied).toMatch(/^https:\/\/example\.org\/circles\/#\S+$/)
  expect(await decodeLink(copied.split('#')[1] as string)).toEqual({ ...shown })
})

it.each([
  [undefined, '"controls'],
  [4, '"controls="player"'],
])('an element has the circles, the region and the areas, and the player at step %s', async (step, controls) => {
  shown = { ...shown, step }
  expect(await actions.copyElementCode()).toBe(copied.length)
  const [, link] =
    copied.match(
      /^<script type="module" src="https:\/\/example\.org\/circles\/element\.js"><\/script>\n<circle-voronoi src="#([^"]+)" /,
    ) ?? []
  expect(copied.replaceAll(' ', '')).toContain(`${controls.replaceAll(' ', '')}></circle-voronoi>`)
  const state = await decodeLink(link as string)
  expect(state).toMatchObject({ circles: CIRCLES, areas: AREAS, view: SEEN, layers: { hull: true } })
  expect(state.region).toMatchObject({ type: 'MultiPolygon' })
  expect([state.step, 'dataSet' in state && state.dataSet !== undefined]).toEqual([step, false])
})

it('a question is about circles by their places in the link, as an address and as the code of a frame', async () => {
  const frame = { title: 'Which <one>?', question: 'Make them meet.', check: { cell: 3, neighbor: 2 } }
  expect(await actions.copyQuestion('link', frame)).toBe(copied.length)
  const address = copied
  expect(address).toMatch(/^https:\/\/example\.org\/circles\/embed\.html#\S+$/)
  const state = await decodeLink(address.split('#')[1] as string)
  expect(state).toMatchObject({ ...frame, check: { cell: 2, neighbor: 1 }, areas: AREAS })
  await actions.copyQuestion('code', frame)
  expect(copied).toMatch(/^<iframe /)
  expect(copied).toContain(address)
  expect(copied).toContain('title="Which &lt;one>?"')
  expect(copied).toContain('aspect-ratio: 4 / 3')
})

it('too many circles for a link are refused, and other errors are told', async () => {
  linkOf = async () => Promise.reject(new CircleVoronoiError('linkTooLong', 'x'))
  expect(await actions.copyLink()).toBeUndefined()
  expect(problem).toMatch(/too many circles for a link: save them as a file/)
  linkOf = async () => 'a'.repeat(2_000_001)
  problem = undefined
  expect(await actions.copyLink()).toBeUndefined()
  expect(problem).toMatch(/too many circles for a link/)
  linkOf = async () => Promise.reject(new Error('Out of order.'))
  expect(await actions.copyLink()).toBeUndefined()
  expect(problem).toBe('Out of order.')
})
