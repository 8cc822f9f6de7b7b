// SPDX-License-Identifier: GPL-3.0-or-later
// Playback of the method on the page's circles.
import type { Page } from '@playwright/test'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { violationsOf } from './accessibility.ts'
import { type App, expect, test } from './page.ts'

const stepOf = async (link: string) => (await decodeLink(link).catch(() => undefined))?.step
const stepOfAddress = (app: App) => stepOf(new URL(app.page.url()).hash)

test('is one button away, follows what is edited, and a link opens it at its step', async ({ app }) => {
  const { page } = app
  const button = page.getByRole('button', { name: 'Step by step' })
  const player = page.getByRole('region', { name: 'The method, step by step' })
  const slider = player.getByRole('slider', { name: 'Step' })
  const sentence = player.locator('.sentence')
  await button.click()
  await expect(sentence).toHaveText('There are 678 circles.')
  await expect(button).toHaveAttribute('aria-expanded', 'true')
  // Playback continues with other circles.
  await app.choose('Introduction')
  await expect(sentence).toHaveText('There are 14 circles, 1 of them inside others and left out.')
  await slider.focus()
  for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowRight')
  await expect(sentence).toHaveText(/ \d+ samples lie/)
  await soon(() => stepOfAddress(app)).toBe(3)
  const waiting = page.getByText('The method is played: layers are seen at its end.')
  await app.openPanel('Layers')
  await expect(waiting).toBeVisible()
  await slider.press('End')
  await expect(waiting).toBeHidden()
  await app.openPanel('Layers')
  await slider.press('Home')
  await slider.focus()
  for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowRight')
  // The address may still be the old one, and briefly name a step on the way.
  let link = ''
  const readLink = () => {
    link = new URL(page.url()).hash
    return stepOf(link)
  }
  await soon(readLink).toBe(3)
  expect((await decodeLink(link)).view).toBeUndefined()
  expect(await violationsOf(page)).toEqual([])

  // At a stage, playback stays there with the edited circles.
  const before = await sentence.textContent()
  await app.canvas.focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press('Delete')
  await expect(app.status).toContainText('13 circles')
  await expect(sentence).toHaveText(/ \d+ samples lie/)
  await expect(sentence).not.toHaveText(before as string)
  await page.keyboard.press('Control+z')
  await expect(sentence).toHaveText(before as string)
  await player.getByLabel('Method').selectOption('Edge flips')
  await expect(sentence).toContainText('There are 14 circles')
  await slider.press('End')
  await expect(sentence).toContainText('No edge is left to flip. The judge proves the diagram.')
  await soon(async () => (await decodeLink(new URL(page.url()).hash)).method).toBe('auto')

  await player.getByRole('button', { name: 'Close the player' }).click()
  await expect(player).toBeHidden()
  await expect(button).toBeFocused()
  await soon(() => stepOfAddress(app)).toBeUndefined()
  // Too many circles are refused; a link to the earlier ones opens at its step.
  await app.choose('Random, 10,000')
  await button.click()
  await expect(sentence).toHaveText('A method is played for 1,000 circles at most; there are 10,000.')
  await page.evaluate((link) => {
    location.hash = link
  }, link)
  await expect(sentence).toHaveText(/ \d+ samples lie/)
  await expect(app.status).toContainText('14 circles')
})

/** The boxes and styles of the parts of the player while it asks a question. Colors of paper and of menus differ. */
async function lookOf(page: Page) {
  const player = page.locator('.cv-player')
  await player.getByRole('button', { name: /^Quiz/ }).click()
  const answers = player.getByRole('group', { name: 'What happens next?' }).getByRole('button')
  await soon(async () => {
    if ((await answers.count()) === 0) await player.getByRole('button', { name: 'Next step', exact: true }).click()
    return answers.count()
  }).toBeGreaterThan(1)
  await page.mouse.move(0, 0)
  return player.evaluate((root) => {
    const { left, top } = (root.querySelector('.head') as Element).getBoundingClientRect()
    return [...root.querySelectorAll('.head, .head *:not(option, svg *), .ring, .ring *')].map((part) => {
      const box = part.getBoundingClientRect()
      const style = getComputedStyle(part)
      const names = [...style].filter((name) => !/color|^--|background/.test(name))
      return [
        `${part.localName} ${part.getAttribute('class')}`,
        ...[box.left - left, part.closest('.head') && box.top - top, box.width, box.height].map((n) => n?.toFixed(1)),
        ...names.map((name) => `${name}: ${style.getPropertyValue(name)}`),
      ]
    })
  })
}

test('looks the same in the page and in a frame', async ({ app, context }) => {
  const circles = Float64Array.of(0, 0, 2, 20, 0, 3, 20, 20, 1, 10, 9, 2, 0, 20, 4)
  const link = await encodeLink({ circles, step: 9 })
  await app.open(link)
  const look = await lookOf(app.page)
  const width = await app.page.locator('.cv-player').evaluate((player) => player.getBoundingClientRect().width)
  const frame = await context.newPage()
  await frame.setViewportSize({ width, height: 900 })
  await frame.goto(`/embed.html#${link}`)
  expect(await lookOf(frame)).toEqual(look)
})

test('the link of a narrow frame to the playground covers nothing of the player', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await page.goto(`/embed.html#${await encodeLink({ circles: Float64Array.of(0, 0, 2, 20, 0, 3, 9, 20, 1), step: 4 })}`)
  await expect(page.locator('.cv-player .sentence')).toBeVisible()
  const link = page.getByRole('link', { name: 'Open' })
  await expect(link).toBeInViewport({ ratio: 1 })
  const below = await link.evaluate((element) => {
    const { left, top, width, height } = element.getBoundingClientRect()
    return document.elementsFromPoint(left + width / 2, top + height / 2).map(({ localName }) => localName)
  })
  expect(below).not.toContain('circle-voronoi')
})

test.describe('on a phone', () => {
  test.use({ viewport: { width: 320, height: 640 }, hasTouch: true, colorScheme: 'dark' })

  test('has a sheet of its own, and leaves the picture its room', async ({ app }) => {
    const { page } = app
    const player = page.getByRole('region', { name: 'The method, step by step' })
    await app.openPanel('Step by step')
    await expect(player.locator('.sentence')).toHaveText('There are 678 circles.')
    await player.getByRole('button', { name: 'Next step', exact: true }).tap()
    await expect(player.locator('.sentence')).toContainText('The Delaunay graph of the centers')
    const { x, y, width, height } = (await player.boundingBox()) as {
      x: number
      y: number
      width: number
      height: number
    }
    expect([x >= 0, x + width <= 320, y > 240, y + height <= 640]).toEqual([true, true, true, true])
    const cut = await player.evaluate((element) => {
      const buttons = [...element.querySelectorAll('button, select')].map((item) => item.getBoundingClientRect())
      return buttons.filter(({ left, right }) => left < 8 || right > 312).length
    })
    expect(cut).toBe(0)
    // A question has its answers in sight, and afterwards the buttons are.
    const button = (name: string | RegExp) => player.getByRole('button', { name })
    await button(/^Quiz/).tap()
    const answers = player.getByRole('group', { name: 'What happens next?' }).getByRole('button')
    for (let k = 0; k < 20 && (await answers.count()) === 0; k++) await button(/^Next step$/).tap()
    await expect(answers.first()).toBeInViewport({ ratio: 1 })
    await expect(answers.last()).toBeInViewport({ ratio: 1 })
    // The head fills the room above them.
    const gap = await answers.last().evaluate((answer) => {
      const player = answer.closest('.cv-player') as HTMLElement
      return player.getBoundingClientRect().bottom - answer.getBoundingClientRect().bottom
    })
    expect(gap).toBeLessThan(60)
    await answers.last().tap()
    await expect(button(/^Next step$/)).toBeInViewport({ ratio: 1 })
    await player.getByRole('button', { name: 'Close the player' }).tap()
    await expect(page.getByRole('button', { name: 'Layers' })).toBeVisible()
  })
})
