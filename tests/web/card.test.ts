// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, expect, it, vi } from 'vitest'
import { CARD, cardOf } from '../../web/app/files/card.ts'

afterEach(() => vi.unstubAllGlobals())

it('a card has the picture above a white caption, with the title on the left and the site on the right', async () => {
  const done: unknown[][] = []
  const context = {
    fillStyle: '',
    textAlign: '',
    drawImage: (...args: unknown[]) => done.push(['picture', ...args.slice(1)]),
    fillRect: (...box: unknown[]) => done.push([context.fillStyle, ...box]),
    fillText: (text: string, x: number, y: number) => done.push([context.textAlign, text, x < 600, y]),
  }
  vi.stubGlobal(
    'OffscreenCanvas',
    class {
      getContext = () => context
      convertToBlob = async () => 'a picture'
    },
  )
  vi.stubGlobal('createImageBitmap', async () => ({ close: () => done.push(['closed']) }))
  expect(await cardOf(new Blob(), 'Trees', 'example.org')).toBe('a picture')
  const { width, height, caption } = CARD
  expect(done).toEqual([
    ['picture', 0, 0, width, height - caption],
    ['closed'],
    ['#ffffff', 0, height - caption, width, caption],
    ['left', 'Trees', true, height - caption / 2],
    ['right', 'example.org', false, height - caption / 2],
  ])
})
