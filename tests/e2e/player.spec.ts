// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, type Page } from '@playwright/test'
import { soon } from '../soon.ts'
import { violationsOf } from './accessibility.ts'
import { testOf } from './built-page.ts'
import type { PlayerPage } from './player-page/player-page.ts'

declare const playing: PlayerPage

const test = testOf('player-page', (page) => expect(page.getByRole('slider', { name: 'Step' })).toBeVisible())

const stepOf = (page: Page) => page.evaluate(() => playing.stepOf() as number)

test('plays the method by keys and by mouse', async ({ opened: page }) => {
  const slider = page.getByRole('slider', { name: 'Step' })
  const sentence = page.locator('.sentence')
  const current = page.locator('[aria-current="step"]')
  await expect(sentence).toHaveText('There are 7 circles.')
  await slider.focus()
  await page.keyboard.press('ArrowRight')
  await expect(sentence).toHaveText(/^The Delaunay graph of the centers has \d+ edges\.$/)
  await expect(current).toHaveText('T ← Delaunay graph of the centers')
  await expect(slider).toHaveAttribute('aria-valuetext', /^Step 1 of \d+$/)
  await page.keyboard.press('End')
  await expect(sentence).toContainText('The judge proves the diagram.')
  expect(await page.evaluate(() => playing.view.hasDiagram)).toBe(true)
  await page.keyboard.press('ArrowLeft')
  expect(await page.evaluate(() => playing.view.hasDiagram)).toBe(false)
  await page.keyboard.press('Home')
  expect(await stepOf(page)).toBe(0)

  // Jumps to the next vertex and back. The list begins with the disc that is taken.
  await page.getByRole('combobox', { name: 'Jump to' }).selectOption('vertex')
  await page.getByRole('button', { name: 'Next match' }).click()
  await expect(sentence).toContainText('is a vertex')
  const vertex = await stepOf(page)
  await page.getByRole('button', { name: 'Previous step' }).click()
  await expect(sentence).toContainText('Are its directed edges still there?')

  // Playback stops at a breakpoint.
  await page.getByRole('button', { name: 'Breakpoint: stop here when playing' }).click()
  await page.evaluate((step) => playing.stepTo(step - 4), vertex)
  await page.getByRole('combobox', { name: 'Speed' }).selectOption('30 / s')
  await page.getByRole('button', { name: 'Play', exact: true }).click()
  await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible()
  expect(await stepOf(page)).toBe(vertex - 1)

  // In the quiz, an answer is followed by the step.
  await page.getByRole('button', { name: 'Quiz: ask me before each step what happens next' }).click()
  await expect(page.getByRole('group', { name: 'What happens next?' })).toContainText('Which directed edges')
  await page
    .getByRole('button', { name: /edges end, one begins|Three edges end/ })
    .first()
    .click()
  await expect(page.locator('.question')).toContainText(/^\s*(Right\.|No: .*\.) [01] of 1 right so far\./)
  await expect(sentence).toContainText('is a vertex')

  // The ring of the selected circle, and the steps about it.
  await page.evaluate(() => playing.select([4]))
  await expect(page.getByRole('img', { name: /^Around circle 4: / })).toBeVisible()
  await page.getByRole('combobox', { name: 'Jump to' }).selectOption('selected')
  await page.getByRole('button', { name: 'Previous match' }).click()
  await expect(sentence).toContainText('4')
  const violations = await violationsOf(page, '#player')
  expect(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([])
})

test('buttons give the focus to the slider at the ends, it plays again from the start, and an edit takes breakpoints away', async ({
  opened: page,
}) => {
  await test.step('a button that has nothing left to do gives the focus to the slider', async () => {
    const slider = page.getByRole('slider', { name: 'Step' })
    await page.evaluate(() => playing.stepTo(1))
    await page.getByRole('button', { name: 'Previous step' }).click()
    expect(await stepOf(page)).toBe(0)
    await expect(slider).toBeFocused()
    await page.evaluate(() => playing.stepTo(playing.player.steps - 2))
    await page.getByRole('button', { name: 'Next step', exact: true }).press('Enter')
    await expect(page.locator('.sentence')).toContainText('The judge proves the diagram.')
    await expect(slider).toBeFocused()
    // A button that is still enabled keeps the focus.
    const back = page.getByRole('button', { name: 'Previous step' })
    await back.press('Enter')
    await expect(back).toBeFocused()
  })
  await test.step('it plays from the start once the end is reached', async () => {
    await page.evaluate(() => {
      playing.stepTo(playing.player.steps - 1)
      playing.seen.length = 0
    })
    await page.getByRole('button', { name: 'Play', exact: true }).click()
    await soon(() => page.evaluate(() => playing.seen.slice(0, 2))).toEqual([0, 1])
    expect(await page.evaluate(() => playing.view.hasDiagram)).toBe(false)
    await page.getByRole('button', { name: 'Pause' }).click()
    await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible()
  })
  await test.step('it stops nowhere in the trace of edited circles, whose steps are others', async () => {
    const stop = page.getByRole('button', { name: 'Breakpoint: stop here when playing' })
    await page.evaluate(() => playing.stepTo(3))
    await stop.click()
    await expect(stop).toHaveAttribute('aria-pressed', 'true')
    const steps = await page.evaluate(() => playing.player.steps)
    await page.evaluate(() => playing.view.scene.edit([{ kind: 'remove', id: 3 }]))
    await soon(() => page.evaluate(() => playing.player.steps)).not.toBe(steps)
    await page.evaluate(() => playing.stepTo(3))
    await expect(stop).toHaveAttribute('aria-pressed', 'false')
  })
})

test.describe('on a phone', () => {
  test.use({ viewport: { width: 320, height: 640 }, hasTouch: true, colorScheme: 'dark' })

  test('plays flips and edits by touch, and nothing is wider than the screen', async ({ opened: page }) => {
    const sentence = page.locator('.sentence')
    await page.getByRole('button', { name: 'Next step', exact: true }).tap()
    await expect(sentence).toContainText('Delaunay graph')
    for (const [options, step, said] of [
      [{ method: 'auto' }, 3, /the edge is wrong|No edge is left to flip/],
      [
        { edits: [{ kind: 'insert', circle: [5, 4, 0.5] }] },
        2,
        /^Circle 7 is inserted at \(5, 4\) with radius 0\.5\.$/,
      ],
    ] as const) {
      await page.evaluate(
        async ([options, step]) => {
          playing.player.dispose()
          playing.player = playing.play(options, step)
          await playing.player.ready
        },
        [options, step] as const,
      )
      await expect(sentence).toHaveText(said)
    }
    const slider = await page.getByRole('slider', { name: 'Step' }).boundingBox()
    await page.touchscreen.tap((slider?.x ?? 0) + (slider?.width ?? 0) - 3, (slider?.y ?? 0) + 20)
    await expect(sentence).toContainText('The judge proves the diagram.')
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320)
    const refused = await page.evaluate(async () => {
      playing.player.dispose()
      playing.player = playing.play({ edits: [{ kind: 'remove', id: 70 }] })
      return playing.player.ready.catch((error) => error.message)
    })
    expect(refused).toBe('There is no circle with id 70.')
    await expect(sentence).toHaveText(refused)
  })
})
