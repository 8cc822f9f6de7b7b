// SPDX-License-Identifier: GPL-3.0-or-later
// Files with rows without a position: the error offers to skip these rows, and says how many there are.
import { encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { expect, test } from './page.ts'

test.use({ link: await encodeLink({ dataSet: 'introduction' }) })

const FILES = [
  ['missing.csv', 'Skip 2 rows', '3 circles'],
  ['missing-radius.csv', 'Skip 1 row', '2 circles'],
  ['null-geometry.geojson', 'Skip 1 row', '2 circles'],
] as const
const pathOf = (name: string) => new URL(`../files/brought/${name}`, import.meta.url).pathname

for (const [name, label, circles] of FILES) {
  test(`the error of ${name} offers to skip rows, and they are counted`, async ({ app }, testInfo) => {
    const { page } = app
    await app.openPanel('Files')
    const before = await app.status.textContent()
    await page.getByLabel('Open …').setInputFiles(pathOf(name))
    const alert = page.getByRole('alert')
    await expect(alert).toContainText(name)
    expect(await app.status.textContent()).toBe(before)
    await page.screenshot({ path: testInfo.outputPath('skip.png') })
    await alert.getByRole('button', { name: label }).click()
    await expect(app.status).toContainText(circles)
    await expect(alert).toBeHidden()
    await expect(page.locator('#toast')).toContainText(`${label.slice('Skip '.length)} skipped.`)
  })
}

test('the way out is gone with its error', async ({ app }) => {
  const { page } = app
  await app.openPanel('Files')
  const [name, label] = FILES[0]
  await page.getByLabel('Open …').setInputFiles(pathOf(name))
  const alert = page.getByRole('alert')
  await expect(alert.getByRole('button', { name: label })).toBeVisible()
  await page
    .getByLabel('Open …')
    .setInputFiles({ name: 'wrong.csv', mimeType: 'text/plain', buffer: Buffer.from('0,0,1\n1,x,1') })
  await expect(alert).toContainText('wrong.csv')
  await expect(alert.getByRole('button', { name: label })).toHaveCount(0)
})

test('columns that were chosen keep rows, names and what can be skipped', async ({ app }) => {
  const { page } = app
  await app.openPanel('Files')
  // Without its radius, which nobody would guess.
  await page.getByLabel('Open …').setInputFiles(pathOf('filialen.csv'))
  const dialog = page.getByRole('dialog', { name: 'Which columns are the circles?' })
  await dialog.getByLabel('radius').selectOption('the same for all')
  await dialog.getByLabel('r', { exact: true }).fill('0.25')
  await dialog.getByLabel('r', { exact: true }).press('Tab')
  await dialog.getByRole('button', { name: 'Open' }).click()
  const circles = Float64Array.of(8.55, 47.4, 0.25, 7.45, 46.95, 0.25, 7.6, 47.55, 0.25)
  await soon(() => app.circles()).toEqual(circles)
  await app.openPanel('Table')
  const grid = page.getByRole('grid', { name: 'Circles' })
  await expect(grid.getByRole('row').nth(1)).toContainText('Zürich; Nord')
  await expect(grid.getByRole('columnheader')).toContainText(['umsatz'])

  await app.openPanel('Files')
  const text = 'ort;rechtswert;hochwert;durchmesser\nA;1;2;1\nB;;2;1\nC;9;2;1,5\n'
  const file = { name: 'odd.csv', mimeType: 'text/csv', buffer: Buffer.from(text) }
  await page.getByLabel('Open …').setInputFiles(file)
  await expect(dialog).toContainText('1 row is not a circle.')
  await dialog.getByRole('button', { name: 'Open' }).click()
  const alert = page.getByRole('alert')
  await expect(alert).toContainText('odd.csv:3: rechtswert is empty.')
  await alert.getByRole('button', { name: 'Skip 1 row' }).click()
  await soon(() => app.circles()).toEqual(Float64Array.of(1, 2, 0.5, 9, 2, 0.75))
})
