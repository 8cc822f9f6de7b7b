// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the recipes of the cookbook like a reader: scripts in Node, pages in a browser. Each recipe has its picture.
import { existsSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { blocksRunBy } from '../readme/blocks.mjs'
import { addModules, POLICY, pageOf, pageOfComponent, recipes, withOwnElement } from '../readme/recipes.mjs'
import { soon } from '../soon.ts'
import { Project, ROOT } from './project.mjs'
import { serve } from './static-server.ts'

const RECIPES = recipes()
const inLanguage = (name: string) => RECIPES.filter(({ language }) => language === name)
const pageOfRecipe = (name: string) => pageOf(inLanguage('html').find(({ title }) => title === name)?.code ?? '')
/** Jupyter shows the value of a cell's last line. */
const NOTEBOOK = `
class HTML:
    def __init__(self, data):
        self.data = data
`

let project: Project
test.beforeAll(() => {
  project = new Project()
  addModules(project.folder)
})
test.afterAll(() => project.remove())

test('all of them are run, and each section has a picture', () => {
  expect(blocksRunBy('tests/pack/cookbook.spec.ts').map(({ code }) => code)).toEqual(RECIPES.map(({ code }) => code))
  expect(new Set(RECIPES.map(({ language }) => language))).toEqual(new Set(['html', 'js', 'jsx', 'py']))
  const text = readFileSync(join(ROOT, 'docs/cookbook.md'), 'utf8')
  const sections = text.split(/^## /m).slice(1)
  expect(sections.length).toBeGreaterThan(18)
  for (const section of sections) {
    const [, picture = ''] = /!\[\w.*\]\(((?:cookbook|examples)\/[\w-]+\.\w+)\)/.exec(section) ?? []
    expect(existsSync(join(ROOT, 'docs', picture)), section).toBe(true)
    expect(picture, section).not.toBe('')
  }
  // The cookbook shows the pictures that `npm run picture` makes.
  for (const { picture } of RECIPES) expect(text).toContain(`](${picture.slice('docs/'.length)})`)
})

for (const { title, code } of inLanguage('js')) {
  test(`${title}, in Node`, () => {
    const expected = [...code.matchAll(/^console\.log\(.*\) \/\/ (.*)$/gm)].map(([, text]) => `${text}\n`)
    expect(expected).not.toHaveLength(0)
    project.write('recipe.js', code)
    expect(project.run(process.execPath, 'recipe.js')).toBe(expected.join(''))
  })
}

for (const { title, code } of inLanguage('html')) {
  test(`${title}, in a page`, async ({ page }) => {
    const complaints = await shown(page, pageOf(code))
    await soon(() => colorsIn(page), complaints.join()).toBeGreaterThan(2)
    expect(complaints).toEqual([])
  })
}

test('the cell under the pointer is another one once the pointer has moved', async ({ page }) => {
  await shown(page, pageOfRecipe('Find the circle under the pointer'))
  await soon(() => colorsIn(page)).toBeGreaterThan(2)
  const before = await page.screenshot()
  await page.mouse.move(400, 120)
  await soon(async () => before.equals(await page.screenshot())).toBe(false)
})

test('cells that are redrawn where they change give the picture of all cells', async ({ page }) => {
  const recipe = pageOfRecipe('Redraw only what changed')
  await page.addInitScript(`{
    let frames = 0
    const request = requestAnimationFrame
    globalThis.requestAnimationFrame = (draw) => {
      if (frames < 20) request.call(globalThis, () => draw(40 * frames++))
      else globalThis.isDrawn = true
    }
  }`)
  const pixels = async (html: string) => {
    await shown(page, html)
    await soon(() => page.evaluate(() => 'isDrawn' in globalThis)).toBe(true)
    return page.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
      return Array.from((canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, 480, 300).data)
    })
  }
  const all = await pixels(recipe.replace('draw(change.cells)', 'draw(circles.keys())'))
  const share = (some: readonly number[]) =>
    some.filter((value, k) => Math.abs(value - (all[k] as number)) > 40).length / all.length
  // Lines cover one another in another order.
  expect(share(await pixels(recipe))).toBeLessThan(0.01)
  expect(share(await pixels(recipe.replace('draw(change.cells)', '')))).toBeGreaterThan(0.02)
})

test('a globe turns when it is dragged, and cells cover it', async ({ page }) => {
  await shown(page, pageOfRecipe('Show a globe with d3'))
  await soon(() => colorsIn(page)).toBeGreaterThan(8)
  /** The share of pixels of the globe that no cell covers. */
  const bare = () =>
    page.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
      const { data } = (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, 480, 300)
      const isOnGlobe = (k: number) => Math.hypot((k % 480) - 239.5, Math.floor(k / 480) - 149.5) < 144
      const alphas = Array.from({ length: 480 * 300 }, (_, k) => k).filter(isOnGlobe)
      return alphas.filter((k) => (data[4 * k + 3] as number) < 128).length / alphas.length
    })
  expect(await bare()).toBe(0)
  const before = await page.screenshot()
  await page.mouse.move(200, 150)
  await page.mouse.down()
  for (const [x, y] of [
    [260, 160],
    [320, 190],
    [330, 120],
  ] as const) {
    await page.mouse.move(x, y)
    expect(await bare()).toBe(0)
  }
  await page.mouse.up()
  expect(before.equals(await page.screenshot())).toBe(false)
})

test('a component of React colors the cell under the pointer', async ({ page }) => {
  const [{ code } = { code: '' }] = inLanguage('jsx')
  const complaints = await shown(page, await pageOfComponent(code))
  const cell = page.locator('svg path').first()
  const first = await cell.getAttribute('d')
  for (const [x, y] of [
    [400, 120],
    [400, 170],
  ] as const) {
    await page.mouse.move(x, y)
    await soon(() => cell.evaluate((path, point) => (path as SVGPathElement).isPointInFill(point), { x, y })).toBe(true)
  }
  expect(await cell.getAttribute('d')).not.toBe(first)
  expect(complaints).toEqual([])
})

test('a picture is saved from a page as an SVG file that is the one shown', async ({ page }) => {
  await shown(page, pageOfRecipe('Save an SVG in a browser'))
  const link = page.getByRole('link', { name: 'Save the picture' })
  const [download] = await Promise.all([page.waitForEvent('download'), link.click()])
  expect(download.suggestedFilename()).toBe('cells.svg')
  const text = readFileSync(await download.path(), 'utf8')
  expect(text).toMatch(/^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg"/)
  const shape = await page.locator('svg').evaluate((svg) => svg.innerHTML)
  expect(
    await page.evaluate((svg) => new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement.innerHTML, text),
  ).toContain(/d="[^"]+"/.exec(shape)?.[0])
})

test('cells end at the polygon to which they are clipped', async ({ page }) => {
  await shown(page, pageOfRecipe('Clip cells to a polygon'))
  await soon(() => colorsIn(page)).toBeGreaterThan(2)
  const inked = (x: number, y: number, width: number, height: number) =>
    page
      .locator('canvas')
      .evaluate(
        (canvas, box) =>
          ((canvas as HTMLCanvasElement).getContext('2d') as CanvasRenderingContext2D)
            .getImageData(...(box as [number, number, number, number]))
            .data.some((value) => value > 0),
        [x, y, width, height],
      )
  // Below the arch of the gate and above its roof nothing is drawn, although cells reach there.
  expect(await inked(160, 200, 160, 90)).toBe(false)
  expect(await inked(0, 0, 100, 60)).toBe(false)
  expect(await inked(150, 20, 180, 160)).toBe(true)
})

test('districts differ by less than a twentieth in their numbers of people', async ({ page }) => {
  await shown(page, pageOfRecipe('Make districts'))
  const said = page.locator('output')
  await expect(said).toHaveText(/\d/)
  const people = ((await said.textContent()) as string).split(' ').map(Number)
  expect(people).toHaveLength(8)
  expect(Math.max(...people) / Math.min(...people)).toBeLessThan(1.05)
})

test('a treemap has all parts, each with its share of the area', async ({ page }) => {
  await shown(page, pageOfRecipe('Make a treemap'))
  const cells = page.locator('svg path[fill-opacity]')
  await expect(cells).toHaveCount(12)
  const areas = await cells.evaluateAll((paths) =>
    (paths as SVGPathElement[]).map((path) => {
      const length = path.getTotalLength()
      const points = Array.from({ length: 2000 }, (_, k) => path.getPointAtLength((k / 2000) * length))
      const doubled = points.reduce((sum, { x, y }, k) => {
        const next = points[(k + 1) % points.length] as DOMPoint
        return sum + x * next.y - next.x * y
      }, 0)
      return Math.abs(doubled / 2)
    }),
  )
  const amounts = [9, 7, 3, 2, 8, 5, 1, 6, 4, 6, 5, 1]
  const total = amounts.reduce((sum, amount) => sum + amount)
  for (const [k, amount] of amounts.entries()) {
    expect((areas[k] as number) / ((472 * 292 * amount) / total)).toBeCloseTo(1, 2)
  }
})

test('what a notebook shows is a live figure', async ({ page }) => {
  const [{ code } = { code: '' }] = inLanguage('py')
  const last = code.slice(code.indexOf('HTML('))
  project.write('IPython.py', '')
  project.write('cell.py', `${NOTEBOOK}\nprint(${last.trim()}.data)`)
  const html = project.run('python3', 'cell.py')
  const own = withOwnElement(html)
  expect(own).not.toBe(html)
  const complaints = await shown(page, pageOf(own))
  const figure = page.locator('circle-voronoi')
  await soon(() =>
    figure.evaluate((element) => (element as HTMLElementTagNameMap['circle-voronoi']).circles?.length),
  ).toBe(9)
  expect(complaints).toEqual([])
})

/** Opens a page of the project, and returns the list that collects its errors. */
async function shown(page: Page, html: string): Promise<string[]> {
  const complaints: string[] = []
  page.on('pageerror', ({ message }) => complaints.push(message))
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()))
  project.write('index.html', html)
  const server = await serve(project.folder, POLICY)
  page.once('close', () => void server.close())
  await page.setViewportSize({ width: 480, height: 300 })
  await page.goto(server.address)
  return complaints
}

/** The number of colors in a screenshot. Drawn canvases, SVGs and maps have several. */
async function colorsIn(page: Page): Promise<number> {
  const png = (await page.screenshot()).toString('base64')
  return page.evaluate(async (data) => {
    const image = new Image()
    image.src = `data:image/png;base64,${data}`
    await image.decode()
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d') as OffscreenCanvasRenderingContext2D
    context.drawImage(image, 0, 0)
    const pixels = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)
    return new Set(pixels).size
  }, png)
}
