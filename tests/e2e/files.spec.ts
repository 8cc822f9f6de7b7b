// SPDX-License-Identifier: GPL-3.0-or-later
// Opening, saving and sharing.
import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { loadFiles } from '../../web/lib/files.ts'
import { decodeLink, LINK_LIMITS } from '../../web/lib/link.ts'
import { loadCircleVoronoi } from '../../web/lib/wasm/loader.ts'
import { soon } from '../soon.ts'
import { framesOf } from './frames.ts'
import { App, dataSet, expect, test } from './page.ts'

const INTRODUCTION = dataSet('introduction')
const THREE_CIRCLES = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const THREE = 'x,y,r\n0,0,1\n6,0,1\n0,8,1\n'

async function openPanel(app: App) {
  await app.openPanel('Files')
}

async function choose(app: App, name: string, content: string | Buffer): Promise<void> {
  const buffer = Buffer.from(content)
  await app.page.getByLabel('Open …').setInputFiles({ name, mimeType: 'text/plain', buffer })
}

/** Keeps toasts open. They close after some seconds, before a slow machine has read them. */
function keepToasts(page: Page): Promise<void> {
  return page.evaluate(() => {
    const set = window.setTimeout as (act: TimerHandler, ms?: number) => number
    const setQuick = (act: TimerHandler, ms = 0) => (ms < 6000 ? set(act, ms) : 0)
    window.setTimeout = setQuick as typeof setTimeout
  })
}

/** Clicks a button and returns the saved file. */
async function saved(app: App, label: string): Promise<{ name: string; text: string }> {
  const download = app.page.waitForEvent('download')
  await app.page.locator('#files').getByRole('button', { name: label, exact: true }).click()
  const file = await download
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), 'utf8') }
}

test('opens circles in each format, and undo goes back', async ({ app }) => {
  await openPanel(app)
  const files = await loadFiles()
  const three = (format: 'csv' | 'json' | 'geojson' | 'svg') =>
    format === 'svg'
      ? // The name equals that of the command line's files.
        loadCircleVoronoi().then((library) => files.writeDiagram(library.compute(THREE_CIRCLES), { format }))
      : files.writeCircles(THREE_CIRCLES, { format })
  for (const format of ['csv', 'json', 'geojson', 'svg'] as const) {
    await test.step(format, async () => {
      await choose(app, `three.${format}`, await three(format))
      await expect(app.status).toContainText('3 circles')
      await expect(app.status).toContainText('1 vertex')
      await app.page.getByRole('button', { name: 'Undo' }).click()
      await expect(app.status).toContainText('678 circles')
    })
  }
})

test('what is saved opens again: SVG as it is, JSON with its diagram, CSV, GeoJSON', async ({ app }) => {
  await app.choose('Introduction')
  await openPanel(app)
  await app.select(INTRODUCTION, 4)
  await app.field('x').fill(String(-10 / 3))
  await app.field('x').press('Enter')
  const expected = INTRODUCTION.slice()
  expected[12] = -10 / 3
  const files = await loadFiles()
  await expect(app.field('x')).toHaveAttribute('title', String(-10 / 3))

  const svg = await saved(app, 'SVG')
  expect(svg.name).toBe('introduction.svg')
  const link = await decodeLink(/<metadata id="circle-voronoi">(.*)<\/metadata>/.exec(svg.text)?.[1] as string)
  expect(link).toMatchObject({ dataSet: 'introduction', edits: [{ kind: 'replace', id: 4 }] })
  expect(files.readCircles((await saved(app, 'CSV')).text)).toEqual(expected)
  expect(files.readCircles((await saved(app, 'GeoJSON')).text)).toEqual(expected)
  const json = await saved(app, 'JSON')
  const diagram = files.readDiagram(json.text)
  expect(diagram.circles).toEqual(expected)
  expect(diagram.certificate.certified).toBe(true)
  const cells = JSON.parse((await saved(app, 'Cells')).text).features
  expect(cells.map((cell: { properties: { circle: number } }) => cell.properties.circle)).toContain(4)
  const edges = `${(await loadCircleVoronoi()).compute(expected).edges.length / 4} edges`

  for (const [name, { text }] of [
    ['a.svg', svg],
    ['a.json', json],
  ] as const) {
    await app.choose('Spruces')
    await expect(app.status).toContainText('134 circles')
    await choose(app, name, text)
    await expect(app.status).toContainText('14 circles')
    await expect(app.status).toContainText(edges)
    await app.page.getByRole('button', { name: 'Fit' }).click()
    const moved = app.locate(expected, { x: -10 / 3, y: expected[13] as number })
    await app.page.mouse.click(moved.x, moved.y)
    await expect(app.field('x')).toHaveAttribute('title', String(-10 / 3))
  }
})

test('saves the picture that is seen as PNG, so many times as large', async ({ app }) => {
  await openPanel(app)
  const sizeOf = async (times: string) => {
    await app.page.getByLabel('× its size').fill(times)
    await app.page.getByLabel('× its size').press('Tab')
    const download = app.page.waitForEvent('download')
    await app.page.getByRole('button', { name: 'PNG' }).click()
    const file = await download
    expect(file.suggestedFilename()).toBe('bronzefilter.png')
    const bytes = readFileSync(await file.path())
    expect(bytes.subarray(1, 4).toString()).toBe('PNG')
    return [bytes.readUInt32BE(16), bytes.readUInt32BE(20), bytes.length]
  }
  expect(await sizeOf('1')).toEqual([1280, 800, expect.any(Number)])
  const [width, height, length] = await sizeOf('2.5')
  expect([width, height]).toEqual([3200, 2000])
  // An empty picture would be smaller.
  expect(length).toBeGreaterThan(200_000)
  await app.page.getByLabel('× its size').fill('1000')
  await app.page.getByLabel('× its size').press('Tab')
  await app.page.getByRole('button', { name: 'PNG' }).click()
  await expect(app.page.getByRole('alert')).toContainText('too large')
})

test('an SVG of circles too many for a link opens again, as these circles', async ({ app }) => {
  const count = LINK_LIMITS.circles + 1
  const rows = Array.from({ length: count }, (_, k) => `${k % 317},${Math.floor(k / 317)},0.25`)
  await openPanel(app)
  await choose(app, 'grid.csv', `x,y,r\n${rows.join('\n')}\n`)
  await expect(app.status).toContainText('100,001 circles')
  // Zooms in, so that the drawing is as small as possible.
  for (let k = 0; k < 10; k++) await app.page.getByRole('button', { name: 'Zoom in' }).click()
  const { text } = await saved(app, 'SVG')
  expect(text.length).toBeLessThan(30 * count)
  await app.choose('Introduction')
  await choose(app, 'grid.svg', text)
  await expect(app.status).toContainText('100,001 circles')
})

const WRONG_FILES = [
  ['a line that is no circle', 'a.csv', '0,0,1\n1,2,three', /^a\.csv:2: .*\. Skip 1 row$/],
  ['a negative radius', 'a.csv', '0,0,1\n1,2,-3', /^a\.csv:2: Circle 1 has a negative radius\. Skip 1 row$/],
  ['JSON of something else', 'a.json', '{"name": "x"}', /^a\.json:.*\.$/],
  [
    'something that is no text',
    'a.bin',
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0, 255, 254]),
    /^a\.bin is not a table of circles\. Open .*\.$/,
  ],
  [
    'an SVG of something else',
    'a.svg',
    '<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>',
    /this SVG is none/,
  ],
  [
    'an SVG with a damaged link',
    'a.svg',
    '<svg><metadata id="circle-voronoi">v1.AAAA</metadata></svg>',
    /cannot be read/,
  ],
  ['an SVG that would run something', 'a.svg', '<svg><script>document.title = "x"</script></svg>', /this SVG is none/],
  ['nothing', 'a.csv', '', /empty/],
] as const

test('a file that is wrong gets a sentence and changes nothing', async ({ app }) => {
  await openPanel(app)
  const undo = app.page.getByRole('button', { name: 'Undo' })
  for (const [what, name, content, says] of WRONG_FILES) {
    await test.step(what, async () => {
      await choose(app, name, content)
      await expect(app.page.getByRole('alert')).toHaveText(says)
      await expect(app.status).toContainText('678 circles')
      await expect(undo).toBeDisabled()
      await expect(app.page).toHaveTitle('Voronoi diagram of circles')
      await choose(app, 'three.csv', THREE)
      await expect(app.status).toContainText('3 circles')
      await expect(app.page.getByRole('alert')).toBeHidden()
      await undo.click()
      await expect(app.status).toContainText('678 circles')
    })
  }
})

/** The state in the address of the page, once the address is stable. */
const linked = async (app: App) => decodeLink(new URL(app.page.url()).hash).catch(() => undefined)

test('opens what is dropped', async ({ app }) => {
  const data = await app.page.evaluateHandle((text) => {
    const data = new DataTransfer()
    data.items.add(new File([text], 'three.csv'))
    return data
  }, THREE)
  await app.canvas.dispatchEvent('dragover', { dataTransfer: data })
  await expect(app.page.locator('body')).toHaveClass('dropping')
  await app.canvas.dispatchEvent('drop', { dataTransfer: data })
  await expect(app.status).toContainText('3 circles')
  await soon(async () => (await linked(app))?.circles).toEqual(THREE_CIRCLES)
  await expect(app.page.locator('body')).not.toHaveClass('dropping')
  await app.page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toContainText('678 circles')
})

test('opens what is pasted, numbers or a link, but not into a field', async ({ app }) => {
  await app.page.context().grantPermissions(['clipboard-read', 'clipboard-write'])
  const paste = async (text: string) => {
    await app.page.evaluate((text) => navigator.clipboard.writeText(text), text)
    await app.page.keyboard.press('Control+v')
  }
  await keepToasts(app.page)
  await app.canvas.focus()
  // Pasted rows of a spreadsheet are added; nothing is removed without asking.
  await paste('0\t0\t1\n6\t0\t1\n0\t8\t1\n')
  await expect(app.status).toContainText('681 circles')
  await expect(app.page.getByRole('region', { name: 'Selected circles' })).toContainText('3 circles')
  await expect(app.page.locator('#toast')).toContainText('3 circles were added.')
  await app.page.getByRole('button', { name: 'Replace all circles instead' }).click()
  await expect(app.page.locator('#toast')).toBeHidden()
  await expect(app.status).toHaveText(/^3 circles/)
  await soon(async () => (await linked(app))?.circles).toEqual(THREE_CIRCLES)
  const link = 'v1.q1ZKSSxJDE4tUbJSSirKz6tKTcvMKUktUtJRSk3JLClWsoqOVtJV0jEzNYiNrQUA'
  await paste(`https://example.org/page#${link}`)
  await expect(app.status).toContainText('677 circles')
  const { dataSet, edits } = await decodeLink(link)
  await soon(() => linked(app)).toMatchObject({ dataSet, edits })
  await app.canvas.focus()
  await app.page.keyboard.press('Enter')
  await expect(app.inspector).toBeVisible()
  await app.field('x').focus()
  await app.page.keyboard.press('Control+a')
  await paste('7')
  await expect(app.field('x')).toHaveValue('7')
  await expect(app.status).toContainText('677 circles')
})

test('copies a link and the code of a frame, which show the same', async ({ app }) => {
  const copied = (name: string) => app.copiedBy(app.page.getByRole('button', { name }))
  await keepToasts(app.page)
  await openPanel(app)
  await choose(app, 'three.csv', THREE)
  await expect(app.status).toContainText('3 circles')
  await app.page.getByRole('button', { name: 'Share', exact: true }).click()
  const link = await copied('Copy link')
  // The message is visible whatever panel is open.
  await expect(app.page.locator('#toast')).toHaveText('The link is in the clipboard.')
  await expect(app.page.locator('#toast')).toBeInViewport()
  const frame = await copied('Copy embed code')
  await expect(app.page.locator('#toast')).toHaveText('The code is in the clipboard.')
  expect(frame).toBe(
    `<iframe src="${link.replace('#', 'embed.html#')}" title="Voronoi diagram of 3 circles" loading="lazy" width="100%" height="480" style="width: 100%; height: auto; aspect-ratio: 3 / 2; max-height: 90vh; border: 0"></iframe>`,
  )
  // The code contains the circles themselves, so that it works anywhere.
  const element = await copied('Copy element')
  const lines =
    /^<script type="module" src="([^"]+)"><\/script>\n<circle-voronoi src="#(v1\.[\w-]+)" controls alt="(.+)">\3<\/circle-voronoi>$/
  expect(element).toMatch(lines)
  const [, module, said, about] = lines.exec(element) as RegExpExecArray
  expect(about).toBe('Voronoi diagram of 3 circles')
  expect(module).toBe(new URL('element.js', link).href)
  expect((await app.page.request.get(module as string)).status()).toBe(200)
  expect((await decodeLink(said as string)).circles).toEqual((await decodeLink(new URL(link).hash)).circles)
  expect((await decodeLink(new URL(link).hash)).circles).toEqual(Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1))
})

test('works where the part for files fails to load, once it can be loaded', async ({ page }) => {
  const app = new App(page)
  await app.open()
  await page.route('**/circle-voronoi-files*.wasm', (route) => route.abort())
  await openPanel(app)
  await choose(app, 'three.csv', THREE)
  await expect(page.getByRole('alert')).toContainText('cannot be loaded')
  await page.unroute('**/circle-voronoi-files*.wasm')
  await choose(app, 'three.csv', THREE)
  await expect(app.status).toContainText('3 circles')
})

test('saved drawings are what is seen: its colors, its layers and its part of the plane, or all circles', async ({
  app,
}) => {
  const { page } = app
  await app.choose('Introduction')
  await app.openPanel('Layers')
  await page.getByLabel('Colors').selectOption('by area of the cell')
  await page.getByLabel('Convex hull').check()
  await openPanel(app)
  await page.mouse.move(700, 400)
  await page.mouse.wheel(0, -400)
  await app.painted()
  /** The colors of some pixels of a drawing in the size of the window. */
  const drawnColors = (svg: string, points: readonly { x: number; y: number }[]) =>
    page.evaluate(
      async ([svg, points]) => {
        const image = new Image()
        image.src = `data:image/svg+xml,${encodeURIComponent(svg)}`
        await image.decode()
        const canvas = new OffscreenCanvas(innerWidth, innerHeight)
        const context = canvas.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
        context.drawImage(image, 0, 0)
        return points.map(({ x, y }) => [...context.getImageData(x, y, 1, 1).data.slice(0, 3)])
      },
      [svg, points] as const,
    )
  const points = Array.from({ length: 240 }, (_, k) => ({ x: 420 + 37 * (k % 20), y: 90 + 53 * Math.floor(k / 20) }))
  const isSame = (one: number[] | undefined, other: number[]) =>
    one?.every((value, k) => Math.abs(value - (other[k] as number)) < 12)
  const seen = await app.colors(points)
  const seenSvg = (await saved(app, 'SVG')).text
  const drawn = await drawnColors(seenSvg, points)
  // Pixels at edges may be rounded differently.
  expect(drawn.filter((color, k) => isSame(seen[k], color)).length).toBeGreaterThan(0.95 * points.length)
  expect(new Set(seen.map(String)).size).toBeGreaterThan(8)
  await page.getByLabel('What the picture shows').selectOption('all circles')
  const all = await drawnColors((await saved(app, 'SVG')).text, points)
  expect(all.filter((color, k) => isSame(seen[k], color)).length).toBeLessThan(0.8 * points.length)
  // A poster has the pixels of a sheet of paper.
  const download = page.waitForEvent('download')
  await page.getByRole('button', { name: 'Poster, A3' }).click()
  const bytes = readFileSync(await (await download).path())
  expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([4961, 3508])
})

test('columns of other names are guessed, and asked for with a preview; names are seen on hover and when selected', async ({
  app,
}) => {
  const { page } = app
  await openPanel(app)
  await choose(app, 'german.csv', 'Ort;X-Koordinate;Y-Koordinate;Radius\nBonn;0,5;0;1\nUlm;6;0;1,5\nKiel;0;8;1\n')
  const dialog = page.getByRole('dialog', { name: 'Which columns are the circles?' })
  await expect(dialog).toContainText('No circle is hidden.')
  await page.keyboard.press('Enter')
  await expect(app.status).toHaveText(/^3 circles/)
  await soon(() => app.circles()).toEqual(Float64Array.of(0.5, 0, 1, 6, 0, 1.5, 0, 8, 1))
  const circles = Float64Array.of(0.5, 0, 1, 6, 0, 1.5, 0, 8, 1)
  const at = app.center(circles, 1)
  await page.mouse.move(at.x, at.y)
  await expect(page.locator('#name-tag')).toHaveText('Ulm')
  await page.mouse.click(at.x, at.y)
  await expect(app.inspector).toContainText('Ulm')
  // The link contains them.
  await page.reload()
  await expect(app.status).toHaveText(/^3 circles/)
  // The panel is open again, and the next frame shows all circles beside it.
  await expect(page.getByLabel('Open …')).toBeVisible()
  await framesOf(page, 2)
  await page.mouse.move(at.x, at.y)
  await page.mouse.move(at.x + 1, at.y)
  await expect(page.locator('#name-tag')).toHaveText('Ulm')

  await choose(app, 'odd.csv', 'a,b,c,d\n1,2,3,4\n5,6,7,8\n15,1,2,3\n')
  await expect(dialog.getByRole('columnheader')).toHaveText(['ax', 'by', 'c', 'dr'])
  await expect(dialog.getByRole('cell')).toHaveCount(12)
  await dialog.getByLabel('x', { exact: true }).selectOption('d')
  await dialog.getByLabel('y', { exact: true }).selectOption('d')
  await expect(dialog).toContainText('x and y are the same column.')
  await expect(dialog.getByRole('button', { name: 'Open' })).toBeDisabled()
  await dialog.getByLabel('y', { exact: true }).selectOption('a')
  await dialog.getByLabel('radius').selectOption('the same for all')
  await dialog.getByLabel('r', { exact: true }).fill('0.5')
  await dialog.getByLabel('r', { exact: true }).press('Tab')
  await dialog.getByRole('button', { name: 'Open' }).click()
  await soon(() => app.circles()).toEqual(Float64Array.of(4, 1, 0.5, 8, 5, 0.5, 3, 15, 0.5))
  // A table of two columns has no radius.
  await choose(app, 'two.csv', 'a,b\n1,2\n3,5\n')
  await expect(dialog.getByLabel('radius').locator('option:checked')).toHaveText('the same for all')
  await dialog.getByRole('button', { name: 'Open' }).click()
  await soon(() => app.circles()).toEqual(Float64Array.of(1, 2, 1, 3, 5, 1))
  await page.getByRole('button', { name: 'Undo' }).click()
  await expect(app.status).toHaveText(/^3 circles/)
  // Closing the dialog changes nothing.
  for (const close of [
    () => page.keyboard.press('Escape'),
    () => dialog.getByRole('button', { name: 'Cancel' }).click(),
  ]) {
    await choose(app, 'odd.csv', 'a,b,c,d\n1,2,3,4\n5,6,7,8\n')
    await expect(dialog).toBeVisible()
    await close()
    await expect(dialog).toBeHidden()
  }
  await expect(page.getByRole('alert')).toBeHidden()
  await expect(app.status).toHaveText(/^3 circles/)
})

test('a picture becomes circles, larger ones where it is darker', async ({ app }) => {
  const png = await app.page.evaluate(async () => {
    const canvas = new OffscreenCanvas(120, 80)
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
    context.fillStyle = 'white'
    context.fillRect(0, 0, 120, 80)
    context.fillStyle = 'black'
    context.fillRect(0, 0, 60, 40)
    return [...new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())]
  })
  await openPanel(app)
  const file = { name: 'dark-corner.png', mimeType: 'image/png', buffer: Buffer.from(png) }
  await app.page.getByLabel('Open …').setInputFiles(file)
  await expect(app.status).toHaveText(/^1,800 circles/)
  await soon(async () => (await app.circles()).length).toBe(5400)
  const circles = await app.circles()
  const isTopLeft = (i: number) => (circles[3 * i] as number) < 60 && (circles[3 * i + 1] as number) > 40
  const dark = Array.from({ length: 1800 }, (_, i) => i).filter(isTopLeft).length
  expect(dark).toBeGreaterThan(5 * (1800 - dark))
  await choose(app, 'broken.png', 'no picture')
  await expect(app.page.getByRole('alert')).toContainText('broken.png')
})
