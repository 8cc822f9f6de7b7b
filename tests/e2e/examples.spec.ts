// SPDX-License-Identifier: GPL-3.0-or-later
// The examples in the documentation: each runs in its page, and each has its source.
import { readdirSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, type Frame, test } from '@playwright/test'
import { soon } from '../soon.ts'
import { violationsOf } from './accessibility.ts'

const EXAMPLES = fileURLToPath(new URL('../../examples/', import.meta.url))
/** The folders that contain pages. */
const PAGES = [
  'bouncing',
  'districts',
  ...readdirSync(`${EXAMPLES}element`).map((name) => `element/${name}`),
  'globe',
  'treemap',
]

test('each page of the examples runs in the place of its picture, and shows a diagram', { tag: '@long' }, async ({
  page,
}) => {
  test.setTimeout(120_000)
  const problems: string[] = []
  page.on('pageerror', ({ message }) => problems.push(message))
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && problems.push(message.text()))
  await page.goto('/docs/examples.html')
  const pictures = page.locator('figure.example img')
  await expect(pictures).toHaveCount(PAGES.length)
  expect(await violationsOf(page)).toEqual([])
  for (const folder of PAGES) {
    const figure = page.locator(`figure.example[data-page="../examples/${folder}/"]`)
    await expect(figure.getByRole('link', { name: 'Open the page' })).toHaveAttribute('href', `../examples/${folder}/`)
    await figure.scrollIntoViewIfNeeded()
    const place = await figure.locator('img').boundingBox()
    await figure.getByRole('button', { name: 'Run it here' }).click()
    expect(await figure.locator('iframe').boundingBox()).toEqual(place)
    const shown = await (await figure.locator('iframe').elementHandle())?.contentFrame()
    await soon(() => inkOf(shown as Frame), folder).toBeGreaterThan(0.02)
    // Removing the figure terminates its threads.
    await figure.evaluate((element) => element.remove())
  }
  expect(problems).toEqual([])
})

/**
 * The share of pixels in a page's canvases, or in those of its frames, that are neither empty nor of the most common
 * color.
 */
async function inkOf(frame: Frame): Promise<number> {
  const inks = await Promise.all([frame, ...frame.childFrames()].map((each) => each.evaluate(inkHere)))
  return Math.max(...inks)
}

function inkHere(): number {
  // An SVG counts if it has shapes.
  if (document.querySelector('#picture svg path') !== null) return 1
  const shadows = [...document.querySelectorAll('circle-voronoi')].map(({ shadowRoot }) => shadowRoot)
  const canvases = [document, ...shadows].flatMap((root) => [...(root?.querySelectorAll('canvas') ?? [])])
  const inks = canvases.map((canvas) => {
    if (canvas.width === 0 || canvas.height === 0) return 0
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d') as OffscreenCanvasRenderingContext2D
    copy.drawImage(canvas, 0, 0)
    const pixels = new Uint32Array(copy.getImageData(0, 0, canvas.width, canvas.height).data.buffer)
    const counts = new Map<number, number>()
    for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1)
    return 1 - Math.max(...counts.values()) / pixels.length
  })
  return Math.max(0, ...inks)
}

test('without scripts examples are pictures, links and sources', async ({ browser }) => {
  const page = await (await browser.newContext({ javaScriptEnabled: false })).newPage()
  await page.goto('/docs/examples.html')
  await expect(page.getByRole('button', { name: 'Run it here' })).toHaveCount(0)
  await expect(page.getByRole('link', { name: 'Open the page' })).toHaveCount(PAGES.length)
  await page.locator('summary', { hasText: 'clearest_path.cpp' }).click()
  await expect(page.getByText('Usage: clearest_path')).toBeVisible()
  await page.context().close()
})
