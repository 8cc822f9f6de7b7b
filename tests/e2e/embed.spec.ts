// SPDX-License-Identifier: GPL-3.0-or-later
// The embedded page, which shows the link after the # of its address.
import { expect, type Page, test } from '@playwright/test'
import { encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { got, heldBack } from './held-back.ts'

const WAKA = 504

const circlesOf = (page: Page) =>
  page.evaluate(
    () => (document.querySelector('circle-voronoi') as HTMLElementTagNameMap['circle-voronoi']).circles.length / 3,
  )

test('refuses a link that asks for more circles than links may', async ({ page }) => {
  await page.goto(`/embed.html#${await encodeLink({ dataSet: 'dense:1:1000000' })}`)
  await expect(page.getByRole('alert')).toHaveText('The link is for too many circles.')
})

test('shows the link that its address has last, though the one before is slower', async ({ page }) => {
  const answer = await heldBack('**/data/spruces.csv', page)
  const asked = page.waitForRequest('**/data/spruces.csv')
  await page.goto(`/embed.html#${await encodeLink({ dataSet: 'spruces' })}`)
  await asked
  const next = await encodeLink({ dataSet: 'waka' })
  await page.evaluate((link) => {
    location.hash = link
  }, next)
  await soon(() => circlesOf(page)).toBe(WAKA)
  const answered = page.waitForResponse('**/data/spruces.csv')
  answer()
  await (await answered).finished()
  await got(page, 'data/spruces.csv')
  // Its thread draws after all earlier requests.
  await page.evaluate(() => document.querySelector('circle-voronoi')?.toSVG())
  expect(await circlesOf(page)).toBe(WAKA)
  await expect(page.locator('#problem')).toBeHidden()
})

test('labels of goals cover none of one another, and are in the picture', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 250 })
  const circles = [
    [0, 3.4, 2],
    [-3.6, -2.6, 2],
    [3.6, -2.6, 2],
  ] as const
  const check = { all: [0, 1, 2].map((cell) => ({ cell, r: { min: 4.5 } })) }
  await page.goto(`/embed.html#${await encodeLink({ circles, check })}`)
  const labels = page.locator('.rings > span')
  await expect(labels).toHaveText(['0radius 2', '1radius 2', '2radius 2'])
  const picture = (await page.locator('.rings').boundingBox()) as { y: number; height: number }
  const boxes = await labels.evaluateAll((all) => all.map((label) => label.getBoundingClientRect().toJSON() as DOMRect))
  for (const [k, box] of boxes.entries()) {
    expect(box.top).toBeGreaterThanOrEqual(picture.y)
    expect(box.bottom).toBeLessThanOrEqual(picture.y + picture.height)
    for (const other of boxes.slice(k + 1)) {
      const isApart =
        box.right <= other.left || other.right <= box.left || box.bottom <= other.top || other.bottom <= box.top
      expect(isApart, JSON.stringify([box, other])).toBe(true)
    }
  }
})

test('an element in a form goes back to what its attributes say when the form is reset', async ({ page }) => {
  await page.goto(`/embed.html#${await encodeLink({ dataSet: 'waka' })}`)
  await soon(() => circlesOf(page)).toBe(WAKA)
  const told = await page.evaluate(async () => {
    const form = document.body.appendChild(document.createElement('form'))
    form.innerHTML =
      '<circle-voronoi name="figure" layers="dual" step="1" circles="[[0,0,1],[6,0,1],[0,8,1]]"></circle-voronoi>'
    const figure = form.firstChild as HTMLElementTagNameMap['circle-voronoi']
    await figure.ready
    const told: unknown[] = []
    const tell = () => told.push([...figure.circles])
    const changed = () => new Promise((resolve) => figure.addEventListener('diagramchange', resolve, { once: true }))
    for (const act of [
      () => {
        figure.circles = Float64Array.of(1, 2, 3)
      },
      () => form.reset(),
    ]) {
      const change = changed()
      act()
      await change
      tell()
    }
    // An attribute replaces the property that was set before.
    figure.layers = { ...figure.layers, dual: false, hull: true }
    told.push([figure.layers.dual, figure.layers.hull])
    figure.setAttribute('layers', 'dual')
    told.push([figure.layers.dual, figure.layers.hull])
    // An attribute that is set to its former value does so, too.
    await figure.stepTo(2)
    const { step } = figure
    figure.setAttribute('step', '1')
    await figure.updateComplete
    told.push([step, figure.step])
    return told
  })
  expect(told).toEqual([
    [1, 2, 3],
    [0, 0, 1, 6, 0, 1, 0, 8, 1],
    [false, true],
    [true, false],
    [2, 1],
  ])
})
