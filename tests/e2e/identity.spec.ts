// SPDX-License-Identifier: GPL-3.0-or-later
// Names and colors of circles, axes and a grid.
import type { Point } from '../../web/lib/index.ts'
import { decodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { dataSet, expect, test } from './page.ts'

const START = dataSet('start')

test('a circle gets a name and a color, which its card, its neighbors, the table, the link and undo know', async ({
  eight: app,
}) => {
  const { page, inspector } = app
  await app.select(START, 0)
  const center = app.center(START, 0)
  await inspector.getByLabel('Name').fill('Hamburg')
  await page.keyboard.press('Enter')
  await expect(inspector.getByRole('heading')).toHaveText('Hamburg')
  await expect(inspector).toContainText('Circle 0')
  await inspector.getByLabel('Color').fill('#8822cc')
  const beside = { x: center.x + 30, y: center.y - 30 }
  await soon(() => app.colors([beside])).toEqual([[0x88, 0x22, 0xcc]])
  // A neighbor lists it by its name, and so do screen readers.
  await app.select(START, 1)
  const chip = inspector.getByRole('list', { name: 'Neighbors' }).getByRole('button', { name: 'Hamburg' })
  await chip.click()
  await expect(inspector.getByRole('heading')).toHaveText('Hamburg')
  await expect(page.locator('#said')).toHaveText(/Hamburg\. Bounded cell/)

  const linked = async () => {
    const { attributes } = await decodeLink(new URL(page.url()).hash)
    return attributes?.properties[0]
  }
  await soon(linked).toBe('{"name":"Hamburg","color":"#8822cc"}')
  await page.reload()
  await expect(app.status).toContainText('edges')
  await app.painted()
  await soon(() => app.colors([beside])).toEqual([[0x88, 0x22, 0xcc]])
  await app.openPanel('Table')
  await expect(page.locator('#circle-grid')).toContainText('Hamburg')
  await app.openPanel('Table')

  await page.mouse.click(center.x, center.y)
  await inspector.getByRole('button', { name: 'Automatic color' }).click()
  await soon(linked).toBe('{"name":"Hamburg"}')
  await page.keyboard.press('Control+z')
  await soon(() => app.colors([beside])).toEqual([[0x88, 0x22, 0xcc]])
})

test('names are entered in the table where there are none yet', async ({ eight: app }) => {
  const { page } = app
  await app.openPanel('Table')
  const cell = page.locator('#circle-grid [role="row"]').nth(2).getByRole('gridcell').last()
  await cell.dblclick()
  await page.keyboard.type('Bremen')
  await page.keyboard.press('Enter')
  await soon(async () => (await decodeLink(new URL(page.url()).hash)).attributes?.properties[1]).toBe(
    '{"name":"Bremen"}',
  )
  await cell.click()
  await expect(app.inspector.getByRole('heading')).toHaveText('Bremen')
})

test('names are written on the picture, and a layer switches them', async ({ eight: app }) => {
  const { page } = app
  await app.select(START, 0)
  await app.inspector.getByLabel('Name').fill('Hamburg')
  await page.keyboard.press('Enter')
  await page.keyboard.press('Escape')
  /** Pixels of the overlay around the middle of the named circle. */
  const written = () =>
    app.canvas
      .locator('canvas')
      .nth(1)
      .evaluate(
        (canvas: HTMLCanvasElement, { x, y }) => {
          const copy = new OffscreenCanvas(120, 20)
          const context = copy.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
          context.drawImage(canvas, 60 - x, 10 - y)
          return context.getImageData(0, 0, 120, 20).data.filter((value, k) => k % 4 === 3 && value > 200).length
        },
        app.center(START, 0),
      )
  await app.select(START, 3)
  await soon(written).toBeGreaterThan(100)
  await app.openPanel('Layers')
  await page.getByLabel('Names').uncheck()
  await soon(written).toBe(0)
  await soon(async () => (await decodeLink(new URL(page.url()).hash)).layers).toEqual({ labels: false })
})

test('circles snap to a visible grid, whose axes have numbers', async ({ eight: app }) => {
  const { page } = app
  await app.openPanel('Layers')
  await page.getByLabel('Axes and grid').check()
  await app.openPanel('Layers')
  const from = app.center(START, 2)
  const to = (x: number): Point => ({ x: x + 41, y: from.y + 33 })
  await app.drag(from, to(from.x))
  await page.mouse.up()
  const [x, y] = [app.field('x'), app.field('y')]
  await soon(async () => [await x.inputValue(), await y.inputValue()]).toEqual(['-0.8', '3.6'])
})
