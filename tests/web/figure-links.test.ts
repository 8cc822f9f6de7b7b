// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it, vi } from 'vitest'
import { decodeLink } from '../../web/lib/link.ts'
import { linkFigures } from '../../web/tutorial/figure-links.ts'

/** Compressing a link may take a busy machine longer than the default of one second. */
const SOON = { timeout: 40_000 }

it('the link of a figure leads to what it shows, with the method that is played in it', async () => {
  let state: object = { circles: Float64Array.of(1, 2, 3) }
  const figure = Object.assign(new EventTarget(), { getState: () => state, getAttribute: () => 'auto' })
  const link = Object.assign(new EventTarget(), {
    href: 'https://example.org/play/#v1.first',
    closest: () => ({ querySelector: () => figure }),
  })
  linkFigures({ querySelectorAll: () => [link] } as unknown as ParentNode)
  const shown = async (target: EventTarget, name: string) => {
    const before = link.href
    target.dispatchEvent(new Event(name))
    await vi.waitFor(() => expect(link.href).not.toBe(before), SOON)
    const [address, text] = link.href.split('#') as [string, string]
    expect(address).toBe('https://example.org/play/')
    return decodeLink(text)
  }
  expect(await shown(figure, 'circleschange')).toEqual({ circles: Float64Array.of(1, 2, 3) })
  state = { circles: Float64Array.of(4, 5, 6), step: 3 }
  expect(await shown(link, 'pointerenter')).toEqual({ circles: Float64Array.of(4, 5, 6), step: 3, method: 'auto' })
  state = { circles: Float64Array.of(4, 5, 6), step: 4 }
  expect(await shown(link, 'focus')).toMatchObject({ step: 4 })
})
