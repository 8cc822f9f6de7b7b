// SPDX-License-Identifier: GPL-3.0-or-later
// <circle-voronoi> wherever a page puts it: scaled, turned and zoomed, on slides that have gestures and keys of their own.
import { expect, type Page, test } from '@playwright/test'
import { soon } from '../soon.ts'
import { centerOfFirst, HEIGHT, onPage, ownPlace, PLACES, WIDTH, whenPlaced, writePlaced } from './places.ts'
import { ROOT } from './project.mjs'
import { type Server, serve } from './static-server.ts'

type Element = HTMLElementTagNameMap['circle-voronoi']

const PAGES = `build/placed-${process.env.TEST_PARALLEL_INDEX}`

let server: Server
test.beforeAll(async () => {
  server = await serve(ROOT, "default-src 'self' data: 'wasm-unsafe-eval' 'unsafe-inline'")
})
test.afterAll(() => server.close())

/** Opens a page with a figure of three circles and a known view. */
async function open(page: Page, around: (figure: string) => string): Promise<void> {
  await page.goto(`${server.address}${writePlaced(PAGES, around)}`)
  await page.evaluate(whenPlaced)
}

/** Returns the position of a point of the plane on the page. */
const placeOf = (page: Page, x: number, y: number) => page.evaluate(onPage, ownPlace(x, y))

async function drag(
  page: Page,
  hasFinger: boolean,
  [x, y]: [number, number],
  [toX, toY]: [number, number],
): Promise<void> {
  const places = Array.from({ length: 9 }, (_, k) => ({ x: x + ((toX - x) * k) / 8, y: y + ((toY - y) * k) / 8 }))
  if (hasFinger) {
    const session = await page.context().newCDPSession(page)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: { x: number; y: number }[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints })
    await touch('touchStart', places.slice(0, 1))
    for (const place of places.slice(1)) await touch('touchMove', [place])
    await touch('touchEnd', [])
    return
  }
  await page.mouse.move(x, y)
  await page.mouse.down()
  for (const place of places.slice(1)) await page.mouse.move(place.x, place.y)
  await page.mouse.up()
}

const center = (page: Page) => page.evaluate(centerOfFirst)

for (const hasFinger of [false, true]) {
  test.describe(hasFinger ? 'a finger' : 'the mouse', () => {
    test.use({ hasTouch: hasFinger })
    for (const [name, around] of PLACES) {
      test(`drags a circle in a figure that is ${name}`, async ({ page }) => {
        await open(page, around)
        await drag(page, hasFinger, await placeOf(page, 0.5, 0.5), await placeOf(page, 4.5, 3.5))
        await soon(() => center(page)).toEqual([4, 3])
      })
    }
  })
}

test('a figure that is made larger by a transform is drawn with as many pixels', async ({ page }) => {
  await open(page, (figure) => `<div id="around" style="transform: scale(1.4)">${figure}</div>`)
  const pixels = () =>
    page.locator('circle-voronoi').evaluate((element: Element) => {
      const canvas = element.shadowRoot?.querySelector('canvas') as HTMLCanvasElement
      return [canvas.width, canvas.height]
    })
  expect(await pixels()).toEqual([1.4 * WIDTH, 1.4 * HEIGHT])
  await page.locator('#around').evaluate((element) => {
    element.style.transform = 'scale(2) rotate(20deg)'
    dispatchEvent(new Event('resize'))
  })
  await soon(pixels).toEqual([2 * WIDTH, 2 * HEIGHT])
})

/** Records the gestures and keys that reach the page, to which slides and carousels would react. */
async function listen(page: Page) {
  await page.evaluate(() => {
    const heard: string[] = []
    const names = [
      'pointerdown',
      'pointermove',
      'pointerup',
      'mousedown',
      'touchstart',
      'touchmove',
      'touchend',
      'wheel',
      'keydown',
    ]
    const tell = (event: Event) => heard.push(event instanceof KeyboardEvent ? event.key : event.type)
    for (const name of names) document.addEventListener(name, tell)
    document.addEventListener('click', () => heard.push('click'))
    Object.assign(globalThis, { heard })
  })
  return {
    heard: () => page.evaluate(() => [...new Set((globalThis as unknown as { heard: string[] }).heard)]),
    forget: () => page.evaluate(() => void (globalThis as unknown as { heard: string[] }).heard.splice(0)),
  }
}

test('a page does not hear of the mouse that drags a circle, nor of keys that the figure uses', async ({ page }) => {
  await open(page, (figure) => figure)
  const { heard, forget } = await listen(page)
  await drag(page, false, await placeOf(page, 0, 0), await placeOf(page, 4, 3))
  await soon(() => center(page)).toEqual([4, 3])
  // A click anywhere closes a menu of the page.
  expect(await heard()).toEqual(['pointermove', 'click'])
  await forget()
  await page.keyboard.press('ArrowRight')
  await soon(async () => (await center(page))[0]).toBeGreaterThan(4)
  await page.keyboard.press('Control+z')
  await page.mouse.wheel(0, 10)
  // Until the undo is done, the figure keeps all keys for what it will select.
  await soon(() => center(page)).toEqual([4, 3])
  expect(await heard()).toEqual(['Control'])
  await forget()
  // The page receives keys that the figure does not use.
  await page.keyboard.press('m')
  await soon(heard).toEqual(['m'])
})

test.describe('on a touch screen', () => {
  test.use({ hasTouch: true })
  test('a page hears of a finger that scrolls, and not of one that drags a circle', async ({ page }) => {
    await open(page, (figure) => figure)
    const { heard } = await listen(page)
    await drag(page, true, await placeOf(page, 0, 0), await placeOf(page, 4, 3))
    await soon(() => center(page)).toEqual([4, 3])
    expect(await heard()).toEqual([])
    // Keys are the figure's then, as after a drag by mouse.
    await page.keyboard.press('ArrowRight')
    await soon(async () => (await center(page))[0]).toBeGreaterThan(4)
    await page.keyboard.press('ArrowLeft')
    await soon(() => center(page)).toEqual([4, 3])
    expect(await heard()).toEqual([])
    await drag(page, true, await placeOf(page, 12, 12), await placeOf(page, 4, 12))
    await soon(heard).toEqual(expect.arrayContaining(['pointerdown', 'touchstart', 'touchmove']))
    expect(await center(page)).toEqual([4, 3])
  })
})
