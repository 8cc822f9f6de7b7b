// SPDX-License-Identifier: GPL-3.0-or-later
// Files with rows without a position: the error offers to skip these rows, and says how many there are.
import { encodeLink } from '../../web/lib/link.ts'
import { expect, test } from './page.ts'

test.use({ link: await encodeLink({ dataSet: 'introduction' }) })

const POINT = { type: 'Point', coordinates: [149.149, -35.315] }
const feature = (ref: string, geometry: unknown) => ({ type: 'Feature', properties: { ref, radius: 0.01 }, geometry })
const FILES = [
  ['missing.csv', 'id,lon,lat,r\n1,10.5,52.1,0\n2,,,0\n3,11.5,52.4,0\n4,NaN,NaN,0\n', 'Skip 2 rows', '2 circles'],
  [
    'null.geojson',
    JSON.stringify({
      type: 'FeatureCollection',
      features: [feature('0042', POINT), feature('0044', null), feature('0043', { ...POINT, coordinates: [1, 2] })],
    }),
    'Skip 1 row',
    '2 circles',
  ],
] as const

for (const [name, text, label, circles] of FILES) {
  test(`the error of ${name} offers to skip rows, and they are counted`, async ({ app }, testInfo) => {
    const { page } = app
    await app.openPanel('Files')
    const before = await app.status.textContent()
    await page.getByLabel('Open …').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })
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
  const [name, text, label] = FILES[0]
  await page.getByLabel('Open …').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })
  const alert = page.getByRole('alert')
  await expect(alert.getByRole('button', { name: label })).toBeVisible()
  await page
    .getByLabel('Open …')
    .setInputFiles({ name: 'wrong.csv', mimeType: 'text/plain', buffer: Buffer.from('0,0,1\n1,x,1') })
  await expect(alert).toContainText('wrong.csv')
  await expect(alert.getByRole('button', { name: label })).toHaveCount(0)
})
