// SPDX-License-Identifier: GPL-3.0-or-later
// A long press previews the cell of a new circle.
import { at } from '../../web/lib/base/diagram-data.ts'
import { soon } from '../soon.ts'
import { framesOf } from './frames.ts'
import { type App, dataSet, expect, test } from './page.ts'

const INTRODUCTION = dataSet('introduction')

/** A point inside a cell and outside its circle. */
const EMPTY = { x: -2.2, y: 0.9 }

function isEmpty({ x, y }: { x: number; y: number }): boolean {
  return Array.from({ length: INTRODUCTION.length / 3 }, (_, i) => i).every(
    (i) => Math.hypot(at(INTRODUCTION, 3 * i) - x, at(INTRODUCTION, 3 * i + 1) - y) > at(INTRODUCTION, 3 * i + 2) + 0.2,
  )
}

const panelOf = (app: App) => app.page.getByRole('region', { name: 'A new circle' })

test('held, it shows what would be taken from whom; Escape leaves all as it was, release adds it', async ({ app }) => {
  const { page } = app
  await app.choose('Introduction')
  expect(isEmpty(EMPTY)).toBe(true)
  const place = app.locate(INTRODUCTION, EMPTY)
  const panel = panelOf(app)
  await page.mouse.move(place.x, place.y)
  await page.mouse.down()
  await expect(panel).toContainText('Its cell would have the area')
  const first = await panel.textContent()
  // The preview follows the pointer; the circles stay.
  await page.mouse.move(place.x + 12, place.y - 9)
  await soon(() => panel.textContent()).not.toBe(first)
  await expect(app.status).toContainText('14 circles')
  const numbers = (await panel.locator('dd').allTextContents()).map(Number)
  const total = Number(/area ([\d.]+)/.exec((await panel.textContent()) as string)?.[1])
  expect(numbers.every((area, k) => k === 0 || area <= (numbers[k - 1] as number))).toBe(true)
  expect(Math.abs(numbers.reduce((sum, area) => sum + area, 0) - total)).toBeLessThan(0.02 * total)
  await page.keyboard.press('Escape')
  await expect(panel).toBeHidden()
  await page.mouse.up()
  await expect(app.status).toContainText('14 circles')
  await expect(page.getByRole('button', { name: 'Undo' })).toBeEnabled()
  await soon(() => app.circles()).toEqual(INTRODUCTION)

  // The tool for adding previews, too, wherever the press is.
  await page.clock.install()
  for (const key of ['v', 'a']) {
    await page.locator('#figure').focus()
    await page.keyboard.press('Escape')
    await page.keyboard.press(key)
    await page.mouse.move(place.x, place.y)
    await page.mouse.down()
    await page.clock.fastForward(5000)
    await expect(panel).toBeVisible()
    await page.mouse.up()
    await expect(panel).toBeHidden()
    await expect(app.status).toContainText('15 circles')
    await soon(async () => (await app.circles()).length).toBe(45)
    const circles = await app.circles()
    const [x, y, r] = circles.slice(42) as unknown as [number, number, number]
    expect(Math.hypot(x - EMPTY.x, y - EMPTY.y)).toBeLessThan(0.05)
    expect(r).toBeGreaterThan(0)
    await page.locator('#figure').focus()
    await page.keyboard.press('Control+z')
    await expect(app.status).toContainText('14 circles')
  }
  // A press on a circle, or one that moves at once, acts as usual. The tool for adding stays until Escape.
  await page.keyboard.press('Escape')
  const center = app.center(INTRODUCTION, 0)
  await page.mouse.move(center.x, center.y)
  await page.mouse.down()
  await page.clock.fastForward(5000)
  // A preview would appear by the frame after the next one.
  await framesOf(page, 2)
  await expect(panel).toBeHidden()
  await page.mouse.up()
  // Its answer comes after anything that would have been added or shown.
  await page.keyboard.press('Delete')
  await expect(app.status).toContainText('13 circles')
  await expect(panel).toBeHidden()
})

test.describe('with fingers', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true })

  test('a finger that rests does the same', async ({ introduction: app }) => {
    const { page } = app
    const place = app.locate(INTRODUCTION, EMPTY)
    const session = await page.context().newCDPSession(page)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: readonly { x: number; y: number }[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: [...points] })
    await touch('touchStart', [place])
    await expect(panelOf(app)).toContainText('area')
    await touch('touchMove', [{ x: place.x + 8, y: place.y }])
    await touch('touchEnd', [])
    await expect(app.status).toContainText('15 circles')
    await expect(panelOf(app)).toBeHidden()
  })
})
