// SPDX-License-Identifier: GPL-3.0-or-later
// The scripts of the embedded page and of a course, with a frame that records what it is told to show.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { encodeLink } from '../../web/lib/link.ts'

interface Options {
  load(dataSet: string): Promise<unknown>
  tell(message: unknown): void
}
const frames = vi.hoisted(
  () => [] as { main: unknown; options: Options; calls: unknown[][]; open: () => Promise<void> }[],
)
vi.mock('../../web/embed/frame.ts', () => ({
  Frame: class {
    readonly calls: unknown[][] = []
    constructor(main: unknown, options: Options) {
      Object.assign(this, { main, options })
      frames.push(this as never)
    }
    open = async (link: string) => {
      this.calls.push(['open', link])
    }
    request = async (request: unknown) => {
      this.calls.push(['request', request])
    }
    restore = (circles: Float64Array) => this.calls.push(['restore', ...circles])
  },
}))
vi.mock('../../web/element/index.ts', () => ({}))
vi.mock('../../web/app/files/files-client.ts', () => ({
  FilesClient: class {
    call = async (...args: unknown[]) => ['made', ...args]
  },
}))
vi.mock('../../web/app/data-sets.ts', () => ({
  loadLinked: async (name: string, make: (recipe: unknown) => unknown) => [name, await make('recipe')],
}))

let window: EventTarget & { parent?: unknown; API?: object; opener: null }
let parts: Record<string, unknown>
let sent: unknown[][]
beforeEach(() => {
  vi.resetModules()
  frames.length = 0
  sent = []
  window = Object.assign(new EventTarget(), { opener: null })
  parts = { main: { dataset: {} }, '#open': { href: '' } }
  vi.stubGlobal('window', window)
  vi.stubGlobal('location', { hash: '#v1.first' })
  vi.stubGlobal('document', { querySelector: (selector: string) => parts[selector] })
  vi.stubGlobal('customElements', { whenDefined: async () => {} })
})
afterEach(() => vi.unstubAllGlobals())
const frame = () => frames[0] as (typeof frames)[number]

async function embedded(isFramed: boolean) {
  const parent = { postMessage: (...args: unknown[]) => sent.push(args) }
  window.parent = isFramed ? parent : window
  await import('../../web/embed/embed.ts')
  const message = (source: unknown, data: unknown) => {
    window.dispatchEvent(Object.assign(new Event('message'), { source, data }))
  }
  return { parent, message }
}

it('an embedded page shows the link of its address, also after it has changed, and links to the playground', async () => {
  await embedded(false)
  expect([frame().main, frame().calls, parts['#open']]).toEqual([
    parts.main,
    [['open', '#v1.first']],
    { href: './#v1.first' },
  ])
  vi.stubGlobal('location', { hash: '#v1.second' })
  window.dispatchEvent(new Event('hashchange'))
  expect([frame().calls.at(-1), parts['#open']]).toEqual([['open', '#v1.second'], { href: './#v1.second' }])
  expect(await frame().options.load('dense')).toEqual(['dense', ['made', 'make', 'recipe']])
})

it('an embedded page tells its parent alone, and listens to it alone', async () => {
  const { parent, message } = await embedded(true)
  frame().options.tell({ height: 3 })
  expect(sent).toEqual([[{ height: 3 }, '*']])
  const request = { type: 'circle-voronoi', state: {} }
  for (const [source, data] of [
    [{}, request],
    [parent, { ...request, type: 'other' }],
    [parent, null],
    [parent, 'circle-voronoi'],
    [parent, request],
  ] as const)
    message(source, data)
  expect(frame().calls.slice(1)).toEqual([['request', request]])
})

it('a page that is in no frame tells nobody, and listens to nobody', async () => {
  const { message } = await embedded(false)
  frame().options.tell({ height: 3 })
  message(window, { type: 'circle-voronoi', state: {} })
  expect([sent, frame().calls.length]).toEqual([[], 1])
})

/** A course whose system has kept some data. */
async function course(suspended: string, link: object = {}) {
  const values: Record<string, string> = { 'cmi.suspend_data': suspended }
  const calls: string[] = []
  window.parent = window
  window.API = {
    LMSInitialize: () => calls.push('initialize'),
    LMSGetValue: (name: string) => values[name] ?? '',
    LMSSetValue: (name: string, value: string) => (values[name] = value),
    LMSCommit: () => calls.push('commit'),
    LMSFinish: () => calls.push('finish'),
  }
  parts.main = { dataset: { link: await encodeLink({ circles: [[0, 0, 1]], ...link }) } }
  await import('../../web/embed/course.ts')
  return { values, calls }
}

it('a course shows its link, then the circles of the last session, and ends the session once', async () => {
  const { values, calls } = await course(await encodeLink({ circles: [[5, 6, 7]] }))
  expect(frame().calls).toEqual([
    ['open', (parts.main as { dataset: { link: string } }).dataset.link],
    ['restore', 5, 6, 7],
  ])
  await expect(frame().options.load('cities')).rejects.toThrow('There is no data set "cities" here.')
  frame().options.tell({ state: { circles: [[8, 8, 8]], layers: {} }, met: true })
  for (const _ of [1, 2]) window.dispatchEvent(new Event('pagehide'))
  expect(calls).toEqual(['initialize', 'commit', 'commit', 'commit', 'finish'])
  expect(values['cmi.core.lesson_status']).toBe('passed')
})

it('a course with a check is incomplete, and ignores what other programs have left', async () => {
  const { values } = await course('v9.none', { check: { circles: 1 } })
  expect(frame().calls).toHaveLength(1)
  expect(values['cmi.core.lesson_status']).toBe('incomplete')
})

it('a course without a system is a page like others', async () => {
  window.parent = window
  parts.main = { dataset: { link: await encodeLink({ circles: [[0, 0, 1]] }) } }
  await import('../../web/embed/course.ts')
  expect(frame().calls).toHaveLength(1)
  frame().options.tell({})
  expect(() => window.dispatchEvent(new Event('pagehide'))).not.toThrow()
})
