// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../web/lib/index.ts'
import { decodeLink } from '../../web/lib/link.ts'
import { loadCircleVoronoi } from '../../web/lib/wasm/loader.ts'
import type { Layers } from '../../web/view/layers.ts'
import { soon } from '../soon.ts'
import { violationsInBoth } from './accessibility.ts'
import { framesOf } from './frames.ts'
import { dataSet, expect, test } from './page.ts'

const INTRODUCTION = dataSet('introduction')
const BRONZE = dataSet('bronzefilter')

test('a drag at a rim resizes, and is taken back at Escape or where something else takes the pointer away', async ({
  app,
}) => {
  await app.choose('Introduction')
  const { scale } = app.camera(INTRODUCTION)
  const { x, y } = app.center(INTRODUCTION, 0)
  await app.drag({ x: x - 1.6 * scale, y }, { x: x - 2 * scale, y })
  await soon(async () => Number(await app.field('r').inputValue())).toBeCloseTo(2, 1)
  await app.page.mouse.up()
  await expect(app.field('x')).toHaveValue('0')

  const from = app.center(INTRODUCTION, 4)
  await app.canvas.evaluate((figure: HTMLElement) => {
    figure.addEventListener('pointerdown', ({ pointerId }) => {
      Object.assign(globalThis, { lose: () => figure.releasePointerCapture(pointerId) })
    })
  })
  for (const end of [
    () => app.page.keyboard.press('Escape'),
    () => app.page.evaluate(() => (globalThis as unknown as { lose(): void }).lose()),
  ]) {
    await app.drag(from, { x: from.x + 30, y: from.y + 20 })
    await expect(app.inspector).toContainText('Circle 4')
    await soon(() => app.field('x').inputValue()).not.toBe(String(INTRODUCTION[12]))
    await end()
    await app.page.mouse.move(from.x + 60, from.y + 60, { steps: 4 })
    await expect(app.field('x')).toHaveValue(String(INTRODUCTION[12]))
    await app.page.mouse.up()
    await app.page.mouse.move(from.x - 60, from.y - 60, { steps: 4 })
    await expect(app.field('x')).toHaveValue(String(INTRODUCTION[12]))
  }
  // These drags changed nothing: the first undo reverts the first drag, the second the choice of circles.
  const undo = app.page.getByRole('button', { name: 'Undo' })
  await undo.click()
  await expect(undo).toBeEnabled()
  await undo.click()
  await expect(app.status).toContainText('678 circles')
})

test('layers are drawn and taken away where they are switched', async ({ app }) => {
  const { page } = app
  await app.choose('Introduction')
  await app.openPanel('Layers')
  const isDrawn = () => app.painted()
  await isDrawn()
  const diagram = (await loadCircleVoronoi()).compute(INTRODUCTION)
  // The midpoints between neighboring centers, except where other layers cover them.
  const middles = Array.from({ length: diagram.edges.length / 4 }, (_, e) => {
    const [i, j] = [diagram.edges[4 * e] as number, diagram.edges[4 * e + 1] as number]
    const [one, other] = [app.center(INTRODUCTION, i), app.center(INTRODUCTION, j)]
    return { x: (one.x + other.x) / 2, y: (one.y + other.y) / 2 }
  }).filter((point) => app.isShown(point) && point.x > 420)
  const before = await app.colors(middles)
  await page.getByRole('checkbox', { name: 'Dual graph' }).check()
  await isDrawn()
  const greenish = async () =>
    (await app.colors(middles)).filter(([red, green]) => (green as number) - (red as number) > 40).length
  await soon(greenish).toBeGreaterThan(0.8 * middles.length)
  await page.getByRole('checkbox', { name: 'Dual graph' }).uncheck()
  await soon(() => app.colors(middles)).toEqual(before)

  const layer = (name: string) => page.getByRole('checkbox', { name, exact: true })
  for (const name of ['Circles', 'Edges', 'Vertices']) await layer(name).uncheck()
  const cells = page.getByLabel('Colors', { exact: true })
  await cells.selectOption('none')
  const row = Array.from({ length: 900 }, (_, k) => ({ x: 320 + k, y: 300 }))
  const isBlank = async () => new Set((await app.colors(row)).map(String)).size === 1
  await soon(isBlank).toBe(true)
  for (const name of [
    'Power diagram',
    'Delaunay of centers',
    'Delaunay of samples',
    'Antipodal discs',
    'Directed edges left',
  ]) {
    await layer(name).check()
    await soon(isBlank).toBe(false)
    await layer(name).uncheck()
    await soon(isBlank).toBe(true)
  }
  await cells.selectOption('neighbors differ')
  await soon(isBlank).toBe(false)
})

test('the clearest path follows its ends and the circles', async ({ app }) => {
  const { page } = app
  await app.choose('Introduction')
  await app.openPanel('Layers')
  await page.getByRole('checkbox', { name: 'Clearest path' }).check()
  const row = page.locator('.layer', { hasText: 'Clearest path' }).locator('small')
  await expect(row).toHaveText(/^[\d.]+$/)
  const clearance = await row.textContent()
  const pathOf = async () => (await decodeLink(new URL(page.url()).hash)).layers?.path
  await soon(pathOf).toBeDefined()
  const end = app.locate(INTRODUCTION, ((await pathOf()) as unknown as { to: Point }).to)
  // A point that is certainly inside a disc.
  const inside = app.center(INTRODUCTION, 0)
  await app.drag(end, inside)
  await page.mouse.up()
  await expect(row).toHaveText(/^-[\d.]+$/)
  await expect(app.inspector).toBeHidden()
  await page.keyboard.press('Escape')
  await app.drag(inside, end)
  await page.mouse.up()
  await expect(row).toHaveText(clearance as string)
  await page.getByRole('checkbox', { name: 'Clearest path' }).uncheck()
  await expect(row).toHaveCount(0)
})

type Path = NonNullable<Layers['path']>

test('the ends of the clearest path are not behind a panel that opens later', async ({ introduction: app }) => {
  const { page } = app
  // In a low window, there is room beside all circles.
  await page.setViewportSize({ width: 1280, height: 600 })
  await framesOf(page, 2)
  await app.openPanel('Layers')
  await page.getByRole('checkbox', { name: 'Clearest path' }).check()
  const pathOf = async () => (await decodeLink(new URL(page.url()).hash)).layers?.path as unknown as Path | undefined
  await soon(pathOf).toBeDefined()
  const endsSeen = async () => {
    const { from, to } = (await pathOf()) as Path
    const places = [from, to].map((end) => app.locate(INTRODUCTION, end))
    return page.evaluate(
      (places) => places.map(({ x, y }) => document.elementFromPoint(x, y)?.closest('#figure') !== null),
      places,
    )
  }
  expect(await endsSeen()).toEqual([true, true])
  // The wider table covers the place beside the panel.
  const before = (await pathOf()) as Path
  await app.drag(app.locate(INTRODUCTION, before.from), { x: app.padding.left + 4, y: 300 })
  await page.mouse.up()
  await soon(pathOf).not.toEqual(before)
  await app.openPanel('Table')
  await soon(endsSeen).toEqual([true, true])
})

test('an end of the clearest path is not behind the card for sharing', async ({ introduction: app }) => {
  const { page } = app
  await app.openPanel('Layers')
  await page.getByRole('checkbox', { name: 'Clearest path' }).check()
  const pathOf = async () => (await decodeLink(new URL(page.url()).hash)).layers?.path as unknown as Path | undefined
  await soon(pathOf).toBeDefined()
  const before = (await pathOf()) as Path
  await app.drag(app.locate(INTRODUCTION, before.to), { x: 1200, y: 400 })
  await page.mouse.up()
  await soon(pathOf).not.toEqual(before)
  await page.getByRole('button', { name: 'Share', exact: true }).click()
  await expect(page.getByRole('button', { name: 'Copy link' })).toBeVisible()
  const card = (await page.locator('#share').boundingBox()) as { x: number }
  await soon(async () => app.locate(INTRODUCTION, ((await pathOf()) as Path).to).x).toBeLessThan(card.x)
})

test('numbers are those of the circles, and say by which way a diagram is right', async ({ app }) => {
  const { page } = app
  const panel = page.getByRole('region', { name: 'Numbers' })
  await app.openPanel('Numbers')
  await expect(panel).toContainText('5.95 on average')
  await expect(panel).toContainText('Proven by a judge')
  await expect(panel.locator('canvas')).toHaveCount(2)
  await panel.getByRole('button', { name: 'Compute' }).click()
  await expect(panel).toContainText('This one is certified')
  await app.choose('Introduction')
  await expect(panel).toContainText('4.46 on average')
  await expect(panel).not.toContainText('This one')
})

test('charts of the numbers before an edit are gone, with what they listened to', async ({ app }) => {
  const { page } = app
  await page.evaluate(() => {
    const listeners = new Set<unknown>()
    const { addEventListener, removeEventListener } = window
    Object.assign(window, {
      listeners,
      addEventListener(...parts: Parameters<typeof addEventListener>) {
        listeners.add(parts[1])
        addEventListener.apply(window, parts)
      },
      removeEventListener(...parts: Parameters<typeof removeEventListener>) {
        listeners.delete(parts[1])
        removeEventListener.apply(window, parts)
      },
    })
  })
  const listeners = () => page.evaluate(() => (window as unknown as { listeners: Set<unknown> }).listeners.size)
  const panel = page.getByRole('region', { name: 'Numbers' })
  await app.openPanel('Numbers')
  await expect(panel.locator('canvas')).toHaveCount(2)
  const before = await listeners()
  await app.choose('Introduction')
  await expect(panel).toContainText('4.46 on average')
  await expect(panel.locator('canvas')).toHaveCount(2)
  await soon(listeners).toBe(before)
  // A closed panel computes no values.
  await app.openPanel('Numbers')
  await soon(listeners).toBeLessThan(before)
})

test('panels that fold remember it, and layers stay in the address', async ({ app }) => {
  const { page } = app
  const layers = page.getByRole('button', { name: 'Layers', exact: true })
  await expect(layers).toHaveAttribute('aria-expanded', 'false')
  await layers.click()
  await page.getByLabel('Colors', { exact: true }).selectOption('by area of the cell')
  const linked = async () => (await decodeLink(new URL(page.url()).hash).catch(() => undefined))?.layers
  await soon(linked).toMatchObject({ cells: 'area' })
  await page.getByRole('checkbox', { name: 'Convex hull' }).check()
  await soon(linked).toMatchObject({ cells: 'area', hull: true })
  await page.reload()
  await expect(layers).toHaveAttribute('aria-expanded', 'true')
  await expect(page.getByRole('checkbox', { name: 'Convex hull' })).toBeChecked()
  await expect(page.getByLabel('Colors', { exact: true })).toHaveValue('area')
  await expect(page.getByRole('checkbox', { name: 'Dual graph' })).toBeVisible()
  await layers.click()
  await page.reload()
  await expect(layers).toHaveAttribute('aria-expanded', 'false')
})

test('the panels have no accessibility violation', async ({ app }) => {
  await app.openPanel('Layers')
  for (const name of ['merged up', 'Cells end', 'Clearest path', 'Largest empty']) {
    await app.page.getByRole('checkbox', { name }).check()
  }
  await app.openPanel('Numbers')
  await expect(app.page.getByText('Proven by')).toBeAttached()
  expect(await violationsInBoth(app.page)).toEqual([])
})

test('says where the pointer is and how long a length is, also after a zoom', async ({ app }) => {
  await app.choose('Introduction')
  const { x, y } = app.center(INTRODUCTION, 4)
  await app.page.mouse.move(x, y)
  const place = app.page.locator('#scale .pointer')
  const numbers = async () => ((await place.textContent()) ?? '').split(', ').map(Number)
  await soon(async () => (await numbers())[0]).toBeCloseTo(INTRODUCTION[12] as number, 1)
  await soon(async () => (await numbers())[1]).toBeCloseTo(INTRODUCTION[13] as number, 1)
  const bar = app.page.locator('#scale .length')
  const before = Number(await bar.textContent())
  await app.page.mouse.wheel(0, -1500)
  await soon(async () => Number(await bar.textContent())).toBeLessThan(before)
  await app.page.mouse.move(5, 5)
  await soon(async () => (await numbers())[0]).not.toBeCloseTo(INTRODUCTION[12] as number, 1)
  await app.page.getByRole('button', { name: 'Layers', exact: true }).hover()
  await expect(place).toHaveText('')
})

for (const colorScheme of ['light', 'dark'] as const) {
  test(`is printed as it is seen, dark on light, without panels: ${colorScheme}`, async ({ app }) => {
    await app.page.emulateMedia({ colorScheme })
    await app.painted()
    await app.page.emulateMedia({ colorScheme, media: 'print' })
    for (const panel of await app.page.locator('.panel, #corner').all()) await expect(panel).toBeHidden()
    const shot = (await app.page.screenshot()).toString('base64')
    const { mean, darkest } = await app.page.evaluate(async (text) => {
      const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
      const context = new OffscreenCanvas(image.width, image.height).getContext(
        '2d',
      ) as OffscreenCanvasRenderingContext2D
      context.drawImage(image, 0, 0)
      const { data } = context.getImageData(0, 0, image.width, image.height)
      const greens = Array.from({ length: data.length / 4 }, (_, k) => data[4 * k + 1] as number)
      const mean = greens.reduce((sum, green) => sum + green, 0) / greens.length
      return { mean, darkest: greens.reduce((least, green) => Math.min(least, green)) }
    }, shot)
    // Discs are solid, with a medium brightness; a dark background would give a mean below 100.
    expect(mean).toBeGreaterThan(150)
    expect(darkest).toBeLessThan(110)
    // A page without a picture has less than 2,000 bytes.
    expect((await app.page.pdf()).length).toBeGreaterThan(20_000)
  })
}

test('what is selected is not printed', async ({ app }) => {
  const { page } = app
  await app.select(BRONZE, 600)
  await soon(app.drawnAbove).toBeGreaterThan(100)
  await page.emulateMedia({ media: 'print' })
  await soon(app.drawnAbove).toBe(0)
  await page.emulateMedia({ media: 'screen' })
  await soon(app.drawnAbove).toBeGreaterThan(100)
})

test('colors by a measure have a legend with numbers on the canvas', async ({ app }) => {
  const { page } = app
  const legend = page.locator('#legend')
  await expect(legend).toBeHidden()
  await app.openPanel('Layers')
  await page.getByLabel('Colors', { exact: true }).selectOption('by radius')
  await expect(legend).toContainText('Radius of the circle')
  const radii = Array.from({ length: 678 }, (_, i) => BRONZE[3 * i + 2] as number).sort((a, b) => a - b)
  const knots = [0.05, 0.25, 0.5, 0.75, 0.95].map((share) => radii[Math.round(share * 677)] as number)
  const texts = await legend.locator('.knots > span').allTextContents()
  expect(texts.map((text) => Number(text.replace(/[≤≥] /, '')))).toEqual(knots.map((r) => Number(r.toPrecision(2))))
  expect([texts[0]?.[0], texts[4]?.[0]]).toEqual(['≤', '≥'])
  // The largest circles have the last color of the ramp.
  const largest = Array.from({ length: 678 }, (_, i) => i).sort(
    (i, j) => (BRONZE[3 * j + 2] as number) - (BRONZE[3 * i + 2] as number),
  )
  await app.painted()
  const [color] = await app.colors([app.center(BRONZE, largest[0] as number)])
  const end = await legend.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
    const context = canvas.getContext('2d') as CanvasRenderingContext2D
    return [...context.getImageData(canvas.width - 1, 0, 1, 1).data.slice(0, 3)]
  })
  expect(color).toEqual(end)
  // Many circles are colored by radius by default.
  await page.getByLabel('Colors', { exact: true }).selectOption('automatic')
  await expect(legend).toBeHidden()
  await app.choose('Random, 10,000')
  await expect(legend).toContainText('Radius of the circle')
})

test('an overlay with nothing on it is not drawn again while the picture is zoomed', async ({ app }) => {
  const { page } = app
  // Chromium may report the pointer at the corner of the figure, whose cell is then hovered.
  await page.locator('#top').hover({ position: { x: 2, y: 2 } })
  await app.painted()
  await page.evaluate(() => {
    const { clearRect } = CanvasRenderingContext2D.prototype
    const overlay = document.querySelector('#figure canvas:nth-of-type(2)')
    Object.assign(globalThis, { drawn: 0 })
    CanvasRenderingContext2D.prototype.clearRect = function (...box) {
      if (this.canvas === overlay) (globalThis as unknown as { drawn: number }).drawn += 1
      clearRect.apply(this, box)
    }
  })
  const drawn = () => page.evaluate(() => (globalThis as unknown as { drawn: number }).drawn)
  const before = await page.locator('#scale').textContent()
  await app.canvas.focus()
  for (let k = 0; k < 3; k++) await page.keyboard.press('+')
  await expect(page.locator('#scale')).not.toHaveText(before as string)
  await app.painted()
  expect(await drawn()).toBe(0)
  await page.keyboard.press('Enter')
  await soon(drawn).toBeGreaterThan(0)
})

test('the numbers of no circles are drawn without an error', async ({ app }) => {
  await app.choose('Introduction')
  await app.openPanel('Numbers')
  const charts = app.page.locator('#numbers canvas')
  await expect(charts).toHaveCount(2)
  await app.canvas.focus()
  await app.page.keyboard.press('Control+a')
  await app.page.keyboard.press('Delete')
  await expect(app.status).toContainText('0 circles')
  await app.painted()
  await expect(app.page.locator('#numbers')).toContainText('No cell is bounded')
  await expect(charts).toHaveCount(0)
})
