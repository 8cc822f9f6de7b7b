// SPDX-License-Identifier: GPL-3.0-or-later
// Regions and prescribed areas in the page: opened, dropped, drawn, edited, kept, saved.
import { readFileSync } from 'node:fs'
import type { Locator, Worker } from '@playwright/test'
import type { Point } from '../../web/lib/index.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { loadCircleVoronoi } from '../../web/lib/wasm/loader.ts'
import { type Camera, fitted, toPlane, toScreen } from '../../web/view/camera.ts'
import { soon } from '../soon.ts'
import { box } from '../web/shapes.ts'
import { violationsInBoth } from './accessibility.ts'
import { framesOf } from './frames.ts'
import { App, expect, test } from './page.ts'
import { THREAD, threadOf } from './thread-session.ts'

const THREE = Float64Array.of(0, 0, 1, 6, 0, 1, 2, 5, 1)
const SQUARE = box(-3, -3, 9, 8)
const HOLE = box(3, 2, 4, 3)
const PAPER = '250,248,244'

const geojson = (...rings: number[][][]) => JSON.stringify({ type: 'Polygon', coordinates: rings })
const { region, fitAreas } = await loadRegions()
const TOTAL = region([SQUARE, HOLE]).area

test.use({ link: await encodeLink({ circles: THREE }) })

/** The panel Region. */
const panel = (app: App): Locator => app.page.getByRole('region', { name: 'Region', exact: true })

const linkOf = async (app: App) => decodeLink(new URL(app.page.url()).hash).catch(() => ({}) as never)

/** The camera that shows the square beside the open panel. */
function cameraOf(app: App): Camera {
  const size = app.page.viewportSize() as { width: number; height: number }
  return fitted({ minX: -3, minY: -3, maxX: 9, maxY: 8 }, size, app.padding)
}

function place(app: App, [x, y]: readonly number[]): Point {
  const size = app.page.viewportSize() as { width: number; height: number }
  return toScreen(cameraOf(app), size, { x: x as number, y: y as number })
}

/** The color of the painted picture at a point of the plane. */
async function colorAt(app: App, point: readonly number[]): Promise<string> {
  await app.painted()
  const [color] = await app.colors([place(app, point)])
  return String(color)
}

async function saved(app: App, label: string): Promise<string> {
  const download = app.page.waitForEvent('download')
  await app.page.locator('#files').getByRole('button', { name: label, exact: true }).click()
  return readFileSync(await (await download).path(), 'utf8')
}

test('a file of polygons is the region: by pixels, areas, link, SVG, cells, undo', async ({ app }) => {
  await app.openPanel('Region')
  const input = panel(app).getByLabel('Open …')
  await input.setInputFiles({ name: 'hall.geojson', mimeType: '', buffer: Buffer.from(geojson(SQUARE, HOLE)) })
  await expect(panel(app)).toContainText('2 outlines with 8 sides')
  await expect(app.page.locator('#toast')).toContainText('Cells are clipped to hall.geojson.')
  expect(await colorAt(app, [-1.5, 6])).not.toBe(PAPER)
  expect(await colorAt(app, [3.5, 2.5])).toBe(PAPER)
  expect(await colorAt(app, [-3.5, 0])).toBe(PAPER)

  // Areas are measured inside the region.
  const { x, y } = place(app, [0, 0])
  await app.page.mouse.click(x, y)
  await expect(app.inspector).toContainText('Area inside the region')
  const ring = [SQUARE, HOLE]
  const diagram = (await loadCircleVoronoi()).compute(THREE)
  const areas = diagram.cellAreas({ region: region(ring) })
  await expect(app.inspector).toContainText(String(Number((areas[0] as number).toPrecision(4))))

  // The link contains the region and restores it, and so does the SVG.
  await soon(async () => (await linkOf(app)).region).toMatchObject({ type: 'MultiPolygon' })
  await app.page.reload()
  await expect(app.status).toContainText('3 circles')
  await expect(panel(app)).toContainText('2 outlines with 8 sides')
  await app.openPanel('Files')
  const svg = await saved(app, 'SVG')
  expect(svg).toMatch(/<g clip-path="url\(#region-/)
  const cells = JSON.parse(await saved(app, 'Cells'))
  expect(cells.features.map(({ properties }: { properties: { area: number } }) => properties.area)).toEqual([...areas])
  expect(cells.features[0].geometry.type).toMatch(/Polygon$/)
  await app.drop('none.csv', '0,0,1\n9,9,1\n')
  await expect(app.status).toContainText('2 circles')
  await app.drop('kept.svg', svg)
  await expect(app.status).toContainText('3 circles')
  await app.openPanel('Region')
  await expect(panel(app)).toContainText('2 outlines with 8 sides')

  await panel(app).getByRole('button', { name: 'Remove region' }).click()
  await expect(panel(app)).not.toContainText('outlines')
  expect(await colorAt(app, [3.5, 2.5])).not.toBe(PAPER)
  await app.page.keyboard.press('Control+z')
  await expect(panel(app)).toContainText('2 outlines with 8 sides')
  await app.page.keyboard.press('Control+Shift+z')
  await expect(panel(app)).not.toContainText('outlines')
})

test('polygons are dropped and pasted; points are circles; what crosses itself is refused, and the last one stays', async ({
  app,
}) => {
  await app.openPanel('Region')
  await app.drop('square.wkt', 'POLYGON ((-3 -3, 9 -3, 9 8, -3 8))')
  await expect(panel(app)).toContainText('One outline with 4 sides')
  await app.drop('closed.wkt', 'POLYGON ((-3 -3, 9 -3, 9 8, -3 -3))')
  await expect(panel(app)).toContainText('One outline with 3 sides')
  await app.drop('square.wkt', 'POLYGON ((-3 -3, 9 -3, 9 8, -3 8))')
  await expect(panel(app)).toContainText('One outline with 4 sides')
  const points = { type: 'Feature', properties: { r: 1 }, geometry: { type: 'Point', coordinates: [1, 2] } }
  await app.drop('bow.geojson', geojson([HOLE[0], HOLE[2], HOLE[1], HOLE[3]] as number[][]))
  await expect(app.page.getByRole('alert')).toContainText(
    'Side 0 of ring 0 of the region and side 2 of ring 0 of the region cross at (3.5, 2.5).',
  )
  await expect(panel(app)).toContainText('One outline with 4 sides')
  await app.page.evaluate(
    (text) => {
      const clipboardData = new DataTransfer()
      clipboardData.setData('text/plain', text)
      document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }))
    },
    geojson(SQUARE, HOLE),
  )
  await expect(panel(app)).toContainText('2 outlines with 8 sides')
  await expect(app.page.getByRole('alert')).toBeHidden()
  await app.drop('points.geojson', JSON.stringify({ type: 'FeatureCollection', features: [points] }))
  await expect(app.status).toContainText('1 circle')
  await expect(panel(app)).not.toContainText('outlines')
})

test('a region is drawn: by clicks with a hole, by keys, canceled and taken back corner by corner', async ({ app }) => {
  const { page } = app
  await app.openPanel('Region')
  const click = async (x: number, y: number) => {
    await page.mouse.move(x, y)
    await page.mouse.click(x, y)
  }
  await panel(app).getByRole('button', { name: 'Draw' }).click()
  await expect(app.canvas).toBeFocused()
  for (const [x, y] of [
    [500, 150],
    [1150, 150],
    [1150, 700],
    [500, 700],
  ] as const) {
    await click(x, y)
  }
  // Removes the corner and places it again.
  await page.keyboard.press('Control+z')
  await click(520, 690)
  // A click on the first corner closes the polygon.
  await click(502, 151)
  await expect(panel(app)).toContainText('One outline with 4 sides')
  await expect(page.getByRole('button', { name: 'Select and move' })).toHaveAttribute('aria-pressed', 'true')

  // A ring inside becomes a hole, closed by a double click. A crossing ring is refused and stays for correction.
  await page.keyboard.press('p')
  await click(700, 300)
  await click(900, 300)
  await page.mouse.dblclick(1300 - 30, 500)
  await expect(page.getByRole('alert')).toContainText('cross')
  await expect(panel(app).getByRole('button', { name: 'Close polygon' })).toBeVisible()
  await panel(app).getByRole('button', { name: 'Undo corner' }).click()
  await page.mouse.dblclick(800, 500)
  await expect(panel(app)).toContainText('2 outlines with 7 sides')
  await soon(async () => (await linkOf(app)).region).toHaveLength(2)
  await app.canvas.focus()
  await page.keyboard.press('Control+z')
  await expect(panel(app)).toContainText('One outline with 4 sides')

  // Escape discards the polygon.
  await page.keyboard.press('p')
  await click(700, 300)
  await page.keyboard.press('Escape')
  await expect(panel(app).getByRole('button', { name: 'Draw more' })).toBeVisible()
  await panel(app).getByRole('button', { name: 'Remove region' }).click()

  // Draws by keys alone: arrow keys move the next corner.
  await panel(app).getByRole('button', { name: 'Draw' }).focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press(' ')
  for (const arrow of ['ArrowRight', 'ArrowUp', 'ArrowLeft']) {
    for (let k = 0; k < 3; k++) await page.keyboard.press(`Shift+${arrow}`)
    await page.keyboard.press(' ')
  }
  await expect(page.locator('#said')).toHaveText('4 corners')
  await page.keyboard.press('Enter')
  await expect(panel(app)).toContainText('One outline with 4 sides')
})

test('areas: equal, by radius, one by one, kept while a point is dragged, by link and by undo', async ({ app }) => {
  const { page } = app
  await app.openPanel('Region')
  await expect(panel(app).getByLabel('Areas')).toBeDisabled()
  await app.drop('hall.geojson', geojson(SQUARE, HOLE))
  const choose = panel(app).getByLabel('Areas')
  await expect(choose).toBeEnabled()
  await choose.selectOption('equal')
  await expect(app.status).toContainText(/areas within \de-\d+/)
  const areaOf = async (at: readonly number[]) => {
    const { x, y } = place(app, at)
    await page.mouse.click(x, y)
    await expect(app.inspector).toContainText('Area inside the region')
    return app.inspector.locator('dd').first()
  }
  const digits = (value: number) => String(Number(value.toPrecision(4)))
  await expect(await areaOf([0, 0])).toHaveText(digits(TOTAL / 3))
  await expect(app.inspector.getByLabel('% of the region')).toHaveValue('33.33')

  // While a point is dragged, the cells keep their areas. The drag is one undo step.
  await soon(async () => (await linkOf(app)).areas).toBe('equal')
  const before = await app.circles()
  await app.drag(place(app, [0, 0]), place(app, [1, -1]))
  await page.mouse.up()
  await soon(async () => (await app.circles())[0]).toBeCloseTo(1, 1)
  await expect(app.inspector.locator('dd').first()).toHaveText(digits(TOTAL / 3))
  await app.canvas.focus()
  await page.keyboard.press('Control+z')
  await soon(() => app.circles()).toEqual(before)

  // Gives half of the region to one cell.
  const share = app.inspector.getByLabel('% of the region')
  await share.fill('50')
  await share.press('Enter')
  await expect(app.inspector.locator('dd').first()).toHaveText(digits(TOTAL / 2))
  await soon(async () => (await linkOf(app)).areas).toEqual([2, 1, 1])
  // Another change is another undo step.
  await share.fill('20')
  await share.press('Enter')
  await expect(app.inspector.locator('dd').first()).toHaveText(digits(TOTAL / 5))
  await app.canvas.focus()
  await page.keyboard.press('Control+z')
  await expect(app.inspector.locator('dd').first()).toHaveText(digits(TOTAL / 2))
  await app.inspector.getByRole('button', { name: 'Circle 1' }).click()
  await expect(app.inspector.locator('dd').first()).toHaveText(digits(TOTAL / 4))
  await page.reload()
  await expect(app.status).toContainText(/areas within/)
  await expect(choose).toHaveValue('own')
  // The panel is open, and the next frame shows all circles beside it.
  await framesOf(page, 2)
  await expect(await areaOf([2, 5])).toHaveText(digits(TOTAL / 4))
  await expect(app.inspector.getByLabel('w', { exact: true })).toHaveAttribute('readonly', '')

  // The slider changes areas live.
  await app.inspector.getByLabel('Share of the region, against the mean').fill('0')
  await expect(app.inspector.locator('dd').first()).toHaveText(digits(TOTAL / 3))

  // Two points cannot coincide.
  for (const [name, value] of [
    ['x', '0'],
    ['y', '0'],
  ] as const) {
    await app.field(name).fill(value)
    await app.field(name).press('Enter')
  }
  await expect(page.getByRole('alert')).toContainText('has the same position as')
})

test('areas are by a column of the opened table, taken back by undo, and kept by a reload with the column', async ({
  app,
}) => {
  const { page } = app
  await app.openPanel('Region')
  await app.drop('towns.csv', 'x,y,r,name,people,rain\n0,0,1,A,10,3\n6,0,1,B,20,0\n2,5,1,C,,5\n')
  const choose = panel(app).getByLabel('Areas')
  const byPeople = choose.locator('option', { hasText: 'by people' })
  await expect(byPeople).toHaveCount(1)
  await app.drop('hall.geojson', geojson(SQUARE, HOLE))
  await expect(choose).toBeEnabled()
  await choose.selectOption('by people')
  await expect(app.status).toContainText(/areas within/)
  await expect(page.locator('#toast')).toHaveText('1 of the circles have no number in people: they get the mean.')
  await soon(async () => (await linkOf(app)).areas).toEqual([10, 20, 15])
  const { x, y } = place(app, [6, 0])
  await page.mouse.click(x, y)
  await expect(app.inspector.locator('dd').first()).toHaveText(String(Number(((TOTAL * 20) / 45).toPrecision(4))))

  // Invalid areas are refused, and the last areas stay.
  await choose.selectOption('by rain')
  await expect(page.getByRole('alert')).toHaveText('rain: circle 1 has 0. Areas need numbers above 0.')
  await expect(choose).toHaveValue('column:people')

  await app.canvas.focus()
  await page.keyboard.press('Control+z')
  await expect(choose).toHaveValue('free')
  await soon(async () => [...(await app.circles())]).toEqual([...THREE])
  await page.keyboard.press('Control+Shift+z')
  await expect(choose).toHaveValue('column:people')
  await soon(async () => (await linkOf(app)).areas).toEqual([10, 20, 15])
  await page.reload()
  await expect(choose).toHaveValue('own')
  await expect(byPeople).toHaveCount(1)

  // Undoing an opening restores the columns, too.
  await app.drop('towns.csv', 'x,y,r,people\n0,0,1,1\n6,0,1,2\n2,5,1,3\n')
  await expect(byPeople).toHaveCount(1)
  await app.drop('none.csv', '0,0,1\n9,9,1\n')
  await expect(app.status).toContainText('2 circles')
  await expect(byPeople).toHaveCount(0)
  await app.canvas.focus()
  await page.keyboard.press('Control+z')
  await expect(byPeople).toHaveCount(1)
})

/** The page with equal areas, and the thread that has fitted them and waits for the next fit. */
async function withFitter(app: App) {
  const { page } = app
  await app.openPanel('Region')
  await app.drop('square.wkt', 'POLYGON ((-3 -3, 9 -3, 9 8, -3 8))')
  const choose = panel(app).getByLabel('Areas')
  await choose.selectOption('equal')
  await expect(app.status).toContainText(/areas within/)
  await soon(async () => (await linkOf(app)).areas).toBe('equal')
  const threads = page.workers().filter((worker) => THREAD.test(worker.url()))
  expect(threads).toHaveLength(2)
  const [painting, fitter] = threads as [Worker, Worker]
  const circles = await app.circles()
  // The radii are those of the core.
  const { diagram } = fitAreas(THREE, [1, 1, 1], { region: region([SQUARE]), shares: true, tolerance: 1e-6 })
  expect(circles).toEqual(Float64Array.from(diagram.circles))
  return { page, choose, painting, fitter, circles }
}

test('cells that are being clipped stay whole if that is canceled', async ({ app }) => {
  const { page } = app
  const progress = page.locator('#progress')
  await app.openPanel('Region')
  const circles = await app.circles()
  // The thread never receives the region. A new thread takes over.
  await threadOf(page).evaluate(() => {
    const thread = globalThis as unknown as { onmessage(event: MessageEvent): void }
    const hear = thread.onmessage
    thread.onmessage = (event) => event.data.name !== 'edit' && hear(event)
  })
  await app.drop('square.wkt', 'POLYGON ((-3 -3, 9 -3, 9 8, -3 8))')
  await expect(progress).toContainText('Clipping the cells of 3 circles …')
  await progress.getByRole('button', { name: 'Cancel' }).click()
  await expect(progress).toBeHidden()
  await expect(page.locator('#toast')).toHaveText('Canceled. Nothing has changed.')
  await app.painted()
  expect((await linkOf(app)).region).toBeUndefined()
  await app.drop('square.wkt', 'POLYGON ((-3 -3, 9 -3, 9 8, -3 8))')
  await expect(panel(app)).toContainText('One outline with 4 sides')
  expect(await app.circles()).toEqual(circles)
})

test('while areas are fitted, the figure zooms and is painted; canceled, the fit ends alone', async ({ app }) => {
  const { page, choose, painting, fitter, circles } = await withFitter(app)
  // A request that is answered late blocks the thread as long as the test needs.
  const fitting = page.waitForRequest('**/fitting')
  await page.route('**/fitting', () => {})
  await fitter.evaluate(() => {
    const thread = globalThis as unknown as { onmessage(event: MessageEvent): void }
    const hear = thread.onmessage
    thread.onmessage = (event) => {
      const request = new XMLHttpRequest()
      request.open('GET', '/fitting', false)
      request.send()
      hear(event)
    }
  })
  // The corner of the window is inside the region at first. After zooming out, the old pixels do not reach it.
  const corner = { x: 1270, y: 790 }
  const colorOfCorner = async () => String(await app.colors([corner]))
  await app.canvas.focus()
  for (let k = 0; k < 10; k++) await page.keyboard.press('+')
  await app.painted()
  expect(['0,0,0', PAPER]).not.toContain(await colorOfCorner())
  const progress = page.locator('#progress')
  await choose.selectOption('disc')
  await fitting
  await expect(progress).toContainText('Fitting the areas of 3 circles …')
  await app.canvas.focus()
  for (let k = 0; k < 20; k++) await page.keyboard.press('-')
  await soon(colorOfCorner).toBe(PAPER)
  await expect(progress).toBeVisible()
  await progress.getByRole('button', { name: 'Cancel' }).click()
  await expect(progress).toBeHidden()
  await expect(page.locator('#toast')).toHaveText('Canceled. Nothing has changed.')
  await soon(() => page.workers().includes(fitter)).toBe(false)
  expect(page.workers()).toContain(painting)
  await expect(choose).toHaveValue('equal')
  expect([await app.circles(), await colorOfCorner()]).toEqual([circles, PAPER])

  await choose.selectOption('disc')
  await soon(async () => (await linkOf(app)).areas).toEqual([1, 1, 1])
  await app.canvas.focus()
  await page.keyboard.press('Control+z')
  await soon(async () => (await linkOf(app)).areas).toBe('equal')
  expect(await app.circles()).toEqual(circles)
  await page.keyboard.press('Control+z')
  await expect(choose).toHaveValue('free')
})

test('a thread that crashes while areas are fitted is told, and the next fit has another one', async ({ app }) => {
  const { page, choose, painting, fitter, circles } = await withFitter(app)
  await fitter.evaluate(() => {
    globalThis.onmessage = () => {
      throw new Error('it broke')
    }
  })
  await choose.selectOption('disc')
  await expect(page.getByRole('alert')).toContainText('it broke')
  await expect(choose).toHaveValue('equal')
  expect(await app.circles()).toEqual(circles)
  await soon(() => page.workers().includes(fitter)).toBe(false)
  expect(page.workers()).toContain(painting)
  const { x, y } = place(app, [0, 0])
  await page.mouse.click(x, y)
  await expect(app.inspector.getByRole('heading')).toHaveText('Circle 0')
  await choose.selectOption('free')
  await soon(() => app.circles()).toEqual(THREE)
  await choose.selectOption('equal')
  await soon(() => app.circles()).toEqual(circles)
})

test('a region is in the table, in the storage of the browser, and in a link that somebody else opens', async ({
  app,
  browser,
}) => {
  const { page } = app
  await app.openPanel('Region')
  await app.drop('hall.geojson', geojson(SQUARE, HOLE))
  await expect(panel(app)).toContainText('2 outlines with 8 sides')
  const diagram = (await loadCircleVoronoi()).compute(THREE)
  const ring = [SQUARE, HOLE]
  const areas = [...diagram.cellAreas({ region: region(ring) })].map((area) => String(Number(area.toPrecision(4))))
  const inTable = async ({ page }: App) => page.locator('#circle-grid [role="row"] > :nth-child(5)').allTextContents()
  await app.openPanel('Table')
  await soon(() => inTable(app)).toEqual(expect.arrayContaining(areas))

  // Without the link in the address, the storage restores the region.
  await soon(async () => (await linkOf(app)).region).toMatchObject({ type: 'MultiPolygon' })
  const { href } = new URL(page.url())
  await page.evaluate(() => history.replaceState(null, '', location.pathname))
  await page.reload()
  await expect(app.status).toContainText('3 circles')
  await soon(() => inTable(app)).toEqual(expect.arrayContaining(areas))

  const context = await browser.newContext()
  const other = new App(await context.newPage())
  await other.page.goto(href)
  await other.openPanel('Region')
  await expect(panel(other)).toContainText('2 outlines with 8 sides')
  await context.close()
})

test('a tiny circle in a region can be selected while nothing but it is visible', async ({ page }) => {
  const link = await encodeLink({
    circles: Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1, 3, 3, 1e-6),
    region: [
      [
        [-9, -9],
        [9, -9],
        [9, 9],
        [-9, 9],
      ],
    ],
    view: { x: 3, y: 3, span: 1e-5 },
  })
  const app = new App(page)
  await app.open(link)
  await app.painted()
  await page.mouse.click(640, 400)
  await expect(app.inspector.getByRole('heading')).toHaveText('Circle 3')
  await app.painted()
  // The outline of the cell is far outside the window.
  const [cell, disc] = await app.colors([
    { x: 300, y: 600 },
    { x: 640, y: 400 },
  ])
  expect(disc).not.toEqual(cell)
  expect(
    await app.colors([
      { x: 200, y: 200 },
      { x: 900, y: 650 },
    ]),
  ).toEqual([cell, cell])
})

test('circles have their radii again where areas are no longer given', async ({ app }) => {
  await app.openPanel('Region')
  await app.drop('hall.geojson', geojson(SQUARE, HOLE))
  const choose = panel(app).getByLabel('Areas')
  await choose.selectOption('disc')
  await expect(app.status).toContainText(/areas within/)
  await soon(async () => [...(await app.circles())]).not.toEqual([...THREE])
  await choose.selectOption('free')
  await soon(async () => [...(await app.circles())]).toEqual([...THREE])
  await expect(app.status).not.toContainText(/areas within/)
})

test('the cities have the outline of their land, also by a link of their name', async ({ app }) => {
  await app.choose('Cities of Europe')
  await app.openPanel('Region')
  await expect(panel(app)).toContainText('11 outlines with 2,062 sides')
  // A name stands for circles and region.
  await soon(async () => linkOf(app)).toEqual({ dataSet: 'cities' })
  await app.page.reload()
  await expect(panel(app)).toContainText('11 outlines')
  await panel(app).getByRole('button', { name: 'Remove region' }).click()
  await soon(async () => linkOf(app)).toEqual({ dataSet: 'cities', region: null })
  await app.page.reload()
  await expect(panel(app)).not.toContainText('outlines')
})

test('is clear to everyone: empty, while drawing, refused, with areas', async ({ app }) => {
  const { page } = app
  const expectNone = async () => expect(await violationsInBoth(page)).toEqual([])
  await app.openPanel('Region')
  await expectNone()
  await panel(app).getByRole('button', { name: 'Draw' }).click()
  await page.mouse.click(600, 300)
  await expect(panel(app).getByRole('button', { name: 'Undo corner' })).toBeEnabled()
  await expectNone()
  await page.keyboard.press('Enter')
  await expect(page.getByRole('alert')).toHaveText('A polygon needs three corners or more.')
  await expectNone()
  await page.keyboard.press('Escape')
  await app.drop('hall.geojson', geojson(SQUARE, HOLE))
  await panel(app).getByLabel('Areas').selectOption('equal')
  await expect(app.status).toContainText(/areas within/)
  const { x, y } = place(app, [0, 0])
  await page.mouse.click(x, y)
  await expect(app.inspector.getByLabel('% of the region')).toBeVisible()
  await expectNone()
})

test.describe('by fingers', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 780 } })

  test('a region is drawn on a phone', async ({ app }) => {
    await app.openPanel('Region')
    await panel(app).getByRole('button', { name: 'Draw' }).tap()
    for (const [x, y] of [
      [60, 150],
      [330, 140],
      [200, 300],
    ] as const) {
      await app.page.touchscreen.tap(x, y)
    }
    await panel(app).getByRole('button', { name: 'Close polygon' }).tap()
    await expect(panel(app)).toContainText('One outline with 3 sides')
  })
})

// Tests of drawing rely on this camera.
test('the camera of these tests is that of the page', async ({ app }) => {
  await app.openPanel('Region')
  await app.drop('square.wkt', 'POLYGON ((-3 -3, 9 -3, 9 8, -3 8))')
  await expect(panel(app)).toContainText('One outline')
  const size = app.page.viewportSize() as { width: number; height: number }
  const corner = place(app, [-3, -3])
  expect(toPlane(cameraOf(app), size, corner)).toEqual({ x: expect.closeTo(-3, 9), y: expect.closeTo(-3, 9) })
  expect(await colorAt(app, [-2.8, -2.8])).not.toBe(PAPER)
  expect(await colorAt(app, [-3.2, -3.2])).toBe(PAPER)
})
