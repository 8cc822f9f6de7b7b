// SPDX-License-Identifier: GPL-3.0-or-later
// A computation that is started in the panel of numbers on the whole page.
// @vitest-environment happy-dom
import { beforeAll, expect, it } from 'vitest'
import { ThreadHere } from './page-threads.ts'
import { found, pressed, quiet, soon, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
let panel: HTMLElement
const text = () => panel.textContent ?? ''
beforeAll(async () => {
  page = await wholePage()
  panel = await page.panel('numbers')
})

it('has a result that is certified', async () => {
  await pressed(panel, 'Compute')
  await soon(() => expect(text()).toContain('This one is certified, too.'))
  expect((await found(panel, 'Compute')).disabled).toBe(false)
})

it.each([
  ['canceled', async () => (await found(panel, 'Cancel')).click()],
  ['overtaken by an edit', () => page.actions.circles.edit([{ kind: 'remove', id: 0 }])],
])('has no result if it is %s, and the figure is edited meanwhile', async (_, end) => {
  await page.open(Float64Array.of(0, 0, 2, 20, 0, 3, 20, 20, 1))
  ;(await found(panel, 'Compute')).click()
  expect(text()).toContain('Computing …')
  await end()
  await quiet()
  await found(panel, 'Compute')
  expect(text()).not.toContain('Computing …')
  expect(text()).not.toContain('certified, too')
  await page.actions.circles.edit([{ kind: 'insert', circle: [9, 9, 1] }])
  expect(page.store.get().problem).toBe('')
  expect([...ThreadHere.running].filter(({ name }) => name.startsWith('start-thread')).length).toBeLessThan(3)
})
