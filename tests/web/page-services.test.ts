// SPDX-License-Identifier: GPL-3.0-or-later
// Services around the figure: data sets that are fetched, links in threads, free space, print, and style sheets.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { printWorksheet } from '../../web/app/files/worksheet.ts'
import { workOffline } from '../../web/app/offline.ts'
import { styleSheetsLoaded } from '../../web/app/style-sheets.ts'
import { all, element, openPage, textOf } from './page-document.ts'
import { settled } from './turns.ts'

beforeEach(() => void openPage())
afterEach(() => {
  vi.restoreAllMocks()
  vi.unstubAllGlobals()
  vi.useRealTimers()
})

describe('the free part of the picture', () => {
  const NONE = { left: 0, top: 0, right: 0, bottom: 0, width: 0, height: 0 }
  const boxOf = (left: number, top: number, width: number, height: number) => ({
    left,
    top,
    width,
    height,
    right: left + width,
    bottom: top + height,
  })
  const WIDE = {
    rail: boxOf(0, 50, 48, 600),
    top: boxOf(0, 0, 1000, 40),
    status: boxOf(0, 770, 300, 30),
    view: boxOf(900, 700, 48, 100),
  }

  /** The padding, with the boxes of some elements, and of the window. */
  async function padding(
    boxes: Record<string, typeof NONE>,
    { width = 1000, height = 800, panel = undefined as typeof NONE | undefined, is = [] as readonly string[] } = {},
  ) {
    vi.resetModules()
    vi.stubGlobal('innerWidth', width)
    vi.stubGlobal('innerHeight', height)
    vi.stubGlobal('getComputedStyle', () => ({ fontSize: '16px' }))
    openPage()
    element('files').hidden = panel === undefined
    for (const [id, box = NONE] of Object.entries({ ...boxes, files: panel })) {
      element(id).getBoundingClientRect = () => box as DOMRect
    }
    vi.stubGlobal('matchMedia', (query: string) => ({ matches: is.some((size) => query.includes(size)) }))
    const { paddingOfPage } = await import('../../web/app/padding.ts')
    return paddingOfPage()
  }

  it('is beside the rail and above the status, with room for the caption', async () => {
    expect(await padding(WIDE)).toEqual({ top: 56, right: 32, bottom: 116, left: 64 })
    // The status is higher than the caption.
    expect(await padding({ ...WIDE, view: boxOf(900, 600, 48, 100) })).toEqual({
      top: 56,
      right: 32,
      bottom: 216,
      left: 64,
    })
    expect(await padding({ ...WIDE, view: NONE })).toMatchObject({ bottom: 90 + 16 })
  })

  it('is beside an open panel and the player', async () => {
    expect(await padding(WIDE, { panel: boxOf(60, 50, 300, 600) })).toMatchObject({ left: 376, right: 32 })
    expect(await padding({ ...WIDE, player: boxOf(700, 50, 300, 600) })).toMatchObject({ left: 64, right: 316 })
    // The card for sharing leaves room except in low windows.
    const share = { ...WIDE, share: boxOf(700, 50, 250, 300) }
    expect(await padding(share)).toMatchObject({ right: 32 })
    expect(await padding(share, { is: ['max-height: 32em'] })).toMatchObject({ right: 316 })
  })

  it('is beside the caption in low windows, unless a panel takes its place', async () => {
    const low = { is: ['max-height: 32em'] }
    expect(await padding(WIDE, low)).toEqual({ top: 56, right: 32 + 13 * 16, bottom: 116, left: 64 })
    expect(await padding(WIDE, { ...low, panel: boxOf(60, 50, 300, 600) })).toMatchObject({ right: 32 })
    expect(await padding({ ...WIDE, player: boxOf(700, 50, 300, 600) }, low)).toMatchObject({ right: 316 })
    expect(await padding(WIDE, { is: ['max-height: 32em', 'max-width: 40em'] })).toMatchObject({ right: 32 })
  })

  const PHONE = { rail: boxOf(0, 740, 400, 60), top: boxOf(0, 0, 400, 40), status: boxOf(0, 710, 400, 30) }
  it('is above the rail and the caption of a phone, or above a sheet', async () => {
    const phone = { width: 400, height: 800, is: ['max-width: 40em'] }
    expect(await padding(PHONE, phone)).toEqual({ top: 56, right: 16, bottom: 800 - (710 - 90) + 16, left: 16 })
    expect(await padding(PHONE, { ...phone, is: ['max-width: 40em', 'max-width: 22em'] })).toMatchObject({
      bottom: 800 - (710 - 112) + 16,
    })
    expect(await padding(PHONE, { ...phone, panel: boxOf(0, 500, 400, 300) })).toEqual({
      top: 56,
      right: 16,
      bottom: 316,
      left: 16,
    })
    for (const name of ['player', 'share']) {
      expect(await padding({ ...PHONE, [name]: boxOf(0, 450, 400, 350) }, phone)).toMatchObject({
        right: 16,
        bottom: 366,
      })
    }
  })
})

describe('print', () => {
  it.each([
    [{}, 'en', ['Name:', 'Date:'], 'Try it: a.example/page/embed.html', 'The figure is too large for a code.'],
    [
      { lang: 'de' },
      'de',
      ['Name:', 'Datum:'],
      'Probiere es aus: a.example/page/embed.html',
      'Die Figur ist zu groß für einen Code.',
    ],
  ])(
    'has a worksheet with the question and a code, until it is closed: %j',
    async (frame, lang, names, tried, long) => {
      let prints = 0
      vi.stubGlobal('print', () => prints++)
      const place = element('worksheet')
      const sheet = async (address: string) => {
        const printing = printWorksheet(place, { title: 'T', question: 'Q?', ...frame }, '<svg><g/></svg>', address)
        const shown = {
          spans: all(place, 'span').map(textOf),
          texts: [textOf(place.querySelector('h1')), textOf(all(place, 'p')[1])],
          figures: all(place, 'figure *').map(({ localName }) => localName),
          foot: textOf(place.querySelector('footer')),
          code: place.querySelector('footer svg')?.getAttribute('viewBox'),
          isShown: !place.hidden,
          lang: place.lang,
        }
        window.dispatchEvent(new Event('afterprint'))
        await printing
        return shown
      }
      const address = 'https://a.example/page/embed.html#v1'
      const { code, ...shown } = await sheet(address)
      expect(shown).toEqual({
        spans: names,
        texts: ['T', 'Q?'],
        figures: ['svg', 'g'],
        foot: tried,
        isShown: true,
        lang,
      })
      // The white squares around the code.
      expect(code).toMatch(/^-4 -4 (\d+) \1$/)
      expect([prints, place.hidden, place.childNodes.length]).toEqual([1, true, 0])
      expect((await sheet(address.padEnd(1800, 'a'))).code).toBeDefined()
      expect(await sheet(address.padEnd(1801, 'a'))).toMatchObject({ code: undefined, foot: long })
    },
  )
})

it.each(['load', 'error'])('style sheets are waited for until each has loaded or failed: %s', async (kind) => {
  openPage('<link rel="stylesheet">'.repeat(3))
  const links = all(document.body, 'link')
  Object.defineProperty(links[1], 'sheet', { value: {} })
  let isLoaded = false
  const loaded = styleSheetsLoaded().then(() => {
    isLoaded = true
  })
  links[0]?.dispatchEvent(new Event(kind))
  await settled()
  expect(isLoaded).toBe(false)
  links[2]?.dispatchEvent(new Event(kind))
  await loaded
})

describe('the service worker', () => {
  const registered: string[] = []
  let isForbidden = false
  const register = async ({ href }: URL) => {
    registered.push(href)
    if (isForbidden) throw new Error('forbidden')
  }
  beforeEach(() => {
    registered.length = 0
    isForbidden = false
    document.body.innerHTML = '<base href="https://a.example/b/">'
    vi.stubEnv('PROD', true)
    vi.stubGlobal('navigator', { serviceWorker: { register } })
  })
  afterEach(() => vi.unstubAllEnvs())

  it('is registered in the folder of the site', async () => {
    await workOffline()
    await workOffline('../')
    isForbidden = true
    await workOffline()
    expect(registered).toEqual(['b/', '', 'b/'].map((folder) => `https://a.example/${folder}service-worker.js`))
  })

  it('is not registered during development, nor where there are none', async () => {
    vi.stubGlobal('navigator', {})
    await workOffline()
    vi.stubGlobal('navigator', { serviceWorker: { register } })
    vi.stubEnv('PROD', false)
    await workOffline()
    expect(registered).toEqual([])
  })
})
