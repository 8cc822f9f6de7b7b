// SPDX-License-Identifier: GPL-3.0-or-later
// A question is made in the panel Share and asked by the embedded page.
import type { Locator } from '@playwright/test'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { violationsInBoth } from './accessibility.ts'
import { App, expect, test } from './page.ts'

const CIRCLES = Float64Array.of(0, 0, 2, 10, 0, 2, 5, 10, 2, 9, 6, 1, 5, 4, 0.5)

test.use({ link: await encodeLink({ circles: CIRCLES }) })

const copiedLink = (app: App) => app.copiedBy(app.page.getByRole('button', { name: 'Copy question link' }))

async function openForm(app: App): Promise<void> {
  await app.page.getByRole('button', { name: 'Share', exact: true }).click()
  await app.page.getByRole('button', { name: 'Make a question' }).click()
  await expect(app.page.getByRole('group', { name: 'Condition 1' })).toBeVisible()
}

test('conditions become the question of a frame, which is solved by moving a circle', async ({ app }) => {
  const { page } = app
  await openForm(app)
  const condition = page.getByRole('group', { name: 'Condition 1' })
  await condition.getByRole('button', { name: 'Choose the circle' }).click()
  const { x, y } = app.center(CIRCLES, 4)
  await page.mouse.click(x, y)
  await expect(condition.getByLabel('Circle of condition 1')).toHaveValue('4')
  await expect(page.locator('#figure .rings')).toContainText('44 edges')
  await expect(condition.getByText('now 4')).toBeVisible()
  await expect(page.locator('#question-now')).toContainText('do not meet this yet')
  await expect(page.getByLabel('Question', { exact: true })).toHaveAttribute(
    'placeholder',
    'Move the circles until the cell of circle 4 has 3 edges.',
  )
  // Adds a second condition, about the diagram.
  await page.getByRole('button', { name: 'Add a condition' }).click()
  await page.getByLabel('What condition 2 is about').selectOption({ label: 'number of circles' })
  await page.getByLabel('Comparison of condition 2').selectOption({ label: 'exactly' })
  await page.getByLabel('Value of condition 2').fill('5')
  await page.getByLabel('Value of condition 2').press('Enter')
  await expect(page.getByText('now 5')).toBeVisible()
  await page.getByLabel('Question', { exact: true }).fill('Give the smallest circle three edges.')
  await page.getByLabel('Title').fill('Three "edges"')
  await page.getByLabel('Language').selectOption('German')
  expect(await violationsInBoth(page)).toEqual([])
  const code = await app.copiedBy(page.getByRole('button', { name: 'Copy question code' }))
  await expect(page.locator('#toast')).toContainText('The code of the question is in the clipboard.')
  expect(code).toMatch(/^<iframe src="[^"]+\/embed\.html#v1\.[\w-]+" title="Three &quot;edges&quot;" loading="lazy"/)
  const address = /src="([^"]+)"/.exec(code)?.[1] as string
  expect(await decodeLink(new URL(address).hash)).toEqual({
    circles: CIRCLES,
    title: 'Three "edges"',
    question: 'Give the smallest circle three edges.',
    check: {
      all: [{ cell: 4, edges: 3 }, { circles: 5 }],
    },
    lang: 'de',
  })
  expect(await copiedLink(app)).toBe(address)
  const opening = page.waitForEvent('popup')
  await page.getByRole('button', { name: 'Try it' }).click()
  const tab = await opening
  await expect(tab).toHaveURL(address)
  await expect(tab.getByRole('status')).toHaveText('Noch nicht gelöst')
  await expect(tab.locator('#goals')).toHaveText('Kanten: jetzt 4, Ziel 3; Kreise: jetzt 5, Ziel 5')
  const ring = tab.locator('circle-voronoi .rings circle')
  await expect(ring).not.toHaveClass(/closed/)
  expect(await violationsInBoth(tab)).toEqual([])
  const circlesThere = () => tab.evaluate(() => document.querySelector('circle-voronoi')?.circles.length)
  await soon(circlesThere).toBe(CIRCLES.length)
  await tab.evaluate(() => {
    const figure = document.querySelector('circle-voronoi') as HTMLElementTagNameMap['circle-voronoi']
    figure.circles = [
      [0, 0, 2],
      [10, 0, 2],
      [5, 10, 2],
      [9, 6, 1],
      [9, 3, 0.5],
    ]
  })
  await expect(tab.getByRole('status')).toHaveText('Gelöst')
  await expect(ring).toHaveClass(/closed/)
  // Check marks say the same without motion.
  const before = (place: Locator, part: string) =>
    place.evaluate((element, part) => getComputedStyle(element, part).content, part)
  expect(await before(tab.getByRole('status'), '::before')).toContain('✓')
  expect(await before(tab.locator('circle-voronoi .rings > span'), '::after')).toContain('✓')
})

test('circles keep their names in a question where others are deleted', async ({ app }) => {
  const { page } = app
  await app.select(CIRCLES, 1)
  await page.keyboard.press('Delete')
  await expect(app.status).toContainText('4 circles')
  await openForm(app)
  await page.getByLabel('Circle of condition 1').fill('4')
  await page.getByLabel('Circle of condition 1').press('Enter')
  const { check, circles } = await decodeLink(new URL(await copiedLink(app)).hash)
  expect(check).toEqual({ cell: 3, edges: 3 })
  expect([...(circles as Float64Array).slice(9)]).toEqual([5, 4, 0.5])
  // A missing circle is reported.
  await page.getByLabel('Circle of condition 1').fill('1')
  await page.getByLabel('Circle of condition 1').press('Enter')
  await expect(page.locator('#question-now')).toHaveText('There is no circle 1.')
})

test('says what cannot be solved, and what is solved already', async ({ app }) => {
  const { page } = app
  await openForm(app)
  await page.getByLabel('Value of condition 1').fill('2')
  await page.getByLabel('Value of condition 1').press('Enter')
  const said = page.locator('#question-now')
  await page.getByLabel('Readers may').selectOption('only look')
  await expect(said).toHaveText('Readers who may only look cannot solve this.')
  await page.getByLabel('Readers may').selectOption('edit circles')
  await page.getByLabel('Comparison of condition 1').selectOption('at least')
  await expect(said).toContainText('meet this already')
  // The form follows the circles.
  await page.getByLabel('What condition 1 is about').selectOption({ label: 'number of circles' })
  await page.getByLabel('Value of condition 1').fill('6')
  await page.getByLabel('Value of condition 1').press('Enter')
  await expect(said).toContainText('do not meet this yet')
  await page.keyboard.press('n')
  await page.locator('#figure').focus()
  await page.keyboard.press('n')
  await expect(said).toContainText('meet this already')
  await page.getByRole('button', { name: 'Remove condition 1' }).click()
  await expect(said).toContainText('Without a condition')
})

test('a link with a question opens in the playground with its form, also with a check that no list makes', async ({
  page,
}) => {
  const app = new App(page)
  const state = { circles: CIRCLES, title: 'T', question: 'Q?', check: { not: { circles: 5 } }, alt: 'A', lang: 'de' }
  await app.open(await encodeLink(state))
  await page.getByRole('button', { name: 'Share', exact: true }).click()
  await expect(page.getByLabel('Question', { exact: true })).toHaveValue('Q?')
  await expect(page.getByText('{"not":{"circles":5}}')).toBeVisible()
  const link = await copiedLink(app)
  expect(link).toContain('embed.html#')
  expect(await decodeLink(new URL(link).hash)).toEqual(state)
})
