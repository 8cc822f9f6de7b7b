// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of a file beyond the circles: shown, sorted, colored by, edited, undone, kept, linked and saved.
import { readFileSync } from 'node:fs'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { type App, expect, test } from './page.ts'

const TOWNS = `x,y,r,name,fips,kind,people
0,0,1,Aarau,01001,town,1200
12,0,2,Bern,1003,city,134000.5
4,9,1.5,"Chur, GR",06037,town,38000
15,11,1,,06038,,
-5,6,2,Davos,7,village,10900
`
const saved = async (app: App, label: string) => {
  const download = app.page.waitForEvent('download')
  await app.page.locator('#files').getByRole('button', { name: label, exact: true }).click()
  return readFileSync(await (await download).path(), 'utf8')
}

test.use({ link: await encodeLink({ dataSet: 'introduction' }) })

test('columns of a table are in the table, the inspector, the colors, the link, and in what is saved', async ({
  app,
}, testInfo) => {
  const { page } = app
  await app.openPanel('Files')
  await page.getByLabel('Open …').setInputFiles({ name: 'towns.csv', mimeType: 'text/csv', buffer: Buffer.from(TOWNS) })
  await expect(app.status).toContainText('5 circles')
  await app.openPanel('Table')
  const grid = page.getByRole('grid', { name: 'Circles' })
  const row = (k: number) => grid.getByRole('row').nth(k).getByRole('gridcell')
  await expect(grid.getByRole('columnheader')).toHaveText([
    '#',
    'x',
    'y',
    'r',
    'area',
    'nbrs',
    'nearest',
    'name',
    'fips',
    'kind',
    'people',
  ])
  await expect(row(2)).toContainText(['1', '12', '0', '2', '∞', '', '', 'Bern', '1003', 'city', '134000.5'])

  // Rows are sorted by number, and rows without a number are last.
  await grid.getByRole('columnheader', { name: 'people' }).click()
  await expect(row(1)).toContainText(['0', '0', '0', '1', '', '', '', 'Aarau'])
  await expect(row(5)).toContainText(['3', '15', '11', '1', '', '', '', '', '06038', '', ''])

  // A text column is edited as text, starting with any key.
  await row(1).nth(8).click()
  await page.keyboard.type('0042')
  await page.keyboard.press('Enter')
  await expect(row(1).nth(8)).toHaveText('0042')
  await row(1).nth(10).click()
  await page.keyboard.type('9x')
  await page.keyboard.press('Enter')
  await expect(page.getByRole('alert')).toContainText('“9x” is not a number')
  await page.keyboard.press('Escape')
  await row(1).nth(10).click()
  await page.keyboard.type('99')
  await page.keyboard.press('Enter')
  await expect(row(1).nth(10)).toHaveText('99')
  await page.getByRole('button', { name: 'Undo' }).click()
  await expect(row(1).nth(10)).toHaveText('1200')

  await row(1).nth(1).click()
  await expect(app.inspector).toContainText('Aarau')
  await expect(app.inspector.locator('#inspector-data')).toContainText('fips0042')
  await expect(app.inspector.locator('#inspector-facts')).toContainText('∞')
  await app.painted()
  await page.screenshot({ path: testInfo.outputPath('table.png') })

  await app.openPanel('Layers')
  await page.getByLabel('Colors').selectOption({ label: 'people' })
  await expect(page.locator('#legend')).toContainText('people')
  await app.painted()
  await page.screenshot({ path: testInfo.outputPath('people.png') })
  await page.getByLabel('Colors').selectOption({ label: 'kind' })
  await expect(page.locator('#legend .categories')).toContainText('towncityvillage')
  await app.painted()
  await page.screenshot({ path: testInfo.outputPath('kind.png') })
  await page.emulateMedia({ colorScheme: 'dark' })
  await app.painted()
  await page.screenshot({ path: testInfo.outputPath('kind-dark.png') })

  // The column survives a link, a reload, and undo across another data set.
  const linked = async () => (await decodeLink(new URL(page.url()).hash)).attributes?.properties[0]
  await soon(linked).toBe('{"name":"Aarau","fips":"0042","kind":"town","people":1200}')
  await page.reload()
  await expect(app.status).toContainText('5 circles')
  await expect(page.getByLabel('Colors').locator('option:checked')).toHaveText('kind')
  await expect(page.locator('#legend .categories')).toContainText('towncityvillage')
  await app.choose('Spruces')
  await expect(page.locator('#legend .categories')).toBeHidden()
  await page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toContainText('5 circles')

  await app.openPanel('Files')
  const lines = (await saved(app, 'CSV')).split('\n')
  expect(lines.slice(0, 4)).toEqual([
    'x,y,r,name,fips,kind,people',
    '0,0,1,Aarau,0042,town,1200',
    '12,0,2,Bern,"1003",city,134000.5',
    '4,9,1.5,"Chur, GR",06037,town,38000',
  ])
  const { features } = JSON.parse(await saved(app, 'GeoJSON'))
  expect(features[2].properties).toMatchObject({ name: 'Chur, GR', fips: '06037', people: 38000 })
  expect(JSON.parse(await saved(app, 'JSON')).circles[0].properties.fips).toBe('0042')
  const cells = JSON.parse(await saved(app, 'Cells'))
  expect(cells.features[1].properties).toMatchObject({ name: 'Bern', circle: 1 })
  expect(cells.bbox).toHaveLength(4)
  await expect(page.locator('#toast')).toContainText('The cells are cut to the box from')
})

test('long columns and values stay in the card, with their whole texts as tooltips', async ({ app }) => {
  const { page, inspector } = app
  const [name, value] = ['the_longest_heading_'.repeat(5), 'a long text without an end '.repeat(40).trim()]
  await app.drop('long.csv', `x,y,r,${name},short\n0,0,1,"${value}",7\n5,0,1,b,8\n`)
  await expect(app.status).toContainText('2 circles')
  await app.canvas.focus()
  await page.keyboard.press('Enter')
  const data = inspector.locator('#inspector-data')
  await expect(data).toBeVisible()
  const card = (await inspector.boundingBox()) as { x: number; width: number }
  for (const [part, text] of [
    [data.locator('dt').first(), name],
    [data.locator('dd').first(), value],
    [data.locator('dd').last(), '7'],
  ] as const) {
    await expect(part).toHaveAttribute('title', text)
    const box = (await part.boundingBox()) as { x: number; width: number; height: number }
    expect(box.x).toBeGreaterThan(card.x)
    expect(box.x + box.width).toBeLessThan(card.x + card.width)
    expect(box.height).toBeLessThan(80)
  }
})
