// SPDX-License-Identifier: GPL-3.0-or-later
// @vitest-environment happy-dom
import { expect, it } from 'vitest'
import { decodeLink } from '../../web/lib/link.ts'
import { linkFigures } from '../../web/tutorial/figure-links.ts'
import { make, send } from './page-document.ts'
import { eventually } from './turns.ts'

it('the link of a figure leads to what it shows, with the method that is played in it', async () => {
  let state: object = { circles: Float64Array.of(1, 2, 3) }
  const figure = Object.assign(document.createElement('circle-voronoi'), { getState: () => state })
  figure.setAttribute('method', 'auto')
  const link = make('a', { className: 'open', href: 'https://example.org/play/#v1.first' })
  document.body.replaceChildren(make('figure', {}, figure, link))
  linkFigures(document)
  const shown = async (target: Element, name: string) => {
    const before = link.href
    send(target, name)
    await eventually(() => expect(link.href).not.toBe(before))
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
