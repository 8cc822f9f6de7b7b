// SPDX-License-Identifier: GPL-3.0-or-later
// Tooltips of icons, and the numbers of a diagram with one bounded cell, on the whole page.
// @vitest-environment happy-dom
import { beforeAll, expect, it } from 'vitest'
import { all, element, send, textOf } from './page-document.ts'
import { soon, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
beforeAll(async () => {
  page = await wholePage()
})

it("a tooltip has the name and the key of its icon, in place of the browser's own", async () => {
  const undo = element('undo')
  await soon(() => {
    send(undo, 'pointerover', { pointerType: 'mouse' })
    expect(textOf(element('tooltip'))).toBe('Undo Ctrl+Z')
  })
  // The browser's own tooltip would be a second one.
  expect(undo.hasAttribute('title')).toBe(false)
})

it('the area of a single bounded cell has no histogram', async () => {
  await page.panel('numbers')
  await soon(() => expect(all(element('numbers'), '.chart')).toHaveLength(1))
})
