// SPDX-License-Identifier: GPL-3.0-or-later
// <circle-voronoi> in pages that its author does not control: on paper, in narrow places, among other styles, moved about, and as
// a form control.
import { expect, type Page, test } from '@playwright/test'
import { soon } from '../soon.ts'
import { ownPages } from './own-pages.ts'

type Element = HTMLElementTagNameMap['circle-voronoi']

const { open } = ownPages('behaves')
const THREE = '[[0,0,2],[10,0,1],[5,8,1.5]]'
const FIGURE = `<circle-voronoi circles="${THREE}"></circle-voronoi>`

const circles = (page: Page) => page.locator('circle-voronoi').evaluate((element: Element) => [...element.circles])

/** Drags circle 0. */
async function drag(page: Page): Promise<void> {
  const [x, y] = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    element.view = { x: 5, y: 4, span: 20 }
    await element.updateComplete
    const box = ((element.shadowRoot as ShadowRoot).querySelector('.figure') as HTMLElement).getBoundingClientRect()
    const scale = Math.min(box.width, box.height) / 20
    const [x, y] = element.circles as unknown as [number, number]
    return [box.left + box.width / 2 + (x - 5) * scale, box.top + box.height / 2 - (y - 4) * scale] as const
  })
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x + 40, y, { steps: 5 })
  await page.mouse.up()
}

test('all figures are printed as drawings, also those that nobody has scrolled to, and the screen is as before', async ({
  page,
}) => {
  await open(page, Array.from({ length: 20 }, () => `<div style="height: 700px">${FIGURE}</div>`).join(''))
  const printed = () =>
    page.locator('circle-voronoi').evaluateAll((figures) =>
      figures.map((figure) => {
        const svg = figure.shadowRoot?.querySelector('.paper > svg')
        return svg === null || svg === undefined
          ? 0
          : svg.getBoundingClientRect().width * svg.querySelectorAll('path').length
      }),
    )
  // Each drawing for print is made a moment after its figure has started.
  await soon(async () => {
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
    const isThere = await page
      .locator('circle-voronoi')
      .evaluateAll((figures) => figures.every((figure) => figure.shadowRoot?.querySelector('.paper > svg') !== null))
    await page.evaluate(() => dispatchEvent(new Event('afterprint')))
    return isThere
  }).toBe(true)
  // A page learns of another medium in its next frame.
  await page.emulateMedia({ media: 'print' })
  await soon(async () => (await printed()).every((size) => size > 1000)).toBe(true)
  const fallbacks = await page
    .locator('circle-voronoi')
    .evaluateAll((figures) =>
      figures.map(
        (figure) => getComputedStyle(figure.shadowRoot?.querySelector('.fallback') as HTMLElement).visibility,
      ),
    )
  expect(new Set(fallbacks)).toEqual(new Set(['hidden']))
  await page.emulateMedia({ media: 'screen' })
  await soon(printed).toEqual(Array.from({ length: 20 }, () => 0))
})

test('a drawing on paper is that of the circles as they are', async ({ page }) => {
  await open(page, FIGURE)
  await drag(page)
  const isSame = () =>
    page.locator('circle-voronoi').evaluate(async (element: Element) => {
      dispatchEvent(new Event('beforeprint'))
      const paper = element.shadowRoot?.querySelector('.paper > svg')
      const paths = (root: ParentNode) => [...root.querySelectorAll('path')].map((path) => path.getAttribute('d'))
      const drawn = new DOMParser().parseFromString(await element.toSVG(), 'image/svg+xml')
      const result = paper !== null && paper !== undefined && paths(paper).join() === paths(drawn).join()
      dispatchEvent(new Event('afterprint'))
      return result
    })
  await soon(isSame).toBe(true)
})

for (const [name, html] of [
  ['a flex row', `<div style="display: flex">${FIGURE}</div>`],
  ['a column that centers', `<div style="display: flex; flex-direction: column; align-items: center">${FIGURE}</div>`],
  ['a float', `<div style="float: left">${FIGURE}</div>`],
  ['a cell of a table', `<table><tr><td>${FIGURE}</td></tr></table>`],
  ['a stack of slides', `<div style="display: grid"><div style="margin: auto">${FIGURE}</div></div>`],
] as const) {
  test(`a figure has a width in ${name}`, async ({ page }) => {
    await open(page, html)
    const box = await page.locator('circle-voronoi').boundingBox()
    expect(box?.width).toBeGreaterThan(400)
    expect(box?.width).toBeLessThan(500)
    // The figure fits into less room.
    await page.setViewportSize({ width: 320, height: 600 })
    await soon(async () => (await page.locator('circle-voronoi').boundingBox())?.width).toBeLessThan(321)
  })
}

test('buttons stand below a figure of 120 pixels, and above the picture of a wide one', async ({ page }) => {
  await open(
    page,
    `<div id="around" style="width: 120px"><circle-voronoi circles="${THREE}" controls></circle-voronoi></div>`,
  )
  const overlap = () =>
    page.locator('circle-voronoi').evaluate((element) => {
      const box = (name: string) =>
        ((element.shadowRoot as ShadowRoot).querySelector(name) as HTMLElement).getBoundingClientRect()
      return box('.controls').top < box('.figure').bottom
    })
  expect(await overlap()).toBe(false)
  await page.screenshot({ path: 'build/behaves-narrow.png' })
  await page.locator('#around').evaluate((element) => element.setAttribute('style', 'width: 500px'))
  await soon(overlap).toBe(true)
})

test('styles of the page do not reach the player and the messages', async ({ page }) => {
  const body = `<circle-voronoi circles="${THREE}" controls="buttons player" view="no view"></circle-voronoi>`
  const styles = () =>
    page.locator('circle-voronoi').evaluate(async (element: Element) => {
      await element.stepTo(1)
      const names = [
        'letterSpacing',
        'textAlign',
        'textIndent',
        'textTransform',
        'wordSpacing',
        'lineHeight',
        'fontStyle',
        'fontSize',
      ] as const
      return ['.sentence', '.problem', '.controls'].map((part) => {
        const style = getComputedStyle(element.shadowRoot?.querySelector(part) as HTMLElement)
        return names.map((name) => style[name])
      })
    })
  await open(page, body)
  const plain = await styles()
  const hostile =
    'letter-spacing: 4px; text-align: center; text-indent: 2em; text-transform: uppercase; word-spacing: 9px; line-height: 3; font: italic 30px serif'
  await open(page, `<div style="${hostile}">${body}</div>`)
  expect(await styles()).toEqual(plain)
})

test('undo goes back to before an element was moved, at once or a moment later', async ({ page }) => {
  await open(page, `${FIGURE}<section></section>`)
  const before = await circles(page)
  const changed = page
    .locator('circle-voronoi')
    .evaluate(
      (element: Element) =>
        new Promise<void>((resolve) => element.addEventListener('change', () => resolve(), { once: true })),
    )
  await drag(page)
  await changed
  const moved = await circles(page)
  expect(moved).not.toEqual(before)
  await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    element.remove()
    await new Promise((resolve) => setTimeout(resolve, 100))
    document.querySelector('section')?.append(element)
    await element.ready
    element.focus()
  })
  expect(await circles(page)).toEqual(moved)
  await page.keyboard.press('Control+z')
  await soon(() => circles(page)).toEqual(before)
})

test('a region, areas and readonly that are set while an element is in no page are shown once it is back', async ({
  page,
}) => {
  await open(page, `<circle-voronoi circles="${THREE}" controls></circle-voronoi>`)
  const seen = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    element.shadowRoot?.querySelector('button')?.click()
    element.remove()
    await new Promise((resolve) => setTimeout(resolve, 50))
    element.region = 'POLYGON ((0 0, 9 0, 9 8, 0 8))'
    element.areas = 'equal'
    element.readonly = true
    document.body.append(element)
    await element.ready
    await element.updateComplete
    const root = element.shadowRoot as ShadowRoot
    return {
      isCut: (await element.toSVG()).includes('clip-path'),
      areas: element.areas,
      buttons: root.querySelectorAll('button').length,
      cursor: (root.querySelector('.figure') as HTMLElement).dataset.cursor === 'add',
    }
  })
  expect(seen).toEqual({ isCut: true, areas: 'equal', buttons: 3, cursor: false })
})

test('a figure that becomes readonly, or gets a region, while circles are being added', async ({ page }) => {
  await open(page, `<circle-voronoi circles="${THREE}" controls></circle-voronoi>`)
  const add = page.locator('circle-voronoi').getByRole('button').first()
  await add.click()
  await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    element.region = 'POLYGON ((-9 -9, 19 -9, 19 18, -9 18))'
    await element.updateComplete
  })
  const box = await page.locator('circle-voronoi').boundingBox()
  const press = () => page.mouse.click((box?.x ?? 0) + 40, (box?.y ?? 0) + 200)
  await press()
  await soon(async () => (await circles(page)).length).toBe(12)
  await page.locator('circle-voronoi').evaluate((element: Element) => {
    element.readonly = true
  })
  await press()
  await page.locator('circle-voronoi').evaluate((element: Element) => element.toSVG())
  expect((await circles(page)).length).toBe(12)
})

test('input and change as of form controls, and a value that is one object until the next change', async ({ page }) => {
  await open(page, FIGURE)
  await page.locator('circle-voronoi').evaluate((element: Element) => {
    const told: string[] = []
    Object.assign(globalThis, { told })
    for (const name of ['input', 'change', 'circleschange'] as const)
      element.addEventListener(name, () => told.push(name))
  })
  const told = () => page.evaluate(() => (globalThis as unknown as { told: string[] }).told)
  const forget = () => page.evaluate(() => void (globalThis as unknown as { told: string[] }).told.splice(0))
  await drag(page)
  await soon(async () => (await told()).at(-1)).toBe('change')
  const all = await told()
  expect(all.filter((name) => name === 'change')).toHaveLength(1)
  expect(all.filter((name) => name === 'input').length).toBe(all.filter((name) => name === 'circleschange').length)
  // A key press causes an input event and a change event at once.
  await forget()
  await page.keyboard.press('ArrowRight')
  await soon(told).toEqual(['circleschange', 'input', 'change'])
  await forget()
  const seen = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    const { value } = element
    const isSame = element.value === value && value.length === 9
    element.value = [...value].flatMap((_, k) => (k % 3 === 0 ? [[...value.subarray(k, k + 3)]] : []))
    await element.updateComplete
    const isKept = element.value === value
    element.value = [[7, 7, 7]]
    await element.updateComplete
    return [isSame, isKept, [...element.value]]
  })
  expect(seen).toEqual([true, true, [7, 7, 7]])
  // Changes by a program cause no input event.
  expect(await told()).toEqual(['circleschange'])
  await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    element.value = ''
    await element.updateComplete
  })
  expect(await circles(page)).toEqual(JSON.parse(THREE).flat())
})

test('ready and updateComplete settle in a tab that is hidden', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(document, 'visibilityState', { get: () => 'hidden' })
    Object.defineProperty(document, 'hidden', { get: () => true })
    // The page draws no frames, and nothing becomes visible.
    globalThis.requestAnimationFrame = () => 0
    globalThis.IntersectionObserver = class {
      observe() {}
      unobserve() {}
      disconnect() {}
    } as unknown as typeof IntersectionObserver
  })
  await open(page, FIGURE)
  const seen = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    element.circles = [[1, 2, 3]]
    await element.updateComplete
    return [...element.circles]
  })
  expect(seen).toEqual([1, 2, 3])
})

const TABLE = '<table><tr><th>x<th>y<th>r<tr><td>0<td>0<td>2<tr><td>10<td>0<td>1<tr><td>5<td>8<td>1.5</table>'
for (const [name, html] of [
  [
    'a paragraph that ends before it, as Python-Markdown writes it',
    `<p><circle-voronoi></p>\n${TABLE}\n<p></circle-voronoi></p>`,
  ],
  [
    'Markdown that is not read',
    '<circle-voronoi>\n| x | y | r |\n|---|:--|--:|\n| 0 | 0 | 2 |\n| 10 | 0 | 1 |\n| 5 | 8 | 1.5 |\n</circle-voronoi>',
  ],
] as const) {
  test(`a table in ${name} has the circles`, async ({ page }) => {
    await open(page, html)
    expect(await circles(page)).toEqual(JSON.parse(THREE).flat())
  })
}

test('a table after an empty figure is not its own', async ({ page }) => {
  await open(page, `<p><circle-voronoi></circle-voronoi></p>${TABLE}<p>Text</p>`)
  expect(await circles(page)).toEqual([])
})

test('the player in a column of 120 pixels has all buttons inside, and its lines can be scrolled to', async ({
  page,
}) => {
  await open(
    page,
    `<div style="width: 120px"><circle-voronoi circles="${THREE}" controls="buttons player" step="9"></circle-voronoi></div>`,
  )
  const outside = await page.locator('circle-voronoi').evaluate((element) => {
    const player = (element.shadowRoot as ShadowRoot).querySelector('.cv-player') as HTMLElement
    const { left, right } = player.getBoundingClientRect()
    return [...player.querySelectorAll('button, select, input, p, li')].flatMap((part) => {
      const box = part.getBoundingClientRect()
      return box.width > 0 && (box.left < left - 0.5 || box.right > right + 0.5) ? [part.outerHTML.slice(0, 60)] : []
    })
  })
  expect(outside).toEqual([])
  // A step does not scroll the buttons away.
  await page.getByRole('button', { name: 'Next step', exact: true }).click()
  const next = await page.locator('circle-voronoi').evaluate((element: Element) => {
    const root = element.shadowRoot as ShadowRoot
    const { left, top } = (root.querySelector('.cv-player input') as HTMLElement).getBoundingClientRect()
    return [element.step, root.elementFromPoint(left + 5, top + 5)?.localName]
  })
  expect(next).toEqual([10, 'input'])
  const line = page.locator('circle-voronoi').locator('[aria-current="step"]')
  await line.scrollIntoViewIfNeeded()
  const isVisible = await page.locator('circle-voronoi').evaluate((element) => {
    const root = element.shadowRoot as ShadowRoot
    const { left, top, height } = (root.querySelector('[aria-current]') as HTMLElement).getBoundingClientRect()
    return root.elementFromPoint(left + 20, top + height / 2)?.closest('[aria-current]') !== null
  })
  expect(isVisible).toBe(true)
  await page.screenshot({ path: 'build/behaves-player.png' })
})
