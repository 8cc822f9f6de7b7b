// SPDX-License-Identifier: GPL-3.0-or-later
// Actions by keys and fingers, and their announcements.
import { readFileSync } from 'node:fs'
import { decodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { App, dataSet, expect, test } from './page.ts'

const BRONZE = dataSet('bronzefilter')
const INTRODUCTION = dataSet('introduction')

/** The pixels of a canvas of the figure: of the picture (0) or of the overlay (1). */
const pixelsOf = (app: App, layer: 0 | 1) =>
  app.canvas
    .locator('canvas')
    .nth(layer)
    .evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL())

test('the focus on the drawing is seen', async ({ app }) => {
  const { page } = app
  const corner = { x: 0, y: 0, width: 12, height: 12 }
  await app.painted()
  const before = await page.screenshot({ clip: corner })
  await page.keyboard.press('Tab')
  await expect(app.canvas).toBeFocused()
  const frame = await page.screenshot({ clip: corner })
  expect(frame.equals(before)).toBe(false)
  await page.keyboard.press('Tab')
  await expect(app.canvas).not.toBeFocused()
  expect((await page.screenshot({ clip: corner })).equals(before)).toBe(true)
})

test('N adds a circle near the middle of the picture, where there is room, and what is duplicated is said, each time', async ({
  introduction: app,
}) => {
  const { page } = app
  await app.canvas.focus()
  const camera = app.camera(INTRODUCTION)
  await page.keyboard.press('n')
  await expect(app.status).toContainText('15 circles')
  // There is a circle in the middle; beside it is room.
  await soon(async () => Math.abs(Number(await app.field('x').inputValue()) - camera.x)).toBeLessThan(3)
  await expect(app.inspector).toContainText('ounded cell')
  const said = page.locator('#said')
  await expect(said).toHaveText(/^Circle 14 added\. /)
  await page.evaluate(() => {
    const texts: string[] = []
    const element = document.querySelector('#said') as HTMLElement
    Object.assign(window, { texts })
    new MutationObserver(() => texts.push(element.textContent ?? '')).observe(element, { childList: true })
  })
  const texts = () => page.evaluate(() => (window as unknown as { texts: string[] }).texts)
  for (const count of [1, 2]) {
    await page.keyboard.press('Control+d')
    await soon(texts).toEqual(Array(count).fill(expect.stringMatching(/^Circle duplicated\. /)))
  }
})

test('the tool for adding stays until Escape', async ({ introduction: app }) => {
  const { page } = app
  const add = page.getByRole('button', { name: 'Add a circle' })
  await add.click()
  for (const [k, place] of [
    { x: 4.4, y: -3.3 },
    { x: -3.6, y: 4.2 },
  ].entries()) {
    const { x, y } = app.locate(INTRODUCTION, place)
    await app.drag({ x, y }, { x: x + 20, y })
    await page.mouse.up()
    await expect(app.status).toContainText(`${15 + k} circles`)
    await expect(add).toHaveAttribute('aria-pressed', 'true')
  }
  await page.keyboard.press('Escape')
  await expect(add).toHaveAttribute('aria-pressed', 'false')
})

test('a tiny circle is zoomed to by a key and by a button', async ({ introduction: app }) => {
  const { page } = app
  await app.select(INTRODUCTION, 4)
  await app.field('r').fill('1e-6')
  await app.field('r').press('Enter')
  await expect(app.field('r')).toHaveValue('1e-6')
  await app.field('r').press('Escape')
  const linked = () => decodeLink(new URL(page.url()).hash)
  await soon(async () => (await linked()).edits?.length).toBe(1)
  await page.keyboard.press('f')
  const span = async () => (await linked()).view?.span ?? Number.POSITIVE_INFINITY
  await soon(span).toBeLessThan(1e-5)
  await page.keyboard.press('0')
  await soon(span).toBe(Number.POSITIVE_INFINITY)
  await app.inspector.getByRole('button', { name: 'Zoom to' }).click()
  await soon(span).toBeLessThan(1e-5)
})

test('the card says what a cell measures, and what the number of a circle is', async ({ introduction: app }) => {
  const { page } = app
  await app.select(INTRODUCTION, 0)
  const facts = app.inspector.locator('#inspector-facts')
  await expect(facts).toContainText('Area of the cell')
  const [area, perimeter] = (await facts.locator('dd').allTextContents()).map(Number) as [number, number]
  expect(area).toBeGreaterThan(Math.PI * 1.6 ** 2)
  // The isoperimetric inequality.
  expect(perimeter ** 2).toBeGreaterThan(4 * Math.PI * area)
  // Numbers of removed circles are not reused.
  await page.keyboard.press('Delete')
  await expect(app.status).toContainText('13 circles')
  await page.keyboard.press('n')
  await expect(app.inspector).toContainText('Circle 14')
  await expect(app.inspector).toContainText('14 of 14; numbers are not used again')
})

test('the disc at the pointer is shown wherever it is, and what belongs to places of other circles goes with them', async ({
  introduction: app,
}) => {
  const { page } = app
  await app.openPanel('Layers')
  await page.getByLabel('Disc at the pointer').check()
  // A point inside a cell and outside its circle.
  const at = app.locate(INTRODUCTION, { x: 0.2, y: 2.2 })
  await page.mouse.move(at.x, at.y)
  await soon(app.drawnAbove).toBeGreaterThan(1000)
  await page.getByLabel('Disc at the pointer').uncheck()
  await page.getByLabel('Clearest path').check()
  await app.choose('Cities of Europe')
  // The ends of the path are in view for these circles, too.
  const path = async () => (await decodeLink(new URL(page.url()).hash).catch(() => undefined))?.layers?.path
  const { x, y, scale } = app.camera(dataSet('cities'))
  type Path = Record<'from' | 'to', { x: number; y: number }>
  const length = async () => {
    const { from, to } = ((await path()) ?? { from: { x: 0 }, to: { x: 0 } }) as unknown as Path
    return (to.x - from.x) * scale
  }
  await soon(length).toBeGreaterThan(400)
  const { from, to } = (await path()) as unknown as Path
  for (const end of [from, to]) {
    expect(Math.abs(end.x - x) * scale).toBeLessThan(640)
    expect(Math.abs(end.y - y) * scale).toBeLessThan(400)
  }
})

test('fields take no value that is not used', async ({ app }) => {
  const { page } = app
  await app.openPanel('Gallery')
  await page.getByText('Hard inputs', { exact: true }).click()
  const count = page.getByRole('region', { name: 'Gallery' }).getByLabel('Number of circles')
  await count.fill('0')
  await count.press('Tab')
  await expect(count).toHaveValue('300')
  await app.openPanel('Files')
  await page.getByLabel('× its size').fill('-2')
  await page.getByLabel('× its size').press('Tab')
  await expect(page.getByLabel('× its size')).toHaveValue('2')
  await app.select(BRONZE, 600)
  const before = await app.field('r').inputValue()
  await app.field('r').fill('-1')
  await app.field('r').press('Enter')
  await expect(page.getByRole('alert')).toBeVisible()
  await app.field('r').press('Escape')
  await expect(app.field('r')).toHaveValue(before)
  await expect(page.getByRole('alert')).toBeHidden()
})

test('without circles a hint says what to do, and the menu that there are none', async ({ app }) => {
  const { page } = app
  await app.canvas.focus()
  await page.keyboard.press('Control+a')
  await page.keyboard.press('Delete')
  await expect(app.status).toHaveText(/^0 circles/)
  await expect(page.getByText('Double-click to add one, or choose a data set above.')).toBeVisible()
  await expect(page.getByLabel('Data set').locator('option:checked')).toHaveText('No circles')
  await page.mouse.dblclick(640, 400)
  await expect(app.status).toHaveText(/^1 circle /)
  await expect(page.getByText('Double-click to add one')).toBeHidden()
})

test('circles move while it plays, and undo brings all of them back at once', async ({ introduction: app }) => {
  const { page } = app
  await app.openPanel('Motion')
  const panel = page.getByRole('region', { name: 'Motion' })
  for (const name of ['Bounce', 'Grow from points', 'Breathe']) {
    await panel.getByLabel(name).check()
    // Compares the figure without the panel, whose labels change at once.
    const before = await pixelsOf(app, 0)
    await panel.getByRole('button', { name: 'Play' }).click()
    await soon(() => pixelsOf(app, 0)).not.toBe(before)
    await panel.getByRole('button', { name: 'Stop' }).click()
    await expect(panel.getByRole('button', { name: 'Play' })).toBeVisible()
    // Waits until the final positions are saved before undoing anything.
    await soon(() => app.circles()).not.toEqual(INTRODUCTION)
    await page.getByRole('button', { name: 'Undo' }).click()
    await soon(() => app.circles()).toEqual(INTRODUCTION)
  }
})

test('motion is recorded as a video', async ({ introduction: app }) => {
  const { page } = app
  await app.openPanel('Motion')
  const download = page.waitForEvent('download')
  // Observes before the click returns, which may take longer than the recording.
  await Promise.all([
    expect(page.getByRole('button', { name: 'Recording …' })).toBeDisabled(),
    page.getByRole('button', { name: 'Record 6 s' }).click(),
  ])
  const file = await download
  expect(file.suggestedFilename()).toMatch(/^circles-bounce\.(mp4|webm)$/)
  const bytes = readFileSync(await file.path())
  expect(bytes.length).toBeGreaterThan(20_000)
  // The first bytes of MP4 or Matroska.
  expect([bytes.toString('latin1', 4, 8), bytes.toString('hex', 0, 4)]).toEqual(
    file.suggestedFilename().endsWith('mp4') ? ['ftyp', expect.anything()] : [expect.anything(), '1a45dfa3'],
  )
})

test.describe('with fingers', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true })

  test('hints say tap, a large circle is dragged at once, and a finger that rests shows the disc', async ({ page }) => {
    const app = new App(page)
    await app.open('')
    await expect(page.locator('#say')).toContainText('Double-tap to add a circle.')
    const session = await page.context().newCDPSession(page)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...points: { x: number; y: number }[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: points })
    const start = dataSet('start')
    const at = app.center(start, 0)
    await touch('touchStart', at)
    for (const dx of [8, 16, 24]) await touch('touchMove', { x: at.x + dx, y: at.y })
    await touch('touchEnd')
    await expect(app.inspector).toContainText('Circle 0')
    await soon(async () => Number(await app.field('x').inputValue())).toBeGreaterThan(0.3)
    // Browsers treat a tap right after a quick drag as the end of a fling, which causes no click.
    await app.inspector.getByRole('button', { name: 'Deselect' }).click()
    await expect(app.inspector).toBeHidden()

    await app.openPanel('Layers')
    await page.getByLabel('Disc at the pointer').check()
    await page.getByRole('region', { name: 'Layers' }).getByRole('button', { name: 'Close' }).tap()
    await expect(app.inspector).toBeHidden()
    await soon(app.drawnAbove).toBe(0)
    const free = { x: 30, y: 300 }
    await page.clock.install()
    await touch('touchStart', free)
    await page.clock.fastForward(700)
    await soon(app.drawnAbove).toBeGreaterThan(100)
    // The disc follows the finger, and no circle is added.
    const first = await pixelsOf(app, 1)
    await touch('touchMove', { x: 60, y: 340 })
    await soon(() => pixelsOf(app, 1)).not.toBe(first)
    await touch('touchEnd')
    await expect(app.status).toHaveText(/^8 circles/)
  })
})

test('a slider scales all radii between the diagram of the centers and that of the circles, as one step of undo', async ({
  app,
}) => {
  const { page } = app
  await app.openPanel('Layers')
  const radii = page.locator('#layers').getByLabel('Radii')
  await expect(radii).toHaveValue('1')
  const before = await app.circles()
  for (const share of ['0.5', '0.25', '0']) await radii.fill(share)
  const scaled = (share: number) => before.map((value, k) => (k % 3 === 2 ? share * value : value))
  await soon(() => app.circles()).toEqual(scaled(0))
  await radii.fill('0.75')
  await soon(() => app.circles()).toEqual(scaled(0.75))
  await app.canvas.focus()
  await page.keyboard.press('Control+z')
  await soon(() => app.circles()).toEqual(before)
  await expect(radii).toHaveValue('1')
  // With reduced motion there is only the slider.
  await expect(page.locator('#layers').getByRole('button', { name: 'Play' })).toHaveCount(0)
})

test.describe('where motion is welcome', () => {
  test.use({ contextOptions: { reducedMotion: 'no-preference' } })

  test('the three diagrams part as the radii grow, in the panel of layers or of motion', async ({
    introduction: app,
  }) => {
    const { page } = app
    await app.openPanel('Layers')
    const layers = page.locator('#layers')
    await layers.getByRole('button', { name: 'Play' }).click()
    for (const name of ['Voronoi of centers', 'Power diagram', 'Edges'])
      await expect(layers.getByLabel(name, { exact: true })).toBeChecked()
    await expect(layers.getByRole('button', { name: 'Stop' })).toBeVisible()
    await app.openPanel('Motion')
    const motion = page.locator('#motion')
    await motion.getByRole('button', { name: 'Stop' }).click()
    await soon(async () => (await app.circles())[2]).toBeLessThan(dataSet('introduction')[2] as number)
    await app.canvas.focus()
    await page.keyboard.press('Control+z')
    await soon(() => app.circles()).toEqual(dataSet('introduction'))
    await motion.getByLabel('Compare three diagrams').check()
    await expect(motion).toContainText('they part as the radii grow')
  })
})
