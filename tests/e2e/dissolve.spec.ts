// SPDX-License-Identifier: GPL-3.0-or-later
// Regions whose polygons share borders or overlap, in the page.
import type { Locator } from '@playwright/test'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { type App, expect, test } from './page.ts'

const COUNTIES = 'MULTIPOLYGON (((-3 -3, 3 -3, 3 8, -3 8)), ((3 -3, 9 -3, 9 8, 3 8)))'

test.use({
  link: await encodeLink({
    circles: Float64Array.of(0, 0, 1, 6, 0, 1, 2, 5, 1),
  }),
})

const panel = (app: App): Locator => app.page.getByRole('region', { name: 'Region', exact: true })

test('counties that share a border are merged where they are refused, and a link keeps that', async ({ app }) => {
  await app.openPanel('Region')
  await app.drop('counties.wkt', COUNTIES)
  await expect(app.page.locator('#toast')).toContainText('Polygons of counties.wkt share borders or overlap.')
  await expect(panel(app)).not.toContainText('outlines')
  await app.page.getByRole('button', { name: 'Merge polygons' }).click()
  await expect(panel(app)).toContainText('2 outlines with 8 sides')
  const merging = panel(app).getByLabel('Merge polygons that share borders or overlap')
  await expect(merging).toBeChecked()
  await soon(async () => (await decodeLink(new URL(app.page.url()).hash)).region).toMatchObject({
    type: 'MultiPolygon',
    dissolve: true,
  })
})

test('with the choice in the panel they are merged at once', async ({ app }) => {
  await app.openPanel('Region')
  await panel(app).getByLabel('Merge polygons that share borders or overlap').check()
  await app.drop('counties.wkt', COUNTIES)
  await expect(panel(app)).toContainText('2 outlines with 8 sides')
  await expect(app.page.getByRole('alert')).toBeHidden()
})
