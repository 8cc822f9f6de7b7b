// SPDX-License-Identifier: GPL-3.0-or-later
// The page for a frame in another page, which shows what the link after the # of its address says.
import { expect, type Page, test } from '@playwright/test'
import { encodeLink } from '../../web/lib/link.ts'
import { got, heldBack } from './held-back.ts'

const WAKA = 504

const circlesOf = (page: Page) =>
  page.evaluate(
    () => (document.querySelector('circle-voronoi') as HTMLElementTagNameMap['circle-voronoi']).circles.length / 3,
  )

test('refuses a link that asks for more circles than links may', async ({ page }) => {
  await page.goto(`/embed.html#${await encodeLink({ dataSet: 'dense:1:1000000' })}`)
  await expect(page.getByRole('alert')).toHaveText('The link is for too many circles.')
})

test('shows the link that its address has last, though the one before is slower', async ({ page }) => {
  const answer = await heldBack('**/data/spruces.csv', page)
  const asked = page.waitForRequest('**/data/spruces.csv')
  await page.goto(`/embed.html#${await encodeLink({ dataSet: 'spruces' })}`)
  await asked
  const next = await encodeLink({ dataSet: 'waka' })
  await page.evaluate((link) => {
    location.hash = link
  }, next)
  await expect.poll(() => circlesOf(page)).toBe(WAKA)
  const answered = page.waitForResponse('**/data/spruces.csv')
  answer()
  await (await answered).finished()
  await got(page, 'data/spruces.csv')
  // Its thread draws after whatever was asked of it before.
  await page.evaluate(() => document.querySelector('circle-voronoi')?.toSVG())
  expect(await circlesOf(page)).toBe(WAKA)
  await expect(page.locator('#problem')).toBeHidden()
})
