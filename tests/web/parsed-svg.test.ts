// SPDX-License-Identifier: GPL-3.0-or-later
// @vitest-environment happy-dom
import { expect, it } from 'vitest'
import { escaped } from '../../web/lib/drawing/escaped.ts'
import { parsedSvg } from '../../web/view/parsed-svg.ts'

it('a drawing has the names and attributes that were written, whatever signs they contain', () => {
  const name = `<A> & "B" 'C' &#38; &quot;`
  const drawing = parsedSvg(
    `<svg xmlns="http://www.w3.org/2000/svg"><text class="${escaped(name)}">${escaped(name)}</text></svg>`,
  )
  const text = drawing?.firstElementChild
  expect([text?.textContent, text?.getAttribute('class')]).toEqual([name, name])
})
