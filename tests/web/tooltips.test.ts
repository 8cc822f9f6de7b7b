// SPDX-License-Identifier: GPL-3.0-or-later
// Tooltips of icons, and the pictures of numbers, on the whole page.
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

it('the area of a single bounded cell has no histogram, and no circles have no picture at all', async () => {
  await page.panel('numbers')
  const charts = () => all(element('numbers'), '[role=img]')
  await soon(() => expect(charts()).toHaveLength(1))
  await page.open(new Float64Array())
  await soon(() => expect(textOf(element('numbers'))).toContain('No cell'))
  expect(charts()).toHaveLength(0)
  await page.open(Float64Array.from({ length: 75 }, (_, k) => [k % 5, Math.floor(k / 15), 0.1][k % 3] as number))
  await soon(() => expect(charts()).toHaveLength(2))
})
