// SPDX-License-Identifier: GPL-3.0-or-later
// Services around the figure: data sets that are fetched, links in threads, free space, print, and style sheets.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { styleSheetsLoaded } from '../../web/app/style-sheets.ts'
import { all, element, openPage } from './page-document.ts'
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

  const PHONE = { rail: boxOf(0, 740, 400, 60), top: boxOf(0, 0, 400, 40), status: boxOf(0, 710, 400, 30) }
  const PANEL = boxOf(60, 50, 300, 600)
  const [LOW, NARROW, SHORT_LINES] = ['max-height: 32em', 'max-width: 40em', 'max-width: 22em']
  const phone = { width: 400, is: [NARROW] }

  it.each<[string, Record<string, typeof NONE>, Parameters<typeof padding>[1], readonly number[]]>([
    // With room for the caption, or for buttons that are higher.
    ['beside the rail and above the caption', WIDE, {}, [56, 32, 116, 64]],
    ['above buttons that are higher', { ...WIDE, view: boxOf(900, 600, 48, 100) }, {}, [56, 32, 216, 64]],
    ['above the caption without buttons', { ...WIDE, view: NONE }, {}, [56, 32, 106, 64]],
    ['beside an open panel', WIDE, { panel: PANEL }, [56, 32, 116, 376]],
    ['beside the player', { ...WIDE, player: boxOf(700, 50, 300, 600) }, {}, [56, 316, 116, 64]],
    ['below the card for sharing', { ...WIDE, share: boxOf(700, 50, 250, 300) }, {}, [56, 32, 116, 64]],
    [
      'beside that card in low windows',
      { ...WIDE, share: boxOf(700, 50, 250, 300) },
      { is: [LOW] },
      [56, 316, 116, 64],
    ],
    ['beside the caption in low windows', WIDE, { is: [LOW] }, [56, 32 + 13 * 16, 116, 64]],
    ['without the caption beside a panel', WIDE, { is: [LOW], panel: PANEL }, [56, 32, 116, 376]],
    [
      'beside the player in low windows',
      { ...WIDE, player: boxOf(700, 50, 300, 600) },
      { is: [LOW] },
      [56, 316, 116, 64],
    ],
    ['above the caption in small windows', WIDE, { is: [LOW, NARROW] }, [56, 32, 116, 64]],
    ['above the rail and the caption of a phone', PHONE, phone, [56, 16, 196, 16]],
    ['above a caption of short lines', PHONE, { ...phone, is: [NARROW, SHORT_LINES] }, [56, 16, 218, 16]],
    ['above a sheet', PHONE, { ...phone, panel: boxOf(0, 500, 400, 300) }, [56, 16, 316, 16]],
    ['above the sheet of the player', { ...PHONE, player: boxOf(0, 450, 400, 350) }, phone, [56, 16, 366, 16]],
    ['above the sheet for sharing', { ...PHONE, share: boxOf(0, 450, 400, 350) }, phone, [56, 16, 366, 16]],
  ])('is %s', async (_, boxes, page, sides) => {
    const { top, right, bottom, left } = await padding(boxes, page)
    expect([top, right, bottom, left]).toEqual(sides)
  })
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
