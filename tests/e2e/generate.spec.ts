// SPDX-License-Identifier: GPL-3.0-or-later
// Families of random circles and figures of the paper.
import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { DATA_SETS } from '../../web/app/data-sets.ts'
import { loadGenerators } from '../../web/app/generators/generators.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { circlesOfText } from '../../web/view/circle-text.ts'
import { soon } from '../soon.ts'
import { type App, expect, test } from './page.ts'

const generators = await loadGenerators()
const stateOf = (app: App) => decodeLink(new URL(app.page.url()).hash).catch(() => undefined)

async function saved(page: Page): Promise<Float64Array> {
  const download = page.waitForEvent('download')
  await page.getByRole('button', { name: 'CSV' }).click()
  return circlesOfText(readFileSync(await (await download).path(), 'utf8'))
}

test('the gallery pictures each data set, and opens the one that is chosen', async ({ eight: app }) => {
  const { page } = app
  await app.openPanel('Gallery')
  const tiles = page.getByRole('list', { name: 'Data sets' }).locator('button')
  await expect(tiles).toHaveCount(DATA_SETS.length)
  // Each has its own circles.
  const pictures = () => tiles.locator('.frame').evaluateAll((frames) => frames.map(({ innerHTML }) => innerHTML))
  await soon(async () => (await pictures()).filter((picture) => picture.includes('<svg')).length).toBe(DATA_SETS.length)
  expect(new Set(await pictures()).size).toBe(DATA_SETS.length)
  await expect(page.getByLabel('Random seed')).toBeHidden()
  const tile = page.getByRole('button', { name: /^Spruces/ })
  await tile.click()
  await expect(app.status).toContainText('134 circles')
  await expect(tile).toHaveAttribute('aria-current', 'true')
})

test('a family with a number and a seed, again, edited, and the same after a reload', async ({ app }) => {
  const { page } = app
  await page.getByLabel('Data set', { exact: true }).selectOption({ label: 'More …' })
  const panel = page.getByRole('region', { name: 'Gallery' })
  await expect(panel.getByRole('button', { name: /^Eight circles/ })).toBeFocused()
  await expect(page.getByLabel('Data set', { exact: true })).toHaveValue('bronzefilter')
  await page.getByText('Hard inputs', { exact: true }).click()
  await panel.getByLabel('Number of circles').fill('50')
  await panel.getByLabel('Random seed').fill('7')
  await panel.getByRole('button', { name: /^clustered/ }).click()
  await expect(app.status).toContainText('50 circles')
  await soon(() => stateOf(app)).toEqual({ dataSet: 'clustered:7:50' })
  await app.openPanel('Files')
  expect(await saved(page)).toEqual(generators.make({ kind: 'family', family: 'clustered', seed: 7, count: 50 }))
  await app.openPanel('Gallery')

  // A number that the browser refuses changes nothing; a valid one takes effect at once.
  await panel.getByLabel('Number of circles').fill('0')
  await panel.getByLabel('Number of circles').press('Enter')
  await expect(app.status).toContainText('50 circles')
  await panel.getByLabel('Number of circles').fill('60')
  await panel.getByLabel('Number of circles').press('Enter')
  await expect(app.status).toContainText('60 circles')
  await page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toContainText('50 circles')
  await page.getByRole('button', { name: 'Redo' }).click()
  await expect(app.status).toContainText('60 circles')
  await soon(() => stateOf(app)).toEqual({ dataSet: 'clustered:7:60' })

  await page.getByRole('button', { name: 'Another random sample' }).click()
  await soon(async () => (await stateOf(app))?.dataSet).toMatch(/^clustered:(?!7:)\d+:60$/)
  const name = (await stateOf(app))?.dataSet as string
  await expect(panel.getByLabel('Random seed')).toHaveValue(name.split(':')[1] as string)

  await page.locator('#figure').focus()
  await page.keyboard.press('Enter')
  await expect(app.inspector).toBeVisible()
  await page.keyboard.press('Delete')
  await expect(app.status).toContainText('59 circles')
  await soon(async () => (await stateOf(app))?.edits?.length).toBe(1)
  await app.openPanel('Files')
  const edited = await saved(page)
  await app.openPanel('Gallery')
  await page.reload()
  await expect(app.status).toContainText('59 circles')
  await expect(panel.getByRole('button', { name: /^clustered/ })).toHaveAttribute('aria-current', 'true')
  await app.openPanel('Files')
  expect(await saved(page)).toEqual(edited)
})

test('a figure of the paper, and links to what is none', async ({ app }) => {
  const { page } = app
  await app.openPanel('Gallery')
  await page.getByText('Hard inputs', { exact: true }).click()
  await page.getByRole('button', { name: /^Figure 13b/ }).click()
  await expect(app.status).toContainText('14 circles')
  await expect(page.getByLabel('Data set', { exact: true }).locator('option:checked')).toHaveText('Figure 13b')
  await soon(() => stateOf(app)).toEqual({ dataSet: 'figure-13b' })
  for (const [dataSet, problem] of [
    ['nonsense:1:5', 'There is no family "nonsense".'],
    ['figure-99', 'There is no figure "99".'],
    ['grid:1:100001', 'The link is for too many circles.'],
  ] as const) {
    const link = await encodeLink({ dataSet })
    await page.evaluate((link) => {
      location.hash = link
    }, link)
    await expect(page.getByRole('alert')).toHaveText(problem)
    await expect(app.status).toContainText('14 circles')
  }
})
