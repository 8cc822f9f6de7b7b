// SPDX-License-Identifier: GPL-3.0-or-later
import { pointAt } from '../../web/lib/curves/bisector.ts'
import { edgeCurve, isBoundedCurve } from '../../web/lib/curves/curve.ts'
import type { Point } from '../../web/lib/index.ts'
import { loadCircleVoronoi } from '../../web/lib/wasm/loader.ts'
import { soon } from '../soon.ts'
import { violationsInBoth } from './accessibility.ts'
import { framesOf } from './frames.ts'
import { got, heldBack } from './held-back.ts'
import { App, dataSet, expect, test } from './page.ts'
import { threadOf } from './thread-session.ts'

const BRONZE = dataSet('bronzefilter')
const INTRODUCTION = dataSet('introduction')
const START = dataSet('start')

test('shows a few circles at the start, and one line that says what it is', async ({ page }) => {
  const app = new App(page)
  await app.open('')
  await expect(app.status).toHaveText(/^8 circles/)
  const line = page.getByText('Every point is colored by its nearest circle. Drag one.')
  await expect(line).toBeVisible()
  for (const name of ['Tutorial', 'Docs', 'Source']) await expect(page.getByRole('link', { name })).toBeVisible()
  // The introduction's picture disappears with the first touch, and is static if the user prefers reduced motion.
  await expect(page.locator('#first-picture')).toHaveCount(0)
  await app.painted()
  const picture = await app.canvas.screenshot()
  await framesOf(page, 30)
  // A round trip to the thread makes sure that it has painted everything requested.
  await threadOf(page).evaluate(() => undefined)
  await app.painted()
  expect(picture.equals(await app.canvas.screenshot())).toBe(true)
  await app.select(START, 0)
  await expect(line).toBeHidden()
  // The first data set needs no link, and can be chosen again.
  expect(new URL(page.url()).hash).toBe('')
  await app.choose('Introduction')
  await app.choose('Eight circles')
  await expect(app.status).toHaveText(/^8 circles/)
})

test.describe('where motion is welcome', () => {
  test.use({ contextOptions: { reducedMotion: 'no-preference' } })

  test('one circle moves until the first touch, and is home then, with nothing to undo', async ({ page }) => {
    const app = new App(page)
    await app.open('')
    await expect(app.status).toHaveText(/^8 circles/)
    const picture = await app.canvas.screenshot()
    await soon(async () => picture.equals(await app.canvas.screenshot())).toBe(false)
    await app.select(START, 0)
    await app.canvas.focus()
    for (let k = 0; k < 7; k++) await page.keyboard.press('Tab')
    await expect(app.inspector).toContainText('Circle 7')
    await expect(app.field('x')).toHaveValue(String(START[21]))
    await expect(app.field('y')).toHaveValue(String(START[22]))
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled()
    await expect(page.getByLabel('Data set')).toHaveValue('start')
  })
})

test('shows the bronze filter of a link, under a strict Content-Security-Policy', async ({ app }) => {
  await expect(app.status).toContainText('678 circles')
  await expect(app.status).toContainText('1,339 vertices')
  await expect(app.status).toContainText('2,016 edges')
  const response = await app.page.request.get('/')
  const policy = response.headers()['content-security-policy']
  expect(policy).toContain("default-src 'self'")
  expect(policy).toContain("script-src 'self' 'wasm-unsafe-eval'")
  expect(policy).not.toContain('unsafe-inline')
  await expect(app.page.locator('meta[http-equiv="Content-Security-Policy"]')).toHaveAttribute(
    'content',
    policy as string,
  )
})

test('draws the edges as arcs, not as chords', async ({ introduction: app }) => {
  const diagram = (await loadCircleVoronoi()).compute(INTRODUCTION)
  const { scale } = app.camera(INTRODUCTION)
  const middles: Point[] = []
  for (let e = 0; e < diagram.edges.length / 4; e++) {
    const curve = edgeCurve(diagram, e)
    if (!isBoundedCurve(curve)) continue
    const chord = { x: (curve.start.x + curve.end.x) / 2, y: (curve.start.y + curve.end.y) / 2 }
    const arc = pointAt(curve.bisector, Math.sqrt(curve.from * curve.to))
    const isShown = [arc, chord].every((point) => app.isShown(app.locate(INTRODUCTION, point)))
    if (isShown && Math.hypot(arc.x - chord.x, arc.y - chord.y) * scale > 6) middles.push(arc, chord)
  }
  // Edges are dark, though a pixel may show no more than half of one. The middle of a chord is light unless another
  // layer is drawn there.
  await app.painted()
  const colors = await app.colors(middles.map((point) => app.locate(INTRODUCTION, point)))
  const isDark = colors.map(([red]) => (red as number) < 200)
  expect(isDark.filter((_, k) => k % 2 === 0)).not.toContain(false)
  const chords = isDark.filter((_, k) => k % 2 === 1)
  expect(chords.length).toBeGreaterThan(3)
  expect(chords.filter((dark) => !dark).length).toBeGreaterThan(chords.length / 2)
})

test('updates the diagram within a drag, before the mouse is released', async ({ app }) => {
  const from = app.center(BRONZE, 600)
  await app.page.mouse.click(from.x, from.y)
  await expect(app.inspector).toContainText('Circle 600')
  await soon(() => app.neighbors()).not.toEqual([])
  const neighbors = await app.neighbors()
  const picture = await app.canvas.screenshot()
  const to = app.center(BRONZE, 100)

  await app.drag(from, to)
  await soon(() => app.neighbors()).not.toEqual(neighbors)
  expect(picture.equals(await app.canvas.screenshot())).toBe(false)
  await soon(async () => Number(await app.field('x').inputValue())).toBeCloseTo(BRONZE[300] as number, 1)

  await app.page.mouse.up()
  await app.page.getByRole('button', { name: 'Undo' }).click()
  await soon(() => app.neighbors()).toEqual(neighbors)
  await expect(app.field('x')).toHaveValue(String(BRONZE[1800]))
})

test('adds a circle by a double click, and by pressing and dragging', async ({ introduction: app }) => {
  const { scale } = app.camera(INTRODUCTION)
  const free = app.locate(INTRODUCTION, { x: 2.3, y: 4.6 })
  await app.page.mouse.dblclick(free.x, free.y)
  await expect(app.status).toContainText('15 circles')
  await expect(app.inspector).toContainText('Circle 14')

  await app.page.getByRole('button', { name: 'Add a circle' }).click()
  const center = app.locate(INTRODUCTION, { x: 4.4, y: -3.3 })
  await app.drag(center, { x: center.x + 0.5 * scale, y: center.y })
  await app.page.mouse.up()
  await expect(app.status).toContainText('16 circles')
  await soon(async () => Number(await app.field('r').inputValue())).toBeCloseTo(0.5, 1)

  await app.page.keyboard.press('Control+z')
  await app.page.keyboard.press('Control+z')
  await expect(app.status).toContainText('14 circles')
  await app.page.keyboard.press('Control+Shift+z')
  await expect(app.status).toContainText('15 circles')
})

test('deletes the selected circle', async ({ app }) => {
  await app.select(BRONZE, 650)
  await app.page.keyboard.press('Delete')
  await expect(app.status).toContainText('677 circles')
  await expect(app.inspector).toBeHidden()
  await app.page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toContainText('678 circles')
})

test('deletes a circle in the middle of its drag, and no other one changes', async ({ app }) => {
  await app.choose('Introduction')
  const from = app.center(INTRODUCTION, 4)
  await app.drag(from, { x: from.x + 30, y: from.y + 20 })
  await app.page.keyboard.press('Delete')
  await app.page.mouse.move(from.x + 60, from.y + 60, { steps: 4 })
  await app.page.mouse.up()
  await expect(app.status).toContainText('13 circles')
  await expect(app.page.getByRole('alert')).toBeHidden()
  // Undo takes two steps, for the drag and for the deletion, so nothing else was recorded.
  const undo = app.page.getByRole('button', { name: 'Undo' })
  await undo.click()
  await expect(app.status).toContainText('14 circles')
  await undo.click()
  // Restores the circles from before the introduction.
  await undo.click()
  await expect(app.status).toContainText('678 circles')
  await expect(undo).toBeDisabled()
})

test('shows the data set that was chosen last', async ({ app }) => {
  const answer = await heldBack('**/data/spruces.csv', app.page)
  const menu = app.page.getByLabel('Data set')
  await menu.selectOption({ label: 'Spruces' })
  await menu.selectOption({ label: 'Waka trees' })
  await expect(app.status).toContainText('504 circles')
  const answered = app.page.waitForResponse('**/data/spruces.csv')
  answer()
  await (await answered).finished()
  await got(app.page, 'data/spruces.csv')
  // An opening that finished late would be undone here.
  await app.page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toContainText('678 circles')
  await app.page.getByRole('button', { name: 'Redo' }).click()
  await expect(app.status).toContainText('504 circles')
})

test('switches the data set by the menu', async ({ app }) => {
  await app.choose('Spruces')
  await expect(app.status).toContainText('134 circles')
  await app.choose('Waka trees')
  await expect(app.status).toContainText('504 circles')
  await expect(app.status).toContainText('10 hidden')
  await app.choose('Random')
  await expect(app.status).toContainText('300 circles')
})

test('the card says what hides a circle, and takes numbers but no wrong ones', async ({ app }) => {
  await test.step('says which circle is hidden, and by which', async () => {
    await app.choose('Introduction')
    await app.select(INTRODUCTION, 11)
    await expect(app.inspector).toContainText('Hidden inside circle 0')
  })
  await test.step('takes numbers, and refuses a wrong one in a sentence while the picture stays', async () => {
    await app.select(INTRODUCTION, 4)
    await app.field('x').fill('-3.25')
    await app.field('x').press('Enter')
    await expect(app.field('x')).toHaveAttribute('title', '-3.25')
    await expect(app.page.getByRole('alert')).toBeHidden()
    await app.painted()
    const counts = async () => (await app.status.textContent())?.replace(/ · [^·]* ms/, '')
    const before = await counts()

    await app.field('r').fill('-1')
    await app.field('r').press('Enter')
    await expect(app.page.getByRole('alert')).toHaveText(/4.*radius|radius.*4/i)
    await expect(app.field('r')).toHaveAttribute('aria-invalid', 'true')
    expect(await counts()).toBe(before)

    await app.field('r').fill('1.25')
    await app.field('r').press('Enter')
    await expect(app.page.getByRole('alert')).toBeHidden()
    await expect(app.field('x')).toHaveValue('-3.25')
  })
})

test('what is pressed on the first picture is pressed on the figure, whose pixels count', async ({ page }) => {
  // The painting thread never starts, so nothing may replace the picture.
  const answer = await heldBack('**/start-thread*', page)
  await page.goto('/')
  await expect(page.locator('#first-picture')).toBeVisible()
  const { width, height } = page.viewportSize() as { width: number; height: number }
  const pressed = () => page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.id, [width / 2, height / 2] as const)
  await soon(pressed).toBe('figure')
  answer()
  await expect(page.locator('#first-picture')).toBeHidden()
})

test('pans and zooms', async ({ app }) => {
  await app.page.mouse.move(640, 400)
  // Hovering changes the picture, too.
  await app.painted()
  const picture = await app.canvas.screenshot()
  const isOther = async () => !picture.equals(await app.canvas.screenshot())
  await app.page.mouse.wheel(0, -300)
  await soon(isOther).toBe(true)
  await app.page.getByRole('button', { name: 'Fit' }).click()

  const before = app.locate(BRONZE, { x: 9, y: -0.5 })
  await app.drag(before, { x: before.x + 100, y: before.y - 50 })
  await app.page.mouse.up()
  const circle = app.center(BRONZE, 650)
  await app.page.mouse.click(circle.x + 100, circle.y - 50)
  await expect(app.inspector).toContainText('Circle 650')
})

test('works with the keyboard alone', async ({ introduction: app }) => {
  await app.canvas.focus()
  await app.page.keyboard.press('Enter')
  await expect(app.inspector).toBeVisible()
  await app.page.keyboard.press('Escape')
  await expect(app.inspector).toBeHidden()

  await app.select(INTRODUCTION, 1)
  await app.page.keyboard.press('Tab')
  await expect(app.inspector).toContainText('Circle 2')
  const number = async (name: 'x' | 'y' | 'r') => Number(await app.field(name).inputValue())
  await app.page.keyboard.press('ArrowRight')
  await soon(() => number('x')).toBeGreaterThan(2.1)
  const step = (await number('x')) - 2.1
  await app.page.keyboard.press('Shift+ArrowUp')
  await soon(() => number('y')).toBeCloseTo(3.2 + 10 * step, 4)
  await app.page.keyboard.press('Alt+ArrowLeft')
  await soon(() => number('x')).toBeCloseTo(2.1 + step * (1 - 1 / 10), 4)
  await app.page.keyboard.press('+')
  await soon(() => number('r')).toBeCloseTo(1 + step, 4)
  await app.page.keyboard.press('-')
  await soon(() => number('r')).toBeCloseTo(1, 4)

  await app.page.keyboard.press('Enter')
  await expect(app.field('x')).toBeFocused()
  await app.page.keyboard.press('Escape')
  await expect(app.canvas).toBeFocused()
  await app.page.keyboard.press('Delete')
  await expect(app.status).toContainText('13 circles')
})

test('has no serious accessibility violation', async ({ app }) => {
  await app.select(BRONZE, 600)
  expect(await violationsInBoth(app.page)).toEqual([])
})

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 780 }, deviceScaleFactor: 3, hasTouch: true })

  test('shows everything without scrolling, and a tap selects', async ({ app }) => {
    const overflow = await app.page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
    expect(overflow).toBeLessThanOrEqual(0)
    const at = app.center(BRONZE, 650)
    await app.page.touchscreen.tap(at.x, at.y)
    await expect(app.inspector).toContainText('Circle 650')
    // Measured together, because the caption disappears by itself.
    const ends = await app.page.evaluate(() =>
      [...document.querySelectorAll('.panel')].map((panel) => {
        const { left, right } = panel.getBoundingClientRect()
        return [left, right] as const
      }),
    )
    for (const [left, right] of ends) {
      expect(left).toBeGreaterThanOrEqual(0)
      expect(right).toBeLessThanOrEqual(390)
    }
  })

  test('a pinch zooms, with what is between the fingers in its place', async ({ app }) => {
    const session = await app.page.context().newCDPSession(app.page)
    const { x, y } = app.center(BRONZE, 650)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', spread?: number) => {
      const touchPoints = spread === undefined ? [] : [-1, 1].map((side, id) => ({ x: x + side * spread, y, id }))
      return session.send('Input.dispatchTouchEvent', { type, touchPoints })
    }
    await touch('touchStart', 20)
    for (const spread of [30, 45, 60, 80]) await touch('touchMove', spread)
    await touch('touchEnd')
    // After zooming in four times, a point a few pixels away is still on the circle.
    await app.page.touchscreen.tap(x + 12, y)
    await expect(app.inspector).toContainText('Circle 650')
    const radius = (BRONZE[3 * 650 + 2] as number) * app.camera(BRONZE).scale
    expect(radius).toBeLessThan(12)
  })
})
