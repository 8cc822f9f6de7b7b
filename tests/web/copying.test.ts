// SPDX-License-Identifier: GPL-3.0-or-later
// Code and addresses that the page copies, without a browser.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { FileActions } from '../../web/app/files/file-actions.ts'
import { attributesOfLink, namedAs } from '../../web/editing/attributes.ts'
import type { CircleSet } from '../../web/editing/history.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { editingSession, sceneOf } from './editing-session.ts'

const CIRCLES = Float64Array.of(1, 1, 1, 5, 5, 2)
const TRIANGLE = [
  [0, 0],
  [9, 0],
  [0, 9],
] as const

let copied: string[]
beforeEach(() => {
  copied = []
  class Item {
    readonly text: Promise<Blob>
    constructor(items: Readonly<Record<string, Promise<Blob>>>) {
      this.text = items['text/plain'] as Promise<Blob>
    }
  }
  const write = async ([item]: [Item]) => copied.push(await (await item.text).text())
  vi.stubGlobal('ClipboardItem', Item)
  vi.stubGlobal('navigator', { clipboard: { write } })
  vi.stubGlobal('location', { origin: 'https://example.org', pathname: '/page/' })
  vi.stubGlobal('requestAnimationFrame', () => 0)
})
afterEach(() => vi.unstubAllGlobals())

async function started(more: Partial<CircleSet> = {}) {
  const session = editingSession()
  const { store, editing, view, actions } = session
  await editing.open({ ...sceneOf(CIRCLES, 'grid:5:2'), ...more })
  const files = new FileActions(store, editing, actions as never, view, { links: { linkOf: encodeLink } } as never)
  return { ...session, files }
}
const linkIn = (text = '') => decodeLink(/#(v[\w.-]+)/.exec(text)?.[1] ?? '')

it('the code of an element has the circles of a data set, their region, areas, attributes and colors', async () => {
  const domain = { region: [TRIANGLE], areas: [1, 2] }
  const attributes = namedAs(['a', 'b'])
  const { files } = await started({ domain, attributes, colors: '34' })
  expect(await files.copyElementCode()).toBe(copied[0]?.length)
  expect(copied[0]).toContain('<script type="module" src="https://example.org/page/element.js"></script>')
  expect(copied[0]).toMatch(/ controls><\/circle-voronoi>$/)
  const state = await linkIn(copied[0])
  const { circles, region, areas, colors } = state
  expect([circles, region, areas, colors]).toEqual([CIRCLES, [TRIANGLE], [1, 2], '34'])
  expect(attributesOfLink(state, 2)?.columns).toEqual(attributes.columns)
})

it('the code of an element has the box, the layers, the viewport and the step', async () => {
  const lattice = { a: [9, 0], b: [0, 9] } as const
  const { files, store, fake } = await started({ domain: { region: undefined, lattice, areas: undefined } })
  fake.setLayers({ hull: true })
  store.update((state) => ({ ...state, step: 3, method: 'flip' }))
  await files.copyElementCode()
  expect(copied[0]).toContain(' controls="player">')
  expect(await linkIn(copied[0])).toMatchObject({
    lattice,
    layers: { hull: true },
    step: 3,
    method: 'flip',
    view: { x: 0, y: 0, span: 100 },
  })
})

it('the address of circles is that of the page, and that of a frame is that of the page for frames', async () => {
  const { files, store } = await started()
  await files.copyLink()
  await files.copyEmbedCode()
  store.update((state) => ({ ...state, step: 3 }))
  await files.copyEmbedCode()
  const [link, frame, player] = copied
  expect(link).toMatch(/^https:\/\/example\.org\/page\/#v/)
  expect((await linkIn(link)).circles).toEqual(CIRCLES)
  expect(frame).toMatch(/^<iframe src="https:\/\/example\.org\/page\/embed\.html#v/)
  // The player needs room below its figure.
  expect([frame, player].map((code) => /aspect-ratio: ([^;]*);/.exec(code ?? '')?.[1])).toEqual(['3 / 2', '1'])
})

it('the code of a question is a frame with its title, and its link is the address', async () => {
  const { files, store } = await started()
  const question = { title: '"T" <&', question: 'Q?' }
  expect(await files.copyQuestion('link', question)).toBe(copied[0]?.length)
  await files.copyQuestion('code', question)
  await files.copyQuestion('code', {})
  store.update((state) => ({ ...state, step: 3 }))
  await files.copyQuestion('code', question)
  const [link, code, untitled, player] = copied
  expect(link).toMatch(/^https:\/\/example\.org\/page\/embed\.html#v[\w.-]+$/)
  expect(await linkIn(link)).toMatchObject({ ...question, circles: CIRCLES })
  expect([code, untitled].map((text) => /title="(.*?)"/.exec(text ?? '')?.[1])).toEqual([
    '&quot;T&quot; &lt;&amp;',
    'Voronoi diagram of circles',
  ])
  expect([code, player].map((text) => /aspect-ratio: ([^;]*);/.exec(text ?? '')?.[1])).toEqual(['4 / 3', '1'])
})

it('what cannot be copied is said', async () => {
  const { files, store } = await started()
  const write = async ([item]: [{ text: Promise<Blob> }]) => {
    await item.text
    throw new Error('Not allowed.')
  }
  vi.stubGlobal('navigator', { clipboard: { write } })
  expect(await files.copyLink()).toBeUndefined()
  expect(store.get().problem).toBe('Not allowed.')
})
