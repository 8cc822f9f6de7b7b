// SPDX-License-Identifier: GPL-3.0-or-later
// Uses each chapter like a reader: drags every figure, moves it by keys, and answers every question wrong and right.
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, type Locator, type Page, test } from '@playwright/test'
import { type Chapter, readBook, type Spec } from '../../scripts/texts/tutorial.mjs'
import { decodeLink } from '../../web/lib/link.ts'
import { CORRUPTIONS } from '../../web/tutorial/corruptions.ts'
import { boundingBox, type Camera, fitted, toScreen } from '../../web/view/camera.ts'
import { layersFrom } from '../../web/view/layers.ts'
import { blocksRunBy } from '../readme/blocks.mjs'
import { soon } from '../soon.ts'
import { violationsOf } from './accessibility.ts'
import { framesOf } from './frames.ts'

type Element = HTMLElementTagNameMap['circle-voronoi']

/** Limit for layout shift, which is invisible below it. */
const MOST_SHIFT = 0.02
const MARGIN = 16
/** Figures that the tutorial draws itself. */
const DRAWN: readonly string[] = ['drawn', 'cones']
const BELOW_BUTTONS = 12

/** Collects the errors and warnings of a page. */
function watch(page: Page): string[] {
  const problems: string[] = []
  page.on('pageerror', ({ message }) => problems.push(message))
  page.on('console', (message) => {
    const isBlocked = message.text() === 'Service Worker registration blocked by Playwright'
    if ((message.type() === 'error' || message.type() === 'warning') && !isBlocked) problems.push(message.text())
  })
  return problems
}

const circlesOf = (figure: Locator): Promise<number[]> => figure.evaluate((element: Element) => [...element.circles])

/** Waits until a figure shows its circles. */
async function show(figure: Locator): Promise<void> {
  await figure.scrollIntoViewIfNeeded()
  await figure.evaluate(async (element: Element) => {
    await element.ready
    await element.updateComplete
  })
}

/** Drags the largest visible circle, whose disc is easiest to hit. */
async function drag(page: Page, figure: Locator): Promise<void> {
  const { circles, view, box, buttons } = await figure.evaluate((element: Element) => {
    const root = element.shadowRoot as ShadowRoot
    const { left, top, width, height } = (root.querySelector('.figure') as HTMLElement).getBoundingClientRect()
    const buttons = (root.querySelector('.controls') as HTMLElement).clientHeight
    return { circles: [...element.circles], view: element.view, box: { left, top, width, height }, buttons }
  })
  const padding = { top: buttons === 0 ? MARGIN : buttons + BELOW_BUTTONS, right: MARGIN, bottom: MARGIN, left: MARGIN }
  const camera: Camera =
    view === undefined
      ? fitted(boundingBox(Float64Array.from(circles)), box, padding)
      : { x: view.x, y: view.y, scale: Math.min(box.width, box.height) / view.span }
  const seen = Array.from({ length: circles.length / 3 }, (_, i) => circles.slice(3 * i, 3 * i + 3))
    .map(([x, y, r]) => ({ at: toScreen(camera, box, { x: x as number, y: y as number }), r: r as number }))
    .filter(({ at }) => at.x > 20 && at.y > 50 && at.x < box.width - 20 && at.y < box.height - 20)
  const { at } = seen.reduce((most, circle) => (circle.r > most.r ? circle : most))
  const [x, y] = [box.left + at.x, box.top + at.y]
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x + 6, y + 4)
  await page.mouse.move(x + 12, y + 8)
  await page.mouse.up()
}

async function tryFigure(page: Page, name: string): Promise<void> {
  const figure = page.locator(`#${name} circle-voronoi`)
  await show(figure)
  const atFirst = await circlesOf(figure)
  await drag(page, figure)
  await soon(() => circlesOf(figure), name).not.toEqual(atFirst)
  await figure.getByRole('application').focus()
  await page.keyboard.press('Escape')
  await page.keyboard.press('Enter')
  await soon(() => figure.evaluate((element: Element) => element.selection.length), name).toBe(1)
  // A key is handled after all earlier pointer events.
  const dragged = await circlesOf(figure)
  await page.keyboard.press('ArrowRight')
  await soon(() => circlesOf(figure), name).not.toEqual(dragged)
}

/** Expects that a figure's link contains the figure's state. */
async function expectLink(page: Page, name: string): Promise<void> {
  const link = page.locator(`#${name} a.open`)
  await link.focus()
  const shown = await page.locator(`#${name} circle-voronoi`).evaluate((element: Element) => {
    const state = element.getState()
    return { ...state, method: state.step === undefined ? undefined : (element.getAttribute('method') ?? undefined) }
  })
  const linked = async () => {
    const {
      circles = [],
      layers,
      step,
      method,
    } = await decodeLink(new URL(await link.evaluate((a: HTMLAnchorElement) => a.href)).hash)
    return { circles: [...circles], layers: layersFrom(layers), step, method }
  }
  await soon(linked, name).toEqual({
    circles: shown.circles.flat(),
    layers: layersFrom(shown.layers),
    step: shown.step,
    method: shown.method,
  })
}

async function answer(page: Page): Promise<void> {
  for (const form of await page.locator('form.question').all()) {
    const right = Number(await form.getAttribute('data-right'))
    const output = form.locator('output')
    await form.getByRole('button', { name: 'Check' }).click()
    await expect(output).toHaveText('Choose an answer first.')
    const choices = form.getByRole('radio')
    await choices.nth((right + 1) % (await choices.count())).check()
    await form.getByRole('button', { name: 'Check' }).click()
    await expect(output).toHaveText(/^Not quite/)
    await expect(form.locator('details.answer')).not.toHaveAttribute('open')
    await choices.nth(right).check()
    await form.getByRole('button', { name: 'Check' }).click()
    await expect(output).toHaveText('Right.')
    await expect(form.locator('details.answer')).toHaveAttribute('open')
  }
}

/** Solves an exercise by dragging, and reverts the solution. */
async function reach(page: Page): Promise<void> {
  for (const section of await page.locator('.try').all()) {
    await expect(section.locator('.now')).toHaveText(/: now .*, goal /)
    const output = section.locator('figcaption output')
    await expect(output).toHaveText('')
    await section.getByText('Answer', { exact: true }).click()
    await section.getByRole('button', { name: 'Show me' }).click()
    await expect(output).toHaveText('Well done.')
    await section.getByRole('button', { name: 'Undo' }).click()
    await expect(output).toHaveText('')
    await section.getByRole('button', { name: 'Show me' }).click()
    await expect(output).toHaveText('Well done.')
    await section.getByRole('button', { name: 'Reset' }).click()
    await expect(output).toHaveText('')
  }
}

async function slide(page: Page): Promise<void> {
  for (const slider of await page.locator('input[data-changes]').all()) {
    const figure = page.locator(`#${await slider.getAttribute('data-figure')} circle-voronoi`)
    const state = () => figure.evaluate((element: Element) => JSON.stringify(element.getState()))
    const before = await state()
    await slider.focus()
    await page.keyboard.press(
      (await slider.evaluate((input: HTMLInputElement) => input.value === input.min)) ? 'End' : 'Home',
    )
    await soon(state).not.toEqual(before)
  }
}

/** Tests the tutorial's own figures: each handle by mouse and keys, the slider, and the caption. */
async function tryDrawn(page: Page, { name }: Spec): Promise<void> {
  const figure = page.locator(`#${name}`)
  await figure.scrollIntoViewIfNeeded()
  const handles = figure.locator('.handle')
  const content = () => figure.locator('svg.drawn > g').first().innerHTML()
  await expect(handles.first()).toBeVisible()
  for (const handle of [handles.first(), handles.last()]) {
    const atFirst = await content()
    const { x, y, width, height } = (await handle.boundingBox()) as NonNullable<
      Awaited<ReturnType<Locator['boundingBox']>>
    >
    await page.mouse.move(x + width / 2, y + height / 2)
    await page.mouse.down()
    await page.mouse.move(x + width / 2 + 9, y + height / 2 + 6)
    await page.mouse.up()
    await soon(content, name).not.toBe(atFirst)
    const dragged = await content()
    await handle.focus()
    await page.keyboard.press('ArrowLeft')
    await soon(content, name).not.toBe(dragged)
  }
  const moved = await content()
  const slider = figure.getByRole('slider')
  await slider.focus()
  await page.keyboard.press((await slider.inputValue()) === (await slider.getAttribute('max')) ? 'Home' : 'End')
  await soon(content, name).not.toBe(moved)
  await expect(figure.locator('output.told')).not.toHaveText('')
  const play = figure.getByRole('button', { name: 'Play' })
  if ((await play.count()) > 0) {
    const atEnd = await content()
    // Pauses playback at the first picture, before it ends by itself.
    await play.evaluate(
      (button: HTMLButtonElement, figure) =>
        new Promise<void>((resolve) => {
          const drawing = figure?.querySelector('svg.drawn > g') as Element
          const observer = new MutationObserver(() => {
            observer.disconnect()
            button.click()
            resolve()
          })
          observer.observe(drawing, { childList: true })
          button.click()
        }),
      await figure.elementHandle(),
    )
    await soon(content, name).not.toBe(atEnd)
    await expect(play).toBeVisible()
    await figure.getByRole('button', { name: 'Next' }).click()
    const told = await figure.locator('output.told').textContent()
    await figure.getByRole('button', { name: 'Back' }).click()
    await expect(figure.locator('output.told')).not.toHaveText(told as string)
  }
}

async function tryCones(page: Page, name: string): Promise<void> {
  const figure = page.locator(`#${name}`)
  await figure.scrollIntoViewIfNeeded()
  const canvas = figure.locator('canvas')
  const picture = async () => {
    // A change is painted in the next frame.
    await framesOf(page, 2)
    return canvas.evaluate((element: HTMLCanvasElement) => element.toDataURL())
  }
  const atFirst = await soonStill(picture)
  for (const slider of await figure.getByRole('slider').all()) {
    await slider.focus()
    await page.keyboard.press('End')
  }
  await expect(figure.locator('output').first()).toHaveText('90°')
  await soon(picture, name).not.toBe(atFirst)
  const above = await soonStill(picture)
  const { x, y, width, height } = (await canvas.boundingBox()) as NonNullable<
    Awaited<ReturnType<Locator['boundingBox']>>
  >
  await page.mouse.move(x + width / 2, y + height / 2)
  await page.mouse.down()
  await page.mouse.move(x + width / 2 + 40, y + height / 2 - 60)
  await page.mouse.up()
  await soon(picture, name).not.toBe(above)
}

/** Waits until a value no longer changes. */
async function soonStill(ask: () => Promise<string>): Promise<string> {
  let before = ''
  await soon(async () => {
    const now = await ask()
    const isStill = now === before
    before = now
    return isStill
  }).toBe(true)
  return before
}

/** Expects that the named check detects each corruption of the list, and one made by hand. */
async function corrupt(page: Page): Promise<void> {
  const verdict = page.locator('.corrupt output')
  const RIGHT = 'The judge: this diagram is right.'
  await expect(verdict).toHaveText(RIGHT)
  const change = page.getByLabel('Change', { exact: true })
  const drawn = () =>
    page.locator('[data-corrupt] circle-voronoi').evaluate(({ layers }: Element) => ({
      ownEdges: layers.edges,
      layers: layers.data?.map(({ id, points = [], segments = [], discs = [] }) => ({
        id,
        parts: [points.length / 2, segments.length / 4, discs.length / 3],
      })),
    }))
  for (const [k, { name, about }] of CORRUPTIONS.entries()) {
    await change.selectOption({ label: name })
    await expect(page.locator('.corrupt p').first(), `${k}`).toHaveText(about)
    await expect(verdict).toHaveText(/^The judge: no\. \w/)
    // The wrong diagram is drawn in place of the right one, with a mark on its flaw.
    const { ownEdges, layers = [] } = await drawn()
    expect(ownEdges, name).toBe(false)
    expect(
      layers.map(({ id }) => id),
      name,
    ).toEqual(['claimed', 'marked'])
    for (const { parts } of layers) expect(Math.max(...parts), name).toBeGreaterThan(0)
    await page.getByRole('button', { name: 'Make it right again' }).click()
    await expect(verdict).toHaveText(RIGHT)
    expect(await drawn()).toEqual({ ownEdges: true, layers: [] })
  }
  await page.getByText('Choose the circles of each vertex yourself').click()
  const choice = page.locator('.corrupt td select').first()
  await choice.selectOption({
    index: ((await choice.evaluate((select: HTMLSelectElement) => select.selectedIndex)) + 1) % 5,
  })
  await expect(verdict).toHaveText(/^The judge: no\. \w/)
  // The vertex, its disc and the circles that it claims to touch are marked.
  await soon(drawn).toMatchObject({ layers: [{ id: 'claimed' }, { id: 'marked', parts: [1, 0, 4] }] })
  await expect(page.locator('.numbers text')).toHaveText(['0', '1', '2', '3', '4', '5'])
  await page.getByRole('button', { name: 'Make it right again' }).click()
  await expect(verdict).toHaveText(RIGHT)
}

async function read(page: Page, { file, blocks }: Chapter): Promise<void> {
  const problems = watch(page)
  await page.addInitScript(() => {
    let shift = 0
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) {
        const { value, hadRecentInput } = entry as PerformanceEntry & { value: number; hadRecentInput: boolean }
        if (!hadRecentInput) shift += value
      }
    }).observe({ type: 'layout-shift', buffered: true })
    Object.assign(globalThis, { shift: () => shift })
  })
  await page.goto(`/tutorial/${file}`)
  const names = blocks
    .filter(({ kind, spec }) => spec.name !== undefined && !DRAWN.includes(kind))
    .map(({ spec }) => spec.name)
  for (const name of names) await show(page.locator(`#${name} circle-voronoi`))
  expect(await page.evaluate(() => (globalThis as unknown as { shift: () => number }).shift())).toBeLessThan(MOST_SHIFT)
  expect(await violationsOf(page)).toEqual([])

  for (const name of names) await tryFigure(page, name)
  for (const { kind, spec } of blocks) {
    if (kind === 'drawn') await tryDrawn(page, spec)
    if (kind === 'cones') await tryCones(page, spec.name)
  }
  await reach(page)
  await slide(page)
  await answer(page)
  if (blocks.some(({ kind }) => kind === 'corrupt')) {
    await corrupt(page)
  }
  for (const output of await page.locator('output.counts').all())
    await expect(output).toHaveText(/^\d+ samples on the largest/)
  for (const name of names) await expectLink(page, name)
  const [first] = names
  if (first !== undefined) {
    const count = (await circlesOf(page.locator(`#${first} circle-voronoi`))).length / 3
    await page.locator(`#${first} a.open`).click()
    await expect(page.locator('#status')).toContainText(`${count} circles`)
  }
  expect(problems).toEqual([])
}

for (const [i, chapter] of readBook()
  .filter(({ isChapter }) => isChapter)
  .entries()) {
  test(`${chapter.file}: figures and questions`, { tag: i === 0 ? [] : '@long' }, async ({ page }) => {
    await read(page, chapter)
  })
}

test('questions, exercises and figures have the same width, on screens and on phones', async ({ page }) => {
  for (const width of [1440, 390]) {
    await page.setViewportSize({ width, height: 900 })
    await page.goto('/tutorial/01-nearest-circle.html')
    const widths = await page
      .locator('form.question, .try, main figure:not(.try figure)')
      .evaluateAll((parts) => parts.map((part) => Math.round(part.getBoundingClientRect().width)))
    expect(widths.length).toBeGreaterThan(5)
    expect([...new Set(widths)], `${width}`).toHaveLength(1)
  }
})

test('a judge that cannot be loaded says so, and is asked for again', async ({ page }) => {
  const chapter = readBook().find(({ blocks }) => blocks.some(({ kind }) => kind === 'corrupt')) as Chapter
  await page.route('**/circle-voronoi-*.wasm', (route) => route.fulfill({ status: 404 }))
  await page.goto(`/tutorial/${chapter.file}`)
  const verdict = page.locator('.corrupt output')
  await verdict.scrollIntoViewIfNeeded()
  await expect(verdict).toHaveText(/^The WebAssembly cannot be loaded from .+404/)
  await page.unrouteAll()
  await page.getByRole('button', { name: 'Make it right again' }).click()
  await expect(verdict).toHaveText('The judge: this diagram is right.')
})

test('what rules find as printed follows the circles', async ({ page }) => {
  const problems = watch(page)
  await page.goto('/tutorial/06-where-rules-fail.html')
  const around = page.locator('#third-edge')
  const figure = around.locator('circle-voronoi')
  const pathOf = (name: string) => around.locator(`svg .${name}`).getAttribute('d')
  await show(figure)
  await expect(around.locator('output')).toHaveText(
    'As printed: 2 of 4 borders found, and 1 line where there is no border.',
  )
  const [discs, wrong] = [await pathOf('discs'), await pathOf('wrong')]
  expect(wrong).not.toBe('')

  // Drags the small circle out from between the others.
  const { view, box } = await figure.evaluate((element: Element) => {
    const { left, top, width, height } = element.getBoundingClientRect()
    return { view: element.view as NonNullable<typeof element.view>, box: { left, top, width, height } }
  })
  const camera = { x: view.x, y: view.y, scale: Math.min(box.width, box.height) / view.span }
  const circle = (await circlesOf(figure)).slice(6)
  const from = toScreen(camera, box, { x: circle[0] as number, y: circle[1] as number })
  const to = toScreen(camera, box, { x: 6, y: 0 })
  await page.mouse.move(box.left + from.x, box.top + from.y)
  await page.mouse.down()
  await page.mouse.move(box.left + (from.x + to.x) / 2, box.top + (from.y + to.y) / 2)
  // Checked during the drag.
  await soon(() => pathOf('discs')).not.toBe(discs)
  await page.mouse.move(box.left + to.x, box.top + to.y)
  await page.mouse.up()
  await expect(around.locator('output')).toHaveText('As printed: the same diagram here.')
  expect(await pathOf('wrong')).toBe('')

  // The figure shows the same part of the plane.
  const viewBox = () => around.locator('svg').getAttribute('viewBox')
  const seen = await viewBox()
  await figure.getByRole('application').focus()
  await page.keyboard.press('Escape')
  await page.keyboard.press('+')
  await soon(viewBox).not.toBe(seen)

  // Too many circles are not compared.
  await figure.evaluate((element: Element) => {
    element.circles = Array.from({ length: 41 }, (_, i) => [3 * i, i % 3, 1])
  })
  await expect(around.locator('output')).toHaveText('Here the rules are tried on 40 circles at most.')
  expect(problems).toEqual([])
})

test('on paper a figure is as it was on the screen, and what asks has no answer', async ({ page }) => {
  await page.goto('/tutorial/01-nearest-circle.html')
  await show(page.locator('#four-circles circle-voronoi'))
  // Printing scales the existing pixels.
  await page.evaluate(() => {
    const printed: number[] = []
    addEventListener('afterprint', () => {
      const canvas = document.querySelector('circle-voronoi')?.shadowRoot?.querySelector('canvas') as HTMLCanvasElement
      const { width, height } = canvas
      const { data } = (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, width, height)
      printed.push(width, data.filter((value, k) => k % 4 === 3 && value > 0).length / (width * height))
    })
    Object.assign(globalThis, { printed })
  })
  const width = await page
    .locator('#four-circles canvas')
    .first()
    .evaluate(({ width }: HTMLCanvasElement) => width)
  await page.pdf({ format: 'A4' })
  const [printedWidth, ink] = await page.evaluate(() => (globalThis as unknown as { printed: number[] }).printed)
  expect(printedWidth).toBe(width)
  expect(ink).toBeGreaterThan(0.9)
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('.question').first()).toBeVisible()
  await expect(page.getByText('Answer', { exact: true }).first()).toBeHidden()
})

test('formulas have a font with a table for mathematics, whatever fonts the system has', async ({ page }) => {
  await page.goto('/tutorial/02-hyperbolas.html')
  const fonts = await page.evaluate(async () => {
    await document.fonts.ready
    return [...document.fonts].map(({ family, status }) => [family, status])
  })
  expect(fonts).toEqual([['Formulas', 'loaded']])
  // The bar of a fraction does not touch the numbers.
  const fraction = page.locator('mfrac').first()
  const [above, below] = await Promise.all([0, 1].map((k) => fraction.locator('> *').nth(k).boundingBox()))
  expect((below?.y ?? 0) - ((above?.y ?? 0) + (above?.height ?? 0))).toBeGreaterThan(0)
})

test('the two lines for teachers are a live figure', async ({ page }) => {
  const problems = watch(page)
  await page.goto('/tutorial/teachers.html')
  const lines = (await page.locator('pre').first().textContent()) as string
  expect(blocksRunBy('tests/e2e/tutorial.spec.ts').map(({ code }) => code)).toEqual([lines])
  expect(lines).toContain('https://example.org/circle-voronoi/element.js')
  // Tests the lines on another page without a policy, with the address of this site.
  const own = lines.replace('https://example.org/circle-voronoi/element.js', '/element.js')
  await page.route('**/lesson.html', (route) => route.fulfill({ contentType: 'text/html', body: own }))
  await page.goto('/lesson.html')
  const figure = page.locator('circle-voronoi')
  await show(figure)
  expect(await circlesOf(figure)).toHaveLength(9)
  await drag(page, figure)
  await soon(() => circlesOf(figure)).not.toEqual([0, 0, 3, 9, 1, 1, 4, 8, 2])
  expect(problems).toEqual([])
})

const SITE = fileURLToPath(new URL('../../dist/site/', import.meta.url))
/** The files of the site that are checked. */
const PAGES = ['tutorial', 'docs', 'api'].flatMap((folder) =>
  readdirSync(`${SITE}${folder}`)
    .filter((name) => name.endsWith('.html'))
    .map((name) => `${folder}/${name}`),
)

test('every link in the texts leads somewhere', () => {
  const texts = new Map(PAGES.map((page) => [page, readFileSync(SITE + page, 'utf8')]))
  const modules = PAGES.flatMap((page) => /^api\/modules-circle-voronoi(.*)\.html$/.exec(page)?.[1] ?? [])
  expect(modules).toEqual([
    ...['', '_element_define', '_files', '_link', '_metrics', '_picture', '_react', '_regions', '_sphere', '_worker'],
  ])
  const dead: string[] = []
  for (const [page, text] of texts) {
    for (const [, address] of text.matchAll(/ (?:href|src|srcset)="([^"]*)"/g)) {
      const { origin, pathname, hash } = new URL(address as string, `http://site/${page}`)
      if (origin !== 'http://site') continue
      const path = pathname.slice(1).replace(/(^|\/)$/, '$1index.html')
      const place = decodeURIComponent(hash.slice(1))
      const isThere = existsSync(SITE + path)
      // The part after the # of a playground's address is a link, not an anchor.
      const isPlace = place === '' || path === 'index.html' || (texts.get(path) ?? '').includes(` id="${place}"`)
      if (!isThere || !isPlace) dead.push(`${page}: ${address}`)
    }
  }
  expect(dead).toEqual([])
})

test('the documentation reads well, and its search finds', async ({ page }) => {
  const problems = watch(page)
  await page.goto('/docs/')
  for (const name of ['The manual page', 'A live figure in a page']) {
    await page.getByRole('navigation', { name: 'Documentation' }).getByRole('link', { name }).click()
    await expect(page.getByRole('heading', { level: 1 })).toHaveText(name)
    expect(await violationsOf(page)).toEqual([])
  }
  await page.getByRole('navigation', { name: 'Site' }).getByRole('link', { name: 'Reference' }).click()
  await page.getByRole('main').getByRole('link', { name: 'circle-voronoi', exact: true }).first().click()
  await page.getByRole('link', { name: 'edgeCurve', exact: true }).click()
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Function: edgeCurve()')
  expect(await violationsOf(page)).toEqual([])
  await page.getByLabel('Search').fill('antipodal disc')
  const found = page.locator('.found a')
  await expect(found.first()).toBeVisible()
  await page.getByLabel('Search').fill('glossry')
  await expect(found.first()).toContainText('Glossary')
  await page.keyboard.press('Enter')
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Glossary')
  await page.getByLabel('Search').fill('qqqq')
  await expect(page.locator('.found')).toHaveText('Nothing found.')
  expect(problems).toEqual([])
})

test.describe('without scripts', () => {
  test.use({ javaScriptEnabled: false })

  test('a chapter has its text, its formulas, its pictures and its answers', async ({ page }) => {
    await page.goto('/tutorial/01-nearest-circle.html')
    await expect(page.getByRole('heading', { level: 1 })).toHaveText('Which circle is nearest?')
    await expect(page.locator('math').first()).toBeVisible()
    const pictures = page.locator('circle-voronoi > img')
    expect(await pictures.count()).toBeGreaterThan(0)
    for (const picture of await pictures.all()) {
      await picture.scrollIntoViewIfNeeded()
      const box = (await picture.boundingBox()) as { width: number; height: number }
      expect(box.width / box.height).toBeGreaterThan(0.5)
      expect(box.height).toBeGreaterThan(200)
    }
    await page.locator('.question').getByText('Answer', { exact: true }).first().click()
    await expect(page.getByText('the first is nearer', { exact: false })).toBeVisible()
    await expect(page.getByRole('button', { name: 'Check' }).first()).toBeHidden()
  })

  test('what rules find as printed is pictured and said', async ({ page }) => {
    await page.goto('/tutorial/06-where-rules-fail.html')
    const figures = await page.locator('figure.printed').all()
    expect(figures.length).toBeGreaterThan(0)
    for (const figure of figures) {
      await figure.scrollIntoViewIfNeeded()
      const picture = figure.locator('.picture img')
      await soon(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(0)
      await expect(figure.locator('output')).toHaveText(/^As printed: \d+ of \d+ borders found/)
    }
  })
})
