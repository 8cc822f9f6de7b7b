// SPDX-License-Identifier: GPL-3.0-or-later
// Links, the state after a reload or in the next tab, and openings that lose nothing.

import { compressText } from '../../web/lib/base/compressed-text.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { got, heldBack } from './held-back.ts'
import { App, dataSet, expect, test } from './page.ts'

const INTRODUCTION = dataSet('introduction')
const hashOf = (app: App) => new URL(app.page.url()).hash

test('the address is that of what is shown, and another page shows the same', async ({ app, browser }) => {
  await app.choose('Introduction')
  const at = app.center(INTRODUCTION, 4)
  await app.select(INTRODUCTION, 4)
  await app.field('x').fill('-3.25')
  await app.field('x').press('Enter')
  await soon(() => decodeLink(hashOf(app)).catch(() => undefined)).toMatchObject({
    dataSet: 'introduction',
    edits: [{ kind: 'replace', id: 4, circle: { x: -3.25, y: INTRODUCTION[13], r: INTRODUCTION[14] } }],
  })

  const context = await browser.newContext()
  const other = new App(await context.newPage())
  await other.page.goto(app.page.url())
  await expect(other.status).toContainText('14 circles')
  await expect(other.page.getByLabel('Data set').locator('option:checked')).toHaveText('Introduction, edited')
  await expect(other.page.getByRole('button', { name: 'Undo' })).toBeEnabled()
  await other.page.mouse.click(at.x, at.y)
  await expect(other.field('x')).toHaveValue('-3.25')
  // Opening a link can be undone like an edit.
  await other.page.keyboard.press('Control+z')
  await expect(other.field('x')).toHaveValue(String(INTRODUCTION[12]))
  await context.close()
})

test('what was changed is there after a reload at once', async ({ app }) => {
  await app.choose('Introduction')
  // The reload uses the address from before the change.
  await soon(async () => (await decodeLink(hashOf(app))).dataSet).toBe('introduction')
  await app.canvas.focus()
  // Enter selects the circle in the middle, and Delete waits for it.
  await app.page.keyboard.press('Enter')
  await app.page.keyboard.press('Delete')
  await expect(app.status).toContainText('13 circles')
  await app.page.reload()
  await expect(app.status).toContainText('13 circles')
})

test('a link that is opened once more shows what it says, whatever was changed there as the page was left', async ({
  app,
}) => {
  const { page, status } = app
  await app.choose('Introduction')
  await soon(async () => (await decodeLink(hashOf(app))).dataSet).toBe('introduction')
  const link = page.url()
  // The page is left before it has saved the change.
  await page.evaluate(() => {
    for (let timer = window.setTimeout(() => {}); timer > 0; timer--) clearTimeout(timer)
    window.setTimeout = (() => 0) as unknown as typeof setTimeout
  })
  await app.canvas.focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press('Delete')
  await expect(status).toContainText('13 circles')
  await page.goto('about:blank')
  await page.goto(link)
  await expect(status).toContainText('14 circles')
})

test('the view is in the address unless everything is shown', async ({ app }) => {
  await app.page.mouse.move(640, 400)
  await app.page.mouse.wheel(0, -300)
  await soon(async () => (await decodeLink(hashOf(app)).catch(() => undefined))?.view?.span).toBeLessThan(10)
  const span = (await decodeLink(hashOf(app))).view?.span as number
  await app.page.reload()
  await expect(app.status).toContainText('678 circles')
  await app.page.mouse.wheel(0, 1)
  await soon(async () => (await decodeLink(hashOf(app))).view?.span).not.toBe(span)
  expect((await decodeLink(hashOf(app))).view?.span).toBeCloseTo(span, 1)
})

test('a link that is pasted into the address is shown, and undo goes back', async ({ app }) => {
  const link = await encodeLink({
    circles: Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1),
  })
  await app.page.evaluate((link) => {
    location.hash = link
  }, link)
  await expect(app.status).toContainText('3 circles')
  await expect(app.page.getByLabel('Data set')).toHaveValue('')
  await app.page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toContainText('678 circles')
  await expect(app.page.getByLabel('Data set')).toHaveValue('bronzefilter')
  await app.page.getByRole('button', { name: 'Redo' }).click()
  await expect(app.status).toContainText('3 circles')
})

test('choosing another data set throws no edits away', async ({ app }) => {
  await app.choose('Introduction')
  await app.select(INTRODUCTION, 4)
  await app.page.keyboard.press('Delete')
  await expect(app.status).toContainText('13 circles')
  await app.choose('Spruces')
  await expect(app.status).toContainText('134 circles')
  const undo = app.page.getByRole('button', { name: 'Undo' })
  await undo.click()
  await expect(app.status).toContainText('13 circles')
  const chosen = app.page.getByLabel('Data set')
  await expect(chosen.locator('option:checked')).toHaveText('Introduction, edited')
  // Choosing the data set again reverts the edits, and undo restores them.
  await chosen.selectOption({ label: 'Introduction' })
  await expect(app.status).toContainText('14 circles')
  await expect(chosen).toHaveValue('introduction')
  await undo.click()
  await expect(app.status).toContainText('13 circles')
  await undo.click()
  await expect(app.status).toContainText('14 circles')
})

test('a link that is wrong shows an error, and the page works', async ({ app }) => {
  // encodeLink refuses such circles, so the link is packed by hand.
  const invalid = `v1.${await compressText(JSON.stringify({ circles: [0, 0, -1], view: [1e300, 0, 1e-300] }))}`
  for (const [what, link, says] of [
    ['damaged', 'v1.AAAA', /cannot be read/],
    ['from a later version', 'v9.AAAA', /version 9/],
    ['to what no page has', await encodeLink({ dataSet: '../../etc/passwd' }), /no data set/],
    ['with a circle that is none', invalid, /radius/],
  ] as const) {
    await test.step(what, async () => {
      const opened = new App(await app.page.context().newPage())
      for (const { page, status } of [app, opened]) {
        await page.goto(`/#${link}`)
        await expect(page.getByRole('alert')).toContainText(says)
        // The old circles stay, or the first data set is shown.
        await expect(status).toHaveText(page === app.page ? /^678 circles/ : /^8 circles/)
      }
      await opened.choose('Introduction')
      await expect(opened.status).toContainText('14 circles')
      await expect(opened.page.getByRole('alert')).toBeHidden()
      await opened.page.close()
    })
  }
})

test('what is chosen while a slow link is loaded stays, and is kept', async ({ app }) => {
  const { page } = app
  const slow = await encodeLink({ dataSet: 'spruces', edits: [{ kind: 'remove', id: 0 }] })
  const quick = await encodeLink({ circles: [[0, 0, 1]] })
  const opened = new App(await page.context().newPage())
  const answer = await heldBack('**/spruces.csv', page, opened.page)
  // Opens the link at the start of one page, and by the address of another.
  await opened.page.goto(`/#${slow}`)
  await opened.page.getByLabel('Data set').selectOption({ label: 'Introduction' })
  await expect(opened.status).toContainText('14 circles')
  await soon(async () => (await decodeLink(hashOf(opened))).dataSet).toBe('introduction')
  const go = (link: string) =>
    page.evaluate((link) => {
      location.hash = link
    }, link)
  await go(slow)
  await go(quick)
  await expect(app.status).toContainText('1 circle')
  const answered = [page, opened.page].map((page) => page.waitForResponse('**/spruces.csv'))
  answer()
  for (const response of answered) await (await response).finished()
  for (const { page } of [app, opened]) await got(page, 'data/spruces.csv')
  // The edit comes after anything that would have been opened.
  await opened.canvas.focus()
  await opened.page.keyboard.press('Enter')
  await opened.page.keyboard.press('Delete')
  await expect(opened.status).toContainText('13 circles')
  await expect(app.status).toContainText('1 circle')
  for (const { page } of [opened, app]) await expect(page.getByRole('alert')).toBeHidden()
  await app.canvas.focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press('Delete')
  await expect(app.status).toContainText('0 circles')
  await soon(async () => (await decodeLink(hashOf(app))).circles).toHaveLength(0)
})

test('a tab that was closed loses nothing, and two tabs do not destroy each other’s', async ({ app }) => {
  const context = app.page.context()
  await app.choose('Introduction')
  await soon(async () => (await decodeLink(hashOf(app))).dataSet).toBe('introduction')
  const second = new App(await context.newPage())
  await second.open('')
  await expect(second.status).toHaveText(/^8 circles/)
  await second.choose('Spruces')
  await soon(async () => (await decodeLink(hashOf(second)).catch(() => ({ dataSet: '' }))).dataSet).toBe('spruces')
  await app.page.goto('/')
  await expect(app.status).toContainText('14 circles')
  await second.page.close()
  // The browser releases the lock of its name a moment later.
  const heldNames = () => app.page.evaluate(async () => (await navigator.locks.query()).held?.length)
  await soon(heldNames).toBe(1)
  const third = new App(await context.newPage())
  await third.open('')
  await expect(third.status).toContainText('134 circles')
  await expect(app.status).toContainText('14 circles')
})

test('many circles, too many for an address, are there again after a reload', async ({ app }) => {
  const circles = Float64Array.from({ length: 3 * 6000 }, (_, k) => {
    const i = Math.floor(k / 3)
    return [(i % 80) + Math.sin(i) / 4, Math.floor(i / 80) + Math.cos(i) / 4, 0.1][k % 3] as number
  })
  const link = await encodeLink({ circles })
  await app.page.evaluate((link) => {
    location.hash = link
  }, link)
  await expect(app.status).toContainText('6,000 circles')
  const longestKept = () =>
    app.page.evaluate(() => Math.max(0, ...Object.values(localStorage).map((kept) => kept.length)))
  await soon(longestKept).toBeGreaterThan(100_000)
  await soon(() => hashOf(app)).toBe('')
  await app.page.reload()
  await expect(app.status).toContainText('6,000 circles')
})
