// SPDX-License-Identifier: GPL-3.0-or-later
// Panels in windows of all sizes, forced colors, and right-to-left pages.
import type { Locator } from '@playwright/test'
import { soon } from '../soon.ts'
import { violationsInBoth, violationsOf } from './accessibility.ts'
import { framesOf } from './frames.ts'
import { heldBack } from './held-back.ts'
import { App, dataSet, expect, test } from './page.ts'

const BRONZE = dataSet('bronzefilter')

async function boxOf(locator: Locator) {
  return (await locator.boundingBox()) as { x: number; y: number; width: number; height: number }
}

async function expectApart(app: App): Promise<number> {
  const { width, height } = app.page.viewportSize() as { width: number; height: number }
  // Measured together, because the caption of a data set disappears by itself.
  const boxes = await app.page.evaluate(() =>
    [...document.querySelectorAll('.panel, .bar, #scale:not(:empty)')]
      .map((element) => element.getBoundingClientRect())
      .filter(({ width }) => width > 0)
      .map(({ x, y, width, height }) => ({ x, y, width, height })),
  )
  for (const [k, { x, y, width: w, height: h }] of boxes.entries()) {
    expect(Math.min(x, y)).toBeGreaterThanOrEqual(0)
    expect(x + w).toBeLessThanOrEqual(width)
    expect(y + h).toBeLessThanOrEqual(height)
    for (const other of boxes.slice(k + 1)) {
      const isApart = x + w <= other.x || other.x + other.width <= x || y + h <= other.y || other.y + other.height <= y
      expect(isApart, JSON.stringify([boxes[k], other])).toBe(true)
    }
  }
  return boxes.length
}

/**
 * Expects that no panel covers another, whatever is open. `layers` is the smallest visible height of that panel, in
 * pixels.
 */
async function expectAlwaysApart(app: App, layers: number): Promise<void> {
  await app.page.getByRole('button', { name: 'Fit' }).click()
  await expectApart(app)
  await app.canvas.focus()
  await app.page.keyboard.press('Enter')
  await expect(app.inspector).toBeVisible()
  await expectApart(app)
  await app.field('r').fill('-1')
  await app.field('r').press('Enter')
  await expect(app.page.getByRole('alert')).toBeVisible()
  expect(await expectApart(app)).toBeGreaterThan(1)
  // In the smallest windows a card takes all the room.
  const isCovered = !(await app.page.locator('#rail').isVisible())
  if (isCovered) await app.inspector.getByRole('button', { name: 'Deselect' }).click()
  await expect(app.page.locator('#rail')).toBeVisible()
  await app.openPanel('Layers')
  await expectApart(app)
  const panel = app.page.locator('#layers')
  expect((await boxOf(panel)).height).toBeGreaterThan(layers)
  await panel.getByRole('button', { name: 'Close' }).click()
  await expect(panel).toBeHidden()
  const answer = await heldBack('**/data/spruces.csv', app.page)
  await app.page.getByLabel('Data set').selectOption({ label: 'Spruces' })
  await expect(app.page.locator('#progress').getByRole('button', { name: 'Cancel' })).toBeInViewport({ ratio: 1 })
  await expectApart(app)
  answer()
}

// 320 x 200 is 1280 x 800 at 400 %.
for (const [width, height, layers] of [
  [1280, 800, 300],
  [800, 600, 300],
  [568, 320, 150],
  [390, 844, 300],
  [320, 200, 120],
] as const) {
  test(`no panel covers another at ${width} x ${height}`, async ({ app }) => {
    await app.page.setViewportSize({ width, height })
    await expectAlwaysApart(app, layers)
  })
}

test('no panel covers another with text of 200 %, in a window or on a phone', async ({
  playwright,
  launchOptions,
  baseURL,
}) => {
  const args = [...(launchOptions.args ?? []), '--blink-settings=defaultFontSize=32']
  const browser = await playwright.chromium.launch({ ...launchOptions, args })
  for (const [width, height] of [
    [1280, 800],
    [390, 844],
  ] as const) {
    const screen = { viewport: { width, height }, hasTouch: true, serviceWorkers: 'block' } as const
    const app = new App(await browser.newPage({ baseURL: baseURL as string, ...screen }))
    await app.open()
    await expectAlwaysApart(app, 150)
    await app.page.close()
  }
  await browser.close()
})

test('all panels, several circles and help have no serious accessibility violation', async ({ app }) => {
  const expectNone = async () => expect(await violationsInBoth(app.page)).toEqual([])
  await app.choose('Introduction')
  await app.page.keyboard.press('Control+a')
  await expect(app.page.getByRole('region', { name: 'Selected circles' })).toBeVisible()
  await app.openPanel('Files')
  await expectNone()
  await app.openPanel('Layers')
  await app.page.getByLabel('Edges that it misses').check()
  await expect(app.page.locator('#method-found')).toContainText('certified')
  await app.page.getByLabel('Colors').selectOption('by area of the cell')
  await expect(app.page.locator('#legend')).toContainText('Area of the cell')
  await expectNone()
  await app.openPanel('Gallery')
  await app.page.getByText('Hard inputs', { exact: true }).click()
  await expect(app.page.getByRole('button', { name: /^uniform/ })).toBeVisible()
  await expectNone()
  await app.openPanel('Table')
  await expect(app.page.getByRole('row').nth(3)).toBeVisible()
  await expectNone()
  for (const name of ['Numbers', 'Motion']) {
    await app.openPanel(name)
    await expectNone()
  }
  await app.page.getByRole('button', { name: 'Share', exact: true }).click()
  await expect(app.page.locator('#share')).toBeVisible()
  await expectNone()
  await app.page.getByRole('button', { name: 'Help' }).click()
  await expect(app.page.getByRole('dialog')).toBeVisible()
  await expectNone()
})

for (const [screen, media, size] of [
  ['light and dark', {}, [1280, 800]],
  ['in forced colors', { forcedColors: 'active' }, [1280, 800]],
  ['on a phone', {}, [390, 844]],
] as const) {
  test(`no circles, errors, progress and a choice of columns have no accessibility violation, ${screen}`, async ({
    app,
  }) => {
    const { page } = app
    await page.setViewportSize({ width: size[0], height: size[1] })
    await page.emulateMedia(media)
    const find = screen === 'light and dark' ? violationsInBoth : violationsOf
    const expectNone = async () => expect(await find(page)).toEqual([])
    await app.canvas.focus()
    await page.keyboard.press('Control+a')
    await page.keyboard.press('Delete')
    await expect(app.status).toContainText('0 circles')
    await expectNone()
    await app.openPanel('Files')
    const open = (name: string, text: string) =>
      page.getByLabel('Open …').setInputFiles({ name, mimeType: 'text/csv', buffer: Buffer.from(text) })
    await open('a.csv', '0,0,-1\n')
    await expect(page.getByRole('alert')).toContainText('negative radius')
    await expectNone()
    await open('odd.csv', 'a,b,c,d\n1,2,3,4\n5,6,7,8\n')
    const dialog = page.getByRole('dialog', { name: 'Which columns are the circles?' })
    await expect(dialog).toBeVisible()
    await expectNone()
    await dialog.getByRole('button', { name: 'Cancel' }).click()
    const answer = await heldBack('**/data/spruces.csv', page)
    await page.getByLabel('Data set').selectOption({ label: 'Spruces' })
    await expect(page.locator('#progress')).toContainText('Loading …')
    await expectNone()
    answer()
    await expect(app.status).toContainText('134 circles')
    await expectNone()
  })
}

test('fields and buttons have borders in forced colors', async ({ app }) => {
  await app.page.emulateMedia({ forcedColors: 'active' })
  await app.select(BRONZE, 600)
  for (const control of await app.page.locator('input:visible, select:visible, button:visible').all()) {
    await expect(control).toHaveCSS('border-top-style', 'solid')
    await expect(control).toHaveCSS('border-top-width', '1px')
  }
})

test('a page that runs from right to left leaves each part of the status as it is', async ({ app }) => {
  await app.page.evaluate(() => {
    document.documentElement.dir = 'rtl'
  })
  const part = app.status.locator('bdi').first()
  await expect(part).toHaveText('678 circles')
  // The number is at the left of its part.
  expect((await boxOf(part.locator('b'))).x).toBe((await boxOf(part)).x)
  expect((await boxOf(part)).x).toBeGreaterThan((await boxOf(app.status.locator('bdi').nth(1))).x)
  // The numbers of the legend are in the order of its colors.
  await app.openPanel('Layers')
  await app.page.getByLabel('Colors').selectOption('by number')
  const knots = app.page.locator('#legend .knots > span')
  await expect(knots).toHaveText(['≤ 34', '169', '339', '508', '≥ 643'])
  expect((await boxOf(knots.first())).x).toBeLessThan((await boxOf(knots.last())).x)
})

test('what is pressed stays where it is while an error goes, and is clicked', async ({ app }) => {
  const { page } = app
  await page.setViewportSize({ width: 800, height: 600 })
  await app.canvas.focus()
  await page.keyboard.press('Enter')
  await app.field('r').fill('-1')
  await app.field('r').press('Enter')
  await expect(page.getByRole('alert')).toBeVisible()
  const { x, y } = await boxOf(page.locator('#rail').getByRole('button', { name: 'Layers', exact: true }))
  await page.mouse.move(x + 10, y + 10)
  await page.mouse.down()
  await framesOf(page, 2)
  await page.mouse.up()
  await expect(page.locator('#layers')).toBeVisible()
  await expect(page.getByRole('alert')).toBeHidden()
})

/** Counts the strongly colored pixels of discs below an element; cells have weak colors. */
async function discPixelsBelow({ page, canvas }: App, selector: string): Promise<number> {
  await expect(canvas).toHaveAttribute('aria-busy', 'false')
  return page.evaluate((selector) => {
    const base = document.querySelector('#figure canvas') as HTMLCanvasElement
    const copy = new OffscreenCanvas(base.width, base.height)
    const context = copy.getContext('2d') as OffscreenCanvasRenderingContext2D
    context.drawImage(base, 0, 0)
    const { x, y, width, height } = (document.querySelector(selector) as Element).getBoundingClientRect()
    const ratio = devicePixelRatio
    const { data } = context.getImageData(x * ratio, y * ratio, width * ratio, height * ratio)
    let count = 0
    for (let k = 0; k < data.length; k += 4) {
      const color = [...data.subarray(k, k + 3)]
      if (Math.max(...color) - Math.min(...color) > 70) count += 1
    }
    return count
  }, selector)
}

for (const [width, height] of [
  [740, 360],
  [320, 568],
  [390, 844],
] as const) {
  test.describe(`on a phone, ${width} x ${height}`, () => {
    test.use({ viewport: { width, height }, hasTouch: true, isMobile: true })

    test('what is said at first and what is shared cover no circle, and nothing of them is cut off', async ({
      page,
    }) => {
      const app = new App(page)
      await app.open('')
      const isWhole = (selector: string) =>
        page.locator(selector).evaluate((element) => element.scrollHeight <= element.clientHeight + 1)
      await expect(page.locator('#say')).toContainText('Drag one.')
      // The count works: it is large over the circles.
      expect(await discPixelsBelow(app, '#figure')).toBeGreaterThan(1000)
      await soon(() => discPixelsBelow(app, '#say')).toBe(0)
      expect(await isWhole('#say')).toBe(true)
      await page.getByRole('button', { name: 'Share', exact: true }).click()
      await expect(page.getByRole('button', { name: 'Copy element' })).toBeVisible()
      await soon(() => discPixelsBelow(app, '#share')).toBe(0)
      expect(await isWhole('#share')).toBe(true)
      if (width < height) expect((await boxOf(page.locator('#share'))).height).toBeLessThan(height / 2)
      await page.locator('#share').getByRole('button', { name: 'Close' }).click()
      await app.canvas.focus()
      await page.keyboard.press('Control+a')
      await page.keyboard.press('Delete')
      await expect(page.locator('#say')).toContainText('choose a data set above.')
      expect(await isWhole('#say')).toBe(true)
    })
  })
}

test.describe('with fingers', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true })

  test('what is to be tapped is 44 pixels large', async ({ app }) => {
    const at = app.center(BRONZE, 650)
    await app.page.touchscreen.tap(at.x, at.y)
    await expect(app.inspector).toBeVisible()
    await app.openPanel('Files')
    for (const control of await app.page.locator('button:visible, select:visible, #files input[type=number]').all()) {
      const { width, height } = await boxOf(control)
      expect(Math.min(width, height), await control.evaluate((element) => element.outerHTML)).toBeGreaterThanOrEqual(44)
    }
    expect(await app.page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0)
  })
})
