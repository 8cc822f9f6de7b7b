// SPDX-License-Identifier: GPL-3.0-or-later
// Long operations show their progress and can be canceled.
import { got, heldBack } from './held-back.ts'
import { expect, test } from './page.ts'
import { threadOf } from './thread-session.ts'

test('what is loaded has a bar and can be canceled; what was wrong before goes at once', async ({ app }) => {
  const { page } = app
  const progress = page.locator('#progress')
  await app.openPanel('Files')
  await page
    .getByLabel('Open …')
    .setInputFiles({ name: 'a.csv', mimeType: 'text/csv', buffer: Buffer.from('0,0,-1\n') })
  await expect(page.getByRole('alert')).toContainText('negative radius')
  const answer = await heldBack('**/data/spruces.csv', page)
  await page.getByLabel('Data set').selectOption({ label: 'Spruces' })
  await expect(page.getByRole('alert')).toBeHidden()
  await expect(progress).toContainText('Loading …')
  await expect(progress.getByRole('progressbar')).toBeVisible()
  await progress.getByRole('button', { name: 'Cancel' }).click()
  await expect(progress).toBeHidden()
  // A late response is not opened.
  const answered = page.waitForResponse('**/data/spruces.csv')
  answer()
  await (await answered).finished()
  await got(page, 'data/spruces.csv')
  await app.canvas.focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press('Delete')
  await expect(app.status).toContainText('677 circles')
})

test('a long computation says how many circles it is of, and canceled leaves what was there', async ({ app }) => {
  const { page } = app
  const progress = page.locator('#progress')
  await app.select((await app.circles()) as Float64Array, 600)
  const before = await app.status.textContent()
  await app.openPanel('Gallery')
  const panel = page.getByRole('region', { name: 'Gallery' })
  await panel.getByText('Hard inputs', { exact: true }).click()
  // The thread never receives the circles, so it computes as long as the test needs. A new thread takes over.
  await threadOf(page).evaluate(() => {
    const thread = globalThis as unknown as { onmessage(event: MessageEvent): void }
    const hear = thread.onmessage
    thread.onmessage = (event) => event.data.name !== 'open' && hear(event)
  })
  await panel.getByLabel('Number of circles').fill('600')
  await panel.getByLabel('Number of circles').press('Enter')
  await panel.getByRole('button', { name: /^points/ }).click()
  await expect(progress).toContainText('Computing the diagram of 600 circles …')
  // The selection belonged to the former circles.
  await expect(app.inspector).toBeHidden()
  await progress.getByRole('button', { name: 'Cancel' }).click()
  await expect(progress).toBeHidden()
  await expect(page.locator('#toast')).toContainText('Canceled. Nothing has changed.')
  await expect(page.getByRole('alert')).toBeHidden()
  expect(await app.status.textContent()).toBe(before)
  // The page continues to work.
  await expect(app.inspector).toContainText('Circle 600')
  await app.painted()
  await app.canvas.focus()
  await page.keyboard.press('Delete')
  await expect(app.status).toContainText('677 circles')
})
