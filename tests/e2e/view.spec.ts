// SPDX-License-Identifier: GPL-3.0-or-later
import { dataSet, expect, test } from './page.ts'

const INTRODUCTION = dataSet('introduction')

test('a drag ends, taken back, where something else takes the pointer away', async ({ app }) => {
  await app.choose('Introduction')
  const from = app.center(INTRODUCTION, 4)
  await app.canvas.evaluate((figure: HTMLElement) => {
    figure.addEventListener('pointerdown', ({ pointerId }) => {
      Object.assign(globalThis, { lose: () => figure.releasePointerCapture(pointerId) })
    })
  })
  await app.drag(from, { x: from.x + 30, y: from.y + 20 })
  await expect.poll(() => app.field('x').inputValue()).not.toBe(String(INTRODUCTION[12]))
  await app.page.evaluate(() => (globalThis as unknown as { lose(): void }).lose())
  await app.page.mouse.move(from.x + 60, from.y + 60, { steps: 4 })
  await expect(app.field('x')).toHaveValue(String(INTRODUCTION[12]))
  await app.page.mouse.up()
  await app.page.mouse.move(from.x - 60, from.y - 60, { steps: 4 })
  await expect(app.field('x')).toHaveValue(String(INTRODUCTION[12]))
  await expect(app.page.getByRole('button', { name: 'Undo' })).toBeDisabled()
})
