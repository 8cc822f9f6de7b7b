// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the documentation and the contents of the tutorial: links, appearance and search.
import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, type Page, test } from '@playwright/test'
import { readBook } from '../../scripts/texts/tutorial.mjs'
import { boundingBox, fitted, toScreen } from '../../web/view/camera.ts'
import { soon } from '../soon.ts'
import { library } from '../web/library.ts'
import { violationsOf } from './accessibility.ts'

const SITE = fileURLToPath(new URL('../../dist/site/', import.meta.url))
const pagesOf = (folder: string) =>
  readdirSync(`${SITE}${folder}`)
    .filter((name) => name.endsWith('.html'))
    .map((name) => `${folder}/${name}`)
/** Tolerance for horizontal scrolling caused by rounding, in pixels. */
const ROUNDING = 1
/** Margin of a figure without buttons, in pixels. */
const MARGIN = 16

test('the first page sends each reader on within a screen', async ({ page }) => {
  await page.goto('/docs/')
  const main = page.getByRole('main')
  for (const [wish, address] of [
    ['try it', '../'],
    ['understand it', '../tutorial/01-nearest-circle.html'],
    ['use it in JavaScript', 'javascript.html'],
    ['use it in C++', 'cpp.html'],
    ['or Python', 'python.html'],
    ['put a figure into a page', 'element.html'],
    ['run it in the shell', 'shell.html'],
    ['build it from source', 'building.html'],
  ] as const) {
    const row = main.getByRole('row').filter({ hasText: wish })
    await expect(row).toBeInViewport({ ratio: 1 })
    await expect(row.locator(`a[href="${address}"]`)).toHaveCount(1)
  }
  // The first code example has five lines and a picture.
  const code = await main.locator('#in-javascript ~ pre').first().textContent()
  expect(
    code
      ?.trim()
      .split('\n')
      .filter((line) => line !== ''),
  ).toHaveLength(5)
  await expect(main.locator('img[src="three-circles.svg"]')).toBeVisible()
})

test('long pages have a table of contents, and short ones none', async ({ page }) => {
  for (const name of [
    'docs/architecture.html',
    'docs/cookbook.html',
    'docs/javascript.html',
    'tutorial/03-touching-discs.html',
  ]) {
    await page.goto(`/${name}`)
    const toc = page.getByRole('navigation', { name: 'On this page' })
    const links = toc.getByRole('link')
    const first = await links.first().textContent()
    expect(await links.count(), name).toBeGreaterThan(2)
    await links.first().click()
    await expect(page.getByRole('heading', { level: 2, name: first as string })).toBeInViewport()
  }
  await page.goto('/docs/tiles.html')
  await expect(page.getByRole('navigation', { name: 'On this page' })).toHaveCount(0)
})

/** Returns code that is clipped although its lines could be broken, and whether the page itself is too wide. */
function clipped(rounding: number): string[] {
  const wide = [
    ...document.querySelectorAll<HTMLElement>('pre:not(.drawn), p, li, :is(h1, h2, h3):not(.hidden)'),
  ].filter(
    (element) => element.scrollWidth > element.clientWidth + rounding && getComputedStyle(element).display !== 'inline',
  )
  const fixed = [...document.querySelectorAll<HTMLElement>('pre.drawn, .wide')].filter(
    (element) => element.scrollWidth > element.clientWidth + rounding && element.tabIndex !== 0,
  )
  const page = document.scrollingElement as Element
  return [
    ...[...wide, ...fixed].map((element) => `${element.tagName}: ${element.textContent?.slice(0, 60)}`),
    ...(page.scrollWidth > innerWidth + rounding ? ['the page'] : []),
  ]
}

async function expectNothingClipped(page: Page, names: readonly string[], widths: readonly number[]): Promise<void> {
  for (const name of names) {
    await page.goto(`/${name}`)
    for (const width of widths) {
      await page.setViewportSize({ width, height: 800 })
      expect(await page.evaluate(clipped, ROUNDING), `${name} at ${width}`).toEqual([])
    }
  }
}

test('code is never clipped, and no page scrolls sideways, on phones and on screens', async ({ page }) => {
  const names = [
    'docs/index.html',
    'docs/cookbook.html',
    'docs/building.html',
    'docs/headers.html',
    'tutorial/index.html',
  ]
  await expectNothingClipped(page, names, [320, 390, 768, 1280, 1920])
})

test('code is never clipped in any page', { tag: '@long' }, async ({ page }) => {
  test.setTimeout(600_000)
  await expectNothingClipped(page, [...pagesOf('docs'), ...pagesOf('tutorial'), ...pagesOf('api')], [320, 1280])
})

test('the pages of the documentation are accessible', { tag: '@long' }, async ({ page }) => {
  test.setTimeout(300_000)
  for (const name of pagesOf('docs')) {
    await page.goto(`/${name}`)
    for (const colorScheme of ['light', 'dark'] as const) {
      await page.emulateMedia({ colorScheme })
      const violations = await violationsOf(page)
      expect(
        violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]),
        `${name} ${colorScheme}`,
      ).toEqual([])
    }
  }
})

test('the description of each page is a whole sentence', () => {
  const broken = ['docs', 'api', 'tutorial'].flatMap(pagesOf).filter((name) => {
    const [, description = ''] =
      /<meta name="description" content="([^"]*)"/.exec(readFileSync(SITE + name, 'utf8')) ?? []
    return !/^(?:&quot;|&lt;circle-voronoi&gt;|[\p{Lu}\p{N}“]).*[.?!)]$/u.test(description)
  })
  expect(broken).toEqual([])
})

test.describe('search', () => {
  const found = (page: Page) => page.locator('.found a')
  async function search(page: Page, words: string) {
    await page.getByLabel('Search').fill(words)
    await expect(page.locator('.found')).toBeVisible()
    await expect(found(page).first()).toHaveAttribute('href', /./)
    return found(page).evaluateAll((links) => links.map((link) => link.getAttribute('href') as string))
  }

  test('finds what is in the text, in its section, with a snippet', async ({ page }) => {
    for (const [words, address] of [
      ['leaflet', '../docs/cookbook.html#show-cells-on-a-leaflet-map'],
      ['react', '../docs/cookbook.html#use-it-in-react'],
      ['animate', '../docs/cookbook.html#animate-by-edits'],
      ['migrate', '../docs/cookbook.html#migrate-from-d3-delaunay'],
      ['moodle', '../docs/cookbook.html#use-it-in-moodle-and-other-frames'],
    ] as const) {
      await page.goto('/docs/')
      const addresses = await search(page, words)
      expect(addresses.slice(0, 2)).toContain(address)
      const link = page.locator(`.found a[href="${address}"]`)
      await expect(link.locator('span')).toHaveText(/\w+ \w+/)
      await link.click()
      await expect(page.locator(`[id="${address.split('#')[1]}"]`)).toBeInViewport()
    }
  })

  test('has pages that explain before names of the reference', async ({ page }) => {
    await page.goto('/docs/')
    for (const words of ['hull', 'vertex', 'worker', 'hidden circles', 'antipodal disc']) {
      const [first] = await search(page, words)
      expect(first, words).not.toContain('/api/')
    }
    // Names that only the reference contains are found, too.
    expect((await search(page, 'outlinePerimeter'))[0]).toContain('outlinePerimeter')
  })

  test('is used with keys', async ({ page }) => {
    await page.goto('/docs/')
    await search(page, 'leaflet')
    await page.getByLabel('Search').press('ArrowDown')
    await expect(found(page).first()).toBeFocused()
    await page.keyboard.press('ArrowUp')
    await expect(page.getByLabel('Search')).toBeFocused()
    await page.keyboard.press('Escape')
    await expect(page.locator('.found')).toBeHidden()
  })
})

test('the contents of the tutorial are a gallery: a figure to drag, and a picture and a line for each chapter', async ({
  page,
}) => {
  await page.goto('/tutorial/')
  const figure = page.locator('.hero circle-voronoi')
  await figure.evaluate(async (element: HTMLElementTagNameMap['circle-voronoi']) => element.ready)
  await expect(page.getByRole('link', { name: 'Start with chapter 1' })).toHaveAttribute(
    'href',
    '01-nearest-circle.html',
  )
  const tiles = page.locator('.gallery a')
  await expect(tiles).toHaveCount(13)
  for (const tile of await tiles.all()) {
    await tile.scrollIntoViewIfNeeded()
    await soon(() => tile.locator('img').evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(0)
    await expect(tile.locator('span').last()).toHaveText(/\w+ \w+/)
  }
  expect(await violationsOf(page)).toEqual([])
})

test.describe('without scripts', () => {
  test.use({ javaScriptEnabled: false })

  test('the pictures of chapter 4 have their lines, samples and shrunken rims', async ({ page }) => {
    await page.goto('/tutorial/04-samples.html')
    /** Counts the lines or discs of a kind in a picture. */
    const countIn = (name: string, kind: string) => {
      const svg = readFileSync(`${SITE}tutorial/pictures/${name}.svg`, 'utf8')
      const [, drawn = ''] = new RegExp(`<(?:path|g) class="lines ${kind}"([\\s\\S]*?)(?:/>\\n|</g>)`).exec(svg) ?? []
      return (drawn.match(/M|<circle/g) ?? []).length
    }
    for (const [name, kind, least] of [
      ['centers-mislead', 'delaunay', 15],
      ['samples', 'sampleGraph', 40],
      ['samples', 'samples', 20],
      ['samples', 'rims', 5],
      ['uniform-samples', 'sampleGraph', 80],
      ['ring', 'samples', 192 + 48 * 9],
      ['layers-between', 'delaunay', 200],
      ['layers-between', 'steps', 6],
    ] as const) {
      expect(countIn(name, kind), `${kind} of ${name}`).toBeGreaterThanOrEqual(least)
      const picture = page.locator(`#${name} img`)
      await picture.scrollIntoViewIfNeeded()
      await expect(picture).toHaveAttribute('src', `pictures/${name}.svg`)
      await soon(async () => (await picture.boundingBox())?.height).toBeGreaterThan(200)
    }
  })
})

test.describe('on a phone', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 844 } })

  test('a tap on a border shows its disc, as a pointer does', async ({ page }) => {
    await page.goto('/tutorial/02-hyperbolas.html')
    const figure = page.locator('#hyperbola circle-voronoi')
    await figure.scrollIntoViewIfNeeded()
    await figure.evaluate(async (element: HTMLElementTagNameMap['circle-voronoi']) => {
      await element.ready
      await element.updateComplete
    })
    const before = await figure.screenshot()
    // The border crosses the line between the centers at distance 5 from the first: the circles reach from -3 to 9.
    const { x, y, width, height } = (await figure.boundingBox()) as {
      x: number
      y: number
      width: number
      height: number
    }
    const scale = (width - 32) / 12
    await page.touchscreen.tap(x + 16 + (5 + 3) * scale, y + height / 2)
    await soon(async () => before.equals(await figure.screenshot())).toBe(false)
    const tapped = await figure.screenshot()
    await page.touchscreen.tap(x + 16 + (5 + 3) * scale, y + 12)
    await soon(async () => tapped.equals(await figure.screenshot())).toBe(false)
  })

  for (const { file, blocks } of readBook()) {
    const names = blocks.filter(({ spec }) => spec.layers?.disc === true).map(({ spec }) => spec.name as string)
    if (names.length === 0) continue
    test(`${file}: a tap on a vertex marks where its disc touches circles`, { tag: '@long' }, async ({ page }) => {
      await page.goto(`/tutorial/${file}`)
      for (const name of names) {
        const figure = page.locator(`#${name} circle-voronoi`)
        await figure.scrollIntoViewIfNeeded()
        const { circles, view, box } = await figure.evaluate(
          async (element: HTMLElementTagNameMap['circle-voronoi']) => {
            await element.ready
            await element.updateComplete
            const root = element.shadowRoot as ShadowRoot
            const { left, top, width, height } = (root.querySelector('.figure') as Element).getBoundingClientRect()
            return { circles: [...element.circles], view: element.view, box: { left, top, width, height } }
          },
        )
        const padding = { top: MARGIN, right: MARGIN, bottom: MARGIN, left: MARGIN }
        const camera =
          view === undefined
            ? fitted(boundingBox(Float64Array.from(circles)), box, padding)
            : { x: view.x, y: view.y, scale: Math.min(box.width, box.height) / view.span }
        const { vertices, vertexCircles } = library.compute(Float64Array.from(circles))
        const screen = (x: number, y: number) => toScreen(camera, box, { x, y })
        const isSeen = ({ x, y }: { x: number; y: number }) =>
          x > 12 && y > 12 && x < box.width - 12 && y < box.height - 12
        const discs = Array.from({ length: vertices.length / 3 }, (_, v) => {
          const [x = 0, y = 0, r = 0] = vertices.subarray(3 * v, 3 * v + 3)
          const feet = [...vertexCircles.subarray(3 * v, 3 * v + 3)].map((i) => {
            const [cx = 0, cy = 0] = circles.slice(3 * i, 3 * i + 2)
            const away = Math.hypot(cx - x, cy - y)
            return screen(x + (r * (cx - x)) / away, y + (r * (cy - y)) / away)
          })
          return { at: screen(x, y), feet }
        })
        const disc = discs.find(({ at, feet }) => [at, ...feet].every(isSeen))
        // The figure has only a border. The test above taps on it.
        if (discs.length === 0) continue
        expect(disc, name).toBeDefined()
        const { at, feet } = disc as NonNullable<typeof disc>
        const marked = () =>
          figure.evaluate((element, points) => {
            const canvas = [...(element.shadowRoot as ShadowRoot).querySelectorAll('canvas')].at(
              -1,
            ) as HTMLCanvasElement
            const ratio = canvas.width / canvas.clientWidth
            const context = canvas.getContext('2d') as CanvasRenderingContext2D
            return points.map(({ x, y }) => (context.getImageData(x * ratio, y * ratio, 1, 1).data[3] as number) > 200)
          }, feet)
        expect(await marked(), name).not.toContain(true)
        // Taps elsewhere, so that this tap and the previous one are no double tap, which would add a circle.
        await page.touchscreen.tap(2, 2)
        await page.touchscreen.tap(box.left + at.x, box.top + at.y)
        await soon(marked, name).toEqual([true, true, true])
      }
    })
  }

  for (const { file, blocks } of readBook()) {
    const names = blocks.filter(({ kind }) => kind === 'drawn').map(({ spec }) => spec.name)
    if (names.length === 0) continue
    test(`${file}: a finger drags in what the tutorial draws itself, and the page stays where it is`, {
      tag: '@long',
    }, async ({ page }) => {
      const session = await page.context().newCDPSession(page)
      await page.goto(`/tutorial/${file}`)
      for (const name of names) {
        const figure = page.locator(`#${name}`)
        const point = figure.locator('.handle').last()
        await point.scrollIntoViewIfNeeded()
        const content = () => figure.locator('svg.drawn > g').first().innerHTML()
        const scrolled = () => page.evaluate(() => scrollY)
        const [drawn, before] = [await content(), await scrolled()]
        const { x, y, width, height } = (await point.boundingBox()) as NonNullable<
          Awaited<ReturnType<typeof point.boundingBox>>
        >
        const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', by: number) =>
          session.send('Input.dispatchTouchEvent', {
            type,
            touchPoints: type === 'touchEnd' ? [] : [{ x: x + width / 2 + by, y: y + height / 2 - by }],
          })
        await touch('touchStart', 0)
        for (const by of [8, 16, 24]) await touch('touchMove', by)
        await touch('touchEnd', 0)
        await soon(content, name).not.toBe(drawn)
        expect(await scrolled(), name).toBe(before)
      }
    })
  }
})
