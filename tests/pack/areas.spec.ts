// SPDX-License-Identifier: GPL-3.0-or-later
// examples/treemap and examples/districts, on the built package.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { ROOT } from './project.mjs'
import { serve } from './static-server.ts'

let server: Awaited<ReturnType<typeof serve>>
test.beforeAll(async () => {
  server = await serve(ROOT)
})
test.afterAll(() => server.close())

/** Opens an example, and returns the list that collects its errors. */
async function open(page: Page, name: string): Promise<string[]> {
  const problems: string[] = []
  page.on('pageerror', ({ message }) => problems.push(message))
  await page.goto(`${server.address}examples/${name}/`)
  return problems
}

/** The cells' shares of the picture's area, measured on their paths in the browser. */
async function areaOf(page: Page, names: string): Promise<number> {
  return page.locator(`[data-names="${names}"]`).evaluate((path) => {
    const its = path as SVGPathElement
    const points = Array.from({ length: 2000 }, (_, k) => its.getPointAtLength((its.getTotalLength() * k) / 2000))
    const twice = points.reduce((sum, { x, y }, k) => {
      const next = points[(k + 1) % points.length] as DOMPoint
      return sum + x * next.y - y * next.x
    }, 0)
    return Math.abs(twice) / 2
  })
}

test('a treemap has cells as large as their numbers, in the first year and in the last', async ({ page }) => {
  const problems = await open(page, 'treemap')
  const output = page.locator('output')
  await expect(output).toHaveText(/1950/, { timeout: 60_000 })
  expect(await page.locator('[data-names]').count()).toBe(32)
  const ratio = async (a: string, b: string) => (await areaOf(page, a)) / (await areaOf(page, b))
  expect(await ratio('Asia/China', 'Europe/France')).toBeCloseTo(544 / 42, 0)
  expect(await ratio('Africa/Egypt', 'Africa/Ethiopia')).toBeCloseTo(21 / 18, 1)
  await page.getByRole('button', { name: '2020' }).click()
  await expect(output).toHaveText(/2020/, { timeout: 60_000 })
  expect(await ratio('Africa/Nigeria', 'Europe/Germany')).toBeCloseTo(208 / 83, 1)
  await page.getByRole('slider').press('Home')
  await expect(output).toHaveText(/1950/)
  expect(await ratio('Africa/Nigeria', 'Europe/Germany')).toBeCloseTo(37 / 71, 1)
  expect(problems).toEqual([])
})

test('a script writes the same treemap as an SVG', async ({ page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-'))
  try {
    const file = join(folder, 'treemap.svg')
    execFileSync(process.execPath, [join(ROOT, 'examples/treemap/write-svg.mjs'), file])
    const shapes = readFileSync(file, 'utf8').match(/<path d="[^"]+"/g)
    await open(page, 'treemap')
    await expect(page.locator('[data-names]').first()).toBeVisible({ timeout: 60_000 })
    const shown = await page
      .locator('#picture path')
      .evaluateAll((paths) => paths.map((path) => path.getAttribute('d')))
    expect(shapes).toEqual(shown.map((d) => `<path d="${d}"`))
  } finally {
    rmSync(folder, { recursive: true })
  }
})

test('districts have nearly equal numbers of people', async ({ page }) => {
  const problems = await open(page, 'districts')
  const output = page.locator('#result')
  for (const count of ['10', '5']) {
    await page.locator('#count').fill(count)
    await expect(output).toHaveText(new RegExp(`^${count} districts of `), { timeout: 60_000 })
    const [, percent] = /at most ([\d.]+) % from the mean$/.exec((await output.textContent()) ?? '') ?? []
    expect(Number(percent)).toBeLessThan(8)
    expect(await page.locator('#picture path').count()).toBe(Number(count))
    expect(await page.locator('#picture circle').count()).toBe(580)
  }
  expect(problems).toEqual([])
})
