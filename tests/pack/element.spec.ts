// SPDX-License-Identifier: GPL-3.0-or-later
// <circle-voronoi> in the pages of examples/element, on the built package.
import { spawnSync } from 'node:child_process'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { expect, type Page, test, type Worker } from '@playwright/test'
import { build as bundle, type Plugin } from 'esbuild'
import { build } from 'vite'
import { buildSite } from '../../examples/element/markdown/build.mjs'
import type { FigureState } from '../../web/element/circle-voronoi-element.ts'
import type { Check } from '../../web/lib/check-types.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { boundingBox, fitted, toScreen } from '../../web/view/camera.ts'
import { violationsOf } from '../e2e/accessibility.ts'
import { type Ask, heapOf, withThread } from '../e2e/thread-session.ts'
import { blocksRunBy } from '../readme/blocks.mjs'
import { soon } from '../soon.ts'
import { ROOT } from './project.mjs'
import { type Server, serve } from './static-server.ts'

/** The policy of examples with inline scripts or styles. */
const EXAMPLE_POLICY =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data:"

const THREE = '[[0,0,2],[10,0,1],[5,8,1.5]]'
const FLAT = [0, 0, 2, 10, 0, 1, 5, 8, 1.5]

type Element = HTMLElementTagNameMap['circle-voronoi']
/** The WebAssembly instances of a thread. */
type Instances = { readonly instances: readonly WebAssembly.Instance[] }

let server: Server
test.beforeAll(async () => {
  server = await serve(ROOT, EXAMPLE_POLICY)
})
test.afterAll(() => server.close())

/** The address of an example's page. */
function exampleOf(name: string): string {
  return readFileSync(join(ROOT, `examples/element/${name}/index.html`), 'utf8')
}

/** The folder for generated pages. Each worker has its own. */
const PAGES = `build/examples-${process.env.TEST_PARALLEL_INDEX}`

/** Writes a page for a test. */
function writeExample(name: string, html: string): void {
  const path = join(ROOT, PAGES, name)
  mkdirSync(dirname(path), { recursive: true })
  writeFileSync(path, html)
}

/** Collects the errors of a page, and the addresses that it requests. */
function watch(page: Page): { readonly problems: string[]; readonly asked: string[] } {
  const problems: string[] = []
  const asked: string[] = []
  page.on('pageerror', ({ message }) => problems.push(message))
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && problems.push(message.text()))
  page.on('request', (request) => asked.push(request.url()))
  return { problems, asked }
}

/** Waits until an element shows its circles. */
const shown = (page: Page) =>
  page
    .locator('circle-voronoi')
    .first()
    .evaluate(async (element: Element) => {
      await element.ready
      await element.updateComplete
    })

const circlesOf = (page: Page): Promise<number[]> =>
  page
    .locator('circle-voronoi')
    .first()
    .evaluate((element: Element) => [...element.circles])

/** The position on the page of a circle's center, while all circles are visible. */
async function placeOf(page: Page, i: number): Promise<{ x: number; y: number }> {
  const { circles, box, controls } = await page
    .locator('circle-voronoi')
    .first()
    .evaluate((element: Element) => {
      const root = element.shadowRoot as ShadowRoot
      const { left, top, width, height } = (root.querySelector('.figure') as HTMLElement).getBoundingClientRect()
      const buttons = (root.querySelector('.controls') as HTMLElement).clientHeight
      return { circles: [...element.circles], box: { left, top, width, height }, controls: buttons }
    })
  const padding = { top: controls === 0 ? 16 : controls + 12, right: 16, bottom: 16, left: 16 }
  const camera = fitted(boundingBox(Float64Array.from(circles)), box, padding)
  const { x, y } = toScreen(camera, box, { x: circles[3 * i] as number, y: circles[3 * i + 1] as number })
  return { x: box.left + x, y: box.top + y }
}

async function drag(page: Page, i: number, dx: number, dy: number): Promise<void> {
  const { x, y } = await placeOf(page, i)
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x + dx, y + dy, { steps: 5 })
  await page.mouse.up()
}

/** Scrolls, and waits until the page rests. It continues to scroll after a finger has left it. */
async function scrollBy(page: Page, act: () => Promise<void>): Promise<void> {
  await page.evaluate(() => {
    const ended = new Promise((resolve) => addEventListener('scrollend', resolve, { once: true }))
    Object.assign(globalThis, { ended })
  })
  await act()
  await page.evaluate(() => (globalThis as unknown as { ended: Promise<unknown> }).ended)
}

/** Drags a circle and moves it back by a key. This works in any page. */
async function expectToBeLive(page: Page): Promise<void> {
  await shown(page)
  const before = await circlesOf(page)
  await drag(page, 1, -40, 30)
  await soon(async () => (await circlesOf(page))[3]).toBeLessThan(before[3] as number)
  await page.keyboard.press('Control+z')
  await soon(() => circlesOf(page)).toEqual(before)
}

/** Uses every module: regions clip cells, areas are fitted, and power diagrams are drawn. */
async function expectAllModules(page: Page): Promise<void> {
  const [drawn, areas] = await page
    .locator('circle-voronoi')
    .first()
    .evaluate(async (element: Element) => {
      element.region = 'POLYGON ((0 0, 9 0, 9 8, 0 8))'
      await element.updateComplete
      const cut = await element.toSVG()
      element.setAttribute('layers', 'power')
      const end = Date.now() + 15_000
      let all = await element.toSVG()
      while (all.length <= cut.length && Date.now() < end) all = await element.toSVG()
      element.removeAttribute('layers')
      element.areas = 'equal'
      await element.updateComplete
      return [cut.includes('clip-path') && all.length > cut.length, element.areas] as const
    })
  expect({ drawn, areas }).toEqual({ drawn: true, areas: 'equal' })
}

test('under a strict policy: data that a page without scripts shows, drawn, dragged and edited by keys', async ({
  page,
}) => {
  const { problems, asked } = watch(page)
  await page.addInitScript(() => {
    const told: string[] = []
    for (const name of ['circleschange', 'diagramchange', 'selectionchange', 'error']) {
      document.addEventListener(name, ({ type, target }) => told.push(`${type} of ${(target as Element).localName}`))
    }
    let shift = 0
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) shift += (entry as PerformanceEntry & { value: number }).value
    }).observe({ type: 'layout-shift', buffered: true })
    Object.assign(globalThis, { told, shift: () => shift })
  })
  await page.goto(`${server.address}examples/element/strict/index.html`)
  await shown(page)
  const element = page.locator('circle-voronoi')
  const figure = element.getByRole('application')
  const told = () => page.evaluate(() => (globalThis as unknown as { told: string[] }).told.splice(0))
  expect(await circlesOf(page)).toEqual([0, 0, 2, 10, 0, 1, 5, 8, 1.5, 4, 3, 0.5])
  expect(await told()).toEqual(['circleschange of circle-voronoi', 'diagramchange of circle-voronoi'])
  expect(await page.evaluate(() => (globalThis as unknown as { shift: () => number }).shift())).toBe(0)
  // Each file is loaded once, except files that two threads share.
  const [wasm, ...more] = asked.filter((url) => url.endsWith('.wasm'))
  expect(wasm).toMatch(/dist\/lib\/generated\/circle-voronoi\.wasm$/)
  expect(more).toEqual([])
  expect(asked.filter((url) => !/\/(examples\/element\/strict|dist\/element|dist\/lib)\//.test(url))).toEqual([])
  expect(asked.filter((url) => url.includes('/player-'))).toEqual([])
  await expect(figure).toHaveAccessibleName('Four circles, their diagram and their hull')
  await expect(figure).toHaveAccessibleDescription(/^4 circles; the diagram has 3 vertices and 6 edges\. Enter: select/)
  expect(await violationsOf(page)).toEqual([])

  // The page scrolls over the figure until the figure is pressed.
  await page.setViewportSize({ width: 1280, height: 500 })
  const { x, y } = await placeOf(page, 3)
  await page.mouse.move(x, y)
  await scrollBy(page, () => page.mouse.wheel(0, 60))
  expect(await page.evaluate(() => scrollY)).toBeGreaterThan(0)
  await expect(element.locator('.hint')).toHaveText(/^Ctrl and the wheel zoom/)
  const viewOf = () => element.evaluate((element: Element) => element.getState().view)
  expect(await viewOf()).toBeUndefined()
  await page.evaluate(() => scrollTo(0, 0))
  await page.mouse.click(x, y)
  await page.mouse.wheel(0, -60)
  await soon(viewOf).toBeDefined()
  expect(await page.evaluate(() => scrollY)).toBe(0)
  await page.keyboard.press('Escape')
  await page.keyboard.press('0')
  await soon(viewOf).toBeUndefined()
  await page.setViewportSize({ width: 1280, height: 800 })

  await told()
  await expectToBeLive(page)
  expect(new Set(await told())).toEqual(
    new Set(['circleschange', 'diagramchange', 'selectionchange'].map((name) => `${name} of circle-voronoi`)),
  )
  await figure.focus()
  const selectedCount = () => element.evaluate((element: Element) => element.selection.length)
  await page.keyboard.press('Escape')
  await soon(selectedCount).toBe(0)
  await page.keyboard.press('Enter')
  await soon(selectedCount).toBe(1)
  const [selected] = await element.evaluate((element: Element) => element.selection)
  await page.keyboard.press('ArrowRight')
  const atFirst = [0, 0, 2, 10, 0, 1, 5, 8, 1.5, 4, 3, 0.5]
  await soon(async () => (await circlesOf(page))[3 * (selected as number)]).toBeGreaterThan(
    atFirst[3 * (selected as number)] as number,
  )
  await page.keyboard.press('Delete')
  await soon(async () => (await circlesOf(page)).length).toBe(9)
  await element.getByRole('button', { name: 'Undo' }).click()
  await element.getByRole('button', { name: 'Undo' }).click()
  await soon(() => circlesOf(page)).toEqual(atFirst)

  // A saved state is restored, also from JSON, and exported as a drawing.
  const kept = await element.evaluate(async (element: Element) => {
    const state = JSON.parse(JSON.stringify(element.getState()))
    element.circles = [
      [0, 0, 1],
      [5, 0, 1],
    ] as unknown as number[][]
    await element.updateComplete
    const others = [...element.circles]
    await element.setState(state)
    element.setAttribute('method', 'touching-disc')
    const { certificate } = await element.compute()
    const image = await element.toPNG(2)
    return { others, svg: await element.toSVG(), certified: certificate.certified, type: image.type }
  })
  expect(kept.others).toEqual([0, 0, 1, 5, 0, 1])
  expect(await circlesOf(page)).toEqual(atFirst)
  expect(kept).toMatchObject({ certified: true, type: 'image/png' })
  expect(kept.svg.match(/<path/g)?.length).toBeGreaterThan(4)
  expect(kept.svg).toContain('rgb(46, 125, 50)')

  // The colors follow the page's colors.
  const corner = () =>
    element.evaluate(async (element: Element) => {
      await element.updateComplete
      const copy = new OffscreenCanvas(1, 1)
      const context = copy.getContext('2d') as OffscreenCanvasRenderingContext2D
      context.drawImage(element.shadowRoot?.querySelector('canvas') as HTMLCanvasElement, -5, -200)
      return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3)
    })
  const light = await corner()
  await page.emulateMedia({ colorScheme: 'dark' })
  await soon(async () => Math.max(...(await corner()))).toBeLessThan(140)
  expect(Math.min(...light)).toBeGreaterThan(150)
  expect(await violationsOf(page)).toEqual([])
  await page.emulateMedia({ colorScheme: 'light' })

  // Errors are reported and change nothing.
  await told()
  await element.evaluate((element: Element) => element.setAttribute('layers', 'hull nonsense'))
  expect(await told()).toEqual(['error of circle-voronoi'])
  await expect(element.getByRole('alert')).toHaveText(/^There is no layer nonsense\. The layers are circles, /)
  const refused = await element.evaluate((element: Element) =>
    element.setState({ circles: [[0, 0, -1]] }).catch((error: Error) => error.message),
  )
  expect(refused).toMatch(/negative/)
  expect(await circlesOf(page)).toEqual(atFirst)

  // A read-only figure. The error would cover circles.
  await element.evaluate((element: Element) => {
    element.setAttribute('layers', 'hull')
    element.readonly = true
  })
  await expect(element.getByRole('button', { name: 'Undo' })).toHaveCount(0)
  await drag(page, 1, -40, 30)
  await page.keyboard.press('0')
  await page.keyboard.press('Enter')
  await page.keyboard.press('Delete')
  await soon(() => element.evaluate((element: Element) => element.selection.length)).toBe(1)
  // Its thread answers after all earlier requests.
  await element.evaluate((element: Element) => element.toSVG())
  expect(await circlesOf(page)).toEqual(atFirst)
  expect(problems).toEqual([])
})

test('in one file from another origin, of which nothing else is asked', async ({ page }) => {
  const elsewhere = await serve(ROOT, undefined)
  const { origin } = new URL(elsewhere.address)
  const here = await serve(
    ROOT,
    `default-src 'none'; script-src ${origin} blob: 'wasm-unsafe-eval'; worker-src ${origin} blob:; connect-src 'self'; img-src data:`,
  )
  try {
    const { problems, asked } = watch(page)
    writeExample('bundle.html', exampleOf('bundle').replaceAll('../../../', elsewhere.address))
    await page.goto(`${here.address}${PAGES}/bundle.html`)
    await expectToBeLive(page)
    // Requested by the page and by the thread.
    expect(new Set(asked.filter((url) => url.startsWith(origin)))).toEqual(
      new Set([`${origin}/dist/element/classic.js`]),
    )
    expect(problems).toEqual([])
    expect(await violationsOf(page)).toEqual([])
  } finally {
    await elsewhere.close()
    await here.close()
  }
})

test('one file draws power diagrams, wherever its thread comes from', async ({ page }) => {
  const elsewhere = await serve(ROOT, undefined)
  const here = await serve(ROOT, "default-src * blob: data: 'unsafe-inline' 'wasm-unsafe-eval'")
  try {
    for (const address of [here.address, elsewhere.address]) {
      writeExample(
        'power.html',
        `<!doctype html><html lang="en"><title>Power</title><link rel="icon" href="data:,">
        <script type="module" src="${address}dist/element/classic.js"></script>
        <circle-voronoi circles="${THREE}"></circle-voronoi>`,
      )
      const { problems } = watch(page)
      await page.goto(`${here.address}${PAGES}/power.html`)
      await shown(page)
      const drawn = () => page.locator('circle-voronoi').evaluate((element: Element) => element.toSVG())
      const before = (await drawn()).match(/<path/g)?.length ?? 0
      await page.locator('circle-voronoi').evaluate((element: Element) => element.setAttribute('layers', 'power'))
      await soon(async () => (await drawn()).match(/<path/g)?.length).toBeGreaterThan(before)
      expect(problems).toEqual([])
    }
  } finally {
    await elsewhere.close()
    await here.close()
  }
})

test('the module and its thread from another origin', async ({ page }) => {
  const elsewhere = await serve(ROOT, undefined)
  const { origin } = new URL(elsewhere.address)
  const here = await serve(
    ROOT,
    `default-src 'none'; script-src ${origin} blob: 'wasm-unsafe-eval'; worker-src ${origin} blob:; connect-src ${origin}; style-src 'self' 'unsafe-inline'; img-src data:`,
  )
  try {
    const { problems } = watch(page)
    writeExample('plain.html', exampleOf('plain').replaceAll('../../../', elsewhere.address))
    await page.goto(`${here.address}${PAGES}/plain.html`)
    await expectToBeLive(page)
    expect(problems).toEqual([])
  } finally {
    await elsewhere.close()
    await here.close()
  }
})

test('the method step by step, in the figure that plays it and where a text tells of it', async ({ page }) => {
  const { problems, asked } = watch(page)
  await page.addInitScript(() => {
    const told: string[] = []
    document.addEventListener('stepchange', (event) => {
      const { detail, target } = event as CustomEvent<{ step: number; steps: number }>
      told.push(`${(target as Element).id} ${detail.step}/${detail.steps}`)
    })
    Object.assign(globalThis, { told })
  })
  await page.goto(`${server.address}examples/element/player/index.html`)
  await shown(page)
  const played = page.locator('#played')
  const slider = played.getByRole('slider', { name: 'Step' })
  const sentence = played.locator('.sentence')
  const stepOf = (id: string) => page.locator(id).evaluate((element: Element) => element.step)
  const hasDiagram = (id: string) =>
    page.locator(id).evaluate((element: Element) => element.toSVG().then((svg) => svg.length))
  await expect(sentence).toHaveText('There are 7 circles.')
  const steps = Number(await slider.getAttribute('max')) + 1
  const told = async (id: string) => {
    const all = await page.evaluate(() => (globalThis as unknown as { told: string[] }).told.splice(0))
    return all.filter((text) => text.startsWith(id))
  }
  expect((await told('played')).at(-1)).toBe(`played 0/${steps}`)
  expect(asked.filter((url) => /\/player-\w+\.js$/.test(url))).toHaveLength(1)
  expect(asked.filter((url) => url.endsWith('.wasm'))).toHaveLength(1)
  await slider.focus()
  await page.keyboard.press('ArrowRight')
  await expect(sentence).toContainText('The Delaunay graph of the centers')
  expect(await stepOf('#played')).toBe(1)
  expect(await told('played')).toEqual([`played 1/${steps}`])
  expect(await violationsOf(page)).toEqual([])

  // Playback by script continues until it is stopped, and the state contains the step.
  const kept = await played.evaluate(async (element: Element) => {
    await element.stepTo(20)
    await element.play()
    await new Promise((resolve) => element.addEventListener('stepchange', resolve, { once: true }))
    element.pause()
    const state = element.getState()
    await element.stepTo(1e6)
    const last = element.step
    await element.setState(JSON.parse(JSON.stringify(state)))
    await element.updateComplete
    return { state, last, step: element.step }
  })
  expect(kept).toMatchObject({ state: { step: 21 }, last: steps - 1, step: 21 })
  expect(kept.state.layers).toEqual({})
  const refused = await played.evaluate((element: Element) => element.stepTo(-1).catch((error: Error) => error.message))
  expect(refused).toBe('A step is a whole number from 0, not -1.')

  // Edited circles are played from the start, but stages and the end stay where they are.
  await played.getByRole('application').focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press('ArrowRight')
  await expect(sentence).toHaveText('There are 7 circles.')
  await played.evaluate((element: Element) => element.stepTo(3))
  await page.keyboard.press('Delete')
  await expect(sentence).toHaveText(/ \d+ samples lie/)
  await soon(async () => (await circlesOf(page)).length).toBe(18)
  await played.evaluate((element: Element) => element.stepTo(1e6))
  await page.keyboard.press('Control+z')
  await expect(slider).toHaveAttribute('max', String(steps - 1))
  await expect(sentence).toContainText('The judge proves the diagram.')
  // Plays flips, then stops.
  await played.evaluate((element: Element) => {
    element.method = 'auto'
  })
  await expect(sentence).toHaveText('There are 7 circles.')
  await page.keyboard.press('Escape')
  await played.evaluate((element: Element) => element.stepTo(2))
  await expect(sentence).toHaveText(/^\d+ triangles, each with the disc/)
  const withoutDiagram = await hasDiagram('#played')
  await played.evaluate((element: Element) => {
    element.controls = false
  })
  await expect(sentence).toHaveCount(0)
  expect(await stepOf('#played')).toBeUndefined()
  expect(await hasDiagram('#played')).not.toBe(withoutDiagram)
  await told('')

  // Without the player, the status is read from the text.
  const other = page.locator('#told')
  await other.evaluate(async (element: Element) => {
    element.scrollIntoView()
    await element.ready
    await element.updateComplete
  })
  expect(await stepOf('#told')).toBe(3)
  await expect(other.locator('.player')).toBeHidden()
  await page.getByRole('button', { name: 'pairs' }).click()
  await soon(async () => (await told('told')).at(-1)).toMatch(/^told 5\//)
  const pairs = await other.evaluate((element: Element) => element.toSVG())
  await page.getByRole('button', { name: 'diagram' }).click()
  await soon(() => stepOf('#told')).toBeUndefined()
  expect(await other.evaluate((element: Element) => element.toSVG())).not.toBe(pairs)
  // A picture waits for the requested step.
  const again = await other.evaluate((element: Element) => {
    element.step = 5
    return element.toSVG()
  })
  expect(again).toBe(pairs)
  expect(problems).toEqual([])
})

test('a question in a form: it is sent once the circles are as asked, and begun again', async ({ page }) => {
  const { problems } = watch(page)
  await page.goto(`${server.address}examples/element/quiz/index.html`)
  await shown(page)
  const element = page.locator('circle-voronoi')
  const output = page.locator('output')
  const atFirst = await circlesOf(page)
  await expect(element.getByRole('application')).toHaveAccessibleDescription(/Not solved yet\./)
  await page.getByRole('button', { name: 'Submit' }).click()
  await expect(output).toBeEmpty()
  expect(await element.evaluate((element: Element) => [element.checkValidity(), element.validationMessage])).toEqual([
    false,
    'Not solved yet.',
  ])
  // The distant circle no longer borders on the small one.
  await drag(page, 3, 150, 0)
  await soon(() => element.evaluate((element: Element) => element.checkValidity())).toBe(true)
  await page.getByRole('button', { name: 'Submit' }).click()
  await expect(output).toHaveText('Handed in: 5 circles, right.')
  await page.getByRole('button', { name: 'Reset' }).click()
  await soon(() => circlesOf(page)).toEqual(atFirst)
  await soon(() => element.evaluate((element: Element) => element.checkValidity())).toBe(false)
  // A disabled form disables the figure.
  await page.evaluate(() => {
    const fields = document.createElement('fieldset')
    const form = document.querySelector('form') as HTMLFormElement
    fields.append(...form.childNodes)
    fields.disabled = true
    form.append(fields)
  })
  await shown(page)
  await drag(page, 3, 150, 0)
  // The drawing follows all earlier edits.
  await element.evaluate((element: HTMLElementTagNameMap['circle-voronoi']) => element.toSVG())
  expect(await circlesOf(page)).toEqual(atFirst)
  expect(problems).toEqual([])
})

test('in Markdown, from a file', async ({ page }) => {
  const { problems } = watch(page)
  buildSite(join(ROOT, PAGES, 'markdown'), '../../../dist/element/index.js')
  await page.goto(`${server.address}${PAGES}/markdown/index.html`)
  await shown(page)
  expect((await circlesOf(page)).slice(0, 3)).toEqual([1, 1, 0.4])
  expect(await circlesOf(page)).toHaveLength(27)
  const fallback = page.locator('circle-voronoi').locator('.fallback')
  await expect(fallback).toHaveCSS('visibility', 'hidden')
  const { x, y } = await placeOf(page, 4)
  await page.mouse.click(x, y)
  await soon(() => page.locator('circle-voronoi').evaluate((element: Element) => element.selection)).toEqual([4])
  expect(problems).toEqual([])
})

for (const name of ['react', 'vue']) {
  test(`with ${name}, which hears of the circles and sets them`, async ({ page }) => {
    const outDir = join(ROOT, PAGES, name)
    await build({
      root: join(ROOT, `examples/element/${name}`),
      configFile: false,
      logLevel: 'error',
      base: './',
      define: {
        __VUE_OPTIONS_API__: 'true',
        __VUE_PROD_DEVTOOLS__: 'false',
        __VUE_PROD_HYDRATION_MISMATCH_DETAILS__: 'false',
      },
      build: { outDir, emptyOutDir: true, target: 'es2022', assetsInlineLimit: 0 },
    })
    const { problems, asked } = watch(page)
    await page.goto(`${server.address}${PAGES}/${name}/index.html`)
    await expect(page.locator('output')).toHaveText('3 circles, 3 edges')
    await expectToBeLive(page)
    expect(asked.filter((url) => url.endsWith('.wasm'))).toHaveLength(1)
    await page.locator('circle-voronoi').evaluate((element: Element) => {
      element.circles = [...Array(5).keys()].map((k) => ({ x: k * k, y: 3 * k, r: 1 }))
    })
    await expect(page.locator('output')).toHaveText(/^5 circles/)
    await page.getByRole('button', { name: 'Reset' }).click()
    await expect(page.locator('output')).toHaveText('3 circles, 3 edges')
    expect(problems).toEqual([])
  })
}

const BLOCKS = blocksRunBy('tests/pack/element.spec.ts')
const inLanguage = (name: string) => BLOCKS.filter(({ language }) => language === name).map(({ code }) => code)

test('from an esbuild build, as docs/element.md says', async ({ page }) => {
  const { problems } = watch(page)
  const [source, ...others] = inLanguage('js') as [string]
  const [command, ...more] = (inLanguage('sh')[0] as string).trim().split(' ')
  expect([others, command]).toEqual([[], 'esbuild'])
  // Replaces the installed package by this repository.
  const args = more.map((arg) => arg.replace('node_modules/circle-voronoi/', join(ROOT, '/')))
  writeExample('esbuild/page.js', source)
  writeExample(
    'esbuild/build/index.html',
    `<!doctype html><html lang="en"><title>esbuild</title><link rel="icon" href="data:,">
    <script type="module" src="page.js"></script><circle-voronoi circles="${THREE}"></circle-voronoi>`,
  )
  const cwd = join(ROOT, PAGES, 'esbuild')
  const { status, stderr } = spawnSync(join(ROOT, 'node_modules/.bin/esbuild'), args, { cwd, encoding: 'utf8' })
  expect(status).toBe(0)
  expect(stderr).not.toContain('WARNING')
  await page.goto(`${server.address}${PAGES}/esbuild/build/index.html`)
  await expectToBeLive(page)
  await expectAllModules(page)
  expect(problems).toEqual([])
})

/** Maps the element to the module that the page has loaded already. */
const elementOfPage: Plugin = {
  name: 'element-of-page',
  setup({ onResolve }) {
    onResolve({ filter: /^circle-voronoi\/element$/ }, () => ({ path: '../../dist/element/index.js', external: true }))
  },
}

for (const [k, code] of inLanguage('jsx').entries()) {
  test(`in React as docs/element.md says: ${k + 1}`, async ({ page }) => {
    const { problems } = watch(page)
    const [imports = ''] = /^import .*$/m.exec(code) ?? []
    const rest = code.replace(imports, '').trim()
    const body = rest.startsWith('<') ? `return (${rest})` : rest
    const source = `${imports}
      import { useEffect, useRef, useState } from 'react'
      import { createRoot } from 'react-dom/client'
      function Page() {
        const [circles, setCircles] = useState(${THREE})
        globalThis.state = { circles, setCircles }
        ${body}
      }
      createRoot(document.querySelector('#root')).render(<Page />)`
    await bundle({
      stdin: { contents: source, loader: 'jsx', resolveDir: ROOT },
      jsx: 'automatic',
      bundle: true,
      format: 'esm',
      outfile: join(ROOT, PAGES, 'react-block.js'),
      plugins: [elementOfPage],
    })
    await open(page, 'react-block', '<div id="root"></div><script type="module" src="react-block.js"></script>')
    await expectToBeLive(page)
    const seen = await page.evaluate(async () => {
      const { state } = globalThis as unknown as { state: { circles: object; setCircles(circles: object): void } }
      const isOfEvent = state.circles instanceof Float64Array
      state.setCircles([[7, 7, 7]])
      return isOfEvent
    })
    expect(seen).toBe(true)
    await soon(() => circlesOf(page)).toEqual([7, 7, 7])
    expect(problems).toEqual([])
  })
}

test('made by a script that is imported later, as in notebooks', async ({ page }) => {
  const { problems } = watch(page)
  const here = await serve(ROOT, `${EXAMPLE_POLICY}; worker-src blob:`)
  page.once('close', () => void here.close())
  await page.goto(`${here.address}examples/element/notebook/index.html`)
  await expect(page.locator('output')).toHaveText('0.7')
  await expectToBeLive(page)
  // Moving, removing and inserting the figure again keeps its state.
  const { circles, isMoved } = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    element.circles = [
      [0, 0, 1],
      [4, 0, 1],
      [0, 5, 1],
    ]
    await element.updateComplete
    const [canvas] = (element.shadowRoot as ShadowRoot).querySelectorAll('canvas')
    document.body.append(element)
    await new Promise((resolve) => setTimeout(resolve))
    const isMoved = canvas === element.shadowRoot?.querySelector('canvas')
    element.remove()
    await new Promise((resolve) => setTimeout(resolve))
    const left = element.shadowRoot?.querySelectorAll('canvas').length
    if (left !== 0) throw new Error('It still has a view.')
    document.body.append(element)
    while (element.shadowRoot?.querySelectorAll('canvas').length === 0)
      await new Promise((resolve) => setTimeout(resolve, 20))
    await element.updateComplete
    return { circles: [...element.circles], isMoved }
  })
  expect(circles).toEqual([0, 0, 1, 4, 0, 1, 0, 5, 1])
  expect(isMoved).toBe(true)
  expect(problems).toEqual([])
})

test('what it says stays: numbers, a check that undo meets again, states, and what is wrong', async ({ page }) => {
  const { problems } = watch(page)
  writeExample(
    'staying.html',
    `<!doctype html><html lang="en"><title>Staying</title><link rel="icon" href="data:,">
    <script type="module" src="../../dist/element/index.js"></script>
    <circle-voronoi circles="[[0,0,2],[10,0,1],[5,8,1.5],[5,3,1]]" check='{"cell": 3, "neighbor": 2}' controls></circle-voronoi>`,
  )
  await page.goto(`${server.address}${PAGES}/staying.html`)
  await shown(page)
  const element = page.locator('circle-voronoi')
  const told = () =>
    element.evaluate((element: Element) => [[...element.ids], [...element.selection], element.checkValidity()])
  // Circles 3 and 2 are deleted and restored. They have new internal ids and another order then.
  await element.evaluate((element: Element) => {
    element.focus()
    element.selection = [2, 3]
  })
  await soon(told).toEqual([[0, 1, 2, 3], [2, 3], true])
  await page.keyboard.press('Delete')
  await soon(told).toEqual([[0, 1], [], false])
  await page.keyboard.press('Control+z')
  await soon(async () => ((await told()) as number[][])[1]?.toSorted()).toEqual([2, 3])
  await soon(async () => (await told())[2]).toBe(true)
  const [ids] = await told()
  expect((ids as number[]).toSorted()).toEqual([0, 1, 2, 3])
  await element.evaluate((element: Element) => {
    element.selection = [3]
  })
  await soon(() => element.evaluate((element: Element) => element.selection)).toEqual([3])
  const y = await element.evaluate(
    (element: Element) => element.circles[3 * [...element.ids].indexOf(element.selection[0] as number) + 1],
  )
  expect(y).toBe(3)
  // Reading a property must not be taken as a sign that it is unchanged.
  const set = await element.evaluate(async (element: Element) => {
    const { circles } = element
    circles[2] = 1
    element.circles = circles
    await element.updateComplete
    return element.circles[2]
  })
  expect(set).toBe(1)

  const problem = element.locator('[part~="problem"]')
  await element.evaluate((element: Element) => element.setAttribute('layers', 'nonsense'))
  await expect(problem).toHaveText(/^There is no layer nonsense\. The layers are circles, /)
  const { x, y: above } = (await element.boundingBox()) as { x: number; y: number }
  for (const step of [20, 60, 100, 140]) await page.mouse.move(x + step, above + step)
  await expect(problem).toHaveText(/^There is no layer nonsense\. The layers are circles, /)
  await element.evaluate((element: Element) => element.setAttribute('layers', ''))

  const states = await element.evaluate(async (element: Element) => {
    const circles = [
      [0, 0, 1],
      [4, 0, 1],
      [0, 5, 1],
    ]
    await element.setState({ circles, view: { x: 1, y: 1, span: 9 }, layers: { hull: true }, step: 1, method: 'auto' })
    await element.updateComplete
    const before = element.getState()
    const place = element.parentElement as HTMLElement
    element.remove()
    await new Promise((resolve) => setTimeout(resolve))
    const away = element.getState()
    place.append(element)
    await element.toSVG()
    return [before, away, element.getState()]
  })
  expect(states[0]).toMatchObject({ layers: { hull: true }, step: 1, method: 'auto' })
  const { view, ...rest } = states[0] as FigureState
  for (const state of states.slice(1)) {
    expect(state).toMatchObject(rest)
    expect(state.view?.span).toBeCloseTo(view?.span as number, 9)
  }

  const gone = await element.evaluate(async (element: Element) => {
    element.remove()
    await new Promise((resolve) => setTimeout(resolve))
    return element.toSVG().catch(({ message }: Error) => message)
  })
  expect(gone).toBe('The figure is in no page, or no longer.')
  expect(problems).toEqual([])
})

const SQUARE = 'POLYGON ((-2 -2, 12 -2, 12 10, -2 10), (4 3, 6 3, 6 5, 4 5))'

for (const file of ['index', 'classic']) {
  test(`with a region and areas: cut, fitted, edited and kept, as ${file}.js`, async ({ page }) => {
    const { problems, asked } = watch(page)
    writeExample('square.wkt', SQUARE)
    writeExample(
      'regions.html',
      `<!doctype html><html lang="en"><title>Regions</title><link rel="icon" href="data:,">
      <script type="module" src="../../dist/element/${file}.js"></script>
      <style>circle-voronoi { width: 600px; height: 400px }</style>
      <circle-voronoi circles="${THREE}" view="5 4 20"></circle-voronoi>`,
    )
    const here = await serve(ROOT, `${EXAMPLE_POLICY}; worker-src 'self' blob:`)
    page.once('close', () => void here.close())
    await page.goto(`${here.address}${PAGES}/regions.html`)
    await shown(page)
    const element = page.locator('circle-voronoi')
    const { x, y } = (await element.boundingBox()) as { x: number; y: number }
    // Unneeded modules are not loaded.
    expect(asked.filter((url) => url.includes('regions'))).toHaveLength(1)
    /** The color at a point of the plane. */
    const colorAt = (px: number, py: number) =>
      element.evaluate(
        async (element: Element, place) => {
          await element.updateComplete
          const image = await createImageBitmap(await element.toPNG(1))
          const context = new OffscreenCanvas(image.width, image.height).getContext('2d')
          context?.drawImage(image, 0, 0)
          return [...(context?.getImageData(place[0], place[1], 1, 1).data ?? [])].slice(0, 3).join()
        },
        [300 + 20 * (px - 5), 200 - 20 * (py - 4)] as const,
      )
    const PAPER = '250,248,244'
    const [far, hole] = [
      [-5, 2],
      [5, 4],
    ] as const
    expect([await colorAt(...far), await colorAt(...hole)]).not.toContain(PAPER)

    // Reads the region from a file, whose address is in the attribute.
    await element.evaluate((element: Element) => element.setAttribute('region', 'square.wkt'))
    expect([await colorAt(...far), await colorAt(...hole)]).toEqual([PAPER, PAPER])
    expect(await colorAt(1, 8)).not.toBe(PAPER)
    expect(await element.evaluate((element: Element) => element.toSVG())).toMatch(/<clipPath id="[\w-]+">/)

    // Areas as shares of 164.
    const becomes = async (cell: number, area: number) => {
      const check = { cell, area: { min: area * (1 - 1e-6), max: area * (1 + 1e-6) } }
      // The check is answered before the picture is painted.
      await element.evaluate((element: Element, check) => {
        element.check = check
        return element.toSVG()
      }, check)
      await soon(() => element.evaluate((element: Element) => element.matches(':state(met)'))).toBe(true)
    }
    await element.evaluate((element: Element) => {
      element.areas = [1, 1, 2]
    })
    await becomes(2, 82)
    const radii = () => element.evaluate((element: Element) => [...element.circles].filter((_, k) => k % 3 === 2))
    const before = await radii()
    await page.mouse.move(x + 300 + 100, y + 200 + 80)
    await page.mouse.down()
    await page.mouse.move(x + 300 + 120, y + 200 + 60)
    await page.mouse.move(x + 300 + 140, y + 200 + 40)
    await page.mouse.up()
    await soon(radii).not.toEqual(before)
    await becomes(1, 41)
    await becomes(2, 82)
    await element.evaluate((element: Element) => element.focus())
    await page.keyboard.press('Control+z')
    await soon(radii).toEqual(before)

    // The state and the link contain the values. An invalid value is reported, and the rest stays.
    const state: FigureState = await element.evaluate((element: Element) => element.getState())
    expect(state).toMatchObject({ areas: [1, 1, 2], region: { type: 'MultiPolygon' } })
    const link = await encodeLink(state)
    const others = await element.evaluate(async (element: Element, link) => {
      element.check = null
      const errors: string[] = []
      element.addEventListener('error', ({ detail }) => errors.push(detail.error.message))
      await element.setState({ circles: [[0, 0, 1]] })
      const none = element.getState()
      await element.setState(link)
      const kept = element.getState()
      element.region = [
        [
          [0, 0],
          [4, 4],
          [4, 0],
          [0, 4],
        ],
      ]
      await element.updateComplete
      return { none, kept, errors, last: element.getState() }
    }, link)
    expect(others.none).toEqual({ circles: [[0, 0, 1]], layers: {} })
    expect({ ...others.kept, view: undefined }).toEqual({ ...state, view: undefined })
    expect(others.errors).toEqual([
      'Side 0 of ring 0 of the region and side 2 of ring 0 of the region cross at (2, 2).',
    ])
    expect(others.last.region).toEqual(others.kept.region)
    expect(problems).toEqual([])
  })
}

test('given the bytes: by its own name, and the method is played', async ({ page }) => {
  const { problems, asked } = watch(page)
  writeExample(
    'bytes.js',
    `import { defineCircleVoronoi } from '../../dist/element/define.js'
    const bytes = fetch('../../dist/lib/generated/circle-voronoi.wasm').then((response) => response.arrayBuffer())
    defineCircleVoronoi({ wasm: bytes })
    defineCircleVoronoi({ wasm: bytes, name: 'my-circles' })`,
  )
  writeExample(
    'bytes.html',
    `<!doctype html><html lang="de"><title>Bytes</title><link rel="icon" href="data:,"><script type="module" src="bytes.js"></script>
    <circle-voronoi circles="[[0,0,2],[10,0,1],[5,8,1.5]]" controls></circle-voronoi>
    <my-circles circles="[[0,0,2],[10,0,1],[5,8,1.5]]" step="1"></my-circles>`,
  )
  await page.goto(`${server.address}${PAGES}/bytes.html`)
  await expectToBeLive(page)
  const other = page.locator('my-circles')
  const state = await other.evaluate(async (element: Element) => {
    await element.ready
    await element.stepTo(2)
    return element.getState()
  })
  expect(state).toEqual({
    circles: [
      [0, 0, 2],
      [10, 0, 1],
      [5, 8, 1.5],
    ],
    layers: {},
    step: 2,
  })
  expect(asked.filter((url) => url.endsWith('.wasm'))).toHaveLength(1)
  // The buttons use the language of the page.
  await expect(page.getByRole('button', { name: 'Rückgängig' })).toBeVisible()
  await expect(page.locator('circle-voronoi').getByRole('application')).toHaveAccessibleDescription(
    /^3 Kreise; das Diagramm hat 1 Ecke und 3 Kanten\. Enter: wählt/,
  )
  expect(problems).toEqual([])
})

test('in a frame, which opens what a link says', async ({ page }) => {
  const { problems } = watch(page)
  await page.goto(`${server.address}examples/element/iframe/index.html`)
  const frame = page.frameLocator('iframe')
  const element = frame.locator('circle-voronoi')
  await soon(() => element.evaluate((element: Element) => element.circles.length)).toBe(12)
  await element.evaluate((element: Element) => element.updateComplete)
  await expect(frame.getByRole('link', { name: 'Open' })).toHaveAttribute('href', /^\.\/#v1\./)
  await element.getByRole('application').focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press('Delete')
  await soon(() => element.evaluate((element: Element) => element.circles.length)).toBe(9)
  // A link to a step opens the player there.
  const link = await encodeLink({ circles: Float64Array.of(0, 0, 2, 10, 0, 1, 5, 8, 1.5), step: 3 })
  await page.goto(`${server.address}dist/site/embed.html#${link}`)
  await expect(page.locator('circle-voronoi').locator('.sentence')).toHaveText(/ \d+ samples lie/)
  expect(problems).toEqual([])
})

test('twenty figures share a module and a thread, and give back what is far away', async ({ page }, info) => {
  const { problems, asked } = watch(page)
  const figures = Array.from(
    { length: 20 },
    (_, k) => `<p>${k}</p><circle-voronoi circles="[[0,0,2],[10,0,1],[5,8,1.5],[${k},3,0.5]]"></circle-voronoi>`,
  )
  writeExample(
    'twenty.html',
    `<!doctype html><html lang="en"><title>Twenty</title><link rel="icon" href="data:,">
    <link rel="stylesheet" href="../../dist/element/element.css">
    <script type="module" src="../../dist/element/index.js"></script>${figures.join('')}`,
  )
  // Instances are visible only to the code that creates them.
  await page.route('**/painter.js', async (route) => {
    const response = await route.fetch()
    const body = `{
      const { instantiate } = WebAssembly
      globalThis.instances = []
      WebAssembly.instantiate = async (...given) => {
        const made = await instantiate(...given)
        instances.push(made.instance ?? made)
        return made
      }
    }
    ${await response.text()}`
    await route.fulfill({ response, body })
  })
  await page.goto(`${server.address}${PAGES}/twenty.html`)
  /** Pixels of canvases in figures that have any. */
  const pixels = () =>
    page
      .locator('circle-voronoi')
      .evaluateAll((elements) =>
        elements
          .map((element) =>
            [...(element.shadowRoot?.querySelectorAll('canvas') ?? [])].reduce(
              (sum, { width, height }) => sum + width * height,
              0,
            ),
          )
          .flatMap((count, k) => (count > 0 ? [k] : [])),
      )
  await soon(async () => (await pixels())[0]).toBe(0)
  await shown(page)
  expect((await pixels()).length).toBeLessThan(5)
  const seen = new Set<number>()
  const session = await page.context().newCDPSession(page)
  /** Memory of the page and its thread in MB, with WebAssembly counted once. */
  const memory = async () => {
    const own = await heapOf(session.send.bind(session) as Ask)
    const thread = await withThread(session, /\/painter\.js$/, heapOf)
    const sizes = await (page.workers()[0] as Worker).evaluate(() =>
      (globalThis as unknown as Instances).instances.flatMap(({ exports }) =>
        Object.values(exports).flatMap((value) =>
          value instanceof WebAssembly.Memory ? [value.buffer.byteLength] : [],
        ),
      ),
    )
    expect(sizes).toHaveLength(1)
    return { heaps: (own + thread) / 1e6, wasm: (sizes[0] as number) / 1e6 }
  }
  const memories: Awaited<ReturnType<typeof memory>>[] = []
  for (let k = 0; k < 20; k++) {
    await page
      .locator('circle-voronoi')
      .nth(k)
      .evaluate(async (element: Element) => {
        element.scrollIntoView()
        await element.ready
        await element.updateComplete
      })
    for (const each of await pixels()) seen.add(each)
    if (k === 9 || k === 19) memories.push(await memory())
  }
  const said = memories.map(
    ({ heaps, wasm }, k) =>
      `${10 * (k + 1)} figures: ${heaps.toFixed(1)} MB of heaps, ${wasm.toFixed(1)} MB of WebAssembly`,
  )
  info.annotations.push({ type: 'memory', description: said.join('; ') })
  const [ten, twenty] = memories as [(typeof memories)[0], (typeof memories)[0]]
  expect(twenty.wasm).toBe(ten.wasm)
  expect(twenty.wasm).toBeLessThan(20)
  expect(twenty.heaps).toBeLessThan(8)
  expect(twenty.heaps - ten.heaps).toBeLessThan(1)
  expect(seen.size).toBe(20)
  await soon(async () => (await pixels()).length).toBeLessThan(8)
  expect(await pixels()).not.toContain(0)
  expect(page.workers()).toHaveLength(1)
  expect(asked.filter((url) => url.endsWith('.wasm'))).toHaveLength(1)
  // The first figure still exists and gets its pixels back.
  await page.evaluate(() => scrollTo(0, 0))
  await soon(pixels).toContain(0)
  await expectToBeLive(page)
  // On paper no figure shows its fallback content. Figures without pixels are drawn as SVG.
  await page.emulateMedia({ media: 'print' })
  const printed = () =>
    page.locator('circle-voronoi').evaluateAll((elements) =>
      elements.map((element) => {
        const [fallback, drawing] = ['.fallback', '.paper > svg'].map((name) => element.shadowRoot?.querySelector(name))
        return [getComputedStyle(fallback as Element).visibility, drawing?.checkVisibility() === true]
      }),
    )
  // An emulated medium takes effect in the next frame.
  await soon(printed).toEqual(Array(20).fill(['hidden', true]))
  expect(problems).toEqual([])
})

test.describe('with fingers', () => {
  test.use({ hasTouch: true, viewport: { width: 360, height: 420 } })

  test('the page scrolls, unless there is a circle to be dragged; two zoom', async ({ page }) => {
    const { problems } = watch(page)
    await page.goto(`${server.address}examples/element/strict/index.html`)
    await shown(page)
    const session = await page.context().newCDPSession(page)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: readonly { x: number; y: number }[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map((point, id) => ({ ...point, id })) })
    const swipe = async ({ x, y }: { x: number; y: number }, dx: number, dy: number) => {
      // Sends both at once, because on a slow machine a resting finger would be a long press.
      await Promise.all([touch('touchStart', [{ x, y }]), touch('touchMove', [{ x: x + dx / 8, y: y + dy / 8 }])])
      for (let k = 2; k <= 8; k++) await touch('touchMove', [{ x: x + (dx * k) / 8, y: y + (dy * k) / 8 }])
      await touch('touchEnd', [])
    }
    const scrolled = () => page.evaluate(() => scrollY)
    const scroll = (act: () => Promise<void>) => scrollBy(page, act)
    const figure = page.locator('circle-voronoi')
    await scroll(() => figure.evaluate((element) => element.scrollIntoView({ block: 'start' })))
    const before = await scrolled()
    const small = await placeOf(page, 3)
    await swipe(small, 30, 24)
    // The circle is where the finger was lifted.
    await soon(async () => (await placeOf(page, 3)).x).toBeCloseTo(small.x + 30, 0)
    expect(await scrolled()).toBe(before)
    await scroll(() => page.evaluate(() => scrollTo(0, 0)))
    const moved = await circlesOf(page)
    const free = await placeOf(page, 2)
    await scroll(() => swipe({ x: free.x - 100, y: free.y + 10 }, 0, -90))
    expect(await scrolled()).toBeGreaterThan(40)
    expect(await circlesOf(page)).toEqual(moved)
    const { x, y } = await placeOf(page, 3)
    await touch('touchStart', [
      { x: x - 20, y },
      { x: x + 60, y },
    ])
    await touch('touchMove', [
      { x: x - 60, y },
      { x: x + 90, y },
    ])
    await touch('touchEnd', [])
    await soon(() =>
      page.locator('circle-voronoi').evaluate((element: Element) => element.getState().view),
    ).toBeDefined()
    expect(problems).toEqual([])
  })
})

test.describe('without scripts', () => {
  test.use({ javaScriptEnabled: false })

  test('its data is what is seen', async ({ page }) => {
    await page.goto(`${server.address}examples/element/strict/index.html`)
    await expect(page.getByRole('cell', { name: 'hazel' })).toBeVisible()
    const [caption, last] = [page.getByText('Each point belongs'), page.getByRole('row', { name: /hazel/ })]
    expect((await caption.boundingBox())?.y).toBeGreaterThan((await last.boundingBox())?.y as number)
  })
})

/** Opens a page with some markup and the element's module, which records events in `told`. */
async function open(page: Page, name: string, body: string, lang = 'en'): Promise<void> {
  await page.addInitScript(() => {
    const told: string[] = []
    document.addEventListener('error', (event) => {
      const { detail } = event as unknown as CustomEvent<{ error: Error }>
      if (detail) told.push(detail.error.message)
    })
    Object.assign(globalThis, { told })
  })
  writeExample(
    `${name}.html`,
    `<!doctype html><html lang="${lang}"><title>${name}</title><link rel="icon" href="data:,">
    <script type="module" src="../../dist/element/index.js"></script>${body}`,
  )
  await page.goto(`${server.address}${PAGES}/${name}.html`)
}

/** The errors since the last call. */
const errors = (page: Page): Promise<string[]> =>
  page.evaluate(() => (globalThis as unknown as { told: string[] }).told.splice(0))

test('an edit is kept where the text between the tags changes, unless the circles are from there', async ({ page }) => {
  await open(page, 'between', `<circle-voronoi circles="${THREE}">Before</circle-voronoi>`)
  await shown(page)
  const element = page.locator('circle-voronoi')
  await element.getByRole('application').focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press('Delete')
  await soon(async () => (await circlesOf(page)).length).toBe(6)
  const after = (text: string) =>
    element.evaluate(async (element: Element, text) => {
      element.textContent = text
      await new Promise((resolve) => setTimeout(resolve))
      await element.updateComplete
      return element.circles.length
    }, text)
  expect(await after('|1|1|1|')).toBe(6)
  await element.evaluate((element: Element) => element.removeAttribute('circles'))
  await soon(() => circlesOf(page)).toEqual([1, 1, 1])
  expect(await after('|1|1|1|\n|5|5|2|')).toBe(6)
  expect(await errors(page)).toEqual([])
})

test('a property that becomes undefined or null is not set', async ({ page }) => {
  const { problems, asked } = watch(page)
  await open(page, 'unset', `<circle-voronoi circles="${THREE}" layers="hull" view="5 4 30"></circle-voronoi>`)
  await shown(page)
  for (const nothing of [undefined, null]) {
    const seen = await page.locator('circle-voronoi').evaluate(async (element: Element, nothing) => {
      const properties = [
        'alt',
        'check',
        'controls',
        'lang',
        'method',
        'name',
        'readonly',
        'samples',
        'selection',
        'src',
        'step',
      ]
      const values = ['A', { circles: 3 }, '', 'de', 'flip', 'a', true, 2, [0], 'x.csv', 0]
      const any = element as unknown as Record<string, unknown>
      any.circles = [[1, 1, 1]]
      any.layers = { dual: true }
      any.view = { x: 1, y: 1, span: 4 }
      any.region = [
        [
          [0, 0],
          [9, 0],
          [9, 9],
        ],
      ]
      any.areas = [1]
      for (const [k, name] of properties.entries()) if (name !== 'src') any[name] = values[k]
      for (const name of [...properties, 'circles', 'layers', 'view', 'region', 'areas']) any[name] = nothing
      await element.updateComplete
      const { layers, view, region, areas } = element
      return {
        circles: [...element.circles],
        domain: [region, areas],
        attributes: element.getAttributeNames().sort(),
        layers: [layers.hull, layers.dual],
        view,
      }
    }, nothing)
    expect(seen).toEqual({
      circles: FLAT,
      domain: [undefined, undefined],
      attributes: ['circles', 'layers', 'view'],
      layers: [true, false],
      view: { x: 5, y: 4, span: 30 },
    })
  }
  expect(asked.filter((url) => /undefined|null/.test(url))).toEqual([])
  expect(await errors(page)).toEqual([])
  expect(problems).toEqual([])
})

test('a typo is told, with what is allowed instead, and changes nothing', async ({ page }) => {
  const { problems } = watch(page)
  const wrong = `layers="dsic" method="magic" controls="buttns" check='{"cell": 7, "edges": 3}'`
  await open(page, 'typos', `<circle-voronoi circles="${THREE}" ${wrong}></circle-voronoi>`)
  await shown(page)
  const element = page.locator('circle-voronoi')
  const alert = element.getByRole('alert')
  const sentences = {
    layer: /^There is no layer dsic\. The layers are circles, .*disc, /,
    cells: 'The layer cells must be auto, none, radius, area, filled, degree, gap, index or different (got "typo").',
    method: 'The method must be auto, touching-disc or flip (got "magic").',
    controls: 'The controls must be buttons or player, or both (got "buttns").',
    check: 'The check cannot be read: there is no circle 7. The circles have the ids 0 to 2.',
  }
  // The error remains after the circles have arrived.
  for (const text of [sentences.layer, sentences.method, sentences.controls, sentences.check])
    await expect(alert).toContainText(
      new RegExp(typeof text === 'string' ? text.replace(/[().]/g, '\\$&') : text.source.slice(1)),
    )
  expect(await errors(page)).toHaveLength(4)
  await element.evaluate((element: Element) => {
    for (const name of ['layers', 'method', 'controls', 'check']) element.removeAttribute(name)
  })
  await expect(alert).toBeHidden()
  const acts: [string, unknown, string | RegExp][] = [
    ['layers', { dsic: true }, sentences.layer],
    ['layers', { cells: 'typo' }, sentences.cells],
    ['layers', { hull: 1 }, 'The layer hull must be true or false (got 1).'],
    ['method', 'magic', sentences.method],
    ['controls', 'buttns', sentences.controls],
    ['check', { cell: 1, edgse: 3 }, /a cell has no edgse; it has .*edges/],
    [
      'check',
      { cell: 3, edges: 3 },
      'The check cannot be read: there is no circle 3. The circles have the ids 0 to 2.',
    ],
    ['circles', [[0, 0]], 'Circle 0: r is missing, because the array has 2 items.'],
    ['samples', 'many', 'The samples must be a whole number from 0 (got "many").'],
    ['view', { x: 1, y: 2 }, 'A view is three numbers: x, y and a span above 0.'],
  ]
  for (const [name, value, text] of acts) {
    await element.evaluate(
      (element: Element, [name, value]) => Object.assign(element, { [name as string]: value }),
      [name, value],
    )
    await expect(alert).toHaveText(text)
    await soon(async () => (await errors(page)).length).toBe(1)
    await element.evaluate((element: Element, name) => Object.assign(element, { [name]: undefined }), name)
    await expect(alert).toBeHidden()
  }
  // The value cannot be an attribute, and is dropped although the attribute is missing.
  await element.evaluate((element: Element) => {
    const parts: Check[] = []
    parts.push({ all: parts })
    element.check = { all: parts }
  })
  await expect(alert).toHaveText(/circular/)
  expect(await errors(page)).toHaveLength(1)
  await element.evaluate((element: Element) => Object.assign(element, { check: undefined }))
  await expect(alert).toBeHidden()
  await element.evaluate((element: Element) => element.setAttribute('layers', 'cells=typo'))
  await expect(alert).toHaveText(sentences.cells)
  expect(await errors(page)).toHaveLength(1)
  expect(await circlesOf(page)).toEqual(FLAT)
  expect(problems).toEqual([])
})

test('a selection that is set before the circles are there is that of the first picture', async ({ page }) => {
  await open(page, 'selection', '')
  const seen = await page.evaluate(async (circles) => {
    const element = document.createElement('circle-voronoi') as Element
    Object.assign(element, { circles, selection: [1] })
    await customElements.whenDefined('circle-voronoi')
    const told: number[][] = []
    element.addEventListener('selectionchange', ({ detail }) => told.push([...detail.selection]))
    const before = [...element.selection]
    document.body.append(element)
    await element.ready
    await new Promise(requestAnimationFrame)
    const first = [...element.selection]
    // The check refers to these other circles.
    element.circles = [...circles, [20, 20, 1]]
    element.selection = [3]
    await element.updateComplete
    await new Promise(requestAnimationFrame)
    return { before, first, other: [...element.selection], told: told.filter((ids) => ids.length > 0) }
  }, JSON.parse(THREE) as number[][])
  expect(seen).toEqual({ before: [1], first: [1], other: [3], told: [[1], [3]] })
  expect(await errors(page)).toEqual([])
})

test('a state that says nothing of circles leaves them, and what it does not say', async ({ page }) => {
  await open(page, 'states', `<circle-voronoi circles="${THREE}" layers="hull"></circle-voronoi>`)
  await shown(page)
  const states = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    await element.setState({})
    const nothing = element.getState()
    await element.setState({ view: { x: 4, y: 4, span: 20 } })
    const viewed = element.getState()
    await element.setState({ layers: { dual: true } })
    await element.setState({ edits: [{ kind: 'remove', id: 1 }] })
    return [nothing, viewed, element.getState()]
  })
  const circles = [
    [0, 0, 2],
    [10, 0, 1],
    [5, 8, 1.5],
  ]
  expect(states).toEqual([
    { circles, layers: { hull: true } },
    { circles, layers: { hull: true }, view: { x: 4, y: 4, span: 20 } },
    { circles: [circles[0], circles[2]], layers: { dual: true }, view: { x: 4, y: 4, span: 20 } },
  ])
})

test('where nothing can be computed, that is said, and what stands between the tags is shown', async ({ page }) => {
  const inside = `<p slot="poster">loading…</p><table><tr><td>0</td><td>0</td><td>2</td></tr></table>`
  await page.addInitScript(() => {
    if (!location.hash.includes('worker')) return
    globalThis.Worker = class {
      constructor() {
        throw new Error('There are no threads here.')
      }
    } as unknown as typeof Worker
  })
  await page.route('**/circle-voronoi.wasm', (route) => route.fulfill({ status: 404 }))
  await open(page, 'failing', `<circle-voronoi>${inside}</circle-voronoi>`)
  const alert = page.locator('circle-voronoi').getByRole('alert')
  for (const [hash, message] of [
    ['', /^The diagram could not be computed: The WebAssembly cannot be loaded from http:[^ ]+: [^.]*404[^.]*\.$/],
    ['#worker', 'The diagram could not be computed: There are no threads here.'],
  ] as const) {
    await page.goto('about:blank')
    await page.goto(`${server.address}${PAGES}/failing.html${hash}`)
    await shown(page)
    await expect(alert).toHaveText(message)
    const told = await errors(page)
    expect(told).toHaveLength(1)
    expect(told[0]).toMatch(message)
    await expect(page.getByText('loading…')).toBeHidden()
    await expect(page.getByRole('cell', { name: '2' })).toBeVisible()
    await expect(page.locator('circle-voronoi').locator('.fallback')).toBeVisible()
  }
})

test('no promise of an element stays open that is in no page', async ({ page }) => {
  await open(page, 'away', `<div style="height: 5000px"></div><circle-voronoi circles="${THREE}"></circle-voronoi>`)
  const settled = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    await customElements.whenDefined('circle-voronoi')
    const never = document.createElement('circle-voronoi')
    await never.ready
    const before = element.ready
    element.remove()
    await before
    await element.ready
    // The circles are shown once the figure is back in the page.
    document.body.prepend(element)
    await element.ready
    return [...element.circles]
  })
  expect(settled).toEqual(FLAT)
})

test('in one file inside the page itself', async ({ page }) => {
  const { problems, asked } = watch(page)
  const here = await serve(
    ROOT,
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:; img-src data:",
  )
  try {
    const bundle = readFileSync(join(ROOT, 'dist/element/classic.js'), 'utf8')
    writeExample(
      'inline.html',
      `<!doctype html><html lang="en"><title>Inline</title><link rel="icon" href="data:,">
      <script type="module">${bundle}</script><circle-voronoi circles="${THREE}" controls></circle-voronoi>`,
    )
    await page.goto(`${here.address}${PAGES}/inline.html`)
    await expectToBeLive(page)
    expect(asked.filter((url) => url.startsWith('http'))).toEqual([`${here.address}${PAGES}/inline.html`])
    expect(problems).toEqual([])
  } finally {
    await here.close()
  }
})

for (const build of ['index', 'classic']) {
  test(`in a frame that has no origin, by ${build}.js`, async ({ page }) => {
    const { problems } = watch(page)
    const here = await serve(ROOT, "default-src * data: blob: 'unsafe-inline' 'wasm-unsafe-eval'")
    try {
      writeExample(
        'framed.html',
        `<!doctype html><html lang="en"><title>Framed</title><link rel="icon" href="data:,">
        <script type="module" src="../../dist/element/${build}.js"></script><circle-voronoi circles="${THREE}"></circle-voronoi>`,
      )
      writeExample(
        'sandbox.html',
        `<!doctype html><html lang="en"><title>Sandbox</title><link rel="icon" href="data:,">
        <iframe sandbox="allow-scripts" src="framed.html" title="Figure" style="width: 600px; height: 400px"></iframe>`,
      )
      await page.goto(`${here.address}${PAGES}/sandbox.html`)
      const element = page.frameLocator('iframe').locator('circle-voronoi')
      const seen = await element.evaluate(async (element: Element) => {
        await element.ready
        await element.updateComplete
        return [...element.circles]
      })
      await expect(element.getByRole('alert')).toBeHidden()
      expect(seen).toEqual(FLAT)
      expect(problems).toEqual([])
    } finally {
      await here.close()
    }
  })
}

test('an application keeps the circles of events, and sets older ones again', async ({ page }) => {
  await open(page, 'kept', `<circle-voronoi circles="${THREE}"></circle-voronoi>`)
  await shown(page)
  const seen = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    const kept: Float64Array[] = []
    element.addEventListener('circleschange', ({ detail }) => kept.push(detail.circles))
    for (const x of [1, 2]) {
      element.circles = [[x, 0, 1]]
      await element.updateComplete
    }
    element.circles = kept[1] as Float64Array
    await element.updateComplete
    const count = kept.length
    element.circles = kept[0] as Float64Array
    await element.updateComplete
    return { count, first: [...element.circles] }
  })
  // The newest circles are shown already.
  expect(seen).toEqual({ count: 2, first: [1, 0, 1] })
})

test('layers that cannot be sent change nothing', async ({ page }) => {
  await open(page, 'unsendable', `<circle-voronoi circles="${THREE}" layers="hull"></circle-voronoi>`)
  await shown(page)
  const element = page.locator('circle-voronoi')
  const setting = (isDetached: boolean) =>
    element.evaluate((element: Element, isDetached) => {
      const points = new Float64Array([0, 0])
      if (isDetached) structuredClone(points, { transfer: [points.buffer] })
      const column = { name: 'b', values: new Float64Array(3), act: () => {} }
      element.layers = { dual: true, column, data: [{ id: 'a', color: 'red', points, act: () => {} } as never] }
      return [element.layers, element.getState().layers] as const
    }, isDetached)
  const layers = await setting(true)
  expect(layers[0]).toMatchObject({ hull: true, dual: false, column: undefined, data: [] })
  expect(layers[1]).toEqual({ hull: true })
  await expect(element.getByRole('alert')).toHaveText(/detached/)
  expect(await errors(page)).toHaveLength(1)
  // Unknown properties of layers are dropped.
  const [sent] = await setting(false)
  expect(sent).toMatchObject({ hull: false, dual: true })
  expect(Object.keys(sent.column ?? {})).toEqual(['name', 'values'])
  expect(Object.keys(sent.data[0] ?? {})).toEqual(['id', 'color', 'points'])
  await expect(element.getByRole('alert')).toBeHidden()
  expect(await errors(page)).toHaveLength(0)
})

test('what is drawn as an SVG and as a PNG is what is seen', async ({ page }) => {
  await open(
    page,
    'pictures',
    `<style>circle-voronoi { width: 300px; --circle-voronoi-paper: #ffe; --circle-voronoi-edge: #a00 }</style>
    <circle-voronoi circles="${THREE}" layers="hull dual largest-disc" view="5 4 30"></circle-voronoi>`,
  )
  await shown(page)
  const element = page.locator('circle-voronoi')
  const share = (kind: 'svg' | 'png') =>
    element.evaluate(async (element: Element, kind) => {
      const canvases = [...(element.shadowRoot as ShadowRoot).querySelectorAll('canvas')]
      const { width, height } = canvases[0] as HTMLCanvasElement
      const context = new OffscreenCanvas(width, height).getContext('2d') as OffscreenCanvasRenderingContext2D
      const pixels = (images: readonly CanvasImageSource[]) => {
        context.clearRect(0, 0, width, height)
        for (const image of images) context.drawImage(image, 0, 0, width, height)
        return context.getImageData(0, 0, width, height).data
      }
      const image = new Image()
      if (kind === 'svg') {
        image.src = `data:image/svg+xml,${encodeURIComponent(await element.toSVG())}`
        await image.decode()
      }
      const drawing = kind === 'svg' ? image : await createImageBitmap(await element.toPNG(1))
      const [drawn, seen] = [pixels([drawing]), pixels(canvases)]
      let others = 0
      // Rims are blended differently.
      for (let k = 0; k < seen.length; k++) if (Math.abs((seen[k] as number) - (drawn[k] as number)) > 96) others += 1
      return others / seen.length
    }, kind)
  for (const kind of ['svg', 'png'] as const) expect(await share(kind), kind).toBeLessThan(0.002)

  // Zooms in, where most is clipped, with other layers and colors.
  await element.evaluate(async (element: Element) => {
    element.layers = 'cells=different delaunay ordinary hidden no-vertices max-distance=4'
    element.view = { x: 8, y: 2, span: 6 }
    await element.updateComplete
  })
  for (const kind of ['svg', 'png'] as const) expect(await share(kind), kind).toBeLessThan(0.002)

  // The selection is highlighted on screen only.
  const svg = () => element.evaluate((element: Element) => element.toSVG())
  const before = await svg()
  expect(before).toContain('rgb(170, 0, 0)')
  await element.evaluate(async (element: Element) => {
    element.selection = [1]
    await element.updateComplete
  })
  await soon(() => share('png')).toBeGreaterThan(0.002)
  expect(await svg()).toBe(before)
})

test('in German where the page is: the method, what is read out, and what is wrong', async ({ page }) => {
  const { problems } = watch(page)
  await open(page, 'german', `<circle-voronoi circles="${THREE}" controls="buttons player"></circle-voronoi>`, 'de')
  await shown(page)
  const element = page.locator('circle-voronoi')
  const player = element.locator('.player')
  await expect(player.locator('.sentence')).toHaveText('Es gibt 3 Kreise.')
  await expect(player).toHaveAttribute('lang', 'de')
  await expect(element.getByRole('region', { name: 'Die Methode Schritt für Schritt' })).toBeVisible()
  await expect(element.getByRole('slider', { name: 'Schritt' })).toBeVisible()
  await expect(element.getByText('So funktioniert es')).toBeVisible()
  await element.getByRole('application').focus()
  await page.keyboard.press('Enter')
  const said = element.locator('[aria-live="polite"]').last()
  await expect(said).toHaveText(/^Kreis \d\. (Unbegrenzte|Begrenzte) Zelle, 2 Nachbarn$/)
  await page.keyboard.press('Delete')
  await expect(said).toHaveText(/^Kreis \d gelöscht$/)
  const alert = element.getByRole('alert')
  await element.evaluate((element: Element) => element.setAttribute('layers', 'dsic'))
  await expect(alert).toHaveText(/^Es gibt keine Ebene dsic\. Ebenen sind circles, /)
  await expect(alert).toHaveAttribute('lang', 'de')
  await element.evaluate((element: Element) => {
    element.removeAttribute('layers')
    element.circles = [[0, 0, -1]]
  })
  await expect(alert).toHaveText('Kreis 0: Der Radius darf nicht negativ sein.')
  expect(problems).toEqual([])
})

test('a property takes what its attribute does, as frameworks set it', async ({ page }) => {
  await open(page, 'strings', '<circle-voronoi></circle-voronoi>')
  const seen = await page.locator('circle-voronoi').evaluate(async (element: Element, circles) => {
    await customElements.whenDefined('circle-voronoi')
    Object.assign(element, { circles, layers: 'dual no-edges', view: '5 4 30', step: '2', controls: true })
    await element.ready
    await element.updateComplete
    const { dual, edges } = element.layers
    return { circles: [...element.circles], layers: [dual, edges], view: element.view, step: element.step }
  }, THREE)
  expect(seen).toEqual({ circles: FLAT, layers: [true, false], view: { x: 5, y: 4, span: 30 }, step: 2 })
  expect(await errors(page)).toEqual([])
})
