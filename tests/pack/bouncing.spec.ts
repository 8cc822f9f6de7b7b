// SPDX-License-Identifier: GPL-3.0-or-later
// examples/bouncing, on the built package.
import { expect, test } from '@playwright/test'
import { ROOT } from './project.mjs'
import { serve } from './static-server.ts'

test('the discs bounce, and their diagram follows', async ({ page }) => {
  const server = await serve(ROOT)
  try {
    const problems: string[] = []
    page.on('pageerror', ({ message }) => problems.push(message))
    page.on('console', (message) => message.type() === 'error' && problems.push(message.text()))
    await page.goto(`${server.address}examples/bouncing/`)
    const times = page.locator('output')
    await expect(times).toHaveText(/^frame \d+: edits [\d.]+ ms, drawing [\d.]+ ms$/, { timeout: 100_000 })
    const inked = await page.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
      const { data } = (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(
        0,
        0,
        canvas.width,
        canvas.height,
      )
      return data.filter((value, k) => k % 4 === 3 && value > 0).length / (canvas.width * canvas.height)
    })
    // The discs, and the edges between them, cover more than this share.
    expect(inked).toBeGreaterThan(0.25)
    expect(inked).toBeLessThan(0.7)
    expect(problems).toEqual([])
  } finally {
    await server.close()
  }
})
