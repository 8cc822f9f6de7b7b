// SPDX-License-Identifier: GPL-3.0-or-later
// Focus and selection, and the scope of keyboard shortcuts.

import { fitted, toScreen } from '../../web/view/camera.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { soon } from '../soon.ts'
import { dataSet, expect, PADDING, test } from './page.ts'

const BRONZE = dataSet('bronzefilter')
const INTRODUCTION = dataSet('introduction')

test('buttons that have nothing left to do give the focus to the picture, and a circle that comes back is selected', async ({
  app,
}) => {
  await test.step('a button that has nothing left to do gives the focus to the picture', async () => {
    await app.select(BRONZE, 650)
    await app.inspector.getByRole('button', { name: 'Delete' }).click()
    await expect(app.status).toContainText('677 circles')
    await expect(app.canvas).toBeFocused()
    await app.page.getByRole('button', { name: 'Undo' }).click()
    await expect(app.status).toContainText('678 circles')
    await expect(app.canvas).toBeFocused()
  })
  await test.step('a circle that comes back is selected', async () => {
    await expect(app.inspector).toContainText('Circle 650')
    // Pressed without pauses: each key waits for the previous one.
    await app.page.keyboard.press('Delete')
    await app.page.keyboard.press('Control+z')
    await expect(app.inspector).toContainText('Circle 650')
    await expect(app.field('x')).toHaveValue(String(BRONZE[1950]))
    await app.page.keyboard.press('Delete')
    await expect(app.status).toContainText('677 circles')
  })
})

test('the focus stays among neighbors, and keys of the picture work after a click on the toolbar', async ({ app }) => {
  await test.step('a neighbor is selected by its number, and the focus stays among the neighbors', async () => {
    await app.choose('Introduction')
    await app.select(INTRODUCTION, 4)
    const list = app.inspector.getByRole('list', { name: 'Neighbors' }).getByRole('button')
    const first = (await list.first().textContent()) as string
    await list.first().focus()
    await app.page.keyboard.press('Enter')
    await expect(app.inspector).toContainText(`Circle ${first}`)
    await expect(list.first()).not.toHaveText(first)
    await expect(list.first()).toBeFocused()
  })
  await test.step('Delete and Escape work after a click on the toolbar', async () => {
    await app.select(INTRODUCTION, 4)
    const add = app.page.getByRole('button', { name: 'Add a circle' })
    await add.click()
    await app.page.keyboard.press('Escape')
    await expect(add).toHaveAttribute('aria-pressed', 'false')
    await expect(app.inspector).toBeVisible()
    await app.page.keyboard.press('Delete')
    await expect(app.status).toContainText('13 circles')
    // A field handles its own keys.
    await app.page.getByLabel('Data set').focus()
    await app.page.keyboard.press('Control+z')
    // The first undo reverts the last action on the figure.
    await app.canvas.focus()
    await app.page.keyboard.press('Control+z')
    await expect(app.status).toContainText('14 circles')
    await app.page.keyboard.press('Control+z')
    await expect(app.status).toContainText('678 circles')
  })
})

test('letters and Backspace act on the picture while it has the focus, and nowhere else', async ({
  introduction: app,
}) => {
  const { page } = app
  await app.select(INTRODUCTION, 4)
  const add = page.getByRole('button', { name: 'Add a circle' })
  const state = async () => [await app.status.textContent(), await page.locator('[aria-pressed=true]').count()]
  const before = await state()
  await page.getByRole('button', { name: 'Fit' }).focus()
  for (const key of ['a', 's', 'v', 'h', 'p', 'n', 'Backspace']) await page.keyboard.press(key)
  // The circle is still there and selected.
  await app.field('r').fill('0.5')
  await app.field('r').press('Enter')
  await soon(async () => (await app.circles())[14]).toBe(0.5)
  expect(await app.circles()).toHaveLength(INTRODUCTION.length)
  await page.getByRole('button', { name: 'Undo' }).click()
  await soon(() => app.circles()).toEqual(INTRODUCTION)
  expect(await state()).toEqual(before)
  await app.canvas.focus()
  await page.keyboard.press('a')
  await expect(add).toHaveAttribute('aria-pressed', 'true')
})

test('a circle that Tab selects is shown', async ({ introduction: app }) => {
  await app.select(INTRODUCTION, 4)
  await app.drag({ x: 140, y: 400 }, { x: 1270, y: 400 })
  await app.page.mouse.up()
  await app.page.keyboard.press('Tab')
  await expect(app.inspector).toContainText('Circle 5')
  // Without a selection, the circle in the middle is selected.
  await app.page.keyboard.press('Escape')
  await app.page.mouse.click(640, 400)
  await expect(app.inspector).toContainText('Circle 5')
})

test('an outlier does not keep one from zooming to the rest', async ({ introduction: app }) => {
  await app.select(INTRODUCTION, 4)
  await app.field('x').fill('1e12')
  await app.field('x').press('Enter')
  await expect(app.field('x')).toHaveAttribute('title', '1000000000000')
  await app.field('x').press('Escape')
  const fit = app.page.getByRole('button', { name: 'Fit' })
  await fit.click()
  await fit.click()
  const circles = INTRODUCTION.slice()
  circles[12] = 1e12
  const size = { width: 1280, height: 800 }
  const center = toScreen(fitted(new CircleTable(circles).core(), size, PADDING), size, { x: 0, y: 0 })
  await app.page.mouse.move(center.x, center.y)
  for (let k = 0; k < 5; k++) await app.page.mouse.wheel(0, -100)
  await app.page.mouse.click(center.x + 40, center.y)
  await expect(app.inspector).toContainText('Circle 0')
})

test('after a tool is pressed, Tab goes into its panel, and Escape closes it from there and from the tool', async ({
  app,
}) => {
  for (const name of ['Share', 'Layers', 'Region']) {
    const tool = app.page.getByRole('button', { name, exact: true })
    await tool.click()
    await expect(tool, name).toHaveAttribute('aria-expanded', 'true')
    await app.page.keyboard.press('Escape')
    await expect(tool, name).toHaveAttribute('aria-expanded', 'false')
    await expect(tool, name).toBeFocused()
    await tool.click()
    await expect(tool, name).toHaveAttribute('aria-expanded', 'true')
    await app.page.keyboard.press('Tab')
    const panel = app.page.locator(`#${await tool.getAttribute('aria-controls')}`)
    await expect(panel.getByRole('button', { name: 'Close', exact: true }), name).toBeFocused()
    await app.page.keyboard.press('Escape')
    await expect(panel, name).toBeHidden()
    await expect(tool, name).toBeFocused()
  }
})
