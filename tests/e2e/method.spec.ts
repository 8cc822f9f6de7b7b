// SPDX-License-Identifier: GPL-3.0-or-later
// The touching disc method's result by candidates and samples.
import { decodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { expect, test } from './page.ts'

test('candidates and samples change what the method finds, and not the diagram', async ({ app }) => {
  const { page } = app
  await app.openPanel('Gallery')
  await page.getByText('Hard inputs', { exact: true }).click()
  await page.getByRole('button', { name: /^Figure 5d/ }).click()
  await expect(page.getByLabel('Data set').locator('option:checked')).toHaveText('Figure 5d')
  await app.openPanel('Gallery')
  const counts = async () => (await app.status.textContent())?.replace(/ · [^·]* m?s$/, '')
  const before = await counts()
  await app.openPanel('Layers')
  const panel = page.getByRole('region', { name: 'Layers' })
  await panel.getByLabel('Edges that it misses').check()
  const said = panel.locator('#method-found')
  const found = async () =>
    ((await said.textContent())?.match(/\d[\d,]*/g) ?? []).map((text) => Number(text.replaceAll(',', '')))
  await expect(said).toContainText('What is shown stays certified.')
  const [, dynamicVertices, vertices, dynamicEdges, edges] = await found()
  expect([dynamicVertices, dynamicEdges]).toEqual([vertices, edges])
  await expect(said).toContainText('nothing that is wrong')

  // Three samples per circle are too few here, so edges are missed and highlighted.
  const pink = () =>
    page
      .locator('#figure canvas')
      .first()
      .evaluate((canvas: HTMLCanvasElement) => {
        const probe = document.body.appendChild(document.createElement('span'))
        probe.style.color = 'var(--missed-edges)'
        const [r, g, b] = (getComputedStyle(probe).color.match(/\d+/g) ?? []).map(Number)
        probe.remove()
        const copy = new OffscreenCanvas(canvas.width, canvas.height)
        const context = copy.getContext('2d') as OffscreenCanvasRenderingContext2D
        context.drawImage(canvas, 0, 0)
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height)
        let count = 0
        for (let k = 0; k < data.length; k += 4) if (data[k] === r && data[k + 1] === g && data[k + 2] === b) count += 1
        return count
      })
  await app.painted()
  expect(await pink()).toBe(0)
  await panel.getByLabel('Candidates').selectOption('uniform')
  await panel.getByLabel('m, samples on a circle').fill('3')
  await panel.getByLabel('m, samples on a circle').press('Enter')
  await soon(async () => (await found())[4]).toBe(edges)
  await soon(async () => ((await found())[3] as number) < (edges as number)).toBe(true)
  await soon(pink).toBeGreaterThan(20)
  expect(await counts()).toBe(before)
  const linked = async () => (await decodeLink(new URL(page.url()).hash).catch(() => undefined))?.layers
  const few = { missedEdges: true, candidates: 'uniform', sampleCount: 3 }
  await soon(linked).toEqual(few)

  // An invalid number of samples changes nothing.
  await panel.getByLabel('m, samples on a circle').fill('0')
  await panel.getByLabel('m, samples on a circle').press('Enter')
  // The link follows later changes.
  await panel.getByLabel('Convex hull').check()
  await soon(linked).toEqual({ ...few, hull: true })
  await panel.getByLabel('Convex hull').uncheck()
  await panel.getByLabel('Candidates').selectOption('all-pairs')
  await expect(said).toContainText('From all pairs')
  await soon(async () => (await found()).slice(0, 4)).toEqual([vertices, vertices, edges, edges])
  // An edit updates the result.
  await page.locator('#figure').focus()
  await page.keyboard.press('Enter')
  await expect(app.inspector).toBeVisible()
  await page.keyboard.press('Delete')
  await soon(async () => (await found())[3]).toBeLessThan(edges as number)
})
