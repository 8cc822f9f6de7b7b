// SPDX-License-Identifier: GPL-3.0-or-later
// The things that people show to others: worksheets, clips, cards, prints and photos as circles.
import { readFileSync } from 'node:fs'
import jsQR from 'jsqr'
import { decodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { violationsInBoth } from './accessibility.ts'
import { type App, dataSet, expect, test } from './page.ts'

const START = dataSet('start')

async function share(app: App): Promise<void> {
  await app.page.getByRole('button', { name: 'Share', exact: true }).click()
  await expect(app.page.getByRole('button', { name: 'Copy link' })).toBeVisible()
}

/** The number of curves and of bitmaps in a PDF, and whether it is one page. */
async function contentsOf(pdf: Buffer) {
  const { inflateSync } = await import('node:zlib')
  const text = pdf.toString('latin1')
  let curves = 0
  for (const [, body] of text.matchAll(/stream\r?\n([\s\S]*?)\r?\nendstream/g)) {
    try {
      curves +=
        inflateSync(Buffer.from(body as string, 'latin1'))
          .toString('latin1')
          .match(/ c\s/g)?.length ?? 0
    } catch {}
  }
  const count = (pattern: RegExp) => text.match(pattern)?.length ?? 0
  return { curves, images: count(/\/Subtype \/Image/g), pages: count(/\/Type \/Page\b/g) }
}

test('a worksheet has circles to draw on, a code and the address of the question, and a key on a second page', async ({
  eight: app,
}) => {
  const { page } = app
  await share(app)
  await page.getByRole('button', { name: 'Make a question' }).click()
  await page.getByRole('textbox', { name: 'Title' }).fill('Who is nearest?')
  await page.evaluate(() => {
    window.print = () => {}
  })
  await page.getByRole('button', { name: 'Worksheet', exact: true }).click()
  const sheet = page.locator('#worksheet')
  await expect(sheet).toBeAttached()
  await soon(() => sheet.evaluate((element: HTMLElement) => element.hidden)).toBe(false)
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' })
  await page.setViewportSize({ width: 794, height: 1123 })
  await expect(sheet.getByRole('heading', { name: 'Who is nearest?', exact: true })).toBeVisible()
  await expect(sheet.locator('section').first().getByRole('listitem')).toHaveText([
    'Draw the border of each cell: the points that are equally far from two circles.',
    'Then draw the circles again, so that the cell of circle 0 has 3 edges.',
  ])
  // The first page has circles, a ring and a number, and the second one the borders and the current value.
  const [blank, key] = [sheet.locator('section').nth(0), sheet.locator('section').nth(1)]
  expect(await blank.locator('figure path').count()).toBe(0)
  await expect(blank.locator('figure text')).toHaveText('0')
  expect(await blank.locator('figure circle').count()).toBe((2 * START.length) / 3 + 1)
  expect(await key.locator('figure path').count()).toBeGreaterThan(START.length / 3)
  await expect(key.locator('figure text')).toHaveText(/^0: \d edges$/)
  await expect(key.getByRole('heading')).toHaveText('Key: Who is nearest?')
  await expect(page.locator('#top')).toBeHidden()
  const code = sheet.locator('footer svg')
  const shot = (await code.screenshot()).toString('base64')
  const { data, width, height } = await page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
    const scale = 4
    const canvas = new OffscreenCanvas(scale * image.width, scale * image.height)
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
    context.imageSmoothingEnabled = false
    context.drawImage(image, 0, 0, canvas.width, canvas.height)
    const pixels = context.getImageData(0, 0, canvas.width, canvas.height)
    return { data: [...pixels.data], width: canvas.width, height: canvas.height }
  }, shot)
  const address = jsQR(Uint8ClampedArray.from(data), width, height)?.data ?? ''
  expect(address).toMatch(/\/embed\.html#v1\./)
  await expect(sheet.locator('footer code')).toHaveText(address)
  const { title, question, check, circles } = await decodeLink(new URL(address).hash)
  expect({ title, question, check }).toMatchObject({ title: 'Who is nearest?', check: { cell: 0, edges: 3 } })
  expect(circles).toEqual(START)
  const { curves, images, pages } = await contentsOf(await page.pdf({ format: 'A4' }))
  expect([images, pages]).toEqual([0, 2])
  expect(curves).toBeGreaterThan(50)
  // The dialog for printing is closed.
  await expect(sheet).toBeHidden()
})

test('the page is printed as a drawing on white, also if it is dark', async ({ eight: app }) => {
  const { page } = app
  await page.emulateMedia({ colorScheme: 'dark' })
  await app.painted()
  const printed = () =>
    page.evaluate(() => {
      dispatchEvent(new Event('beforeprint'))
      const { innerHTML } = document.getElementById('paper') as HTMLElement
      dispatchEvent(new Event('afterprint'))
      return innerHTML
    })
  // The first drawing may have been made before the circles were there.
  await expect.poll(async () => (await printed()).match(/<path/g)?.length).toBeGreaterThan(START.length / 3)
  expect(await printed()).toMatch(/<rect[^>]*fill="#ffffff"/)
  const { curves, images, pages } = await contentsOf(await page.pdf())
  expect([images, pages]).toEqual([0, 1])
  expect(curves).toBeGreaterThan(50)
  // A dialog for printing stays open for longer than a new drawing takes.
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('#figure')).toBeHidden()
  await page.waitForTimeout(600)
  expect(await page.locator('#paper > svg').count()).toBe(1)
})

test('a clip is recorded by one tap, of circles or of the method, and everything is as before', async ({
  eight: app,
}) => {
  const { page } = app
  const counts = async () => (await app.status.textContent())?.replace(/ · computed.*/, '')
  const before = await counts()
  for (const isMethod of [false, true]) {
    if (isMethod) {
      await page.getByRole('button', { name: 'Step by step' }).click()
      await expect(page.getByRole('region', { name: 'The method, step by step' })).toBeVisible()
    }
    if (!(await page.getByRole('button', { name: 'Record a video' }).isVisible())) await share(app)
    const [film] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Record a video' }).click(),
    ])
    expect(film.suggestedFilename()).toMatch(/^circles-clip\.(mp4|webm)$/)
    expect(readFileSync(await film.path()).length).toBeGreaterThan(10_000)
    await expect(page.getByRole('button', { name: 'Record a video' })).toBeEnabled()
  }
  expect(await counts()).toBe(before)
  await soon(() => app.circles()).toEqual(START)
})

test('a card has the size that other sites show beside a link', async ({ eight: app }) => {
  const { page } = app
  await share(app)
  const [saved] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save a card' }).click(),
  ])
  expect(saved.suggestedFilename()).toBe('start-card.png')
  const png = readFileSync(await saved.path())
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([1200, 630])
})

test('the tile of the picture saves what is seen, twice as large', async ({ eight: app }) => {
  const { page } = app
  await app.painted()
  const at = app.center(START, 0)
  const [color] = await app.colors([at])
  await share(app)
  const [saved] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save a picture' }).click(),
  ])
  expect(saved.suggestedFilename()).toBe('start.png')
  const png = readFileSync(await saved.path())
  const { width, height } = page.viewportSize() as { width: number; height: number }
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([2 * width, 2 * height])
  const drawn = await page.evaluate(
    async ([text, x, y]) => {
      const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
      const context = new OffscreenCanvas(1, 1).getContext('2d') as OffscreenCanvasRenderingContext2D
      context.drawImage(image, -x, -y)
      return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)]
    },
    [png.toString('base64'), Math.floor(2 * at.x), Math.floor(2 * at.y)] as const,
  )
  expect(drawn).toEqual(color)
})

test('a photo becomes circles in its colors', async ({ app }) => {
  const { page } = app
  const photo = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(80, 40)
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
    context.fillStyle = '#102030'
    context.fillRect(0, 0, 40, 40)
    context.fillStyle = '#c04020'
    context.fillRect(40, 0, 40, 40)
    return [...new Uint8Array(await (await canvas.convertToBlob({ type: 'image/png' })).arrayBuffer())]
  })
  await app.choose('Eight circles')
  const field = page.locator('#say').getByLabel('Or open a photo.')
  await field.setInputFiles({ name: 'a.png', mimeType: 'image/png', buffer: Buffer.from(photo) })
  await expect(app.status).toContainText('1,800 circles')
  const properties = async () => (await decodeLink(new URL(page.url()).hash)).attributes?.properties ?? []
  await soon(async () => (await properties()).length).toBe(1800)
  const colors = (await properties()).map((text) => (JSON.parse(text) as { color: string }).color)
  expect(new Set(colors).has('#102030')).toBe(true)
  expect(new Set(colors).has('#c04020')).toBe(true)
  await app.painted()
  const [left] = await app.colors([{ x: 400, y: 400 }])
  expect(Math.max(...(left as number[]))).toBeLessThan(255)

  // The bar below makes more circles, saves the mosaic as large as the photo, and moves the circles.
  const bar = page.getByRole('region', { name: 'Photo' })
  const isPressable = (name: string) => bar.getByRole('button', { name }).isEnabled()
  await bar.getByRole('button', { name: 'More' }).click()
  await expect(app.status).toContainText('3,600 circles')
  await expect(bar).toContainText('3,600 circles')
  expect(await violationsInBoth(page)).toEqual([])
  // The limit of circles that move is lower.
  expect([await isPressable('Breathe'), await isPressable('More')]).toEqual([false, true])
  const [saved] = await Promise.all([page.waitForEvent('download'), bar.getByRole('button', { name: 'Save' }).click()])
  const png = readFileSync(await saved.path())
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([2400, 1200])
  await page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toContainText('1,800 circles')
  await expect(bar).toContainText('1,800 circles')
  await soon(async () => (await decodeLink(new URL(page.url()).hash)).layers).toMatchObject({ edges: false })
  await bar.getByRole('button', { name: 'Breathe' }).click()
  await expect(page.locator('#stop')).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(page.locator('#stop')).toBeHidden()
  // Undo goes back to the circles before the photo, with their layers and without the bar.
  await page.getByRole('button', { name: 'Undo' }).click()
  await page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toContainText('8 circles')
  await expect(bar).toBeHidden()
  await soon(async () => (await decodeLink(new URL(page.url()).hash)).layers).toBeUndefined()
  await page.getByRole('button', { name: 'Redo' }).click()
  await expect(bar).toContainText('1,800 circles')
})

test('a menu at the pointer has what can be done there, also by keys', async ({ eight: app }) => {
  const { page } = app
  const menu = page.getByRole('menu')
  const { x, y } = app.center(START, 0)
  await page.mouse.click(x, y, { button: 'right' })
  await expect(menu.getByRole('menuitem')).toHaveText([/^Name …/, /^Zoom to/, /^Duplicate/, /^Delete/])
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Enter')
  await expect(menu).toBeHidden()
  await expect(app.status).toContainText('9 circles')
  // The menu key opens it at the selected circle.
  await expect(app.canvas).toBeFocused()
  await page.keyboard.press('ContextMenu')
  await expect(menu).toBeVisible()
  await menu.getByRole('menuitem', { name: 'Name' }).click()
  await expect(app.inspector.getByLabel('Name')).toBeFocused()
  // On an empty place a circle can be added.
  await page.mouse.click(x - 180, y - 180, { button: 'right' })
  await menu.getByRole('menuitem', { name: 'Add a circle here' }).click()
  await expect(app.status).toContainText('10 circles')
  await page.mouse.click(x, y, { button: 'right' })
  await expect(menu).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(menu).toBeHidden()
  await expect(app.canvas).toBeFocused()
})
