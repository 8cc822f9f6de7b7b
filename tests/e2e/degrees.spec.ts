// SPDX-License-Identifier: GPL-3.0-or-later
// Tables in degrees: the page says so, and offers a globe and a map.
import type { Page } from '@playwright/test'
import { soon } from '../soon.ts'
import { violationsOf } from './accessibility.ts'
import { type App, expect, test } from './page.ts'

/** Four places within 40 km of Canberra, with radii in meters. */
const NEAR = 'name,lat,lon,radius\nA,-35.315,149.149,500\nB,-35.5,149.3,800\nC,-35.2,149,300\nD,-35.3,149.3,400\n'
const FAR = 'name;Latitude;Longitude;Radius (km)\nJuneau;58,3;-134,42;100\nPole;-90;0;500\nKyiv;50,45;30,52;50\n'

function noticeOf(page: Page) {
  return page.locator('#degrees')
}

async function openTable(app: App, name: string, text: string): Promise<void> {
  await app.openPanel('Files')
  const file = { name, mimeType: 'text/csv', buffer: Buffer.from(text) }
  await app.page.getByLabel('Open …').setInputFiles(file)
  // A heading with a unit is asked about.
  if (text.includes('(km)')) await app.page.getByRole('button', { name: 'Open', exact: true }).click()
  await expect(app.status).toContainText('proven for a plane')
  await app.openPanel('Files')
}

test('a table in degrees is projected to a map in meters, and undo goes back', async ({ app, page }) => {
  await expect(noticeOf(page)).toBeHidden()
  await openTable(app, 'near.csv', NEAR)
  await expect(noticeOf(page)).toContainText('These are longitudes and latitudes.')
  await expect(noticeOf(page).getByLabel('Radii are in')).toHaveValue('m')
  expect(await violationsOf(page)).toEqual([])
  await noticeOf(page).getByRole('button', { name: 'Project to a map' }).click()
  await expect(page.getByText('x and y are meters on an equal-area map around 35.3° S, 149.2° E.')).toBeVisible()
  await expect(noticeOf(page)).toBeHidden()
  await expect(app.status).toContainText(/✓ proven(?! for)/)
  // A and D are 13.8 km apart on the ellipsoid.
  const distance = async () => {
    const [ax = 0, ay = 0, , , , , , , , dx = 0, dy = 0] = await app.circles()
    return Math.round(Math.hypot(ax - dx, ay - dy) / 100)
  }
  await soon(distance).toBe(138)
  expect((await app.circles()).filter((_, k) => k % 3 === 2)).toEqual(Float64Array.of(500, 800, 300, 400))
  await page.getByRole('button', { name: 'Undo' }).first().click()
  await expect(app.status).toContainText('proven for a plane')
  await expect(noticeOf(page)).toBeVisible()
  await noticeOf(page).getByRole('button', { name: 'Dismiss' }).click()
  await expect(noticeOf(page)).toBeHidden()
  await expect(app.status).toContainText('proven for a plane')
})

test('a table in degrees is shown on a globe in another tab, with its names and unit', async ({
  app,
  page,
  context,
}) => {
  await openTable(app, 'world.csv', FAR)
  await expect(noticeOf(page).getByLabel('Radii are in')).toHaveValue('km')
  // The pole is too far from the other places for one map.
  await noticeOf(page).getByRole('button', { name: 'Project to a map' }).click()
  await expect(page.getByRole('alert')).toContainText(
    /more than 60° from the middle of all circles.*Show them on a globe\.$/,
  )
  const [globe] = await Promise.all([
    context.waitForEvent('page'),
    noticeOf(page).getByRole('button', { name: 'Show on a globe' }).click(),
  ])
  const summary = globe.locator('#summary')
  await expect(summary).toHaveText('world.csv: 3 circles')
  await expect(globe.getByRole('combobox', { name: 'Unit' })).toHaveValue('km')
  await globe.getByRole('application', { name: 'Globe' }).focus()
  await globe.keyboard.press('End')
  for (let k = 0; k < 12; k++) await globe.keyboard.press('ArrowDown')
  await soon(() => globe.locator('#cell-name').textContent()).toBe('Pole')
  await expect(globe.locator('#facts')).toContainText('500 km')
  await globe.reload()
  await expect(summary).toHaveText('world.csv: 3 circles')
})

test('places without radii have the same radius on the map, and are points of the globe that they are shown on', async ({
  app,
  page,
  context,
}) => {
  await app.openPanel('Files')
  const text = 'Ort,lon,lat\nAlt-Schwerin,12.35,53.51\nAschersleben,11.46,51.76\nLüttich,5.57,50.64\n'
  const file = { name: 'places.csv', mimeType: 'text/csv', buffer: Buffer.from(text) }
  await page.getByLabel('Open …').setInputFiles(file)
  const dialog = page.getByRole('dialog', { name: 'Which columns are the circles?' })
  await expect(dialog.getByLabel('radius').locator('option:checked')).toHaveText('the same for all')
  await dialog.getByLabel('r', { exact: true }).fill('0')
  await dialog.getByLabel('r', { exact: true }).press('Tab')
  await dialog.getByRole('button', { name: 'Open' }).click()
  await expect(noticeOf(page)).toBeVisible()
  // Without radii there is no unit to choose.
  await expect(noticeOf(page).getByRole('combobox')).toHaveCount(0)
  const [globe] = await Promise.all([
    context.waitForEvent('page'),
    noticeOf(page).getByRole('button', { name: 'Show on a globe' }).click(),
  ])
  await expect(globe.locator('#summary')).toHaveText('places.csv: 3 circles')
})

test('a pasted table in degrees replaces circles of a plane, and joins circles in degrees', async ({ app, page }) => {
  const paste = (text: string) =>
    page.evaluate((text) => {
      const clipboardData = new DataTransfer()
      clipboardData.setData('text/plain', text)
      document.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }))
    }, text)
  await paste(NEAR)
  await expect(app.status).toContainText('4 circles')
  await expect(noticeOf(page)).toBeVisible()
  await paste('lon,lat,r\n149.1,-35.1,200\n')
  await expect(app.status).toContainText('5 circles')
  await expect(noticeOf(page)).toBeVisible()
})
